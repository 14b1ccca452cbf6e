r"""What speaks for a misprint, and what against it: a formula is only accused with support.

A misprint is a small change of a true formula; a formula that was misread is not. So the author is
accused (REFUTED) of ``\sin(a - b) = \cos a\sin b - \sin a\cos b`` because the formula holds with
another sign. ``\sin s + t = \sin s\cos t + \cos s\sin t`` fails as well, but holds under no small
change: probably the sine was meant to reach further. It is only SUSPECT, which is listed apart and
fails no run.

Two tables say what counts: ``SUPPORTS`` and ``DOUBTS``, each entry with its weight and a test. The
third, ``MEANT``, has the reasons to tell nothing, because another meaning is known under which the
formula holds, or because the text itself calls it a mistake.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Sequence
from dataclasses import replace
from difflib import SequenceMatcher
from typing import NamedTuple

from flint import fmpq

from tresym.checking.time_limited import Task, check_within
from tresym.manuscript import prose
from tresym.manuscript.accusations import DoubtKind
from tresym.manuscript.deciding import PASSES, Row, under_also
from tresym.manuscript.mentions import dependent
from tresym.manuscript.symbols import mentions
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import ZERO, Expr, add, apply, bind, opened, rebuild, symbols
from tresym.reals.language.parsing import parse_claim, sequences_of
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.repair.search import GIVEN

SUSPECT = "SUSPECT"
ACCUSED = (Verdict.REFUTED.value, SUSPECT)
MOST_CHANGED = 2
"""The most tokens that a misprint changes."""
ENOUGH = 2
"""The weight from which on a formula is accused."""
WITHOUT = (
    "the term before it, of which the link before is accused, is wrong: the chain holds without it"
)


_TEXT = re.compile(r"\\(?:text\w*|mbox|intertext)\s*\{((?:[^{}]|\{[^{}]*\})*)\}")
_TOKEN = re.compile(r"[A-Za-z_]\w*|[\d./]+|\*\*|[-+*/]")
_DIGITS = re.compile(r"[-+\d/.]*")
_REMARK = re.compile(r",[^,=\\]*=(?:[^,\\]|\\(?!\\))*\\\\\s*&?\s*=")
"""A formula behind a comma at the end of a line, and a line that continues another one."""
_SENTENCE = re.compile(r"[^.!?]+[.!?]")
_CONDITIONAL = re.compile(
    r"\b(?:if|when|whenever|unless|provided|suppos\w*|assum\w*|hypothes\w*|let|set|either|or|not"
    r"|never|cannot|only|cases?|such that|for which|contradict\w*|roughly|about|say"
    r"|modulo|mod|guess|conjectur\w*|ansatz|try|instead)\b",
    re.IGNORECASE,
)
"""Words that may state a condition, or say that a formula need not hold."""
_SUPPOSED = re.compile(
    r"\b(?:guess\w*|conjectur\w*|ansatz|tr(?:y|ies|ying)|contradict\w*|absurd\w*|impossib\w*"
    r"|would|were|if and only if|iff|precisely when|exactly when|unless|true or false|is it true"
    r"|for (?:which|what)|intersect\w*|unknowns?|solv(?:e|es|ing)|satisf(?:y|ies))\b",
    re.IGNORECASE,
)
"""Words by which an equation holds for some values only, or is perhaps not true at all."""
_TASK = re.compile(
    r"\?|\b(?:solv\w+|find|determin\w+|exercises?|questions?|equations?|satisf\w+|solutions?|roots?"
    r"|unknowns?|system|true or false|which|whether|fill)\b",
    re.IGNORECASE,
)
"""Words that ask for something: what follows need not hold for all values."""
_MISTAKE = re.compile(
    r"\b(?:mistakes?|mistaken(?:ly)?|incorrect(?:ly)?|wrong(?:ly)?|fallac\w+|bogus|flaw(?:ed|s)?"
    r"|(?:spot|find|what is|identify|explain|all)\s+(?:\w+\s+){0,2}errors?"
    r"|errors?\s+in\s+th(?:is|e)\s+(?:work|argument|proof|reasoning|calculation|computation|derivation)|student|does\s+not"
    r"\s+hold|is\s+(?:false|not\s+true)|paradox\w*|nonsense|not\s+equal"
    r"|hatay\w+|[Ff]ehler(?!rechnung)\w*|erreurs?|falsch\w*|error(?:e|es)\b)\b",
    re.IGNORECASE,
)
"""Words that call a formula a mistake."""
_FALSE = re.compile(r"\b(?:wrong|false|incorrect|mistake)\b", re.IGNORECASE)
"""Words that call a formula a mistake inside its own display."""
_MARKED = re.compile(
    r"\\[bx]?cancel(?:to)?(?![a-zA-Z])|\\(?:sout|xmark|ding|unicode)(?![a-zA-Z])|[?✗❌]"
)
"""Signs that strike something out of a display or question it."""
_FACTOR = re.compile(r"it behaves like (?:[\d/()*.+-]|\bpi\b|\bsqrt\b)+(?:;|\Z)")
_SCALED = re.compile(
    r"\\(?:kilo|milli|centi|micro|nano|mega|giga|hecto|deci|pico|tera)(?![a-z])"
    r"|\\(?:SI|qty|si|unit|mathrm|text|textrm|rm)\b[^$]*?\{[^{}]*(?<![a-zA-Z])(?:[kcmnGM]|\\mu\s*)"
    r"(?:m|g|s|N|J|W|V|A|Pa|Hz|eV|cal|L|mol)(?![a-zA-Z])"
)
"""Units with a prefix."""
_ANGLES = re.compile(r"\brad\b|\\circ|[dD]eg|180")
_OR = re.compile(r"(?<![a-zA-Z\\])or(?![a-zA-Z])")
_LABEL = re.compile(r"(?<![a-zA-Z\\])[a-zA-Z]\s*\^\s*(?:\{\s*[01]\s*\}|[01](?!\d))(?<!e \^ [01])")
"""A letter with the superscript 0 or 1."""
_CASE = re.compile(
    r"(?:\A|[.!?:;\n]|\\item\b)\s*(?:(?:now|first|then|next|so|but|and)\b[\s,]*)?"
    r"(?:if|when|case|suppose|assum(?:e|ing))\b",
    re.IGNORECASE,
)
"""A sentence that begins with a condition."""
_OTHER_CASE = re.compile(
    r"\W*(?:(?:similarly|likewise|conversely|on the other hand)\b[^.]*?\b(?:if|when|case)"
    r"|(?:(?:and|but|now)\s+)?(?:if|when|otherwise))\b",
    re.IGNORECASE,
)
"""The beginning of a sentence about another case."""
MOST_BEFORE = 200
"""How many characters before a display are searched for the case that it is about."""
_WAVES = frozenset(("sin", "cos", "tan", "log", "exp"))


class Case(NamedTuple):
    """A row that fails, and the other rows of its display."""

    row: Row
    others: tuple[Row, ...] = ()

    @property
    def sides(self) -> tuple[Expr, str, Expr]:
        """Both sides and the relation."""
        return self.row.link.sides or (ZERO, "", ZERO)

    @property
    def names(self) -> set[str]:
        """The symbols of both sides."""
        return {*symbols(self.sides[0]), *symbols(self.sides[2])}

    @property
    def words(self) -> str:
        """The sentence around the display, and the words in it, without formulas."""
        before, after = self.row.link.around[:2]
        own = " ".join(_TEXT.findall(self.row.link.display.text))
        lead, trail = prose.last_sentence(before), prose.first_sentence(after)
        return prose.without_formulas(f"{lead} {own} {trail}")


class Evidence(NamedTuple):
    """What counts for or against an accusation.

    Attributes:
        says: the evidence in words.
        weight: how much it counts, below 0 against an accusation.
        holds: whether it is there.
    """

    says: str
    weight: int
    holds: Callable[[Case], bool]


def explained(row: Row) -> Row:
    """Return a row that fails, UNDECIDED if another meaning is known, or it is called a mistake."""
    case = Case(row)
    meant = next((one for one in MEANT if one.holds(case)), None)
    if meant is None:
        return row
    return replace(row, status=Verdict.UNDECIDED.value, why=f"{meant.says}; {row.why}")


def weighed(row: Row, others: Sequence[Row] = ()) -> Row:
    """Return a row that fails with its status: REFUTED if it is supported, else SUSPECT.

    Args:
        others: the other rows of its display.
    """
    case = Case(row, tuple(others))
    found = [one for one in (*SUPPORTS, *DOUBTS) if one.holds(case)]
    false = row.status == Verdict.REFUTED.value or bool(row.refuted)  # and not only unlikely
    if false and sum(one.weight for one in found) >= ENOUGH:
        at = row.witness if row.witness is not None else row.fails_at
        return replace(row, status=Verdict.REFUTED.value, witness=at)
    lacking = next((one.says for one in found if one.weight < 0), "")
    lacking = lacking or "no formula close to it was found to hold"
    return replace(row, status=SUSPECT, why=f"{row.why}; only a suspicion: {lacking}")


# What supports an accusation


def _is_called(case: Case) -> bool:
    return case.row.link.noted == prose.CLAIM


def _is_claimed(case: Case) -> bool:
    ground = case.row.link.ground
    return ground.universal or (ground.explicit and bool(case.names))


def _one_edit(case: Case) -> bool:
    """Whether a formula one small edit away holds; of numbers alone nearly every one is close to a
    true one, so only signs and functions count there."""
    for found in case.row.instead:
        if found.edit.startswith("the coefficient"):  # one of an expansion is another
            return True
        new, _, old = found.edit.partition(" in place of ")
        if found.edit.startswith(GIVEN) or not old or not _is_small(old, new):
            continue
        if any(old == str(side) and not symbols(side) for side in case.sides[::2]):
            continue  # the value of the other side: there always is one
        if any(found.claim.endswith(f"== {kept}") for kept in _beside_replaced(case)):
            continue  # it changes what is not printed there
        if _says_less(found.claim, case.names):
            continue
        if case.names or not _DIGITS.fullmatch(f"{new}{old}"):
            return True
    return False


def _says_less(claim: str, names: set[str]) -> bool:
    """Whether a repair drops a letter or makes an integral empty: it only holds because it says
    less, as max(a, a) = a."""
    terms = _terms(claim)
    if not terms:
        return True
    empty = any(n.op == "integral" and n.args[1] == n.args[2] for n in outermost(*terms))
    return empty or not names <= frozenset().union(*map(symbols, terms))


def _terms(claim: str) -> list[Expr]:
    """Return the sides of a claim without its conditions; none if it cannot be read."""
    claim, _, given = claim.partition(" as ")[0].partition(" given ")
    try:
        return [term for link in parse_claim(claim, sequences_of(given)) for term in link[::2]]
    except InputError:
        return []


def _beside_replaced(case: Case) -> list[str]:
    """Return the right side if the left one is the derivative of a letter that was replaced by its
    definition: in du = 2x dx behind u = x^3 another u may be meant, so the 2x has to be wrong."""
    right = case.sides[2]
    return [f"{right}{given}" for given in ("", _given(case.row))] if _replaced(case) else []


def _replaced(case: Case) -> set[str]:
    """Return the letters whose derivatives the left side prints and which were replaced."""
    shown = case.row.link.shown.partition("=")[0]
    return set(dependent(shown)) - symbols(case.sides[0])


def _given(row: Row) -> str:
    given = row.refuted.partition(" given ")[2]
    return f" given {given}" if given else ""


def _is_small(old: str, new: str) -> bool:
    """Whether a misprint changes so little: a sign, a number, a letter, an exponent, a
    function, or a fraction upside down."""
    upper, over, lower = old.strip("()").partition(")/(")
    if over and new == f"({lower})/({upper})":
        return True  # a fraction upside down
    one, other = (_TOKEN.findall(text.replace("nothing", "")) for text in (old, new))
    changes = SequenceMatcher(None, one, other, autojunk=False).get_opcodes()
    changed = sum(max(b - a, d - c) for tag, a, b, c, d in changes if tag != "equal")
    return changed <= MOST_CHANGED


def _chain_before(case: Case) -> bool:
    """Whether the link before it in its chain is proved, and so its left side is read rightly."""
    link = case.row.link
    return link.goes_on and any(
        one.status in PASSES and one.link.number == link.number - 1 and _joins(one, case.row)
        for one in case.others
    )


def _chain_after(case: Case) -> bool:
    """Whether the link behind it in its chain is proved, and so its right side is read rightly."""
    link = case.row.link
    return any(
        one.status in PASSES and one.link.number == link.number + 1 and _joins(case.row, one)
        for one in case.others
    )


def _joins(first: Row, second: Row) -> bool:
    """Whether a link continues another one: they share a term."""
    one, other = first.link.sides, second.link.sides
    if not second.link.goes_on or one is None or other is None:
        return False
    return not {one[0], one[2]}.isdisjoint((other[0], other[2]))


def _without_term(case: Case) -> bool:
    """Whether its chain holds without its right side, so that this alone is wrong."""
    number = case.row.link.number + 1
    return any(one.link.number == number and one.why == WITHOUT for one in case.others)


def _twins(case: Case) -> bool:
    """Whether another formula of its display with the same letters is proved, and none fails."""
    proved = [one for one in case.others if one.status in PASSES and one.link.sides]
    alike = any(
        {*symbols(one.link.sides[0]), *symbols(one.link.sides[2])} >= case.names  # type: ignore[index]
        for one in proved
    )
    return bool(case.names) and alike and len(proved) == len(case.others)


def _beside(case: Case) -> bool:
    return _chain_before(case) or _chain_after(case) or _twins(case)


SUPPORTS = (
    Evidence("the author calls it a claim", 9, _is_called),
    Evidence("the text says for which values it is claimed", 1, _is_claimed),
    Evidence("a formula one edit away holds", 3, _one_edit),
    Evidence("its chain holds without the term between", 2, _without_term),
    Evidence("a formula beside it holds, so that its letters are read rightly", 1, _beside),
)

# What throws doubt on the reading


def _is_conditional(case: Case) -> bool:
    return bool(_CONDITIONAL.search(case.words))


def _is_supposed(case: Case) -> bool:
    """Whether the words around it, or the sentence behind it, say that it may not hold."""
    after = prose.without_formulas(case.row.link.around[1])
    behind = _SENTENCE.match(after.lstrip(" \n.,;"))
    return bool(_SUPPOSED.search(f"{case.words} {behind[0] if behind else ''}"))


def _is_set(case: Case) -> bool:
    return bool(_TASK.search(case.words))


def _is_several(case: Case) -> bool:
    return bool(_OR.search(case.row.link.display.text))


def _is_solution(case: Case) -> bool:
    return case.row.link.solves is not None or case.row.why.startswith("it does not")


def _is_case(case: Case) -> bool:
    """Whether the text before it or behind it distinguishes cases."""
    before, after = (prose.without_formulas(text) for text in case.row.link.around[:2])
    return bool(_CASE.search(before[-MOST_BEFORE:]) or _OTHER_CASE.match(after))


def _is_marked(case: Case) -> bool:
    return bool(_MARKED.search(case.row.link.display.text))


def _is_labelled(case: Case) -> bool:
    """Whether a letter has a superscript 0 or 1, which is rarely a power."""
    return bool(_LABEL.search(case.row.link.shown))


def _is_of_decimals(case: Case) -> bool:
    return bool(re.search(r"\d\s*\.\s*\d", case.row.link.shown)) or "digits" in case.row.why


def _is_of_units(case: Case) -> bool:
    return bool(_SCALED.search(case.row.link.display.text))


def _is_under_condition(case: Case) -> bool:
    """Whether it holds under a condition, or with an absolute value: sqrt(u^2) = u for u > 0."""
    edits = [found.edit for found in case.row.instead]
    alone = bool(edits) and all(edit.startswith(("abs(", "-abs(")) for edit in edits)
    return alone or any(edit.startswith(GIVEN) for edit in edits)


def _is_without_limits(case: Case) -> bool:
    """Whether one side alone is an indefinite integral: its limits may be left out."""
    inside = [any(n.op == "antiderivative" for n in outermost(side)) for side in case.sides[::2]]
    return inside[0] != inside[1] and any(not symbols(side) for side in case.sides[::2])


def _is_equivalence(case: Case) -> bool:
    """Whether its display has a sign that may join two equations."""
    return bool(
        re.search(r"\\(?:equiv|iff|(?:Long|long)?[Ll]eftrightarrow)", case.row.link.display.text)
    )


def _is_behind_remark(case: Case) -> bool:
    return bool(_REMARK.search(case.row.link.display.text))


def _is_dotted(case: Case) -> bool:
    return "..." in case.row.refuted or "..." in case.row.link.read_as


def _is_substituted(case: Case) -> bool:
    return bool(case.row.put)


def _is_of_other_letter(case: Case) -> bool:
    """Whether du = 2x dx may speak of another u: unless its display defines u once, before it."""
    text, number = case.row.link.display.text, case.row.link.number
    for name in _replaced(case):
        printed = re.findall(rf"(?<![a-zA-Z\\{{])d\s*\\?{re.escape(name)}\s*&?\s*=", text)
        lefts = [
            str(one.link.sides[0])
            for one in case.others
            if one.link.sides and one.link.number < number
        ]
        if printed and (len(printed) > 1 or lefts.count(name) != 1):
            return True
    return False


def _is_defined_elsewhere(case: Case) -> bool:
    """Whether a letter was replaced by a definition outside its display: in W = int F dx = int k x
    dx another F may be meant than in F = -k x."""
    text = " ".join(map(str, case.sides[::2]))
    read = {part for name in _TOKEN.findall(text) for part in name.split("_")} | _CONSTANTS
    lefts = {str(one.link.sides[0]) for one in case.others if one.link.sides} | _replaced(case)
    shown = mentions(case.row.link.shown.split())
    return any(
        one.letter not in read | lefts and not (one.accent or one.subscript) for one in shown
    )


_CONSTANTS = frozenset("deiEC")


def _is_solving(case: Case) -> bool:
    """Whether it is one of the lines of a display that solves an equation in the same letters."""
    if case.row.link.goes_on:
        return False
    lines = [
        one
        for one in case.others
        if not one.link.goes_on and case.names and case.names <= _names(one.link.sides)
    ]
    unsolved = sum(one.status == "EQUATION" for one in lines)
    return unsolved > 0 or sum(one.status in ACCUSED for one in lines) > 1


def _is_implying(case: Case) -> bool:
    """Whether it stands alone in front of an arrow, as an equation does that is solved."""
    link = case.row.link
    after = (one.link for one in case.others if one.link.number == link.number + 1)
    alone = not link.goes_on and not any(one.goes_on for one in after)
    return alone and bool(re.search(r"\\(?:implies|(?:Long)?[rR]ightarrow)\b", link.display.text))


def _names(sides: tuple[Expr, str, Expr] | None) -> set[str]:
    return {*symbols(sides[0]), *symbols(sides[2])} if sides else set()


def _is_at_place(case: Case) -> bool:
    """Whether a letter stands alone before its value at a number, which then counts a place."""
    return bool(re.search(r"\bat\((\w+), \1, ", " ".join(map(str, case.sides[::2]))))


def _is_far(case: Case) -> bool:
    return "earlier sections" in case.row.why


def _is_one_sided(case: Case) -> bool:
    own, other = _letters(case)
    return not (own <= other or other <= own) and elementary(*case.sides[::2])


def _letters(case: Case) -> tuple[set[str], set[str]]:
    """Return the letters of both sides, with those of the definitions that stand for others."""
    put = dict(case.row.put)
    own, other = (
        {*symbols(side)} - {*symbols(INFINITY), *put}
        | {name for old in symbols(side) & put.keys() for name in symbols(put[old])}
        for side in case.sides[::2]
    )
    return own, other


def _is_of_other_letters(case: Case) -> bool:
    """Whether one side has a letter that the other one lacks, but for a constant of integration,
    and no formula beside it shows that its letters are read rightly."""
    own, other = _letters(case)
    return bool((own ^ other) - {"C", "c"}) and not (_beside(case) or _without_term(case))


def _is_of_value(case: Case) -> bool:
    sides = case.sides[::2]
    return elementary(*sides) and any(map(symbols, sides)) and not all(map(symbols, sides))


def _is_bound(case: Case) -> bool:
    return case.sides[1] in ("<", ">", "<=", ">=", "!=")


def _is_doubted(case: Case) -> bool:
    return any(doubt.kind not in _HARMLESS for doubt in case.row.link.ground.doubts)


_HARMLESS = frozenset((DoubtKind.NOT_FREE, DoubtKind.FAR, DoubtKind.DEFINITION))

DOUBTS = (
    Evidence("a condition may stand in the words around it", -1, _is_conditional),
    Evidence("the words around it set a task", -1, _is_set),
    Evidence("the words around it may only suppose it", -2, _is_supposed),
    Evidence("it may state several cases", -2, _is_several),
    Evidence("it may hold in one of several cases", -2, _is_case),
    Evidence("something in its display is struck out or questioned", -4, _is_marked),
    Evidence("a superscript in it may be a label", -4, _is_labelled),
    Evidence("it may hold as a solution", -2, _is_solution),
    Evidence("its numbers may be rounded", -2, _is_of_decimals),
    Evidence("its numbers may have units", -2, _is_of_units),
    Evidence("it holds under a condition, which the text may state", -4, _is_under_condition),
    Evidence("the limits of an integral may be left out", -4, _is_without_limits),
    Evidence("a sign in its display may join two equations", -4, _is_equivalence),
    Evidence("its line may continue the one before a remark", -4, _is_behind_remark),
    Evidence("the dots in it may stand for something else", -1, _is_dotted),
    Evidence("a definition is substituted, which may not hold there", -1, _is_substituted),
    Evidence("the letter in its differential may be another one", -2, _is_of_other_letter),
    Evidence("it may be a step of a solution", -3, _is_solving),
    Evidence("what it implies may be a step of a solution", -3, _is_implying),
    Evidence("a number behind a bar may count a place", -4, _is_at_place),
    Evidence("a definition from another display is substituted", -3, _is_defined_elsewhere),
    Evidence("a condition from another section is used", -1, _is_far),
    Evidence("each side has letters of its own, as an equation has", -2, _is_one_sided),
    Evidence("a letter is on one side only", -2, _is_of_other_letters),
    Evidence("one side has no letters, as in an equation to be solved", -2, _is_of_value),
    Evidence("the text may say for which values the bound is meant", -3, _is_bound),
    Evidence("a letter in it may be restricted", -2, _is_doubted),
)

# Other meanings, under which it holds


def _is_mistake(case: Case) -> bool:
    before, after = case.row.link.around[:2]
    words = f"{prose.last_sentence(before)} {' '.join(_SENTENCE.findall(after)[:2])}"
    if _FALSE.search(" ".join(_TEXT.findall(case.row.link.display.text))):
        return True
    return bool(_MISTAKE.search(prose.without_formulas(words)))


def _is_of_integers(case: Case) -> bool:
    """Whether it holds if the letters of indices are positive integers: cos(x + 2 pi n) = cos x."""
    names = [name for name in sorted(case.names) if name in "nmkj"]
    if not names or not case.row.refuted or " as " in case.row.refuted:
        return False
    whole = ", ".join(f"{name} integer, {name} >= 1" for name in names)
    asked = under_also(case.row.refuted, whole)
    try:
        return check_within(Task(asked), 2.0).verdict is not Verdict.REFUTED
    except InputError:
        return False


def _is_of_each_sign(case: Case) -> bool:
    return "\\pm" in case.row.link.display.text and _is_several(case)


def _is_with_longer_sums(case: Case) -> bool:
    return bool(alike := _with_longer_sums(case.row)) and _holds(alike)


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


MEANT = (
    Evidence("the text calls it a mistake", 0, _is_mistake),
    Evidence("the sign may mean the same order, as Theta does", 0, lambda c: _is_of_order(c.row)),
    Evidence("the sides may be in different units", 0, lambda c: _in_other_unit(c.row)),
    Evidence(
        "an equation for the symbol that stands alone on one side of it",
        0,
        lambda c: not c.row.instead and _is_to_be_solved(c.row),
    ),
    Evidence(
        "a solution for some values of the other symbols, or with rounded numbers",
        0,
        lambda c: _is_solution_of_some(c.row),
    ),
    Evidence("it holds for positive integers, which its letters may be", 0, _is_of_integers),
    Evidence("each sign may have a value of its own", 0, _is_of_each_sign),
    Evidence(
        "the integer may be rounded, as the decimals on the other side are",
        0,
        lambda c: _is_rounded_to_integer(c.row),
    ),
    Evidence("it holds if what follows a sum or a function belongs to it", 0, _is_with_longer_sums),
)
