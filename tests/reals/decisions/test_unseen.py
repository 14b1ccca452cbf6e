"""A fixed part of the lists of tests/unseen.py: no verdict is wrong, and all are given."""

import pytest
from finite_claims import KINDS
from hunt import built, is_wrong
from unseen import LISTS, claims, is_right

import tresym

PART = 20
"""Of so many claims one is asked."""


PARTS = [
    pytest.param(*claim, id=f"{path.stem}-{n}")
    for path in sorted(LISTS.glob("*.txt"))
    for n, claim in enumerate(claims(path.stem)[3::PART])
]


@pytest.mark.parametrize(("truth", "claim"), PARTS)
@pytest.mark.slow
def test_a_part_of_each_list(truth: bool, claim: str) -> None:
    assert is_right(truth, tresym.check(claim))


@pytest.mark.parametrize("n", range(3 * len(KINDS)))
@pytest.mark.slow
def test_random_claims_of_finite_objects(n: int) -> None:
    _, claim, truth = built(3 * len(KINDS), 1, KINDS)[n]
    assert not is_wrong(truth, tresym.check(claim).verdict.value), claim
