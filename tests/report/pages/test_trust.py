"""The page on trust says what was counted, and what the tests of the tests found."""

from collections.abc import Callable

import pytest

from tresym.ledger.verification import Report
from tresym.report.pages.coq_page import STATEMENTS
from tresym.report.pages.trust import trust, trust_details
from tresym.report.pages.trusted_code import trusted

GUARDS = {
    "files": {
        "tresym/reals/normal/ring.py": {"killed": 18, "stopped": 1, "survived": 1},
        "tresym/ledger/judge.py": {"killed": 1, "equivalent": 1, "not tried": 3},
    },
    "alive": [
        {"piece": "judge", "kind": "negated", "was": "x", "why": "it costs time alone"},
        {"piece": "multiply", "kind": "dropped", "was": "y", "why": None},
    ],
}


@pytest.mark.slow
def test_the_page_opens_with_the_answer(judged: Callable[..., Report]) -> None:
    page = trust(judged("eq_gamma"), GUARDS)
    assert f"{trusted(STATEMENTS):,} lines of Python" in page.splitlines()[0]
    assert f"can reach {trusted():,} lines of tresym" in page
    assert "| integrating | fundamental theorem of calculus |" in page
    assert "The quick tests notice 20 of the changes (95.2 %)" in page


def test_the_appendix_lists_what_no_test_notices() -> None:
    page = trust_details(GUARDS)
    assert "- it costs time alone: `judge`: negated, `x`." in page
    assert "`multiply`" not in page


MUTANTS = {
    "counts": dict.fromkeys(("PROVED", "ENCLOSED"), 0) | {"REFUTED": 99, "UNDECIDED": 1},
    "survivors": [],
    "stopped": [],
    "claims": [{"label": "eq_gamma", "changes": 5}, {"label": "chart", "changes": 0}],
    "few": [{"label": "chart", "changes": 0, "why": "it is not used"}],
}


def test_the_page_says_what_became_of_false_variants(judged: Callable[..., Report]) -> None:
    page = trust(judged("eq_gamma"), None, mutants=MUTANTS)
    assert "100 false variants of 1 claims" in page
    assert "99 are refuted with a counterexample (99.0 %), none passed" in page
    assert "- `chart`, 0: it is not used." in trust_details(None, mutants=MUTANTS)
    slipped = [{"label": "eq_gamma", "place": "statement", "change": "a"}]
    assert ", 1 passed" in trust(
        judged("eq_gamma"), None, mutants={**MUTANTS, "survivors": slipped}
    )


def test_the_page_does_without_what_was_never_measured(judged: Callable[..., Report]) -> None:
    assert "Tests of the tests" not in trust(judged("eq_gamma"), None)


def test_the_page_tells_of_the_long_hunts() -> None:
    row = {"examples": 3000, "seconds": 1.0, "chunks": 2, "failures": 1}
    row |= {"day": "2026-01-02", "commit": "abc"}
    hunts = {"tests": {"a.py::test_x": row, "b.py::y": {**row, "decided": 2900}}}
    page = trust_details(None, hunts)
    assert "| `x` | 2026-01-02, `abc` | 3,000 |  | 1 |" in page
    assert "| `y` | 2026-01-02, `abc` | 3,000 | 2,900 | 1 |" in page
