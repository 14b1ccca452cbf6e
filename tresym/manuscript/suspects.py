"""Proof-reading: which equalities that fail are misprints, and what is true instead.

An equality that fails somewhere may be an equation to be solved, a law, a condition, a definition,
or a misprint. It may be a misprint if no words around it introduce it as one of the former, and

- a statement one edit away holds, or it holds itself under a natural condition, or
- the other links of its display are identities, or a word such as "hence" leads to it, and both
  sides have the same variables.

A symbol that is defined again near by, one edit away from another form of its first definition and
without a word such as "now", is SUSPECT as well. What is REFUTED gets the suggestions. Then all of
them are weighed: what has support is REFUTED, the rest SUSPECT (:mod:`tresym.manuscript.support`).
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Sequence
from dataclasses import replace
from itertools import groupby

from tresym.checking.time_limited import Task, check_within
from tresym.manuscript import prose
from tresym.manuscript.accusations import DoubtKind, sought_on_path
from tresym.manuscript.aftermath import settled
from tresym.manuscript.classification import (
    ASSUMED,
    CONSTANTS,
    DEFINED,
    EQUATION,
    UNREAD,
    Link,
    Obstacle,
)
from tresym.manuscript.deciding import COORDINATE, Row, under_also
from tresym.manuscript.mentions import names_in
from tresym.manuscript.support import SUSPECT
from tresym.manuscript.terms import unknown_in
from tresym.reals.decisions.answer import Alternative
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Cause, Verdict
from tresym.repair import suggestions
from tresym.repair.agreement import Definitions
from tresym.repair.search import GIVEN, SECONDS

_INTRODUCED = re.compile(
    r"\b(?:equations?|solv\w+|solutions?|roots?|satisf\w+|obeys?|fulfil\w+|unknowns?|curves?|system"
    r"|lines?|circles?|ellips\w+|hyperbolas?|parabolas?|conics?|planes?|surfaces?|spheres?|locus"
    r"|graph|constraints?|conditions?|requir\w+|equilibri\w+|conserv\w+|laws?|boundary|initial"
    r"|critical|stationary|intersect\w+|meets?|model\w*|relat(?:es|ing)|dispersion|state|rule"
    r"|suppos\w+|assum\w+|hypothes\w+|ansatz|try|seek|postulat\w+|let|set|setting|put|choos\w+"
    r"|chosen|defin\w+|denot\w+|introduc\w+|abbreviat\w+|call(?:ed)?|impos\w+|demand\w*|unless"
    r"|consider|zeros?|vanish\w*|find|determin\w+|wrong\w*|false|incorrect\w*|(?:only )?if(?=\W*\Z)"
    r"|when(?=\W*\Z)|mistak\w*|err(?:or|oneous)\w*|not|never|fails?|counterexample|contradict\w*"
    r"|absurd|differential)\b",
    re.IGNORECASE,
)
"""Words before a display that mark it as an equation or the like, not as an identity."""
_AFTER = re.compile(
    r"\b(?:solutions?|roots?|solv\w+|satisf\w+|if and only if|holds? (?:only )?(?:if|when)"
    r"|unknowns?|is (?:called|false|wrong|not)|does not hold|equation|zeros?|cannot"
    r"|contradict\w*|absurd"
    r"|impossible|fails)\b",
    re.IGNORECASE,
)
"""Words behind a display that mark it as an equation or the like, not as an identity."""
_TOLD = re.compile(
    r"\b(?:hence|therefore|thus|identit\w+|it follows|consequently|then"
    r"|we (?:\w+ )?(?:get|obtain|find|have|see|prove|show|compute|deduce)|gives?|yields?|shows?"
    r"|implies|becomes?|know that)\b",
    re.IGNORECASE,
)
"""Words that claim that the display behind them holds for all values."""
_SIGNED = re.compile(
    r"\b(?:positive|negative|non-?negative|integers?|natural|whole|acute|distances?|lengths?|radius"
    r"|quadrant|angles?|large|small|greater|less|between|least|most)\b|[<>]|\\[gl]e|\\in\b",
    re.IGNORECASE,
)
"""Words and signs by which variables do not take all real values."""
_HARMLESS = frozenset((DoubtKind.NOT_FREE, DoubtKind.DEFINITION, DoubtKind.RANGE))
"""Reasons to withhold a refutation in spite of which the link may be a misprint."""
_WORDS = frozenset((DoubtKind.SENTENCE, DoubtKind.FAR, DoubtKind.FUNCTION))
"""Reasons that the form of an equality may outweigh: words around it, definitions elsewhere."""
_OPEN = (Cause.NO_POINT, Cause.NO_VALUE)
"""What stopped the decision of an equality that may nevertheless be a misprint."""
_ANEW = re.compile(
    r"\b(?:now|instead|if|or|cases?|otherwise|alternativ\w+|example|exercise|second|other|another|new"
    r"|next|then for|redefin\w+|approximat\w+|similarly|whereas|while)\b",
    re.IGNORECASE,
)
"""Words by which a symbol may stand for something else."""
_LET = re.compile(r"\b(?:let|for|with|where|when|if|at|put|set|takes?)\b[^.$]*\$", re.IGNORECASE)
"""Words by which a variable has a value."""
_SOLVE = re.compile(r"\b(?:solv(?:e|ed|ing)|solutions? (?:of|to|for))\b", re.IGNORECASE)
_TOTALS = frozenset(("integral", "limit", "product", "sum"))
_PATH = re.compile(r" as (\w+) -> ")
_BOUNDS = frozenset(("<", "<=", ">", ">="))
_STRICT = re.compile(r" ([<>])=? ")
_RELATIONS = frozenset(("==", "<", "<=", ">", ">="))
_HOLD = frozenset(("PROVED", "ENCLOSED"))


def proofread(
    rows: Sequence[Row], seconds: float = SECONDS, processes: int | None = None
) -> list[Row]:
    """Return the rows with misprints marked, REFUTED or SUSPECT, and with true statements close to
    them.

    Args:
        seconds: processor time for each search.
        processes: how many searches at once; None for one per core.
    """
    asked = {
        n: row
        for n, row in enumerate(rows)
        if row.status == "REFUTED" or may_be(row) or _defined_again(row)
    }
    texts = [_question(row) for row in asked.values()]
    searched = suggestions(texts, processes, seconds) if texts else ()
    found = {n: tuple(map(_as_written, some)) for n, some in zip(asked, searched, strict=True)}
    blocks = _blocks(rows)
    result = list(rows)
    for n, row in asked.items():
        instead = found[n]
        if row.status == "REFUTED":
            result[n] = replace(row, instead=instead)
            continue
        if row.status == DEFINED:
            found_again = next((one for one in instead if _says_more(one)), None)
            if found_again is not None:
                why = f"{row.put[-1][0]} was {row.put[-1][1]} before; an edit makes them equal"
                result[n] = replace(row, status=SUSPECT, why=why, instead=instead, refuted="")
            continue
        why = "" if _redefined(row, rows) else reason(row, instead, blocks[n])
        if why and (_is_free(row) or _fails_for_positive(row)):
            witness = row.fails_at
            result[n] = replace(row, status=SUSPECT, why=why, instead=instead, witness=witness)
    for n, row in enumerate(result):
        if why := bound_outside(row) or false_for_all(row):
            result[n] = replace(row, status=SUSPECT, why=why, witness=row.fails_at)
    return settled(result, processes=processes)


def false_for_all(row: Row) -> str:
    """Return how much the sides of a link within a chain differ whatever its functions and symbols
    are, as those of ``f(3) - f(3) = -80`` do; empty if that depends on them."""
    sides = row.link.sides
    withheld = row.status in ("UNDECIDED", EQUATION) and bool(row.refuted) and row.link.goes_on
    if not withheld or sides is None or sides[1] != "==" or row.link.noted or row.holds_given:
        return ""
    try:
        rest = normal_form(sides[0] - sides[2], Given())
    except (InputError, ZeroDivisionError):
        return ""
    named = symbols(sides[0]) | symbols(sides[2]) | unknown_in(sides[0], sides[2])
    if not named or rest.op != "number" or not rest.args[0]:
        return ""
    return f"the sides differ by {rest}, whatever {', '.join(sorted(named))} may be"


def bound_outside(row: Row) -> str:
    """Return which variable of a limit, a definite integral or a sum on one side of an equality
    stands free on the other, as x in ``lim(f, x, 0) == 3*x``; empty if none does."""
    sides = row.link.sides
    if row.status != EQUATION or not row.refuted or sides is None or row.put or row.link.noted:
        return ""
    if _is_to_be_solved(row.link) or _LET.search(prose.without_formulas(row.link.around[0])[-60:]):
        return ""
    for one, other in (sides[::2], sides[::-2]):
        for node in outermost(one):
            loose = {*node.names} & symbols(other) - symbols(one)
            if node.op in _TOTALS and loose and sides[1] == "==":
                name = min(loose)
                return f"{name} is the variable of the {node.op} on one side, and free on the other"
    return ""


def _defined_again(row: Row) -> bool:
    """Whether a row defines a symbol again, near by, by a formula with the same letters."""
    sides = row.link.sides
    if row.status != DEFINED or not row.put or not row.refuted or sides is None:
        return False
    if not row.why.startswith("defined differently") or sides[0].op != "symbol":
        return False
    values = [value for name, value in row.put if name == str(sides[0])]
    alike = [symbols(value) == symbols(sides[2]) for value in values]
    words = prose.without_formulas(row.link.around[0])
    return bool(symbols(sides[2])) and alike == [True] and not _ANEW.search(words)


def _says_more(found: Alternative) -> bool:
    """Whether the formula that holds has sides of different form, and so is no mere repetition."""
    left, equal, right = found.claim.partition(" given ")[0].partition(" == ")
    return bool(equal) and left.strip() != right.strip() and not found.edit.startswith(GIVEN)


def _fails_for_positive(row: Row) -> bool:
    """Whether a link that fails at a negative number fails for positive ones too, as lengths are
    which the text did not introduce."""
    if not any(value.startswith("-") for value in (row.fails_at or {}).values()):
        return True
    claim = row.failing or row.refuted
    names = ", ".join(f"{name} > 0" for name in sorted(row.fails_at or {}) if "(" not in name)
    if " as " in claim or not names:
        return True
    try:
        return check_within(Task(under_also(claim, names)), SECONDS).verdict is Verdict.REFUTED
    except InputError:
        return False


def _as_written(found: Alternative) -> Alternative:
    """Return a suggestion in which functions have the names that the author uses."""
    return Alternative(*(re.sub(r"\bfn_", "", text) for text in found))


def _redefined(row: Row, rows: Sequence[Row]) -> bool:
    """Whether its display gives a symbol of the link a value that was not read, as ``v = ?``."""
    unread = {
        one.link.shown.partition(" = ")[0]
        for one in rows
        if one.link.display == row.link.display and one.status in (UNREAD, "UNDECIDED")
        if " = " in one.link.shown and one.link is not row.link
    }
    return not unread.isdisjoint(row.link.shown.split())


def may_be(row: Row) -> bool:
    """Whether a row may be a misprint: it fails, and no words mark it as an equation."""
    link = row.link
    if row.status not in (EQUATION, "UNDECIDED") or link.sides is None or row.holds_given:
        return False
    left, relation, right = link.sides
    path = _PATH.search(link.claims[0].text) if link.claims else None
    if path and sought_on_path(left, relation, right, path[1]):
        return False
    vary = link.same and bool(symbols(left)) and bool(symbols(right))
    if relation not in _RELATIONS or _is_to_be_solved(link):
        return False
    to_constant = link.goes_on and not symbols(right)  # … = f(x) = 1: only a repair tells
    meant = is_meant(link) or to_constant
    if not meant and (is_introduced(link) or _stands_alone(left, right)):
        return False
    kinds = {doubt.kind for doubt in link.ground.doubts} - _HARMLESS
    if DoubtKind.FAR in kinds and not symbols(left) | symbols(right):
        return False  # numbers by a function of another example
    kinds -= _WORDS if meant else {DoubtKind.FAR} if vary else set()
    if link.goes_on or _of_terms(left, right):
        kinds -= {DoubtKind.FUNCTION}
    if link.goes_on and elementary(left, right):
        kinds -= {DoubtKind.UNREAD}  # a derivative that both sides contain, if a repair is found
    if kinds or _has_constants(left, right):
        return False
    if relation != "==":
        return bool(row.refuted) and not row.put
    return bool(row.refuted) or (bool(link.claims) and row.cause in _OPEN)


def _is_to_be_solved(link: Link) -> bool:
    """Whether the sentence before it asks to solve it, as "Solve for $x$:" does."""
    return not link.goes_on and bool(_SOLVE.search(prose.last_sentence(link.around[0])))


def is_meant(link: Link) -> bool:
    """Whether the form of an equality shows that it is meant for all values of its symbols,
    whatever the words around it: it continues a chain, or it evaluates an integral or the like,
    and one side has no symbol that the other does not have."""
    if link.sides is None or link.sides[1] != "==" or link.noted in (prose.SOLVE, prose.ASSUME):
        return False
    if unknown_in(link.sides[0]) != unknown_in(link.sides[2]):
        return False  # it says what a function is
    left, right = (symbols(side) for side in link.sides[::2])
    shared = bool(left and right) and (left <= right or right <= left)
    alike = any(asked.same and asked.may_fail for asked in link.claims)
    return (link.goes_on and (shared or alike)) or (link.worked and link.same)


def _of_terms(left: Expr, right: Expr) -> bool:
    """Whether both sides contain the same unknown sequence, each at several places, as identities
    of differences do: then a near identity tells more than the shape of an equation."""
    return all(
        len({node for node in outermost(side) if node.op == "unknown"}) > 1
        for side in (left, right)
    ) and unknown_in(left) == unknown_in(right)


def _has_constants(*sides: Expr) -> bool:
    """Whether both sides are linear in a constant that is to be determined.

    A constant of integration, which is added to both sides, is not.
    """
    if not elementary(*sides):
        return False
    names = [name for name in symbols(sides[0]) & symbols(sides[1]) if CONSTANTS.fullmatch(name)]
    slopes = [[differentiate(side, name) for side in sides] for name in names]
    return any(
        all(name not in symbols(slope) for slope in found) and found[0] != found[1]
        for name, found in zip(names, slopes, strict=True)
    )


def _question(row: Row) -> tuple[str, Definitions, bool, bool]:
    """Return the claim to repair, its substitutions, whether to be cautious, and whether to try
    unusual edits."""
    relation, sure = row.link.sides[1] if row.link.sides else "", row.status == "REFUTED"
    if row.status == DEFINED:
        return row.failing, (), False, False
    if row.refuted:
        return row.refuted, row.put, relation != "==" and not sure, sure
    if sure:
        return row.link.read_as, (), False, True
    return row.link.claims[0].text, (), True, False


def is_introduced(link: Link) -> bool:
    """Whether words around a display mark it as an equation, a condition or the like."""
    before, after = link.around[:2]
    lead, trail = (_words(prose.last_sentence(before)), _words(prose.first_sentence(after)))
    if _AFTER.search(trail) or link.noted in (prose.SOLVE, prose.ASSUME, prose.DEFINE):
        return True
    introduced, told = (_last(pattern, lead) for pattern in (_INTRODUCED, _TOLD))
    return introduced > told


def _last(pattern: re.Pattern[str], text: str) -> int:
    """Return where the last match of a pattern ends, -1 if there is none; means do not count."""
    return max((found.end() for found in pattern.finditer(_METHODS.sub(_blank, text))), default=-1)


def _blank(found: re.Match[str]) -> str:
    return " " * len(found[0])


def _words(text: str) -> str:
    return prose.without_formulas(text)


_METHODS = re.compile(
    r"\b(?:by|from|using|use|with|via|apply(?:ing)?|into|in|of|both sides of)\b[^,.;:]*?"
    r"\b(?:equations?|laws?|conditions?|relations?|definitions?|rules?|solutions?)\b",
    re.IGNORECASE,
)
"""The means of a derivation, which say nothing about its result: "by the equation above"."""


def _stands_alone(left: Expr, right: Expr) -> bool:
    """Whether an equality has the form of a definition, a law or an equation: one side is a symbol
    that the other does not contain, or the sides have no symbol in common."""
    own, others = symbols(left), symbols(right)
    if own and others and own.isdisjoint(others):
        return True
    if bool(own) != bool(others) and not elementary(right if own else left):
        return True  # the value of an integral in letters
    pairs = ((left, others), (right, own))
    return any(side.op == "symbol" and symbols(side).isdisjoint(rest) for side, rest in pairs)


def reason(row: Row, instead: Sequence[Alternative], others: Sequence[str]) -> str:
    """Return why a failing equality looks like a misprint; empty if it does not.

    Args:
        instead: true statements close to it.
        others: the statuses of the other links of its display.
    """
    at = ", ".join(f"{name} = {value}" for name, value in (row.fails_at or {}).items())
    fails = f"it fails at {at}" if at else "it fails" if row.refuted else row.why
    relation = row.link.sides[1] if row.link.sides else ""
    if any(one.edit.startswith(GIVEN) for one in instead) and not _is_free(row):
        return ""  # the unread text may well state the condition
    if relation != "==" and instead and _STRICT.sub(r" \1 ", instead[0].claim) == _bare(row):
        return ""  # only strictness differs: the sides are equal at single points
    if instead:
        first = instead[0]
        condition = first.edit.startswith(GIVEN)
        return (
            (f"{fails}; it holds {first.edit}")
            if condition
            else f"{fails}; a statement close to it holds"
        )
    if relation != "==" or not row.refuted:
        return ""
    if any(doubt.kind is DoubtKind.UNREAD for doubt in row.link.ground.doubts):
        return ""
    link = row.link
    sides = (link.sides[0], link.sides[2]) if link.sides else ()
    if not sides or not link.same or any(not symbols(side) for side in sides):
        return ""
    if any(doubt.kind is DoubtKind.FAR for doubt in link.ground.doubts):
        return ""
    read = [status for status in others if status != UNREAD]
    if read and all(status in _HOLD for status in read):
        return f"{fails}; the other links of its display are identities"
    lead = _words(link.around[0])
    several = len(symbols(sides[0])) > 1  # with one variable it may be an equation
    if _INLINE.search(prose.last_sentence(link.around[0])):
        return ""  # "At a fixed point $y = x^y$ this becomes": it holds there
    if several and _TOLD.search(lead[-60:]) and not _INTRODUCED.search(lead):
        return f"{fails}; the words before it claim that it holds"
    return ""


_INLINE = re.compile(
    r"\b(?:at|for|when|where|if|with|since|as|using|because)\b[^.;$]{0,40}"
    r"(?:\$|\\\()[^$]*?=[^$]*?(?:\$|\\\))",
    re.IGNORECASE,
)
"""An equation within the words before a display, which may be a condition of it."""


def _bare(row: Row) -> str:
    """Return the failing claim without conditions, with its relation made strict."""
    return _STRICT.sub(r" \1 ", row.refuted.partition(" given ")[0])


def _is_free(row: Row) -> bool:
    """Whether the letters of the variables usually take all real values, and no word says
    otherwise."""
    names = symbols(row.link.sides[0]) | symbols(row.link.sides[2]) if row.link.sides else set()
    text = row.link.around[0] + row.link.around[1][: prose.MAX_AFTER]
    plain = all(COORDINATE.fullmatch(name) for name in names)
    return plain and not row.put and not row.link.ground.doubts and not _SIGNED.search(text)


def _blocks(rows: Sequence[Row]) -> dict[int, list[str]]:
    """Return, for each row, the statuses of the other links in its display."""
    result: dict[int, list[str]] = {}
    for _, group in groupby(enumerate(rows), key=lambda pair: pair[1].link.display.number):
        found = list(group)
        for n, _ in found:
            result[n] = [_bare_status(row) for m, row in found if m != n]
    return result


def _bare_status(row: Row) -> str:
    """Return the status, EQUATION for what holds only where an equation before it does."""
    return EQUATION if row.why.startswith(("it follows", "it solves")) else row.status


_SKIPPED = re.compile(r"[\s&{}]|\\(?:left|right|,|;|:|!|quad|qquad|nonumber|notag|label\{[^}]*\})")


def printed(link: Link) -> str:
    """Return the source of a link: its line of the display, or the whole display."""
    whole = " ".join(link.display.text.split())
    wanted = _SKIPPED.sub("", link.shown)
    for line in re.split(r"\\\\(?:\[[^]]*\])?", whole):
        if wanted and wanted in _SKIPPED.sub("", line):
            return line.strip().rstrip(".,; ")
    return whole


def attention(rows: Iterable[Row]) -> list[Row]:
    """Return the rows that an author must look at: the REFUTED ones, then the SUSPECT ones."""
    found = [row for row in rows if row.status in (SUSPECT, "REFUTED")]
    return sorted(found, key=lambda row: row.status == SUSPECT)


def failing(rows: Iterable[Row]) -> list[Row]:
    """Return the rows that fail somewhere and are not accused, although they may be claims."""
    return [row for row in rows if _fails(row)]


def _fails(row: Row) -> bool:
    link = row.link
    if row.holds_given or link.sides is None:
        return False
    if row.fails_at is None:
        return row.cause is Cause.UNCONFIRMED and (link.same or is_meant(link))
    if row.status == DEFINED:  # it does not solve the equation before it
        return link.solves is not None and link.solves.called
    if row.status == ASSUMED:  # f << g along a stated path
        return " as " in row.refuted
    bounded = names_in(link.claims[0].given) if link.claims else frozenset()
    if link.sides[1] in _BOUNDS and row.status == "UNDECIDED":
        return names_in([link.sides]) <= bounded and not is_introduced(link)
    unread = any(doubt.kind is DoubtKind.UNREAD for doubt in link.ground.doubts)
    if row.status == "UNDECIDED":
        same = link.same and (link.goes_on or not unread)
        tends = " as " in row.refuted or "limit(" in row.refuted
        return same or tends or link.solves is not None or is_meant(link)
    if row.status == UNREAD:
        return row.obstacle is Obstacle.CONDITION and is_meant(link)
    names = symbols(link.sides[0]) | symbols(link.sides[2])
    put = {name for name, _ in row.put}
    closed = bool(names) and names <= put and not link.unknown  # nothing is left to solve for
    unclear = link.same and not is_introduced(link) and not link.unknown
    return row.status == EQUATION and (closed or unclear or is_meant(link))


_OPEN_STATUSES = ("UNREAD", "UNDECIDED", EQUATION)


def grouped_by_reason(rows: Iterable[Row]) -> list[tuple[tuple[str, str], list[Row]]]:
    """Return the rows that are not decided by status and reason, the most common reason first."""
    reasons: dict[tuple[str, str], list[Row]] = {}
    for row in rows:
        if row.status in _OPEN_STATUSES:
            reasons.setdefault((row.status, _short_reason(row)), []).append(row)
    return sorted(reasons.items(), key=lambda item: -len(item[1]))


def _short_reason(row: Row) -> str:
    """Return the reason of a row without the names and formulas that are its own."""
    if row.obstacle is not None and row.status != EQUATION:
        return row.obstacle.value.partition(";")[0]
    if row.status == EQUATION:
        return "an equation, or a statement about unknown symbols"
    text = re.split(r"[;:(]|, near | at '", row.why)[0]
    text = re.sub(r"^\S+(?: \S+)? is (?=an? |of unknown)", "a symbol is ", text)
    return text[:80].strip(" ,")
