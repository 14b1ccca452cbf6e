"""Theorems that are quoted: what they give, and what is near to them and false."""

import pytest

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.known_values import Known, known_value
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import PI, ZERO, Expr, opened
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

INTEGRALS = [
    "integral(sin(m*x)*sin(n*x), x, 0, pi) == 0 given n integer, n >= 1, m integer, m > n",
    "integral(sin(m*x)*cos(n*x), x, 0, 2*pi) == 0 given n integer, n >= 1, m integer, m > n",
    "integral(sin(m*x)/x, x, 0, oo) == pi/2 given m > 0",
    "integral(sin(m*x)/x, x, 0, oo) == -pi/2 given m < 0",
    "integral(exp(-x**2), x, -oo, oo) == sqrt(pi)",
    "integral(cos(a*x)/(x**2 + b**2), x, 0, oo) == pi/(2*b)*exp(-a*b) given a > 0, b > 0",
    "integral(1/(a + b*cos(x)), x, 0, pi) == pi/sqrt(a**2 - b**2) given a > b, b > 0",
    "integral(1/(2 + cos(x)), x, 0, 2*pi) == 2*pi/sqrt(3)",
    "integral(1/(1 + x**4), x, 0, oo) == pi/(2*sqrt(2))",
    "integral((sin(x)/x)**2, x, 0, oo) == pi/2",
    "integral(2*x*log(x)/(1 - x**2), x, 0, 1) == -pi**2/12",
    "integral(exp(-2*x)*sin(3*x)/x, x, 0, oo) == atan(3/2)",
    "asin(x) == integral(1/sqrt(1 - t**2), t, 0, x) given -1 <= x <= 1",
    "acosh(x) == integral(1/sqrt(t**2 - 1), t, 1, x) given x >= 1",
]
FALSE_INTEGRALS = [
    "integral(sin(m*x)*sin(n*x), x, 0, pi) == 0 given n integer, n >= 1, m integer, m >= 1",
    "integral(cos(m*x)*cos(n*x), x, 0, pi) == pi/2 given n integer, n >= 1, m integer, m > n",
    "integral(sin(m*x)/x, x, 0, oo) == pi given m > 0",
    "integral(sin(m*x)/x, x, 0, oo) == pi/2 given m < 0",
    "integral(sin(m*x)/x, x, 0, oo) == m*pi/2 given m > 0",
    "integral(exp(-x**2), x, -oo, oo) == sqrt(pi)/2",
    "integral(exp(-a*x**2), x, 0, oo) == sqrt(pi)/(2*a) given a > 0",
    "integral(cos(a*x)/(x**2 + b**2), x, 0, oo) == pi/2*exp(-a*b) given a > 0, b > 0",
    "integral(log(x)/(1 - x), x, 0, 1) == pi**2/6",
    "integral(log(x)/(1 + x), x, 0, 1) == -pi**2/6",
    "integral(asin(x)/x, x, 0, 1) == pi/4*log(2)",
    "integral(x/sinh(x), x, 0, oo) == pi**2/2",
    "integral(x/(exp(x) - 1), x, 0, oo) == pi**2/12",
    "integral(log(sin(x)), x, 0, pi/2) == pi/2*log(2)",
    "integral(log(sin(x)), x, 0, pi) == -pi/2*log(2)",
    "integral(1/(a + b*cos(x)), x, 0, pi) == 2*pi/sqrt(a**2 - b**2) given a > b, b > 0",
    "integral((exp(-a*x) - exp(-b*x))/x, x, 0, oo) == log(a/b) given a > 0, b > 0",
    "integral(sin(x**2), x, 0, oo) == sqrt(pi/2)",
    "integral(x**(a - 1)/(1 + x), x, 0, oo) == pi*sin(pi*a) given 0 < a < 1",
    "asin(x) == integral(1/sqrt(1 + t**2), t, 0, x) given -1 <= x <= 1",
    "asinh(x) == integral(1/sqrt(t**2 - 1), t, 1, x) given x >= 1",
]
HOLD = [
    "E == sum(1/factorial(k), k, 0, oo)",
    "log(2) == sum((-1)**(n - 1)/n, n, 1, oo)",
    "pi/4 == sum((-1)**n/(2*n + 1), n, 0, oo)",
    "pi**2/6 == sum(1/n**2, n, 1, oo)",
    "pi**2/8 == sum(1/(2*n + 1)**2, n, 0, oo)",
    "pi**2/12 == sum((-1)**(n + 1)/n**2, n, 1, oo)",
    "pi**3/32 == sum((-1)**n/(2*n + 1)**3, n, 0, oo)",
    "pi**4/90 == sum(1/n**4, n, 1, oo)",
    "pi*cot(pi*x) == 1/x + 2*x*sum(1/(x**2 - n**2), n, 1, oo)",
    "csc(x)**2 == sum((x - k*pi)**(-2), k, -oo, oo)",
    "csc(x) == 1/x + 2*x*sum((-1)**n/(x**2 - n**2*pi**2), n, 1, oo)",
    "coth(x) == 1/x + 2*x*sum(1/(x**2 + n**2*pi**2), n, 1, oo) given x != 0",
    "csch(x) == 1/x + 2*x*sum((-1)**n/(x**2 + n**2*pi**2), n, 1, oo) given x != 0",
    "tan(x) == 8*x*sum(1/((2*n - 1)**2*pi**2 - 4*x**2), n, 1, oo)",
    "tanh(x) == 8*x*sum(1/((2*n + 1)**2*pi**2 + 4*x**2), n, 0, oo)",
    "sec(x) == 4*pi*sum((-1)**n*(2*n + 1)/((2*n + 1)**2*pi**2 - 4*x**2), n, 0, oo)",
    "sin(z) == z*product(1 - z**2/(n**2*pi**2), n, 1, oo)",
    "cos(z) == product(1 - 4*z**2/((2*n - 1)**2*pi**2), n, 1, oo)",
    "sinh(z) == z*product(1 + z**2/(n**2*pi**2), n, 1, oo)",
    "cosh(z) == product(1 + 4*z**2/((2*n - 1)**2*pi**2), n, 1, oo)",
    "sin(z)/z == product(cos(z/2**n), n, 1, oo)",
    "pi/2 == product(4*n**2/(4*n**2 - 1), n, 1, oo)",
    "sum(1/(n**2 + 1), n, 1, oo) == (pi*coth(pi) - 1)/2",
    "sum(1/n**2, n, 1, oo) > 3/2",
    "sin(n*x) == 2**(n - 1)*product(sin(x + k*pi/n), k, 0, n - 1) given n integer, n >= 1",
    "product(sin(k*pi/n), k, 1, n - 1) == n/2**(n - 1) given n integer, n >= 2",
    "limit((1 + 1/n)**n, n, oo) == sum(1/factorial(k), k, 0, oo)",
]
FALSE = [
    "E == sum(1/factorial(k), k, 1, oo)",
    "E == sum(2/factorial(k), k, 0, oo)",
    "log(2) == sum((-1)**n/n, n, 1, oo)",
    "log(3) == sum((-1)**(n - 1)/n, n, 1, oo)",
    "pi/4 == sum((-1)**n/(2*n + 1), n, 1, oo)",
    "pi/2 == sum((-1)**n/(2*n + 1), n, 0, oo)",
    "pi**2/6 == sum(1/n**2, n, 2, oo)",
    "pi**2/6 == sum(1/(2*n + 1)**2, n, 0, oo)",
    "pi**2/12 == sum((-1)**n/n**2, n, 1, oo)",
    "pi**3/32 == sum((-1)**n/(2*n + 1)**3, n, 1, oo)",
    "pi**4/96 == sum(1/n**4, n, 1, oo)",
    "pi*cot(pi*x) == 1/x + 2*x*sum(1/(x**2 + n**2), n, 1, oo)",
    "pi*cot(pi*x) == 1/x + x*sum(1/(x**2 - n**2), n, 1, oo)",
    "pi*cot(pi*x) == 1/x + 2*x*sum(1/(x**2 - n**2), n, 2, oo)",
    "pi*cot(pi*x) == -1/x + 2*x*sum(1/(x**2 - n**2), n, 1, oo)",
    "pi*tan(pi*x) == 1/x + 2*x*sum(1/(x**2 - n**2), n, 1, oo)",
    "csc(x)**2 == 2*sum((x - k*pi)**(-2), k, -oo, oo)",
    "csc(x) == 1/x + 2*x*sum(1/(x**2 - n**2*pi**2), n, 1, oo)",
    "coth(x) == 1/x + 2*x*sum(1/(x**2 + n**2*pi**2), n, 0, oo) given x != 0",
    "tan(x) == 4*x*sum(1/((2*n - 1)**2*pi**2 - 4*x**2), n, 1, oo)",
    "tan(x) == 8*x*sum(1/((2*n + 1)**2*pi**2 - 4*x**2), n, 1, oo)",
    "sin(z) == product(1 - z**2/(n**2*pi**2), n, 1, oo)",
    "sin(z) == z*product(1 + z**2/(n**2*pi**2), n, 1, oo)",
    "sin(z) == z*product(1 - z**2/(n**2*pi**2), n, 2, oo)",
    "cosh(z) == product(1 - 4*z**2/((2*n - 1)**2*pi**2), n, 1, oo)",
    "pi/4 == product(4*n**2/(4*n**2 - 1), n, 1, oo)",
    "sin(z) == product(cos(z/2**n), n, 1, oo)",
    "sum(1/n**2, n, 1, oo) > 2",
    "sin(n*x) == 2**n*product(sin(x + k*pi/n), k, 0, n - 1) given n integer, n >= 1",
    "product(sin(k*pi/n), k, 1, n - 1) == n/2**n given n integer, n >= 2",
    "limit((1 + 1/n)**n, n, oo) == sum(1/factorial(k), k, 1, oo)",
]
NEVER = [
    "cos(z) == product(1 - 4*z**2/((2*n + 1)**2*pi**2), n, 1, oo)",
    "csc(x)**2 == sum((x - 2*k*pi)**(-2), k, -oo, oo)",
    "coth(x) == 1/x + 2*x*sum(1/(x**2 + n**2*pi), n, 1, oo) given x != 0",
    "sin(z) == z*product(1 - z**2/(n**3*pi**2), n, 1, oo)",
    "1 == sum(1/n, n, 1, oo)",
    "pi**2/6 == sum(1/n**3, n, 1, oo)",
    "pi == sum(1/(n**2 - 4), n, 1, oo)",  # a term is none
    "pi/2 == product(4*n**2/(4*n**2 - 1), n, 0, oo)",
    "sin(n*x) == 2**(n - 1)*product(sin(x + k*pi/n), k, 0, n - 1) given n integer, n >= 0",
    "sin(n*x) == 2**(n - 1)*product(sin(x + k*pi/n), k, 1, n - 1) given n integer, n >= 1",
    "sin(n*x) == 2**(n - 1)*product(sin(x + 2*k*pi/n), k, 0, n - 1) given n integer, n >= 1",
    "1 < 1/x + 2*x*sum(1/(x**2 - n**2), n, 1, oo)",
]


