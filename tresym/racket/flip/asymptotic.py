"""The flip defect ε₀ by a closed formula, with a proved bound on its error.

With ε* the leading term, R = b/a and s = sin t, the exact separatrix equation is

    log(ε₀/ε*) = ∫₀^ε₀ [1/t − (1 − b s²)/(s √(1 + R s²))] dt,    0 < b ≤ 1,

and 1 − x/2 ≤ (1+x)^(−1/2) ≤ 1 − x/2 + 3x²/8, s ≤ t, 1/s ≥ 1/t + t/6 give the bounds

    c₁ε₀² − C ε₀⁴ ≤ log(ε₀/ε*) ≤ c₁ε₀²,
    C = K + (b + R/2)/24 + (bR/2 + 3R²/8)/4,    K = (log(4/π) − π²/48)/(π/2)⁴.

K comes from ∫₀^e (1/sin t − 1/t) dt = log(tan(e/2)/(e/2)): all Taylor coefficients are positive, so
that (… − e²/12)/e⁴ increases up to e = π/2. Starting with 0 < ε₀ < π/2, each application of the
bounds gives a narrower enclosure.
"""

from __future__ import annotations

import math
from functools import lru_cache
from typing import Any

from flint import arb, fmpq

from tresym.racket.flip.separatrix import LARGEST_ARGUMENT
from tresym.racket.formulas import stable
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits

SWEEPS = 3

LARGEST_K = fmpq(5905, 10**6)
"""An upper bound of the constant K = 0.0059046…."""


def enclose(a: fmpq, b: fmpq, digits: int) -> arb | None:
    """Return a ball around ε₀ at a precision for ``digits``, as narrow as the bounds allow.

    Returns:
        None if ε₀ is too small to be distinguished from 0; see
        :mod:`tresym.racket.flip.separatrix`.
    """
    with ball_precision(bits(digits, 84)):
        p, q = arb(a), arb(b)
        k, R = (p * q).sqrt(), q / p
        if k > LARGEST_ARGUMENT:
            return None
        r = R.sqrt()
        leading, first = stable.leading_term(k, r, balls), stable.first_coefficient(k, r)
        second = arb(0).union(_quartic(q, R))
        defect = arb(0).union(arb.pi() / 2)
        for _ in range(SWEEPS):
            square = defect * defect
            defect = leading * (square * (first - second * square)).exp()
            if proves(defect, digits):
                break
        return defect


def reach(a: float, b: float) -> float:
    """Estimate how many digits :func:`enclose` can give: −log₁₀ of C ε*⁴, in float64.

    It only decides whether the formula is tried.
    """
    R = b / a
    exponent = math.sqrt(a * b) * (math.pi + math.atan(math.sqrt(R)))
    second = _quartic(b, R)
    return (4 * (exponent - math.log(2) + math.log1p(R) / 2) - math.log(second)) / math.log(10)


@lru_cache(maxsize=64)
def least_product(digits: int) -> int:
    """Return an ab below which :func:`reach` is below ``digits``, as it is < 8.2 √(ab) + 3."""
    return max(digits - 3, 0) ** 2 // 68


def _quartic(b: Any, R: Any) -> Any:
    """The coefficient C of the lower bound."""
    K = 0.005905 if isinstance(b, float) else LARGEST_K
    return K + (b + R / 2) / 24 + R * (4 * b + 3 * R) / 32
