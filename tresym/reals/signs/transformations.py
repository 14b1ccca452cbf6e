"""Transform an inequality into an equivalent simpler one.

The functions that find transformations are not trusted: :func:`holds` checks for each one that the
simpler inequality implies the original.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import reduce
from math import gcd
from typing import NamedTuple

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import needs
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
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import MIRRORED
from tresym.reals.language.like_terms import scaled
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.normal.to_expression import written
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import PROVING, Ask, is_zero, without_powers
from tresym.reals.signs.interior import sign_inside as sign

MAX_EXPONENT = 100


class Link(NamedTuple):
    """Relate two inequalities, one of which is easier.

    Attributes:
        hard: the left side of the inequality ``hard relation 0`` that is sought, under ``given``.
        given: the conditions of the inequality that is sought.
        easy: the left side of an inequality that implies it, under ``where``.
        where: the conditions of the easier inequality.
        scale: the factor or substitution that relates them, see :func:`holds`.
        words: what was done, for the proof.
    """

    hard: Expr
    given: Given
    easy: Expr
    where: Given
    scale: dict[str, Expr] | Expr | None
    words: str


def by_equivalents(difference: Expr, relation: str, given: Given, ask: Ask) -> str | None:
    """Equivalents: the claim is transformed into an equivalent inequality that another method
    proves.

    Factors of known sign are divided out, ``x**2`` becomes the variable, or logarithms or
    exponentials of both sides are taken.

    Decides ``x**x >= exp(-1/E) given x > 0``.

    Limits: one such step is tried, or two if one of them makes a power the variable.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        given: the conditions.
        ask: the prover for the transformed inequality.

    Returns:
        A sentence that states the proof, or None.
    """
    for links in equivalents(difference, relation, given):
        found = ask(links[-1].easy, relation, links[-1].where)
        if found is not None and all(holds(link, relation) for link in links):
            return "".join(link.words for link in links) + found
    return None


def holds(link: Link, relation: str) -> bool:
    """Return whether ``hard relation 0`` follows from ``easy relation 0`` wherever hard is defined.

    There are three kinds of links. With a scale s > 0, hard = s·(exp(easy) − 1) or easy =
    s·(exp(hard) − 1). With no scale and ``>=``, hard/easy ≥ 0. With a dict as scale, substituting
    its values for the variables of easy gives hard.
    """
    hard, given, easy, where, scale, _ = link
    if isinstance(scale, dict):
        meant = substitute(easy, scale)
        for condition in where.conditions:
            e = substitute(condition.expression, scale)
            if (
                condition not in given.conditions
                and sign(e, given) not in PROVING[condition.relation]
            ):
                return False
        return _are_defined(meant, hard, given) and is_zero(meant - hard, given)
    if not _are_defined(easy, hard, given):
        return False
    if scale is None:
        return relation == ">=" and sign(hard / easy, given) in PROVING[">="]
    grown = (scale * (apply("exp", one) - 1) - other for one, other in ((easy, hard), (hard, easy)))
    return sign(scale, given) == "+" and any(is_zero(e, given) for e in grown)


def _are_defined(e: Expr, before: Expr, given: Given) -> bool:
    """Return whether ``e`` is defined wherever ``before`` is."""
    known = needs((before,))
    return all(part in known or sign(part[0], given) in PROVING[part[1]] for part in needs((e,)))


def equivalents(difference: Expr, relation: str, region: Given) -> Iterator[tuple[Link, ...]]:
    """Yield chains of links from the difference to easier ones."""
    ways: list[tuple[Link, ...]] = [()]
    for left, right in _sides(difference):
        easy = _logarithms(left, right, region)
        if easy is not None:
            words = "after taking logarithms of both sides, "
            ways.append((Link(difference, region, easy, region, right, words),))
    sides = _exponentials(difference)
    if sides is not None:
        easy, words = sides[0] - sides[1], "after taking exponentials of both sides, "
        ways.append((Link(difference, region, easy, region, sides[1], words),))
    for way in tuple(ways) if relation == ">=" else ():
        hard = way[-1].easy if way else difference
        cleared, words = _cleared(hard, region), "after dividing by factors of known sign, "
        if cleared is not None:
            ways.append((*way, Link(hard, region, cleared, region, None, words)))
    for way in ways:
        hard = way[-1].easy if way else difference
        if way:
            yield way
        for name in sorted(symbols(hard)):
            evened = _in_powers(hard, name, region)
            if evened is not None:
                easy, where, g = evened
                words = f"with {name} written for {name}**{g}, "
                yield (*way, Link(hard, region, easy, where, {name: symbol(name) ** g}, words))


def _sides(difference: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Yield two sides with this difference: one term with an exponential, and the rest."""
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
    """Return log left − log right for two sides that are proved positive, else None."""
    if any(sign(f, region) != "+" for side in (left, right) for f in _factors(side)):
        return None
    return _logarithm(left) - _logarithm(right)


