"""Inequalities that are equivalent to a given one, and easier: exact steps of a proof by hand."""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from math import gcd

from tresym.reals.language.cancellation import scaled
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    rebuild,
    symbol,
    symbols,
)
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.normal.written import written
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.places.conditions import Given
from tresym.reals.signs.cones import open_factors
from tresym.reals.signs.inside import Ask
from tresym.reals.signs.inside import sign_inside as sign

MAX_EXPONENT = 100
_FLIP = {">": "<", ">=": "<=", "<": ">", "<=": ">=", "!=": "!="}


def by_equivalents(difference: Expr, relation: str, given: Given, ask: Ask) -> str | None:
    """Equivalents: an inequality that implies this one is proved by the methods before.

    Factors of known sign are divided out, ``x**2`` is made the variable, logarithms or
    exponentials are taken of both sides.

    Decides ``x**x >= exp(-1/E) given x > 0``. Ends after one such step, or two with a power
    for the variable.
    """
    for other, where, words in equivalents(difference, relation, given):
        found = ask(other, relation, where)
        if found is not None:
            return words + found
    return None


def equivalents(
    difference: Expr, relation: str, region: Given
) -> Iterator[tuple[Expr, Given, str]]:
    """Differences whose ``relation`` to zero on their regions implies that of this one.

    Each with words that say what was done.
    """
    found: list[tuple[Expr | None, str]] = [(difference, "")]
    words = "of the logarithms of both sides, "
    found += [(_logarithms(*sides, region), words) for sides in _sides(difference)]
    found.append((_exponentials(difference), "of the exponentials of both sides, "))
    if relation == ">=":
        found += [
            (_cleared(e, region), f"{words}cleared of factors of known sign, ")
            for e, words in found
            if e is not None
        ]
    for other, words in found:
        if other is None:
            continue
        if words:
            yield other, region, words
        for name in sorted(symbols(other)):
            evened = _in_powers(other, name, region)
            if evened is not None:
                yield *evened[:2], f"{words}{name} written for {name}**{evened[2]}, "


def _sides(difference: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Two sides with this difference: one term, in which an exponential grows, and the rest."""
    terms = difference.args if difference.op == "+" else (difference,)
    for n, term in enumerate(terms):
        if any(map(_is_exponential, _factors(term))):
            others = (*terms[:n], *terms[n + 1 :])
            if scaled(term)[0] < 0:
                yield add(*others), -term
            else:
                yield term, add(*(-other for other in others))


def _factors(e: Expr) -> tuple[Expr, ...]:
    return e.args if e.op == "*" else (e,)


def _is_exponential(e: Expr) -> bool:
    return e.op == "exp" or (e.op == "^" and e.args[1].op != "number")


def _logarithms(left: Expr, right: Expr, region: Given) -> Expr | None:
    """log left − log right, for two positive sides of which one has an exponential factor."""
    if any(sign(f, region) != "+" for side in (left, right) for f in _factors(side)):
        return None
    return _logarithm(left) - _logarithm(right)


def _logarithm(e: Expr) -> Expr:
    """log e, taken into its factors, which are positive."""
    if e.op == "*":
        return add(*map(_logarithm, e.args))
    if e.op == "exp":
        return e.args[0]
    if e.op == "^":
        return e.args[1] * apply("log", e.args[0])
    return apply("log", e)


def _cleared(difference: Expr, region: Given) -> Expr | None:
    """The factors of the difference of which no sign is known, times the sign of the others."""
    try:
        field = Field(region)
        (value,) = field.normal(difference)
        known, rest = open_factors(field, (value.num, value.den), strict=False)
        factors = written(field, rest)
    except (TooLargeError, UndefinedError, InputError):
        return None
    return None if factors is None else known * factors


def _exponentials(difference: Expr) -> Expr | None:
    """A product of powers less another, for a sum of multiples of logarithms and a constant."""
    sides: list[list[Expr]] = [[], []]
    stack = [(difference, ONE)]
    while stack:
        term, scale = stack.pop()
        if term.op == "+":
            stack += [(arg, scale) for arg in term.args]
        elif term.op == "*" and len(term.args) == 2 and term.args[0].op == "number":
            stack.append((term.args[1], scale * term.args[0]))
        elif term.op == "log":
            r = scale.args[0]
            if max(abs(r.p), r.q) > MAX_EXPONENT:
                return None
            sides[r < 0].append(power(term.args[0], number(abs(r))))
        elif not symbols(term):
            sides[0].append(apply("exp", scale * term))
        else:
            return None
    return multiply(*sides[0]) - multiply(*sides[1])


def _in_powers(difference: Expr, name: str, region: Given) -> tuple[Expr, Given, int] | None:
    """The difference, its region and g, with the symbol written for its own g-th power, g > 1.

    The symbol enters through powers that are multiples of g alone, and is bounded by numbers that
    are not negative, or, for even g, not bounded.
    """
    exponents = set(_exponents(difference, name))
    g = reduce(gcd, exponents, 0)
    if g < 2:
        return None
    conditions = []
    bounded = sign(symbol(name), region) in ("+", ">=0")
    if not bounded and g % 2:
        return None
    for left, relation, right in region.comparisons:
        if name not in symbols(left) | symbols(right):
            conditions.append((left, relation, right))
            continue
        if left.op == "number":
            left, relation, right = right, _FLIP[relation], left
        if not (bounded and left == symbol(name) and right.op == "number" and right.args[0] >= 0):
            return None
        conditions.append((left, relation, right**g))
    conditions.append((symbol(name), ">=", ZERO))
    return _lowered(difference, name, g), Given(tuple(conditions)), g


def _exponents(e: Expr, name: str) -> Iterator[int]:
    """The natural powers in which a symbol occurs; 1 for any other occurrence."""
    if e == symbol(name):
        yield 1
    elif e.op == "^" and e.args[0] == symbol(name) and e.args[1].op == "number":
        r = e.args[1].args[0]
        yield int(r.p) if r.q == 1 and r > 0 else 1
    elif name in symbols(e):
        for arg in e.args:
            yield from _exponents(arg, name)


def _lowered(e: Expr, name: str, g: int) -> Expr:
    """``e`` with every power of the symbol divided by g."""
    if name not in symbols(e):
        return e
    if e.op == "^" and e.args[0] == symbol(name) and e.args[1].op == "number":
        return power(e.args[0], number(e.args[1].args[0] / g))
    return rebuild(e, tuple(_lowered(arg, name, g) for arg in e.args))
