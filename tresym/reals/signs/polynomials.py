"""Prove the sign of a polynomial on a semialgebraic set, by one point in every open cell.

The cells are those of an open cylindrical decomposition by the polynomial and the conditions (see
:mod:`tresym.reals.domain.cylindrical_decomposition`). On each cell every one of these polynomials
has constant sign, and every point outside the cells is a limit of points of cells (McCallum 1993;
Strzeboński 2000). All arithmetic is exact.

The coordinates are the variables, and roots, exponentials and other functions of them, whose values
lie in known intervals. Proving the sign for independent coordinates proves it for these functions.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache
from math import prod
from typing import NamedTuple

from flint import arb, fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.cylindrical_decomposition import sample_points
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.local_search import low_points
from tresym.reals.language.expression import ONE, Expr, add, multiply, number, symbols
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly, UndefinedError, project
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import near, rational_ends
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import REMEMBERED, Ask, without_powers

MAX_VARIABLES = 4
MAX_CELLS = 3000
STARTS = 8
SMALLEST = fmpq(1, 2**30)
"""The smallest positive constant that is tried as a lower bound of a difference."""


class Cells(NamedTuple):
    """Hold the number of open cells in the region and a point where the polynomial is negative.

    The point is None if there is none, and empty if its coordinates are not those of variables.
    """

    number: int
    against: tuple[tuple[str, fmpq], ...] | None


def sign_of_polynomial(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Cells: a polynomial is not negative if it is not negative at one rational point of each open
    cell.

    The cells come from a cylindrical decomposition by the polynomial and the conditions. The method
    is complete for ``>=``. For ``>``, it proves that the difference minus a positive multiple of a
    strict condition, or a positive constant, is not negative. For polynomials in roots,
    exponentials and other functions, it proves the sign for independent values of them, and
    ``u + v*sqrt(w) >= 0`` by the signs of u, v and ``u**2 - v**2*w``.

    Decides ``x**2*y**2*(x**2 + y**2 - 1) >= -1/27``.

    Limits: at most four variables and projections of low degree are allowed.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        region: the conditions.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
    """
    for bound in _positive(difference, region) if relation == ">" else ():
        least = _least(difference / bound, region)
        if least is not None and least > 0:
            less = number(least) * bound
            count = _count(difference - less, region)
            if count:
                return f"the difference less {less} is not negative in each of {count} open cells"
    count = _count(difference, region) if relation == ">=" else None
    return f"the difference is not negative in each of {count} open cells" if count else None


def _positive(difference: Expr, region: Given) -> Iterator[Expr]:
    """Yield expressions that are positive by the conditions, if the difference is rational."""
    names, system = symbols(difference), _system(difference, region)
    if system is None:
        return
    field, top, _ = system
    if any(field.ring.at(i).kind != "symbol" for i in field.ring.used(top)):
        return
    strict = [
        c.expression
        for c in region.conditions
        if c.relation == ">" and symbols(c.expression) <= names
    ]
    variables = [e for e in strict if e.op == "symbol"]
    yield ONE
    yield from strict
    yield multiply(*variables)
    if len(variables) > 1:
        yield multiply(*(e / add(*variables) for e in variables))
    yield from (bound for e in strict for bound in (e / (1 + e), e**2))


def _least(difference: Expr, region: Given) -> fmpq | None:
    """Return a positive number below the smallest value that a local search finds, or None."""
    names = sorted(symbols(difference) | region.names)
    with ball_precision():
        values = (
            evaluate(difference, point).lower()
            for point in low_points(difference, region, region.points(names, STARTS))
        )
        low = rational_ends(min((x for x in values if x.is_finite()), default=arb(0)) / 2).low
    return near(low, low / 2) if low is not None and low > SMALLEST else None


def _count(difference: Expr, region: Given) -> int | None:
    """Return the number of cells that show ``difference >= 0``, or None if they do not."""
    try:
        region_cells, system = cells(difference, region), _system(difference, region)
        if system is None or (region_cells is not None and region_cells.against is None):
            return region_cells and (region_cells.number or None)
        return _by_conjugate(*system)
    except TooLargeError:
        return None


