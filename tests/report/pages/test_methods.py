"""The page on deciding says of each method what it does, and its example is one it decides."""

from collections.abc import Callable
from typing import Any

import pytest
from falsehoods import read
from unseen import LISTS

from tresym.reals.signs.sign import DIRECT, METHODS, directly, proof
from tresym.report.pages.check_tables import KINDS, by_kind, by_source
from tresym.report.pages.methods import example, methods

EXAMPLES = [(method, example(method)) for method in METHODS]


@pytest.mark.parametrize(("method", "claim"), EXAMPLES, ids=[m.__name__ for m in METHODS])
def test_a_method_decides_its_example(method: Callable[..., Any], claim: str) -> None:
    left, relation, right, given = read(claim)
    ask = directly if method in DIRECT else proof
    assert method(left - right, relation, given, ask) is not None


def test_every_method_is_on_the_page() -> None:
    page = methods().splitlines()
    assert len(page) == len(METHODS)
    assert all(
        line.startswith("- **") and "Decides `" in line and "Limits: " in line for line in page
    )


def test_every_list_is_a_kind_of_the_table() -> None:
    assert {*KINDS} == {path.stem for path in LISTS.glob("*.txt")}
    counts = {"true": 4, "held": 3, "false": 2, "refuted": 2, "wrong": 0, "median": 1.5, "p99": 7}
    row = by_kind(dict.fromkeys(KINDS, counts)).splitlines()[2]
    assert row.endswith("| MetiTarski | 4 | 3 (75.0 %) | 2 | 2 | 0 | 1.5 ms | 7 ms |")


def test_the_sources_add_up() -> None:
    counts = {"displays": 3, "links": 5, "elementary": 4, "held": 2, "refuted": 1}
    own = {"links": 9, "held": 8, "first_sight": 7, "refuted": 0, "changed": 9, "changed_held": 0}
    rows = [{"source": name, "note": "", **counts} for name in ("one", "two")]
    text = by_source({"rows": rows, "handbook": own})
    assert "| total | 6 | 10 | 8 | 4 | 2 |" in text
    assert "8 of 9 relations" in text
