"""Work-precision benchmark: correct digits of ε(γ) against time, in six scenes.

The truth is a ball with more than a thousand digits. Each model of tresym is called by itself; the
model that would be selected is recorded in ``notes.picks``, and the time including the selection is
that of the method `tresym`.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import suppress
from functools import partial
from typing import Any, NamedTuple

import numpy as np
from flint import arb, fmpq

from tresym.dev.bench import peers
from tresym.dev.bench.run import Contender, Judge, Judged, Pace, Rising, Workload, row
from tresym.dev.bench.truth import by_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import defect, flip_defect, separatrix
from tresym.racket.flip.model_selection import MODELS, climb
from tresym.racket.floats.flipmap import flip_map
from tresym.racket.floats.shapes import defects
from tresym.reals.numbers.exact import InputError, fraction_text, parse_number

DIGITS = (3, 10, 16, 30, 50, 100, 200, 500, 1000)
FLOATS = 15
"""The digits asked for in float64."""

MANY = 4096
"""The number of results per call in float64 arrays."""


class Scene(NamedTuple):
    """A body and a γ, with a name for readers."""

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


def warm_up() -> None:
    """Import and compile everything before anything is timed."""
    peers.brentq_quad(*SCENES[0][1:], FLOATS)
    peers.brentq_carlson(*SCENES[0][1:], FLOATS)
    peers.scipy_ode("RK45")(*SCENES[0][1:], 4)
    with suppress(ImportError):
        for tolerance in SOLVERS["heyoka, Taylor"][1]:
            peers.heyoka_solver(tolerance)


def picks(*_: Any) -> dict[str, dict[str, dict[str, str]]]:
    """Return the model that is selected, by scene and digits."""
    found = {
        scene.name: {str(d): climb(scene.shape, scene.gamma, d).model for d in DIGITS}
        for scene in SCENES
    }
    return {"picks": found}


def truth_of(scene: Scene) -> arb:
    """Return ε(γ) of a scene, with more digits than any method is asked for."""
    if scene.gamma == 0:
        return separatrix.solve(*scene.shape, 1100).defect
    return defect.inverted(*scene.shape, scene.gamma, 1100).defect


def contenders(_: Any) -> Iterator[Contender]:
    """Yield every method in every scene, each for increasing digits."""
    warm_up()
    for scene in SCENES:
        name, shape, gamma = scene
        truth, at = truth_of(scene), (shape, gamma)
        text = fraction_text(shape.a), fraction_text(shape.b), fraction_text(gamma)
        methods: dict[str, tuple[Callable[[int], Any], tuple[int, ...]]] = {
            "tresym": (partial(_on_model, scene, None), DIGITS),
            "tresym.flip_defect": (partial(_public, *text), DIGITS),
        }
        for model in MODELS:
            able = [d for d in DIGITS if _answers(scene, model, d)]
            digits = (*able, *(d for d in DIGITS if d not in able))[: len(able) + 1]
            methods[f"tresym, {model}"] = partial(_on_model, scene, model), digits
        on_level = ON_SEPARATRIX if gamma == 0 else {}
        methods |= {n: (partial(m, *at), DIGITS) for n, m in (on_level | EVERYWHERE).items()}
        methods |= {n: (partial(m, *at), digits) for n, (m, digits) in SOLVERS.items()}
        for method, (work, digits) in methods.items():
            rising = Rising()
            for d in digits:
                once = {method: rising.work(work, d)}
                yield from row(name, once, by_digits(truth, d, d), asked=d)
        first = {"scipy brentq, printed equation": peers.brentq_printed} if gamma == 0 else {}
        floats = {n: partial(m, *at, FLOATS) for n, m in (first | FLOAT_PEERS).items()}
        yield from row(name, floats, by_digits(truth, FLOATS, FLOATS), asked=FLOATS)
        judge = partial(_of_first, by_digits(truth, FLOATS - 2, FLOATS - 2))
        arrays = {"tresym, float64 arrays": _arrays(scene)}
        yield from row(name, arrays, judge, asked=FLOATS, pieces=MANY)


WORKLOAD = Workload(contenders, Pace(rounds=7, limit=2.5, patience=0.3), "tresym", notes=picks)


def _answers(scene: Scene, model: str, digits: int) -> bool:
    with suppress(InputError):
        _on_model(scene, model, digits)
        return True
    return False


def _public(a: str, b: str, gamma: str, digits: int) -> arb:
    return flip_defect(a, b, gamma, digits).defect


def _of_first(judge: Judge, values: Any) -> Judged:
    return judge(float(values[0]))


def _on_model(scene: Scene, model: str | None, digits: int) -> arb:
    return climb(scene.shape, scene.gamma, digits, model).defect


def _arrays(scene: Scene) -> Callable[[], Any]:
    """Float64 arrays: the time of one result among thousands."""
    a, b, gamma = peers.floats(scene.shape, scene.gamma)
    if scene.gamma == 0:
        return partial(defects, np.full(MANY, a), np.full(MANY, b))
    rate = np.full(MANY, np.sqrt((a + b) * (gamma + b)) / (1 - b))
    psi = np.full(MANY, np.pi / 2)
    return lambda: psi + flip_map(a, b, psi, rate, -np.pi)
