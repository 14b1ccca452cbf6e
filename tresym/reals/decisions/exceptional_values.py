"""Decide a claim also at the exceptional values that a proof leaves out.

A proof by a limit, a theorem, an induction or a quotient holds where the expressions in it behave
as they do in general. It says nothing where ``sign(u)`` or ``atan2(u, v)`` jumps, where a
coefficient that was divided by vanishes, and where a value that was put in for a series is
undefined. These are zeros of some expression u in the parameters. This module is the one place
where such a claim is decided a second time, at the zeros of u:

- if u vanishes only at one value of a parameter, that value is substituted;
- otherwise u = 0 becomes a condition, and ``sign(u)`` is 0.

Example: ``1/x + 1 - sign(a - 9)**2 -> 0 as x -> oo`` holds for a != 9, where the square of the sign
is 1. At a = 9 it is the claim ``1/x + 1 -> 0``, which is refuted, and so is the whole claim.

Limitations: the variable of a path, bound variables and expressions with integrals or sums in them
are no parameters. If the claim at the zeros of u is undecided, so is the whole claim.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from math import factorial

from tresym.reals.decisions.answer import Answer, Decide, exact_text, worst
from tresym.reals.decisions.equations import NO_POINT, is_empty
from tresym.reals.decisions.readable_witnesses import constants_hold, exact_witness
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs, operations
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    DOTS,
    LEAVES,
    MINUS_ONE,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    factors_in,
    integer,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.discontinuities import value_at_zero, zeros
from tresym.reals.signs.interior import PROVING, is_nonzero
from tresym.reals.signs.interior import jumps as jumps_of
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MOST_SIGNS = 3
"""The number of jumps of ``sign`` for which both signs of the argument are tried."""
FIRST_TERMS = 4
"""The number of terms of a series that may be left where its variable is 0."""
Procedure = Callable[[Comparison, Statement, Decide], Answer]


def decide_with_jumps(
    procedure: Procedure, claim: Comparison, statement: Statement, decided: Decide
) -> Answer:
    """Decide a claim by ``procedure`` away from the jumps of its parameters, and at each of them.

    Args:
        procedure: a decision method that may treat ``sign(u)**2`` as 1.
        claim: the comparison to decide.
        statement: its conditions.
        decided: the procedure for any claim.
    """
    nodes = _parameter_jumps(claim, statement)
    if not nodes:
        return procedure(claim, statement, decided)
    given, parts = statement.given, []
    for node in nodes:
        parts += [part for part in zeros(node.args[0], given) if part not in parts]
    apart = given & Given(tuple((part, "!=", ZERO) for part in parts))
    answer = procedure(claim, replace(statement, given=apart), decided)
    if answer.verdict is Verdict.UNDECIDED and 0 < len(nodes) <= MOST_SIGNS:
        answer = _for_each_sign(nodes, claim, replace(statement, given=apart), decided) or answer
    return (
        answer if _is_refuted(answer) else also_at_zeros(answer, parts, claim, statement, decided)
    )


def also_at_zeros(
    found: Answer,
    parts: Iterable[Expr],
    claim: Comparison,
    statement: Statement,
    decided: Decide,
    multiplied: Expr | None = None,
) -> Answer:
    """Return the weakest of an answer and of those where one of ``parts`` vanishes.

    Args:
        found: the answer where none of ``parts`` is zero.
        parts: expressions; what is proved to vanish nowhere is left out.
        claim: the comparison to decide.
        statement: its conditions.
        decided: the procedure for any claim.
        multiplied: a part of the claim whose coefficient is the only one of ``parts``; where that
            is 0, a proof may take any value for it.
    """
    answers = [found]
    for part in parts:
        if _is_refuted(answers[-1]):
            break
        there = list(_at_zeros(part, claim, statement, decided))
        if multiplied is not None and not worst([found, *there]):
            without = claim.mapped(partial(replaced, known={multiplied: ZERO}))
            again = list(_at_zeros(part, without, statement, decided))
            there = again if worst([found, *again]) else there
        answers += there
    weakest = worst(answers)
    if len(answers) > 1 and weakest:
        where = ", ".join(dict.fromkeys(answer.why.split(":")[0] for answer in answers[1:]))
        why = f"{found.why}; decided separately {where}"
        return replace(found, verdict=weakest.verdict, why=why, constant=None, region=None)
    return weakest


def refuted_at_jumps(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Return a refutation where ``sign`` or ``atan2`` jumps, at a root of an equation, or None."""
    for node in _parameter_jumps(claim, statement):
        for part in zeros(node.args[0], statement.given):
            if value_at_zero(part) is None:
                for answer in _under_equation(part, claim, statement, decided):
                    if _is_refuted(answer):
                        return answer
    return None


