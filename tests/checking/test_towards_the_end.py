"""Ratios on the way to the end of a path, against mpmath."""

import mpmath
import pytest

import tresym
from tresym.checking.towards_the_end import STEPS, in_a_line, sides_of


@pytest.mark.parametrize(
    ("claim", "ratio"),
    [
        ("sin(x) ~ 2*x as x -> 0+", lambda x: mpmath.sin(x) / (2 * x)),
        ("exp(x) == 1 + O(x**2) as x -> 0", lambda x: mpmath.expm1(x) / x**2),
        ("log(x) == O(1) as x -> oo", mpmath.log),
    ],
)
def test_ratios(claim: str, ratio: object) -> None:
    sides = sides_of(tresym.check(claim))
    assert sides is not None
    rows = sides.rows(STEPS)
    assert len(rows) >= 4
    for x, values in rows:
        exact = ratio(mpmath.mpf(int(x.args[0].p)) / int(x.args[0].q))  # type: ignore[operator]
        assert abs(float(values[-1].mid()) - exact) <= 1e-12 * max(1, abs(exact))


def test_parameters_and_claims_without_a_path_leave_nothing_to_show() -> None:
    assert in_a_line(tresym.check("a*x == O(x**2) given a > 0 as x -> 0")) == ""
    assert in_a_line(tresym.check("sin(x) > x given x > 0")) == ""
