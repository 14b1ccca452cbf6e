"""Exact limits with parameters: the rules, and what each of their guards keeps out."""

import pytest
from cases import cases

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import _is_bounded, limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

LIMITS = cases(__file__, "LIMITS")


@pytest.mark.parametrize(("e", "point", "given", "value"), LIMITS)
def test_limits(e: str, point: str, given: str, value: str) -> None:
    where = None if point == "oo" else parse(point)
    found = limit_of(parse(e), "x", where, 1, Given.parse(given))
    infinite = {"oo": INFINITY, "-oo": -INFINITY}
    if value in infinite:
        assert found == infinite[value]
    else:
        assert found is not None
        assert decide(found, parse(value), Given.parse(given)).verdict is Verdict.PROVED


NONE = cases(__file__, "NONE")


@pytest.mark.parametrize(("e", "point", "given"), NONE)
def test_what_has_no_limit_or_none_that_is_shown(e: str, point: str, given: str) -> None:
    where = None if point == "oo" else parse(point)
    assert limit_of(parse(e), "x", where, 1, Given.parse(given)) is None


@pytest.mark.parametrize(
    ("e", "bounded"),
    cases(__file__, "what_is_made_of_waves_is_bounded"),
)
def test_what_is_made_of_waves_is_bounded(e: str, bounded: bool) -> None:
    assert _is_bounded(parse(e), "x") is bounded
