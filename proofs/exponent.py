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
  `root_above_one` and by `turn_increases`, as the turn vanishes at e = 0; see `leading_below`.
"""

from __future__ import annotations

from tresym.proofs.conditions import defect, shape

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

label_claims(globals())
