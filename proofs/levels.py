"""Beyond the paper: where ε(γ) decreases on (−b, a], and where it does not.

ε(γ) is the flip angle half a turn before the motion passes ψ = π/2. Until the motion has reached a
turning point, it solves F(ε, γ) = π. F decreases in ε, since ∂F/∂ε = −f, and in γ, since f does, so
ε decreases in γ:

- `rotating_decrease`, `unturned_decrease`: −dε/dγ = (∂F/∂γ)/(∂F/∂ε) > 0, for γ > 0 with ε < π/2
  and for 0 < ε < π/2 with γ > −b sin²ε.

Together with the results of `turning` on motions beyond their turning points:

- `decrease_in_gamma`: ε decreases strictly on [γ°, a], where ε(γ°) = π/2 and Φ(π, γ°) = π;
- `one_level`: a value below π/2 is taken at exactly one level above the one with Φ(2π, γ) = π, the
  largest of all levels that have it;
- `decrease_of_bodies`: no γ° exists if and only if b ≤ 1/(a+2), and only then is ε monotone;
- `always_decreasing`: for other shapes ε is not monotone; `up_and_down` is an example.
"""

from __future__ import annotations

from typing import Any

from tresym.proofs import euler_angles, flip_dynamics, rigid_bodies, turn_integral
from tresym.proofs.conditions import shape
from tresym.proofs.numbers_in_text import lower_level, upper_level_exact
from tresym.proofs.printed import moments, number
from tresym.proofs.turning import (
    beyond_right_angle,
    body_stays_below,
    c,
    flip_defect_on_level,
    near_right_angle,
    one_time,
    one_turned_level,
    others_do_not,
    phase_at_bottom,
    phase_rises_in_gamma,
    slope_at_turns,
    turned_decrease,
    unfolded_decrease,
    unfolded_motion,
    unfolded_turn,
)

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

rotating_rate, unturned_rate = (
    Symbol(name, real=True) for name in ("epsilonprime_r", "epsilonprime_o")
)
"""dε/dγ of a rotating and of an oscillating motion that has not turned."""

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
_angles = (epsilon > 0, epsilon < pi / 2)
rotating = (*shape, gamma > 0, epsilon < pi / 2, _off_pole)
unturned = (*shape, *_angles, gamma + b * sin(epsilon) ** 2 > 0, _off_pole)
"""A motion of either kind, where ε is above the turning point that it has for γ < 0."""


def _at(level: Expr, given: tuple[Any, ...]) -> tuple[Any, ...]:
    """The conditions for the motion on ``level``."""
    return tuple(condition.xreplace({gamma: level}) for condition in given)


def _falling(name: str, given: tuple[Any, ...], rate: Symbol) -> tuple[Claim, ...]:
    """F(ε, γ) = π where ``given`` holds, and dε/dγ = −(∂F/∂γ)/(∂F/∂ε) with its sign."""
    turn = Claim(
        label=f"{name}_turn",
        says=equal(_turn(c), pi),
        given=_at(c, given),
        proof=Definition("half a turn of the handle from epsilon to the middle"),
    )
    by_end = differentiating_integral(Integer(0))
    slope = Claim(
        label=f"{name}_slope",
        says=equal(rate, -_by_depth / Derivative(_turn(gamma), epsilon)),
        given=given,
        proof=ImplicitFunction(turn, epsilon, c, gamma, (step(-_f(gamma, epsilon), by_end),)),
    )
    decrease = Claim(
        label=f"{name}_decrease",
        says=rate < 0,
        given=given,
        proof=(
            step(
                Integral(_fall, (psi, epsilon, pi / 2)) / _f(gamma, epsilon),
                substituting(slope),
                *(differentiating_integral(-_fall), by_end, roots),
            ),
        ),
    )
    return turn, slope, decrease


rotating_claims = _falling("rotating", rotating, rotating_rate)
unturned_claims = _falling("unturned", unturned, unturned_rate)

# -- what this says of ε(γ) -----------------------------------------------------------------------

decrease_in_gamma = Claim(
    says="For a > 0 and 0 < b ≤ 1, ε(γ) decreases strictly up to γ = a, from the level with "
    "Φ(π, γ) = π where it is π/2, or from −b if there is none.",
    proof=in_words(
        rotating_claims[-1],
        unturned_claims[-1],
        unfolded_motion,
        unfolded_turn,
        unfolded_decrease,
        turned_decrease,
    ),
    note="At γ = 0 the second of these holds, and where the motion begins to turn, χ = π/2, the "
    "last, on both sides, as Φ is F up to there. For b = 1, which no body has, it is vertical "
    "where the handle passes a pole.",
)

one_level = Claim(
    **jointly(
        turn_integral.one_rotating_level, one_turned_level, phase_rises_in_gamma, beyond_right_angle
    ),
    note="Φ(2π, γ) = 2Φ(π, γ), so these γ are exactly those above one level.",
)

decrease_of_bodies = Claim(
    says="ε(γ) decreases strictly on all of (−b, a] for b ≤ 1/(a+2), that is for every rigid "
    "body; for every other shape Φ(π, γ) < π near γ = −b.",
    proof=in_words(
        decrease_in_gamma,
        phase_rises_in_gamma,
        phase_at_bottom,
        body_stays_below,
        rigid_bodies.realizable,
        others_do_not,
        beyond_right_angle,
        near_right_angle,
    ),
    note="If Φ(π, γ) < π near −b, ε first exceeds π/2, its limit at −b, before it decreases.",
)


def _on(level: str) -> Subs:
    """ε on a level."""
    return at(flip_defect_on_level, {gamma: Rational(level)})


up_and_down = Claim(
    says="At a = 10 and b = 1/2 the defect ε(γ) rises from γ = −7/15 to −19/60, falls to −3/20, "
    "and rises to −1/60.",
    means=Tuple(
        *(_on(low) < _on(high) for low, high in (("-7/15", "-19/60"), ("-3/20", "-19/60"))),
        _on("-3/20") < _on("-1/60"),
    ),
    given=(equal(a, 10), equal(b, Rational(1, 2))),
    proof=Evaluated((one_time,)),
    note="ε(γ) takes the value ε(−19/60) at least twice more, once above −3/20 and once below "
    "−7/15.",
)

always_decreasing = Claim(
    says="ε(γ) decreases on all of (−b, a], whatever the shape.",
    means=Le(parts_of(slope_at_turns.says)[1].args[0], 0, evaluate=False),
    given=slope_at_turns.given,
    proof=formally(slope_at_turns),
    expect=Verdict.REFUTED,
    amended_by=(decrease_in_gamma, decrease_of_bodies, up_and_down),
    note=(
        "ε(γ) increases at every level with χ = 3π/2, 7π/2, …: the formula is dε/dγ at the "
        "first of these levels."
    ),
)

perfect_level = number(
    "The standard racket flips perfectly, ε = 0, at γ = {}.",
    TheRoot(*turn_integral.one_rotating_level.statement.args),
    "3.20e-3",
    (*moments("str"), equal(epsilon, 0)),
    *(euler_angles.d08, turn_integral.one_rotating_level, flip_dynamics.d19),
)

standard_is_a_body = Claim(
    says=at(1 - b * (a + 2), {a: Rational(1517, 121), b: Rational(55, 874)}) > 0,
    proof=by(evaluating),
    note="The standard racket.",
)

levels_of_the_thresholds = Claim(
    **jointly(
        lower_level,
        perfect_level,
        upper_level_exact,
        turn_integral.one_rotating_level,
        one_turned_level,
    ),
)

label_claims(globals())
