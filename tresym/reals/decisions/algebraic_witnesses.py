"""Counterexamples at algebraic points, where both sides of a strict inequality are equal.

- A zero of an irreducible factor in one variable that changes sign between two rational numbers.
- Simple constants, such as multiples of π, close to the lowest point found.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice, product

from flint import arb, fmpq, fmpz_poly

from tresym.reals.balls.simplest_constants import candidates
from tresym.reals.decisions.answer import Answer, exactly, refuted
from tresym.reals.decisions.inequalities_on_regions import is_isolated
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.normal.at_point import equal_at, satisfies
from tresym.reals.normal.factors import factor_polynomial
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import Interval, fraction_text, rational_ends
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.verdict import Verdict

WIDTH = fmpq(1, 2**30)
NEAR = fmpq(1, 2**24)
SMALL = arb(2) ** -30
MAX_EACH = 3
"""Simple constants tried for each variable, and points tried for the others."""


def equal_at_algebraic(left: Expr, right: Expr, given: Given) -> Answer | None:
    """Refute a strict inequality or ``!=`` where a factor in one variable is 0, or return None."""
    names = sorted(symbols(left) | symbols(right) | given.names)
    for name, factor in _factors_in_one_variable(left - right):
        others = [{}] if len(names) == 1 else given.points(names, MAX_EACH)
        for (low, high), other in product(_brackets(factor), others):
            with ball_precision(2 * WORKING):
                at = {n: arb(x) for n, x in other.items()} | {name: arb(low).union(arb(high))}
                sides = evaluate(left, at), evaluate(right, at)
                inside = all(condition.holds(at) for condition in given.conditions)
            if not (inside and all(side.is_finite() for side in sides)):
                continue
            if low == high:
                point = other | {name: low}
                return refuted(exactly("both sides are equal", point), point, *sides)
            where = f"[{fraction_text(low)}, {fraction_text(high)}]"
            text = str(factor).replace("^", "**").replace("x", name)
            return Answer(
                Verdict.REFUTED,
                f"both sides are equal where {text} = 0; it changes sign on "
                f"{where} and so has a root there",
                witness={n: fraction_text(x) for n, x in other.items()} | {name: where},
            )
    return None


def _factors_in_one_variable(difference: Expr) -> Iterator[tuple[str, fmpz_poly]]:
    """Yield the irreducible factors in one variable of a rational difference."""
    try:
        field = Field(Given())
        (value,) = field.normal(difference)
        if any(generator.kind != "symbol" for generator in field.ring.generators):
            return
        parts = [part for part, _ in factor_polynomial(field.ring, value.num)[1]]
    except (TooLargeError, UndefinedError):
        return
    for part in parts:
        if len(used := field.ring.used(part)) == 1:
            coefficients = [0] * (int(part.total_degree()) + 1)
            for monomial, c in part.terms():
                coefficients[sum(map(int, monomial))] = int(c)
            yield field.ring.at(used[0]).data[0], fmpz_poly(coefficients)


def _brackets(p: fmpz_poly) -> Iterator[tuple[fmpq, fmpq]]:
    """Rational numbers close together between which ``p`` changes its sign, or twice its zero."""
    if p.degree() == 1:
        zero = fmpq(-p[0], p[1])
        yield zero, zero
        return
    with ball_precision(WORKING):
        places = [rational_ends(root.real).low for root, _ in p.complex_roots() if root.imag == 0]
    for place in places:
        if place is not None:
            below = (place / WIDTH).floor()
            low, high = (fmpq(below + step) * WIDTH for step in (0, 1))
            if p(low) * p(high) < 0:
                yield low, high


def equal_at_simple(
    left: Expr, right: Expr, given: Given, near: Mapping[str, fmpq]
) -> Answer | None:
    """Refute a strict inequality at simple constants ``near`` a lowest point, or return None."""
    difference = left - right
    with ball_precision():
        if not abs(evaluate(difference, near)) < SMALL:
            return None
    choices = [
        list(islice(candidates(Interval(x - NEAR, x + NEAR)), MAX_EACH)) for x in near.values()
    ]
    for values in product(*choices):
        point = dict(zip(near, values, strict=True))
        with ball_precision(2 * WORKING):
            at = {name: evaluate(value, {}) for name, value in point.items()}
            if not evaluate(left - right, at).contains(0):
                continue
            if not all(satisfies(condition, point, at) for condition in given.conditions):
                continue
            if is_isolated(at, (left, right)):
                continue
            sides = evaluate(left, at), evaluate(right, at)
        if all(side.is_finite() for side in sides) and equal_at(left, right, point):
            return refuted(exactly("both sides are equal", point), point, *sides)
    return None
