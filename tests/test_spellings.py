"""One claim in several spellings has one verdict: spellings are generated from lists of claims.

A spelling of a true claim is never refuted, and one of a false claim never holds; it may be left
open. ``tests/spellings.py`` writes them; ``python tests/deep.py spellings`` tries many more.
"""

from __future__ import annotations

import hunt
import pytest
import spellings

import tresym
from tresym.papers.reading import read_paper
from tresym.papers.verification import verify_paper
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

EACH, MORE = 2, 12
"""How many claims are written in each of the ways of spellings.py: in every run, and in CI."""
TWINS = (
    ("exp(x)*E1(x) ~ 1/x*(1 - 1/(2*x)) as x -> oo", "exp(x)*E1(x) ~ 1/x - 1/(2*x**2) as x -> oo"),
    (
        "gamma(n+1) ~ sqrt(2*pi*n)*(n/E)**n*(1 + 1/(11*n)) as n -> oo",
        "factorial(n) ~ sqrt(2*pi*n)*(n/E)**n*(1 + 1/(11*n)) as n -> oo",
    ),
    ("sin(x) ~ x*(1 - x**2/7) as x -> 0", "sin(x) ~ x - x**3/7 as x -> 0"),
    ("φ == ϕ", r"\phi = \varphi"),
    (
        "sum(1/k, k, 1, n) == log(n) + EulerGamma + 1/n + O(1/n**2) as n -> oo",
        r"\sum_{k=1}^n \frac1k = \ln n + \gamma + \frac1n + O(1/n^2) \text{ as } n \to \infty",
    ),
    ("x >= 0 given y > 0, x real", "x >= 0 for each x and each y > 0"),
    (
        "-integral(log(t**2 + e**2), t, 1, 0) == -2 + O(e**2) as e -> 0+",
        "integral(log(t**2 + e**2), t, 0, 1) == -2 + O(e**2) as e -> 0+",
    ),
)


TRUE_TWINS = (
    (
        "sum(1/k, k, 1, n) == log(n) + EulerGamma + 1/(2*n) + O(1/n**2) as n -> oo",
        r"\sum_{k=1}^n \frac1k = \ln n + \gamma + \frac1{2n} + O(1/n^2) \text{ as } n \to \infty",
    ),
    (
        "digamma(x) == -EulerGamma - 1/x + O(x) as x -> 0+",
        "digamma(x) == -gamma - 1/x + O(x) as x -> 0+",
    ),
)
IN_FILES = ("{0}**n <= 1", "{0}**n == E**n", "log({0}) < 0")
"""Claims of a file about a letter between 0 and 1 and an integer n >= 0."""


def _verdict(claim: str) -> Verdict | None:
    try:
        return tresym.check(claim).verdict
    except InputError:
        return None


def _contradict(one: Verdict | None, other: Verdict | None) -> bool:
    if one is None or other is None:
        return False
    return (one.holds and other is Verdict.REFUTED) or (other.holds and one is Verdict.REFUTED)


def wrong(spelling: spellings.Spelling, count: int, seed: int) -> list[str]:
    """The spellings of so many claims whose verdict contradicts the truth of the claim."""
    found = []
    for text, truth in spellings.sample(spelling, count, seed):
        try:
            answer = tresym.check(text, suggest=False)
        except InputError:
            continue
        if hunt.is_wrong(truth, answer.verdict.value) or "please report" in answer.why:
            found.append(f"{text} is {truth}; {answer.verdict.value}: {answer.why}")
    return found


@pytest.mark.parametrize("spelling", spellings.SPELLINGS)
def test_a_spelling_has_the_verdict_of_the_claim_or_none(spelling: spellings.Spelling) -> None:
    assert not wrong(spelling, EACH, 2026)


@pytest.mark.slow
@pytest.mark.parametrize("spelling", spellings.SPELLINGS)
def test_more_spellings(spelling: spellings.Spelling) -> None:
    assert not wrong(spelling, MORE, 2027)


@pytest.mark.slow
@pytest.mark.parametrize(("one", "other"), TWINS)
def test_both_of_two_false_twins_are_refuted(one: str, other: str) -> None:
    assert _verdict(one) is _verdict(other) is Verdict.REFUTED


@pytest.mark.slow
@pytest.mark.parametrize(("one", "other"), TRUE_TWINS)
def test_both_of_two_true_twins_hold(one: str, other: str) -> None:
    for claim in (one, other):
        verdict = _verdict(claim)
        assert verdict is not None
        assert verdict.holds, claim


@pytest.mark.parametrize("claim", IN_FILES)
def test_the_letter_e_of_a_file_is_no_number(claim: str) -> None:
    found: list[Verdict | None] = []
    for letter in "eh":
        given = f"{letter} real; given 0 < {letter} < 1\nn integer; given n >= 0\n"
        paper = read_paper(f"{given}one: {claim.format(letter)}\n")
        rows = verify_paper(paper, limit=5, cached=False, suggest=False).rows
        found.append(None if paper.problems else rows[-1].verdict)
    assert found[1] not in (None, Verdict.UNDECIDED)
    assert not _contradict(*found)


@pytest.mark.parametrize("limit", [0, 1])
def test_the_letter_e_of_a_path_is_no_number(limit: int) -> None:
    one, other = (_verdict(f"{x}**a -> {limit} given a > 0 as {x} -> 0+") for x in "eh")
    assert other is not None
    assert other.holds == (limit == 0)
    assert not _contradict(one, other)
