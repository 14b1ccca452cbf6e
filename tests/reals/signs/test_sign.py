"""Proven signs: they hold at every point, on closed ends too, and stop where a guard says so."""

from __future__ import annotations

from fractions import Fraction
from itertools import product

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.conditions import Given
from tresym.reals.places.values import evaluate
from tresym.reals.signs.sign import PROVING, nonzero_denominators, sign, without_powers

SIGNS = [
    # functions by their ranges
    ("cosh(x)*sech(y)", "", "+"),
    ("cosh(x) - 1", "", ">=0"),
    ("2 - tanh(x)", "", "+"),
    ("1 - tanh(x)", "", "+"),
    ("1 + sin(x)*cos(y)", "", ">=0"),
    ("11/10 + sin(x)*cos(y)", "", "+"),
    ("8/5 - atan(x)", "", "+"),
    ("1 - atan(x)", "", None),
    ("asinh(x - 1)", "x > 1", "+"),
    ("cbrt(x)", "x <= 0", "<=0"),
    ("atanh(x)**2", "", ">=0"),
    ("2 - abs(x)", "-1 <= x < 2", "+"),
    ("2 - abs(x)", "-2 <= x < 2", ">=0"),
    ("2 - abs(x)", "-3 < x < 2", None),
    ("abs(x)", "x != 0", "+"),
    ("abs(x)", "", ">=0"),
    ("abs(x) + abs(y)", "y != 0", "+"),
    ("x", "2*x >= 0", ">=0"),
    ("x", "-2*x >= 0", "<=0"),
    # powers
    ("sqrt(x)", "x >= 0", ">=0"),
    ("x**(-3)", "x < 0", "-"),
    ("x**(-3)", "x <= 0", "<=0"),
    ("x**(-3)", "", None),
    ("x**(-2)", "", "+"),
    ("x**(1/2)", "x != 0", "+"),
    ("x**(-1/2)", "", "+"),
    ("x**y", "", "+"),
    ("x**4", "", ">=0"),
    ("(x - y)**4", "x != y", "+"),
    # products and sums of weak signs
    ("x*y", "x >= 0, y > 0", ">=0"),
    ("x*y*z", "x < 0, y < 0, z < 0", "-"),
    ("x + y", "x >= 0, y > 0", "+"),
    ("x + y", "x >= 0, y >= 0", ">=0"),
    ("x - y", "x >= 0, y >= 0", None),
    # a polynomial at the corners of its box, and beside them
    ("1 - x*y", "0 <= x <= 1, 0 <= y <= 1", ">=0"),
    ("1 - x*y", "0 <= x <= 1, 0 <= y < 1", "+"),
    ("2 + x*y", "-1 <= x <= 1, -1 <= y <= 1", "+"),
    ("1 + x*y", "-1 <= x <= 1, -1 < y < 1", "+"),
    ("x*(3 - x)", "0 < x < 3", "+"),
    ("x*(3 - x)", "0 <= x < 3", ">=0"),
    ("x**2 + x*y + y**2", "", ">=0"),
    ("x**2 + x*y + y**2 + 1", "", "+"),
    ("x**2 + 3*x*y + y**2", "", None),
    ("-x**2 + x*y - y**2 - 1", "", "-"),
    ("sin(x)**2 + sin(x) + 1/4", "", ">=0"),
    ("sin(x)**2 + sin(x) + 1/5", "", None),
    # conditions as they stand, and through factors
    ("x - y**3", "x > y**3", "+"),
    ("y**3 - x", "x >= y**3", "<=0"),
    ("x**2 - y**2", "x > y, y > 0", ">=0"),
    ("x**2 - y**2", "x != y", None),
    ("x**2 - 2*x*y + y**2", "x != y", "+"),
    ("x - y", "x != y", None),
    # constants, by balls or by the normal form
    ("pi - 355/113", "", "-"),
    ("sqrt(2)*sqrt(3) - sqrt(6)", "", "0"),
    ("exp(1) - 2 - 5/7", "", "+"),
    ("pi - pi", "", "0"),
]


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


@pytest.mark.parametrize(
    ("text", "conditions", "nonzero"),
    [
        ("1/(x*y)", "x > 0, y < 0", True),
        ("1/(x*y)", "x > 0, y <= 0", False),
        ("x/(x**2 + 1)", "", True),
        ("1/(x**2 - 2*x + 1)", "x != 1", True),
        ("1/(x**2 - 1)", "x != 1", False),
        ("1/(x**2 - 1)", "x != 1, x != -1", True),
        ("1/(x**2 - 1)", "x**2 != 1", True),
        ("cot(x)", "sin(x) != 0", True),
        ("cot(x)", "x != 0", False),
        ("sec(x)", "cos(x) > 0", True),
        ("tan(x)", "sin(x) != 0", False),
        ("atanh(x)", "x**2 < 1", True),
        ("atanh(x)", "x > 0", False),
        ("log(x)", "x != 0", True),
        ("coth(x)", "x >= 0", False),
        ("sign(x - y)", "x > y", True),
        # what is shown of almost all points says nothing of each one
        ("1/(sqrt(x**2) + x)", "x != 0", False),
        ("1/(sin(x)**2 + cos(x)**2 - y)", "y != 1", False),
        ("x**(y - 1)", "y > 1", False),
        ("exp(1/log(x))", "x > 0", False),
    ],
)
def test_denominators_that_vanish_nowhere(text: str, conditions: str, nonzero: bool) -> None:
    found = nonzero_denominators(parse(text), Given.parse(conditions))
    assert (found is None) is nonzero


def test_what_proves_a_relation() -> None:
    """By all values of each sign; ``!=`` is not proved by a weak one."""
    values = {"+": {1}, "-": {-1}, "0": {0}, ">=0": {0, 1}, "<=0": {0, -1}}
    holds = {">": lambda v: v > 0, ">=": lambda v: v >= 0, "!=": lambda v: v != 0}
    for relation, found in PROVING.items():
        assert set(found) == {s for s, at in values.items() if all(map(holds[relation], at))}


@pytest.mark.parametrize(
    ("text", "conditions", "changes"),
    [
        ("x - 2*sqrt(x) + 1", "x > 0", True),
        ("x**2 - 2*sqrt(x) + x", "", True),
        ("x + sqrt(-x)", "x < 0", False),
        ("x + sqrt(1 + x)", "x > 0", False),
        ("x + sqrt(y)", "x > 0, y > 0", False),
    ],
)
def test_a_positive_symbol_is_a_power_of_its_own_root(
    text: str, conditions: str, changes: bool
) -> None:
    field = Field(Given.parse(conditions))
    (value,) = field.normal(parse(text))
    changed = without_powers(field, value.num)
    assert (changed != value.num) is changes
    with ball_precision(100):
        for x in (arb(fmpq(1, 3)), arb(5)):
            assert not changes or _at(field, changed, x).overlaps(_at(field, value.num, x))


def _at(field: Field, p: Poly, x: arb) -> arb:
    """The value where the one symbol is x and the one root its square root."""
    total = arb(0)
    for monomial, c in p.terms():
        term = arb(c)
        for i in field.used(p):
            base = x if field.at(i).kind == "symbol" else x.sqrt()
            term *= base ** int(monomial[i])
        total += term
    return total
