"""Section 2, continued: what the frames and the angles say of the racket.

- `handle_in_space`, `line_of_nodes`: e₁ and the line of nodes in the laboratory frame;
- `angles_of_the_reference`: they are not the z-x-z angles of the reference cited there;
- `laboratory_turned`: the axes X and Y may be chosen freely;
- display (2), `d02`: the flip starts with e₂ near M; `near_intermediate_axis`: how near;
- (3), `d03`: the observed effect after a turn; `perfect_flip`: Δφ = 2π with Δψ = π is a half
  turn of the body about its handle;
- `cross_product`: in a rotation about one principal axis, M is parallel to that axis;
- `angles_from_momentum`: θ and ψ from M, and why the poles are excluded.
"""

from tresym.proofs import momentum
from tresym.proofs.conditions import ordered_moments, tilted
from tresym.proofs.model import (
    about_y,
    about_z,
    eq_Mi,
    eq_omega,
    product,
    rate,
    rotation,
    rotation_orthogonal,
    spin,
)

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

upright = ImmutableMatrix([0, 0, 1])
"""Z in the laboratory, and e₁ in the body (its axes in the order e₂, e₃, e₁)."""

times_upright = ImmutableMatrix([[0, -1, 0], [1, 0, 0], [0, 0, 0]])
"""The matrix of Z×: it takes a vector v of the laboratory to Z × v."""

handle = ImmutableMatrix([sin(theta) * cos(phi), sin(theta) * sin(phi), cos(theta)])
"""e₁ along (X, Y, Z)."""

no_external_moment = Claim(
    says=momentum.two_first_integrals.parts[1],
    given=ordered_moments,
    proof=all_of(momentum.two_first_integrals),
    where=line(56),
    note=(
        "`torque_free` assumes that the vector M is fixed in space; "
        "seen from the body it moves, but its length is constant."
    ),
)

cross_product = Claim(
    says=Tuple(
        equal(M2 * W3 - M3 * W2, (I2 - I3) * W2 * W3),
        equal(M3 * W1 - M1 * W3, (I3 - I1) * W3 * W1),
        equal(M1 * W2 - M2 * W1, (I1 - I2) * W1 * W2),
    ),
    proof=by(substituting(eq_omega)),
    note=(
        "Each component of M × Ω contains two components of Ω as "
        "factors, so it vanishes if only one component is not zero."
    ),
)

one_component_is_parallel = Claim(
    **jointly(eq_omega, cross_product),
    where=line(61),
)

fig_racket = Claim(
    **jointly(rotation_orthogonal),
    where=line(53),
)

handle_in_space = Claim(
    says=equal(product(about_z(phi), about_y(theta), about_z(psi), upright), handle),
    proof=by(),
    where=line(67),
    note="φ is the angle from X to the projection of the handle on the plane (X, Y).",
    shown=r"R\,(0, 0, 1)^{\mathsf T} = "
    r"(\sin\theta\cos\phi, \sin\theta\sin\phi, \cos\theta)^{\mathsf T}",
)

line_of_nodes = Claim(
    says=equal(
        product(times_upright, handle), sin(theta) * ImmutableMatrix([-sin(phi), cos(phi), 0])
    ),
    proof=by(),
    where=line(67),
    note="The line N is perpendicular to Z and to the handle, at the angle φ from Y.",
    shown=r"\vec Z\times\vec e_1 = \sin\theta\,(-\sin\phi, \cos\phi, 0)^{\mathsf T}",
)

_about_x = ImmutableMatrix([[1, 0, 0], [0, cos(theta), -sin(theta)], [0, sin(theta), cos(theta)]])
_second_reading = (about_z(phi) * _about_x * about_z(psi)).T * upright

angles_of_the_reference = Claim(
    says="The angles themselves are those of the reference that the section follows, which turns "
    "about the axes z, x and z.",
    paper_says="“Following Ref. [3], we fix the Z- axis of the laboratory frame along M.” Read "
    "as: only that choice is the reference's.",
    means=Tuple(
        equal(M * _second_reading[0], -M * sin(theta) * cos(psi)),
        equal(M * _second_reading[1], M * sin(theta) * sin(psi)),
    ),
    proof=formally(),
    where=line(62),
    expect=Verdict.REFUTED,
    amended_by=(eq_Mi,),
    note="The components of M that the paper prints belong to rotations about z, y and z.",
)

