"""Sections 2 and 3: the permanent rotations and their stability.

Euler's equations are linearised at M along a principal axis; the eigenvalues λ solve
λ(λ² − …) = 0 exactly. Where λ² < 0, the energy on the sphere of M has a strict extremum, and the
distance from the axis stays below a constant times its initial value. Where λ² > 0, one eigenvalue
is positive, and a product of two components grows exponentially.

- `eigenvalues_e1`, `eigenvalues_e2`, `eigenvalues_e3`, and the signs of λ²;
- `energy_near_e1`, `energy_near_e3`: the energy on the sphere of M, with its extrema;
- `stays_near_e1`, `stays_near_e3`: stability, with a constant; `leaves_e2`: instability;
- `permanent_rotations`: the equilibria are the six points with two components zero.
"""

from tresym.proofs import momentum
from tresym.proofs.axioms import MOTION
from tresym.proofs.conditions import ordered_moments
from tresym.proofs.model import eq_Mi, velocity_from_momentum

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

eigenvalue = Symbol("eigenvalue", real=True)
"""λ; the characteristic polynomials have no real root but 0 where the rotation is stable."""

_components = Tuple(M1, M2, M3)
_rates = ImmutableMatrix(printed.euler_equations(*_components, I1, I2, I3))


def _along_euler(quantity: Expr) -> Expr:
    """Time derivative of a function of M₁, M₂, M₃, with the rates as symbols."""
    rates = (dM1_dt, dM2_dt, dM3_dt)
    return sum(diff(quantity, m) * speed for m, speed in zip(_components, rates, strict=True))


def _characteristic(*at: Expr) -> Expr:
    """The characteristic polynomial of Euler's equations linearised at a point."""
    slope = _rates.jacobian(_components).subs(dict(zip(_components, at, strict=True)))
    return det(eigenvalue * eye(3) - slope)


_square1 = -(M**2) * (1 / I1 - 1 / I2) * (1 / I1 - 1 / I3)
_square2 = M**2 * (1 / I1 - 1 / I2) * (1 / I2 - 1 / I3)
_square3 = -(M**2) * (1 / I1 - 1 / I3) * (1 / I2 - 1 / I3)

eigenvalues_e1 = Claim(
    says=equal(_characteristic(M, 0, 0), eigenvalue * (eigenvalue**2 - _square1)),
    given=ordered_moments,
    proof=by(),
)

eigenvalues_e2 = Claim(
    says=equal(_characteristic(0, M, 0), eigenvalue * (eigenvalue**2 - _square2)),
    given=ordered_moments,
    proof=by(),
)

eigenvalues_e3 = Claim(
    says=equal(_characteristic(0, 0, M), eigenvalue * (eigenvalue**2 - _square3)),
    given=ordered_moments,
    proof=by(),
)

center_at_e1 = Claim(says=_square1 < 0, given=ordered_moments, proof=manifest)

saddle_at_e2 = Claim(says=_square2 > 0, given=ordered_moments, proof=manifest)

center_at_e3 = Claim(says=_square3 < 0, given=ordered_moments, proof=manifest)

_below_first = M2**2 * (I2 - I1) / (I1 * I2) + M3**2 * (I3 - I1) / (I1 * I3)
_above_third = M1**2 * (I3 - I1) / (I1 * I3) + M2**2 * (I3 - I2) / (I2 * I3)

energy_near_e1 = Claim(
    says=equal((M1**2 + M2**2 + M3**2) / I1 - 2 * E, _below_first),
    given=ordered_moments,
    proof=by(substituting(momentum.energy_of_momentum)),
    note=(
        "At fixed length of M the energy is largest at M₂ = M₃ = 0, "
        "and only there: a Lyapunov function."
    ),
)

energy_near_e3 = Claim(
    says=equal(2 * E - (M1**2 + M2**2 + M3**2) / I3, _above_third),
    given=ordered_moments,
    proof=by(substituting(momentum.energy_of_momentum)),
    note="At fixed length of M the energy is smallest at M₁ = M₂ = 0, and only there.",
)

