"""Claims about integrals, sums and limits in Coq: what they say, and that no false one holds."""

import time
from pathlib import Path

import pytest
from cases import cases

from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.candidate_search import bound, found_by
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import HEAD, Dialogue
from tresym.coq.statement import NotExportedError
from tresym.reals.decisions.claim_parsing import read

needs_coq = pytest.mark.coq
CLAIMS = Path(__file__).with_name("textbook_claims.txt").read_text(encoding="utf-8")


def of_kind(kind: str) -> list[str]:
    """The claims under a heading."""
    return CLAIMS.split(f"# {kind}\n")[1].split("\n# ")[0].strip().splitlines()


@pytest.mark.parametrize(
    ("claim", "said"),
    cases(__file__, "a_statement_says_what_is_claimed_and_that_its_parts_are_defined"),
)
def test_a_statement_says_what_is_claimed_and_that_its_parts_are_defined(
    claim: str, said: str
) -> None:
    assert said in theorems(read(claim))[0].text


@pytest.mark.parametrize(
    ("claim", "why"),
    [
        ("integral(sin(t)/t, t, x, 1) == O(x) as x -> 0", "integrals or sums"),
        ("x == O(x*y) as x*y -> oo given x > 1, y > 1", "of an expression"),
        ("x*y -> 0 as (x, y) -> (0, 0)", "of several variables"),
        ("sin(x) == x + O(x^3) as x -> 0 on abs(x) <= 1", "on a region"),
        ("atan(x) == O(1) as x -> oo on x > 0", "on a region"),
        ("sin(a*x) == O(x) uniformly as x -> 0 given 0 < a, a < 1", "one constant for all"),
        ("integral(integral(x*y, x, 0, 1), y, 0, 1) == 1/4", "within an integral"),
        ("sum(k, k, -2, n) == n*(n + 1)/2 - 3", "begin at a natural number"),
    ],
)
def test_what_is_not_exported_says_why(claim: str, why: str) -> None:
    with pytest.raises(NotExportedError, match=why):
        theorems(read(claim))


@needs_coq
@pytest.mark.slow
def test_of_true_claims_some_of_each_kind_are_proved_and_of_false_ones_none() -> None:
    true = [of_kind(kind)[0] for kind in ("limits", "integrals", "sums")]
    with Dialogue(lemmas=HEAD + bound(theorems(read(true[0])))) as coq:
        for claim in [*true, *of_kind("false")]:
            try:
                found = [found_by(t, coq, time.monotonic() + 20) for t in theorems(read(claim))]
            except NotExportedError:
                continue
            assert all(found) == (claim in true), claim
            assert any(found) or claim not in true


def test_a_theorem_about_a_limit_is_one_about_bound_variables() -> None:
    assert all(isinstance(t, BoundTheorem) for t in theorems(read("1/x -> 0 as x -> oo")))
