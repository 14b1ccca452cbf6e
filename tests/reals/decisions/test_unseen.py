"""A fixed part of the lists of tests/unseen.py: no verdict is wrong, and all are given."""

import pytest
from unseen import claims, is_right

import tresym

PART = 15
"""Of so many claims one is asked."""


@pytest.mark.parametrize(("truth", "claim"), claims("orders")[::PART])
def test_orders(truth: bool, claim: str) -> None:
    assert is_right(truth, tresym.check(claim))


@pytest.mark.parametrize(("truth", "claim"), claims("angles")[::PART])
def test_angles(truth: bool, claim: str) -> None:
    assert is_right(truth, tresym.check(claim))


@pytest.mark.parametrize(("truth", "claim"), claims("inequalities")[3::PART])
def test_inequalities(truth: bool, claim: str) -> None:
    assert is_right(truth, tresym.check(claim))
