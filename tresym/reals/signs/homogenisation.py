"""Homogenise a polynomial by a condition such as x + y + z ≤ 1.

Where L is homogeneous with 0 ≤ L ≤ k, a term that is not negative becomes no larger when it is
multiplied by a power of L/k; where L ≥ k > 0, so does one that is not positive. What is proved of
the homogeneous function, in which x = y = z is a ray and not a point, holds of the other.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import ONE, ZERO, Expr, number, power, symbols
from tresym.reals.language.like_terms import collected
from tresym.reals.normal.polynomials import as_expression, degree, polynomial
from tresym.reals.signs.interior import PROVING, Ask, is_zero
from tresym.reals.signs.interior import sign_inside as sign
from tresym.reals.signs.orthant_cones import sign_on_cones
from tresym.reals.signs.structural import WEAK


class _Term(NamedTuple):
    """A monomial with its coefficient, which is 0 here where it is no rational number."""

    degree: int
    value: fmpq
    expression: Expr


class Way(NamedTuple):
    """How a sum becomes homogeneous.

    Attributes:
        parts: its terms, and the power of the form that each is multiplied by.
        form: at most 1 where ``side`` is 1, at least 1 where it is −1.
        words: which condition says so.
    """

    parts: tuple[tuple[Expr, fmpq], ...]
    form: Expr
    side: int
    words: str


def sign_by_homogeneity(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Homogeneity: a condition makes the polynomial homogeneous, and cones settle what it becomes.

    Decides ``1 - 27*x*y*z >= 0 given x >= 0, y >= 0, z >= 0, x + y + z <= 1``. Ends where no
    condition is a homogeneous polynomial compared with a number, and where cones end.
    """
    for way in ways(difference, region) if relation != "!=" else ():
        made = below(difference, way, region)
        if made is None:
            continue
        least, is_less = made
        needed = ">=" if is_less else relation
        proof: str | None = "it is so by the signs of its parts"
        if sign(least, region) not in PROVING[needed]:
            proof = sign_on_cones(least, needed, region)
        if proof is not None:
            return f"made homogeneous by {way.words}, {proof}"
    return None


def below(difference: Expr, way: Way, region: Given) -> tuple[Expr, bool] | None:
    """What is nowhere larger than ``difference``, and whether it is smaller everywhere.

    None where the way does not show that.
    """
    parts, form, side, _ = way
    room = sign(side * (1 - form), region)
    if room not in WEAK or sign(form, region) not in WEAK:
        return None
    if not is_zero(sum((part for part, _ in parts), -difference), region):
        return None
    signs = [sign(part * side, region) for part, power_ in parts if power_ > 0]
    if not all(found in WEAK for found in signs) or any(power_ < 0 for _, power_ in parts):
        return None
    least = sum((part * power(form, number(power_)) for part, power_ in parts), ZERO)
    return least, room == "+" and "+" in signs


def ways(difference: Expr, region: Given) -> Iterator[Way]:
    """What to try, one for each condition that is a homogeneous form compared with a number."""
    terms = _terms(difference) or _written_terms(difference) or []
    largest = max((t.degree for t in terms), default=0)
    if all(t.degree == largest for t in terms):
        return
    for condition in region.beyond_box:
        known = _terms(condition.expression) if condition.relation in (">", ">=") else None
        constant = sum((t.value for t in known or () if t.degree == 0), fmpq(0))
        degrees = {t.degree for t in known or () if t.degree}
        if constant == 0 or len(degrees) != 1:
            continue
        (degree_,) = degrees
        form = sum((t.expression for t in known or () if t.degree), ZERO) * (-1 / constant)
        parts = tuple((t.expression, fmpq(largest - t.degree, degree_)) for t in terms)
        words = f"{condition.expression} {condition.relation} 0"
        yield Way(parts, form, 1 if constant > 0 else -1, words)


def _terms(e: Expr) -> list[_Term] | None:
    """The terms of a polynomial in symbols, or None."""
    terms = polynomial(e)
    if terms is None:
        return None
    return [_Term(degree(m), c, number(c) * as_expression(m)) for m, c in terms.items()]


def _written_terms(e: Expr) -> list[_Term] | None:
    """The terms as they stand, where coefficients are constants such as sqrt(3)."""
    found = []
    total = collected(e)
    for term in total.args if total.op == "+" else (total,):
        powers = 0
        for part in term.args if term.op == "*" else (term,):
            base, exponent = part.args if part.op == "^" else (part, ONE)
            if not symbols(part):
                continue
            if base.op != "symbol" or exponent.op != "number" or exponent.args[0].q != 1:
                return None
            powers += int(exponent.args[0].p)
        found.append(_Term(powers, fmpq(0), term))
    return found if all(term.degree >= 0 for term in found) else None
