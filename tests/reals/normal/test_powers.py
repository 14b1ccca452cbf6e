"""Roots, exponentials and logarithms obey their laws on the domain, and no others."""

from typing import Any

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.angles import AngleRing
from tresym.reals.normal.field import Field
from tresym.reals.normal.powers import PowerRing
from tresym.reals.normal.ring import Fraction, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError

EQUAL = [
    # equal, with a near falsehood
    ("sqrt(x*y)", "sqrt(x)*sqrt(y)", "-sqrt(x)*sqrt(y)", "x > 0, y > 0"),
    ("sqrt(x*y)", "sqrt(-x)*sqrt(-y)", "-sqrt(-x)*sqrt(-y)", "x < 0, y < 0"),
    ("sqrt(x^2*y)", "abs(x)*sqrt(y)", "x*sqrt(y)", ""),
    ("x**(1/2)*x**(1/3)", "x**(5/6)", "x**(1/6)", ""),
    ("(x**(2/3))**(3/4)", "sqrt(abs(x))", "x", ""),
    ("(x^6)**(1/3)", "x^2", "x^3", ""),
    ("(x^6)**(1/2)", "abs(x)^3", "x^3", ""),
    ("cbrt(x*y)", "cbrt(x)*cbrt(y)", "-cbrt(x)*cbrt(y)", ""),
    ("cbrt(x^2)", "cbrt(x)^2", "-cbrt(x)^2", ""),
    ("cbrt(x - y)", "-cbrt(y - x)", "cbrt(y - x)", ""),
    ("cbrt(-x)", "-cbrt(x)", "cbrt(x)", ""),
    ("cbrt(sign(x))", "sign(x)", "1", ""),
    ("sqrt(-x)^2", "-x", "x", ""),
    ("cbrt(x - y)^3", "x - y", "abs(x - y)", ""),
    ("sqrt(12)", "2*sqrt(3)", "3*sqrt(2)", ""),
    ("6**(1/2)*24**(1/2)", "12", "-12", ""),
    ("8**(1/6)", "sqrt(2)", "-sqrt(2)", ""),
    ("sqrt(exp(x))", "exp(x/2)", "-exp(x/2)", ""),
    ("sqrt(exp(2*x)*y)", "exp(x)*sqrt(y)", "exp(2*x)*sqrt(y)", ""),
    ("sqrt(x)**(-3)", "1/(x*sqrt(x))", "x/sqrt(x)", ""),
    ("log(x*y)", "log(abs(x)) + log(abs(y))", "log(abs(x)) - log(abs(y))", ""),
    ("log(x^3/y^2)", "3*log(x) - 2*log(abs(y))", "3*log(x) + 2*log(abs(y))", ""),
    ("log(sqrt(x))", "log(x)/2", "log(x)", ""),
    ("log(12)", "2*log(2) + log(3)", "log(2) + 2*log(3)", ""),
    ("log(x - y)", "log((x^2 - y^2)/(x + y))", "log(x + y)", ""),
    ("log(exp(x)*y^2)", "x + 2*log(abs(y))", "x - 2*log(abs(y))", ""),
    ("log(sign(x)^2)", "0", "1", ""),
    ("exp(log(x)/2 + y)", "sqrt(x)*exp(y)", "x*exp(y)", ""),
    ("exp(-log(x - y))", "1/(x - y)", "x - y", ""),
    ("exp(x*log(2)/2 + y*log(2)/3)", "2**(x/2 + y/3)", "2**(x/3 + y/2)", ""),
    ("exp((x + log(x)*y)/y)", "x*exp(x/y)", "exp(x/y)", ""),
    ("exp(2)*exp(x)", "exp(x + 2)", "exp(x - 2)", ""),
    ("exp(x + y)*exp(x - y)", "exp(2*x)", "exp(2*y)", ""),
    ("exp(x/2)^2/exp(x/3)^3", "1", "2", ""),
    ("exp(sign(x)*y)", "cosh(y) + sign(x)*sinh(y)", "cosh(y) + sinh(y)", ""),
    ("exp(abs(x))*exp(-abs(x))", "1", "-1", ""),
    ("x**y*y**y", "(x*y)**y", "(x + y)**y", ""),
]


def equal(left: str, right: str, under: str) -> bool:
    field = Field(Given.parse(under))
    x, y = field.normal(parse(left), parse(right))
    return bool((x - y).num.is_zero())


@pytest.mark.parametrize(("left", "right", "wrong", "under"), EQUAL)
def test_equal(left: str, right: str, wrong: str, under: str) -> None:
    assert equal(left, right, under)
    assert not equal(left, wrong, under)


NOT_EQUAL = [
    # laws of positive numbers, where nothing tells that they are
    ("sqrt(x^2)", "x", ""),
    ("sqrt(x^2*y^2)", "x*y", ""),
    ("(x^2)**(1/4)*y", "sqrt(abs(x))*abs(y)", ""),
    ("log(x^2) + sqrt(y)", "2*log(abs(x + y)) + sqrt(y)", ""),
    ("sqrt((x - y)^2*z)", "(x - y)*sqrt(z)", "x > 0, y > 0"),
    ("exp(abs(x))", "exp(x)", ""),
    ("cbrt(x^2)**(1/2)", "cbrt(x)", ""),
    ("((x*y)^2)**(1/3)", "x**(2/3)*y**(2/3) + cbrt(x*y)", ""),
]


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
    rest, pieces = field.linear_part(x, "log")
    assert sorted(r for _, r in pieces) == [fmpq(2, 5), fmpq(3, 5)]
    assert not {field.at(i).kind for i in field.used(rest.num)} & {"log"}
    field, (x,) = fractions("x > 0, y > 0", "log(x)^2 + y*log(x + 1)")
    rest, pieces = field.linear_part(x, "log")
    assert not pieces
    assert rest.key == x.key


def test_log_of_absolute_and_its_value() -> None:
    field, (x,) = fractions("", "(x - y)^3*12")
    value = field.log_of_absolute(x.num)
    at = {"x": arb(1), "y": arb(3)}
    assert field.ball(value, at).overlaps(arb(96).log())


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
    monkeypatch.setattr(PowerRing, "_combination", lambda self, basis, x: wrong[: len(basis)])
    assert not equal("exp(x)*exp(y)*exp(x + y)", false, "")


def test_what_is_split_off_may_be_any_multiple(monkeypatch: pytest.MonkeyPatch) -> None:
    found = PowerRing._multiples
    monkeypatch.setattr(PowerRing, "_multiples", lambda *at: [(g, 2 * r) for g, r in found(*at)])
    assert not equal("exp(log(x) + y)", "x**2*exp(y)", "x > 0")
    assert not equal("cos(atan(x) + y)", "cos(2*atan(x) + y)", "")
    monkeypatch.setattr(
        PowerRing, "_multiples", lambda ring, x, kind: [(ring.at(i), fmpq(1)) for i in ring.used(x)]
    )
    assert equal("exp(x)*exp(y)", "exp(x + y)", "")


def test_what_is_no_sign_is_not_split_off(monkeypatch: pytest.MonkeyPatch) -> None:
    def signed(ring: Any, x: Any, kind: str) -> list[Any]:
        there = [ring.at(i) for i in ring.used(x) if ring.at(i).kind == "atan"]
        return [(g, ring.variable(ring.symbol("x")), fmpq(1)) for g in there]

    monkeypatch.setattr(AngleRing, "_signed_multiples", signed)
    assert not equal("cos(x*atan(y))", "cos(atan(y))", "")
    assert not equal("sin(x*atan(y))", "x*sin(atan(y))", "")