@pytest.mark.parametrize("claim", INTEGRALS)
def test_integrals_that_hold(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", HOLD)
def test_theorems(claim: str) -> None:
    assert tresym.check(claim)


@pytest.mark.parametrize("claim", [*FALSE_INTEGRALS, *FALSE])
def test_what_is_near_to_a_theorem_and_false(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


@pytest.mark.parametrize("claim", NEVER)
def test_what_no_theorem_says(claim: str) -> None:
    assert not tresym.check(claim)


def test_a_theorem_has_its_conditions() -> None:
    f, g = parse("1/(a + b*cos(x))"), parse("sin(a*x)/x")
    h = parse("sin(a*x)/(x + 1)")
    for conditions in ("b > a, a > 0", "a > 0", "b > 0"):
        assert known_value("integral", f, "x", ZERO, PI, Given.parse(conditions)) is None
    assert known_value("integral", f, "x", ZERO, PI, Given.parse("a > b, b > 0")) is not None
    assert known_value("integral", g, "x", ZERO, INFINITY, Given()) is None
    assert known_value("integral", g, "x", ZERO, PI, Given.parse("a > 0")) is None
    assert known_value("integral", h, "x", ZERO, INFINITY, Given.parse("a > 0")) is None


def _value(node: Expr, given: Given) -> Known | None:
    (n,), body = opened(node, given.names)
    return known_value(node.op, body, n, node.args[1], node.args[2], given)


@pytest.mark.parametrize(
    "total",
    [
        "sum(1/n**2, n, 1, m)",
        "sum(1/n**2, n, m, oo)",
        "sum(1/n**2, n, 1/2, oo)",
        "product(1 - z**2/(n**2*pi**2), n, 1, 9)",
        "sum((x - k*pi)**(-2), k, -oo, m)",
        "sum((x - k*pi)**(-2), k, -oo, 5)",
        "sum(1/n**2, n, -oo, 5)",
        "sum(1/factorial(n), n, -1, oo)",  # its first term is none
        "sum(x**n/(2*n + 1), n, 0, oo)",  # of atanh(sqrt(x)), not of atanh(x)
        "sum(x**n*factorial(n), n, 0, oo)",
        "sum((-1)**n/(2*n - 1)**4, n, 1, oo)",
        "sum((1/2)**n/n**2, n, 1, oo)",
        "sum(atan2(-1, n)/n**2, n, 1, oo)",
        "product(cos(z/3**n), n, 1, oo)",
    ],
)
def test_no_theorem_gives_it(total: str) -> None:
    """Asked of the table itself: points refute most claims on these before it is."""
    statement = read(f"1 == {total} given abs(x) < 1")
    assert _value(statement.comparisons[0].right, statement.given) is None


@pytest.mark.parametrize(
    ("total", "low"),
    [
        ("product(cos(x + k*pi/n), k, 0, n - 1)", 1),
        ("sum(sin(x + k*pi/n), k, 0, n - 1)", 1),
        ("product(sin(x + k*pi/n), k, 1, n - 1)", 1),
        ("product(sin(x + k*pi/n), k, 0, n - 1)", -1),
        ("product(sin(x*k + k*pi/n), k, 0, n - 1)", 1),
    ],
)
def test_no_theorem_gives_the_finite_product(total: str, low: int) -> None:
    statement = read(f"1 == {total} given n integer, n >= {low}")
    assert _value(statement.comparisons[0].right, statement.given) is None
