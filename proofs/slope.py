"""Appendix, second part: how the flip defect depends on γ at the separatrix.

- display (54), `d54`: ∂f/∂γ at γ = 0;
- (55), `d55`: its antiderivative, as printed;
- (51), `d51`: ∂ε/∂F at γ = 0 from ∂F/∂ε = −f.
"""

from tresym.proofs.conditions import defect, shape
from tresym.proofs.flip_dynamics import sign_of_tilt
from tresym.proofs.separatrix import between

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

d54 = Claim(
    says=equal(
        Subs(Derivative(printed.integrand(psi, a, b, gamma, S, sympy), gamma), gamma, 0),
        printed.integrand_slope(psi, a, b, S, sympy),
    ),
    given=(*shape, *between),
    proof=by(differentiation, roots),
    where=display(54),
)

d55 = Claim(
    says=equal(
        Derivative(printed.turn_slope_antiderivative(psi, a, b, S, sympy), psi),
        printed.integrand_slope(psi, a, b, S, sympy),
    ),
    given=(*shape, psi > 0, psi < pi / 2, sin(psi) > 0, cos(psi) > 0),
    proof=by(differentiation, trigonometry, roots),
    where=display(55),
)

d51 = Claim(
    says=equal(
        -1 / printed.integrand(epsilon, a, b, 0, S, sympy),
        printed.defect_per_turn(epsilon, a, b, S, sympy),
    ),
    given=(*shape, *defect, cos(theta) ** 2 > 0),
    proof=by(substituting(sign_of_tilt), roots),
    where=display(51),
)

label_claims(globals())