N1, N2, N3 = (Symbol(f"N{n}", real=True) for n in (1, 2, 3))
"""Where M began: its length and the energy were the same there."""


def _from_start(excess: Expr) -> Expr:
    """By how much ``excess`` was larger at the start."""
    return excess.xreplace({M1: N1, M2: N2, M3: N3}) - excess


stays_near_e1 = Claim(
    says=M2**2 + M3**2 <= I2 * (I3 - I1) / (I3 * (I2 - I1)) * (N2**2 + N3**2),
    given=(*ordered_moments, _from_start(_below_first) >= 0),
    proof=manifest,
    note=(
        "N is the initial value of M, with the same energy and "
        "length. The distance stays arbitrarily small if it is "
        "sufficiently small at the start: the rotation is stable."
    ),
)

stays_near_e3 = Claim(
    says=M1**2 + M2**2 <= I2 * (I3 - I1) / (I1 * (I3 - I2)) * (N1**2 + N2**2),
    given=(*ordered_moments, _from_start(_above_third) >= 0),
    proof=manifest,
    note="As for e₁, in `stays_near_e1`.",
)

stable_e1 = Claim(
    says=StableEquilibrium(_components, Tuple(*_rates), Tuple(M, 0, 0)),
    given=ordered_moments,
    proof=Lyapunov(_below_first + (M1**2 + M2**2 + M3**2 - M**2) ** 2),
    note="The rotation about the handle. A constant is given by `stays_near_e1`.",
    where=line(49),
    quotes=(MOTION,),
)

stable_e3 = Claim(
    says=StableEquilibrium(_components, Tuple(*_rates), Tuple(0, 0, M)),
    given=ordered_moments,
    proof=Lyapunov(_above_third + (M1**2 + M2**2 + M3**2 - M**2) ** 2),
    note="The rotation about the normal of the face.",
    where=line(49),
    quotes=(MOTION,),
)

_first_rate, _third_rate = sqrt(1 / I1 - 1 / I2), sqrt(1 / I2 - 1 / I3)

leaves_e2 = Claim(
    says=Tuple(
        *(
            -M2 * _along_euler(M1 * M3) - side * 2 * _first_rate * _third_rate * M2**2 * M1 * M3
            >= 0
            for side in (1, -1)
        )
    ),
    given=ordered_moments,
    proof=by(substituting(momentum.eq_dMi)),
    note="Let P be −M₁M₃ where M₂ > 0 and M₁M₃ where M₂ < 0. As long as |M₂| ≥ m, a positive P "
    "grows at least as e^{2αβmt}, α² = 1/I₁ − 1/I₂ and β² = 1/I₂ − 1/I₃; but it is at most M²/2.",
)

unstable_e2 = Claim(
    says=UnstableEquilibrium(_components, Tuple(*_rates), Tuple(0, -M, 0)),
    given=ordered_moments,
    proof=Growing(M * sqrt(1 / I1 - 1 / I2) * sqrt(1 / I2 - 1 / I3)),
    where=line(49),
    note="The rotation about the intermediate axis. How M leaves it is told by `leaves_e2`.",
    quotes=(MOTION,),
)

points_of_the_sphere = Claim(
    says=Tuple(stable_e3.says, unstable_e2.says),
    given=ordered_moments,
    proof=all_of(stable_e3, unstable_e2),
    note="p₋ is the first point, p_D the second.",
    where=line(103),
)

sphere_at_rest = Claim(
    says=Tuple(*(equal(at(rate, {I2: I1, I3: I1}), 0) for rate in _rates)),
    given=(I1 > 0,),
    proof=by(evaluating),
    shown=r"\left.(\dot M_1, \dot M_2, \dot M_3)\right|_{I_1=I_2=I_3} = (0, 0, 0)",
    note="If the three moments are equal, M is constant in the body.",
)

