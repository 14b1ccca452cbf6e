"""Section 2: the frames, the Euler angles and the angular velocity.

The body axes (x, y, z) are (e₂, e₃, e₁), the angles are z-y-z, and Z lies along the angular
momentum. Proved here:

- `rotation_orthogonal`: R = R_z(φ) R_y(θ) R_z(ψ) is a rotation;
- `spin_is_velocity`: RᵀṘ is antisymmetric, and its three entries are the angular velocity;
- `angular_velocity`: its components along e₁, e₂, e₃;
- display (1), `eq_omega`: M_i = I_i Ω_i, and `velocity_from_momentum`, the same solved for Ω;
- (6), `eq_Mi`: the components of M from the direction of Z in the body;
- `torque_free`, `momentum_transport`: M is fixed in space, which means dM/dt = M × Ω in the body.
"""

from sympy import Add, Mul
from tresym.proofs.conditions import ordered_moments

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *


def _both(angle: Expr) -> tuple[Expr, Expr]:
    """Sine and cosine, unevaluated: SymPy would remove a full turn from the argument."""
    return sin(angle, evaluate=False), cos(angle, evaluate=False)


def about_z(angle: Expr) -> ImmutableMatrix:
    """Rotation by ``angle`` about the third axis."""
    s, c = _both(angle)
    return ImmutableMatrix([[c, -s, 0], [s, c, 0], [0, 0, 1]])


def about_y(angle: Expr) -> ImmutableMatrix:
    """Rotation by ``angle`` about the second axis."""
    s, c = _both(angle)
    return ImmutableMatrix([[c, 0, s], [0, 1, 0], [-s, 0, c]])


def product(first: ImmutableMatrix, *others: ImmutableMatrix) -> ImmutableMatrix:
    """Return the product of matrices with its entries as unevaluated sums of products.

    If SymPy evaluated the product, both sides of a statement would become identical.
    """
    for other in others:
        columns = range(other.shape[1])
        rows = [[_dot(first.row(i), other.col(j)) for j in columns] for i in range(first.shape[0])]
        first = ImmutableMatrix(rows)
    return first


def _dot(row: ImmutableMatrix, column: ImmutableMatrix) -> Expr:
    pairs = zip(row, column, strict=True)
    return Add(*(Mul(p, q, evaluate=False) for p, q in pairs), evaluate=False)


def rate(expression: Basic) -> Basic:
    """Time derivative by the chain rule, with the rates of the angles as symbols."""
    rates = {phi: dphi_dt, theta: dtheta_dt, psi: dpsi_dt}
    return sum(
        (diff(expression, angle) * speed for angle, speed in rates.items()), start=0 * expression
    )


rotation = about_z(phi) * about_y(theta) * about_z(psi)
"""R: components along (e₂, e₃, e₁) to components along (X, Y, Z)."""

spin = rotation.T * rate(rotation)
"""RᵀṘ, with the rows and columns in the order e₂, e₃, e₁."""

hat = ImmutableMatrix([[0, -W1, W3], [W1, 0, -W2], [-W3, W2, 0]])
"""The antisymmetric matrix of Ω in the same order: ``hat·v = Ω × v``."""

momentum = ImmutableMatrix([M2, M3, M1])
"""M in the order e₂, e₃, e₁."""

rotation_orthogonal = Claim(
    shown=r"R^{\mathsf T}R = 1,\qquad R = R_z(\phi)\,R_y(\theta)\,R_z(\psi)",
    says=equal(rotation.T * rotation, ImmutableMatrix(eye(3))),
    proof=by(trigonometry),
)

spin_matrix = Claim(
    shown=(
        r"\Omega_1 = (R^{\mathsf T}\dot R)_{21},\quad "
        r"\Omega_2 = (R^{\mathsf T}\dot R)_{32},\quad \Omega_3 = (R^{\mathsf T}\dot R)_{13}"
    ),
    says=Tuple(equal(W1, spin[1, 0]), equal(W2, spin[2, 1]), equal(W3, spin[0, 2])),
    proof=Definition(),
    note="The entries of RᵀṘ are, up to sign, the components of the angular velocity.",
)

angular_velocity = Claim(
    says=equal(
        ImmutableMatrix([W1, W2, W3]),
        ImmutableMatrix(
            [
                dphi_dt * cos(theta) + dpsi_dt,
                dtheta_dt * sin(psi) - dphi_dt * sin(theta) * cos(psi),
                dtheta_dt * cos(psi) + dphi_dt * sin(theta) * sin(psi),
            ]
        ),
    ),
    proof=by(substituting(spin_matrix), trigonometry),
)

spin_is_velocity = Claim(
    shown=(
        r"R^{\mathsf T}\dot R = \begin{pmatrix}0 & -\Omega_1 & \Omega_3\\"
        r"\Omega_1 & 0 & -\Omega_2\\-\Omega_3 & \Omega_2 & 0\end{pmatrix}"
    ),
    says=equal(spin, hat),
    proof=by(substituting(spin_matrix), trigonometry),
    note="All nine entries are checked, not only the three that define Ω.",
)

eq_omega = Claim(
    says=Tuple(equal(M1, I1 * W1), equal(M2, I2 * W2), equal(M3, I3 * W3)),
    proof=Definition(),
    where=display(1),
    note="The axes are principal axes of inertia.",
)

velocity_from_momentum = Claim(
    says=equal(ImmutableMatrix([W1, W2, W3]), ImmutableMatrix([M1 / I1, M2 / I2, M3 / I3])),
    given=ordered_moments,
    proof=by(substituting(eq_omega)),
)

momentum_along_z = Claim(
    shown=r"(M_2, M_3, M_1)^{\mathsf T} = M\,R^{\mathsf T}(0, 0, 1)^{\mathsf T}",
    says=equal(momentum, M * rotation.T * ImmutableMatrix([0, 0, 1])),
    proof=Definition(assumes="the choice of axes in space"),
    note="The third axis of the laboratory is chosen along the angular momentum.",
)

eq_Mi = Claim(
    says=equations((M1, M2, M3), printed.momentum(theta, psi, M, sympy)),
    given=ordered_moments,
    proof=by(substituting(momentum_along_z)),
    where=display(6),
)

torque_free = Claim(
    shown=(
        r"(\dot M_2, \dot M_3, \dot M_1)^{\mathsf T} = "
        r"-R^{\mathsf T}\dot R\,(M_2, M_3, M_1)^{\mathsf T}"
    ),
    says=equal(ImmutableMatrix([dM2_dt, dM3_dt, dM1_dt]), -spin * momentum),
    proof=Definition(assumes="no torque acts, so the angular momentum is fixed in space"),
    note="R M is fixed in space, so the derivative of M in the body is −RᵀṘ M.",
)

momentum_transport = Claim(
    shown=r"\dot{\vec M} = \vec M\times\vec\Omega",
    says=equal(
        ImmutableMatrix([dM1_dt, dM2_dt, dM3_dt]),
        ImmutableMatrix([M2 * W3 - M3 * W2, M3 * W1 - M1 * W3, M1 * W2 - M2 * W1]),
    ),
    proof=by(substituting(torque_free, spin_matrix), trigonometry),
)

label_claims(globals())
