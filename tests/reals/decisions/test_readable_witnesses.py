"""Points with small numbers in conditions."""

from flint import fmpq

from tresym.reals.decisions.readable_witnesses import constants_hold, simple_points
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse


def test_small_numbers_come_first_and_satisfy_the_conditions() -> None:
    assert simple_points(["a"], Given.parse("a > 0"), 2) == [{"a": fmpq(2)}, {"a": fmpq(3)}]
    far = simple_points(["a"], Given.parse("a > 1000"), 2)
    assert far
    assert all(point["a"] > 1000 for point in far)
    assert simple_points(["a"], Given.parse("a > 1, a < 0"), 2) == []


def test_conditions_between_constants_hold_exactly_or_are_not_taken() -> None:
    x, root = parse("x"), parse("sqrt(2)*sqrt(8)")
    assert constants_hold([(root, ">=", parse("4")), (x, ">", root)]) is not None
    for beyond in ("4 + 10**(-90)", "5", "log(-1)"):
        assert constants_hold([(root, ">=", parse(beyond))]) is None
