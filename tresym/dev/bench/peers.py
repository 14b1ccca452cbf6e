"""Competing methods for ε(γ): what a reader of the paper would use today.

A method takes a shape, an exact γ and the accuracy (decimal digits, or −log₁₀ of a solver's
tolerance), and returns a number of its own arithmetic. mpmath starts from the paper's formulas.
"""

from __future__ import annotations

import math
from collections.abc import Callable
from functools import lru_cache, partial
from typing import Any

from flint import arb, fmpq

from tresym.racket.body import Shape, named_body
from tresym.racket.flip import flip_defect
from tresym.racket.formulas import printed, stable
from tresym.racket.motion import quadrature
from tresym.reals.numbers.arithmetic import mp_precision, to_mp
from tresym.reals.numbers.exact import fraction_text

FINEST = {"xtol": 1e-300, "rtol": 8.9e-16}
"""The smallest tolerances that brentq accepts."""

Method = Callable[[Shape, fmpq, int], Any]
Path = Callable[[float, float, list[float], float], float]
"""ψ at an angle of the handle from a, b and where it begins: ψ and cos θ."""


def from_text(body: str, gamma: str, digits: int) -> arb:
    """Return ε(γ) as a user asks for it: a and b are parsed from text."""
    a, b = _texts(body)
    return flip_defect(a, b, gamma, digits).defect


@lru_cache
def _texts(body: str) -> list[str]:
    return [fraction_text(x) for x in named_body(body).shape]


def start(a: Any, b: Any, gamma: Any, m: Any) -> Any:
    """Return the paper's asymptotic value of ε(γ), or a point of (ψ_min, π/2) if it is outside."""
    near = printed.linear_defect(printed.asymptotic_defect(a, b, m), b, gamma)
    least = m.asin(m.sqrt(-gamma / b)) if gamma < 0 else 0
    if least < near < m.pi / 2:
        return near
    return (9 * least + m.pi / 2) / 10


def _findroot(residual: Callable[..., Any], says: str) -> Method:
    def run(shape: Shape, gamma: fmpq, digits: int) -> Any:
        with mp_precision(digits) as mp:
            a, b, g = (to_mp(x, mp) for x in (*shape, gamma))
            return mp.findroot(lambda e: residual(e, a, b, g, mp), start(a, b, g, mp))

    run.__doc__ = says
    return run


def findroot_phase(shape: Shape, _: fmpq, digits: int) -> Any:
    """Return ε₀ by Newton's method in mpmath on the phase equation, from its float64 root."""
    from tresym.racket.flip.separatrix import float_phase

    with mp_precision(digits + 5) as mp:
        a, b = to_mp(shape.a, mp), to_mp(shape.b, mp)
        k, r = mp.sqrt(a * b), mp.sqrt(b / a)
        phase, correct = mp.mpf(float_phase(float(k), float(b))[0]), 14
        while correct < digits + 5:
            residual = phase - stable.phase_map(phase, k, r, mp)
            phase -= residual / stable.phase_slope(phase, k, r, mp)
            correct *= 2
        return stable.defect_at(phase, k, r, mp)


def carlson_turn(e: Any, a: Any, b: Any, gamma: Any, m: Any, rf: Any, rj: Any) -> Any:
    """Return F(ε, γ) by R_F and R_J of a library, with γ + b sin²ε computed by addition."""
    sine2, cosine = m.sin(e) ** 2, m.cos(e)
    x, y, w = sine2, (a + b * sine2) / (a + b), (gamma + b * sine2) / (gamma + b)
    both = (1 - b) * rf(x, y, w) + b / 3 * cosine**2 * rj(x, y, w, 1)
    return cosine / m.sqrt((a + b) * (gamma + b)) * both


findroot_printed = _findroot(
    lambda e, a, b, _, m: printed.separatrix_residual(e, a, b, m),
    "``mpmath.findroot`` on the exact equation as printed (γ = 0).",
)
findroot_quad = _findroot(
    lambda e, a, b, g, m: quadrature.printed(e, a, b, g, m)[0] - m.pi,
    "``mpmath.findroot`` over ``quad`` (tanh-sinh) of the paper's integrand.",
)
findroot_carlson = _findroot(
    lambda e, a, b, g, m: carlson_turn(e, a, b, g, m, m.elliprf, m.elliprj) - m.pi,
    "``mpmath.findroot`` over mpmath's R_F and R_J.",
)


def odefun(shape: Shape, gamma: fmpq, digits: int) -> Any:
    """Return ε(γ) by mpmath's Taylor solver ``odefun``, from ψ = π/2 over half a turn."""
    with mp_precision(digits) as mp:
        a, b, g = (to_mp(x, mp) for x in (*shape, gamma))

        def system(_: Any, y: Any) -> list[Any]:
            return slopes(y, a, b, mp)

        flow = mp.odefun(system, 0, [mp.pi / 2, mp.sqrt((g + b) / (a + b))])
        return mp.pi - flow(mp.pi)[0]


