"""From what claims say to what is decided: definitions put in, opaque things kept apart."""

from __future__ import annotations

import pytest
from sympy import (
    Basic,
    Derivative,
    Eq,
    Function,
    Integral,
    Matrix,
    Subs,
    Symbol,
    Tuple,
    sin,
)

from tresym.ledger.claim import Claim, Definition, equal
from tresym.ledger.meaning import CircularError, definitions, put_in, to_expression, to_given
from tresym.reals.language.expression import symbols
from tresym.reals.language.parsing import parse
from tresym.reals.places.conditions import Given

x, y, z, t, u = (Symbol(name, real=True) for name in "xyztu")


def defined(*says: Basic) -> dict[Basic, Basic]:
    return definitions(Claim(f"d{n}", e, Definition()) for n, e in enumerate(says))


def test_definitions_are_put_in_until_none_is_left() -> None:
    rules = defined(equal(x, y + 1), equal(y, z**2))
    assert put_in(2 * x, rules) == 2 * (z**2 + 1)


def test_systems_and_matrices_define_entry_by_entry() -> None:
    rules = defined(Tuple(equal(x, t), y > 0), Eq(Matrix([y, z]), Matrix([t, 2 * t])))
    assert rules == {x: t, y: t, z: 2 * t}


@pytest.mark.parametrize(
    ("e", "rules"),
    [
        (x, {x: x + 1}),
        (x + y, {x: y + 1, y: x}),
        (Integral(x * t, (t, 0, 1)), {x: t}),
        (Derivative(x * y, x), {x: 2 * z}),
        (Integral(y, (t, 0, 1)), {y: t + 1}),
    ],
    ids=str,
)
def test_circles_and_captured_variables_are_refused(e: Basic, rules: dict[Basic, Basic]) -> None:
    with pytest.raises(CircularError):
        put_in(e, rules)


def test_a_definition_reaches_under_an_integral_that_does_not_bind_it() -> None:
    assert put_in(Integral(x * t, (t, 0, 1)), {x: y}) == Integral(y * t, (t, 0, 1))


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        (Integral(sin(t), (t, 0, x)), Integral(sin(u), (u, 0, x)), True),
        (Integral(sin(t), (t, 0, x)), Integral(sin(t), (t, 0, y)), False),
        (Integral(2 * t, (t, 0, 1)), 2 * Integral(t, (t, 0, 1)), True),
        (Integral(t, (t, 0, 1)), Integral(t, (t, 1, 0)), False),
        (Derivative(x**2, x), Derivative(x**3, x), False),
        (Derivative(sin(x), x), Derivative(sin(x), (x, 2)), False),
        (Subs(x**2, x, y), Subs(x**2, x, z), False),
    ],
    ids=str,
)
def test_what_is_not_opened_is_a_symbol_of_its_own(one: Basic, other: Basic, same: bool) -> None:
    assert (to_expression(one) == to_expression(other)) is same


def test_derivatives_and_values_open_where_they_may() -> None:
    assert to_expression(Derivative(x**2, x), True) == parse("2*x")
    assert to_expression(Subs(x**2 + y, (x, y), (3, z)), True) == parse("9 + z")
    kept = Derivative(Integral(x * t, (t, 0, 1)), x)
    assert to_expression(kept, True) == to_expression(kept)
    assert symbols(to_expression(kept)) != {"x"}
    free = Derivative(y * Integral(t, (t, 0, 1)), y)
    assert symbols(to_expression(free, True)) == symbols(to_expression(Integral(t, (t, 0, 1))))


def test_a_function_that_is_not_known_is_refused() -> None:
    with pytest.raises(ValueError, match="unknown"):
        to_expression(Function("f")(x))


def test_conditions_are_those_of_the_engine() -> None:
    assert to_given((x > 0, y <= 1)) == Given.parse("x > 0, y <= 1")
