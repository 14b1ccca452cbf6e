"""Benchmark of ε(γ) to 50 digits: certified balls against ``findroot`` on the paper's integral.

The other methods start from the paper's formulas. If the trajectory has passed a turning point,
F(ε, γ) = π has no root, and they fail.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from typing import Any

from flint import arb, fmpq

from tresym.dev.bench import peers
from tresym.dev.bench.run import Contender, Pace, Workload, row
from tresym.dev.bench.truth import by_digits
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import defect
from tresym.reals.numbers.exact import parse_number

DIGITS = 50
SHAPE = named_body("str").shape
SCENES = ("1e-4", "1e-8", "1e-2", "-1e-3", "-1e-2")
"""The γ that are timed: next to the separatrix, with ε < 0, below the separatrix, turned once."""
OURS = "tresym, certified"


def contenders(_: Any) -> Iterator[Contender]:
    """Yield the internal and the public function of tresym, and the methods by mpmath."""
    for text in SCENES:
        gamma = parse_number(text)
        truth = defect.solve(*SHAPE, gamma, 2 * DIGITS).defect
        asked = SHAPE, gamma, DIGITS
        works: dict[str, Callable[[], Any]] = {
            OURS: partial(_solved, *asked),
            "tresym.flip_defect, from text": partial(peers.from_text, "str", text, DIGITS),
            "mpmath findroot over quad": partial(peers.findroot_quad, *asked),
            "mpmath findroot over R_F, R_J": partial(peers.findroot_carlson, *asked),
        }
        yield from row(f"γ = {text}", works, by_digits(truth, DIGITS, DIGITS), asked=DIGITS)


def _solved(shape: Shape, gamma: fmpq, digits: int) -> arb:
    return defect.solve(*shape, gamma, digits).defect


WORKLOAD = Workload(contenders, Pace(rounds=7, limit=5.0, patience=1.0), OURS)
