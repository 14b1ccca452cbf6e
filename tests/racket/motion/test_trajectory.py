"""Any start: the singular cases, relative accuracy, laws of the flow, independent integration."""

import json
from fractions import Fraction

import mpmath
import pytest
from flint import arb, fmpq
from hypothesis import example, given
from hypothesis import strategies as st

import tresym
from tresym.commands import main
from tresym.racket.angle import Angle, parse_angle
from tresym.racket.body import Shape, named_body
from tresym.racket.flip import flip_angle, flip_defect
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits, mp_precision
from tresym.reals.numbers.exact import InputError

STR = named_body("str").shape


def right(x: arb, digits: int) -> bool:
    return bool(x.is_zero() or x.rel_accuracy_bits() >= bits(digits, 0))


# Angles


def test_the_angle_of_a_point_is_of_balls():
    with ball_precision(100):
        assert balls.atan2(arb(1), arb(-1)).overlaps(3 * arb.pi() / 4)
        assert balls.atan2(arb(-1), arb(1)).overlaps(-arb.pi() / 4)


@pytest.mark.parametrize(
    ("text", "halves", "radians"),
    [
        ("pi", "1", "0"),
        ("-pi/2", "-1/2", "0"),
        ("-3*pi/4", "-3/4", "0"),
        ("0.25*pi", "1/4", "0"),
        (" 2/3 * pi ", "2/3", "0"),
        ("0.1", "0", "1/10"),
        ("1e-12", "0", "1/1000000000000"),
        ("pi/1e3", "1/1000", "0"),
    ],
)
def test_angles_are_read_exactly(text, halves, radians):
    read = parse_angle(text)
    assert str(read.halves) == halves
    assert str(read.radians) == radians
    assert parse_angle(str(read)) == read


@pytest.mark.parametrize(
    "text", ["", "pi/0", "2pi", "pi*2", "*pi", "pi pi", "tau", "nan", "π", "pi/2/3", "1" * 10_001]
)
def test_what_is_no_angle_is_refused_in_one_line(text):
    with pytest.raises(InputError) as caught:
        parse_angle(text)
    assert "\n" not in str(caught.value)


def test_sines_of_multiples_of_pi_are_exact_where_rational():
    for text, square in (("pi/6", "1/4"), ("-7*pi/4", "1/2"), ("5*pi/2", "1"), ("9*pi", "0")):
        assert str(parse_angle(text).rational_square()) == square
        sine, _ = parse_angle(text).sin_cos()
        assert (sine * sine).overlaps(arb(parse_angle(text).rational_square()))
    assert parse_angle("pi/5").rational_square() is None
    assert parse_angle("0.5").rational_square() is None


# Singular cases: each has a start that a formula divided by 0 for


@pytest.mark.parametrize(
    ("psi0", "rate"),
    [("0", "0"), ("pi", "0"), ("pi/2", "0"), ("-pi/2", "0"), ("-7*pi/2", "0"), ("100*pi", "0")],
)
def test_equilibria_stay(psi0, rate):
    answer = flip_angle(*STR, psi0, rate)
    assert answer.turn.is_zero()
    assert isinstance(answer.gamma, fmpq)


def test_starts_at_multiples_of_a_quarter_turn_are_one_motion():
    """Where float prototypes gave nan (ψ₀ = ±π/2) or were off by π (ψ₀ = 0, negative rate)."""
    forth, back = flip_angle(*STR, 0, "0.5"), flip_angle(*STR, 0, "-0.5")
    assert forth.turn.overlaps(-back.turn)
    assert forth.turn.overlaps(arb("4.775939189758932786650724", "1e-23"))
    for psi0 in ("pi", "-pi", "4*pi"):
        assert flip_angle(*STR, psi0, "-1/2").turn.overlaps(back.turn)
    up, down = flip_angle(*STR, "pi/2", 3), flip_angle(*STR, "-pi/2", -3)
    assert up.turn.overlaps(-down.turn)
    assert right(up.turn, 50)


@pytest.mark.parametrize("psi0", ["1e-12", "1e-100", "1e-300"])
def test_a_tiny_offset_keeps_relative_accuracy(psi0):
    """Linear motion: Δψ/ψ₀ = cosh(2π√(ab)) − 1 up to O(ψ₀²)."""
    answer = flip_angle(*STR, psi0, 0, 30)
    assert right(answer.turn, 30)
    with ball_precision(1200):
        growth = (2 * arb.pi() * arb(STR.a * STR.b).sqrt()).cosh() - 1
        ratio = answer.turn / arb(Fraction(psi0).numerator) * Fraction(psi0).denominator / growth
        assert abs(ratio - 1) < 1e-19


