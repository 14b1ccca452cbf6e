r"""What an error does to the links around it: one misprint is told once, and proves nothing.

In ``3 + 4 = 8 = 7`` both links fail, but 8 alone is wrong: ``3 + 4 = 7`` holds. Only the first link
is told then, at which an author has to look. A link that seemed to follow from an accused one is
not proved. A formula that the text itself calls a mistake is not told either.

In ``2x + 3 = 7``, ``2x = 5``, ``x = 2`` of one display the middle line is no new equation: the one
before it gives x = 2, at which it fails, and the one behind it follows without it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from flint import fmpq

from tresym.checking.time_limited import Task, check_all, check_within
from tresym.manuscript import prose
from tresym.manuscript.classification import DEFINED, EQUATION
from tresym.manuscript.deciding import PASSES, Row, under_also
from tresym.reals.decisions.answer import Answer
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    apply,
    bind,
    opened,
    rebuild,
    substitute,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

ACCUSED = ("REFUTED", "SUSPECT")
FOLLOWS = "it follows from"
_MISTAKE = re.compile(
    r"\b(?:mistakes?|mistaken(?:ly)?|incorrect(?:ly)?|wrong(?:ly)?|fallac\w+|bogus|flaw(?:ed|s)?"
    r"|(?:spot|find|what is|identify|explain|all)\s+(?:\w+\s+){0,2}errors?"
    r"|errors?\s+in\s+th(?:is|e)\s+(?:work|argument|proof|reasoning|calculation|computation|derivation)|student|does\s+not"
    r"\s+hold|is\s+(?:false|not\s+true)|paradox\w*|nonsense|not\s+equal"
    r"|hatay\w+|[Ff]ehler(?!rechnung)\w*|erreurs?|falsch\w*|error(?:e|es)\b)\b",
    re.IGNORECASE,
)
"""Words that call a formula a mistake."""
_CASES = re.compile(
    r"\b(?:cases?|or|either|contradict\w*|inconsistent|no solution|respectively|both|pairs?"
    r"|possib\w+|alternativ\w+)\b",
    re.IGNORECASE,
)
"""Words by which two equations of a display need not hold together."""
_FACTOR = re.compile(r"it behaves like (?:[\d/()*.+-]|\bpi\b|\bsqrt\b)+(?:;|\Z)")
_SCALED = re.compile(
    r"\\(?:kilo|milli|centi|micro|nano|mega|giga|hecto|deci|pico|tera)(?![a-z])"
    r"|\\(?:SI|qty|si|unit|mathrm|text|textrm|rm)\b[^$]*?\{[^{}]*(?<![a-zA-Z])(?:[kcmnGM]|\\mu\s*)"
    r"(?:m|g|s|N|J|W|V|A|Pa|Hz|eV|cal|L|mol)(?![a-zA-Z])"
)
"""Units with a prefix."""
_ANGLES = re.compile(r"\brad\b|\\circ|[dD]eg|180")
_OR = re.compile(r"(?<![a-zA-Z\\])or(?![a-zA-Z])")
_WAVES = frozenset(("sin", "cos", "tan", "log", "exp"))
_SENTENCE = re.compile(r"[^.!?]+[.!?]")
_LINE = re.compile(r"\blines? (\d+)")


def settled(rows: Sequence[Row], seconds: float = 2.0, processes: int | None = None) -> list[Row]:
    """Return the rows with each misprint told once, and nothing proved from one.

    Args:
        seconds: processor time for each question.
        processes: how many at once; None for one per core.
    """
    result = [_excused(row) if row.status in ACCUSED else row for row in rows]
    _contradicting(result)
    _told_once(result, seconds, processes)
    _without_premises(result)
    return result


def _excused(row: Row) -> Row:
    """Return the row, not accused if it means something else, or is called a mistake."""
    before, after = row.link.around[:2]
    words = f"{prose.last_sentence(before)} {' '.join(_SENTENCE.findall(after)[:2])}"
    excuse = ""
    if _MISTAKE.search(prose.without_formulas(words)):
        excuse = "the text calls it a mistake"
    elif _is_of_order(row):
        excuse = "the sign may mean the same order, as Theta does"
    elif _in_other_unit(row):
        excuse = "the sides may be in different units"
    elif not row.instead and _is_to_be_solved(row):
        excuse = "an equation for the symbol that stands alone on one side of it"
    elif "\\pm" in row.link.display.text and _OR.search(row.link.display.text):
        excuse = "each sign may have a value of its own"
    elif _is_solution_of_some(row):
        excuse = "a solution for some values of the other symbols, or with rounded numbers"
    elif _is_rounded_to_integer(row):
        excuse = "the integer may be rounded, as the decimals on the other side are"
    elif (alike := _with_longer_sums(row)) and _holds(alike):
        excuse = f"it holds as {alike}, if what follows is meant to belong to it"
    if not excuse:
        return row
    return replace(row, status=Verdict.UNDECIDED.value, why=f"{excuse}; {row.why}")


def _with_longer_sums(row: Row) -> str:
    """Return an equality with all that follows a sum under it: some print sum (k + 2) as sum k +
    2; empty if there is nothing to put under it."""
    left, relation, right = row.link.sides or (ZERO, "", ZERO)
    longer = [_longer_sum(side) for side in (left, right)]
    if relation != "==" or longer == [left, right]:
        return ""
    given = row.refuted.partition(" given ")[2]
    return f"{longer[0]} == {longer[1]}" + (f" given {given}" if given else "")


def _longer_sum(side: Expr) -> Expr:
    if side.op in ("*", "^") and elementary(side):
        side = rebuild(side, tuple(map(_longer_sum, side.args)))  # (\sin s + t)/(\cos s + t)
    waves = [arg for arg in side.args if isinstance(arg, Expr) and arg.op in _WAVES]
    if side.op == "+" and len(waves) == 1 and all(map(elementary, side.args)):
        rest = [arg for arg in side.args if arg is not waves[0]]
        return apply(waves[0].op, add(waves[0].args[0], *rest))  # \cos s + t
    sums = [arg for arg in side.args if isinstance(arg, Expr) and arg.op == "sum"]
    if side.op != "+" or len(sums) != 1:
        return side
    (one,) = sums
    rest = [arg for arg in side.args if arg is not one]
    names, body = opened(one, frozenset().union(*map(symbols, rest)))
    return Expr("sum", (bind(add(body, *rest), names), *one.args[1:]), names)


def _holds(claim: str) -> bool:
    try:
        return check_within(Task(claim), 2.0).verdict in (Verdict.PROVED, Verdict.ENCLOSED)
    except InputError:
        return False


def _is_to_be_solved(row: Row) -> bool:
    """Whether one side is a symbol that the other one contains, x = sqrt(1 - x^2)."""
    left, relation, right = row.link.sides or (ZERO, "", ZERO)
    pairs = ((left, right), (right, left))
    return (
        relation == "=="
        and elementary(left, right)
        and any(one.op == "symbol" and str(one) in symbols(other) for one, other in pairs)
    )


def _is_solution_of_some(row: Row) -> bool:
    """Whether a solution, which fails, contains decimals or fails for negative numbers only."""
    if not row.why.startswith("it does not solve"):
        return False
    if re.search(r"\d\.\d", row.link.shown):
        return True
    left, _, right = row.link.sides or (ZERO, "", ZERO)
    names = sorted(name for name in symbols(left) | symbols(right) if name in row.refuted)
    more = [f"{name} > 0" for name in names] + [f"{n} integer" for n in names if n in "nmk"]
    if not more or not row.refuted or " as " in row.refuted:
        return False
    try:
        found = check_within(Task(under_also(row.refuted, ", ".join(more))), 2.0)
    except InputError:
        return False
    return found.verdict is not Verdict.REFUTED


def _is_of_order(row: Row) -> bool:
    """Whether sides of a ~ differ by a constant factor, and the right one is a bare power: n(n +
    1)/2 ~ n^2."""
    left, relation, right = row.link.sides or (ZERO, "", ZERO)
    base = right.args[0] if right.op == "^" and right.args[1].op == "number" else right
    bare = isinstance(base, Expr) and base.op == "symbol"
    return relation == "~" and bare and bool(symbols(left)) and bool(_FACTOR.search(row.why))


def _in_other_unit(row: Row) -> bool:
    """Whether two numbers differ by a power of ten in a display of units such as km."""
    left, relation, right = row.link.sides or (ZERO, "", ZERO)
    if relation != "==" or symbols(left) | symbols(right) or not elementary(left, right):
        return False
    text = row.link.display.text
    with ball_precision():
        ratio = evaluate(left / right, {}) if right != ZERO else None
        turned = [] if ratio is None else [ratio / 57.29578, ratio * 57.29578]
    if _ANGLES.search(text) and any(abs(one - 1) < 0.01 for one in turned):
        return True
    if not _SCALED.search(text):
        return False
    powers = [ratio * 10**n for n in range(-12, 13) if n] if ratio is not None else []
    return any(abs(power - 1) < 0.05 for power in powers)


def _is_rounded_to_integer(row: Row) -> bool:
    """Whether an integer is the nearest one to a value of decimals: sqrt(653.2) + 14.4 = 40."""
    left, relation, right = row.link.sides or (ZERO, "", ZERO)
    if relation != "==" or symbols(left) | symbols(right) or not elementary(left, right):
        return False
    whole = any(side.op == "number" and side.args[0].q == 1 for side in (left, right))
    if not whole or not re.search(r"\d\s*\.\s*\d", row.link.shown):
        return False
    with ball_precision():
        return abs(evaluate(left - right, {})) < fmpq(1, 2)


def _contradicting(rows: list[Row]) -> None:
    """Mark an equation SUSPECT at which the one before it in its display fails, if another line of
    the display agrees with that one and none agrees with it."""
    for _, group in groupby(enumerate(rows), key=lambda pair: pair[1].link.display.number):
        steps = [(n, row) for n, row in group if _is_step(row)]
        for (_, before), (n, row) in pairwise(steps):
            if row.status not in (EQUATION, DEFINED) or _is_value(before) or _says_no(row):
                continue
            others = [other for k, other in steps if other is not row and other is not before]
            if not _fails_with(row, before) or any(_agrees(row, other) for other in others):
                continue
            if any(_agrees(before, other) for other in others):
                why = f"it contradicts the equation before it in its display, {before.link.read_as}"
                rows[n] = replace(row, status="SUSPECT", why=why)


def _is_step(row: Row) -> bool:
    """Whether a row is an equation whose symbols the display may be solving for."""
    sides = row.link.sides
    if sides is None or sides[1] != "==" or not elementary(sides[0], sides[2]) or row.link.noted:
        return False
    solved = row.status in PASSES and row.why.startswith(("it follows", "it solves"))
    return (row.status in (EQUATION, DEFINED) or solved) and ZERO not in sides[::2]


def _is_value(row: Row) -> bool:
    """Whether a row is x = 2, one value of several perhaps."""
    left, _, right = row.link.sides or (ZERO, "", ZERO)
    return left.op == "symbol" and not symbols(right)


def _says_no(row: Row) -> bool:
    words = prose.without_formulas(f"{row.link.around[0][-300:]} {row.link.around[1][:200]}")
    return bool(_CASES.search(words))


def _fails_with(row: Row, before: Row) -> bool:
    """Whether both equations cannot hold: with the value from one the other says 3 = 0."""
    rest = _with_value_of(before, row)
    return rest is not None and rest.op == "number" and rest != ZERO


def _agrees(one: Row, other: Row) -> bool:
    """Whether an equation holds wherever the other one does."""
    return ZERO in (_with_value_of(one, other), _with_value_of(other, one))


def _with_value_of(known: Row, row: Row) -> Expr | None:
    """Return the difference of the sides of a row where another one holds that is linear in a
    symbol with a number as coefficient; None if there is no such symbol."""
    one, other = ((s[0] - s[2]) for s in (known.link.sides, row.link.sides) if s is not None)
    if not symbols(one) or symbols(one) != symbols(other):
        return None
    for name in sorted(symbols(one)):
        try:
            slope = normal_form(differentiate(one, name), Given())
            if slope.op != "number" or slope == ZERO:
                continue
            value = -substitute(one, {name: ZERO}) / slope
            return normal_form(substitute(other, {name: value}), Given())
        except (InputError, ZeroDivisionError):
            continue
    return None


def _told_once(rows: list[Row], seconds: float, processes: int | None) -> None:
    """Withhold the second of two accusations of a chain that holds without the term between."""
    tasks = []
    for n, (first, second) in enumerate(pairwise(rows)):
        if first.status not in ACCUSED or second.status not in ACCUSED:
            continue
        if second.link.shown.replace("\\Im", "\\Re") == first.link.shown != second.link.shown:
            why = f"of the same link the real parts are not equal either; {second.why}"
            status = Verdict.UNDECIDED.value
            rows[n + 1] = replace(second, status=status, why=why, instead=(), witness=None)
        elif _chained(first, second):
            text = _around(first, second)
            tasks += [Task(text, line=n)] if text else []
    for task, answer in check_all(tasks, seconds, processes) if tasks else ():
        n = task.line or 0
        if isinstance(answer, Answer) and answer and rows[n].status in ACCUSED:
            why = "the term before it, of which the link before is accused, is wrong: "
            why = f"{why}the chain holds without it"
            rows[n + 1] = replace(
                rows[n + 1], status=Verdict.UNDECIDED.value, why=why, instead=(), witness=None
            )


def _chained(first: Row, second: Row) -> bool:
    one, other = first.link, second.link
    if one.sides is None or other.sides is None or one.display != other.display:
        return False
    return other.number == one.number + 1 and one.shown.endswith(other.shown.split(" = ")[0])


def _around(first: Row, second: Row) -> str:
    """Return the claim that the first and the last term of a chain of three are related."""
    for asked in first.link.claims:
        for other in second.link.claims:
            if asked.sides is None or other.sides is None or asked.sides[2] != other.sides[0]:
                continue
            if asked.sides[1] == "==":
                return f"{asked.sides[0]} {other.sides[1]} {other.sides[2]}{other.under}"
    one, other_ = first.link.sides, second.link.sides
    if one is None or other_ is None or one[1] != "==" or first.put or second.put:
        return ""
    return f"{one[0]} {other_[1]} {other_[2]}"


def _without_premises(rows: list[Row]) -> None:
    """Undo what was proved from lines that are all accused now."""
    accused = {row.link.display.line for row in rows if row.status in ACCUSED}
    clean = {row.link.display.line for row in rows if row.status not in ACCUSED and row.link.sides}
    for n, row in enumerate(rows):
        named = {int(line) for line in _LINE.findall(row.why)}
        wrong = (named & accused) - clean
        if row.status in PASSES and row.why.startswith(FOLLOWS) and wrong:
            why = f"{row.why}; but line {min(wrong)} is accused"
            rows[n] = replace(row, status=Verdict.UNDECIDED.value, why=why)
