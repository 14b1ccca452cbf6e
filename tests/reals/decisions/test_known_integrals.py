"""Standard integrals: the table against quadrature, and what is near to it and false."""

from __future__ import annotations

from typing import Any

import mpmath
import pytest
import sympy
from flint import fmpq
from in_sympy import to_sympy

import tresym
from tresym.reals.decisions.known_integrals import TABLES, Standard, standard
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import PI, ZERO
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

ENTRIES = [(end, entry) for end, table in TABLES.items() for entry in table]
HOLD = [
    "integral(sin(m*x)*sin(n*x), x, 0, pi) == 0 given n integer, n >= 1, m integer, m > n",
    "integral(sin(m*x)*cos(n*x), x, 0, 2*pi) == 0 given n integer, n >= 1, m integer, m > n",
    "integral(sin(m*x)/x, x, 0, oo) == pi/2 given m > 0",
    "integral(sin(m*x)/x, x, 0, oo) == -pi/2 given m < 0",
    "integral(exp(-x**2), x, -oo, oo) == sqrt(pi)",
    "integral(cos(a*x)/(x**2 + b**2), x, 0, oo) == pi/(2*b)*exp(-a*b) given a > 0, b > 0",
    "integral(1/(a + b*cos(x)), x, 0, pi) == pi/sqrt(a**2 - b**2) given a > b, b > 0",
    "integral(1/(2 + cos(x)), x, 0, 2*pi) == 2*pi/sqrt(3)",
    "integral(1/(1 + x**4), x, 0, oo) == pi/(2*sqrt(2))",
    "integral((sin(x)/x)**2, x, 0, oo) == pi/2",
    "integral(2*x*log(x)/(1 - x**2), x, 0, 1) == -pi**2/12",
    "integral(exp(-2*x)*sin(3*x)/x, x, 0, oo) == atan(3/2)",
    "asin(x) == integral(1/sqrt(1 - t**2), t, 0, x) given -1 <= x <= 1",
    "acosh(x) == integral(1/sqrt(t**2 - 1), t, 1, x) given x >= 1",
]
FALSE = [
    "integral(sin(m*x)*sin(n*x), x, 0, pi) == 0 given n integer, n >= 1, m integer, m >= 1",
    "integral(cos(m*x)*cos(n*x), x, 0, pi) == pi/2 given n integer, n >= 1, m integer, m > n",
    "integral(sin(m*x)/x, x, 0, oo) == pi given m > 0",
    "integral(sin(m*x)/x, x, 0, oo) == pi/2 given m < 0",
    "integral(sin(m*x)/x, x, 0, oo) == m*pi/2 given m > 0",
    "integral(exp(-x**2), x, -oo, oo) == sqrt(pi)/2",
    "integral(exp(-a*x**2), x, 0, oo) == sqrt(pi)/(2*a) given a > 0",
    "integral(cos(a*x)/(x**2 + b**2), x, 0, oo) == pi/2*exp(-a*b) given a > 0, b > 0",
    "integral(log(x)/(1 - x), x, 0, 1) == pi**2/6",
    "integral(log(x)/(1 + x), x, 0, 1) == -pi**2/6",
    "integral(asin(x)/x, x, 0, 1) == pi/4*log(2)",
    "integral(x/sinh(x), x, 0, oo) == pi**2/2",
    "integral(x/(exp(x) - 1), x, 0, oo) == pi**2/12",
    "integral(log(sin(x)), x, 0, pi/2) == pi/2*log(2)",
    "integral(log(sin(x)), x, 0, pi) == -pi/2*log(2)",
    "integral(1/(a + b*cos(x)), x, 0, pi) == 2*pi/sqrt(a**2 - b**2) given a > b, b > 0",
    "integral((exp(-a*x) - exp(-b*x))/x, x, 0, oo) == log(a/b) given a > 0, b > 0",
    "integral(sin(x**2), x, 0, oo) == sqrt(pi/2)",
    "integral(x**(a - 1)/(1 + x), x, 0, oo) == pi*sin(pi*a) given 0 < a < 1",
    "asin(x) == integral(1/sqrt(1 + t**2), t, 0, x) given -1 <= x <= 1",
    "asinh(x) == integral(1/sqrt(t**2 - 1), t, 1, x) given x >= 1",
]


