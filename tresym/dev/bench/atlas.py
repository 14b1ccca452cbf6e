"""The stability atlas: digits lost by each printed formula and by its stable form.

Every formula is evaluated in float64 and at 50 digits on a grid in its plane, and compared with a
ball of the same quantity, computed from the same numbers.
"""

from __future__ import annotations

import math
import warnings
from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import product
from typing import Any, NamedTuple

import numpy as np
from flint import arb, fmpq

from tresym.dev.bench import peers
from tresym.dev.bench.run import Workload
from tresym.dev.bench.truth import true_digits
from tresym.dev.bench.turn import by_library
from tresym.racket.body import named_body
from tresym.racket.flip import separatrix
from tresym.racket.floats.shapes import defects
from tresym.racket.formulas import printed, stable
from tresym.racket.motion import quadrature
from tresym.racket.motion.carlson import amplitude, by_flint, turn
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits, mp_precision

FLOAT_DIGITS = 53 * math.log10(2)
MANY = 50
STR = named_body("str").shape
TRUTH = 400
"""The digits with which the balls are computed."""

Numbers = dict[str, Any]
"""The coordinates of a point and what follows from them, in some arithmetic."""
Formula = Callable[[Numbers, Any], Any]


class Plane(NamedTuple):
    """Two logarithmic axes: name, label, and the exponents of ten at the ends."""

    name: str
    x: tuple[str, float, float]
    y: tuple[str, float, float]
    point: Callable[[fmpq, fmpq], Numbers]
    """Converts exact coordinates to the arguments of a formula, as balls."""


class Pair(NamedTuple):
    """One quantity: as printed, in its stable form, and as a ball (by default the stable form).

    A slow pair has ``stride`` 2: only every second column and row is computed.
    """

    name: str
    plane: str
    printed: Formula
    stable: Formula
    truth: Formula | None = None
    stride: int = 1


def _on_separatrix(product_: fmpq, b: fmpq) -> Numbers:
    a = product_ / b
    root = separatrix.solve(a, b, 2 * MANY)
    one, three = arb(1 / (1 + a)), arb(1 / (1 - b) if b < 1 else 2)
    return {"a": arb(a), "b": arb(b), "defect": root.defect, "I1": one, "I2": arb(1), "I3": three}


def _on_level(psi: fmpq, gamma: fmpq) -> Numbers:
    a, b, x = arb(STR.a), arb(STR.b), arb(psi)
    square = b * x.sin() ** 2
    theta = ((gamma + square) / (a + square)).sqrt().acos()
    M1, M2, M3 = printed.momentum(theta, x, arb(1), balls)
    one, three = 1 / (1 + a), 1 / (1 - b)
    angles = {"a": a, "b": b, "psi": x, "theta": theta, "gamma": arb(gamma)}
    return angles | {"M1": M1, "M2": M2, "M3": M3, "I1": one, "I2": arb(1), "I3": three}


def _at_turning_point(ahead: fmpq, share: fmpq) -> Numbers:
    least = arb(share).sqrt().asin()
    return {"a": arb(STR.a), "b": arb(STR.b), "psi": least + arb(ahead), "psi_min": least}


def _near_rotation(below: fmpq, a: fmpq) -> Numbers:
    return {"a": arb(a), "b": arb(STR.b), "gamma": arb(a * (1 - below))}


PLANES = (
    Plane("separatrix", ("$ab$", -8, 4), ("$b$", -6, 0), _on_separatrix),
    Plane("levels", (r"$\psi$ (rad)", -6, 0.19), (r"$\gamma$", -16, 0), _on_level),
    Plane(
        "turning point",
        (r"$\psi - \psi_{\min}$ (rad)", -14, -1),
        (r"$|\gamma|/b$", -8, -0.3),
        _at_turning_point,
    ),
    Plane("stable rotation", (r"$1 - \gamma/a$", -16, 0), ("$a$", -4, 4), _near_rotation),
)


def _root_printed(p: Numbers, m: Any) -> Any:
    """The root of the printed equation that a root finder returns, started near the true one."""
    if m is np:
        from scipy.optimize import brentq

        def residual(e: float) -> float:
            return float(printed.separatrix_residual(np.float64(e), p["a"], p["b"], np))

        return float(brentq(residual, 1e-300, math.pi / 2, maxiter=2000, **peers.FINEST))
    return m.findroot(
        lambda e: printed.separatrix_residual(e, p["a"], p["b"], m),
        (p["defect"] * 0.9, p["defect"] * 1.1),
        verify=False,
    )


def _root_stable(p: Numbers, m: Any) -> Any:
    if m is np:
        return float(defects(p["a"], p["b"]))
    k, r = _kr(p, m)
    return stable.defect_at(_phase(p, m), k, r, m)


