"""Roots, exponentials and logarithms obey their laws on the domain, and no others."""

from typing import Any

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.angles import Angles
from tresym.reals.normal.field import Field
from tresym.reals.normal.powers import Powers
from tresym.reals.normal.rational_basis import RationalBasis
from tresym.reals.normal.ring import Fraction, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError

EQUAL = cases(__file__, "EQUAL")


def equal(left: str, right: str, under: str) -> bool:
    field = Field(Given.parse(under))
    x, y = field.normal(parse(left), parse(right))
    return bool((x - y).num.is_zero())


@pytest.mark.parametrize(("left", "right", "wrong", "under"), EQUAL)
def test_equal(left: str, right: str, wrong: str, under: str) -> None:
    assert equal(left, right, under)
    assert not equal(left, wrong, under)


NOT_EQUAL = cases(__file__, "NOT_EQUAL")


@pytest.mark.parametrize(("left", "right", "under"), NOT_EQUAL)
def test_not_equal(left: str, right: str, under: str) -> None:
    assert not equal(left, right, under)


def fractions(under: str, *texts: str) -> tuple[Field, list[Fraction]]:
    field = Field(Given.parse(under))
    return field, field.normal(*map(parse, texts))


small = st.fractions(-3, 3, max_denominator=6)


@given(st.lists(st.tuples(small, small), min_size=1, max_size=3))
def test_exponentials_have_a_rational_basis(terms: list[tuple[fmpq, fmpq]]) -> None:
    """Π exp(aᵢx + bᵢy) is exp of the sum: the exponents' units do not matter."""
    each = [f"exp(({a})*x + ({b})*y)" for a, b in terms]
    total = f"exp(({sum(a for a, _ in terms)})*x + ({sum(b for _, b in terms)})*y)"
    assert equal("*".join(each), total, "")
    assert not equal("*".join(each), f"{total}*exp(x/7)", "")


@given(st.lists(st.tuples(st.sampled_from(["x", "y", "x + y", "6"]), small), max_size=4))
def test_logarithm_and_exponential_undo_each_other(parts: list[tuple[str, fmpq]]) -> None:
    product = "*".join(["1", *(f"({base})**({k})" for base, k in parts)])
    total = " + ".join(["0", *(f"({k})*log({base})" for base, k in parts)])
    assert equal(f"log({product})", total, "x > 0, y > 0")
    assert equal(f"exp({total})", product, "x > 0, y > 0")


def test_linear_part() -> None:
    field, (x,) = fractions("x > 0, y > 0", "(3*log(x)*y + 2*y*log(y) + x)/(5*y)")
    rest, pieces = field.powers.linear_part(x, "log")
    assert sorted(r for _, r in pieces) == [fmpq(2, 5), fmpq(3, 5)]
    assert not {field.ring.at(i).kind for i in field.ring.used(rest.num)} & {"log"}
    field, (x,) = fractions("x > 0, y > 0", "log(x)^2 + y*log(x + 1)")
    rest, pieces = field.powers.linear_part(x, "log")
    assert not pieces
    assert rest.key == x.key


def test_log_of_absolute_and_its_value() -> None:
    field, (x,) = fractions("", "(x - y)^3*12")
    value = field.powers.log_of_absolute(x.num)
    at = {"x": arb(1), "y": arb(3)}
    assert field.ring.ball(value, at).overlaps(arb(96).log())


@pytest.mark.parametrize("text", ["(x - x)**(-1/3)", "log(x - x)", "cbrt(x - x)**(-1)"])
def test_nowhere_defined(text: str) -> None:
    with pytest.raises(UndefinedError):
        fractions("", text)


@pytest.mark.parametrize("text", ["x**(1/61)", "x**(1/7)*x**(1/9)"])
def test_bounds(text: str) -> None:
    with pytest.raises(TooLargeError):
        fractions("", text)


def test_a_root_of_zero_is_zero() -> None:
    assert equal("(x - x)**(1/3) + sqrt(x - x)", "0", "")


def test_a_wrong_combination_of_exponents_is_not_believed(monkeypatch: pytest.MonkeyPatch) -> None:
    true, false = "exp(2*x + 2*y)", "exp(x)**3*exp(y)**3"
    assert equal("exp(x)*exp(y)*exp(x + y)", true, "")
    wrong = [fmpq(2), fmpq(2)]
    monkeypatch.setattr(RationalBasis, "_solution", lambda self, basis, x: wrong[: len(basis)])
    assert not equal("exp(x)*exp(y)*exp(x + y)", false, "")


def test_what_is_split_off_may_be_any_multiple(monkeypatch: pytest.MonkeyPatch) -> None:
    found = Powers._multiples
    monkeypatch.setattr(Powers, "_multiples", lambda *at: [(g, 2 * r) for g, r in found(*at)])
    assert not equal("exp(log(x) + y)", "x**2*exp(y)", "x > 0")
    assert not equal("cos(atan(x) + y)", "cos(2*atan(x) + y)", "")
    monkeypatch.setattr(
        Powers,
        "_multiples",
        lambda powers, x, kind: [(powers.ring.at(i), fmpq(1)) for i in powers.ring.used(x)],
    )
    assert equal("exp(x)*exp(y)", "exp(x + y)", "")


def test_what_is_no_sign_is_not_split_off(monkeypatch: pytest.MonkeyPatch) -> None:
    def signed(angles: Angles, x: Any, kind: str) -> list[Any]:
        ring = angles.ring
        there = [ring.at(i) for i in ring.used(x) if ring.at(i).kind == "atan"]
        return [(g, ring.variable(ring.symbol("x")), fmpq(1)) for g in there]

    monkeypatch.setattr(Angles, "_signed_multiples", signed)
    assert not equal("cos(x*atan(y))", "cos(atan(y))", "")
    assert not equal("sin(x*atan(y))", "x*sin(atan(y))", "")
