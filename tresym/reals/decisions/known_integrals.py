"""Definite integrals whose values are quoted theorems, with sources.

An integrand matches an entry if one exact identity proves it and the conditions of the entry are
proved for its parameters, whose candidates are the coefficients of the integrand. Numbers refer to
I. S. Gradshteyn and I. M. Ryzhik, *Table of Integrals, Series, and Products*, 7th edition; the
tests compare each with quadrature.
"""

from __future__ import annotations

from itertools import product
from typing import NamedTuple

from flint import fmpq

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import preorder
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    multiply,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict


class Standard(NamedTuple):
    """``∫ integrand dt`` over the interval is ``value`` under the conditions."""

    integrand: str
    value: str
    given: str
    source: str


LINE = (
    Standard("sin(a*t)/t", "pi/2", "a > 0", "3.721.1"),
    Standard("sin(a*t)**2/t**2", "pi*a/2", "a > 0", "3.821.9"),
    Standard("(1 - cos(a*t))/t**2", "pi*a/2", "a > 0", "3.782.2"),
    Standard("cos(a*t)/(t**2 + b**2)", "pi*exp(-a*b)/(2*b)", "a >= 0, b > 0", "3.723.2"),
    Standard("t*sin(a*t)/(t**2 + b**2)", "pi*exp(-a*b)/2", "a > 0, b > 0", "3.723.3"),
    Standard("exp(-a*t**2)", "sqrt(pi/a)/2", "a > 0", "3.321.3"),
    Standard("t**2*exp(-a*t**2)", "sqrt(pi/a)/(4*a)", "a > 0", "3.461.2"),
    Standard("exp(-a*t**2)*cos(b*t)", "sqrt(pi/a)*exp(-b**2/(4*a))/2", "a > 0", "3.896.4"),
    Standard("exp(-a*t)/sqrt(t)", "sqrt(pi/a)", "a > 0", "3.361.2"),
    Standard("sin(a*t**2)", "sqrt(pi/(2*a))/2", "a > 0", "3.691.1"),
    Standard("cos(a*t**2)", "sqrt(pi/(2*a))/2", "a > 0", "3.691.1"),
    Standard("exp(-a*t)*sin(b*t)/t", "atan(b/a)", "a > 0", "3.941.1"),
    Standard("(exp(-a*t) - exp(-b*t))/t", "log(b/a)", "a > 0, b > 0", "3.434.2"),
    Standard("(cos(a*t) - cos(b*t))/t", "log(b/a)", "a > 0, b > 0", "3.784.1"),
    Standard("t/sinh(a*t)", "pi**2/(4*a**2)", "a > 0", "3.521.1"),
    Standard("t/(exp(a*t) - 1)", "pi**2/(6*a**2)", "a > 0", "3.411.1"),
    Standard("t/(exp(a*t) + 1)", "pi**2/(12*a**2)", "a > 0", "3.411.3"),
    Standard("t**3/(exp(a*t) - 1)", "pi**4/(15*a**4)", "a > 0", "3.411.1"),
    Standard("t**3/(exp(a*t) + 1)", "7*pi**4/(120*a**4)", "a > 0", "3.411.3"),
    Standard("log(1 - exp(-a*t))", "-pi**2/(6*a)", "a > 0", "4.223.2"),
    Standard("log(1 + exp(-a*t))", "pi**2/(12*a)", "a > 0", "4.223.1"),
    Standard("sin(a*t)/sinh(b*t)", "pi*tanh(pi*a/(2*b))/(2*b)", "b > 0", "3.981.1"),
    Standard("cos(a*t)/cosh(b*t)", "pi*sech(pi*a/(2*b))/(2*b)", "b > 0", "3.981.3"),
    Standard("log(t)/(t**2 + b**2)", "pi*log(b)/(2*b)", "b > 0", "4.231.8"),
    Standard("t**(a - 1)/(1 + t)", "pi*csc(pi*a)", "0 < a, a < 1", "3.222.2"),
    Standard("1/(1 + t**a)", "pi/a*csc(pi/a)", "a > 1", "3.241.2"),
    Standard("log(1 + a**2/t**2)", "pi*a", "a > 0", "4.222.1"),
)
UNIT = (
    Standard("log(t)/(1 - t)", "-pi**2/6", "", "4.231.2"),
    Standard("log(t)/(1 + t)", "-pi**2/12", "", "4.231.1"),
    Standard("log(t)/(1 - t**2)", "-pi**2/8", "", "4.231.13"),
    Standard("t*log(t)/(1 - t**2)", "-pi**2/24", "", "4.231.14"),
    Standard("log(t)/sqrt(1 - t**2)", "-pi*log(2)/2", "", "4.241.7"),
    Standard("log(1 + t)/t", "pi**2/12", "", "4.291.1"),
    Standard("log(1 - t)/t", "-pi**2/6", "", "4.291.2"),
    Standard("log(1 + t)/(1 + t**2)", "pi*log(2)/8", "", "4.291.8"),
    Standard("log((1 + t)/(1 - t))/t", "pi**2/4", "", "4.291.1 and 4.291.2"),
    Standard("log(t)*log(1 - t)", "2 - pi**2/6", "", "4.221.1"),
    Standard("log(t)*log(1 + t)", "2 - 2*log(2) - pi**2/12", "", "4.221.2"),
    Standard("asin(t)/t", "pi*log(2)/2", "", "4.521.1"),
    Standard("(t**a - t**b)/log(t)", "log((a + 1)/(b + 1))", "a > -1, b > -1", "4.267.8"),
)
QUARTER = (
    Standard("log(sin(t))", "-pi*log(2)/2", "", "4.224.3"),
    Standard("log(cos(t))", "-pi*log(2)/2", "", "4.224.6"),
    Standard("log(tan(t))", "0", "", "4.224.3 and 4.224.6"),
    Standard("log(2*sin(t))", "0", "", "4.224.3"),
    Standard("log(2*cos(t))", "0", "", "4.224.6"),
    Standard("t*cot(t)", "pi*log(2)/2", "", "3.747.7"),
    Standard("t**2/sin(t)**2", "pi*log(2)", "", "3.837.1"),
    Standard("1/(a**2*cos(t)**2 + b**2*sin(t)**2)", "pi/(2*a*b)", "a > 0, b > 0", "3.642.1"),
    Standard("sqrt(tan(t))", "pi/sqrt(2)", "", "3.622.1"),
)
HALF = (
    Standard("log(sin(t))", "-pi*log(2)", "", "4.224.3"),
    Standard("t*sin(t)/(1 + cos(t)**2)", "pi**2/4", "", "3.79"),
    Standard("t*log(sin(t))", "-pi**2*log(2)/2", "", "4.322.1"),
    Standard("1/(a + b*cos(t))", "pi/sqrt(a**2 - b**2)", "a > 0, a > abs(b)", "3.613.1"),
    Standard("1/(a + b*cos(t))**2", "pi*a/(a**2 - b**2)**(3/2)", "a > abs(b), a > 0", "3.661.4"),
    Standard(
        "log(a + b*cos(t))", "pi*log((a + sqrt(a**2 - b**2))/2)", "a > 0, a > abs(b)", "4.224.9"
    ),
    Standard("log(1 - 2*a*cos(t) + a**2)", "0", "-1 < a, a < 1", "4.224.14"),
    Standard("log(1 - 2*a*cos(t) + a**2)", "2*pi*log(a)", "a > 1", "4.224.14"),
)
WHOLE = (
    Standard("1/(a + b*cos(t))", "2*pi/sqrt(a**2 - b**2)", "a > 0, a > abs(b)", "3.613.1"),
    Standard("1/(a + b*sin(t))", "2*pi/sqrt(a**2 - b**2)", "a > 0, a > abs(b)", "3.613.1"),
)
EIGHTH = (Standard("log(1 + tan(t))", "pi*log(2)/8", "", "4.227.9"),)
TABLES = {
    "oo": LINE,
    "1": UNIT,
    "pi/2": QUARTER,
    "pi": HALF,
    "2*pi": WHOLE,
    "pi/4": EIGHTH,
}
"""The theorems by the upper end of the interval, which begins at 0."""
T, CANDIDATES = "t", 10


