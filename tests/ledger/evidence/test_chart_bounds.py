"""Bounds on regions: what is said is what is shown, and every guard has a falsehood."""

from dataclasses import replace
from functools import partial

import pytest
from flint import fmpq
from sympy import Abs, And, Basic, Eq, Gt, Ne, Rational, Symbol, Tuple, exp, expand, log, sqrt
from sympy_statements import ExactlyOne
from tresym.proofs import asymptotics, near, separatrix
from tresym.proofs.charts import BY_KAPPA, KAPPA

from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.chart_bounds import (
    Charted,
    On,
    Reading,
    Shown,
    _divides_somewhere,
    judge_charted,
)
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge_evidence
from tresym.racket.bounds import charts
from tresym.reals.balls.branch_and_bound import box
from tresym.reals.balls.tracing import Named, Part, traced
from tresym.reals.language.expression import ONE, ZERO, number
from tresym.reals.verdict import Verdict

equal = partial(Eq, evaluate=False)

x, y, z, a, b, P, Q = (Symbol(name, real=True) for name in "xyzabPQ")
epsilon0, epsilon_star = (Symbol(name, real=True) for name in ("epsilon0", "epsilon_star"))
POSITIVE = (x > 0, x <= 2)
UNIT = box((0, 2))
TWO = number(2)


def judged(says: Basic, *on: On, given: tuple[Basic, ...] = POSITIVE, **rest: object) -> Finding:
    """By this checker alone: none of the others stands in for its guards."""
    proof = Charted(on, **rest)
    return judge_charted(Claim("c", says, proof, given=given), proof)


def holds(says: Basic, *on: On, **rest: object) -> bool:
    return judged(says, *on, **rest).verdict is Verdict.ENCLOSED


def exponential(t, m):
    """(e^t − 1)/t − 9/10."""
    return charts.expm1_over(t) - fmpq(9, 10)


EXPONENTIAL = On((x,), UNIT, (Shown(exponential, x),))
SAYS = exp(x) - 1 > Rational(9, 10) * x


def test_a_bound_with_its_factor_divided_out_is_shown() -> None:
    assert holds(SAYS, EXPONENTIAL)


def test_what_a_point_denies_is_refuted() -> None:
    false = judge_evidence(Claim("c", exp(x) - 1 < x, Charted((EXPONENTIAL,)), given=POSITIVE))
    assert false is not None
    assert false.verdict is Verdict.REFUTED
    assert false.witness is not None


