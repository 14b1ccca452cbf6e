"""Appendix, second part: the integral F whose level lines are ε(γ).

- display (48), `d48`: the turn is twice F, by the symmetry of the flip angle about π/2;
- (49), `d49`, defines F, and `one_turn`, `level_line`: F = π is one turn;
- (50), `implicit_defect`: F(ε(γ), γ) = π has a slope, and `eq_depsdgamma_form`: which it is;
- (51), `slope_by_end`, `slope_by_end_at_zero`: ∂F/∂ε = −f; `inverse_symbol`: ε as a function of F,
  which has a slope where F = π, and `defect_by_turn`: it is ∂ε/∂F = −1/f at γ = 0;
- (53), `d53`: ∂F/∂γ is the integral of ∂f/∂γ; (55), `slope_of_turn`: its
  value;
- `S_drops_out`: the sign S does not matter for dε/dγ.
"""

from tresym.proofs import flip_dynamics
from tresym.proofs.conditions import defect, shape

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

_f = printed.integrand(psi, a, b, gamma, S, sympy)
F_epsilon, F_gamma, defect_F, defect_gamma = (
    Symbol(f"partial{of}_partial{by}", real=True)
    for of, by in (("F", "epsilon"), ("F", "gamma"), ("epsilon", "F"), ("epsilon", "gamma"))
)
F_epsilon0 = Symbol("partialF_partialepsilon0", real=True)
"""Partial derivatives, as symbols of their own; the last of F by ε at γ = 0."""
_value = Symbol("F0", real=True)
"""A value F₀ of F at γ = 0."""
_rotating = (*shape, b < 1, *defect, gamma > 0)


def _turn(level: Expr, start: Expr = epsilon) -> Integral:
    """F as an integral from ``start``, for the motions with γ = ``level``."""
    return Integral(printed.integrand(psi, a, b, level, S, sympy), (psi, start, pi / 2))


d48 = Claim(
    says=equal(Integral(_f, (psi, epsilon, pi - epsilon)), 2 * _turn(gamma)),
    given=_rotating,
    proof=(
        step(_turn(gamma) + Integral(_f, (psi, pi / 2, pi - epsilon)), cutting(pi / 2)),
        step(None, changing_variable(pi - psi)),
    ),
    where=display(48),
    note="The second half is the first half run backwards.",
)

d49 = Claim(says=equal(F, _turn(gamma)), given=_rotating, proof=Definition(), where=display(49))

one_turn = Claim(
    says=equal(_turn(gamma), pi),
    given=(*shape, b < 1, *defect, gamma >= 0),
    proof=Definition("one turn of the handle, before the motion turns back"),
    where=display(49),
    note=(
        "The condition of one turn of the handle, by d48, for "
        "motions before their first turning point."
    ),
)

level_line = Claim(
    says=equal(F, pi), given=_rotating, proof=by(substituting(d49, one_turn)), where=display(49)
)

# -- the derivative by the end --------------------------------------------------------------------

slope_symbol = Claim(
    says=equal(F_epsilon, Derivative(_turn(gamma), epsilon)),
    given=(*shape, *defect, gamma > 0),
    proof=Definition(),
    note="∂F/∂ε.",
)

slope_symbol_at_zero = Claim(
    says=equal(F_epsilon0, Derivative(_turn(Integer(0)), epsilon)),
    given=(*shape, *defect),
    proof=Definition(),
    note="∂F/∂ε at γ = 0.",
)

slope_by_end = Claim(
    says=equal(F_epsilon, -printed.integrand(epsilon, a, b, gamma, S, sympy)),
    given=(*shape, b < 1, *defect, gamma > 0),
    proof=by(substituting(slope_symbol), differentiating_integral(Integer(0))),
    where=display(51),
    note="F is an integral from ε.",
)

_at_end = printed.integrand(epsilon, a, b, 0, S, sympy)

slope_by_end_at_zero = Claim(
    says=equal(F_epsilon0, -_at_end),
    given=(*shape, b < 1, *defect),
    proof=by(substituting(slope_symbol_at_zero), differentiating_integral(Integer(0))),
    where=display(51),
    note="At γ = 0.",
)

_length = pi / 2 - epsilon
_excess = Integral(
    printed.integrand(psi, a, b, 0, S, sympy) - _value / _length, (psi, epsilon, pi / 2)
)
"""F − F₀ at γ = 0, as one integral: F₀ is spread over its interval."""
_one_motion = (*shape, b < 1, *defect, S > 0)

value_at_zero = Claim(
    says=equal(_turn(Integer(0)), _value),
    given=_one_motion,
    proof=Definition("the motion on the separatrix on which F is F0"),
    note="An equation for ε; in one turn F₀ is π.",
)

value_reached = Claim(
    says=equal(_excess, 0),
    given=_one_motion,
    proof=(
        step(_turn(Integer(0)) - Integral(_value / _length, (psi, epsilon, pi / 2)), collecting()),
        step(None, integrating(_value * psi / _length), substituting(value_at_zero)),
    ),
    note="F = F₀ at γ = 0, as an equation for ε.",
)

