"""What a display says beside its formula: ranges of orders, words for integers, shared conditions.

Each line of the list is a text of its own, with the status of its last display.
"""

from pathlib import Path

import pytest
from manuscripts import read

LINES = (Path(__file__).parents[1] / "data" / "displays.txt").read_text(encoding="utf-8")
TEXTS = [line.split(" | ", 1) for line in LINES.splitlines() if not line.startswith("#")]


@pytest.mark.parametrize(("status", "text"), TEXTS)
def test_what_is_said_beside_a_formula_is_used_or_refused(
    status: str, text: str, tmp_path: Path
) -> None:
    row = read(tmp_path, text)[-1]
    assert row.status == status, row.why


@pytest.mark.parametrize("more", [r"- 5 \cdot 2 + 7", r"+ 2 \cdot 3"])
def test_a_sum_that_began_in_the_display_before_is_not_judged_by_its_end(
    more: str, tmp_path: Path
) -> None:
    text = rf"\[ N = 100 - 3 \cdot 20 + 4 \cdot 10 \] %s \[ {more} = 77 \]"
    assert read(tmp_path, text % "")[-1].status == "UNREAD"
    assert read(tmp_path, text % "We also have")[-1].status == "REFUTED"
