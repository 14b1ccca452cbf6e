"""Equations as conditions: a variable is eliminated exactly, in as many cases as it has values.

An equation is solved for a variable that it determines: one that it is linear or quadratic in, or
that stands in it once, under functions that can be undone. Each case has its value of the variable
and the conditions under which it is one, and together they are all points of the equation. The
claim, the other conditions and the other equations are decided in every case with the value put in;
cases that are shown to have no point are left out, and where all are, nothing is decided.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import Any, NamedTuple

from flint import fmpq

from tresym.reals.decisions.answer import Answer, Decide, exact_text, worst
from tresym.reals.decisions.claim_parsing import Comparison, Statement
from tresym.reals.decisions.readable_witnesses import constants_hold, exact_witness, tidied
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.expression import (
    HALF,
    ONE,
    PI,
    ZERO,
    Expr,
    add,
    apply,
    differentiate,
    integer,
    multiply,
    number,
    power,
    sqrt,
    substitute,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.language.parsing import Compared
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

_EMPTY = "no point satisfies the conditions, and nothing is proved vacuously"


_HALF_TURN = PI / 2
_INVERSES: dict[str, Any] = {
    "exp": ("log", (">", ZERO)),
    "log": ("exp",),
    "sinh": ("asinh",),
    "asinh": ("sinh",),
    "tanh": ("atanh", ("<", ONE), (">", -ONE)),
    "atanh": ("tanh",),
    "atan": ("tan", ("<", _HALF_TURN), (">", -_HALF_TURN)),
    "asin": ("sin", ("<=", _HALF_TURN), (">=", -_HALF_TURN)),
    "acos": ("cos", ("<=", PI), (">=", ZERO)),
}
"""What undoes a function, and the ends between which its values lie."""
_PERIODIC: dict[str, Any] = {
    "sin": ("asin", (-1, PI), (-_HALF_TURN, _HALF_TURN)),
    "cos": ("acos", (-1, ZERO), (ZERO, PI)),
    "tan": ("atan", (1, PI), (-_HALF_TURN, _HALF_TURN)),
}
"""The inverse on a range, the sign and the shift that make another value of it, and the range."""


class Case(NamedTuple):
    """A value of the variable, and the conditions and equations under which it is one."""

    value: Expr | None
    conditions: tuple[Compared, ...] = ()
    equations: tuple[tuple[Expr, Expr], ...] = ()


def decide_under_equations(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """The answer at the points that satisfy the first equation of the statement.

    Args:
        decided: decides the claim under what is left.
    """
    statement = among_integers(statement) or statement
    (left, right), *others = statement.equations
    rest = replace(statement, equations=tuple(others))
    e = left - right
    if not symbols(e) or is_zero(e, Given()):
        with ball_precision():
            value = evaluate(e, {}) if not symbols(e) else None
        if value is not None and value != 0:
            return Answer(Verdict.UNDECIDED, _EMPTY)
        if is_zero(e, Given()) and undefined(e, statement.given) is None:
            return decided(claim, rest)
        return Answer(Verdict.UNDECIDED, f"{left} == {right} is not shown to have a point")
    for name in _candidates(claim, statement, e):
        cases = _solved(e, name, statement.given)
        if name in statement.integers and cases is not None:
            cases = _whole(cases, statement.integers)
        if cases is not None:
            return _by_cases(claim, rest, name, cases, decided)
    for name in (n for n in _candidates(claim, statement, e) if n not in statement.integers):
        some = _undone(e, name, ZERO, statement.given, some=True)  # not all: they may refute
        found = _by_cases(claim, rest, name, some or [], decided)
        if found.verdict is Verdict.REFUTED:
            return found
    return Answer(
        Verdict.UNDECIDED,
        f"no variable of the condition {left} == {right} is eliminated: write it solved for one",
    )


def among_integers(statement: Statement) -> Statement | None:
    """The statement, an equation between integers alone in front; None without such a one."""
    for pair in statement.equations:
        e = pair[0] - pair[1]
        if symbols(e) <= {*statement.integers} and is_whole(e, statement.integers):
            others = tuple(other for other in statement.equations if other is not pair)
            return replace(statement, equations=(pair, *others))
    return None


def _candidates(claim: Comparison, statement: Statement, e: Expr) -> list[str]:
    """Variables to eliminate, those of which little hangs first."""
    path = () if statement.path is None else (statement.path.name,)
    names = symbols(e) - {*path}
    beyond = [c.expression for c in statement.given.conditions]

    def cost(name: str) -> tuple[bool, int, str]:
        return name in statement.integers, sum(name in symbols(c) for c in beyond), name

    return sorted(names, key=cost)


def _whole(cases: list[Case], integers: tuple[str, ...]) -> list[Case] | None:
    """The cases where every value is an integer where it is one at all; None if not shown."""
    kept = []
    for case in cases:
        value = case.value
        if value is None or not is_whole(value, integers):
            if value is None or value.op != "number":
                return None
            continue
        kept.append(case)
    return kept


def is_whole(e: Expr, integers: tuple[str, ...]) -> bool:
    """Whether it is an integer for all integers."""
    if e.op == "number":
        return integer(e) is not None
    if e.op == "symbol":
        return e.args[0] in integers
    if e.op == "^":
        return (integer(e.args[1]) or 0) > 0 and is_whole(e.args[0], integers)
    return e.op in ("+", "*") and all(is_whole(arg, integers) for arg in e.args)


# Solving


def _solved(e: Expr, name: str, given: Given) -> list[Case] | None:
    """All solutions of ``e = 0`` for the variable under the conditions; None if not found."""
    at = {name: ZERO}
    slope = differentiate(e, name)
    if _is_free(slope, name):
        return _linear(tidied(substitute(slope, at)), tidied(substitute(e, at)), given)
    bend = differentiate(slope, name)
    if _is_free(bend, name):
        a, b, c = (tidied(substitute(part, at)) for part in (HALF * bend, slope, e))
        if sign(a, given, "!=") not in PROVING["!="]:
            return None
        under = b**2 - 4 * a * c  # not negative where the values are real
        return [Case((-b + side * sqrt(under)) / (2 * a)) for side in (1, -1)]
    return _undone(e, name, ZERO, given)


def _is_free(e: Expr, name: str) -> bool:
    """Whether ``e`` is one expression in the other variables, defined wherever they are."""
    if name not in symbols(e):
        return True
    return not needs((e,)) and is_zero(e - substitute(e, {name: ZERO}), Given())


def _linear(p: Expr, q: Expr, given: Given) -> list[Case]:
    """All v with p v + q = 0."""
    if sign(p, given, "!=") in PROVING["!="]:
        return [Case(-q / p)]
    solved = Case(-q / p, ((p, "!=", ZERO),))
    if sign(q, given, "!=") in PROVING["!="]:
        return [solved]
    return [solved, Case(None, (), ((p, ZERO), (q, ZERO)))]


def _undone(
    e: Expr, name: str, value: Expr, given: Given, *, some: bool = False
) -> list[Case] | None:
    """All solutions of ``e = value`` where the variable stands in ``e`` once, or ``some``."""
    if e.op == "symbol":
        return [Case(value)] if e.args == (name,) else None
    inner = [arg for arg in e.args if isinstance(arg, Expr) and name in symbols(arg)]
    if len(inner) != 1:
        return None
    (arg,) = inner
    others = list(e.args)
    others.remove(arg)
    if e.op == "+":
        return _undone(arg, name, value - add(*others), given, some=some)
    if e.op == "*":
        factor = multiply(*others)
        if sign(factor, given, "!=") not in PROVING["!="]:
            return None
        return _undone(arg, name, value / factor, given, some=some)
    steps = list(_inverses(e, arg, value))
    if e.op in _PERIODIC:
        steps = _turned(e, arg, value, given, some)
    found = []
    for inverse, conditions in steps:
        cases = _undone(arg, name, inverse, given, some=some)
        if cases is None:
            return None
        found += [replaced_case(case, conditions) for case in cases]
    return found or None


def _turned(
    e: Expr, arg: Expr, v: Expr, given: Given, some: bool
) -> list[tuple[Expr, tuple[Compared, ...]]]:
    """The one value of ``arg`` in its range with ``e = v``, or some three; none if too many."""
    inverse, (turn, shift), (low, high) = _PERIODIC[e.op]
    first = apply(inverse, v)
    within = (sign(side, given, ">=") in PROVING[">="] for side in (arg - low, high - arg))
    if all(within):
        return [(first, ())]
    return [(u, ()) for u in (first, shift + turn * first, 2 * PI + first)] if some else []


def replaced_case(case: Case, conditions: tuple[Compared, ...]) -> Case:
    """The case with more conditions."""
    return case._replace(conditions=(*conditions, *case.conditions))


def _inverses(e: Expr, arg: Expr, v: Expr) -> Iterator[tuple[Expr, tuple[Compared, ...]]]:
    """The values of ``arg`` with ``e = v``, each with the conditions on v; none if too many."""
    if e.op == "^" and e.args[1].op == "number" and arg is e.args[0]:
        yield from _roots(e.args[1].args[0], v)
    elif e.op == "abs":
        yield v, ((v, ">=", ZERO),)
        yield -v, ((v, ">", ZERO),)
    elif e.op == "cbrt":
        yield v**3, ()
    elif e.op in _INVERSES:
        inverse, *bounds = _INVERSES[e.op]
        yield apply(inverse, v), tuple((v, relation, end) for relation, end in bounds)


def _roots(r: fmpq, v: Expr) -> Iterator[tuple[Expr, tuple[Compared, ...]]]:
    """All u with ``u**r = v``."""
    exponent = number(r)
    value = exponent.args[0]
    if value.q != 1:  # u ≥ 0, and v too
        yield power(v, 1 / exponent), ((v, ">=" if value > 0 else ">", ZERO),)
    elif value.p % 2 == 0:
        bound: tuple[Compared, ...] = ((v, ">=" if value > 0 else ">", ZERO),)
        yield power(v, 1 / exponent), bound
        yield -power(v, 1 / exponent), bound
    elif abs(value.p) == 3:
        root = apply("cbrt", v)
        yield (root, ()) if value > 0 else (1 / root, ((v, "!=", ZERO),))
    elif value == -1:
        yield 1 / v, ((v, "!=", ZERO),)


# Deciding


def _by_cases(
    claim: Comparison, rest: Statement, name: str, cases: list[Case], decided: Decide
) -> Answer:
    answers = []
    for case in cases:
        known = {} if case.value is None else {name: case.value}
        try:
            sides, inside = _put_in(claim, rest, case, known)
        except InputError as error:
            return Answer(Verdict.UNDECIDED, f"an expression on the way grew too large: {error}")
        if _is_empty(inside.given):
            continue
        found = decided(sides, inside)
        if found.verdict is Verdict.REFUTED and known:
            found = _with_value(found, claim, name, case.value or ZERO)
        shown = f"{name} = {case.value}" if known else chained_zero(case)
        answers.append(replace(found, why=f"with {shown}: {found.why}", region=None))
    if not answers:
        return Answer(Verdict.UNDECIDED, _EMPTY)
    return worst(answers)


def chained_zero(case: Case) -> str:
    """The equations of a case in words."""
    return ", ".join(f"{left} = {right}" for left, right in case.equations)


def _put_in(
    claim: Comparison, rest: Statement, case: Case, known: dict[str, Expr]
) -> tuple[Comparison, Statement]:
    """The claim and its conditions in a case; of what is differentiated, where it is real."""
    value: tuple[Compared, ...] = ()
    if case.value is not None:  # is a number, wherever it is put in
        value = tuple((e, relation, ZERO) for e, relation in needs((case.value,)))
    real = tuple(
        (e, relation.replace(">=", ">"), ZERO) for e, relation in needs(claim.differentiated)
    )
    put_in = partial(substitute, mapping=known)
    sides = Comparison(put_in(claim.left), claim.relation, put_in(claim.right))
    rest = replace(rest, given=rest.given & Given(real)).mapped(put_in)
    links = tuple(dict.fromkeys((*rest.given.comparisons, *case.conditions, *value)))
    given = constants_hold(links)
    equations = (*rest.equations, *case.equations)
    return sides, replace(rest, given=Given(links) if given is None else given, equations=equations)


def _is_empty(given: Given) -> bool:
    """Whether a condition is shown to fail wherever the others hold."""
    for n, (left, relation, right) in enumerate(given.comparisons):
        others = Given(given.comparisons[:n] + given.comparisons[n + 1 :])
        if symbols(left) | symbols(right):
            against = NEGATED[relation]
            wanted = {"==": "0"}.get(against)
            found = sign(left - right, others, None if wanted else against, dear=False)
            negative = {"<": ("-",), "<=": ("-", "<=0", "0")}
            proving = (wanted,) if wanted else (PROVING | negative)[against]
            if found in proving:
                return True
        else:
            with ball_precision():
                difference = evaluate(left - right, {})
            if difference.is_finite() and stands(difference, NEGATED[relation]):
                return True
    return False


def _with_value(answer: Answer, claim: Comparison, name: str, value: Expr) -> Answer:
    """A refutation with the value of the variable that was eliminated."""
    point = exact_witness(answer)
    if point is None:
        return Answer(Verdict.UNDECIDED, f"{answer.why}, at no exact point")
    for missing in symbols(value) - point.keys():
        point[missing] = ONE
    at = substitute(value, point)
    with ball_precision():
        if not evaluate(at, {}).is_finite():
            return Answer(Verdict.UNDECIDED, f"{answer.why}, where {name} is not shown to be real")
    point[name] = at
    return replace(answer, witness={n: exact_text(v) for n, v in sorted(point.items())})
