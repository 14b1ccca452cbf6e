"""Sections 6 and 7: every number in running text, and what is concluded from the numbers.

Printed inputs and outputs are intervals of half a unit in the last place. A printed value is
compared with the quantity that it is printed for. If it belongs to the asymptotic formula and not
to the exact equation, there is a claim for each interpretation.

- `d26` … `accuracy`: ε₀ of the standard racket; `d27`: the slope at the separatrix;
- `d29`: the levels at which the tolerance is reached, exactly and by the linear formula;
  `lower_level_unturned`: the integral of the appendix does not give one of them;
- `each_eps0_one_a`, `larger_ab_less_robust`, `linear_range`: conclusions drawn from the formula;
- `zero_on_separatrix`, `slow_on_separatrix`, …: conclusions drawn from the figures.
"""

from __future__ import annotations

from tresym.proofs import (
    euler_angles,
    flip_dynamics,
    model,
    monotonicity,
    orders,
    phase_portraits,
    regimes,
    separatrix,
    turn_integral,
    turning,
)
from tresym.proofs.conditions import STANDARD, defect, shape, shape_of_a_body, standard_racket
from tresym.proofs.printed import inputs, moments, number, share_of_pi

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *
from tresym.reals.numbers.exact import as_rational

chi, edge = Symbol("chi", real=True), Symbol("e", real=True)
longest_turn, one_turned_level, raised = (
    turning.longest_turn,
    turning.one_turned_level,
    turning.raised,
)
phase = turning.one_time.statement.args[3].lhs
STR = moments("str")
"""The standard racket's moments as Table 1 prints them."""
EXACTLY = (euler_angles.d08, separatrix.flip_defect, separatrix.one_flip_defect)
"""What ε₀ is, by the moments."""
BY_FORMULA = (euler_angles.d08, separatrix.leading_defect)
"""What ε₀ is by the asymptotic formula, by the moments."""

# -- ε₀ of the standard racket --------------------------------------------------------------------

eps0_str_formula = number(
    "By the asymptotic formula the standard racket has ε₀ = {}.",
    epsilon_printed,
    "0.1150",
    STR,
    *BY_FORMULA,
    where=line(252),
)
eps0_str_exact = number(
    "By the exact equation the standard racket has ε₀ = {}.",
    epsilon0,
    "0.1150",
    STR,
    *EXACTLY,
    where=line(252),
    note="The printed moments give 0.11494…; moments that round to them give 0.1150.",
)
d26 = Claim(
    kind="number",
    **jointly(eps0_str_formula, eps0_str_exact),
    where=display(26),
)
flip_str = number(
    "The standard racket flips by π(1 − {}).",
    share_of_pi(epsilon0),
    "0.073",
    inputs(epsilon0="0.1150"),
    where=line(253),
)
flip_str_exact = number(
    "By the exact equation the standard racket flips by π(1 − {}) on the separatrix.",
    share_of_pi(epsilon0),
    "0.073",
    STR,
    *EXACTLY,
    where=line(253),
)
accuracy = number(
    "For the standard racket the formula agrees with the exact equation to an accuracy of 10⁻³.",
    epsilon_printed - epsilon0,
    "0.000",
    STR,
    *(*EXACTLY, separatrix.leading_defect),
    half_units=2,
    where=line(253),
)
accuracy_relative = number(
    "The same holds relative to ε₀.",
    (epsilon_printed - epsilon0) / epsilon0,
    "0.000",
    STR,
    *(*EXACTLY, separatrix.leading_defect),
    half_units=2,
    where=line(253),
)

# -- the slope ------------------------------------------------------------------------------------

_slope = turn_integral.closed_form.xreplace({epsilon: epsilon0})
"""dε/dγ at γ = 0."""

slope_str_formula = number(
    "By the asymptotic formulas the standard racket has dε/dγ = {} at γ = 0.",
    printed.defect_slope_asymptotic(epsilon_printed, b),
    "-34.5",
    STR,
    *BY_FORMULA,
    where=line(255),
)
slope_str_exact = number(
    "The derivative itself is {}, for the standard racket.",
    _slope,
    "-35.6",
    STR,
    *(*EXACTLY, turn_integral.closed_slope),
)
slope_str_leading = number(
    "With the exact ε₀ the leading term −1/(4bε₀) is {}, for the standard racket.",
    printed.defect_slope_asymptotic(epsilon0, b),
    "-34.6",
    STR,
    *EXACTLY,
)
d27 = number(
    "For the standard racket dε/dγ = {} at γ = 0.",
    _slope,
    "-34.5",
    STR,
    *(*EXACTLY, turn_integral.closed_slope),
    where=display(27),
    expect=Verdict.REFUTED,
    amended_by=(slope_str_exact, slope_str_formula, slope_str_leading),
    note="The statement is about ε(γ) itself; the printed number is −1/(4bε₀), with ε₀ by the "
    "formula of the theorem.",
    fault=Fault.ROUNDING,
)

