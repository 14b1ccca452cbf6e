"""Exact places of equality, and that none is found where there is none."""

import pytest
from cases import cases
from flint import fmpq

import tresym
from tresym.reals.decisions.algebraic_witnesses import (
    equal_at_algebraic,
    equal_at_simple,
)
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.quick


@pytest.mark.parametrize(
    ("left", "given", "found"),
    cases(__file__, "zeros_of_polynomials"),
)
def test_zeros_of_polynomials(left: str, given: str, found: bool) -> None:
    answer = equal_at_algebraic(parse(left), parse("0"), Given.parse(given))
    assert (answer is not None) is found


def test_a_rational_zero_is_exact() -> None:
    answer = tresym.check("x < 10**40")
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness == {"x": str(10**40)}


@pytest.mark.parametrize(
    ("right", "found"), [("3*sqrt(3)/2", True), ("3*sqrt(3)/2 + 1/10**40", False)]
)
def test_points_of_simple_constants(right: str, found: bool) -> None:
    near = {"x": fmpq(1047197551, 10**9), "y": fmpq(1047197551, 10**9)}
    left = parse("sin(x) + sin(y) + sin(x + y)")
    answer = equal_at_simple(parse(right), left, Given(), near)
    assert (answer is not None) is found
    assert equal_at_simple(parse(right), left, Given.parse("x < 1.04"), near) is None
