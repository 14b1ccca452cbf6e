"""Theorems that are quoted: what they give, and what is near to them and false."""

from __future__ import annotations

import pytest
from flint import fmpq

import tresym
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.hypergeometric import series_of
from tresym.reals.decisions.known_series import TEMPLATES, Template, quoted_product, quoted_total
from tresym.reals.decisions.power_series import decide_power_series
from tresym.reals.language.expression import number, substitute
from tresym.reals.language.parsing import parse
from tresym.reals.normal.at_point import equal_at
from tresym.reals.verdict import Verdict

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


@pytest.mark.parametrize("claim", HOLD)
def test_theorems(claim: str) -> None:
    assert tresym.check(claim)


@pytest.mark.parametrize("claim", FALSE)
def test_what_is_near_to_a_theorem_and_false(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.REFUTED


@pytest.mark.parametrize("claim", NEVER)
def test_what_no_theorem_says(claim: str) -> None:
    assert not tresym.check(claim)


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
        "sum((-1)**n/(2*n - 1)**2, n, 1, oo)",  # Catalan's constant
        "sum((1/2)**n/n**2, n, 1, oo)",
        "sum(atan2(-1, n)/n**2, n, 1, oo)",
        "product(cos(z/3**n), n, 1, oo)",
    ],
)
def test_no_theorem_gives_it(total: str) -> None:
    """Asked of the table itself: points refute most claims on these before it is."""
    statement = read(f"1 == {total} given abs(x) < 1")
    assert quoted_total(statement.comparisons[0].right, [], statement.given) is None


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
    assert quoted_product(statement.comparisons[0].right, statement.given) is None


@pytest.mark.parametrize("template", TEMPLATES)
def test_a_power_series_in_the_table_is_one(template: Template) -> None:
    """By its differential equation."""
    body = _term(template)
    statement = read(f"{template.function} == sum({body}, k, 0, oo) given abs(y) < 1/2")
    claim = statement.comparisons[0]
    assert decide_power_series(claim.left, claim.right, statement.given).verdict is Verdict.PROVED
    s = series_of(claim.right)
    assert s is not None
    ratio = parse(template.above) / parse(template.below)
    for k in range(9):
        value = substitute(ratio, {"k": number(k)})
        assert equal_at(value, number(s.above(fmpq(k)) / s.below(fmpq(k))), {})


def _term(template: Template) -> str:
    """The general term, written out."""
    fact = {
        "exp(y)": "1/factorial(k)",
        "sin(y)": "(-1)**k/factorial(2*k + 1)",
        "cos(y)": "(-1)**k/factorial(2*k)",
        "sinh(y)": "1/factorial(2*k + 1)",
        "cosh(y)": "1/factorial(2*k)",
        "-log(1 - y)": "1/(k + 1)",
        "atan(y)": "(-1)**k/(2*k + 1)",
        "atanh(y)": "1/(2*k + 1)",
        "asin(y)": "factorial(2*k)/(4**k*factorial(k)**2*(2*k + 1))",
        "asinh(y)": "(-1)**k*factorial(2*k)/(4**k*factorial(k)**2*(2*k + 1))",
        "asin(y)**2": "4**k*factorial(k)**2*2/(factorial(2*k + 2))",
        "1/(1 - y)": "1",
        "1/(1 - y)**2": "k + 1",
        "(1 + y)/(1 - y)**3": "(k + 1)**2",
        "1/sqrt(1 - y)": "factorial(2*k)/(4**k*factorial(k)**2)",
    }[template.function]
    return f"({fact})*y**({template.step}*k + {template.start})"
