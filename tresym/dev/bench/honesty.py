"""Benchmark of error estimates: the error that a method claims against its true error.

The claimed error is the estimate of ``quad``; the tolerance given to root finders and ODE solvers,
which return without a warning only if they consider it met; the radius of a ball; and the estimate
of our float64 map.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from itertools import product
from typing import Any

import numpy as np
from flint import arb, fmpq

from tresym.dev.bench import flipmap as starts
from tresym.dev.bench import peers
from tresym.dev.bench.run import Workload
from tresym.dev.bench.truth import true_digits
from tresym.dev.bench.turn import flint_turn, mp_quad
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import defect, separatrix
from tresym.racket.flip.model_selection import climb
from tresym.racket.floats import flipmap
from tresym.racket.motion import quadrature
from tresym.reals.numbers.exact import parse_number
from tresym.reals.resource_limits import TimeUp, time_limit

WIDTHS = tuple(fmpq(*x) for x in ((1, 1), (1, 2), (1, 10), (1, 100), (1, 1000)))
SHAPES = tuple(
    Shape(fmpq(10) ** (n // 2) * (3 if n % 2 else 1) / b, b)
    for n, b in product(range(-6, 9), WIDTHS)
)
"""75 shapes, ab = 10⁻³ … 10⁴ in steps of about √10."""
STR = named_body("str").shape
GAMMAS = ("1e-2", "1e-4", "1e-6", "1e-8", "1e-10", "1e-12", "1e-14", "1e-20", "1e-30", "0")
LIMIT = 3.0
MOST = 60.0
"""Larger numbers of digits are not distinguished."""

MeasuredPoint = dict[str, Any]


def points(_: Any) -> Iterator[tuple[str, MeasuredPoint]]:
    """Yield the points of the chart; nothing is timed."""
    for group in (_balls, _quadratures, _roots, _solvers, _float_map):
        yield from (("points", found) for found in group())


WORKLOAD = Workload(tables=points)


def point(method: str, where: str, claims: float, digits: float) -> MeasuredPoint:
    """Return one point of the chart."""
    claimed, true = (round(max(0.0, min(MOST, x)), 2) for x in (claims, digits))
    return {"method": method, "where": where, "claims": claimed, "digits": true}


def _asked(work: Callable[[], Any]) -> Any:
    """The result of a method, or None if it reports failure or takes too long."""
    with suppress(Exception, TimeUp), time_limit(LIMIT):
        return work()
    return None


def _balls() -> Iterator[MeasuredPoint]:
    """Balls of tresym: the radius against the distance of the midpoint from the truth."""
    cases = [*product(SHAPES, ["0"]), *product((STR, named_body("book").shape), GAMMAS)]
    for (shape, text), digits in product(cases, (10, 40)):
        gamma = parse_number(text)
        found = climb(shape, gamma, digits).defect
        truth = defect_truth(shape, gamma)
        claims = found.rel_accuracy_bits() * math.log10(2)
        yield point("tresym, balls", _where(shape, text), claims, true_digits(found, truth))


def defect_truth(shape: Shape, gamma: fmpq) -> arb:
    """Return ε(γ) to 80 digits."""
    if gamma == 0:
        return separatrix.solve(*shape, 80).defect
    return defect.solve(*shape, gamma, 80).defect


def _quadratures() -> Iterator[MeasuredPoint]:
    """``quad`` of the paper's integrand from ε = 1/10, and from the turning point if γ < 0."""
    for text in (*GAMMAS, "-1/1000", "-1/100"):
        gamma = parse_number(text)
        truth = flint_turn(gamma, 80)
        for digits, method in product((15, 30, 50), ("tanh-sinh", "gauss-legendre")):
            found = _asked(partial(mp_quad, gamma, method, digits))
            if found is not None and (digits < 50 or method == "tanh-sinh"):
                value, error = found
                claims = MOST if error == 0 else -math.log10(float(abs(error / value)))
                yield point(f"mpmath quad, {method}", text, claims, true_digits(value, truth))
        value, error = _scipy_quad(gamma)
        claims = -math.log10(error / value)
        yield point("scipy quad", text, claims, true_digits(value, truth))


def _scipy_quad(gamma: fmpq) -> tuple[float, float]:
    import warnings

    from scipy.integrate import quad

    a, b, g = peers.floats(STR, gamma)
    begin = math.asin(math.sqrt(-g / b)) * (1 + 1e-15) if g < 0 else 0.1
    with warnings.catch_warnings(), np.errstate(all="ignore"):
        warnings.simplefilter("ignore")
        value, error = quad(quadrature.integrand, begin, math.pi / 2, (a, b, g, math))[:2]
    return float(value), float(error)


def _roots() -> Iterator[MeasuredPoint]:
    """``findroot`` and ``brentq``: the digits asked for, if they return without a warning."""
    printed = "printed equation"
    finest = -math.log10(peers.FINEST["rtol"])
    asked: list[tuple[str, peers.Method, Shape, str, int, float]] = [
        *(
            (f"mpmath findroot, {printed}", peers.findroot_printed, shape, "0", digits, digits)
            for shape, digits in product(SHAPES, (15, 50))
        ),
        *(
            (f"scipy brentq, {printed}", peers.brentq_printed, shape, "0", 15, finest)
            for shape in SHAPES
        ),
        *(("mpmath findroot over quad", peers.findroot_quad, STR, g, 15, 15) for g in GAMMAS),
    ]
    for name, method, shape, text, digits, claims in asked:
        gamma = parse_number(text)
        found = _asked(partial(method, shape, gamma, digits))
        if found is not None:
            had = true_digits(found, defect_truth(shape, gamma))
            where = text if "quad" in name else _where(shape, text)
            yield point(name, where, claims, had)


def _solvers() -> Iterator[MeasuredPoint]:
    """ODE solvers: the relative tolerance, on ε(0) of bodies up to √(ab) = 4."""
    bodies = (STR, *(Shape(fmpq(2 * n * n), fmpq(1, 2)) for n in (1, 2, 3, 4)))
    methods = {
        "scipy RK45": peers.scipy_ode("RK45"),
        "scipy DOP853": peers.scipy_ode("DOP853"),
        "heyoka": peers.heyoka_ode,
    }
    for (name, method), shape, digits in product(methods.items(), bodies, (4, 6, 8, 10, 12, 14)):
        if name == "scipy RK45" and digits > 12:
            continue
        found = _asked(partial(method, shape, fmpq(0), digits))
        if found is not None:
            truth = defect_truth(shape, fmpq(0))
            yield point(name, _where(shape, "0"), digits, true_digits(found, truth))


def _float_map() -> Iterator[MeasuredPoint]:
    """The float64 map of tresym: its own error estimate."""
    for shape in starts.BODIES.values():
        a, b, _ = peers.floats(shape, fmpq(0))
        psi, rate = starts.starts(40)
        flips = flipmap.flip_map(a, b, psi, rate).tolist()
        expected = flipmap.flip_uncertainty(a, b, psi, rate).tolist()
        for x, v, flip, error in zip(psi.tolist(), rate.tolist(), flips, expected, strict=True):
            truth = starts.ball_flip(a, b, x, v)
            claims = -math.log10(error / abs(flip)) if math.isfinite(error) else 0.0
            yield point("tresym, float64 map", "a start", claims, true_digits(flip, truth))


def _where(shape: Shape, gamma: str) -> str:
    return f"a = {float(arb(shape.a)):.3g}, b = {float(arb(shape.b)):.3g}, γ = {gamma}"