def _phase(p: Numbers, m: Any) -> Any:
    """The phase of a shape by Newton's method."""
    k, r = _kr(p, m)
    phase = k * 0 + separatrix.float_phase(float(k), float(p["b"]))[0]
    for _ in range(1 if m is np else 3):
        residual = phase - stable.phase_map(phase, k, r, m)
        phase -= residual / stable.phase_slope(phase, k, r, m)
    return phase


def _root_truth(p: Numbers, _: Any) -> arb:
    k, r = _kr(p, balls)
    return stable.defect_at(separatrix.enclose_phase(k, r, bits(TRUTH)), k, r, balls)


def _flip_printed(p: Numbers, m: Any) -> Any:
    return printed.flip(_root_stable(p, m), m)


def _flip_stable(p: Numbers, m: Any) -> Any:
    k, r = _kr(p, m)
    return stable.flip_at(_phase(p, m), k, r, m)


def _flip_truth(p: Numbers, _: Any) -> arb:
    k, r = _kr(p, balls)
    return stable.flip_at(separatrix.enclose_phase(k, r, bits(TRUTH)), k, r, balls)


def _energy(p: Numbers, m: Any) -> Any:
    momentum = p["M1"], p["M2"], p["M3"]
    energy = printed.energy(*momentum, p["I1"], p["I2"], p["I3"])
    return printed.depth_from_energy(energy, m.sqrt(printed.momentum_squared(*momentum)), p["I2"])


def _momentum(p: Numbers, _: Any) -> Any:
    a, b = stable.shape(p["I1"], p["I2"], p["I3"])
    return stable.depth_from_momentum(p["M1"], p["M2"], p["M3"], a, b)


def _turning(p: Numbers, m: Any) -> Any:
    """γ of the trajectory with the turning point ψ_min."""
    return -p["b"] * m.sin(p["psi_min"]) ** 2


def _turn_printed(p: Numbers, m: Any) -> Any:
    return _quad(p["psi"], p["a"], p["b"], _turning(p, m), m)


def _rotating_printed(p: Numbers, m: Any) -> Any:
    return _quad(p["psi"], p["a"], p["b"], p["gamma"], m)


def _quad(psi: Any, a: Any, b: Any, g: Any, m: Any) -> Any:
    """The paper's integral by the quadrature of scipy or mpmath."""
    if m is np:
        from scipy.integrate import quad

        ends = float(psi), math.pi / 2
        return quad(quadrature.integrand, *ends, (float(a), float(b), float(g), math))[0]
    return m.re(quadrature.printed(psi, a, b, g, m)[0])


def _turn_stable(p: Numbers, m: Any) -> Any:
    z = stable.radicand(p["psi"], p["psi_min"], p["b"], m)
    return _carlson(p["psi"], z, p["a"], p["b"], _turning(p, m), m)


def _rotating_stable(p: Numbers, m: Any) -> Any:
    z = p["gamma"] + p["b"] * m.sin(p["psi"]) ** 2
    return _carlson(p["psi"], z, p["a"], p["b"], p["gamma"], m)


def _carlson(psi: Any, z: Any, a: Any, b: Any, g: Any, m: Any) -> Any:
    """The same integral in Carlson's form, by R_F and R_J of FLINT, scipy or mpmath."""
    at = amplitude(m.sin(psi), m.cos(psi), z, a, b, g, m)
    n = b / a
    if m is balls:
        return turn(by_flint(at, n), a, b, g, m)
    import scipy.special

    return turn(by_library(at, n, scipy.special if m is np else m), a, b, g, m)


def _radicand(p: Numbers, m: Any) -> Any:
    return _turning(p, m) + p["b"] * m.sin(p["psi"]) ** 2


def _theta_min(p: Numbers, m: Any) -> Any:
    return printed.theta_bounds_rotating(p["a"], p["b"], p["gamma"], m)[0]


PAIRS = (
    Pair("root of the separatrix equation", "separatrix", _root_printed, _root_stable, _root_truth),
    Pair(
        "its left-hand side",
        "separatrix",
        lambda p, m: printed.separatrix_left(p["defect"], p["a"], p["b"], m),
        lambda p, m: stable.separatrix_left(p["defect"], p["a"], p["b"], m),
    ),
    Pair(
        r"$\partial F/\partial\gamma$ at $\gamma = 0$",
        "separatrix",
        lambda p, m: printed.turn_slope(p["defect"], p["a"], p["b"], 1, m),
        lambda p, m: stable.turn_slope(p["defect"], p["a"], p["b"], m),
    ),
    Pair(r"flip $\Delta\psi$", "separatrix", _flip_printed, _flip_stable, _flip_truth),
    Pair(
        "$a$ by the moments",
        "separatrix",
        lambda p, _: printed.shape(p["I1"], p["I2"], p["I3"])[0],
        lambda p, _: stable.shape(p["I1"], p["I2"], p["I3"])[0],
    ),
    Pair(
        r"$\gamma$ by the angles",
        "levels",
        lambda p, m: printed.depth(p["theta"], p["psi"], p["a"], p["b"], m),
        lambda p, m: stable.depth(p["theta"], p["psi"], p["a"], p["b"], m),
    ),
    Pair(r"$\gamma$ by the momentum", "levels", _energy, _momentum),
    Pair(
        r"$F(\psi, \gamma)$, $\gamma > 0$", "levels", _rotating_printed, _rotating_stable, stride=2
    ),
    Pair(
        r"$\gamma + b\,\sin^2\psi$",
        "turning point",
        _radicand,
        lambda p, m: stable.radicand(p["psi"], p["psi_min"], p["b"], m),
    ),
    Pair(r"$F(\psi, \gamma)$", "turning point", _turn_printed, _turn_stable, stride=2),
    Pair(
        r"$\theta_{\min}$",
        "stable rotation",
        _theta_min,
        lambda p, m: stable.theta_min(p["a"], p["b"], p["gamma"], m),
    ),
)


