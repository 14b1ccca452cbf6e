"""Restrict claims with derivatives to points at which the differentiated functions are real."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache

from flint import arb

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.language.expression import (
    Expr,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign


def where_real(
    given: Given, functions: Iterable[Expr], by: Iterable[str] = ()
) -> tuple[Given, Given]:
    """Return the conditions for refuting and for proving a claim with derivatives.

    A derivative exists only at points with a neighbourhood, in the variables ``by``, on which the
    function is real. ``x**(3/2)`` is real at 0 but not on a neighbourhood: a proof includes such a
    point, and a refutation excludes it.
    """
    parts = [part for part in needs(functions) if not _holds_everywhere(*part)]
    whole = tuple(bound(*part) for part in parts)
    opened = tuple(
        bound(e, ">" if relation == ">=" and symbols(e) & set(by) else relation)
        for e, relation in parts
    )
    return Given(given.comparisons + opened), Given(given.comparisons + whole)


def interior(given: Given, functions: Iterable[Expr], by: Iterable[str]) -> Given:
    """Return the first of the conditions of :func:`where_real`, and more that follow from them."""
    names = {*by}
    return Given(
        given.comparisons
        + tuple(
            bound(e, ">")
            if relation == ">=" and symbols(e) & names and not _holds_everywhere(e, relation)
            else bound(e, relation)
            for e, relation in needs(functions)
        )
    )


def real_nowhere(given: Given, functions: Iterable[Expr]) -> bool:
    """Whether what one of ``functions`` needs to be real is shown to fail wherever ``given`` holds,
    and variables are what the functions need of them, as b != 0 for sqrt(-b**2)/b."""
    parts = needs(functions)
    factors = ((part, relation) for e, relation in parts for part in _nonzero_factors(e, relation))
    bounds = (bound(*factor) for factor in factors)
    known = given & Given(tuple(link for link in bounds if link[0].op == "symbol"))
    return any(
        sign(e, given if e.op == "symbol" else known) in EXCLUDING[relation]
        for e, relation in parts
    )


def _nonzero_factors(e: Expr, relation: str) -> Iterator[Expr]:
    """What stands in the relation to zero because ``e`` does: of what is not 0, every factor."""
    if relation == "!=" and e.op == "*":
        for arg in e.args:
            yield from _nonzero_factors(arg, relation)
    elif relation == "!=" and e.op == "^" and e.args[1].op == "number" and e.args[1].args[0] > 0:
        yield from _nonzero_factors(e.args[0], relation)
    else:
        yield e


EXCLUDING = {">": ("-", "0", "<=0"), ">=": ("-",), "!=": ("0",)}
"""The signs that exclude a relation to zero."""


SAMPLES = ((1, -2, 3, -5, 7), (-1, 3, -2, 7, -5), (2, 2, -1, -1, 5))
"""Values of the variables at which an expression is looked at before its sign is proved."""


@lru_cache(maxsize=1 << 10)
def _holds_everywhere(e: Expr, relation: str) -> bool:
    return not _takes_other_signs(e, relation) and sign(e, Given()) in PROVING[relation]


def _takes_other_signs(e: Expr, relation: str) -> bool:
    """Return whether values of ``e`` show that it has no sign that proves the relation."""
    names = sorted(symbols(e))
    if e.hidden:
        return False
    with ball_precision(64):
        values = [
            evaluate(e, {name: arb(at[n % len(at)]) for n, name in enumerate(names)})
            for at in SAMPLES
        ]
    positive = any(value > 0 for value in values)
    negative = any(value < 0 for value in values)
    return negative and (positive or relation != "!=")
