"""Abstract and introduction: what they promise, judged by what the proofs have shown.

- `planar_constraint`: the one case treated before, I₃ = I₁ + I₂, in terms of the shape;
- `general_formula`: the closed formula for bodies of every shape;
- `abstract_flip`: the effect itself.
"""

import sympy
from flint import fmpq
from sympy import Gt
from tresym.proofs.asymptotics import uniform_formulas
from tresym.proofs.conditions import defect, shape
from tresym.proofs.euler_angles import precession_forward, shape_and_depth
from tresym.proofs.frames import perfect_flip
from tresym.proofs.regimes import realizable as realizable_shape
from tresym.proofs.rigid_bodies import realizable
from tresym.proofs.separatrix import one_flip_defect

from tresym.claims.claim import (
    Claim,
    Counterexample,
    Place,
    all_of,
)
from tresym.formulas import printed
from tresym.notation import a, b, epsilon
from tresym.verdict import Verdict

abstract_flip = Claim(
    label="abstract_flip",
    says="The effect is a turn of the head by π during a turn of the handle by 2π.",
    kind="statement",
    proof=all_of(perfect_flip, precession_forward),
    where=Place(line=38),
)

planar_constraint = Claim(
    label="planar_constraint",
    says="The case studied before, I₃ = I₁ + I₂, is that of the shapes with b = 1/(a + 2).",
    kind="statement",
    proof=all_of(shape_and_depth, realizable),
    where=Place(line=45),
    note="These are the flat bodies; their shape has one parameter.",
)

_below_root = (
    *shape,
    *defect,
    1 - b * (a + 2) > 0,
    printed.separatrix_residual(epsilon, a, b, sympy) < 0,
)
"""Angles below the exact flip defect of a body that can exist: the residual is negative there."""

_far_off = Counterexample(
    {"a": fmpq(1, 10**6), "b": fmpq(499, 1000), "epsilon": fmpq(2, 5)},
    Gt(epsilon, 100 * printed.asymptotic_defect(a, b, sympy)),
)

general_formula = Claim(
    label="abstract_general_formula",
    says="The closed formula estimates every flip defect: it is never 100 times too small.",
    kind="statement",
    given=_below_root,
    proof=_far_off,
    where=Place(line=38),
    expect=Verdict.REFUTED,
    amended_by=(one_flip_defect, uniform_formulas),
    note="For a → 0 at fixed b the formula goes to 0 and the defect does not. The exact equation "
    "has one root for every shape; the formula is its limit for large ab.",
)

formula_for_any_body = Claim(
    label="intro_any_body",
    says="The closed formula gives the flip of any rigid body: it is never 100 times too small.",
    kind="statement",
    given=_below_root,
    proof=_far_off,
    where=Place(line=45),
    expect=Verdict.REFUTED,
    amended_by=(one_flip_defect, uniform_formulas),
)

shapes_of_bodies = Claim(
    label="shapes_of_bodies",
    says="Every rigid body has b ≤ 1/(a + 2) and b < 1/2, and equality in the first is a flat one.",
    kind="statement",
    proof=all_of(realizable_shape, planar_constraint),
)
