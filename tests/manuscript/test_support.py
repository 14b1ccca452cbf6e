"""An accusation has support; what fails without it is a suspicion."""

from pathlib import Path

import manuscripts
import pytest
from cases import cases

from tresym.manuscript.suspects import proofread
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize(("text", "expected"), cases(__file__, "weighed"))
def test_only_what_is_supported_is_accused(
    text: str, expected: str | Verdict, tmp_path: Path
) -> None:
    rows = proofread(manuscripts.read(tmp_path, text), 5.0, 1)
    wanted = expected.value if isinstance(expected, Verdict) else expected
    assert [row.status for row in rows] == wanted.split()


def test_what_the_author_calls_a_claim_needs_no_other_support(tmp_path: Path) -> None:
    text = "% tresym: claim\n\\[ \\sin s + t = \\sin s + \\cos^3 t \\]"
    (row,) = proofread(manuscripts.read(tmp_path, text), 5.0, 1)
    assert row.status == "REFUTED"
