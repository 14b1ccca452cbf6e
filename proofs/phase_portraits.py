"""Section 5, continued: the phase portraits of ψ and of θ.

- `sign_constant_rotating`, `turning_points`: where dψ/dφ may change its sign;
- display (14), `eq_borne_psi`: the flip stays between ψ_min and ψ_max, defined by `flip_bounds`;
  `flip_between`: no ψ outside this interval occurs for this γ;
- `linear_at_e2`, `linear_at_e3`: the planar system linearised at its equilibria;
- `width_of_flip`, `width_of_pendulum`: the amplitudes of the oscillations;
- (15), `d15`, and (16), `eq_dthetadphi`: the equation of the tilt, with S₂ the sign of
  sin ψ cos ψ;
- (17), `eq_borne_theta`: the tilt stays between θ_min and θ_max, defined by `tilt_bounds_rotating`
  and `tilt_bounds_oscillating`.
"""

from tresym.proofs import euler_angles, flip_dynamics, regimes, stability
from tresym.proofs.axioms import MOTION
from tresym.proofs.conditions import ordered_moments, shape_of_a_body, tilted

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

planar_variables = Tuple(theta, psi)
planar_rates = Tuple(*printed.planar_rates(theta, psi, a, b, sympy))
"""The planar system: its variables, and their rates by φ."""
rotating, oscillating = regimes.rotating, regimes.oscillating

_sine = sin(psi) ** 2
_body = (*ordered_moments, *shape_of_a_body)

sign_constant_rotating = Claim(
    says=dpsi_dphi * cos(theta) > 0,
    given=(*_body, *tilted, cos(theta) ** 2 > 0),
    proof=by(substituting(euler_angles.eq_Euler)),
    where=line(160),
    note="dψ/dφ has the sign of cos θ, which for γ > 0 never vanishes.",
)

second_equation_enough = Claim(
    **jointly(euler_angles.gamma_conserved, flip_dynamics.eq_dpsidphi),
    where=line(143),
)

_flow = printed.planar_rates(theta, psi, a, b, sympy)
_turning = sum(
    Derivative(_flow[1], angle) * rate for angle, rate in zip((theta, psi), _flow, strict=True)
)

turning_points = Claim(
    says=equal(
        at(_turning, {theta: pi / 2}),
        b * (a + b * _sine) * sin(psi) * cos(psi) / (1 - b * _sine) ** 2,
    ),
    given=shape_of_a_body,
    proof=by(differentiation, trigonometry),
    note="d²ψ/dφ² where dψ/dφ = 0: not zero off the equilibria, so dψ/dφ changes its sign there.",
    shown=r"\left.\frac{d^2\psi}{d\phi^2}\right|_{\theta=\pi/2} = "
    r"\frac{b(a+b\sin^2\psi)\sin\psi\cos\psi}{(1-b\sin^2\psi)^2}",
)

sign_changes_oscillating = Claim(
    **jointly(
        sign_constant_rotating, turning_points, regimes.tilt_by_flip, regimes.psi_half_oscillating
    ),
    where=line(160),
    quotes=(MOTION,),
)

positive_beyond = Claim(
    says=equal(gamma + b * _sine, b * (_sine - Abs(gamma) / b)),
    given=(b > 0, gamma < 0),
    proof=by(roots),
    note="Positive exactly where sin²ψ > |γ|/b, and zero at the extremes.",
)

positive_only_if = Claim(
    says="γ + b sin²ψ is positive only if sin²ψ = |γ|/b.",
    given=(*oscillating, gamma + b * _sine > 0),
    means=equal(_sine, Abs(gamma) / b),
    proof=Counterexample({"b": fmpq(1, 2), "a": fmpq(1), "gamma": fmpq(-1, 8), "psi": fmpq(1)}),
    where=line(160),
    amended_by=(positive_beyond,),
    note="At the printed extreme values of ψ the argument of the root vanishes; it is positive "
    "where sin²ψ > |γ|/b. The extreme values are correct.",
    fault=Fault.MISPRINT,
)

flip_bounds = Claim(
    says=equations((psi_min, psi_max), printed.psi_bounds(b, gamma, sympy)),
    given=oscillating,
    proof=Definition(),
    where=display(14),
)

flip_between = Claim(
    says=equal(gamma + b * _sine, b * sin(psi - psi_min) * sin(psi_max - psi)),
    given=oscillating,
    proof=by(substituting(flip_bounds), trigonometry, inverses, roots),
    note="For ψ in [0, π] this is positive exactly between ψ_min and ψ_max, and zero at both.",
)

eq_borne_psi = Claim(
    **jointly(flip_bounds, flip_between, regimes.tilt_by_flip, turning_points),
    where=display(14),
    note="An oscillating motion with −π < ψ < 0 stays between −ψ_max and −ψ_min.",
    quotes=(MOTION,),
)

