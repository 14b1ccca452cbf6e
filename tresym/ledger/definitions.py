"""The table of definitions: each symbol once, by symbols that do not come back to it.

Two definitions of one symbol together prove anything, and so do two that go round in a circle.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from functools import lru_cache
from itertools import combinations

from sympy import Eq

from tresym.ledger.claim import Claim, Definition, parts_of
from tresym.ledger.evidence.manifest import is_manifest
from tresym.ledger.meaning import (
    DEFINING,
    CircularError,
    Conditions,
    Rules,
    conditions,
    definitions,
    put_in,
    tree,
)
from tresym.ledger.second_look import satisfiable, scalars
from tresym.reals.language.expression import Expr, symbol, symbols


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
    meanings: dict[Expr, list[tuple[Expr, Claim]]] = {}
    for claim in claims:
        for left, right in definitions((claim,)).items():
            meanings.setdefault(left, []).append((right, claim))
    circle = _circle({left: [m for m, _ in found] for left, found in meanings.items()})
    if circle is not None:
        return circle
    for left, found in meanings.items():
        for (first, one), (second, two) in combinations(found, 2):
            if first != second and not _agree(left, one, two, claims):
                return f"{left} is defined by {one.label} and by {two.label}"
    return None


def _agree(left: Expr, one: Claim, two: Claim, claims: tuple[Claim, ...]) -> bool:
    """Whether two equations for a symbol are for different cases, or one is assumed by name.

    What is assumed must be possible as the other symbols are defined.
    """
    given, others = conditions(one.given), conditions(two.given)
    if _exclude(given, others) or _exclude(others, given):
        return True
    if not (_assumes(one) or _assumes(two)):
        return False
    equations = [e for claim in claims for e in _equations(claim)]
    counted = Counter(e.lhs for e in equations)
    both = (*one.given, *two.given)
    known = [e for claim in (one, two) for e in _equations(claim) if tree(e.lhs) == left]
    try:
        return satisfiable(both, (*(e for e in equations if counted[e.lhs] == 1), *known))
    except CircularError:  # a symbol is bound there: the equations are taken as they stand
        return satisfiable(both, tuple(known))


def _equations(claim: Claim) -> tuple[Eq, ...]:
    """The equations of a claim for symbols, as they are written."""
    entries = (entry for part in parts_of(claim.says) for entry in scalars(part))
    return tuple(e for e in entries if isinstance(e, Eq) and e.lhs.is_Symbol)


def _exclude(given: Conditions, others: Conditions) -> bool:
    """Whether one of ``others`` is shown to fail wherever ``given`` holds."""
    return any(is_manifest(condition.negated, given) for condition in others)


def _assumes(claim: Claim) -> bool:
    return isinstance(claim.proof, Definition) and bool(claim.proof.assumes)


def _circle(meanings: dict[Expr, list[Expr]]) -> str | None:
    """A symbol that is defined by itself, by way of others."""
    names = {left: frozenset().union(*map(symbols, found)) for left, found in meanings.items()}
    for start in (left for left in meanings if left.op == "symbol"):
        seen: set[Expr] = set()
        waiting = {*names[start]}
        while waiting:
            one = symbol(waiting.pop())
            seen.add(one)
            waiting |= {n for n in names.get(one, frozenset()) if symbol(n) not in seen}
        if start in seen:
            return f"{start} is defined by itself"
    return None


@lru_cache(maxsize=4096)
def _overdetermined(claims: tuple[Claim, ...]) -> str | None:
    rules: Rules = {}
    implicit: list[tuple[Expr, Claim]] = []
    for claim in claims:
        for left, right in definitions((claim,)).items():
            if left.op == "integral":
                implicit.append((left - right, claim))
            else:
                rules[left] = right
    seen: frozenset[str] = frozenset()
    for difference, claim in implicit:
        if symbols(difference) & seen:
            return f"{claim.label} is a second equation for the same symbols"
        seen |= symbols(difference)
        try:
            if not symbols(put_in(difference, rules)):
                return f"{claim.label} leaves nothing to define"
        except CircularError as error:
            return str(error)
    return None
