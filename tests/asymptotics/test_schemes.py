"""Orders and error bounds of schemes for every smooth f: lists, leading errors and refusals."""

from __future__ import annotations

from pathlib import Path

import pytest

import tresym
from tresym.checking.dispatch import decide_claim

LISTS = Path(__file__).parent.parent / "data" / "asymptotics"
VERDICTS = {"true": "PROVED", "false": "REFUTED", "open": "UNDECIDED"}
LINES = [
    line
    for name in ("schemes.txt", "peano.txt")
    for line in (LISTS / name).read_text().splitlines()
    if not line.startswith("#")
]


@pytest.mark.parametrize("line", LINES)
def test_scheme(line: str) -> None:
    truth, claim = line.split(maxsplit=1)
    assert decide_claim(claim).verdict.value == VERDICTS[truth]


def test_systems() -> None:
    """Scalar equations do not tell f_y(f_yy(f, f)) from f_yy(f, f_y(f)), systems do."""
    found = tresym.check(
        "y(t+h) == y(t) + h/8*(k1 + 3*k2 + 3*k3 + k4) + O(h**5) as h -> 0",
        given="diff(y(t), t) == f(y(t)), k1 == f(y(t)), k2 == f(y(t) + h/3*k1),"
        "k3 == f(y(t) + h*(k1 - k2/3)), k4 == f(y(t) + h*(-7*k1 + 11*k2 - 3*k3))",
    )
    assert found.verdict.value == "PROVED"
    assert "for systems of equations the error is of order h**4: f_y(f_yy(f, f))" in found.why
    heun = "y(t+h) == y(t) + h/2*(f(y(t)) + f(y(t) + h*f(y(t)))) + O(h**3) as h -> 0"
    assert "also for systems" in tresym.check(heun, given="diff(y(t), t) == f(y(t))").why
    product = "y(t+h) == y(t) + h*f(y(t))*y(t)/y(t) + O(h**2) as h -> 0"
    assert "systems" not in tresym.check(product, given="diff(y(t), t) == f(y(t))").why
