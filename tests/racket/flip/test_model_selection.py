"""Model selection: the cheapest model with the digits, models that agree or do not answer."""

from typing import Any

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

import tresym
from tresym.racket.angle import Angle, parse_angle
from tresym.racket.body import Shape, named_body, shape
from tresym.racket.flip import asymptotic, defect, flip_defect, flip_defects, model_selection
from tresym.racket.flip.model_selection import MODELS, checked_digits, climb, follow, parse_digits
from tresym.racket.motion.trajectory import Start
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError

STR = named_body("str").shape
FAR = shape("100", "1")


@pytest.mark.parametrize(
    ("text", "digits"), [("1", 1), (" 50 ", 50), ("10000", 10_000), ("007", 7)]
)
def test_digits_that_are_read(text: str, digits: int) -> None:
    assert parse_digits(text) == digits


@pytest.mark.parametrize(
    "text",
    ["", "0", "-1", "+5", "10001", "1e3", "5.0", "٥", "²", "1_0", "000001", "\t5", "5\n", "9" * 99],
)  # fmt: skip
def test_digits_that_are_refused(text: str) -> None:
    with pytest.raises(InputError, match="from 1 to 10000"):
        parse_digits(text)


@pytest.mark.parametrize("digits", [True, 0, -3, 10_001, 5.0, "5", None])
def test_only_a_whole_number_of_digits_is_one(digits: Any) -> None:
    with pytest.raises(InputError, match="from 1 to 10000"):
        checked_digits(digits)
    with pytest.raises(InputError, match="from 1 to 10000"):
        climb(STR, 0, digits)
    with pytest.raises(InputError, match="from 1 to 10000"):
        follow(STR, Start(Angle(fmpq(0), fmpq(1)), fmpq(0)), parse_angle("2*pi"), digits)


PLACES = [
    (STR, fmpq(0), 2, "asymptotic"),
    (STR, fmpq(0), 9, "separatrix"),
    (STR, fmpq(0), 200, "separatrix"),
    (FAR, fmpq(0), 30, "asymptotic"),
    (FAR, fmpq(0), 200, "separatrix"),
    (STR, fmpq(1, 10**300), 20, "carlson"),
    (STR, fmpq(12), 20, "carlson"),
    (STR, fmpq(-1, 50), 20, "carlson"),
    (STR, STR.a, 20, "planar"),
    (STR, -STR.b, 20, "planar"),
    (shape("1e40", "1"), fmpq(0), 20, "separatrix"),
    (shape("1e-9", "1e-9"), fmpq(0), 20, "separatrix"),
]


@pytest.mark.parametrize(("body", "gamma", "digits", "model"), PLACES, ids=str)
def test_the_first_model_with_the_digits_answers(
    body: Shape, gamma: fmpq, digits: int, model: str
) -> None:
    answer = climb(body, gamma, digits)
    assert answer.model == model
    assert (answer.shape, answer.gamma, answer.digits) == (body, gamma, digits)
    with ball_precision(bits(digits, 64)):
        assert (answer.turn + 2 * answer.defect).overlaps(arb.pi())
        tiny = arb(10) ** -digits
        for x in (answer.defect, answer.turn):
            assert proves(x, digits) or (x.contains(0) and x.rad() < tiny)
    # No cheaper model has the digits.
    for cheaper in MODELS[: MODELS.index(model)]:
        with pytest.raises(InputError, match="model: "):
            climb(body, gamma, digits, cheaper)


shapes = st.tuples(st.fractions("1/10", 40), st.fractions("1/20", 1))


@pytest.mark.slow
@given(shapes, st.fractions("-9/10", "9/10"), st.integers(1, 40))
def test_the_models_that_answer_agree(given_: tuple[Any, Any], part: Any, digits: int) -> None:
    body = shape(*given_)
    gamma = fmpq(*part.as_integer_ratio()) * (body.a if part > 0 else body.b)
    for level in (gamma, fmpq(0)):
        best = climb(body, level, digits)
        truth = climb(body, level, digits + 20, "planar")
        for model in MODELS:
            try:
                other = climb(body, level, digits, model)
            except InputError:
                continue
            assert other.defect.overlaps(truth.defect)
            assert other.turn.overlaps(truth.turn)
            assert MODELS.index(best.model) <= MODELS.index(model) or model == "asymptotic"
            assert proves(other.defect, digits) or other.defect.contains(0)


@pytest.mark.parametrize(
    ("gamma", "model", "says"),
    cases(__file__, "what_a_model_cannot_do_is_said"),
)
def test_what_a_model_cannot_do_is_said(gamma: str, model: str | None, says: str) -> None:
    with pytest.raises(InputError, match=says):
        climb(STR, parse_angle(gamma).radians, 30, model)


