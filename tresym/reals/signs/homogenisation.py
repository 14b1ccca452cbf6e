"""Homogenise a polynomial by a condition such as x + y + z ≤ 1.

Let L be a homogeneous polynomial. If 0 ≤ L ≤ k, multiplying a nonnegative term by a power of L/k
makes it no larger. If L ≥ k > 0, the same holds for a nonpositive term. So the polynomial is
bounded below by a homogeneous function, and a proof for the latter is enough. For a homogeneous
function the point x = y = z becomes a ray, on which the cone method of
:mod:`tresym.reals.signs.orthant_cones` can handle equality.
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
    """Hold a monomial with its coefficient; ``value`` is 0 if the coefficient is not rational."""

    degree: int
    value: fmpq
    expression: Expr


class Way(NamedTuple):
    """Describe how a sum becomes homogeneous.

    Attributes:
        parts: its terms, each with the power of the form by which it is multiplied.
        form: a homogeneous form that is at most 1 if ``side`` is 1 and at least 1 if it is −1.
        side: 1 or −1, see ``form``.
        words: the condition that bounds the form, for the proof.
    """

    parts: tuple[tuple[Expr, fmpq], ...]
    form: Expr
    side: int
    words: str


def sign_by_homogeneity(
    difference: Expr, relation: str, region: Given, ask: Ask | None = None
) -> str | None:
    """Homogeneity: a condition makes the polynomial homogeneous, and the cone method proves the
    result.

    Decides ``1 - 27*x*y*z >= 0 given x >= 0, y >= 0, z >= 0, x + y + z <= 1``.

    Limits: some condition must compare a homogeneous polynomial with a number, and the cone
    method must succeed.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        region: the conditions.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
    """
    for way in ways(difference, region) if relation != "!=" else ():
        made = below(difference, way, region)
        if made is None:
            continue
        least, is_less = made
        needed = ">=" if is_less else relation
        proof: str | None = "the relation follows from the signs of its parts"
        if sign(least, region) not in PROVING[needed]:
            proof = sign_on_cones(least, needed, region)
        if proof is not None:
            return f"made homogeneous by {way.words}, {proof}"
    return None


def below(difference: Expr, way: Way, region: Given) -> tuple[Expr, bool] | None:
    """Return a homogeneous lower bound of ``difference``, and whether it is strictly smaller.

    Returns:
        The bound and whether it is smaller at every point; None if ``way`` does not prove the
            bound.
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
    """Yield a way for each condition that compares a homogeneous form with a number."""
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
    """Return the terms of a polynomial in symbols, or None if ``e`` is not such a polynomial."""
    terms = polynomial(e)
    if terms is None:
        return None
    return [_Term(degree(m), c, number(c) * as_expression(m)) for m, c in terms.items()]


def _written_terms(e: Expr) -> list[_Term] | None:
    """Return the terms as written, for coefficients that are constants such as sqrt(3)."""
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
