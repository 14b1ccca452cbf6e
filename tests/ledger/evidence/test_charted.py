"""Bounds on regions: what is said is what is shown, and every guard has a falsehood."""

from dataclasses import replace

import pytest
from flint import fmpq
from sympy import Abs, Basic, Rational, Symbol, Tuple, exp, log, sin, sqrt
from tresym.proofs import near

from tresym.ledger.claim import Claim, Definition, equal
from tresym.ledger.evidence.charted import Charted, On, Reading, Shown
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge_evidence
from tresym.racket.near import charts
from tresym.racket.notation import Q, a, b, epsilon0, epsilon_star
from tresym.reals.balls.boxes import box
from tresym.reals.balls.traced import Named, Part
from tresym.reals.language.expression import ONE, ZERO
from tresym.reals.verdict import Verdict

x, y, z = (Symbol(name, real=True) for name in "xyz")
POSITIVE = (x > 0, x <= 2)
UNIT = box((0, 2))


def judged(says: Basic, *on: On, given: tuple[Basic, ...] = POSITIVE, **rest: object) -> Finding:
    found = judge_evidence(Claim("c", says, Charted(on, **rest), given=given))
    assert found is not None
    return found


def holds(says: Basic, *on: On, **rest: object) -> bool:
    return judged(says, *on, **rest).verdict is Verdict.ENCLOSED


def exponential(t, m):
    """(e^t − 1)/t − 9/10."""
    return charts.expm1_over(t) - fmpq(9, 10)


EXPONENTIAL = On((x,), UNIT, (Shown(exponential, x),))
SAYS = exp(x) - 1 > Rational(9, 10) * x


def test_a_bound_with_its_factor_divided_out_is_shown() -> None:
    assert holds(SAYS, EXPONENTIAL)


@pytest.mark.parametrize(
    "says",
    [
        exp(x) - 1 > Rational(91, 100) * x,
        exp(x) - 1 > x,
        exp(x) > Rational(9, 10) * x,
        exp(x) - 1 < Rational(9, 10) * x,
        exp(2 * x) - 1 > Rational(9, 10) * x,
        Tuple(SAYS, x < 1),
        equal(exp(x) - 1, Rational(9, 10) * x),
    ],
)
def test_another_statement_is_not(says: Basic) -> None:
    assert not holds(says, EXPONENTIAL)


@pytest.mark.parametrize(
    ("given", "on"),
    [
        ((x > 0, x <= 3), EXPONENTIAL),
        ((x <= 2,), EXPONENTIAL),
        ((), EXPONENTIAL),
        ((x > 0, x <= 0), EXPONENTIAL),
        ((x >= 1, x <= 1), EXPONENTIAL),
        (POSITIVE, replace(EXPONENTIAL, box=box(("1/10", 2)))),
        (POSITIVE, replace(EXPONENTIAL, box=box((0, 2), (0, 2)))),
        (POSITIVE, replace(EXPONENTIAL, coordinates=(x / 2,))),
        (POSITIVE, replace(EXPONENTIAL, coordinates=(x + 1,))),
        (POSITIVE, replace(EXPONENTIAL, where=(x > 1,))),
        (POSITIVE, replace(EXPONENTIAL, shown=())),
    ],
)
def test_a_box_that_does_not_hold_the_region_shows_nothing(given: tuple[Basic], on: On) -> None:
    assert not holds(SAYS, on, given=given)


@pytest.mark.parametrize(
    "shown",
    [
        Shown(exponential, -x),
        Shown(exponential, x - 1),
        Shown(exponential, x**2),
        Shown(lambda t, m: exponential(t, m) + fmpq(1, 2), x, -x / 2),
        Shown(lambda t, m: exponential(t, m) - fmpq(1, 2), x, x / 2),
        Shown(lambda t, m: fmpq(1), x),
        Shown(lambda t, m: 1 + 0 * t, x),
        Shown(lambda t, m: 1 if t > 0 else t, x),
        Shown(lambda t, m: charts.expm1_over(t - t) - fmpq(9, 10), x),
    ],
)
def test_a_margin_or_a_factor_of_another_kind_shows_nothing(shown: Shown) -> None:
    """A factor of unknown sign, one that is the whole statement, what is spare and negative, …"""
    on = replace(EXPONENTIAL, shown=(shown,))
    assert not holds(SAYS, on) or shown.spare == x / 2


def test_what_is_spare_may_be_left_over() -> None:
    less = Shown(lambda t, m: exponential(t, m) - fmpq(1, 20), x, x / 20)
    assert holds(SAYS, replace(EXPONENTIAL, shown=(less,)))


def test_a_bound_is_cited_where_its_conditions_are_those_of_the_chart() -> None:
    later = Claim("later", y >= x, given=(x >= 1,))
    spare = Shown(exponential, x, spare=y - x)
    on = On((x,), UNIT, (spare,), (x >= 1,), (later,))
    says = exp(x) - 1 + y - x > Rational(9, 10) * x
    given = (*POSITIVE, x >= 1)
    assert holds(says, on, given=given)
    assert not holds(says, replace(on, cited=()), given=given)
    assert not holds(says, replace(on, where=()), given=POSITIVE)
    earlier = replace(on, where=(x <= 1,))
    assert not holds(says, on, earlier)


def test_charts_cover_together() -> None:
    low, high = (replace(EXPONENTIAL, where=w) for w in ((x <= 1,), (x > Rational(1, 2),)))
    assert holds(SAYS, low, high)
    assert holds(SAYS, replace(low, box=box((0, 1))), replace(high, box=box(("1/2", 2))))
    assert not holds(SAYS, low, replace(high, where=(x > Rational(3, 2),)))
    assert not holds(SAYS, low, replace(high, where=(x > 1,), box=box(("11/10", 2))))
    assert not holds(SAYS, low)


