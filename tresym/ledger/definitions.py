"""The table of definitions: each symbol once, by symbols that do not come back to it.

Two definitions of one symbol together prove anything, and so do two that go round in a circle.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import combinations

from sympy import Basic, Integral, Symbol
from sympy.core.relational import Relational

from tresym.ledger.claim import Claim, Definition, equal
from tresym.ledger.evidence.defined import Conditions
from tresym.ledger.evidence.manifest import is_manifest
from tresym.ledger.meaning import DEFINING, CircularError, Rules, definitions, put_in
from tresym.ledger.second_look import satisfiable


def conflict(claims: Iterable[Claim]) -> str | None:
    """Why the definitions among ``claims`` are no table: two of one symbol, or a circle."""
    return _conflict(tuple(c for c in claims if isinstance(c.proof, DEFINING)))


def overdetermined(claims: Iterable[Claim]) -> str | None:
    """Why equations for integrals among ``claims`` do not together define what they are to.

    Each defines one symbol, and does not say which: two that share symbols may contradict each
    other, and one whose symbols are all defined may be false.
    """
    return _overdetermined(tuple(c for c in claims if isinstance(c.proof, DEFINING)))


@lru_cache(maxsize=4096)
def _conflict(claims: tuple[Claim, ...]) -> str | None:
    meanings: dict[Basic, list[tuple[Basic, Claim]]] = {}
    for claim in claims:
        for left, right in definitions((claim,)).items():
            meanings.setdefault(left, []).append((right, claim))
    circle = _circle({left: [m for m, _ in found] for left, found in meanings.items()})
    if circle is not None:
        return circle
    once = {s: found[0][0] for s, found in meanings.items() if s.is_Symbol and len(found) == 1}
    for left, found in meanings.items():
        for one, two in combinations(found, 2):
            if one[0] != two[0] and not _agree(left, one, two, once):
                return f"{left} is defined by {one[1].label} and by {two[1].label}"
    return None


def _agree(left: Basic, one: tuple[Basic, Claim], two: tuple[Basic, Claim], rules: Rules) -> bool:
    """Whether two equations for a symbol are for different cases, or one is assumed by name.

    What is assumed must be possible as the other symbols are defined.
    """
    (first, earlier), (second, later) = one, two
    if _exclude(earlier.given, later.given) or _exclude(later.given, earlier.given):
        return True
    both = (*earlier.given, *later.given)
    assumed = _assumes(earlier) or _assumes(later)
    known = equal(left, first), equal(left, second)
    try:
        both = tuple(put_in(condition, rules) for condition in both)
        known = tuple(equal(left, put_in(e.args[1], rules)) for e in known)
    except CircularError:
        pass  # a symbol is bound there, or the equations go on: they are taken as they stand
    return assumed and satisfiable(both, known)


def _exclude(given: Conditions, others: Conditions) -> bool:
    """Whether one of ``others`` is shown to fail wherever ``given`` holds."""
    return any(isinstance(c, Relational) and is_manifest(c.negated, given) for c in others)


def _assumes(claim: Claim) -> bool:
    return isinstance(claim.proof, Definition) and bool(claim.proof.assumes)


def _circle(meanings: dict[Basic, list[Basic]]) -> str | None:
    """A symbol that is defined by itself, by way of others."""
    names = {s: frozenset().union(*(m.free_symbols for m in ms)) for s, ms in meanings.items()}
    for symbol in (left for left in meanings if isinstance(left, Symbol)):
        seen: set[Basic] = set()
        waiting = {*names[symbol]}
        while waiting:
            name = waiting.pop()
            seen.add(name)
            waiting |= names.get(name, frozenset()) - seen
        if symbol in seen:
            return f"{symbol} is defined by itself"
    return None


@lru_cache(maxsize=4096)
def _overdetermined(claims: tuple[Claim, ...]) -> str | None:
    rules: Rules = {}
    implicit: dict[Basic, Claim] = {}
    for claim in claims:
        for left, right in definitions((claim,)).items():
            if isinstance(left, Integral):
                implicit[equal(left, right)] = claim
            else:
                rules[left] = right
    seen: frozenset[Basic] = frozenset()
    for equation, claim in implicit.items():
        if equation.free_symbols & seen:
            return f"{claim.label} is a second equation for the same symbols"
        seen |= equation.free_symbols
        try:
            left = put_in(equation.args[0] - equation.args[1], rules)
        except CircularError as error:
            return str(error)
        if not left.free_symbols:
            return f"{claim.label} leaves nothing to define"
    return None
