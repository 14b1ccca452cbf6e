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

*Inequalities.* If A' >= f(t, A) for t after the initial point and A is above the solution there, it
stays above (comparison theorem).

Source: J. K. Hale, *Ordinary Differential Equations*, 1980, sections I.3 and I.6.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial

from flint import arb, fmpq

from tresym.asymptotics.constants import rounded
from tresym.asymptotics.differential_problem import (
    OpenError,
    Problem,
    domain_of,
    problem_of,
    residuals,
    symbols_of,
    with_initial_point,
)
from tresym.asymptotics.explicit_solutions import Curve, expansion, next_term, solutions
from tresym.asymptotics.exponential_polynomials import expression, is_bounded, polynomial
from tresym.asymptotics.logarithmic_norm import Range, error_bound, supremum
from tresym.asymptotics.order_claims import region
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
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

EXACT = "uniqueness of the solution (Picard and Lindelöf; Hale 1980, theorem I.3.1)"
REGULAR = "regular dependence on a parameter (Hale 1980, theorem I.3.3)"
GRONWALL = "residual and logarithmic norm (Gronwall, Dahlquist; Hairer et al. 1993, theorem I.10.6)"
COMPARISON = "comparison of solutions (Hale 1980, theorem I.6.1)"
HIGHEST = 6
"""The highest power of the small parameter."""
RANGES = (fmpq(1, 2), fmpq(1, 5), fmpq(1, 20), fmpq(1, 100), fmpq(1, 400))
SHARP = arb("1.08")
"""The constant is at most this times the supremum, if a range of the parameter allows that."""
SAMPLES = 80


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
    problem = problem_of(statement)
    if any(jumps(e) for e in (*problem.right.values(), claim.left, claim.right)):
        raise OpenError("functions with jumps are not supported in differential equations")
    if not problem.is_initial:
        raise OpenError("boundary conditions are not supported: give all values at one point")
    domain = domain_of(problem, statement)
    if path is None:
        return _at_points(claim, problem, statement, domain, decided)
    if path.name == problem.time:
        raise OpenError(f"claims as {path.name} -> oo about a solution are not supported")
    return _small_parameter(claim, problem, statement, domain, path, decided)


# What a claim gives for the solution


def curve_of_claim(claim: Comparison, problem: Problem, found: Curve | None = None) -> Curve:
    """Return what the claim gives for each variable of the system.

    Args:
        found: what is put in for functions that the claim does not mention and that no equation
            gives, since it is linear in them.

    Raises:
        OpenError: the claim does not have the form y(t) == A.
    """
    gap = claim.left - claim.right if claim.relation in ("==", "->") else claim.left
    nodes = set(functions(gap))
    t = symbol(problem.time)
    if len(nodes) != 1:
        raise OpenError("the claim must be about one function of the differential equations")
    (node,) = nodes
    name, orders = node.args[0].args
    if (name, 0) not in problem.state or any(orders) or node.args[1] != t:
        raise OpenError("the claim must be about the function of the differential equation")
    mark = symbol("[S]")
    e = replaced(gap, {node: mark})
    factor = tidied(differentiate(e, "[S]"))
    if factor.op != "number" or factor == ZERO or not elementary(e):
        raise OpenError("the claim must be linear in the function of the differential equation")
    start = tidied(-substitute(e, {"[S]": ZERO}) / factor)
    curve: Curve = {}

    def follow(name: str, e: Expr) -> None:
        for (other, j), variable in problem.state.items():
            if other == name:
                slope = e
                for _ in range(j):
                    slope = differentiate(slope, problem.time)
                curve[variable] = tidied(slope)

    follow(name, start)
    waiting = sorted({other for other, _ in problem.state} - {name})
    for _ in range(len(waiting)):
        for other in waiting:
            if problem.state[other, 0] in curve:
                continue
            for variable, right in problem.right.items():
                missing = symbols(right) & set(problem.right) - set(curve)
                if variable not in curve or missing != {problem.state[other, 0]}:
                    continue
                (target,) = missing
                slope = tidied(differentiate(right, target))
                if slope.op != "number" or slope == ZERO:
                    continue
                rest = substitute(substitute(right, {target: ZERO}), curve)
                own = differentiate(curve[variable], problem.time)
                follow(other, tidied((own - rest) / slope))
                break
    if found is not None:
        curve = {variable: curve.get(variable, found[variable]) for variable in problem.right}
    if set(curve) != set(problem.right):
        raise OpenError("the claim says nothing of the other functions of the system")
    return curve


