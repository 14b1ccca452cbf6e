"""Exact limits with parameters: the rules, and what each of their guards keeps out."""

import pytest

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.expansions.limit_values import _is_bounded, limit_of
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

LIMITS = [
    ("sin(a*x)/x", "0", "", "a"),
    ("(1 + a/x)**x", "oo", "", "exp(a)"),
    ("x**3*exp(-a*x)", "oo", "a > 0", "0"),
    ("x**a*exp(-x)", "oo", "", "0"),
    ("x**a*log(x)", "0", "a > 0", "0"),
    ("log(x)/x**a", "oo", "a > 0", "0"),
    ("sqrt(x + a) - sqrt(x)", "oo", "", "0"),
    ("sqrt(x**2 + a*x) - x", "oo", "", "a/2"),
    ("(a**x - 1)/x", "0", "a > 0", "log(a)"),
    ("atan(x/a)", "oo", "a > 0", "pi/2"),
    ("atan(x/a)", "oo", "a < 0", "-pi/2"),
    ("x*sin(1/x)", "0", "", "0"),
    ("exp(-a*x)*(sin(b*x)*c + cos(x**2))", "oo", "a > 0", "0"),
    ("x*(atan(x) - pi/2)", "oo", "", "-1"),
    ("a**x", "oo", "a > 1", "oo"),
    ("a**x", "oo", "a > 0, a < 1", "0"),
    ("x**x", "0", "", "1"),
    ("sqrt(x)*log(x)**3", "0", "", "0"),
    ("log(sin(x))", "0", "", "-oo"),
    ("asin(1 - x)", "0", "", "pi/2"),
    ("1/(cos(x) - 1)", "0", "", "-oo"),
    ("log(x)/2 - log(x**2 + 1)/4", "oo", "", "0"),
    ("log(x) - log(x**2)", "0", "", "oo"),
    ("a*log(x) - a*log(2*x + 1)", "oo", "", "-a*log(2)"),
    ("sign(x - x)", "0", "", "0"),
    ("(a**x + b**x)**(1/x)", "oo", "a > 1, b > a", "b"),
    ("(1 + a/x + b/x**2)**x", "oo", "", "exp(a)"),
    ("x**a/exp(b*x)", "oo", "b > 0", "0"),
    ("exp(x)*(exp(a/x - exp(-x)) - exp(a/x))", "oo", "", "-1"),
    ("x**a*log(1/x)**b", "0", "a > 0", "0"),
    ("(sin(x) + x**2)/x", "oo", "", "oo"),
]


@pytest.mark.parametrize(("e", "point", "given", "value"), LIMITS)
def test_limits(e: str, point: str, given: str, value: str) -> None:
    where = None if point == "oo" else parse(point)
    found = limit_of(parse(e), "x", where, 1, Given.parse(given))
    infinite = {"oo": INFINITY, "-oo": -INFINITY}
    if value in infinite:
        assert found == infinite[value]
    else:
        assert found is not None
        assert decide(found, parse(value), Given.parse(given)).verdict is Verdict.PROVED


NONE = [
    ("sin(1/x)", "0", ""),
    ("exp(-a*x)*sin(b*x)", "oo", ""),
    ("exp(-a*x)*sin(b*exp(2*a*x))/sin(b*x)", "oo", "a > 0"),
    ("exp(-a*x)*sin(b*x) + sin(c*x)", "oo", "a > 0"),
    ("exp(-a*x)*sin(b*x)*log(-x)", "oo", "a > 0"),
    ("atan(x/a)", "oo", ""),  # the sign of a is open
    ("x**a", "0", ""),
    ("exp(-a*x)", "oo", ""),
    ("a**x", "oo", "a > 0"),
    ("sqrt(-x)", "0", ""),  # real at 0 and nowhere beside it
    ("sqrt(x - x**2 - x)", "0", ""),
    ("log(-x)", "0", ""),
    ("asin(1 + x)", "0", ""),
    ("(-x)**x", "0", ""),
    ("sqrt(log(x))*x", "0", ""),
    ("x/log(1 + x)*log(x)/log(1 + x**2)*0*tan(1/x)", "0", ""),
    ("exp(-1/x)*tan(1/x)", "0", ""),  # tan is not bounded
    ("exp(-1/x)/sin(1/x)", "0", ""),
    ("a/a", "0", ""),  # a may be 0
    ("sqrt(a)*x", "0", ""),
    ("log(a + x)", "0", "a >= 0"),  # -oo at a = 0 alone
    ("1/(a + x)", "0", "a >= 0"),
    ("log(-x)*x", "0", ""),
    ("log(x) - log(x - 2*x)", "0", ""),  # the second is not real
    ("log(-x) - log(-2*x)", "0", ""),  # real nowhere near
    ("(x**2 - 1)/(x - a)", "1", ""),
    ("x*exp(1/x)*log(1 + x - 1)/log(2 - x/x - 1)", "0", ""),
    ("sin(tan(x))/x", "oo", ""),  # infinitely many points at which it is not defined
    ("sin(x + tan(x))/x", "oo", ""),
    ("sin(tan(x)**2)/x", "oo", ""),
    ("sin(sqrt(1 - x))/x", "oo", ""),  # not real
]


@pytest.mark.parametrize(("e", "point", "given"), NONE)
def test_what_has_no_limit_or_none_that_is_shown(e: str, point: str, given: str) -> None:
    where = None if point == "oo" else parse(point)
    assert limit_of(parse(e), "x", where, 1, Given.parse(given)) is None


@pytest.mark.parametrize(
    ("e", "bounded"),
    [
        ("a*sin(b*x**2 + 1) + cos(x)", True),
        ("sin(x)*cos(x)", True),
        ("sin(x) + x", False),
        ("x*sin(x)", False),
        ("1/sin(x)", False),
        ("sin(1/x)", False),  # with a pole on the way, for all that is known
        ("exp(sin(x))", False),  # it is, but no rule says so
    ],
)
def test_what_is_made_of_waves_is_bounded(e: str, bounded: bool) -> None:
    assert _is_bounded(parse(e), "x") is bounded
