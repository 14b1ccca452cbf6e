"""Conditions of a domain: every point where an expression is defined satisfies them."""

import pytest
from cases import cases
from flint import arb, fmpq

from tresym.reals.domain.conditions import Condition, Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, with_domain
from tresym.reals.language.expression import Expr, number, substitute
from tresym.reals.language.parsing import parse

TABLE = cases(__file__, "TABLE")


@pytest.mark.parametrize(("text", "conditions"), TABLE)
def test_what_an_operation_needs(text: str, conditions: str) -> None:
    assert set(with_domain(Given(), parse(text)).comparisons) == set(
        Given.parse(conditions).comparisons
    )


def test_conditions_that_were_given_stay_first() -> None:
    under = Given.parse("x < 3")
    found = with_domain(under, parse("log(x)"), parse("sqrt(x)"))
    assert found.comparisons[:1] == under.comparisons
    assert len(found.comparisons) == 3


ALL = [text for text, _ in TABLE] + [
    "log(1 - x**2)/x",
    "sqrt(x)*log(1 - x)",
    "acosh(1/x)",
    "asin(x - 1)/tan(3*x)",
    "(x - 1/2)**(3*x)",
]


GRID = [fmpq(n, 6) for n in range(-18, 19)]


@pytest.mark.parametrize("text", ALL)
def test_no_point_of_the_domain_is_left_out(text: str) -> None:
    e = parse(text)
    places = [{"x": arb(x), "y": arb(1)} for x in GRID]
    defined = [at for at in places if evaluate(e, at).is_finite()]
    assert defined
    for at in defined:
        for condition in with_domain(Given(), e).conditions:
            value = evaluate(condition.expression, at)
            assert not (value.is_zero() and condition.relation != ">=")
            assert not value < 0 or condition.relation == "!="


AFFINE = ["x", "-x", "3 - 2*x", "x/7 + 5", "2*(x - 1)", "x + x - 1", "-1*x - 1/3"]
OTHERS = ["x**2 - 1", "x*y", "abs(x)", "x + y", "x + sin(x)", "x - x", "1/x", "x*x", "pi*x - 1"]


def _holds(comparison: tuple[Expr, str, Expr], x: fmpq) -> bool:
    left, relation, right = comparison
    difference = substitute(left - right, {"x": number(x)})
    assert difference.op == "number"
    value = difference.args[0]
    holds = {">": value > 0, ">=": value >= 0, "<": value < 0, "<=": value <= 0, "!=": value != 0}
    return bool(holds[relation])


@pytest.mark.parametrize("relation", [">", ">=", "!="])
@pytest.mark.parametrize("text", AFFINE)
def test_a_bound_says_the_same(text: str, relation: str) -> None:
    e = parse(text)
    found = bound(e, relation)
    assert found[0] == parse("x")
    for x in (*GRID, *(-found[2].args[0], found[2].args[0], fmpq(-35))):
        assert _holds(found, x) == _holds((e, relation, number(0)), x)


@pytest.mark.parametrize("text", OTHERS)
def test_only_what_is_affine_becomes_a_bound(text: str) -> None:
    e = parse(text)
    assert bound(e, ">=") == (e, ">=", number(0))


def test_a_domain_is_no_condition_beyond_what_is_defined() -> None:
    """A false bound would exclude x = 2 from the claim, where it may fail."""
    region = with_domain(Given(), parse("sqrt(x**2 - 1) + log(3 - x)"))
    at = {"x": arb(2)}
    assert all(isinstance(c, Condition) and c.holds_exactly(at) for c in region.conditions)
