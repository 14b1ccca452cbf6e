"""An answer gives what its claim asks for: a region, every point, every word of a condition."""

from pathlib import Path

import pytest

import tresym
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Cause, Verdict

LINES = (Path(__file__).parents[1] / "data" / "promises.txt").read_text(encoding="utf-8")
PROMISES = [line.split(" | ", 1) for line in LINES.splitlines() if not line.startswith("#")]


def test_a_constant_on_the_region_is_found_where_there_is_one() -> None:
    answer = tresym.check("exp(a*x) == 1 + O(x) given 0 < a, a < 1 as x -> 0+ on 0 < x <= 1")
    assert answer
    assert answer.constant is not None
    assert float(answer.constant.mid) >= 1.71828  # e − 1, at a = x = 1
    assert answer.region == "0 < x <= 1"


def test_uniformly_with_one_constant_still_holds() -> None:
    answer = tresym.check("sin(a*x) == a*x + O(x**3) given 0 < a, a < 1 uniformly as x -> 0")
    assert answer.uniform


@pytest.mark.parametrize(
    "claim",
    [
        "x**n >= 0 for all even n",
        "n > 1 for all prime n",
        "x > 1/2 for all x greater than 1",
        "x**2 == 2 for some x",
        "x >= 0 for all real x and y > 0",
        "x >= 0 given real x, y > 0",
        "sin(E) == 2*E + O(E**3) as E -> 0",
        "cos(pi) -> -1 as pi -> 0",
    ],
)
def test_a_word_that_is_not_understood_is_refused(claim: str) -> None:
    with pytest.raises(InputError):
        tresym.check(claim)


def test_a_witness_is_one_of_the_variable_that_was_written() -> None:
    answer = tresym.check("lambertw(x) ~ log(x)/2 as x -> oo")
    assert answer.witness == {"x": "16*exp(16)"}


def test_of_two_bounds_of_the_time_the_smaller_one_counts() -> None:
    equation = "diff(y(t), t) == e*y(t), y(0) == 1, 0 <= t, t <= 1"
    one, two = (
        tresym.check(f"y(t) == 1 + O(e) given {equation}{more} uniformly as e -> 0+").constant
        for more in ("", ", t <= 5")
    )
    assert one is not None
    assert two is not None
    assert one.mid == two.mid


@pytest.mark.parametrize(
    "claim",
    [
        "sum(k**a*exp(-k*x), k, 1, oo) ~ gamma(a+1)/x**(a+1) as x -> 0+",
        "besselk(a+1, x) > besselk(a, x) given x > 0, a >= 0",
        "sum(exp(-k**2), k, -oo, oo) > 1",
    ],
)
def test_a_true_claim_beyond_the_methods_is_left_open(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is not Verdict.REFUTED
    assert answer.cause is not Cause.FAILED


def _found(claim: str) -> str:
    try:
        verdict = tresym.check(claim).verdict
    except InputError:
        return "refused"
    return "holds" if verdict.holds else {Verdict.REFUTED: "refuted"}.get(verdict, "open")


@pytest.mark.parametrize(("expected", "claim"), PROMISES)
def test_what_an_answer_promises(expected: str, claim: str) -> None:
    assert _found(claim) == expected


@pytest.mark.parametrize(
    ("claim", "words", "not_said"),
    [
        ("integral(exp(a*t**3), t, 0, 1) != 1", "are equal", "differ"),
        ("integral((cos(t) - cos(-t))/t, t, 0, oo) == 0", "normal form", "Gradshteyn"),
        ("(-1)**n*n > 5 given n integer as n -> oo", "n = 2*m + 1", "all n"),
        ("n + (-1)**n ~ n + n/100 given n integer as n -> oo", "like 2*m", "like 2*n"),
    ],
)
def test_a_reason_names_what_is_so(claim: str, words: str, not_said: str) -> None:
    why = tresym.check(claim).why
    assert words in why
    assert not_said not in why


@pytest.mark.parametrize(
    ("claim", "smallest", "sharp"),
    [
        ("exp(x) == 1 + O(x) as x -> 0 on abs(x) <= 1", 1.7182818, True),  # e − 1
        ("exp(a*x) == 1 + O(x) given 0 < a, a < 1 uniformly as x -> 0", 1.0517, False),
    ],
)
def test_an_answer_says_whether_its_constant_is_sharp(
    claim: str, smallest: float, sharp: bool
) -> None:
    answer = tresym.check(claim)
    assert answer.sharp is sharp
    assert answer.constant is not None
    top = float(answer.constant.mid) + float(answer.constant.rad)
    assert top >= smallest
    assert not sharp or top <= 1.02 * smallest
