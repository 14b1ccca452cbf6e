"""A place among tokens: what comes next, what it is called, and one line where it is not read."""

import pytest
from cases import cases

from tresym.reals.language.expression import symbol
from tresym.reals.language.latex_ambiguity import check_name
from tresym.reals.language.latex_cursor import (
    Cursor,
    allowed,
    derived,
    is_derivative,
    is_letter,
    is_number,
)
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.numbers.exact import InputError


def _at(source: str) -> Cursor:
    return Cursor(tokenize(source))


def test_tokens_are_taken_in_order_and_none_after_the_last() -> None:
    cursor = _at("x+")
    assert (cursor.peek(), cursor.peek(1), cursor.peek(2)) == ("x", "+", "")
    assert (cursor.take(), cursor.take("+"), cursor.peek()) == ("x", "+", "")
    with pytest.raises(InputError, match="ends"):
        cursor.take()


def test_another_token_than_expected_is_refused_at_its_place() -> None:
    cursor = _at("x+y")
    with pytest.raises(InputError, match="expected"):
        cursor.take("y")
    assert cursor.at == 0


@pytest.mark.parametrize(
    ("source", "kind", "operator", "spaced"),
    [
        (r"\sin x", "function", "", False),
        (r"\arcsin x", "inverse", "", False),
        (r"\int f", "function", "", False),
        (r"\max(x, y)", "function", "", False),
        (r"\lim_{x\to 0} x", "function", "", False),
        (r"\dot x", "derivative", "", False),
        (r"\frac{d}{dx} x", "derivative", "", False),
        (r"\frac{\partial f}{\partial x}", "derivative", "", False),
        (r"\frac{d}{c}", "fraction", "", False),
        ("(x)", "bracket", "", False),
        ("y", "letter", "", False),
        (r"\pi", "letter", "", False),
        ("e^x", "other", "", False),
        ("3", "other", "", False),
        (r"\cdot x", "letter", "*", False),
        ("/x", "letter", "/", False),
        (r"\,x", "letter", "", True),
        ("+x", "", "", False),
        ("=x", "", "", False),
        (")", "", "", False),
        (r"\right)", "", "", False),
        (",x", "", "", False),
        ("", "", "", False),
    ],
)
def test_what_follows_in_a_product(source: str, kind: str, operator: str, spaced: bool) -> None:
    assert _at(source).ahead() == (kind, operator, spaced)


def test_a_differential_ends_an_integrand_only_inside_an_integral() -> None:
    cursor = _at("dx")
    assert cursor.ahead().kind == "letter"
    cursor.integrals = 1
    assert cursor.ahead().kind == ""


@pytest.mark.parametrize(
    ("source", "partner", "listed"),
    [
        ("(x)y", 2, False),
        ("(x,y)", 4, True),
        ("((x,y))", 6, False),
        ("(x", 2, False),
        ("{x(y)}", 5, False),
    ],
)
def test_brackets_have_partners(source: str, partner: int, listed: bool) -> None:
    assert _at(source).partner(0) == partner
    assert _at(source).is_list() is listed


def test_two_readings_are_both_in_the_line() -> None:
    with pytest.raises(InputError) as caught:
        _at("x").two_readings("sin(x*y)", "sin(x)*y" * 100)
    assert "sin(x*y)" in str(caught.value)
    assert len(str(caught.value)) < 400


@pytest.mark.parametrize(
    ("token", "letter", "number"),
    [
        ("x", True, False),
        (r"\alpha", True, False),
        (r"\Delta", True, False),
        (r"\sin", False, False),
        ("1.5", False, True),
        (".5", False, True),
        ("é", False, False),
        ("xy", False, False),
        ("", False, False),
    ],
)
def test_letters_and_numbers(token: str, letter: bool, number: bool) -> None:
    assert is_letter(token) is letter
    assert is_number(token) is number


@pytest.mark.parametrize(
    ("source", "above", "below", "end"),
    [
        (r"\frac{a+b}{c}x", "a + b", "c", 9),
        (r"\frac ab", "a", "b", 3),
        (r"\frac a{bc}", "a", "b c", 6),
        (r"\frac{a{b}}c", "a { b }", "c", 8),
    ],
)
def test_halves_of_a_fraction(source: str, above: str, below: str, end: int) -> None:
    assert _at(source).halves(0) == (above.split(), below.split(), end)


@pytest.mark.parametrize(
    ("source", "sides"),
    [("^+", "^ +"), ("^{-}", "^ { - }"), ("+", "+"), ("-}", "-"), ("+x", ""), ("^2", ""), ("", "")],
)
def test_the_side_that_a_path_comes_from(source: str, sides: str) -> None:
    assert _at(source).sides() == sides.split()


@pytest.mark.parametrize(
    ("source", "name"),
    cases(__file__, "symbols"),
)
def test_symbols(source: str, name: str) -> None:
    assert _at(source).symbol() == name


@pytest.mark.parametrize("source", ["3", "+", r"\sin", "x_12", "x_{a,b}", "x_{-1}", "x_", "x_{a"])
def test_what_is_no_symbol(source: str) -> None:
    with pytest.raises(InputError):
        _at(source).symbol()


@pytest.mark.parametrize("source", ["i", "j", "dx", "sin x", "alpha", "sqrt"])
def test_letters_that_are_no_variable_are_refused(source: str) -> None:
    with pytest.raises(InputError):
        check_name(_at(source))


@pytest.mark.parametrize("source", ["x", "i_1", "d", r"d\cdot x", r"s\,i\,n", "si", r"\alpha"])
def test_letters_that_are_variables_pass(source: str) -> None:
    check_name(_at(source))


def test_reserved_names_step_aside() -> None:
    assert {allowed(name) for name in ("pi", "sin", "x")} == {"pi_", "sin_", "x"}


@pytest.mark.parametrize(
    ("name", "is_one"), [("dy_dx", True), ("partialf_partialx", True), ("d_x", False), ("x", False)]
)
def test_what_is_a_derivative(name: str, is_one: bool) -> None:
    assert is_derivative(Piece(2 * symbol(name) + 1)) is is_one
    assert is_derivative(derived("\\partial", "lambda_", "x"))
