"""The sign of a polynomial where polynomials are positive: at one point of every open cell.

Irreducible polynomials in x₁, …, xₙ are projected onto x₁, …, xₙ₋₁: their leading coefficients
and discriminants in xₙ, and their resultants in pairs. Where none of these vanishes the real roots
in xₙ are continuous and never meet, so above a connected open set the signs between them are
constant. So on, down to a line, which roots cut into intervals: the open cells so made have
rational points in them, and leave out nothing but limits of their points (McCallum 1993;
Strzeboński 2000). No floating point takes part.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import combinations, pairwise
from math import gcd
from typing import NamedTuple

from flint import Ordering, arb, fmpq, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly

from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.expression import number as constant
from tresym.reals.normal.field import Field
from tresym.reals.normal.polynomials import terms_in_symbols
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import WORKING, ball_precision
from tresym.reals.numbers.exact import Interval, near, rational_ends
from tresym.reals.numbers.factoring import TooLargeError, factors_of
from tresym.reals.places.conditions import Given
from tresym.reals.places.descent import low_points
from tresym.reals.places.values import evaluate
from tresym.reals.signs.inside import REMEMBERED, Ask

MAX_VARIABLES = 4
MAX_POLYNOMIALS = 40
"""In one variable less than before."""
MAX_DEGREE, MAX_TERMS = 100, 3000
"""Of a projection."""
MAX_CELLS = 3000
STARTS = 8
SMALLEST = fmpq(1, 2**30)
"""A constant by which a difference may be above 0."""


class Cells(NamedTuple):
    """How many open cells there are in the region, and a point of one on which the claim fails."""

    number: int
    against: tuple[tuple[str, fmpq], ...] | None


def sign_of_polynomial(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Cells: a polynomial is not negative at one rational point of every open cell.

    The cells are those of a cylindrical decomposition by the polynomial and the conditions. It is
    complete for ``>=``; for ``>``, the difference less a constant is looked at.

    Decides ``x**2*y**2*(x**2 + y**2 - 1) >= -1/27``. Ends at five variables, at
    projections of high degree, and for ``>`` where the difference comes as near to 0 as one likes.
    """
    if relation == "!=" or not 0 < len(symbols(difference)) <= MAX_VARIABLES:
        return None
    try:
        found = cells(difference, region)
        if found is None or found.against is not None or not found.number:
            return None
        beyond = ""
        if relation == ">":
            least = _least(difference, region)
            above = None if least is None else cells(difference - constant(least), region)
            if above is None or above.against is not None:
                return None
            found, beyond = above, f" less {least}"
    except TooLargeError:
        return None
    return f"the difference{beyond} is not negative in each of {found.number} open cells"


def _least(difference: Expr, region: Given) -> fmpq | None:
    """A positive number below the smallest value that is found."""
    names = sorted(symbols(difference) | region.names)
    with ball_precision():
        values = (
            evaluate(difference, point).lower()
            for point in low_points(difference, region, region.points(names, STARTS))
        )
        low = rational_ends(min((x for x in values if x.is_finite()), default=arb(0)) / 2).low
    return near(low, low / 2) if low is not None and low > SMALLEST else None


@lru_cache(maxsize=REMEMBERED)
def cells(difference: Expr, region: Given) -> Cells | None:
    """The open cells of the region; None where the difference is no quotient of polynomials.

    Raises:
        TooLargeError: there are more than we look at.
    """
    names = tuple(sorted(symbols(difference)))
    known = [
        c.expression
        for c in region.conditions
        if c.relation != "!=" and symbols(c.expression) <= {*names}
    ]
    target, *conditions = _polynomials((difference, *known), names)
    if target is None:
        return None
    return _Search(target, tuple(p for p in conditions if p is not None), names).cells()


def _polynomials(expressions: Iterable[Expr], names: tuple[str, ...]) -> list[fmpz_mpoly | None]:
    """Polynomials of the same signs, wherever these are defined; None where there is none."""
    ring = fmpz_mpoly_ctx.get(names or ("x",), Ordering.lex)
    found: list[fmpz_mpoly | None] = []
    for e in expressions:
        try:
            field = Field(Given())
            (value,) = field.normal(e)
            terms = terms_in_symbols(field, value.num * value.den)
        except (TooLargeError, UndefinedError):
            terms = None
        if terms is None:
            found.append(None)
            continue
        powers = {
            tuple(dict(monomial).get(name, 0) for name in ring.names()): int(c.p)
            for monomial, c in terms.items()
        }
        found.append(ring.from_dict(powers))
    return found


