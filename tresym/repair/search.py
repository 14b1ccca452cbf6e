"""Search for true statements close to a refuted claim.

Three kinds of candidates are searched: the claim on parts of the line and of the plane, all claims
one edit away, and other values of an integral, a sum, a limit or a constant. Candidates are
filtered in floating point at several points of the conditions. The remaining ones are decided
exactly like any other claim. Trivial statements are dropped. The most common misprints come first.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator, Sequence
from itertools import islice, takewhile
from statistics import median

from tresym.checking.dispatch import decide_claim
from tresym.reals.decisions.answer import Alternative
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    Expr,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.parsing import parse_claim, parse_given, sequences_of
from tresym.reals.language.paths import read_path
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import TimeUp, time_limit
from tresym.repair.agreement import Claim, Definitions, agrees_with_values, without_integrals
from tresym.repair.edits import (
    FACTOR,
    FUNCTION,
    OTHER,
    VARIABLE,
    WRAPPED,
    Edit,
    edits,
    lone_variables,
)
from tresym.repair.expansions import true_expansions
from tresym.repair.floating import Points, UnsupportedError
from tresym.repair.like_terms import collected, is_trivial, loses_names
from tresym.repair.regions import holding
from tresym.repair.samples import held, sampled
from tresym.repair.values import values, worked_side

SECONDS = 1.0
MOST, DECIDED = 3, 20
"""The most suggestions for a claim, and the most candidates that are decided; these counts, and not
the time, end nearly every search, so that equal runs make equal suggestions."""
GRID, FEW = 70, 9
"""The numbers of points at which conditions and edits are tested."""
MORE = 2
"""How many times as much more the true expansion gets, which is nearly always what was meant."""
SHARE = 0.3
"""The share of the time for the decision of one candidate."""
MOST_REGIONS = 4
MOST_SIZE = 400
"""The maximal size of a claim for which edits are tried."""
SMALL = 3.0
"""The largest value of a variable in a claim with integrals."""
VALUE = FUNCTION - 0.5
"""The rank of other values among the edits."""
TOUCHING = 1e-6
"""The relative distance below which the sides of an inequality count as touching."""
FAR = 0.5
"""The relative distance above which the sides of an inequality are far from each other."""
APART = 1e-3
"""The relative distance above which the sides of an equality count as different."""
GIVEN = "given"
"""The first word of an edit that adds a condition."""
_BOUNDS = frozenset(("<", "<=", ">", ">="))
_CLOSED = {"<": "<=", ">": ">="}


def alternatives(
    text: str,
    seconds: float = SECONDS,
    most: int = MOST,
    put: Definitions = (),
    cautious: bool = False,
    unusual: bool = True,
) -> tuple[Alternative, ...]:
    """Return true alternatives to a refuted claim, the likeliest first.

    Args:
        text: the claim with its conditions and its path, in the text grammar.
        seconds: the processor time of the search.
        most: the maximal number of alternatives.
        put: definitions of symbols, which remain in the alternatives.
        cautious: whether to avoid claims that may be true or have another meaning. Then only
            inequalities whose sides touch are returned, and nothing for an equality whose sides are
            not seen to differ.
        unusual: whether uncommon edits count as well.

    Example:
        >>> [found.claim for found in alternatives("cos(2*x) == 2*cos(x)**2 + 1", most=1)]
        ['cos(2*x) == 2*cos(x)**2 - 1']
    """
    try:
        claim = _parsed(text)._replace(put=put)
    except InputError:
        return ()
    hard = any(node.op in ("integral", "sum") for term in claim.terms for node in outermost(term))
    if hard and seconds:
        import sympy  # noqa: F401 - its import shall not count as time of the search
    if cautious and not _is_inequality(claim) and not _differs(claim):
        return ()
    end = time.process_time() + seconds
    found: list[Alternative] = []
    tried = 0
    until = time.process_time() + seconds / 2
    for rank, candidate, more, edit in _candidates(claim, until):
        left = end - time.process_time() + (MORE * seconds if rank < 0 else 0)
        if left <= 0 or len(found) >= most or tried >= DECIDED:
            break
        if rank >= OTHER and not unusual:
            continue
        if cautious and _is_inequality(claim) and (more or not _touches(candidate)):
            continue
        if more and any(one.edit.startswith(GIVEN) for one in found):
            continue  # a stricter condition than one already found
        if any(one.claim == candidate.says() for one in found) and not more:
            continue
        if _replaced(edit) and any(_replaced(one.edit) == _replaced(edit) for one in found):
            continue  # another term in the place where a likelier one was found
        head = _before_order(claim.says())
        weaker = head and head == _before_order(candidate.says())
        if weaker and any(_before_order(one.claim) == head for one in found):
            continue  # a weaker comparison function than one already found
        tried += 1
        asked = _as_asked(candidate.text(more), text)
        verdict = _decided(asked, left if hard or rank < 0 else min(left, SHARE * seconds))
        if verdict:
            under = ", ".join(filter(None, (chained(claim.given), more)))
            if more:
                edit = f"{GIVEN} {more}"
            found.append(Alternative(candidate.says(), under, edit, verdict))
    return tuple(found)


def _replaced(edit: str) -> str:
    """Return what an edit in words replaces: ``b`` of "a in place of b"; empty for other edits."""
    return edit.partition(" in place of ")[2]


def _before_order(claim: str) -> str:
    """Return the text of a claim before its O(…) or o(…); empty without one."""
    return re.split(r"\b[oO]\(", claim, maxsplit=1)[0] if re.search(r"\b[oO]\(", claim) else ""


def _parsed(text: str) -> Claim:
    """Return the parts of a claim.

    Raises:
        InputError: it is not in the text grammar.
    """
    text, _, _ = text.replace(" uniformly", "").partition(" on ")
    claim, _, end = text.partition(" as ")
    claim, _, under = claim.partition(" given ")
    links = parse_claim(claim, sequences_of(under))
    terms = (links[0][0], *(link[2] for link in links))
    relations = tuple(link[1] for link in links)
    return Claim(terms, relations, tuple(parse_given(under)), read_path(end) if end else None)


def _as_asked(candidate: str, text: str) -> str:
    """Return a candidate with the region and the uniformity that the refuted claim asks for."""
    if " uniformly" in text:
        before, word, path = candidate.rpartition(" as ")
        candidate = f"{before} uniformly{word}{path}"
    _, word, on = text.partition(" on ")
    return candidate + word + on


def _decided(text: str, seconds: float) -> str:
    """Return PROVED or ENCLOSED, or "" for a claim that is not proved in time."""
    try:
        with time_limit(seconds):
            answer = decide_claim(text)
    except (InputError, TimeUp):
        return ""
    except Exception:  # a candidate at which a procedure fails is no suggestion
        return ""
    return answer.verdict.value if answer else ""


def _candidates(claim: Claim, until: float) -> Iterator[tuple[float, Claim, str, str]]:
    """Yield candidates: the rank, the claim, one more condition or "", and the edit in words."""
    for candidate, edit in true_expansions(claim):
        yield -1.0, candidate, "", edit
    grid = _grid(claim)
    under = _regions(claim, grid)
    if _is_inequality(claim):  # an inequality nearly always holds on some part
        usual = list(takewhile(lambda found: found[0] <= FUNCTION, _ranked(claim, grid, until)))
        yield from usual
        yield from under
        return
    yield from under
    yield from _ranked(claim, grid, until)


def _grid(claim: Claim) -> Points | None:
    """Return points at which the conditions hold; None if none is found in floating point."""
    terms = claim.defined().terms
    names = sorted(frozenset().union(*map(symbols, terms)) - symbols(INFINITY))
    hard = any(node.op == "integral" for term in terms for node in outermost(term))
    given = [*claim.given, *_of_ends(terms)]
    try:
        found = sampled(names, given, *((FEW, SMALL) if hard else (GRID,)))
        return None if found is None else _with_values(found, claim.put)
    except (UnsupportedError, InputError):
        return None


def _of_ends(terms: Sequence[Expr]) -> list[Compared]:
    """Return the conditions that the ends of finite sums and products are positive integers."""
    nodes = [node for node in outermost(*terms) if node.op in ("sum", "product")]
    names = frozenset().union(*(symbols(end) for node in nodes for end in node.args[1:]))
    return parse_given(
        ", ".join(f"{n} integer, {n} >= 1" for n in sorted(names - symbols(INFINITY)))
    )


def _with_values(points: Points, put: Definitions) -> Points:
    """Return the points with the values of defined symbols."""
    for name, value in reversed(put):
        points = Points({**points.at, name: points.values(value)}, points.count)
    return points


def _is_inequality(claim: Claim) -> bool:
    return any(relation in _BOUNDS for relation in claim.relations)


def _regions(claim: Claim, grid: Points | None) -> Iterator[tuple[float, Claim, str, str]]:
    """Yield the claim under natural conditions."""
    if grid is None or claim.path is not None:
        return
    try:
        links = [without_integrals(link) for link in claim.links]
        usual = (more for more in holding(links, grid, claim.integers) if _is_apart(claim, more))
        for more in islice(usual, MOST_REGIONS):
            yield 0.0, claim, more, ""
    except (UnsupportedError, InputError):
        return


def _is_apart(claim: Claim, more: str) -> bool:
    """Return whether a condition restates neither the claim nor the ends of a sum."""
    nodes = [n for n in outermost(*claim.terms) if n.op in ("sum", "product")]
    ends = frozenset().union(*(symbols(end) for node in nodes for end in node.args[1:]))
    gaps = {collected(a - b) for a, _, b in claim.links} | {
        collected(b - a) for a, _, b in claim.links
    }
    conditions = parse_given(more)
    names = frozenset().union(*(symbols(a) | symbols(b) for a, _, b in conditions))
    return names.isdisjoint(ends) and all(collected(a - b) not in gaps for a, _, b in conditions)


def _ranked(
    claim: Claim, grid: Points | None, until: float
) -> Iterator[tuple[float, Claim, str, str]]:
    """Yield other values and edits with their ranks, the likelier ones first."""
    seen = {_key(claim.terms)}
    valued = [(VALUE, *found, "") for found in _valued(claim)]
    edited = _surviving(claim, grid, until)
    if _is_inequality(claim):
        edited = iter(_sharp_first(claim, edited))
    for edit in edited:
        while valued and valued[0][0] < edit.rank:
            yield from _new(seen, valued.pop(0))
        other = claim._replace(terms=edit.terms, relations=edit.relations)
        if edit.relations != claim.relations:
            yield edit.rank, other, "", edit.says
        else:
            yield from _new(seen, (edit.rank, other, edit.says, ""))
    for value in valued:
        yield from _new(seen, value)


def _new(
    seen: set[object], found: tuple[float, Claim, str, str]
) -> Iterator[tuple[float, Claim, str, str]]:
    """Yield a candidate unless an earlier one differs only in the order of terms and factors."""
    rank, claim, says, more = found
    key = _key(claim.terms)
    if key not in seen:
        seen.add(key)
        yield rank, claim, more, says


def _key(terms: Sequence[Expr]) -> object:
    try:
        return tuple(map(collected, terms))
    except InputError:
        return tuple(terms)


def _valued(claim: Claim) -> Iterator[tuple[Claim, str]]:
    """Yield the claim with another value."""
    if len(claim.terms) != 2:
        return
    side = worked_side(claim.links[0])
    for value in values(claim.links[0], claim.given):
        terms = (claim.terms[0], value) if side == 0 else (value, claim.terms[1])
        what = {"integral": "integral", "sum": "sum", "product": "product"}
        node = next(iter(outermost(claim.terms[0 if side == 0 else 1])), None)
        name = what.get(node.op, "value") if node is not None else "value"
        yield claim._replace(terms=terms), f"the {name} is {value}"


def _surviving(claim: Claim, grid: Points | None, until: float) -> Iterator[Edit]:
    """Yield nontrivial edits that hold in floating point, by rank.

    Edits that leave integrals unchanged are cheap to test and come first within the common ranks.
    """
    if sum(term.size for term in claim.terms) > MOST_SIZE:
        return
    points = None if grid is None else _telling(claim, grid)
    known = {node for term in claim.terms for node in outermost(term) if node.op == "integral"}
    waiting: list[Edit] = []
    for edit in edits(claim.terms, claim.relations, claim.integers, not claim.put):
        if (waiting and waiting[-1].rank <= FUNCTION < edit.rank) or edit.rank >= WRAPPED:
            yield from (e for e in waiting if _stands(claim, e, points, until))
            waiting = []
        nodes = {node for term in edit.terms for node in outermost(term) if node.op == "integral"}
        if edit.rank < WRAPPED and not nodes <= known:
            waiting.append(edit)
        elif _stands(claim, edit, points, until):
            yield edit
    yield from (e for e in waiting if _stands(claim, e, points, until))


def _stands(claim: Claim, edit: Edit, points: Points | None, until: float) -> bool:
    """Return whether an edit holds in floating point, if that can be seen, and is not trivial."""
    if time.process_time() > until:
        return False
    links = edit.links
    try:
        if (
            points is not None
            and points.at
            and claim.path is None
            and _fails_at_first(links, points)
        ):
            return False
        survives = edit.rank <= FACTOR if points is None else _survives(claim, links, points)
    except UnsupportedError:
        survives = edit.rank <= FACTOR
    except (InputError, ArithmeticError, ValueError):
        return False
    if not survives:
        return False
    changed = [(a, b) for a, b in zip(claim.links, links, strict=True) if a != b]
    slopes = [(without_integrals(a), without_integrals(b)) for a, b in changed]
    lone = edit.rank == VARIABLE and edit.old in lone_variables(claim.terms, claim.integers)
    mistaken = edit.old if lone and _are_alike(edit.old, edit.new) else ""
    return not any(is_trivial(*pair, mistaken) for pair in changed) and not any(
        loses_names(*pair, mistaken) for pair in slopes
    )


def _fails_at_first(links: Sequence[Compared], points: Points) -> bool:
    """Return whether a link with an integral fails at the first point, which saves the others."""
    if not any(node.op == "integral" for link in links for node in outermost(*link[::2])):
        return False
    one = Points({name: row[:1] for name, row in points.at.items()})
    return any(held(one, link) == [False] for link in links)


def _are_alike(one: str, other: str) -> bool:
    """Return whether two variables are easily confused: close in the alphabet, or both indexed."""
    return abs(ord(one[0]) - ord(other[0])) <= 2 and (len(one) == 1) is (len(other) == 1)


def _sharp_first(claim: Claim, found: Iterator[Edit]) -> list[Edit]:
    """Sort inequalities: those whose sides nearly touch, as in print, come first.

    Sides that touch at a point but are mostly far from each other, as those of sin(a) > -a are,
    count as less likely by one rank.
    """
    grid = _closed_grid(claim)
    if grid is None:
        return list(found)
    gaps = [(_gap(edit.links, grid), edit) for edit in found]
    sharp = []
    for gap, edit in gaps:
        if gap < TOUCHING:
            typical = _gap(edit.links, grid, median)
            rank = edit.rank + (typical > FAR)
            sharp.append((rank, typical, edit._replace(rank=rank)))
    rest = [edit._replace(rank=max(edit.rank, OTHER)) for gap, edit in gaps if gap >= TOUCHING]
    slack = [(_gap(edit.links, grid), edit.rank, edit) for edit in rest]
    order = [*sorted(sharp, key=lambda s: s[:2]), *sorted(slack, key=lambda s: s[:2])]
    return [edit for _, _, edit in order]


def _touches(claim: Claim) -> bool:
    """Return whether the sides of an inequality are seen to touch somewhere."""
    grid = _closed_grid(claim)
    return grid is not None and _gap(claim.links, grid) < TOUCHING


def _closed_grid(claim: Claim) -> Points | None:
    """Return points at which the conditions hold, ends included."""
    names = sorted(frozenset().union(*map(symbols, claim.terms)) - symbols(INFINITY))
    closed = [(a, _CLOSED.get(r, r), b) for a, r, b in claim.given if r != "!="]
    try:
        return sampled(names, closed, GRID)
    except (UnsupportedError, InputError):
        return None


def _differs(claim: Claim) -> bool:
    """Return whether the sides of an equality are seen to differ, or to have no values.

    This refutes nothing; it is used for claims that are not decided.
    """
    grid = _grid(claim)
    try:
        rows = [held(grid, without_integrals(x), APART) for x in claim.links] if grid else []
    except (UnsupportedError, InputError, OverflowError):
        return False
    seen = [value for row in rows for value in row]
    return bool(seen) and True not in seen


def _gap(
    links: Sequence[Compared],
    grid: Points,
    which: Callable[[list[float]], float] = min,
) -> float:
    """Return how near to each other the sides of inequalities come, or are on the median."""
    found = 0.0
    for left, relation, right in links:
        if relation not in _BOUNDS:
            continue
        try:
            rows = grid.values(left), grid.values(right)
        except (UnsupportedError, OverflowError):
            continue
        gaps = [abs(x - y) / (abs(x) + abs(y) or 1.0) for x, y in zip(*rows, strict=True)]
        found = max(found, which([gap for gap in gaps if gap == gap] or [1.0]))
    return found


def _survives(claim: Claim, links: Sequence[Compared], points: Points) -> bool:
    return all(agrees_with_values(claim, link, points) for link in links)


def _telling(claim: Claim, grid: Points) -> Points:
    """Return a few points, preferably ones at which the sides of the claim have values."""
    if not grid.at:
        return grid
    few = FEW if grid.count > FEW else FEW // 2
    try:
        rows = [held(grid, without_integrals(link)) for link in claim.links]
        defined = [n for n in range(grid.count) if all(row[n] is not None for row in rows)]
    except (UnsupportedError, InputError):
        defined = []
    chosen = defined[:few] if len(defined) >= 3 else []
    chosen += [n for n in range(grid.count) if n not in chosen][
        : few // 3 if len(chosen) >= 3 else few
    ]
    return Points({name: [row[n] for n in chosen] for name, row in grid.at.items()})
