"""γ from ε, and between which levels ε(γ) is monotone, in balls, as proofs/levels.tresym says."""

from itertools import pairwise

import pytest
from differences import defect_slope
from flint import arb, fmpq

from tresym.racket.angle import parse_angle
from tresym.racket.flip.defect import defect_on, inverted
from tresym.racket.flip.levels import _bracket, _enclosed, level_of, turning_level
from tresym.racket.motion.orbit import exact_level
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, parse_number

STR = fmpq(1517, 121), fmpq(55, 874)
NOT_BODIES = [
    (fmpq(1), fmpq(7, 20)),
    (fmpq(1), fmpq(1, 2)),
    (fmpq(10), fmpq(1, 2)),
    (fmpq(3), fmpq(201, 1000)),
    (fmpq(1, 5), fmpq(1)),
]
"""Shapes with b > 1/(a + 2), far beyond it and just beyond."""


def defects(a: fmpq, b: fmpq, levels: list[fmpq]) -> list[arb]:
    with ball_precision(256):
        return [defect_on(a, b, exact_level(a, b, level)) for level in levels]


def rational(x: arb) -> fmpq:
    """The midpoint of a ball."""
    mantissa, exponent = x.mid().man_exp()
    return fmpq(mantissa) * fmpq(2) ** int(exponent)


@pytest.mark.parametrize("a", [fmpq(1, 1000), fmpq(1, 3), fmpq(2), fmpq(40), fmpq(3000)])
@pytest.mark.parametrize("part", [fmpq(1), fmpq(999, 1000), fmpq(1, 7)])
def test_the_defect_of_a_body_falls_on_the_whole_range(a: fmpq, part: fmpq) -> None:
    b = part / (a + 2)
    levels = [-b + b * fmpq(k, 12) ** 2 for k in range(1, 12)] + [a * fmpq(k, 5) for k in range(6)]
    assert all(high > low for high, low in pairwise(defects(a, b, levels)))
    assert turning_level(a, b, 20, 2) is None


@pytest.mark.parametrize("shape", NOT_BODIES)
def test_other_shapes_pass_a_right_angle_twice(shape: tuple[fmpq, fmpq]) -> None:
    """From π/2 at −b up, and down through π/2 at γ°, above which ε falls."""
    a, b = shape
    level = level_of(a, b, parse_angle("pi/2"), 30)
    again = turning_level(a, b, 30, 2)
    assert again is not None
    assert level.overlaps(again)
    apart = fmpq(1, 10**6) * (rational(level) + b)
    below, above = defects(a, b, [rational(level) - apart, rational(level) + apart])
    with ball_precision(256):
        assert below > arb.pi() / 2 > above
    levels = [rational(level) * (1 - fmpq(k, 12)) for k in range(1, 12)]
    assert all(high > low for high, low in pairwise(defects(a, b, levels)))


@pytest.mark.parametrize("shape", [s for s in NOT_BODIES if turning_level(*s, 10, 3) is not None])
def test_the_defect_rises_at_the_second_turning_level(shape: tuple[fmpq, fmpq]) -> None:
    a, b = shape
    for turns, sign in ((1, -1), (3, 1)):
        level = turning_level(a, b, 60, turns)
        assert level is not None
        gamma = rational(level)
        with ball_precision(256):
            steep = sign / (2 * (-arb(gamma) * arb(gamma + b)).sqrt())
            assert abs(defect_slope(a, b, gamma) / steep - 1) < arb("1e-25")


def test_values_above_a_right_angle_are_not_looked_for() -> None:
    for shape, value, limit in (
        (STR, "pi/2", "less than pi/2"),
        (STR, "1.5707963267948966193", "less than pi/2"),
        ((fmpq(1), fmpq(1, 2)), "2", "at most pi/2"),
    ):
        with pytest.raises(InputError, match=limit):
            level_of(*shape, parse_angle(value), 20)


@pytest.mark.slow
@pytest.mark.parametrize("value", ["3/2", "1", "1/10", "0", "-1/10"])
@pytest.mark.parametrize("shape", NOT_BODIES)
def test_the_inverse_is_where_the_defect_falls(shape: tuple[fmpq, fmpq], value: str) -> None:
    a, b = shape
    (least,) = defects(a, b, [a])
    if not least < parse_angle(value).ball():
        with pytest.raises(InputError, match="more than"):
            level_of(a, b, parse_angle(value), 20)
        return
    level = level_of(a, b, parse_angle(value), 30)
    lowest = turning_level(a, b, 30, 2)
    assert lowest is not None
    assert level > lowest
    apart = fmpq(1, 10**25) * min(rational(level) + b, a - rational(level))
    below, above = defects(a, b, [rational(level) - apart, rational(level) + apart])
    with ball_precision(256):
        assert below > parse_angle(value).ball() > above


@pytest.mark.parametrize(
    ("a", "b", "value"),
    [("1", "1", "1.5706"), ("1/100", "1", "1.57"), ("3", "999999999/1000000000", "1.5707")],
)
def test_next_to_a_right_angle_where_the_phase_stands_still(a: str, b: str, value: str) -> None:
    shape, angle = (parse_number(a), parse_number(b)), parse_angle(value)
    found = level_of(*shape, angle, 15)
    with ball_precision(300):
        low, high = found.lower().fmpq(), found.upper().fmpq()
        above, below = (inverted(*shape, level, 30).defect for level in (low, high))
        assert above > angle.ball() > below


def test_newtons_method_is_given_up_where_it_leads_nowhere() -> None:
    with pytest.raises(ArithmeticError, match="does not converge"):
        _enclosed(lambda x: x * x + arb((1, -60)), arb((1, -31)), 200, 30)


def test_a_bracket_that_does_not_exist_is_given_up() -> None:
    with pytest.raises(ArithmeticError):
        _bracket(lambda x: arb(1), 1)
    with pytest.raises(ArithmeticError):
        _bracket(lambda x: arb(-1), 1)
    with pytest.raises(ArithmeticError):
        _bracket(lambda x: x, 1, arb(2))
