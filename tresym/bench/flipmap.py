"""The flip map in float64: many starts at once against scipy's ODE solver, point by point."""

from __future__ import annotations

import math
from typing import Any

import numpy as np
from flint import arb, fmpq

from tresym.bench.run import Contender, Measurement, interleave
from tresym.bench.separatrix import time_once
from tresym.body import Shape, named_body
from tresym.flip.angle import Angle
from tresym.flip.flipmap import flip_map
from tresym.flip.trajectory import Start, travel

SHAPE = named_body("str").shape
STARTS = 100_000
SAMPLE = 20


def measure(rounds: int = 5) -> Measurement:
    """The workload ``flipmap``: seconds for one start; digits after the point, at the worst."""
    a, b = (int(x.p) / int(x.q) for x in SHAPE)
    rng = np.random.default_rng(1)
    psi, rate = rng.uniform(-3, 3, STARTS), rng.uniform(-2, 2, STARTS)
    few = list(zip(psi[:SAMPLE], rate[:SAMPLE], strict=True))
    truths = [_ball_flip(a, b, *start) for start in few]

    def theirs() -> list[float]:
        return [_solve_ivp(a, b, *start) for start in few]

    def digits(values: list[float]) -> int:
        worst = max(abs(float((t - arb(v)).mid())) for t, v in zip(truths, values, strict=True))
        return int(-math.log10(worst))

    ours = "tresym, numpy"
    contenders = [
        Contender(
            ours,
            lambda: time_once(lambda: flip_map(a, b, psi, rate)) / STARTS,
            digits(flip_map(a, b, psi[:SAMPLE], rate[:SAMPLE]).tolist()),
        ),
        Contender(
            "scipy solve_ivp, RK45 at 1e-10",
            lambda: time_once(theirs) / SAMPLE,
            digits(theirs()),
        ),
    ]
    says = "the flip of one start of str, of very many; digits after the point at the worst"
    return Measurement("flipmap", says, rounds, interleave(contenders, rounds), ours)


def _ball_flip(a: float, b: float, psi: float, rate: float) -> arb:
    p, q, x, v, turns = (fmpq(*float(y).as_integer_ratio()) for y in (a, b, psi, rate, math.tau))
    return travel(Shape(p, q), Start(Angle(fmpq(0), x), v), Angle(fmpq(0), turns), 20).turn


def _solve_ivp(a: float, b: float, psi: float, rate: float) -> float:
    from scipy.integrate import solve_ivp

    def system(_: float, y: Any) -> list[float]:
        sine, cosine = math.sin(y[0]), math.cos(y[0])
        clock = 1 - b * sine * sine
        return [
            (a + b * sine * sine) * y[1] / clock,
            b * (1 - y[1] * y[1]) * sine * cosine / clock,
        ]

    square = math.sin(psi) ** 2
    start = [psi, rate * (1 - b * square) / (a + b * square)]
    found = solve_ivp(system, (0, math.tau), start, method="RK45", rtol=1e-10, atol=1e-12)
    return float(found.y[0, -1]) - psi
