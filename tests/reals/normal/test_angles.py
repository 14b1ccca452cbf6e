"""Sines and cosines: exact at multiples of π, free of the half angle's poles elsewhere."""

import pytest
from cases import cases
from flint import arb, fmpq, fmpz_poly
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal import angles
from tresym.reals.normal.angles import MAX_HALF_TURN, MAX_MULTIPLE
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import AgainError
from tresym.reals.numbers.factoring import TooLargeError


def equal(left: str, right: str, under: str = "") -> bool:
    field = Field(Given.parse(under), size=32)
    x, y = field.normal(parse(left), parse(right))
    return bool((x - y).num.is_zero())


DENOMINATORS = [1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 12, 15, 16, 24, 30]


@pytest.mark.parametrize("q", DENOMINATORS)
def test_turns_of_pi(q: int) -> None:
    field = Field(Given(), size=8)
    for p in range(-2 * q, 2 * q + 1):
        r = fmpq(p, q)
        try:
            c, s = field.angles.turn_of_pi(r)
        except AgainError:  # the unit grew
            c, s = field.angles.turn_of_pi(r)
        assert field.ring.ball(c).overlaps(arb.cos_pi_fmpq(r))
        assert field.ring.ball(s).overlaps(arb.sin_pi_fmpq(r))
        square = c**2 + s**2
        assert (square - 1).num.is_zero()


@given(st.sampled_from([5, 7, 11, 12]), st.integers(-40, 40), st.integers(-40, 40))
def test_turns_of_pi_add_up(q: int, j: int, k: int) -> None:
    field = Field(Given(), size=8)
    field.angles.turn_of_pi(fmpq(1, q))
    (a, b), (c, d), (e, f) = (field.angles.turn_of_pi(fmpq(n, q)) for n in (j, k, j + k))
    cosine = a * c - b * d
    sine = a * d + b * c
    assert (cosine - e).num.is_zero()
    assert (sine - f).num.is_zero()


def test_bounds() -> None:
    with pytest.raises(TooLargeError):
        Field(Given()).angles.turn_of_pi(fmpq(1, MAX_HALF_TURN))
    with pytest.raises(TooLargeError):
        Field(Given()).normal(parse(f"sin(x) + cos({MAX_MULTIPLE + 1}*x)"))
    with pytest.raises(TooLargeError):
        Field(Given()).normal(
            parse(f"sin(x*log(y)*atan(y)) + cos({MAX_MULTIPLE + 1}*x*log(y)*atan(y))")
        )


EQUAL = cases(__file__, "EQUAL")


@pytest.mark.parametrize(("left", "right", "wrong"), EQUAL)
def test_equal(left: str, right: str, wrong: str) -> None:
    assert equal(left, right)
    assert not equal(left, wrong)


ODD_TURNS = cases(__file__, "ODD_TURNS")


@pytest.mark.parametrize(("angle", "under"), ODD_TURNS)
def test_an_odd_turn_has_no_tangent_of_its_half(angle: str, under: str) -> None:
    """At an odd multiple of π the cosine is −1: no other value is proved, nor a division by it."""
    assert not equal(f"cos({angle})", "1", under)
    assert not equal(f"sin({angle})", "1", under)
    assert not equal(f"cos({angle})^2", "1/2", under)
    assert equal(f"cos({angle})^2 + sin({angle})^2", "1", under)
    assert not equal(f"sign(1 + cos({angle}))", "1", under)  # there it is 0
    root = f"sqrt((1 + cos({angle}))*y)"  # real for every y
    assert not equal(f"{root} + abs(y)", f"{root} + y", "")
    field = Field(Given.parse(under), size=48)
    (value,) = field.normal(parse(f"cos({angle})"))
    at = {"x": arb(3), "y": arb(2)}
    found = field.ring.ball(value, at)
    assert not found.is_finite() or found.contains(-1)


@pytest.mark.parametrize("angle", ["2*(x + atan(cot(x)))/3", "4/3*(atan(2) + atan(3))"])
def test_thirds_of_arc_tangents_may_be_an_odd_turn(angle: str) -> None:
    """They stay in the angle: on a region it is π, and 1 + cos of it is 0."""
    assert not equal(f"sign(1 + cos({angle}))", "1")
    assert equal(f"cos({angle})^2 + sin({angle})^2", "1")


@pytest.mark.parametrize("other", [18, 7, 14, 3])
def test_another_minimal_polynomial_is_not_believed(
    other: int, monkeypatch: pytest.MonkeyPatch
) -> None:
    class Lying(fmpz_poly):
        @staticmethod
        def cos_minpoly(_: int) -> fmpz_poly:
            return fmpz_poly.cos_minpoly(other)

    assert equal("cos(pi/7) - cos(2*pi/7) + cos(3*pi/7)", "1/2")
    monkeypatch.setattr(angles, "fmpz_poly", Lying)
    with pytest.raises(ArithmeticError):
        Field(Given(), size=8).normal(parse("cos(pi/7)"))


NO_SIGNS = cases(__file__, "NO_SIGNS")


@pytest.mark.parametrize(("left", "right"), NO_SIGNS)
def test_only_signs_come_out_of_an_angle(left: str, right: str) -> None:
    assert not equal(left, right)


SIGNS = [
    ("cos(sign(x)*pi/2 + pi/3)", "-sign(x)*sqrt(3)/2"),
    ("sin(sign(x)*pi/2 + sign(y)*pi)", "-sign(x)"),
    ("sin(sign(x)*atan(y))", "sign(x)*y/sqrt(1 + y**2)"),
    ("cos(sign(x)*atan(y) + atan(x))", "(1 - abs(x)*y)/(sqrt(1 + x**2)*sqrt(1 + y**2))"),
]


@pytest.mark.parametrize(("left", "right"), SIGNS)
def test_signs_do_where_they_are_not_0(left: str, right: str) -> None:
    assert equal(left, right)