# -- the levels at which the tolerance is reached -------------------------------------------------

_UPPER = (*STR, equal(epsilon, -pi / 12))
_LOWER = (*inputs(I1=1210, I2=16380, I3=17480), equal(epsilon, pi / 12))

_level = 4 * b * epsilon_printed * (epsilon_printed - epsilon)
"""γ at which the linear formula gives ε."""

upper_level_linear = number(
    "By the linear formula the standard racket reaches ε = −π/12 at γ = {}.",
    _level.xreplace({epsilon: -pi / 12}),
    "1.09e-2",
    STR,
    *BY_FORMULA,
    where=line(262),
)
upper_level_exact = number(
    "The standard racket has ε = −π/12 at γ = {} in fact.",
    TheRoot(*turn_integral.one_rotating_level.statement.args),
    "1.04e-2",
    _UPPER,
    *(euler_angles.d08, turn_integral.one_rotating_level, flip_dynamics.d19),
)
upper_level = number(
    "For the standard racket ε = −π/12 at γ = {}.",
    TheRoot(*turn_integral.one_rotating_level.statement.args),
    "1.09e-2",
    _UPPER,
    *(euler_angles.d08, turn_integral.one_rotating_level, flip_dynamics.d19),
    expect=Verdict.REFUTED,
    amended_by=(upper_level_exact, upper_level_linear),
    note="The number is that of the linear formula.",
)
lower_level_linear = number(
    "By the linear formula the standard racket reaches ε = π/12 at γ = {}.",
    _level.xreplace({epsilon: pi / 12}),
    "-4.2e-3",
    STR,
    *BY_FORMULA,
    where=line(262),
)
lower_level = number(
    "The standard racket has ε = π/12 at γ = {} by a motion that starts backwards at "
    "ψ = π/12, turns, and passes π/2 after half a turn of the handle.",
    TheRoot(*one_turned_level.statement.args),
    "-4.2e-3",
    _LOWER,
    *(euler_angles.d08, one_turned_level, flip_dynamics.d19),
    where=line(262),
    note=(
        "Below γ* = −0.00348 the sign S changes during the motion, "
        "which the integral F does not take into account."
    ),
)

_ends = (
    *((a, "12.5371", "12.5372"), (b, "0.062929", "0.06293")),
    (edge, "0.261799", "0.2618"),
)
_near_standard = tuple(
    f(x, Rational(end)) for x, *two in _ends for f, end in zip((Ge, Le), two, strict=True)
)
_standard = {**dict(each.args for each in standard_racket), edge: pi / 12}

standard_is_near = Claim(
    says=Tuple(*(e.func(at(e.lhs, {e.lhs: _standard[e.lhs]}), e.rhs) for e in _near_standard)),
    proof=by(evaluating),
    note="The standard racket and ε = π/12 lie between these ends.",
)

longest_unturned = Claim(
    says=phase.xreplace({chi: pi / 2, gamma: -b * sin(edge) ** 2}) < Rational("3.0373"),
    given=_near_standard,
    proof=Evaluated(),
    note=(
        "F(π/12, γ) at the smallest γ with which ψ = π/12 is "
        "reached; there it is the turning point, reached at χ = π/2."
    ),
)

