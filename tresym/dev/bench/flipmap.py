"""Benchmark of the flip map in float64: many starts at once against ODE solvers.

Digits are counted against a ball, at the worst of a sample of starts. There are two bodies: the
standard racket, and one with √(ab) = 3, near whose unstable points errors grow by e^{6π}.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import lru_cache, partial
from typing import Any

import numpy as np
from flint import arb, fmpq

from tresym.dev.bench import peers
from tresym.dev.bench.run import WRONG, Contender, Judged, Pace, Workload, row
from tresym.dev.bench.truth import as_ball
from tresym.racket.angle import Angle
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import flip_angle
from tresym.racket.floats import flipmap
from tresym.racket.motion.trajectory import Start, travel

BODIES = {"standard racket": named_body("str").shape, "√(ab) = 3": Shape(fmpq(18), fmpq(1, 2))}
STARTS = 400_000
LOOP = 20
"""The number of starts that are solved one by one."""
SAMPLE = 20
WANTED = 11
"""Digits after the point that every result must have."""

OURS = "tresym.flip_map, numpy"
Floats = flipmap.Floats


@lru_cache(maxsize=1)
def _all_starts() -> tuple[Floats, Floats]:
    rng = np.random.default_rng(1)
    return rng.uniform(-3, 3, STARTS), rng.uniform(-2, 2, STARTS)


def starts(count: int) -> tuple[Floats, Floats]:
    """Return the first ``count`` starts (ψ₀, dψ/dφ)."""
    psi, rate = _all_starts()
    return psi[:count], rate[:count]


Method = Callable[[float, float, Floats, Floats], Any]


def contenders(_: Any) -> Iterator[Contender]:
    """Yield the methods: seconds per start, and digits after the point at the worst start."""
    for name, shape in BODIES.items():
        a, b, _ = peers.floats(shape, fmpq(0))
        truths = [ball_flip(a, b, *start) for start in zip(*starts(SAMPLE), strict=True)]
        methods: dict[str, tuple[Method, int]] = {
            OURS: (flipmap.flip_map, STARTS),
            "tresym.flip_angle, 15 digits certified": (certified, LOOP),
            "scipy solve_ivp, RK45 at 1e-10": (by_scipy("RK45", 1e-10), LOOP),
            "scipy solve_ivp, DOP853 at 1e-13": (by_scipy("DOP853", 1e-13), LOOP),
            "heyoka, one by one": (by_heyoka, 1000),
            "heyoka, batch": (by_heyoka_batch, 1000),
        }
        judge = partial(judged, truths)
        for title, (method, count) in methods.items():
            work = partial(method, a, b, *starts(count))
            with suppress(Exception):  # compiled and imported before anything is timed
                method(a, b, *starts(8))
            more: dict[str, Any] = {"asked": WANTED, "pieces": count}
            yield from row(name, {title: work}, judge, **more)


WORKLOAD = Workload(contenders, Pace(rounds=5, limit=20.0, patience=3.0), OURS)


def judged(truths: list[arb], values: Any) -> Judged:
    """Assess the digits after the point at the worst start of the sample."""
    errors = [
        abs(float((truth - (as_ball(float(v)) or 0)).mid()))
        for truth, v in zip(truths, values, strict=False)
    ]
    worst = max(errors)
    digits = 17.0 if worst == 0 else max(0.0, -math.log10(worst))
    if digits >= WANTED:
        return Judged(digits)
    return Judged(digits, None, WRONG, f"an error of {worst:.1e} at the worst start")


def ball_flip(a: float, b: float, psi: float, rate: float) -> arb:
    """Return the certified Δψ of a start over one turn of the handle."""
    p, q, x, v, turns = (fmpq(*float(y).as_integer_ratio()) for y in (a, b, psi, rate, math.tau))
    return travel(Shape(p, q), Start(Angle(fmpq(0), x), v), Angle(fmpq(0), turns), 20).turn


def certified(a: float, b: float, psi: Floats, rate: Floats) -> list[float]:
    """Return Δψ by ``tresym.flip_angle``, start by start."""
    p, q = (fmpq(*x.as_integer_ratio()) for x in (a, b))
    pairs = zip(psi.tolist(), rate.tolist(), strict=True)
    exact = ((fmpq(*x.as_integer_ratio()), fmpq(*v.as_integer_ratio())) for x, v in pairs)
    return [float(flip_angle(p, q, x, v, 15).flip) for x, v in exact]


def handle(a: float, b: float, psi: Any, rate: Any) -> Any:
    """Return cos θ of a start."""
    square = np.sin(psi) ** 2
    return rate * (1 - b * square) / (a + b * square)


def one_by_one(path: peers.Path, a: float, b: float, psi: Floats, rate: Floats) -> list[float]:
    """Return Δψ by a solver of the planar system, start by start."""
    pairs = zip(psi.tolist(), handle(a, b, psi, rate).tolist(), strict=True)
    return [path(a, b, [x, z], math.tau) - x for x, z in pairs]


def by_scipy(method: str, tolerance: float) -> Method:
    """Return a method by scipy's ``solve_ivp``."""
    return partial(one_by_one, partial(peers.scipy_path, method, (tolerance, tolerance / 100)))


by_heyoka: Method = partial(one_by_one, partial(peers.heyoka_path, 16))
"""heyoka's Taylor integrator at its smallest tolerance."""


def by_heyoka_batch(a: float, b: float, psi: Floats, rate: Floats) -> Floats:
    """Return Δψ by heyoka's batch integrator, which uses the processor's vector instructions."""
    size, solver = _batch()
    tilt, found = handle(a, b, psi, rate), np.empty_like(psi)
    solver.pars[0, :], solver.pars[1, :] = a, b
    for i in range(0, psi.size - size + 1, size):
        part = slice(i, i + size)
        solver.set_time(0.0)
        solver.state[0, :], solver.state[1, :] = psi[part], tilt[part]
        solver.propagate_until([math.tau] * size)
        found[part] = solver.state[0, :] - psi[part]
    return found


@lru_cache(maxsize=1)
def _batch() -> tuple[int, Any]:
    import heyoka

    size = heyoka.recommended_simd_size()
    state, pars = np.array([[1.0] * size, [0.0] * size]), np.array([[1.0] * size, [0.1] * size])
    solver = heyoka.taylor_adaptive_batch(peers.heyoka_system(), state, pars=pars, tol=1e-16)
    return size, solver
