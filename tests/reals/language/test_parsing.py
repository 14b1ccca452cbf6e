"""Text to expressions: the grammar, exactness, and hostile input in one clear line."""

from fractions import Fraction
from functools import reduce

import pytest
from cases import cases
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import at, derivative, integral, limit, order
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    FUNCTIONS,
    PI,
    E,
    Expr,
    add,
    angle,
    apply,
    number,
    symbol,
    trees,
)
from tresym.reals.language.parsing import as_written, parse, parse_given
from tresym.reals.language.sympy import from_sympy
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.numbers.exact import InputError

HOSTILE = [
    "",
    "   ",
    "(" * 5000 + "x" + ")" * 5000,
    "(" * 150 + "x" + ")" * 150,
    "-" * 9000 + "x",
    "x" * 10**6,
    "x+" * 4900 + "x",
    "sin(" * 200 + "x" + ")" * 200,
    "x**" * 300 + "x",
    "x**(10**9)",
    "2**2**2**2**2",
    "9**9**9",
    "(1/3)**(-10**6)",
    "1" * 9000 + "**900",
    "1e999999",
    "1e400j",
    "nan.real",
    "0x10",
    "1_000",
    "__import__('os')",
    "__import__",
    "x.__class__",
    "[1, 2]",
    "x[0]",
    "lambda: 1",
    "x if y else z",
    "x := 1",
    "f'{x}'",
    "'text'",
    "True",
    "x and y",
    "x < y",
    "x == y",
    "x = y",
    "exec('1')",
    "f(x)",
    "sin(x, y)",
    "sin()",
    "sin(x=1)",
    "sin",
    "diff(x)",
    "diff(x, 2)",
    "diff(x, x, 99)",
    "diff(x, x, y)",
    "2x",
    "2 x",
    "x y",
    "(x)(y)",
    "x%2",
    "x//2",
    "~x",
    "x\0y",
    "é",
    "١",
    "#",
    "*x",
    "yield",
    "x)",
    "(x",
]


@pytest.mark.parametrize("text", HOSTILE, ids=range(len(HOSTILE)))
def test_hostile_text_is_one_line(text: str) -> None:
    with pytest.raises(InputError) as caught:
        parse(text)
    message = str(caught.value)
    assert "\n" not in message
    assert 0 < len(message) < 400


def test_implicit_multiplication_gets_a_hint() -> None:
    with pytest.raises(InputError, match=r"write \* between factors"):
        parse("2x + 1")


def test_decimals_are_exact() -> None:
    assert parse("0.1") == number(Fraction(1, 10))
    assert parse("1e-30") == number(Fraction(1, 10**30))
    assert parse("12.5372") == number(Fraction(125372, 10000))
    assert parse("1/3") == number(Fraction(1, 3))


@pytest.mark.parametrize(
    ("one", "other"),
    cases(__file__, "notation"),
)
def test_notation(one: str, other: str) -> None:
    assert parse(one) == parse(other)


@pytest.mark.parametrize(
    "text",
    cases(__file__, "text_and_sympy_round_trips"),
)
def test_text_and_sympy_round_trips(text: str) -> None:
    e = parse(text)
    assert parse(str(e)) == e
    again = from_sympy(to_sympy(e))
    assert to_sympy(again) == to_sympy(e)


def test_expressions_are_an_arithmetic() -> None:
    x = symbol("x")
    e = trees.sqrt(1 - x**2) * trees.pi / 2 + trees.atan(x) - Fraction(1, 3)
    assert e == parse("sqrt(1 - x**2)*pi/2 + atan(x) - 1/3")
    assert hash(e) == hash(parse(str(e)))


def test_expressions_are_values() -> None:
    import pickle

    e = parse("sin(x)**2 + 1/3")
    assert pickle.loads(pickle.dumps(e)) == e
    assert parse("E") == E
    assert len({e, parse("sin(x)**2 + 1/3")}) == 1


def test_floats_are_refused() -> None:
    with pytest.raises(InputError):
        symbol("x") + 0.5  # type: ignore[operator]


def test_growth_is_bounded() -> None:
    def squared(e: Expr) -> Expr:
        return add(e * e, number(1))

    for step in (squared, trees.sin):
        with pytest.raises(InputError):
            reduce(lambda e, _: step(e), range(200), symbol("x"))


def test_derivative_of_a_constant_is_zero() -> None:
    assert differentiate(parse("sin(a)**2"), "x") == number(0)


@pytest.mark.parametrize(
    "text", ["a", "a = 1", "a == 1", "a > b or c", "a > ", "a in b", "1 < 2 >"]
)
def test_bad_conditions(text: str) -> None:
    with pytest.raises(InputError):
        Given.parse(text)


def test_conditions_from_sympy() -> None:
    import sympy

    a, b = sympy.symbols("a b", real=True)
    conditions = Given.from_sympy(a > 0, sympy.And(b > 0, b <= 1), sympy.Ne(a, b))
    assert conditions.satisfying_point() is not None
    assert conditions.names == {"a", "b"}
    with pytest.raises(InputError):
        Given.from_sympy(sympy.Eq(a, b))
    with pytest.raises(InputError):
        from_sympy(sympy.Float("0.5"))
    with pytest.raises(InputError):
        from_sympy(sympy.I)


def _names(e: Expr) -> set[str]:
    from tresym.reals.language.expression import symbols

    return set(symbols(e))


def test_symbols() -> None:
    assert _names(parse("a*sin(x)**y + pi")) == {"a", "x", "y"}


VARIABLES = st.sampled_from(["x", "y", "a1", "theta_0"])
NUMBERS = st.fractions(min_value=-5, max_value=5, max_denominator=4).map(number)
LEAVES = VARIABLES.map(symbol) | NUMBERS | st.sampled_from([PI, E])


def _larger(inner: st.SearchStrategy[Expr]) -> st.SearchStrategy[Expr]:
    pairs, bound = st.tuples(inner, inner), st.tuples(inner, VARIABLES)
    ends = st.tuples(inner, VARIABLES, inner)
    return st.one_of(
        pairs.map(lambda p: p[0] + p[1]),
        pairs.map(lambda p: p[0] - p[1]),
        pairs.map(lambda p: p[0] * p[1]),
        pairs.map(lambda p: p[0] / p[1]),
        pairs.map(lambda p: angle(*p)),
        st.tuples(inner, LEAVES).map(lambda p: p[0] ** p[1]),
        st.tuples(st.sampled_from(sorted(FUNCTIONS)), inner).map(lambda p: apply(*p)),
        bound.map(lambda p: derivative(*p)),
        ends.map(lambda p: derivative(*p)),
        ends.map(lambda p: at(p[0], {p[1]: p[2]})),
        st.tuples(ends, inner, inner).map(lambda p: at(p[0][0], {"x": p[1], "y": p[2]})),
        st.tuples(ends, st.sampled_from([-1, 0, 1])).map(lambda p: limit(*p[0], p[1])),
        st.tuples(bound, inner, inner).map(lambda p: integral(*p[0], *p[1:])),
        st.tuples(st.sampled_from("Oo"), inner).map(lambda p: order(*p)),
    )


@given(st.recursive(LEAVES, _larger, max_leaves=10))
def test_what_is_printed_is_read_back(tree: Expr) -> None:
    assert as_written(str(tree)) == tree


@pytest.mark.parametrize(
    ("text", "says"),
    cases(__file__, "what_is_no_condition_on_numbers_is_refused"),
)
def test_what_is_no_condition_on_numbers_is_refused(text: str, says: str) -> None:
    with pytest.raises(InputError, match=says):
        parse_given(text)
