"""ε(γ) by six independent methods.

A method may start from a float64 value of another one, since the result of Newton's method does not
depend on the initial value. Each has a number of digits that it is designed to give; the comparison
counts how many of them agree with the ball of the first.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.racket.body import Shape, named_body
from tresym.racket.flip import defect
from tresym.racket.flip.levels import turning_level
from tresym.racket.motion import quadrature
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits, mp_precision, to_mp
from tresym.reals.numbers.exact import parse_number

DIGITS = 50


def carlson(shape: Shape, gamma: fmpq) -> arb:
    """Return the ball by Carlson's integrals, with Gauss's transformation in the first quarter."""
    return defect.solve(shape.a, shape.b, gamma, DIGITS + 4).defect


def flint_integration(shape: Shape, gamma: fmpq) -> arb:
    """Compute ε(γ) by Newton's method on FLINT's rigorous integral of f; the last step encloses it.

    The unknown is ψ on and above the separatrix, and χ with cos ψ = cos ψ_min sin χ below.
    """
    start = _float_defect(shape, gamma)
    with ball_precision(bits(DIGITS, 24)):
        a, b, g = arb(shape.a), arb(shape.b), arb(gamma)
        if gamma >= 0:
            return _newton(
                arb(start),
                lambda psi: arb.pi() - quadrature.rigorous(psi, a, b, g),
                lambda psi: quadrature.integrand(psi, a, b, g, balls),
            )
        largest = (1 + g / b).sqrt()
        chi = (arb(start).cos() / largest).asin().mid()
        found = _newton(
            arb.pi().mid() - chi if _turned(shape, gamma) else chi,
            lambda x: quadrature.rigorous_turned(x, a, b, g) - arb.pi(),
            lambda x: quadrature.rate_turned(x, a, b, g),
        )
        return (largest * found.sin()).acos()


def mpmath_quadrature(shape: Shape, gamma: fmpq) -> Any:
    """Compute ε(γ) by Newton's method on mpmath's quadrature of the substituted integral."""
    start = _float_defect(shape, gamma)
    with mp_precision(DIGITS + 10) as mp:
        a, b, g = (to_mp(x, mp) for x in (*shape, gamma))
        t = quadrature.parameter(mp.mpf(start), b, g, mp)
        if _turned(shape, gamma):
            t = -t
        for _ in range(2):
            excess = quadrature.substituted(t, a, b, g, mp) - mp.pi
            t += excess / quadrature.rate(t, a, b, g, mp)
        return mp.atan(quadrature.tangent(t, b, g, mp))


def mpmath_taylor(shape: Shape, gamma: fmpq) -> Any:
    """Compute ε(γ) by Taylor integration in mpmath, from ψ = π/2 over half a turn.

    In s = sin ψ, c = cos ψ, z = cos θ and w = 1/(1 − b s²) the system is polynomial:
    ψ′ = (a + b s²) z w, s′ = c ψ′, c′ = −s ψ′, z′ = b (1 − z²) s c w, w′ = 2b w² s s′.
    """
    steps, order = 40, 60
    with mp_precision(DIGITS + 14) as mp:
        a, b, g = (to_mp(x, mp) for x in (*shape, gamma))
        psi, h = mp.pi / 2, mp.pi / steps
        state = [mp.mpf(1), mp.mpf(0), mp.sqrt((g + b) / (a + b)), 1 / (1 - b)]
        for _ in range(steps):
            turn, state = _taylor_step(state, a, b, h, order, mp)
            psi += turn
        return mp.pi - psi


def _taylor_step(
    state: list[Any], a: Any, b: Any, h: Any, order: int, mp: Any
) -> tuple[Any, list[Any]]:
    """The change of ψ over a step h, and the state after it, from ``order`` Taylor coefficients."""
    s, c, z, w = ([x] for x in state)
    ss, sc, ww, zw, across, scw, rate, spin = ([] for _ in range(8))

    def product(x: list[Any], y: list[Any]) -> Any:
        """The newest coefficient of the product of two series."""
        return mp.fdot(x, y[::-1])

    for k in range(order):
        ss.append(product(s, s))
        sc.append(product(s, c))
        ww.append(product(w, w))
        zw.append(product(z, w))
        across.append((k == 0) - product(z, z))
        scw.append(product(sc, w))
        rate.append(a * zw[k] + b * product(ss, zw))
        spin.append(product(sc, rate))
        slopes = product(c, rate), -product(s, rate), b * product(across, scw)
        for series, slope in zip((s, c, z, w), (*slopes, 2 * b * product(ww, spin)), strict=True):
            series.append(slope / (k + 1))
    turn = h * mp.polyval([x / (k + 1) for k, x in enumerate(rate)][::-1], h)
    return turn, [mp.polyval(series[::-1], h) for series in (s, c, z, w)]


def scipy_solver(shape: Shape, gamma: fmpq) -> float:
    """Compute ε(γ) by scipy's DOP853 on the same system, in float64."""
    import math

    from scipy.integrate import solve_ivp

    a, b, g = (int(x.p) / int(x.q) for x in (*shape, gamma))
    system = _system(a, b, math)
    start = [math.pi / 2, math.sqrt((g + b) / (a + b))]
    found = solve_ivp(
        lambda _, y: system(y), (0, math.pi), start, method="DOP853", rtol=1e-13, atol=1e-14
    )
    return math.pi - float(found.y[0, -1])


