"""Section 6, continued: a formula on one line for every shape, by one sweep of the phase equation.

A sweep is one step of the fixed-point iteration P ↦ π + arctan(√(b/a) tanh(√(ab) P)), computed as
in the code.

- `chart`: κ, the coordinate for large ab;
- `sweep_from_pi`, `sweep_from_four`: the defect after one sweep from P = π or P = 4;
- `phase_from_pi`, `defect_from_pi`, `phase_from_four`, `defect_from_four`: the same after a step of
  Newton's method.
"""

from tresym.proofs.conditions import shape

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import stable
from tresym.racket.notation import *

_k, _r = sqrt(a * b), sqrt(b / a)

chart = Claim(says=equal(kappa, 1 / _k), given=shape, proof=Definition())


def _swept(defect: Symbol, start: Expr) -> Claim:
    """The defect that belongs to the phase after one sweep from ``start``."""
    phase = stable.phase_map(start, _k, _r, sympy)
    return Claim(
        says=equal(defect, stable.defect_at(phase, _k, _r, sympy)), given=shape, proof=Definition()
    )


sweep_from_pi = _swept(epsilon_pi, pi)
sweep_from_four = _swept(epsilon_4, Integer(4))

newton_phase_pi, newton_pi, newton_phase_4, newton_4 = (
    Symbol(name, real=True) for name in ("P_pi", "epsilon_pi2", "P_4", "epsilon_42")
)
"""The phase, and the defect, after one step of Newton's method from such a sweep."""


def _improved(phase: Symbol, defect: Symbol, start: Expr) -> tuple[Claim, Claim]:
    """The phase after a Newton step, and the defect that belongs to it."""
    swept = stable.phase_map(start, _k, _r, sympy)
    sine = sinh(_k * swept)
    gap = atan(_r * tanh(_k * start)) - atan(_r * tanh(_k * swept))
    steepness = (cosh(_k * swept) ** 2 + b / a * sine**2) / (1 - b + (1 + b / a) * sine**2)
    stepped = Claim(says=equal(phase, swept - gap * steepness), given=shape, proof=Definition())
    angle = pi / 2 - atan(sqrt(1 + b / a) * sinh(_k * phase))
    return stepped, Claim(says=equal(defect, angle), given=shape, proof=Definition())


newton_from_pi = _improved(newton_phase_pi, newton_pi, pi)
newton_from_four = _improved(newton_phase_4, newton_4, Integer(4))
phase_from_pi, defect_from_pi = newton_from_pi
phase_from_four, defect_from_four = newton_from_four

label_claims(globals())
