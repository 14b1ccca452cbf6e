"""Powers whose exponents are variables: proofs speak of positive bases, and here of the others.

``x**a`` is ``exp(a log(x))``, and so a claim with it is decided where ``x`` is positive. But for a
number ``a`` the power may have a value elsewhere, as at ``a = 1``, and a claim that fails there
is false: ``x**a >= 0``, ``(x**2)**a == x**(2*a)``.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from itertools import islice, product
from typing import Any

from flint import fmpq

from tresym.reals.decisions.answer import Answer, refuted
from tresym.reals.decisions.reading import Comparison, Statement
from tresym.reals.decisions.simple import constants_hold
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    number,
    substitute,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.domain import needs
from tresym.reals.places.values import evaluate, stands
from tresym.reals.signs.sign import sign

EXPONENTS = (*map(fmpq, (1, 2, 3, -1)), fmpq(1, 2), *map(fmpq, (-2, 0)), fmpq(1, 3))
ELSEWHERE = (*map(fmpq, (-1, 0, 2, -2)), fmpq(-1, 2), *map(fmpq, (1, -4)), fmpq(1, 2))
MOST = 400


def beyond_positive_bases(answer: Answer, claim: Comparison, statement: Statement) -> Answer:
    """An answer that passes, which says where its powers are taken; or what refutes it elsewhere.

    Exponents that are integers by a condition have deciders of their own.
    """
    trees = (claim.left, claim.right, *statement.said)
    if statement.path is not None or not elementary(*trees):
        return answer
    doubtful = {
        base
        for base, exponent in _powers(trees)
        if symbols(exponent) - {*statement.integers}
        and sign(base, statement.given, dear=False) != "+"
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


def _against(claim: Comparison, statement: Statement, doubtful: set[Expr]) -> Iterator[Answer]:
    """Refutations at points where a base in doubt is not positive."""
    sides = (claim.left, claim.right, *statement.said)
    raised = {name for _, exponent in _powers(sides) for name in symbols(exponent)}
    names = sorted(set().union(*map(symbols, sides)), key=lambda name: (name in raised, name))
    tried = (EXPONENTS if name in raised else ELSEWHERE for name in names)
    for values in islice(product(*tried), MOST):
        point = dict(zip(names, values, strict=True))
        if any(point[name].q != 1 for name in statement.integers if name in point):
            continue
        try:
            sizes = _sides_at(claim, statement, doubtful, point)
        except (InputError, ZeroDivisionError):  # a power too long, or of 0
            continue
        if sizes is not None and stands(sizes[0] - sizes[1], NEGATED[claim.relation]):
            yield refuted("the powers have values there too, and it fails", point, *sizes)


def _sides_at(
    claim: Comparison, statement: Statement, doubtful: set[Expr], point: dict[str, fmpq]
) -> tuple[Any, Any] | None:
    """Both sides at a point of the conditions beyond positive bases, None at any other."""
    put_in = partial(substitute, mapping={name: number(value) for name, value in point.items()})
    if all(evaluate(put_in(base), {}) > 0 for base in doubtful):
        return None
    real = ((e, relation.replace(">=", ">"), ZERO) for e, relation in needs(claim.differentiated))
    equal = ((left, "==", right) for left, right in statement.equations)
    links = (*statement.given.comparisons, *real, *equal)
    if constants_hold((put_in(x), relation, put_in(y)) for x, relation, y in links) is None:
        return None
    left, right = evaluate(put_in(claim.left), {}), evaluate(put_in(claim.right), {})
    return (left, right) if (left - right).is_finite() else None
