"""Equations as conditions: their consequences, and elimination of a variable case by case.

1. *Consequences.* A claimed equation, or its negation, may follow from the equations algebraically
   (ideals.py).
2. *Elimination.* An equation is split at the factors of its numerator and solved for a variable
   (equation_solutions.py). Each case consists of a value of the variable and the conditions under
   which it is a solution; together the cases cover all points of the equation. The claim is decided
   in every case after substitution. Cases that are proved to be empty are left out. If all are
   empty, there is nothing to prove and the answer is UNDECIDED.
3. *Without the equations.* What holds everywhere holds where they do, if they do anywhere. Newton's
   method shows a point of ``tanh(x*y) == cos(x) + exp(y)*sin(x + y)``, so that x² + 1 > 0 there.
   What fails without the equations may well hold under them.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from dataclasses import replace
from functools import partial
from typing import Any

from flint import arb

from tresym.reals.decisions.answer import Answer, Decide, exact_text, worst
from tresym.reals.decisions.equation_solutions import Case, solved
from tresym.reals.decisions.ideals import follows, numerator_factors
from tresym.reals.decisions.readable_witnesses import constants_hold, exact_witness
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.domain.newton import points_on
from tresym.reals.domain.operation_domains import bound, needs, operations
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    integer,
    substitute,
    symbols,
)
from tresym.reals.language.formula import NEGATED, Compared
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Cause, Verdict

NO_POINT = Answer(
    Verdict.UNDECIDED,
    "no point satisfies the conditions, so there is nothing to prove; check the conditions",
)
"""Where the conditions are shown to have no point."""


def decide_under_equations(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim at the points that satisfy the equations of the statement.

    Args:
        claim: the comparison to decide.
        statement: its conditions, equations among them.
        decided: the procedure for the claim under the remaining conditions.
    """
    statement = among_integers(statement) or statement
    for pair in statement.equations:
        answer = _without_variables(claim, statement, pair, decided)
        if answer is not None:
            return answer
    if is_contradictory(statement):
        return NO_POINT
    inside = _speaking(claim, statement)
    found = _as_consequence(claim, inside, decided) or _by_elimination(claim, inside, decided)
    if found.verdict is not Verdict.UNDECIDED or found == NO_POINT:
        return found
    return _without_equations(claim, statement, decided) or found