def _kr(p: Numbers, m: Any) -> tuple[Any, Any]:
    return m.sqrt(p["a"] * p["b"]), m.sqrt(p["b"] / p["a"])


def plane_of(pair: Pair) -> Plane:
    """Return the plane over which a pair is shown."""
    return next(plane for plane in PLANES if plane.name == pair.plane)


def digits_lost(pair: Pair, x: fmpq, y: fmpq, digits: int, form: str) -> float:
    """Return how many of 16 (float64) or 50 digits ``form``, printed or stable, loses.

    The truth is computed from the rounded arguments, so the effect of rounding the input is not
    counted.
    """
    numbers, truth = _rounded(pair.name, x, y, digits)
    formula = pair.printed if form == "printed" else pair.stable
    most = FLOAT_DIGITS if digits == 16 else float(MANY)
    try:
        value = _in_floats(formula, numbers) if digits == 16 else _in_digits(formula, numbers)
    except (ArithmeticError, ValueError):
        return most
    return most - min(most, true_digits(value, truth))


@lru_cache(maxsize=2)
def _rounded(name: str, x: fmpq, y: fmpq, digits: int) -> tuple[Numbers, arb]:
    """The arguments at a point, exactly as float64 or 50 digits represent them, and the truth."""
    pair = next(p for p in PAIRS if p.name == name)
    with ball_precision(bits(TRUTH)):
        numbers = plane_of(pair).point(x, y)
    with ball_precision(53 if digits == 16 else bits(MANY, 0)):
        numbers = {key: (+value.mid()).mid() for key, value in numbers.items()}
    with ball_precision(bits(TRUTH)):
        return numbers, (pair.truth or pair.stable)(numbers, balls)


def _in_floats(formula: Formula, numbers: Numbers) -> Any:
    with np.errstate(all="ignore"), warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return float(formula({key: np.float64(float(x)) for key, x in numbers.items()}, np))


def _in_digits(formula: Formula, numbers: Numbers) -> Any:
    with mp_precision(MANY) as mp:
        return formula({key: _mpf(x, mp) for key, x in numbers.items()}, mp)


def _mpf(x: arb, mp: Any) -> Any:
    mantissa, exponent = x.man_exp()
    return mp.mpf((int(mantissa), int(exponent)))


COLUMNS, ROWS = 32, 20


def axis(low: float, high: float, count: int) -> list[fmpq]:
    """Return ``count`` logarithmically spaced points, each an exact decimal of four digits."""
    step = (high - low) / (count - 1)
    return [fmpq(*_fraction(10.0 ** (low + i * step))) for i in range(count)]


def _fraction(x: float) -> tuple[int, int]:
    from fractions import Fraction

    exact = Fraction(f"{x:.4g}")
    return exact.numerator, exact.denominator


def grid(pair: Pair, digits: int, form: str) -> dict[str, Any]:
    """Return the digits lost over the plane of a pair: rows by y, columns by x, both increasing."""
    plane = plane_of(pair)
    xs, ys = (
        axis(low, high, count // pair.stride)
        for (_, low, high), count in ((plane.x, COLUMNS), (plane.y, ROWS))
    )
    lost = [[round(digits_lost(pair, x, y, digits, form), 1) for x in xs] for y in ys]
    return {"pair": pair.name, "plane": plane.name, "form": form, "digits": digits, "lost": lost}


def grids(_: Any) -> Iterator[tuple[str, dict[str, Any]]]:
    """Yield the planes, and each pair over its plane; nothing is timed."""
    for plane in PLANES:
        yield "planes", {"plane": plane.name, "x": list(plane.x), "y": list(plane.y)}
    for pair, digits, form in product(PAIRS, (16, 50), ("printed", "stable")):
        yield "grids", grid(pair, digits, form)


WORKLOAD = Workload(tables=grids)
