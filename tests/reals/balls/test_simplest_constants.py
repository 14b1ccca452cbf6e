"""Signs and orders at a point of contact, by the first derivative that is not exactly zero."""

import pytest
from flint import arb, fmpq

from tresym.reals.balls.simplest_constants import (
    LARGEST_DENOMINATOR,
    candidates,
    enclosure,
)
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.verdict import Verdict

E, R, U = Verdict.ENCLOSED, Verdict.REFUTED, Verdict.UNDECIDED

POINTS = ["1/3", "-7/2", "pi/4", "-2*pi/3", "E/2", "3*exp(-1)", "sqrt(2)", "-sqrt(3/5)", "log(3)"]
POINTS += ["exp(1/2)", "atan(2)", "0"]


@pytest.mark.parametrize("text", POINTS)
def test_a_short_interval_suggests_the_point_within(text: str) -> None:
    point = parse(text)
    with ball_precision(128):
        middle = evaluate(point, {})
        low, high = middle.lower().fmpq(), middle.upper().fmpq()
        worst = Interval(low - fmpq(1, 10**9), high + fmpq(2, 10**9))
        found = list(candidates(worst))
        assert any(evaluate(e, {}).overlaps(middle) for e in found)
        assert len(found) == len(set(found))


def test_known_points_come_first_and_only_if_they_are_near() -> None:
    known = [parse("sqrt(2) + sqrt(3)"), parse("4"), parse("log(23)")]
    found = list(candidates(Interval(fmpq(3146264, 10**6), fmpq(3146265, 10**6)), known))
    assert found[0] == known[0]
    assert not {known[1], known[2]} & set(found)


def test_a_point_of_large_denominator_is_no_multiple_of_a_constant() -> None:
    with ball_precision(128):
        at = (arb.pi() * fmpq(1, LARGEST_DENOMINATOR + 7)).mid().fmpq()
    gap = fmpq(1, 10**12)
    wanted = parse(f"pi/{LARGEST_DENOMINATOR + 7}")
    assert wanted not in set(candidates(Interval(at - gap, at + gap)))


@pytest.mark.parametrize("text", ["2/3", "pi", "sqrt(2)", "-exp(30)", "exp(-50)"])
def test_an_enclosure_in_rationals(text: str) -> None:
    low, high = enclosure(parse(text))
    assert (low == high) is (text == "2/3")
    with ball_precision(400):
        value = evaluate(parse(text), {})
        assert arb(low) <= value or low == high
        assert value <= arb(high) or low == high
        assert high - low < fmpq(1, 10**20)
