"""Counterexamples at algebraic points, where both sides of a strict inequality are equal.

- A zero of a polynomial in one variable: an irreducible factor of the difference that changes sign
  between two rational numbers.
- A critical zero of a polynomial in several variables: its coordinates are polynomials in a root t
  of a polynomial m, and m divides the difference after substituting them.
- Multiples of π/2 for every angle, with 0 and ±1 for the other variables.
- Simple constants, such as multiples of π, close to the lowest point found.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from itertools import islice, product

from flint import arb, arb_mat, arb_poly, fmpq, fmpq_poly, fmpz_mat, fmpz_poly

from tresym.reals.balls.simplest_constants import candidates
from tresym.reals.decisions.answer import Answer, Root, exactly, refuted
from tresym.reals.decisions.inequalities_on_regions import is_isolated
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import LEAVES, PI, Expr, number, symbols
from tresym.reals.normal.at_point import equal_at, satisfies
from tresym.reals.normal.field import Field
from tresym.reals.normal.polynomials import Monomial, polynomial, terms_in_symbols
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import Interval, fraction_text, rational_ends
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.verdict import Verdict

WIDTH = fmpq(1, 2**30)
NEAR = fmpq(1, 2**24)
SMALL = arb(2) ** -30
DIGITS, STEPS = 400, 10
"""Bits of a point at which a gradient vanishes, and steps of Newton towards it."""
SCALE, TINY = arb(2) ** 300, arb(2) ** -350
MAX_DEGREE, MAX_COEFFICIENT = 8, 2**24
"""Of the polynomial whose root it is."""
TURNS = tuple(k * PI / 2 for k in (2, 0, 1, -1))
UNITS = tuple(map(number, (1, -1, 0)))
MAX_POINTS = 100
"""Points of quarter turns, and of units for the other variables, that are tried."""
MAX_EACH = 3
"""Simple constants tried for each variable."""


def equal_at_algebraic(left: Expr, right: Expr, given: Given) -> Answer | None:
    """Refute a strict inequality or ``!=`` of polynomials in one variable, or return None."""
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
                point = {name: low}
                return refuted(exactly("both sides are equal", point), point, *sides)
            where = f"[{fraction_text(low)}, {fraction_text(high)}]"
            text = _text(factor, name)
            return Answer(
                Verdict.REFUTED,
                f"both sides are equal where {text} = 0; it changes sign on "
                f"{where} and so has a root there",
                witness={name: where},
            )
    return None


def _factors(difference: Expr) -> Iterator[fmpz_poly]:
    """Return the irreducible factors of a rational difference."""
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
        places = [rational_ends(root.real).low for root, _ in p.complex_roots() if root.imag == 0]
    for place in places:
        if place is not None:
            below = (place / WIDTH).floor()
            low, high = (fmpq(below + step) * WIDTH for step in (0, 1))
            if p(low) * p(high) < 0:
                yield low, high


def _text(p: fmpz_poly | fmpq_poly, name: str) -> str:
    return str(p).replace("^", "**").replace("x", name)


def equal_at_lowest(
    left: Expr, right: Expr, given: Given, near: Mapping[str, fmpq]
) -> Answer | None:
    """Refute a strict inequality of polynomials at algebraic numbers ``near`` a point, or None."""
    names = sorted(near)
    terms = polynomial(left - right)
    if terms is None or given.names - {*names} or len(names) < 2:
        return None
    with ball_precision(DIGITS):
        if not abs(evaluate(left - right, near)) < SMALL:
            return None
        point = _stationary(left - right, names, near)
        if point is None:
            return None
        for weights in _weights(len(names)):
            found = _in_root(point, weights)
            if found is None:
                continue
            m, root, values = found
            at = dict(zip(names, values, strict=True))
            if _vanishes(terms, at, m):
                return _shown_zero((left, right), given, at, m, root)
    return None


def _stationary(difference: Expr, names: list[str], near: Mapping[str, fmpq]) -> list[arb] | None:
    """Find a zero of the gradient by Newton's method; None if it does not converge."""
    slopes = [differentiate(difference, name) for name in names]
    bends = [[differentiate(slope, name) for name in names] for slope in slopes]
    point = [arb(near[name]) for name in names]
    for _ in range(STEPS):
        at = dict(zip(names, point, strict=True))
        gradient = arb_mat([[evaluate(slope, at)] for slope in slopes])
        try:
            step = arb_mat([[evaluate(e, at) for e in row] for row in bends]).solve(gradient)
        except ZeroDivisionError:
            return None
        point = [(x - step[i, 0]).mid() for i, x in enumerate(point)]
    size = max(abs(step[i, 0]) for i in range(len(names)))
    return point if size < TINY else None


