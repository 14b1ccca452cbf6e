"""Monotonicity: ε₀ decreases strictly in a at fixed b and in b at fixed a, on the whole domain.

By `stable_equation` log tan ε₀ = ½ log(a/(a+b)) − log sinh T, where T is the only root of
g = T − √(ab)(π + arctan(√(b/a) tanh T)). With S = cosh²T + (b/a) sinh²T and D = 1 − b/S:

- `slope_in_T`, `slope_in_T_positive`: ∂g/∂T = D > 0;
- `slope_in_a`, `slope_in_b`: −∂g/∂a and −∂g/∂b at the root, so that dT/da = −(∂g/∂a)/D;
- `decrease_in_a`: −2aD d(log tan ε₀)/da = (T coth T − 1) + (1 − b)/(1 + b/a), which is positive
  because tanh T < T by `tangent_below`;
- `increase_of_T`: −∂g/∂b > 0, so that T increases with b, while √(a/(a+b)) decreases.
"""

from tresym.proofs.conditions import later, shape
from tresym.proofs.separatrix import one_flip_defect, stable_equation

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

_ratio = b / a
_spread = cosh(T) ** 2 + _ratio * sinh(T) ** 2
_slope = 1 - b / _spread
_g = T - sqrt(a * b) * (pi + atan(sqrt(b / a) * tanh(T)))
_share = tanh(T) / (1 + _ratio * tanh(T) ** 2)

slope_in_T = Claim(
    says=equal(Derivative(_g, T), _slope),
    given=(*shape, *later),
    proof=by(differentiation, exponentials, roots),
)

slope_in_T_positive = Claim(says=_slope > 0, given=(*shape, *later), proof=manifest)

slope_in_a = Claim(
    says=equal(-Derivative(_g, a), (T - _g) / (2 * a) - b * _share / (2 * a)),
    given=(*shape, *later),
    proof=by(differentiation, roots),
    note="At the root g = 0, so the first term is T/(2a).",
)

slope_in_b = Claim(
    says=equal(-Derivative(_g, b), (T - _g) / (2 * b) + _share / 2),
    given=(*shape, *later),
    proof=by(differentiation, roots),
)

decrease_in_a = Claim(
    says=equal(
        -2 * a * (_slope * b / (2 * a * (a + b)) - (T - b * _share) / (2 * a) * cosh(T) / sinh(T)),
        (T * cosh(T) / sinh(T) - 1) + (1 - b) / (1 + _ratio),
    ),
    given=(*shape, *later),
    proof=by(exponentials),
    note="The left side is −2aD d(log tan ε₀)/da with dT/da = (T − bw)/(2aD), w the share of b.",
)

tangent_below = Claim(says=sinh(T) <= T * cosh(T), given=(T > 0,), proof=manifest)

increase_of_T = Claim(says=T / (2 * b) + _share / 2 > 0, given=(*shape, *later), proof=manifest)

monotonicity = Claim(
    says="ε₀ decreases strictly in a for fixed b, and in b for fixed a, for a > 0, 0 < b ≤ 1.",
    proof=all_of(
        stable_equation,
        one_flip_defect,
        slope_in_T,
        slope_in_T_positive,
        slope_in_a,
        slope_in_b,
        decrease_in_a,
        tangent_below,
        increase_of_T,
    ),
)

label_claims(globals())
