"""Constants of |ε₀/ε* − 1| ≤ K ε*² and |ε₀/ε* − 1 − c₁ε*²| ≤ K₂ ε*⁴ on {a ≥ a₀, 0 < b ≤ 1}.

They are proved in ``proofs/constants.tresym``; here they are data, with the ratios they bound. At
the corner a = a₀, b = 1 each ratio comes within one per cent of its constant.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import arb, fmpq

from tresym.accuracy.values import certified
from tresym.racket.comparison.errors import SMALLEST, exact_defect
from tresym.racket.formulas import stable
from tresym.reals.language.expression import number, trees


class Constants(NamedTuple):
    """Proved constants K and K₂ for the shapes with a ≥ ``least``, as exact decimals."""

    least: str
    first: str
    second: str


CONSTANTS = (
    Constants("1/100", "43.8", "1165"),
    Constants("1/30", "10.13", "88.7"),
    Constants("1/10", "3.185", "11.5"),
    Constants("1/4", "1.451", "2.98"),
    Constants("1/2", "0.925", "1.405"),
    Constants("1", "0.669", "0.83"),
    Constants("2", "0.543", "0.594"),
    Constants("5", "0.468", "0.467"),
    Constants("10", "0.443", "0.428"),
)
"""A row for each a₀; the constants fall towards 5/12 and 31/80, the values of c₁ and c₂ at b = 1,
a = ∞."""


def excesses(a: fmpq, b: fmpq, digits: int = 6) -> tuple[arb, arb]:
    """Compute (ε₀/ε* − 1)/ε*² and (ε₀/ε* − 1 − c₁ε*²)/ε*⁴ to ``digits`` certified digits."""
    k, r = trees.sqrt(number(a * b)), trees.sqrt(number(b / a))
    leading = stable.leading_term(k, r, trees)
    first = (exact_defect(a, b) / leading - 1) / leading**2
    second = (first - stable.first_coefficient(k, r)) / leading**2
    one, other = (certified(e, digits, smallest=SMALLEST) for e in (first, second))
    return one, other
