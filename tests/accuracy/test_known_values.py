"""Integrals, roots, sums and functions of a list, to 50 digits against mpmath at 80."""

from pathlib import Path

import mpmath
import pytest

import tresym

LIST = Path(__file__).parents[1] / "data" / "values.txt"
KNOWN = [
    tuple(part.strip() for part in line.split("|", 1))
    for line in LIST.read_text(encoding="utf-8").splitlines()
    if not line.startswith("#")
]
EVERY = 4
"""One in so many is tried in every run, the others at night."""


def agree(text: str, closed: str) -> None:
    found = tresym.value(text, 50)
    with mpmath.workdps(80):
        names = {name: getattr(mpmath, name) for name in dir(mpmath) if not name.startswith("_")}
        truth = mpmath.mpf(getattr(value := eval(closed, names), "real", value))
        last = mpmath.mpf(10) ** (mpmath.floor(mpmath.log10(abs(truth))) - 49)
        assert abs(mpmath.mpf(found.text) - truth) <= last * mpmath.mpf("0.5000001")


@pytest.mark.parametrize(("text", "closed"), KNOWN[::EVERY])
def test_every_digit_is_right(text: str, closed: str) -> None:
    agree(text, closed)


@pytest.mark.night
@pytest.mark.parametrize(("text", "closed"), [row for n, row in enumerate(KNOWN) if n % EVERY])
def test_every_digit_of_the_others_is_right(text: str, closed: str) -> None:
    agree(text, closed)
