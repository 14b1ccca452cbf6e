"""What numbers along a path show: failing, holding, or neither."""

import pytest
from cases import cases
from flint import arb

from tresym.asymptotics.numerical_evidence import Ray, fails, follows_a_law, oscillating
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.numbers.arithmetic import ball_precision


def ray(claim: str, side: int = 1, **at: int) -> Ray:
    statement = read(claim)
    assert statement.path is not None
    values = {name: arb(value) for name, value in at.items()}
    return Ray(statement.comparisons[0], statement.path, side, values, statement.integers)


FAILS = cases(__file__, "FAILS")
HOLDS = cases(__file__, "HOLDS")
OPEN = [
    "sqrt(x) -> 0 as x -> 0-",  # not real there
    "f(x) -> 0 as x -> 0",
    "integral(f(t), t, 0, x) -> 0 as x -> 0",
    "log(-1 - x**2) == O(1) as x -> 0",
]


@pytest.mark.parametrize(
    ("claim", "expected"),
    [
        *((claim, True) for claim in FAILS),
        *((claim, False) for claim in HOLDS),
        *((claim, None) for claim in OPEN),
    ],
)
def test_what_numbers_show(claim: str, expected: bool | None) -> None:
    side = -1 if claim.endswith("-") else 1
    assert fails(ray(claim, side)) is expected


def test_slow_limits_are_not_taken_to_fail() -> None:
    for claim in ("1/log(x) -> 0", "1/log(log(x)) -> 0", "log(x)**9/x -> 0", "sin(x)/log(x) -> 0"):
        assert fails(ray(f"{claim} as x -> oo")) is not True
    assert fails(ray("x**100 == o(exp(x/10**6)) as x -> oo")) is not True


def test_parameters_and_sides() -> None:
    assert fails(ray("sin(n*x) -> 0 as x -> pi", n=2)) is False
    assert fails(ray("cos(n*x) -> 1 as x -> pi", n=3)) is True
    assert fails(ray("abs(x)/x -> 1 as x -> 0", 1)) is False
    assert fails(ray("abs(x)/x -> 1 as x -> 0", -1)) is True
    assert fails(ray("1/(x - a) -> oo as x -> a", -1, a=3)) is True


def test_waves_are_those_of_arguments_that_grow() -> None:
    for claim, count in (
        ("sin(x)*cos(x**2) == O(1) as x -> oo", 2),
        ("sin(1/x)*cos(x) == O(1) as x -> oo", 1),
        ("sin(x) == O(x) as x -> 0", 0),
        ("sin(exp(x)) == O(1) as x -> oo", 1),
        ("sin(exp(-x)) == O(1) as x -> oo", 0),
    ):
        assert len(oscillating(ray(claim))) == count, claim


@pytest.mark.parametrize(
    ("sizes", "law"),
    [
        *(([1, 1, 1], True), ([2**90, 2**30, 2**10], True), ([3, 2, 1], False)),  # u^(1/10), none
        *(([90, 30, 10], True), ([5, 3, 2], False), ([0, 0, 0], False)),  # log(u)
    ],
)
def test_only_a_simple_law_speaks_against_a_limit(sizes: list[int], law: bool) -> None:
    """Sizes at the distances 2**900, 2**300 and 2**100, the farthest first."""
    orders = [arb(900), arb(300), arb(100)]
    with ball_precision(200):
        assert follows_a_law(orders, [arb(size) for size in sizes]) is law
