"""Find explicit solutions of differential equations, which the lemmas then put into the equations.

What is found is a suggestion, so that nothing here needs to be trusted: linear systems with
constant coefficients (:mod:`tresym.asymptotics.exponential_polynomials`), one linear equation with
an integrating factor, Bernoulli's equation y' = p y + q yᵃ by v = y¹⁻ᵃ, an autonomous equation with
a quadratic right side, and a few separable ones. Example: y' = y (1 − y), y(0) = 1/2 is Bernoulli's
with a = 2, and its solution is 1/(1 + e⁻ᵗ).

:func:`expansion` finds the first terms in a small parameter, each from a linear equation.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import partial

from flint import fmpq

from tresym.asymptotics.differential_problem import Problem, residuals
from tresym.asymptotics.exponential_polynomials import (
    Polynomial,
    expression,
    polynomial,
    solve_linear,
)
from tresym.reals.decisions.antiderivatives import suggested
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    apply,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign

EXPONENTS = tuple(
    fmpq(*x)
    for x in ((2, 1), (3, 1), (-1, 1), (1, 2), (4, 1), (5, 1), (-2, 1), (3, 2), (1, 3), (-3, 1))
)
"""The exponents a of Bernoulli's equation that are tried."""

Curve = dict[str, Expr]
"""For each variable of a system a function of the time."""


def solutions(problem: Problem, given: Given) -> Iterator[Curve]:
    """Yield what may be the solution of an initial value problem.

    Args:
        given: the conditions on its parameters.
    """
    try:
        found = linear(problem)
        if found is not None:
            yield found
            return
        if len(problem.right) == 1:
            ((name, right),) = problem.right.items()
            value = problem.values[name]
            for e in _of_one(right, name, problem.time, problem.start, value, given):
                yield {name: _short(e, given)}
        if len(problem.right) == 2:
            yield from _oscillators(problem, given)
    except (InputError, ZeroDivisionError, ValueError):
        return


def _short(e: Expr, given: Given) -> Expr:
    """Return the shorter of two forms."""
    return min((tidied(e), normal_form(e, given)), key=lambda x: x.size)


def linear(problem: Problem) -> Curve | None:
    """Return the solution of a linear system with constant rational coefficients, or None."""
    found = linear_polynomials(problem)
    if found is None:
        return None
    shifted = symbol(problem.time) - problem.start
    return {
        name: tidied(substitute(expression(p, problem.time), {problem.time: shifted}))
        for name, p in found.items()
    }


def linear_polynomials(problem: Problem) -> dict[str, Polynomial] | None:
    """Return the solution of a linear system as exponential polynomials of t − start."""
    names = list(problem.right)
    matrix: list[list[fmpq]] = []
    forcing = []
    rest = dict.fromkeys(names, ZERO)
    moved = symbol(problem.time) + problem.start
    for right in problem.right.values():
        row = []
        for name in names:
            slope = normal_form(differentiate(right, name), Given())
            if slope.op != "number":
                return None
            row.append(slope.args[0])
        matrix.append(row)
        source = substitute(right, rest)
        if problem.start != ZERO:
            source = substitute(source, {problem.time: moved})
        p = polynomial(tidied(source), problem.time)
        if p is None:
            return None
        forcing.append(p)
    values = problem.values
    found = solve_linear(matrix, forcing, [values[name] for name in names])
    return None if found is None else dict(zip(names, found, strict=True))


def _oscillators(problem: Problem, given: Given) -> Iterator[Curve]:
    """Yield the solution of y'' = c y with a constant c whose sign is known."""
    (first, right), (second, top) = problem.right.items()
    if right != symbol(second):
        first, second, right, top = second, first, top, right
    if right != symbol(second) or second in symbols(top):
        return
    c = tidied(differentiate(top, first))
    rest = tidied(substitute(top, {first: ZERO}))
    if symbols(c) & {first, problem.time} or rest != ZERO:
        return
    y0, y1 = problem.values[first], problem.values[second]
    s = symbol(problem.time) - problem.start
    if _is_positive(-c, given):
        w = _root(-c, given)
        found = y0 * apply("cos", w * s) + y1 / w * apply("sin", w * s)
    elif _is_positive(c, given):
        w = _root(c, given)
        found = y0 * apply("cosh", w * s) + y1 / w * apply("sinh", w * s)
    else:
        return
    found = tidied(found)
    yield {first: found, second: tidied(differentiate(found, problem.time))}


