"""ε₀ of a million shapes in float64: our arrays against scipy's vectorised root finders and loops.

Shapes are log-uniform, 0.05 ≤ a ≤ 50 and 0.005 ≤ b ≤ 1. A scipy route is right when it has 12
digits on each of a sample of shapes; the paper's equation loses them where ab is large.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable
from functools import partial
from typing import Any

import numpy as np
from flint import fmpq

from tresym.bench.run import WRONG, Contender, Judged, Keep, Measurement, Pace, forget, interleave
from tresym.bench.truth import true_digits
from tresym.racket.flip import separatrix
from tresym.racket.floats.shapes import Floats, defects
from tresym.racket.formulas import printed, stable

SHAPES = 1_000_000
LOOP = 2_000
"""Shapes of a loop in Python, which costs the same each time."""
SAMPLE = 200
WANTED = 12

OURS = "tresym, numpy arrays"
PACE = Pace(rounds=5, limit=40.0, patience=1.5)


def shapes(count: int) -> tuple[Floats, Floats]:
    """The first ``count`` shapes."""
    rng = np.random.default_rng(1)
    a = 0.05 * 1000.0 ** rng.random(SHAPES)
    b = 0.005 * 200.0 ** rng.random(SHAPES)
    return a[:count], b[:count]


def find_root_printed(a: Floats, b: Floats) -> Floats:
    """scipy's ``elementwise.find_root`` (Chandrupatla's method) on the printed equation."""
    from scipy.optimize import elementwise

    ends = np.full_like(a, 1e-18), np.full_like(a, np.pi / 2)
    residual = partial(printed.separatrix_residual, m=np)
    return np.asarray(elementwise.find_root(residual, ends, args=(a, b)).x)


def find_root_map(a: Floats, b: Floats) -> Floats:
    """The same on tan ε₀ = √(a/(a+b))/sinh T, from which nothing cancels."""
    from scipy.optimize import elementwise

    ends = np.full_like(a, 1e-18), np.full_like(a, np.pi / 2)
    return np.asarray(elementwise.find_root(_fixed_point, ends, args=(a, b)).x)


def _fixed_point(defect: Floats, a: Floats, b: Floats) -> Any:
    return np.log(defect / stable.separatrix_map(defect, a, b, np))


def newton_printed(a: Floats, b: Floats) -> Floats:
    """scipy's ``newton`` (secant) over arrays on the printed equation, from the paper's formula."""
    from scipy.optimize import newton

    start = printed.asymptotic_defect(a, b, np)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return np.asarray(newton(printed.separatrix_residual, start, args=(a, b, np), tol=1e-14))


def newton_phase(a: Floats, b: Floats) -> Floats:
    """scipy's ``newton`` with the derivative over arrays on our phase equation."""
    from scipy.optimize import newton

    k, r = np.sqrt(a * b), np.sqrt(b / a)
    phase = newton(
        lambda p: p - stable.phase_map(p, k, r, np),
        np.full_like(a, 4.0),
        fprime=lambda p: stable.phase_slope(p, k, r, np),
        tol=1e-13,
    )
    return np.asarray(stable.defect_at(phase, k, r, np))


def brentq_loop(a: Floats, b: Floats) -> Floats:
    """scipy's ``brentq`` on the printed equation, shape by shape."""
    import math

    from scipy.optimize import brentq

    ends, residual = (1e-18, math.pi / 2), printed.separatrix_residual
    pairs = zip(a.tolist(), b.tolist(), strict=True)
    finest = {"xtol": 1e-300, "maxiter": 1000}
    return np.array([brentq(residual, *ends, (p, q, math), **finest) for p, q in pairs])


METHODS: dict[str, tuple[Callable[[Floats, Floats], Floats], int]] = {
    OURS: (defects, SHAPES),
    "scipy find_root, printed equation": (find_root_printed, SHAPES),
    "scipy find_root, tan ε₀ equation": (find_root_map, SHAPES),
    "scipy newton, printed equation": (newton_printed, SHAPES),
    "our phase equation in scipy newton": (newton_phase, SHAPES),
    "brentq in a loop, printed equation": (brentq_loop, LOOP),
}


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``many``: seconds for one shape; digits at the worst of the sample."""
    contenders = [
        Contender(
            "ε₀ of a shape",
            name,
            partial(_run, method, count),
            compare,
            name.startswith(("tresym", "our")),
            WANTED,
            pieces=count,
        )
        for name, (method, count) in METHODS.items()
    ]
    timings, complete = interleave(contenders, pace, keep)
    says = f"ε₀ of {SHAPES:,} shapes in float64, for one shape"
    return Measurement("many", says, timings, OURS, complete=complete)


def _run(method: Callable[[Floats, Floats], Floats], count: int) -> Floats:
    with np.errstate(all="ignore"):
        return method(*shapes(count))


def compare(found: Floats) -> Judged:
    """The worst and the typical digits on the sample."""
    pairs = zip(*(x.tolist() for x in shapes(SAMPLE)), strict=True)
    digits = [true_digits(v, _truth(*s)) for v, s in zip(found.tolist(), pairs, strict=False)]
    worst = min(digits)
    bad = sum(d < WANTED for d in digits)
    if not bad:
        return Judged(worst)
    return Judged(worst, None, WRONG, f"{bad} of {SAMPLE} shapes have fewer than {WANTED} digits")


def _truth(a: float, b: float) -> Any:
    p, q = (fmpq(*x.as_integer_ratio()) for x in (a, b))
    return separatrix.solve(p, q, 25).defect
