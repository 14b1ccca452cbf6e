"""The certified flip on the separatrix: balls, digits, routes, and what is refused."""

import math
from fractions import Fraction

import mpmath
import numpy as np
import pytest
from cases import cases
from flint import acb, arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

import tresym
from tresym.racket.body import NAMED_BODIES, Body, Shape, named_body, shape
from tresym.racket.flip import Flip, asymptotic, flip_defect
from tresym.racket.flip import separatrix as solver
from tresym.racket.formulas import printed, stable
from tresym.racket.result import ball_json, proves
from tresym.reals.numbers.arithmetic import ball_precision, balls, mp_precision, to_mp
from tresym.reals.numbers.exact import InputError, parse_number

# 75 shapes: five b, and ab from 1/1000 to 10 000 in half decades
SHAPES = [
    shape(fmpq(round(10**6 * 10 ** (half / 2)), 10**6) / parse_number(b), b)
    for b in ("0.01", "0.1", "0.31", "0.9", "1")
    for half in range(-6, 9)
]


def shape_id(s: Shape) -> str:
    return f"b={float(Fraction(str(s.b))):g},ab={float(Fraction(str(s.a * s.b))):.3g}"


def literal_sign(defect: arb, s: Shape) -> int:
    """The sign of the paper's literal equation at an exact point, at enough precision."""
    precision = 128
    while True:
        with ball_precision(precision):
            value = printed.separatrix_residual(defect, arb(s.a), arb(s.b), balls)
        if value > 0:
            return 1
        if value < 0:
            return -1
        precision *= 2


def test_the_literal_equation_changes_sign_across_the_ball() -> None:
    for s in SHAPES:
        answer = flip_defect(s.a, s.b)
        assert proves(answer.defect, 50)
        assert literal_sign(answer.defect.lower(), s) == -1
        assert literal_sign(answer.defect.upper(), s) == 1


def mpmath_defect(s: Shape, digits: int) -> mpmath.mpf:
    """ε₀ by mpmath alone: the paper's equation, in logarithms, by bisection and secants."""
    with mp_precision(digits + 20) as mp:
        a, b = to_mp(s.a, mp), to_mp(s.b, mp)

        def residual(log_defect: mpmath.mpf) -> mpmath.mpf:
            defect = mp.exp(log_defect)
            left = mp.log(stable.separatrix_left(defect, a, b, mp))
            arc = mp.asin(mp.sqrt(b / (a + b)) * mp.cos(defect))
            return left + 2 * mp.sqrt(a * b) * (mp.pi + arc)

        ends = (-2 * mp.pi * mp.sqrt(a * b) - 10, mp.log(mp.pi / 2))
        return mp.exp(mp.findroot(residual, ends, solver="anderson", tol=mp.mpf(10) ** -digits))


def test_mpmath_solves_to_the_same_fifty_digits() -> None:
    for s in SHAPES:
        answer = flip_defect(s.a, s.b)
        with mp_precision(80), ball_precision(300):
            second = mpmath_defect(s, 60)
            second_ball = arb((int(second.man), int(second.exp)))
            assert abs(second_ball / answer.defect - 1) < arb("1e-50")


def digits_of_findroot(s: Shape) -> float:
    """Right digits of mpmath's root of the printed equation from the paper's start, at 50."""
    truth = flip_defect(s.a, s.b, digits=80).defect
    with mp_precision(50) as mp:
        a, b = to_mp(s.a, mp), to_mp(s.b, mp)
        start = printed.asymptotic_defect(a, b, mp)
        found = mp.findroot(lambda e: printed.separatrix_residual(e, a, b, mp), start)
        error = abs(found / mp.mpf(truth.str(70, radius=False)) - 1)
        return float(-mp.log10(error + mp.mpf(10) ** -60))


def test_findroot_on_the_printed_equation_silently_loses_digits() -> None:
    digits = [digits_of_findroot(s) for s in SHAPES]
    assert sum(d < 45 for d in digits) >= 25
    assert sum(d < 2 for d in digits) >= 8


@pytest.mark.parametrize("s", [s for s in SHAPES if s.a * s.b >= 100], ids=shape_id)
def test_the_printed_equation_is_dead_in_float64(s: Shape) -> None:
    defect, a, b = (float(x) for x in (flip_defect(s.a, s.b).defect, arb(s.a), arb(s.b)))
    assert printed.separatrix_left(np.float64(defect), a, b, np) == 0
    assert printed.separatrix_right(np.float64(defect), a, b, np) >= 0
    k, r = math.sqrt(a * b), math.sqrt(b / a)
    phase, _ = solver.float_phase(k, b)
    if k * phase < 700:
        assert stable.defect_at(phase, k, r, np) == pytest.approx(defect, rel=1e-12)