def _is_positive(e: Expr, given: Given) -> bool:
    return sign(e, given, ">") in PROVING[">"]


def _root(e: Expr, given: Given) -> Expr:
    """Return a square root, without the root of a square of something positive."""
    if e.op == "^" and e.args[1] == number(2) and _is_positive(e.args[0], given):
        return e.args[0]
    return normal_form(sqrt(e), given)


# One equation


def _of_one(
    right: Expr, name: str, time: str, start: Expr, value: Expr, given: Given
) -> Iterator[Expr]:
    y = symbol(name)
    slope = tidied(differentiate(right, name))
    rest = tidied(substitute(right, {name: ZERO})) if _defined(right, name) else None
    if rest is not None and name not in symbols(slope):
        yield from _first_order(slope, rest, time, start, value, given)
        return
    if value != ZERO:
        ratio = tidied(right / y)
        for a in EXPONENTS:
            g = differentiate(ratio, name) / y ** number(a - 2)
            power = normal_form(g, Given(((y, ">", ZERO), *given.comparisons)))
            if name in symbols(power):
                continue
            q = power * number(1 / (a - 1))
            p = normal_form(ratio - q * y ** number(a - 1), Given(((y, ">", ZERO),)))
            if name in symbols(p):
                continue
            b = number(1 - a)
            negative = _is_positive(-value, given)
            if negative and a.q != 1:
                return
            base = -value if negative else value
            if negative and (a.p % 2 == 0):
                q = -q
            inverse = number(1 / (1 - a))
            for v in _first_order(b * p, b * q, time, start, tidied(base**b), given):
                found = _short(v, given) ** inverse
                yield -found if negative else found
            break
    if time not in symbols(right):
        yield from _quadratic(right, name, time, start, value, given)
    for kind, inverse_of in _SEPARABLE.items():
        for c in (fmpq(1), fmpq(-1), fmpq(2), fmpq(-2), fmpq(1, 2), fmpq(-1, 2)):
            inner = apply(kind, number(c) * y)
            factor = normal_form(right / inner, given)
            if name in symbols(factor):
                continue
            for g in _integral(factor, time, start, given):
                yield inverse_of(number(c), value, g)
            return


def _defined(right: Expr, name: str) -> bool:
    with ball_precision():
        e = substitute(right, {n: number(fmpq(3, 7)) for n in symbols(right) - {name}})
        return bool(evaluate(substitute(e, {name: ZERO}), {}).is_finite())


_SEPARABLE = {
    # y' = g(t) exp(c y)
    "exp": lambda c, y, g: -apply("log", apply("exp", -c * y) - c * g) / c,
    # y' = g(t) sin(c y)
    "sin": lambda c, y, g: 2 * apply("atan", apply("tan", c * y / 2) * apply("exp", c * g)) / c,
}


def _first_order(
    p: Expr, q: Expr, time: str, start: Expr, value: Expr, given: Given
) -> Iterator[Expr]:
    """Yield solutions of y' = p y + q."""
    for exponent in _integral(p, time, start, given):
        if q == ZERO:
            yield value * apply("exp", exponent) if exponent != ZERO else value
            continue
        factor = tidied(apply("exp", -exponent)) if exponent != ZERO else ONE
        for total in _integral(tidied(q * factor), time, start, given):
            yield tidied((value + total) / factor)


def _integral(f: Expr, time: str, start: Expr, given: Given) -> Iterator[Expr]:
    """Yield what may be the integral of f from the initial point."""
    t = symbol(time)
    if time not in symbols(f):
        yield tidied(f * (t - start))
        return
    positive = frozenset(
        str(x.args[0])
        for x, r, y in given.comparisons
        if r == ">" and y == ZERO and x.op == "symbol"
    )
    for found in suggested(f, time, positive):
        yield tidied(found - substitute(found, {time: start}))


