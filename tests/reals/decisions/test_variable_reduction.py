"""Several variables by one: what is reduced, and falsehoods that a wrong reduction would pass."""

from typing import Any

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.inequalities import decide_inequality
from tresym.reals.decisions.variable_reduction import (
    _by_sizes,
    _is_homogeneous,
    _monotone,
    _of_one_part,
    _scaled,
    by_one_variable,
)
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse, parse_claim
from tresym.reals.verdict import Verdict

HOLD = cases(__file__, "HOLD")
FAIL = cases(__file__, "FAIL")


TRUE = cases(__file__, "TRUE")
METHODS = (_scaled, _of_one_part, _monotone, _by_sizes)


def asked(claim: str) -> tuple[Any, ...]:
    """A claim as the methods are asked of it."""
    statement = read(claim)
    (found,) = statement.comparisons
    sides = (found.left, found.right) if ">" in found.relation else (found.right, found.left)
    return sides[0], found.relation.replace("<", ">"), sides[1], statement.given


@pytest.mark.parametrize(("claim", "why"), HOLD)
def test_what_is_said_of_one_variable_holds_of_several(claim: str, why: str) -> None:
    body, _, given = claim.partition(" given ")
    ((left, relation, right),) = parse_claim(body)
    if relation in ("<", "<="):
        left, relation, right = right, relation.replace("<", ">"), left
    answer = by_one_variable(left, relation, right, Given.parse(given), decide_inequality)
    assert answer is not None
    assert answer
    assert why in answer.why


@pytest.mark.parametrize("claim", FAIL)
@pytest.mark.slow
def test_what_fails_is_not_reduced_to_what_holds(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.REFUTED, Verdict.UNDECIDED)
    for method in METHODS:
        assert not method(*asked(claim), decide_inequality)


@pytest.mark.parametrize("claim", [*(claim for claim, _ in HOLD), *TRUE])
def test_what_holds_is_not_refuted_by_what_is_stronger(claim: str) -> None:
    for method in METHODS:
        found = method(*asked(claim), decide_inequality)
        assert found is None or found.verdict is not Verdict.REFUTED


@pytest.mark.parametrize("verdict", [Verdict.UNDECIDED, Verdict.REFUTED])
@pytest.mark.parametrize("claim", [claim for claim, _ in HOLD])
def test_nothing_is_shown_by_what_is_not(claim: str, verdict: Verdict) -> None:
    for method in METHODS:
        assert not method(*asked(claim), lambda *_: Answer(verdict, ""))


def test_several_are_as_sure_as_the_least_sure() -> None:
    claim = "sin(x)*sin(y) <= x*y given x >= 0, y >= 0"
    for last, verdict in ((Verdict.ENCLOSED, Verdict.ENCLOSED), (Verdict.UNDECIDED, None)):
        told = iter([Answer(Verdict.PROVED, ""), Answer(last, "")])
        found = _by_sizes(*asked(claim), lambda *_, told=told: next(told))
        assert (found and found.verdict) is verdict


@pytest.mark.parametrize(
    ("text", "given", "homogeneous"),
    cases(__file__, "what_scales"),
)
def test_what_scales(text: str, given: str, homogeneous: bool) -> None:
    assert _is_homogeneous(parse(text), "x", "y", Given.parse(given)) is homogeneous


def test_a_condition_or_a_domain_that_does_not_scale_is_kept() -> None:
    for claim in (
        "x >= y given x > 0, y > 0, x >= 2, y <= 1",
        "x + 0*sqrt(x - 2) >= y + 0*sqrt(1 - y) given x > 0, y > 0",
    ):
        body, _, given = claim.partition(" given ")
        ((left, relation, right),) = parse_claim(body)
        asked: list[tuple[Any, ...]] = []

        def ask(*question: Any) -> Answer:
            asked.append(question)  # noqa: B023
            return Answer(Verdict.UNDECIDED, "")

        by_one_variable(left, relation, right, Given.parse(given), ask)
        scaled = (parse("x"), ">=", parse("1"))
        assert all(question[:3] != scaled for question in asked)


@pytest.mark.parametrize(
    "claim",
    [
        "atan2(x, -1) >= atan2(y, -1) given x < y",  # each falls where it does not jump
        "atan2(x, -y) <= atan2(x, y) + 4 given y > 0",
        "x - 2*sign(x) >= y - 2*sign(y) - 1 given x > y",
    ],
)
def test_what_jumps_is_not_reduced(claim: str) -> None:
    body, _, given = claim.partition(" given ")
    ((left, _, right),) = parse_claim(body)
    asked = by_one_variable(left, ">=", right, Given.parse(given), decide_inequality)
    assert asked is None


def test_a_refutation_names_a_point_of_both_variables() -> None:
    body, given = "(x - y)/(log(x) - log(y)) <= (x + y)/3", Given.parse("0 < x, x < y")
    ((left, _, right),) = parse_claim(body)
    answer = by_one_variable(right, ">=", left, given, decide_inequality)
    assert answer is not None
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None
    assert sorted(answer.witness) == ["x", "y"]


@pytest.mark.parametrize(
    "under", ["x < 0, y > 0", "x != 0, y != 0, x < y", "x**3 < y**3, x < y, x*y < 0"]
)
def test_a_pole_between_two_places_is_not_passed_over(under: str) -> None:
    """1/x − x falls on both sides of 0, and not from one to the other."""
    given = Given.parse(under)
    left, right = parse("1/x - x"), parse("1/y - y")
    found = by_one_variable(left, ">=", right, given, decide_inequality)
    assert found is None or not found


BESIDE = cases(__file__, "BESIDE")


@pytest.mark.parametrize("claim", BESIDE)
def test_what_is_false_is_no_function_of_one_part(claim: str) -> None:
    statement = read(claim)
    (asked,) = statement.comparisons
    turned = asked.relation.startswith("<")
    left, right = (asked.right, asked.left) if turned else (asked.left, asked.right)
    relation = asked.relation.replace("<", ">")
    assert not by_one_variable(left, relation, right, statement.given, decide_inequality)


@pytest.mark.parametrize("claim", TRUE[:-1])
def test_several_variables_are_decided_without_a_reduction(claim: str) -> None:
    assert tresym.check(claim)
