"""Order claims by growth: scales whose order is known, and planted falsehoods."""

import pytest
from cases import cases
from flint import arb, ctx, fmpq
from hypothesis import given, settings
from hypothesis import strategies as st

import tresym
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.leading_terms import judge_order, sign_near, sign_towards
from tresym.reals.expansions.scale import T
from tresym.reals.language.expression import Expr, substitute, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.slow

PROVED, ENCLOSED = Verdict.PROVED, Verdict.ENCLOSED
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


def in_t(text: str) -> Expr:
    """An expression in the small parameter."""
    return substitute(parse(text), {"t": symbol(T)})


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
    expected = (PROVED, ENCLOSED) if truth else (REFUTED,)
    assert answer.verdict in (*expected, UNDECIDED)


@given(POWERS, st.sampled_from(SCALE), st.sampled_from(["O", "o", "~"]))
@FEWER
def test_one_factor_more(powers: tuple[object, ...], more: str, kind: str) -> None:
    """f = o(f h), and f h is not O(f), where h tends to infinity."""
    f = _text(powers)
    assert tresym.check(f"{f} == o({f}*{more})", path="x -> oo").verdict is PROVED
    claim = f"{f}*{more} ~ {f}" if kind == "~" else f"{f}*{more} == {kind}({f})"
    assert tresym.check(claim, path="x -> oo").verdict in (REFUTED, UNDECIDED)


def test_deep_towers_end_undecided_and_not_in_an_error() -> None:
    found = judge_order("o", in_t("exp(exp(exp(1/t)))"), in_t("exp(exp(exp(1/t) + 1))"))
    assert found.verdict in (ENCLOSED, UNDECIDED)


