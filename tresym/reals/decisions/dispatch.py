"""Dispatch: decide every comparison of a statement by the method for its kind."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import replace
from typing import Any

from tresym.reals.cross_check import STOPPED
from tresym.reals.decisions.answer import Answer, Decide, exact_text, refuted, worst
from tresym.reals.decisions.claim_cross_check import attack
from tresym.reals.decisions.claim_parsing import (
    Comparison,
    Statement,
    functions,
    implied_integers,
    read,
)
from tresym.reals.decisions.equalities import decide_equality
from tresym.reals.decisions.identity import JUMP
from tresym.reals.decisions.variable_exponents import beyond_positive_bases, holds_powers
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.language.binders import is_infinite, outermost
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.expression import DOTS, ZERO, Expr, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import collecting_seldom
from tresym.reals.signs.discontinuities import cases_at_jumps, jumps, zeros
from tresym.reals.verdict import Verdict

SELDOM = 20_000
"""New objects, a few megabytes of them, after which memory is searched for circles."""
LOOKED_AT = 40
"""Points of the conditions at which it is seen where a claim is defined."""
_LOOK_ALIKE = {
    "e": "not the number 2.718…, which is E",
    "Pi": "not the number pi",
    "PI": "not the number pi",
    "i": "not the imaginary unit; all variables are real",
    "j": "not the imaginary unit; all variables are real",
}


def decide_claim(claim: Any, given: Any = "", path: str | None = None) -> Answer:
    """Decide a claim, after reading it if necessary.

    Args:
        claim: text, LaTeX, a SymPy relation, or a :class:`Statement` that is read already.
        given: conditions, as for :func:`tresym.reals.decisions.claim_parsing.read`.
        path: the path of an order claim, such as ``"x -> 0+"``; None for other claims.

    Returns:
        The verdict with its reason. A chain has the weakest verdict of its comparisons.

    Raises:
        InputError: the claim cannot be read.
    """
    start = time.perf_counter()
    with collecting_seldom(SELDOM):
        statement = claim if isinstance(claim, Statement) else read(claim, given, path)
        answers = [_everywhere(comparison, statement) for comparison in statement.comparisons]
    answer = worst(answers)
    if len(answers) > 1:
        broken = statement.comparisons[answers.index(answer)]
        which = f"{broken.left} {broken.relation} {broken.right}: "
        answer = replace(answer, why=which + answer.why)
    if not answer:
        answer = replace(answer, why=answer.why + _mistaken(statement))
    elif answer.region is None and statement.path is None:
        answer = replace(answer, region=_part_spoken_of(statement))
    return replace(
        answer,
        statement=_short(statement.text),
        given=_short(statement.under),
        read_as=statement.read_as,
        seconds=time.perf_counter() - start,
    )


def _part_spoken_of(statement: Statement) -> str | None:
    """Return where both sides are defined, if that is not everywhere under the conditions."""
    sides = [side for c in statement.comparisons for side in (c.left, c.right)]
    given = statement.given
    if not given.comparisons or any(e.hidden for e in (*sides, *statement.said)):
        return None
    names = sorted(frozenset().union(*map(symbols, sides)))
    missing: list[tuple[Expr, str]] = []
    with ball_precision():
        points = list(given.points(names, LOOKED_AT))
        for e, relation in needs(sides):
            values = (evaluate(e, point) for point in points) if symbols(e) else ()
            if any(value < 0 if relation != "!=" else value.is_zero() for value in values):
                missing.append((e, relation))
    links = (bound(*part) for part in missing)
    shown = ", ".join(sorted(f"{left} {relation} {right}" for left, relation, right in links))
    return f"where both sides are defined: {shown}" if missing else None


def _everywhere(comparison: Comparison, statement: Statement) -> Answer:
    statement = _with_integers(comparison, statement)
    start = time.perf_counter()
    answer = _bounded(comparison, statement)
    if answer:
        answer = beyond_positive_bases(answer, comparison, statement, _bounded)
    if answer:
        from tresym.reals.decisions.definedness_check import unspoken

        missing = unspoken(comparison, statement)
        if missing is not None:
            why = f"{missing}, so there may be nothing to prove ({answer.why})"
            return Answer(Verdict.UNDECIDED, why)
    if answer and any(holds_powers(e) for e in (comparison.left, comparison.right)):
        spent = time.perf_counter() - start
        return _attacked(answer, comparison, statement, spent, anywhere=True)
    return answer


def _attacked(
    answer: Answer, comparison: Comparison, statement: Statement, spent: float, anywhere: bool
) -> Answer:
    """Return the answer, or UNDECIDED if the independent numerical check contradicts it."""
    against = attack(comparison, statement, answer, spent, anywhere)
    return answer if against is None else Answer(Verdict.UNDECIDED, STOPPED.format(against))


def _with_integers(comparison: Comparison, statement: Statement) -> Statement:
    """Return the statement with the variables that must be integers, such as ends of sums."""
    trees = (comparison.left, comparison.right, *statement.said)
    return replace(statement, integers=implied_integers(trees, statement.integers))


def _bounded(comparison: Comparison, statement: Statement) -> Answer:
    """Decide a comparison; UNDECIDED if an intermediate expression exceeds the size limit."""
    start = time.perf_counter()
    statement = _with_integers(comparison, statement)
    try:
        answer = _decide(comparison, statement)
    except InputError as error:
        return Answer(
            Verdict.UNDECIDED, (f"an intermediate expression exceeds the size limit: {error}")
        )
    if answer.verdict is Verdict.REFUTED and statement.path is not None:
        from tresym.reals.decisions.asymptotics.refutation_check import checked

        return checked(answer, comparison, statement)
    if answer.verdict is Verdict.REFUTED:
        from tresym.reals.decisions.point_check import confirmed

        return confirmed(answer, comparison, statement)
    if not answer:
        return answer
    spent = time.perf_counter() - start
    return _attacked(answer, comparison, statement, spent, anywhere=False)


def _decide(comparison: Comparison, statement: Statement) -> Answer:
    left, relation, right = comparison.left, comparison.relation, comparison.right
    hiding = {node.op for node in outermost(*comparison.differentiated)} - {"unknown"}
    if hiding == {"integral"}:
        from tresym.reals.decisions.leibniz import decide_by_leibniz

        return decide_by_leibniz(comparison, statement, _bounded)
    if hiding:
        return Answer(Verdict.UNDECIDED, "derivatives of sums and limits are not supported")
    procedure = _procedure_for(comparison, statement)
    if procedure is not None:
        return procedure(comparison, statement, _bounded)
    real = comparison.differentiated, comparison.by
    if left.op == "abs" and relation in ("<", "<=") and not symbols(right):
        halves = (replace(comparison, left=side * left.args[0]) for side in (1, -1))
        return worst([_decide(half, statement) for half in halves])
    if relation == "==":
        found = decide_equality(left, right, statement.given, *real)
        if found.witness is not None and found.values is not None:
            return refuted(found.why, found.witness, *found.values)
        return Answer(found.verdict, found.why)
    return _decide_inequality(left, relation, right, statement.given, *real)


Procedure = Callable[[Comparison, Statement, Decide], Answer]
"""Decides a claim by simpler ones, which it hands to its last argument."""


def _procedure_for(comparison: Comparison, statement: Statement) -> Procedure | None:
    """Return the procedure for claims with sums, integrals, paths and the like, or None."""
    sides = comparison.left, comparison.right
    nodes = {node.op for node in outermost(*sides)}
    unknown = {f.args[0].args[0] for e in (*sides, *statement.said) for f in functions(e)}
    if any(DOTS.args[0] in symbols(side) for side in sides):
        from tresym.reals.decisions.ellipsis_series import decide_dotted

        return decide_dotted
    if any(is_infinite(node) for node in outermost(*sides)):
        from tresym.reals.decisions.infinite_sums import decide_infinite

        return decide_infinite
    if "nth" in nodes:
        from tresym.reals.decisions.nth_derivatives import decide_repeated

        return decide_repeated
    finite = nodes <= {"sum", "product", "unknown"} and statement.path is None
    if nodes & {"sum", "product"} and (unknown <= {FACTORIAL} or finite):
        from tresym.reals.decisions.finite_sums import decide_totals

        return decide_totals
    if FACTORIAL in unknown:
        from tresym.reals.decisions.factorials import decide_factorials

        return decide_factorials
    if unknown and statement.integers and statement.path is None:
        from tresym.reals.decisions.integer_variables import decide_whole

        return decide_whole
    if unknown:
        from tresym.reals.decisions.unknown_functions import decide_unknown

        return decide_unknown
    if statement.equations:
        from tresym.reals.decisions.equations import among_integers, decide_under_equations

        if among_integers(statement):
            return decide_under_equations
    if statement.integers and statement.path is None:
        from tresym.reals.decisions.integer_variables import alternates, decide_whole

        if alternates(comparison, statement):
            return decide_whole
    if statement.equations:
        return decide_under_equations
    if "integral" in nodes and statement.path is not None:
        from tresym.reals.decisions.asymptotics.integral_limits import decide_integral_limits

        return decide_integral_limits
    if "integral" in nodes:
        from tresym.reals.decisions.integrals import decide_integrals

        return decide_integrals
    if statement.integers and statement.path is None:
        from tresym.reals.decisions.integer_variables import decide_whole

        return decide_whole
    if statement.path is not None:
        from tresym.reals.decisions.asymptotics.path_claims import decide_tending

        return decide_tending
    return None


def _decide_inequality(
    left: Expr,
    relation: str,
    right: Expr,
    given: Given,
    differentiated: tuple[Expr, ...],
    by: frozenset[str],
) -> Answer:
    """Decide an inequality, and separately at the points where sign and atan2 jump."""
    from tresym.reals.decisions.inequalities import decide_inequality

    nodes = jumps((left, right), given)
    apart = Given(tuple((u, "!=", ZERO) for node in nodes for u in zeros(node.args[0], given)))
    answer = decide_inequality(left, relation, right, given & apart, differentiated, by)
    answers = [replace(answer, region=str(given) or None) if nodes and answer.region else answer]
    for case in cases_at_jumps((left, right), given) if nodes else ():
        if case is None:
            answers.append(Answer(Verdict.UNDECIDED, JUMP))
            continue
        real = tuple(map(case.of, differentiated))
        found = _decide_inequality(case.of(left), relation, case.of(right), case.given, real, by)
        at = case.point(_exact(found.witness))
        if found.verdict is Verdict.REFUTED and at is None:
            found = replace(found, verdict=Verdict.UNDECIDED)
        shown = at and {name: exact_text(value) for name, value in at.items()}
        why = f"{case}: {found.why}"
        answers.append(replace(found, why=why, witness=shown, region=str(given) or None))
    return worst(answers)


def _exact(witness: Mapping[str, str] | None) -> dict[str, Expr] | None:
    """Return the witness as expressions, or None if it is not an exact point."""
    try:
        return None if witness is None else {name: parse(v) for name, v in witness.items()}
    except InputError:  # intervals between whose ends the sign changes
        return None


def _mistaken(statement: Statement) -> str:
    """Return a remark on variables such as e and i that may have been meant as constants."""
    names = frozenset().union(*(symbols(c.left) | symbols(c.right) for c in statement.comparisons))
    remarks = [
        f"; {name} is read as a variable, {other}"
        for name, other in _LOOK_ALIKE.items()
        if name in names
    ]
    return "".join(remarks)


def _short(text: str) -> str:
    """Return ``text`` on one line, abbreviated in the middle if it is very long."""
    line = " ".join(text.split())
    return line if len(line) <= 400 else f"{line[:200]} … {line[-100:]}"
