"""Every region that polynomials cut out of space gets a rational point."""

from fractions import Fraction
from itertools import product

import pytest
from flint import fmpq, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.cylindrical_decomposition import (
    MAX_DEGREE,
    MAX_POLYNOMIALS,
    between,
    sample_points,
)
from tresym.reals.numbers.exact import Interval
from tresym.reals.numbers.factoring import TooLargeError

CONTEXTS = {n: fmpz_mpoly_ctx.get(["x", "y", "z"][:n], "lex") for n in (1, 2, 3)}


def polys(texts: str, n: int) -> tuple[list[fmpz_mpoly], fmpz_mpoly_ctx]:
    context = CONTEXTS[n]
    names = dict(zip("xyz", context.gens(), strict=False))
    known = {
        "x": names["x"],
        "x^2 - 2": names["x"] ** 2 - 2,
        "close": (10**9 * names["x"] - 1) * (10**9 * names["x"] - 2),
    }
    if n > 1:
        x, y = names["x"], names["y"]
        known |= {
            "y": y,
            "circle": x**2 + y**2 - 1,
            "ring": (x**2 + y**2 - 1) * (x**2 + y**2 - 4),
            "hyperbola": x * y - 1,
            "loop": y**2 - x**2 * (x + 1),  # a node: three regions
            "droplet": (x**2 + y**2) * 10**12 - 1,
            "positive": x**2 + y**2 + 1,
        }
    if n > 2:
        x, y, z = names["x"], names["y"], names["z"]
        known |= {"sphere": x**2 + y**2 + z**2 - 1, "cone": z**2 - x**2 - y**2}
    return [known[text] for text in texts.split(", ")], context


def signs(found: list[fmpz_mpoly], point: tuple[fmpq, ...]) -> tuple[int, ...]:
    values = [sum((fmpq(c) * _product(point, m) for m, c in p.terms()), fmpq(0)) for p in found]
    return tuple((v > 0) - (v < 0) for v in values)


def _product(point: tuple[fmpq, ...], monomial: tuple[int, ...]) -> fmpq:
    total = fmpq(1)
    for x, k in zip(point, monomial, strict=True):
        total *= x ** int(k)
    return total


@pytest.mark.parametrize(
    ("texts", "n", "expected"),
    [
        ("x", 1, 2),
        ("x^2 - 2", 1, 2),
        ("close", 1, 2),
        ("circle", 2, 2),
        ("ring", 2, 2),
        ("droplet", 2, 2),
        ("circle, x, y", 2, 8),
        ("hyperbola, x", 2, 4),
        ("loop, x", 2, 4),
        ("positive", 2, 1),
        ("sphere", 3, 2),
        ("sphere, cone", 3, 4),
    ],
)
def test_every_pattern_of_signs_is_met(texts: str, n: int, expected: int) -> None:
    found, context = polys(texts, n)
    met = {signs(found, point) for point in sample_points(found, context)}
    assert len({s for s in met if 0 not in s}) == expected


def test_both_branches_are_met() -> None:
    """The hyperbola cuts off a region on either side of it, both of one sign."""
    found, context = polys("hyperbola", 2)
    inside = [p for p in sample_points(found, context) if signs(found, p) == (1,)]
    assert {p[0] > 0 for p in inside} == {True, False}
    found, context = polys("ring", 2)
    outside = [p for p in sample_points(found, context) if signs(found, p) == (1,)]
    assert {p[0] ** 2 + p[1] ** 2 < 1 for p in outside} == {True, False}


coefficients = st.lists(st.integers(-3, 3), min_size=6, max_size=6)


@given(coefficients, coefficients)
def test_no_pattern_of_a_grid_is_missed(p: list[int], q: list[int]) -> None:
    context = CONTEXTS[2]
    monomials = [(0, 0), (1, 0), (0, 1), (2, 0), (1, 1), (0, 2)]
    found = [context.from_dict(dict(zip(monomials, row, strict=True))) for row in (p, q)]
    met = {signs(found, point) for point in sample_points(found, context)}
    grid = [fmpq(2 * k + 1, 3) for k in range(-4, 4)]
    seen = {signs(found, point) for point in product(grid, grid)}
    zeros = {i for i, f in enumerate(found) if f.is_zero()}
    for pattern in seen:
        if {i for i, s in enumerate(pattern) if s == 0} == zeros:
            assert pattern in met


def test_bounds() -> None:
    (x,) = CONTEXTS[1].gens()
    with pytest.raises(TooLargeError):
        list(sample_points([x - k for k in range(MAX_POLYNOMIALS + 1)], CONTEXTS[1]))
    with pytest.raises(TooLargeError):
        list(sample_points([x ** (MAX_DEGREE + 1) - 2], CONTEXTS[1]))


rationals = st.fractions(min_value=-5, max_value=5, max_denominator=20)


@given(rationals, rationals)
def test_simplest_lies_between_and_none_is_simpler(one: Fraction, other: Fraction) -> None:
    low, high = sorted((one, other))
    if low == high:
        return
    ends = fmpq(low.numerator, low.denominator), fmpq(high.numerator, high.denominator)
    found = Interval(*ends, True, True).simplest()
    value = Fraction(int(found.p), int(found.q))
    assert low < value < high
    for q in range(1, value.denominator):
        k = low.numerator * q // low.denominator + 1
        assert not Fraction(k, q) < high
    assert Interval(None, -found, high_open=True).simplest() < -found
    assert Interval(found, None, low_open=True).simplest() > found


def test_a_point_that_is_not_between_the_roots_is_none(monkeypatch: pytest.MonkeyPatch) -> None:
    p = fmpz_poly([-2, 0, 1])
    assert between(p) == [fmpq(-2), fmpq(0), fmpq(2)]
    monkeypatch.setattr(Interval, "simplest", lambda _: fmpq(0))
    with pytest.raises(TooLargeError):
        between(p)
