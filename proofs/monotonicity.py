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
from tresym.proofs.separatrix import defect_range, flip_defect

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

_root0 = sqrt(1 + b / a * sin(epsilon0) ** 2)
_inverse0 = cos(epsilon0) / _root0
_time0 = sqrt(a * b) * (pi + asin(sqrt(b / (a + b)) * cos(epsilon0)))
_sine0 = sqrt(1 - b / (a + b) * cos(epsilon0) ** 2)

positive_time = Claim(says=_time0 > 0, given=shape, proof=manifest, note="T at the root.")

hyperbolic_tangent_below = Claim(says=tanh(x) < x, given=(x > 0,), proof=manifest)

_below = Instance(hyperbolic_tangent_below, ((x, _time0),), (positive_time,))
tangent_of_time = Claim(says=_below.says, given=shape, proof=_below)

time_above = Claim(
    says=_time0 > _inverse0,
    given=shape,
    proof=(step(_time0 - tanh(_time0), substituting(flip_defect), citing(tangent_of_time)),),
    note="At the root tanh T = cos ε₀/√(1 + (b/a) sin²ε₀), and tanh T < T.",
)

_slope_a = (_time0 / (2 * a)) - b * cos(epsilon0) / (2 * (a + b) * _root0)
_slope_b = _time0 / (2 * b) + a * cos(epsilon0) / (2 * (a + b) * _root0)
_sech = sin(epsilon0) ** 2 * (1 + b / a) / _root0**2

monotonicity = Claim(
    says=Tuple(StrictlyDecreasing(epsilon0, a), StrictlyDecreasing(epsilon0, b)),
    given=shape,
    proof=follows(
        RootMonotone(
            flip_defect,
            (
                step(
                    (1 - tanh(_time0) ** 2) * _slope_a
                    - b * sin(epsilon0) ** 2 * _inverse0 / (2 * a**2 * _root0**2),
                    *(roots, exponentials, trigonometry, citing(defect_range)),
                ),
                step(
                    (1 - _inverse0**2) * _slope_a
                    - b * sin(epsilon0) ** 2 * _inverse0 / (2 * a**2 * _root0**2),
                    *(substituting(flip_defect), roots, citing(defect_range)),
                ),
                step(
                    sin(epsilon0) ** 2
                    / (2 * a * _root0**2)
                    * ((1 + b / a) * (_time0 - _inverse0) + (1 - b) * _inverse0),
                    *(roots, trigonometry, citing(time_above, defect_range)),
                ),
            ),
        ),
        RootMonotone(
            flip_defect,
            (
                step(
                    (1 - tanh(_time0) ** 2) * _slope_b
                    + sin(epsilon0) ** 2 * _inverse0 / (2 * a * _root0**2),
                    *(roots, exponentials, trigonometry, citing(defect_range)),
                ),
                step(
                    (1 - _inverse0**2) * _slope_b
                    + sin(epsilon0) ** 2 * _inverse0 / (2 * a * _root0**2),
                    *(substituting(flip_defect), roots, citing(defect_range)),
                ),
                step(
                    _sech * _slope_b + sin(epsilon0) ** 2 * _inverse0 / (2 * a * _root0**2),
                    *(roots, trigonometry, citing(positive_time, defect_range)),
                ),
            ),
        ),
    ),
    note="ε₀ is the zero of h = tanh T − cos ε/√(1 + (b/a) sin²ε), which increases with ε; where "
    "h = 0, ∂h/∂a and ∂h/∂b are positive.",
)

label_claims(globals())
