"""Beyond the paper: where ε(γ) decreases on (−b, a], and where it does not.

ε(γ) is the flip angle half a turn before the motion passes ψ = π/2. Until the motion has turned it
solves F(ε, γ) = π, and F falls in ε and in γ:

- `rotating_decrease`, `unturned_decrease`: dε/dγ = −(∂F/∂γ)/(∂F/∂ε) < 0, for γ > 0 and γ ≤ 0.

Beyond a turning point f is infinite, and the motion is followed in another variable: with

    Q = a + b sin²χ − γ cos²χ,  R = ab cos²χ − γ(b + a sin²χ),
    N = (1−b)(a−γ) cos²χ + (a+b)(1+γ) sin²χ,

all positive for γ < 0, the curve cot ψ = √((a+b)(γ+b)/R) sin χ, cos θ = √((γ+b)/(a+b)) cos χ is the
motion (`unfolded_motion`), its precession counted back from ψ = π/2 is Φ = ∫₀^χ N/(Q√R) dx, which
is F up to the turning point χ = π/2 (`unfolded_turn`), and ε(γ) is read where Φ(χ, γ) = π:

- `unfolded_decrease`: χ falls as γ rises while χ < π, and π/2 is reached by ε where it is π;
- `turned_decrease`: once the motion has turned, dε/dγ < 0 up to there;
- `beyond_right_angle`: ε > π/2 for π < χ < 2π, that is until Φ(2π, γ) = π;
- `slope_at_turns`: at the levels with χ = π/2 and 3π/2 dε/dγ is ∓1/(2√(−γ(γ+b))): ε rises again.

Φ(π, γ) rises with γ from its value π(1−b)/√(b(a+b)) at γ = −b (`phase_at_bottom`), which is at
least π exactly for b ≤ 1/(a+2), the shapes of rigid bodies: `decrease_of_bodies`.
"""

from __future__ import annotations

from typing import Any

import sympy
from flint import arb, fmpq
from sympy import (
    Derivative,
    Expr,
    Integer,
    Integral,
    Subs,
    Symbol,
    Tuple,
    acos,
    atan,
    cos,
    pi,
    sin,
    sqrt,
)
from tresym.proofs.conditions import defect, shape
from tresym.proofs.numbers_in_text import lower_exact, number, upper_exact_value
from tresym.proofs.rigid_bodies import realizable

from tresym.claims.bounds import Boxes
from tresym.claims.claim import (
    Claim,
    Definition,
    ImplicitFunction,
    all_of,
    by,
    changing_variable,
    citing,
    differentiating_integral,
    differentiation,
    equal,
    integrating,
    roots,
    step,
    substituting,
    together,
    trigonometry,
)
from tresym.claims.denial import Denied
from tresym.claims.enclosure import Bound, box
from tresym.flip.angle import Angle
from tresym.flip.defect import defect_on
from tresym.flip.levels import level_of
from tresym.flip.orbit import exact_level
from tresym.formulas import printed
from tresym.notation import a, b, epsilon, gamma, psi, x
from tresym.verdict import Verdict

c = Symbol("c", real=True)
"""A level, where γ is held."""
chi = Symbol("chi", real=True)
"""The variable in which the motion passes its turning points smoothly."""
F_epsilon, F_gamma, Phi_chi, Phi_gamma = (
    Symbol(name, real=True) for name in ("F_epsilon", "F_gamma", "Phi_chi", "Phi_gamma")
)
rotating_rate, unturned_rate, chi_rate = (
    Symbol(name, real=True) for name in ("epsilonprime_r", "epsilonprime_o", "chiprime")
)
"""dε/dγ of a rotating and of an oscillating motion that has not turned, and dχ/dγ."""

# -- until the motion turns -----------------------------------------------------------------------


def _f(level: Expr, angle: Expr = psi) -> Expr:
    return printed.integrand(angle, a, b, level, 1, sympy)


def _turn(level: Expr) -> Integral:
    """F of the motion on ``level``."""
    return Integral(_f(level), (psi, epsilon, pi / 2))


