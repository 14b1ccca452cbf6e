"""What SymPy suggests, as trees, within a time."""

import pytest

from tresym.reals.decisions import antiderivatives
from tresym.reals.decisions.antiderivatives import suggested
from tresym.reals.language.parsing import parse
from tresym.reals.resource_limits import time_limit


def test_suggestions_are_trees() -> None:
    assert parse("x**2/2") in suggested(parse("x"), "x", frozenset())
    assert parse("log(abs(x))") in suggested(parse("1/x"), "x", frozenset())
    assert parse("sqrt(pi)*erf(x)/2") in suggested(parse("exp(-x**2)"), "x", frozenset())
    assert suggested(parse("exp(-x**2)*sin(sin(x))"), "x", frozenset()) == []
    assert suggested(parse("atan2(x, 1)"), "x", frozenset()) is not None


def test_a_long_search_is_stopped() -> None:
    with (
        pytest.raises(antiderivatives._StoppedError),
        time_limit(0.01, antiderivatives._StoppedError),
    ):
        for _ in range(10**9):
            pass
