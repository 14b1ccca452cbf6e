"""Sections 3 and 4: oscillating and rotating motions, told apart by γ.

- `energy_by_gamma`: 2I₂E, 2I₃E and 2I₁E compared with M², as multiples of γ, γ + b, a − γ;
- `tilt_by_flip`: cos²θ depends on ψ alone, so θ returns to its value when ψ has changed by π;
- `theta_half`, `psi_unbounded`: for γ > 0 the handle stays on one side, and ψ is unbounded;
- `psi_half_oscillating`, `handle_crosses`: for γ < 0 the racket oscillates, and the handle crosses
  the plane;
- `symmetry_half`: the symmetries of the planar system;
- `depth_at_e1`, `depth_at_e3`: γ = a and γ = −b, and where the angles are constant.
"""

from tresym.proofs import euler_angles, jacobi, momentum, stability
from tresym.proofs.axioms import MOTION
from tresym.proofs.conditions import ordered_moments, shape_of_a_body, tilted
from tresym.proofs.frames import handle_in_space

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

planar_variables = Tuple(theta, psi)
planar_rates = Tuple(*(part.args[1] for part in euler_angles.eq_Euler.parts))
"""The planar system: its variables, and their rates by φ."""

_sine = sin(psi) ** 2

ordering = Claim(
    label="ordered_moments",
    says="The moments may be any with 0 ≤ I₁ ≤ I₂ ≤ I₃.",
    given=(I1 >= 0, I2 - I1 >= 0, I3 - I2 >= 0),
    means=I1 > 0,
    proof=Counterexample({"I1": fmpq(0), "I2": fmpq(1), "I3": fmpq(1)}),
    where=line(82),
    amended_by=(momentum.eq_dMi,),
    note="At I₁ = 0 the equations that follow divide by zero; they hold for 0 < I₁ < I₂ < I₃.",
    fault=Fault.MISPRINT,
)

energy_by_gamma = Claim(
    says=Tuple(
        equal(2 * I2 * E - M**2, M**2 * gamma),
        equal(2 * I3 * E - M**2, M**2 * (gamma + b) / (1 - b)),
        equal(M**2 - 2 * I1 * E, M**2 * (a - gamma) / (1 + a)),
    ),
    given=ordered_moments,
    proof=by(substituting(euler_angles.d08)),
    note="As 1 − b and 1 + a are positive, the signs of the left sides are those of γ, γ + b "
    "and a − γ.",
)

_apart = (M**2 - 2 * I2 * E > 0, 2 * I3 * E - M**2 > 0)
_together = (M**2 - 2 * I1 * E > 0, 2 * I2 * E - M**2 > 0)

oscillating_case = Claim(
    says=Tuple(-gamma > 0, gamma + b > 0),
    given=(*ordered_moments, *_apart),
    proof=by(substituting(euler_angles.d08)),
    where=line(96),
)

rotating_case = Claim(
    says=Tuple(gamma > 0, a - gamma > 0),
    given=(*ordered_moments, *_together),
    proof=by(substituting(euler_angles.d08)),
    where=line(96),
)

separatrix_case = Claim(
    says=Equivalent(equal(2 * I2 * E - M**2, 0), equal(gamma, 0)),
    given=ordered_moments,
    proof=(step(equal(gamma, 0), multiplying(1 / M**2), substituting(euler_angles.d08)),),
    where=line(96),
)

three_regimes = Claim(
    **jointly(energy_by_gamma, oscillating_case, rotating_case, separatrix_case),
    where=line(124),
    note="The extreme values γ = a and γ = −b belong to the two stable rotations.",
)

fig_sphere_cases = Claim(
    **jointly(
        jacobi.solution_on_intersection,
        jacobi.intersection_condition,
        three_regimes,
        stability.three_equilibria_and_opposites,
    ),
    where=line(110),
)

