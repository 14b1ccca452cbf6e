"""What lemmas on initial and on boundary values share: explicit functions put into a problem.

A claim such as ``y(t) == 3*exp(-2*t)`` gives a function for every variable of the system
(:func:`curve_of_claim`); :func:`exactly` decides whether functions solve an initial value problem,
and :func:`first_term` finds the first Taylor coefficient in a small parameter that does not vanish.
"""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from flint import fmpq

from tresym.asymptotics.differential_problem import (
    OpenError,
    Problem,
    residuals,
    with_initial_point,
)
from tresym.asymptotics.explicit_solutions import Curve
from tresym.reals.decisions.answer import Answer, Decide, exact_text
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
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
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Verdict

EXACT = "uniqueness of the solution (Picard and Lindelöf; Hale 1980, theorem I.3.1)"
HIGHEST = 6
"""The highest power of the small parameter."""
SAMPLES = 80


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


def exactly(problem: Problem, curve: Curve, domain: Given, decided: Decide) -> Answer:
    """Decide whether a curve is the solution of an initial value problem."""
    start = {problem.time: problem.start}
    plain = Statement((), domain, None, "")
    fixed = without_time(domain, problem)
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
    need_smooth(problem, curve, with_initial_point(domain, problem))
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


def need_smooth(problem: Problem, curve: Curve, closed: Given) -> None:
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


def order_of(claim: Comparison, name: str) -> int:
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


def power_text(name: str, k: int) -> str:
    """Return a power of the small parameter as text."""
    return "1" if k == 0 else name if k == 1 else f"{name}**{k}"


def nonzero_at(e: Expr, given: Given) -> dict[str, str] | None:
    """Return a point at which an expression is not 0."""
    with ball_precision():
        names = sorted(symbols(e))
        if not names:
            return {} if evaluate(e, {}) != 0 else None
        for at in given.points(names, SAMPLES):
            if evaluate(e, at) != 0:
                return {name: exact_text(value) for name, value in at.items()}
    return None


def first_term(gap: Expr, name: str, terms: int, given: Given) -> tuple[int, Expr] | None:
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


def without_time(domain: Given, problem: Problem) -> Given:
    """Return the conditions without the time."""
    links = domain.comparisons
    return Given(tuple(x for x in links if problem.time not in symbols(x[0]) | symbols(x[2])))
