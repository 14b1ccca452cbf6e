"""Factorials: cancel those whose arguments differ by an integer.

n! is defined for integers n ≥ 0 only. Among factorials whose arguments differ by integers, the
smallest is replaced by an arbitrary number F ≥ 1, and (n + 2)! becomes F (n + 1)(n + 2). A claim
that holds for all F ≥ 1 is proved; the converse fails, so such a failure is UNDECIDED. False claims
are refuted at small integers.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import chain, islice, product
from math import factorial

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.binomial_bounds import decide_by_bounds
from tresym.reals.decisions.gamma_forms import decide_as_reals
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.readable_witnesses import decided_at
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    fresh,
    integer,
    multiply,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.verdict import Verdict

MOST, FAR, LOOKED_AT = 600, 50, 6
_LARGE = ((12, 4), (20, 3), (20, 10), (40, 20), (60, 6), (100, 10), (100, 50), (200, 20))
"""Points that are looked at, how far apart factorials may be, and integers at which they are."""


def decide_factorials(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with factorials.

    Args:
        decided: the procedure for claims without factorials.
    """
    folded = {
        node: _value(node.args[1]) or node
        for node in outermost(claim.left, claim.right)
        if node.op == "unknown" and node.args[0].args == (FACTORIAL, (0,))
    }
    sides = replaced(claim.left, folded), replaced(claim.right, folded)
    claim = replace(claim, left=sides[0], right=sides[1])
    nodes = dict.fromkeys(outermost(*sides))
    if not nodes:
        return decided(claim, statement)
    if (
        any(node.op != "unknown" or node.args[0].args != (FACTORIAL, (0,)) for node in nodes)
        or any(
            next(functions(e), None) for e in (*statement.said, *(node.args[1] for node in nodes))
        )
        or statement.path is not None
        or claim.derivatives
    ):
        why = (
            "factorials are not supported together with sums, derivatives, limits or in conditions"
        )
        return Answer(Verdict.UNDECIDED, why)
    names = sorted({name for node in nodes for name in symbols(node)})
    points = islice(_small(names), MOST)
    near = (
        at for at in points if None not in (_value(substitute(node.args[1], at)) for node in nodes)
    )
    answer, proved = decided_at(chain(near, _far(names)), claim, statement, decided)
    if answer is not None:
        return answer
    if not proved:
        return Answer(Verdict.UNDECIDED, "the claim could not be proved at any small integers")
    alone = len(nodes) == 1 and any(map(_is_transcendental, sides))  # nothing would cancel
    as_reals = decide_as_reals(claim, statement, decided) if alone else None
    if as_reals is not None:
        return as_reals
    known, positive = _by_least(list(nodes), statement.given)
    left, right = (replaced(side, known) for side in sides)
    given = statement.given & Given(tuple(positive))
    answer = decided(Comparison(left, claim.relation, right), replace(statement, given=given))
    if not answer and not alone:
        as_reals = decide_as_reals(claim, statement, decided)
        if as_reals is not None:
            return as_reals
        by_bounds = decide_by_bounds(claim, statement, decided)
        if by_bounds is not None:
            return by_bounds
    if answer.verdict is Verdict.REFUTED:
        meant = ", ".join(f"{node} = {value}" for node, value in known.items())
        return Answer(
            Verdict.UNDECIDED,
            "no counterexample was found at small integers, but the claim fails when factorials "
            f"are replaced by arbitrary numbers >= 1 (with {meant}: {answer.why})",
        )
    return answer


def _is_transcendental(e: Expr) -> bool:
    """Return whether a side has a power with a variable exponent or a function, as Stirling's."""
    plain = replaced(e, dict.fromkeys(outermost(e), ONE))
    return any(
        node.op not in ("+", "*", "^") or symbols(node.args[1] if node.op == "^" else ONE)
        for node in operations((plain,))
    )


def _small(names: list[str]) -> Iterator[dict[str, Expr]]:
    values = sorted(product(range(LOOKED_AT), repeat=len(names)), key=sum)
    return (dict(zip(names, map(number, point), strict=True)) for point in values)


def _far(names: list[str]) -> Iterator[dict[str, Expr]]:
    """Yield larger values of two variables, such as those of a binomial, in either order."""
    if len(names) == 2:
        for n, k in _LARGE:
            yield dict(zip(names, (number(n), number(k)), strict=True))
            yield dict(zip(names, (number(k), number(n)), strict=True))


def _value(e: Expr) -> Expr | None:
    """Return the factorial of an integer ≥ 0 as an expression, else None."""
    n = integer(e)
    return None if n is None or n < 0 else number(factorial(n))


def _by_least(
    nodes: list[Expr], given: Given
) -> tuple[dict[Expr, Expr], list[tuple[Expr, str, Expr]]]:
    """Express each factorial by the smallest one whose argument differs by an integer."""
    classes: dict[Expr, dict[Expr, int]] = {}
    for node in nodes:
        gaps = ((first, _apart(node.args[1], first)) for first in classes)
        new = node.args[1], 0
        first, apart = next(((e, gap) for e, gap in gaps if gap is not None), new)
        classes.setdefault(first, {})[node] = apart
    known: dict[Expr, Expr] = {}
    positive: list[tuple[Expr, str, Expr]] = []
    taken = {*given.names, *(name for node in nodes for name in symbols(node))}
    for others in classes.values():
        least = min(others.values())
        base = next(node.args[1] for node, apart in others.items() if apart == least)
        name = fresh("F", taken)
        taken.add(name)
        positive += [(symbol(name), ">=", ONE), (base, ">=", ZERO)]
        for node, apart in others.items():
            factors = (base + number(n) for n in range(1, apart - least + 1))
            known[node] = multiply(symbol(name), *factors)
    return known, positive


def _apart(one: Expr, other: Expr) -> int | None:
    """Return the difference of two arguments if it is an integer, else None."""
    gap = one - other
    apart = integer(substitute(gap, dict.fromkeys(symbols(gap), ZERO)))
    if apart is None or abs(apart) > FAR:
        return None
    return apart if decide(gap, number(apart)).verdict is Verdict.PROVED else None