each_oscillating_trajectory = Claim(
    says="Each oscillating motion, with −π < ψ < 0 too, has ψ between arcsin √(|γ|/b) and "
    "π − arcsin √(|γ|/b).",
    paper_says="“each oscillating trajectory is bounded by: ψ_min = arcsin √(|γ|/b), ψ_max = π − "
    "arcsin √(|γ|/b).” Read as: each with 0 < ψ < π; the others are mirror images.",
    given=(*oscillating, psi > -pi, psi < pi, gamma + b * _sine > 0),
    means=Tuple(psi >= asin(sqrt(Abs(gamma) / b)), psi <= pi - asin(sqrt(Abs(gamma) / b))),
    proof=Counterexample({"b": fmpq(1, 2), "a": fmpq(1), "gamma": fmpq(-1, 8), "psi": fmpq(-3, 2)}),
    where=line(160),
    amended_by=(eq_borne_psi,),
    note="The bounds hold for ψ or for −ψ: one half of the oscillating motions are mirror "
    "images of the other half.",
)

eigenvalue = Symbol("eigenvalue", real=True)


def _characteristic(flip: sympy.Expr) -> sympy.Expr:
    """The characteristic polynomial of the planar system at θ = π/2 and the given ψ."""
    here = {theta: pi / 2, psi: flip}
    (p, q), (r, s) = (
        [
            at(Derivative(rate.subs(other, here[other]), angle), {angle: here[angle]})
            for angle, other in ((theta, psi), (psi, theta))
        ]
        for rate in _flow
    )
    return eigenvalue**2 - (p + s) * eigenvalue + p * s - q * r


linear_at_e2 = Claim(
    says=equal(_characteristic(Integer(0)), eigenvalue**2 - a * b),
    given=shape_of_a_body,
    proof=by(differentiation, trigonometry),
    note="Eigenvalues ±√(ab): a saddle.",
    shown=r"\det(\lambda-A) = \lambda^2-ab,\quad A = "
    r"\left.\frac{\partial(\theta', \psi')}{\partial(\theta, \psi)}\right|_{\theta=\pi/2,\,\psi=0}",
)

linear_at_e3 = Claim(
    says=equal(_characteristic(pi / 2), eigenvalue**2 + b * (a + b) / (1 - b) ** 2),
    given=shape_of_a_body,
    proof=by(differentiation, trigonometry),
    note="Eigenvalues ±i√(b(a + b))/(1 − b): a centre.",
    shown=r"\det(\lambda-A) = \lambda^2+\frac{b(a+b)}{(1-b)^2},\quad "
    r"A = \left.\frac{\partial(\theta', \psi')}{\partial(\theta, \psi)}\right|_{\theta=\psi=\pi/2}",
)

rest_points = Claim(
    says=Tuple(
        *(
            equal(at(rate, {theta: pi / 2, psi: flip}), 0)
            for flip in (Integer(0), pi / 2, pi)
            for rate in _flow
        )
    ),
    given=shape_of_a_body,
    proof=by(evaluating, trigonometry),
    where=line(179),
    note=(
        "The planar system is in equilibrium at θ = π/2 with ψ = 0, "
        "π/2 or π. In the phase portrait of θ all of them are the single point (π/2, 0)."
    ),
    shown=r"V\left(\tfrac{\pi}{2}, 0\right) = V\left(\tfrac{\pi}{2}, \tfrac{\pi}{2}\right) = "
    r"V\left(\tfrac{\pi}{2}, \pi\right) = 0,\quad "
    r"V = \left(\frac{d\theta}{d\phi}, \frac{d\psi}{d\phi}\right)",
)

momentum_at_rest = Claim(
    says=Tuple(
        *(
            equal(at(component, {theta: pi / 2, psi: flip}), value)
            for flip, direction in ((0, (0, -M, 0)), (pi, (0, M, 0)), (pi / 2, (0, 0, M)))
            for component, value in zip(
                printed.momentum(theta, psi, M, sympy), direction, strict=True
            )
        )
    ),
    proof=by(evaluating, trigonometry),
    shown=r"(M_1, M_2, M_3)\left(\tfrac{\pi}{2}, 0\right) = (0, -M, 0),\quad "
    r"(M_1, M_2, M_3)\left(\tfrac{\pi}{2}, \pi\right) = (0, M, 0),\quad "
    r"(M_1, M_2, M_3)\left(\tfrac{\pi}{2}, \tfrac{\pi}{2}\right) = (0, 0, M)",
)

