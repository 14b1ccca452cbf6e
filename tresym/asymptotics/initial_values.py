"""Decide claims about the solution of an initial value problem.

Examples: ``y(t) == 3*exp(-2*t) given diff(y(t), t) == -2*y(t), y(0) == 3`` and, with a small
parameter, ``y(t) == exp(-t) + e*(exp(-t) - exp(-2*t)) + O(e**2) given diff(y(t), t) == -y(t) +
e*y(t)**2, y(0) == 1, t >= 0 as e -> 0``. Equations of higher order and systems become u' =
f(t, u, e); A is an explicit function for u, from the claim or found
(:mod:`tresym.asymptotics.explicit_solutions`).

*Exact solutions.* A satisfies every equation and every initial value, and f is analytic near (t,
A(t)) for all t. Then A is the only solution there (Picard and Lindelöf), and a claim about the
solution, such as ``y(1) < 3``, is one about A. If the equation fails, or an initial value, the
claim that A is the solution is false, since the solution exists near the initial point.

*A small parameter, t fixed.* If f is analytic near the curve (t, A(t), 0) and the residual A' −
f(t, A, e) and the error of the initial value are O(eⁿ), then u − A = O(eⁿ), uniformly on every
bounded interval of t. That is shown exactly: the Taylor coefficients of the residual in e vanish
identically below eⁿ. If one does not, u − A is of that lower order for some t.

*Uniformly in t.* The logarithmic norm (:mod:`tresym.asymptotics.logarithmic_norm`) bounds the error
for all t. The next coefficient v of the solution makes the constant sharp: it is at least the
supremum of its size. If v is unbounded, such as the secular term t*sin(t), no constant serves for
all t >= 0.

*Near a point.* A claim as t tends to a number, such as ``y(t) == 1 + t + O(t**2)`` as t -> 0, is
one about A, which must be the solution from the initial point to beyond that number, on both sides.

*Inequalities.* If A' >= f(t, A) for t after the initial point and A is above the solution there, it
stays above (comparison theorem).

Source: J. K. Hale, *Ordinary Differential Equations*, 1980, sections I.3 and I.6.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from flint import arb, fmpq

from tresym.asymptotics.attracting_curves import decide_attracted
from tresym.asymptotics.boundary_values import decide_boundary_values
from tresym.asymptotics.constants import rounded
from tresym.asymptotics.differential_problem import (
    OpenError,
    Problem,
    domain_of,
    need_no_layer,
    problem_of,
    residuals,
    symbols_of,
    with_initial_point,
)
from tresym.asymptotics.explicit_claims import (
    EXACT,
    curve_of_claim,
    exactly,
    first_term,
    need_smooth,
    nonzero_at,
    order_of,
    power_text,
    put_in,
    without_time,
)
from tresym.asymptotics.explicit_solutions import Curve, expansion, next_term, solutions
from tresym.asymptotics.exponential_polynomials import expression, is_bounded, polynomial
from tresym.asymptotics.layers import decide_layers
from tresym.asymptotics.logarithmic_norm import Range, error_bound, exact, supremum
from tresym.asymptotics.long_time import decide_autonomous
from tresym.asymptotics.order_claims import region
from tresym.asymptotics.slow_times import decide_slow_times
from tresym.reals.decisions.answer import Answer, Decide, constant_ball, exact_text
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    fresh,
    is_polynomial,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, parse_number
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

REGULAR = "regular dependence on a parameter (Hale 1980, theorem I.3.3)"
GRONWALL = "residual and logarithmic norm (Gronwall, Dahlquist; Hairer et al. 1993, theorem I.10.6)"
INTEGRAL = "derivative along the solutions (first integrals, Lyapunov functions; Hale 1980, X.1)"
COMPARISON = "comparison of solutions (Hale 1980, theorem I.6.1)"
RANGES = (fmpq(1, 2), fmpq(1, 5), fmpq(1, 20), fmpq(1, 100), fmpq(1, 400))
NEARBY = fmpq(1, 8)
"""An explicit solution is shown this far around the point to which the time tends."""
SHARP = arb("1.08")
"""The constant is at most this times the supremum, if a range of the parameter allows that."""


def decide_initial_values(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about functions that differential equations and their values determine.

    Args:
        claim: the comparison.
        statement: its conditions.
        decided: the procedure for claims about explicit functions.
    """
    try:
        return _decide(claim, statement, decided)
    except OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))


