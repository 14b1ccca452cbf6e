"""Integrals and roots in balls: every choice inside the balls that are given is enclosed."""

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.binder_values import At, value
from tresym.reals.language.binders import at as value_at
from tresym.reals.language.binders import derivative, integral, order, root
from tresym.reals.language.expression import PI, Expr, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision


def one(node: Expr, at: At) -> bool:
    return True


def none(node: Expr, at: At) -> bool:
    return False


def at(e: Expr, unique: object = one, **point: arb | fmpq) -> arb:
    with ball_precision(128):
        return value(e, point, unique)  # type: ignore[arg-type]


def over(f: str, low: str, high: str) -> Expr:
    return integral(parse(f), "x", parse(low), parse(high))


def found(f: str, low: str, high: str) -> Expr:
    return root(parse(f), "x", parse(low), parse(high))


@pytest.mark.parametrize(
    ("f", "low", "high", "is_"),
    cases(__file__, "integrals_that_are_known"),
)
def test_integrals_that_are_known(f: str, low: str, high: str, is_: str) -> None:
    assert at(over(f, low, high) - parse(is_)).contains(0)
    assert at(over(f, low, high)).is_finite()


@pytest.mark.parametrize(
    ("f", "low", "high"),
    [
        ("1/x", "-1", "1"),
        ("sqrt(-1 - x)*sqrt(-1 - x)", "0", "1"),  # −1 − x in the complex numbers, nothing in ℝ
        ("log(x - 3)/log(x - 3)", "0", "1"),
        ("sqrt(x - 1)", "0", "2"),
    ],
)
def test_an_integrand_that_is_not_real_on_the_whole_way_has_no_integral(
    f: str, low: str, high: str
) -> None:
    assert not at(over(f, low, high)).is_finite()


@given(st.integers(1, 40), st.integers(0, 8))
def test_an_integral_over_a_ball_holds_those_of_its_points(n: int, part: int) -> None:
    e = integral(parse("sqrt(a + x**2)"), "x", number(0), symbol("a"))
    low, width = fmpq(n, 8), fmpq(1, 16)
    whole = at(e, a=arb(low).union(arb(low + width)))
    assert whole.is_finite()
    assert whole.overlaps(at(e, a=low + width * fmpq(part, 8)))


@given(st.integers(1, 60), st.integers(0, 8))
def test_a_root_over_a_ball_holds_those_of_its_points(n: int, part: int) -> None:
    e = root(parse("x**3 + x - a"), "x", number(0), symbol("a"))
    low, width = fmpq(n, 8), fmpq(1, 64)
    whole = at(e, a=arb(low).union(arb(low + width)))
    inside = at(e, a=low + width * fmpq(part, 8))
    assert whole.overlaps(inside)
    assert inside.rel_accuracy_bits() > 90


def test_a_bracket_is_widened_until_it_holds_all_roots() -> None:
    e = root(parse("x**3 + x - a"), "x", number(0), symbol("a"))
    whole = at(e, a=arb(1).union(arb(3)))
    assert all(whole.contains(at(e, a=fmpq(n)).mid()) for n in (1, 2, 3))


def test_roots_that_are_known() -> None:
    assert (at(found("x**2 - 2", "0", "2")) ** 2).contains(2)
    assert at(found("cos(x)", "0", "3") - PI / 2).contains(0)
    assert (at(10**5 * found("x - 1/10**5", "0", "1")) - 1).contains(0)
    assert (at(found("x - 1/2", "0", "1")) * 2 - 1).contains(0)
    assert at(found("integral(1/t, t, 1, x) - 1", "1", "3")).overlaps(arb(1).exp())


@pytest.mark.parametrize(
    ("f", "low", "high"),
    cases(__file__, "without_a_root_there_is_no_value"),
)
def test_without_a_root_there_is_no_value(f: str, low: str, high: str) -> None:
    assert not at(found(f, low, high)).is_finite()


def test_a_root_that_nobody_says_is_one_has_no_value() -> None:
    e = found("x**2 - 2", "0", "2")
    assert at(e).is_finite()
    assert not at(e, none).is_finite()


def test_values_are_put_in_where_a_root_is_asked_for() -> None:
    e = root(parse("x**2 - y"), "x", parse("0"), parse("y"))
    asked = []

    def there(node: Expr, at: At) -> bool:
        asked.append(at["y"])
        return node == e

    two = value_at(e, {"y": parse("4*z")})
    assert at(two - 2, there, z=fmpq(1), y=fmpq(25)).contains(0)
    assert not at(two - 5, there, z=fmpq(1), y=fmpq(25)).contains(0)
    assert {bool(y == 4) for y in asked} == {True}
    assert at(value_at(derivative(parse("x**3"), "x"), {"x": parse("2")})) == 12


def test_nothing_else_that_binds_has_a_value_here() -> None:
    rate = derivative(integral(parse("y*x"), "x", parse("0"), parse("1")), "y")
    assert not at(rate, y=fmpq(1)).is_finite()
    assert not at(parse("limit(1/x, x, oo)")).is_finite()
    assert not at(order("O", symbol("x")), x=fmpq(1)).is_finite()


def test_a_fraction_is_rounded_once() -> None:
    assert at(parse("p/q - 1"), p=fmpq(7126), q=fmpq(448)).contains(fmpq(6678, 448))
    assert at(parse("p/q"), p=fmpq(3), q=fmpq(4)).is_exact()
