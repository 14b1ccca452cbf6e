"""Power series: the equation, the coefficients that it leaves open, and the range are needed."""

from contextlib import suppress

import pytest

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.power_series import decide_power_series
from tresym.reals.verdict import Verdict

HOLD = [
    "exp(x) == sum(x**n/factorial(n), n, 0, oo)",
    "sin(x) == sum((-1)**n*x**(2*n + 1)/factorial(2*n + 1), n, 0, oo)",
    "cosh(x) == sum(x**(2*n)/factorial(2*n), n, 0, oo)",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given -1 < x <= 1",
    "log(1 - x) == -sum(x**n/n, n, 1, oo) given -1 <= x < 1",
    "log((x + 1)/(x - 1)) == 2*sum(1/((2*k + 1)*x**(2*k + 1)), k, 0, oo) given abs(x) > 1",
    "log(x) == 2*sum(((x - 1)/(x + 1))**(2*k + 1)/(2*k + 1), k, 0, oo) given x > 0",
    "log(x) == sum(((x - 1)/x)**k/k, k, 1, oo) given x > 1/2",
    "log(x + a) == log(a) + 2*sum((x/(2*a + x))**(2*k + 1)/(2*k + 1), k, 0, oo)"
    " given a > 0, x > -a",
    "atanh(x) == sum(x**(2*k + 1)/(2*k + 1), k, 0, oo) given -1 < x < 1",
    "atan(x) == sum((-1)**k*x**(2*k + 1)/(2*k + 1), k, 0, oo) given -1 <= x <= 1",
    "atan(x) == pi/2 - sum((-1)**n/((2*n + 1)*x**(2*n + 1)), n, 0, oo) given x >= 1",
    "asin(x) == sum(factorial(2*n)*x**(2*n + 1)/(4**n*factorial(n)**2*(2*n + 1)), n, 0, oo)"
    " given abs(x) <= 1",
    "asin(x)**2 == sum(factorial(n)**2*(2*x)**(2*n)/(2*n**2*factorial(2*n)), n, 1, oo)"
    " given abs(x) <= 1",
    "1/(1 - x) == sum(x**n, n, 0, oo) given abs(x) < 1",
    "x/(1 - x)**2 == sum(n*x**n, n, 0, oo) given abs(x) < 1",
    "sin(x)/x == sum((-1)**n*x**(2*n)/factorial(2*n + 1), n, 0, oo) given x != 0",
    "log(1 + x)/x == sum((-x)**n/(n + 1), n, 0, oo) given -1 < x < 1, x != 0",
    "a**x == sum((x*log(a))**n/factorial(n), n, 0, oo) given a > 0",
    "1/sqrt(1 - 4*x) == sum(factorial(2*n)/factorial(n)**2*x**n, n, 0, oo) given abs(x) < 1/4",
    "coth(x) == 1 + 2*sum(exp(-2*n*x), n, 1, oo) given x > 0",
    "sin(x)*sinh(x) == sum((-1)**n*2**(2*n + 1)*x**(4*n + 2)/factorial(4*n + 2), n, 0, oo)",
    "x*exp(x) == sum(x**n/factorial(n - 1), n, 1, oo)",
]
FALSE = [
    # a wrong sign, a wrong start, a wrong power, a wrong factor
    "exp(x) == sum(x**n/factorial(n), n, 1, oo)",
    "exp(x) == sum((-x)**n/factorial(n), n, 0, oo)",
    "exp(x) == sum(x**n/factorial(n + 1), n, 0, oo)",
    "exp(2*x) == sum(x**n/factorial(n), n, 0, oo)",
    "exp(x) == sum(x**(n + 1)/factorial(n), n, 0, oo)",
    "exp(x) == 1 + sum(x**n/factorial(n), n, 0, oo)",
    "exp(-x) == sum(x**n/factorial(n), n, 0, oo)",
    "sin(x) == sum(x**(2*n + 1)/factorial(2*n + 1), n, 0, oo)",
    "sin(x) == sum((-1)**n*x**(2*n)/factorial(2*n), n, 0, oo)",
    "sin(x) == sum((-1)**n*x**(2*n + 1)/factorial(2*n), n, 0, oo)",
    "sin(x) == sum((-1)**n*x**(2*n + 1)/factorial(2*n + 1), n, 1, oo)",
    "sin(x) == sum((-1)**(n + 1)*x**(2*n + 1)/factorial(2*n + 1), n, 0, oo)",
    "sin(x) == 2*sum((-1)**n*x**(2*n + 1)/factorial(2*n + 1), n, 0, oo)",
    "cos(x) == sum((-1)**n*x**(2*n + 1)/factorial(2*n + 1), n, 0, oo)",
    "cos(x) == sum((-1)**n*x**(2*n)/factorial(2*n), n, 1, oo)",
    "cosh(x) == sum((-1)**n*x**(2*n)/factorial(2*n), n, 0, oo)",
    "cosh(x) == sum(x**(2*n + 1)/factorial(2*n + 1), n, 0, oo)",
    "sinh(x) == sum(x**(2*n + 1)/factorial(2*n - 1), n, 1, oo)",
    "exp(x) + exp(-x) == sum(x**(2*n)/factorial(2*n), n, 0, oo)",
    "log(1 + x) == sum((-1)**n*x**n/n, n, 1, oo) given -1 < x <= 1",
    "log(1 + x) == sum(x**n/n, n, 1, oo) given -1 < x < 1",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 2, oo) given -1 < x <= 1",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n**2, n, 1, oo) given -1 < x <= 1",
    "log(1 + x) == sum((-1)**(n - 1)*x**(n + 1)/n, n, 1, oo) given -1 < x <= 1",
    "log(1 + x**2) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given -1 < x <= 1",
    "log(x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given 0 < x < 1",
    "log(x) == sum(((x - 1)/(x + 1))**(2*k + 1)/(2*k + 1), k, 0, oo) given x > 0",
    "log(x) == 2*sum(((x - 1)/(x + 1))**(2*k)/(2*k + 1), k, 0, oo) given x > 0",
    "log(x) == 2*sum(((x + 1)/(x - 1))**(2*k + 1)/(2*k + 1), k, 0, oo) given x > 1",
    "log((x + 1)/(x - 1)) == 2*sum(1/((2*k + 3)*x**(2*k + 1)), k, 0, oo) given abs(x) > 1",
    "log((x + 1)/(x - 1)) == 2*sum(x**(2*k + 1)/(2*k + 1), k, 0, oo) given abs(x) > 1",
    "atan(x) == sum(x**(2*k + 1)/(2*k + 1), k, 0, oo) given -1 < x < 1",
    "atan(x) == sum((-1)**k*x**(2*k + 1)/(2*k - 1), k, 0, oo) given -1 <= x <= 1",
    "atan(x) == sum((-1)**k*x**(2*k)/(2*k + 1), k, 0, oo) given -1 <= x <= 1",
    "atan(x) == -pi/2 - sum((-1)**n/((2*n + 1)*x**(2*n + 1)), n, 0, oo) given x >= 1",
    "atan(x) == pi/2 + sum((-1)**n/((2*n + 1)*x**(2*n + 1)), n, 0, oo) given x >= 1",
    "atanh(x) == sum((-1)**k*x**(2*k + 1)/(2*k + 1), k, 0, oo) given -1 < x < 1",
    "acos(x) == sum(factorial(2*n)*x**(2*n + 1)/(4**n*factorial(n)**2*(2*n + 1)), n, 0, oo)"
    " given abs(x) <= 1",
    "asin(x) == sum(factorial(2*n)*x**(2*n + 1)/(2**n*factorial(n)**2*(2*n + 1)), n, 0, oo)"
    " given abs(x) <= 1/2",
    "asin(x)**2 == sum(factorial(n)**2*(2*x)**(2*n)/(n**2*factorial(2*n)), n, 1, oo)"
    " given abs(x) <= 1",
    "1/(1 - x) == sum(x**n, n, 1, oo) given abs(x) < 1",
    "1/(1 + x) == sum(x**n, n, 0, oo) given abs(x) < 1",
    "1/(1 - x)**2 == sum(n*x**n, n, 0, oo) given abs(x) < 1",
    "1/(1 - x)**2 == sum((n + 1)*x**(n + 1), n, 0, oo) given abs(x) < 1",
    "1/(1 - x)**3 == sum((n + 1)*(n + 2)*x**n, n, 0, oo) given abs(x) < 1",
    "sqrt(1 - 4*x) == sum(factorial(2*n)/factorial(n)**2*x**n, n, 0, oo) given abs(x) < 1/4",
    "a**x == sum((x*log(a))**n/factorial(n + 1), n, 0, oo) given a > 0",
    "a**x == sum((a*log(x))**n/factorial(n), n, 0, oo) given a > 0, x > 0",
    "coth(x) == 1 + sum(exp(-2*n*x), n, 1, oo) given x > 0",
    "tanh(x) == 1 + 2*sum(exp(-2*n*x), n, 1, oo) given x > 0",
    # a range that is too large: x outside the radius
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given x > -1",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given 0 < x < 3",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given x > 1",
    "log(x) == sum(((x - 1)/x)**k/k, k, 1, oo) given x > 1/4",
    "atan(x) == sum((-1)**k*x**(2*k + 1)/(2*k + 1), k, 0, oo) given abs(x) < 2",
    "atan(x) == sum((-1)**k*x**(2*k + 1)/(2*k + 1), k, 0, oo) given x > 0",
    "1/(1 - x) == sum(x**n, n, 0, oo) given x != 1",
    "1/(1 - x) == sum(x**n, n, 0, oo) given x < 1",
    "1/(1 - x)**2 == sum((n + 1)*x**n, n, 0, oo) given x > 2",
    "1/sqrt(1 - 4*x) == sum(factorial(2*n)/factorial(n)**2*x**n, n, 0, oo) given x < 1/4",
    "coth(x) == 1 + 2*sum(exp(-2*n*x), n, 1, oo) given x != 0",
    # an end of the range at which it diverges
    "1/(1 + x) == sum((-x)**n, n, 0, oo) given -1 < x <= 1",
    "1/(1 + x**2) == sum((-1)**n*x**(2*n), n, 0, oo) given abs(x) <= 1",
    "1/(1 - x) == sum(x**n, n, 0, oo) given -1 <= x < 1",
    "1/(1 + x)**2 == sum((-1)**n*(n + 1)*x**n, n, 0, oo) given -1 < x <= 1",
    # numbers whose series diverges
    "10 == sum(1/k, k, 1, oo)",
    "1/2 == sum((-1)**k, k, 0, oo)",
    "5 == sum(2**k/k**5, k, 1, oo)",
    "5 == sum(factorial(k)/2**k, k, 1, oo)",
]
NEVER = [
    # what is said of a range that it does not have, without a condition or with none that is shown
    "1/(1 - x) == sum(x**n, n, 0, oo)",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo)",
    "log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo) given -1 <= x <= 1",
    "log(1 - x) == -sum(x**n/n, n, 1, oo) given -1 <= x <= 1",
    "atanh(x) == sum(x**(2*k + 1)/(2*k + 1), k, 0, oo) given abs(x) <= 1",
    "atan(x) == sum((-1)**k*x**(2*k + 1)/(2*k + 1), k, 0, oo)",
    "exp(x) == sum(factorial(n)*x**n, n, 0, oo)",
    "exp(x) == sum(x**n/n, n, 0, oo)",  # the first term is none
    "sign(1 - x) + log(1 + x) == 1 + sum((-1)**(n - 1)*x**n/n, n, 1, oo) given -1 < x <= 1",
    "exp(x) == sum(x**n/factorial(n), n, 0, oo) given x > 1, x < 0",
    "exp(x) < sum(x**n/factorial(n), n, 0, oo)",
    # nearer than the balls that refute: the equation fails, or the coefficient that it leaves open
    "exp(x) + x/10**200 == sum(x**n/factorial(n), n, 0, oo)",
    "(1 + 1/10**200)*exp(x) == sum(x**n/factorial(n), n, 0, oo)",
]
NOWHERE_FALSE = [
    # it diverges where the other side is not defined, or where all of its terms are 0
    "log((1 + x)/(1 - x)) == 2*sum(x**(2*k + 1)/(2*k + 1), k, 0, oo) given -3/2 < x < 3/2",
    "log(1 - x) == -sum(x**k/k, k, 1, oo) given x >= -1",
    "0 == sum(0*factorial(k), k, 0, oo)",
    "0*x == sum(0*x**k, k, 0, oo) given -2 < x < 2",
    "0*x == sum(0*x**k, k, 0, oo) given -1 <= x <= 1",
    "log(0) == sum(1/k, k, 1, oo)",
]


