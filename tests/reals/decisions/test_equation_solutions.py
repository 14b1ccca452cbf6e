"""Solutions of an equation for a variable: all of them, each under its conditions."""

import pytest

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.equation_solutions import solved

COUNTS = [
    ("x*y - z", "", 2),  # and where both y and z are 0
    ("x*y - 1", "", 1),
    ("x*y - 1", "y > 0", 1),
    ("x**2 - y", "", 2),
    ("exp(x) - y", "", 1),
    ("sin(x) - y", "", 2),
    ("sin(x) - y", "-1 < x, x < 1", 1),
    ("tan(x) - y", "", 1),
    ("x + sin(x) - y", "", 0),
]


@pytest.mark.parametrize(("equation", "given", "count"), COUNTS)
def test_the_number_of_cases(equation: str, given: str, count: int) -> None:
    statement = read(f"{equation} == 0", given)
    assert len(solved(statement.comparisons[0].left, "x", statement) or ()) == count


def test_a_sine_has_its_values_at_whole_turns() -> None:
    statement = read("sin(x) - k == 0")
    cases = solved(statement.comparisons[0].left, "x", statement) or []
    assert [len(case.integers) for case in cases] == [1, 1]
    assert "k" not in cases[0].integers  # a new name
