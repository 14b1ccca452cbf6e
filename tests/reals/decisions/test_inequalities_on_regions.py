"""Branch and bound with contacts apart: regions closed in balls, and falsehoods that stay open."""

import pytest
from cases import cases
from flint import arb

from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.inequalities_on_regions import search
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import with_domain
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict

ENCLOSED, REFUTED = Verdict.ENCLOSED, Verdict.REFUTED


def searched(left: str, right: str, strict: bool, under: str) -> Answer:
    given = Given.parse(under)
    sides = parse(left), parse(right)
    return search(*sides, strict, with_domain(given, *sides), given)


# left, right, whether >, conditions; then a right side or strictness with which it fails
CLOSED = cases(__file__, "CLOSED")


@pytest.mark.parametrize(("left", "right", "strict", "under", "_"), CLOSED)
def test_a_region_is_closed(left: str, right: str, strict: bool, under: str, _: str) -> None:
    found = searched(left, right, strict, under)
    assert found.verdict is ENCLOSED


@pytest.mark.parametrize(("left", "_", "strict", "under", "right"), CLOSED)
def test_a_near_falsehood_is_not(left: str, right: str, strict: bool, under: str, _: str) -> None:
    found = searched(left, right, strict, under)
    assert not found
    if found.witness is not None:
        at = {name: arb(parse_number(text)) for name, text in found.witness.items()}
        assert all(c.holds_exactly(at) for c in Given.parse(under).conditions)
        assert not evaluate(parse(left), at) > evaluate(parse(right), at)


CONTACTS = cases(__file__, "CONTACTS")


@pytest.mark.parametrize(("left", "right", "under"), CONTACTS)
def test_a_contact_is_no_strict_inequality(left: str, right: str, under: str) -> None:
    assert not searched(left, right, True, under)


@pytest.mark.parametrize(
    ("left", "right", "under"),
    [
        ("exp(x)", "1 + x", "-2 <= x <= 3, x != 0"),
        ("1", "x", "0 <= x < 1"),
        ("sin(x) + cos(x)", "1", "0 < x < pi/2"),
        ("x**2", "0", "-1 <= x <= 1, x != 0"),
    ],
)
def test_a_contact_that_is_excluded_does_not_count(left: str, right: str, under: str) -> None:
    assert searched(left, right, True, under).verdict is ENCLOSED


FALSE = cases(__file__, "FALSE")


@pytest.mark.parametrize(("left", "right", "strict", "under"), FALSE)
def test_planted_falsehoods_do_not_hold(left: str, right: str, strict: bool, under: str) -> None:
    assert not searched(left, right, strict, under)


def test_where_bounds_are_missing_they_are_named() -> None:
    assert "bounds on a, b may help" in searched("a*b", "1", True, "a > 0, b > 0").why


def test_conditions_on_other_variables_are_left_aside() -> None:
    found = searched("x**4 + 1", "x", True, "-2 <= x <= 2, a > 0, b > a")
    assert found.verdict is ENCLOSED


def test_neighbourhoods_of_both_infinities_may_meet() -> None:
    assert searched("x**2 + 5", "atan(x)", True, "").verdict is ENCLOSED


@pytest.mark.parametrize(
    ("left", "under"),
    [
        ("x**2", "x != 1, -2 <= x <= 2"),
        ("x**2", "x != -1, -2 <= x <= 2"),
        ("(x**2 - 2)**2", "x != 5, 0 <= x <= 2"),
        ("(x**2 - 2)**2", "x**2 != 3, 0 <= x <= 3"),
        ("1 - sin(x)", "x != 2, 0 <= x <= 2"),
    ],
)
def test_a_contact_where_an_inequation_holds_counts(left: str, under: str) -> None:
    assert not searched(left, "0", True, under)
