"""Decide claims about the solution of a boundary value problem.

Example: ``y(x) == sinh(x)/sinh(1) given diff(y(x), x, 2) == y(x), y(0) == 0, y(1) == 1``. That the
function satisfies the equation and the boundary values is decided as for initial values; that no
other function does is shown in one of two ways:

*By the maximum principle.* For y'' = f(x, y, y') with values of y at both ends and ∂f/∂y >= 0 for
all y and y' (M. H. Protter and H. F. Weinberger, *Maximum Principles in Differential Equations*,
1984, section 1.1).

*By a fundamental system* of a linear equation: explicit solutions of the homogeneous equation whose
boundary values have a determinant that is not 0. Then there is exactly one solution, and it is put
into claims of any kind. y'' = -y with y(0) = y(pi) = 0 has many solutions; its determinant is
sin(pi).

*A small parameter.* If a linear problem is uniquely solvable where the parameter is 0 and analytic
there, an error of order eⁿ in the equation and the boundary values makes one of order eⁿ in the
solution, uniformly between the ends.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from functools import partial

from tresym.asymptotics.differential_problem import OpenError, Problem, Value, residuals
from tresym.asymptotics.explicit_claims import (
    curve_of_claim,
    exactly,
    first_term,
    need_smooth,
    nonzero_at,
    order_of,
    power_text,
    put_in,
)
from tresym.asymptotics.explicit_solutions import Curve, solutions
from tresym.reals.decisions.answer import Answer, Decide, exact_text
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

MAXIMUM = "maximum principle (Protter and Weinberger 1984, section 1.1)"
REGULAR = "regular dependence of a linear problem on a parameter (Hale 1980, theorem I.3.3)"
FUNDAMENTAL = "fundamental system of a linear boundary value problem"


def between(problem: Problem, domain: Given) -> tuple[Given, Given]:
    """Return the conditions without the variable, and those with it on its whole interval.

    That is the interval between the ends if the conditions keep the variable there, and the line if
    they say nothing of it.

    Raises:
        OpenError: the ends are not ordered, or the variable may lie beyond them.
    """
    x = symbol(problem.time)
    links = domain.comparisons
    own = [link for link in links if problem.time in symbols(link[0]) | symbols(link[2])]
    fixed = Given(tuple(link for link in links if link not in own))
    low, high = ends(problem, fixed)
    for left, relation, right in own:
        end = right if left == x else left
        if x not in (left, right) or problem.time in symbols(end) or relation == "!=":
            raise OpenError(f"the conditions must keep {x} in an interval")
        below = (relation[0] == "<") == (left == x)
        gap = high - end if below else end - low
        if sign(gap, fixed, ">=") not in PROVING[">="]:
            raise OpenError(f"the conditions must keep {x} between {low} and {high}")
    inside = ((x, ">=", low), (x, "<=", high))
    return fixed, fixed & Given(inside) if own else fixed


def ends(problem: Problem, fixed: Given) -> tuple[Expr, Expr]:
    """Return the boundary points in their order."""
    one, other = dict.fromkeys(value.point for value in problem.given)
    for low, high in ((one, other), (other, one)):
        if sign(high - low, fixed, ">") in PROVING[">"]:
            return low, high
    raise OpenError(f"it is not known which of {one} and {other} is larger")


def is_linear(problem: Problem) -> bool:
    """Whether the equations are linear in the functions."""
    return not any(
        symbols(tidied(differentiate(differentiate(f, n), m)))
        or tidied(differentiate(differentiate(f, n), m)) != ZERO
        for f in problem.right.values()
        for n in problem.right
        for m in problem.right
    )


def unique_by_sign(problem: Problem, closed: Given, decided: Decide) -> bool:
    """Whether the maximum principle shows that there is at most one solution.

    Args:
        closed: the conditions with the variable between the ends.
    """
    if len(problem.right) != 2 or len(problem.state) != 2:
        return False
    variables = [problem.state[key] for key in sorted(problem.state, key=lambda key: key[1])]
    if sorted(key[1] for key in problem.state) != [0, 1]:
        return False
    if any(value.variable != variables[0] for value in problem.given):
        return False
    top = problem.right[variables[1]]
    slopes = [differentiate(top, name) for name in variables]
    if any(continuous_on(e, closed, proof) is not None for e in (top, *slopes)):
        return False
    return bool(decided(Comparison(slopes[0], ">=", ZERO), Statement((), closed, None, "")))


def fundamental_system(
    problem: Problem, fixed: Given, closed: Given, decided: Decide
) -> list[Curve] | None:
    """Return solutions of the homogeneous equations with unit initial values, or None."""
    names = list(problem.right)
    nothing = dict.fromkeys(names, ZERO)
    homogeneous = {n: tidied(f - substitute(f, nothing)) for n, f in problem.right.items()}
    homogeneous = {n: normal_form(f, Given()) for n, f in homogeneous.items()}
    found: list[Curve] = []
    for name in names:
        given = tuple(Value(problem.start, n, ONE if n == name else ZERO) for n in names)
        unit = problem._replace(right=homogeneous, given=given)
        shown = _first_shown(unit, fixed, closed, decided)
        if shown is None:
            return None
        found.append(shown)
    return found


def _first_shown(problem: Problem, fixed: Given, closed: Given, decided: Decide) -> Curve | None:
    for curve in solutions(problem, fixed):
        try:
            if exactly(problem, curve, closed, decided):
                return curve
        except OpenError:
            continue
    return None


def determinant(problem: Problem, system: Sequence[Curve]) -> Expr:
    """Return the determinant of the boundary values of a fundamental system."""
    return _determinant(_matrix(problem, system))


def _matrix(problem: Problem, system: Sequence[Curve]) -> list[list[Expr]]:
    return [
        [substitute(curve[v.variable], {problem.time: v.point}) for curve in system]
        for v in problem.given
    ]


def _determinant(rows: Sequence[Sequence[Expr]]) -> Expr:
    if not rows:
        return ONE
    total: Expr = ZERO
    for j, x in enumerate(rows[0]):
        if x != ZERO:
            minor = [[*row[:j], *row[j + 1 :]] for row in rows[1:]]
            total = total + (x if j % 2 == 0 else -x) * _determinant(minor)
    return total


def solution(
    problem: Problem, system: Sequence[Curve], fixed: Given, closed: Given, decided: Decide
) -> Curve | None:
    """Return the explicit solution of a linear problem whose determinant is not 0, or None."""
    zero = tuple(Value(problem.start, n, ZERO) for n in problem.right)
    particular = _first_shown(problem._replace(given=zero), fixed, closed, decided)
    if particular is None:
        return None
    rows = _matrix(problem, system)
    whole = _determinant(rows)
    gaps = [
        v.value - substitute(particular[v.variable], {problem.time: v.point}) for v in problem.given
    ]
    factors = []
    for j in range(len(system)):
        column = [[*row[:j], gap, *row[j + 1 :]] for row, gap in zip(rows, gaps, strict=True)]
        factors.append(_determinant(column) / whole)
    found: Curve = {}
    for name in problem.right:
        e = particular[name]
        for factor, curve in zip(factors, system, strict=True):
            e = e + factor * curve[name]
        found[name] = tidied(e)
    return found


def check_candidate(
    problem: Problem, curve: Curve, fixed: Given, closed: Given, decided: Decide
) -> Answer:
    """Decide whether a curve satisfies the equations and the boundary values.

    Raises:
        OpenError: it is not shown.
    """
    plain = Statement((), fixed, None, "")
    for value in problem.given:
        there = substitute(curve[value.variable], {problem.time: value.point})
        found = decided(Comparison(there, "==", value.value), plain)
        if found.verdict is Verdict.REFUTED:
            witness = {**dict(found.witness or {}), problem.time: exact_text(value.point)}
            why = f"the boundary value at {value.point} is not {there}: {found.why}"
            return Answer(Verdict.REFUTED, why, witness=witness)
        if not found:
            raise OpenError(f"the boundary value {value.value} is not shown: {found.why}")
    need_smooth(problem, curve, closed)
    for residual in residuals(problem, curve):
        found = decided(Comparison(residual, "==", ZERO), replace(plain, given=closed))
        if found.verdict is Verdict.REFUTED:
            return Answer(
                Verdict.REFUTED, f"the differential equation is not satisfied: {found.why}"
            )
        if not found:
            raise OpenError(f"it is not shown that the equation is satisfied: {found.why}")
    return Answer(Verdict.PROVED, "it satisfies the differential equation and the boundary values")


def decide_boundary_values(
    claim: Comparison, problem: Problem, statement: Statement, decided: Decide
) -> Answer:
    """Decide a claim about the solution of a boundary value problem.

    Raises:
        OpenError: what is missing.
    """
    path = statement.path
    if path is not None:
        return _small_parameter(claim, problem, statement, decided)
    fixed, closed = between(problem, statement.given)
    low, high = ends(problem, fixed)
    x = symbol(problem.time)
    middle = fixed & Given(((x, ">=", low), (x, "<=", high)))
    linear = is_linear(problem)
    smooth = (*problem.right.values(), *_slopes(problem))
    if linear and any(continuous_on(e, closed, proof) is not None for e in smooth):
        raise OpenError("the coefficients of the equation are not shown to be smooth")
    by_sign = unique_by_sign(problem, middle, decided)
    system = fundamental_system(problem, fixed, closed, decided) if linear else None
    regular = False
    if system is not None:
        value = determinant(problem, system)
        plain = Statement((), fixed, None, "")
        regular = bool(decided(Comparison(value, "!=", ZERO), plain))
        if not regular and not by_sign and decided(Comparison(value, "==", ZERO), plain):
            raise OpenError(
                "the boundary values do not determine the solution: the homogeneous problem has "
                "solutions that are not 0"
            )
    if not (by_sign or regular):
        raise OpenError(
            "uniqueness is not shown: neither is the derivative of the right side by "
            "the function nowhere negative, nor was a fundamental system with a determinant that "
            "is not 0 found"
        )
    lemma = FUNDAMENTAL if regular else MAXIMUM
    reason: OpenError | None = None
    if claim.relation == "==":
        try:
            curve = curve_of_claim(claim, problem)
            found = check_candidate(problem, curve, fixed, closed, decided)
            if found:
                why = f"{found.why}, and the problem has only one solution"
                return Answer(Verdict.PROVED, why, lemma=lemma)
            if linear:  # uniqueness implies existence
                return replace(found, lemma=lemma)
            raise OpenError(f"{found.why}, but it is not known whether there is a solution")
        except OpenError as error:
            reason = error
    if regular and system is not None:
        explicit = solution(problem, system, fixed, closed, decided)
        if explicit is not None and check_candidate(problem, explicit, fixed, closed, decided):
            put, arguments = put_in(claim, problem, explicit)
            for argument in arguments:
                inside = argument == x or problem.time not in symbols(argument)
                if not inside or (argument != x and not _is_between(argument, low, high, fixed)):
                    raise OpenError(f"it is not shown that {argument} lies between the ends")
            answer = decided(put, Statement((), statement.given, None, ""))
            return replace(answer, lemma=lemma)
    raise reason or OpenError("no explicit solution of the boundary value problem was found")


def _is_between(e: Expr, low: Expr, high: Expr, fixed: Given) -> bool:
    return all(sign(gap, fixed, ">=") in PROVING[">="] for gap in (e - low, high - e))


def _slopes(problem: Problem) -> list[Expr]:
    return [tidied(differentiate(f, n)) for f in problem.right.values() for n in problem.right]


def _small_parameter(
    claim: Comparison, problem: Problem, statement: Statement, decided: Decide
) -> Answer:
    """Decide an order in a small parameter for a linear problem that is regular at 0."""
    path = statement.path
    if path is None or path.point != ZERO or claim.relation not in ("O", "o", "->"):
        raise OpenError(
            "claims about boundary value problems with a path are orders as a parameter tends to 0"
        )
    e = path.name
    fixed, closed = between(problem, statement.given)
    if e in fixed.names or any(e in symbols(value.point) for value in problem.given):
        raise OpenError("conditions on the small parameter are not supported")
    if not is_linear(problem):
        raise OpenError("orders are supported for linear boundary value problems")
    low, high = ends(problem, fixed)
    x = symbol(problem.time)
    middle = fixed & Given(((x, ">=", low), (x, "<=", high)))
    at_zero = partial(substitute, mapping={e: ZERO})
    flat = problem._replace(
        right={n: tidied(at_zero(f)) for n, f in problem.right.items()},
        given=tuple(v._replace(value=at_zero(v.value)) for v in problem.given),
    )
    gap = next(
        (
            g
            for f in (*problem.right.values(), *_slopes(problem))
            if (g := continuous_on(at_zero(f), closed, proof)) is not None
        ),
        None,
    )
    if gap is not None:
        raise OpenError(
            f"the problem is not regular at {e} = 0, where {gap} leaves its domain: boundary "
            "layers are not supported"
        )
    unique = unique_by_sign(flat, middle, decided)
    if not unique:
        system = fundamental_system(flat, fixed, closed, decided)
        plain = Statement((), fixed, None, "")
        if system is None or not decided(Comparison(determinant(flat, system), "!=", ZERO), plain):
            raise OpenError(f"it is not shown that there is just one solution at {e} = 0")
    curve = curve_of_claim(claim, problem)
    order = order_of(claim, e)
    terms = order if claim.relation == "O" else order + 1
    gaps = [
        (substitute(curve[v.variable], {problem.time: v.point}) - v.value, v.point)
        for v in problem.given
    ]
    for gap_, point in [*gaps, *((r, None) for r in residuals(problem, curve))]:
        found = first_term(gap_, e, terms, fixed if point is not None else closed)
        if found is None:
            continue
        k, coefficient = found
        at = nonzero_at(coefficient, fixed if point is not None else closed)
        if at is None:
            raise OpenError("a coefficient of the error is not shown to differ from 0")
        what = "residual of the equation" if point is None else f"error of the value at {point}"
        why = f"the {what} is ({coefficient})*{power_text(e, k)} to leading order"
        return Answer(Verdict.REFUTED, why, witness={}, lemma=REGULAR)
    why = (
        f"the boundary values agree and the residual of the equation is of order "
        f"{power_text(e, terms)}, uniformly between the ends; the problem at {e} = 0 has only one "
        "solution"
    )
    everywhere = closed is not fixed and not symbols_of_parameters(problem, curve, e)
    if statement.uniformly and not everywhere:
        raise OpenError("it holds for fixed values; restrict the variable to the interval")
    return Answer(Verdict.PROVED, why, lemma=REGULAR, uniform=True if everywhere else None)


def symbols_of_parameters(problem: Problem, curve: Curve, name: str) -> set[str]:
    """Return the parameters of a problem other than the small one."""
    trees = [*problem.right.values(), *curve.values(), *(v.value for v in problem.given)]
    found = set().union(*map(symbols, trees), *(symbols(v.point) for v in problem.given))
    return found - {name, problem.time, *problem.right}
