"""One claim in several spellings has one verdict: spellings are generated from lists of claims.

Two spellings contradict each other if one of them holds and the other is refuted. That must never
happen; a spelling that is left open is counted, and most must be decided as the claim is.
"""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from pathlib import Path

import pytest

import tresym
from tresym.papers.reading import read_paper
from tresym.papers.verification import verify_paper
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

DATA = Path(__file__).parent / "data"
LISTS = ("claims/orders.txt", "claims/inequalities.txt", "claims/special.txt")
EACH = 9
"""Claims that are taken from each list; another seed takes others."""
LEAST_ALIKE = 0.9
_RELATION = re.compile(r" (==|<=|>=|<|>) ")
_MIRRORED = {"==": "==", "<": ">", ">": "<", "<=": ">=", ">=": "<="}
_ORDER = re.compile(r"(?<![A-Za-z])[oO]\(")


def _parts(claim: str) -> tuple[str, str, str, str] | None:
    """Return both sides, the relation between them, and the rest of a claim that has one."""
    body, word, rest = re.split(r"( given | as |$)", claim, maxsplit=1)
    found = _RELATION.split(body)
    return (found[0], found[1], found[2], word + rest) if len(found) == 3 else None


def renamed(claim: str) -> str:
    """Call the variable x u."""
    return re.sub(r"(?<![\w.])x(?!\w)", "u", claim)


def with_letter_e(claim: str) -> str:
    """Call the variable x e, which is not Euler's number."""
    return re.sub(r"(?<![\w.])x(?!\w)", "e", claim)


def with_gamma(claim: str) -> str:
    """Write gamma for Euler's constant."""
    return claim.replace("EulerGamma", "gamma") if " gamma(" not in f" {claim}" else claim


def exchanged(claim: str) -> str:
    """Exchange the sides of a claim without O."""
    parts = _parts(claim)
    if parts is None or _ORDER.search(claim):
        return claim
    left, relation, right, rest = parts
    return f"{right} {_MIRRORED[relation]} {left}{rest}"


def moved(claim: str) -> str:
    """Take the left side from both sides, or 2 from both sides of an order."""
    parts = _parts(claim)
    if parts is None:
        return claim
    left, relation, right, rest = parts
    if _ORDER.search(claim):
        return f"({left}) - 2 {relation} {right} - 2{rest}"
    return f"0 {relation} ({right}) - ({left}){rest}"


def gammas(claim: str) -> str:
    """Write n! as the gamma function."""
    return re.sub(r"factorial\((\w+)\)", r"gamma(\1 + 1)", claim)


def by_definition(claim: str) -> str:
    """Write E1 as the integral that defines it."""
    return claim.replace("E1(x)", "integral(exp(-t)/t, t, x, oo)")


def inverted(claim: str) -> str:
    """Put 1/s for x where x tends to infinity."""
    if not claim.endswith(" as x -> oo") or " given " in claim:
        return claim
    body = claim.removesuffix(" as x -> oo")
    return re.sub(r"(?<![\w.])x(?!\w)", "(1/s)", body) + " as s -> 0+"


SPELLINGS: list[Callable[[str], str]] = [
    renamed,
    with_letter_e,
    with_gamma,
    exchanged,
    moved,
    gammas,
    by_definition,
    inverted,
]
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


@pytest.mark.slow
@pytest.mark.parametrize("name", LISTS)
def test_another_spelling_has_no_other_verdict(name: str) -> None:
    lines = (line.split(" | ") for line in (DATA / name).read_text(encoding="utf-8").splitlines())
    claims = [line[1] for line in lines if len(line) == 2 and len(line[1]) < 80]
    alike = tried = 0
    for claim in random.Random(2026).sample(claims, EACH):
        verdict = _verdict(claim)
        for spelling in SPELLINGS:
            other = spelling(claim)
            if other == claim:
                continue
            found = _verdict(other)
            assert not _contradict(verdict, found), (claim, other)
            tried += 1
            alike += (verdict and verdict.holds) == (found and found.holds)
    assert tried >= EACH
    assert alike >= LEAST_ALIKE * tried


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
