"""Claims along a path about roots: true ones, false ones, and ones of which nothing may be said."""

from __future__ import annotations

from pathlib import Path

import mpmath
import pytest

import tresym
from tresym.checking.dispatch import decide_claim

DATA = Path(__file__).parent.parent / "data" / "asymptotics" / "roots.txt"


def _rows() -> list[tuple[str, str]]:
    lines = (line.partition(" ") for line in DATA.read_text().splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in ("HOLDS", "FALSE", "NONE")]


@pytest.mark.parametrize(
    ("kind", "claim"),
    [
        pytest.param(*row, marks=[pytest.mark.night] if row[0] != "NONE" and k % 3 else [])
        for k, row in enumerate(_rows())
    ],
)
def test_claims_about_roots(kind: str, claim: str) -> None:
    found = decide_claim(claim).verdict.value
    allowed = {"HOLDS": ("PROVED", "ENCLOSED"), "FALSE": ("REFUTED",), "NONE": ("UNDECIDED",)}
    assert found in allowed[kind]


UNSEEN = DATA.parent / "perturbation_unseen.txt"


def _unseen() -> list[tuple[str, str]]:
    lines = (line.partition(" ") for line in UNSEEN.read_text().splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in ("H", "F", "N")]


@pytest.mark.parametrize(
    ("kind", "claim"),
    [
        pytest.param(*row, marks=[pytest.mark.night] if k % 6 else [])
        for k, row in enumerate(_unseen())
    ],
)
def test_statements_of_textbooks(kind: str, claim: str) -> None:
    allowed = {"H": ("PROVED", "ENCLOSED"), "F": ("REFUTED",), "N": ("UNDECIDED",)}
    assert decide_claim(claim).verdict.value in allowed[kind]


@pytest.mark.parametrize(
    ("claim", "region", "function"),
    [
        (
            "y == 1 - e/5 - e**2/25 + O(e**3) given y**5 + e*y == 1, y > 0 as e -> 0+",
            "0 < e <= 1",
            lambda e: (
                (mpmath.findroot(lambda y: y**5 + e * y - 1, 0.9) - 1 + e / 5 + e**2 / 25) / e**3
            ),
        ),
        (
            "w == x - x**2 + O(x**3) given w*exp(w) == x, w > 0 as x -> 0+ on 0 < x <= 1/2",
            "0 < x <= 1/2",
            lambda x: (mpmath.lambertw(x).real - x + x**2) / x**3,
        ),
    ],
)
def test_the_constant_is_the_supremum(claim: str, region: str, function: object) -> None:
    answer = tresym.check(claim)
    assert answer.region == region
    assert answer.constant is not None
    end = mpmath.mpf(1) if region.endswith(" 1") else mpmath.mpf(1) / 2
    with mpmath.workdps(40):
        truth = max(abs(function(end * k / 100)) for k in range(1, 101))  # type: ignore[operator]
        high = mpmath.mpf(answer.constant.mid) + mpmath.mpf(answer.constant.rad)
        assert truth * (1 - mpmath.mpf("1e-9")) <= high <= truth * 1.05


def test_a_parameter_in_terms_of_the_root_stays_fixed() -> None:
    # For fixed u the claim is another one than for fixed m, whose root u moves.
    answer = decide_claim("u == m + e*sin(m) + O(e**2) given m == u - e*sin(u) as e -> 0")
    assert answer.lemma.startswith("residual")


def test_the_answer_says_what_is_missing() -> None:
    why = decide_claim("y -> 1 given y**2 == 1 + e as e -> 0").why
    assert why.startswith("2 roots satisfy the conditions near the end of the path")
