"""Inequalities whose sides are equal on an edge of the region, and false ones for each guard."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from tresym.reals.decisions import edges_of_contact
from tresym.reals.decisions.edges_of_contact import Edge, Quotient
from tresym.reals.decisions.inequalities_on_regions import search
from tresym.reals.domain.conditions import Given
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.parsing import parse, parse_given
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.verdict import Verdict

TINY = "x**3 + x*(1 - sin(y)**2 - cos(y)**2 - 1/10**100)"
"""Negative for x < 10**(-50), although its coefficient of x is 0 to 250 bits."""
UNIT = "0 < x, x <= 1, 0 < y, y <= 1"


def given(text: str) -> Given:
    return Given(tuple(parse_given(text)))


def test_coefficients_vanish_by_exact_normal_forms() -> None:
    """To 250 bits the coefficient of x is 0, and without an exact proof x³ would be divided out."""
    where = given(UNIT)
    found = search(parse(TINY), parse("0"), False, where, where)
    assert found.verdict is not Verdict.ENCLOSED
    box = [Interval(fmpq(0), fmpq(1))] * 2
    seen = edges_of_contact._seen(parse(TINY), ["x", "y"], box, 0, fmpq(0))
    assert seen > 1  # so that it is the exact proof that stops it


def test_a_strict_claim_is_not_shown_on_an_edge_that_belongs_to_it() -> None:
    """x·y > sin(x·y) fails at x = 0, where the quotient by x³ is positive."""
    sides = parse("x*y"), parse("sin(x*y)")
    closed = given("0 <= x, x <= 1, 1/2 <= y, y <= 1")
    half_open = given("0 < x, x <= 1, 1/2 <= y, y <= 1")
    assert search(*sides, True, closed, closed).verdict is not Verdict.ENCLOSED
    assert search(*sides, True, half_open, half_open).verdict is Verdict.ENCLOSED


@pytest.mark.parametrize(
    ("text", "positive"), [("(1 - x)**3*(1 + y)", True), ("(x - 1)**3", False)]
)
def test_the_distance_from_an_upper_edge_is_positive(text: str, positive: bool) -> None:
    e, names = parse(text), ["x", "y"]
    slopes = [differentiate(e, name) for name in names]
    with ball_precision():
        near = [arb("0.9").union(arb(1)), arb(0).union(arb(1))]
        found = Quotient(e, slopes, names, Edge(0, fmpq(1), -1, 3)).least(near)
    assert bool(found > 0) is positive


def test_nothing_is_concluded_where_the_difference_is_not_smooth() -> None:
    """|x − 1/100| has a kink between the edge and the box."""
    e, names = parse("x*abs(x - 1/100)"), ["x", "y"]
    slopes = [differentiate(e, name) for name in names]
    with ball_precision():
        near = [arb(0).union(arb("0.1")), arb(0).union(arb(1))]
        assert not Quotient(e, slopes, names, Edge(0, fmpq(0), 1, 1)).least(near) > 0
