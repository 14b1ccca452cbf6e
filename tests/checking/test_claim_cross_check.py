"""The advocate before a user's claim: what is false and called proved is contradicted."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.checking.claim_cross_check import attack
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.numbers.exact import Decimal
from tresym.reals.verdict import Verdict


def against(claim: str, constant: str | None = None, region: str | None = None) -> str | None:
    statement = read(claim)
    ball = None if constant is None else Decimal(constant, "1e-9")
    answer = Answer(Verdict.PROVED, "so it is said", constant=ball, region=region)
    (comparison,) = statement.comparisons
    return attack(comparison, statement, answer)


@pytest.mark.parametrize(
    ("true", "false"),
    [
        ("sqrt(x**2) == abs(x)", "sqrt(x**2) == x"),
        ("sqrt(x**2) == x given x > 0", "sqrt(x**2) == x given x > -1"),
        ("x**2 + 1 > 2*x - 1", "x**2 + 1 > 2*x + 1"),
        ("x**2 + 1 != 0", "x**2 - 1 != 0"),
        ("diff(sin(x), x) == cos(x)", "diff(sin(x), x) == -cos(x)"),
        ("diff(log(x), x) == 1/abs(x)", "diff(log(-x), x) == 1/abs(x)"),
        ("atan(x) + atan(1/x) == pi/2 given x > 0", "atan(x) + atan(1/x) == pi/2"),
        ("sum(k, k, 1, n) == n*(n + 1)/2", "sum(k, k, 1, n) == n**2"),
        ("product(2, k, 1, n) == 2**n", "product(k, k, 1, n) == n"),
        ("integral(x, x, 0, 1) == 1/2", "integral(x, x, 0, 1) == 2"),
        ("integral(a*x, x, 0, 1) == a/2", "integral(a*x, x, 0, 1) == a**2"),
        (
            "integral(x, x, 0, oo) == 1",
            "integral(x, x, 0, 1) > 1",
        ),  # of an end at oo nothing is said
        ("cos(n*pi)**2 == 1 given n integer", "(-1)**n == 1 given n integer"),
        ("sin(n*pi) == 0 given n integer", "sin(n*pi/2) == 0 given n integer"),
    ],
)
def test_a_claim_and_a_false_one(true: str, false: str) -> None:
    assert against(true) is None
    assert "its sides are" in (against(false) or "")


@pytest.mark.parametrize(
    ("claim", "region", "enough", "less"),
    [
        ("2*x + x**2 == O(x) as x -> 0+", "0 < x <= 1", "3", "2.9"),
        ("x - 3 == O(1) as x -> 3", "0 < |x - 3| <= 1/2", "0.5", "0.4"),
        ("x == O(1) as x -> 0-", "0 < -x <= 1", "1", "0.9"),
        ("exp(x) == O(1) as x -> 0", "0 < |x| <= 1", "2.72", "2.71"),
        ("x + 1 == O(x) as x -> oo", "x >= 10", "1.1", "1.09"),
        ("x - 1 == O(x) as x -> -oo", "x <= -10", "1.1", "1.09"),
    ],
)
def test_a_constant_and_one_too_small(claim: str, region: str, enough: str, less: str) -> None:
    assert against(claim, enough, region) is None
    assert "violates the bound" in (against(claim, less, region) or "")


def test_an_order_without_constant_or_region_says_nothing_of_a_point() -> None:
    assert against("2*x == O(x) as x -> 0", constant="1") is None
    assert against("2*x == O(x) as x -> 0", region="0 < x <= 1") is None


def test_points_at_which_a_side_is_not_real_are_left_out() -> None:
    assert against("sqrt(x) == O(1) as x -> 0", "1", "0 < |x| <= 1") is None
    assert against("sqrt(x) == O(1) as x -> 0", "0.9", "0 < |x| <= 1") is not None


@pytest.mark.parametrize(
    ("true", "false"),
    [
        ("sin(x)/x -> 1 as x -> 0", "sin(x)/x -> 2 as x -> 0"),
        ("1/x**2 -> oo as x -> 0", "1/x -> oo as x -> 0"),
        ("a*x -> 0 given a > 0 as x -> 0", "a*x -> 1 given a > 0 as x -> 0"),
        ("1/log(log(x)) -> 0 as x -> oo", "log(x) -> 5 as x -> oo"),
        ("log(x)**100/x -> 0 as x -> oo", "x ~ 2*x as x -> oo"),
        ("exp(-exp(x)) -> 0 as x -> oo", "x -> -oo as x -> oo"),
        ("x**2 == o(sin(x)) as x -> 0", "x == o(sin(x)) as x -> 0"),
        ("x**3 == omega(x) as x -> oo", "x**2 == omega(x**3) as x -> oo"),
        ("exp(-a*x) -> 0 given a > 0 as x -> oo", "exp(-a*x) -> 0 as x -> oo"),
    ],
)
def test_a_limit_and_a_false_one(true: str, false: str) -> None:
    assert against(true) is None
    assert "contradict it" in (against(false) or "")


FALSE_ALONG_PATHS = [
    "sin(x) == O(sin(2*x)) as x -> oo",
    "sin(x) ~ sin(2*x)/2 as x -> oo",
    "sin(x) == O(1 - cos(2*x)) as x -> oo",
    "sin(1/x) == O(sin(2/x)) as x -> 0",
    "sin(x)/sin(2*x)/x -> 0 as x -> oo",
    "sqrt(1 + sin(x)) == O(sin(x)) as x -> oo",
    "sqrt(sin(x) + 1/2) == O(sin(x)) as x -> oo",
    "sin(log(x)) == O(sin(2*log(x))) as x -> oo",
    "sin(n*x) -> 0 as x -> pi/2 given n integer",
    "x**n == O(x**2) as x -> 0+ given n integer, n > 0",
    "x**n -> oo as x -> 0 given n integer, n < 0",
    "exp(-n*x) == O(exp(-2*x)) as x -> oo given n integer, n > 0",
    "(-1)**n -> 1 as n -> oo given n integer",
    "n*cos(n*pi) -> oo as n -> oo given n integer",
    "sin(n) -> 0 as n -> oo given n integer",
    "sin(a*x)/x -> 2 as x -> 0 given a == 3",
    "a*x + b -> 2 as x -> 0 given a + b == 3, a == 2",
    "a*x -> oo as x -> oo given a > -1, b > 0",
    "a*x -> oo as x -> oo given a >= 0",
    "sqrt(x) -> 1 as x -> 0",
    "x*sin(x) > 0 as x -> oo",
    "x*sin(1/x) > 0 as x -> 0",
    "x - 10**6*sin(x**2)*x < x as x -> oo",
    "x**a == O(x) as x -> oo given a > 0",
    "integral(cos(t), t, 0, x)/x -> 2 as x -> 0",
    "x == Theta(x*sin(x)) as x -> oo",
    "x*sin(x) == omega(log(x)) as x -> oo",
    "tan(x) == o(exp(x)) as x -> oo",
]


@pytest.mark.parametrize("claim", FALSE_ALONG_PATHS)
def test_numbers_along_the_path_stop_what_is_false(
    claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Whatever the deciders say."""
    assert tresym.check(claim).verdict in (Verdict.REFUTED, Verdict.UNDECIDED)
    monkeypatch.setattr(dispatch, "_decide", lambda *_: Answer(Verdict.PROVED, "so it is said"))
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


