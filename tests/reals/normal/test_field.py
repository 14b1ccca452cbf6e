"""Normal forms of equal expressions are equal, and have the value of the expression."""

from collections.abc import Callable

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, add, apply, multiply, number, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.normal.field import ALL_THEORIES, Field
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.factoring import TooLargeError

EQUAL = cases(__file__, "EQUAL")


def equal(left: str, right: str, under: str, theories: frozenset[str] = ALL_THEORIES) -> bool:
    field = Field(Given.parse(under), theories)
    x, y = field.normal(parse(left), parse(right))
    return bool((x - y).num.is_zero())


@pytest.mark.parametrize(("left", "right", "wrong", "under"), EQUAL)
def test_equal(left: str, right: str, wrong: str, under: str) -> None:
    assert equal(left, right, under)
    assert not equal(left, wrong, under)
    assert not equal(left, f"{right} + 1/10^80", under)


NOT_EQUAL = cases(__file__, "NOT_EQUAL")


@pytest.mark.parametrize(("left", "right", "under"), NOT_EQUAL)
def test_not_equal(left: str, right: str, under: str) -> None:
    assert not equal(left, right, under)


@pytest.mark.parametrize(
    ("text", "of"),
    cases(__file__, "a_theory_that_is_not_allowed_is_not_used"),
)
def test_a_theory_that_is_not_allowed_is_not_used(text: str, of: str) -> None:
    assert equal(text, "0", "")
    assert not equal(text, "0", "", ALL_THEORIES - {of})
    assert equal(f"({text})*(x - y)", f"({text})*x - y*({text})", "", frozenset())


@pytest.mark.parametrize(
    "text",
    cases(__file__, "nowhere_defined"),
)
def test_nowhere_defined(text: str) -> None:
    with pytest.raises(UndefinedError):
        Field(Given()).normal(parse(text))


@pytest.mark.parametrize(
    "text",
    [" + ".join(f"a{k}" for k in range(30)), "(x + y + z)^600", "x**(1/61)", "sin(200*x) + sin(x)"],
)
def test_too_large(text: str) -> None:
    with pytest.raises(TooLargeError):
        Field(Given()).normal(parse(text))


def test_what_is_learnt_in_one_pass_is_used_in_the_next() -> None:
    """The radicands come last; that x is positive is used in the absolute value before them."""
    assert equal("abs(x) + sqrt(x)", "x + sqrt(x)", "")
    assert equal("abs(x) + sqrt(x*y) + sqrt(y)", "x + sqrt(x*y) + sqrt(y)", "")
    assert not equal("abs(x) + sqrt(x*y)", "x + sqrt(x*y)", "")
    assert not equal("abs(x) + log(x^2)", "x + log(x^2)", "")


X, Y = symbol("x"), symbol("y")
FUNCTIONS = tuple(cases(__file__, "FUNCTIONS"))
FUNCTIONS += ("sinh", "tanh", "asinh", "acosh", "atanh")


def _named(name: str) -> Callable[[Expr], Expr]:
    return lambda e: e ** number(fmpq(1, 2)) if name == "sqrt" else apply(name, e)


leaves = st.sampled_from([X, Y, X - Y, 2 * X, number(3), number(fmpq(-1, 2)), parse("pi")])
trees: st.SearchStrategy[Expr] = st.recursive(
    leaves,
    lambda inner: (
        st.builds(add, inner, inner)
        | st.builds(multiply, inner, inner)
        | st.builds(lambda f, e: f(e), st.sampled_from([_named(n) for n in FUNCTIONS]), inner)
    ),
    max_leaves=4,
)
WHERE = [(fmpq(2, 7), fmpq(5, 9)), (fmpq(-9, 4), fmpq(1, 3)), (fmpq(13, 8), fmpq(-1, 5))]


@given(trees)
def test_the_value_is_kept(e: Expr) -> None:
    field = Field(Given())
    try:
        (found,) = field.normal(e)
    except (TooLargeError, UndefinedError):
        return
    with ball_precision(200):
        for x, y in WHERE:
            point = {"x": arb(x), "y": arb(y)}
            value, expected = field.ring.ball(found, point), evaluate(e, point)
            if value.is_finite() and expected.is_finite():
                assert value.overlaps(expected)


def test_an_arc_tangent_beside_a_quarter_turn_is_none() -> None:
    field = Field(Given())
    (huge,) = field.normal(parse("atan(10^60)"))
    assert not (huge - field.angles.pi(fmpq(1, 2))).num.is_zero()
