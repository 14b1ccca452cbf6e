"""Powers whose exponents are variables: proofs speak of positive bases, and here of the others.

``x**a`` is ``exp(a log(x))``, and so a claim with it is decided where ``x`` is positive. But for a
number ``a`` the power may have a value elsewhere, as at ``a = 1``, and a claim that fails there
is false: ``x**a >= 0``, ``(x**2)**a == x**(2*a)``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache, partial
from math import prod

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, refuted
from tresym.reals.decisions.claim_parsing import Comparison, Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import Tape, rational_power, stands
from tresym.reals.domain.operation_domains import bound, needs
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
from tresym.reals.numbers.arithmetic import ball_precision
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
        found = next(_against(claim, statement, doubtful, asked), None)
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


def _against(
    claim: Comparison,
    statement: Statement,
    doubtful: Iterable[Expr],
    asked: Iterable[tuple[Expr, str]],
) -> Iterator[Answer]:
    """Refutations at points where a base in doubt is not positive."""
    sides = (claim.left, claim.right, *statement.said)
    raised = {name for _, exponent in _powers(sides) for name in symbols(exponent)}
    names = sorted(set().union(*map(symbols, sides)), key=lambda name: (name in raised, name))
    tried = [
        [(x, arb(x)) for x in (EXPONENTS if name in raised else ELSEWHERE)]
        for name in reversed(names)
    ]
    count = prod(map(len, tried))
    some = (k * STRIDE % count for k in range(MOST)) if count > MOST else range(count)
    links = [(e, relation) for e, relation in asked]
    links += [(x - y, relation) for x, relation, y in statement.given.comparisons]
    links += [(x - y, "==") for x, y in statement.equations]
    at = cache(partial(_AtNumbers, names=names))
    for k in some:
        digits = []
        for values in tried:
            k, n = divmod(k, len(values))
            digits.append(values[n])
        exact, near = zip(*reversed(digits), strict=True)
        point = dict(zip(names, exact, strict=True))
        if any(point[name].q != 1 for name in statement.integers if name in point):
            continue
        if all(at(base)(near) > 0 for base in doubtful):
            continue
        failing = next(
            (link for link in links if not _holds(at(link[0])(near), *link, point)), None
        )
        if failing is None:
            x, y = at(claim.left)(near), at(claim.right)(near)
            if stands(x - y, NEGATED[claim.relation]):
                yield refuted("the powers have values there too, and it fails", point, x, y)
        else:
            links.sort(key=lambda link: link is not failing)  # it may fail at the next point, too


def _holds(difference: arb, e: Expr, relation: str, point: Mapping[str, fmpq]) -> bool:
    """Whether ``e``, of which this is the ball at the point, is shown to stand so to zero."""
    if stands(difference, relation) or not difference.contains(0):
        return stands(difference, relation)
    if relation not in (">=", "<="):
        return False
    return equal_at(substitute(e, {name: number(x) for name, x in point.items()}), ZERO, {})


class _AtNumbers(Tape):
    """Values in balls, where a power whose exponent is a number is that of the number."""

    @staticmethod
    def _power(x: arb, y: arb) -> arb:
        r = y.fmpq() if y.is_exact() and abs(y) < MAX_POWER else None
        if r is None or r.q > MAX_POWER:
            return Tape._power(x, y)
        return rational_power(x, r)