def decide_with_values(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim after putting in the value that an equation gives to a variable."""
    for pair in statement.equations:
        answer = _without_variables(claim, statement, pair, decided)
        if answer is not None:  # 1 == 2 is left of x == 1, x == 2
            return answer
    for pair in statement.equations:
        known = value_given(pair, statement)
        if known is not None:
            name, value = known
            case = Case(value, (), ())
            return _by_cases(claim, _without(statement, pair), name, [case], decided)
    return Answer(Verdict.UNDECIDED, "no condition has the form x == …")


def has_values(claim: Comparison, statement: Statement) -> bool:
    """Return whether an equation gives the value of a variable, or is about numbers alone.

    Derivatives are left alone: they are about the points around the value, too.
    """
    if statement.path is not None or claim.derivatives:
        return False
    return any(
        value_given(pair, statement) is not None or not symbols(pair[0]) | symbols(pair[1])
        for pair in statement.equations
    )


def value_given(pair: tuple[Expr, Expr], statement: Statement) -> tuple[str, Expr] | None:
    """The variable that an equation ``x == …`` gives the value of, and the value; or None."""
    for left, right in (pair, pair[::-1]):
        name = left.args[0] if left.op == "symbol" else None
        if name is None or name in symbols(right) or not elementary(right):
            continue
        if name not in statement.integers or is_whole(right, statement.integers):
            return name, right
    return None


def _without_equations(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """A proof that needs none of the equations, if a point is shown to satisfy them; or None."""
    sides = claim.left, claim.right
    if statement.path is not None or claim.derivatives or any(side.hidden for side in sides):
        return None
    at = point_of(statement, sides)
    if at is None:
        return None
    with ball_precision():
        left, right = (evaluate(side, at) for side in sides)
    if not (left.is_finite() and right.is_finite()) or stands(
        left - right, NEGATED[claim.relation]
    ):
        return None
    answer = decided(claim, replace(statement, equations=()))
    if not answer:
        return None
    near = ", ".join(f"{name} = {at[name].str(6, radius=False)}" for name in sorted(at))
    why = f"without the equations: {answer.why}; they are satisfied at a point near {near}"
    return replace(answer, why=why, region=None)


def point_of(statement: Statement, trees: Iterable[Expr] = ()) -> dict[str, arb] | None:
    """Return balls around a point that is shown to satisfy all conditions; None if none is.

    Args:
        statement: its conditions, equations among them.
        trees: expressions without hidden parts that have a value there, too.

    Example:
        >>> from tresym.reals.decisions.claim_parsing import read
        >>> sorted(point_of(read("x > 0", "x**5 - x == 3")))
        ['x']
        >>> point_of(read("x > 0", "x == 1, x == 2")) is None
        True
    """
    zero, _ = _known(statement)
    real = (*trees, *zero)
    if statement.integers or any(e.hidden for e in (*real, *statement.said)):
        return None
    names = sorted(frozenset().union(*map(symbols, trees)))
    given = statement.given & Given(tuple(bound(*part) for part in needs(real)))
    return next(points_on(zero, given, names), None)


def _without_variables(
    claim: Comparison, statement: Statement, pair: tuple[Expr, Expr], decided: Decide
) -> Answer | None:
    """Handle an equation that holds everywhere or nowhere; return None for other equations."""
    left, right = pair
    e = left - right
    if symbols(e) and not is_zero(e, Given()):
        return None
    with ball_precision():
        value = evaluate(e, {}) if not symbols(e) else None
    if value is not None and value != 0:
        return NO_POINT
    if is_zero(e, Given()) and undefined(e, statement.given) is None:
        others = tuple(other for other in statement.equations if other is not pair)
        return decided(claim, replace(statement, equations=others))
    if is_zero(e, Given()) and symbols(e):  # x/x == 1 says that x is not 0
        others = tuple(other for other in statement.equations if other is not pair)
        given = statement.given & Given(tuple(bound(*part) for part in needs((left, right))))
        return decided(claim, replace(statement, equations=others, given=given))
    return Answer(
        Verdict.UNDECIDED,
        f"no point was found that satisfies the condition {left} == {right}; check the conditions",
    )


def is_contradictory(statement: Statement) -> bool:
    """Return whether the ideal of the equations shows that they have no common solution."""
    return bool(statement.equations) and follows(ONE, *_known(statement), vanishes=True)


def _known(statement: Statement) -> tuple[list[Expr], list[Expr]]:
    """Return the expressions that are 0, and those that are not 0, under the conditions."""
    zero = [left - right for left, right in statement.equations]
    nonzero = [c.expression for c in statement.given.conditions if c.relation != ">="]
    return zero, nonzero


def _speaking(claim: Comparison, statement: Statement) -> Statement:
    """Return the statement with the condition that no denominator vanishes."""
    parts = (e for e, relation in needs((claim.left, claim.right)) if relation == "!=")
    links = tuple(bound(e, "!=") for e in parts if symbols(e) and not e.loose)
    if claim.relation != "==" or statement.path is not None:
        return statement
    return replace(
        statement, given=Given(tuple(dict.fromkeys((*statement.given.comparisons, *links))))
    )


# Consequences


def _as_consequence(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Return a proof of ``==`` or ``!=`` by the ideal of the equations, or None."""
    left, relation, right = claim.left, claim.relation, claim.right
    if relation not in ("==", "!=") or claim.derivatives or statement.path is not None:
        return None
    if not follows(left - right, *_known(statement), vanishes=relation == "=="):
        return None
    why = (
        "it follows algebraically from the equations: it lies in the "
        "radical of their ideal (Gröbner basis)"
    )
    return _with_a_point(Answer(Verdict.PROVED, why), claim, statement, decided)


def _with_a_point(
    answer: Answer, claim: Comparison, statement: Statement, decided: Decide
) -> Answer | None:
    """Return the proof if some point satisfies the conditions, and no point contradicts it."""
    sides = claim.left, claim.right
    if any(side.hidden for side in sides):
        return None
    at = point_of(statement, sides)
    if at is not None:
        with ball_precision():
            left, right = (evaluate(side, at) for side in sides)
        if left.is_finite() and right.is_finite():
            if not stands(left - right, NEGATED[claim.relation]):
                near = ", ".join(f"{name} = {at[name].str(6, radius=False)}" for name in sorted(at))
                return replace(
                    answer, why=f"{answer.why}; the equations are satisfied at a point near {near}"
                )
            return None
    both = add(*sides)
    same = _by_elimination(Comparison(both, "==", both), statement, decided)
    return (
        replace(answer, why=f"{answer.why}; a point satisfies the equations: {same.why}")
        if same
        else None
    )


# Elimination


def _by_elimination(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """The answer in all cases of one equation, the one that is solved with the least trouble."""
    ways_ = sorted(_ways(statement), key=lambda way: way[0])
    split = _split(claim, statement, decided) if not ways_ or len(ways_[0][3]) > 1 else None
    if split is not None:
        return split
    for _, pair, name, cases in ways_[:1]:
        return _by_cases(claim, _without(statement, pair), name, cases, decided)
    left, right = statement.equations[0]
    return Answer(
        Verdict.UNDECIDED,
        f"the condition {left} == {right} could not be solved for a "
        "variable: give it in the form x == …",
    )


def _split(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """The answer where each factor of the numerator of an equation is 0; None where it is one."""
    for pair in statement.equations:
        left, right = pair
        factors = numerator_factors(left - right)
        links = tuple(bound(*part) for part in needs((left, right)))
        if factors is None:
            continue
        same = len(factors) == 1 and not symbols(in_lowest_terms((left - right) / factors[0]))
        if same and len(needs((factors[0],))) >= len(links):
            continue  # the only case is this equation again, defined where it was
        zero = (f for f in factors if sign(f, statement.given, "!=") not in PROVING["!="])
        cases = [Case(None, (), ((factor, ZERO),)) for factor in zero]
        rest = _without(statement, pair)
        return _by_cases(claim, replace(rest, given=rest.given & Given(links)), "", cases, decided)
    return None


def _ways(statement: Statement) -> Iterator[tuple[Any, tuple[Expr, Expr], str, list[Case]]]:
    """Solutions of an equation for a variable, with the trouble that they make."""
    for k, pair in enumerate(statement.equations):
        e = pair[0] - pair[1]
        for (whole, *cost), name in _candidates(statement, e):
            cases = solved(e, name, statement)
            if name in statement.integers and cases is not None:
                cases = _whole(cases, statement.integers)
            if cases is not None:
                yield (whole, len(cases) > 1, _is_rooted(cases), k, *cost), pair, name, cases


def _without(statement: Statement, pair: tuple[Expr, Expr]) -> Statement:
    others = tuple(other for other in statement.equations if other is not pair)
    return replace(statement, equations=others)


def _is_rooted(cases: list[Case]) -> bool:
    """Whether the values hold more than sums, products and powers."""
    values = (case.value for case in cases if case.value is not None)
    return any(part.op not in ("+", "*", "^") for part in operations(values))


def among_integers(statement: Statement) -> Statement | None:
    """The statement, an equation between integers alone in front; None without such a one."""
    for pair in statement.equations:
        e = pair[0] - pair[1]
        if symbols(e) <= {*statement.integers} and is_whole(e, statement.integers):
            others = tuple(other for other in statement.equations if other is not pair)
            return replace(statement, equations=(pair, *others))
    return None


def _candidates(statement: Statement, e: Expr) -> Iterator[tuple[tuple[bool, int, str], str]]:
    """Variables to eliminate, each with how much hangs on it."""
    path = () if statement.path is None else (statement.path.name,)
    beyond = [c.expression for c in statement.given.conditions]
    for name in sorted(symbols(e) - {*path}):
        hangs = sum(name in symbols(c) for c in beyond)
        yield (name in statement.integers, hangs, name), name


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


def _by_cases(
    claim: Comparison, rest: Statement, name: str, cases: list[Case], decided: Decide
) -> Answer:
    answers = []
    for case in cases:
        known = {} if case.value is None else {name: case.value}
        try:
            sides, inside = _put_in(claim, rest, case, known)
        except InputError as error:
            return Answer(
                Verdict.UNDECIDED,
                f"an intermediate expression exceeds the size limit: {error}",
                cause=Cause.TOO_LARGE,
            )
        if is_empty(inside.given):
            continue
        answer = decided(sides, inside)
        if answer == NO_POINT:
            continue
        if answer.verdict is Verdict.REFUTED and known:
            answer = _with_value(answer, case, name)
        shown = f"{name} = {case.value}" if known else chained_zero(case)
        answers.append(replace(answer, why=f"with {shown}: {answer.why}", region=None))
    return worst(answers) if answers else NO_POINT


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
    return sides, replace(
        rest,
        given=Given(links) if given is None else given,
        equations=equations,
        integers=(*rest.integers, *case.integers),
    )


def is_empty(given: Given) -> bool:
    """Whether a condition is shown to fail wherever the others hold."""
    links = [link for link in given.comparisons if elementary(*link[::2])]
    for n, (left, relation, right) in enumerate(links):
        others = Given((*links[:n], *links[n + 1 :]))
        if symbols(left) | symbols(right):
            against = NEGATED[relation]
            wanted = {"==": "0"}.get(against)
            its_sign = sign(left - right, others, None if wanted else against, dear=False)
            negative = {"<": ("-",), "<=": ("-", "<=0", "0")}
            proving = (wanted,) if wanted else (PROVING | negative)[against]
            if its_sign in proving:
                return True
        else:
            with ball_precision():
                difference = evaluate(left - right, {})
            if difference.is_finite() and stands(difference, NEGATED[relation]):
                return True
    return False


def _with_value(answer: Answer, case: Case, name: str) -> Answer:
    """A refutation with the value of the variable that was eliminated."""
    point, value = exact_witness(answer), case.value or ZERO
    if point is None:
        return Answer(
            Verdict.UNDECIDED,
            f"the claim seems false ({answer.why}), but no exact counterexample was found",
        )
    for missing in symbols(value) - point.keys():
        point[missing] = ONE
    at = substitute(value, point)
    with ball_precision():
        if not evaluate(at, {}).is_finite():
            return Answer(
                Verdict.UNDECIDED,
                f"the claim seems false ({answer.why}), but {name} "
                "could not be shown to be real there",
            )
    point[name] = at
    shown = sorted(item for item in point.items() if item[0] not in case.integers)
    return replace(answer, witness={n: exact_text(v) for n, v in shown})
