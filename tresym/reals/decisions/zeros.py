"""Places where the two sides of a claim are equal, though no rational point shows it.

- A zero of a polynomial in one variable: an irreducible factor of the difference changes its sign
  between two rational numbers, and divides it.
- A point of simple constants, such as multiples of π, next to the lowest point found.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from itertools import islice, product

from flint import arb, fmpq, fmpz_poly

from tresym.reals.balls.contact import candidates
from tresym.reals.decisions.answer import Answer, refuted
from tresym.reals.decisions.identity import shown
from tresym.reals.decisions.region import is_isolated
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.normal.at_point import equal_at, satisfies
from tresym.reals.normal.field import Field
from tresym.reals.normal.polynomials import terms_in_symbols
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import Interval, fraction_text, rational_ends
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.places.conditions import Given
from tresym.reals.places.values import evaluate
from tresym.reals.verdict import Verdict

WIDTH = fmpq(1, 2**30)
NEAR = fmpq(1, 2**24)
SMALL = arb(2) ** -30
MAX_EACH = 3
"""Simple constants tried for each variable."""


def equal_at_algebraic(left: Expr, right: Expr, given: Given) -> Answer | None:
    """A refutation of a strict inequality, or of ``!=``, between polynomials in one variable."""
    names = symbols(left) | symbols(right)
    if len(names) != 1 or given.names - names:
        return None
    (name,) = names
    for factor in _factors(left - right):
        for low, high in _brackets(factor):
            with ball_precision(2 * WORKING):
                at = {name: arb(low).union(arb(high))}
                sides = evaluate(left, at), evaluate(right, at)
                inside = all(condition.holds(at) for condition in given.conditions)
            if not (inside and all(side.is_finite() for side in sides)):
                continue
            if low == high:
                return refuted(f"both sides are equal at {shown({name: low})}", {name: low}, *sides)
            where = f"[{fraction_text(low)}, {fraction_text(high)}]"
            text = _text(factor, name)
            return Answer(
                Verdict.REFUTED,
                f"both sides are equal where {text} is 0, which changes its sign in {where}",
                witness={name: where},
            )
    return None


def _factors(difference: Expr) -> Iterator[fmpz_poly]:
    """Irreducible factors of the difference, where its normal form is a fraction of polynomials."""
    try:
        field = Field(Given())
        (value,) = field.normal(difference)
        if any(generator.kind != "symbol" for generator in field.generators):
            return
        parts = [part for part, _ in field.factor(value.num)[1]]
    except (TooLargeError, UndefinedError):
        return
    for part in parts:
        terms = terms_in_symbols(field, part)
        if terms is None or not part.total_degree():
            continue
        coefficients = [0] * (int(part.total_degree()) + 1)
        for monomial, c in terms.items():
            coefficients[sum(power for _, power in monomial)] = int(c.p)
        yield fmpz_poly(coefficients)


def _brackets(p: fmpz_poly) -> Iterator[tuple[fmpq, fmpq]]:
    """Rational numbers close together between which ``p`` changes its sign, or twice its zero."""
    if p.degree() == 1:
        zero = fmpq(-p[0], p[1])
        yield zero, zero
        return
    with ball_precision(WORKING):
        for root, _ in p.complex_roots():
            place = rational_ends(root.real).low if root.imag == 0 else None
            if place is not None:
                below = (place / WIDTH).floor()
                low, high = (fmpq(below + step) * WIDTH for step in (0, 1))
                if p(low) * p(high) < 0:
                    yield low, high


def _text(p: fmpz_poly, name: str) -> str:
    return str(p).replace("^", "**").replace("x", name)


def equal_at_simple(
    left: Expr, right: Expr, given: Given, near: Mapping[str, fmpq]
) -> Answer | None:
    """A refutation of a strict inequality at simple constants ``near`` a lowest point."""
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
            if not evaluate(difference, at).contains(0):
                continue
            if not all(satisfies(condition, point, at) for condition in given.conditions):
                continue
            if is_isolated(at, (left, right)):
                continue
            sides = evaluate(left, at), evaluate(right, at)
        if all(side.is_finite() for side in sides) and equal_at(left, right, point):
            return refuted(f"both sides are equal at {shown(point)}", point, *sides)
    return None
