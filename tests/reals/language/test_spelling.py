"""Expressions as people type them: products, functions, powers; two readings are refused."""

import contextlib

import pytest
from cases import cases
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.language.parsing import as_written, parse
from tresym.reals.language.spelling import spell_sum
from tresym.reals.language.spelling_tokens import tokens
from tresym.reals.language.typed_text import NotSpelledError, Typed
from tresym.reals.numbers.exact import InputError


def spell(text: str) -> str:
    typed = Typed(tokens(text)[1])
    found = spell_sum(typed)
    assert typed.at == len(typed.tokens), text
    return found


@pytest.mark.parametrize(
    ("typed", "meant"),
    [
        ("2x^2", "2*x**2"),
        ("-x^2", "-(x**2)"),
        ("x^-2", "1/x**2"),
        ("2^3^2", "512"),
        ("a/b/c", "(a/b)/c"),
        ("(x+1)/2", "(x + 1)/2"),
        ("sin 2x cos 3x", "sin(2*x)*cos(3*x)"),
        ("sin x + 1", "sin(x) + 1"),
        ("cos^2 2x", "cos(2*x)**2"),
        ("sin -x", "sin(-x)"),
        ("2(x+1)(x-1)", "2*(x + 1)*(x - 1)"),
        ("ln 2 + 1", "log(2) + 1"),
        ("|x||y|", "abs(x)*abs(y)"),
        ("3!", "factorial(3)"),
        ("x 90°", "x*pi/2"),
    ],
)
def test_typed_expressions(typed: str, meant: str) -> None:
    assert as_written(spell(typed)) == as_written(meant)


@pytest.mark.parametrize("typed", ["√2 x", "sin x cos x / 2", "1/2 x", "2e^2x"])
def test_two_readings_are_refused(typed: str) -> None:
    with pytest.raises(InputError, match="two readings"):
        spell(typed)


@pytest.mark.parametrize("text", ["2 3", "x + ", "*x", "x)", "(x", "sin", "0x10", "[x", "f(x) + f"])
def test_what_is_no_expression_is_left_to_the_strict_reader(text: str) -> None:
    with pytest.raises((NotSpelledError, AssertionError)):
        spell(text)


@pytest.mark.parametrize(
    ("typed", "meant"),
    cases(__file__, "typed_operators"),
)
def test_typed_operators(typed: str, meant: str) -> None:
    assert as_written(spell(typed)) == as_written(meant)


@pytest.mark.parametrize(
    "typed",
    [
        "∫_0 x dx",
        "sum_(k=1)^n k + 1",
        "lim x->0 x + 1",
        "d/dx x + 1",
        "d/dx (x^2) x",
        "dy/dx",
        "d^2y/dx^2",
    ],
)
def test_how_far_an_operator_reaches_is_not_guessed(typed: str) -> None:
    with pytest.raises((InputError, NotSpelledError)):
        spell(typed)


PIECES = [
    "x",
    "y",
    "2",
    "+",
    "-",
    "*",
    "/",
    "^",
    "(",
    ")",
    "[",
    "]",
    "{",
    "}",
    ",",
    "|",
    "!",
    "°",
    "'",
    "=",
    "sin",
    "cos",
    "sqrt",
    "d",
    "dx",
    "/",
    "int",
    "sum",
    "lim",
    "->",
    "_",
    "e",
    "pi",
]


@given(st.lists(st.sampled_from(PIECES), min_size=1, max_size=12).map(" ".join))
def test_any_text_is_spelled_or_refused(text: str) -> None:
    with contextlib.suppress(NotSpelledError, InputError):
        spell_sum(Typed(tokens(text)[1]))


ATOMS = st.sampled_from(["x", "y", "2", "7", "pi"])


@given(
    st.recursive(
        ATOMS,
        lambda inner: st.one_of(
            st.tuples(inner, inner).map(lambda p: f"({p[0]} + {p[1]})"),
            st.tuples(inner, inner).map(lambda p: f"({p[0]})*({p[1]})"),
            st.tuples(inner, inner).map(lambda p: f"({p[0]})/({p[1]})"),
            inner.map(lambda e: f"sin({e})"),
            inner.map(lambda e: f"-({e})"),
            inner.map(lambda e: f"({e})**2"),
        ),
        max_leaves=8,
    )
)
def test_what_is_in_the_grammar_keeps_its_meaning(text: str) -> None:
    try:
        expected = parse(text)
    except InputError:
        return
    assert parse(spell(text)) == expected
