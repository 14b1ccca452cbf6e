"""Benchmark of ε₀ for a million shapes in float64: arrays against vectorised root finders.

Shapes are log-uniform, 0.05 ≤ a ≤ 50 and 0.005 ≤ b ≤ 1. A method is right if it has 12 digits on
each of a sample of shapes; the paper's equation loses them where ab is large.
"""

from __future__ import annotations

import warnings
from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

import numpy as np
from flint import fmpq

from tresym.dev.bench import peers
from tresym.dev.bench.run import WRONG, Contender, Judged, Pace, Workload, row
from tresym.dev.bench.truth import true_digits
from tresym.racket.body import Shape
from tresym.racket.flip import flip_defects, separatrix
from tresym.racket.floats.shapes import Floats, defects
from tresym.racket.formulas import printed, stable

SHAPES = 1_000_000
LOOP = 2_000
"""The number of shapes in a Python loop, whose time per shape is constant."""
SAMPLE = 200
WANTED = 12

OURS = "tresym, numpy arrays"


def shapes(count: int) -> tuple[Floats, Floats]:
    """Return the first ``count`` shapes."""
    rng = np.random.default_rng(1)
    a = 0.05 * 1000.0 ** rng.random(SHAPES)
    b = 0.005 * 200.0 ** rng.random(SHAPES)
    return a[:count], b[:count]


def find_root(residual: Callable[..., Any], a: Floats, b: Floats) -> Floats:
    """Return ε₀ by scipy's ``elementwise.find_root`` (Chandrupatla's method)."""
    from scipy.optimize import elementwise

    ends = np.full_like(a, 1e-18), np.full_like(a, np.pi / 2)
    return np.asarray(elementwise.find_root(residual, ends, args=(a, b)).x)


def fixed_point(defect: Floats, a: Floats, b: Floats) -> Any:
    """Return the residual of tan ε₀ = √(a/(a+b))/sinh T, which does not cancel."""
    return np.log(defect / stable.separatrix_map(defect, a, b, np))


def newton_printed(a: Floats, b: Floats) -> Floats:
    """Return ε₀ by scipy's ``newton`` (secant) on the printed equation, from the asymptotic one."""
    from scipy.optimize import newton

    start = printed.asymptotic_defect(a, b, np)
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return np.asarray(newton(printed.separatrix_residual, start, args=(a, b, np), tol=1e-14))


def newton_phase(a: Floats, b: Floats) -> Floats:
    """Return ε₀ by scipy's ``newton`` with the derivative on the phase equation."""
    from scipy.optimize import newton

    k, r = np.sqrt(a * b), np.sqrt(b / a)
    phase = newton(
        lambda p: p - stable.phase_map(p, k, r, np),
        np.full_like(a, 4.0),
        fprime=lambda p: stable.phase_slope(p, k, r, np),
        tol=1e-13,
    )
    return np.asarray(stable.defect_at(phase, k, r, np))


def exact(a: Floats, b: Floats) -> list[Shape]:
    """Return the shapes as fractions."""
    pairs = zip(a.tolist(), b.tolist(), strict=True)
    return [Shape(*(fmpq(*x.as_integer_ratio()) for x in pair)) for pair in pairs]


def in_balls(a: Floats, b: Floats) -> Floats:
    """Return ε₀ by ``tresym.flip_defects``, 15 digits certified."""
    return np.array([float(flip.defect) for flip in flip_defects(exact(a, b), digits=15)])


def brentq_loop(a: Floats, b: Floats) -> Floats:
    """Return ε₀ by scipy's ``brentq`` on the printed equation, shape by shape."""
    return np.array([peers.brentq_printed(shape, fmpq(0), 15) for shape in exact(a, b)])


METHODS: dict[str, tuple[Callable[[Floats, Floats], Floats], int]] = {
    OURS: (defects, SHAPES),
    "tresym.flip_defects, 15 digits certified": (in_balls, LOOP),
    "scipy find_root, printed equation": (
        partial(find_root, partial(printed.separatrix_residual, m=np)),
        SHAPES,
    ),
    "scipy find_root, tan ε₀ equation": (partial(find_root, fixed_point), SHAPES),
    "scipy newton, printed equation": (newton_printed, SHAPES),
    "our phase equation in scipy newton": (newton_phase, SHAPES),
    "brentq in a loop, printed equation": (brentq_loop, LOOP),
}


def contenders(_: Any) -> Iterator[Contender]:
    """Yield the methods: seconds per shape, and digits at the worst of the sample."""
    for name, (method, count) in METHODS.items():
        work = {name: partial(_run, method, count)}
        yield from row("ε₀ of a shape", work, compare, asked=WANTED, pieces=count)


WORKLOAD = Workload(contenders, Pace(rounds=5, limit=40.0, patience=1.5), OURS)


def _run(method: Callable[[Floats, Floats], Floats], count: int) -> Floats:
    with np.errstate(all="ignore"):
        return method(*shapes(count))


def compare(found: Floats) -> Judged:
    """Assess the worst and the typical digits on the sample."""
    pairs = zip(found.tolist(), exact(*shapes(SAMPLE)), strict=False)
    digits = [true_digits(v, separatrix.solve(*s, 25).defect) for v, s in pairs]
    bad = sum(d < WANTED for d in digits)
    if not bad:
        return Judged(min(digits))
    why = f"{bad} of {SAMPLE} shapes have fewer than {WANTED} digits"
    return Judged(min(digits), None, WRONG, why)
