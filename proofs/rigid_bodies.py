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

from tresym.proofs import euler_angles, exponent, monotonicity
from tresym.proofs.conditions import ordered_moments, shape
from tresym.proofs.separatrix import flip_defect

from tresym.ledger.vocabulary import *
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
    proof=Decided(),
    kind="order",
    expect=Verdict.PROVED,
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
_share_of_c = Instance(exponent.arsinh_concave, ((Symbol("c", real=True), _c), (x, sinh(pi))))
concave_at_the_floor = Claim(says=_share_of_c.says, given=_some, proof=_share_of_c)


floor_candidate = Claim(
    says=asinh(_c * sinh(pi)) - _c / (1 + _u) * (pi + _turned) > 0,
    given=_some,
    proof=Decided(also=(concave_at_the_floor,)),
    note="Q(e) − log(e/ε*) at the candidate.",
)

planar_shapes = (a > 0, equal(b, 1 / (a + 2)))
"""The shapes of planar bodies; see `planar_constraint`."""

_at = 1 / (a + 1)
_in_a = {_u: _at}
_candidate = Instance(floor_candidate, ((_u, _at),))
floor_in_a = Claim(says=_candidate.says, given=(a > 0,), proof=_candidate)

_later = asinh(_c * sinh(pi)).xreplace(_in_a)
_sooner = (_c / (1 + _u) * (pi + _turned)).xreplace(_in_a)

tangent_grows = Claim(says=tanh(T + x) - tanh(T) > 0, given=(T > 0, x > 0), proof=manifest)

positive_sooner = Claim(says=_sooner > 0, given=(a > 0,), proof=manifest)

_tangents = Instance(
    tangent_grows, ((T, _sooner), (x, _later - _sooner)), (floor_in_a, positive_sooner)
)
tangents_at_the_floor = Claim(says=_tangents.says, given=(a > 0,), proof=_tangents)

rigid_body_floor = Claim(
    says=epsilon0 > _angle,
    given=planar_shapes,
    proof=RootBound(
        flip_defect,
        (
            step(
                tanh(_sooner + (_later - _sooner)) - tanh(_sooner),
                *(roots, exponentials, inverses, trigonometry, citing(tangents_at_the_floor)),
            ),
        ),
    ),
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
    proof=Decided(),
)

_first = (_u > 0, _u <= Rational(1, 8))

excess = Claim(says=_excess > 0, given=_first, proof=FromSlope(excess_grows, excess_at_infinity))

_excess_in_a = Instance(excess, ((_u, _at),))
excess_in_a = Claim(says=_excess_in_a.says, given=(a >= 7,), proof=_excess_in_a)

_beyond = (_c / (1 + _u) * (pi + asin(_u * cos(_above)))).xreplace(_in_a)
_short = asinh(_c * cos(_above) / sin(_above)).xreplace(_in_a)

_candidate_above = _angle + _at

above_is_an_angle = Claim(
    says=Tuple(
        _candidate_above > 0,
        _candidate_above < pi / 2,
        sin(_candidate_above) > 0,
        cos(_candidate_above) > 0,
    ),
    given=(a >= 7,),
    proof=manifest,
)

_inverse_above = Instance(
    exponent.inverse_by_cotangent,
    ((epsilon, _candidate_above), (b, 1 / (a + 2))),
    (above_is_an_angle,),
)
inverse_above = Claim(
    says=_inverse_above.says,
    given=(a >= 7,),
    proof=_inverse_above,
    shown=r"-\frac{\cos e}{\sqrt{1+\frac ba\sin^2e}} = -\tanh\operatorname{arsinh}\left("
    r"\sqrt{\tfrac{a}{a+b}}\cot e\right),\quad e = 2\arctan e^{-\pi}+\tfrac{1}{a+1},\quad "
    r"b = \tfrac{1}{a+2}",
)

positive_short = Claim(says=_short > 0, given=(a >= 7,), proof=manifest)

_tangents_above = Instance(
    tangent_grows, ((T, _short), (x, _beyond - _short)), (excess_in_a, positive_short)
)
tangents_above = Claim(
    says=_tangents_above.says,
    given=(a >= 7,),
    proof=_tangents_above,
    shown=r"\tanh\bigl(\sqrt{ab}\,(\pi+\arcsin(u\cos e))\bigr)-\tanh\operatorname{arsinh}"
    r"\bigl(\sqrt{1-u^2}\cot e\bigr) > 0,\quad e = 2\arctan e^{-\pi}+u,\quad u = \tfrac{1}{a+1},"
    r"\quad b = \tfrac{1}{a+2}",
)

floor_is_approached = Claim(
    says=epsilon0 < _candidate_above,
    given=(a >= 7, equal(b, 1 / (a + 2))),
    proof=RootBound(
        flip_defect,
        (
            step(
                tanh(_beyond) + _inverse_above.says.args[0],
                *(roots, citing(above_is_an_angle)),
            ),
            step(
                tanh(_beyond) + _inverse_above.says.args[1],
                *(substituting(inverse_above), citing(above_is_an_angle)),
            ),
            step(
                tanh(_short + (_beyond - _short)) - tanh(_short),
                *(roots, citing(tangents_above, above_is_an_angle)),
            ),
        ),
    ),
    note="h at e = 2 arctan e^{−π} + u is 0 in the limit u = 1/(a + 1) = 0 and grows with u.",
)

floor_of_shapes = Claim(
    says=epsilon0 > _angle,
    given=(*shape, 1 - b * (a + 2) >= 0),
    proof=FromTheEdge(monotonicity.monotonicity, rigid_body_floor, 1 / (a + 2)),
    note="Among the bodies with the same a, ε₀ decreases in b up to the planar body b = 1/(a + 2).",
)

_t = Symbol("t", real=True)

floor_of_every_body = Claim(
    says=Infimum(epsilon0, _angle),
    given=(*ordered_moments, I1 + I2 - I3 >= 0),
    proof=InfimumBy(
        floor_of_shapes,
        floor_is_approached,
        ((I1, Integer(1)), (I2, 1 / _t), (I3, 1 + 1 / _t), (M, Integer(1))),
        (euler_angles.d08,),
    ),
    note="Over all rigid bodies; it is approached by planar bodies as a → ∞.",
)

label_claims(globals())
