"""Four verdicts, of which two hold."""

import pytest

from tresym.reals.verdict import Verdict


def test_there_are_four_and_each_is_its_word() -> None:
    assert {v.value for v in Verdict} == {"PROVED", "ENCLOSED", "REFUTED", "UNDECIDED"}
    assert all(Verdict(v.name) is v for v in Verdict)


@pytest.mark.parametrize(
    ("word", "holds"),
    [("PROVED", True), ("ENCLOSED", True), ("REFUTED", False), ("UNDECIDED", False)],
)
def test_undecided_is_no_pass(word: str, holds: bool) -> None:
    assert Verdict(word).holds is holds
