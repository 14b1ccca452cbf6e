"""Signs that are manifest: by structure and ranges, or as a sum of conditions known to hold."""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from flint import fmpq

from tresym.ledger.meaning import REMEMBERED, Conditions, known
from tresym.reals.decisions.identity import decide
from tresym.reals.language.binders import elementary, generalised, ordered
from tresym.reals.language.expression import (
    HALF,
    LEAVES,
    PI,
    UNWORKED,
    Expr,
    multiply,
    number,
    power,
    rebuild,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.places.conditions import Given
from tresym.reals.signs.sign import PROVING, sign
from tresym.reals.verdict import Verdict

NON_NEGATIVE = ("+", "0", ">=0")
DEPTH = 2
"""At most this many conditions are taken out of a sum."""


@lru_cache(maxsize=REMEMBERED)
def manifest_sign(e: Expr, conditions: Conditions, depth: int = DEPTH) -> str | None:
    """The proven sign of ``e`` under ``conditions``, or None.

    Where structure alone does not show it, ``e`` is split into a condition (``c > 0`` or
    ``c ≥ 0``) and a rest of known sign.
    """
    (e,) = generalised(_joined(e))
    found = sign(e, known(conditions))
    if found in ("+", "-", "0", "<=0"):
        return found
    if e.op in ("sin", "cos"):
        found = _in_half_turn(e, conditions) or found
    if e.op == "*":
        found = _product([manifest_sign(f, conditions, depth) for f in e.args]) or found
    if found == "+" or depth == 0 or (found == ">=0" and e.op == "*"):
        return found
    by_parts = _split(e, conditions, depth)
    return "+" if by_parts == "+" else found or by_parts


def _joined(e: Expr) -> Expr:
    """``e`` with each product as powers of different bases: the same wherever it is defined."""
    if e.op in LEAVES or e.op in UNWORKED:
        return e
    if e.op not in ("*", "^"):
        return rebuild(e, tuple(map(_joined, e.args)))
    powers: dict[Expr, fmpq] = {}
    for base, exponent in _factors(e, fmpq(1)):
        powers[base] = powers.get(base, fmpq(0)) + exponent
    return multiply(*(power(base, number(r)) for base, r in powers.items() if r != 0))


def _factors(e: Expr, exponent: fmpq) -> Iterator[tuple[Expr, fmpq]]:
    """The bases and exponents of a product to a power; only whole powers go into a product."""
    if e.op == "*" and exponent.q == 1:
        for factor in e.args:
            yield from _factors(factor, exponent)
    elif e.op == "^" and e.args[1].op == "number" and exponent.q == 1:
        yield from _factors(e.args[0], e.args[1].args[0] * exponent)
    else:
        yield (
            _joined(e) if e.op not in ("*", "^") else rebuild(e, tuple(map(_joined, e.args))),
            exponent,
        )


def is_stated(e: Expr, conditions: Conditions) -> bool:
    """Whether a condition says as it stands that ``e`` is not negative."""
    up = (c.upward for c in conditions if c.sign != "!=")
    return any(ordered(c.left - c.right) == ordered(e) for c in up)


def _split(e: Expr, conditions: Conditions, depth: int) -> str | None:
    """The sign of ``e`` as a condition and a rest that is not negative."""
    found = None
    for condition in (c.upward for c in conditions if c.sign != "!="):
        term = condition.left - condition.right
        if term.op == "symbol" or not symbols(term) & symbols(e) or not elementary(term):
            continue
        rest = e - term
        rest_sign = manifest_sign(rest, conditions, depth - 1)
        if rest_sign not in NON_NEGATIVE:
            continue
        if _are_equal(e, term + rest, conditions):
            if rest_sign == "+" or condition.sign == ">":
                return "+"
            found = ">=0"
    return found


def _are_equal(e: Expr, parts: Expr, conditions: Conditions) -> bool:
    """Under no conditions, as sums mostly are, or under these, where points are hard to find."""
    worlds = (Given(), known(conditions))
    return any(decide(e, parts, w, frozenset()).verdict is Verdict.PROVED for w in worlds)


def _in_half_turn(e: Expr, conditions: Conditions) -> str | None:
    """``+`` inside the half turn where the sine or cosine is positive, ``>=0`` with its ends."""
    (angle,) = e.args
    quarter = PI * HALF
    ends = (angle, PI - angle) if e.op == "sin" else (angle + quarter, quarter - angle)
    return _product([manifest_sign(end, conditions) for end in ends])


def is_manifest(relation: Relation, conditions: Conditions) -> bool:
    """Whether the proven sign of the difference of the two sides shows the inequality."""
    if relation.sign == "==":
        return False
    up = relation.upward
    return manifest_sign(up.left - up.right, conditions) in PROVING[up.sign]


def _product(signs: list[str | None]) -> str | None:
    """The sign of a product of factors none of which is negative."""
    if not all(s in NON_NEGATIVE for s in signs):
        return None
    return "+" if set(signs) == {"+"} else ">=0"
