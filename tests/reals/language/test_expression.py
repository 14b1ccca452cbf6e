"""Trees: what was written and no more, derivatives that are derivatives, bounds that hold."""

import pickle
from fractions import Fraction
from typing import Any

import pytest
from cases import cases
from flint import arb, fmpq
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import (
    FUNCTIONS,
    MAX_BITS,
    MAX_DEPTH,
    MAX_POWER,
    MAX_SIZE,
    PI,
    E,
    Expr,
    add,
    apply,
    as_expr,
    extreme,
    multiply,
    number,
    power,
    rebuild,
    sqrt,
    substitute,
    symbol,
    symbols,
    trees,
)
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

x, y = symbol("x"), symbol("y")
fractions = st.fractions(-9, 9, max_denominator=9)
leaves = st.one_of(st.sampled_from([x, y, PI, E]), fractions.map(number))


def _larger(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    return st.one_of(
        st.lists(inner, min_size=2, max_size=3).map(lambda parts: add(*parts)),
        st.lists(inner, min_size=2, max_size=3).map(lambda parts: multiply(*parts)),
        st.builds(power, inner, st.integers(-3, 3).map(number)),
        st.builds(apply, st.sampled_from(sorted(FUNCTIONS - {"sign"})), inner),
        inner.map(sqrt),
        inner.map(lambda e: -e),
    )


trees_ = st.recursive(leaves, _larger, max_leaves=8)


@given(trees_)
def test_text_is_read_back_as_the_same_value(e: Expr) -> None:
    again = parse(str(e))
    assert symbols(again) == symbols(e)
    with ball_precision(100):
        at = {"x": arb(fmpq(3, 7)), "y": arb(fmpq(-5, 4))}
        one, other = evaluate(e, at), evaluate(again, at)
        assert one.is_finite() == other.is_finite()
        assert one.overlaps(other)


@given(trees_)
def test_a_pickle_is_equal_and_hashes_alike(e: Expr) -> None:
    again = pickle.loads(pickle.dumps(e))
    assert again == e
    assert hash(again) == hash(e)


@given(trees_, fractions)
def test_substitution_and_evaluation_commute(e: Expr, value: Fraction) -> None:
    put = substitute(e, {"x": number(value)})
    at = {"x": arb(fmpq(value.numerator, value.denominator)), "y": arb(2)}
    one, other = evaluate(e, at), evaluate(put, at)
    assert "x" not in symbols(put)
    assert not (one.is_finite() and other.is_finite()) or one.overlaps(other)


def test_substitution_is_all_at_once() -> None:
    assert substitute(parse("x - y + exp(x)"), {"x": y, "y": x}) == parse("y - x + exp(y)")


@pytest.mark.parametrize(
    ("text", "tree"),
    cases(__file__, "only_numbers_are_folded"),
)
def test_only_numbers_are_folded(text: str, tree: str) -> None:
    assert parse(text).op == tree


def test_sums_and_products_are_flat() -> None:
    assert add(add(x, number(1)), add(y, number(2))).args == (x, y, number(3))
    assert multiply(number(2), multiply(x, number(3)), y).args == (number(6), x, y)
    assert power(power(x, number(2)), number(3)) == power(x, number(6))


@given(st.lists(fractions, min_size=1, max_size=5))
def test_extremes(values: list[Fraction]) -> None:
    for side, expected in ((1, max(values)), (-1, min(values))):
        value = evaluate(extreme(side, map(number, values)), {})
        assert (value * expected.denominator).contains(expected.numerator)


@pytest.mark.parametrize("op", ["x + y", "x*y", "x**y", "sin(x)", "sqrt(x)"])
def test_rebuilding_with_the_same_operands(op: str) -> None:
    assert rebuild(parse(op), parse(op).args) == parse(op)


def _deep() -> Expr:
    e = x
    for _ in range(MAX_DEPTH):
        e = apply("sin", e)
    return e


def _large() -> Expr:
    e = x + y
    for _ in range(MAX_SIZE.bit_length()):
        e = apply("sin", e) * apply("cos", e)
    return e


def test_what_is_too_much_is_refused() -> None:
    for build in (
        _deep,
        _large,
        lambda: number(2**MAX_BITS),
        lambda: power(number(10**9), number(MAX_POWER * 2)),
        lambda: power(x, number(MAX_POWER + 1)),
        lambda: power(x, number(Fraction(1, MAX_POWER + 1))),
        lambda: power(power(x, number(MAX_POWER)), number(2)),
        lambda: power(number(2**60), number(MAX_POWER)),
        lambda: apply("gudermann", x),
    ):
        with pytest.raises(InputError):
            build()


@pytest.mark.parametrize("value", [0.5, 1j, "x", None])
def test_only_exact_numbers_enter(value: Any) -> None:
    with pytest.raises(InputError):
        as_expr(value)


def test_formulas_run_in_trees() -> None:
    assert trees.sqrt(2) * trees.sin(x) + trees.pi == parse("sqrt(2)*sin(x) + pi")
    assert not hasattr(trees, "gudermann")
    assert 1 - 2 / x**2 + abs(y) == parse("1 - 2/x**2 + abs(y)")
    assert 2**x == parse("2**x")
