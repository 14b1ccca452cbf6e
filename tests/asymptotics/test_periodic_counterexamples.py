"""What oscillates: failures that return again and again, and limits that do not exist."""

import pytest
from cases import cases

import tresym
from tresym.asymptotics.periodic_counterexamples import failure_where_waves_return
from tresym.reals.decisions.waves import has_no_limit
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import ZERO
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import Path
from tresym.reals.verdict import Verdict

SIDES = {"oo": Path("x", None, (1,)), "-oo": Path("x", None, (-1,)), "0": Path("x", ZERO, (1, -1))}
FAIL = [
    "x*sin(x) > 1 as x -> oo",
    "x*sin(x/3) + log(x) > 0 as x -> oo",
    "exp(x)*cos(x) > -x as x -> oo",
    "x*sin(x + 1) > 3 as x -> oo",
    "-x - x**2*cos(2*x) > 0 as x -> -oo",
]
OSCILLATES = cases(__file__, "OSCILLATES")
DOES_NOT = cases(__file__, "DOES_NOT")


@pytest.mark.parametrize(
    ("difference", "end", "fails"),
    cases(__file__, "what_has_a_period_fails_again_and_again"),
)
def test_what_has_a_period_fails_again_and_again(difference: str, end: str, fails: bool) -> None:
    found = failure_where_waves_return(parse(difference), ">", SIDES[end])
    assert (found is not None) is fails
    if found is not None:
        assert found.verdict is Verdict.REFUTED
        assert found.witness is not None
        at = evaluate(parse(found.witness["x"]), {})
        assert evaluate(parse(difference), {"x": at}) <= 0


def test_a_period_towards_a_point_that_is_open_is_not_looked_for() -> None:
    path = Path("x", parse("a"), (1,))
    assert failure_where_waves_return(parse("sin(1/(x - a))"), ">", path) is None


@pytest.mark.parametrize("claim", FAIL)
def test_it_fails_at_the_point_that_is_named(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
    left, right = map(parse, claim.split(" as ")[0].split(">"))
    at = evaluate(parse(answer.witness["x"]), {})
    assert evaluate(left - right, {"x": at}) < 0


@pytest.mark.parametrize("e", OSCILLATES)
def test_what_oscillates_has_no_limit(e: str) -> None:
    assert has_no_limit(parse(e), "x", 1, Given())


@pytest.mark.parametrize("e", DOES_NOT)
def test_what_has_a_limit_or_may_have_one(e: str) -> None:
    assert not has_no_limit(parse(e), "x", 1, Given())