_square = sin(psi) ** 2
_fall = (1 - b * _square) / (2 * sqrt(a + b * _square) * sqrt(gamma + b * _square) ** 3)
"""−∂f/∂γ."""
_by_depth = Subs(Derivative(_turn(c), c), c, gamma)

_off_pole = 1 - b * sin(epsilon) ** 2 > 0
"""For b < 1 always so; for b = 1 the handle is not where φ loses its meaning."""
rotating = (*shape, gamma > 0, epsilon < pi / 2, _off_pole)
unturned = (*shape, gamma > -b, gamma <= 0, *defect, gamma + b * sin(epsilon) ** 2 > 0, _off_pole)
"""A motion that oscillates or tends to the unstable point, ε above its turning point."""

turn_slopes = Claim(
    label="turn_slopes",
    says=Tuple(
        equal(F_epsilon, Derivative(_turn(gamma), epsilon)),
        equal(F_gamma, _by_depth),
    ),
    given=(*shape, epsilon < pi / 2),
    proof=Definition(),
    note="∂F/∂ε and ∂F/∂γ.",
)

higher_sine = Claim(
    label="higher_sine",
    says=b * _square - b * sin(epsilon) ** 2 >= 0,
    kind="bound",
    given=(b > 0, epsilon > 0, epsilon < pi / 2, psi >= epsilon, psi <= pi / 2),
    proof=(step(Integral(2 * b * sin(x) * cos(x), (x, epsilon, psi)), integrating(b * sin(x) ** 2)),),
)

above_turning_point = Claim(
    label="above_turning_point",
    says=gamma + b * _square > 0,
    kind="bound",
    given=(*unturned, psi >= epsilon, psi <= pi / 2),
    proof=(step(gamma + b * _square, citing(higher_sine)),),
    note="From ε to π/2 the motion does not turn.",
)


def _falling(
    name: str, given: tuple[Any, ...], rate: Symbol, bounds: tuple[Claim, ...]
) -> tuple[Claim, ...]:
    """F(ε, γ) = π where ``given`` holds, both slopes of F, and dε/dγ with its sign."""
    turn = Claim(
        label=f"{name}_turn",
        says=equal(_turn(c), pi),
        given=tuple(condition.xreplace({gamma: c}) for condition in given),
        proof=Definition(),
    )
    by_defect = Claim(
        label=f"{name}_falls_in_defect",
        says=F_epsilon < 0,
        kind="bound",
        given=given,
        proof=(
            step(
                _f(gamma, epsilon),
                substituting(turn_slopes),
                differentiating_integral(Integer(0), *bounds),
            ),
        ),
    )
    cited = (citing(*bounds),) if bounds else ()
    by_depth = Claim(
        label=f"{name}_falls_in_gamma",
        says=F_gamma < 0,
        kind="bound",
        given=given,
        proof=(
            step(
                Integral(_fall, (psi, epsilon, pi / 2)),
                substituting(turn_slopes),
                differentiating_integral(-_fall, *bounds),
                *cited,
            ),
        ),
    )
    slope = Claim(
        label=f"{name}_slope",
        says=equal(rate, -_by_depth / Derivative(_turn(gamma), epsilon)),
        given=given,
        proof=ImplicitFunction(
            equation=turn,
            unknown=epsilon,
            parameter=c,
            at=gamma,
            slope=(step(-_f(gamma, epsilon), differentiating_integral(Integer(0), *bounds)),),
            bounds=bounds,
        ),
    )
    decrease = Claim(
        label=f"{name}_decrease",
        says=rate < 0,
        kind="bound",
        given=given,
        proof=(
            step(F_gamma / F_epsilon, substituting(slope, turn_slopes), citing(by_defect, by_depth)),
        ),
    )
    return turn, by_defect, by_depth, slope, decrease


rotating_claims = _falling("rotating", rotating, rotating_rate, ())
unturned_claims = _falling("unturned", unturned, unturned_rate, (above_turning_point,))