equilibria_phase_portrait = Claim(
    says=Tuple(
        StableEquilibrium(planar_variables, planar_rates, Tuple(pi / 2, pi / 2)),
        *(
            UnstableEquilibrium(planar_variables, planar_rates, Tuple(pi / 2, flip))
            for flip in (Integer(0), pi)
        ),
    ),
    given=shape_of_a_body,
    proof=follows(
        Lyapunov(b + printed.depth(theta, psi, a, b, sympy)), *(Growing(sqrt(a * b)),) * 2
    ),
    where=line(159),
    note=(
        "γ, which is conserved, has its smallest value at ψ = θ = "
        "π/2, and only there modulo π: stable. At ψ = 0 M is along "
        "e₂, and leaves it while φ grows: unstable."
    ),
)

correspond_e3_e2 = Claim(
    **jointly(momentum_at_rest, stability.stable_e3, stability.unstable_e2),
    where=line(160),
)

unstable_on_separatrix = Claim(
    says=Tuple(
        *(
            equal(at(printed.depth(theta, psi, a, b, sympy), {theta: pi / 2, psi: flip}), 0)
            for flip in (Integer(0), pi)
        )
    ),
    proof=by(evaluating, trigonometry),
    note="γ = 0 at the two unstable points.",
)

fig_ph_portrait = Claim(
    **jointly(
        regimes.three_regimes, unstable_on_separatrix, momentum_at_rest, equilibria_phase_portrait
    ),
    where=line(157),
)

width_of_flip = Claim(
    says=(pi - asin(sqrt(-gamma / b))) - asin(sqrt(-gamma / b)) < pi,
    given=oscillating,
    proof=manifest,
    where=line(164),
    note="The distance of the turning points; it is below π and tends to π as γ tends to 0.",
)

_lift = Symbol("h", real=True)

width_of_pendulum = Claim(
    says=2 * acos(-_lift) < 2 * pi,
    given=(_lift > -1, _lift < 1),
    proof=manifest,
    note="A pendulum with energy v²/2 − cos q = h turns at q = ±arccos(−h).",
)

amplitude_pi = Claim(
    **jointly(width_of_flip, width_of_pendulum),
    where=line(164),
    note=(
        "The full width, which is twice what is often called the "
        "amplitude; neither bound is attained."
    ),
)

_swing, _speed = Symbol("q", real=True), Symbol("v", real=True)
_pendulum = (_speed, -sin(_swing))
"""Rates of the angle and of the speed of a pendulum."""


def _linear_pendulum(rest: sympy.Expr) -> sympy.Expr:
    """The characteristic polynomial of a pendulum at rest at the angle ``rest``."""
    (p, q), (r, s) = (
        (at(Derivative(rate.subs(_speed, 0), _swing), {_swing: rest}), Derivative(rate, _speed))
        for rate in _pendulum
    )
    return eigenvalue**2 - (p + s) * eigenvalue + p * s - q * r


linear_pendulum = Claim(
    says=Tuple(
        equal(_linear_pendulum(Integer(0)), eigenvalue**2 + 1),
        equal(_linear_pendulum(pi), eigenvalue**2 - 1),
    ),
    proof=by(differentiation, trigonometry),
    note="A centre at the bottom and a saddle at the top, in every period of 2π.",
    shown=r"\ddot q = -\sin q:\quad \det(\lambda-A)|_{q=0} = \lambda^2+1,\quad "
    r"\det(\lambda-A)|_{q=\pi} = \lambda^2-1",
)

similar_to_a_pendulum = Claim(
    **jointly(
        linear_at_e2,
        linear_at_e3,
        linear_pendulum,
        unstable_on_separatrix,
        regimes.depth_at_e3,
        regimes.symmetry_half,
        regimes.three_regimes,
    ),
    where=line(164),
)

separatrix_moves = Claim(
    says=printed.psi_rate(psi, a, b, 0, 1, sympy) ** 2 > 0,
    given=(*shape_of_a_body, sin(psi) ** 2 > 0),
    proof=manifest,
)

heteroclinic_pi = Claim(
    **jointly(unstable_on_separatrix, separatrix_moves, sign_constant_rotating),
    where=line(164),
    note="On γ = 0 there is no equilibrium between ψ = 0 and ψ = π. With S = −1 it is Δψ = −π.",
    quotes=(MOTION,),
)

sign_of_product = Claim(
    says=equal(S2, sin(psi) * cos(psi) / Abs(sin(psi) * cos(psi))),
    given=((sin(psi) * cos(psi)) ** 2 > 0,),
    proof=Definition(),
)

_square = cos(theta) ** 2
_argument = (gamma + b - (a + b) * _square) * (a * _square - gamma)

root_argument = Claim(
    says=equal(_argument, b**2 * sin(theta) ** 4 * (sin(psi) * cos(psi)) ** 2),
    given=_body,
    proof=by(substituting(euler_angles.eq_gamma), trigonometry),
    where=line(179),
    note="So the argument of the root is never negative.",
)

_off_axes = (*_body, *tilted, sin(psi) ** 2 * cos(psi) ** 2 > 0, (sin(psi) * cos(psi)) ** 2 > 0)