@pytest.mark.parametrize("digits", [1, 2, 15, 50, 333, 1000, 10_000])
def test_any_number_of_digits_is_delivered(digits: int) -> None:
    answer = flip_defect("12.5372", "0.0629", digits=digits)
    for key, ball in (("defect", answer.defect), ("flip", answer.turn)):
        text = answer.as_json()[key]
        with ball_precision(40_000):
            mid, rad = arb(text["mid"]), arb(text["rad"])
            assert rad * arb(10) ** digits <= mid
            assert mid - rad <= ball.lower()
            assert ball.upper() <= mid + rad
    with ball_precision(40_000):
        assert answer.defect.overlaps(flip_defect("12.5372", "0.0629", digits=60).defect)


positive = st.fractions(min_value=Fraction(1, 10**9), max_value=10**9, max_denominator=10**12)
share = st.fractions(min_value=Fraction(1, 10**9), max_value=1, max_denominator=10**12)


@given(a=positive, b=share, digits=st.integers(1, 120))
def test_more_digits_refine_the_same_root(a: Fraction, b: Fraction, digits: int) -> None:
    one, two = (flip_defect(a, b, digits=n) for n in (digits, digits + 40))
    with ball_precision(800):
        assert one.defect.overlaps(two.defect)
        assert proves(one.defect, digits)
        assert proves(one.turn, digits)
        # The ball solves the fixed-point form of the separatrix equation, of which it knows nothing
        again = stable.separatrix_map(two.defect, arb(shape(a, b).a), arb(shape(a, b).b), balls)
        assert again.overlaps(two.defect)
        assert (two.turn + 2 * two.defect).overlaps(arb.pi())
        assert 0 < two.defect < arb.pi() / 2


@given(a=positive, b=share)
@settings(max_examples=25)
def test_the_defect_falls_as_either_parameter_grows(a: Fraction, b: Fraction) -> None:
    least = flip_defect(a, b).defect
    assert flip_defect(a * Fraction(101, 100), b).defect < least
    assert flip_defect(a, b * Fraction(99, 100)).defect > least


EXTREMES = cases(__file__, "EXTREMES")


@pytest.mark.parametrize(("a", "b"), EXTREMES)
def test_extreme_shapes_keep_every_digit(a: str, b: str) -> None:
    answer = flip_defect(a, b, digits=30)
    assert proves(answer.defect, 30)
    assert proves(answer.turn, 30)


def test_the_limits_of_the_shape() -> None:
    with ball_precision(200):
        # b -> 0: no flip at all; a -> infinity at ab = 1: the floor 2 arctan(e^-pi)
        assert flip_defect("1", "1e-10000").defect.overlaps(arb.pi() / 2)
        floor = 2 * (-arb.pi()).exp().atan()
        assert flip_defect("1e10000", "1e-10000").defect.overlaps(floor)


def test_a_defect_that_cannot_be_told_from_zero_says_so() -> None:
    answer = flip_defect("1e40", "1", digits=25)
    text = answer.as_json()["defect"]
    assert text["relative"] is False
    assert parse_number(text["rad"]) <= parse_number("1e-25")
    assert answer.defect.contains(0)
    assert proves(answer.turn, 24)


def test_precision_is_left_as_it_was_found() -> None:
    before = ctx.prec
    flip_defect("12.5372", "0.0629", digits=200)
    assert ctx.prec == before


def test_the_root_is_enclosed_from_points_that_are_near_and_from_no_others() -> None:
    with ball_precision(128):
        k, r = arb(1), arb(1) / 10
        root = solver.enclose_phase(k, r, 128)
        for offset in (0, 1e-6, -1e-6):
            image = solver.root_from((root + offset).mid(), k, r)
            assert image.contains(root.mid()) or image.overlaps(root)
        # What is left out is bounded for x ≥ 3 and |y| ≤ 1/34 alone.
        for far in (root + 0.05, arb(2.9), arb(-3), arb.nan()):
            with pytest.raises(ArithmeticError):
                solver.root_from(far.mid(), k, r)


