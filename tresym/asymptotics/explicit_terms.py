"""The terms of an asymptotic expansion of an explicit function, one after another.

Each is the leading term of what the terms found so far leave (Gruntz's algorithm,
:mod:`tresym.reals.expansions`). Example: 1/(2 − e^{x}) at x → log 2 begins with 1/(2 (log 2 − x)).
"""

from __future__ import annotations

from typing import NamedTuple

from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.leading_terms import written_term
from tresym.reals.language.expression import (
    ONE,
    Expr,
    add,
    factors_in,
    multiply,
    power,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.interior import is_zero

LARGEST = 600
"""The largest size of an expression whose leading term is looked for."""


class Terms(NamedTuple):
    """Terms of an expansion, the largest first.

    Attributes:
        terms: the terms.
        gauge: the comparison function of the error; None if the expansion ends.
        uniform: whether the error is meant for all values of the other variables together.
    """

    terms: tuple[Expr, ...]
    gauge: Expr | None
    uniform: bool = False


def explicit_terms(f: Expr, path: Path, given: Given, count: int) -> Terms | None:
    """Return the first terms of an explicit function, from the first side of the path.

    None if a leading term is not found.
    """
    found: list[Expr] = []
    for _ in range(count + 1):
        rest = f - add(*found) if found else f
        if is_zero(rest, given):
            return Terms(tuple(found), None)
        first = first_term(rest, path, given)
        if first is None:
            return None
        if len(found) == count:
            return Terms(tuple(found), first[1])
        found.append(first[0])
    return None


def first_term(e: Expr, path: Path, given: Given) -> tuple[Expr, Expr] | None:
    """Return the leading term of ``e`` and the same without its coefficient."""
    if e.size > LARGEST:
        return None
    found = written_term(e, path.name, path.point, path.sides[0], given)
    return None if found is None else (simple_term(found[0]), simple_term(found[1]))


def simple_term(e: Expr) -> Expr:
    """Return a term with its constant factors in normal form, in front."""
    factors = factors_in(e)
    fixed = [f for f in factors if not symbols(f)]
    moving = [f for f in factors if symbols(f)]
    constant = normal_form(multiply(ONE, *fixed), Given()) if fixed else ONE
    return multiply(constant, *map(_positive_powers, moving)) if moving else constant


def _positive_powers(e: Expr) -> Expr:
    """Return a factor (c x)^n as c^n x^n for integers n."""
    if e.op == "^" and e.args[0].op == "*" and e.args[1].op == "number":
        r = e.args[1].args[0]
        first = e.args[0].args[0]
        if first.op == "number" and r.q == 1:
            return power(first, e.args[1]) * power(multiply(*e.args[0].args[1:]), e.args[1])
    return e