@lru_cache(maxsize=REMEMBERED)
def cells(difference: Expr, region: Given) -> Cells | None:
    """Return the open cells of the region, in the coordinates that occur in the difference.

    Args:
        difference: the expression whose sign is sought.
        region: the conditions.

    Returns:
        The cells; None if the difference has no normal form in a few coordinates.

    Raises:
        TooLargeError: there are more than :data:`MAX_CELLS` cells.
    """
    system = _system(difference, region)
    return None if system is None else _cells(*system)


System = tuple[Field, Poly, tuple[Poly, ...]]
"""A ring, a polynomial with the sign of a difference, and others that are not negative."""


@lru_cache(maxsize=REMEMBERED)
def _system(difference: Expr, region: Given) -> System | None:
    names = symbols(difference)
    known = [
        c.expression
        for c in region.conditions
        if c.relation != "!=" and symbols(c.expression) <= names
    ]
    try:
        field = Field(region)
        values = [field.ring.reduce(x.num * x.den) for x in field.normal(difference, *known)]
    except (TooLargeError, UndefinedError):
        return None
    return field, without_powers(field, values[0]), tuple(values[1:])


def _cells(field: Field, p: Poly, facts: tuple[Poly, ...]) -> Cells | None:
    """Return the cells of the conditions in the coordinates of ``p``; None if they are too many."""
    degrees, used = p.degrees(), field.ring.used(p)
    order = sorted(used, key=lambda i: (-degrees[i], i))
    if not 0 < len(used) <= MAX_VARIABLES:
        return None
    inside = [without_powers(field, fact, p) for fact in facts]
    inside = [
        fact for fact in (*inside, *_ranges(field, used)) if {*field.ring.used(fact)} <= {*used}
    ]
    target, *conditions = (project(q, order) for q in (p, *inside))

    def wanted(point: tuple[fmpq, ...]) -> bool:
        return all(_value(q, point) > 0 for q in conditions if not any(q.degrees()[len(point) :]))

    count = 0
    for point in sample_points([target, *conditions], target.context(), wanted):
        count += 1
        if count > MAX_CELLS:
            raise TooLargeError(
                f"the decomposition has more than {MAX_CELLS} cells, which is the limit"
            )
        if _value(target, point) < 0:
            kinds = {field.ring.at(i).kind for i in order}
            names = (field.ring.at(i).data[0] for i in order)
            at = tuple(sorted(zip(names, point, strict=True))) if kinds == {"symbol"} else ()
            return Cells(count, at)
    return Cells(count, None)


def _ranges(field: Field, used: list[int]) -> Iterator[Poly]:
    """Yield the ranges of the coordinates that are not variables, as conditions."""
    for i in used:
        kind = field.ring.at(i).kind
        ends = (fmpq(-1), fmpq(1)) if kind in ("sin", "cos") else field.signs.ends(i)
        for side, end in zip((1, -1), ends, strict=True):
            if kind != "symbol" and end is not None:
                yield side * (field.ring.variables[i] * int(end.q) - int(end.p))


def _by_conjugate(field: Field, p: Poly, facts: tuple[Poly, ...]) -> int | None:
    """Return the number of cells that show ``u + v*sqrt(w) >= 0``, where ``p`` is such a sum.

    One of u and v is not negative, and neither is the difference of its square and the other one.
    """
    for i, order, _ in field.ring.relations:
        if order != 2 or p.degrees()[i] != 1 or field.ring.at(i).kind != "root":
            continue
        parts = field.ring.split(p, i)
        u, v = (parts.get(k, field.ring.zero_poly) for k in range(2))
        norm = field.ring.reduce(v**2 * field.ring.variables[i] ** 2 - u**2)
        for both in ((v, norm), (u, -norm)):
            counts = [_shown(field, q, facts) for q in both]
            if None not in counts:
                return sum(filter(None, counts))
    return None


def _shown(field: Field, p: Poly, facts: tuple[Poly, ...]) -> int | None:
    """Return the number of cells that show ``p >= 0``, or None."""
    if p.is_constant():
        return 1 if p.is_zero() or p.leading_coefficient() > 0 else None
    region_cells = _cells(field, p, facts)
    if region_cells is not None and region_cells.against is None:
        return region_cells.number or None
    return _by_conjugate(field, p, facts)


def _value(p: Poly, at: tuple[fmpq, ...]) -> fmpq:
    terms = ((zip(at, m, strict=False), c) for m, c in p.terms())
    return sum(
        (prod((x ** int(n) for x, n in powers), start=fmpq(c)) for powers, c in terms), fmpq(0)
    )
