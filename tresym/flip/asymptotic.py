"""The flip defect ε₀ by its closed formula, with a proved bound on what the formula leaves out.

With ε* the leading term, R = b/a and s = sin t, the exact separatrix equation is

    log(ε₀/ε*) = ∫₀^ε₀ [1/t − (1 − b s²)/(s √(1 + R s²))] dt,    0 < b ≤ 1,

and 1 − x/2 ≤ (1+x)^(−1/2) ≤ 1 − x/2 + 3x²/8, s ≤ t, 1/s ≥ 1/t + t/6 bound it on both sides by

    c₁ε₀² − C ε₀⁴ ≤ log(ε₀/ε*) ≤ c₁ε₀²,
    C = K + (b + R/2)/24 + (bR/2 + 3R²/8)/4,    K = (log(4/π) − π²/48)/(π/2)⁴.

K comes from ∫₀^e (1/sin t − 1/t) dt = log(tan(e/2)/(e/2)), all of whose Taylor coefficients are
positive, so that (… − e²/12)/e⁴ increases up to e = π/2. A first upper bound of ε₀ is what the
phase π, its smallest value, gives.
"""

from __future__ import annotations

from flint import arb, fmpq

from tresym.arithmetic import ball_precision, balls, bits
from tresym.flip.separatrix import LARGEST_ARGUMENT
from tresym.formulas import stable

SWEEPS = 3


def enclose(a: fmpq, b: fmpq, digits: int) -> arb | None:
    """A ball around ε₀ at a precision that serves ``digits``; as wide as the formula leaves it.

    None where ε₀ is too small to be told from 0 (see :mod:`tresym.flip.separatrix`).
    """
    with ball_precision(bits(digits, 84)):
        p, q = arb(a), arb(b)
        k, r = (p * q).sqrt(), (q / p).sqrt()
        if k > LARGEST_ARGUMENT:
            return None
        leading, first = stable.leading_term(k, r, balls), stable.first_coefficient(k, r)
        second = arb(0).union(_quartic(q, r * r))
        defect = arb(0).union(stable.defect_at(arb.pi(), k, r, balls).upper())
        for _ in range(SWEEPS):
            square = defect * defect
            defect = leading * (square * (first - second * square)).exp()
        return defect


def _quartic(b: arb, R: arb) -> arb:
    """C of the lower bound."""
    quarter = arb.pi() / 2
    K = ((4 / arb.pi()).log() - arb.pi() ** 2 / 48) / quarter**4
    return K + (b + R / 2) / 24 + (b * R / 2 + 3 * R * R / 8) / 4
