"""A concave difference that is nonnegative at both ends is nonnegative between them.

For example, sin(x) − 2x/π is concave for 0 ≤ x ≤ π/2 and 0 at both ends, which proves Jordan's
inequality. Source: S. Boyd, L. Vandenberghe, *Convex Optimization*, 2004, section 3.1.
"""

from __future__ import annotations

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import singularities
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, substitute, symbol, symbols
from tresym.reals.language.formula import MIRRORED
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import Ask
from tresym.reals.signs.interior import sign_inside as sign


def sign_by_concavity(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Concavity: a concave difference is not negative between two points where it is not negative.

    Decides ``sin(x) >= 2*x/pi given 0 <= x <= pi/2``.

    Limits: a variable must lie between two constant bounds, and the sign of the second derivative
    must be provable.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        region: the conditions.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
    """
    sentences = (_in(name, difference, relation, region) for name in sorted(symbols(difference)))
    return next((sentence for sentence in sentences if sentence is not None), None)


def _in(name: str, difference: Expr, relation: str, region: Given) -> str | None:
    """Prove the relation by concavity in one variable; the others are parameters."""
    ends = [_end(region, name, (">", ">=")), _end(region, name, ("<", "<="))]
    if ends[0] is None or ends[1] is None:
        return None
    others = Given(
        tuple(c for c in region.comparisons if name not in symbols(c[0]) | symbols(c[2]))
    )
    (low, _), (high, _) = ends[0], ends[1]
    x = symbol(name)
    inside, closed = (
        others & Given(((x, above, low), (x, below, high)))
        for above, below in ((">", "<"), (">=", "<="))
    )
    for end, is_open in (ends[0], ends[1]):
        value = substitute(difference, {name: end})
        if symbols(value):
            inside = closed  # where nothing can be evaluated, the ends are to be proved regular too
            weak = bool(sign_by_concavity(value, ">=", others))
            at_end = sign(value, others) or (">=0" if weak else None)
        else:
            with ball_precision():
                at_end = sign(value, Given()) if evaluate(value, {}).is_finite() else None
        if at_end not in ("+", ">=0", "0") or (relation != ">=" and at_end != "+" and not is_open):
            return None
    if any(sign(part, inside) not in ("+", "-") for part, _ in singularities(difference)):
        return None
    curvature = sign(differentiate(differentiate(difference, name), name), inside)
    if curvature not in (("-", "<=0", "0") if relation == ">=" else ("-",)):
        return None
    return f"the difference is concave in {name} and not negative at {low} and {high}"


def _end(region: Given, name: str, relations: tuple[str, str]) -> tuple[Expr, bool] | None:
    """Return a constant bound of the symbol by one of the relations, and whether it is excluded.

    Any such bound is enough: a proof between two bounds covers the region, which lies between them.
    """
    for left, relation, right in region.comparisons:
        if right == symbol(name):
            left, relation, right = right, MIRRORED[relation], left
        if left == symbol(name) and relation in relations and not symbols(right):
            return right, relation in ("<", ">")
    return None
