"""Appendix, second part: the integral F whose level lines are ε(γ).

- `d48`: the turn is twice F, by the symmetry of the flip angle about π/2; `d49` defines F;
- `slope_by_end`: ∂F/∂ε = −f; `eq_depsdgamma_form`: dε/dγ = −(∂ε/∂F)(∂F/∂γ);
- `d53`: the derivative goes under the integral, whose integrand is smooth there;
- `S_drops_out`: the sign S does not matter for dε/dγ.
"""

from __future__ import annotations

import sympy
from sympy import Equivalent, Gt, Integral, Ne, Symbol, cos, pi, sin
from tresym.proofs.conditions import defect, shape
from tresym.proofs.flip_definition import equal_rates
from tresym.proofs.flip_dynamics import sign_of_tilt
from tresym.proofs.slope import inverse_slope, slope_of_integral, slope_of_integrand

from tresym.claims.claim import (
    Claim,
    Definition,
    Place,
    adding,
    all_of,
    by,
    changing_variable,
    equal,
    multiplying,
    step,
    substituting,
)
from tresym.formulas import printed
from tresym.notation import F, S, a, b, epsilon, gamma, psi, theta, x

_f = printed.integrand(psi, a, b, gamma, S, sympy)
F_epsilon, F_gamma, defect_F, defect_gamma = (
    Symbol(f"partial{of}_partial{by}", real=True)
    for of, by in (("F", "epsilon"), ("F", "gamma"), ("epsilon", "F"), ("epsilon", "gamma"))
)
"""Partial derivatives, as symbols of their own."""
_rotating = (*shape, b < 1, *defect, gamma > 0)

second_half = Claim(
    label="second_half",
    says=equal(
        Integral(_f, (psi, pi / 2, pi - epsilon)),
        Integral(-_f.subs(psi, x), (x, pi / 2, epsilon)),
    ),
    given=_rotating,
    proof=by(changing_variable(pi - psi)),
)

half_turn = Claim(
    label="d48",
    says="The integral of f from ε to π − ε is twice that from ε to π/2.",
    kind="statement",
    proof=all_of(second_half, equal_rates),
    where=Place(display=48),
    note="The second half is the first, run backwards.",
)

half_integral = Claim(
    label="d49",
    says=equal(F, Integral(_f, (psi, epsilon, pi / 2))),
    given=_rotating,
    proof=Definition(),
    where=Place(display=49),
)

one_turn = Claim(
    label="one_turn",
    says=equal(Integral(_f, (psi, epsilon, pi / 2)), pi),
    given=_rotating,
    proof=Definition(),
    where=Place(display=49),
    note="What one turn of the handle means, by d48, while the motion has not turned.",
)

smooth_under_the_integral = Claim(
    label="smooth_under_the_integral",
    says=Gt(b * sin(psi) ** 2 + gamma, 0, evaluate=False),
    kind="bound",
    given=(*shape, psi > 0, psi < pi, sin(psi) > 0, gamma >= 0),
    proof=(step(b * sin(psi) ** 2 + gamma),),
)

derivative_under_the_integral = Claim(
    label="d53",
    says="At γ = 0 the derivative of F by γ is the integral of that of f.",
    kind="statement",
    proof=all_of(slope_of_integrand, slope_of_integral, smooth_under_the_integral),
    where=Place(display=53),
    note="On [ε₀, π/2] the integrand is smooth in ψ and γ; that F itself converges is not enough.",
)

slope_of_turn = Claim(
    label="slope_of_turn",
    says="At γ = 0 the derivative of F by γ is the antiderivative of d55 between its ends.",
    kind="statement",
    proof=all_of(derivative_under_the_integral, slope_of_integrand, slope_of_integral),
    where=Place(display=55),
)

slope_by_end = Claim(
    label="slope_by_end",
    says=equal(F_epsilon, -printed.integrand(epsilon, a, b, gamma, S, sympy)),
    given=_rotating,
    proof=Definition(),
    where=Place(display=51),
    note="What ∂F/∂ε is: F is an integral from ε.",
)

defect_by_turn = Claim(
    label="defect_by_turn",
    says=equal(defect_F, -1 / printed.integrand(epsilon, a, b, 0, S, sympy)),
    given=(*shape, *defect, Ne(S, 0), 1 - b * sin(epsilon) ** 2 > 0),
    proof=Definition(),
    where=Place(display=51),
    note="What ∂ε/∂F is: the inverse of ∂F/∂ε, here at γ = 0.",
)

differentiated_turn = Claim(
    label="differentiated_turn",
    says=Equivalent(
        equal(F_gamma + defect_gamma / defect_F, 0), equal(defect_gamma, -defect_F * F_gamma)
    ),
    given=(defect_F < 0,),
    proof=(
        step(equal(defect_F * F_gamma + defect_gamma, 0), multiplying(defect_F)),
        step(equal(defect_gamma, -defect_F * F_gamma), adding(-defect_F * F_gamma)),
    ),
    where=Place(display=50),
    note="On the left F(ε(γ), γ) = π, differentiated; for S = 1, where F falls as ε grows.",
)

implicit_derivative = Claim(
    label="eq_depsdgamma_form",
    says="dε/dγ = −(∂ε/∂F)(∂F/∂γ) at γ = 0.",
    kind="statement",
    proof=all_of(differentiated_turn, inverse_slope, derivative_under_the_integral),
    where=Place(display=50),
    note="F(ε(γ), γ) = π is differentiated; ∂F/∂ε = −f is not 0.",
)

S_drops_out = Claim(
    label="S_drops_out",
    says=equal(
        printed.defect_per_turn(epsilon, a, b, S, sympy)
        * printed.turn_slope_asymptotic(epsilon, a, b, S, sympy),
        printed.defect_per_turn(epsilon, a, b, 1, sympy)
        * printed.turn_slope_asymptotic(epsilon, a, b, 1, sympy),
    ),
    given=(*shape, b < 1, *defect, cos(theta) ** 2 > 0),
    proof=by(substituting(sign_of_tilt)),
    where=Place(line=417),
)