@pytest.mark.parametrize(("end", "entry"), ENTRIES, ids=lambda e: str(e)[:60])
def test_the_table_against_quadrature(end: str, entry: Standard) -> None:
    f, value = parse(entry.integrand), parse(entry.value)
    given = Given.parse(entry.given) if entry.given else Given()
    for at in ({"a": "3/4", "b": "1/2"}, {"a": "3/2", "b": "1/2"}):
        point = {sympy.Symbol(n, real=True): sympy.Rational(v) for n, v in at.items()}
        exact = {n: fmpq(*map(int, v.split("/"))) for n, v in at.items()}
        if all(c.holds(exact) for c in given.conditions):
            break
    else:
        raise AssertionError("no values of the parameters")
    wanted = mpmath.mpf(sympy.N(to_sympy(value).subs(point), 20))
    t = sympy.Symbol("t", real=True)
    g = sympy.lambdify(t, to_sympy(f).subs(point), "mpmath")
    a = mpmath.mpf(sympy.Rational(at["a"]).p) / sympy.Rational(at["a"]).q
    b = mpmath.mpf(1) / 2
    assert abs(_integral(g, end, entry.integrand, a, b) - wanted) < 1e-4


def _integral(g: Any, end: str, text: str, a: Any, b: Any) -> Any:
    """By mpmath, and for what oscillates by its own methods."""
    if end != "oo":
        top = mpmath.mpf(sympy.N(sympy.sympify(end), 20))
        return mpmath.quad(g, [0, top / 2, top])
    if "t**2)" in text and text[:3] in ("sin", "cos"):
        wave = mpmath.sin if text[:3] == "sin" else mpmath.cos
        far = mpmath.quadosc(lambda u: wave(a * u) / (2 * mpmath.sqrt(u)), [9, mpmath.inf], omega=a)
        return mpmath.quad(g, [0, 1, 2, 3]) + far
    if text.startswith("(cos"):
        far = mpmath.ci(b * 20) - mpmath.ci(a * 20)
        return mpmath.quad(g, mpmath.linspace(0, 20, 9)) + far
    if text.startswith(("(1 - cos", "sin(a*t)**2")):
        far = mpmath.quadosc(lambda u: g(u) - g_mean(text) / u**2, [20, mpmath.inf], omega=2 * a)
        return mpmath.quad(g, mpmath.linspace(0, 20, 9)) + far + g_mean(text) / 20
    if text in ("sin(a*t)/t", "cos(a*t)/(t**2 + b**2)", "t*sin(a*t)/(t**2 + b**2)"):
        return mpmath.quadosc(g, [0, mpmath.inf], omega=a)
    return mpmath.quad(g, [0, 1]) + mpmath.quad(lambda u: g(1 / u) / u**2, [0, 0.1, 1])


def g_mean(text: str) -> float:
    """What the numerator is in the mean."""
    return 1.0 if text.startswith("(1") else 0.5


@pytest.mark.parametrize("claim", HOLD)
def test_integrals_that_hold(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", FALSE)
def test_integrals_that_are_false(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


def test_a_theorem_has_its_conditions() -> None:
    f, g = parse("1/(a + b*cos(x))"), parse("sin(a*x)/x")
    for conditions in ("b > a, a > 0", "a > 0", "b > 0"):
        assert standard(f, "x", ZERO, PI, Given.parse(conditions)) is None
    assert standard(f, "x", ZERO, PI, Given.parse("a > b, b > 0")) is not None
    assert standard(g, "x", ZERO, INFINITY, Given()) is None
    assert standard(g, "x", ZERO, PI, Given.parse("a > 0")) is None
    assert standard(parse("sin(a*x)/(x + 1)"), "x", ZERO, INFINITY, Given.parse("a > 0")) is None