def _quadratic(
    right: Expr, name: str, time: str, start: Expr, value: Expr, given: Given
) -> Iterator[Expr]:
    """Yield the solution of y' = a y² + b y + c, a number a, where b²/4 − a c has a sign."""
    y, s = symbol(name), symbol(time) - start
    zero = {name: ZERO}
    first = differentiate(right, name)
    a = tidied(differentiate(first, name)) / 2
    if a.op != "number" or a == ZERO:
        return
    b, c = tidied(substitute(first, zero)), tidied(substitute(right, zero))
    if normal_form(right - a * y**2 - b * y - c, Given()) != ZERO:
        return
    square = tidied(b**2 / 4 - a * c)  # z' = a z² − square/a for z = y + b/(2a)
    shift = b / (2 * a)
    z = tidied(value + shift)
    if square == ZERO:
        yield z / (1 - a * z * s) - shift
        return
    size = sign(square, given)
    if size == "+":
        k = normal_form(sqrt(square), given)
        tanh = apply("tanh", k * s)
        yield (z - k / a * tanh) / (1 - a * z / k * tanh) - shift
    elif size == "-":
        k = normal_form(sqrt(-square), given)
        yield k / a * apply("tan", k * s + apply("atan", a * z / k)) - shift


# A small parameter


def expansion(problem: Problem, name: str, terms: int, given: Given) -> Curve | None:
    """Return the first terms of the solution in powers of a small parameter, or None.

    Args:
        name: the parameter, which tends to 0.
        terms: how many powers, from 0 on.
        given: the conditions on other parameters.
    """
    at_zero = partial(substitute, mapping={name: ZERO})
    flat = problem._replace(
        right={n: tidied(at_zero(f)) for n, f in problem.right.items()},
        given=tuple(v._replace(value=tidied(at_zero(v.value))) for v in problem.given),
    )
    curve = next(solutions(flat, given), None)
    if curve is None or name in symbols(problem.start):
        return None
    for k in range(1, terms):
        more = next_term(problem, curve, name, k, given)
        if more is None:
            return None
        e = symbol(name) ** k
        curve = {n: curve[n] + e * more[n] for n in curve}
    return curve


def next_term(problem: Problem, curve: Curve, name: str, k: int, given: Given) -> Curve | None:
    """Return the coefficient of the k-th power of the parameter in solution minus curve."""
    found = next_term_problem(problem, curve, name, k)
    if found is None:
        return None
    return next(solutions(found, given), None)


def next_term_problem(problem: Problem, curve: Curve, name: str, k: int) -> Problem | None:
    """Return the linear problem of the k-th coefficient, if the curve has all powers below."""
    start = {problem.time: problem.start}
    sources = _coefficients(residuals(problem, curve), name, k)
    gaps = [v.value - substitute(curve[v.variable], start) for v in problem.given]
    values = _coefficients(gaps, name, k)
    at_zero = {name: ZERO}
    base = {n: substitute(c, at_zero) for n, c in curve.items()}
    right = {}
    for (n, f), source in zip(problem.right.items(), sources, strict=True):
        total = -source
        for other in problem.right:
            slope = substitute(substitute(differentiate(f, other), at_zero), base)
            total = total + tidied(slope) * symbol(other)
        right[n] = total
    given = tuple(v._replace(value=x) for v, x in zip(problem.given, values, strict=True))
    return problem._replace(right=right, given=given)


def _coefficients(trees: Sequence[Expr], name: str, k: int) -> list[Expr]:
    """Return the k-th Taylor coefficients at 0."""
    factorial = 1
    found = list(trees)
    for n in range(k):
        found = [differentiate(e, name) for e in found]
        factorial *= n + 1
    return [tidied(substitute(e, {name: ZERO})) * number(fmpq(1, factorial)) for e in found]
