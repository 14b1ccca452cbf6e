"""Rigid bodies: what I₃ ≤ I₁ + I₂ means for the shape, and how perfect a flip can be.

- `realizable`: I₁ + I₂ − I₃ has the sign of 1 − b(a + 2);
- `product_below_one`: ab < 1 for every rigid body; `product_is_approached`: the bound 1 is sharp;
- `rigid_body_floor`: on b = 1/(a+2) (planar bodies) ε₀ > 2 arctan e^{−π}, for every a > 0;
- `floor_is_approached`: there ε₀ < 2 arctan e^{−π} + 1/(a+1) for every a ≥ 7, so this is the
  infimum; by `monotonicity` the bound holds for every body, `floor_of_every_body`.

With u = 1/(a + 1), planar bodies have μ = u and √(ab) = c/(1 + u), c = √(1 − u²). For the candidate
e = 2 arctan e^{−π} (tan e = 1/sinh π, cos e = tanh π) the claim ε₀ > e is
arsinh(c sinh π) > c/(1+u) (π + arcsin(u tanh π)). Since arsinh is concave, the left side is at
least cπ (`arsinh_concave`), and it remains to show c u/(1+u) (π − arcsin(u tanh π)/u) > 0:
`floor_candidate`.
"""

from __future__ import annotations

from typing import Any

from tresym.proofs.conditions import ordered_moments, shape
from tresym.proofs.exponent import arsinh_concave, exponent_gap, residual_increases, share
from tresym.proofs.monotonicity import monotonicity
from tresym.proofs.separatrix import one_flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.bounds.charts import arcsine_over
from tresym.racket.notation import *

realizable = Claim(
    says=equal(1 - (1 - I2 / I3) * ((I2 / I1 - 1) + 2), I2 * (I1 + I2 - I3) / (I1 * I3)),
    given=ordered_moments,
    proof=by(algebra),
    note="So b ≤ 1/(a + 2) exactly when I₃ ≤ I₁ + I₂.",
)

product_below_one = Claim(
    says=1 - a * b > 0,
    given=(*shape, 1 - b * (a + 2) >= 0),
    proof=manifest,
    note="b ≤ 1/(a + 2) for rigid bodies.",
)

product_is_approached = Claim(
    says="For planar bodies, b = 1/(a + 2), the product ab = a/(a + 2) tends to 1 as a → ∞.",
    means=order(equal(a / (a + 2), 1 + Function("o")(Integer(1))), a, oo),
    proof=Squeezed(Integer(2)),
    note="Hence no bound below 1 holds for every rigid body.",
)

_u = Symbol("u", real=True)
_c = sqrt(1 - _u**2)
_a, _b = 1 / _u - 1, _u / (1 + _u)
_some = (_u > 0, _u < 1)

planar_shape = Claim(
    says=Tuple(
        equal(1 / (_a + 2), _b),
        equal(sqrt(_a / (_a + _b)), _c),
        equal(sqrt(_a * _b), _c / (1 + _u)),
        equal(sqrt(_b / (_a + _b)), _u),
    ),
    given=_some,
    proof=by(roots),
    note="With a = 1/u − 1: a planar body, the factor of its equation, √(ab) and μ.",
)

_angle = 2 * atan(exp(-pi))

floor_angle = Claim(
    says=Tuple(equal(cos(_angle) / sin(_angle), sinh(pi)), equal(cos(_angle), tanh(pi))),
    proof=by(exponentials, inverses, trigonometry),
    note="The candidate for the lower bound.",
)

_turned = asin(_u * tanh(pi))

_concave = asinh(_c * sinh(pi)) - _c * asinh(sinh(pi))
_share_of_c = Instance(arsinh_concave, ((share, _c), (x, sinh(pi))))
concave_at_the_floor = Claim(says=_share_of_c.says, given=_some, proof=_share_of_c)


def _floor_margin(u: Any, m: Any) -> Any:
    """π − tanh π · arcsin(u tanh π)/(u tanh π)."""
    tangent = m.tanh(m.pi)
    return m.pi - tangent * arcsine_over(u * tangent)


floor_candidate = Claim(
    says=asinh(_c * sinh(pi)) - _c / (1 + _u) * (pi + _turned) > 0,
    given=_some,
    proof=Charted(
        (On((_u,), box((0, 1)), (Shown(_floor_margin, _c * _u / (1 + _u), _concave),)),),
        cited=(concave_at_the_floor,),
        stored=certificate("floor_candidate"),
    ),
    note="Q(e) − log(e/ε*) at the candidate.",
)

_planar = (one_flip_defect, realizable, residual_increases, exponent_gap, planar_shape)

rigid_body_floor = Claim(
    says="ε₀ > 2 arctan e^{−π} = 0.08637… for every planar body, b = 1/(a + 2), a > 0.",
    kind="bound",
    proof=all_of(floor_candidate, *_planar, floor_angle),
    note="At fixed a the defect decreases in b, so planar bodies have the smallest.",
)

_above = _angle + _u
_excess = _c / (1 + _u) * (pi + asin(_u * cos(_above))) - asinh(_c * cos(_above) / sin(_above))

excess_at_infinity = Claim(
    says=equal(at(_excess, {_u: 0}), 0),
    proof=by(evaluating, exponentials, inverses, roots, trigonometry),
    shown=r"\left.\log(e/\epsilon_*) - Q(e)\right|_{e = 2\arctan e^{-\pi},\, u = 0} = 0",
    note="log(e/ε*) − Q(e) at e = 2 arctan e^{−π} + u, in the limit a → ∞, where u = 1/(a+1) is 0.",
)

excess_grows = Claim(
    says=Derivative(_excess, _u) > 0,
    given=(_u >= 0, _u <= Rational(1, 8)),
    proof=Evaluated(stored=certificate("excess_grows")),
)

floor_is_approached = Claim(
    says="ε₀ < 2 arctan e^{−π} + 1/(a + 1) for every planar body with a ≥ 7.",
    kind="bound",
    proof=all_of(excess_grows, excess_at_infinity, *_planar),
    note="log(e/ε*) − Q(e) at e = 2 arctan e^{−π} + u is 0 in the limit u = 0 and grows with u, so "
    "that ε₀ < e. Hence the floor is the infimum, approached by planar bodies as a → ∞.",
)

floor_of_every_body = Claim(
    says="2 arctan e^{−π} is the infimum of ε₀ over all rigid bodies, and none attains it.",
    proof=all_of(realizable, monotonicity, rigid_body_floor, floor_is_approached),
    note="Among the bodies with the same a, ε₀ decreases in b up to the planar body b = 1/(a + 2).",
)

label_claims(globals())
