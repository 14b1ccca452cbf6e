"""Claims about solutions of initial value problems, exact and with a small parameter."""

from __future__ import annotations

from pathlib import Path

import mpmath
import pytest

from tresym.checking.dispatch import decide_claim

DATA = Path(__file__).parent.parent / "data" / "asymptotics"
KINDS = {
    "HOLDS": ("PROVED", "ENCLOSED"),
    "UNIFORM": ("PROVED", "ENCLOSED"),
    "FALSE": ("REFUTED",),
    "NONE": ("UNDECIDED",),
}


def _rows() -> list[tuple[str, str]]:
    texts = [
        (DATA / f"{name}.txt").read_text() for name in ("initial_values", "layers", "slow_times")
    ]
    lines = (line.partition(" ") for text in texts for line in text.splitlines())
    return [(kind, claim) for kind, _, claim in lines if kind in KINDS]


@pytest.mark.parametrize(("kind", "claim"), _rows())
def test_claims_about_initial_value_problems(kind: str, claim: str) -> None:
    answer = decide_claim(claim)
    assert answer.verdict.value in KINDS[kind]
    if kind in ("HOLDS", "UNIFORM"):
        assert answer.lemma
        assert (answer.uniform is True) == (kind == "UNIFORM")


def test_the_uniform_constant_bounds_the_error_of_a_numerical_solution() -> None:
    answer = decide_claim(
        "y(t) == exp(-t) + e*(exp(-t) - exp(-2*t)) + O(e**2) given "
        "diff(y(t), t) == -y(t) + e*y(t)**2, y(0) == 1, t >= 0 as e -> 0+"
    )
    assert answer.region == "t >= 0, 0 < e <= 1/100"
    assert answer.constant is not None
    high = float(answer.constant.mid) + float(answer.constant.rad)
    assert high < 1.1 * 4 / 27  # the supremum of the next term, exp(-t)*(1 - exp(-t))**2
    with mpmath.workdps(30):
        high = mpmath.mpf(answer.constant.mid) + mpmath.mpf(answer.constant.rad)
        for e in (mpmath.mpf(1) / 100, mpmath.mpf(1) / 200):
            for t in range(8):
                exact = 1 / (mpmath.exp(t) * (1 - e) + e)  # Bernoulli's equation
                a = mpmath.exp(-t) + e * (mpmath.exp(-t) - mpmath.exp(-2 * t))
                assert abs(exact - a) <= high * e**2
