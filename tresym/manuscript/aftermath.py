r"""What an error does to the links around it: one misprint is told once, and proves nothing.

In ``3 + 4 = 8 = 7`` both links fail, but 8 alone is wrong: ``3 + 4 = 7`` holds. Only the first link
is told then, at which an author has to look. A link that seemed to follow from an accused one is
not proved. What is left is weighed: without support it is only a suspicion.

In ``2x + 3 = 7``, ``2x = 5``, ``x = 2`` of one display the middle line is no new equation: the one
before it gives x = 2, at which it fails, and the one behind it follows without it.
"""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from itertools import groupby, pairwise

from tresym.checking.time_limited import Task, check_all
from tresym.manuscript import prose
from tresym.manuscript.classification import DEFINED, EQUATION
from tresym.manuscript.consequences import Step
from tresym.manuscript.deciding import NEAR, PASSES, Row, step_to
from tresym.manuscript.support import ACCUSED, WITHOUT, explained, weighed
from tresym.reals.decisions.answer import Answer
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    substitute,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

FOLLOWS = "it follows from"
_WITHHELD = (Verdict.UNDECIDED.value, EQUATION)
_NUMERAL = re.compile(r"-?\s*(?:[\d.\s]+|\\[dt]?frac \{? ?-?[\d.\s]+\}? ?\{? ?[\d.\s]+\}?)")
_CASES = re.compile(
    r"\b(?:cases?|or|either|contradict\w*|inconsistent|no solution|respectively|both|pairs?"
    r"|possib\w+|alternativ\w+)\b",
    re.IGNORECASE,
)
"""Words by which two equations of a display need not hold together."""


def settled(rows: Sequence[Row], seconds: float = 2.0, processes: int | None = None) -> list[Row]:
    """Return the rows with each misprint told once, and nothing proved from one.

    Args:
        seconds: processor time for each question.
        processes: how many at once; None for one per core.
    """
    result = [explained(row) if row.status in ACCUSED else row for row in rows]
    _contradicting(result)
    _between(result, seconds, processes)
    _told_once(result, seconds, processes)
    _weigh(result)
    _without_premises(result, seconds, processes)
    return result


def _weigh(rows: list[Row]) -> None:
    """Accuse what is supported; what is not is a suspicion."""
    for _, group in groupby(enumerate(rows), key=lambda pair: pair[1].link.display.number):
        display = list(group)
        for n, row in display:
            if row.status in ACCUSED:
                rows[n] = weighed(row, [other for k, other in display if k != n])


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


def _between(rows: list[Row], seconds: float, processes: int | None) -> None:
    """Mark a withheld link SUSPECT if the next one fails too, and their chain holds without the
    term between: a = b = c with a = c, where b is more than a number."""
    tasks = []
    for n, (first, second) in enumerate(pairwise(rows)):
        withheld = all(row.status in _WITHHELD and row.refuted for row in (first, second))
        if not withheld or not _chained(first, second) or first.link.noted:
            continue
        ends = first.link.shown.split(" = ")[0], second.link.shown.rpartition(" = ")[2]
        if _is_bare(second) or ends[0] == ends[1] or _says_no(first):
            continue
        text = _around(first, second)
        tasks += [Task(text, line=n)] if text else []
    for task, answer in check_all(tasks, seconds, processes) if tasks else ():
        if isinstance(answer, Answer) and answer:
            n = task.line or 0
            why = f"its chain holds without its right side: {task.claim}"
            found = replace(rows[n], status="SUSPECT", why=why, witness=rows[n].fails_at)
            rows[n] = explained(found)


def _is_bare(row: Row) -> bool:
    """Whether the left side of a link is a number, a symbol, or has symbols of its own."""
    left, _, right = row.link.sides or (ZERO, "", ZERO)
    printed = row.link.shown.split(" = ")[0]
    own = symbols(left) - symbols(right)
    return bool(_NUMERAL.fullmatch(printed)) or left.op == "symbol" or bool(own)


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
            status = Verdict.UNDECIDED.value
            rows[n + 1] = replace(rows[n + 1], status=status, why=WITHOUT, instead=(), witness=None)


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


def _without_premises(rows: list[Row], seconds: float, processes: int | None) -> None:
    """Undo what was proved from accused rows, unless it follows from the others as well."""
    accused = [(n, row) for n, row in enumerate(rows) if row.status in ACCUSED]
    found: dict[int, tuple[Row, Step | None]] = {}
    for n, row in enumerate(rows):
        wrong = [one for k, one in accused if k < n <= k + NEAR and _may_rest_on(row, one)]
        if row.status in PASSES and wrong:
            left = [one for one in rows[:n] if one.status not in ACCUSED]
            again = [*left, replace(row, status=EQUATION), *rows[n + 1 :]]
            found[n] = wrong[-1], step_to(again, len(left)) if _by_step(row) else None
    tasks = [Task(text, line=n) for n, (_, step) in found.items() if step for text in step.claims]
    failed = {n for n, (_, step) in found.items() if step is None}
    for task, answer in check_all(tasks, seconds, processes) if tasks else ():
        if not isinstance(answer, Answer) or answer.verdict is not Verdict.PROVED:
            failed.add(task.line or 0)
    for n, (one, step) in found.items():
        if step is not None and n not in failed:
            rows[n] = replace(rows[n], why=step.why)
        else:
            why = (
                f"{rows[n].why}; but {one.link.read_as} in line {one.link.display.line} is accused"
            )
            rows[n] = replace(rows[n], status=Verdict.UNDECIDED.value, why=why)


def _may_rest_on(row: Row, one: Row) -> bool:
    """Whether a row may have been proved from another one, which stands before it."""
    link, sides = row.link, one.link.sides
    if _by_step(row):
        return one.link.reach == link.reach[: len(one.link.reach)]
    if link.solves is not None:
        return (link.solves.display, link.solves.shown) == (one.link.display.number, one.link.shown)
    return sides is not None and any(
        str(sides[0]) == name and sides[2] == value for name, value in row.put
    )


def _by_step(row: Row) -> bool:
    """Whether a row was proved from equations before it, not from the one that it solves."""
    solved = row.link.solves is None and row.why.startswith("it solves")
    return solved or row.why.startswith(FOLLOWS)