def _weights(count: int) -> Iterator[tuple[int, ...]]:
    """Sums of the coordinates that may generate a field which holds all of them."""
    for i in range(count):
        yield tuple(int(j == i) for j in range(count))
    yield tuple(range(1, count + 1))


def _in_root(
    point: list[arb], weights: tuple[int, ...]
) -> tuple[fmpz_poly, arb, list[fmpq_poly]] | None:
    """A polynomial m, its root near the sum, and each coordinate as a polynomial in the root."""
    root = sum((w * x for w, x in zip(weights, point, strict=True)), arb(0))
    powers = [root**k for k in range(MAX_DEGREE + 1)]
    for degree in range(1, MAX_DEGREE + 1):
        relation = _relation(powers[: degree + 1])
        if relation is None or not relation[degree]:
            continue
        values = []
        for x in point:
            found = _relation([*powers[:degree], x])
            if found is None or not found[degree]:
                return None
            values.append(fmpq_poly([fmpq(-c, found[degree]) for c in found[:degree]]))
        return fmpz_poly(relation), root, values
    return None


def _relation(numbers: list[arb]) -> list[int] | None:
    """Small integers with which the sum of the numbers is all but 0, by a short lattice vector."""
    size = len(numbers)
    rows = [
        [*(int(i == j) for j in range(size)), int((x * SCALE).mid().floor().unique_fmpz() or 0)]
        for i, x in enumerate(numbers)
    ]
    first = fmpz_mat(rows).lll().tolist()[0]
    short = max(abs(int(c)) for c in first)
    return [int(c) for c in first[:size]] if short < MAX_COEFFICIENT else None


def _vanishes(
    terms: Mapping[Monomial, fmpq], values: Mapping[str, fmpq_poly], m: fmpz_poly
) -> bool:
    """Whether ``m`` divides the polynomial with the values put in for its variables."""
    total, modulus = fmpq_poly([]), fmpq_poly(m)
    for monomial, c in terms.items():
        term = fmpq_poly([c])
        for name, power in monomial:
            for _ in range(power):
                term = term * values[name] % modulus
        total += term
    return bool(m.degree() > 0 and total % modulus == 0)


def _shown_zero(
    sides: tuple[Expr, Expr],
    given: Given,
    values: Mapping[str, fmpq_poly],
    m: fmpz_poly,
    root: arb,
) -> Answer | None:
    """Return the refutation if the root of m is real and the point satisfies the conditions."""
    for low, high in _brackets(m):
        if not (arb(low) <= root <= arb(high)):
            continue
        t = arb(low).union(arb(high))
        at = {name: arb_poly(value)(t) for name, value in values.items()}
        inside = all(condition.holds(at) for condition in given.conditions)
        if not (inside and all(evaluate(side, at).is_finite() for side in sides)):
            return None
        where = f"[{fraction_text(low)}, {fraction_text(high)}]"
        point = ", ".join(f"{name} = {_text(value, 't')}" for name, value in values.items())
        return Answer(
            Verdict.REFUTED,
            f"both sides are equal at {point}, where t is the root of {_text(m, 't')} in {where}",
            witness={name: _interval(x) for name, x in at.items()},
            root=Root(
                _text(m, "t"),
                fraction_text(low),
                fraction_text(high),
                {name: _text(value, "t") for name, value in values.items()},
            ),
        )
    return None


def _interval(x: arb) -> str:
    low, high = rational_ends(x)[:2]
    return fraction_text(low) if low == high else f"[{fraction_text(low)}, {fraction_text(high)}]"


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
    points = (dict(zip(near, values, strict=True)) for values in product(*choices))
    return _equal_at_one(left, right, given, points)


def equal_at_turns(left: Expr, right: Expr, given: Given) -> Answer | None:
    """Refute a strict inequality where all angles are multiples of π/2, or return None."""
    difference = left - right
    names = sorted(symbols(difference))
    angles = frozenset().union(*map(symbols, _angles(difference)))
    if not angles or len(names) < 2 or given.names - {*names}:
        return None
    choices = [TURNS if name in angles else UNITS for name in names]
    points = (dict(zip(names, values, strict=True)) for values in product(*choices))
    return _equal_at_one(left, right, given, islice(points, MAX_POINTS))


def _angles(e: Expr) -> Iterator[Expr]:
    """Return the arguments of sines and cosines."""
    for arg in () if e.op in LEAVES else e.args:
        yield from (arg,) if e.op in ("sin", "cos") else _angles(arg)


def _equal_at_one(
    left: Expr, right: Expr, given: Given, points: Iterable[dict[str, Expr]]
) -> Answer | None:
    """Return a refutation at the first point at which both sides are equal, or None."""
    for point in points:
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
