"""Natural conditions: the widest on which a claim is seen to hold comes first."""

import pytest
from cases import cases

from tresym.reals.language.parsing import parse_claim
from tresym.repair.regions import holding
from tresym.repair.samples import sampled


@pytest.mark.parametrize(
    ("claim", "first"),
    cases(__file__, "the_widest_region_comes_first"),
)
def test_the_widest_region_comes_first(claim: str, first: str) -> None:
    links = parse_claim(claim)
    names = ["x", "y"] if "y" in claim else ["x"]
    points = sampled(names, [], 70)
    assert points is not None
    assert holding(links, points, [])[0] == first


def test_what_holds_nowhere_or_everywhere_has_no_region() -> None:
    points = sampled(["x"], [], 70)
    assert points is not None
    for claim in ("sin(x) == 2", "x == x"):
        assert holding(parse_claim(claim), points, []) == []
