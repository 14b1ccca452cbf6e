"""Divide an inequality by its positive factors, and multiply it by its positive denominators.

Example: ``b*(e - sin(e)) > b*e**3/7 given 0 < e <= 1, b > 0`` has no bounded box, since b is not
bounded. The normal form of the difference has the common factor b > 0; what is left depends on e
alone. Beside ``e = 0``, a denominator such as e² would have no value in balls either.

The normal form equals the difference wherever that is defined, so that only a proof carries over.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import product

from flint import arb

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.normal.to_expression import common_factors
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.sign import sign

MOST_VARIABLES = 4
"""The largest number of variables of a region at whose corners values are looked at."""


def cleared(difference: Expr, region: Given, positive: Callable[[Expr], bool]) -> Expr | None:
    """Return an expression with the sign of the difference wherever the region holds, or None.

    Args:
        difference: the expression.
        region: the conditions.
        positive: whether an expression is shown to be positive, for denominators whose sign the
            sign prover does not know.

    Returns:
        None if there is nothing to divide out, or if a denominator has no proven sign.
    """
    found = common_factors(difference, region)
    if found is None:
        return None
    (*shared, rest), below = found
    if not shared and not any(symbols(factor) for factor in below):
        return None
    side = 1
    for factor in (*shared, *below):
        known = sign(factor, region)
        if known not in ("+", "-") and factor in below:
            known = "+" if positive(factor) else "-" if positive(-factor) else None
        if known in ("+", "-"):
            side = -side if known == "-" else side
        elif factor in below:
            return None
        else:
            rest = rest * factor
    return side * rest


def is_singular(difference: Expr, region: Given) -> bool:
    """Return whether a variable is unbounded, or there is no value at a corner of the region."""
    names = sorted(symbols(difference) | region.names)
    ranges = [region.box.get(name) for name in names]
    ends = [(x.low, x.high) for x in ranges if x is not None]
    if len(ends) < len(names) or any(end is None for pair in ends for end in pair):
        return True
    if len(names) > MOST_VARIABLES:
        return False
    with ball_precision():
        corners = (dict(zip(names, map(arb, corner), strict=True)) for corner in product(*ends))
        return not all(evaluate(difference, corner).is_finite() for corner in corners)
