"""Vectors and matrices that are written out are read by components."""

from pathlib import Path

import pytest
from cases import cases
from manuscripts import statuses


@pytest.mark.parametrize(("text", "expected"), cases(__file__, "by_components"))
def test_components_are_compared(text: str, expected: str, tmp_path: Path) -> None:
    assert ["links", *statuses(tmp_path, text)] == expected.split()
