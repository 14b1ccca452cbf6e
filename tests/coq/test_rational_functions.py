"""Rational functions of names that are bound by one equation each."""

import pytest

from tresym.coq.rational_functions import Quotients
from tresym.reals.language.expression import symbol
from tresym.reals.language.parsing import parse


def bound() -> Quotients:
    """With a sine s of cosine c, and g the root of 1 + x²."""
    found = Quotients()
    found.powers = {"s": (2, parse("1 - c**2")), "g": (2, parse("1 + x**2"))}
    return found


@pytest.mark.parametrize(
    ("written", "lowest"),
    [
        ("(x**2 + x)/(x + 1)", "x"),
        ("(g - 1)*(g + 1)/x", "x"),
        ("s**2 + c**2", "1"),
        ("(y - pi)/(2*y - 2*pi)", "1/2"),
        ("x - x", "0"),
    ],
)
def test_lowest_terms(written: str, lowest: str) -> None:
    assert bound().canonical(parse(written)) == parse(lowest)


def test_a_cosine_beside_its_opposite_is_a_sine() -> None:
    _, factors = bound().factors(parse("(1 - c)*(1 + c)*c**2"))
    assert dict(factors) == {symbol("s"): 2, symbol("c"): 2}


def test_a_sum_of_bases() -> None:
    parts = dict(bound().parts(parse("pi/2 + 3*x/4 - 2/y")))
    assert {str(base): str(c) for base, c in parts.items()} == {
        "pi": "1/2",
        "x": "3/4",
        "1/y": "-2",
    }


def test_what_is_too_long_stays_as_it_is() -> None:
    e = parse("(a + b + c + d + f + g)**9")
    assert bound().canonical(e) == e
