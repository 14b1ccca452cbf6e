"""The separatrix equation as one exponent, and the lower bound that follows by hand.

ε* = 2√(a/(a+b)) e^{−√(ab)(π + arcsin μ)}, μ = √(b/(a+b)), is the leading term of ε₀.

- `logarithmic_equation`: the stable equation is log(ε₀/ε*) = Q(ε₀), where
  Q(e) = log(e/sin e) + log((cos e + ρ)/2) + √(ab)(arcsin μ − arcsin(μ cos e)),
  ρ = √(1 + (b/a) sin²e);
- `sine_of_turn`: the sine of that difference of angles, in a form without cancellation;
- `residual_increases`: log e − Q(e) increases with e, so that ε₀ ≤ e exactly when
  Q(e) ≤ log(e/ε*). To bound ε₀ it therefore suffices to find one sign at an explicit candidate e;
- `exponent_gap`: Q(e) − log(e/ε*) without logarithms, for candidates e that are angles;
- `arctangent_concave`, `arsinh_concave`: f(tx) ≥ t f(x) for these concave functions, 0 ≤ t ≤ 1;
- `half_exponent`, `half_tangent`: log(tan(ε₀/2)/(ε*/2)) is a sum of two terms, positive by
  `root_above_one` and by `turn_increases`, as the turn vanishes at e = 0. Hence `leading_below`:
  ε₀ > 2 arctan(ε*/2), and by `arctangent_above` ε₀/ε* > 1 − ε*²/12, for every shape.
"""

from __future__ import annotations

from tresym.proofs.conditions import defect, shape
from tresym.proofs.near import exponent_of_defect, leading_by_defect, leading_term
from tresym.proofs.separatrix import defect_range, flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

_mu = sqrt(b / (a + b))
_cosine = sqrt(a / (a + b))
_root = sqrt(1 + b / a * sin(epsilon) ** 2)
_time = sqrt(a * b) * (pi + asin(_mu * cos(epsilon)))
_turn = asin(_mu) - asin(_mu * cos(epsilon))
_leading = 2 * _cosine * exp(-sqrt(a * b) * (pi + asin(_mu)))
exponent = log(epsilon / sin(epsilon)) + log((cos(epsilon) + _root) / 2) + sqrt(a * b) * _turn
"""Q(e)."""

logarithmic_equation = Claim(
    says=Equivalent(
        equal(_cosine / sinh(_time), tan(epsilon)), equal(exponent, log(epsilon / _leading))
    ),
    given=(*shape, *defect),
    proof=(
        step(
            equal(asinh(_cosine * cos(epsilon) / sin(epsilon)), _time),
            multiplying(cos(epsilon) * sinh(_time) / sin(epsilon)),
            applying("asinh"),
            *(exponentials, inverses, trigonometry),
        ),
        step(
            equal(log(_cosine * (cos(epsilon) + _root) / sin(epsilon)), _time),
            *(exponentials, inverses, roots, trigonometry),
        ),
        step(
            equal(exponent, log(epsilon / _leading)),
            adding(log(epsilon) - log(2 * _cosine) + sqrt(a * b) * _turn),
            *(exponentials, inverses, roots),
        ),
    ),
    note="Solved for the logarithm of ε₀/ε*; the other side is Q(ε₀).",
)

exponent_gap = Claim(
    says=equal(
        exponent - log(epsilon / _leading), asinh(_cosine * cos(epsilon) / sin(epsilon)) - _time
    ),
    given=(*shape, *defect),
    proof=by(exponentials, inverses, roots, trigonometry),
    note=(
        "Since log e − Q(e) increases, ε₀ is larger than e if this "
        "is positive, and smaller than e if it is negative."
    ),
)

inverse_by_cotangent = Claim(
    says=equal(-cos(epsilon) / _root, -tanh(asinh(_cosine * cos(epsilon) / sin(epsilon)))),
    given=(*shape, *defect),
    proof=by(roots, trigonometry),
)

sine_of_turn = Claim(
    says=equal(sin(_turn), sqrt(b / a) * sin(epsilon) ** 2 / (cos(epsilon) + _root)),
    given=(*shape, *defect),
    proof=by(inverses, roots, trigonometry),
    note="Both arcsines are between 0 and π/2, so that their difference is the arcsine of this.",
)

