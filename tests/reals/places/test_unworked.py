"""Integrals and roots in balls: every choice inside the balls that are given is enclosed."""

from __future__ import annotations

import pytest
from flint import acb, arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.language.binders import derivative, integral, order, root
from tresym.reals.language.expression import FUNCTIONS, PI, Expr, apply, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.unworked import MEROMORPHIC, At, Enclosing, _Holomorphic, value
from tresym.reals.places.values import evaluate


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
    [
        ("exp(x)", "0", "1", "exp(1) - 1"),
        ("1/x", "1", "2", "log(2)"),
        ("sqrt(x)", "1", "4", "14/3"),
        ("x**(1/3)", "1", "8", "45/4"),
        ("log(x)", "1", "2", "2*log(2) - 1"),
        ("x**pi", "1", "2", "(2**(pi + 1) - 1)/(pi + 1)"),
        ("1/(1 + x**2)", "1", "0", "-pi/4"),
        ("abs(x)", "1", "2", "3/2"),
    ],
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


HOLOMORPHIC = ("x**2", "x**(-3)", "sqrt(x)", "x**(5/3)", "x**pi", "log(x)", "pi*x + 1/2", "abs(x)")


@pytest.mark.parametrize("text", [*HOLOMORPHIC, *(f"{name}(x)" for name in sorted(MEROMORPHIC))])
def test_in_the_complex_numbers_it_is_the_same_function(text: str) -> None:
    e, here = parse(text), fmpq(3, 7)
    with ball_precision(128):
        outer = Enclosing({})
        found = _Holomorphic(outer, "x", acb(here)).value(e)
        assert found.real.overlaps(evaluate(e, {"x": here}))
        assert found.real.rel_accuracy_bits() > 90
        assert found.imag.contains(0)
        turned = _Holomorphic(outer, "x", acb(0, 1)).value(e)
        if text in ("sqrt(x)", "exp(x)", "cos(x)"):
            assert not turned.imag.is_zero() or text == "cos(x)"


@pytest.mark.parametrize("name", sorted(FUNCTIONS - MEROMORPHIC - {"abs", "log"}))
def test_what_is_not_holomorphic_everywhere_is_not_taken_for_it(name: str) -> None:
    outer = Enclosing({})
    x = symbol("x")
    assert not _Holomorphic(outer, "x", acb(fmpq(3, 2))).value(apply(name, x)).is_finite()


@pytest.mark.parametrize("text", ["sqrt(x)", "x**(1/3)", "log(x)", "x**pi", "1/x", "abs(x)"])
def test_a_ball_on_a_cut_has_no_holomorphic_value(text: str) -> None:
    wide = acb(arb(0, 1), arb(0, 1))
    assert not _Holomorphic(Enclosing({}), "x", wide).value(parse(text)).is_finite()


def test_roots_that_are_known() -> None:
    assert (at(found("x**2 - 2", "0", "2")) ** 2).contains(2)
    assert at(found("cos(x)", "0", "3") - PI / 2).contains(0)
    assert (at(10**5 * found("x - 1/10**5", "0", "1")) - 1).contains(0)
    assert (at(found("x - 1/2", "0", "1")) * 2 - 1).contains(0)
    assert at(found("integral(1/t, t, 1, x) - 1", "1", "3")).overlaps(arb(1).exp())


@pytest.mark.parametrize(
    ("f", "low", "high"),
    [
        ("x**2 + 1", "0", "1"),
        ("x - 2", "0", "1"),  # outside
        ("x - 1", "0", "1"),  # the ends do not count
        ("1/(x - 1/3)", "0", "1"),  # a sign that changes at a pole
        ("sign(x - 1/3)", "0", "1"),  # and at a jump
        ("atan2(x - 1/3, -1)", "0", "1"),
    ],
)
def test_without_a_root_there_is_no_value(f: str, low: str, high: str) -> None:
    assert not at(found(f, low, high)).is_finite()


def test_a_root_that_nobody_says_is_one_has_no_value() -> None:
    e = found("x**2 - 2", "0", "2")
    assert at(e).is_finite()
    assert not at(e, none).is_finite()


def test_nothing_else_that_binds_has_a_value_here() -> None:
    assert not at(derivative(parse("x**2"), "x"), x=fmpq(1)).is_finite()
    assert not at(parse("limit(1/x, x, oo)")).is_finite()
    assert not at(order("O", symbol("x")), x=fmpq(1)).is_finite()


def test_a_fraction_is_rounded_once() -> None:
    assert at(parse("p/q - 1"), p=fmpq(7126), q=fmpq(448)).contains(fmpq(6678, 448))
    assert at(parse("p/q"), p=fmpq(3), q=fmpq(4)).is_exact()
