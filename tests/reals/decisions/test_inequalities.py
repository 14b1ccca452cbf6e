"""Inequalities called directly: each true claim stands beside a near falsehood."""

import pytest
from cases import cases
from flint import arb

from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.inequalities import _one_period, decide_inequality
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import with_domain
from tresym.reals.language.parsing import parse, parse_claim
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict

PROVED, ENCLOSED = Verdict.PROVED, Verdict.ENCLOSED
REFUTED, UNDECIDED = Verdict.REFUTED, Verdict.UNDECIDED


def decided(claim: str, under: str = "") -> Answer:
    ((left, relation, right),) = parse_claim(claim)
    return decide_inequality(left, relation, right, Given.parse(under))


# by signs; cells; concavity; Taylor; equivalents; cases; boxes and germs; constants
PAIRS = cases(__file__, "PAIRS")


@pytest.mark.parametrize(("true", "_", "under"), PAIRS, ids=[p[0] for p in PAIRS])
def test_true_claims_hold(true: str, _: str, under: str) -> None:
    assert decided(true, under).verdict.holds


@pytest.mark.parametrize(("_", "false", "under"), PAIRS, ids=[p[1] for p in PAIRS])
def test_near_falsehoods_are_refuted(_: str, false: str, under: str) -> None:
    assert decided(false, under).verdict is REFUTED


POINTS = cases(__file__, "POINTS")


@pytest.mark.parametrize(("claim", "under"), POINTS)
def test_a_witness_satisfies_the_conditions_and_violates_the_claim(claim: str, under: str) -> None:
    found = decided(claim, under)
    assert found.witness is not None
    at = {name: arb(parse_number(text)) for name, text in found.witness.items()}
    assert all(c.holds_exactly(at) for c in Given.parse(under).conditions)
    ((left, relation, right),) = parse_claim(claim)
    x, y = evaluate(left, at), evaluate(right, at)
    assert {"<": x >= y, "<=": x > y, ">": x <= y, ">=": x < y}[relation]


def test_sides_are_shown_in_the_order_they_were_written() -> None:
    for claim in ("3 < 2", "2 > 3", "3 <= 2", "2 >= 3"):
        values = decided(claim).values
        left = claim[0]
        assert values is not None
        assert values[0].mid.startswith(left)


OPEN = cases(__file__, "OPEN")


@pytest.mark.parametrize(("claim", "under"), OPEN)
def test_nothing_is_proved_where_nothing_is_shown(claim: str, under: str) -> None:
    assert decided(claim, under).verdict is UNDECIDED


CLOSED = cases(__file__, "CLOSED")


@pytest.mark.parametrize(("claim", "under"), CLOSED)
def test_planted_falsehoods_do_not_hold(claim: str, under: str) -> None:
    assert not decided(claim, under)


@pytest.mark.parametrize("claim", ["1/x != 0", "1/(x - 1/3) != 0", "tan(x)*cos(x)/sin(x) != 0"])
def test_a_pole_between_two_signs_is_no_zero(claim: str) -> None:
    assert decided(claim).verdict is not REFUTED


def test_a_zero_between_two_points_is_enclosed_by_them() -> None:
    found = decided("x**2 != 2", "x > 0")
    assert found.witness is not None
    low, high = (parse(text).args[0] for text in found.witness["x"].strip("[]").split(","))
    assert low**2 < 2 < high**2


@pytest.mark.parametrize("claim", ["x + 10**(-60) != x", "x + 10**(-60) > x", "exp(-500) != 0"])
def test_balls_that_overlap_are_not_yet_equal(claim: str) -> None:
    assert decided(claim).verdict is not REFUTED


PERIODIC = cases(__file__, "PERIODIC")


@pytest.mark.parametrize(("text", "under", "period"), PERIODIC)
def test_one_period_is_enough_of_what_is_periodic(text: str, under: str, period: str) -> None:
    difference, given = parse(text), Given.parse(under)
    region = with_domain(given, difference)
    cut = _one_period(difference, region, given)
    if period is None:
        assert cut == region
    else:
        half = parse(period) / 2
        assert cut == region & Given(((parse("x"), ">=", -half), (parse("x"), "<=", half)))


@pytest.mark.parametrize("under", ["1 <= x <= 20", "x >= 1", "-7 < x < -6"])
def test_a_claim_under_a_condition_is_not_looked_at_elsewhere(under: str) -> None:
    assert not decide_inequality(parse("1"), ">", parse("cos(x)"), Given.parse(under))


CASES = [
    ("abs(x) + abs(x - 1)", "1", "11/10"),
    ("abs(x) + abs(y)", "abs(x + y)", "abs(x + y) + 1/100"),
    ("abs(x)", "x", "x + 1/100"),
    ("abs(x)", "-x", "1/100 - x"),
    ("abs(abs(x) - 1)", "1 - abs(x)", "101/100 - abs(x)"),
]


@pytest.mark.parametrize(("left", "true", "false"), CASES)
def test_every_case_of_an_absolute_value_counts(left: str, true: str, false: str) -> None:
    assert decide_inequality(parse(left), ">=", parse(true), Given()).verdict is Verdict.PROVED
    assert not decide_inequality(parse(left), ">=", parse(false), Given())


ISOLATED = cases(__file__, "ISOLATED")


@pytest.mark.parametrize(("left", "relation", "right", "under", "refuted"), ISOLATED)
def test_a_point_that_stands_alone_refutes_nothing(
    left: str, relation: str, right: str, under: str, refuted: bool
) -> None:
    found = decide_inequality(parse(left), relation, parse(right), Given.parse(under))
    assert (found.verdict is Verdict.REFUTED) == refuted


@pytest.mark.parametrize(
    ("left", "under"),
    [
        ("x - 1/3", "(x - 1/3)**2 >= 1/100"),
        ("x", "x**2 >= 1/100"),
        ("x**3 - 2", "(x - 1)**2 >= 1/10"),
        ("1/x", ""),
        ("x/(x - 1/3)**2", "(x - 1/3)**2 + x**2 > 1/3"),
    ],
)
def test_a_zero_outside_the_conditions_refutes_no_inequation(left: str, under: str) -> None:
    found = decide_inequality(parse(left), "!=", parse("0"), Given.parse(under))
    assert found.verdict is not Verdict.REFUTED


@pytest.mark.parametrize("text", ["x", "1/7", "x + y", "abs(x)", "x*0"])
def test_a_side_is_not_less_than_itself(text: str) -> None:
    side = parse(text)
    assert decide_inequality(side, ">=", side, Given()).verdict is Verdict.PROVED
    assert decide_inequality(side, ">", side, Given()).verdict is Verdict.REFUTED
    assert decide_inequality(side, "!=", side, Given()).verdict is Verdict.REFUTED