def put_in(claim: Comparison, problem: Problem, curve: Curve) -> tuple[Comparison, list[Expr]]:
    """Return the claim with an explicit solution in place of its functions, and their arguments.

    Raises:
        OpenError: a function of the claim is none of the differential equations.
    """
    known: dict[Expr, Expr] = {}
    for side in (claim.left, claim.right):
        for node in functions(side):
            name, orders = node.args[0].args
            highest = max((k for n, k in problem.state if n == name), default=-1)
            if len(node.args) != 2 or highest < 0 or node.args[1].hidden:
                raise OpenError(f"{node} is no value of a function of the differential equations")
            order = orders[0]
            e = curve[problem.state[name, min(order, highest)]]
            for _ in range(order - highest):
                e = differentiate(e, problem.time)
            known[node] = tidied(substitute(e, {problem.time: node.args[1]}))
    arguments = list(dict.fromkeys(node.args[1] for node in known))
    if not known:
        raise OpenError("the claim contains no function of the differential equations")
    return claim.mapped(partial(replaced, known=known)), arguments


def _fixed(domain: Given, problem: Problem) -> Given:
    """Return the conditions without the time."""
    links = domain.comparisons
    return Given(tuple(x for x in links if problem.time not in symbols(x[0]) | symbols(x[2])))


def _segment(domain: Given, problem: Problem, argument: Expr) -> Given:
    """Return the conditions with the time between the initial point and an argument."""
    t, fixed = symbol(problem.time), _fixed(domain, problem)
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
            return _exactly(problem, curve_of_claim(claim, problem), domain, decided)
        except OpenError as error:
            reason = error
    found_ = _compared(claim, problem, domain, decided)
    if found_ is not None:
        return found_
    try:
        for curve in solutions(problem, _fixed(domain, problem)):
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
        shown = _exactly(problem, curve, _segment(domain, problem, argument), decided)
        if not shown:
            raise OpenError("the explicit function that was found is no solution")
    plain = Statement((), domain, statement.path, "", uniformly=statement.uniformly)
    found = decided(explicit, plain)
    name, _ = next(key for key in problem.state if key[1] == 0)
    shown_as = f"{name}({problem.time}) = {curve[problem.state[name, 0]]}"
    return replace(found, why=f"the solution is {shown_as}: {found.why}", lemma=EXACT)


def _exactly(problem: Problem, curve: Curve, domain: Given, decided: Decide) -> Answer:
    """Decide whether a curve is the solution of an initial value problem."""
    start = {problem.time: problem.start}
    plain = Statement((), domain, None, "")
    fixed = _fixed(domain, problem)
    for name, value in problem.values.items():
        found = decided(
            Comparison(substitute(curve[name], start), "==", value), replace(plain, given=fixed)
        )
        if found.verdict is Verdict.REFUTED:
            witness = {**dict(found.witness or {}), problem.time: exact_text(problem.start)}
            why = f"the initial value is not {substitute(curve[name], start)}: {found.why}"
            return Answer(Verdict.REFUTED, why, witness=witness, lemma=EXACT)
        if not found:
            raise OpenError(f"the initial value {value} is not shown: {found.why}")
    _need_smooth(problem, curve, with_initial_point(domain, problem))
    for residual in residuals(problem, curve):
        found = decided(Comparison(residual, "==", ZERO), plain)
        if found.verdict is Verdict.REFUTED:
            why = f"the differential equation is not satisfied: {found.why}"
            return Answer(Verdict.REFUTED, why, lemma=EXACT)
        if not found:
            raise OpenError(f"it is not shown that the equation is satisfied: {found.why}")
    why = (
        "it satisfies the differential equation and the initial values, and the equation has only "
        "one solution"
    )
    return Answer(Verdict.PROVED, why, lemma=EXACT)


