"""Powers whose exponents are variables: proofs speak of positive bases, and here of the others.

``x**a`` is ``exp(a log(x))``, and so a claim with it is decided where ``x`` is positive. But for a
number ``a`` the power may have a value elsewhere, as at ``a = 1``, and a claim that fails there
is false: ``x**a >= 0``, ``(x**2)**a == x**(2*a)``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from math import prod

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, refuted
from tresym.reals.decisions.reading import Comparison, Statement
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    LEAVES,
    MAX_POWER,
    ZERO,
    Expr,
    number,
    substitute,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision, balls
from tresym.reals.places.conditions import Given
from tresym.reals.places.domain import bound, needs
from tresym.reals.places.values import InBalls, UndefinedError, rational_power, real_power, stands
from tresym.reals.signs.sign import sign

EXPONENTS = (*map(fmpq, (1, 2, 3, -1)), fmpq(1, 2), *map(fmpq, (-2, 0)), fmpq(1, 3))
ELSEWHERE = (*map(fmpq, (-1, 0, 2, -2)), fmpq(-1, 2), *map(fmpq, (1, -4)), fmpq(1, 2))
MOST, STRIDE = 64, 317811
"""Points that are tried; of more there are those that come at this stride, in no pattern."""


def beyond_positive_bases(answer: Answer, claim: Comparison, statement: Statement) -> Answer:
    """An answer that passes, which says where its powers are taken; or what refutes it elsewhere.

    Exponents that are integers by a condition have deciders of their own.
    """
    trees = (claim.left, claim.right, *statement.said)
    if statement.path is not None or not elementary(*trees):
        return answer
    asked = _needs(claim)
    doubtful = {
        base
        for base, exponent in _powers(trees)
        if symbols(exponent) - {*statement.integers}
        and sign(base, statement.given & _said_of(base, asked), dear=False) != "+"
    }
    if not doubtful:
        return answer
    with ball_precision():
        found = next(_against(claim, statement, doubtful), None)
    if found is not None:
        return found
    bases = ", ".join(sorted(map(str, doubtful)))
    note = f"; powers with a variable as exponent are taken where their base is positive: {bases}"
    return replace(answer, why=answer.why + note)


def _powers(trees: Iterable[Expr]) -> Iterator[tuple[Expr, Expr]]:
    """Base and exponent of every power in the trees with a variable as exponent."""
    seen: set[Expr] = set()
    stack = list(trees)
    while stack:
        e = stack.pop()
        if e.op not in LEAVES and e not in seen:
            seen.add(e)
            stack.extend(e.args)
            if e.op == "^" and symbols(e.args[1]):
                yield e.args[0], e.args[1]


def _needs(claim: Comparison) -> list[tuple[Expr, str]]:
    """What must hold for all parts of the claim to be real but powers with variable exponents.

    Beside a point at which what is differentiated is real it is real, too.
    """
    parts = needs((claim.left, claim.right), powers=False)
    real = needs(claim.differentiated, powers=False)
    return [*parts, *((e, relation.replace(">=", ">")) for e, relation in real)]


def _said_of(base: Expr, asked: Iterable[tuple[Expr, str]]) -> Given:
    """What is asked of the variables of the base alone."""
    return Given(tuple(bound(*part) for part in asked if symbols(part[0]) <= symbols(base)))


def _against(claim: Comparison, statement: Statement, doubtful: set[Expr]) -> Iterator[Answer]:
    """Refutations at points where a base in doubt is not positive."""
    sides = (claim.left, claim.right, *statement.said)
    raised = {name for _, exponent in _powers(sides) for name in symbols(exponent)}
    names = sorted(set().union(*map(symbols, sides)), key=lambda name: (name in raised, name))
    tried = [EXPONENTS if name in raised else ELSEWHERE for name in names]
    count = prod(map(len, tried))
    some = (k * STRIDE % count for k in range(MOST)) if count > MOST else range(count)
    equal = tuple((left, "==", right) for left, right in statement.equations)
    links = [(e, relation, ZERO) for e, relation in _needs(claim)]
    links += [*statement.given.comparisons, *equal]
    for k in some:
        point = {}
        for name, values in zip(reversed(names), reversed(tried), strict=True):
            k, n = divmod(k, len(values))
            point[name] = values[n]
        if any(point[name].q != 1 for name in statement.integers if name in point):
            continue
        at = _AtNumbers(balls, point)
        if all(at.size(base) > 0 for base in doubtful):
            continue
        failing = next((link for link in links if not _holds(at, *link)), None)
        if failing is None:
            x, y = at.size(claim.left), at.size(claim.right)
            if stands(x - y, NEGATED[claim.relation]):
                yield refuted("the powers have values there too, and it fails", point, x, y)
        else:
            links.sort(key=lambda link: link is not failing)  # it may fail at the next point, too


def _holds(at: _AtNumbers, left: Expr, relation: str, right: Expr) -> bool:
    """Whether a condition is shown to hold."""
    difference = at.size(left) - at.size(right)
    if stands(difference, relation) or not difference.contains(0):
        return stands(difference, relation)
    put_in = partial(substitute, mapping={name: number(x) for name, x in at.at.items()})
    return relation in (">=", "<=") and equal_at(put_in(left), put_in(right), {})


class _AtNumbers(InBalls):
    """Values in balls, where a power whose exponent is a number is that of the number."""

    def size(self, e: Expr) -> arb:
        """The value of ``e``, NaN where it has none."""
        try:
            return self.value(e)
        except UndefinedError:
            return arb.nan()

    def _power(self, base: Expr, exponent: Expr) -> arb:
        x, y = self.value(base), self.value(exponent)
        r = y.fmpq() if y.is_exact() and abs(y) < MAX_POWER else None
        return real_power(x, y) if r is None or r.q > MAX_POWER else rational_power(x, r)
