"""Claims about special functions, true or false by mpmath at 40 digits: none is decided wrongly."""

from __future__ import annotations

from pathlib import Path

import pytest
from in_mpmath import DIGITS, is_true_at_points, value

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import Statement
from tresym.reals.numbers.arithmetic import mp_precision
from tresym.reals.verdict import Verdict

FILE = Path(__file__).parents[2] / "data" / "claims" / "special.txt"
LINES = [
    (truth.strip() == "true", claim.strip())
    for truth, claim in (
        line.split("|", 1)
        for line in FILE.read_text(encoding="utf-8").splitlines()
        if line.strip() and not line.startswith("#")
    )
]
BY_DEFAULT = LINES[::9]
LEAST = 0.97
"""The share of all claims that must be decided."""


def is_true_along_path(statement: Statement) -> bool:
    """Whether the numbers along the path behave as the claim says."""
    (comparison,), path = statement.comparisons, statement.path
    assert path is not None
    found = []
    with mp_precision(DIGITS) as m:
        for k in (3, 5, 7) if path.point is not None else (2, 4, 6):
            size = m.mpf(2) ** -k / 3 if path.point is not None else m.mpf(3) ** (k / 2) + k
            base = value(m, path.point, {}) if path.point is not None else 0
            at = {path.name: base + path.sides[0] * size}
            x, y = (m.re(value(m, e, at)) for e in (comparison.left, comparison.right))
            match comparison.relation:
                case "O":
                    found.append(abs(x / y))
                case "o":
                    found.append(abs(x / y) ** m.mpf(0.5))
                case "~":
                    found.append(abs(x / y - 1))
                case _:
                    found.append(abs(x - y))
    _, middle, last = found
    if comparison.relation == "O":
        return bool(last < 1.7 * middle + 1e-20)
    return bool(last < 0.7 * middle or last < 1e-12)


BY_DLMF = ("integral(", "li(x) ==", "Ci(x) ->", "besselj(0, x) == sqrt", "besselk(0, x) ~")
"""Claims that no few numbers confirm: integrals, and limits that are approached slowly."""


def is_true(claim: str) -> bool | None:
    """The truth by mpmath; None where the list takes it from DLMF."""
    if claim.startswith(BY_DLMF):
        return None
    if " as " in claim:
        return is_true_along_path(read(claim))
    return is_true_at_points(claim)


def decided(truth: bool, claim: str) -> bool:
    """Whether a claim is decided; it must not be decided wrongly."""
    found = tresym.check(claim).verdict
    assert found is not (Verdict.REFUTED if truth else Verdict.PROVED), claim
    assert truth or found is not Verdict.ENCLOSED, claim
    return found is not Verdict.UNDECIDED


@pytest.mark.parametrize(("truth", "claim"), BY_DEFAULT)
def test_claims_are_decided_as_mpmath_finds_them(truth: bool, claim: str) -> None:
    assert is_true(claim) in (truth, None), claim
    assert decided(truth, claim), claim


@pytest.mark.night
def test_nearly_all_claims_are_decided_and_none_wrongly() -> None:
    wrong = [claim for truth, claim in LINES if is_true(claim) not in (truth, None)]
    assert not wrong
    count = sum(decided(truth, claim) for truth, claim in LINES)
    assert count >= LEAST * len(LINES)


def test_a_third_of_the_claims_is_false() -> None:
    assert len(LINES) >= 200
    assert 3 * sum(not truth for truth, _ in LINES) >= len(LINES) - 3
