"""The constants of the repaired theorem against the least a, and why no single one serves.

- `repaired_from` and `second_order_from`: |ε₀/ε* − 1| ≤ K ε*² and |ε₀/ε* − 1 − c₁ε*²| ≤ K₂ ε*⁴
  on a ≥ a₀, 0 < b ≤ 1, for nine a₀ from 1/100 to 10. Each constant is within one per cent of what
  is found at the corner a = a₀, b = 1 (`tresym table constants`);
- `no_single_constant`: as a₀ → 0 there is none.

From a₀ = 1/10 on two charts hold the region with its unbounded edges: (b, κ), κ = 1/√(ab), where
ab ≥ a₀, and (k, 1/a), k = √(ab), where ab ≤ a₀; both are scaled to the unit square by √a₀. Below,
ε* is not small, and the slab up to the next a₀ is enough, for a bound with a smaller constant is
there already. The lower side of the first bound is `leading_below`, which needs no boxes.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from tresym.proofs.asymptotics import RESTS_ON, repaired
from tresym.proofs.conditions import shape
from tresym.proofs.exponent import leading_below
from tresym.proofs.separatrix import flip_defect

from tresym.ledger.evidence.asymptotics import t
from tresym.ledger.vocabulary import *
from tresym.racket.compared.constants import CONSTANTS
from tresym.racket.near import charts
from tresym.racket.notation import a, b, epsilon0
from tresym.reals.numbers.exact import as_rational

EXCESSES = (charts.first_excess, charts.second_excess)
SAYS = ("|ε₀/ε* − 1| ≤ {} ε*².", "|ε₀/ε* − 1 − c₁ε*²| ≤ {} ε*⁴.")
SIDES = ((1,), (1, -1))
"""The sides that boxes show: above ε₀, and below it."""
LABELS = ("repaired_from", "second_order_from")
UNIT = box((0, 1), (0, 1))


def _charts(order: int, a0: fmpq, constant: fmpq) -> tuple[Bound, ...]:
    """The bounds on the whole of a ≥ a₀: in (b, κ√a₀) and in (k/√a₀, a₀/a)."""

    def near(b: Any, scaled: Any, m: Any) -> charts.Root:
        return charts.root_by_kappa(b, scaled / arb(a0).sqrt(), m)

    def far(scaled: Any, alpha: Any, m: Any) -> charts.Root:
        return charts.root_by_k(scaled * arb(a0).sqrt(), alpha / arb(a0), m)

    def margin(side: int, chart: Callable[..., charts.Root]) -> Callable[..., Any]:
        return lambda x, y, m: arb(constant) - side * EXCESSES[order](chart(x, y, m), m)

    return tuple(Bound(margin(side, chart), UNIT) for side in SIDES[order] for chart in (near, far))


def _slab(order: int, a0: fmpq, a1: fmpq, constant: fmpq) -> tuple[Bound, ...]:
    """The bounds on a₀ ≤ a ≤ a₁, in the chart (a, √b)."""

    def margin(side: int) -> Callable[..., Any]:
        def upper(a: Any, root_b: Any, m: Any) -> Any:
            gap, power = charts.gap_over(a, root_b, order, m)
            return power * arb(constant) - side * gap

        return upper

    region = box((a0, a1), (0, 1))
    return tuple(Bound(margin(side), region, slopes=True) for side in SIDES[order])


def _claim(order: int, least: str, constant: str, bounds: tuple[Bound, ...], rest: Any) -> Claim:
    label = f"{LABELS[order]}_{least.replace('/', '_')}"
    return Claim(
        label=label,
        says=SAYS[order].format(constant),
        kind="bound",
        proof=Boxes(
            bounds,
            ("x", "y"),
            f"a >= {least}, 0 < b <= 1",
            as_rational(constant),
            (*RESTS_ON, *((leading_below,) if order == 0 else ()), *rest),
            certificate(label),
        ),
        expect=Verdict.ENCLOSED,
    )


SMALL = fmpq(1, 10)
"""Below this a₀ slabs are used."""


def _table(order: int) -> tuple[Claim, ...]:
    """The claims of one order, smallest a₀ first; a slab rests on the claim above it."""
    claims: list[Claim] = []
    above = [*(as_rational(row.least) for row in CONSTANTS[1:]), fmpq(0)]
    for row, a1 in reversed(list(zip(CONSTANTS, above, strict=True))):
        a0, text = as_rational(row.least), row[1 + order]
        constant = as_rational(text)
        if a0 < SMALL:
            bounds, rest = _slab(order, a0, a1, constant), claims[-1:]
        else:
            bounds, rest = _charts(order, a0, constant), []
        claims.append(_claim(order, row.least, text, bounds, rest))
    return tuple(reversed(claims))


repaired_from = _table(0)
second_order_from = _table(1)


_star = 2 * sqrt(a / (a + b)) * exp(-sqrt(a * b) * (pi + asin(sqrt(b / (a + b)))))
"""ε*."""

no_single_constant = Claim(
    label="no_single_constant",
    says="One constant K serves all shapes: ε₀/ε* − 1 = O(ε*²) for a > 0, 0 < b ≤ 1.",
    means=order(equal(epsilon0 / _star - 1, Function("O")(_star**2)), a),
    given=shape,
    proof=Asymptotics(
        {a: t**2, b: Integer(1)}, beside=epsilon0 > Rational(1, 10), claims=(flip_defect,)
    ),
    expect=Verdict.REFUTED,
    amended_by=(repaired, *repaired_from),
    note="At b = 1 the defect tends to a positive limit as a → 0 while ε* tends to 0.",
)
