"""The constants of the repaired theorem against the least a, and why no single one serves.

- `repaired_from` and `second_order_from`: |ε₀/ε* − 1| ≤ K ε*² and |ε₀/ε* − 1 − c₁ε*²| ≤ K₂ ε*⁴
  on a ≥ a₀, 0 < b ≤ 1, for nine values of a₀ from 1/100 to 10. Each constant exceeds the value at
  the corner a = a₀, b = 1 by at most one per cent (`tresym table constants`);
- `no_single_constant`: no constant holds for all a₀ > 0.

For a₀ ≥ 1/10, two charts cover the unbounded region: (b, κ) with κ = 1/√(ab) where ab ≥ a₀, and
(k, 1/a) with k = √(ab) where ab ≤ a₀; both are scaled to the unit square by √a₀. For smaller a₀,
where ε* is not small, slabs from each a₀ to the next lead up to 1/10.
"""

from __future__ import annotations

from collections.abc import Callable
from itertools import pairwise
from typing import Any

from tresym.proofs import asymptotics
from tresym.proofs.conditions import shape
from tresym.proofs.near import (
    bound,
    exponent_is_logarithm,
    first_coefficient,
    leading_by_defect,
    leading_term,
)
from tresym.proofs.separatrix import flip_defect

from tresym.ledger.evidence.asymptotics import t
from tresym.ledger.vocabulary import *
from tresym.racket.bounds import charts
from tresym.racket.comparison.constants import CONSTANTS
from tresym.racket.notation import a, b, c1, epsilon0, epsilon_star
from tresym.reals.numbers.exact import as_rational

EXCESSES = (charts.first_excess, charts.second_excess)
SIDES = (1, -1)
LABELS = ("repaired_from", "second_order_from")
UNIT = box((0, 1), (0, 1))
_series = epsilon0 / epsilon_star - 1
SIZES = (_series, _series - c1 * epsilon_star**2)
LEAST = fmpq(1, 10)
"""Below this a₀ slabs are used."""


def _charts(order: int, a0: fmpq, constant: fmpq) -> tuple[On, ...]:
    """The bounds on the whole region a ≥ a₀: in (b, κ√a₀) and in (k/√a₀, a₀/a)."""
    least = Rational(int(a0.p), int(a0.q))

    def near(b: Any, scaled: Any, m: Any) -> charts.Root:
        return charts.root_by_kappa(b, scaled / m.sqrt(a0), m)

    def far(scaled: Any, alpha: Any, m: Any) -> charts.Root:
        return charts.root_by_k(scaled * m.sqrt(a0), alpha / a0, m)

    def shown(chart: Callable[..., charts.Root]) -> tuple[Shown, ...]:
        def margin(side: int) -> Callable[..., Any]:
            return lambda x, y, m: constant - side * EXCESSES[order](chart(x, y, m), m)

        return tuple(Shown(margin(side), epsilon_star ** (2 * order + 2)) for side in SIDES)

    beyond = (a >= least,)
    return (
        On((b, sqrt(least / (a * b))), UNIT, shown(near), (*beyond, a * b >= least)),
        On((sqrt(a * b / least), least / a), UNIT, shown(far), (*beyond, a * b <= least)),
    )


def _slab(order: int, a0: fmpq, a1: fmpq, constant: fmpq) -> On:
    """The bounds on a₀ ≤ a ≤ a₁, in the chart (a, √b)."""

    def margin(side: int) -> Callable[..., Any]:
        def upper(a: Any, root_b: Any, m: Any) -> Any:
            gap, power = charts.gap_over(a, root_b, order, m)
            return power * constant - side * gap

        return upper

    shown = tuple(Shown(margin(side), 1 / epsilon_star, slopes=True) for side in SIDES)
    low, high = (Rational(int(x.p), int(x.q)) for x in (a0, a1))
    return On((a, sqrt(b)), box((a0, a1), (0, 1)), shown, (a >= low, a <= high))


def _claim(order: int, n: int) -> Claim:
    """The bound from the n-th a₀ on: on slabs up to 1/10, and on the remaining region."""
    least, text = CONSTANTS[n].least, CONSTANTS[n][1 + order]
    a0, constant = as_rational(least), as_rational(text)
    ends = [as_rational(row.least) for row in CONSTANTS[n:] if as_rational(row.least) <= LEAST]
    slabs = [_slab(order, low, high, constant) for low, high in pairwise(ends)]
    on = (*slabs, *_charts(order, max(a0, LEAST), constant))
    return bound(
        f"{LABELS[order]}_{least.replace('/', '_')}",
        Abs(SIZES[order]) <= Rational(text) * epsilon_star ** (2 * order + 2),
        *on,
        put=((exponent_is_logarithm, leading_term) if slabs else (leading_by_defect,))
        + (first_coefficient,) * order,
        given=(*shape, a >= Rational(least)),
        constant=text,
    )


def _table(order: int) -> tuple[Claim, ...]:
    """The claims of one order, for increasing a₀."""
    return tuple(_claim(order, n) for n in range(len(CONSTANTS)))


repaired_from = _table(0)
second_order_from = _table(1)

_star = 2 * sqrt(a / (a + b)) * exp(-sqrt(a * b) * (pi + asin(sqrt(b / (a + b)))))
"""ε*."""

no_single_constant = Claim(
    says="One constant K serves all shapes: ε₀/ε* − 1 = O(ε*²) for a > 0, 0 < b ≤ 1.",
    means=order(equal(epsilon0 / _star - 1, Function("O")(_star**2)), a),
    given=shape,
    proof=Asymptotics(
        {a: t**2, b: Integer(1)}, beside=epsilon0 > Rational(1, 10), claims=(flip_defect,)
    ),
    expect=Verdict.REFUTED,
    amended_by=(asymptotics.repaired, *repaired_from),
    note="At b = 1 the defect tends to a positive limit as a → 0 while ε* tends to 0.",
)

label_claims(globals())