def test_where_sides_have_no_values_nothing_is_shown() -> None:
    on = On((x,), UNIT, (Shown(lambda t, m: charts.log1p_over(t), x),))
    assert holds(log(1 + x) > 0, on)
    assert not holds(log(1 + x) > 0, replace(on, shown=(Shown(lambda t, m: t, x),)))
    assert not holds(log(x - 1) - log(x - 1) + sin(x) > -2, on)


def test_a_symbol_stands_for_its_definition_where_that_exists() -> None:
    root = Claim("root", equal(y, sqrt(x - 1)), Definition(), given=(x > 1,))
    on = On((x,), box((1, 2)), (Shown(lambda t, m: 2 * t - 1),))
    above = (x > 1, x <= 2)
    assert holds(y**2 + x > 0, on, given=above, put=(root,))
    assert not holds(y**2 + x > 0, replace(on, box=UNIT), put=(root,))
    assert not holds(y**2 + x > 0, on, given=above)


# -- readings -------------------------------------------------------------------------------------


@Part
def square(t, m):
    return t * t


READING = Reading(square, (x,), x**2, (x > 0,))
SQUARE = On((x,), UNIT, (Shown(lambda t, m: 1 + t + square(t, m)),))


def test_a_part_is_what_it_is_read_as() -> None:
    assert holds(x + x**2 > -1, SQUARE, readings=(READING,))
    for wrong in (
        replace(READING, value=x**2 + 1),
        replace(READING, value=x),
        replace(READING, given=(x > 1,)),
        replace(READING, value=y),
    ):
        assert not holds(wrong.value + x > -1, SQUARE, readings=(wrong,)), wrong
    elsewhere = replace(READING, at=(x + 1,), value=(x + 1) ** 2)
    assert holds(x + x**2 > -1, SQUARE, readings=(elsewhere,))
    assert not holds((x + 1) ** 2 + x > -1, SQUARE, readings=(elsewhere,))


def test_a_root_is_read_by_its_equation_and_between_its_ends() -> None:
    """What the program of a root contains is the phase, and nothing else."""
    margin = Shown(lambda b_, k_, m: charts.phase_by_kappa(b_, k_) - 1)
    on = On(near.BY_KAPPA, near.KAPPA, (margin,))
    known = {"given": near.quarter, "cited": (*near.ROOT, near.phase_range)}
    right = near.phase_in_kappa
    assert holds(near.P > 1, on, readings=(right,), **known)
    assert not holds(near.P > 1, on, **known)
    for wrong in (
        replace(right, value=epsilon0),
        replace(right, value=near.P + 1),
        replace(right, claims=()),
        replace(right, claims=(near.phase,)),
        replace(right, cited=()),
        replace(right, at=(b, 1 / sqrt(a * b) + 1)),
        replace(right, at=(a, 1 / sqrt(a * b))),
        replace(right, given=(a > 0,)),
    ):
        assert not holds(wrong.value > 1, on, readings=(wrong,), **known), wrong


def test_a_root_that_no_claim_names_is_none() -> None:
    half = Named(lambda t: t, image=lambda s, t: s, between=(ZERO, ONE))
    on = On((x,), UNIT, (Shown(lambda t, m: half(t) + 1),))
    assert not holds(z + 1 > 0, on, readings=(Reading(half, (x,), z, (x > 0,)),))


# -- the paper's ----------------------------------------------------------------------------------


def first(b_, k_, m):
    return charts.first_excess(charts.root_by_kappa(b_, k_, m), m)


def repaired(limit: str = "1.451", margin: str = "1.451", **changes: object) -> Claim:
    says = Abs(epsilon0 / epsilon_star - 1) <= Rational(limit) * epsilon_star**2
    shown = near.within(first, fmpq(*map(int, Rational(margin).as_numer_denom())), epsilon_star**2)
    on = On(near.BY_KAPPA, near.KAPPA, shown)
    claim = near.bound("repaired", says, on, given=near.quarter)
    return replace(claim, **changes)


def test_the_first_order_is_enclosed() -> None:
    assert judge_evidence(repaired()).verdict is Verdict.ENCLOSED


@pytest.mark.parametrize(
    "claim",
    [
        repaired("1.45"),
        repaired("1.45", "1.45"),
        repaired("1.452"),
        repaired(given=(a > 0, b > 0, b <= 1, a * b >= Rational(1, 5))),
        repaired(given=(a > 0, b > 0, a * b >= Rational(1, 4))),
        repaired(given=(a > 0, b > 0, b <= 1)),
        repaired(says=Abs(epsilon0 / epsilon_star - 1) <= Rational("1.451") * epsilon_star**3),
        repaired(says=Abs(epsilon0 / epsilon_star - 1) <= Rational("1.451") * epsilon0**2),
        repaired(says=Abs(epsilon_star / epsilon0 - 1) <= Rational("1.451") * epsilon_star**2),
        repaired(says=epsilon0 - epsilon_star <= Rational("1.451") * epsilon_star**2),
        repaired(says=Abs(Q) <= Rational("1.451") * epsilon_star**2),
    ],
    ids=range(11),
)
def test_wrong_constants_regions_and_orders_are_never_enclosed(claim: Claim) -> None:
    assert judge_evidence(claim).verdict is not Verdict.ENCLOSED
