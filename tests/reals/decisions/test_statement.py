"""Statements: what comparisons and conditions keep, and which variables must be integers."""

import pytest

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import functions, implied_integers
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import ZERO, substitute, symbol
from tresym.reals.language.parsing import as_written, parse
from tresym.reals.signs.interior import is_zero


def test_an_equation_is_solved_for_what_is_linear_in_it() -> None:
    (comparison,) = read("2*x + y == 3*z").comparisons
    found = comparison.solved(symbol("x"))
    assert found is not None
    value, coefficient = found
    assert is_zero(value - parse("(3*z - y)/2"), Given())
    assert coefficient == parse("2")
    (comparison,) = read("x**2 + y == 3*z").comparisons
    assert comparison.solved(symbol("x")) is None


@pytest.mark.parametrize("text", ["y > 0 given x > 1, x < y", "y > 0 given x == y, n integer"])
def test_the_conditions_are_shown(text: str) -> None:
    statement = read(text)
    assert read("y > 0", statement.under) == read(text) or statement.under
    changed = statement.mapped(lambda e: substitute(e, {"x": ZERO}))
    assert "x" not in changed.under


def test_variables_that_must_be_integers() -> None:
    tree = as_written("sum(k, k, 1, n) + factorial(m - 1)")
    assert set(implied_integers([tree])) == {"n", "m"}
    assert implied_integers([as_written("factorial(x**2)")]) == ()
    assert [str(f) for f in functions(as_written("f(x) + 1"))] == ["f(x)"]
