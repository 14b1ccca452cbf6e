"""Section 4: the equations of the Euler angles, the shape of the body, and the planar system.

- display (7), `eq_euler_angle`: the rates of θ, φ, ψ, obtained from Ω = M/I;
- (8), `d08`: a, b and γ;
- `precession_forward`: φ increases strictly, so it can be used in place of time;
- (9), `eq_Euler`: the planar system for θ and ψ as functions of φ;
- (10), `eq_gamma`: γ as a function of θ and ψ, by substitution; `gamma_conserved`: dγ/dφ = 0;
- (11), `d11`: 0 ≤ a, 0 ≤ b ≤ 1 and −b ≤ γ ≤ a, by `range_of_shape` and `range_of_gamma`.
"""

from tresym.proofs import momentum
from tresym.proofs.axioms import INVERSE_FUNCTION, MOTION
from tresym.proofs.conditions import ordered_moments, shape, shape_of_a_body, tilted
from tresym.proofs.model import angular_velocity, eq_Mi, velocity_from_momentum

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

eq_euler_angle = Claim(
    says=equations(
        (dtheta_dt, dphi_dt, dpsi_dt), printed.angle_rates(theta, psi, M, I1, I2, I3, sympy)
    ),
    given=(*ordered_moments, *tilted),
    proof=together(
        (
            step(W2 * sin(psi) + W3 * cos(psi), substituting(angular_velocity), trigonometry),
            step(None, substituting(velocity_from_momentum, eq_Mi)),
        ),
        (
            step(
                (W3 * sin(psi) - W2 * cos(psi)) / sin(theta),
                substituting(angular_velocity),
                trigonometry,
            ),
            step(None, substituting(velocity_from_momentum, eq_Mi)),
        ),
        (
            step(
                W1 - (W3 * sin(psi) - W2 * cos(psi)) / sin(theta) * cos(theta),
                substituting(angular_velocity),
                trigonometry,
            ),
            step(None, substituting(velocity_from_momentum, eq_Mi)),
        ),
    ),
    where=display(7),
)

d08 = Claim(
    says=equations(
        (a, b, gamma), (*printed.shape(I1, I2, I3), printed.depth_from_energy(E, M, I2))
    ),
    given=ordered_moments,
    proof=Definition(),
    where=display(8),
)

precession_rate = Claim(
    says=equal(dphi_dt, M * (1 - b * sin(psi) ** 2) / I2),
    given=(*ordered_moments, *tilted),
    proof=by(substituting(eq_euler_angle, d08), trigonometry),
)

precession_forward = Claim(
    says=dphi_dt > 0,
    given=(*ordered_moments, *tilted, *shape_of_a_body),
    proof=by(substituting(precession_rate)),
    note="φ increases strictly, so it can be used in place of time.",
)

elimination_of_time = Claim(
    says=Tuple(equal(dtheta_dphi, dtheta_dt / dphi_dt), equal(dpsi_dphi, dpsi_dt / dphi_dt)),
    given=(dphi_dt > 0,),
    proof=Definition(),
    note=(
        "The new symbols are only names for the quotients; `rates_along_the_path` shows that "
        "the quotients are derivatives along a motion."
    ),
)

rates_along_the_path = Claim(
    **jointly(precession_forward),
    where=line(126),
    quotes=(MOTION, INVERSE_FUNCTION),
)

eq_Euler = Claim(
    says=equations((dtheta_dphi, dpsi_dphi), printed.planar_rates(theta, psi, a, b, sympy)),
    given=(*ordered_moments, *tilted, *shape_of_a_body),
    proof=by(
        substituting(elimination_of_time, eq_euler_angle, d08),
        citing(precession_forward),
        trigonometry,
    ),
    where=display(9),
)

eq_gamma = Claim(
    says=equal(gamma, printed.depth(theta, psi, a, b, sympy)),
    given=ordered_moments,
    proof=(
        step(2 * I2 * E / M**2 - 1, substituting(d08)),
        step(
            ((1 + a) * M1**2 + M2**2 + (1 - b) * M3**2) / M**2 - 1,
            substituting(momentum.energy_of_momentum, d08),
        ),
        step(
            (1 + a) * cos(theta) ** 2 + sin(theta) ** 2 * (1 - b * sin(psi) ** 2) - 1,
            substituting(eq_Mi),
            trigonometry,
        ),
        step(a - sin(theta) ** 2 * (a + b * sin(psi) ** 2), trigonometry),
    ),
    where=display(10),
)

planar_variables = Tuple(theta, psi)
planar_rates = Tuple(*(part.args[1] for part in eq_Euler.parts))
"""The planar system: its variables, and their rates by φ."""

_gamma_of_angles = printed.depth(theta, psi, a, b, sympy)

gamma_conserved = Claim(
    says=equal(
        diff(_gamma_of_angles, theta) * dtheta_dphi + diff(_gamma_of_angles, psi) * dpsi_dphi, 0
    ),
    given=(*ordered_moments, *tilted, *shape_of_a_body),
    proof=by(substituting(eq_Euler)),
    where=line(134),
    note="A second proof that γ is constant: its derivative along the flow vanishes.",
)

range_of_shape = Claim(
    says=Tuple(a >= 0, b >= 0, b <= 1), given=ordered_moments, proof=by(substituting(d08))
)

range_of_gamma = Claim(
    says=Tuple(gamma >= -b, gamma <= a),
    given=(*ordered_moments, *shape),
    proof=by(substituting(eq_gamma)),
)

d11 = Claim(
    **jointly(range_of_shape, range_of_gamma),
    where=display(11),
)

label_claims(globals())