class _Search:
    """The cells of a target and of conditions, one variable after the other."""

    def __init__(
        self, target: fmpz_mpoly, conditions: tuple[fmpz_mpoly, ...], names: tuple[str, ...]
    ) -> None:
        self.target, self.conditions = target, conditions
        self.count = 0
        present = target.degrees()
        order = sorted(range(len(names)), key=lambda i: (-int(present[i]), i))
        self.names, self.order = names, order
        self.levels: list[list[fmpz_mpoly]] = [[] for _ in order]
        level = _factors((target, *conditions))
        for k in reversed(range(len(order))):
            self.levels[k] = [p for p in level if p.degrees()[order[k]] > 0]
            below = [p for p in level if p.degrees()[order[k]] == 0]
            level = _factors((*below, *_projected(self.levels[k], order[k])))

    def cells(self) -> Cells:
        """Look into each of them."""
        for point in self._points(0, {}):
            self.count += 1
            if self.count > MAX_CELLS:
                raise TooLargeError("the cells are too many to look into")
            if _value(self.target, point) < 0:
                return Cells(
                    self.count, tuple((self.names[i], x) for i, x in sorted(point.items()))
                )
        return Cells(self.count, None)

    def _points(self, k: int, point: dict[int, fmpq]) -> Iterator[dict[int, fmpq]]:
        """A point in every open cell in which all conditions are positive."""
        known = {*self.order[:k]}
        for p in self.conditions:
            if _variables(p) <= known and _value(p, point) <= 0:
                return
        if k == len(self.order):
            yield point
            return
        i = self.order[k]
        lines = [_restricted(p, i, point) for p in self.levels[k]]
        for x in _between(lines):
            yield from self._points(k + 1, {**point, i: x})


def _variables(p: fmpz_mpoly) -> set[int]:
    return {i for i, degree in enumerate(p.degrees()) if degree > 0}


def _factors(polys: Iterable[fmpz_mpoly]) -> list[fmpz_mpoly]:
    """All irreducible factors that are no numbers, each once."""
    found: dict[str, fmpz_mpoly] = {}
    for p in polys:
        if p.total_degree() > MAX_DEGREE or len(p) > MAX_TERMS:
            raise TooLargeError("the cells are too many to look into")
        found |= {str(factor): factor for factor, _ in factors_of(p)[1]}
        if len(found) > MAX_POLYNOMIALS:
            raise TooLargeError("the cells are too many to look into")
    return list(found.values())


def _projected(polys: list[fmpz_mpoly], i: int) -> Iterator[fmpz_mpoly]:
    """What keeps the roots in the i-th variable real, apart and finite where it does not vanish."""
    for p in polys:
        yield _leading(p, i)
        if p.degrees()[i] > 1:
            yield p.discriminant(i)
    for p, q in combinations(polys, 2):
        yield p.resultant(q, i)


def _leading(p: fmpz_mpoly, i: int) -> fmpz_mpoly:
    """The leading coefficient in the i-th variable."""
    degree = p.degrees()[i]
    terms = {
        (*powers[:i], 0, *powers[i + 1 :]): c for powers, c in p.terms() if powers[i] == degree
    }
    return p.context().from_dict(terms)


def _value(p: fmpz_mpoly, point: dict[int, fmpq]) -> fmpq:
    total = fmpq(0)
    for powers, c in p.terms():
        term = fmpq(c)
        for i, power in enumerate(powers):
            if power:
                term *= point[i] ** int(power)
        total += term
    return total


def _restricted(p: fmpz_mpoly, i: int, point: dict[int, fmpq]) -> fmpz_poly:
    """``p`` on the line of the i-th variable through a point, times a positive number."""
    coefficients = [fmpq(0)] * (int(p.degrees()[i]) + 1)
    for powers, c in p.terms():
        term = fmpq(c)
        for j, power in enumerate(powers):
            if power and j != i:
                term *= point[j] ** int(power)
        coefficients[int(powers[i])] += term
    unit = 1
    for value in coefficients:
        unit *= int(value.q) // gcd(unit, int(value.q))
    return fmpz_poly([int((value * unit).p) for value in coefficients])


def _between(polys: Iterable[fmpz_poly]) -> list[fmpq]:
    """A rational number in each of the intervals into which all real roots cut the line."""
    for bits in (WORKING, 4 * WORKING):
        ends = _ends([p for p in polys if p.degree() > 0], bits)
        if ends is not None:
            break
    else:
        raise TooLargeError("the cells are too many to look into")
    if not ends:
        return [fmpq(0)]
    inner = [Interval(a.high, b.low, True, True).simplest() for a, b in pairwise(ends)]
    first, last = ends[0].low, ends[-1].high
    return [fmpq(first.ceil() - 1), *inner, fmpq(last.floor() + 1)]


def _ends(polys: list[fmpz_poly], bits: int) -> list[Interval] | None:
    """The real roots of all of them in rational intervals, in order; None where two overlap."""
    with ball_precision(bits):
        roots = [rational_ends(z.real) for p in polys for z, _ in p.complex_roots() if z.imag == 0]
    roots.sort()
    return None if any(a.high >= b.low for a, b in pairwise(roots)) else roots
