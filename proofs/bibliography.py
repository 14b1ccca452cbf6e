"""The numbers in the bibliography: the Wilson T-2000, in kg m²."""

from __future__ import annotations

from tresym.proofs.numbers_in_text import STR, number

from tresym.ledger.vocabulary import *

KILOGRAM_METRES = {"I1": "0.121e-2", "I2": "1.638e-2", "I3": "1.748e-2"}
"""The moments as printed there."""

_THERE = line(461)

moments = tuple(
    number(
        f"wilson_{name}",
        f"{name} = {printed} kg m² is the {STR[name]} kg mm² of Table 1.",
        STR[name],
        lambda moment, m: moment * 10**6,
        {name: printed},
        where=_THERE,
    )
    for name, printed in KILOGRAM_METRES.items()
)

wilson_a = number(
    "wilson_a",
    "These moments lead to a = 12.5372.",
    "12.5372",
    lambda I1, I2, m: I2 / I1 - 1,
    {name: KILOGRAM_METRES[name] for name in ("I1", "I2")},
    where=_THERE,
)

wilson_b = number(
    "wilson_b",
    "These moments lead to b = 0.0629.",
    "0.0629",
    lambda I2, I3, m: 1 - I2 / I3,
    {name: KILOGRAM_METRES[name] for name in ("I2", "I3")},
    where=_THERE,
)
