"""Branches, domains and planted falsehoods: what must be proved, refuted, or neither."""

import pytest
from cases import cases

from tresym.reals.decisions.identity import decide, decide_continuous
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import Field
from tresym.reals.verdict import Verdict

TRUE = cases(__file__, "TRUE")
"""Proved: the two sides are equal wherever both are defined."""

FALSE = cases(__file__, "FALSE")
"""Refuted, with a witness."""

NEITHER = cases(__file__, "NEITHER")
"""Nowhere defined, conditions that nothing satisfies, or outside the procedure: never proved."""


def claim(left: str, right: str, given: str) -> Verdict:
    return decide(parse(left), parse(right), Given.parse(given)).verdict


@pytest.mark.parametrize(("left", "right", "given"), TRUE)
def test_proved(left: str, right: str, given: str) -> None:
    assert claim(left, right, given) is Verdict.PROVED


@pytest.mark.parametrize(("left", "right", "given"), FALSE)
def test_refuted(left: str, right: str, given: str) -> None:
    decision = decide(parse(left), parse(right), Given.parse(given))
    assert decision.verdict is Verdict.REFUTED
    assert decision.witness is not None
    assert decision.values is not None
    assert not decision.values[0].overlaps(decision.values[1])


@pytest.mark.parametrize(("left", "right", "given"), NEITHER)
def test_never_vacuously_proved(left: str, right: str, given: str) -> None:
    assert claim(left, right, given) is Verdict.UNDECIDED


VANISHING = cases(__file__, "VANISHING")
"""Zero on a whole region, and not zero: a radicand with it says nothing of its other factors."""


@pytest.mark.slow
@pytest.mark.parametrize("factor", VANISHING)
def test_a_factor_that_vanishes_on_a_region_implies_nothing(factor: str) -> None:
    roots = f"sqrt(({factor})*y) + sqrt(({factor})*z)"
    assert claim(f"{roots} + abs(y*z)", f"{roots} + y*z", "") is not Verdict.PROVED
    assert claim(f"{roots} + abs(y)", f"{roots} + y", "") is not Verdict.PROVED
    # nor does an even power, or a root, whose sign is known
    for even in (f"({factor})**2", f"sqrt({factor})"):
        root = f"sqrt({even}*y)"
        assert claim(f"{root} + abs(y)", f"{root} + y", "") is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right"),
    [
        # what is inverted on the way is no denominator of the claim
        ("atan(x + 50 + abs(x + 50))", "atan(2*x + 100)"),
        ("abs(x - 9)", "9 - x + 0*atan(abs(x - 9) + 9 - x)"),
        ("asec(1 + (x + 5) + abs(x + 5))", "asec(1 + 2*(x + 5))"),
        ("asin(1 - x - abs(x)) + x", "asin(1 - x - abs(x)) + abs(x)"),
        ("sqrt(atan(x + abs(x))) + x", "sqrt(atan(x + abs(x))) + abs(x)"),
        # the slopes have no value where the claim fails
        *(
            (f"{root} + (abs(x + 50) - x - 50)*(x + 51)", root)
            for root in (
                "sqrt(x + 50 + abs(x + 50))",
                "cbrt(x + 50 + abs(x + 50))",
                "acosh(1 + x + 50 + abs(x + 50))",
                "abs(x + 50 + abs(x + 50))",
            )
        ),
    ],
)
def test_nothing_is_learnt_where_the_claim_is_defined_and_a_slope_is_not(
    left: str, right: str
) -> None:
    assert claim(left, right, "") is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right", "given", "verdict"),
    cases(__file__, "a_bound_that_is_not_rational"),
)
def test_a_bound_that_is_not_rational(
    left: str, right: str, given: str, verdict: Verdict | None
) -> None:
    """It cuts regions too; None is whatever is not PROVED."""
    found = claim(left, right, given)
    assert found is verdict if verdict else found is not Verdict.PROVED


def test_a_constant_is_as_wide_as_its_ball() -> None:
    """exp(25) − 72004899337 loses most of the digits of the ball it is first seen in."""
    constant = "log(exp(25) - 72004899337) + 0.9522484"
    left, right = f"abs(x - ({constant}))", f"x - ({constant})"
    assert claim(left, right, "x > 0") is not Verdict.PROVED
    assert claim(left, right, "x > 1") is Verdict.PROVED


@pytest.mark.parametrize(
    ("text", "sign"),
    [
        ("x + 2 - 2*sqrt(x + 1)", 0),  # a square that vanishes at 0
        ("x + 3 - 2*sqrt(x + 1)", 1),
        ("(x - y)**2*(1 + x**2)", 0),
        ("1 + x**2 + y**2", 1),
    ],
)
def test_what_may_vanish_on_a_wall_is_not_definite(text: str, sign: int) -> None:
    field = Field(Given.parse("x > -1"))
    (value,) = field.normal(parse(text))
    assert field.signs.definite(value.num) == sign


AT_JUMPS = cases(__file__, "AT_JUMPS")
"""True but where a function jumps, at one place or at one of several."""


@pytest.mark.parametrize(("left", "right"), AT_JUMPS)
def test_what_holds_off_the_jumps_alone_is_not_proved(left: str, right: str) -> None:
    for decider in (decide, decide_continuous):
        assert decider(parse(left), parse(right)).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("left", "right"), [("x*sign(x)", "abs(x)"), ("sign(x)**3", "sign(x)"), ("sign(x)*abs(x)", "x")]
)
def test_what_holds_at_the_jumps_too_is(left: str, right: str) -> None:
    assert decide(parse(left), parse(right)).verdict is Verdict.PROVED


def test_where_a_side_may_jump_the_ledger_has_no_answer() -> None:
    asked = parse("sign(x - sqrt(2))**3"), parse("sign(x - sqrt(2))")
    assert decide_continuous(*asked).verdict is Verdict.UNDECIDED
    assert decide_continuous(*asked, Given.parse("x < 1")).verdict is Verdict.PROVED


ALONE = ["x**2*(x - 1) >= 0", "sqrt(x**2*(x - 1)) < 5", "x**2*(x - 1) >= 0, y**2*(y - 1) >= 0"]


@pytest.mark.parametrize("given", ALONE)
def test_conditions_that_hold_at_a_point_alone_prove_nothing_by_what_holds_beside_it(
    given: str,
) -> None:
    """At x = 0 the left side is 1 and the right side −1."""
    for decider in (decide, decide_continuous):
        found = decider(parse("sqrt((x - 1)**2)"), parse("x - 1"), Given.parse(given))
        assert found.verdict is Verdict.UNDECIDED
        assert "isolated points" in found.why


@pytest.mark.parametrize("given", ALONE)
def test_such_conditions_do_no_harm_where_the_others_are_enough(given: str) -> None:
    for left, right, more in (("sqrt((x - 1)**2)", "x - 1", ", x > 1"), ("x + x", "2*x", "")):
        found = decide(parse(left), parse(right), Given.parse(given + more))
        assert found.verdict is Verdict.PROVED


def test_one_such_condition_is_not_left_in_when_the_others_are_dropped() -> None:
    given = Given.parse("sign(x)**2*(x - 5) > -1/2, x**2*(x - 2) >= 0")
    found = decide(parse("sqrt((x - 1)**2)"), parse("x - 1"), given)
    assert found.verdict is Verdict.UNDECIDED
