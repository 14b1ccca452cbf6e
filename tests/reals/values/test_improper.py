"""Integrals with singular or infinite ends, against closed forms that mpmath evaluates."""

import mpmath
import pytest
from cases import cases
from flint import arb

from tresym.reals.domain.binder_values import enclosing
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.arithmetic import ball_precision, mp_precision
from tresym.reals.values.growth import DivergesError
from tresym.reals.values.improper import integral

KNOWN = tuple(cases(__file__, "KNOWN"))


def value(text: str) -> arb:
    with ball_precision(210):
        return integral(as_written(f"integral({text})"), enclosing({}, {"integral": integral}))


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
    cases(__file__, "a_divergent_integral_is_told_apart"),
)
def test_a_divergent_integral_is_told_apart(text: str) -> None:
    with pytest.raises(DivergesError):
        value(text)


@pytest.mark.parametrize(
    "text",
    cases(__file__, "what_has_no_value_gets_none"),
)
def test_what_has_no_value_gets_none(text: str) -> None:
    with pytest.raises(UndefinedError):
        value(text)