def also_at_holes(
    found: Answer,
    known: Mapping[Expr, Expr],
    claim: Comparison,
    statement: Statement,
    decided: Decide,
) -> Answer:
    """Return the weakest of an answer and of those where a value that was put in is undefined.

    Args:
        found: the answer with ``known`` put in.
        known: series, sums or integrals with their values.
        claim: the comparison to decide, with the series in it.
        statement: its conditions.
        decided: the procedure for any claim.
    """
    if not found:
        return found
    outside = (part for part in _needs_outside(claim) if symbols(part[0]))
    given = statement.given & Given(tuple(bound(*part) for part in outside))
    parts = []
    for e, relation in needs(known.values(), powers=False):
        if not symbols(e) or e.loose or symbols(e) & {INFINITY.args[0]}:
            continue
        if statement.path is not None and statement.path.name in symbols(e):
            factors = zeros(e, given) if relation == "!=" else ()
            parts += [part for part in factors if statement.path.name not in symbols(part)]
            continue
        weak = ">=" if relation == ">" else relation
        shown = sign(e, given, weak)
        if shown in PROVING[relation] or (relation == "!=" and is_nonzero(e, given)):
            continue
        if relation != "!=" and shown not in PROVING[">="]:
            why = f"the claim is undecided where {bound(e, relation)[0]} {relation} 0 fails"
            return Answer(Verdict.UNDECIDED, f"{why}; elsewhere, {found.why}")
        parts.append(e)
    return also_at_zeros(found, parts, claim, statement, decided)


def _is_refuted(found: Answer) -> bool:
    return found.verdict is Verdict.REFUTED


def _parameter_jumps(claim: Comparison, statement: Statement) -> list[Expr]:
    """Return the nodes ``sign(u)`` and ``atan2(u, v)`` in parameters that may jump."""
    path = statement.path
    trees = [claim.left, claim.right, *claim.differentiated, *statement.said]
    trees += [] if path is None or path.point is None else [path.point]
    moving = {INFINITY.args[0], DOTS.args[0], *(() if path is None else (path.name,))}
    nodes = (
        node
        for node in operations(trees)
        if node.op in ("sign", "atan2")
        and not (node.loose or node.hidden)
        and symbols(node.args[0])
        and symbols(node).isdisjoint(moving)
    )
    return sorted({node for node in nodes if jumps_of((node,), statement.given)}, key=str)


def _for_each_sign(
    nodes: list[Expr], claim: Comparison, statement: Statement, decided: Decide
) -> Answer | None:
    """Return the answer with ``sign(u)`` replaced by 1 and by −1; None if there is no ``sign``."""
    node = next((node for node in nodes if node.op == "sign"), None)
    if node is None:
        return None
    (u,), answers = node.args, []
    for relation, value in ((">", ONE), ("<", MINUS_ONE)):
        inside = replace(statement, given=statement.given & Given(((u, relation, ZERO),)))
        if is_empty(inside.given):
            continue
        change = partial(replaced, known={node: value})
        answers.append(decided(claim.mapped(change), inside.mapped(change)))
        if not answers[-1]:
            break
    return worst(answers) if answers else None


def _at_zeros(
    e: Expr, claim: Comparison, statement: Statement, decided: Decide
) -> Iterator[Answer]:
    """Yield the answers at the zeros of ``e``; nothing if it has none under the conditions."""
    if not symbols(e):
        return
    for part in zeros(e, statement.given):
        value = value_at_zero(part, _fixed(part, statement))
        if value is None:
            yield from _under_equation(part, claim, statement, decided)
            continue
        ((name, at),) = value.items()
        if name in statement.integers and at.op == "number" and integer(at) is None:
            continue
        change = partial(value_put_in, value=value)
        there = statement.mapped(change)
        integers = tuple(n for n in statement.integers if n != name)
        if is_empty(there.given) or not may_be_defined(claim.mapped(change)):
            continue
        kept = constants_hold(there.given.comparisons)
        given = there.given if kept is None else kept
        answer = decided(claim.mapped(change), replace(there, given=given, integers=integers))
        if answer == NO_POINT:
            continue
        yield with_substituted_witness(answer, f"{name} = {at}", value)


def _under_equation(
    part: Expr, claim: Comparison, statement: Statement, decided: Decide
) -> Iterator[Answer]:
    """Yield the answer under the condition ``part == 0``."""
    change = partial(_with_zero, part=part)
    there = statement.mapped(change)
    there = replace(there, equations=(*there.equations, (part, ZERO)))
    answer = decided(claim.mapped(change), there)
    if answer != NO_POINT:
        yield with_substituted_witness(answer, f"{part} = 0", {})


def with_substituted_witness(found: Answer, where: str, value: dict[str, Expr]) -> Answer:
    """Return the answer at exceptional values, with a witness that holds them."""
    found = replace(found, why=f"where {where}: {found.why}")
    if found.verdict is not Verdict.REFUTED or not value:
        return found
    point = exact_witness(found)
    ((name, at),) = value.items()
    missing = {} if point is None else dict.fromkeys(symbols(at) - point.keys(), ONE)
    if point is None:
        return replace(found, verdict=Verdict.UNDECIDED, witness=None, values=None)
    here = substitute(at, {**missing, **point})
    witness = {n: exact_text(v) for n, v in missing.items()} | dict(found.witness or {})
    return replace(found, witness=witness | {name: exact_text(here)})


