"""Theorems that are quoted: what they give, and what is near to them and false."""

import pytest
from cases import cases

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.known_values import Known, known_value
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import PI, ZERO, Expr, opened
from tresym.reals.language.parsing import parse


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
    cases(__file__, "no_theorem_gives_it"),
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