ellipsoid_radii = Claim(
    says=equal(
        sum(
            component**2 / radius**2
            for component, radius in zip(
                (M1, M2, M3), printed.ellipsoid_radii(I1, I2, I3, E, sympy), strict=True
            )
        ),
        printed.energy(M1, M2, M3, I1, I2, I3) / E,
    ),
    given=(*ordered_moments, E > 0),
    proof=by(),
    where=line(96),
    note="The energy surface is Σ Mᵢ²/(2IᵢE) = 1.",
)

precession_of_the_handle = Claim(
    **jointly(handle_in_space, euler_angles.precession_forward),
    where=line(70),
)

tilt_by_flip = Claim(
    says=equal(cos(theta) ** 2 * (a + b * _sine), gamma + b * _sine),
    given=ordered_moments,
    proof=by(substituting(euler_angles.eq_gamma), trigonometry),
)

_flips = Symbol("psi1", real=True), Symbol("psi2", real=True)
_tilts = [(gamma + b * sin(p) ** 2) / (a + b * sin(p) ** 2) for p in _flips]

tilt_after_flip = Claim(
    says=equal(at(_tilts[0], {_flips[0]: _flips[0] + pi}), _tilts[0]),
    given=shape_of_a_body,
    proof=by(evaluating, trigonometry),
    shown=r"\frac{\gamma+b\sin^2(\psi_1+\pi)}{a+b\sin^2(\psi_1+\pi)} = "
    r"\frac{\gamma+b\sin^2\psi_1}{a+b\sin^2\psi_1}",
)

tilt_near_flip = Claim(
    says=equal(
        _tilts[1] - _tilts[0],
        b
        * (a - gamma)
        * (sin(_flips[1]) ** 2 - sin(_flips[0]) ** 2)
        / ((a + b * sin(_flips[0]) ** 2) * (a + b * sin(_flips[1]) ** 2)),
    ),
    given=shape_of_a_body,
    proof=by(),
    note="At most (b/a)(1 + b/a) times the change of sin²ψ, since 0 ≤ a − γ ≤ a + b.",
)

delta_theta_zero = Claim(
    **jointly(tilt_by_flip, tilt_after_flip, tilt_near_flip),
    where=line(78),
    note="The proof uses the energy: at given γ, cos²θ is a function of sin²ψ.",
)

_end = Symbol("theta_f", real=True)

components_are_sufficient = Claim(
    says="The components of M by the angles are enough, without the energy, to show that Δψ = π "
    "gives Δθ = 0.",
    paper_says="“These equations are sufficient to show that, for a flip Δψ ≃ π, the variation of "
    "θ is Δθ ≃ 0.” Read as: with the curves of Fig. 3, which hold the energy.",
    means=equal(
        printed.momentum(theta, psi, M, sympy)[0], printed.momentum(_end, psi + pi, M, sympy)[0]
    ),
    given=(M > 0, theta > 0, theta < pi, _end > 0, _end < pi),
    proof=Counterexample({"M": fmpq(1), "theta": fmpq(3, 2), "theta_f": fmpq(3, 4)}),
    where=line(102),
    amended_by=(delta_theta_zero,),
    note="The three components give the length M for all angles; the conclusion Δθ = 0 also "
    "needs the energy.",
)

_momentum = printed.momentum(theta, psi, M, sympy)

flip_components = Claim(
    says=equations(
        tuple(at(m, {psi: psi + pi}) for m in _momentum[1:]), tuple(-m for m in _momentum[1:])
    ),
    proof=by(evaluating, trigonometry),
    note="M₁ = M cos θ does not depend on ψ.",
    where=line(102),
    shown=r"(M_2, M_3)(\theta, \psi+\pi) = (-M_2, -M_3)(\theta, \psi)",
)

rotating = (*shape_of_a_body, gamma > 0, gamma < a)
"""Rotating motions."""
oscillating = (*shape_of_a_body, gamma < 0, gamma > -b)
"""Oscillating motions."""

