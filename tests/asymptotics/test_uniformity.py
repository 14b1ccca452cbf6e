"""Uniform and pointwise orders, orders in several variables, and orders between monomials."""

from __future__ import annotations

from pathlib import Path

import pytest
from cases import cases

import tresym
from tresym.checking.dispatch import decide_claim
from tresym.reals.numbers.exact import InputError

DATA = Path(__file__).parent.parent / "data" / "asymptotics" / "uniformity.txt"
KINDS = {
    "UNIFORM": ("PROVED", "ENCLOSED"),
    "FIXED": ("PROVED", "ENCLOSED"),
    "FALSE": ("REFUTED",),
    "NONE": ("UNDECIDED",),
}


def _rows() -> list[tuple[str, str]]:
    lines = (line.partition(" ") for line in DATA.read_text().splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in KINDS]


SLOW = ("abs(y))**3", "exp(x*y)", "x**4 + y**2", "x**2*y/(x**2 + y**2)")


@pytest.mark.parametrize(
    ("kind", "claim"),
    [
        pytest.param(*row, marks=[pytest.mark.night] if any(e in row[1] for e in SLOW) else [])
        for row in _rows()
    ],
)
def test_orders_with_parameters(kind: str, claim: str) -> None:
    answer = decide_claim(claim)
    assert answer.verdict.value in KINDS[kind]
    if kind in ("UNIFORM", "FIXED"):
        assert answer.uniform is (kind == "UNIFORM")
    if kind == "FIXED":
        assert "not uniformly" in answer.why


def test_the_constants_of_monomials_are_the_best_ones() -> None:
    best = {
        "a**2*b == O(a**3 + b**3) given a > 0, b > 0": 2 ** (2 / 3) / 3,
        "a*b == O(a**2 + b**2) given a > 0, b > 0": 1 / 2,
        "(a*b*c)**(1/3) == O(a + b + c) given a > 0, b > 0, c > 0": 1 / 3,
    }
    for claim, truth in best.items():
        constant = decide_claim(claim).constant
        assert constant is not None
        assert abs(float(constant.mid) - truth) < 1e-9


def test_uniformly_is_read_and_written_again() -> None:
    answer = tresym.check("sin(a*x) == a*x + O(x**3) given 0 < a, a < 1 uniformly as x -> 0")
    assert " uniformly as x -> 0" in answer.read_as
    assert tresym.check(answer.read_as).read_as == answer.read_as


@pytest.mark.parametrize(
    "claim",
    cases(__file__, "what_is_no_claim_is_refused"),
)
def test_what_is_no_claim_is_refused(claim: str) -> None:
    with pytest.raises(InputError):
        tresym.check(claim)
