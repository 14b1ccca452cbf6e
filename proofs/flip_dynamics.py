"""Section 5: the flip angle alone.

- `sign_of_tilt`: S is the sign of cos θ; `sign_squared`: S² = 1;
- display (12), `d12`: cos θ from γ and ψ;
- (13), `eq_dpsidphi`: the equation of the flip angle;
- (19), `d19`: dφ/dψ, the integrand f of the precession.
"""

from tresym.proofs.conditions import ordered_moments, shape_of_a_body, tilted
from tresym.proofs.euler_angles import eq_Euler, eq_gamma

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

moving = (*ordered_moments, *shape_of_a_body, cos(theta) ** 2 > 0, gamma + b * sin(psi) ** 2 > 0)
"""Away from the turning points, where cos θ ≠ 0; the two conditions mean the same."""

sign_of_tilt = Claim(
    says=equal(S, cos(theta) / Abs(cos(theta))), given=(cos(theta) ** 2 > 0,), proof=Definition()
)

sign_squared = Claim(
    says=equal(S**2, 1), given=(cos(theta) ** 2 > 0,), proof=by(substituting(sign_of_tilt), roots)
)

d12 = Claim(
    says=equal(cos(theta), printed.cos_theta(psi, a, b, gamma, S, sympy)),
    given=moving,
    proof=(
        step(S * sqrt(cos(theta) ** 2), substituting(sign_of_tilt)),
        step(None, substituting(eq_gamma), trigonometry, roots),
    ),
    where=display(12),
)

eq_dpsidphi = Claim(
    says=equal(dpsi_dphi, printed.psi_rate(psi, a, b, gamma, S, sympy)),
    given=(*tilted, *moving),
    proof=by(substituting(eq_Euler, d12), roots),
    where=display(13),
)

d19 = Claim(
    says=equal(1 / dpsi_dphi, printed.integrand(psi, a, b, gamma, S, sympy)),
    given=(*tilted, *moving, Ne(dpsi_dphi, 0)),
    proof=by(substituting(eq_dpsidphi, sign_of_tilt), roots),
    where=display(19),
)

label_claims(globals())
