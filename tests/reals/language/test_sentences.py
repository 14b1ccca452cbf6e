"""What newcomers type: read and shown in the grammar, or refused with what to write instead."""

from __future__ import annotations

import pytest

import tresym
from tresym.reals.language.sentences import spelled, spelled_conditions
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

READ = [
@READ@
]

REFUSED = [
@REFUSED@
]


@pytest.mark.parametrize(("claim", "shown"), READ)
def test_what_newcomers_type_is_read_and_shown(claim: str, shown: str) -> None:
    assert tresym.reals.decisions.claim_parsing.read(claim).read_as == shown


@pytest.mark.parametrize(("claim", "advice"), REFUSED)
def test_what_can_be_read_in_two_ways_is_refused_with_both(claim: str, advice: str) -> None:
    with pytest.raises(InputError) as found:
        tresym.check(claim)
    assert str(found.value) == advice


def test_the_conditions_apart_are_read_as_the_claim_is() -> None:
    for given in ("x in [0, 1]", "0 <= x and x <= 1", "x ∈ [0,1]"):
        assert tresym.check("x^2 <= x", given).verdict is Verdict.PROVED
    assert tresym.check("a + b >= 0", "a,b >= 0").verdict is Verdict.PROVED
    assert spelled_conditions("n positive integer") == "n > 0, n integer"
    assert spelled_conditions("x") is None


@pytest.mark.parametrize(
    "claim",
    [
        "sin 2x = 2 sin x",
        "(x^2)' = x",
        "integrate(x**2, (x, 0, 1)) == 1/2",
        "x^2 > x for x in [0, 3]",
        "n! = n^2 for all positive integers n",
        "lim x->0 sin(2x)/x = 1",
        "2|x| = 2x",
        "e^x < 1 + x for x > 0",
    ],
)
def test_false_claims_of_newcomers_are_refuted(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


def test_an_echo_is_shown_with_the_answer() -> None:
    assert ("read as", "2*x + 3*x == 5*x") in tresym.check("2x + 3x = 5x").rows()


@pytest.mark.parametrize("text", ["(" * 5000 + "2x = 1", "2x" * 5000, "sin " * 500 + "x = 1", "||" * 200])
def test_long_and_deep_text_is_left_to_the_strict_reader(text: str) -> None:
    assert spelled(text) is None
    with pytest.raises(InputError) as found:
        tresym.check(text)
    assert len(str(found.value)) < 400
