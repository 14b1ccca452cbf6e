"""ε(γ) to 50 digits: the certified ball against ``findroot`` over the paper's integral.

The peers start from the paper's formulas. Where the trajectory has turned F(ε, γ) = π has no root,
and they say so in their ways.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial

from flint import arb, fmpq

from tresym.bench import peers
from tresym.bench.run import Contender, Keep, Measurement, Pace, forget, interleave
from tresym.bench.truth import by_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import defect, flip_defect
from tresym.reals.numbers.exact import fraction_text, parse_number

DIGITS = 50
SHAPE = named_body("str").shape
A, B = map(fraction_text, SHAPE)
SCENES = ("1e-4", "1e-8", "1e-2", "-1e-3", "-1e-2")
"""The γ that are timed: next to the separatrix, with ε < 0, below the separatrix, turned once."""
OURS = "tresym, certified"
PUBLIC = "tresym.flip_defect, from text"

METHODS: dict[str, peers.Method] = {
    "mpmath findroot over quad": peers.findroot_quad,
    "mpmath findroot over R_F, R_J": peers.findroot_carlson,
}

PACE = Pace(rounds=7, limit=5.0, patience=1.0)


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``defect``."""
    contenders = (c for text in SCENES for c in _contenders(parse_number(text), text))
    timings, complete = interleave(contenders, pace, keep)
    return Measurement("defect", "ε(γ) of str to 50 digits", timings, OURS, complete=complete)


def _contenders(gamma: fmpq, text: str) -> Iterator[Contender]:
    truth = defect.solve(*SHAPE, gamma, 2 * DIGITS).defect
    works = {
        name: partial(m, SHAPE, gamma, DIGITS) for name, m in ({OURS: _ours} | METHODS).items()
    }
    works[PUBLIC] = partial(_public, text)
    for name, work in works.items():
        judge = by_digits(truth, DIGITS, DIGITS)
        yield Contender(f"γ = {text}", name, work, judge, name in (OURS, PUBLIC), DIGITS)


def _public(gamma: str) -> arb:
    """The same, as a user asks for it."""
    return flip_defect(A, B, gamma, DIGITS).defect


def _ours(shape: Shape, gamma: fmpq, digits: int) -> arb:
    return defect.solve(*shape, gamma, digits).defect