d15 = Claim(
    says=equal(sin(psi) * cos(psi), printed.sin_psi_cos_psi(theta, a, b, gamma, S2, sympy)),
    given=_off_axes,
    proof=by(substituting(sign_of_product, root_argument), roots),
    where=display(15),
)

denominator_of_tilt = Claim(
    says=equal(gamma + 1 - (a + 1) * _square, sin(theta) ** 2 * (1 - b * _sine)),
    given=_body,
    proof=by(substituting(euler_angles.eq_gamma), trigonometry),
)

eq_dthetadphi = Claim(
    says=equal(dtheta_dphi, printed.theta_rate(theta, a, b, gamma, S2, sympy)),
    given=_off_axes,
    proof=by(
        substituting(euler_angles.eq_Euler, sign_of_product, root_argument, denominator_of_tilt),
        roots,
    ),
    where=display(16),
)

fig_portrait_theta = Claim(
    **jointly(regimes.three_regimes, regimes.handle_crosses, regimes.handle_side, rest_points),
    where=line(179),
    quotes=(MOTION,),
)

_said_at = Integer(103)
"""Where `symmetry_half` is said: θ in [0, π/2] is enough for γ > 0."""

said_in_section_3 = Claim(
    says="That θ in [0, π/2] is enough for γ > 0 is said in Section 3.",
    means=Tuple(Ge(_said_at, 81, evaluate=False), Le(_said_at, 112, evaluate=False)),
    proof=formally(),
)

reference_to_section_2 = Claim(
    says="That θ in [0, π/2] is enough for γ > 0 is said in Section 2.",
    means=Le(_said_at, 80, evaluate=False),
    proof=Counterexample({"line": fmpq(103)}),
    where=line(179),
    amended_by=(said_in_section_3,),
    note="The cross reference has a wrong label.",
    fault=Fault.MISPRINT,
)

_least_cosine = (gamma + b) / (a + b)

tilt_bounds_rotating = Claim(
    says=equations((theta_min, theta_max), printed.theta_bounds_rotating(a, b, gamma, sympy)),
    given=rotating,
    proof=Definition(),
    where=display(17),
)

tilt_bounds_oscillating = Claim(
    says=equations((theta_min, theta_max), printed.theta_bounds_oscillating(a, b, gamma, sympy)),
    given=oscillating,
    proof=Definition(),
    where=display(17),
)

cosines_of_bounds = Claim(
    says=Tuple(_least_cosine > 0, 1 - _least_cosine >= 0, gamma / a > 0, 1 - gamma / a > 0),
    given=rotating,
    proof=manifest,
    note="Both arc cosines are defined.",
)

tilts_in_order = Claim(
    says=_least_cosine - gamma / a > 0,
    given=rotating,
    proof=manifest,
    note="θ_min < θ_max for every rotating motion.",
)

tilt_above_least = Claim(
    says=gamma + b - (a + b) * _square >= 0,
    given=_body,
    proof=by(substituting(euler_angles.eq_gamma)),
)

_above = gamma + b - (a + b) * _square
_roots = (trigonometry, inverses, roots)

oscillating_tilt_between = Claim(
    says=equal(_above, (a + b) * sin(theta - theta_min) * sin(theta_max - theta)),
    given=oscillating,
    proof=by(substituting(tilt_bounds_oscillating), *_roots),
    note="For θ in [0, π] this is non-negative exactly between θ_min and θ_max, and zero at both.",
)

rotating_tilt_between = Claim(
    says=Tuple(
        equal(_above, (a + b) * sin(theta - theta_min) * sin(theta + theta_min)),
        equal(a * _square - gamma, a * sin(theta_max - theta) * sin(theta_max + theta)),
    ),
    given=rotating,
    proof=by(substituting(tilt_bounds_rotating), *_roots),
    note="For θ in [0, π/2] both are non-negative exactly between θ_min and θ_max.",
)

bounds_are_reached = Claim(
    says=Tuple(
        equal(_above, b * sin(theta) ** 2 * cos(psi) ** 2),
        equal(a * _square - gamma, b * sin(theta) ** 2 * _sine),
    ),
    given=_body,
    proof=by(substituting(euler_angles.eq_gamma), trigonometry),
    note="Zero at ψ = π/2 and at ψ = 0: there the tilt attains a bound.",
)

eq_borne_theta = Claim(
    **jointly(
        tilt_bounds_rotating,
        tilt_bounds_oscillating,
        cosines_of_bounds,
        rotating_tilt_between,
        oscillating_tilt_between,
        tilts_in_order,
        tilt_above_least,
        regimes.theta_half,
        bounds_are_reached,
    ),
    where=display(17),
    quotes=(MOTION,),
)

fig_thetamin = Claim(
    **jointly(eq_borne_theta),
    where=line(193),
)

label_claims(globals())