lower_level_unturned = Claim(
    says="By F(ε, γ) = π, as the appendix has it, no γ gives the standard racket ε = π/12: "
    "F(π/12, γ) stays below 3.0373 for every γ > −b sin²(π/12).",
    kind="bound",
    means=longest_turn.says.lhs < Rational("3.0373"),
    given=(*raised, *_near_standard),
    proof=Decided(cited=(longest_turn, longest_unturned)),
    note="With γ = d − b sin²e, d > 0; a, b and e = π/12 are in range: `standard_is_near`.",
)
d29 = Claim(
    kind="number",
    **jointly(upper_level, lower_level),
    where=display(29),
    amended_by=(
        upper_level_exact,
        lower_level,
        lower_level_unturned,
        upper_level_linear,
        lower_level_linear,
    ),
    note=(
        "As in d27 the statement is about ε(γ) itself; the printed "
        "numbers are those of the linear formula."
    ),
    fault=Fault.ROUNDING,
)
lower_level_exists = number(
    "At ψ = π/12 no motion has γ + b sin²ψ < 0: γ ≥ −b sin²(π/12) = {}.",
    -b * sin(pi / 12) ** 2,
    "-4.22e-3",
    moments("str", "I2", "I3"),
    euler_angles.d08,
)
threshold_impossible = Claim(
    says="At the γ of the linear formula for ε = π/12, with all its digits, a motion passes "
    "ψ = π/12.",
    paper_says="“γ|_{ε = π/12} = −4.2 × 10^{−3}.” Read as: by the formula, to the digits that are "
    "printed.",
    kind="bound",
    means=Ge(_level.xreplace({epsilon: pi / 12}) + b * sin(pi / 12) ** 2, 0, evaluate=False),
    given=shape,
    proof=Counterexample(STANDARD, (separatrix.leading_defect,)),
    where=line(262),
    amended_by=(lower_level_exists, lower_level_unturned, lower_level),
    note="For the standard racket it lies below the least γ with which ψ = π/12 can be reached.",
)

# -- what the formula is said to show -------------------------------------------------------------

_a1, _b1, _a2, _b2 = (Symbol(name, real=True) for name in ("a1", "b1", "a2", "b2"))
_defect = TheRoot(*separatrix.defect_is_one.statement.args)
"""ε₀, where it is asked for of several shapes."""
_LESS = (_a1 > 0, _b1 > 0, _b1 <= 1, _a2 > 0, _b2 > 0, _b2 <= 1, _a1 * _b1 <= _a2 * _b2)
"""Two shapes, the first with the smaller product."""


def _of_both(e: Expr) -> tuple[Basic, Basic]:
    """``e`` of the first shape and of the second."""
    return at(e, {a: _a1, b: _b1}), at(e, {a: _a2, b: _b2})


def _shapes(*numbers: str) -> dict[str, fmpq]:
    return dict(zip(("a1", "b1", "a2", "b2"), map(as_rational, numbers), strict=True))


larger_ab_smaller_eps0 = Claim(
    says="The larger the product ab is, the smaller ε₀ is.",
    kind="bound",
    means=Ge(*_of_both(_defect), evaluate=False),
    given=_LESS,
    proof=Counterexample(_shapes("1", "3/10", "10", "31/1000"), (separatrix.defect_is_one,)),
    where=line(251),
    amended_by=(monotonicity.monotonicity,),
    note="The statement is true at fixed a and at fixed b. Both shapes of the counterexample "
    "are those of rigid bodies.",
)

formula_shows_larger_ab = Claim(
    says="The larger the product ab is, the smaller ε₀ is, by the formula.",
    means=printed.asymptotic_defect(_a1, _b1, sympy) >= printed.asymptotic_defect(_a2, _b2, sympy),
    kind="bound",
    given=_LESS,
    proof=Counterexample(_shapes("1", "3/10", "10", "31/1000")),
    where=line(251),
    amended_by=(monotonicity.monotonicity,),
    note="The statement is true at fixed a and at fixed b. Both shapes of the counterexample "
    "are those of rigid bodies.",
)

robustness_at_fixed_b = Claim(
    says=StrictlyIncreasing(1 / (4 * b * epsilon0), a),
    given=shape,
    proof=MonotoneOf(monotonicity.monotonicity, (separatrix.flip_defect,)),
    note="At fixed b the slope −1/(4bε₀) is the steeper the larger a is.",
)

larger_ab_less_robust = Claim(
    says="The larger the product ab is, the less robust is the effect: |dε/dγ| at γ = 0 is larger.",
    kind="bound",
    means=Le(*_of_both(-turn_integral.closed_form.xreplace({epsilon: _defect})), evaluate=False),
    given=_LESS,
    proof=Counterexample(_shapes("1", "1/100", "1", "3/10"), (separatrix.defect_is_one,)),
    where=line(254),
    amended_by=(robustness_at_fixed_b,),
)

sensitive_if_small = Claim(
    says=Ge(1 / (4 * b * epsilon0), 1 / (4 * epsilon0), evaluate=False),
    given=(b > 0, b <= 1, epsilon0 > 0),
    proof=manifest,
    where=line(254),
    note="The second term grows without bound as ε₀ → 0.",
)

_three = tuple(Symbol(f"a{n}", real=True) for n in (1, 2, 3))
_at_tenth = [printed.asymptotic_defect(s, Rational(1, 10), sympy) for s in _three]

