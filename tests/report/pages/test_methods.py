"""The page on deciding says of each method what it does, and its example is one it decides."""

from collections.abc import Callable
from typing import Any

import pytest
from falsehoods import read

from tresym.reals.signs.sign import DIRECT, METHODS, directly, proof
from tresym.report.pages.methods import example, methods

EXAMPLES = [(method, example(method)) for method in METHODS]


@pytest.mark.parametrize(("method", "claim"), EXAMPLES, ids=[m.__name__ for m in METHODS])
def test_a_method_decides_its_example(method: Callable[..., Any], claim: str) -> None:
    left, relation, right, given = read(claim)
    ask = directly if method in DIRECT else proof
    assert method(left - right, relation, given, ask) is not None


def test_every_method_is_on_the_page() -> None:
    page = methods().splitlines()
    assert len(page) == len(METHODS)
    assert all(line.startswith("- **") and "Decides `" in line and "Ends " in line for line in page)
