"""Prove the sign of a polynomial on a semialgebraic set, by one point in every open cell.

The cells are those of an open cylindrical decomposition by the polynomial and the conditions (see
:mod:`tresym.reals.domain.cylindrical_decomposition`). On each cell every one of these polynomials
has constant sign, and every point outside the cells is a limit of points of cells (McCallum 1993;
Strzeboński 2000). All arithmetic is exact.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache
from math import prod
from typing import NamedTuple

from flint import Ordering, arb, fmpq, fmpz_mpoly, fmpz_mpoly_ctx

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.cylindrical_decomposition import sample_points
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.local_search import low_points
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.expression import number as constant
from tresym.reals.normal.field import Field
from tresym.reals.normal.polynomials import Monomial, terms_in_symbols
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import near, rational_ends
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import REMEMBERED, Ask

MAX_VARIABLES = 4
MAX_CELLS = 3000
STARTS = 8
SMALLEST = fmpq(1, 2**30)
"""The smallest positive constant that is tried as a lower bound of a difference."""


Terms = Mapping[Monomial, fmpq]


class Cells(NamedTuple):
    """Hold the number of open cells in the region and a point where the claim fails, if any."""

    number: int
    against: tuple[tuple[str, fmpq], ...] | None


def sign_of_polynomial(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Cells: a polynomial is not negative if it is not negative at one rational point of each open
    cell.

    The cells come from a cylindrical decomposition by the polynomial and the conditions. The method
    is complete for ``>=``. For ``>``, it proves that the difference minus a positive constant is
    not negative.

    Decides ``x**2*y**2*(x**2 + y**2 - 1) >= -1/27``.

    Limits: at most four variables and projections of low degree are allowed, and for ``>`` the
    difference must stay away from 0.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        region: the conditions.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
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
            known = least is not None and least > 0
            above = cells(difference - constant(least), region) if known else None
            if above is None or above.against is not None:
                return None
            found, beyond = above, f" less {least}"
    except TooLargeError:
        return None
    return f"the difference{beyond} is not negative in each of {found.number} open cells"


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


@lru_cache(maxsize=REMEMBERED)
def cells(difference: Expr, region: Given) -> Cells | None:
    """Return the open cells of the region.

    Args:
        difference: the expression whose sign is sought.
        region: the conditions.

    Returns:
        The cells; None if the difference is not a quotient of polynomials.

    Raises:
        TooLargeError: there are more than :data:`MAX_CELLS` cells.
    """
    names = symbols(difference)
    known = [
        c.expression
        for c in region.conditions
        if c.relation != "!=" and symbols(c.expression) <= names
    ]
    target, *others = map(_terms, (difference, *known))
    if target is None:
        return None
    conditions = [terms for terms in others if terms is not None]
    order = sorted(names, key=lambda name: (-_degree(target, name), name))
    ring = fmpz_mpoly_ctx.get(order, Ordering.lex)
    polynomials = [_polynomial(terms, ring) for terms in (target, *conditions)]

    def wanted(point: tuple[fmpq, ...]) -> bool:
        known = dict(zip(order, point, strict=False))
        return all(
            _value(terms, known) > 0
            for terms in conditions
            if {name for monomial in terms for name, _ in monomial} <= known.keys()
        )

    count = 0
    for point in sample_points(polynomials, ring, wanted):
        count += 1
        if count > MAX_CELLS:
            raise TooLargeError(
                f"the decomposition has more than {MAX_CELLS} cells, which is the limit"
            )
        at = dict(zip(order, point, strict=True))
        if _value(target, at) < 0:
            return Cells(count, tuple(sorted(at.items())))
    return Cells(count, None)


def _terms(e: Expr) -> Terms | None:
    """Return a polynomial with the sign of ``e`` wherever ``e`` is defined, or None."""
    try:
        field = Field(Given())
        (value,) = field.normal(e)
        return terms_in_symbols(field, value.num * value.den)
    except (TooLargeError, UndefinedError):
        return None


def _degree(terms: Terms, name: str) -> int:
    return max((dict(monomial).get(name, 0) for monomial in terms), default=0)


def _polynomial(terms: Terms, ring: fmpz_mpoly_ctx) -> fmpz_mpoly:
    powers = (dict(monomial) for monomial in terms)
    return ring.from_dict(
        {
            tuple(power.get(name, 0) for name in ring.names()): int(c.p)
            for power, c in zip(powers, terms.values(), strict=True)
        }
    )


def _value(terms: Terms, at: Mapping[str, fmpq]) -> fmpq:
    return sum((prod((at[n] ** k for n, k in m), start=c) for m, c in terms.items()), fmpq(0))