@given(log_k=st.floats(-8, 5), b=st.floats(1e-6, 1.0), offset=st.floats(-0.02, 0.02))
def test_what_is_left_out_of_the_inverse_is_in_the_ball(
    log_k: float, b: float, offset: float
) -> None:
    """Far from the root the remainder is the ball's whole width."""
    with ball_precision(256):
        k = arb(log_k).exp()
        r = b / k
        root = solver.enclose_phase(k, r, 250)
        far = root_from(root, offset, k, r)
        assert far.overlaps(root)
        fourth = (abs(offset) * 2) ** 4
        assert far.rad() < 20 * fourth + 1e-70


def root_from(root: arb, offset: float, k: arb, r: arb) -> arb:
    """The enclosure from a point so far away; from 3 where it would lie below."""
    return solver.root_from(max((root + offset).mid(), arb(3)), k, r)


@given(
    theta=st.floats(0, 1.5707),
    log_s=st.floats(-6, 6),
    x=st.floats(3, 9),
    at=st.complex_numbers(max_magnitude=1),
)
def test_the_slope_on_the_disc_is_below_a_half(
    theta: float, log_s: float, x: float, at: complex
) -> None:
    """|u′| < 1/2 for |z − x| ≤ 1, which is what the bound on the remainder rests on."""
    k = math.exp(log_s) * math.cos(theta)
    r = math.tan(theta)
    with ball_precision(128):
        w = acb(k) * (acb(x) + acb(at.real, at.imag))
        slope = k * r / (w.cosh() ** 2 + r * r * w.sinh() ** 2)
        assert abs(slope) < 0.5 or not slope.is_finite()


@given(log_k=st.floats(-700, 700), b=st.floats(1e-300, 1.0))
def test_the_float_start_is_good_to_half_its_digits(log_k: float, b: float) -> None:
    k = math.exp(log_k)
    phase, slope = solver.float_phase(k, b)
    with ball_precision(200):
        truth = solver.enclose_phase(arb(k), arb(b) / arb(k), 200)
        assert abs(truth - phase) < 1e-13
        assert abs(stable.phase_slope(truth, arb(k), arb(b) / arb(k), balls) - slope) < 1e-9
    assert solver.float_phase(0.0, b) == pytest.approx(solver.float_phase(1e-300, b))
    assert solver.float_phase(math.inf, b) == (math.pi, 1.0)


@given(a=positive, b=share)
def test_the_closed_formula_contains_the_root(a: Fraction, b: Fraction) -> None:
    s = shape(a, b)
    answer = asymptotic.enclose(s.a, s.b, 40)
    with ball_precision(1000):
        assert answer is not None
        assert answer.contains(solver.solve(s.a, s.b, 120).defect)


def test_the_lowest_model_that_meets_the_digits_answers() -> None:
    few, many = (flip_defect("12.5372", "0.0629", digits=n) for n in (4, 40))
    assert (few.model, many.model) == ("asymptotic", "separatrix")
    assert flip_defect("10000", "1", digits=60).model == "asymptotic"
    forced = flip_defect("12.5372", "0.0629", digits=4, model="separatrix")
    assert forced.model == "separatrix"
    with ball_precision(200):
        assert few.defect.contains(many.defect)
        assert few.turn.contains(many.turn)
    for a in ("12.5372", "0.01", "1e40"):
        with pytest.raises(InputError, match=r"asymptotic reaches \d digits"):
            flip_defect(a, "1" if a != "12.5372" else "0.0629", model="asymptotic")


def test_the_answer_in_json_has_every_key() -> None:
    answer = flip_defect("12.5372", "0.0629").as_json()
    assert answer["a"] == "31343/2500"
    assert answer["b"] == "629/10000"
    assert answer["gamma"] == "0"
    assert answer["digits"] == 50
    assert answer["model"] == "separatrix"
    assert answer["realizable"] is True
    assert answer["seconds"] >= 0
    assert set(answer["defect"]) == set(answer["flip"]) == {"mid", "rad"}
    assert ball_json(arb(0), 50) == {"mid": "0", "rad": "0"}


def test_the_answer_is_a_value() -> None:
    answer = tresym.flip_defect(Fraction(1517, 121), "55/874")
    assert isinstance(answer, Flip)
    with pytest.raises(AttributeError):
        answer.defect = arb(0)  # type: ignore[misc]


# Bodies


def test_moments_give_the_shape_exactly() -> None:
    body = Body("1210", 16380, Fraction(17480))
    assert body.shape == Shape(fmpq(15170, 1210), fmpq(1100, 17480))
    assert body.realizable
    assert body.shape.realizable
    assert eval(repr(body), {"Body": Body}) == body
    assert hash(body) == hash(Body("1210", "16380", "17480"))
    with pytest.raises(AttributeError):
        body.I1 = fmpq(1)