each_eps0_one_a = Claim(
    says="By the theorem's formula with b = 0.1 each ε₀ belongs to one a: the formula is monotone.",
    given=(_three[0] > 0, _three[1] - _three[0] > 0, _three[2] - _three[1] > 0),
    means=Ge((_at_tenth[1] - _at_tenth[0]) * (_at_tenth[2] - _at_tenth[1]), 0, evaluate=False),
    proof=Counterexample({"a1": fmpq(1, 1000), "a2": fmpq(1), "a3": fmpq(10)}),
    where=line(263),
    amended_by=(monotonicity.monotonicity,),
    note=(
        "A continuous function that increases and decreases takes "
        "some values twice, here 1/5 between the points."
    ),
)

_linear = printed.linear_defect(epsilon0, b, gamma)

fig_roban = Claim(
    says=Equivalent(equal(_linear, 0), equal(gamma, 4 * b * epsilon0**2)),
    given=(b > 0, epsilon0 > 0),
    proof=(
        step(
            equal(gamma, 4 * b * epsilon0**2),
            multiplying(-4 * b * epsilon0),
            adding(4 * b * epsilon0**2),
        ),
    ),
    where=line(267),
    note="The line of exact flips by the linear formula.",
)

fig_psiphi = Claim(
    **jointly(
        regimes.three_regimes, phase_portraits.sign_constant_rotating, phase_portraits.eq_borne_psi
    ),
    where=line(281),
)

_upper, _lower = 4 * b * epsilon0 * (epsilon0 + pi / 12), 4 * b * epsilon0 * (epsilon0 - pi / 12)

linear_range = Claim(
    says=equal(_upper - _lower, 2 * pi / 3 * b * epsilon0),
    proof=by(),
    where=line(269),
    note="The range of γ with a flip within the tolerance; it grows with ε₀ at fixed b.",
)
linear_range_ends = Claim(
    says=Tuple(
        equal(at(_linear, {gamma: _upper}), -pi / 12), equal(at(_linear, {gamma: _lower}), pi / 12)
    ),
    given=(b > 0, epsilon0 > 0),
    proof=by(evaluating),
    note="In the linear formula the tolerance is reached at γ = 4bε₀(ε₀ ± π/12).",
)
close_to_separatrix = Claim(
    **jointly(linear_range, linear_range_ends),
    where=line(269),
)

# -- Section 7 ------------------------------------------------------------------------------------

_rate = printed.psi_rate(psi, a, b, gamma, S, sympy)

angular_velocity_of_the_handle = Claim(
    says=equal(W1, dphi_dt * (dpsi_dphi + cos(theta))),
    given=(dphi_dt > 0,),
    proof=by(substituting(model.angular_velocity, euler_angles.elimination_of_time)),
)

initial_rate_is_angular_velocity = Claim(
    says="dψ/dφ is the angular velocity along the handle, counted in units of dφ/dt.",
    given=(dphi_dt > 0, cos(theta) > 0),
    means=equal(dphi_dt * cos(theta) + dpsi_dt, dpsi_dt),
    proof=Counterexample({"theta": fmpq(1), "dphi_dt": fmpq(1), "dpsi_dt": fmpq(1)}),
    where=line(283),
    amended_by=(angular_velocity_of_the_handle,),
    note="The precession contributes cos θ.",
)

unstable_rotation_characterized = Claim(
    says=Gt((a + b * sin(psi) ** 2) / (1 - b * sin(psi) ** 2), 0, evaluate=False),
    given=shape_of_a_body,
    proof=manifest,
    where=line(283),
    note="The factor of cos θ in dψ/dφ: the rate is 0 only at θ = π/2, where M is along e₂ if ψ is "
    "a multiple of π.",
)

fig_rob = Claim(
    says=Tuple(
        equal(at(_rate, {psi: -psi, S: -S}), -_rate), equal(at(_rate, {psi: psi + pi}), _rate)
    ),
    given=(*shape_of_a_body, gamma + b * sin(psi) ** 2 > 0),
    proof=by(evaluating, trigonometry),
    where=line(283),
    note=(
        "(ψ, dψ/dφ) → (−ψ, −dψ/dφ) maps motions to motions and Δψ to "
        "−Δψ; the same holds about every multiple of π."
    ),
    shown=r"V(-\psi, -S) = -V(\psi, S),\quad V(\psi+\pi, S) = V(\psi, S),\quad "
    r"V = \frac{d\psi}{d\phi}",
)