theta_half = Claim(
    says=a * cos(theta) ** 2 - gamma >= 0,
    given=(*ordered_moments, *shape_of_a_body),
    proof=by(substituting(euler_angles.eq_gamma)),
    where=line(103),
    note="For γ > 0, cos²θ ≥ γ/a > 0: θ stays in [0, π/2) or in (π/2, π].",
)

rotating_speed = Claim(
    says=printed.psi_rate(psi, a, b, gamma, 1, sympy) ** 2 >= a * gamma,
    given=rotating,
    proof=manifest,
    note="|dψ/dφ| ≥ √(aγ) > 0, with one sign.",
)

_turned = Symbol("Psi", real=True)
_per_angle = printed.integrand(psi, a, b, gamma, 1, sympy)
_at_most = 1 / sqrt(a * gamma)

psi_unbounded = Claim(
    says=Integral(_per_angle, (psi, 0, _turned)) <= _turned / sqrt(a * gamma),
    given=(*rotating, _turned > 0),
    proof=(
        step(
            Integral(_at_most, (psi, 0, _turned)) - Integral(_per_angle, (psi, 0, _turned)),
            integrating(_at_most * psi),
        ),
        step(Integral(_at_most - _per_angle, (psi, 0, _turned)), collecting()),
    ),
    where=line(103),
    note="Every angle Ψ is reached after a finite precession; for S = −1 likewise −Ψ.",
)

handle_side = Claim(
    **jointly(handle_in_space, theta_half, rotating_speed, psi_unbounded),
    where=line(103),
    quotes=(MOTION,),
)

_flow = printed.planar_rates(theta, psi, a, b, sympy)
_mirrored = tuple(at(rate, {theta: pi - theta, psi: -psi}) for rate in _flow)
_shifted = tuple(at(rate, {psi: psi + pi}) for rate in _flow)

symmetry_half = Claim(
    says=Tuple(
        *equations(_mirrored, tuple(-r for r in _flow)).args, *equations(_shifted, _flow).args
    ),
    given=shape_of_a_body,
    proof=by(evaluating, trigonometry),
    where=line(103),
    note=(
        "With (θ, ψ) also (π − θ, −ψ) is a motion, so θ ≤ π/2 is no "
        "restriction; nor is a shift of ψ by π."
    ),
    shown=r"V(\pi-\theta, -\psi) = -V(\theta, \psi),\quad "
    r"V(\theta, \psi+\pi) = V(\theta, \psi),\quad "
    r"V = \left(\frac{d\theta}{d\phi}, \frac{d\psi}{d\phi}\right)",
)

psi_half_oscillating = Claim(
    says=b * _sine > 0,
    given=(*ordered_moments, *shape_of_a_body, gamma < 0),
    proof=(step(cos(theta) ** 2 * (a + b * _sine) - gamma, substituting(tilt_by_flip)),),
    where=line(103),
    note="sin ψ never vanishes, so that ψ, which is continuous, stays in (0, π) or in (−π, 0), up "
    "to full turns.",
    quotes=(MOTION,),
)

handle_crosses = Claim(
    says=printed.planar_rates(pi / 2, psi, a, b, sympy)[0] ** 2 > 0,
    given=(*shape_of_a_body, sin(psi) ** 2 > 0, cos(psi) ** 2 > 0),
    proof=manifest,
    where=line(103),
    note=(
        "At θ = π/2 the rate of the tilt is not 0, unless sin ψ or "
        "cos ψ is 0, so the handle crosses the plane there."
    ),
    quotes=(MOTION,),
)

panel_depends_on_shape = Claim(
    says=equal((gamma - a) / a, -(sin(theta) ** 2) * (1 + b / a * _sine)),
    given=(*ordered_moments, *shape_of_a_body),
    proof=by(substituting(euler_angles.eq_gamma)),
    where=line(112),
    note="The curves γ = constant are those of sin²θ (1 + (b/a) sin²ψ): they depend on the shape, "
    "and only through b/a.",
)

