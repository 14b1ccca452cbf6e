"""Functions by their names: aliases, what is folded, and the errors for other names."""

import pytest

from tresym.reals.language.calls import call
from tresym.reals.language.expression import apply, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError

X = symbol("x")


def test_a_function_has_several_names() -> None:
    assert call("arcsin", [X]) == call("asin", [X]) == apply("asin", X)
    assert call("log", [X, number(2)]) == call("ln", [X]) / call("log", [number(2)])
    assert call("asec", [X]) == call("acos", [1 / X])
    assert call("max", [X, number(1)]) == parse("max(x, 1)")
    assert call("gd", [X]) == parse("2*atan(tanh(x/2))")


@pytest.mark.parametrize(("name", "count"), [("sin", 2), ("nonsense", 1), ("gd", 2), ("sqrt", 0)])
def test_other_calls_are_refused(name: str, count: int) -> None:
    with pytest.raises(InputError, match=name):
        call(name, [X] * count)