def float_map(shape: Shape, gamma: fmpq) -> float:
    """Compute ε(γ) by the vectorised float64 map, started at ψ = π/2."""
    return _float_defect(shape, gamma)


def _float_defect(shape: Shape, gamma: fmpq) -> float:
    import math

    from tresym.racket.floats.flipmap import flip_map

    a, b, g = (int(x.p) / int(x.q) for x in (*shape, gamma))
    rate = math.sqrt((a + b) * (g + b)) / (1 - b)
    return math.pi / 2 + float(flip_map(a, b, math.pi / 2, rate, -math.pi))


def _turned(shape: Shape, gamma: fmpq) -> bool:
    """Whether the trajectory has passed a turning point."""
    level = turning_level(*shape, 20) if gamma < 0 else None
    return level is not None and bool(gamma < level)


def _newton(x: arb, excess: Callable[[arb], arb], slope: Callable[[arb], arb]) -> arb:
    """The root of an increasing function near x, enclosed by a final interval Newton step."""
    for _ in range(2):
        x = (x - excess(x) / slope(x)).mid()
    residual = excess(x)
    wide = arb(x, (4 * residual / slope(x)).abs_upper())
    found = x - residual / slope(wide)
    if not wide.contains_interior(found):
        raise ArithmeticError("interval Newton did not contract")
    return found


def _system(a: Any, b: Any, m: Any) -> Callable[[Any], list[Any]]:
    """The planar system in (ψ, cos θ), from the paper's equations for the angles."""

    def slopes(y: Any) -> list[Any]:
        sine, cosine = m.sin(y[0]), m.cos(y[0])
        clock = 1 - b * sine * sine
        return [(a + b * sine * sine) * y[1] / clock, b * (1 - y[1] * y[1]) * sine * cosine / clock]

    return slopes


class Route(NamedTuple):
    """A method for ε(γ), and the number of digits that it is designed to give.

    A method in float64 gives a few more; how many depends on the processor.
    """

    name: str
    run: Callable[[Shape, fmpq], Any]
    digits: int


ROUTES = (
    Route("balls, Carlson's integrals", carlson, DIGITS),
    Route("balls, FLINT's rigorous integration", flint_integration, DIGITS),
    Route("mpmath quadrature, substituted", mpmath_quadrature, DIGITS),
    Route("mpmath Taylor integration", mpmath_taylor, DIGITS),
    Route("float64 map", float_map, 12),
    Route("scipy DOP853", scipy_solver, 10),
)

CASES = (
    ("str", "0"),
    ("str", "1e-8"),
    ("str", "1/100"),
    ("str", "-1/1000"),
    ("str", "-347/100000"),
    ("str", "-1/50"),
    ("book", "1/20"),
    ("book", "-1/10"),
    ("racket-1", "-1e-4"),
)
"""Named bodies and γ: on the separatrix, next to it, above, below, at the turning point, turned."""


class RouteRow(NamedTuple):
    """One case: the ball, and for each other method the digits it is designed to give and gives."""

    body: str
    gamma: str
    ball: arb
    digits: tuple[int, ...]


def compare(cases: tuple[tuple[str, str], ...] = CASES) -> list[RouteRow]:
    """Apply every method to every case."""
    return [_row(body, gamma) for body, gamma in cases]


def _row(body: str, gamma: str) -> RouteRow:
    shape, level = named_body(body).shape, parse_number(gamma)
    truth = carlson(shape, level)
    found = (min(r.digits, agreement(r.run(shape, level), truth)) for r in ROUTES[1:])
    return RouteRow(body, gamma, truth, tuple(found))


def agreement(value: Any, truth: arb) -> int:
    """Return how many decimal digits of a value, at most ``DIGITS``, agree with a ball."""
    with ball_precision(bits(DIGITS, 64)):
        error = abs(_as_ball(value) / truth - 1)
        size = error.upper()
        if size <= 0:
            return DIGITS
        return min(DIGITS, max(0, int((-size.log() / arb.const_log10()).floor().unique_fmpz())))


def _as_ball(value: Any) -> arb:
    if isinstance(value, arb | float):
        return arb(value)
    return arb((int(value.man), int(value.exp))) * (-1 if value < 0 else 1)