zero_on_separatrix = Claim(
    says="On the separatrix the flip in one turn is approximately zero.",
    means=Le(pi - 2 * epsilon, pi / 2),
    given=(*shape, *defect[:2], printed.separatrix_residual(epsilon, a, b, sympy) > 0),
    proof=Counterexample({**STANDARD, "epsilon": fmpq(1, 5)}),
    where=line(284),
    amended_by=(flip_str_exact,),
    note="From ψ₀ = ε₀ it is π − 2ε₀, more than π − 2ε for ε above ε₀; and no quarter turn is near "
    "zero. It is small only for starts at an unstable point or running into one.",
)

rate_at_the_top = number(
    "Half way on the separatrix the standard racket has dψ/dφ = {}.",
    sqrt(b) * sqrt(a + b) / (1 - b),
    "0.950",
    STR,
    euler_angles.d08,
)

slow_on_separatrix = Claim(
    says="Everywhere on the separatrix |dψ/dφ| ≤ 1/2 for the standard racket.",
    paper_says="“the time evolution of ψ on this line is very slow.” Read as: near the unstable "
    "points; how slow is not said.",
    means=Le(
        Abs(printed.psi_rate(psi, Rational(1517, 121), Rational(55, 874), 0, 1, sympy)),
        Rational(1, 2),
        evaluate=False,
    ),
    given=(Gt(psi, 0), Lt(psi, pi)),
    proof=Counterexample({"psi": fmpq(3, 2)}),
    where=line(284),
    amended_by=(rate_at_the_top,),
    note="The motion is slow only near the unstable points.",
)

separatrix_curve = Claim(
    says=equal(
        printed.psi_rate(psi, a, b, 0, S, sympy) ** 2,
        b * sin(psi) ** 2 * (a + b * sin(psi) ** 2) / (1 - b * sin(psi) ** 2) ** 2,
    ),
    given=(*shape_of_a_body, cos(theta) ** 2 > 0),
    proof=by(substituting(flip_dynamics.sign_of_tilt), roots),
    where=line(288),
    note="The dotted line of the contour plot.",
)

tre_if_eps0_small = Claim(
    says=Tuple(Ge(pi - 2 * epsilon0, 5 * pi / 6), Le(pi - 2 * epsilon0, 7 * pi / 6)),
    given=(*shape, epsilon0 <= pi / 12),
    proof=by(citing(separatrix.flip_defect)),
    where=line(291),
)

nearly_hyperbolic = Claim(
    says=Tuple(
        sqrt(a * b) > log(Rational(13, 25) / epsilon0) / pi,
        sqrt(a * b) < log(Rational(201, 100) / epsilon0) / pi,
        Lt(log(Rational(201, 52)) / pi, Rational("0.4305"), evaluate=False),
    ),
    given=(*shape, a * b >= Rational(1, 4)),
    proof=together(
        (
            step(
                log(epsilon0 * exp(pi * sqrt(a * b)) * 25 / 13) / pi,
                exponentials,
                citing(orders.remark1, separatrix.flip_defect),
            ),
        ),
        (
            step(
                -log(epsilon0 * exp(pi * sqrt(a * b)) * 100 / 201) / pi,
                exponentials,
                citing(orders.remark1, separatrix.flip_defect),
            ),
        ),
        manifest,
    ),
    where=line(291),
    note="On a level curve of ε₀ with ab ≥ 1/4, √(ab) stays within an interval of length 0.4305.",
)

hyperbolic_levels = Claim(
    says="The level curves of ε₀ are the hyperbolas ab = const.",
    paper_says="“Note the hyperbolic shape of the ε₀- level curves.” Read as: nearly ab = const.",
    kind="bound",
    means=equal(at(_defect, {a: _a1, b: _b1}), at(_defect, {a: _a2, b: _a1 * _b1 / _a2})),
    given=(_a1 > 0, _b1 > 0, _b1 <= 1, _a2 > 0, _a1 * _b1 <= _a2),
    proof=Counterexample(
        {"a1": fmpq(1), "b1": fmpq(3, 10), "a2": fmpq(10)}, (separatrix.defect_is_one,)
    ),
    where=line(291),
    amended_by=(nearly_hyperbolic, monotonicity.monotonicity),
    note="The level curves decrease, as hyperbolas do, since ε₀ decreases with a and with b.",
)

flip_of_no_flip = number(
    "A body can have ε₀ = {}, beyond π/12: a = 1, b = 1/100.",
    epsilon0,
    "1.2573",
    inputs(a=1, b=Rational(1, 100)),
    *(separatrix.flip_defect, separatrix.one_flip_defect),
    where=line(318),
    note="Hence the effect needs constraints on the moments, as the conclusion of the paper says.",
)

label_claims(globals())
