"""Expected values and variances are integrals of the distribution that the text states."""

from pathlib import Path

import pytest
from cases import cases
from manuscripts import statuses


@pytest.mark.parametrize(("words", "formula", "status"), cases(__file__, "expected"))
def test_expected_values_are_integrals(
    words: str, formula: str, status: str, tmp_path: Path
) -> None:
    assert statuses(tmp_path, rf"{words} \[ {formula} \]") == [status.rstrip(".")]
