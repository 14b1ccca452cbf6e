"""Germs: what one says holds on all of its range, and none is formed where that is not sure."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import mpmath
import pytest
from flint import arb, ctx, fmpq, fmpq_poly
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.balls.germ import (
    PI,
    Germ,
    Germs,
    LogarithmError,
    RamifiedError,
    UnresolvedError,
    as_ball,
    is_zero,
)
from tresym.reals.numbers.arithmetic import ball_precision, balls

Formula = Callable[[Any, Any], Any]


def value(germ: Germ, x: arb) -> arb:
    """What the germ says of its function at x, by the definition."""
    total = germ.rest
    for c in reversed(germ.terms):
        total = total * x + as_ball(c)
    exponent = sum((as_ball(p) / x**j for j, p in enumerate(germ.exponent)), start=arb(0))
    return total * x**germ.power * exponent.exp()


NAMES = ("exp", "expm1", "log1p", "sin", "cos", "tan", "asin", "acos", "atan")
NAMES += ("sinh", "cosh", "tanh", "asinh", "atanh")

FUNCTIONS: dict[str, Formula] = {
    name: lambda x, m, name=name: getattr(m, name)(x * (1 + x)) for name in NAMES
}
FORMULAS: dict[str, Formula] = FUNCTIONS | {
    "at a point that is not 0": lambda x, m: m.sin(x + 1) + m.tanh(2 - x) + m.log(x + fmpq(3, 2)),
    "at a multiple of pi": lambda x, m: m.cos(m.pi / 3 + x) - m.tan(m.pi + x),
    "a root": lambda x, m: m.sqrt(4 + x) * (9 - x) ** fmpq(-3, 2),
    "a root of an even power": lambda x, m: m.sqrt(x**2 + x**3) / x,
    "a quotient with a pole": lambda x, m: (1 - m.cos(x)) / (x**5 * m.exp(x)),
    "a cancellation": lambda x, m: (m.sin(x) - x + x**3 / 6) / x**5,
    "an exponential that grows": lambda x, m: m.exp(1 / x - 2 / x**2 + x) * x**3,
    "two exponentials": lambda x, m: m.exp(1 / x) + m.exp(-1 / x) / x**7,
    "an exponential of a constant": lambda x, m: m.exp(2 + x) - m.exp(2 - x),
    "its logarithm": lambda x, m: m.log(m.exp(1 / x) * (2 + x)),
    "what is flat beyond its peak": lambda x, m: 1 + m.exp(-1 / x) / x**20,
    "what is flat": lambda x, m: 1 + m.sin(m.exp(-1 / x)),
    "a small logarithm": lambda x, m: m.log1p(m.exp(-2 / x) * x),
    "arc tangent of what grows": lambda x, m: m.atan(-1 / x**2) * m.atan(1 / x),
    "hyperbolic functions of what grows": lambda x, m: (
        m.tanh(-1 / x) + m.sinh(1 / x) / m.cosh(2 / x)
    ),
    "an absolute value": lambda x, m: abs(x - 3) * abs(1 + x),
    "an oscillation": lambda x, m: 2 + x * m.sin(1 / x) + m.cos(3 / x**2),
    "a negative power": lambda x, m: (2 * x + x**2) ** -3,
}


@pytest.mark.parametrize("order", [3, 6])
@pytest.mark.parametrize("name", FORMULAS)
def test_a_germ_contains_its_function_at_every_point_of_its_range(name: str, order: int) -> None:
    formula = FORMULAS[name]
    with ball_precision(160):
        field = Germs(fmpq(1, 8), order)
        germ = formula(field.x, field)
        assert len(germ.terms) <= order
        for k in range(1, 33):
            x = arb(fmpq(k, 256))
            exact = formula(x, balls)
            assert exact.rel_accuracy_bits() > 20
            assert value(germ, x).overlaps(exact)
            plain = exact / x**germ.power
            exponent = (as_ball(p) / x**j for j, p in enumerate(germ.exponent))
            assert germ.range().overlaps(plain / sum(exponent, start=arb(0)).exp())


@pytest.mark.parametrize("name", FUNCTIONS)
def test_the_terms_are_the_taylor_coefficients(name: str) -> None:
    """By differentiation in mpmath; at 0 they are rational, and balls of no width."""
    with ball_precision(200), mpmath.workdps(50):
        germ = FUNCTIONS[name](Germs(fmpq(1, 8), 6).x, Germs(fmpq(1, 8), 6))
        terms = [arb(0)] * germ.power + [as_ball(c) for c in germ.terms]
        assert all(isinstance(c, fmpq_poly) for c in germ.terms)
        expected = mpmath.taylor(lambda x: FUNCTIONS[name](x, mpmath.mp), 0, 5)
        for found, wanted in zip(terms, expected, strict=False):
            assert abs(float(found.mid()) - float(wanted)) < 1e-9


def _degree(p: list[int]) -> int:
    return max((k for k, c in enumerate(p) if c), default=0)


SMALL = st.lists(st.integers(-3, 3), min_size=1, max_size=4)


@given(SMALL, SMALL, st.integers(1, 4))
def test_polynomials_are_exact(first: list[int], second: list[int], order: int) -> None:
    """Sum and product of polynomials at an exact point, in fractions; zero is seen to be zero."""
    with ball_precision(128):
        field = Germs(fmpq(1), order)
        f, g = (
            sum((c * field.x**k for k, c in enumerate(p)), start=field.constant(0))
            for p in (first, second)
        )
        at = [sum(fmpq(c, 3**k) for k, c in enumerate(p)) for p in (first, second)]
        for germ, exact in ((f + g, at[0] + at[1]), (f * g, at[0] * at[1]), (f - f, fmpq(0))):
            assert value(germ, arb(fmpq(1, 3))).overlaps(arb(exact))
            assert exact == 0 or not germ.vanishes
        assert (f - f).vanishes is f.rest.is_exact()
        assert not f.rest.is_zero() or f.vanishes or f.power + len(f.terms) == _degree(first) + 1


def test_what_is_certainly_zero() -> None:
    with ball_precision(64):
        assert is_zero(PI - PI)
        assert not is_zero(PI * 7 - 22)
        assert not is_zero(arb(0, 1))
        field = Germs(fmpq(1, 2))
        assert (field.pi - field.constant(PI)).vanishes
        assert not (field.constant(arb.pi()) - field.pi).vanishes
        assert as_ball(PI**2 - 9).overlaps(arb.pi() ** 2 - 9)


def test_growth() -> None:
    field = Germs(fmpq(1, 8))
    x = field.x
    with ball_precision(64):
        assert [f.growth() for f in (x, 1 + x, 1 / x)] == [-1, 0, 1]
        assert [field.exp(f).growth() for f in (1 / x, -1 / x, x, 3 + x)] == [1, -1, 0, 0]
        assert (field.exp(-1 / x) / x**9).growth() == -1
        assert (field.exp(1 / x - 1 / x**2) / x).growth() == -1
        with pytest.raises(UnresolvedError):
            field.exp(field.constant(arb(0, 1)) / x).growth()


REFUSED: dict[str, tuple[type[ArithmeticError], Formula]] = {
    "division by what may vanish": (UnresolvedError, lambda x, m: 1 / m.bounded(arb(0, 1))),
    "division by zero": (UnresolvedError, lambda x, m: 1 / (x - x)),
    "division by a zero within the range": (UnresolvedError, lambda x, m: 1 / (x - fmpq(1, 16))),
    "absolute value of a change of sign": (UnresolvedError, lambda x, m: abs(x - fmpq(1, 16))),
    "logarithm of a negative number": (UnresolvedError, lambda x, m: m.log(x - 1)),
    "logarithm of what may be negative": (UnresolvedError, lambda x, m: m.log(1 - 16 * x)),
    "root of a negative number": (UnresolvedError, lambda x, m: m.sqrt(x - 1)),
    "root of what may be negative": (UnresolvedError, lambda x, m: m.sqrt(1 - 16 * x)),
    "arc sine beyond 1": (UnresolvedError, lambda x, m: m.asin(16 * x)),
    "arc sine at 1": (UnresolvedError, lambda x, m: m.asin(1 + x)),
    "tangent across a pole": (UnresolvedError, lambda x, m: m.tan(20 * x)),
    "sine over an unknown number of turns is bounded": (
        UnresolvedError,
        lambda x, m: m.log(m.sin(1 / x)),
    ),
    "exponential of an unknown that grows": (
        UnresolvedError,
        lambda x, m: m.exp(m.bounded(arb(0, 1)) / x),
    ),
    "exponential of an exponential": (UnresolvedError, lambda x, m: m.exp(m.exp(1 / x))),
    "two exponentials not told apart": (
        UnresolvedError,
        lambda x, m: m.exp(m.constant(arb(1, "1e-9")) / x) - m.exp(1 / x),
    ),
    "an exponential not yet small": (
        UnresolvedError,
        lambda x, m: 1 + m.exp(1000 / x - 1 / x**2),
    ),
    "values of what is not bounded": (UnresolvedError, lambda x, m: m.values(1 / x)),
    "values of an exponential that grows": (UnresolvedError, lambda x, m: m.values(m.exp(1 / x))),
    "root of x": (RamifiedError, lambda x, m: m.sqrt(x)),
    "logarithm of x": (LogarithmError, lambda x, m: m.log(x**2 * (1 + x))),
}


@pytest.mark.parametrize("name", REFUSED)
def test_no_germ_where_it_is_not_sure(name: str) -> None:
    error, formula = REFUSED[name]
    with ball_precision(100):
        field = Germs(fmpq(1, 8), 6)
        with pytest.raises(error):
            formula(field.x, field)


@pytest.mark.parametrize(("power", "index"), [("1/2", 2), ("-2/3", 3), ("7/5", 5)])
def test_a_ramified_root_names_its_index(power: str, index: int) -> None:
    field = Germs(fmpq(1, 8))
    with pytest.raises(RamifiedError) as found:
        field.power(field.x * (2 + field.x), power)
    assert found.value.index == index
    with ball_precision(64):
        assert field.power(field.x**index, power).power == fmpq(*map(int, power.split("/"))) * index


def test_series_lengths_are_restored_on_errors_too() -> None:
    before = ctx.cap
    field = Germs(fmpq(1, 8), 20)
    with ball_precision(64):
        field.sin(field.x)
        with pytest.raises(UnresolvedError):
            field.log1p(-9 * field.x)
    assert ctx.cap == before