strict_range_of_shape = Claim(
    says=Tuple(a > 0, b > 0, 1 - b > 0),
    given=ordered_moments,
    proof=by(substituting(euler_angles.d08)),
    note=(
        "Neither endpoint is attained: b = 1 would require I₃ = ∞, and a = ∞ would require I₁ = 0."
    ),
)

_real = (*ordered_moments, I1 + I2 - I3 >= 0)

realizable_shape = Claim(
    says=Tuple(1 / (a + 2) - b >= 0, 1 - 2 * b > 0),
    given=_real,
    proof=by(substituting(euler_angles.d08)),
    note=(
        "No moment of a rigid body exceeds the sum of the two others; the paper does not use this."
    ),
)

symmetric_top = Claim(
    says=equations((a * I1, b * I3), (I2 - I1, I3 - I2)),
    given=ordered_moments,
    proof=by(substituting(euler_angles.d08)),
    where=line(124),
    note="a = 0 exactly when I₁ = I₂, b = 0 exactly when I₂ = I₃, both for a spherical top.",
)

ratios_of_moments = Claim(
    says=equations((I2 / I1, I3 / I2), (1 + a, 1 / (1 - b))),
    given=ordered_moments,
    proof=by(substituting(euler_angles.d08)),
    note="I₁ ≪ I₂ ≪ I₃ means a ≫ 1 and 1 − b ≪ 1.",
)

a_and_b_large = Claim(
    says="There is a case a ≫ 1, b ≫ 1, in which I₁ ≪ I₂ ≪ I₃.",
    means=ForSome(b >= 1),
    given=ordered_moments,
    proof=formally(euler_angles.d08),
    where=line(124),
    expect=Verdict.REFUTED,
    amended_by=(ratios_of_moments, strict_range_of_shape),
    note="b is below 1 for every body, and below 1/2 for a rigid one; I₁ ≪ I₂ ≪ I₃ needs b near 1.",
)

depth_at_e1 = Claim(
    says=equal(a - gamma, sin(theta) ** 2 * (a + b * _sine)),
    given=ordered_moments,
    proof=by(substituting(euler_angles.eq_gamma)),
    note="γ = a exactly when sin θ = 0: M lies along the handle.",
)

depth_at_e3 = Claim(
    says=equal(gamma + b, (a + b) * cos(theta) ** 2 + b * sin(theta) ** 2 * cos(psi) ** 2),
    given=ordered_moments,
    proof=by(substituting(euler_angles.eq_gamma), trigonometry),
    note="γ = −b exactly when cos θ = 0 and cos ψ = 0: M lies along e₃.",
)

_depth = printed.depth(theta, psi, a, b, sympy)

depth_at_the_points = Claim(
    says=Tuple(
        equal(at(_depth, {theta: 0}), a), equal(at(_depth, {theta: pi / 2, psi: pi / 2}), -b)
    ),
    proof=by(evaluating, trigonometry),
    where=line(141),
)

ends_of_gamma = Claim(
    **jointly(depth_at_e1, depth_at_e3, stability.permanent_rotations),
    where=line(140),
)

angles_rest_at_e1 = Claim(
    says="At θ = 0 the planar system is in equilibrium.",
    paper_says="“The two equilibrium points, given by γ = a and γ = −b, correspond to the points "
    "p₊ and p₋.” Read as: M rests there.",
    given=shape_of_a_body,
    means=equations(
        tuple(at(rate, {theta: 0}) for rate in printed.planar_rates(theta, psi, a, b, sympy)),
        (0, 0),
    ),
    proof=Counterexample({"a": fmpq(1), "b": fmpq(1, 2), "psi": fmpq(0)}),
    where=line(140),
    amended_by=(ends_of_gamma,),
    note=(
        "M is constant there, while ψ grows at a constant rate: the "
        "racket rotates about its handle."
    ),
)

planar_system = Claim(
    says=Conserved(printed.depth(theta, psi, a, b, sympy), planar_variables, planar_rates),
    given=(*tilted, *shape_of_a_body),
    proof=Conservation(),
    where=line(126),
    quotes=(MOTION,),
)

label_claims(globals())
