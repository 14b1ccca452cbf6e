"""The separatrix equation as one exponent, and the lower bound that follows by hand.

ε* = 2√(a/(a+b)) e^{−√(ab)(π + arcsin μ)}, μ = √(b/(a+b)), is the leading term of ε₀.

- `logarithmic_equation`: the stable equation is log(ε₀/ε*) = Q(ε₀), where
  Q(e) = log(e/sin e) + log((cos e + ρ)/2) + √(ab)(arcsin μ − arcsin(μ cos e)),
  ρ = √(1 + (b/a) sin²e);
- `sine_of_turn`: the sine of that difference of angles, in a form without cancellation;
- `inverse_by_cotangent`: the other side of the equation for ε₀ by the hyperbolic arsine;
- `arctangent_concave`, `arsinh_concave`: f(tx) ≥ t f(x) for these concave functions, 0 ≤ t ≤ 1;
- `arctangent_above`: x − arctan x ≤ x³/3, which `leading_below` uses.
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

inverse_by_cotangent = Claim(
    says=equal(-cos(epsilon) / _root, -tanh(asinh(_cosine * cos(epsilon) / sin(epsilon)))),
    given=(*shape, *defect),
    proof=by(roots, trigonometry),
)

sine_of_turn = Claim(
    says=equal(sin(_turn), sqrt(b / a) * sin(epsilon) ** 2 / (cos(epsilon) + _root)),
    given=(*shape, *defect),
    proof=by(inverses, roots, trigonometry),
    note="Both arcsines are between 0 and π/2, so that their difference is the arcsine of the "
    "right side.",
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
