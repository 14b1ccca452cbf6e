"""Choose readable counterexamples with small numbers, and confirm them exactly."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import islice, product

from flint import fmpq

from tresym.reals.decisions.answer import Answer, Decide, exact_text
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import LEAVES, ZERO, Expr, rebuild, substitute, symbols
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import parse
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

SIMPLE = (*map(fmpq, (2, -1, 3, -2, 1, 5)), fmpq(1, 2), fmpq(-3, 2), fmpq(1, 3))
MOST_TRIED = 500


def simple_points(
    names: Sequence[str], given: Given, count: int, integers: Sequence[str] = ()
) -> list[dict[str, fmpq]]:
    """At most ``count`` points at which every condition is shown to hold, strictly.

    Args:
        integers: the names that have integer values.
    """
    points = []
    with ball_precision():
        for values in islice(product(SIMPLE, repeat=len(names)), MOST_TRIED):
            at = dict(zip(names, values, strict=True))
            if any(at[name].q != 1 for name in integers if name in at):
                continue
            if given.names <= at.keys() and all(c.holds(at) for c in given.conditions):
                points.append(at)
                if len(points) == count:
                    return points
    return points if points or integers else list(given.points(names, count))


def tidied(e: Expr) -> Expr:
    """``e`` without products with 0, where what is left out is defined everywhere."""
    if e.op in LEAVES or e.names:
        return e
    args = tuple(map(tidied, e.args))
    if e.op == "*" and ZERO in args and not needs(args):
        return ZERO
    return rebuild(e, args)


def exact_witness(answer: Answer) -> dict[str, Expr] | None:
    """The point at which a claim was refuted; None where that is no exact point."""
    try:
        return {name: parse(text) for name, text in (answer.witness or {}).items()}
    except InputError:  # intervals between whose ends a sign changes
        return None


def constants_hold(links: Iterable[Compared]) -> Given | None:
    """The conditions, less those between constants that hold; None where one may not."""
    kept = []
    for left, relation, right in links:
        if symbols(left) | symbols(right):
            kept.append((left, relation, right))
        elif not _holds(left, relation, right):
            return None
    return Given(tuple(kept))


def _holds(left: Expr, relation: str, right: Expr) -> bool:
    with ball_precision():
        difference = evaluate(left - right, {})
        if not difference.is_finite():
            return False
        if stands(difference, relation):
            return True
    return relation in (">=", "<=") and difference.contains(0) and equal_at(left, right, {})


def decided_at(
    points: Iterable[Mapping[str, Expr]], claim: Comparison, statement: Statement, decided: Decide
) -> tuple[Answer | None, bool]:
    """Decide a claim at values of some of its variables, one point after another.

    Points at which a condition fails, or may fail, are left out.

    Returns:
        The first refutation, with all of its point, or None; and whether a point had a proof.
    """
    proved = False
    for at in points:
        put_in = partial(substitute, mapping=at)
        try:
            fixed, there = claim.mapped(put_in), statement.mapped(put_in)
        except InputError:  # a number on the way is too long
            continue
        given = constants_hold(there.given.comparisons)
        if given is None:
            continue
        integers = tuple(name for name in statement.integers if name not in at)
        answer = decided(fixed, replace(there, given=given, integers=integers))
        if answer.verdict is Verdict.REFUTED:
            point = {name: exact_text(value) for name, value in at.items()}
            shown = ", ".join(f"{name} = {value}" for name, value in point.items())
            witness = point | dict(answer.witness or {})
            return replace(answer, why=f"at {shown}: {answer.why}", witness=witness), proved
        proved = proved or bool(answer)
    return None, proved
