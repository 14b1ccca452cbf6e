"""Section 3, end: bodies with two equal moments.

- `sphere_ellipsoid`: three equal moments;
- `depth_b_zero`, `theta_constant`, `psi_linear`: I₂ = I₃, only rotating motions;
- `depth_a_zero`: I₁ = I₂, only oscillating motions.
"""

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

_moments = (I1 > 0, I2 - I1 > 0, I2 > 0, M > 0)

_at_rest = printed.euler_equations(M1, M2, M3, I1, I2, I3)

sphere_ellipsoid = Claim(
    says=equal(
        printed.energy(M1, M2, M3, I1, I1, I1), printed.momentum_squared(M1, M2, M3) / (2 * I1)
    ),
    given=(I1 > 0,),
    proof=by(),
    where=line(112),
    note="For three equal moments the energy surface is a sphere.",
)

_first = M * cos(theta)
_third = M * sin(theta) * sin(psi)

depth_b_zero = Claim(
    says=equal(M**2 * printed.depth(theta, psi, a, 0, sympy), a * _first**2),
    proof=by(trigonometry),
    note="I₂ = I₃: γ M² = a M₁².",
)

no_oscillating_I2_I3 = Claim(
    says=printed.depth(theta, psi, a, 0, sympy) >= 0,
    given=(a > 0,),
    proof=manifest,
    where=line(112),
    note="I₂ = I₃: γ is never negative.",
)

separatrix_equator = Claim(
    **jointly(depth_b_zero, no_oscillating_I2_I3),
    where=line(112),
)

circle_e1 = Claim(
    says=Tuple(
        equal(at(_at_rest[0], {I3: I2}), 0),
        equal(at(2 * M2 * _at_rest[1] + 2 * M3 * _at_rest[2], {I3: I2}), 0),
    ),
    given=_moments,
    proof=by(evaluating),
    where=line(112),
    note="I₂ = I₃: M₁ and M₂² + M₃² are constant, so that M stays on a circle about e₁.",
    shown=r"I_2 = I_3:\quad \dot M_1 = 0,\quad \frac{d}{dt}\left(M_2^2 + M_3^2\right) = 0",
)

_other = Symbol("N1", real=True)

one_circle_e1 = Claim(
    says="For I₂ = I₃ the two surfaces meet in one circle and no more.",
    paper_says="“The intersection of the two surfaces is a circle centered on e₁.” Read as: the "
    "one on which a solution runs.",
    means=Under(equal(M1, _other), Tuple(equal(a * M1**2, a * _other**2))),
    given=(a > 0, M > 0),
    proof=Counterexample({"a": fmpq(1), "M": fmpq(2), "M1": fmpq(1), "N1": fmpq(-1)}),
    where=line(112),
    amended_by=(depth_b_zero, circle_e1),
    note=(
        "The two surfaces intersect in two circles, M₁ = ±M√(γ/a), and a solution stays on "
        "one of them; on the separatrix the two circles coincide."
    ),
)

_rates = printed.angle_rates(theta, psi, M, I1, I2, I3, sympy)

theta_constant = Claim(
    says=equal(at(_rates[0], {I3: I2}), 0),
    given=_moments,
    proof=by(evaluating),
    where=line(112),
    shown=r"\dot\theta = M\left(\frac{1}{I_2}-\frac{1}{I_2}\right)\sin\theta\sin\psi\cos\psi = 0",
)

psi_linear = Claim(
    says=equal(at(_rates[2], {I3: I2}), M * (1 / I1 - 1 / I2) * cos(theta)),
    given=_moments,
    proof=by(evaluating, trigonometry),
    where=line(112),
    note="I₂ = I₃: θ is constant, so ψ grows at a constant rate.",
)

depth_a_zero = Claim(
    says=equal(M**2 * at(printed.depth(theta, psi, a, b, sympy), {a: 0}), -b * _third**2),
    proof=by(evaluating),
    note="I₁ = I₂: γ M² = −b M₃².",
    shown=r"M^2\left.\gamma\right|_{a=0} = -bM_3^2",
)

only_oscillating_I1_I2 = Claim(
    says=printed.depth(theta, psi, 0, b, sympy) <= 0,
    given=(b > 0,),
    proof=manifest,
    where=line(112),
    note="I₁ = I₂: γ is never positive, so that no motion rotates. It is 0 on the circle M₃ = 0, "
    "where M rests (`rest_on_the_circle`).",
)

rest_on_the_circle = Claim(
    says=Tuple(*(equal(at(rate, {I2: I1, M3: 0}), 0) for rate in _at_rest)),
    given=(I1 > 0, I3 > 0),
    proof=by(evaluating),
    shown=r"\left.(\dot M_1, \dot M_2, \dot M_3)\right|_{I_1=I_2,\,M_3=0} = (0, 0, 0)",
)

separatrix_circle_e1e2 = Claim(
    **jointly(depth_a_zero, only_oscillating_I1_I2, rest_on_the_circle),
    where=line(112),
    note="Every point of it is an equilibrium.",
)

label_claims(globals())
