"""Definite integrals: values that are proved, bounds, and what each guard keeps out."""

import pytest

import tresym
from tresym.reals.decisions import antiderivatives, integrals
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

PROVED = [
    "integral(x, x, 0, 1) == 1/2",
    "integral(x, x, 1, 0) == -1/2",
    "integral(x, x, a, b) == (b**2 - a**2)/2",
    "integral(1/x, x, a, b) == log(b/a) given a > 0, b > 0",
    "integral(1/x, x, -2, -1) == -log(2)",
    "integral(x*y, x, 0, y) == y**3/2",
    "integral(x, x, 0, x) == x**2/2",
    "integral(integral(x*y, x, 0, y), y, 0, 1) == 1/8",
    "integral(exp(-a*x), x, 0, oo) == 1/a given a > 0",
    "integral(1/(1 + x**2), x, -oo, oo) == pi",
    "integral(log(x), x, 0, 1) == -1",
    "integral(1/sqrt(x), x, 0, 1) == 2",
    "integral(1/(x**2 - 1), x, 2, oo) == log(3)/2",
    "integral(abs(x**2 - x), x, -1, 2) == 11/6",
    "integral(abs(x), x, -1, 1) == 1",
    "integral(abs(sin(x)), x, 0, 2*pi) == 4",
    "integral(1/sqrt(abs(x)), x, -1, 1) == 4",
    "integral(abs(cos(x)), x, 0, 2*pi) == 4",
    "integral(sign(cos(x)), x, 0, pi) == 0",
    "integral(sqrt(1 - sin(x)**2), x, 0, pi) == 2",
    "integral(sqrt(1 - cos(x)), x, 0, 2*pi) == 4*sqrt(2)",
    "integral(sqrt(1 + sin(x)), x, 0, 2*pi) == 4*sqrt(2)",
    "integral(sqrt((x - 1)**2), x, 0, 2) == 1",
    "integral(sin(m*x)*cos(n*x), x, -pi, pi) == 0",
    "integral(x**3*exp(-x**4)*cos(x), x, -a, a) == 0",
    "integral(1/x, x, 1, oo) == oo",
    "integral(sin(n*x), x, 0, pi) == (1 - cos(n*pi))/n given n > 0",
    "1 + integral(2*x, x, 0, a) >= 1",
    "integral(exp(a*x), x, 0, 1) == (exp(a) - 1)/a",  # a is not 0 where there is a right side
]
REFUTED = [
    "integral(sqrt(1 - sin(x)**2), x, 0, pi) == 0",  # sin(pi) - sin(0), without the turn at pi/2
    "integral(sqrt((x - 1)**2), x, 0, 2) == 0",
    "integral(x, x, 0, 1) == 1/3",
    "integral(sin(x)*exp(x**4), x, -1, 2) == 0",  # odd, but about another point
    "integral(cos(x)*exp(x**4), x, -1, 1) == 0",  # even
    "integral(exp(-a*x), x, 0, oo) == 2/a given a > 0",
    "integral(1/x, x, 0, 1) == 5",  # it diverges
    "integral(1/x**2, x, -1, 1) == -2",  # F(1) - F(-1), across a pole
    "integral(1/(2 + cos(x)), x, 0, 2*pi) == 0",  # F(2 pi) - F(0), across a jump of F
    "integral(sign(x), x, -1, 2) == 2",
    "integral(exp(-x**2), x, 0, 1) > 3/4",
    "integral(1/x, x, 1, oo) == -oo",
    "integral(1/x, x, -1, 1) == 0",  # no value
    "integral(tan(x), x, 0, pi) == 0",
    "integral(x, x, -oo, oo) == 0",  # odd, and no value
    "integral(cos(x), x, 0, oo) == 0",  # no limit at oo
    "integral(1/(x**2 - 1), x, 0, 2) == -log(3)/2",
    "integral(x**a, x, 0, 1) == 5 given a < -1",
    "integral(exp(-a*x), x, 0, oo) == 1/a",  # not of a < 0
    "integral(sin(a*x)/x, x, 0, oo) == pi/2",
]
OPEN = [
    "integral(sqrt(sin(x)**2 + 0*sqrt(x - 1)), x, 0, 2) == 1 - cos(2)",  # not real below 1
    "integral(tan(x)*exp(x**4), x, -2, 2) == 0",  # odd, with a pole
    "integral(sin(x)*exp(x**4) + 10**(-40), x, -1, 1) == 0",
    "integral(sqrt(x), x, -1, 1) == 2/3",  # not real on the way
    "integral(1/x, x, a, b) == log(b/a)",
    "integral(1/x, x, 0, 1) == 1/0",  # infinite, but the other side has no value
    "integral(f(x), x, 0, 1) == 1",
    "integral(x, x, 0, 1) == 1/2 given a > 1, a < 0",
]