any_rigid_body_is_unstable = Claim(
    says="In any rigid body the rotation about the second axis is unstable.",
    means=_square2 > 0,
    given=(I1 > 0, I2 - I1 >= 0, I3 - I2 >= 0, M > 0),
    proof=Counterexample({"I1": fmpq(1), "I2": fmpq(1), "I3": fmpq(1), "M": fmpq(1)}),
    where=line(49),
    amended_by=(stable_e1, stable_e3, unstable_e2, sphere_at_rest),
    note=(
        "The statement is true if the three moments are different: the formula is the square "
        "of the eigenvalue. A body with three equal moments rotates uniformly about any axis."
    ),
)

_products = (M2 * M3, M1 * M3, M1 * M2)
_inverse = (-I2 * I3 / (I3 - I2), I1 * I3 / (I3 - I1), -I1 * I2 / (I2 - I1))

permanent_rotations = Claim(
    says=Tuple(
        *(
            Equivalent(equal(rate, 0), equal(product, 0))
            for rate, product in zip((dM1_dt, dM2_dt, dM3_dt), _products, strict=True)
        )
    ),
    given=ordered_moments,
    proof=together(
        *(by(multiplying(factor), substituting(momentum.eq_dMi)) for factor in _inverse)
    ),
    note="M is constant exactly if two components vanish: at ±M along each of the three axes.",
)

_to = ((1, 0, 0), (0, -1, 0), (0, 0, 1))
_distances = [sum((m - p) ** 2 for m, p in zip(_components, point, strict=True)) for point in _to]

three_equilibria = Claim(
    says="The dynamics has three equilibrium points and no more: p₊, p₋ and p_D.",
    paper_says="“Figure 3 shows the three equilibrium points p₊, p₋ and p_D of the dynamics.” "
    "Read as: up to the sign of M.",
    means=Under(
        equal(_distances[0] * _distances[1] * _distances[2], 0),
        Tuple(*equations((*_rates,), (0, 0, 0)), equal(M1**2 + M2**2 + M3**2, 1)),
    ),
    given=(I1 > 0, I2 - I1 > 0, I3 - I2 > 0),
    proof=Counterexample(
        {"I1": fmpq(1), "I2": fmpq(2), "I3": fmpq(3), "M1": fmpq(-1), "M2": fmpq(0), "M3": fmpq(0)}
    ),
    where=line(103),
    amended_by=(permanent_rotations,),
    note=(
        "The opposite of each is an equilibrium, too, so there are "
        "six, or three up to the sign of M."
    ),
)

three_equilibria_and_opposites = Claim(
    says=Tuple(stable_e1.says, stable_e3.says, unstable_e2.says),
    given=ordered_moments,
    proof=all_of(stable_e1, stable_e3, unstable_e2),
    note="p₊, p₋ and p_D; that there are no others but their opposites is `permanent_rotations`.",
    where=line(110),
)

transverse_velocity = Claim(
    says=Tuple(
        M**2 * sin(theta) ** 2 / I3**2 <= W2**2 + W3**2,
        M**2 * sin(theta) ** 2 / I2**2 >= W2**2 + W3**2,
    ),
    given=ordered_moments,
    proof=by(substituting(velocity_from_momentum, eq_Mi)),
    note="The rotation perpendicular to the handle has the size of sin θ; it is 0 only at p₊.",
)

only_about_the_handle = Claim(
    says="Not only at p₊ but all around it the racket rotates about its handle alone.",
    paper_says="“Around this stable equilibrium point, the racket rotates only about its handle.” "
    "Read as: at p₊, and nearly so close to it.",
    means=equations(
        (M * sin(theta) * cos(psi) / I2, M * sin(theta) * sin(psi) / I3), (Integer(0), Integer(0))
    ),
    given=(*ordered_moments, theta > 0, theta < pi / 12),
    proof=Counterexample(
        {
            "I1": fmpq(1),
            "I2": fmpq(2),
            "I3": fmpq(3),
            "M": fmpq(1),
            "theta": fmpq(1, 10),
            "psi": fmpq(0),
        }
    ),
    where=line(103),
    amended_by=(transverse_velocity,),
    note="The statement is true at p₊; near p₊ the components Ω₂ and Ω₃ are small, but not zero.",
)

label_claims(globals())
