"""Inverse functions on their branches: asin a = b if sin b = a and b is in [−π/2, π/2].

The normal form writes asin and acos by arc tangents and roots. It loses the branch if the sign of a
root is not constant on the region, or if a is not a rational function. Here the inverse function is
eliminated: the claim becomes an identity between a and the sine, cosine or tangent of b, and a
condition that b lies in the range, which is proved by signs. log and the
inverse hyperbolic sine have no range condition.

An inequality loses its inverse function in the same way: for b in [−π/2, π/2], asin a > b exactly
if a > sin b, since the sine increases there.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import ZERO, Expr, apply, as_expr, number, symbols, trees
from tresym.reals.language.like_terms import collected, scaled
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign_by

_ONTO = {
    row.name: row.inverse
    for row in TABLE.values()
    if row.image is not None and row.inverse in TABLE
    if TABLE[row.inverse].entire and row.image(trees)[:2] == (None, None)
}
"""The function of which each is the inverse, at every number."""
_RANGES = {
    row.name: (row.inverse, as_expr(low), as_expr(high), ">=" if closed else ">")
    for row in TABLE.values()
    if row.family == "inverse trigonometric" and row.image is not None
    for low, high, closed in [row.image(trees)]
}
"""The function of which each is the inverse, the ends of its values, and whether it takes them."""


_LAMBERT = {"lambertw": 1, "lambertwm1": -1}
"""The sign of W + 1 on each branch."""


def without_inverse(
    left: Expr, right: Expr, given: Given, theories: frozenset[str]
) -> Iterator[tuple[Expr, Expr]]:
    """Yield equivalent equations, as pairs of sides, without the inverse function."""
    difference = collected(left - right)
    terms = difference.args if difference.op == "+" else (difference,)
    for term in terms:
        scale, inverse = scaled(term)
        theory = "exponentials" if inverse.op in _ONTO else "trigonometry"
        if inverse.op in _LAMBERT:  # W(a) = b if b e^b = a and b is on the branch
            value = collected((term - difference) * number(1 / scale))
            if _holds(_LAMBERT[inverse.op] * (value + 1), ">=", given):
                yield value * apply("exp", value), inverse.args[0]
            continue
        if inverse.op not in (*_RANGES, *_ONTO) or not theories >= {theory, "inverses"}:
            continue
        value = collected((term - difference) * number(1 / scale))
        if inverse.op in _ONTO:
            yield apply(_ONTO[inverse.op], value), inverse.args[0]
            continue
        function, low, high, relation = _RANGES[inverse.op]
        ends = collected(value - low), collected(high - value)
        if all(_holds(end, relation, given) for end in ends):
            yield apply(function, value), inverse.args[0]


def of_same_sign(difference: Expr, given: Given) -> Iterator[Expr]:
    """Yield expressions without an inverse trigonometric function that have the sign of another.

    For c·asin a − b it is a − sin(b/c), with the sign of c, if b/c is shown to lie in the range.
    """
    difference = collected(difference)
    terms = difference.args if difference.op == "+" else (difference,)
    for term in terms:
        scale, inverse = scaled(term)
        if inverse.op not in _RANGES or len(terms) == 1:
            continue
        value = collected((term - difference) * number(1 / scale))
        function, low, high, relation = _RANGES[inverse.op]
        if all(_holds(collected(end), relation, given) for end in (value - low, high - value)):
            sign = number(1 if (scale > 0) is (inverse.op != "acos") else -1)
            yield sign * (inverse.args[0] - apply(function, value))


def _holds(e: Expr, relation: str, given: Given) -> bool:
    """Whether ``e`` is shown to have its relation to zero, also where it is c ± an inverse."""
    if sign_by(e, given, relation) in PROVING[relation]:
        return True
    terms = e.args if e.op == "+" else (e,)
    varying = [term for term in terms if symbols(term)]
    scale, inverse = scaled(varying[0]) if len(varying) == 1 else (fmpq(0), ZERO)
    if inverse.op not in _RANGES:
        return False
    function, low, high, _ = _RANGES[inverse.op]
    at = collected((varying[0] - e) * number(1 / scale))  # the inverse, where e is 0
    if not all(sign_by(end, Given()) in PROVING[">"] for end in (at - low, high - at)):
        return False
    rises = (scale > 0) is (inverse.op != "acos")
    inside = (inverse.args[0] - apply(function, at)) * (1 if rises else -1)
    conditions = (c for c in given.conditions if c.relation in (">", relation))
    if any(is_zero(inside - c.expression, given) for c in conditions):
        return True
    return sign_by(inside, given, relation) in PROVING[relation]