TRUE_ALONG_PATHS = [
    "1/log(log(x)) -> 0 as x -> oo",
    "log(log(x)) == o(log(x)) as x -> oo",
    "x**100 == o(exp(x/1000)) as x -> oo",
    "exp(-exp(x)) -> 0 as x -> oo",
    "2 + sin(log(log(x))) == O(1) as x -> oo",
    "x*(2 + sin(x)) == Theta(x) as x -> oo",
    "sin(2*x) == O(sin(x)) as x -> oo",
    "10**9*x + sin(10**9*x) > 0 as x -> oo",
    "1/(1/10**9 + sin(x)**2) == O(1) as x -> oo",
    "(1 + 1/x)**x -> E as x -> oo",
    "x*(atan(x) - pi/2) -> -1 as x -> oo",
    "a*x -> oo as x -> oo given a > 0, b > 0",
    "(-1)**n/n -> 0 as n -> oo given n integer",
]


@pytest.mark.parametrize("claim", TRUE_ALONG_PATHS)
def test_numbers_along_the_path_do_not_stop_what_is_true(claim: str) -> None:
    assert against(claim) is None


@pytest.mark.parametrize(
    "claim",
    [
        "integral(1/x, x, 0, a) == oo given a >= 0",
        "integral(a/(x**2 + a**2), x, 0, a) == pi/4 given a >= 0",
        "integral(x, x, a, b) == b - a",
        "integral(exp(x), x, 0, a) == a given a == 2",
        "(x**a)**b*y == x**(a*b)*y",
        "((x + y)**a)**b == (x + y)**(a*b)",
        "(x**2)**a == x**(2*a)",
        "x**a >= 0",
        "f(cos(n*pi)) == f(1) given n integer",
        "f(x) == f(x + 1)",
        "diff(f(x), x) == f(x)",
        "x + y == 2 given x - y == 1",
        "x == 2 given x**2 == 3, x > 0",
        "n == 3 given n == 2*m, n integer, m integer",
        "factorial(n) >= n + 1",
        "product(k, k, 1, n) == n*(n + 1)/2",
        "sum(k, k, 1, n) == n*(n + 1)/2 + n - 4 given n >= 1",
        "diff(exp(2*x), x, n) == exp(2*x)",
    ],
)
def test_it_stops_each_family_alone(monkeypatch: pytest.MonkeyPatch, claim: str) -> None:
    monkeypatch.setattr(dispatch, "_decide", lambda *_: Answer(Verdict.PROVED, "so it is said"))
    monkeypatch.setattr(dispatch, "beyond_positive_bases", lambda answer, *_: answer)
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.UNDECIDED
    assert "please report" in answer.why
