"""Like terms: which repairs say nothing."""

import pytest
from cases import cases

from tresym.reals.language.parsing import parse_claim
from tresym.repair.like_terms import is_trivial


@pytest.mark.parametrize(
    ("old", "new"),
    cases(__file__, "what_says_nothing_is_dropped"),
)
def test_what_says_nothing_is_dropped(old: str, new: str) -> None:
    assert is_trivial(parse_claim(old)[0], parse_claim(new)[0])


@pytest.mark.parametrize(
    ("old", "new"),
    [
        ("(x + 1)**2 == x**2 + 1", "(x + 1)**2 == x**2 + 2*x + 1"),
        ("sin(-x) == sin(x)", "sin(-x) == -sin(x)"),
        ("sin(x)**2 - cos(x)**2 == 1", "sin(x)**2 + cos(x)**2 == 1"),
        ("sqrt(x**2) == x", "sqrt(x**2) == abs(x)"),
    ],
)
def test_what_says_something_stays(old: str, new: str) -> None:
    assert not is_trivial(parse_claim(old)[0], parse_claim(new)[0])
