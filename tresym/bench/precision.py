"""Work and precision: true digits of ε(γ) against time, for every method, in six scenes.

The truth is a ball of a thousand digits and more. Our rungs are asked one by one, each as it would
answer alone; which of them the ladder takes is noted beside (``notes.picks``), and what the
choosing itself costs is the method `tresym`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from flint import arb, fmpq

from tresym.bench import peers
from tresym.bench.run import Contender, Keep, Measurement, Pace, Rising, forget, interleave
from tresym.bench.truth import by_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import defect, separatrix
from tresym.racket.flip.ladder import RUNGS, climb
from tresym.racket.floats.flipmap import flip_map
from tresym.racket.floats.shapes import defects
from tresym.reals.numbers.exact import InputError, parse_number

DIGITS = (3, 10, 16, 30, 50, 100, 200, 500, 1000)
FLOATS = 15
"""Digits that a float64 method is asked for."""

MANY = 4096
"""Answers at once in the float64 arrays."""


class Scene(NamedTuple):
    """A body and a γ, with the words a reader knows it by."""

    name: str
    shape: Shape
    gamma: fmpq


SCENES = (
    Scene("standard racket, γ = 0", named_body("str").shape, fmpq(0)),
    Scene("standard racket, γ = 1e-8", named_body("str").shape, parse_number("1e-8")),
    Scene(
        "standard racket, at its turning point",
        named_body("str").shape,
        parse_number("-0.0034786129"),
    ),
    Scene("Goldstein's book, γ = 0", named_body("book").shape, fmpq(0)),
    Scene("nearly symmetric, a = 1, b = 1e-6", Shape(fmpq(1), parse_number("1e-6")), fmpq(0)),
    Scene("ab = 30, b = 0.5", Shape(fmpq(60), fmpq(1, 2)), fmpq(0)),
)
"""What is timed; the turning point of the racket is at γ = −0.003478612941952…"""

ON_SEPARATRIX: dict[str, peers.Method] = {
    "mpmath findroot, printed equation": peers.findroot_printed,
    "mpmath Newton, phase equation": peers.findroot_phase,
}
EVERYWHERE: dict[str, peers.Method] = {
    "mpmath findroot over quad": peers.findroot_quad,
    "mpmath findroot over R_F, R_J": peers.findroot_carlson,
}
FLOAT_PEERS: dict[str, peers.Method] = {
    "scipy brentq over quad": peers.brentq_quad,
    "scipy brentq over R_F, R_J": peers.brentq_carlson,
}
SOLVERS: dict[str, tuple[peers.Method, tuple[int, ...]]] = {
    "scipy solve_ivp, RK45": (peers.scipy_ode("RK45"), (4, 7, 10, 13)),
    "scipy solve_ivp, DOP853": (peers.scipy_ode("DOP853"), (4, 7, 10, 13)),
    "heyoka, Taylor": (peers.heyoka_ode, (6, 10, 15)),
    "mpmath odefun": (peers.odefun, (10, 16, 30)),
}

PACE = Pace(rounds=7, limit=2.5, patience=0.3)


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``precision``."""
    warm_up()
    contenders = (c for scene in SCENES for c in _contenders(scene))
    timings, complete = interleave(contenders, pace, keep)
    return Measurement(
        "precision",
        "ε(γ) by every method, 10 to 1000 digits and float64, in six scenes",
        timings,
        "tresym",
        notes={"picks": picks()},
        complete=complete,
    )


def warm_up() -> None:
    """Import and compile everything before anything is timed."""
    peers.brentq_quad(*SCENES[0][1:], FLOATS)
    peers.brentq_carlson(*SCENES[0][1:], FLOATS)
    peers.scipy_ode("RK45")(*SCENES[0][1:], 4)
    with suppress(ImportError):
        for tolerance in SOLVERS["heyoka, Taylor"][1]:
            peers.heyoka_solver(tolerance)


def picks() -> dict[str, dict[str, str]]:
    """The rung that the ladder takes, by scene and digits."""
    return {
        scene.name: {str(d): climb(scene.shape, scene.gamma, d).rung for d in DIGITS}
        for scene in SCENES
    }


def truth_of(scene: Scene) -> arb:
    """ε(γ) of a scene, more digits than anybody is asked for."""
    if scene.gamma == 0:
        return separatrix.solve(*scene.shape, 1100).defect
    return defect.inverted(*scene.shape, scene.gamma, 1100).defect


def _contenders(scene: Scene) -> Iterator[Contender]:
    truth = truth_of(scene)
    at = scene.shape, scene.gamma
    yield from _ladder(scene, truth, "tresym", lambda d: climb(*at, d).defect, ours=True)
    for rung in RUNGS:
        work = partial(_on_rung, scene, rung)
        able = [d for d in DIGITS if _answers(scene, rung, d)]
        digits = (*able, *(d for d in DIGITS if d not in able))[: len(able) + 1]
        yield from _ladder(scene, truth, f"tresym, {rung}", work, digits=digits, ours=True)
    yield _arrays(scene, truth)
    on_level = ON_SEPARATRIX if scene.gamma == 0 else {}
    for name, method in (on_level | EVERYWHERE).items():
        yield from _ladder(scene, truth, name, partial(method, *at))
    floats = {"scipy brentq, printed equation": peers.brentq_printed} if scene.gamma == 0 else {}
    for name, method in (floats | FLOAT_PEERS).items():
        judge = by_digits(truth, FLOATS, FLOATS)
        yield Contender(scene.name, name, partial(method, *at, FLOATS), judge, asked=FLOATS)
    for name, (method, tolerances) in SOLVERS.items():
        yield from _ladder(scene, truth, name, partial(method, *at), digits=tolerances)


def _answers(scene: Scene, rung: str, digits: int) -> bool:
    try:
        _on_rung(scene, rung, digits)
    except InputError:
        return False
    return True


def _on_rung(scene: Scene, rung: str, digits: int) -> arb:
    return climb(scene.shape, scene.gamma, digits, rung).defect


def _ladder(
    scene: Scene,
    truth: arb,
    name: str,
    work: Callable[[int], Any],
    *,
    digits: tuple[int, ...] = DIGITS,
    ours: bool = False,
) -> Iterator[Contender]:
    """One method at rising digits."""
    rising = Rising()
    for asked in digits:
        judge = by_digits(truth, asked, asked)
        yield Contender(scene.name, name, rising.work(work, asked), judge, ours, asked)


def _arrays(scene: Scene, truth: arb) -> Contender:
    """Float64 over arrays: the time of one answer among thousands."""
    a, b, gamma = peers.floats(scene.shape, scene.gamma)
    if scene.gamma == 0:
        first, second = np.full(MANY, a), np.full(MANY, b)

        def work() -> Any:
            return defects(first, second)

    else:
        rate = np.full(MANY, np.sqrt((a + b) * (gamma + b)) / (1 - b))
        psi = np.full(MANY, np.pi / 2)

        def work() -> Any:
            return psi + flip_map(a, b, psi, rate, -np.pi)

    judged = by_digits(truth, FLOATS - 2, FLOATS - 2)
    return Contender(
        scene.name,
        "tresym, float64 arrays",
        work,
        lambda values: judged(float(values[0])),
        ours=True,
        asked=FLOATS,
        pieces=MANY,
    )
