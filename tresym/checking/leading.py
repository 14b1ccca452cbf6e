"""Orders at a point where both functions are smooth, by the first derivatives that do not vanish.

Whether a derivative vanishes at the point is shown exactly, so that constants such as √2 are no
obstacle. By Taylor's theorem f = f⁽ᵐ⁾(ξ) tᵐ/m! and g = g⁽ⁿ⁾(η) tⁿ/n! on the whole range.
"""

from __future__ import annotations

from math import factorial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.arithmetic import ball_precision
from tresym.checking.domain import equal_at
from tresym.claims.order import Judgement, Size
from tresym.exact import InputError
from tresym.identity.evaluation import evaluate
from tresym.identity.expression import ZERO, Expr, differentiate
from tresym.verdict import Verdict

PRECISION = 128
MAX_ORDER = 8
MAX_SIZE = 3_000
REACHES = tuple(fmpq(1, 4**k) for k in range(12))


class _Leading(NamedTuple):
    """The first derivative that does not vanish, and all below it."""

    order: int
    derivatives: list[Expr]

    @property
    def last(self) -> Expr:
        """The derivative itself."""
        return self.derivatives[-1]


def decide_smooth(
    kind: str, left: Expr, right: Expr, name: str, point: Expr, side: int
) -> Judgement:
    """O, o or ~ from one side of ``point``; UNDECIDED where the functions are not smooth there."""
    f, g = _leading(left, name, point), _leading(right, name, point)
    if f is None or g is None:
        return Judgement(Verdict.UNDECIDED)
    with ball_precision(PRECISION):
        at = evaluate(point, {})
        top = evaluate(f.last, {name: at}) * side**f.order / factorial(f.order)
        bottom = evaluate(g.last, {name: at}) * side**g.order / factorial(g.order)
        power = f.order - g.order
        sizes = Size(top / bottom, fmpq(power)), Size(top, fmpq(f.order))
        holds = {"O": power >= 0, "o": power > 0, "~": power == 0}[kind]
        if kind == "~" and holds:
            holds = equal_at(f.last, g.last, {name: point})
            if not holds and (top / bottom).contains(1):
                return Judgement(Verdict.UNDECIDED)
        for reach in REACHES:
            hull = at.union(at + side * arb(reach))
            if not all(
                evaluate(d, {name: hull}).is_finite() for d in f.derivatives + g.derivatives
            ):
                continue
            whole = [evaluate(x.last, {name: hull}) / factorial(x.order) for x in (f, g)]
            if whole[1].contains(0):
                continue
            if not holds:
                return Judgement(Verdict.REFUTED, *sizes, points={"t": reach / 16})
            constant = None
            if kind == "O":
                upper = (abs(whole[0]) / abs(whole[1])).upper() * arb(reach) ** power
                lower = abs(top / bottom).lower() if power == 0 else arb(0)
                constant = lower.union(upper)
            return Judgement(Verdict.ENCLOSED, *sizes, constant=constant, upto=reach)
    return Judgement(Verdict.UNDECIDED)


def _leading(e: Expr, name: str, point: Expr) -> _Leading | None:
    derivatives = [e]
    with ball_precision(PRECISION):
        at = evaluate(point, {})
        for order in range(MAX_ORDER + 1):
            value = evaluate(derivatives[-1], {name: at})
            if not value.is_finite():
                return None
            if not value.contains(0):
                return _Leading(order, derivatives)
            try:
                if not equal_at(derivatives[-1], ZERO, {name: point}):
                    return None
                derivatives.append(differentiate(derivatives[-1], name))
            except InputError:
                return None
            if derivatives[-1].size > MAX_SIZE:
                return None
    return None
