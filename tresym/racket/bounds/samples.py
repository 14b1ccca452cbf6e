"""Values of a formula's symbols at sample shapes, with their exact ε₀.

At these samples, the bounds of margins and orders are compared with the true remainder.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator

from flint import arb, fmpq

from tresym.racket.flip.separatrix import defect_over
from tresym.racket.formulas import printed, stable
from tresym.racket.motion.quadrature import rigorous
from tresym.racket.notation import S, a, b, depsilon_dgamma, epsilon, epsilon0, gamma, lam, mu
from tresym.reals.language.binders import at
from tresym.reals.language.expression import ZERO, Expr, symbol
from tresym.reals.numbers.arithmetic import balls

Values = dict[Expr, arb]
Samples = Callable[[], Iterator[tuple[tuple[arb, ...], Values]]]

SHAPES = tuple(
    (fmpq(*p), fmpq(*q))
    for p, q in (((9, 2), (1, 2)), ((12, 1), (1, 4)), ((5, 4), (7, 8)), ((40, 1), (9, 10)))
)
"""Shapes with ab ≥ 1/4 and b ≤ 4a, strictly inside every box."""
TURN = symbol("f")
"""−∂F/∂ε at a level, which converts F − π to a distance in ε."""


def at_shape(p: fmpq | arb, q: fmpq | arb) -> Values:
    """Return every symbol of the separatrix, at a shape and its exact ε₀."""
    point: Values = {a: arb(p), b: arb(q), S: arb(1)}
    point[epsilon0] = defect_over(point[a], point[b])
    point[lam], point[mu] = printed.small_parameters(point[a], point[b], balls)
    return point


def in_bent_chart() -> Samples:
    """Return samples of levels γ = bε₀²v, in the chart (b, κ, v)."""

    def samples() -> Iterator[tuple[tuple[arb, ...], Values]]:
        for p, q in SHAPES[:2]:
            shape = at_shape(p, q)
            for v in (arb("0.5"), arb("-0.5")):
                known = _at_level(p, q, shape[b] * shape[epsilon0] ** 2 * v)
                yield (known[b], known[lam], v), known

    return samples


def slope_at_separatrix(known: Values) -> arb:
    """Return dε/dγ at γ = 0."""
    place = known[epsilon0], known[a], known[b]
    turn = printed.integrand(*place, arb(0), 1, balls)
    return stable.turn_slope(*place, balls) / turn


def _at_level(p: fmpq, q: fmpq, level: arb) -> Values:
    """As :func:`at_shape`, with ε of a level by one step of Newton's method from the tangent."""
    known = at_shape(p, q)
    slope = slope_at_separatrix(known)
    start = known[epsilon0] + slope * level
    reach = 4 * (known[a] * known[b]).sqrt() * level**2 / (known[b] ** 2 * known[epsilon0])
    turn = printed.integrand(start + reach * arb(0, 1), known[a], known[b], level, 1, balls)
    step = (rigorous(start, known[a], known[b], level) - balls.pi) / turn
    found = start + step if abs(step) < reach else arb.nan()
    known[gamma], known[epsilon], known[TURN] = level, found, turn
    known[at(depsilon_dgamma, {str(gamma): ZERO})] = slope
    return known