near_intermediate_axis = Claim(
    says=Tuple(M**2 - M2**2 >= 0, M**2 * (cos(theta) ** 2 + sin(psi) ** 2) >= M**2 - M2**2),
    given=ordered_moments,
    proof=by(substituting(eq_Mi)),
)

d02 = Claim(
    **jointly(eq_Mi, near_intermediate_axis),
    where=display(2),
    note="At ψ = π the same holds with e₂ along M instead of against it.",
)

_turn = Symbol("alpha", real=True)
_turned = about_z(_turn) * rotation
"""The body in a laboratory that is turned about Z."""

_turns = (about_z(phi), about_y(theta), about_z(psi))
"""R, turn by turn."""

laboratory_turned = Claim(
    says=Tuple(
        equal(product(_turned.T, rate(_turned)), spin),
        equal(
            product(about_z(_turn), about_z(phi), about_y(theta), about_z(psi)),
            product(about_z(phi + _turn), about_y(theta), about_z(psi)),
        ),
    ),
    proof=by(trigonometry),
    where=line(74),
    note=(
        "A rotation of X and Y about Z shifts φ and changes nothing else, so φ₀ may be chosen as 0."
    ),
    shown=r"(R_z(\alpha)R)^{\mathsf T}\frac{d}{dt}(R_z(\alpha)R) = R^{\mathsf T}\dot R,\quad "
    r"R_z(\alpha)\,R = R_z(\phi+\alpha)\,R_y(\theta)\,R_z(\psi)",
)

perfect_flip = Claim(
    says=equal(
        product(about_z(phi + 2 * pi), about_y(theta), about_z(psi + pi)),
        product(*_turns, ImmutableMatrix([[-1, 0, 0], [0, -1, 0], [0, 0, 1]])),
    ),
    proof=by(trigonometry),
    note="e₁ returns to its direction; e₂ and e₃ are reversed.",
    shown=r"R_z(\phi+2\pi)\,R_y(\theta)\,R_z(\psi+\pi) = R\,\operatorname{diag}(-1, -1, 1)",
)

flip_about_the_handle = Claim(
    says=equal(
        product(about_z(phi), about_y(theta), about_z(psi + _turn)),
        product(*_turns, about_z(_turn)),
    ),
    proof=by(trigonometry),
    where=line(70),
    note="A change of ψ rotates the body about its own axis e₁.",
    shown=r"R_z(\phi)\,R_y(\theta)\,R_z(\psi+\alpha) = "
    r"R_z(\phi)\,R_y(\theta)\,R_z(\psi)\,R_z(\alpha)",
)

d03 = Claim(
    **jointly(rotation_orthogonal, handle_in_space, perfect_flip),
    where=display(3),
)

flip_observed = Claim(
    **jointly(perfect_flip),
    where=line(49),
)

angles_from_momentum = Claim(
    says=Tuple(
        equal(cos(theta), M1 / M),
        equal(cos(psi), -M2 / sqrt(M2**2 + M3**2)),
        equal(sin(psi), M3 / sqrt(M2**2 + M3**2)),
    ),
    given=(*ordered_moments, *tilted, M2**2 + M3**2 > 0),
    proof=by(substituting(eq_Mi), trigonometry, roots),
    where=line(62),
    note="Away from the poles M determines θ, and ψ up to full turns.",
)

_turned = [(Symbol(f"theta{n}", real=True), Symbol(f"psi{n}", real=True), M, sympy) for n in (1, 2)]

globally_parameterize = Claim(
    says="The angles describe every motion: different θ, ψ (up to full turns) give different M.",
    paper_says="“A suitable set of Euler angles is proposed to globally parameterize the TRE.” "
    "Read as: the motions that show it, whose handle is never along M.",
    means=Under(
        equations(*((tilt, flip) for tilt, flip, *_ in _turned)),
        equations(*(printed.momentum(*turned) for turned in _turned)),
    ),
    given=(
        M > 0,
        *(end for tilt, *_ in _turned for end in (tilt >= 0, tilt <= pi)),
        *(end for _, flip, *_ in _turned for end in (flip >= 0, flip < 2 * pi)),
    ),
    proof=Counterexample(
        {"M": fmpq(1), "theta1": fmpq(0), "theta2": fmpq(0), "psi1": fmpq(0), "psi2": fmpq(1)}
    ),
    where=line(47),
    amended_by=(angles_from_momentum,),
    note="With the handle along M, every ψ gives the same M, and φ has no meaning.",
)

label_claims(globals())
