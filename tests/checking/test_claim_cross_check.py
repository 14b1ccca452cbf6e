"""The advocate before a user's claim: what is false and called proved is contradicted."""

import pytest
from cases import cases

import tresym
from tresym.checking import dispatch
from tresym.checking.claim_cross_check import attack
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.numbers.exact import Decimal
from tresym.reals.verdict import Verdict


def against(claim: str, constant: str | None = None, region: str | None = None) -> str | None:
    statement = read(claim)
    ball = None if constant is None else Decimal(constant, "1e-9")
    answer = Answer(Verdict.PROVED, "so it is said", constant=ball, region=region)
    (comparison,) = statement.comparisons
    return attack(comparison, statement, answer)


@pytest.mark.parametrize(
    ("true", "false"),
    cases(__file__, "a_claim_and_a_false_one"),
)
def test_a_claim_and_a_false_one(true: str, false: str) -> None:
    assert against(true) is None
    assert "its sides are" in (against(false) or "")


@pytest.mark.parametrize(
    ("claim", "region", "enough", "less"),
    cases(__file__, "a_constant_and_one_too_small"),
)
def test_a_constant_and_one_too_small(claim: str, region: str, enough: str, less: str) -> None:
    assert against(claim, enough, region) is None
    assert "violates the bound" in (against(claim, less, region) or "")


def test_an_order_without_constant_or_region_says_nothing_of_a_point() -> None:
    assert against("2*x == O(x) as x -> 0", constant="1") is None
    assert against("2*x == O(x) as x -> 0", region="0 < x <= 1") is None


def test_points_at_which_a_side_is_not_real_are_left_out() -> None:
    assert against("sqrt(x) == O(1) as x -> 0", "1", "0 < |x| <= 1") is None
    assert against("sqrt(x) == O(1) as x -> 0", "0.9", "0 < |x| <= 1") is not None


@pytest.mark.parametrize(
    ("true", "false"),
    cases(__file__, "a_limit_and_a_false_one"),
)
def test_a_limit_and_a_false_one(true: str, false: str) -> None:
    assert against(true) is None
    assert "contradict it" in (against(false) or "")


FALSE_ALONG_PATHS = cases(__file__, "FALSE_ALONG_PATHS")


@pytest.mark.parametrize("claim", FALSE_ALONG_PATHS)
def test_numbers_along_the_path_stop_what_is_false(
    claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever the deciders say."""
    assert tresym.check(claim).verdict in (Verdict.REFUTED, Verdict.UNDECIDED)
    monkeypatch.setattr(dispatch, "_decide", lambda *_: Answer(Verdict.PROVED, "so it is said"))
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


TRUE_ALONG_PATHS = cases(__file__, "TRUE_ALONG_PATHS")


@pytest.mark.parametrize("claim", TRUE_ALONG_PATHS)
def test_numbers_along_the_path_do_not_stop_what_is_true(claim: str) -> None:
    assert against(claim) is None


@pytest.mark.parametrize(
    "claim",
    cases(__file__, "it_stops_each_family_alone"),
)
def test_it_stops_each_family_alone(monkeypatch: pytest.MonkeyPatch, claim: str) -> None:
    monkeypatch.setattr(dispatch, "_decide", lambda *_: Answer(Verdict.PROVED, "so it is said"))
    monkeypatch.setattr(dispatch, "beyond_positive_bases", lambda answer, *_: answer)
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.UNDECIDED
    assert "please report" in answer.why
