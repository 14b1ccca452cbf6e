"""Roots of equations as expressions: values, claims, derivatives, and false claims of each kind."""

from __future__ import annotations

import mpmath
import pytest

import tresym
from tresym.accuracy.values import value
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.roots import root_nodes
from tresym.reals.decisions.roots_over_boxes import decide_over_boxes
from tresym.reals.language.expression import number, substitute, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.language.readings import in_latex
from tresym.reals.numbers.exact import InputError

HOLDS = """
root(y**2 - 2, y, 0, 2) == sqrt(2)
root(y**2 - a, y, 0, oo) == sqrt(a) given a > 0
root(y*exp(y) - x, y, 0, oo) <= log(x) given x >= E
root(y*exp(y) - x, y, 0, oo) <= x given x > 0
root(y**5 + e*y - 1, y, 0, oo) < 1 given 0 < e < 1
root(x*exp(x) - 3, x, 0, oo) < 1.05
root(tan(x) - x, x, pi, 3*pi/2) < 4.4935
root(y - x, y, 0, 1) == x
root(k - e*sin(k) - m, k, -oo, oo) <= m + e given 0 < e < 1
diff(root(y**3 - x, y, 0, oo), x) == 1/(3*root(y**3 - x, y, 0, oo)**2) given x > 0
diff(root(y*exp(y) - x, y, 0, oo), x)*x > 0 given x > 0
root(cos(y) - a*y, y, 0, pi/2) + root(y*exp(y) - a, y, 0, oo) < 2 given 1 <= a <= 3/2
sin(root(y + a*sin(y) - b, y, -3, 3)) > 12/25 given 1/2 <= a <= 1, 1 <= b <= 2
abs(root(tanh(a*y) - b*cos(y), y, 0, pi/2) - 0.52) < 1/10 given 1 <= a <= 1.1, 0.55 <= b <= 0.6
root(y**3 + a*y - b, y, 0, 3) ~= 0.682 given a ~= 1.0000, b ~= 1.0000
root(y - a*exp(-y), y, 0, 2) != b given 1 <= a <= 3/2, 1 <= b <= 2
"""


def _lines(text: str) -> list[str]:
    return [line for line in text.splitlines() if line]


@pytest.mark.parametrize("claim", _lines(HOLDS))
def test_true_claims_about_roots(claim: str) -> None:
    assert tresym.check(claim).verdict.holds


def test_values_agree_with_lambert_w_and_kepler() -> None:
    with mpmath.workdps(60):
        lambert = mpmath.lambertw(3)
        found = value("root(x*exp(x) - 3, x, 0, oo)", digits=50)
        assert abs(mpmath.mpf(found.text) - lambert) < 1e-49
        anomaly = mpmath.findroot(lambda y: y - mpmath.sin(y) / 2 - 1, 1.5)
        found = value("root(y - e*sin(y) - m, y, -oo, oo)", 40, e="1/2", m="1")
        assert abs(mpmath.mpf(found.text) - anomaly) < 1e-39
        inverse = mpmath.erfinv(1 / mpmath.sqrt(mpmath.pi))
        found = value("root(integral(exp(-t**2), t, 0, y) - 1/2, y, 0, 2)", digits=30)
        assert abs(mpmath.mpf(found.text) - inverse) < 1e-29


def test_a_zero_that_the_search_hits_exactly() -> None:
    assert value("root(y - 1, y, -2, 4)").text.startswith("1.000")
    assert value("root(y**5 + e*y - 1, y, 0, oo)", e="0").text.startswith("1.000")


@pytest.mark.parametrize(
    "claim",
    [
        "root(y**3 - a*y, y, -1, 1) + b < 2 given 1/2 <= a <= 3/4, 0 <= b <= 1/2",
        "root(sign(y - a/4) - b/8, y, -1, 1) < 1 given 1/2 <= a <= 3/4, 0 <= b <= 1/2",
        "root(y - a, y, 0, 1) + b < 2 given 1 < a <= 2, 0 <= b <= 1/2",
        "root(y - a, y, 0, 2) + sign(1 - a) < 2 given 1/2 <= a <= 3/2, a != 1",
        "root(y - a, y, 0, 2) < 1 given 1/2 <= a < 1",
        "root(y - a, y, 0, 2) < 2 given a >= 1/2",
        "root(y - a, y, 0, 2) < b given 1/2 <= a < 1",
    ],
)
def test_balls_leave_open_what_they_do_not_show(claim: str) -> None:
    statement = read(claim)
    (comparison,) = statement.comparisons
    nodes = root_nodes(comparison.left, comparison.right)
    assert decide_over_boxes(comparison, statement, nodes, 60) is None


def test_zeros_at_the_ends_do_not_count() -> None:
    assert value("root(sin(x) - x/2, x, 0, pi)").text.startswith("1.895494267")
    assert value("root(cos(x) - 1 + x**2/4, x, 0, 3)").text.startswith("2.78311")


@pytest.mark.parametrize(
    ("text", "why"),
    [("root(y**2 - 2, y, -2, 2)", "at least 2 zeros"), ("root(y**2 + 1, y, 0, 2)", "no zero")],
)
def test_no_value_where_there_are_two_roots_or_none(text: str, why: str) -> None:
    with pytest.raises(InputError, match=why):
        value(text)


def test_text_substitution_and_latex() -> None:
    e = parse("root(y**2 - a, y, 0, 2*y)")
    assert str(e) == "root(y_1**2 - a, y_1, 0, 2*y)"
    assert parse(str(e)) == e
    moved = substitute(e, {"a": symbol("y"), "y": number(3)})
    assert str(moved) == "root(y_1**2 - y, y_1, 0, 6)"
    assert r"\operatorname{root}_{0 < y < \infty}" in in_latex("root(y**2 - 2, y, 0, oo) == x")
