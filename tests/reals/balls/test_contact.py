"""Signs and orders at a point of contact, by the first derivative that is not exactly zero."""

from __future__ import annotations

import pytest
from flint import arb, fmpq

from tresym.reals.balls.contact import (
    LARGEST_DENOMINATOR,
    candidates,
    decide_smooth,
    enclosure,
    sign_at_contact,
)
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.places.values import evaluate
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


SIGNS = [
    # (function, point, sign above, sign below)
    ("x**3", "0", 1, -1),
    ("1 - cos(x)", "0", 1, 1),
    ("sin(x) - x", "0", -1, 1),
    ("sin(x) - x + x**3/6", "0", 1, -1),
    ("(x**2 - 2)**2", "sqrt(2)", 1, 1),
    ("x**2 - 2", "sqrt(2)", 1, -1),
    ("sin(x)**3", "pi", -1, 1),
    ("log(x) - x + 1", "1", -1, -1),
    ("exp(x) - 3 - 3*(x - log(3))", "log(3)", 1, 1),
    ("tan(x) - 2", "atan(2)", 1, -1),
    ("x + 5", "0", 1, 1),
    # neither shown to be zero nor seen to differ from it; not smooth; flat beyond the orders
    ("x - 10**(-60)", "0", None, None),
    ("x**2 - 2 - 10**(-60)", "sqrt(2)", None, None),
    ("abs(x)", "0", None, None),
    ("sqrt(x)", "0", None, None),
    ("x*sin(1/x)", "0", None, None),
    ("log(x)", "0", None, None),
    ("x**9", "0", None, None),
    ("sin(x) - sin(x)", "0", None, None),
]


@pytest.mark.parametrize(("text", "at", "above", "below"), SIGNS)
def test_the_sign_beside_a_point_of_contact(
    text: str, at: str, above: int | None, below: int | None
) -> None:
    e, point = parse(text), parse(at)
    for side, expected in ((1, above), (-1, below)):
        found = sign_at_contact(e, "x", point, side)
        assert (None if found is None else found[0]) == expected
        if found is None:
            continue
        sign, reach = found
        with ball_precision(200):
            for k in range(1, 33):
                x = evaluate(point, {}) + side * arb(reach * fmpq(k, 32))
                assert sign * evaluate(e, {"x": x}) > 0


@pytest.mark.parametrize("text", ["x**2*(1/100 - x)", "x*(x - 1/100)*(x + 1/200)", "x**2*log(x+2)"])
def test_the_neighbourhood_ends_before_the_next_zero(text: str) -> None:
    for side in (1, -1):
        found = sign_at_contact(parse(text), "x", parse("0"), side)
        assert found is not None
        with ball_precision(128):
            at = {"x": side * arb(0).union(arb(found[1])) + side * arb(fmpq(1, 10**30))}
            assert evaluate(parse(text), at).is_finite()
            values = [
                evaluate(parse(text), {"x": side * arb(found[1] * fmpq(k, 64))})
                for k in range(1, 65)
            ]
            assert all(found[0] * value > 0 for value in values)


ORDERS = [
    # (kind, left, right, point, verdict)
    ("O", "sin(x) - x", "x**3", "0", E),
    ("O", "sin(x) - x", "x**4", "0", R),
    ("o", "sin(x) - x", "x**2", "0", E),
    ("o", "sin(x) - x", "x**3", "0", R),
    ("~", "sin(x) - x", "-x**3/6", "0", E),
    ("~", "sin(x) - x", "x**3/6", "0", R),
    ("~", "sin(x) - x", "-x**3/6*(1 + 10**(-30))", "0", R),
    ("~", "sin(x) - x", "-x**3/6*(1 + 10**(-60))", "0", U),
    ("~", "x**2 - 2", "2*sqrt(2)*(x - sqrt(2))", "sqrt(2)", E),
    ("~", "x**2 - 2", "3*(x - sqrt(2))", "sqrt(2)", R),
    ("~", "log(x/3)", "x/3 - 1", "3", E),
    ("O", "tan(x) - 2", "x - atan(2)", "atan(2)", E),
    ("O", "tan(x) - 2", "(x - atan(2))**2", "atan(2)", R),
    ("O", "cos(x)", "1", "pi/2", E),
    ("O", "sin(x)", "x*(1/8 - x)", "0", E),
    ("o", "cos(x)", "1", "pi/2", E),
    ("~", "x**2", "2*x", "0", R),  # their last derivatives agree, their orders do not
    ("~", "sin(x)", "x**3/6 + x**2/2", "0", R),
    ("O", "x**2", "2*x", "0", E),
    ("O", "x", "x**2/2", "0", R),
    ("O", "sqrt(x)", "x", "0", U),
    ("O", "x", "sqrt(x)", "0", U),
    ("~", "x + abs(x)**3", "x", "0", U),
    ("O", "x", "x - x", "0", U),
    ("O", "abs(x)", "x", "0", U),
]


@pytest.mark.parametrize("side", [1, -1])
@pytest.mark.parametrize(("kind", "left", "right", "at", "verdict"), ORDERS)
def test_orders_at_a_point(
    kind: str, left: str, right: str, at: str, verdict: Verdict, side: int
) -> None:
    f, g, point = parse(left), parse(right), parse(at)
    found = decide_smooth(kind, f, g, "x", point, side)
    assert found.verdict is verdict
    if verdict is E and kind == "O":
        assert found.constant is not None
        with ball_precision(300):
            for k in range(1, 33):
                x = {"x": evaluate(point, {}) + side * arb(found.upto * fmpq(k, 32))}
                assert abs(evaluate(f, x)) <= found.constant.upper() * abs(evaluate(g, x))


@pytest.mark.parametrize("text", ["2/3", "pi", "sqrt(2)", "-exp(30)", "exp(-50)"])
def test_an_enclosure_in_rationals(text: str) -> None:
    low, high = enclosure(parse(text))
    assert (low == high) is (text == "2/3")
    with ball_precision(400):
        value = evaluate(parse(text), {})
        assert arb(low) <= value or low == high
        assert value <= arb(high) or low == high
        assert high - low < fmpq(1, 10**20)


def test_the_constant_is_no_larger_than_the_supremum() -> None:
    found = decide_smooth("O", parse("x**2"), parse("sin(20*x)"), "x", parse("0"), 1)
    assert found.verdict is E
    with ball_precision(64):
        at = arb(found.upto)
        assert found.constant.lower() <= at**2 / (20 * at).sin() <= found.constant.upper()
    found = decide_smooth("O", parse("3*x + x**2"), parse("sin(x)"), "x", parse("0"), 1)
    assert found.constant.lower() >= 3 - arb("1e-6")
