"""Section 8: ethylene, from its printed rotational constants.

- `rotational_constants`: a = B₁/B₂ − 1 and b = 1 − B₃/B₂;
- `ethylene_flip`: the printed flip does not follow from the constants; `ethylene_flip_exact` and
  `ethylene_flip_formula` give the values that do; `ethylene_without_prefactor` explains the printed
  number.
"""

from __future__ import annotations

from tresym.proofs.euler_angles import d08
from tresym.proofs.printed import inputs, number, share_of_pi
from tresym.proofs.separatrix import flip_defect, leading_defect, one_flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

B1, B2, B3 = (Symbol(f"B{n}", real=True) for n in (1, 2, 3))
_ordered = (B1 > 0, B2 > 0, B3 > 0, B2 - B3 > 0, B1 - B2 > 0)
_moments = {I1: 1 / B1, I2: 1 / B2, I3: 1 / B3}
_a, _b = (at(ratio, _moments) for ratio in printed.shape(I1, I2, I3))

CONSTANTS = inputs(B1="4.64", B2="1.001", B3="0.828")
_ETHYLENE = (*CONSTANTS, *(equal(moment, value) for moment, value in _moments.items()))
"""The constants as printed, and the moments, but for their common factor."""

rotational_constants = Claim(
    says=Tuple(equal(_a, B1 / B2 - 1), equal(_b, 1 - B3 / B2)),
    given=_ordered,
    proof=by(evaluating),
    where=line(320),
    note="The constants are inversely proportional to the moments; the factor cancels.",
    shown=r"\frac{I_2}{I_1}-1 = \frac{B_1}{B_2}-1,\quad 1-\frac{I_2}{I_3} = 1-\frac{B_3}{B_2}",
)

rotational_order = Claim(
    says=Tuple(1 / B2 - 1 / B1 > 0, 1 / B3 - 1 / B2 > 0), given=_ordered, proof=manifest
)

ethylene_flip_exact = number(
    "By the exact equation ethylene flips by π(1 − {}).",
    share_of_pi(epsilon0),
    "0.0870",
    _ETHYLENE,
    *(d08, rotational_constants, flip_defect, one_flip_defect),
)

ethylene_flip_formula = number(
    "By the asymptotic formula ethylene flips by π(1 − {}).",
    share_of_pi(epsilon_printed),
    "0.0871",
    _ETHYLENE,
    *(d08, rotational_constants, leading_defect),
)

ethylene_without_prefactor = number(
    "The printed {} is (2/π) e^{−π√(ab)}: the formula without its prefactor.",
    share_of_pi(exp(-pi * sqrt(a * b))),
    "0.0528",
    _ETHYLENE,
    *(d08, rotational_constants),
)

_AMENDED = (ethylene_flip_exact, ethylene_flip_formula, ethylene_without_prefactor)

ethylene_flip = number(
    "Ethylene flips by π(1 − {}) at γ = 0.",
    share_of_pi(epsilon0),
    "0.0528",
    _ETHYLENE,
    *(d08, rotational_constants, flip_defect, one_flip_defect),
    where=line(320),
    expect=Verdict.REFUTED,
    amended_by=_AMENDED,
    fault=Fault.MISPRINT,
)

ethylene_flip_by_formula = number(
    "By the asymptotic formula ethylene flips by π(1 − {}) at γ = 0.",
    share_of_pi(epsilon_printed),
    "0.0528",
    _ETHYLENE,
    *(d08, rotational_constants, leading_defect),
    where=line(320),
    expect=Verdict.REFUTED,
    amended_by=_AMENDED,
    fault=Fault.MISPRINT,
)

ethylene_plane = number(
    "1/B₃ and 1/B₁ + 1/B₂ differ by 0.6 %: the molecule is flat, as its constants say.",
    (1 / B1 + 1 / B2) * B3 - 1,
    "0.006",
    CONSTANTS,
)

ethylene = Claim(
    **jointly(rotational_constants, rotational_order, ethylene_plane),
    where=line(320),
)

label_claims(globals())
