"""Sums, products and series, against closed forms that mpmath evaluates."""

import mpmath
import pytest
from flint import arb

from tresym.reals.domain.binder_values import Enclosing
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.values.growth import DivergesError
from tresym.reals.values.improper import integral
from tresym.reals.values.totals import total

KNOWN = (
    ("sum(1/factorial(k), k, 0, oo)", "e"),
    ("sum(1/k**2, k, 1, oo)", "pi**2/6"),
    ("sum((-1)**k/(2*k + 1), k, 0, oo)", "pi/4"),
    ("sum(2**k/factorial(2*k), k, 0, oo)", "cosh(sqrt(2))"),
    ("sum(1/k, k, 1, 1000)", "digamma(1001) + euler"),
    ("sum(k**2/2**k, k, 0, oo)", "mpf(6)"),
    ("sum(1/(k**2 + 1), k, 0, oo)", "(1 + pi*coth(pi))/2"),
    ("sum(log(k)/k**2, k, 1, oo)", "-zeta(2, derivative=1)"),
    ("sum(1/k**(3/2), k, 1, oo)", "zeta(mpf(3)/2)"),
    ("product(1 + 1/k**2, k, 1, oo)", "sinh(pi)/pi"),
    ("product(k, k, 1, 30)", "fac(30)"),
    ("sum((-1)**(k + 1)/k, k, 1, oo)", "log(2)"),
    ("sum((-1)**k/sqrt(k + 1), k, 0, oo)", "altzeta(mpf(1)/2)"),
    ("sum(factorial(2*k)/(factorial(k)**2*16**k*(2*k + 1)), k, 0, oo)", "pi/3"),
    ("sum((-1/4)**k/factorial(k)**2, k, 0, oo)", "besselj(0, 1)"),
    ("sum(1/(k*(k + 1)*(k + 2)), k, 1, oo)", "mpf(1)/4"),
    ("sum((-1)**k/(k**2 + 1), k, 1, oo)", "(pi/sinh(pi) - 1)/2"),
    ("sum(log(1 + 1/k) - 1/k, k, 1, oo)", "-euler"),
    ("sum(exp(-k**2), k, -3, oo)", "(1 + jtheta(3, 0, exp(-1)))/2 + exp(-1) + exp(-4) + exp(-9)"),
    ("sum((-2)**k, k, 0, 5)", "mpf(-21)"),
    ("sum(k, k, 3, 2)", "mpf(0)"),
)


def value(text: str) -> arb:
    own = {"integral": integral, "sum": total, "product": total}
    with ball_precision(210):
        return Enclosing({}, own=own).value(as_written(text))


@pytest.mark.parametrize(("text", "closed"), KNOWN)
def test_a_sum_is_its_closed_form(text: str, closed: str) -> None:
    with mp_precision(80) as mp:
        names = {name: getattr(mp, name) for name in dir(mp) if not name.startswith("_")}
        truth = mpmath.nstr(eval(closed, names), 75)
    found = value(text)
    with ball_precision(300):
        near = arb(truth) + arb(0, abs(arb(truth)) * arb("1e-74"))
        assert found.overlaps(near)
    assert found.is_zero() or found.rel_accuracy_bits() > 166


@pytest.mark.parametrize(
    "text",
    [
        "sum(1/k, k, 1, oo)",
        "sum(2**k, k, 0, oo)",
        "sum((-1)**k*(1 + 1/(k + 1)), k, 0, oo)",  # its pairs of terms have a finite sum
        "sum(1/sqrt(k), k, 1, oo)",
        "sum(factorial(k)/100**k, k, 0, oo)",
        "product(1 + 1/k, k, 1, oo)",
    ],
)
def test_a_divergent_series_is_told_apart(text: str) -> None:
    with pytest.raises(DivergesError):
        value(text)


@pytest.mark.parametrize("text", ["sum(1/k**2, k, -1, oo)", "sum(sin(k), k, 1, oo)"])
def test_what_has_no_value_gets_none(text: str) -> None:
    with pytest.raises(UndefinedError):
        value(text)


@pytest.mark.parametrize("text", ["sum(k, k, 1, 3/2)", "sum(k, k, 1, 10**9)"])
def test_what_is_no_sum_is_refused(text: str) -> None:
    with pytest.raises(InputError):
        value(text)