def slopes(y: Any, a: Any, b: Any, m: Any) -> list[Any]:
    """Return dψ/dφ and d(cos θ)/dφ of the planar system."""
    sine, cosine = m.sin(y[0]), m.cos(y[0])
    clock = 1 - b * sine * sine
    return [(a + b * sine * sine) * y[1] / clock, b * (1 - y[1] * y[1]) * sine * cosine / clock]


def floats(shape: Shape, gamma: fmpq) -> tuple[float, float, float]:
    """Return a, b and γ rounded to float64."""
    a, b, g = (int(x.p) / int(x.q) for x in (*shape, gamma))
    return a, b, g


def _brentq(residual: Callable[[float, float, float, float], float], says: str) -> Method:
    def run(shape: Shape, gamma: fmpq, _: int) -> float:
        import warnings

        from scipy.optimize import brentq

        at = floats(shape, gamma)
        least = math.asin(math.sqrt(-at[2] / at[1])) if at[2] < 0 else 0.0
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            return float(brentq(residual, least + 1e-15, math.pi / 2, at, **FINEST))

    run.__doc__ = says
    return run


def _quad_residual(e: float, a: float, b: float, g: float) -> float:
    from scipy.integrate import quad

    return float(quad(quadrature.integrand, e, math.pi / 2, (a, b, g, math))[0]) - math.pi


def _carlson_residual(e: float, a: float, b: float, g: float) -> float:
    from scipy.special import elliprf, elliprj

    return float(carlson_turn(e, a, b, g, math, elliprf, elliprj)) - math.pi


brentq_printed = _brentq(
    lambda e, a, b, _: float(printed.separatrix_residual(e, a, b, math)),
    "scipy's ``brentq`` on the exact equation as printed (γ = 0).",
)
brentq_quad = _brentq(_quad_residual, "scipy's ``brentq`` over ``quad`` of the paper's integrand.")
brentq_carlson = _brentq(_carlson_residual, "scipy's ``brentq`` over its R_F and R_J.")


def scipy_path(
    method: str, tolerances: tuple[float, float], a: float, b: float, begin: list[float], end: float
) -> float:
    """Return ψ at the angle ``end`` of the handle, by scipy's ``solve_ivp`` with rtol and atol."""
    from scipy.integrate import solve_ivp

    rtol, atol = tolerances
    more = {"method": method, "rtol": rtol, "atol": atol}
    found = solve_ivp(lambda _, y: slopes(y, a, b, math), (0, end), begin, **more)
    return float(found.y[0, -1])


def _half_turn(path: Path, *at: Any) -> float:
    """ε(γ) from the path that begins at ψ = π/2, over half a turn of the handle."""
    a, b, g = floats(*at)
    return math.pi - path(a, b, [math.pi / 2, math.sqrt((g + b) / (a + b))], math.pi)


def scipy_ode(method: str) -> Method:
    """Return a method by scipy's ``solve_ivp`` on the planar system with rtol = 10^−asked."""

    def run(shape: Shape, gamma: fmpq, asked: int) -> float:
        fine = 10.0**-asked, 10.0**-asked / 10
        return _half_turn(partial(scipy_path, method, fine), shape, gamma)

    return run


def heyoka_path(asked: int, a: float, b: float, begin: list[float], end: float) -> float:
    """Return ψ by heyoka's Taylor integrator, compiled before, with the tolerance 10^−asked."""
    solver = heyoka_solver(asked)
    solver.time, solver.pars[:], solver.state[:] = 0.0, [a, b], begin
    solver.propagate_until(end)
    return float(solver.state[0])


def heyoka_ode(shape: Shape, gamma: fmpq, asked: int) -> float:
    """Return ε(γ) by heyoka's Taylor integrator on the planar system."""
    return _half_turn(partial(heyoka_path, asked), shape, gamma)


def heyoka_system() -> list[Any]:
    """Return the planar system in heyoka's expressions, with a and b as parameters."""
    import heyoka

    psi, handle = heyoka.make_vars("psi", "handle")
    a, b = heyoka.par[0], heyoka.par[1]
    right = slopes([psi, handle], a, b, heyoka)
    return [(psi, right[0]), (handle, right[1])]


@lru_cache(maxsize=8)
def heyoka_solver(asked: int) -> Any:
    """Return a compiled integrator of the planar system."""
    import heyoka

    return heyoka.taylor_adaptive(heyoka_system(), [1.0, 0.0], pars=[1.0, 0.1], tol=10.0**-asked)