def _fixed(e: Expr, statement: Statement) -> list[str]:
    """Return the names that no value may be substituted for."""
    path = statement.path
    linked = {n for pair in statement.equations for side in pair for n in symbols(side)}
    moving = [] if path is None else [path.name]
    return (
        moving
        + [n for n in statement.integers if n in symbols(e) and len(symbols(e)) > 1]
        + [n for n in linked if n in symbols(e) and len(symbols(e)) > 1]
    )


def value_put_in(e: Expr, value: dict[str, Expr]) -> Expr:
    """Return ``e`` with a value substituted, and the signs of numbers worked out."""
    return e if e in (INFINITY, -INFINITY) else with_signs(substitute(e, value))


def _with_zero(e: Expr, part: Expr) -> Expr:
    return with_signs(replaced(e, {part: ZERO, -part: ZERO}))


def with_signs(e: Expr) -> Expr:
    """Return ``e`` with sign, abs and atan2 of rational numbers worked out, and 0·c as 0.

    Only factors that are defined everywhere are dropped beside 0.
    """
    if e.op in LEAVES:
        return e
    args = tuple(map(with_signs, e.args))
    if e.op in ("sign", "abs") and args[0].op == "number":
        r = args[0].args[0]
        return number((r > 0) - (r < 0)) if e.op == "sign" else number(abs(r))
    if e.op == "atan2" and args[0] == ZERO and args[1].op == "number" and args[1] != ZERO:
        return ZERO if args[1].args[0] > 0 else PI
    if e.op == "sum":
        return _first_of_series(rebuild(e, args))
    if e.op == "*" and ZERO in args and not any(map(_may_fail, args)):
        return ZERO
    return rebuild(e, args)


def _first_of_series(e: Expr) -> Expr:
    """Return a sum of terms with a factor ``0**(k + c)`` as its first terms, with 0**0 = 1."""
    low = integer(e.args[1])
    if low is None or e.loose or e.args[2] != INFINITY:
        return e
    (k,), body = opened(e)
    raised = [n for n in operations((body,)) if n.op == "^" and n.args[0] == ZERO]
    if not raised or any(symbols(n) != {k} for n in raised):
        return e
    slope, start = differentiate(raised[0].args[1], k), substitute(raised[0].args[1], {k: ZERO})
    first, step = integer(start), integer(slope)
    if first is None or step is None or step <= 0 or first + step * low < 0:
        return e
    after = max(low, -(-(1 - first) // step))
    beyond = Given(((symbol(k), ">=", number(after)),))
    calls = {n: ONE for n in operations((body,)) if n.op == "unknown"}
    rest = replaced(body, calls)
    whole = all(n.args[0].args == (FACTORIAL, (0,)) and n.args[1] == symbol(k) for n in calls)
    fixed = all(sign(x, beyond, r) in PROVING[r] for x, r in needs((rest,), powers=False))
    factors = factors_in(body)
    if not (whole and fixed and low >= 0 and after - low <= FIRST_TERMS and raised[0] in factors):
        return e
    return add(ZERO, *(_at_index(body, k, n) for n in range(low, after)))


def _at_index(body: Expr, k: str, n: int) -> Expr:
    term = substitute(body, {k: number(n)})
    calls = {c: number(factorial(n)) for c in operations((term,)) if c.op == "unknown"}
    return replaced(term, calls)


def _may_fail(e: Expr) -> bool:
    """Return whether ``e`` may be undefined somewhere: it has a domain, or is a series."""
    if e.op == "nth":
        return e.loose > 0 or bool(needs((e,))) or any(n.op == "abs" for n in operations((e,)))
    return e.hidden or e.loose > 0 or DOTS.args[0] in symbols(e) or bool(needs((e,)))


def _needs_outside(claim: Comparison) -> list[tuple[Expr, str]]:
    """Return what must hold for both sides to be defined, apart from what is inside binders."""
    nodes = list(outermost(claim.left, claim.right))
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes) if not node.loose}
    hidden = frozenset(str(mark) for mark in marks.values())
    needed = needs((replaced(side, marks) for side in (claim.left, claim.right)), powers=False)
    return [part for part in needed if symbols(part[0]).isdisjoint(hidden) and not part[0].hidden]


def may_be_defined(claim: Comparison) -> bool:
    """Return whether no constant part of the elementary sides is shown to be undefined."""
    for e, relation in _needs_outside(claim):
        if symbols(e):
            continue
        with ball_precision():
            value = evaluate(e, {})
        if value.is_finite() and (value < 0 if relation != "!=" else False):
            return False
        if relation != ">=" and value.is_zero():
            return False
    return True
