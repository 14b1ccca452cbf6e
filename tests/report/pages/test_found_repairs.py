"""What the search for repairs finds for refuted claims of the ledger."""

import pytest

from tresym.ledger.paper import all_claims
from tresym.report.pages.found_repairs import search

CLAIMS = {claim.label: claim for claim in all_claims()}


@pytest.mark.parametrize(
    ("label", "tried", "found"),
    [
        ("ordered_moments", True, "I1 >= 0"),  # printed with a strict sign
        ("table_units", True, ""),
        ("d24", False, ""),  # an asymptotic statement
        ("prop1", False, ""),  # words
    ],
)
def test_a_misprint_is_found_by_itself(label: str, tried: bool, found: str) -> None:
    searched = search(CLAIMS[label])
    assert searched.tried is tried
    assert (searched.found.claim if searched.found else "") == found
