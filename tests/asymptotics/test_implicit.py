"""Claims about roots in tubes, two unknowns, recurrences, and under premises with O, o and ~."""

from __future__ import annotations

from pathlib import Path

import pytest

from tresym.checking.dispatch import decide_claim
from tresym.reals.numbers.exact import InputError

DATA = Path(__file__).parent.parent / "data" / "asymptotics"
ALLOWED = {"H": ("PROVED", "ENCLOSED"), "F": ("REFUTED",), "N": ("UNDECIDED",)}


def _lines(name: str) -> list[str]:
    lines = (DATA / name).read_text().splitlines()
    return [line for line in lines if line and not line.startswith("#")]


@pytest.mark.parametrize(
    "line",
    [
        pytest.param(
            line, marks=[pytest.mark.night] if k % 8 or line[0] == "N" or "exp(x*y)" in line else []
        )
        for name in ("implicit_unseen.txt", "implicit_more.txt")
        for k, line in enumerate(_lines(name), start=name == "implicit_more.txt")
    ],
)
def test_statements_of_textbooks(line: str) -> None:
    kind, _, claim = line.partition(" ")
    assert decide_claim(claim).verdict.value in ALLOWED[kind]


@pytest.mark.parametrize(
    "claim",
    [
        pytest.param(claim, marks=[pytest.mark.night] if k % 6 and k < 146 else [])
        for k, claim in enumerate(_lines("implicit_guards.txt"))
    ],
)
def test_guards_let_nothing_false_pass(claim: str) -> None:
    assert not decide_claim(claim)


def test_a_premise_needs_a_path() -> None:
    with pytest.raises(InputError, match="needs a path"):
        decide_claim("y > 0 given y == x + O(1)")


def test_a_refutation_under_a_premise_names_the_function() -> None:
    answer = decide_claim("y**2 == x**2 + O(1) given y == x + O(1) as x -> oo")
    assert answer.witness is not None
    assert answer.witness["y"] == "x + 1"
