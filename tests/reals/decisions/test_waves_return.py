"""What fails where waves return to the same values on the way to infinity."""

from __future__ import annotations

import pytest

import tresym
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

FAIL = [
    "x*sin(x) > 1 as x -> oo",
    "x*sin(x/3) + log(x) > 0 as x -> oo",
    "exp(x)*cos(x) > -x as x -> oo",
    "x*sin(x + 1) > 3 as x -> oo",
    "-x - x**2*cos(2*x) > 0 as x -> -oo",
]
TOUCH = ["cos(x) < 1 as x -> oo", "x*sin(x) != 0 as x -> oo"]
TRUE = [  # the last three would be refuted where waves are taken to return together
    "x + sin(x) > 5 as x -> oo",
    "2*x > x*sin(x) as x -> oo",
    "x*(2 + cos(x)) > sqrt(x) as x -> oo",
    "x*cos(x) + x*cos(sqrt(2)*x) < 2*x as x -> oo",
    "x*(cos(x) + cos(pi*x)) < 2*x as x -> oo",
    "x*(sin(x) + sin(sqrt(3)*x)) != 2*x as x -> oo",
]


@pytest.mark.parametrize("claim", FAIL)
def test_it_fails_at_the_point_that_is_named(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
    left, right = map(parse, claim.split(" as ")[0].split(">"))
    at = evaluate(parse(answer.witness["x"]), {})
    assert evaluate(left - right, {"x": at}) < 0


@pytest.mark.parametrize("claim", TOUCH)
def test_where_it_touches_it_fails(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


@pytest.mark.parametrize("claim", TRUE)
def test_what_is_true_is_not_refuted(claim: str) -> None:
    assert tresym.check(claim).verdict is not Verdict.REFUTED