def test_a_start_on_the_separatrix_itself():
    """a = 3, b = 1/5: √(b(a+b))/(1−b) = 1, so ψ₀ = π/2 with rate 1 has γ = 0 exactly."""
    answer = flip_angle(3, "1/5", "pi/2", 1)
    assert answer.gamma == 0
    half = flip_angle(3, "1/5", "pi/2", 1, precession="pi")
    with ball_precision(200):
        defect = flip_defect(3, "1/5", digits=55).defect
        assert (arb.pi() / 2 - half.turn).overlaps(defect)
        assert answer.turn < arb.pi() / 2
    back = flip_angle(3, "1/5", "pi/2", 1, precession="-pi")
    assert back.turn.overlaps(-half.turn)


def test_the_poles():
    """γ = a, θ = 0 or π: ψ goes on by dψ/dφ = ±(a + b sin²ψ)/(1 − b sin²ψ)."""
    for psi0, theta0 in (("0", "0"), ("pi/6", "0"), ("1", "0"), ("pi/3", "pi")):
        answer = flip_angle(*STR, psi0, theta0=theta0)
        assert right(answer.turn, 50)
        assert (answer.turn > 0) is (theta0 == "0")
    fastest = flip_angle(*STR, 0, STR.a)
    assert fastest.gamma == STR.a
    assert fastest.turn.overlaps(flip_angle(*STR, 0, theta0=0).turn)
    quarter = (STR.a + STR.b) / (1 - STR.b)
    assert flip_angle(*STR, "pi/2", quarter).gamma == STR.a
    with pytest.raises(InputError, match="no body of this shape has it"):
        flip_angle(*STR, 0, STR.a + fmpq(1, 10**300))
    near = flip_angle(*STR, 0, STR.a - fmpq(1, 10**300), 20)
    assert right(near.turn, 20)


@pytest.mark.parametrize(
    ("a", "b"),
    [("1e-9", "1"), ("1e-9", "1e-12"), ("1e6", "1"), ("1e6", "1e-12"), ("3", "1"), ("2", "1/4")],
)
@pytest.mark.parametrize("rate", ["0", "1e-10", "-1e-10", "1e-300"])
def test_extreme_shapes(a, b, rate):
    for psi0 in ("0.1", "pi/4", "-2", "1e-12"):
        answer = flip_angle(a, b, psi0, rate, 20)
        assert right(answer.turn, 20)
        assert answer.turn.overlaps(flip_angle(a, b, psi0, rate, 40).turn)


def test_where_the_precession_stands_still():
    """b = 1, θ = ψ = π/2: dφ/dτ = 0. At rest it is the limit b → 1; with a rate there is none."""
    assert flip_angle(3, 1, "pi/2", 0).turn.is_zero()
    with pytest.raises(InputError, match="the precession stands still"):
        flip_angle(3, 1, "pi/2", 1)
    assert right(flip_angle(3, 1, "pi/2", theta0=1).turn, 50)


@pytest.mark.parametrize("theta0", ["-1", "4", "-pi/2", "3*pi/2"])
def test_theta_is_an_angle_from_the_axis(theta0):
    with pytest.raises(InputError, match=r"theta0: must be in \[0, pi\]"):
        flip_angle(*STR, "0.1", theta0=theta0)


def test_a_start_within_1e_295_of_the_separatrix():
    with ball_precision(2000):
        square = arb.sin_pi_fmpq(fmpq(1, 5)) ** 2
        a, b = arb(STR.a), arb(STR.b)
        rate = (b * square * (a + b * square)).sqrt() / (1 - b * square)
        digits = rate.str(300, radius=False)
    answer = flip_angle(*STR, "pi/5", digits, 20)
    assert right(answer.turn, 20)
    assert abs(answer.gamma) < 1e-295


# Laws

rates = st.fractions(-2, 2)
angles = st.fractions(-4, 4)


@pytest.mark.slow
@given(angles, rates)
@example(Fraction(0), Fraction(-1, 2))
@example(Fraction(1, 10**12), Fraction(0))
def test_laws_of_the_flow(psi0, rate):
    forth = flip_angle("12.5", "0.06", psi0, rate, 25)
    mirror = flip_angle("12.5", "0.06", -psi0, -rate, 25)
    assert mirror.turn.overlaps(-forth.turn)
    # Time reversal: (ψ, dψ/dφ) → (−ψ, …) read backwards.
    reverse = flip_angle("12.5", "0.06", -psi0, rate, 25, precession="-2*pi")
    assert reverse.turn.overlaps(-forth.turn)
    # γ is conserved: computed from where it arrives.
    with ball_precision(200):
        a, b = arb(fmpq(25, 2)), arb(fmpq(3, 50))
        gamma = a - forth.theta.sin() ** 2 * (a + b * forth.psi.sin() ** 2)
        known = forth.gamma if isinstance(forth.gamma, arb) else arb(forth.gamma)
        assert abs(gamma - known) < 1e-23