class Known(NamedTuple):
    """The value of an integral, and the theorem that states it."""

    value: Expr
    source: str


def standard(f: Expr, name: str, low: Expr, high: Expr, given: Given) -> Known | None:
    """Return the value of an integral, or None if it is not in the table.

    Args:
        given: the conditions on the parameters.
    """
    if not elementary(f):
        return None
    if low == -INFINITY and high == INFINITY:
        mirrored = substitute(f, {name: -symbol(name)})
        even = decide(f, mirrored, given).verdict is Verdict.PROVED
        half = standard(f, name, ZERO, high, given) if even else None
        return None if half is None else half._replace(value=2 * half.value)
    if low != ZERO or str(high) not in TABLES or T in symbols(f) - {name}:
        return None
    f = substitute(f, {name: symbol(T)})
    upper = () if high == INFINITY else ((symbol(T), "<", high),)
    inside = given & Given(((symbol(T), ">", ZERO), *upper))
    found = _parameters(f)
    try:
        for theorem in TABLES[str(high)]:
            pattern = parse(theorem.integrand)
            names = sorted(symbols(pattern) - {T})
            for values in product(found, repeat=len(names)):
                at = dict(zip(names, values, strict=True))
                c = _factor(f, substitute(pattern, at), inside)
                if c is not None and _hold(theorem.given, at, given):
                    value = c * substitute(parse(theorem.value), at)
                    return Known(value, f"Gradshteyn and Ryzhik {theorem.source}")
    except InputError:
        return None
    return None


