"""Appendix: what is said between the displays, of limits and of what dominates.

- `zero_asymptotic`, `any_delta`: ε₀ → 0, as fast as e^{−π/λ};
- `dominant_exponential`: the exponent is −2π√(ab) plus a bounded term;
- `implicit_solution`: the conclusion of the implicit function theorem, on λ ≥ 0;
- `uniform_convergence`, `more_difficult`, `terms_dominant`, `remainder_constant`: the remarks on
  dε/dγ.
"""

from __future__ import annotations

from tresym.proofs import implicit_function, slope
from tresym.proofs.axioms import IMPLICIT_FUNCTION
from tresym.proofs.conditions import defect, shape
from tresym.proofs.orders import (
    bend_carries,
    d56,
    eq_epsilon_gen,
    printed_speed,
    remark1,
    u_exponentially_small,
)
from tresym.proofs.separatrix import flip_defect
from tresym.proofs.turn_integral import d53, eq_depsdgamma_form, slope_of_turn

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

decay_at_most = Claim(
    says=epsilon0 <= Rational(201, 100) * exp(-pi * sqrt(a * b)),
    given=(*shape, a * b >= Rational(1, 4)),
    proof=(
        step(
            exp(-pi * sqrt(a * b)) * (Rational(201, 100) - epsilon0 * exp(pi * sqrt(a * b))),
            *(exponentials, citing(remark1)),
        ),
    ),
)

zero_asymptotic = Claim(
    says=order(equal(epsilon0, Function("o")(Integer(1))), a * b, oo),
    given=shape,
    proof=Dominated(decay_at_most, flip_defect),
    where=line(342),
)

arcsine_by_arctangent = Claim(
    says=equal(asin(sqrt(b / (a + b))), atan(sqrt(b / a))), given=shape, proof=by(inverses, roots)
)

arctangent_below = Claim(
    says=atan(r) <= r, given=(r > 0,), proof=manifest, note="So √(ab) arctan √(b/a) ≤ b ≤ 1."
)

cosine_below_one = Claim(
    says=sqrt(b / (a + b)) - sqrt(b / (a + b)) * cos(epsilon) >= 0,
    given=(*shape, *defect),
    proof=manifest,
)

dominant_exponential = Claim(
    **jointly(arcsine_by_arctangent, arctangent_below, cosine_below_one),
    where=line(342),
    note="The two sides of the equation are equal at the root, so neither is larger there.",
)

# -- the implicit function ------------------------------------------------------------------------

implicit_solution = Claim(
    **jointly(
        implicit_function.G_at_origin,
        implicit_function.G_u_at_origin,
        implicit_function.defect_is_flat,
    ),
    where=line(368),
    note="Nothing follows for λ < 0, where e^{−1/s} is not flat. With |λ| in place "
    "of λ the equation is smooth on both sides.",
    quotes=(IMPLICIT_FUNCTION,),
)

solution_in_that_form = Claim(
    **jointly(implicit_solution, implicit_function.equ),
    where=line(369),
)

limit_of_eps0 = Claim(
    **jointly(implicit_function.small_together, u_exponentially_small, zero_asymptotic),
    where=line(370),
)

_of_the_logarithm = S * (a - b - 2 * a * b) / (4 * sqrt(a * b) ** 3)
_delta = Symbol("delta", real=True)

factor_that_vanishes = Claim(
    says=equal(exp(-pi / lam), exp(-(pi - _delta) / lam) * exp(-_delta / lam)),
    given=(lam > 0, _delta > 0),
    proof=by(exponentials),
)

any_delta = Claim(
    **jointly(decay_at_most, factor_that_vanishes, implicit_function.flat_from_above),
    where=line(370),
    note="ε₀ ≤ 2.01 e^{−π/λ}, and the factor e^{−δ/λ} tends to 0.",
)

# -- remarks on the slope -------------------------------------------------------------------------

slope_is_variation = Claim(
    **jointly(eq_depsdgamma_form, bend_carries),
    where=line(222),
    note=(
        "The slope is the derivative of ε at γ = 0; the range in which the linear formula is "
        "accurate is shown for the standard racket."
    ),
)

uniform_convergence = Claim(
    **jointly(d53),
    where=line(407),
    note=(
        "The reason given is the convergence of F; what is needed is "
        "that ∂f/∂γ is smooth on [ε₀, π/2]."
    ),
)

logarithm_stays = Claim(
    says=Equivalent(equal(_of_the_logarithm, 0), equal(a - b - 2 * a * b, 0)),
    given=(*shape, S > 0),
    proof=(step(equal(a - b - 2 * a * b, 0), multiplying(4 * sqrt(a * b) ** 3 / S), roots),),
    note="The coefficient of the logarithm in ∂F/∂γ; it vanishes only if a = b(1 + 2a).",
)

more_difficult = Claim(
    **jointly(slope.d51, slope_of_turn, logarithm_stays),
    where=line(407),
    note="Difficult is read as: needs an integration, and more than algebraic functions.",
)

terms_dominant = Claim(
    **jointly(d56),
    where=line(413),
    note="The term is −1/(4b√(ab) ε₀²), the rest by `d56` at most 0.96/(4b√(ab) ε₀).",
)

remainder_constant = Claim(
    says="With the printed slope the remainder is O(γ²): over γ² it tends to a constant.",
    where=line(426),
    amended_by=(eq_epsilon_gen,),
    note="With dε/dγ itself, it does.",
    fault=Fault.THEOREM,
    **printed_speed,
)

label_claims(globals())