@pytest.mark.parametrize(
    ("claim", "path", "verdict", "region"),
    [
        ("diff(log(x), x) ~ 1/abs(x)", "x -> 0", ENCLOSED, "0 < x <= 1/2"),  # real on one side
        ("diff(log(-x), x) ~ -1/abs(x)", "x -> 0", ENCLOSED, "0 < -x <= 1/2"),
        ("diff(log(x), x) ~ -1/abs(x)", "x -> 0", REFUTED, None),
        ("diff(log(x), x) == O(1)", "x -> 0", REFUTED, None),
        ("diff(log(abs(x)), x) ~ 1/abs(x)", "x -> 0", REFUTED, None),  # real on both sides
        ("diff(diff(log(x), x), x) == o(1/abs(x))", "x -> 0", REFUTED, None),
        ("1/abs(x) == diff(log(x), x) + O(1)", "x -> 0", ENCLOSED, "0 < x <= 1/2"),
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


BY_GROWTH = cases(__file__, "BY_GROWTH")


@pytest.mark.quick
@pytest.mark.parametrize(("claim", "path"), BY_GROWTH)
def test_what_growth_decides_comes_with_a_range(claim: str, path: str) -> None:
    answer = tresym.check(claim, path=path)
    assert answer.verdict in (PROVED, ENCLOSED)
    assert answer.region or answer.verdict is PROVED
    assert ("O(" in claim) == (answer.constant is not None)


@pytest.mark.quick
def test_a_range_ends_where_a_sign_changes() -> None:
    found = judge_order("~", in_t("abs(t - 1/100)"), in_t("1/100 - t"))
    assert found.verdict is ENCLOSED
    assert found.upto is not None
    assert found.upto < fmpq(1, 100)


@pytest.mark.quick
@pytest.mark.parametrize(
    ("text", "sign"), [("t - 1/100", -1), ("log(1 + t) - t + t**2/2", 1), ("t - t", 0)]
)
def test_the_sign_near_zero_holds_on_its_range(text: str, sign: int) -> None:
    found = sign_near(in_t(text))
    assert found is not None
    assert found[0] == sign
    with ball_precision():
        for part in (1, 2, 50):
            value = evaluate(parse(text), {"t": arb(found[1] / part)})
            assert value > 0 if sign > 0 else value < 0 if sign < 0 else value.contains(0)


@pytest.mark.quick
def test_no_sign_is_given_to_a_wave() -> None:
    assert sign_near(in_t("t*sin(1/t)")) is None


SIGNS = [
    # (function, point or infinity, sign above or at +oo, sign below or at -oo)
    ("sin(x) - x", "0", -1, 1),
    ("sin(x) - x + x**3/6 - x**5/120", "0", -1, 1),
    ("sqrt(x) - x", "0", 1, None),
    ("cbrt(x) + x**2", "0", 1, -1),
    ("x**(1/6) - 2*x**(1/2)", "0", 1, None),
    ("log(x) + 1/sqrt(x)", "0", 1, None),
    ("x*log(x)", "0", -1, None),
    ("exp(1/x) - 1/x**20", "0", 1, -1),
    ("1/x + 10**6", "0", 1, -1),
    ("1 - x*exp(-1/x**2)", "0", 1, 1),
    ("acos(x)", "1", None, 1),
    ("acos(x) - sqrt(2 - 2*x)", "1", None, 1),
    ("tan(x)", "pi/2", -1, 1),
    ("cos(x) + x - pi/2", "pi/2", 1, -1),
    ("abs(x - 1) - (x - 1)", "1", 0, 1),
    ("sin(x)**2 + cos(x)**2 - 1", "0", 0, 0),
    ("atan(x) - pi/2 + 1/x", "oo", 1, -1),
    ("atan(x) - pi/2 + 1/x - 1/(3*x**3)", "oo", -1, -1),
    ("x - 100*log(x)", "oo", 1, None),
    ("x**5*exp(-x) - 1/x", "oo", -1, -1),
    ("sqrt(x**2 + 1) - x", "oo", 1, 1),
    ("sqrt(x**2 + 1) - x - 1/(2*x)", "oo", -1, 1),
    ("tanh(x) - 1 + 3*exp(-2*x)", "oo", 1, 1),
    ("x - x", "oo", 0, 0),
    ("x**3", "0", 1, -1),
    ("1 - cos(x)", "0", 1, 1),
    ("sin(x) - x", "0", -1, 1),
    ("sin(x) - x + x**3/6", "0", 1, -1),
    ("(x**2 - 2)**2", "sqrt(2)", 1, 1),
    ("x**2 - 2", "sqrt(2)", 1, -1),
    ("sin(x)**3", "pi", -1, 1),
    ("log(x) - x + 1", "1", -1, -1),
    ("exp(x) - 3 - 3*(x - log(3))", "log(3)", 1, 1),
    ("tan(x) - 2", "atan(2)", 1, -1),
    ("x + 5", "0", 1, 1),
    # what oscillates, or is not defined, has no sign
    ("sin(1/x)", "0", None, None),
    ("x*sin(1/x) + x**2", "0", None, None),
    ("sin(x)", "oo", None, None),
    ("1 + sin(x)", "oo", None, None),
    ("sqrt(x)", "0", 1, None),
    ("log(-1 - x**2)", "0", None, None),
    ("x + 2*x*sin(x**2)", "oo", None, None),
]


@pytest.mark.parametrize(("text", "at", "above", "below"), SIGNS)
def test_the_sign_beside_a_point(text: str, at: str, above: int | None, below: int | None) -> None:
    e, point = parse(text), None if at == "oo" else parse(at)
    before = ctx.prec, ctx.cap
    for side, expected in ((1, above), (-1, below)):
        found = sign_towards(e, "x", point, side)
        assert (None if found is None else found[0]) == expected
        if found is None:
            continue
        sign, reach = found
        with ball_precision(3000):
            for k in range(1, 17):
                t = arb(reach * fmpq(k, 16))
                x = side / t if point is None else evaluate(point, {}) + side * t
                value = evaluate(e, {"x": x})
                assert sign * value > 0 or (sign == 0 and value.contains(0))
    assert (ctx.prec, ctx.cap) == before


@pytest.mark.parametrize("gap", ["1/10", "1/100", "1/1000"])
@pytest.mark.parametrize("side", [1, -1])
def test_the_neighbourhood_ends_before_the_next_zero(gap: str, side: int) -> None:
    found = sign_towards(parse(f"x**2*(x - {gap})*(x + {gap})"), "x", parse("0"), side)
    assert found is not None
    assert found[0] == -1
    assert found[1] < fmpq(*map(int, gap.split("/")))


@pytest.mark.parametrize("digits", [5, 9, 20, 60])
def test_a_zero_near_by_is_not_passed_over(digits: int) -> None:
    zero = fmpq(1, 10**digits)
    for text, at in ((f"x - 10**(-{digits})", parse("0")), (f"x - 10**{digits}", None)):
        found = sign_towards(parse(text), "x", at, 1)
        assert found is not None
        assert found[0] == (-1 if at else 1)
        assert found[1] < zero
