"""Claims about sequences that recurrences determine: linear ones, and divide and conquer."""

from __future__ import annotations

from fractions import Fraction
from itertools import islice
from pathlib import Path

import pytest
from flint import fmpq

from tresym.asymptotics.linear_recurrences import Solved
from tresym.checking.dispatch import decide_claim
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import number, substitute, symbol
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

DATA = Path(__file__).parent.parent / "data" / "asymptotics"
FILES = (
    "linear_recurrences.txt",
    "divide_and_conquer.txt",
    "divided_arguments.txt",
    "rounding.txt",
)
KINDS = {"HOLDS": ("PROVED", "ENCLOSED"), "FALSE": ("REFUTED",), "NONE": ("UNDECIDED",)}
REFUSED = "REFUSED"


def _rows() -> list[tuple[str, str]]:
    lines = (x.partition(" ") for name in FILES for x in (DATA / name).read_text().splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in (*KINDS, REFUSED)]


@pytest.mark.parametrize(("kind", "claim"), _rows()[::2])
def test_claims_about_recurrences(kind: str, claim: str) -> None:
    _decided_as(kind, claim)


@pytest.mark.night
@pytest.mark.parametrize(("kind", "claim"), _rows()[1::2])
def test_more_claims_about_recurrences(kind: str, claim: str) -> None:
    _decided_as(kind, claim)


def _decided_as(kind: str, claim: str) -> None:
    if kind == REFUSED:
        with pytest.raises(InputError):
            decide_claim(claim)
        return
    assert decide_claim(claim).verdict.value in KINDS[kind]


@pytest.mark.parametrize(
    ("coefficients", "constant", "values", "first"),
    [
        ((6, -5), 0, (1, 2), 0),
        ((-4, -4), 3, (1, 5), 2),  # a double negative root
        ((-1, 3), 0, (1, 1), -1),  # two positive irrational roots
        ((-1, -3), 2, (0, 7), 0),  # two negative ones
        ((2, 0), 1, (1, 4), 0),  # ± sqrt(2)
        ((1, -3, 3), 5, (0, 1, 7), 1),  # a root 1 of multiplicity 4
        ((-1, -2, 1, 2), 0, (1, 0, 0, 3), 0),  # the golden ratio twice
    ],
)
def test_closed_forms_agree_with_the_recurrence(
    coefficients: tuple[int, ...], constant: int, values: tuple[int, ...], first: int
) -> None:
    numbers = [tuple(map(fmpq, row)) for row in (coefficients, values)]
    sequence = Solved(symbol("a"), "n", first, 0, numbers[0], fmpq(constant), numbers[1])
    form = sequence.closed()
    assert form is not None
    row = list(map(Fraction, values))
    while len(row) < 12:
        last = row[-len(coefficients) :]
        row.append(constant + sum(c * x for c, x in zip(coefficients, last, strict=True)))
    assert [Fraction(int(x.p), int(x.q)) for x in islice(sequence.terms(), 12)] == row
    with ball_precision():
        for k, value in enumerate(row, first):
            found = evaluate(substitute(form, {"n": number(k)}), {})
            assert abs(found - fmpq(value.numerator, value.denominator)) < 1e-9
