"""Monotonicity: ε₀ decreases strictly in a at fixed b and in b at fixed a, on the whole domain.

ε₀ is the only zero of h = tanh T − cos ε/R, with T = √(ab)(π + arcsin(√(b/(a+b)) cos ε)) and
R = √(1 + (b/a) sin²ε), and h increases with ε (`defect_is_one`). Where h = 0, tanh T is cos ε/R,
and (2aR²/sin²ε) ∂h/∂a = (1 + b/a)(T − cos ε/R) + (1 − b) cos ε/R, which is positive because
tanh T < T (`time_above`). All terms of ∂h/∂b are positive. By the implicit function theorem ε₀
decreases.
"""

from tresym.proofs.conditions import later, shape
from tresym.proofs.separatrix import defect_range, flip_defect

from tresym.ledger.vocabulary import *
from tresym.racket.notation import *

_slope = 1 - b / (cosh(T) ** 2 + b / a * sinh(T) ** 2)

slope_in_T_positive = Claim(says=_slope > 0, given=(*shape, *later), proof=manifest)

tangent_below = Claim(says=sinh(T) <= T * cosh(T), given=(T > 0,), proof=manifest)

_root0 = sqrt(1 + b / a * sin(epsilon0) ** 2)
_inverse0 = cos(epsilon0) / _root0
_time0 = sqrt(a * b) * (pi + asin(sqrt(b / (a + b)) * cos(epsilon0)))

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
