"""Section 6, continued: a formula on one line for every shape, by one sweep of the phase equation.

- `chart`: κ, by which large ab is looked at;
- `sweep_from_pi`, `sweep_from_four`: the defect after one sweep, which puts a start into
  P = π + arctan(√(b/a) tanh(√(ab) P)), as the code computes it.
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

label_claims(globals())
