"""Divide an inequality by its positive factors, and multiply it by its positive denominators.

Example: ``b*(e - sin(e)) > b*e**3/7 given 0 < e <= 1, b > 0`` has no bounded box, since b is not
bounded. All terms of the difference have the factor b > 0; what is left depends on e alone. Beside
``e = 0``, a denominator such as e² would have no value in balls either.

What is left equals the difference, times a positive factor, wherever that is defined, so that only
a proof carries over.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from itertools import product

from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    Expr,
    number,
    power,
    rebuild,
    replaced,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import common_factors
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.sign import sign

HALF = number(fmpq(1, 2))
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
    common = _common_factors_with_roots(with_split_roots(difference, region))
    if common is None:
        return None
    (*shared, rest), below = common
    plain = not shared and not any(symbols(factor) for factor in below)
    if plain and symbols(rest) == symbols(difference):
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


def _common_factors_with_roots(e: Expr) -> tuple[list[Expr], list[Expr]] | None:
    """Return the common factors of an expression, in which √x and x count as powers of one atom."""
    roots = {n.args[0].args[0]: n for n in operations((e,)) if _is_root_of_symbol(n)}
    marks = {name: symbol(f"√{name}") for name in roots}
    put = {name: mark**2 for name, mark in marks.items()}
    plain = substitute(replaced(e, {roots[name]: mark for name, mark in marks.items()}), put)
    common = common_factors(plain)
    if common is None:
        return None
    back = {str(mark.args[0]): roots[name] for name, mark in marks.items()}
    above, below = ([_with_powers(x, back) for x in part] for part in common)
    return above, below


def _is_root_of_symbol(e: Expr) -> bool:
    return e.op == "^" and e.args[1] == HALF and e.args[0].op == "symbol"


def _with_powers(e: Expr, roots: Mapping[str, Expr]) -> Expr:
    """Return ``e`` with roots for their names, and x for the square of √x."""
    if e.op == "symbol":
        return roots.get(str(e.args[0]), e)
    if e.op in LEAVES or e.names:
        return e
    if e.op == "^" and e.args[0].op == "symbol" and e.args[1].op == "number":
        root, n = roots.get(str(e.args[0].args[0])), e.args[1].args[0]
        if root is not None and n.q == 1:
            odd = int(n) % 2
            return root.args[0] ** ((int(n) - odd) // 2) * (root if odd else ONE)
    return rebuild(e, tuple(_with_powers(arg, roots) for arg in e.args))


def with_split_roots(e: Expr, given: Given) -> Expr:
    """Return ``e`` with square roots of products of known signs as products of roots.

    Example: ``sqrt(b/r**2)`` is ``sqrt(b)/r`` where r > 0, and has a denominator that can be
    cleared.

    Args:
        e: the expression; nothing is changed under operations that bind a variable.
        given: conditions, by which factors that leave a root or divide are shown to be positive.
    """
    if e.op in LEAVES or e.names:
        return e
    split = rebuild(e, tuple(with_split_roots(arg, given) for arg in e.args))
    if split.op != "^" or split.args[1].op != "number" or split.args[1].args[0].q != 2:
        return split
    factors = common_factors(split.args[0])
    root = ONE
    for side, part in zip((1, -1), factors or (), strict=False):
        for factor in part:
            base, n = (factor.args[0], factor.args[1]) if factor.op == "^" else (factor, ONE)
            whole = n.op == "number" and n.args[0].q == 1
            times = int(n.args[0]) if whole else 1
            base = base if whole else factor
            if (side < 0 or times > 1) and sign(base, given) != "+":
                return split
            odd = sqrt(base) if times % 2 and base != ONE else ONE
            even = base ** (times // 2) if times > 1 else ONE
            root = root * power(even * odd, number(side))
    return power(root, number(2 * split.args[1].args[0])) if factors else split


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