def _need_smooth(problem: Problem, curve: Curve, closed: Given) -> None:
    """Require that the curve is analytic in t, and the equation near it."""
    for e in curve.values():
        gap = continuous_on(e, closed, proof)
        if gap is not None:
            raise OpenError(
                f"{e} is not shown to be smooth: {gap} may leave its domain; restrict "
                f"{problem.time} to an interval around {problem.start}"
            )
    slopes = (differentiate(e, n) for e in problem.right.values() for n in problem.right)
    for e in (*problem.right.values(), *slopes):
        gap = continuous_on(substitute(e, curve), closed, proof)
        if gap is not None:
            raise OpenError(f"the equation is not shown to be smooth at the solution: {gap}")


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
    t = symbol(problem.time)
    closed, along = with_initial_point(domain, problem), substitute(right, bound)
    sides = [x for x in domain.comparisons if t in (x[0], x[2])]
    after = any(
        (x == t) == (r[0] == ">") and is_zero((y if x == t else x) - problem.start, domain)
        for x, r, y in sides
    )
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
    if not decided(begin, replace(plain, given=_fixed(domain, problem))) or not decided(
        rising, plain
    ):
        return None
    where = "above" if below else "below"
    why = (
        f"{bound[name]} is {where} the solution at the initial point and stays there, since "
        f"{rising.left} {rising.relation} {rising.right}"
    )
    return Answer(Verdict.PROVED, why, lemma=COMPARISON)


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
    if path.point != ZERO:
        put = partial(substitute, mapping={path.name: symbol(path.name) + path.point})
        problem = problem._replace(
            right={n: put(e) for n, e in problem.right.items()},
            given=tuple(v._replace(point=put(v.point), value=put(v.value)) for v in problem.given),
        )
        claim = claim.mapped(put)
    if path.name in symbols(problem.start):
        raise OpenError("the initial point must not depend on the small parameter")
    order = _order(claim, path.name)
    terms = order if claim.relation == "O" else order + 1
    fixed = _fixed(domain, problem)
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


def _order(claim: Comparison, name: str) -> int:
    """Return n for the comparison function eⁿ, or for o(eⁿ)."""
    if claim.relation == "->":
        return 0
    for n in range(HIGHEST + 1):
        rest = normal_form(claim.right / symbol(name) ** n if n else claim.right, Given())
        if name not in symbols(rest):
            if rest.op != "number" or rest == ZERO:
                raise OpenError("the comparison function must be a power of the small parameter")
            return n
    raise OpenError("the comparison function must be a power of the small parameter")


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
    for node in functions(gap):
        if not _is_polynomial(gap, node):
            raise OpenError(f"the claim must be a polynomial in {node}")
    e = path.name
    first = _first_term(explicit.left, e, terms, with_initial_point(domain, problem))
    if first is None:
        why = (
            "it agrees with the expansion of the solution, whose equations and initial values were "
            f"checked, up to {_power(e, terms)}, for each fixed {problem.time}"
        )
        return Answer(Verdict.PROVED, why, lemma=REGULAR)
    k, coefficient = first
    witness = _nonzero_at(coefficient, with_initial_point(domain, problem))
    if witness is None:
        raise OpenError("a coefficient of the error is not shown to differ from 0")
    names = sorted({key for key in problem.state if key[1] == 0})
    shown = "; ".join(
        f"{name}({problem.time}) = {_ordered(found[problem.state[name, 0]], e, k + 1)} + "
        f"O({_power(e, k + 1)})"
        for name, _ in names[:1]
    )
    why = f"the error is ({coefficient})*{_power(e, k)} to leading order; the solution is {shown}"
    return Answer(Verdict.REFUTED, why, witness=witness, lemma=REGULAR)


def _ordered(e: Expr, name: str, terms: int) -> str:
    """Return the expansion in a parameter as text, in the order of its powers."""
    parts = []
    factorial = 1
    for k in range(terms):
        c = normal_form(substitute(e, {name: ZERO}), Given()) / number(fmpq(factorial))
        c = tidied(normal_form(c, Given()))
        if c != ZERO:
            parts.append(f"{c}" if k == 0 else f"{_power(name, k)}*({c})")
        e = differentiate(e, name)
        factorial *= k + 1
    return " + ".join(parts) or "0"


