"""Division by positive factors, and factors whose sign is not proved."""

from __future__ import annotations

import pytest

import tresym
from tresym.reals.decisions.cleared_factors import cleared
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.verdict import Verdict


def never(_: Expr) -> bool:
    return False


def divided(text: str, conditions: str) -> Expr | None:
    return cleared(parse(text), Given(tuple(parse_given(conditions))), never)


def test_the_signs_of_factors_are_those_proved() -> None:
    assert divided("1/y + x/y", "x > 0") is None
    assert divided("b*x**2 + b*x", "b > 0, x > 0") == parse("x + 1")
    kept = divided("b*x**2 + b*x", "x > 0")
    assert kept is not None
    assert "b" in symbols(kept)
    turned = divided("b*x + b", "b < 0")
    assert turned is not None
    assert turned == -parse("x + 1") or turned == parse("-x - 1")


@pytest.mark.parametrize("text", ["1 + cos(x)", "3 + 4*cos(x) + cos(2*x)", "1 - cos(x)"])
def test_no_factor_is_undefined_where_the_difference_vanishes(text: str) -> None:
    """In tan(x/2), 1 + cos(x) is 2/(1 + tan(x/2)**2), which has no value at its zero x = pi."""
    assert cleared(parse(text), Given(), lambda _: True) is None
    assert tresym.check(f"{text} > 0").verdict is Verdict.REFUTED
