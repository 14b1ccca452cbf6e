"""Series with dots: every coefficient, and how far it converges."""

import pytest

import tresym
from tresym.reals.verdict import Verdict

HOLD = [
    "exp(x) == 1 + x + x**2/2 + x**3/6 + ...",
    "sin(x) == x - x**3/6 + x**5/120 - ...",
    "log(1 + x) == x - x**2/2 + x**3/3 - ... given -1 < x <= 1",
    "tan(x) == x + x**3/3 + 2*x**5/15 + 17*x**7/315 + ... given abs(x) < pi/2",
    "cot(x) == 1/x - x/3 - x**3/45 - 2*x**5/945 - ... given 0 < abs(x), abs(x) < pi",
    "csc(x) == 1/x + x/6 + 7*x**3/360 + ... given 0 < x < pi",
    "sec(x) == 1 + x**2/2 + 5*x**4/24 + 61*x**6/720 + ... given abs(x) < pi/2",
    "x/(exp(x) - 1) == 1 - x/2 + x**2/12 - x**4/720 + ... given abs(x) < 2*pi, x != 0",
    "log(cos(x)) == -x**2/2 - x**4/12 - x**6/45 - ... given abs(x) < pi/2",
    "log(sin(x)/x) == -x**2/6 - x**4/180 - x**6/2835 - ... given 0 < x < pi",
    "log(x) == 2*((x - 1)/(x + 1) + ((x - 1)/(x + 1))**3/3 + ((x - 1)/(x + 1))**5/5 + ...)"
    " given x > 0",
    "log(x) == (x - 1) - (x - 1)**2/2 + (x - 1)**3/3 - ... given 0 < x <= 2",
    "acos(x) == pi/2 - x - x**3/6 - 3*x**5/40 - ... given abs(x) < 1",
    "atan(x) == pi/2 - 1/x + 1/(3*x**3) - 1/(5*x**5) + ... given x >= 1",
    "(1 + x)**a == 1 + a*x + a*(a - 1)/2*x**2 + a*(a - 1)*(a - 2)/6*x**3 + ... given abs(x) < 1",
    "a**x == 1 + x*log(a) + (x*log(a))**2/2 + (x*log(a))**3/6 + ... given a > 0",
    "exp(sin(x)) == 1 + x + x**2/2 - x**4/8 - ...",
    "sqrt(1 + x) == 1 + x/2 - x**2/8 + x**3/16 - ... given abs(x) <= 1",
    "sum(x**n/factorial(n), n, 0, oo) == 1 + x + x**2/2 + x**3/6 + ...",
    "sum((-1)**n*x**(2*n + 1)/(2*n + 1), n, 0, oo) == x - x**3/3 + x**5/5 - ...",
]
FALSE = [
    "exp(x) == 1 + x + x**2/2 + x**3/3 + ...",
    "exp(x) == 1 + x + x**3/6 + ...",
    "exp(x) == 1 - x + x**2/2 - x**3/6 + ...",
    "sin(x) == x + x**3/6 + x**5/120 + ...",
    "sin(x) == x - x**3/6 + x**5/24 - ...",
    "cos(x) == 1 - x**2/2 + x**3/6 - ...",
    "log(1 + x) == x - x**2/2 + x**3/3 + x**4/4 + ... given -1 < x <= 1",
    "log(1 + x) == 1 + x - x**2/2 + ... given -1 < x <= 1",
    "tan(x) == x + x**3/3 + 2*x**5/15 + 16*x**7/315 + ... given abs(x) < pi/2",
    "tan(x) == x - x**3/3 + 2*x**5/15 - ... given abs(x) < pi/2",
    "cot(x) == 1/x + x/3 - x**3/45 - ... given 0 < x < pi",
    "csc(x) == 1/x - x/6 + 7*x**3/360 + ... given 0 < x < pi",
    "x/(exp(x) - 1) == 1 - x/2 + x**2/6 - x**4/720 + ... given abs(x) < 2*pi, x != 0",
    "log(cos(x)) == x**2/2 - x**4/12 - ... given abs(x) < pi/2",
    "log(x) == 3*((x - 1)/(x + 1) + ((x - 1)/(x + 1))**3/3 + ...) given x > 0",
    "log(x) == (x - 1) + (x - 1)**2/2 + (x - 1)**3/3 + ... given 0 < x <= 2",
    "sqrt(1 + x) == 1 + x/2 + x**2/8 + ... given abs(x) < 1",
]
NEVER = [
    "tan(x) == x + x**3/3 + 2*x**5/15 + ... given abs(x) < pi",
    "tan(x) == x + x**3/3 + 2*x**5/15 + ...",
    "log(1 + x) == x - x**2/2 + x**3/3 - ... given -1 < x <= 2",
    "log(1 + x) == x - x**2/2 + x**3/3 - ...",
    "log(1 - x) == -x - x**2/2 - x**3/3 - ... given -1 <= x <= 1",
    "1/(1 - x) == 1 + x + x**2 + ... given abs(x) <= 1",
    "1/(1 - x) == 1 + x + x**2 + ... given x < 1",
    "x/(exp(x) - 1) == 1 - x/2 + x**2/12 - ... given x > 0",
    "cot(x) == 1/x - x/3 - x**3/45 - ... given x != 0",
    "(1 + x)**a == 1 + a*x + a*(a + 1)/2*x**2 + ... given abs(x) < 1",
    "(1 + x)**a == 1 + a*x + a*(a - 1)/2*x**2 + ...",
    "sqrt(x**2) == x + x**3 + ... given abs(x) < 1",
    "sqrt(x**2 + x**4) == x + x**3/2 - x**5/8 + ... given abs(x) < 1",
    "atan(x) == -pi/2 - 1/x + 1/(3*x**3) - ... given x >= 1",
    "exp(x) > 1 + x + ...",
    "sum(x**n/factorial(n), n, 0, oo) == 1 + x + x**2/3 + ...",
    "sum(x**n/factorial(n), n, 1, oo) == 1 + x + x**2/2 + ...",
    "sum(x**n/factorial(n), n, 0, oo) == 1 + x + x**3/6 + ...",
    "sum(x**n/n, n, 0, oo) == x + x**2/2 + ...",
    "x == 1 + y + ...",
    "exp(x) + ... == 1",
    "exp(x) == 1 + x + x**2/2 + ... given x > 1, x < 0",
]


@pytest.mark.parametrize("claim", HOLD)
def test_series_with_dots(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert tresym.check(answer.read_as).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", FALSE)
def test_series_with_dots_that_are_false(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness


@pytest.mark.parametrize("claim", NEVER)
def test_series_with_dots_that_are_not_proved(claim: str) -> None:
    assert not tresym.check(claim)
