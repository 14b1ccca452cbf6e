"""ε(γ) to 50 digits: the certified ball against ``findroot`` over the paper's integral.

The peer starts from the linear formula at γ = 0. Where the trajectory has turned it has no root to
find, so there it is not entered.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

from flint import fmpq

from tresym.arithmetic import mp_precision, to_mp
from tresym.bench.run import Measurement, interleave
from tresym.bench.turn import DIGITS, SHAPE, contender
from tresym.exact import parse_number
from tresym.flip import defect, quadrature
from tresym.flip.slopes import slopes

SCENES = ("1/10000", "1/100", "-1/1000", "-1/100")
"""The γ that are timed: not turned with ε > 0, with ε < 0, below the separatrix, turned once."""


def measure(rounds: int = 3) -> Measurement:
    """The workload ``defect``."""
    contenders = []
    for text in SCENES:
        gamma = parse_number(text)
        truth = defect.solve(*SHAPE, gamma, 2 * DIGITS).defect
        works: dict[str, Callable[[], Any]] = {"tresym, certified": partial(_ours, gamma)}
        if text != SCENES[-1]:
            works["mpmath findroot over quad"] = partial(_findroot, gamma)
        contenders += [
            contender(f"gamma = {text}: {name}", work, truth) for name, work in works.items()
        ]
    timings = interleave(contenders, rounds)
    reference = f"gamma = {SCENES[0]}: tresym, certified"
    return Measurement("defect", "ε(γ) of str to 50 digits", rounds, timings, reference)


def _ours(gamma: fmpq) -> Any:
    return defect.solve(*SHAPE, gamma, DIGITS).defect


def _findroot(gamma: fmpq) -> Any:
    found = slopes(*SHAPE, fmpq(0), 15)
    with mp_precision(DIGITS) as mp:
        a, b, g = (to_mp(x, mp) for x in (*SHAPE, gamma))
        start = mp.mpf(float(found.defect)) + g * mp.mpf(float(found.first))
        return mp.findroot(lambda e: quadrature.printed(e, a, b, g, mp)[0] - mp.pi, start)
