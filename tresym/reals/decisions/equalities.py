"""Decide equalities that contain derivatives.

Derivatives are first taken as formal ones, which may be real where the functions themselves are
not, as 1/x is that of log x. What holds of them everywhere is proved of the functions; what does
not is looked at again, where the functions are real. Where no such point is found nothing is
refuted, and a proof says that it is one of formal derivatives.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import replace
from itertools import chain

from flint import arb, ctx, fmpq

from tresym.reals.decisions.answer import exactly
from tresym.reals.decisions.derivative_domains import real_nowhere, where_real
from tresym.reals.decisions.identity import Decision, decide, no_point, sampled_values
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.numbers.arithmetic import decided
from tresym.reals.verdict import Cause, Verdict

LOOKS = 10
REAL = "the differentiated functions are real"
NOWHERE = f"no point was found at which {REAL}"
FORMAL = "so the proof is about formal derivatives only"


def decide_equality(
    left: Expr,
    right: Expr,
    given: Given,
    differentiated: tuple[Expr, ...] = (),
    by: Iterable[str] = (),
) -> Decision:
    """Decide ``left = right`` wherever both sides and the differentiated functions are real.

    Args:
        differentiated: the functions whose derivatives occur in the claim.
        by: the variables of differentiation.
    """
    answer = decide(left, right, given)
    if not differentiated:
        return answer
    if answer.witness is not None and _is_real(differentiated, by, answer.witness):
        return answer
    parts = (left, right, *differentiated)
    names = sorted(frozenset().union(*map(symbols, parts)))
    if answer.at is not None:
        more = (point for point, _ in sampled_values(left, right, given, names, LOOKS))
        for point in chain((answer.at,), more):
            if _is_real(differentiated, by, point):
                return replace(answer, why=exactly(f"{answer.why}; {REAL}", point))
    proved = answer.verdict is Verdict.PROVED
    if real_nowhere(given, differentiated if proved else parts):
        why = f"{REAL} nowhere, {FORMAL}" if proved else f"{NOWHERE}, and none exists"
        verdict = Verdict.PROVED if proved else Verdict.UNDECIDED
        return Decision(verdict, f"{answer.why}; {why}", cause=Cause.NO_POINT)
    inside, whole = where_real(given, differentiated, by)
    real = next(sampled_values(left, right, inside, names, 1), None)
    if proved:
        where = exactly(f"; {REAL}", real[0]) if real else f"; {NOWHERE}, {FORMAL}"
        return replace(answer, why=answer.why + where)
    if real is None:
        why = f"{no_point(parts, given)}; {NOWHERE}"
        return Decision(Verdict.UNDECIDED, why, cause=Cause.NO_POINT)
    again = decide(left, right, whole, stated=given)
    if again.verdict is Verdict.UNDECIDED and answer.witness is not None:
        why = (
            f"{again.why}; {answer.why}, but the differentiated functions "
            "could not be shown to be real there"
        )
        return replace(again, why=why)
    return again


def _is_real(functions: Iterable[Expr], by: Iterable[str], point: Mapping[str, fmpq]) -> bool:
    """Whether balls show every function to be real at ``point`` and beside it."""

    def shown_real() -> bool | None:
        near = {name: arb(value) for name, value in point.items()}
        beside = arb(0, arb(2) ** (-ctx.prec // 2))
        near |= {name: near[name] + beside for name in by if name in near}
        real = (symbols(f) <= near.keys() and evaluate(f, near).is_finite() for f in functions)
        return all(real) or None

    return decided(shown_real) is True
