"""Names: letters with subscripts, and what is refused because it is no real variable."""

from __future__ import annotations

import pytest

from tresym.reals.language.expression import symbol
from tresym.reals.language.latex_cursor import Author
from tresym.reals.language.latex_names import Names, allowed, derived, is_derivative
from tresym.reals.language.latex_reach import Piece
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.numbers.exact import InputError


def _at(source: str, author: Author | None = None) -> Names:
    return Names(tokenize(source), author)


@pytest.mark.parametrize(
    ("source", "name"),
    [
        ("x", "x"),
        ("x_1", "x1"),
        ("x_{12}", "x12"),
        ("x_a", "x_a"),
        (r"\psi_{in}", "psi_in"),
        (r"\omega_\perp", "omega_perp"),
        (r"\Delta\psi", "Delta_psi"),
        (r"\lambda", "lambda_"),
        ("E", "E_"),
        ("I", "I_"),
        ("I_1", "I1"),
    ],
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
        _at(source).check_name()


@pytest.mark.parametrize("source", ["x", "i_1", "d", r"d\cdot x", r"s\,i\,n", "si", r"\alpha"])
def test_letters_that_are_variables_pass(source: str) -> None:
    _at(source).check_name()


def test_derivatives_of_an_author_are_symbols_and_nobody_elses() -> None:
    assert _at("dy/dx", Author()).inline_derivative()
    assert not _at("y/x").inline_derivative()
    assert _at("dy/dx", Author()).slashed_derivative().tree == symbol("dy_dx")
    assert _at(r"\dot{\psi}").dotted().tree == symbol("dpsi_dt")
    with pytest.raises(InputError):
        _at("dy/dx").slashed_derivative()


def test_reserved_names_step_aside() -> None:
    assert {allowed(name) for name in ("pi", "sin", "x")} == {"pi_", "sin_", "x"}


@pytest.mark.parametrize(
    ("name", "is_one"), [("dy_dx", True), ("partialf_partialx", True), ("d_x", False), ("x", False)]
)
def test_what_is_a_derivative(name: str, is_one: bool) -> None:
    assert is_derivative(Piece(2 * symbol(name) + 1)) is is_one
    assert is_derivative(derived("\\partial", "lambda_", "x"))
