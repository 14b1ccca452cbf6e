"""Rigid bodies: what I₃ ≤ I₁ + I₂ means for the shape, and how perfect a flip can be.

- `realizable`: I₁ + I₂ − I₃ has the sign of 1 − b(a + 2);
- `product_below_one`: ab < 1 for every rigid body, and `product_is_approached`: no less will do;
- `rigid_body_floor`: on b = 1/(a+2) (planar bodies) ε₀ > 2 arctan e^{−π}, for every a > 0;
- `floor_is_approached`: and ε₀ < 2 arctan e^{−π} + 1/(a+1) there, for every a ≥ 7, so it is the
  infimum; with `monotonicity` that is so for every body, `floor_of_every_body`.

With u = 1/(a + 1) planar bodies have μ = u and √(ab) = c/(1 + u), c = √(1 − u²). For the candidate
e = 2 arctan e^{−π} (tan e = 1/sinh π, cos e = tanh π) the claim ε₀ > e is
arsinh(c sinh π) > c/(1+u) (π + arcsin(u tanh π)); arsinh is concave, so the left side is at least
cπ (`arsinh_concave`), and what is left is c u/(1+u) (π − arcsin(u tanh π)/u) > 0, `floor_split`.
"""

from __future__ import annotations

from typing import Any

from tresym.proofs.conditions import ordered_moments, shape
from tresym.proofs.exponent import arsinh_concave, exponent_gap, residual_increases
from tresym.proofs.monotonicity import monotonicity
from tresym.proofs.separatrix import one_flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.near.charts import arcsine_over
from tresym.racket.notation import *
from tresym.reals.balls.gradient import coordinates, gradients
from tresym.reals.numbers.arithmetic import balls

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
    proof=Asymptotics(),
    note="So no bound below 1 holds for every rigid body.",
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
    proof=together(by(), by(), by(roots), by(roots)),
    note="With a = 1/u − 1: a planar body, the factor of its equation, √(ab) and μ.",
)

_angle = 2 * atan(exp(-pi))

floor_angle = Claim(
    says=Tuple(equal(cos(_angle) / sin(_angle), sinh(pi)), equal(cos(_angle), tanh(pi))),
    proof=by(exponentials, inverses, trigonometry),
    note="The candidate for the floor.",
)

_turned = asin(_u * tanh(pi))

floor_split = Claim(
    says=equal(
        asinh(_c * sinh(pi)) - _c / (1 + _u) * (pi + _turned),
        asinh(_c * sinh(pi)) - _c * asinh(sinh(pi)) + _c * _u / (1 + _u) * (pi - _turned / _u),
    ),
    given=_some,
    proof=by(algebra),
    note="Q(e) − log(e/ε*) at the candidate: not negative, and what the bound is about.",
)


def _floor_margin(u: Any, m: Any) -> Any:
    """π − tanh π · arcsin(u tanh π)/(u tanh π)."""
    tangent = balls.pi.tanh()
    return balls.pi - tangent * arcsine_over(u * tangent)


_planar = (one_flip_defect, realizable, residual_increases, exponent_gap, planar_shape, floor_angle)

rigid_body_floor = Claim(
    says="ε₀ > 2 arctan e^{−π} = 0.08637… for every planar body, b = 1/(a + 2), a > 0.",
    proof=Boxes(
        (Bound(_floor_margin, box((0, 1)), sufficient=True),),
        ("u",),
        "b = 1/(a+2), a > 0, u = 1/(a+1)",
        claims=(*_planar, floor_split, arsinh_concave),
        stored=certificate("rigid_body_floor"),
    ),
    note="At fixed a the defect decreases in b, so that planar bodies have the least.",
)


_above = _angle + _u
_excess = _c / (1 + _u) * (pi + asin(_u * cos(_above))) - asinh(_c * cos(_above) / sin(_above))

excess_at_infinity = Claim(
    says=equal(at(_excess, {_u: 0}), 0),
    proof=by(evaluating, exponentials, inverses, roots, trigonometry),
    shown=r"\left.\log(e/\epsilon_*) - Q(e)\right|_{e = 2\arctan e^{-\pi},\, u = 0} = 0",
    note="log(e/ε*) − Q(e) at e = 2 arctan e^{−π} + u, in the limit a → ∞, where u = 1/(a+1) is 0.",
)


def _excess_at(u: Any, m: Any) -> Any:
    """The same for numbers."""
    e = 2 * m.atan(m.exp(-m.pi)) + u
    c = m.sqrt(1 - u * u)
    return c / (1 + u) * (m.pi + m.asin(u * m.cos(e))) - m.asinh(c / m.tan(e))


def _excess_slope(u: Any, m: Any) -> Any:
    """The derivative of the excess: by the mean value theorem the excess has its sign."""
    (at,) = coordinates((u,))
    return _excess_at(at, gradients).slopes[0]


floor_is_approached = Claim(
    says="ε₀ < 2 arctan e^{−π} + 1/(a + 1) for every planar body with a ≥ 7.",
    proof=Boxes(
        (Bound(_excess_slope, box((0, "1/8")), sufficient=True),),
        ("u",),
        "b = 1/(a+2), a >= 7, u = 1/(a+1)",
        claims=(*_planar, excess_at_infinity),
        stored=certificate("floor_is_approached"),
    ),
    note="log(e/ε*) − Q(e) at e = 2 arctan e^{−π} + u is 0 in the limit u = 0 and grows with u, so "
    "that ε₀ < e. Hence the floor is the infimum, approached by planar bodies as a → ∞.",
)

floor_of_every_body = Claim(
    says="2 arctan e^{−π} is the infimum of ε₀ over all rigid bodies, and none attains it.",
    proof=all_of(realizable, monotonicity, rigid_body_floor, floor_is_approached),
    note="Of the bodies with one a, ε₀ decreases in b up to the planar b = 1/(a + 2).",
)

label_claims(globals())
