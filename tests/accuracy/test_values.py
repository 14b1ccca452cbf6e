"""Certified values: every digit against mpmath, and one clear line for what has no value."""

from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

import tresym
from tresym.accuracy.values import rounded

KNOWN = (
    ("root(y - e*sin(y) - M, y, 0, pi)", {"e": "1/2", "M": 1}, None),
    ("integral(exp(-x*t)/(1 + t), t, 0, oo)", {"x": "1/10"}, "exp(x)*e1(x)"),
    ("2*integral(1/sqrt(1 - k**2*sin(t)**2), t, 0, pi/2)/pi", {"k": "9/10"}, "2*ellipk(k**2)/pi"),
    ("root(y*exp(y) - x, y, 0, oo)", {"x": 3}, "lambertw(x)"),
    ("sum(1/k**s, k, 1, oo)", {"s": 3}, "zeta(s)"),
    ("sin(x) - x", {"x": "1e-30"}, "sin(x) - x"),
    ("diff(atan(x)**2, x)", {"x": "1/3"}, "2*atan(x)/(1 + x**2)"),
    ("x**2", {"x": "sqrt(2)"}, "mpf(2)"),
    ("exp(-x)", {"x": 1000}, "exp(-x)"),
    ("root(integral(exp(-t**2), t, 0, y) - 1/2, y, 0, 2)", {}, "erfinv(1/sqrt(pi))"),
    ("factorial(n)/n**n", {"n": 30}, "fac(n)/n**n"),
    ("integral(x**a*(1 - x)**b, x, 0, 1)", {"a": "-1/2", "b": "1/3"}, "beta(1 + a, 1 + b)"),
)


@pytest.mark.parametrize(("text", "at", "closed"), KNOWN)
def test_every_digit_is_right(text: str, at: dict[str, str | int], closed: str | None) -> None:
    found = tresym.value(text, **at)
    with mpmath.workdps(140):
        names = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")}
        names |= {n: mpmath.mpf(Fraction(x).numerator) / Fraction(x).denominator
                  for n, x in at.items() if not str(x).startswith("sqrt")}  # fmt: skip
        if closed is None:
            truth = mpmath.findroot(lambda y: y - mpmath.sin(y) / 2 - 1, 1.5)
        else:
            truth = eval(closed, names)
        shown = mpmath.mpf(found.text)
        last = mpmath.mpf(10) ** (mpmath.floor(mpmath.log10(abs(truth))) - 49)
        assert abs(shown - truth) <= last * mpmath.mpf("0.5000001")
        ball = mpmath.mpf(found.ball.mid), mpmath.mpf(found.ball.rad)
        assert abs(ball[0] - truth) <= ball[1] <= abs(truth) * mpmath.mpf(10) ** -50


@pytest.mark.parametrize(
    ("text", "at", "why"),
    [
        ("root(y**2 - 2, y, -2, 2)", {}, "at least 2 zeros"),
        ("root(y**2 + 1, y, -2, 2)", {}, "no zero was found"),
        ("root(log(y - 9), y, 0, 1)", {}, "no values"),
        ("integral(1/x, x, 0, 1)", {}, "diverges"),
        ("integral(exp(x), x, 0, oo)", {}, "diverges"),
        ("integral(1/x, x, -1, 1)", {}, "diverges"),
        ("sum(1/k, k, 1, oo)", {}, "the series .* diverges"),
        ("log(x)", {"x": -1}, "no real value"),
        ("x", {"x": 0.5}, "not exact"),
        ("x + y", {"x": 1}, "give the value of y"),
        ("f(3)", {}, "unknown function"),
        ("x +", {"x": 1}, "not an expression"),
        ("factorial(1/2)", {}, "no value"),
        ("x", {"x": "1e99999"}, "exponent"),
    ],
)
def test_what_has_no_value_gets_one_line(text: str, at: dict[str, object], why: str) -> None:
    with pytest.raises(tresym.InputError, match=why) as error:
        tresym.value(text, **at)  # type: ignore[arg-type]
    assert "\n" not in str(error.value)


def test_an_exact_zero_is_told_and_a_hidden_one_is_not_made_up() -> None:
    assert tresym.value("sin(pi)").text == "0"
    assert tresym.value("sqrt(2)*sqrt(3) - sqrt(6)").text == "0"
    with pytest.raises(tresym.InputError, match="apart from 0"):
        tresym.value("integral(exp(-x**2), x, -oo, oo) - sqrt(pi)")


@given(st.fractions(), st.integers(1, 12))
def test_rounding_is_to_the_nearest_decimal(x: Fraction, digits: int) -> None:
    text = rounded(arb(fmpq(x.numerator, x.denominator)), digits)
    shown = Fraction(text)
    if x:
        assert abs(shown - x) * 2 <= Fraction(10) ** (_exponent(x) - digits + 1)
        assert len(text.split("e")[0].replace(".", "").strip("-").lstrip("0")) >= digits
    else:
        assert text == "0"


@pytest.mark.parametrize("x", ["-10000", "10000"])
def test_more_digits_than_python_writes_for_an_integer(x: str) -> None:
    """By mpmath: exp(±10000) has 4343 decimal places."""
    exact = mpmath.nstr(mpmath.exp(mpmath.mpf(x)), 10)
    assert tresym.value("exp(x)", 10, x=x).text == exact.replace("e+", "e")


def _exponent(x: Fraction) -> int:
    n = 0
    while abs(x) >= Fraction(10) ** (n + 1):
        n += 1
    while abs(x) < Fraction(10) ** n:
        n -= 1
    return n


def test_a_value_shows_itself() -> None:
    found = tresym.value("exp(x)", 10, x="1/2")
    assert repr(found) == "Value(exp(x) at x = 1/2 = 1.648721271)"
    assert float(found) == 1.648721271
    assert "1.648721271" in found._repr_html_()
    assert found._repr_latex_() == "$e^{x} = 1.648721271$"
    assert "1.648721271" in str(found)