def _factor(f: Expr, pattern: Expr, inside: Given) -> Expr | None:
    """c where f is c times the pattern, and c is free of t."""
    ratio = f / pattern
    names = symbols(ratio)
    point = next(inside.points(names, 1), None)
    if point is None:
        return None
    with ball_precision():
        values = [evaluate(ratio, point | {T: point[T] * fmpq(k, 7)}) for k in (7, 5, 3)]
    if not all(v.is_finite() and v.overlaps(values[0]) for v in values):
        return None
    c = in_lowest_terms(ratio)
    if T in symbols(c):
        with ball_precision():
            whole = (values[0] * 5040).unique_fmpz()
        if whole is None:
            return None
        c = number(fmpq(int(whole), 5040))
    return c if decide(f, c * pattern, inside).verdict is Verdict.PROVED else None


def _hold(conditions: str, at: dict[str, Expr], given: Given) -> bool:
    """Whether the conditions of a theorem are proved of its parameters."""
    for left, relation, right in parse_given(conditions):
        if relation in ("<", "<="):
            left, right, relation = right, left, relation.replace("<", ">")
        gap = substitute(left - right, at)
        if sign(gap, given, relation) not in PROVING[relation]:
            return False
    return True


def _parameters(f: Expr) -> list[Expr]:
    """What the parameters of a theorem may be: coefficients of t, of t², and what is without it."""
    found: dict[Expr, None] = {}
    for e in preorder(f):
        if T not in symbols(e):
            continue
        try:
            slope = differentiate(e, T)
            bend = differentiate(slope, T)
            linear = T not in symbols(bend)
            for c in (substitute(slope, {T: ZERO}), bend / 2) if linear else ():
                found |= {in_lowest_terms(c): None}
            if e.op == "+":
                rest = add(*(arg for arg in e.args if T not in symbols(arg)))
                found |= {c: None for c in (rest, _root(rest)) if c is not None}
                found |= {_scale(arg): None for arg in e.args if T in symbols(arg)}
            if e.op == "^":
                found |= {e.args[1]: None, in_lowest_terms(e.args[1] + 1): None}
        except InputError:
            continue
    names = [symbol(name) for name in sorted(symbols(f) - {T})]
    small = [c for c in found if c != ZERO and T not in symbols(c) and c not in names]
    signed = [*names, *small, ONE, *(-c for c in (*names, *small))]
    return list(dict.fromkeys(signed))[:CANDIDATES]


def _scale(e: Expr) -> Expr:
    """The factors without t."""
    return multiply(*(f for f in (e.args if e.op == "*" else (e,)) if T not in symbols(f)))


def _root(e: Expr) -> Expr | None:
    """The base of a square, or the root of a number."""
    if e.op == "^" and e.args[1] == number(2):
        return e.args[0]
    return sqrt(e) if e.op == "number" and e.args[0] > 0 else None
