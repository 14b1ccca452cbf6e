"""Names: letters with subscripts, and what is refused because it is no real variable."""

from __future__ import annotations

import pytest

from tresym.reals.language.latex_names import Names, allowed, is_derivative
from tresym.reals.language.latex_tokens import tokenize
from tresym.reals.numbers.exact import InputError


def _at(source: str, author: bool = False) -> Names:
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
    assert _at("dy/dx", author=True).inline_derivative()
    assert not _at("y/x").inline_derivative()
    assert _at("dy/dx", author=True).slashed_derivative().text == "dy_dx"
    assert _at(r"\dot{\psi}").dotted().text == "dpsi_dt"
    with pytest.raises(InputError):
        _at("dy/dx").slashed_derivative()


@pytest.mark.parametrize(
    ("source", "name", "applied"),
    [
        ("(x)", "y", True),
        ("(x,1)", "y", True),
        ("(x+1)", "y", False),
        ("(x+1)", "f", True),
        ("(2)", "y", False),
    ],
)
def test_a_bracket_that_may_hold_an_argument(source: str, name: str, applied: bool) -> None:
    names = _at(source)
    assert names.is_application(name) is applied
    assert names.at == 0


def test_reserved_names_step_aside() -> None:
    assert {allowed(name) for name in ("pi", "sin", "x")} == {"pi_", "sin_", "x"}


@pytest.mark.parametrize(
    ("text", "derived"),
    [("dy_dx", True), ("2*dpsi_dt + 1", True), ("partialf_partialx", True), ("d_x", False)],
)
def test_what_is_a_derivative(text: str, derived: bool) -> None:
    assert is_derivative(text) is derived
