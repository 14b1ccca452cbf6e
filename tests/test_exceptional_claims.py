"""False claims at exceptional values: none of a list is accepted; a sample of the hunt is right."""

import random
from collections.abc import Callable
from pathlib import Path

import exceptional_claims
import pytest

import tresym
from tresym.reals.verdict import Verdict

LINES = (Path(__file__).parent / "data" / "exceptional.txt").read_text(encoding="utf-8")
FALSE = [line for line in LINES.splitlines() if line and not line.startswith("#")]


@pytest.mark.parametrize("claim", FALSE[::6])
@pytest.mark.slow
def test_no_false_claim_is_accepted(claim: str) -> None:
    assert not tresym.check(claim)


@pytest.mark.night
@pytest.mark.parametrize("claim", FALSE)
def test_none_of_all_is_accepted_or_laid_at_our_door(claim: str) -> None:
    found = tresym.check(claim)
    assert not found
    assert "please report" not in found.why


@pytest.mark.parametrize("kind", dict.fromkeys(exceptional_claims.KINDS))
@pytest.mark.slow
def test_no_verdict_on_a_sample_is_wrong(
    kind: Callable[[random.Random], tuple[str, bool | None]],
) -> None:
    dice = random.Random(2026)
    for _ in range(4):
        text, truth = kind(dice)
        found = tresym.check(text)
        assert "please report" not in found.why, text
        if found.verdict is not Verdict.UNDECIDED and truth is not None:
            assert bool(found) is truth, (text, found.why)
