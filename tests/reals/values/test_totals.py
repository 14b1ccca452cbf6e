"""Sums, products and series, against closed forms that mpmath evaluates."""

import mpmath
import pytest
from cases import cases
from flint import arb

from tresym.reals.domain.binder_values import enclosing
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.values.growth import DivergesError
from tresym.reals.values.improper import integral
from tresym.reals.values.totals import total

KNOWN = tuple(cases(__file__, "KNOWN"))


def value(text: str) -> arb:
    rules = {"integral": integral, "sum": total, "product": total}
    with ball_precision(210):
        return enclosing({}, rules).value(as_written(text))


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
    cases(__file__, "a_divergent_series_is_told_apart"),
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