@pytest.mark.parametrize(
    ("name", "a", "b", "realizable"),
    [
        ("str", Fraction(16380, 1210) - 1, 1 - Fraction(16380, 17480), True),
        ("t2000-printed", Fraction("12.5372"), Fraction("0.0629"), True),
        ("racket-1", Fraction(16336, 886) - 1, 1 - Fraction(16336, 18270), False),
        ("racket-2", Fraction(14445, 1319) - 1, 1 - Fraction(14445, 16175), False),
        ("racket-3", Fraction("14.88"), Fraction("0.12"), False),
        ("book", Fraction("1.11"), Fraction("0.31"), True),
        ("ethylene", Fraction("4.64") / Fraction("1.001") - 1,
         1 - Fraction("0.828") / Fraction("1.001"), True),
    ],
)  # fmt: skip
def test_named_bodies_use_exactly_the_printed_data(
    name: str, a: Fraction, b: Fraction, realizable: bool
) -> None:
    found = named_body(name).shape
    assert found == Shape(fmpq(a.numerator, a.denominator), fmpq(b.numerator, b.denominator))
    assert found.realizable is realizable
    assert len(NAMED_BODIES) == 7


@given(st.tuples(positive, positive, positive).map(sorted))
def test_realizable_means_the_triangle_inequality(moments: list[Fraction]) -> None:
    if len(set(moments)) < 3:
        return
    body = Body(*moments)
    assert body.realizable == (moments[2] <= moments[0] + moments[1])
    assert body.shape.realizable == body.realizable


BAD_MOMENTS = [
    (("-1", "2", "3"), "moment I1: must be positive"),
    (("0", "2", "3"), "moment I1: must be positive"),
    (("nan", "2", "3"), "is not a number"),
    (("1", "2", "inf"), "is not a number"),
    (("3", "2", "1"), "expected order is I1 < I2 < I3 (smallest first); here I3 < I2 < I1"),
    (("448", "7126", "1818"), "here I1 < I3 < I2"),
    (("1", "1", "2"), "symmetric top"),
    (("1", "2", "2"), "symmetric top"),
    (("2", "2", "1"), "here I3 < I1 = I2"),
]


@pytest.mark.parametrize(("moments", "says"), BAD_MOMENTS)
def test_bad_moments_are_refused(moments: tuple[str, str, str], says: str) -> None:
    with pytest.raises(InputError) as caught:
        Body(*moments)
    assert says in str(caught.value)


BAD_SHAPES = [
    ("-1", "0.5", "a: must be positive"),
    ("0", "0.5", "a: 0 is a symmetric top"),
    ("1", "0", "no isolated root, the defect tends to pi/2"),
    ("1", "-0.1", "b: must be in (0, 1]"),
    ("1", "1.0001", "b: must be in (0, 1]"),
    ("", "1", "is not a number"),
]


@pytest.mark.parametrize(("a", "b", "says"), BAD_SHAPES)
def test_bad_shapes_are_refused(a: str, b: str, says: str) -> None:
    with pytest.raises(InputError) as caught:
        flip_defect(a, b)
    assert says in str(caught.value)


@pytest.mark.parametrize("digits", [0, -5, 10**9, 10_001, True, 2.5, "50"])
def test_bad_digits_are_refused(digits: int) -> None:
    with pytest.raises(InputError, match="integer from 1 to 10000"):
        flip_defect("1", "0.5", digits=digits)


def test_unknown_names_are_refused_with_the_nearest_known() -> None:
    with pytest.raises(InputError, match="did you mean ethylene"):
        named_body("etylene")
    with pytest.raises(InputError, match="model: 'magic' is not known"):
        flip_defect("1", "0.5", model="magic")


@pytest.mark.parametrize("digits", [10, 16, 28, 30, 50, 52, 100, 400])
def test_the_first_pass_has_the_digits(digits: int, monkeypatch: pytest.MonkeyPatch) -> None:
    passes: list[int] = []
    enclose = solver.enclose_phase

    def counted(k: arb, r: arb, precision: int) -> arb:
        passes.append(precision)
        return enclose(k, r, precision)

    monkeypatch.setattr(solver, "enclose_phase", counted)
    for s in SHAPES:
        solver.solve(*s, digits)
    assert len(passes) == len(SHAPES)
