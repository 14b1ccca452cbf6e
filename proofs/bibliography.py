"""The numbers in the bibliography: the Wilson T-2000, in kg m²."""

from __future__ import annotations

from tresym.proofs.euler_angles import d08
from tresym.proofs.printed import MOMENTS, TABLE_1, inputs, number, typeset

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

KILOGRAM_METRES = {"I1": "0.121e-2", "I2": "1.638e-2", "I3": "1.748e-2"}
"""The moments as printed there."""

_THERE = line(461)


def _as_there(*names: str) -> tuple[Basic, ...]:
    return inputs(**{name: KILOGRAM_METRES[name] for name in names})


def _letter(name: str) -> str:
    return name.translate(str.maketrans("123", "₁₂₃"))


moments = tuple(
    number(
        f"{_letter(name)} = {typeset(KILOGRAM_METRES[name])} kg m² is the {{}} kg mm² of Table 1.",
        10**6 * Symbol(name, real=True),
        str(text),
        _as_there(name),
        label=f"wilson_{name}",
        where=_THERE,
    )
    for name, text in zip(MOMENTS, TABLE_1["str"][:3], strict=True)
)

wilson_a = number(
    "These moments lead to a = {}.", a, "12.5372", _as_there("I1", "I2"), d08, where=_THERE
)

wilson_b = number(
    "These moments lead to b = {}.", b, "0.0629", _as_there("I2", "I3"), d08, where=_THERE
)

label_claims(globals())