def _decide(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    path = statement.path
    if claim.derivatives or statement.integers:
        raise OpenError(
            "a claim about the solution of a differential equation is about its values and slopes, "
            "without integer conditions"
        )
    if path is not None and path.point in (None, ZERO):
        found = decide_slow_times(claim, statement)
        if found is None:
            found = decide_layers(claim, statement, decided)
        if found is not None:
            return found
    try:
        return _regularly(claim, statement, path, decided)
    except OpenError:
        found = _by_layered_solution(claim, statement, path, decided)
        if found is None:
            raise
        return found


def _by_layered_solution(
    claim: Comparison, statement: Statement, path: Path | None, decided: Decide
) -> Answer | None:
    """Decide by an explicit solution for e > 0 of a problem that has a layer as e -> 0+."""
    if path is None or path.point != ZERO or path.sides != (1,):
        return None
    small = symbol(path.name)
    positive = Given(((small, ">", ZERO),))
    problem = problem_of(replace(statement, given=statement.given & positive))
    if not problem.is_initial or path.name == problem.time:
        return None
    try:
        need_no_layer(problem.right.values(), problem.time, path)
    except OpenError:
        domain = domain_of(problem, statement) & positive
        for curve in solutions(problem, without_time(domain, problem)):
            try:
                return by_solution(claim, problem, curve, statement, domain, decided)
            except OpenError:
                continue
    return None


def _regularly(
    claim: Comparison, statement: Statement, path: Path | None, decided: Decide
) -> Answer:
    problem = problem_of(statement)
    if any(jumps(e) for e in (*problem.right.values(), claim.left, claim.right)):
        raise OpenError("functions with jumps are not supported in differential equations")
    if not problem.is_initial:
        return decide_boundary_values(claim, problem, statement, decided)
    if path is not None and path.name == problem.time:
        return _long_time(claim, problem, statement, path, decided)
    domain = domain_of(problem, statement)
    if path is None:
        return _at_points(claim, problem, statement, domain, decided)
    return _small_parameter(claim, problem, statement, domain, path, decided)


# What a claim gives for the solution


def _segment(domain: Given, problem: Problem, argument: Expr) -> Given:
    """Return the conditions with the time between the initial point and an argument."""
    t, fixed = symbol(problem.time), without_time(domain, problem)
    if argument == t:
        return domain
    if problem.time in symbols(argument):
        return fixed
    for ends in ((problem.start, argument), (argument, problem.start)):
        if sign(ends[1] - ends[0], fixed, ">=") in PROVING[">="]:
            return fixed & Given(((t, ">=", ends[0]), (t, "<=", ends[1])))
    raise OpenError(f"it is not known on which side of {problem.start} the point {argument} lies")


# Claims at points


def _at_points(
    claim: Comparison, problem: Problem, statement: Statement, domain: Given, decided: Decide
) -> Answer:
    reason = None
    if claim.relation == "==":
        try:
            return exactly(problem, curve_of_claim(claim, problem), domain, decided)
        except OpenError as error:
            reason = error
    found_ = _compared(claim, problem, domain, decided)
    if found_ is not None:
        return found_
    found_ = _along_solutions(claim, problem, domain, decided)
    if found_ is not None:
        return found_
    try:
        for curve in solutions(problem, without_time(domain, problem)):
            found = by_solution(claim, problem, curve, statement, domain, decided)
            if found.verdict is not Verdict.UNDECIDED:
                return found
            reason = reason or OpenError(found.why)
    except OpenError as error:
        reason = reason or error
    raise reason or OpenError("no explicit solution of the differential equations was found")


def by_solution(
    claim: Comparison,
    problem: Problem,
    curve: Curve,
    statement: Statement,
    domain: Given,
    decided: Decide,
) -> Answer:
    """Decide a claim by an explicit solution, after it is shown to be one.

    Raises:
        OpenError: it is not shown.
    """
    explicit, arguments = put_in(claim, problem, curve)
    for argument in arguments:
        shown = exactly(problem, curve, _segment(domain, problem, argument), decided)
        if not shown:
            raise OpenError("the explicit function that was found is no solution")
    plain = Statement((), domain, statement.path, "", uniformly=statement.uniformly)
    found = decided(explicit, plain)
    name, _ = next(key for key in problem.state if key[1] == 0)
    shown_as = f"{name}({problem.time}) = {curve[problem.state[name, 0]]}"
    return replace(found, why=f"the solution is {shown_as}: {found.why}", lemma=EXACT)


def _compared(claim: Comparison, problem: Problem, domain: Given, decided: Decide) -> Answer | None:
    """Prove an inequality for the solution of one equation by the comparison theorem.

    The difference d of the solution and the bound A satisfies a linear differential inequality as
    long as the equation is smooth near A, so that its sign at the initial point is kept.
    """
    if len(problem.right) != 1 or claim.relation not in ("<", "<=", ">", ">="):
        return None
    ((name, right),) = problem.right.items()
    try:
        bound = curve_of_claim(replace(claim, relation="=="), problem)
    except OpenError:
        return None
    closed, along = with_initial_point(domain, problem), substitute(right, bound)
    after = _is_later(domain, problem)
    steep = substitute(differentiate(right, name), bound)
    if not after or any(continuous_on(e, closed, proof) for e in (bound[name], along, steep)):
        return None
    gap = claim.left - claim.right
    (node,) = set(functions(gap))
    factor = tidied(differentiate(replaced(gap, {node: symbol("[S]")}), "[S]"))
    below = (claim.relation[0] == "<") == bool(evaluate(factor, {}) > 0)
    relation = "<" if below else ">"
    start = substitute(bound[name], {problem.time: problem.start})
    strict = claim.relation in ("<", ">")
    begin = Comparison(problem.values[name], relation if strict else f"{relation}=", start)
    slope = differentiate(bound[name], problem.time)
    rising = Comparison(along, f"{relation}=", slope)
    plain = Statement((), domain, None, "")
    if not decided(begin, replace(plain, given=without_time(domain, problem))) or not decided(
        rising, plain
    ):
        return None
    where = "above" if below else "below"
    why = (
        f"{bound[name]} is {where} the solution at the initial point and stays there, since "
        f"{rising.left} {rising.relation} {rising.right}"
    )
    return Answer(Verdict.PROVED, why, lemma=COMPARISON)


def _along_solutions(
    claim: Comparison, problem: Problem, domain: Given, decided: Decide
) -> Answer | None:
    """Prove a relation by its derivative along all solutions, as for the energy of a pendulum.

    With G for left minus right, G = 0 at the initial point and G' = 0 for all values of the
    variables shows an equation, and G >= 0 there and G' >= 0 an inequality at later times.
    """
    if claim.relation not in ("==", "<", "<=", ">", ">="):
        return None
    t = symbol(problem.time)
    known: dict[Expr, Expr] = {}
    for side in (claim.left, claim.right):
        for node in functions(side):
            key = (node.args[0].args[0], node.args[0].args[1][0])
            if len(node.args) != 2 or node.args[1] != t or key not in problem.state:
                return None
            known[node] = symbol(problem.state[key])
    gap = replaced(claim.left - claim.right, known)
    if not known or not elementary(gap):
        return None
    rate = differentiate(gap, problem.time)
    for name, right in problem.right.items():
        rate = rate + differentiate(gap, name) * right
    closed = with_initial_point(domain, problem)
    if any(continuous_on(e, closed, proof) is not None for e in (gap, rate)):
        return None
    relation = claim.relation
    if relation != "==" and not _is_later(domain, problem):
        return None
    start = substitute(substitute(gap, problem.values), {problem.time: problem.start})
    fixed = Statement((), without_time(domain, problem), None, "")
    weak = relation if relation == "==" else f"{relation[0]}="
    begins = decided(Comparison(start, relation, ZERO), fixed)
    if begins.verdict is Verdict.REFUTED and relation == "==":  # the gap is continuous there
        witness = {**dict(begins.witness or {}), problem.time: exact_text(problem.start)}
        why = f"at the initial point left minus right is {start}: {begins.why}"
        return Answer(Verdict.REFUTED, why, witness=witness, lemma=INTEGRAL)
    if not begins or not decided(Comparison(rate, weak, ZERO), replace(fixed, given=closed)):
        return None
    what = "vanishes" if relation == "==" else "keeps its sign"
    why = (
        f"it holds at {problem.time} = {problem.start}, and the derivative of left minus right "
        f"along every solution, {normal_form(rate, Given())}, {what}"
    )
    return Answer(Verdict.PROVED, why, lemma=INTEGRAL)


def _is_later(domain: Given, problem: Problem) -> bool:
    """Whether the conditions keep the time at or after the initial point."""
    t = symbol(problem.time)
    return any(
        t in (x, y)
        and (x == t) == (r[0] == ">")
        and is_zero((y if x == t else x) - problem.start, domain)
        for x, r, y in domain.comparisons
    )


# Large times


def _long_time(
    claim: Comparison, problem: Problem, statement: Statement, path: Path, decided: Decide
) -> Answer:
    """Decide a claim as the time tends to infinity, by an explicit solution if one is found."""
    if path.point is not None:
        return _near_point(claim, problem, statement, path, decided)
    if path.sides != (1,):
        raise OpenError(f"claims about a solution are supported as {path.name} -> oo")
    t = symbol(problem.time)
    if any(
        problem.time in symbols(x) | symbols(y) and t not in (x, y)
        for x, _, y in statement.given.comparisons
    ):
        raise OpenError(f"the conditions must keep {t} in an interval")
    fixed = without_time(statement.given, problem)  # those with the time hold or fail far out
    if any(
        (x == t and r[0] != ">") or (y == t and r[0] != "<")
        for x, r, y in statement.given.comparisons
        if t in (x, y)
    ):
        raise OpenError(f"the conditions keep {t} from infinity")
    after = fixed & Given(((t, ">=", problem.start),))
    reason: OpenError | None = None
    for curve in solutions(problem, fixed):
        try:
            explicit, arguments = put_in(claim, problem, curve)
            for argument in arguments:
                where = after if argument == t else _segment(fixed, problem, argument)
                if not exactly(problem, curve, where, decided):
                    raise OpenError("the explicit function that was found is no solution")
        except OpenError as error:
            reason = error
            continue
        plain = Statement((), fixed, path, "", uniformly=statement.uniformly)
        found = decided(explicit, plain)
        if found.verdict is not Verdict.UNDECIDED:
            name, _ = next(key for key in problem.state if key[1] == 0)
            shown = f"{name}({t}) = {curve[problem.state[name, 0]]}"
            return replace(found, why=f"the solution is {shown}: {found.why}", lemma=EXACT)
        reason = OpenError(found.why)
    try:
        return decide_autonomous(claim, problem, statement, fixed, decided)
    except OpenError as error:
        if problem.time not in set().union(*map(symbols, problem.right.values())):
            raise reason or error from None
    try:
        return decide_attracted(claim, problem, statement, decided)
    except OpenError as error:
        raise reason or error from None


def _near_point(
    claim: Comparison, problem: Problem, statement: Statement, path: Path, decided: Decide
) -> Answer:
    """Decide a claim as the time tends to a number, by an explicit solution that is shown there."""
    t, point, start = symbol(problem.time), path.point, problem.start
    if point is None or point.op != "number" or start.op != "number":
        raise OpenError(f"the initial point and the point to which {t} tends must be numbers")
    if statement.given.comparisons or path.expression is not None:
        raise OpenError(f"conditions beside {t} -> {point} are not supported for a solution")
    if path.reach is not None:
        raise OpenError(f"a region beside {t} -> {point} is not supported for a solution")
    reason = OpenError("no explicit solution of the differential equations was found")
    first, last = point.args[0], start.args[0]
    for curve in solutions(problem, Given()):
        try:
            explicit, arguments = put_in(claim, problem, curve)
            if arguments != [t]:
                raise OpenError(f"the function must be taken at {t}")
            low = number(min(first, last) - NEARBY)
            high = number(max(first, last) + NEARBY)
            where = Given(((t, ">=", low), (t, "<=", high)))
            if not exactly(problem, curve, where, decided):
                raise OpenError("the explicit function that was found is no solution")
        except OpenError as error:
            reason = error
            continue
        found = decided(explicit, Statement((), Given(), path, "", uniformly=statement.uniformly))
        if found.verdict is not Verdict.UNDECIDED:
            name, _ = next(key for key in problem.state if key[1] == 0)
            shown = f"{name}({t}) = {curve[problem.state[name, 0]]}"
            # a constant would be for a region on which the solution is not shown to exist
            why = "it has this order" if found.constant is not None else found.why
            why = f"the solution is {shown}: {why}"
            # a time farther away is no witness, since the solution may not exist there
            witness = found.witness
            if witness and problem.time in witness:
                away = abs(parse_number(witness[problem.time]) - first)
                if away > NEARBY:
                    witness = {n: x for n, x in witness.items() if n != problem.time}
            return replace(found, why=why, lemma=EXACT, region=None, constant=None, witness=witness)
        reason = OpenError(found.why)
    raise reason


# A small parameter


def _small_parameter(
    claim: Comparison,
    problem: Problem,
    statement: Statement,
    domain: Given,
    path: Path,
    decided: Decide,
) -> Answer:
    if claim.relation not in ("O", "o", "->"):
        raise OpenError("the claim is not of the form y(t) == A, A + O(g) or A + o(g), y(t) -> L")
    if path.point is None or path.point.op != "number":
        raise OpenError("the small parameter must tend to a number")
    need_no_layer(problem.right.values(), problem.time, path)
    if path.point != ZERO:
        put = partial(substitute, mapping={path.name: symbol(path.name) + path.point})
        problem = problem._replace(
            right={n: put(e) for n, e in problem.right.items()},
            given=tuple(v._replace(point=put(v.point), value=put(v.value)) for v in problem.given),
        )
        claim = claim.mapped(put)
    if path.name in symbols(problem.start):
        raise OpenError("the initial point must not depend on the small parameter")
    order = order_of(claim, path.name)
    terms = order if claim.relation == "O" else order + 1
    fixed = without_time(domain, problem)
    try:
        found = expansion(problem, path.name, terms, fixed)
    except (InputError, ZeroDivisionError, ValueError):
        found = None
    try:
        curve: Curve | None = curve_of_claim(claim, problem, found)
        reason = None
    except OpenError as error:
        curve, reason = None, error
    pointwise = None
    if found is not None:
        try:
            pointwise = _by_expansion(claim, problem, found, domain, path, terms)
        except OpenError as error:
            reason = reason or error
    if pointwise is None and curve is not None:
        pointwise = _pointwise(problem, curve, domain, path, terms)
    if pointwise is None:
        raise reason or OpenError("no expansion of the solution was found")
    if not pointwise or claim.relation != "O":
        return _unless_uniform(pointwise, statement, problem, None)
    if curve is None or path.point != ZERO:
        return _unless_uniform(pointwise, statement, problem, None)
    return _uniformly(pointwise, claim, problem, curve, statement, path, order, decided)


def _at_zero(problem: Problem, name: str) -> Problem:
    put = partial(substitute, mapping={name: ZERO})
    return problem._replace(right={m: put(f) for m, f in problem.right.items()})


def _by_expansion(
    claim: Comparison, problem: Problem, found: Curve, domain: Given, path: Path, terms: int
) -> Answer:
    """Decide an order by the expansion of the solution, for each fixed time."""
    gap = claim.left - claim.right if claim.relation == "->" else claim.left
    explicit, arguments = put_in(replace(claim, left=gap), problem, found)
    for argument in arguments:
        segment = _segment(domain, problem, argument)
        if not _pointwise(problem, found, segment, path, terms):
            raise OpenError("the expansion that was found is none of the solution")
    mark = fresh("m", symbols(gap))
    for node in functions(gap):
        if not is_polynomial(replaced(gap, {node: symbol(mark)}), mark):
            raise OpenError(f"the claim must be a polynomial in {node}")
    e = path.name
    first = first_term(explicit.left, e, terms, with_initial_point(domain, problem))
    if first is None:
        why = (
            "it agrees with the expansion of the solution, whose equations and initial values were "
            f"checked, up to {power_text(e, terms)}, for each fixed {problem.time}"
        )
        return Answer(Verdict.PROVED, why, lemma=REGULAR)
    k, coefficient = first
    witness = nonzero_at(coefficient, with_initial_point(domain, problem))
    if witness is None:
        raise OpenError("a coefficient of the error is not shown to differ from 0")
    names = sorted({key for key in problem.state if key[1] == 0})
    shown = "; ".join(
        f"{name}({problem.time}) = {_ordered(found[problem.state[name, 0]], e, k + 1)} + "
        f"O({power_text(e, k + 1)})"
        for name, _ in names[:1]
    )
    why = (
        f"the error is ({coefficient})*{power_text(e, k)} to leading order; the solution is {shown}"
    )
    return Answer(Verdict.REFUTED, why, witness=witness, lemma=REGULAR)


def _ordered(e: Expr, name: str, terms: int) -> str:
    """Return the expansion in a parameter as text, in the order of its powers."""
    parts = []
    factorial = 1
    for k in range(terms):
        c = normal_form(substitute(e, {name: ZERO}), Given()) / number(fmpq(factorial))
        c = tidied(normal_form(c, Given()))
        if c != ZERO:
            parts.append(f"{c}" if k == 0 else f"{power_text(name, k)}*({c})")
        e = differentiate(e, name)
        factorial *= k + 1
    return " + ".join(parts) or "0"


def _pointwise(problem: Problem, curve: Curve, domain: Given, path: Path, terms: int) -> Answer:
    """Decide whether a curve is the solution up to a power of e, for each fixed time.

    The Taylor coefficients in e of its residual and initial values are looked at.
    """
    e = path.name
    closed = with_initial_point(domain, problem)
    at_zero = partial(substitute, mapping={e: ZERO})
    need_smooth(_at_zero(problem, e), {m: at_zero(c) for m, c in curve.items()}, closed)
    for name, value in problem.values.items():
        gap = substitute(curve[name], {problem.time: problem.start}) - value
        found = first_term(gap, e, terms, closed)
        if found is not None:
            k, coefficient = found
            at = nonzero_at(coefficient, closed)
            if at is None:
                raise OpenError("a coefficient of an initial value is not shown to differ")
            power = power_text(e, k)
            why = f"the initial value differs from that of the claim by {coefficient}*{power}"
            witness = {**at, problem.time: exact_text(problem.start)}
            return Answer(Verdict.REFUTED, why, witness=witness, lemma=REGULAR)
    for residual in residuals(problem, curve):
        found = first_term(residual, e, terms, closed)
        if found is None:
            continue
        k, coefficient = found
        if nonzero_at(coefficient, closed) is None:
            raise OpenError("a coefficient of the residual is not shown to vanish")
        why = (
            f"the residual of the equation is {coefficient}*{power_text(e, k)} to leading order, "
            f"so that the error is of order {power_text(e, k)} for some {problem.time}"
        )
        return Answer(Verdict.REFUTED, why, witness={}, lemma=REGULAR)
    why = (
        f"the initial values agree and the residual of the equation is of order "
        f"{power_text(e, terms)}, for each fixed {problem.time}"
    )
    return Answer(Verdict.PROVED, why, lemma=REGULAR)


# Uniformly in the time


def _unless_uniform(
    pointwise: Answer, statement: Statement, problem: Problem, why: str | None
) -> Answer:
    """Return the answer for each fixed time, which does not suffice for a uniform claim."""
    if not statement.uniformly or not pointwise:
        return pointwise
    reason = why or "no bound of the error with one constant was found"
    said = f"it holds for each fixed {problem.time}, but {reason}"
    return Answer(Verdict.UNDECIDED, said)


def _uniformly(
    pointwise: Answer,
    claim: Comparison,
    problem: Problem,
    curve: Curve,
    statement: Statement,
    path: Path,
    order: int,
    decided: Decide,
) -> Answer:
    """Prove the order with one constant for all times, or show that there is none."""
    t = symbol(problem.time)
    others = symbols_of(statement) - {problem.time, path.name}
    interval = list(_interval(problem, statement))
    if others or not interval or symbols(problem.start):
        return _unless_uniform(pointwise, statement, problem, None)
    (length,) = interval
    shift = {problem.time: t + problem.start} if problem.start != ZERO else {}
    put = partial(substitute, mapping=shift)
    moved = problem._replace(
        right={n: put(e) for n, e in problem.right.items()},
        given=tuple(v._replace(point=ZERO) for v in problem.given),
    )
    curve = {n: tidied(put(e)) for n, e in curve.items()}
    (node,) = set(functions(claim.left))
    gap = replaced(claim.left, {node: symbol("[S]")})
    factor = abs(evaluate(differentiate(gap, "[S]"), {}))
    scale = factor / abs(
        evaluate(tidied(normal_form(claim.right / symbol(path.name) ** order, Given())), {})
    )
    variable = problem.state[node.args[0].args[0], 0]
    with ball_precision():
        return _bounded(
            pointwise, moved, curve, variable, statement, path, order, length, scale, decided
        )


def _interval(problem: Problem, statement: Statement) -> Iterator[arb | None]:
    """Yield the length of the interval of times after the initial point, None if unbounded.

    Nothing is yielded if it is not bounded below by the initial point.
    """
    t = symbol(problem.time)
    length, begins = None, False
    for x, relation, y in statement.given.comparisons:
        if t in (x, y):
            end = y if x == t else x
            if symbols(end):
                return
            if (relation[0] == "<") == (x == t):
                until = evaluate(end - problem.start, {})
                length = until if length is None else length.min(until)
            elif is_zero(end - problem.start, Given()):
                begins = True
    if begins:
        yield length


def _bounded(
    pointwise: Answer,
    problem: Problem,
    curve: Curve,
    variable: str,
    statement: Statement,
    path: Path,
    order: int,
    length: arb | None,
    scale: arb,
    decided: Decide,
) -> Answer:
    e = path.name
    try:
        following = next_term(problem, curve, e, order, Given())
    except (InputError, ZeroDivisionError, ValueError):
        following = None
    if following is not None:
        t = symbol(problem.time)
        later = Given(
            ((t, ">=", ZERO), *(() if length is None else ((t, "<=", number(exact(length))),)))
        )
        more = {n: curve[n] + symbol(e) ** order * following[n] for n in curve}
        try:
            if not _pointwise(problem, more, later, path, order + 1):
                following = None
        except OpenError:
            following = None
    v = None if following is None else polynomial(following[variable], problem.time)
    if v is not None and length is None and not is_bounded(v):
        return _secular(pointwise, problem, expression(v, problem.time), path, order, statement)
    size = None if v is None else supremum(v, problem.time, length)
    best: Answer | None = None
    ranges = RANGES if path.reach is None else (path.reach,)
    for prover, reach in [(None, reach) for reach in ranges] + [(decided, x) for x in ranges[:3]]:
        if prover is not None and best is not None:
            break
        low, high = (reach * side if side in path.sides else fmpq(0) for side in (-1, 1))
        where = Range(problem.time, length, e, arb(low), arb(high))
        found = None
        if size is not None and following is not None:
            finer = {n: curve[n] + symbol(e) ** order * following[n] for n in curve}
            rest = error_bound(problem, finer, order + 1, where, prover)
            if rest is not None:
                more = rest.constant * rest.rows[variable] * arb(reach)
                found = arb(size.lower()).union(arb((size.upper() + more).upper())), rest
        if found is None:
            plain = error_bound(problem, curve, order, where, prover)
            if plain is None:
                continue
            upper = arb((plain.constant * plain.rows[variable]).upper())
            least = arb(0) if size is None else arb(size.lower())
            found = least.union(upper), plain
        ball, bound = found
        ball = ball * scale
        why = (
            f"|left| <= C |right| with C = {rounded(arb(ball.upper()), 1)} for all "
            f"{problem.time}: the logarithmic norm of the equation is at most "
            f"{rounded(bound.slope, 1)} near the approximation"
        )
        best = Answer(
            Verdict.ENCLOSED,
            why,
            constant=constant_ball(ball),
            lemma=GRONWALL,
            uniform=True,
            region=f"{statement.given}, {region(path, reach)}",
        )
        if size is None or ball.upper() <= SHARP * scale * size.lower():
            break
    if best is None and length is not None and _is_closed(problem, statement):
        why = f"{pointwise.why}, and uniformly, since the interval is bounded and closed"
        return replace(pointwise, why=why, uniform=True)
    return best or _unless_uniform(pointwise, statement, problem, None)


def _is_closed(problem: Problem, statement: Statement) -> bool:
    """Whether the interval of times contains its later end."""
    t = symbol(problem.time)
    return not any(
        (x == t and relation == "<") or (y == t and relation == ">")
        for x, relation, y in statement.given.comparisons
    )


def _secular(
    pointwise: Answer,
    problem: Problem,
    following: Expr,
    path: Path,
    order: int,
    statement: Statement,
) -> Answer:
    """Return that no constant serves for all times, since the next coefficient is unbounded."""
    why = (
        f"for each fixed {problem.time}, not uniformly: the next term, "
        f"{power_text(path.name, order)} times {following}, is unbounded"
    )
    if not statement.uniformly:
        return replace(pointwise, why=f"{pointwise.why}; {why}", uniform=False)
    return Answer(Verdict.REFUTED, f"it holds {why}", lemma=REGULAR, uniform=False, witness={})
