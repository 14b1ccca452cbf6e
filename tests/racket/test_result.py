"""The answer as a value: its decimal ball holds the ball, and says whether digits are proved."""

import json
from fractions import Fraction

import pytest
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.racket.body import shape
from tresym.racket.result import Flip, Journey, ball_json, proves
from tresym.reals.numbers.arithmetic import ball_precision


def exact(x: arb) -> Fraction:
    man, exp = x.man_exp()
    return Fraction(int(man)) * Fraction(2) ** int(exp)


@given(
    st.integers(-(10**30), 10**30),
    st.integers(-200, 200),
    st.integers(0, 10**9),
    st.integers(-200, 20),
    st.integers(1, 60),
)
def test_the_decimal_ball_holds_the_ball(
    mid: int, exp: int, rad: int, fine: int, digits: int
) -> None:
    with ball_precision(400):
        x = arb((mid, exp), arb((rad, exp + fine)))
        found = ball_json(x, digits)
        low, high = (exact(end) for end in (x.mid() - x.rad(), x.mid() + x.rad()))
        said = proves(x, digits)
    centre, radius = Fraction(found["mid"]), Fraction(found["rad"])
    assert centre - radius <= low <= high <= centre + radius
    assert ("relative" not in found) is said
    if said:
        assert radius * 10**digits <= abs(centre)


@pytest.mark.parametrize(
    ("mid", "rad", "digits", "says"),
    [
        ("1", "0", 10_000, True),
        ("0", "0", 10_000, True),
        ("0", "1e-100", 1, False),
        ("1e-99", "1e-100", 1, False),
        ("1", "1e-12", 10, True),
        ("1", "1e-12", 11, False),
        ("1e50", "1e38", 10, True),
        ("1e50", "1e40", 10, False),
        ("-3", "1e-30", 28, True),
        ("-3", "1e-30", 31, False),
    ],
)
def test_digits_are_relative_and_few_bits_are_kept(
    mid: str, rad: str, digits: int, says: bool
) -> None:
    with ball_precision(300):
        x = arb(arb(mid).mid(), arb(rad))
        assert proves(x, digits) is says
        assert ball_json(x, digits).get("relative", True) is says


def test_what_is_no_number_is_not_proved() -> None:
    for x in (arb("nan"), arb(0).union(arb(1)), arb(1, "inf"), arb(0, 1)):
        assert not proves(x, 1)


def test_a_flip_in_json() -> None:
    with ball_precision(100):
        defect, turn = arb("0.25"), arb("2.5", "1e-3")
    answer = Flip(shape("2", "1/4"), fmpq(-1, 8), 5, defect, turn, "planar", "because", 0.5)
    said = json.loads(json.dumps(answer.as_json()))
    assert said["a"] == "2"
    assert said["b"] == "1/4"
    assert said["gamma"] == "-1/8"
    assert {x: Fraction(y) for x, y in said["defect"].items()} == {"mid": Fraction(1, 4), "rad": 0}
    assert said["flip"]["relative"] is False
    assert said["psi"] is said["theta"] is None
    assert said["realizable"] is answer.realizable is True
    assert not answer._replace(shape=shape("2", "1/3")).realizable


def test_a_journey_in_json() -> None:
    """The same keys; γ may be a ball, and there is no defect."""
    with ball_precision(100):
        gamma, angle = arb("-0.125", "1e-20"), arb(1) / 3
    journey = Journey(shape("2", "1"), gamma, 5, angle, -angle, arb(0), "planar", "because", 0.5)
    said = json.loads(json.dumps(journey.as_json()))
    flip = Flip(shape("2", "1"), fmpq(0), 5, angle, angle, "planar", "because", 0.5)
    assert list(said) == list(flip.as_json())
    assert said["defect"] is None
    assert Fraction(said["gamma"]["mid"]) == Fraction(-1, 8)
    assert Fraction(said["gamma"]["rad"]) >= Fraction(1, 10**20)
    assert abs(Fraction(said["psi"]["mid"]) + Fraction(1, 3)) <= Fraction(said["psi"]["rad"])
    assert said["theta"] == {"mid": "0", "rad": "0"}
    assert said["realizable"] is False
