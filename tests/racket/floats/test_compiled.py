"""The compiled map: every function it calls is compiled or given its meaning for numbers."""

import inspect
from types import FunctionType

import pytest

from tresym.racket.floats import float_orbit

compiled = pytest.importorskip("tresym.racket.floats.compiled")

ARRAYS = {"choose", "largest", "least"}


def called_by(name: str) -> set[str]:
    """The functions of the float orbit that one of them calls."""
    code = getattr(float_orbit, name).__code__
    return {x for x in code.co_names if isinstance(getattr(float_orbit, x, None), FunctionType)}


def test_all_that_is_called_is_compiled_or_overloaded() -> None:
    reached, open_ = set(), {"turn_each"}
    while open_:
        reached |= open_
        open_ = set().union(*map(called_by, open_)) - reached
    assert reached == {"turn_each", *compiled.PARTS} | ARRAYS
    assert len(set(compiled.PARTS)) == len(compiled.PARTS)


def test_on_numbers_a_choice_is_a_choice() -> None:
    number = compiled._either(None, None, None)
    assert number(True, 1.0, 2.0) == 1.0
    assert number(False, 1.0, 2.0) == 2.0
    assert compiled._itself(None)(3.5) == 3.5


def test_the_overloads_take_the_arguments_of_what_they_stand_for() -> None:
    for name, made in (("choose", compiled._either), ("largest", compiled._itself)):
        wanted = list(inspect.signature(getattr(float_orbit, name)).parameters)
        assert list(inspect.signature(made).parameters) == wanted
        inner = made(*(None for _ in wanted))
        assert list(inspect.signature(inner).parameters) == wanted
