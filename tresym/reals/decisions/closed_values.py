"""Decide claims without variables by certified values: integrals, series, roots, factorials.

Both sides are enclosed at rising precision. Balls that do not overlap refute an equality, and
prove or refute an inequality. Example: ``integral(exp(-x**2), x, 0, oo) < 0.8863``. A printed
number is an inequality as well: ``x ~= 0.1150`` says |x − 0.1150| ≤ 0.00005.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

from flint import arb

from tresym.reals.decisions.answer import Answer, failing, refuted
from tresym.reals.decisions.equations import point_of
from tresym.reals.decisions.root_values import enclosed_root
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.binder_values import enclosing
from tresym.reals.domain.evaluation import InBalls, Rule, UndefinedError, stands
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import ORDERS, Expr, symbols
from tresym.reals.language.formula import NEGATED
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.values.growth import DivergesError
from tresym.reals.values.improper import integral
from tresym.reals.values.totals import factorial_value, total
from tresym.reals.verdict import Verdict

PRECISIONS = (128, 512, 2048)


class NamedDivergence(DivergesError):  # noqa: N818 - the fact, not a fault
    """A divergent integral or series; the message names it."""


def _named(kind: Rule, what: str) -> Rule:
    """Return an enclosure that says which node diverges."""

    def enclosure(e: Expr, outer: InBalls) -> arb:
        try:
            return kind(e, outer)
        except NamedDivergence:
            raise
        except DivergesError:
            raise NamedDivergence(f"the {what} {e} diverges") from None

    return enclosure


RULES: Mapping[str, Rule] = {
    "root": enclosed_root,
    "integral": _named(integral, "integral"),
    "sum": _named(total, "series"),
    "product": _named(total, "product"),
    "unknown": factorial_value,
}
"""How roots, integrals, series, products and factorials are enclosed."""


def certified_evaluation(at: Mapping[str, Any] | None = None) -> InBalls:
    """Return the evaluation of certified values, at working precision."""
    return enclosing(at or {}, RULES)


def decide_closed(claim: Comparison, statement: Statement) -> Answer | None:
    """Decide a claim without variables; None if it has some, or its values are not enclosed."""
    sides = claim.left, claim.right
    if (
        statement.path is not None
        or claim.relation not in NEGATED
        or claim.derivatives
        or INFINITY in sides
        or -INFINITY in sides
        or any(side.op in ORDERS for side in sides)
        or (symbols(claim.left) | symbols(claim.right)) - {INFINITY.args[0]}
    ):
        return None
    if statement.equations and point_of(statement) is None:  # they may have no solution
        return None
    for precision in PRECISIONS:
        with ball_precision(precision):
            walker = certified_evaluation()
            try:
                left, right = map(walker.value, sides)
            except (UndefinedError, InputError):
                return None
            gap = left - right
            if stands(gap, NEGATED[claim.relation]):
                return refuted(failing(claim.relation), {}, left, right)
            if claim.relation != "==" and stands(gap, claim.relation):
                why = f"the left side minus the right side is {gap.str(6, radius=False)}, by balls"
                return Answer(Verdict.ENCLOSED, why)
    return None
