"""Decide claims about the solution of an initial value problem.

Examples: ``y(t) == 3*exp(-2*t) given diff(y(t), t) == -2*y(t), y(0) == 3`` and, with a small
parameter, ``y(t) == exp(-t) + e*(exp(-t) - exp(-2*t)) + O(e**2) given diff(y(t), t) == -y(t) +
e*y(t)**2, y(0) == 1, t >= 0 as e -> 0``. Equations of higher order are systems of first order,
u' = f(t, u, e); A is what the claim gives for u.

*Exact solutions.* A satisfies every equation and every initial value, and f is analytic near (t,
A(t)) for all t. Then A is the only solution there (Picard and Lindelöf). If the equation fails, or
an initial value, the claim is false, since the solution exists near the initial point.

*A small parameter, t fixed.* If f is analytic near the curve (t, A(t), 0) and the residual A' −
f(t, A, e) and the error of the initial value are O(eⁿ), then u − A = O(eⁿ), uniformly on every
bounded interval of t. That is shown exactly: the Taylor coefficients of the residual in e vanish
identically below eⁿ. If one does not, u − A is of that lower order for some t.

*Uniformly in t.* One equation of first order with ∂f/∂y ≤ L for |y − A| ≤ w and a residual of at
most K eⁿ: |y − A| ≤ K eⁿ (e^{Lt} − 1)/L as long as that is below w; for L < 0 this is at most
K eⁿ/|L| for all t. Source: J. K. Hale, *Ordinary Differential Equations*, 1980, section I.6.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.constants import rounded
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
    ONE,
    ZERO,
    Expr,
    apply,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

EXACT = "uniqueness of the solution (Picard and Lindelöf; Hale 1980, theorem I.3.1)"
REGULAR = "regular dependence on a parameter (Hale 1980, theorem I.3.3)"
GRONWALL = "residual and one-sided Lipschitz bound (Gronwall; Hale 1980, section I.6)"
HIGHEST = 6
"""The highest power of the small parameter."""
WIDTHS = (fmpq(1, 2), fmpq(1, 5), fmpq(1, 20))
RANGES = (fmpq(1, 2), fmpq(1, 5), fmpq(1, 20), fmpq(1, 100))
SAMPLES = 80


class _OpenError(Exception):
    """The lemma is not shown to apply; the text says what is missing."""


class _Problem(NamedTuple):
    """An initial value problem u' = f(t, u), u(start) = values, as a system of first order.

    Attributes:
        time: the independent variable.
        start: the initial point.
        right: for each variable of the system, its derivative.
        values: their initial values.
        state: the variables, by function and order of the derivative.
    """

    time: str
    start: Expr
    right: dict[str, Expr]
    values: dict[str, Expr]
    state: dict[tuple[str, int], str]


def decide_initial_values(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about a function that differential equations and initial values determine.

    Args:
        claim: the comparison.
        statement: its conditions.
        decided: the procedure for claims about explicit functions.
    """
    try:
        return _decide(claim, statement, decided)
    except _OpenError as error:
        return Answer(Verdict.UNDECIDED, str(error))


