"""Where what is differentiated is real: a claim with derivatives speaks of these points alone."""

from __future__ import annotations

from collections.abc import Iterable

from tresym.reals.language.expression import (
    Expr,
    symbols,
)
from tresym.reals.places.conditions import Given
from tresym.reals.places.domain import bound, needs
from tresym.reals.signs.inside import PROVING
from tresym.reals.signs.sign import sign


def where_real(
    given: Given, functions: Iterable[Expr], by: Iterable[str] = ()
) -> tuple[Given, Given]:
    """``given`` and that the functions are real, to refute at a point and to prove everywhere.

    A claim that holds derivatives speaks of the points beside which, in the variables ``by``, what
    is differentiated is real. ``x**(3/2)`` is real at 0 and not beside it: a proof counts such a
    point in, and a refutation leaves it out.
    """
    parts = [part for part in needs(functions) if not _holds_everywhere(*part)]
    whole = tuple(bound(*part) for part in parts)
    opened = tuple(
        bound(e, ">" if relation == ">=" and symbols(e) & set(by) else relation)
        for e, relation in parts
    )
    return Given(given.comparisons + opened), Given(given.comparisons + whole)


def _holds_everywhere(e: Expr, relation: str) -> bool:
    return sign(e, Given()) in PROVING[relation]
