"""Random identities with known truth: rewritten by exact rules, or changed visibly.

A true one is an expression rewritten twice, by rules that hold wherever both of their sides are
defined. A false one has a change in it besides, and a point at which mpmath, which shares nothing
with the procedure under trial, finds both sides defined and far apart. Everything follows from the
state of the generator that is passed in.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from fractions import Fraction
from random import Random
from typing import Any

from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    rebuild,
    sqrt,
    substitute,
    symbol,
)
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError

VARIABLES = ("x", "y", "a")
_LEAVES = ("x", "x", "y", "a", "2", "3", "-1", "1/2", "5/3", "pi", "sqrt(2)")
_FUNCTIONS = (
    *("exp", "log", "sin", "cos", "tan", "atan", "asin", "acos", "sinh", "cosh", "tanh"),
    *("asinh", "atanh", "abs", "cbrt"),
)
_SHAPES = ("u**2 + 1", "1 - u**2", "u/(1 + u)", "1/u", "u**3", "u*v", "u + v", "u - v", "u/v")
_DEFECTS = ("1", "x", "1/10^30", "x/10^20", "sin(x)/10^9", "y*x/10^40", "pi/10^12")

RULES: Mapping[str, tuple[str, ...]] = {
    "exp": ("exp(u/2)**2", "cosh(u) + sinh(u)", "1/exp(-u)", "exp(u - 1)*exp(1)"),
    "log": ("2*log(sqrt(u))", "-log(1/u)", "log(2*u) - log(2)", "log(u**2)/2"),
    "sin": ("2*sin(u/2)*cos(u/2)", "cos(pi/2 - u)", "tan(u)*cos(u)", "-sin(u + pi)", "1/csc(u)"),
    "cos": ("1 - 2*sin(u/2)**2", "sin(pi/2 - u)", "cos(-u)", "1/sec(u)", "cot(u)*sin(u)"),
    "tan": ("sin(u)/cos(u)", "sin(2*u)/(1 + cos(2*u))", "1/cot(u)", "tan(u + pi)"),
    "atan": ("2*atan(u/(1 + sqrt(1 + u**2)))", "asin(u/sqrt(1 + u**2))", "-atan(-u)"),
    "asin": ("pi/2 - acos(u)", "atan(u/sqrt(1 - u**2))", "-asin(-u)"),
    "acos": ("pi/2 - asin(u)", "pi - acos(-u)", "2*atan(sqrt((1 - u)/(1 + u)))"),
    "sinh": ("(exp(u) - exp(-u))/2", "2*sinh(u/2)*cosh(u/2)", "tanh(u)*cosh(u)", "1/csch(u)"),
    "cosh": ("(exp(u) + exp(-u))/2", "1 + 2*sinh(u/2)**2", "sqrt(1 + sinh(u)**2)"),
    "tanh": ("(exp(2*u) - 1)/(exp(2*u) + 1)", "sinh(u)/cosh(u)", "sinh(2*u)/(1 + cosh(2*u))"),
    "asinh": ("log(u + sqrt(u**2 + 1))", "-asinh(-u)", "atanh(u/sqrt(1 + u**2))"),
    "atanh": ("log((1 + u)/(1 - u))/2", "-atanh(-u)", "asinh(u/sqrt(1 - u**2))"),
    "abs": ("sqrt(u**2)", "u*sign(u)", "u**2/abs(u)", "abs(-u)"),
    "cbrt": ("sign(u)*abs(u)**(1/3)", "u/cbrt(u)**2", "-cbrt(-u)"),
    "+": ("u*(1 + v/u)", "v + u", "(u**2 - v**2)/(u - v)", "u + sqrt(v**2)*sign(v)"),
    "*": ("((u + v)**2 - (u - v)**2)/4", "v*u", "u/(1/v)", "sign(u)*abs(u)*v"),
    "sqrt": ("u/sqrt(u)", "(u**2)**(1/4)", "sqrt(2*u)/sqrt(2)", "exp(log(u)/2)"),
    "symbol": ("u*cos(y)**2 + u*sin(y)**2", "(u**2 + u)/(u + 1)", "tan(atan(u))", "cbrt(u**3)"),
}
"""By the outermost operation of ``f(u)`` or of ``u`` and ``v``: expressions equal to it."""


def true_identity(random: Random) -> tuple[Expr, Expr]:
    """Two rewritings of one expression, or their derivatives, both real at some point."""
    while True:
        try:
            e = expression(random, random.randint(2, 5))
            left, right = rewritten(e, random), rewritten(e, random)
            if random.random() < 0.3:
                left, right = differentiate(left, "x"), rewritten(differentiate(right, "x"), random)
        except InputError:
            continue  # a number or a power outgrew its bounds
        sides = (left, right)
        if any(None not in [real_value(e, point) for e in sides] for point in points(random)):
            return left, right


def false_identity(random: Random) -> tuple[Expr, Expr]:
    """Two rewritings of one expression, one of them changed, seen to differ at a point."""
    while True:
        left, right = true_identity(random)
        try:
            right = changed(right, random)
        except InputError:
            continue
        if any(far_apart(left, right, point) for point in points(random)):
            return left, right


def expression(random: Random, size: int) -> Expr:
    """A random expression of about ``size`` operations."""
    if size <= 0:
        return parse(random.choice(_LEAVES))
    if random.random() < 0.45:
        return apply(random.choice(_FUNCTIONS), expression(random, size - 1))
    if random.random() < 0.25:
        return sqrt(expression(random, size - 1))
    first = random.randint(0, size - 1)
    parts = {"u": expression(random, first), "v": expression(random, size - 1 - first)}
    return substitute(parse(random.choice(_SHAPES)), parts)


def rewritten(e: Expr, random: Random) -> Expr:
    """``e`` with one to four of its parts replaced by what equals them."""
    for _ in range(random.randint(1, 4)):
        path = _path(e, random)
        e = _replaced(e, path, lambda part: _equal(part, random))
    return e


def changed(e: Expr, random: Random) -> Expr:
    """``e`` with a number, a sign, a power or a function changed, or with something added."""
    if random.random() < 0.3:
        return e + parse(random.choice(_DEFECTS))
    return _replaced(e, _path(e, random), lambda part: _other(part, random))


def _path(e: Expr, random: Random) -> list[int]:
    """The way to a random part."""
    path: list[int] = []
    while e.op not in ("number", "symbol", "pi") and random.random() < 0.75:
        k = random.randrange(1 if e.op == "^" else len(e.args))
        path.append(k)
        e = e.args[k]
    return path


def _replaced(e: Expr, path: list[int], change: Any) -> Expr:
    if not path:
        result: Expr = change(e)
        return result
    k = path[0]
    inner = _replaced(e.args[k], path[1:], change)
    return rebuild(e, (*e.args[:k], inner, *e.args[k + 1 :]))


def _equal(e: Expr, random: Random) -> Expr:
    """An expression equal to ``e`` by one rule, wherever both are defined."""
    if e.op in ("+", "*"):
        k = random.randrange(len(e.args))
        join = add if e.op == "+" else multiply
        parts = {"u": e.args[k], "v": join(*e.args[:k], *e.args[k + 1 :])}
        return substitute(parse(random.choice(RULES[e.op])), parts)
    name = "sqrt" if e.op == "^" and e.args[1] == number(Fraction(1, 2)) else e.op
    if name not in RULES:
        return e
    inner = e if name == "symbol" else e.args[0]
    return substitute(parse(random.choice(RULES[name])), {"u": inner})


def _other(e: Expr, random: Random) -> Expr:
    """An expression that is not ``e``, nor most often equal to it."""
    if e.op == "number":
        return number(e.args[0] + random.choice((-2, -1, 1, 2)))
    if e.op == "symbol":
        return symbol(random.choice([name for name in VARIABLES if name != e.args[0]]))
    if e.op == "^":
        return power(e.args[0], e.args[1] + 1)
    if e.op in _FUNCTIONS and random.random() < 0.6:
        return apply(random.choice([name for name in _FUNCTIONS if name != e.op]), e.args[0])
    return random.choice((-e, 2 * e, e + 1, abs(e)))


def points(random: Random, names: Sequence[str] = VARIABLES) -> Iterator[dict[str, Fraction]]:
    """Twelve random points, small and large, some with positive coordinates only."""
    for k in range(12):
        size = (1, 4, 1, 30)[k % 4]
        yield {
            name: Fraction(random.randint(-999 if k % 3 else 1, 999) * size, 1000) for name in names
        }


def far_apart(left: Expr, right: Expr, point: Mapping[str, Fraction]) -> bool:
    """Whether both sides have real values there that differ, at 60 digits and at 150 alike."""
    import mpmath

    gaps = []
    for digits in (60, 150):
        with mpmath.workdps(digits):
            x, y = real_value(left, point), real_value(right, point)
            if x is None or y is None:
                return False
            gaps.append(abs(x - y) / (1 + abs(x)))
    return bool(gaps[0] > 1e-45 and abs(gaps[0] - gaps[1]) < gaps[0] * 1e-6)


def real_value(e: Expr, point: Mapping[str, Fraction]) -> Any:
    """The value in mpmath at its working precision, None where it is not real."""
    import mpmath

    at = {name: mpmath.mpf(x.numerator) / x.denominator for name, x in point.items()}
    try:
        value = _value(e, at, mpmath)
    except (ZeroDivisionError, ValueError, OverflowError):
        return None
    return value if mpmath.isfinite(value) and abs(value) < mpmath.mpf(10) ** 40 else None


def _value(e: Expr, at: Mapping[str, Any], mpmath: Any) -> Any:
    if e.op == "number":
        return mpmath.mpf(int(e.args[0].p)) / int(e.args[0].q)
    if e.op == "symbol":
        return at[e.args[0]]
    if e.op == "pi":
        return +mpmath.pi
    values = [_value(arg, at, mpmath) for arg in e.args]
    x = values[0]
    if e.op == "+":
        return mpmath.fsum(values)
    if e.op == "*":
        return mpmath.fprod(values)
    if e.op == "^":
        whole = e.args[1].op == "number" and e.args[1].args[0].q == 1
        return _real(x ** (int(e.args[1].args[0].p) if whole else values[1]), mpmath)
    if e.op == "abs":
        return abs(x)
    if e.op == "cbrt":
        return mpmath.sign(x) * mpmath.cbrt(abs(x))
    if e.op == "sign" and x == 0:
        raise ZeroDivisionError
    return _real(getattr(mpmath, e.op)(x), mpmath)


def _real(x: Any, mpmath: Any) -> Any:
    if not isinstance(x, mpmath.mpf):
        raise ValueError("not real")
    return x
