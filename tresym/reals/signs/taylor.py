"""Prove the sign of a difference by Taylor's theorem about one point.

For example, exp(x) − 1 − x has the value and the slope 0 at 0 and a positive second derivative, so
that it is exp(ξ)x²/2 ≥ 0.

On a segment from c to x, d(x) = Σ_{j<k} d⁽ʲ⁾(c) (x−c)ʲ/j! + d⁽ᵏ⁾(ξ) (x−c)ᵏ/k!. If all terms have
one sign, d has it too. The other symbols are parameters, and c may depend on them: it is an end of
the range, 0, 1, another symbol, or a zero of the derivative. The sign of a term that contains
parameters may itself be proved by another expansion, so that a corner of the region is treated one
edge after the other. All arithmetic is exact. Source: W. Rudin, *Principles of Mathematical
Analysis*, 1976, theorem 5.15.
"""

from __future__ import annotations

from functools import lru_cache

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import singularities
from tresym.reals.domain.sample_points import Range
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ONE, ZERO, Expr, number, substitute, symbol, symbols
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import numerator
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import REMEMBERED, Ask
from tresym.reals.signs.interior import sign_inside as sign
from tresym.reals.signs.structural import FLIP, WEAK

MAX_ORDER = 5
MAX_SIZE = 500
MAX_BASES = 8
MAX_LOOKS = 12


def sign_by_taylor(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Taylor's theorem: all terms of an expansion about one point, and the remainder, have the
    claimed sign.

    The point is an end of the range, 0, 1, another variable, or a zero of the derivative. The
    method handles unbounded regions and parameters.

    Decides ``exp(x) >= 1 + x``.

    Limits: it fails if no derivative up to the fifth has a provable sign.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        region: the conditions.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
    """
    for name in sorted(symbols(difference)):
        ranges = _without_beyond(region, name)
        inside = opened(ranges, name)
        where = ranges.box.get(name, Range())
        for c in _bases(difference, name, where, inside):
            if _within(ranges, name, c, inside) and _smooth(difference, name, c, inside):
                proof = _expansion(difference, relation, name, c, region, inside)
                if proof is not None:
                    return proof
    return None


def _without_beyond(region: Given, name: str) -> Given:
    """Return ``region`` without conditions on the variable other than bounds: it is then convex in
    it.
    """
    beyond = [c for c in region.beyond_box if name in symbols(c.expression)]
    pairs = zip(region.comparisons, region.conditions, strict=True)
    return Given(tuple(comparison for comparison, c in pairs if c not in beyond))


def opened(region: Given, name: str) -> Given:
    """Return ``region`` with strict bounds on the variable, as they hold inside every segment."""
    opened = [
        (left, sign_.replace("=", "") if name in symbols(left) | symbols(right) else sign_, right)
        for left, sign_, right in region.comparisons
    ]
    return Given(tuple(opened))


def _bases(difference: Expr, name: str, where: Range, inside: Given) -> list[Expr]:
    """Return candidate points of expansion, whether or not they lie in the range."""
    points = [number(c) for c in (where.low, where.high) if c is not None and c.q < 2**64]
    points += [ZERO, ONE, *map(symbol, sorted(symbols(difference) - {name}))]
    slope = differentiate(difference, name)
    points += solutions(slope, name) or solutions(numerator(slope, inside), name)
    return list(dict.fromkeys(points))[:MAX_BASES]


def _within(region: Given, name: str, c: Expr, inside: Given) -> bool:
    """Return whether ``c`` is defined and satisfies the bounds, equality included."""
    at = {name: c}
    defined = all(
        sign(part, inside) in (("+",) if positive else ("+", "-"))
        for part, positive in singularities(c)
    )
    return defined and all(
        sign(substitute(condition.expression, at), inside) in WEAK
        for condition in region.conditions
        if name in symbols(condition.expression)
    )


def _smooth(e: Expr, name: str, c: Expr, inside: Given) -> bool:
    """Return whether ``e`` is analytic in the variable on every segment from ``c``."""
    at = {name: c}
    for part, _ in singularities(e):
        if sign(part, inside) not in ("+", "-"):
            return False
        if sign(substitute(part, at), inside) not in ("+", "-"):
            return False
    return True


def _expansion(
    difference: Expr, relation: str, name: str, c: Expr, region: Given, inside: Given
) -> str | None:
    """Raise the order of the expansion until every term has the sign that is claimed."""
    beside = sign(symbol(name) - c, region)
    sides = [1] * (beside not in ("-", "<=0")) + [-1] * (beside not in ("+", ">=0"))
    apart = sign((symbol(name) - c) ** 2, region) == "+"
    at = {name: c}
    terms: list[str | None] = []
    assumed: list[Expr] = []
    derivative = difference
    for order in range(1, MAX_ORDER + 1):
        term = substitute(derivative, at)
        seen, ways = _seen(term, inside), {side ** (order - 1) for side in sides}
        term_sign = None if len(seen) > 1 else sign(term, inside)
        if term_sign is None:
            if len(seen | ways) > 1:
                return None
            (way,) = ways
            assumed.append(way * term)
            term_sign = {1: ">=0", -1: "<=0"}[way]
        terms.append(term_sign)
        derivative = differentiate(derivative, name)
        if derivative.size > MAX_SIZE:
            return None
        last = None if len(_seen(derivative, inside)) > 1 else sign(derivative, inside)
        if last is None:
            continue
        if all(_has_sign([*terms, last], side, relation, apart) for side in sides):
            # the signs assumed may be proved by another expansion
            if not all(sign_by_taylor(e, ">=", inside) for e in assumed):
                return None
            return (
                f"in the expansion about {name} = {c}, the terms below order {order} and the "
                f"derivative of order {order} have the claimed sign"
            )
    return None


def _seen(e: Expr, inside: Given) -> set[int]:
    """Return the signs of ``e`` at sample points; if both occur, no sign needs to be proved."""
    if not symbols(e):
        return set()
    with ball_precision():
        values = [evaluate(e, point) for point in _points(inside, symbols(e))]
    return {way for way in (1, -1) if any(way * value > 0 for value in values)}


@lru_cache(maxsize=REMEMBERED)
def _points(inside: Given, names: frozenset[str]) -> list[dict[str, fmpq]]:
    return list(inside.points(names, MAX_LOOKS))


def _has_sign(terms: list[str | None], side: int, relation: str, apart: bool) -> bool:
    """Return whether the terms, on this side of c, add up to ``relation`` zero."""
    signs = [FLIP[term] if side < 0 and j % 2 else term for j, term in enumerate(terms)]
    if not all(term in WEAK for term in signs):
        return False
    if relation == ">=" or signs[0] == "+":
        return True
    return apart and "+" in signs  # away from c one positive term is enough
