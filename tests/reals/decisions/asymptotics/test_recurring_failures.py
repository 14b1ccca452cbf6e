"""Failures that return: what has a period fails again and again."""

from __future__ import annotations

import pytest

from tresym.reals.decisions.asymptotics.recurring_failures import periodic_failure
from tresym.reals.decisions.statement import Path
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import ZERO
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

SIDES = {"oo": Path("x", None, (1,)), "-oo": Path("x", None, (-1,)), "0": Path("x", ZERO, (1, -1))}


@pytest.mark.parametrize(
    ("difference", "end", "fails"),
    [
        ("sin(x)", "oo", True),
        ("sin(x) + sin(2*x) + 1/2", "-oo", True),
        ("sin(1/x) + 1/2", "0", True),
        ("2 + sin(x)", "oo", False),
        ("sin(x/2) + 1/2", "oo", False),  # it has another period
        ("x*sin(x)", "oo", False),
        ("1 - x*sin(1/x)", "0", False),
        ("sin(x) + a", "oo", False),
        ("sqrt(sin(x)) - 2", "-oo", True),  # where it is real
    ],
)
def test_what_has_a_period_fails_again_and_again(difference: str, end: str, fails: bool) -> None:
    found = periodic_failure(parse(difference), ">", SIDES[end])
    assert (found is not None) is fails
    if found is not None:
        assert found.verdict is Verdict.REFUTED
        assert found.witness is not None
        at = evaluate(parse(found.witness["x"]), {})
        assert evaluate(parse(difference), {"x": at}) <= 0


def test_a_period_towards_a_point_that_is_open_is_not_looked_for() -> None:
    path = Path("x", parse("a"), (1,))
    assert periodic_failure(parse("sin(1/(x - a))"), ">", path) is None