@pytest.mark.parametrize("claim", PROVED)
def test_an_integral_with_an_antiderivative(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", REFUTED)
def test_a_false_value_is_refuted(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


@pytest.mark.parametrize("claim", OPEN)
@pytest.mark.slow
def test_what_has_no_value_that_is_shown(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


def test_a_bound_without_an_antiderivative_is_enclosed() -> None:
    assert tresym.check("integral(exp(-x**2), x, 0, 1) < 3/4").verdict is Verdict.ENCLOSED


@pytest.mark.parametrize(
    ("f", "function", "low", "high"),
    [
        ("1/(2 + cos(x))", "2*sqrt(3)*atan(sqrt(3)*tan(x/2)/3)/3", "0", "2*pi"),  # it jumps
        ("1/x**2", "-1/x", "-1", "1"),
        ("2*x", "x**2 + x", "0", "1"),
        ("sign(x)", "abs(x)", "-1", "1"),  # no derivative at 0
        ("1/(1 + x**2)", "atan((1 + x)/(1 - x))", "0", "2"),
        ("0*sqrt(-x)", "0*x", "0", "1"),
        ("0*x", "sign(x)", "-1", "1"),
        ("1/x", "log(abs(x))", "-1", "1"),
        ("x", "x**2/2 + 0*log(x - 1)", "0", "1"),
    ],
)
def test_what_is_no_antiderivative_between_the_ends(
    f: str, function: str, low: str, high: str
) -> None:
    ends = [integrals.INFINITY if e == "oo" else parse(e) for e in (low, high)]
    found = integrals._difference("x", parse(f), parse(function), ends[0], ends[1], Given())
    assert found is None


def test_a_wrong_suggestion_proves_nothing(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(antiderivatives, "suggested", lambda *_: [parse("x"), parse("-1/x")])
    for claim in ("integral(x + 1, x, 0, 1) == 3/2", "integral(1/x**2, x, -1, 1) == -2"):
        assert tresym.check(claim).verdict is not Verdict.PROVED


def test_an_antiderivative_may_be_written_in_the_claim(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(antiderivatives, "suggested", lambda *_: [])
    for function, verdict in (("x**2/2", Verdict.PROVED), ("x**3/2", Verdict.UNDECIDED)):
        value = f"at({function}, x, 1) - at({function}, x, 0)"
        assert tresym.check(f"integral(x, x, 0, 1) == {value}").verdict is verdict
    assert tresym.check("integral(x, x, 0, 1) == at(x, x, 1)").verdict is Verdict.REFUTED


def test_either_order_of_the_ends_is_looked_at(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(integrals, "_by_quadrature", lambda *_: None)
    claim = "integral(abs(x - a), x, a, b) == (b - a)**2/2"  # for b < a it is less than 0
    assert tresym.check(claim).verdict is not Verdict.PROVED
    assert tresym.check(f"{claim} given a < b").verdict is Verdict.PROVED


@pytest.mark.parametrize(
    "claim",
    [
        "integral(1/x, x, 0, 1) != integral(1/x**2, x, 0, 1)",  # both are infinite
        "integral(abs(x), x, -1, b) == b**2/2 - 1/2 given b > 0",
    ],
)
def test_what_is_infinite_or_ends_at_a_parameter_is_compared_with_care(claim: str) -> None:
    assert not tresym.check(claim)


@pytest.mark.parametrize(
    "claim",
    [
        "limit(1/b*integral(cos(w*t), t, 0, b), b, 0) == 1",  # true: b is no parameter to put in
        "integral(sum(sin(n*t)/n**3, n, 1, oo)*cos(t), t, -1, 1) == 0",
        "integral(sum(x**k, k, 0, oo), x, 0, 1/2) == 0",
        "x/(x + 1)**2 == x*sum((-1)**k*x**k, k, 0, oo)**2",
    ],
)
def test_what_binds_a_variable_inside_is_not_entered(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is not Verdict.REFUTED
    assert "internal error" not in answer.why
