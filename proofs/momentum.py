"""Section 3: Euler's equations and the two first integrals.

- display (4), `eq_dMi`: Euler's equations, from M fixed in space and Ω_i = M_i/I_i;
- (5), `two_first_integrals`: `energy` and `eq_first_int` are twice the energy and the length of M;
  `energy_conserved`, `momentum_conserved`: their derivatives along Euler's equations vanish.
"""

from tresym.proofs.conditions import ordered_moments
from tresym.proofs.model import eq_Mi, eq_omega, momentum_transport, velocity_from_momentum

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *


def along_euler(quantity: Expr) -> Expr:
    """Time derivative of a function of M₁, M₂, M₃, with the rates as symbols."""
    rates = {M1: dM1_dt, M2: dM2_dt, M3: dM3_dt}
    return sum(diff(quantity, component) * speed for component, speed in rates.items())


eq_dMi = Claim(
    says=equations((dM1_dt, dM2_dt, dM3_dt), printed.euler_equations(M1, M2, M3, I1, I2, I3)),
    given=ordered_moments,
    proof=by(substituting(momentum_transport, velocity_from_momentum)),
    where=display(4),
)

energy = Claim(says=equal(E, (I1 * W1**2 + I2 * W2**2 + I3 * W3**2) / 2), proof=Definition())

energy_of_momentum = Claim(
    says=equal(E, printed.energy(M1, M2, M3, I1, I2, I3)),
    given=ordered_moments,
    proof=by(substituting(energy, eq_omega)),
)

eq_first_int = Claim(
    says=Tuple(
        equal(2 * E, M1**2 / I1 + M2**2 / I2 + M3**2 / I3),
        equal(M**2, printed.momentum_squared(M1, M2, M3)),
    ),
    given=ordered_moments,
    proof=by(substituting(energy_of_momentum, eq_Mi), trigonometry),
    where=display(5),
)

energy_conserved = Claim(
    says=equal(along_euler(printed.energy(M1, M2, M3, I1, I2, I3)), 0),
    given=ordered_moments,
    proof=by(substituting(eq_dMi)),
)

momentum_conserved = Claim(
    says=equal(along_euler(printed.momentum_squared(M1, M2, M3)), 0),
    given=ordered_moments,
    proof=by(substituting(eq_dMi)),
)

components = Tuple(M1, M2, M3)
rates = Tuple(*printed.euler_equations(M1, M2, M3, I1, I2, I3))
"""Euler's equations: the components of M, and their rates."""

two_first_integrals = Claim(
    says=Tuple(
        Conserved(printed.energy(M1, M2, M3, I1, I2, I3), components, rates),
        Conserved(printed.momentum_squared(M1, M2, M3), components, rates),
    ),
    given=ordered_moments,
    proof=follows(Conservation(), Conservation()),
    note="The two constants are E and M², by `eq_first_int`.",
    where=display(5),
)

label_claims(globals())
