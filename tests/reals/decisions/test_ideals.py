"""Consequences of polynomial equations: each relation of a function is used, none too many."""

import pytest
from cases import cases

from tresym.reals.decisions.ideals import follows, numerator_factors
from tresym.reals.language.parsing import parse

FOLLOWS = cases(__file__, "FOLLOWS")
DOES_NOT = cases(__file__, "DOES_NOT")


def _follows(claim: str, equations: str, *nonzero: str) -> bool:
    zero = [parse(text) for text in equations.split(";") if text]
    return follows(parse(claim), zero, [parse(text) for text in nonzero], vanishes=True)


@pytest.mark.parametrize(("claim", "equations"), FOLLOWS)
def test_what_follows_from_equations(claim: str, equations: str) -> None:
    assert _follows(claim, equations)


@pytest.mark.parametrize(("claim", "equations"), DOES_NOT)
def test_what_does_not_follow(claim: str, equations: str) -> None:
    assert not _follows(claim, equations)


def test_what_is_not_zero_counts() -> None:
    assert _follows("x - y", "x*z - y*z", "z")
    assert follows(parse("x"), [parse("x*y - 1")], [], vanishes=False)
    assert not follows(parse("x"), [parse("x*y")], [], vanishes=False)


def test_factors_of_a_numerator() -> None:
    factors = numerator_factors(parse("x/y - y/x"))
    assert factors is not None
    assert sorted(map(str, factors)) == ["x + y", "x - y"]
