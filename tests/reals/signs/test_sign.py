"""Proven signs: they hold at every point, on closed ends too, and stop where a guard says so."""

from fractions import Fraction
from itertools import product

import pytest
from cases import cases
from flint import arb
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.sign import sign

SIGNS = cases(__file__, "SIGNS")


@pytest.mark.parametrize(("text", "conditions", "expected"), SIGNS)
def test_a_sign_is_the_one_expected_and_holds_at_points(
    text: str, conditions: str, expected: str | None
) -> None:
    e, region = parse(text), Given.parse(conditions)
    assert sign(e, region) == expected
    with ball_precision(200):
        for point in region.points(["x", "y", "z"], 40):
            value = evaluate(e, {name: arb(at) for name, at in point.items()})
            assert not value.is_finite() or not _excluded(value, expected)


def _excluded(value: arb | Fraction, found: str | None) -> bool:
    """Whether a value is not of that sign."""
    return {
        "+": bool(value <= 0),
        "-": bool(value >= 0),
        ">=0": bool(value < 0),
        "<=0": bool(value > 0),
        "0": bool(value > 0 or value < 0),
    }.get(found or "", False)


ENDS = st.tuples(st.integers(-3, 3), st.integers(1, 4), st.booleans(), st.booleans())
MONOMIALS = list(product(range(3), repeat=2))


@given(st.lists(st.integers(-3, 3), min_size=9, max_size=9), ENDS, ENDS)
def test_the_sign_of_a_polynomial_holds_on_its_box(
    coefficients: list[int], in_x: tuple, in_y: tuple
) -> None:
    """At all points of a grid, in fractions: on the closed ends, and beside the open ones."""
    ends = in_x, in_y
    terms = [f"({c})*x**{i}*y**{j}" for c, (i, j) in zip(coefficients, MONOMIALS, strict=True)]
    bounds = [
        f"{low} {'<' if low_open else '<='} {name} {'<' if high_open else '<='} {low + length}"
        for name, (low, length, low_open, high_open) in zip("xy", ends, strict=True)
    ]
    found = sign(parse(" + ".join(terms)), Given.parse(", ".join(bounds)))
    tiny = Fraction(1, 10**6)
    grids = []
    for low, length, low_open, high_open in ends:
        inner = [low + Fraction(length * k, 8) for k in range(1, 8)]
        grids.append([low + tiny * low_open, *inner, low + length - tiny * high_open])
    for x, y in product(*grids):
        value = sum(c * x**i * y**j for c, (i, j) in zip(coefficients, MONOMIALS, strict=True))
        assert not _excluded(Fraction(value), found)


DEAR = cases(__file__, "DEAR")


@pytest.mark.parametrize(("text", "conditions", "wanted", "expected"), DEAR)
def test_a_wanted_relation_is_proved_by_every_method(
    text: str, conditions: str, wanted: str, expected: str | None
) -> None:
    e, region = parse(text), Given.parse(conditions)
    found = sign(e, region, wanted)
    assert found == expected or (expected is None and found not in PROVES[wanted])
    if expected is not None and wanted != "!=":
        assert sign(e, region) is None


PROVES = {">": ("+",), ">=": ("+", ">=0", "0"), "!=": ("+", "-", "!=")} | {
    "<": ("-",),
    "<=": ("-", "<=0", "0"),
}


@pytest.mark.parametrize("rest", ["log(exp(z)**2) - 2*z", "sqrt(z**2) - abs(z)"])
def test_a_strict_condition_and_what_vanishes_has_its_sign(rest: str) -> None:
    e, given = parse(f"x*y - 1 + {rest}"), Given.parse("x*y > 1")
    assert [sign(e, given, wanted) for wanted in (">", "!=", "<")] == ["+", "+", "+"]
    assert [sign(-e, given, wanted) for wanted in (">", "!=", "<")] == ["-", "-", "-"]
    assert sign(e, Given.parse("x*y >= 1"), ">") not in ("+", "-")
