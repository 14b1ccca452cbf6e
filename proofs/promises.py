"""Abstract and introduction: what they promise, judged by what the proofs have shown.

- `planar_constraint`: the only case treated before the paper, I₃ = I₁ + I₂, in terms of the shape;
- `abstract_general_formula`: how well the closed formula estimates the effect;
- `formula_far_off`: it does not do so for every shape;
- `abstract_flip`: the tennis racket effect itself.
"""

from tresym.proofs import conclusion, euler_angles, regimes, table_of_objects
from tresym.proofs.asymptotics import printed_error, uniform_formulas
from tresym.proofs.conditions import defect, ordered_moments, shape
from tresym.proofs.frames import perfect_flip
from tresym.proofs.numbers_in_text import flip_of_no_flip, flip_str_exact, tre_if_eps0_small
from tresym.proofs.separatrix import one_flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.formulas import printed
from tresym.racket.notation import *

abstract_flip = Claim(
    **jointly(perfect_flip, euler_angles.precession_forward),
    where=line(38),
)

planar_constraint = Claim(
    says=Equivalent(equal(I3, I1 + I2), equal(1 / (a + 2), b)),
    given=ordered_moments,
    proof=by(
        multiplying(-I2 / (I3 * (I1 + I2))), adding(Integer(1)), substituting(euler_angles.d08)
    ),
    where=line(45),
    note="Bodies with I₃ = I₁ + I₂ are the planar bodies; their shapes form a one-parameter "
    "family.",
)

_below_root = (
    *shape,
    *defect,
    1 - b * (a + 2) > 0,
    printed.separatrix_residual(epsilon, a, b, sympy) < 0,
)
"""Angles below the exact flip defect of a body that can exist: the residual is negative there."""

_not_too_small = epsilon <= 100 * printed.asymptotic_defect(a, b, sympy)
_far_off = Counterexample({"a": fmpq(1, 10**6), "b": fmpq(499, 1000), "epsilon": fmpq(2, 5)})

formula_far_off = Claim(
    says="The closed formula gives the flip defect of every body to within a factor of 100.",
    means=_not_too_small,
    given=_below_root,
    proof=_far_off,
    amended_by=(printed_error, one_flip_defect, uniform_formulas),
    note="As a → 0 at fixed b the formula tends to 0 and the defect does not, so that bounds of "
    "its error need a condition such as ab ≥ 1/4.",
)

abstract_general_formula = Claim(
    **jointly(printed_error),
    where=line(38),
    note="How good the estimate is. The exact equation has one root for every shape; the formula "
    "is its limit for large ab.",
)

intro_any_body = Claim(
    **jointly(printed_error),
    where=line(45),
    note="How good the asymptotic formula is. For a rigid body ab < 1.",
)

coincide_large_class = Claim(
    **jointly(printed_error, uniform_formulas),
    where=line(47),
    note="How well is said by the two bounds; the second has the exact ε₀.",
)

variety_of_bodies = Claim(
    **jointly(
        table_of_objects.table_str_realizable,
        flip_str_exact,
        conclusion.ethylene,
        conclusion.ethylene_flip_exact,
        tre_if_eps0_small,
    ),
    where=line(38),
    note="The standard racket and ethylene can exist. The other rackets of Table 1 cannot, by "
    "their printed moments.",
)

some_bodies = Claim(
    **jointly(tre_if_eps0_small, flip_str_exact, flip_of_no_flip),
    where=line(318),
    note="The constraints on the moments that the conclusion speaks of.",
)

shapes_of_bodies = Claim(
    **jointly(regimes.realizable_shape, planar_constraint),
)

label_claims(globals())