def _logarithm(e: Expr) -> Expr:
    """Return log e as a sum over its factors, which are positive."""
    if e.op == "*":
        return add(*map(_logarithm, e.args))
    if e.op == "exp":
        return e.args[0]
    if e.op == "^":
        return e.args[1] * apply("log", e.args[0])
    return apply("log", e)


def _cleared(difference: Expr, region: Given) -> Expr | None:
    """Return the factors of unknown sign, times the sign of the others; None if it is not found."""
    try:
        field = Field(region)
        (value,) = field.normal(difference)
        known, rest = 1, field.one_poly
        for content, parts in (
            field.factor(without_powers(field, p)) for p in (value.num, value.den)
        ):
            known *= 1 if content > 0 else -1
            for part in (part for part, multiplicity in parts if multiplicity % 2):
                sign_ = field.sign(part)
                known, rest = known * (sign_ or 1), rest if sign_ else rest * part
        factors = written(field, rest)
    except (TooLargeError, UndefinedError, InputError):
        return None
    return None if factors is None else known * factors


def _exponentials(difference: Expr) -> tuple[Expr, Expr] | None:
    """Return the exponentials of both sides, for a sum of multiples of logarithms and constants."""
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
    return multiply(*sides[0]), multiply(*sides[1])


def _in_powers(difference: Expr, name: str, region: Given) -> tuple[Expr, Given, int] | None:
    """Write a symbol for its own g-th power, where only powers divisible by g occur.

    The symbol must be bounded by nonnegative numbers or, for even g, may be unbounded.

    Returns:
        The difference, its region and g > 1; None if there is no such g.
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
            left, relation, right = right, MIRRORED[relation], left
        if not (bounded and left == symbol(name) and right.op == "number" and right.args[0] >= 0):
            return None
        conditions.append((left, relation, right**g))
    conditions.append((symbol(name), ">=", ZERO))
    return _lowered(difference, name, g), Given(tuple(conditions)), g


def _exponents(e: Expr, name: str) -> Iterator[int]:
    """Yield the natural powers in which a symbol occurs; 1 for any other occurrence."""
    if e == symbol(name):
        yield 1
    elif e.op == "^" and e.args[0] == symbol(name) and e.args[1].op == "number":
        r = e.args[1].args[0]
        yield int(r.p) if r.q == 1 and r > 0 else 1
    elif name in symbols(e):
        for arg in e.args:
            yield from _exponents(arg, name)


def _lowered(e: Expr, name: str, g: int) -> Expr:
    """Return ``e`` with every power of the symbol divided by g."""
    if name not in symbols(e):
        return e
    if e.op == "^" and e.args[0] == symbol(name) and e.args[1].op == "number":
        return power(e.args[0], number(e.args[1].args[0] / g))
    return rebuild(e, tuple(_lowered(arg, name, g) for arg in e.args))