def _power(name: str, k: int) -> str:
    return "1" if k == 0 else name if k == 1 else f"{name}**{k}"


def _is_polynomial(e: Expr, node: Expr) -> bool:
    """Whether an expression is a polynomial in one of its nodes."""
    if e == node or not e.hidden:
        return True
    if e.op == "unknown":
        return True
    if e.op == "^":
        n = e.args[1]
        whole = n.op == "number" and n.args[0].q == 1 and n.args[0] >= 0
        return whole and _is_polynomial(e.args[0], node)
    return e.op in ("+", "*") and all(_is_polynomial(arg, node) for arg in e.args)


def _nonzero_at(e: Expr, given: Given) -> dict[str, str] | None:
    """Return a point at which an expression is not 0."""
    with ball_precision():
        names = sorted(symbols(e))
        if not names:
            return {} if evaluate(e, {}) != 0 else None
        for at in given.points(names, SAMPLES):
            if evaluate(e, at) != 0:
                return {name: exact_text(value) for name, value in at.items()}
    return None


def _pointwise(problem: Problem, curve: Curve, domain: Given, path: Path, terms: int) -> Answer:
    """Decide whether a curve is the solution up to a power of e, for each fixed time.

    The Taylor coefficients in e of its residual and initial values are looked at.
    """
    e = path.name
    closed = with_initial_point(domain, problem)
    at_zero = partial(substitute, mapping={e: ZERO})
    _need_smooth(_at_zero(problem, e), {m: at_zero(c) for m, c in curve.items()}, closed)
    for name, value in problem.values.items():
        gap = substitute(curve[name], {problem.time: problem.start}) - value
        found = _first_term(gap, e, terms, closed)
        if found is not None:
            k, coefficient = found
            at = _nonzero_at(coefficient, closed)
            if at is None:
                raise OpenError("a coefficient of an initial value is not shown to differ")
            why = (
                f"the initial value differs from that of the claim by {coefficient}*{_power(e, k)}"
            )
            witness = {**at, problem.time: exact_text(problem.start)}
            return Answer(Verdict.REFUTED, why, witness=witness, lemma=REGULAR)
    for residual in residuals(problem, curve):
        found = _first_term(residual, e, terms, closed)
        if found is None:
            continue
        k, coefficient = found
        if _nonzero_at(coefficient, closed) is None:
            raise OpenError("a coefficient of the residual is not shown to vanish")
        why = (
            f"the residual of the equation is {coefficient}*{_power(e, k)} to leading order, so "
            f"that the error is of order {_power(e, k)} for some {problem.time}"
        )
        return Answer(Verdict.REFUTED, why, witness={}, lemma=REGULAR)
    why = (
        f"the initial values agree and the residual of the equation is of order "
        f"{_power(e, terms)}, for each fixed {problem.time}"
    )
    return Answer(Verdict.PROVED, why, lemma=REGULAR)


def _first_term(gap: Expr, name: str, terms: int, given: Given) -> tuple[int, Expr] | None:
    """Return the first Taylor coefficient in the small parameter that does not vanish identically.

    None if all below ``terms`` do. The function must be analytic where the parameter is 0, and so
    near every bounded part of the interval.

    Raises:
        OpenError: this is not shown.
    """
    missing = continuous_on(substitute(gap, {name: ZERO}), given, proof)
    if missing is not None:
        raise OpenError(f"{gap} is not shown to be smooth at {name} = 0: {missing}")
    factorial = 1
    for k in range(terms):
        coefficient = tidied(substitute(gap, {name: ZERO}))
        if not is_zero(coefficient, given):
            return k, tidied(normal_form(coefficient, given) * number(fmpq(1, factorial)))
        gap = differentiate(gap, name)
        factorial *= k + 1
    return None


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
                length = evaluate(end - problem.start, {})
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
        f"for each fixed {problem.time}, not uniformly: the next term, {_power(path.name, order)} "
        f"times {following}, is unbounded"
    )
    if not statement.uniformly:
        return replace(pointwise, why=f"{pointwise.why}; {why}", uniform=False)
    return Answer(Verdict.REFUTED, f"it holds {why}", lemma=REGULAR, uniform=False, witness={})
