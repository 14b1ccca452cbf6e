"""Conditions, points, proven signs, denominators, and what each theory is worth."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import ALL_THEORIES
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict


def test_points_satisfy_and_repeat() -> None:
    given = Given.parse("0 < I1 < I2 < I3, 0 < b <= 1, psi != 0, I1 + b*sin(psi)**2 > 1/10")
    points = list(given.points(["x"], 12))
    assert len(points) == 12
    assert points == list(given.points(["x"], 12))
    for point in points:
        assert 0 < point["I1"] < point["I2"] < point["I3"]
        assert 0 < point["b"] <= 1
        assert all(isinstance(value, fmpq) for value in point.values())


def test_negative_values_come_early() -> None:
    first = list(Given().points(["x", "y"], 4))
    assert {(p["x"] > 0, p["y"] > 0) for p in first} >= {(True, True), (False, False)}
    assert len({(p["x"] > 0, p["y"] > 0) for p in first}) == 4


@pytest.mark.parametrize(
    ("text", "found"),
    [
        ("x > 0, x < 0", False),
        ("x >= 0, x <= 0", True),
        ("x >= 1, x <= 0", False),
        ("a**2 + 1 < 0", False),
        ("0 < x < pi", True),
        ("", True),
        ("log(x) > 0", True),
    ],
)
def test_satisfying_point(text: str, found: bool) -> None:
    assert (Given.parse(text).satisfying_point() is not None) is found


@pytest.mark.parametrize(
    ("text", "given", "expected"),
    cases(__file__, "sign"),
)
def test_sign(text: str, given: str, expected: str | None) -> None:
    assert sign(parse(text), Given.parse(given)) == expected


@pytest.mark.parametrize(
    ("text", "given", "culprit"),
    cases(__file__, "denominators"),
)
def test_denominators(text: str, given: str, culprit: str | None) -> None:
    found = undefined(parse(text), Given.parse(given))
    assert (None if found is None else str(found)) == culprit


NEEDS = cases(__file__, "NEEDS")


@pytest.mark.parametrize(("left", "right", "needed"), NEEDS)
def test_a_theory_left_out_is_not_used(left: str, right: str, needed: str) -> None:
    sides = parse(left), parse(right)
    only = decide(*sides, theories=frozenset({needed}))
    without = decide(*sides, theories=ALL_THEORIES - {needed})
    assert only.verdict is Verdict.PROVED
    assert without.verdict is Verdict.UNDECIDED
    assert decide(*sides, theories=frozenset()).verdict is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("left", "right"),
    cases(__file__, "algebra_and_equal_arguments_are_always_allowed"),
)
def test_algebra_and_equal_arguments_are_always_allowed(left: str, right: str) -> None:
    assert decide(parse(left), parse(right), theories=frozenset()).verdict is Verdict.PROVED


def test_refutation_needs_no_theory() -> None:
    decision = decide(parse("sin(x)"), parse("cos(x)"), theories=frozenset())
    assert decision.verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    ("text", "x"),
    cases(__file__, "undefined_is_nan"),
)
def test_undefined_is_nan(text: str, x: str) -> None:
    with ball_precision(100):
        value = evaluate(parse(text), {"x": arb(parse(x).args[0])})
    assert value.is_nan()


def test_cube_root_of_a_negative_number() -> None:
    with ball_precision(100):
        assert evaluate(parse("cbrt(x)"), {"x": arb(-8)}).contains(-2)
        for text in ("cbrt(x)", "x**(1/3)", "abs(x)**(2/3)", "cbrt(x**3)"):
            assert evaluate(parse(text), {"x": arb(0)}) == 0
        around = evaluate(parse("cbrt(x)"), {"x": arb(0, 8)})
        assert around.is_finite()
        assert around.contains(2)
        assert around.contains(-2)


def test_witness_is_inside_the_conditions() -> None:
    decision = decide(parse("sqrt(b**2)"), parse("-b"), Given.parse("0 < b < 1"))
    assert decision.verdict is Verdict.REFUTED
    assert decision.witness is not None
    assert 0 < decision.witness["b"] < 1


def test_true_only_for_positive_b() -> None:
    sides = parse("sqrt(a*b**2)"), parse("b*sqrt(a)")
    assert decide(*sides, Given.parse("b > 0")).verdict is Verdict.PROVED
    assert decide(*sides).verdict is Verdict.REFUTED


def test_why_is_one_sentence() -> None:
    for left, right in [("x", "x"), ("x", "y"), ("asin(sin(x/7))", "x/7"), ("sqrt(-1-x**2)", "1")]:
        why = decide(parse(left), parse(right)).why
        assert why
        assert "\n" not in why


BOUNDS = ["abs(x) < 3/2", "2 >= abs(x - 1)", "abs(x) < -1", "log(x) < 0", "log(x) >= 1/2"]
BOUNDS += ["0 > log(log(x))", "abs(log(x)) <= 1", "1 < log(x**2)", "abs(x) > 1", "log(x) != 0"]


@pytest.mark.parametrize("text", BOUNDS)
def test_bounds_of_sizes_and_logarithms_unfold_to_the_same_points(text: str) -> None:
    given = Given.parse(text)
    unfolded = given.unfolded()
    for n in range(-60, 61):
        point = {"x": fmpq(n, 17)}
        with ball_precision():
            before, after = (all(c.holds(point) for c in g.conditions) for g in (given, unfolded))
        assert before == after
