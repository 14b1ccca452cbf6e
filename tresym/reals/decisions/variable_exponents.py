"""Powers with variable exponents at nonpositive bases.

``x**a`` means ``exp(a log(x))``, so a claim with it is first decided for positive ``x``. For some
numbers ``a``, such as ``a = 1``, the power has a value elsewhere too, and a claim that fails there
is false: ``x**a >= 0``, ``(x**2)**a == x**(2*a)``. A negative base requires an integer exponent, so
the remaining claim is one about integers and is decided as such. Sample points are tried first;
they can only refute.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import cache, partial
from itertools import chain, islice, product
from math import prod

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Decide, exactly, refuted
from tresym.reals.decisions.equations import is_empty
from tresym.reals.decisions.statement import Comparison, Statement
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import Tape, rational_power, stands
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.language.binders import elementary, generalised
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    MAX_POWER,
    ONE,
    ZERO,
    Expr,
    integer,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

EXPONENTS = (*map(fmpq, (1, 2, 3, -1)), fmpq(1, 2), *map(fmpq, (-2, 0)), fmpq(1, 3))
ELSEWHERE = (*map(fmpq, (-1, 0, 2, -2)), fmpq(-1, 2), *map(fmpq, (1, -4)), fmpq(1, 2))
MOST, STRIDE = 512, 317811
"""Points that are tried; of more there are those that come at this stride, in no pattern."""
MOST_BASES = 3
OPEN = (
    "undecided where the base of a power ({1}) is not positive: "
    "{2}; add the condition that it is positive (for positive bases: {0})"
)


def beyond_positive_bases(
    answer: Answer, claim: Comparison, statement: Statement, decided: Decide
) -> Answer:
    """Extend a proof for positive bases to bases that are not positive.

    Where a base is negative its exponents are integers, and so the claim is decided for integers;
    where it is 0 they are not negative. Exponents that are integers by a condition have deciders of
    their own.

    Args:
        answer: the proof for positive bases.
        claim: the comparison to decide.
        statement: its conditions.
        decided: the procedure for the claim under more conditions.

    Returns:
        The answer, a refutation, or UNDECIDED with the bases in question.
    """
    trees = (claim.left, claim.right, *statement.said)
    if statement.path is not None:
        return answer
    asked = [part for part in _needs(claim) if elementary(part[0])]
    doubtful: dict[Expr, str | None] = {}
    for base, exponent in _powers(trees):
        if not base.loose and symbols(exponent) - {*statement.integers} and base not in doubtful:
            sign_of = _sign(base, statement.given & _said_of(base, asked))
            if sign_of != "+":
                doubtful[base] = sign_of
    if not doubtful:
        return answer
    if elementary(*trees):
        with ball_precision():
            found = next(_against(claim, statement, doubtful, asked), None)
        if found is not None:
            return found
    bases = ", ".join(sorted(map(str, doubtful)))
    if len(doubtful) > MOST_BASES:
        return Answer(Verdict.UNDECIDED, OPEN.format(answer.why, bases, "too many bases"))
    given = statement.given & Given(tuple(bound(*part) for part in asked))
    statement = replace(statement, given=given)
    for case, inside in chain(
        _at_negative_bases(claim, statement, doubtful), _at_zero(claim, statement, doubtful)
    ):
        if not is_empty(inside.given):
            found = decided(case, inside)
            if not found:
                return Answer(Verdict.UNDECIDED, OPEN.format(answer.why, bases, found.why))
    note = (
        f"; proved first where the bases of powers are positive ({bases}), then where they are not"
    )
    return replace(answer, why=answer.why + note)


def _sign(e: Expr, given: Given) -> str | None:
    """The sign of ``e`` by the cheap methods; what binds a variable counts as one."""
    e, *sides = generalised(e, *(side for link in given.comparisons for side in link[::2]))
    pairs = zip(given.comparisons, sides[::2], sides[1::2], strict=True)
    return sign(e, Given(tuple((x, link[1], y) for link, x, y in pairs)), dear=False)


def _at_negative_bases(
    claim: Comparison, statement: Statement, doubtful: Mapping[Expr, str | None]
) -> Iterator[tuple[Comparison, Statement]]:
    """The claim where some bases are negative, so that their exponents are integers."""
    trees = (claim.left, claim.right, *statement.said)
    for signs in islice(product((">", "<"), repeat=len(doubtful)), 1, None):
        chosen = dict(zip(doubtful, signs, strict=True))
        if any(doubtful[base] == ">=0" for base, relation in chosen.items() if relation == "<"):
            continue
        integers, put = dict.fromkeys(statement.integers), {}
        exponents = [e for base, e in _powers(trees) if chosen.get(base) == "<"]
        for e in sorted(exponents, key=lambda e: e.size):
            names = sorted(symbols(e))
            slope = differentiate(e, names[0])
            rest = integer(substitute(e, {names[0]: ZERO})) if len(names) == 1 else None
            if rest is not None and slope.op == "number" and names[0] not in integers:
                integers[names[0]] = None
                put[names[0]] = symbol(names[0]) / slope  # slope times it is the integer
        there = Given(tuple((base, relation, ZERO) for base, relation in chosen.items()))
        inside = replace(statement, given=statement.given & there, integers=tuple(integers))
        change = partial(substitute, mapping=put)
        yield claim.mapped(change), inside.mapped(change)


def _at_zero(
    claim: Comparison, statement: Statement, doubtful: Iterable[Expr]
) -> Iterator[tuple[Comparison, Statement]]:
    """The claim where a base is 0, but where it holds there by continuity.

    With its exponent fixed, such a power has its limit as the base falls to 0.
    """
    if claim.relation in ("==", ">=", "<=") and not jumps(claim.left) and not jumps(claim.right):
        return
    trees = (claim.left, claim.right, *statement.said)
    for base in doubtful:
        exponents = list(dict.fromkeys(e for b, e in _powers(trees) if b == base))
        for values in product((ZERO, ONE), repeat=len(exponents)):
            put = {power(base, e): v for e, v in zip(exponents, values, strict=True)}
            pairs = list(zip(exponents, values, strict=True))
            equations = [(base, ZERO), *((e, ZERO) for e, v in pairs if v == ONE)]
            positive = Given(tuple((e, ">", ZERO) for e, v in pairs if v == ZERO))
            inside = replace(
                statement.mapped(partial(replaced, known=put)),
                equations=(*statement.equations, *equations),
            )
            change = partial(replaced, known=put)
            yield claim.mapped(change), replace(inside, given=inside.given & positive)


def holds_powers(e: Expr) -> bool:
    """Whether a power with a variable as exponent is in it."""
    return next(_powers((e,)), None) is not None


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
                why = exactly("it fails", point) + ", where the base of a power is not positive"
                yield refuted(why, point, x, y)
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