@pytest.mark.parametrize(
    ("psi0", "rate"), [("0.3", "0"), ("-1", "0.4"), ("2", "-3"), ("pi/2", "1")]
)
def test_two_half_turns_are_one_turn(psi0, rate):
    """flow(π) ∘ flow(π) = flow(2π): the middle state is rounded, to 60 digits."""
    whole = flip_angle(*STR, psi0, rate, 30)
    half = flip_angle(*STR, psi0, rate, 60, precession="pi")
    with ball_precision(260):
        middle = parse_angle(half.psi.str(60, radius=False))
        theta = parse_angle(half.theta.str(60, radius=False))
    rest = flip_angle(*STR, middle, theta0=theta, digits=30, precession="pi")
    with ball_precision(260):
        assert abs(half.turn + rest.turn - whole.turn) < 1e-27


def taylor(shape: Shape, psi0: str, rate: str) -> mpmath.mpf:
    """Δψ by mpmath's ODE solver on (ψ, cos θ): no elliptic function anywhere."""
    with mp_precision(34) as mp:
        a, b = (mp.mpf(int(x.p)) / int(x.q) for x in shape)
        start, speed = mp.mpf(psi0), mp.mpf(rate)

        def system(_, y):
            s, c = mp.sin(y[0]), mp.cos(y[0])
            clock = 1 - b * s * s
            return [(a + b * s * s) * y[1] / clock, b * (1 - y[1] ** 2) * s * c / clock]

        square = mp.sin(start) ** 2
        state = [start, speed * (1 - b * square) / (a + b * square)]
        return mp.odefun(system, 0, state, tol=mp.mpf(10) ** -28)(2 * mp.pi)[0] - start


@pytest.mark.slow
@pytest.mark.parametrize(
    ("psi0", "rate"),
    [("0.3", "-0.2"), pytest.param("1.57", "0.1", marks=pytest.mark.night)],
)
def test_an_ode_solver_agrees(psi0, rate):
    shape = named_body("book").shape
    ball = flip_angle(*shape, psi0, rate, 30).turn
    with ball_precision(160):
        value = arb(mpmath.nstr(taylor(shape, psi0, rate), 30))
        assert abs(ball - value) < 1e-24
        assert not abs(ball - value * (1 + arb("1e-20"))) < 1e-24


def test_higher_precision_lies_inside_lower():
    few, many = (flip_angle(*STR, "0.3", "-0.2", n) for n in (15, 200))
    with ball_precision(bits(220)):
        assert few.turn.contains(many.turn)
        assert few.psi.contains(many.psi)
        assert few.theta.contains(many.theta)


# The border


def test_json_of_a_start(capsys):
    words = [
        "flip",
        "--body",
        "str",
        "--psi0",
        "-pi/2",
        "--rate",
        "-1e-1",
        "--digits",
        "20",
        "--json",
    ]
    assert main(words) == 0
    answer = json.loads(capsys.readouterr().out)
    assert answer["defect"] is None
    assert answer["rung"] == "planar"
    assert answer["gamma"] == str(flip_angle(*STR, "pi/2", "1/10").gamma)
    assert set(answer["flip"]) == set(answer["theta"]) == {"mid", "rad"}
    assert main(["flip", "--body", "str", "--json"]) == 0
    assert set(json.loads(capsys.readouterr().out)) == set(answer)


@pytest.mark.parametrize(
    ("words", "says"),
    [
        (["--gamma", "99"], "gamma: must be between -b and a"),
        (["--gamma", ""], "gamma: '' is not a number"),
        (["--gamma", "0", "--psi0", "1"], "not allowed with"),
        (["--rate", "1"], "need --psi0"),
        (["--psi0", "1"], "either a rate or theta0"),
        (["--psi0", "1", "--rate", "1", "--theta0", "1"], "not allowed with"),
        (["--psi0", "1", "--rate", "100"], "no body of this shape has it"),
        (["--psi0", "x", "--rate", "1"], "an angle may also be pi/2"),
        (["--psi0", "1", "--rate", "1", "--rung", "carlson"], "for a start use planar"),
        (["--psi0", "1", "--rate", "1", "--precession", "often"], "precession:"),
    ],
)
def test_bad_starts_are_refused(words, says, capsys):
    assert main(["flip", "--body", "str", *words]) == 2
    assert says in capsys.readouterr().err


def test_text_of_a_start(capsys):
    assert main(["flip", "--body", "str", "--psi0", "0.1", "--theta0", "pi/2"]) == 0
    text = capsys.readouterr().out
    for part in ("flip", "ends at", "planar", "realizable"):
        assert part in text


def test_from_python():
    assert tresym.flip_angle(3, "1/5", "pi/2", 1).gamma == 0
    for bad in ({}, {"rate": 1, "theta0": 1}):
        with pytest.raises(InputError, match="either a rate or theta0"):
            flip_angle(*STR, 1, **bad)
    with pytest.raises(InputError, match="not exact"):
        flip_angle(*STR, 0.5, 1)
    assert flip_angle(*STR, Angle(fmpq(1, 2), fmpq(0)), 0).turn.is_zero()
    assert flip_angle(*STR, 1, 1, precession=0).turn.is_zero()