_by_value = Subs(Derivative(_excess, _value), _value, pi)
_by_end = Derivative(_excess.xreplace({_value: pi}), epsilon)
_spread_slope = -pi / _length**2
_opened = (differentiating_integral(_spread_slope), integrating(_spread_slope * psi))

inverse_symbol = Claim(
    says=equal(defect_F, -_by_value / _by_end),
    given=_one_motion,
    proof=ImplicitFunction(value_reached, epsilon, _value, pi, (step(-_at_end, *_opened),)),
    note="∂ε/∂F at γ = 0: the slope of the inverse function, where F = π.",
)

defect_by_turn = Claim(
    says=equal(defect_F, -1 / _at_end),
    given=_one_motion,
    proof=by(
        substituting(inverse_symbol),
        *(differentiating_integral(-1 / _length), integrating(-psi / _length)),
        *(*_opened, roots),
    ),
    where=display(51),
)

inverse_of_slope = Claim(
    says=equal(defect_F, 1 / F_epsilon0),
    given=_one_motion,
    proof=by(substituting(defect_by_turn, slope_by_end_at_zero), roots),
)

# -- the derivative by γ --------------------------------------------------------------------------

_slope = Subs(Derivative(_turn(gamma), gamma), gamma, 0)
_slope_of_f = printed.integrand_slope(psi, a, b, S, sympy)
_primitive = printed.turn_slope_antiderivative(psi, a, b, S, sympy)

d53 = Claim(
    says=equal(_slope, Integral(_slope_of_f, (psi, epsilon, pi / 2))),
    given=(*shape, *defect),
    proof=by(differentiating_integral(_slope_of_f)),
    where=display(53),
    note="On [ε₀, π/2] the integrand is smooth in ψ and γ; that F itself converges is not enough.",
)

slope_of_turn = Claim(
    says=equal(_slope, _primitive.subs(psi, pi / 2) - _primitive.subs(psi, epsilon)),
    given=(*shape, *defect),
    proof=by(substituting(d53), integrating(_primitive), trigonometry),
    where=display(55),
)

turn_symbol = Claim(
    says=equal(F_gamma, _slope), given=(*shape, *defect), proof=Definition(), note="∂F/∂γ at γ = 0."
)

implicit_defect = Claim(
    says=equal(defect_gamma, -_slope / Derivative(_turn(Integer(0)), epsilon)),
    given=(*shape, b < 1, *defect, S > 0),
    proof=ImplicitFunction(
        *(one_turn, epsilon, gamma, Integer(0)),
        slope=(step(-_at_end, differentiating_integral(Integer(0)), roots),),
    ),
    where=display(50),
    note="∂ε/∂γ at γ = 0, where F(ε(γ), γ) = π; the sign S is 1 there.",
)

eq_depsdgamma_form = Claim(
    says=equal(defect_gamma, -defect_F * F_gamma),
    given=(*shape, b < 1, *defect, S > 0, Ne(F_epsilon0, 0)),
    proof=by(substituting(implicit_defect, turn_symbol, slope_symbol_at_zero, inverse_of_slope)),
    where=display(50),
)

closed_form = -printed.defect_per_turn(epsilon, a, b, 1, sympy) * printed.turn_slope(
    epsilon, a, b, 1, sympy
)

closed_slope = Claim(
    says=equal(defect_gamma, closed_form),
    given=(*shape, b < 1, *defect, S > 0, Ne(F_epsilon0, 0)),
    proof=by(substituting(eq_depsdgamma_form, defect_by_turn, turn_symbol, slope_of_turn), roots),
    note="∂ε/∂γ at γ = 0, in closed form.",
)

S_drops_out = Claim(
    says=equal(
        printed.defect_per_turn(epsilon, a, b, S, sympy)
        * printed.turn_slope_asymptotic(epsilon, a, b, S, sympy),
        printed.defect_per_turn(epsilon, a, b, 1, sympy)
        * printed.turn_slope_asymptotic(epsilon, a, b, 1, sympy),
    ),
    given=(*shape, b < 1, *defect, cos(theta) ** 2 > 0),
    proof=by(substituting(flip_dynamics.sign_of_tilt), roots),
    where=line(417),
)

# -- the level at which a flip defect is reached --------------------------------------------------

_level = Symbol("c", real=True)
_on_level = printed.integrand(psi, a, b, _level, 1, sympy)
_fall = (1 - b * sin(psi) ** 2) / (
    2 * sqrt(a + b * sin(psi) ** 2) * sqrt(_level + b * sin(psi) ** 2) ** 3
)
"""−∂f/∂γ on the level."""

one_rotating_level = Claim(
    says="A flip defect, of either sign, belongs to one γ > 0 at most.",
    means=AtMostOne(_level, 0, a, equal(pi, Integral(_on_level, (psi, epsilon, pi / 2)))),
    given=(*shape, epsilon < pi / 2, 1 - b * sin(epsilon) ** 2 > 0),
    proof=Monotone(
        (step(Integral(_fall, (psi, epsilon, pi / 2)), differentiating_integral(-_fall)),)
    ),
    note="F decreases as γ, here c, increases.",
)

label_claims(globals())
