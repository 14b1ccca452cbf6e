"""One misprint is told once, and proves nothing."""

from dataclasses import replace
from pathlib import Path

import manuscripts
import pytest
from cases import cases

from tresym.manuscript.aftermath import settled
from tresym.manuscript.suspects import proofread
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize(("text", "expected"), cases(__file__, "told_once"))
def test_one_misprint_is_told_once(text: str, expected: str | Verdict, tmp_path: Path) -> None:
    rows = proofread(manuscripts.read(tmp_path, text), 5.0, 1)
    wanted = expected.value if isinstance(expected, Verdict) else expected
    assert [row.status for row in rows] == wanted.split()


def test_what_follows_from_an_accused_line_is_not_proved(tmp_path: Path) -> None:
    text = "\\[ 2x + 3y = 7 \\]\n and so \n\\[ 4x + 6y = 14 \\]"
    first, second = manuscripts.read(tmp_path, text)
    assert second.status == "PROVED"
    accused = replace(first, status="SUSPECT")
    assert settled([accused, second], 5.0, 1)[1].status == "UNDECIDED"
    assert settled([first, second], 5.0, 1)[1].status == "PROVED"