@pytest.mark.parametrize(
    "says",
    [
        exp(x) - 1 > Rational(91, 100) * x,
        exp(x) - 1 > x,
        exp(x) > Rational(9, 10) * x,
        exp(x) - 1 < Rational(9, 10) * x,
        exp(2 * x) - 1 > Rational(9, 10) * x,
        Tuple(SAYS, x < 1),
        Tuple(SAYS, Ne(x, 3)),
        Tuple(),
        Ne(x, 3),
        "exp(x) - 1 > 9/10*x",
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


def above_zero(t, m):
    return t + 1


NOTHING = log((x - 1) ** 3) - 3 * log(x - 1)
PLUS = On((x,), UNIT, (Shown(above_zero),))


def test_each_side_of_each_part_is_shown_and_defined() -> None:
    assert holds(x + 1 > 0, PLUS)
    assert holds(Tuple(x + 1 > 0, x > -1), PLUS)
    assert holds(And(x + 1 > 0, -x < 1, evaluate=False), PLUS)
    for says in (
        *(And(x + 1 > 0, more, evaluate=False) for more in (x > 1, x < 1, x + 5 > 0, -x < 3)),
        ExactlyOne(y, 0, 3, equal(y, x)),
        Tuple(x + 1 > 0, x > 1),
        Gt(x + 1 + NOTHING, 0, evaluate=False),
        Gt(x + 1, NOTHING, evaluate=False),
        x > -2,
    ):
        assert not holds(says, PLUS)


@pytest.mark.parametrize(
    "given",
    [
        (x**2 * (x - 1) >= 0, x >= 0, x <= 2),
        (x >= 1, x <= 1),
        (x >= 1, x <= 0),
        (x > 0, x < 0),
        (sqrt(x) >= 0, -x >= 0),
    ],
    ids=str,
)
def test_a_region_without_inside_shows_nothing(given: tuple[Basic, ...]) -> None:
    assert not holds(x + 1 > 0, replace(PLUS, box=box((0, 2))), given=given)


def test_a_margin_that_is_not_positive_shows_nothing() -> None:
    for less in (2, fmpq(3, 2), 1):
        low = Shown(lambda t, m, less=less: charts.expm1_over(t) - less, x)
        assert not holds(exp(x) - 1 > less * x, replace(EXPONENTIAL, shown=(low,)))
    open_ = judged(exp(x) - 1 > 2 * x, replace(EXPONENTIAL, shown=(low,)), budget=3)
    assert "open" in open_.why or "differ" in open_.why
    assert not holds(x > 0, replace(PLUS, shown=(Shown(lambda t, m: 1 * t),)))


def test_the_factor_of_a_margin_is_positive_everywhere() -> None:
    for over in (x - 1, (x - 1) ** 2, -x, x - x):
        says = Gt(expand(over * (x + 1)), 0, evaluate=False)
        assert not holds(says, replace(PLUS, shown=(Shown(above_zero, over),)))
    assert holds(x * (x + 1) > 0, replace(PLUS, shown=(Shown(above_zero, x),)))


def test_the_constant_is_told_where_there_is_one() -> None:
    assert judged(SAYS, EXPONENTIAL).constant is None
    assert judged(SAYS, EXPONENTIAL, constant=fmpq(9, 8)).constant == ("1.1250000000000000000", "0")


def test_a_quotient_that_has_no_value_anywhere_is_no_margin() -> None:
    for formula in (
        lambda t, m: charts.expm1_over(t - t) + t,
        lambda t, m: 1 + t + 0 * charts.log1p_over(t - t),
        lambda t, m: (t - t) / (t - t),
        lambda t, m: m.log(t - 2),
    ):
        assert not _divides_somewhere(traced(formula, 1), UNIT)
        why = judged(x + 1 > 0, replace(PLUS, shown=(Shown(formula),))).why
        assert why == "could not show that the divisors in the margin are not identically zero"
    for formula in (exponential, above_zero, lambda t, m: square(t, m) / t + half(t - t)):
        assert _divides_somewhere(traced(formula, 1), UNIT)


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
    assert not holds(SAYS, replace(low, where=(x <= 2, x <= 1)))


def test_where_sides_have_no_values_nothing_is_shown() -> None:
    on = On((x,), UNIT, (Shown(lambda t, m: charts.log1p_over(t), x),))
    assert holds(log(1 + x) > 0, on)
    assert not holds(log(1 + x) > 0, replace(on, shown=(Shown(lambda t, m: t, x),)))
    assert not holds(NOTHING + log(1 + x) > 0, on)


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
    on = On(BY_KAPPA, KAPPA, (margin,))
    cited = (separatrix.flip_defect, separatrix.defect_range, near.phase_range)
    known = {"given": near.quarter, "cited": cited}
    readings = asymptotics.repaired.proof.readings
    (right,) = (r for r in readings if r.step is charts.phase_by_kappa)
    assert holds(P > 1, on, readings=(right,), **known)
    assert not holds(P > 1, on, **known)
    for wrong in (
        replace(right, value=epsilon0),
        replace(right, value=P + 1),
        replace(right, claims=()),
        replace(right, claims=(near.phase,)),
        replace(right, cited=()),
        replace(right, at=(b, 1 / sqrt(a * b) + 1)),
        replace(right, at=(a, 1 / sqrt(a * b))),
        replace(right, given=(a > 0,)),
    ):
        value = P if wrong.value == right.value else wrong.value
        assert not holds(value > 1, on, readings=(wrong,), **known), wrong


half = Named(lambda t: t / 2, image=lambda s, t: t / TWO, between=(ZERO, ONE))
HALVED = On((x,), UNIT, (Shown(lambda t, m: half(t) + 1),))
IS_HALF, HIGH = Claim("z", equal(z, x / 2)), Claim("high", z <= 1, given=(x <= 2,))
LOW = Claim("low", z >= 0, given=(x > 0,))
READ = Reading(half, (x,), z, POSITIVE, (HIGH, IS_HALF), (LOW, HIGH))


def test_a_root_that_no_claim_names_is_none() -> None:
    assert holds(z + 1 > 0, HALVED, readings=(READ,))
    both = replace(IS_HALF, says=Tuple(z > -5, equal(z, x / 2)))
    assert holds(z + 1 > 0, HALVED, readings=(replace(READ, claims=(both,)),))
    assert (
        judged(z + 1 > 0, HALVED).why == "no reading says which root a step of the margin denotes"
    )
    for wrong in (
        replace(READ, claims=()),
        replace(READ, claims=(HIGH,)),
        replace(READ, claims=(replace(IS_HALF, says="z = x/2"),)),
        replace(READ, claims=(replace(IS_HALF, says=z >= x / 2),)),
        replace(READ, claims=(replace(IS_HALF, says=equal(z, x / 3)),)),
        replace(READ, claims=(replace(IS_HALF, says=equal(y, x / 2)),)),
        replace(READ, claims=(replace(IS_HALF, given=(x > 1,)),)),
        replace(READ, cited=(LOW,)),
        replace(READ, cited=(HIGH,)),
        replace(READ, given=(*POSITIVE, x > 1)),
    ):
        assert not holds(z + 1 > 0, HALVED, readings=(wrong,)), wrong
    for changed in ({"image": None}, {"between": None}):
        other = replace(half, **changed)
        on = replace(HALVED, shown=(Shown(lambda t, m, other=other: other(t) + 1),))
        found = judged(z + 1 > 0, on, readings=(replace(READ, step=other),))
        assert found.why == "the step of the reading is neither a formula nor a root"


def test_what_a_step_asks_of_its_arguments_is_shown() -> None:
    """A root, and a function that says itself what it means: each of what they ask."""
    meant = replace(half, meaning=lambda t: t / TWO, image=None, between=None)
    for step, says, readings in (
        (half, z + 1 > 0, (READ,)),
        (meant, x / 2 + 1 > 0, ()),
        (meant, x / 2 + 1 > 0, (Reading(meant, (x,), x / 2, POSITIVE),)),
    ):
        for asks, allowed in (
            (lambda t: (t, t + ONE), True),
            (lambda t: (t - ONE,), False),
            (lambda t: (t, t - ONE), False),
        ):
            asking = replace(step, asks=asks)
            on = replace(HALVED, shown=(Shown(lambda t, m, asking=asking: asking(t) + 1),))
            read = tuple(replace(reading, step=asking) for reading in readings)
            assert holds(says, on, readings=read) is allowed


def test_a_reading_is_of_all_its_arguments() -> None:
    product = Part(lambda s, t, m: s * t)
    on = replace(PLUS, shown=(Shown(lambda t, m: 1 + t + product(t, t, m)),))
    assert holds(1 + x + x**2 > 0, on, readings=(Reading(product, (x, x), x**2, POSITIVE),))
    other = Reading(product, (x, x - 10), x * (x - 10), POSITIVE)
    assert not holds(1 + x + x * (x - 10) > 0, on, readings=(other,))


# -- the paper's ----------------------------------------------------------------------------------


def first(b_, k_, m):
    return charts.first_excess(charts.root_by_kappa(b_, k_, m), m)


def repaired(limit: str = "1.451", margin: str = "1.451", **changes: object) -> Claim:
    says = Abs(epsilon0 / epsilon_star - 1) <= Rational(limit) * epsilon_star**2
    most, gauge = fmpq(*map(int, Rational(margin).as_numer_denom())), epsilon_star**2
    shown = (
        Shown(lambda *at: most - first(*at), gauge),
        Shown(lambda *at: most + first(*at), gauge),
    )
    known = asymptotics.repaired
    proof = replace(known.proof, on=(On(BY_KAPPA, KAPPA, shown),), constant=None)
    return replace(replace(known, says=says, proof=proof), **changes)


def test_the_first_order_is_enclosed() -> None:
    assert judge_charted(repaired(), repaired().proof).verdict is Verdict.ENCLOSED


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