@pytest.mark.parametrize("wide", [arb(0, 1), arb("1e-15", "1e-45"), arb("nan")])
def test_a_ball_that_does_not_prove_the_digits_is_no_answer(
    wide: arb, monkeypatch: pytest.MonkeyPatch
) -> None:
    """A closed formula that were too wide, whatever float64 promised, is passed over."""
    monkeypatch.setattr(asymptotic, "enclose", lambda *_: wide)
    monkeypatch.setattr(asymptotic, "reach", lambda *_: 1e9)
    answer = climb(FAR, 0, 40)
    assert answer.model == "separatrix"
    assert proves(answer.defect, 40)
    with pytest.raises(InputError, match="asymptotic reaches"):
        climb(FAR, 0, 40, "asymptotic")


def test_where_the_quick_route_says_nothing_the_last_model_answers(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    right = climb(STR, fmpq(1), 30)
    monkeypatch.setattr(defect, "quick", lambda *_: None)
    answer = climb(STR, fmpq(1), 30)
    assert (right.model, answer.model) == ("carlson", "planar")
    assert answer.defect.overlaps(right.defect)


def test_starts_are_followed_by_the_last_model_only() -> None:
    start = Start(parse_angle("pi/2"), fmpq(1, 10))
    journey = follow(STR, start, parse_angle("2*pi"), 25)
    assert journey.model == "planar"
    assert proves(journey.turn, 25)
    assert follow(STR, start, parse_angle("2*pi"), 25, "planar").turn.overlaps(journey.turn)
    for model in (*MODELS[:3], "fast"):
        with pytest.raises(InputError, match="model: "):
            follow(STR, start, parse_angle("2*pi"), 25, model)


def test_the_symmetric_start_is_the_flip() -> None:
    """From ψ = π/2 on γ after half a turn ψ has gone on by π/2 − ε."""
    gamma = fmpq(3, 10)
    body = shape("3", "1/5")
    with ball_precision(300):
        handle = ((arb(gamma) + arb(body.b)) / arb(body.a + body.b)).sqrt()
    assert handle.overlaps(arb(fmpq(5, 32)).sqrt())
    half = follow(
        shape("7/4", "1/4"),
        Start(parse_angle("pi/2"), theta=parse_angle("pi/3")),
        parse_angle("pi"),
        30,
    )
    # cos²(π/3) = (γ + b)/(a + b) gives γ = 1/4.
    assert half.gamma == fmpq(1, 4)
    flip = climb(shape("7/4", "1/4"), fmpq(1, 4), 30)
    with ball_precision(200):
        assert (arb.pi() / 2 - half.turn).overlaps(flip.defect)


def test_the_estimate_only_spares_attempts() -> None:
    assert model_selection._worth_trying(FAR, fmpq(0), 30) == MODELS
    assert model_selection._worth_trying(FAR, fmpq(0), 300) == MODELS[1:]
    assert model_selection._worth_trying(STR, fmpq(1, 10**400), 30) == MODELS[2:]
    assert model_selection._worth_trying(shape("1e4000", "1e-4000"), fmpq(0), 1) == MODELS[1:]


def test_many_shapes_are_answered_as_one_by_one() -> None:
    many = [("12.5372", "0.0629"), shape(3, "1/2"), named_body("str"), ("1", "1/3")]
    found = flip_defects(many, "1/10", 20)
    alone = [flip_defect(*(x if type(x) is tuple else (x,)), gamma="1/10", digits=20) for x in many]
    assert [str(f.defect) for f in found] == [str(f.defect) for f in alone]
    assert flip_defects([]) == []


@pytest.mark.parametrize(
    ("shapes", "says"),
    [
        ([("1", "1/2"), ("1", "2")], "shape 2: shape parameter b"),
        ([("1", "1/2"), ("1",)], "shape 2: give a pair"),
        ([(1.0, "1/2")], "shape 1: shape parameter a: float"),
        (["12"], "shape 1: give a pair"),
        ([None], "shape 1: give a pair"),
        ("12", "shapes: "),
        (7, "shapes: "),
    ],
)
def test_a_shape_that_is_none_is_named_by_its_place(shapes: Any, says: str) -> None:
    with pytest.raises(InputError, match=says):
        flip_defects(shapes)


def test_old_names_still_work() -> None:
    found = tresym.flip_defect("1", "1/10", digits=6, rung="separatrix")
    assert found.rung == found.model == "separatrix"
    assert found.as_json()["rung"] == found.as_json()["model"]
    assert tresym.bodies["wilson"] is tresym.bodies["str"]
    assert "wilson" not in [*tresym.bodies]
