"""The tables of quoted theorems against quadrature, partial sums and differential equations."""

from typing import Any

import mpmath
import pytest
import sympy
from flint import fmpq

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.power_series import decide_power_series
from tresym.reals.decisions.theorems import POWER_SERIES, TABLES, Theorem
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.verdict import Verdict

ENTRIES = [(key, row) for key, table in TABLES.items() for row in table]


@pytest.mark.parametrize(("key", "row"), ENTRIES, ids=lambda e: str(e)[:60])
@pytest.mark.slow
def test_the_tables_against_quadrature_and_partial_sums(key: str, row: Theorem) -> None:
    f, value = parse(row.body), parse(row.value)
    given = Given.parse(row.given) if row.given else Given()
    for at in ({"a": "3/4", "b": "1/2"}, {"a": "3/2", "b": "1/2"}, {"a": "5", "b": "1/2"}):
        point = {sympy.Symbol(n, real=True): sympy.Rational(v) for n, v in at.items()}
        exact = {n: fmpq(*map(int, v.split("/"))) for n, v in at.items()}
        whole = not key.endswith("a - 1") or exact["a"].q == 1
        slow = row.body == "1/n**a" and exact["a"] < 2
        if whole and not slow and all(c.holds(exact) for c in given.conditions):
            break
    else:
        raise AssertionError("no values of the parameters")
    wanted = mpmath.mpf(sympy.N(to_sympy(value).subs(point), 20))
    t = sympy.Symbol("t" if key.startswith("integral") else "n", real=True)
    g = sympy.lambdify(t, to_sympy(f).subs(point), "mpmath")
    kind, low, high = key.split(" ", 2)
    if kind == "integral":
        a = mpmath.mpf(sympy.Rational(at["a"]).p) / sympy.Rational(at["a"]).q
        b = mpmath.mpf(1) / 2
        assert abs(_integral(g, high, row.body, a, b) - wanted) < 1e-4
    else:
        ends = [
            mpmath.mpf({"oo": "inf", "-oo": "-inf", "a - 1": "4"}.get(e, e)) for e in (low, high)
        ]
        found = (mpmath.nsum if kind == "sum" else mpmath.nprod)(g, ends)
        assert abs(found - wanted) < 1e-4


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
    if text.startswith("besselj"):
        return mpmath.quadosc(g, [0, mpmath.inf], omega=b)
    if text in ("t**(a - 1)*sin(t)", "t**(a - 1)*cos(t)"):
        return mpmath.quad(g, [0, 1]) + mpmath.quadosc(g, [1, mpmath.inf], omega=1)
    if any(name in text for name in ("besselj", "besselk", "airyai", "erfc", "expint")):
        return mpmath.quad(g, [0, 1, 4, 10, 40])
    if "cosh(t))" in text and text.startswith("exp"):
        return mpmath.quad(g, [0, 1, 3, 6])
    return mpmath.quad(g, [0, 1]) + mpmath.quad(lambda u: g(1 / u) / u**2, [0, 0.1, 1])


def g_mean(text: str) -> float:
    """What the numerator is in the mean."""
    return 1.0 if text.startswith("(1") else 0.5


@pytest.mark.parametrize(("term", "function"), POWER_SERIES)
def test_a_power_series_in_the_table_is_one(term: str, function: str) -> None:
    """By its differential equation."""
    statement = read(f"{function} == sum({term}, k, 0, oo) given abs(y) < 1/2")
    claim = statement.comparisons[0]
    assert decide_power_series(claim.left, claim.right, statement.given).verdict is Verdict.PROVED
