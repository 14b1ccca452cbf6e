"""Consequences of polynomial equations: each relation of a function is used, none too many."""

import pytest

from tresym.reals.decisions.ideals import follows, numerator_factors
from tresym.reals.language.parsing import parse

FOLLOWS = [
    ("x**5 + 1/x**5 - 123", "x + 1/x - 3"),
    ("x", "x**3"),  # in the radical alone
    ("sin(x + y)", "sin(x); sin(y)"),
    ("cos(x + pi/2) + sin(x)", ""),
    ("cos(3*x) - 4*cos(x)**3 + 3*cos(x)", ""),
    ("cosh(x)**2 - 25/16", "exp(x) - 2"),
    ("sqrt(x)**4 - 9", "x - 3"),
    ("x**n*y - 2*x**n", "y - 2"),  # a power that stands for itself
    ("abs(x)**2 - 9", "x**2 - 9"),
    ("a/b - c/d", "a*d - b*c"),  # saturated by b and d
]
DOES_NOT = [
    ("x - y", "x**2 - y**2"),
    ("x - y", "x*z - y*z"),
    ("cos(x) - 1", "sin(x)"),
    ("abs(x) - x", "x**2 - 9"),
    ("sqrt(x) - y", "x - y**2"),
    ("sin(x) - sin(y)", "cos(x) - cos(y)"),
    ("sin(x/2)", "sin(x)"),
    ("f - 1", "f/(x - x) - 1"),  # a denominator that vanishes everywhere
    ("exp(x) - exp(y)", "exp(2*x) - exp(2*y) + 1"),
]


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