def _decide(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    path = statement.path
    if claim.derivatives or statement.integers:
        raise _OpenError(
            "a claim about the solution of a differential equation compares it with an explicit "
            "function, without derivatives and integer conditions"
        )
    problem = _problem(statement)
    curve, factor = _curve(claim, problem)
    if any(jumps(e) for e in (*problem.right.values(), *curve.values())):
        raise _OpenError("functions with jumps are not supported in differential equations")
    domain = _domain(problem, statement)
    if claim.relation == "==" and path is None:
        return _exactly(problem, curve, domain, decided)
    if path is None or claim.relation not in ("O", "o", "->"):
        raise _OpenError("the claim is not of the form y(t) == A, A + O(g) or A + o(g), y(t) -> L")
    if path.name == problem.time:
        raise _OpenError(f"claims as {path.name} -> oo about a solution are not supported")
    if path.point is None or path.point.op != "number":
        raise _OpenError("the small parameter must tend to a number")
    moved = symbol(path.name) + path.point
    if path.point != ZERO:
        put = partial(substitute, mapping={path.name: moved})
        problem = problem._replace(
            start=put(problem.start),
            right={n: put(e) for n, e in problem.right.items()},
            values={n: put(e) for n, e in problem.values.items()},
        )
        curve = {n: put(e) for n, e in curve.items()}
        claim = claim.mapped(put)
    order = _order(claim, path.name, factor)
    pointwise = _pointwise(problem, curve, domain, path, order, claim.relation == "O")
    if not pointwise or claim.relation != "O" or path.point != ZERO:
        return pointwise
    return _uniformly(problem, curve, statement, path, order, decided) or pointwise


# Reading the problem


def _problem(statement: Statement) -> _Problem:
    """Return the system of first order that the equations of the statement state."""
    gaps = [left - right for left, right in statement.equations]
    nodes = [list(functions(gap)) for gap in gaps]
    times = {
        node.args[1]
        for part in nodes
        for node in part
        if any(node.args[0].args[1]) and len(node.args) == 2 and node.args[1].op == "symbol"
    }
    if len(times) != 1 or any(len(node.args) != 2 for part in nodes for node in part):
        raise _OpenError("the equations must contain functions of one and the same variable")
    time = str(next(iter(times)))
    equations, initial = [], []
    for gap, part in zip(gaps, nodes, strict=True):
        at = {node.args[1] for node in part}
        if at == {symbol(time)}:
            equations.append(gap)
        elif part and time not in symbols(gap):
            initial.append(gap)
        else:
            raise _OpenError(f"{gap} == 0 is neither a differential equation nor an initial value")
    highest: dict[str, int] = {}
    for gap in equations:
        for node in functions(gap):
            name, (order,) = node.args[0].args
            highest[name] = max(order, highest.get(name, 0))
    if len(equations) != len(highest) or min(highest.values(), default=0) < 1:
        raise _OpenError("there must be one differential equation for each function")
    taken = symbols_of(statement)
    state: dict[tuple[str, int], str] = {}
    for name, order in highest.items():
        for j in range(order):
            state[name, j] = _fresh(f"{name}_{j}", taken)
            taken.add(state[name, j])
    put = {
        unknown(name, (symbol(time),), (j,)): symbol(variable)
        for (name, j), variable in state.items()
    }
    right: dict[str, Expr] = {}
    for gap in equations:
        tops = [
            n
            for n, order in highest.items()
            if unknown(n, (symbol(time),), (order,)) in set(functions(gap))
        ]
        if len(tops) != 1:
            raise _OpenError("each equation must contain the highest derivative of one function")
        (name,) = tops
        top = unknown(name, (symbol(time),), (highest[name],))
        mark = symbol("[D]")
        e = replaced(gap, put | {top: mark})
        slope = tidied(differentiate(e, "[D]"))
        if "[D]" in symbols(slope) or not elementary(e):
            raise _OpenError(f"the equation {gap} == 0 is not linear in the highest derivative")
        if slope.op != "number" and sign(slope, statement.given, "!=") not in PROVING["!="]:
            raise _OpenError(f"the factor {slope} of the highest derivative may vanish")
        solved = tidied(-substitute(e, {"[D]": ZERO}) / slope)
        for j in range(highest[name]):
            variable = state[name, j]
            if variable in right:
                raise _OpenError(f"there are two equations for {name}")
            right[variable] = symbol(state[name, j + 1]) if j + 1 < highest[name] else solved
    values: dict[str, Expr] = {}
    starts = set()
    for gap in initial:
        found = list(functions(gap))
        if len(set(found)) != 1:
            raise _OpenError("boundary conditions are not supported: give initial values")
        node = found[0]
        name, (j,) = node.args[0].args
        mark = symbol("[V]")
        e = replaced(gap, {node: mark})
        slope = tidied(differentiate(e, "[V]"))
        if (name, j) not in state or slope.op != "number" or slope == ZERO:
            raise _OpenError(f"{gap} == 0 is no initial value of the equations")
        if state[name, j] in values:
            raise _OpenError(f"there are two initial values of {node}")
        values[state[name, j]] = tidied(-substitute(e, {"[V]": ZERO}) / slope)
        starts.add(node.args[1])
    if set(values) != set(right):
        raise _OpenError(
            f"a problem of order {len(right)} needs {len(right)} initial values; "
            f"{len(values)} are given"
        )
    if len(starts) != 1:
        raise _OpenError("boundary conditions are not supported: give all values at one point")
    return _Problem(time, starts.pop(), right, values, state)


def symbols_of(statement: Statement) -> set[str]:
    """Return all variables of a statement."""
    trees = [side for c in statement.comparisons for side in (c.left, c.right)]
    return set().union(*map(symbols, (*trees, *statement.said)))


def _fresh(name: str, taken: set[str]) -> str:
    while name in taken:
        name += "_"
    return name


def _curve(claim: Comparison, problem: _Problem) -> tuple[dict[str, Expr], Expr]:
    """Return what the claim gives for each variable of the system, and the factor of the function.

    What it does not give for another function follows from an equation that is linear in it.
    """
    gap = claim.left - claim.right if claim.relation in ("==", "->") else claim.left
    found = set(functions(gap))
    t = symbol(problem.time)
    if len(found) != 1:
        raise _OpenError("the claim must be about one function of the differential equations")
    (node,) = found
    name, orders = node.args[0].args
    if (name, 0) not in problem.state or any(orders) or node.args[1] != t:
        raise _OpenError("the claim must be about the function of the differential equation")
    mark = symbol("[S]")
    e = replaced(gap, {node: mark})
    factor = tidied(differentiate(e, "[S]"))
    if factor.op != "number" or factor == ZERO or not elementary(e):
        raise _OpenError("the claim must be linear in the function of the differential equation")
    start = tidied(-substitute(e, {"[S]": ZERO}) / factor)
    curve: dict[str, Expr] = {}

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
    if set(curve) != set(problem.right):
        raise _OpenError("the claim says nothing of the other functions of the system")
    return curve, factor


def _domain(problem: _Problem, statement: Statement) -> Given:
    """Return the conditions, which must keep the variable in an interval with the initial point."""
    t = symbol(problem.time)
    links = []
    for link in statement.given.comparisons:
        left, relation, right = link
        names = symbols(left) | symbols(right)
        if statement.path is not None and statement.path.name in names:
            raise _OpenError("conditions on the small parameter are not supported")
        if problem.time in names:
            ends = [side for side in (left, right) if side != t]
            if len(ends) != 1 or problem.time in symbols(ends[0]) or relation == "!=":
                raise _OpenError(f"the conditions must keep {t} in an interval")
            below = (relation[0] == "<") == (left == t)
            gap = ends[0] - problem.start if below else problem.start - ends[0]
            if sign(gap, statement.given, ">=") not in PROVING[">="]:
                raise _OpenError(f"the interval of {t} must contain the initial point")
        links.append(link)
    return Given(tuple(links))


def _closed(domain: Given, problem: _Problem) -> Given:
    """Return the conditions with the initial point in the interval of the variable."""
    t = symbol(problem.time)

    def with_start(x: Expr, relation: str, y: Expr) -> Compared:
        end = y if x == t else x if y == t else None
        if end is None or relation.endswith("=") or not is_zero(end - problem.start, domain):
            return x, relation, y
        return x, f"{relation}=", y

    return Given(tuple(with_start(*link) for link in domain.comparisons))


def _residuals(problem: _Problem, curve: dict[str, Expr]) -> list[Expr]:
    return [
        differentiate(curve[n], problem.time) - substitute(right, curve)
        for n, right in problem.right.items()
    ]


# Exact solutions


def _exactly(problem: _Problem, curve: dict[str, Expr], domain: Given, decided: Decide) -> Answer:
    start = {problem.time: problem.start}
    plain = Statement((), domain, None, "")
    fixed = Given(
        tuple(x for x in domain.comparisons if problem.time not in symbols(x[0]) | symbols(x[2]))
    )
    for name, value in problem.values.items():
        found = decided(
            Comparison(substitute(curve[name], start), "==", value), replace(plain, given=fixed)
        )
        if found.verdict is Verdict.REFUTED:
            witness = {**dict(found.witness or {}), problem.time: exact_text(problem.start)}
            why = f"the initial value is not {substitute(curve[name], start)}: {found.why}"
            return Answer(Verdict.REFUTED, why, witness=witness, lemma=EXACT)
        if not found:
            raise _OpenError(f"the initial value {value} is not shown: {found.why}")
    _need_smooth(problem, curve, _closed(domain, problem))
    answers = []
    for residual in _residuals(problem, curve):
        found = decided(Comparison(residual, "==", ZERO), plain)
        if found.verdict is Verdict.REFUTED:
            why = f"the differential equation is not satisfied: {found.why}"
            return Answer(Verdict.REFUTED, why, lemma=EXACT)
        if not found:
            raise _OpenError(f"it is not shown that the equation is satisfied: {found.why}")
        answers.append(found)
    why = (
        "it satisfies the differential equation and the initial values, and the equation has only "
        "one solution"
    )
    return Answer(Verdict.PROVED, why, lemma=EXACT)


def _need_smooth(problem: _Problem, curve: dict[str, Expr], closed: Given) -> None:
    """Require that the curve is analytic in t, and the equation near it."""
    for e in curve.values():
        gap = continuous_on(e, closed, proof)
        if gap is not None:
            raise _OpenError(
                f"{e} is not shown to be smooth: {gap} may leave its domain; restrict "
                f"{problem.time} to an interval around {problem.start}"
            )
    for e in problem.right.values():
        there = substitute(e, curve)
        gap = continuous_on(there, closed, proof)
        if gap is not None:
            raise _OpenError(f"the equation is not shown to be smooth at the solution: {gap}")


# A small parameter


def _order(claim: Comparison, name: str, factor: Expr) -> int:
    """Return n for the comparison function eⁿ, or for o(eⁿ)."""
    if claim.relation == "->":
        return 0
    for n in range(HIGHEST + 1):
        rest = normal_form(claim.right / symbol(name) ** n if n else claim.right, Given())
        if name not in symbols(rest):
            if rest.op != "number" or rest == ZERO:
                raise _OpenError("the comparison function must be a power of the small parameter")
            return n
    raise _OpenError("the comparison function must be a power of the small parameter")


def _pointwise(
    problem: _Problem, curve: dict[str, Expr], domain: Given, path: Path, n: int, big: bool
) -> Answer:
    """Decide the order for each fixed value of the variable by Taylor coefficients in e."""
    e = path.name
    terms = n if big else n + 1  # coefficients of e**k for k < terms must vanish
    closed = _closed(domain, problem)
    if e in symbols(problem.start):
        raise _OpenError("the initial point must not depend on the small parameter")
    at_zero = partial(substitute, mapping={e: ZERO})
    flat = problem._replace(right={m: at_zero(f) for m, f in problem.right.items()})
    _need_smooth(flat, {m: at_zero(c) for m, c in curve.items()}, closed)
    for name, value in problem.values.items():
        gap = substitute(curve[name], {problem.time: problem.start}) - value
        found = _first_term(gap, e, terms, closed)
        if found is not None:
            k, coefficient = found
            power = f"{e}**{k}" if k else "1"
            why = f"the initial value differs from that of the claim by {coefficient}*{power}"
            witness = {problem.time: exact_text(problem.start)}
            return Answer(Verdict.REFUTED, why, witness=witness, lemma=REGULAR)
    for residual in _residuals(problem, curve):
        found = _first_term(residual, e, terms, closed)
        if found is None:
            continue
        k, coefficient = found
        with ball_precision():
            shown = any(
                evaluate(coefficient, at) != 0
                for at in closed.points(sorted(symbols(coefficient)), SAMPLES)
            )
        if not shown:
            raise _OpenError("a coefficient of the residual is not shown to vanish")
        why = (
            f"the residual of the equation is {coefficient}*{e}**{k} to leading order, so that "
            f"the error is of order {e}**{k} for some {problem.time}"
        )
        return Answer(Verdict.REFUTED, why, witness={}, lemma=REGULAR)
    why = (
        f"the initial values agree and the residual of the equation is of order {e}**{terms}, for "
        f"each fixed {problem.time}"
    )
    return Answer(Verdict.PROVED, why, lemma=REGULAR)


def _first_term(gap: Expr, name: str, terms: int, given: Given) -> tuple[int, Expr] | None:
    """Return the first Taylor coefficient in the small parameter that does not vanish identically.

    None if all below ``terms`` do. The function must be analytic where the parameter is 0, and so
    near every bounded part of the interval.

    Raises:
        _OpenError: this is not shown.
    """
    missing = continuous_on(substitute(gap, {name: ZERO}), given, proof)
    if missing is not None:
        raise _OpenError(f"{gap} is not shown to be smooth at {name} = 0: {missing}")
    factorial = 1
    for k in range(terms):
        coefficient = tidied(substitute(gap, {name: ZERO}))
        if not is_zero(coefficient, given):
            return k, tidied(normal_form(coefficient, given) * number(fmpq(1, factorial)))
        gap = differentiate(gap, name)
        factorial *= k + 1
    return None


def _uniformly(
    problem: _Problem,
    curve: dict[str, Expr],
    statement: Statement,
    path: Path,
    n: int,
    decided: Decide,
) -> Answer | None:
    """Prove the order with one constant for all t, by Gronwall's inequality; None if that fails."""
    if len(problem.right) != 1:
        return None
    ((name, right),) = problem.right.items()
    a, t, e = curve[name], symbol(problem.time), symbol(path.name)
    others = symbols_of(statement) - {problem.time, path.name, name}
    others |= symbols(right) - {problem.time, path.name, name}
    if others or symbols(problem.start):
        return None
    ends = [
        (x if y == t else y, (r[0] == "<") == (x == t))
        for x, r, y in statement.given.comparisons
        if t in (x, y)
    ]
    length = None
    for end, below in ends:
        if below:
            length = tidied(end - problem.start)
    if not any(not below and is_zero(end - problem.start, Given()) for end, below in ends):
        return None
    if substitute(a, {problem.time: problem.start}) - problem.values[name] != ZERO and not is_zero(
        substitute(a, {problem.time: problem.start}) - problem.values[name], Given()
    ):
        return None
    residual = tidied(_residuals(problem, curve)[0])
    for width in WIDTHS:
        s = symbol("s_")
        slope = substitute(differentiate(right, name), {name: a + number(width) * s})
        tube: tuple[Compared, ...] = ((s, ">=", -ONE), (s, "<=", ONE))
        for reach in RANGES:
            near = Given((*statement.given.comparisons, *_small(e, path, reach)))
            answer = _gronwall(
                residual, slope, near, near & Given(tube), length, path, n, width, reach, decided
            )
            if answer is not None:
                shown = region(path, reach)
                return replace(answer, region=f"{statement.given}, {shown}")
    return None


def _small(e: Expr, path: Path, reach: fmpq) -> tuple[Compared, ...]:
    """Return the range of the small parameter."""
    low = number(-reach if -1 in path.sides else 0)
    high = number(reach if 1 in path.sides else 0)
    return (e, ">=", low), (e, "<=", high), (e, "!=", ZERO)


def _gronwall(
    residual: Expr,
    slope: Expr,
    near: Given,
    tube: Given,
    length: Expr | None,
    path: Path,
    n: int,
    width: fmpq,
    reach: fmpq,
    decided: Decide,
) -> Answer | None:
    e = symbol(path.name)
    size_ = e if path.sides == (1,) else apply("abs", e)
    gauge = size_**n if n else ONE
    with ball_precision():
        slopes = _sampled(slope, tube)
        sizes = [abs(x) for x in _sampled(residual / gauge, near)]
        if not slopes or not sizes:
            return None
        top = max(slopes)
        if length is None and top >= 0:
            return None
        lipschitz = fmpq(int(1000 * top * (0.9 if top < 0 else 1.1)) + (1 if top >= 0 else 0), 1000)
        if length is None and lipschitz >= 0:
            return None
        size = fmpq(int(max(sizes) * 10200) + 1, 10000)
        if length is None:
            factor = arb(1) / arb(-lipschitz)
        else:
            span = evaluate(length, {})
            rate = arb(lipschitz)
            factor = span if lipschitz == 0 else ((rate * span).exp() - 1) / rate
        if not arb(size) * factor * arb(reach) ** n <= arb(width):
            return None
    plain = Statement((), tube, None, "")
    if not decided(Comparison(slope, "<=", number(lipschitz)), plain):
        return None
    bounded = Comparison(apply("abs", residual), "<=", number(size) * gauge)
    if not decided(bounded, replace(plain, given=near)):
        return None
    constant = arb(size) * factor
    why = (
        f"|left| <= C |right| with C = {rounded(constant, 1)}: the residual of the equation is at "
        f"most {number(size)}*{gauge}, and its slope at most {number(lipschitz)} within {width} of "
        "the approximation"
    )
    return Answer(
        Verdict.ENCLOSED,
        why,
        constant=constant_ball(arb(0).union(constant.upper())),
        lemma=GRONWALL,
        uniform=True,
    )


def _sampled(e: Expr, given: Given) -> list[float]:
    names = sorted(symbols(e))
    if not names:
        value = evaluate(e, {})
        return [float(value.mid())] if value.is_finite() else []
    found = []
    for at in given.points(names, SAMPLES):
        value = evaluate(e, at)
        if value.is_finite():
            found.append(float(value.mid()))
    return found
