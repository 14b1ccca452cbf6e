"""Power series: the equation, the coefficients that it leaves open, and the range are needed."""

from contextlib import suppress

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.power_series import decide_power_series
from tresym.reals.verdict import Verdict

FALSE = cases(__file__, "FALSE")


@pytest.mark.parametrize("claim", FALSE)
def test_series_that_are_false(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


def test_the_values_shown_are_those_of_the_two_sides() -> None:
    for claim, left, right in (
        ("25 == sum(k**3/2**k, k, 1, oo)", 25, 26),
        ("sum(k**3/2**k, k, 1, oo) == 25", 26, 25),
    ):
        values = tresym.check(claim).values
        assert values is not None
        assert [round(float(ball.mid)) for ball in values] == [left, right]
    assert tresym.check("2*sum(k**3/2**k, k, 1, oo) == 50").values is None


def test_the_range_is_part_of_the_claim() -> None:
    """What holds by equation and coefficients is refused without the range, and at its ends."""
    for under in ("", " given x > -1/2", " given -1 <= x < 1"):
        statement = read(f"log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo){under}")
        claim = statement.comparisons[0]
        found = decide_power_series(claim.left, claim.right, statement.given)
        assert found.verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    "claim",
    [
        "diff(sum(x**n, n, 0, oo), x) == 1",
        "sum(x**n, n, 0, oo) > 0 given 0 < x < 1",
        "sum(x**n, n, 0, oo)**2 == 1/(1 - x)**3 given 0 < x < 1",
        "sum(sin(n), n, 0, oo) == 1",
    ],
)
def test_what_is_left_open_or_refused(claim: str) -> None:
    with suppress(tresym.InputError):
        assert not tresym.check(claim)
