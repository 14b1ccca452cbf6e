"""A polynomial under a condition such as x + y + z ≤ 1, made homogeneous by it.

Where L is homogeneous with 0 ≤ L ≤ k, a term that is not negative becomes no larger when it is
multiplied by a power of L/k; where L ≥ k > 0, so does one that is not positive. What is proved of
the homogeneous function, in which x = y = z is a ray and not a point, holds of the other.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import fmpq

from tresym.reals.language.expression import ONE, ZERO, Expr, number, power, symbols
from tresym.reals.language.products import collected
from tresym.reals.normal.polynomials import as_expression, degree, polynomial
from tresym.reals.places.conditions import Condition, Given
from tresym.reals.signs.cones import sign_on_cones
from tresym.reals.signs.inside import PROVING, Ask
from tresym.reals.signs.inside import sign_inside as sign


class _Term(NamedTuple):
    """A monomial with its coefficient, which is 0 here where it is no rational number."""

    degree: int
    value: fmpq
    expression: Expr


class _HomogeneousBound(NamedTuple):
    """``form`` ≤ 1 (``side`` 1) or ≥ 1 (−1), homogeneous of this degree."""

    form: Expr
    degree: int
    side: int
    strict: bool


def sign_by_homogeneity(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Homogeneity: a condition makes the polynomial homogeneous, and cones settle what it becomes.

    Decides ``1 - 27*x*y*z >= 0 given x >= 0, y >= 0, z >= 0, x + y + z <= 1``. Ends where no
    condition is a homogeneous polynomial compared with a number, and where cones end.
    """
    terms = _terms(difference) or _written_terms(difference)
    if not terms or relation == "!=":
        return None
    for condition in region.beyond_box:
        bound = _bound(condition, region)
        made = _homogeneous(terms, bound, region) if bound is not None else None
        if bound is None or made is None:
            continue
        least, lost = made
        needed = ">=" if bound.strict and lost else relation
        proof: str | None = "it is so by the signs of its parts"
        if sign(least, region) not in PROVING[needed]:
            proof = sign_on_cones(least, needed, region)
        if proof is not None:
            return f"made homogeneous by {condition.expression} {condition.relation} 0, {proof}"
    return None


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


def _bound(condition: Condition, region: Given) -> _HomogeneousBound | None:
    """``k − L`` or ``L − k`` with L homogeneous and k > 0."""
    terms = _terms(condition.expression) if condition.relation in (">", ">=") else None
    if not terms or {t.degree for t in terms} - {0} != {max(t.degree for t in terms)}:
        return None
    constant = next((t.value for t in terms if t.degree == 0), fmpq(0))
    if constant == 0:
        return None
    side = 1 if constant > 0 else -1
    form = sum((t.expression for t in terms if t.degree), ZERO) * (-1 / constant)
    if side > 0 and sign(form, region) not in ("+", ">=0"):
        return None
    return _HomogeneousBound(form, max(t.degree for t in terms), side, condition.relation == ">")


def _homogeneous(
    terms: list[_Term], bound: _HomogeneousBound, region: Given
) -> tuple[Expr, bool] | None:
    """What is not larger and homogeneous, and whether it is smaller under a strict condition."""
    largest = max(t.degree for t in terms)
    result, lost = ZERO, False
    for term in terms:
        part = term.expression
        if term.degree < largest:
            signed = sign(part * bound.side, region)
            if signed not in ("+", ">=0"):
                return None
            lost = lost or signed == "+"
            part = part * power(bound.form, number(fmpq(largest - term.degree, bound.degree)))
        result = result + part
    return (result, lost) if any(t.degree < largest for t in terms) else None
