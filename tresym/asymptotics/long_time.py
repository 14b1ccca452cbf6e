"""Decide claims about the solution of a differential equation as the time tends to infinity.

Example: ``y(t) -> pi as t -> oo given diff(y(t), t) == sin(y(t)), y(0) == 1``. If an explicit
solution is found, the claim is one about that. Otherwise one autonomous equation y' = f(y) is
followed along the line:

*To an equilibrium.* If f(c) = 0 and f has no other zero between y(0) and c, where it points to c,
then y tends to c monotonically. If f'(c) = a < 0, then y - c ~ K e^{at} with some K that is not 0;
if f(y) ~ b (y - c)ᵐ with m > 1, then \\|y - c\\| ~ (\\|b\\| (m - 1) t)^{-1/(m-1)}.

*To infinity.* If f > 0 beyond y(0) and f(y) -> k > 0 as y -> oo, then y ~ k t.

Source: S. H. Strogatz, *Nonlinear Dynamics and Chaos*, 2015, section 2.2; the rates follow from
separation of variables.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.differential_problem import OpenError, Problem
from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    PI,
    ZERO,
    Expr,
    apply,
    number,
    replaced,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Verdict

MONOTONE = "an autonomous equation on the line (Strogatz 2015, section 2.2)"
MOST_VANISHING = 6
"""The highest order of a zero of the right side."""
STEPS, FACTOR, HALVINGS = 120, arb("1.1"), 40
"""How a zero of the right side is searched for: steps of growing length, then halvings."""
DENOMINATORS = 12


class _Approach(NamedTuple):
    """How the solution tends to an equilibrium.

    Attributes:
        limit: the equilibrium.
        size: a function whose ratio with \\|y - limit\\| tends to a positive number.
        exact: whether that number is 1.
        side: the sign of y - limit.
    """

    limit: Expr
    size: Expr
    exact: bool
    side: int


def decide_autonomous(
    claim: Comparison, problem: Problem, statement: Statement, fixed: Given, decided: Decide
) -> Answer:
    """Decide a claim as t -> oo about the solution of one autonomous equation.

    Args:
        fixed: the conditions on parameters.

    Raises:
        OpenError: what is missing.
    """
    path = statement.path
    if path is None or len(problem.right) != 1:
        raise OpenError(
            "no explicit solution was found, which claims as t -> oo about systems need"
        )
    ((name, right),) = problem.right.items()
    if problem.time in symbols(right):
        raise OpenError(
            "no explicit solution was found, and the equation depends on the time itself"
        )
    gap = claim.left - claim.right if claim.relation == "->" else claim.left
    nodes = set(functions(gap))
    if len(nodes) != 1 or next(iter(nodes)).args[1] != symbol(problem.time):
        raise OpenError("the claim must be about the value of one function at the time")
    (node,) = nodes
    if any(node.args[0].args[1]):
        raise OpenError("no explicit solution was found, which claims about slopes need")
    plain = Statement((), fixed, None, "")
    for limit in _candidates(claim, problem):
        found = _approach(problem, name, right, limit, plain, decided)
        if found is not None:
            return _at_equilibrium(claim, node, found, plain, path, decided)
    grown = _growth(claim, problem, name, right, node, plain, decided)
    if grown is not None:
        return grown
    raise OpenError("no explicit solution and no equilibrium that it tends to were found")


def _candidates(claim: Comparison, problem: Problem) -> Iterator[Expr]:
    """Yield where the solution may tend: what the claim says, and the next zero of f."""
    ((name, right),) = problem.right.items()
    if claim.relation == "->":
        yield claim.right
    start = problem.values[name]
    if symbols(start) or symbols(right) != {name}:
        yield ZERO
        yield number(fmpq(1))
        return
    yield from _next_zero(start, name, right)


def _next_zero(start: Expr, name: str, right: Expr) -> list[Expr]:
    """Return exact numbers near the first zero of f that the solution moves towards."""
    found: list[Expr] = []
    with ball_precision(256):
        x = evaluate(start, {})
        value = evaluate(right, {name: x})
        if not value.is_finite() or value.contains(0):
            return found
        up = 1 if value > 0 else -1
        step = arb("0.03") * up
        for _ in range(STEPS):
            following = arb((x + step).mid())
            other = evaluate(right, {name: following})
            if not other.is_finite():
                return found
            if not other * up > 0:
                break
            x, step = following, step * FACTOR
        else:
            return found
        low, high = x, following
        for _ in range(HALVINGS * 4):
            middle = arb(((low + high) / 2).mid())
            if evaluate(right, {name: middle}) * up > 0:
                low = middle
            else:
                high = middle
        for unit in (number(fmpq(1)), PI, sqrt(number(2)), sqrt(number(3)), sqrt(number(5))):
            scale = evaluate(unit, {})
            for q in range(1, DENOMINATORS + 1):
                p = (high / scale * q + arb("0.5")).floor().unique_fmpz()
                if p is not None and abs(high / scale * q - int(p)) < arb("1e-9"):
                    found.append(number(fmpq(int(p), q)) * unit)
                    break
    return found


def _approach(
    problem: Problem, name: str, right: Expr, limit: Expr, plain: Statement, decided: Decide
) -> _Approach | None:
    """Return how the solution tends to an equilibrium, if it is shown to."""
    start, y = problem.values[name], symbol(name)
    at = {name: limit}
    if problem.time in symbols(limit) or not decided(
        Comparison(substitute(right, at), "==", ZERO), plain
    ):
        return None
    for side, beyond, towards in ((-1, ">", ">"), (1, "<", "<")):
        # from below (side -1): start < limit and f > 0 on [start, limit)
        if not decided(Comparison(limit, beyond, start), plain):
            continue
        if side < 0:
            ends = ((y, ">=", start), (y, "<", limit))
            closed = ((y, ">=", start), (y, "<=", limit))
        else:
            ends = ((y, "<=", start), (y, ">", limit))
            closed = ((y, "<=", start), (y, ">=", limit))
        whole = plain.given & Given(closed)
        slope = differentiate(right, name)
        if any(continuous_on(e, whole, proof) is not None for e in (right, slope)):
            return None
        inside = replace(plain, given=plain.given & Given(ends))
        if not decided(Comparison(right, towards, ZERO), inside):
            return None
        return _rate(problem, name, right, limit, side, plain, decided)
    return None


def _rate(
    problem: Problem,
    name: str,
    right: Expr,
    limit: Expr,
    side: int,
    plain: Statement,
    decided: Decide,
) -> _Approach | None:
    t, factorial, slope = symbol(problem.time), 1, right
    for m in range(1, MOST_VANISHING + 1):
        slope = differentiate(slope, name)
        factorial *= m
        value = tidied(substitute(slope, {name: limit}))
        if decided(Comparison(value, "==", ZERO), plain):
            continue
        if not decided(Comparison(value, "!=", ZERO), plain):
            return None
        value = normal_form(value, plain.given)
        if m == 1:
            return _Approach(limit, apply("exp", value * t), False, side)
        size = apply("abs", value) * number(fmpq(m - 1, factorial))
        if value.op == "number":
            size = number(abs(value.args[0]) * fmpq(m - 1, factorial))
        return _Approach(limit, (size * t) ** number(fmpq(-1, m - 1)), True, side)
    return None


def _at_equilibrium(
    claim: Comparison,
    node: Expr,
    found: _Approach,
    plain: Statement,
    path: Path,
    decided: Decide,
) -> Answer:
    """Decide a claim about a solution that tends to an equilibrium."""
    why = f"the solution tends to {found.limit} monotonically"
    moving = replace(plain, path=path)
    put = {node: found.limit}
    if claim.relation == "->":
        rest = replaced(claim.left, put)
        answer = decided(Comparison(rest, "->", claim.right), moving)
        return _said(answer, why)
    if claim.relation == "~" and claim.left == node:
        if not decided(Comparison(found.limit, "==", ZERO), plain):
            return _said(decided(Comparison(found.limit, "~", claim.right), moving), why)
        if found.exact:
            size = found.side * found.size
            why = f"{why}, and is asymptotically equal to {size}"
            return _said(decided(Comparison(size, "~", claim.right), moving), why)
        raise OpenError("the factor of the exponential function is not known without a solution")
    if claim.relation not in ("O", "o"):
        raise OpenError("no explicit solution of the differential equations was found")
    mark = symbol("[S]")
    e = replaced(claim.left, {node: mark})
    factor = tidied(differentiate(e, "[S]"))
    if factor.op != "number" or factor == ZERO:
        raise OpenError("the claim must be linear in the function of the differential equation")
    rest = normal_form(substitute(e, {"[S]": found.limit}), plain.given)
    why = f"{why}, at the rate of {found.size}"
    of_error = decided(Comparison(found.size, claim.relation, claim.right), moving)
    if rest == ZERO:
        return _said(of_error, why)
    of_rest = decided(Comparison(rest, claim.relation, claim.right), moving)
    if of_error and of_rest:
        return _said(of_rest, why)
    if of_error and of_rest.verdict is Verdict.REFUTED:
        return _said(of_rest, why)
    if of_rest and of_error.verdict is Verdict.REFUTED:
        return _said(of_error, why)
    raise OpenError(f"{why}, but the terms of the claim may cancel its error")


def _said(answer: Answer, why: str) -> Answer:
    if answer.verdict is Verdict.UNDECIDED:
        raise OpenError(f"{why}, but {answer.why}")
    return Answer(
        Verdict.PROVED if answer else answer.verdict,
        f"{why}: {answer.why}",
        witness=None if answer else answer.witness or {},
        lemma=MONOTONE,
    )


def _growth(
    claim: Comparison,
    problem: Problem,
    name: str,
    right: Expr,
    node: Expr,
    plain: Statement,
    decided: Decide,
) -> Answer | None:
    """Decide ``y(t) ~ k t`` where the solution grows without bound."""
    t, y = symbol(problem.time), symbol(name)
    ratio = normal_form(claim.right / t, Given())
    if claim.relation != "~" or claim.left != node or ratio.op != "number":
        return None
    above = plain.given & Given(((y, ">=", problem.values[name]),))
    if symbols(right) != {name} or continuous_on(right, above, proof) is not None:
        return None
    if not decided(Comparison(right, ">", ZERO), replace(plain, given=above)):
        return None
    with ball_precision():
        far = evaluate(right, {name: arb(10) ** 8})
    guesses = [ratio]
    if far.is_finite():
        guesses += [
            number(fmpq(int(p), q))
            for q in range(1, DENOMINATORS)
            for p in [(far * q + arb("0.5")).floor().unique_fmpz()]
            if p is not None and abs(far * q - int(p)) < arb("0.001")
        ]
    for limit in guesses:
        path = Path(name, None, (1,))
        tends = decided(Comparison(right, "->", limit), replace(plain, path=path))
        if not tends or not decided(Comparison(limit, ">", ZERO), plain):
            continue
        why = f"the solution grows without bound, and its slope tends to {limit}"
        if limit == ratio:
            return Answer(Verdict.PROVED, why, lemma=MONOTONE)
        return Answer(Verdict.REFUTED, f"{why}, not {ratio}", witness={}, lemma=MONOTONE)
    return None