residual_increases = Claim(
    says=Derivative(log(epsilon) - exponent, epsilon) > 0,
    given=(*shape, *defect),
    proof=(
        step(
            (cos(epsilon) ** 2 + (1 - b) * sin(epsilon) ** 2) / (sin(epsilon) * _root),
            differentiation,
            trigonometry,
            roots,
        ),
    ),
    note="The derivative is (1 − b sin²e)/(sin e √(1 + (b/a) sin²e)).",
)

half_exponent = Claim(
    says=equal(
        exponent + log(2 * sin(epsilon) / (epsilon * (1 + cos(epsilon)))),
        log((cos(epsilon) + _root) / (1 + cos(epsilon))) + sqrt(a * b) * _turn,
    ),
    given=(*shape, *defect),
    proof=by(exponentials),
)

half_tangent = Claim(
    says=equal(tan(epsilon / 2), sin(epsilon) / (1 + cos(epsilon))),
    given=defect,
    proof=by(trigonometry),
)

root_above_one = Claim(says=_root > 1, given=(*shape, *defect), proof=manifest)

turn_increases = Claim(
    says=Derivative(_turn, epsilon) > 0, given=(*shape, *defect), proof=by(differentiation)
)

arctangent_above = Claim(says=x - atan(x) <= x**3 / 3, given=(x > 0,), proof=manifest)

share = Symbol("c", real=True)
_part = (x > 0, share > 0, share <= 1)

arctangent_concave = Claim(
    says=atan(share * x) - share * atan(x) >= 0,
    given=_part,
    proof=manifest,
    note="The ratio of two angles below π/2 lies between 1 and the ratio of their tangents.",
)

arsinh_concave = Claim(says=asinh(share * x) - share * asinh(x) >= 0, given=_part, proof=manifest)

_at_root = citing(flip_defect, defect_range)
_sine0, _cosine0 = sin(epsilon0), cos(epsilon0)
_root0 = sqrt(1 + b / a * _sine0**2)
_turn0 = asin(sqrt(b / a) * _sine0**2 / (_cosine0 + _root0))

leading_positive = Claim(says=epsilon_star > 0, given=shape, proof=by(substituting(leading_term)))

half_tangent_at_root = Claim(
    says=equal(
        tan(epsilon0 / 2),
        epsilon_star / 2 * (_cosine0 + _root0) / (1 + _cosine0) * exp(sqrt(a * b) * _turn0),
    ),
    given=shape,
    proof=(
        step(_sine0 / (1 + _cosine0), trigonometry, _at_root),
        step(
            epsilon0
            * exp(-Q)
            / 2
            * (_cosine0 + _root0)
            / (1 + _cosine0)
            * exp(sqrt(a * b) * _turn0),
            *(substituting(exponent_of_defect), exponentials, _at_root),
        ),
        step(None, substituting(leading_by_defect), _at_root),
    ),
)

half_tangent_above = Claim(
    says=tan(epsilon0 / 2) > epsilon_star / 2,
    given=shape,
    proof=(
        step(
            epsilon_star
            / 2
            * (
                (_root0 - 1) / (1 + _cosine0) * exp(sqrt(a * b) * _turn0)
                + (exp(sqrt(a * b) * _turn0) - 1)
            ),
            *(substituting(half_tangent_at_root), citing(leading_positive), _at_root),
        ),
    ),
)

_half = Instance(arctangent_above, ((x, epsilon_star / 2),), (leading_positive,))
arctangent_at_half = Claim(says=_half.says, given=shape, proof=_half)

half_angle_above = Claim(
    says=epsilon0 / 2 > atan(epsilon_star / 2),
    given=shape,
    proof=(
        step(
            tan(epsilon0 / 2) - epsilon_star / 2,
            *(
                applying("tan"),
                inverses,
                trigonometry,
                citing(half_tangent_above, leading_positive),
                _at_root,
            ),
        ),
    ),
)

leading_below = Claim(
    says=Tuple(
        epsilon0 / 2 > atan(epsilon_star / 2), epsilon0 / epsilon_star > 1 - epsilon_star**2 / 12
    ),
    given=shape,
    proof=follows(
        all_of(half_angle_above),
        (
            step(
                2
                / epsilon_star
                * (
                    (epsilon0 / 2 - atan(epsilon_star / 2))
                    + (epsilon_star**3 / 24 - epsilon_star / 2 + atan(epsilon_star / 2))
                ),
                citing(half_angle_above, arctangent_at_half, leading_positive),
            ),
        ),
    ),
    note="Equality would be attained in the limit b → 0, b/a → 0, where tan(ε₀/2) = e^{−π√(ab)}.",
)

label_claims(globals())
