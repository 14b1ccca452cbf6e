"""Transform an inequality into an equivalent simpler one.

The functions that find transformations are not trusted: :func:`holds` checks for each one that the
simpler inequality implies the original. For example, √(x² + 1) < x + 1 for x > 0 follows from the
inequality of the squares, x² + 1 < x² + 2x + 1.
"""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.expression import (
    Expr,
    add,
    apply,
    factors_in,
)
from tresym.reals.language.like_terms import scaled
from tresym.reals.normal.factors import factor_polynomial
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.normal.to_expression import written
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import PROVING, Ask, is_zero, without_powers
from tresym.reals.signs.interior import sign_inside as sign


class Link(NamedTuple):
    """Relate two inequalities, one of which is easier.

    Attributes:
        hard: the left side of the inequality ``hard relation 0`` that is sought.
        easy: the left side of an inequality that implies it.
        scale: the factor that relates them, see :func:`holds`.
        words: what was done, for the proof.
    """

    hard: Expr
    easy: Expr
    scale: Expr | None
    words: str


def by_equivalents(difference: Expr, relation: str, given: Given, ask: Ask) -> str | None:
    """Equivalents: the claim is transformed into an equivalent inequality that another method
    proves.

    Factors of known sign are divided out, or logarithms of both sides are taken.

    Decides ``x**x >= exp(-1/E) given x > 0``.

    Limits: each of the two steps is tried once.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        given: the conditions.
        ask: the prover for the transformed inequality.

    Returns:
        A sentence that states the proof, or None.
    """
    for links in equivalents(difference, relation, given):
        sentence = ask(links[-1].easy, relation, given)
        if sentence is not None and all(holds(link, relation, given) for link in links):
            return "".join(link.words for link in links) + sentence
    return None


def holds(link: Link, relation: str, given: Given) -> bool:
    """Return whether ``hard relation 0`` follows from ``easy relation 0`` wherever hard is defined.

    With a scale s > 0, hard = s·(exp(easy) − 1). With no scale and ``>=``, hard/easy ≥ 0.
    """
    hard, easy, scale, _ = link
    if not _are_defined(easy, hard, given):
        return False
    if scale is None:
        return relation == ">=" and sign(hard / easy, given) in PROVING[">="]
    return sign(scale, given) == "+" and is_zero(scale * (apply("exp", easy) - 1) - hard, given)


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
            ways.append((Link(difference, easy, right, words),))
    for way in tuple(ways) if relation == ">=" else ():
        hard = way[-1].easy if way else difference
        cleared, words = _cleared(hard, region), "after dividing by factors of known sign, "
        if cleared is not None:
            ways.append((*way, Link(hard, cleared, None, words)))
    yield from ways[1:]


def _sides(difference: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Yield two sides with this difference: one term with an exponential, and the rest."""
    terms = difference.args if difference.op == "+" else (difference,)
    for n, term in enumerate(terms):
        if any(map(_is_exponential, factors_in(term))):
            others = (*terms[:n], *terms[n + 1 :])
            if scaled(term)[0] < 0:
                yield add(*others), -term
            else:
                yield term, add(*(-other for other in others))


def _is_exponential(e: Expr) -> bool:
    return e.op == "exp" or (e.op == "^" and e.args[1].op != "number")


def _logarithms(left: Expr, right: Expr, region: Given) -> Expr | None:
    """Return log left − log right for two sides that are proved positive, else None."""
    if any(sign(f, region) != "+" for side in (left, right) for f in factors_in(side)):
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
    """Return the product of the factors of unknown sign, with the sign of the others, or None."""
    try:
        field = Field(region)
        (value,) = field.normal(difference)
        known, rest = 1, field.ring.one_poly
        for content, parts in (
            factor_polynomial(field.ring, without_powers(field, p)) for p in (value.num, value.den)
        ):
            known *= 1 if content > 0 else -1
            for part in (part for part, multiplicity in parts if multiplicity % 2):
                sign_ = field.signs.sign(part)
                known, rest = known * (sign_ or 1), rest if sign_ else rest * part
        factors = written(field, rest)
    except (TooLargeError, UndefinedError, InputError):
        return None
    return None if factors is None else known * factors
