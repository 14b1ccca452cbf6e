"""Powers with variable exponents at nonpositive bases.

``x**a`` means ``exp(a log(x))``, so a claim with it is first decided for positive ``x``. For some
numbers ``a``, such as ``a = 1``, the power has a value elsewhere too, and a claim that fails there
is false: ``x**a >= 0``, ``(x**2)**a == x**(2*a)``. A negative base requires an integer exponent, so
the remaining claim is one about integers and is decided as such. Where it is open, simple
exponents are tried.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import chain, islice, product

from tresym.checking.point_check import confirmed
from tresym.reals.decisions.answer import Answer, Decide, exact_text
from tresym.reals.decisions.equations import is_empty, value_given
from tresym.reals.decisions.readable_witnesses import decided_at
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.language.binders import elementary, generalised
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    HALF,
    LEAVES,
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
from tresym.reals.language.parsing import parse
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MOST_BASES = 3
EXPONENTS, MOST = (number(2), HALF, ONE), 9
"""Values of the variables in exponents, and how many points, at which the claim is looked at."""
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
            at = _at_values(base, statement)
            sign_of = _sign(at, _without_powers(statement.given) & _said_of(base, asked))
            if sign_of != "+":
                doubtful[base] = sign_of
    if not doubtful:
        return answer
    bases = ", ".join(sorted(map(str, doubtful)))
    if len(doubtful) > MOST_BASES:
        return Answer(Verdict.UNDECIDED, OPEN.format(answer.why, bases, "too many bases"))
    given = statement.given & Given(tuple(bound(*part) for part in asked))
    whole = replace(statement, given=given)
    for case, inside, put in chain(
        _at_negative_bases(claim, whole, doubtful), _at_zero(claim, whole, doubtful)
    ):
        if not is_empty(_without_powers(inside.given)):
            found = decided(case, inside)
            if found.verdict is Verdict.REFUTED:
                found = _of_claim(found, put, claim, statement)
            if found.verdict is Verdict.REFUTED:
                return found
            if not found:
                why = OPEN.format(answer.why, bases, found.why)
                other = _at_simple_exponents(claim, statement, decided)
                return Answer(Verdict.UNDECIDED, why) if other is None else other
    note = (
        f"; proved first where the bases of powers are positive ({bases}), then where they are not"
    )
    return replace(answer, why=answer.why + note)


def _at_values(base: Expr, statement: Statement) -> Expr:
    """A base with the values that equations give to its variables put in.

    A claim with derivatives is about the points around, too, where a continuous base that is
    positive at the point is positive as well.
    """
    known = [value_given(pair, statement) for pair in statement.equations]
    put = dict(value for value in known if value is not None)
    if not put or continuous_on(base, statement.given) is not None:
        return base
    return substitute(base, put)


def _without_powers(given: Given) -> Given:
    """The conditions without variable exponents, since such a power would be taken to require a
    positive base, even where its exponent is an integer."""
    links = (link for link in given.comparisons if not any(map(holds_powers, link[::2])))
    return Given(tuple(links))


def _sign(e: Expr, given: Given) -> str | None:
    """The sign of ``e`` by the cheap methods; what binds a variable counts as one."""
    e, *sides = generalised(e, *(side for link in given.comparisons for side in link[::2]))
    pairs = zip(given.comparisons, sides[::2], sides[1::2], strict=True)
    return sign(e, Given(tuple((x, link[1], y) for link, x, y in pairs)), dear=False)


def _of_claim(
    found: Answer, put: Mapping[str, Expr], claim: Comparison, statement: Statement
) -> Answer:
    """A refutation of a case, with its point in the variables of the claim, where it is checked."""
    point = {name: parse(text) for name, text in (found.witness or {}).items()}
    moved = {name: exact_text(substitute(e, point)) for name, e in put.items() if name in point}
    return confirmed(replace(found, witness=dict(found.witness or {}) | moved), claim, statement)


def _at_simple_exponents(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """A refutation where exponents have simple values, or None."""
    raised = _powers((claim.left, claim.right, *statement.said))
    names = sorted(frozenset().union(*(symbols(e) for _, e in raised)))
    points = islice(product(EXPONENTS, repeat=len(names)), MOST)
    at = (dict(zip(names, values, strict=True)) for values in points)
    return decided_at(at, claim, statement, decided)[0]


def _at_negative_bases(
    claim: Comparison, statement: Statement, doubtful: Mapping[Expr, str | None]
) -> Iterator[tuple[Comparison, Statement, dict[str, Expr]]]:
    """The claim where some bases are negative, so that their exponents are integers.

    The third item gives the variables that are replaced: the new ones are the exponents.
    """
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
        yield claim.mapped(change), inside.mapped(change), put


def _at_zero(
    claim: Comparison, statement: Statement, doubtful: Iterable[Expr]
) -> Iterator[tuple[Comparison, Statement, dict[str, Expr]]]:
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
            yield claim.mapped(change), replace(inside, given=inside.given & positive), {}


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
