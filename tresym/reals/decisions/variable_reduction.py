"""Reduce inequalities in several variables to one variable.

- *Homogeneity.* If d(ty, y) = yᵏ d(t, 1) for y > 0, and the conditions and the domain are
  homogeneous as well, the claim at (x, y) is the claim at (x/y, 1).
- *Monotonicity.* g(x) ≥ g(y) for x < y holds if g′ ≤ 0 on an interval that contains both.

The remaining claims in one variable go to the procedure for one variable.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from dataclasses import replace
from functools import partial

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

Decide = Callable[[Expr, str, Expr, Given], Answer]
DEGREES = tuple(fmpq(n, 2) for n in (0, 2, 4, -2, 6, 8, 1, -4, 3))
Comparison = tuple[Expr, str, Expr]


def by_one_variable(
    left: Expr, relation: str, right: Expr, given: Given, decide: Decide
) -> Answer | None:
    """Decide ``>=`` or ``>`` by claims in one variable; None if no reduction applies.

    Expressions with jumps (sign, atan2) are not reduced, since the normal form ignores jumps.
    """
    if _jumps((left, right, *(c.expression for c in given.conditions))):
        return None
    for method in (_scaled, _monotone):
        found = method(left, relation, right, given, decide)
        if found is not None:
            return found
    return None


def _jumps(expressions: Iterable[Expr]) -> bool:
    return any(
        e.op in ("sign", "atan2") or (e.op not in LEAVES and _jumps(e.args)) for e in expressions
    )


# -- scaling ------------------------------------------------------------------------------------


def _scaled(left: Expr, relation: str, right: Expr, given: Given, ask: Decide) -> Answer | None:
    names = sorted(symbols(left - right) | given.names)
    if len(names) != 2:
        return None
    for x, y in (names, names[::-1]):
        if sign(symbol(y), given) != "+":
            continue
        parts = [left - right, *(c.expression for c in given.conditions)]
        parts += [e for e, _ in needs((left, right))]
        if not all(_is_homogeneous(e, x, y, given) for e in parts):
            continue
        put_in = partial(substitute, mapping={y: ONE})
        one = tuple(c for c in given.mapped(put_in).comparisons if symbols(c[0] - c[2]))
        found = ask(put_in(left), relation, put_in(right), Given(one))
        if found.verdict is Verdict.UNDECIDED:
            return None
        if found.witness is not None:
            return replace(found, witness={**found.witness, y: "1"})
        return replace(
            found,
            why=(f"the claim is homogeneous, so it is enough to prove it for {y} = 1: {found.why}"),
            region=None,
        )
    return None


def _is_homogeneous(e: Expr, x: str, y: str, given: Given) -> bool:
    """Whether e(xy, y) = yᵏ e(x, 1) for x of the same sign and y > 0."""
    left, right = substitute(e, {x: symbol(x) * symbol(y)}), substitute(e, {y: ONE})
    signs = {"+": (">",), "-": ("<",)}.get(sign(symbol(x), given) or "", ())
    free = Given(((symbol(y), ">", ZERO), *((symbol(x), s, ZERO) for s in signs)))
    with ball_precision():
        at = {x: arb(fmpq(5, 7)) * (-1 if signs == ("<",) else 1)}
        values = [evaluate(left, at | {y: arb(n)}) for n in (3, 1)]
        for degree in DEGREES:
            wrong = values[0] - values[1] * arb(3) ** arb(degree)
            if wrong.is_finite() and not wrong.contains(0):
                continue
            if is_zero(left - symbol(y) ** number(degree) * right, free):
                return True
    return False


# -- one function at two places -----------------------------------------------------------------


def _monotone(left: Expr, relation: str, right: Expr, given: Given, ask: Decide) -> Answer | None:
    names = sorted(symbols(left - right))
    if len(names) != 2:
        return None
    x, y = names
    g = _at_two_points(collected(left - right), x, y, given)
    if g is None:
        return None
    order = sign(symbol(y) - symbol(x), given)
    if order not in ("+", "-"):
        return None
    first, last = (x, y) if order == "+" else (y, x)
    where = Given((*_bounds(first, 1, x, given), *_bounds(last, -1, x, given)))
    slope = differentiate(g, x)
    if not all(sign(e, where, r) in PROVING[r] for e, r in needs((g, slope))):
        return None  # a jump or a pole between the two
    sides = (ZERO, slope) if order == "+" else (slope, ZERO)
    found = ask(sides[0], relation, sides[1], where)
    if not found:
        return None
    why = (
        f"the difference is that of {g} at two points, and its "
        f"derivative has constant sign: {found.why}"
    )
    return replace(found, why=why, region=None)


def _at_two_points(difference: Expr, x: str, y: str, given: Given) -> Expr | None:
    """Return g if the difference is g(x) − g(y), or one of two terms with quotient g(x)/g(y)."""
    terms = difference.args if difference.op == "+" else (difference,)
    g, other = add(*(term for term in terms if symbols(term) == {x})), {x: symbol(y)}
    if is_zero(difference - g + substitute(g, other), Given()):
        return g
    for up, down in (terms, terms[::-1]) if len(terms) == 2 else ():
        if sign(up, given) == sign(-down, given) == "+":
            over, under = (e.args if e.op == "*" else (e,) for e in (up, -down))
            factors = (*over, *(1 / factor for factor in under))
            g = multiply(*(factor for factor in factors if symbols(factor) == {x}))
            there = substitute(g, other)
            if sign(there, given) == "+" and is_zero(up / -down - g / there, given):
                return g
    return None


def _bounds(name: str, side: int, x: str, given: Given) -> Iterator[Comparison]:
    """The bounds of a variable from below (``side`` 1) or above, as such of ``x``."""
    for condition in given.conditions:
        e = condition.expression
        if symbols(e) == {name} and condition.relation != "!=":
            slope = differentiate(e, name)
            if slope.op == "number" and slope.args[0] * side > 0:
                bound = collected(substitute(e, {name: ZERO}) / -slope)
                relation = condition.relation if side > 0 else condition.relation.replace(">", "<")
                yield symbol(x), relation, bound
