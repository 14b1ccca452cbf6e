"""Equalities of complex numbers are compared by real and imaginary parts."""

from pathlib import Path

import pytest
from cases import cases
from manuscripts import read

from tresym.manuscript.aftermath import settled


@pytest.mark.parametrize(("text", "expected"), cases(__file__, "in_parts"))
def test_real_and_imaginary_parts_are_compared(text: str, expected: str, tmp_path: Path) -> None:
    found = [row.status for row in settled(read(tmp_path, text), 5.0, 1)]
    assert ["links", *found] == expected.split()
