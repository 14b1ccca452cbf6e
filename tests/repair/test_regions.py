"""Natural conditions: the widest on which a claim is seen to hold comes first."""

import pytest

from tresym.reals.language.parsing import parse_claim
from tresym.repair.regions import holding
from tresym.repair.samples import sampled


@pytest.mark.parametrize(
    ("claim", "first"),
    [
        ("sqrt(x**2) == x", "x >= 0"),
        ("sqrt(x**2) == -x", "x <= 0"),
        ("abs(x + y) == abs(x) + abs(y)", "x*y >= 0"),
        ("acos(cos(x)) == x", "0 <= x, x <= pi"),
        ("atan(tan(x)) == x", "-pi/2 < x, x < pi/2"),
        ("abs(x - y) == y - x", "x <= y"),
        ("abs(x**2 - 1) == 1 - x**2", "abs(x) <= 1"),
    ],
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
