"""Order claims by growth: scales whose order is known, and planted falsehoods."""

import pytest
from flint import arb, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

import tresym
from tresym.reals.balls.germ import Germs
from tresym.reals.balls.order import Size
from tresym.reals.decisions.growth import judged_by_growth, sign_near
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.places.values import evaluate
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.slow

ENCLOSED = Verdict.ENCLOSED
REFUTED, UNDECIDED = Verdict.REFUTED, Verdict.UNDECIDED

SCALE = ("exp(x)", "x", "log(x)", "log(log(x))")
"""Every function grows faster than all powers of the next."""
POWERS = st.tuples(
    st.integers(-1, 2), *(st.sampled_from(["0", "1", "-1", "2", "1/2", "-1/3"]) for _ in range(3))
)
BESIDE = st.sampled_from(["1", "(1 + 1/x)", "(2 + sin(x))", "tanh(x)", "(1 + 1/log(x))", "(-3)"])


def _size(powers: tuple[object, ...]) -> tuple[fmpq, ...]:
    return tuple(fmpq(*map(int, str(p).split("/"))) for p in powers)


def _text(powers: tuple[object, ...]) -> str:
    return "*".join(f"{base}**({p})" for base, p in zip(SCALE, powers, strict=True))


FEWER = settings(max_examples=max(20, settings.default.max_examples // 5))
"""An order may take a second."""


@given(POWERS, POWERS, BESIDE, st.sampled_from(["O", "o"]))
@FEWER
def test_products_of_a_scale_compare_like_their_powers(
    left: tuple[object, ...], right: tuple[object, ...], beside: str, kind: str
) -> None:
    """In order of the scale, the first power that differs decides."""
    f, g = _size(left), _size(right)
    truth = f <= g if kind == "O" else f < g
    answer = tresym.check(f"{_text(left)}*{beside} == {kind}({_text(right)})", path="x -> oo")
    assert answer.verdict in (ENCLOSED if truth else REFUTED, UNDECIDED)


@given(POWERS, st.sampled_from(SCALE), st.sampled_from(["O", "o", "~"]))
@FEWER
def test_one_factor_more(powers: tuple[object, ...], more: str, kind: str) -> None:
    """f = o(f h), and f h is not O(f), where h tends to infinity."""
    f = _text(powers)
    assert tresym.check(f"{f} == o({f}*{more})", path="x -> oo").verdict is ENCLOSED
    claim = f"{f}*{more} ~ {f}" if kind == "~" else f"{f}*{more} == {kind}({f})"
    assert tresym.check(claim, path="x -> oo").verdict in (REFUTED, UNDECIDED)


HIDDEN_ZERO = "(abs(x - 1/1000) + (x - 1/1000))"
"""Zero for x ≤ 1/1000, where the limit is."""


@pytest.mark.parametrize("kind", ["O", "o"])
@pytest.mark.parametrize("more", ["log(log(1/x))", "1/x", "exp(1/x)", "exp(exp(1/x))"])
def test_a_factor_that_is_zero_near_the_end_refutes_nothing(kind: str, more: str) -> None:
    claim = f"{HIDDEN_ZERO}*{more} == {kind}({HIDDEN_ZERO})"
    assert tresym.check(claim, path="x -> 0+").verdict in (ENCLOSED, UNDECIDED)


@pytest.mark.parametrize(
    ("claim", "path", "why"),
    [
        ("x*log(x) == O(x)", "x -> 0+", "-1.00000 * log(1/x)^(1) * x^(1)"),
        ("x*log(x) == o(1)", "x -> oo", "1.00000 * log(x)^(1) * x^(1)"),
        ("exp(log(x)**2) == O(x)", "x -> oo", "1.00000 * exp(1.00000 * log(x)^2)"),
        ("x**pi == O(x**4)", "x -> 0+", "1.00000 * x^(3.14159)"),
    ],
)
def test_leading_terms_are_written_with_the_logarithm(claim: str, path: str, why: str) -> None:
    answer = tresym.check(claim, path=path)
    assert answer.verdict is REFUTED
    assert f"the left side is about {why}" in answer.why


def test_the_logarithm_of_a_distance_from_a_half_is_not_one_of_infinity() -> None:
    size = Size(arb(1), fmpq(-1), (arb(0), arb(-2)), logarithmic=True)
    assert size.text("(1/x)") == "1.00000 * log(x)^(1) * x^(-2)"
    assert size.text("(1/2 - x)") == "1.00000 * log(1/(1/2 - x))^(1) * (1/2 - x)^(2)"


@pytest.mark.parametrize("claim", ["0 ~ 0", "sin(x)**2 + cos(x)**2 - 1 ~ 0", "x - x == o(0)"])
def test_zero_is_like_zero(claim: str) -> None:
    """f − g = o(g) holds of two zeros; no answer may call it false."""
    assert tresym.check(claim, path="x -> 0").verdict in (ENCLOSED, UNDECIDED)


@pytest.mark.parametrize("upto", [1, 2, 8])
def test_germs_of_bounded_functions(upto: int) -> None:
    """A function of which only bounds are known: powers, quotients and logarithms keep them."""
    with ball_precision(128):
        m = Germs(fmpq(1, upto))
        wave = m.constant(2) + m.sin(1 / m.x)
        for germ, f in (
            (1 / wave, lambda w: 1 / w),
            (wave**3, lambda w: w**3),
            (m.sqrt(wave), lambda w: w.sqrt()),
            (m.log(wave), lambda w: w.log()),
        ):
            for k in range(1, 9):
                value = f(2 + (1 / arb(fmpq(k, 8 * upto))).sin())
                assert germ.range().contains(value)


def test_deep_towers_end_undecided_and_not_in_an_error() -> None:
    found = judged_by_growth("o", parse("exp(exp(exp(1/t)))"), parse("exp(exp(exp(1/t) + 1))"), "t")
    assert found.verdict in (ENCLOSED, UNDECIDED)


@pytest.mark.parametrize(
    ("claim", "path", "verdict", "region"),
    [
        ("diff(log(x), x) ~ 1/abs(x)", "x -> 0", ENCLOSED, "0 < x <= 1"),  # real on one side
        ("diff(log(-x), x) ~ -1/abs(x)", "x -> 0", ENCLOSED, "0 < -x <= 1"),
        ("diff(log(x), x) ~ -1/abs(x)", "x -> 0", REFUTED, None),
        ("diff(log(x), x) == O(1)", "x -> 0", REFUTED, None),
        ("diff(log(abs(x)), x) ~ 1/abs(x)", "x -> 0", REFUTED, None),  # real on both sides
        ("diff(diff(log(x), x), x) == o(1/abs(x))", "x -> 0", REFUTED, None),
        ("1/abs(x) == diff(log(x), x) + O(1)", "x -> 0", ENCLOSED, "0 < x <= 1"),
        ("1/abs(x) == O(diff(log(x), x))", "x -> 0", ENCLOSED, "0 < x <= 1"),
        ("diff(log(1 - 2*x), x) == O(1)", "x -> 0", ENCLOSED, "0 < |x| <= 1/4"),
        ("diff(sqrt(x**2 - 1), x) ~ 1", "x -> oo", ENCLOSED, "x >= 2"),
        ("diff(atanh(x), x) ~ -1/x**2", "x -> oo", UNDECIDED, None),  # real nowhere on the way
        ("diff(atanh(x), x) == O(x)", "x -> oo", UNDECIDED, None),
        ("diff(atanh(x), x) == o(x**(-2))", "x -> oo", UNDECIDED, None),
        ("diff(log(x), x) ~ 1/x", "x -> 0-", UNDECIDED, None),
        ("diff(x + log(y), x) == O(1)", "x -> 0", UNDECIDED, None),
        ("diff(atanh(3 + sin(1/x)), x) == O(x**(-2))", "x -> 0", UNDECIDED, None),
        ("diff(log(-log(log(x))), x) ~ 1/(x*log(x)*log(log(x)))", "x -> oo", UNDECIDED, None),
        ("diff(log(-1/log(log(log(x)))), x) == O(1)", "x -> oo", UNDECIDED, None),
        ("diff(log(log(log(x))), x) ~ 1/(x*log(x)*log(log(x)))", "x -> oo", ENCLOSED, "x >= 16"),
        ("diff(log(3 + sin(1/x)), x) == O(x**(-2))", "x -> 0+", ENCLOSED, "0 < x <= 1"),
    ],
)
def test_an_order_speaks_of_the_sides_on_which_the_functions_are_real(
    claim: str, path: str, verdict: Verdict, region: str | None
) -> None:
    answer = tresym.check(claim, path=path)
    assert (answer.verdict, answer.region) == (verdict, region)


def test_a_refutation_is_shown_where_the_functions_are_real() -> None:
    answer = tresym.check("sin(1/x) + 0*diff(log(1 - 1000*x), x) == o(1)", path="x -> 0+")
    assert answer.verdict is REFUTED
    assert answer.witness is not None
    assert fmpq(*map(int, answer.witness["x"].split("/"))) < fmpq(1, 1000)


BY_GROWTH = [
    ("exp(x)*(exp(1/x - exp(-x)) - exp(1/x)) == -1 + o(1)", "x -> oo"),
    ("(3**x + 5**x)**(1/x) == 5 + o(1)", "x -> oo"),
    ("x**x == 1 + x*log(x) + O(x**2*log(x)**2)", "x -> 0+"),
    ("atan(sin(x)/x) == pi/4 + o(1)", "x -> 0"),
    ("asin(x) == pi/2 - sqrt(2*(1 - x)) + O((1 - x)**(3/2))", "x -> 1-"),
    ("1 == o(x + exp(-exp(x)))", "x -> oo"),
    ("1/(2 + sin(x)) == O(1)", "x -> oo"),
    ("x*(2 + sin(x)) == O(x)", "x -> oo"),
    ("abs(x - 1/1000) ~ 1/1000 - x", "x -> 0"),
]
NOT_BY_GROWTH = [
    ("exp(x)*(exp(1/x - exp(-x)) - exp(1/x)) == -1 - 1/10**30 + o(1)", "x -> oo"),
    ("(3**x + 5**x)**(1/x) == 3 + o(1)", "x -> oo"),
    ("x**x == 1 + x*log(x) + o(x**2*log(x)**2)", "x -> 0+"),
    ("asin(x) == pi/2 - sqrt(2*(1 - x)) + o((1 - x)**(3/2))", "x -> 1-"),
    ("1 == O(sin(x))", "x -> oo"),
    ("tan(x) == O(x)", "x -> oo"),
    ("x*sin(x) == o(x)", "x -> oo"),
    ("1 == O(sin(x) + exp(-x))", "x -> oo"),
    ("2 + sin(x) ~ 2", "x -> oo"),
    ("sin(x)*cos(3*x) == o(1)", "x -> oo"),
]


@pytest.mark.quick
@pytest.mark.parametrize(("claim", "path"), BY_GROWTH)
def test_what_growth_decides_comes_with_a_range(claim: str, path: str) -> None:
    answer = tresym.check(claim, path=path)
    assert answer.verdict is ENCLOSED
    assert answer.region
    assert ("O(" in claim) == (answer.constant is not None)


@pytest.mark.quick
@pytest.mark.parametrize(("claim", "path"), NOT_BY_GROWTH)
def test_what_differs_a_little_or_at_a_phase_is_refuted(claim: str, path: str) -> None:
    assert tresym.check(claim, path=path).verdict is REFUTED


@pytest.mark.quick
@pytest.mark.parametrize(
    ("claim", "path"),
    [
        ("sin(x)*sin(sqrt(2)*x) == O(sin(x))", "x -> oo"),  # true, and no sine may be divided by
        ("x*sin(x)**2 == O(x*sin(x))", "x -> oo"),
        ("1 == O(1 + cos(x) + sin(x/2)**2)", "x -> oo"),  # true: the phases are not free
        ("log(sin(x)) == O(1)", "x -> oo"),
    ],
)
def test_waves_are_not_divided_by(claim: str, path: str) -> None:
    assert tresym.check(claim, path=path).verdict in (ENCLOSED, UNDECIDED)


@pytest.mark.quick
def test_a_range_ends_where_a_sign_changes() -> None:
    found = judged_by_growth("~", parse("abs(t - 1/100)"), parse("1/100 - t"), "t")
    assert found.verdict is ENCLOSED
    assert found.upto is not None
    assert found.upto < fmpq(1, 100)


@pytest.mark.quick
@pytest.mark.parametrize(
    ("text", "sign"), [("t - 1/100", -1), ("log(1 + t) - t + t**2/2", 1), ("t - t", 0)]
)
def test_the_sign_near_zero_holds_on_its_range(text: str, sign: int) -> None:
    found = sign_near(parse(text), "t")
    assert found is not None
    assert found[0] == sign
    with ball_precision():
        for part in (1, 2, 50):
            value = evaluate(parse(text), {"t": arb(found[1] / part)})
            assert value > 0 if sign > 0 else value < 0 if sign < 0 else value.contains(0)


@pytest.mark.quick
def test_no_sign_is_given_to_a_wave() -> None:
    assert sign_near(parse("t*sin(1/t)"), "t") is None


@pytest.mark.quick
@pytest.mark.parametrize(
    "claim",
    [
        "exp(sqrt(log(x))) == o(x**(1/1000)) as x -> oo",
        "log(x)**1000 == o(exp(sqrt(log(x)))) as x -> oo",
        "log(x)**1000/exp(sqrt(log(x))) -> 0 as x -> oo",
        "sin(x)/log(log(x)) -> 0 as x -> oo",
    ],
)
def test_what_is_slow_is_not_stopped_by_the_advocate(claim: str) -> None:
    assert tresym.check(claim)