@pytest.mark.parametrize("claim", HOLD)
@pytest.mark.slow
def test_series_that_hold(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", FALSE)
def test_series_that_are_false(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


@pytest.mark.parametrize("claim", NEVER)
@pytest.mark.slow
def test_series_that_are_not_proved(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.UNDECIDED, Verdict.REFUTED)


@pytest.mark.parametrize("claim", NOWHERE_FALSE)
def test_what_is_no_witness_refutes_nothing(claim: str) -> None:
    assert tresym.check(claim).verdict is not Verdict.REFUTED


def test_the_values_shown_are_those_of_the_two_sides() -> None:
    for claim, left, right in (
        ("25 == sum(k**3/2**k, k, 1, oo)", 25, 26),
        ("sum(k**3/2**k, k, 1, oo) == 25", 26, 25),
    ):
        values = tresym.check(claim).values
        assert values is not None
        assert [round(float(ball.mid)) for ball in values] == [left, right]
    assert tresym.check("2*sum(k**3/2**k, k, 1, oo) == 50").values is None


def test_the_range_is_part_of_the_claim() -> None:
    """What holds by equation and coefficients is refused without the range, and at its ends."""
    for under in ("", " given x > -1/2", " given -1 <= x < 1"):
        statement = read(f"log(1 + x) == sum((-1)**(n - 1)*x**n/n, n, 1, oo){under}")
        claim = statement.comparisons[0]
        found = decide_power_series(claim.left, claim.right, statement.given)
        assert found.verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("claim", "said"),
    [
        ("exp(x) == sum(x**n/factorial(n), n, 0, oo)", "differential equation"),
        ("pi**2/6 == sum(1/n**2, n, 1, oo)", "DLMF"),
        ("sum(1/(k*(k + 1)), k, 1, oo) == 1", "limit of the partial sums"),
        ("E/(E - 1) == sum(1/factorial(k), k, 0, oo)*sum(exp(-k), k, 0, oo)/E", "power series of"),
        (r"e^x = \sum_{n=0}^\infty \frac{x^n}{n!}", "differential equation"),
        (r"\ln 2 = \sum_{n=1}^\infty \frac{(-1)^{n-1}}{n}", "power series of"),
    ],
)
def test_how_a_series_is_decided(claim: str, said: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert said in answer.why


@pytest.mark.parametrize(
    "claim",
    [
        "diff(sum(x**n, n, 0, oo), x) == 1",
        "sum(x**n, n, 0, oo) > 0 given 0 < x < 1",
        "sum(x**n, n, 0, oo)**2 == 1/(1 - x)**3 given 0 < x < 1",
        "sum(sin(n), n, 0, oo) == 1",
    ],
)
def test_what_is_left_open_or_refused(claim: str) -> None:
    with suppress(tresym.InputError):
        assert not tresym.check(claim)
