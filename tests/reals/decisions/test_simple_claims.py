"""Simple claims of many kinds with their truth; each guard has a false claim beside a true one."""

import pytest

import tresym
from tresym.checking import dispatch
from tresym.reals.decisions import equations
from tresym.reals.verdict import Verdict

TRUE = (
    *("a == b given a**2 + b**2 == 2*a*b", "x == 1 given x**3 - 3*x**2 + 3*x - 1 == 0"),
    *("(x*y - 1)**2 + x**2 > 0", "(x*y - 1)**2 + abs(x) > 0", "x > -1 given x/x == 1, x > 0"),
    *("atan2(y, x) > -pi", "atan2(y, x) <= pi", "-atan2(y, x) < pi", "atan2(y, x) > -4"),
    *("1/n <= 1 given n integer", "2**n >= n**3 given n integer, n >= 10"),
    *("x**n -> 0 as n -> oo given 0 <= x, x < 1", "abs(exp(x) - 1) <= exp(abs(x)) - 1"),
    "a/(b + c) + b/(c + a) + c/(a + b) < 2 given a + b > c, b + c > a, c + a > b",
    "integral(1/(x**2 + a**2), x, 0, oo) == pi/(2*abs(a))",
    "a*integral(exp(a*x), x, 0, 1) == exp(a) - 1",
    "integral(1/x, x, 1, oo) > 100",
    "cos(pi*n)**2 -> 1 as n -> oo given n integer",
    "log(log(log(x)))**10/log(log(x)) -> 0 as x -> oo",
    "log(log(log(x)))**10 < log(log(x)) as x -> oo",
    "log(x)**2*exp(sqrt(log(x))*log(log(x))**2*exp(sqrt(log(log(x)))*log(log(log(x)))**3))/sqrt(x)"
    " -> 0 as x -> oo",
    "sin(x) ~ x - x**3/6 as x -> 0",
    "log(x + a) ~ log(x) + a/x as x -> oo given a > 0",
)
FALSE = (
    *("(x*y - 1)**2 + (x - 1)**2 > 0", "x == 2 given x**3 - 3*x**2 + 3*x - 1 == 0"),
    *("atan2(y, x) < pi", "1/n < 1 given n integer", "2**n >= n**3 given n integer, n >= 9"),
    *("(n - 30)*(n - 31) > 0 given n integer", "(-1)**n*(n - 37) != 0 given n integer"),
    *("cos(pi*n) -> 1 as n -> oo given n integer", "abs(x**3 - x) <= x**2/10 given abs(x) <= 1"),
    *("n + (-1)**n ~ n + n/100 as n -> oo given n integer", "sign(x**2 - 2)**2 == 1"),
    *("exp(-n*(x**2 + y**2)) -> 0 as n -> oo", "x**n -> 0 as n -> oo given 0 <= x, x <= 1"),
    "a/(b + c) + b/(c + a) + c/(a + b) < 8/5 given a + b > c, b + c > a, c + a > b",
    "integral(cos(n*x)**2, x, 0, pi) == pi/2 given n integer",
    "integral(1/x, x, 1, oo) < 100",
    "integral(exp(x)/x, x, 0, 1) == 2",
    "sum(k**2, k, 1, n) <= 40*n given n >= 1",
    "sin(x) ~ x - x**3/4 as x -> 0",
    "x**2 + x + 1 ~ x**2 + 5*x as x -> oo",
)


@pytest.mark.parametrize("claim", TRUE)
@pytest.mark.slow
def test_it_holds(claim: str) -> None:
    assert tresym.check(claim)


@pytest.mark.parametrize("claim", FALSE)
def test_it_is_refuted(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


@pytest.mark.parametrize(
    "claim", ["sin(x) ~ x - x**3/4 as x -> 0", "cosh(t) ~ 1 + 5*t**2 as t -> 0"]
)
def test_without_its_terms_an_expansion_would_hold(
    claim: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(dispatch, "_asserted", lambda claim, _: [claim])
    assert tresym.check(claim)


def test_what_is_solved_by_an_identity_keeps_its_domain() -> None:
    """``x/x == 1`` excludes 0, and nothing else."""
    assert not tresym.check("x != 0 given x == x")
    assert tresym.check("x != 0 given x/x == 1")
    assert equations.NO_POINT.why not in tresym.check("x > 3 given x/x == 1").why
