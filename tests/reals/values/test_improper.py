"""Integrals with singular or infinite ends, against closed forms that mpmath evaluates."""

import mpmath
import pytest
from flint import arb

from tresym.reals.domain.binder_values import Enclosing
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.values.growth import DivergesError
from tresym.reals.values.improper import integral

KNOWN = (
    ("exp(-x), x, 0, oo", "1"),
    ("1/sqrt(1 - x**2), x, 0, 1", "pi/2"),
    ("1/sqrt(x*(1 - x)), x, 0, 1", "pi"),
    ("exp(-x**2), x, -oo, oo", "sqrt(pi)"),
    ("1/(1 + x**2), x, 0, oo", "pi/2"),
    ("log(x), x, 0, 1", "mpf(-1)"),
    ("x/(exp(x) - 1), x, 0, oo", "pi**2/6"),
    ("exp(-10*t)/(1 + t), t, 0, oo", "exp(10)*e1(10)"),
    ("1/sqrt(cos(x) - cos(2)), x, 0, 2", "sqrt(2)*ellipk(sin(1)**2)"),
    ("x**(-2/3)*exp(-x), x, 0, oo", "gamma(mpf(1)/3)"),
    ("1/(sqrt(x)*(1 + x)), x, 0, oo", "pi"),
    ("sech(x)**2, x, -oo, oo", "mpf(2)"),
    ("log(sin(x)), x, 0, pi/2", "-pi*log(2)/2"),
    ("1/sqrt(sin(x)), x, 0, pi/2", "gamma(mpf(1)/4)**2/(2*sqrt(2*pi))"),
    ("sqrt(tan(x)), x, 0, pi/2", "pi/sqrt(2)"),
    ("exp(-sqrt(x)), x, 0, oo", "mpf(2)"),
    ("1/(x**3 + 1), x, 0, oo", "2*pi/(3*sqrt(3))"),
    ("atan(x)/(x*(1 + x**2)), x, 0, oo", "pi*log(2)/2"),
    ("exp(-cosh(x)), x, 0, oo", "besselk(0, 1)"),
    ("1/sqrt((1 - x)*(2 - x)*(3 - x)), x, -oo, 1", "gamma(mpf(1)/4)**2/(2*sqrt(2*pi))"),
    ("log(1 + 1/x**2), x, 0, oo", "pi"),
    ("1/sqrt(abs(x)), x, -1, 1", "mpf(4)"),
    ("exp(-1/x)/x**2, x, 0, 1", "exp(-1)"),
    ("x**pi*(1 - x)**(1/3), x, 0, 1", "beta(pi + 1, mpf(4)/3)"),
    ("(exp(-x) - exp(-2*x))/x, x, 0, oo", "log(2)"),
    ("acos(x), x, 0, 1", "mpf(1)"),
    ("tanh(x) - 1, x, 0, oo", "-log(2)"),
    ("1/x**2, x, oo, 1", "mpf(-1)"),
    ("exp(x)*x**2, x, -oo, 0", "mpf(2)"),
)


def value(text: str) -> arb:
    with ball_precision(210):
        return integral(as_written(f"integral({text})"), Enclosing({}, own={"integral": integral}))


@pytest.mark.parametrize(("text", "closed"), KNOWN)
def test_an_integral_is_its_closed_form(text: str, closed: str) -> None:
    with mp_precision(80) as mp:
        names = {name: getattr(mp, name) for name in dir(mp) if not name.startswith("_")}
        truth = mpmath.nstr(eval(closed, names), 75)
    found = value(text)
    with ball_precision(300):
        assert abs(found - arb(truth)) < abs(arb(truth)) * arb("1e-49") + found.rad()
        assert found.overlaps(arb(truth))
    assert found.rel_accuracy_bits() > 166


@pytest.mark.parametrize(
    "text",
    [
        "1/x, x, 0, 1",
        "1/x, x, 1, oo",
        "1/(1 - x), x, 0, 1",
        "1/sqrt(x), x, 1, oo",
        "exp(x), x, 0, oo",
        "1/(x*sqrt(1 + x)), x, 0, 1",
        "cos(x)/(x - 3)**2, x, 0, 3",
        "1/(x*log(x)), x, 2, oo",
    ],
)
def test_a_divergent_integral_is_told_apart(text: str) -> None:
    with pytest.raises(DivergesError):
        value(text)


@pytest.mark.parametrize(
    "text",
    [
        "1/x, x, -1, 1",  # its principal value is 0
        "1/(x - 1/3)**2, x, 0, 1",
        "sqrt(-1 - x)*sqrt(-1 - x), x, 0, 1",  # undefined, although its algebra is −1 − x
        "sqrt(x - 1)**2/sqrt(x), x, 0, 1",
        "sqrt(-x)*sqrt(-x)/sqrt(x), x, 0, 1",
        "log(x)/log(x)/sqrt(x), x, -1, 1",
        "exp(-x)*sqrt(10 - x)**2, x, 0, oo",
        "tan(x), x, 0, 2",
        "sin(x)/x, x, 0, oo",  # it converges, but not absolutely
    ],
)
def test_what_has_no_value_gets_none(text: str) -> None:
    with pytest.raises(UndefinedError):
        value(text)
