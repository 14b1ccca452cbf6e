"""Advice names what was meant, and is silent where nothing is wrong."""

import pytest
from cases import cases

from tresym.reals.language.expression import FUNCTIONS
from tresym.reals.language.suggestions import MAX_TEXT, about_function, about_name, hint

KNOWN = FUNCTIONS | {"sqrt"}


@pytest.mark.parametrize(
    ("text", "keyword"),
    [
        ("2x", "2*x"),
        ("x y", "x*y"),
        ("(x) y", "*"),
        ("3 (x + 1)", "*"),
        ("sin x", "sin(x)"),
        ("sin**2(x)", "sin(x)**2"),
        ("n! + 1", "factorial"),
        ("d/dx f", "diff"),
        ("f'(x)", "diff"),
        ("x ^^ 2", "**"),
        ("a => b", ">="),
        ("a =< b", "<="),
        ("a <> b", "!="),
        ("a := b", "=="),
        ("x = 1", "condition"),
        ("= 3", "missing"),
        ("x >", "missing"),
        ("x given", "missing"),
        ("given x > 0", "missing"),
        ("x for x > 0", "given"),
        ("50%", "fraction"),
        ("x; y", "commas"),
        ("x && y", "commas"),
        ("x -> 0", "as"),
        ("[x]", "parentheses"),
        ("lambda + 1", "lambda_"),
        ("(x", "character 1 is not closed"),
        ("(x))", "character 4 was not opened"),
        ("((x)", "character 1 is not closed"),
    ],
)
def test_advice(text: str, keyword: str) -> None:
    found = hint(text, KNOWN)
    assert keyword in found
    assert found.startswith(" (")
    assert "\n" not in found


@pytest.mark.parametrize("text", ["2*x", "x + 1", "sin(x)**2", "a >= b", "1.5*x", "log2"])
def test_nothing_is_said_of_what_is_well_written(text: str) -> None:
    assert hint(text, KNOWN) == ""


@pytest.mark.parametrize("text", ["(" * 10**6, "x " * 10**6, "a=" * 10**5, ")" + "1" * 10**6])
def test_long_text_is_answered_briefly(text: str) -> None:
    assert len(hint(text, KNOWN)) < 2 * MAX_TEXT


@pytest.mark.parametrize(
    ("name", "keyword"),
    cases(__file__, "functions_that_are_not_known"),
)
def test_functions_that_are_not_known(name: str, keyword: str) -> None:
    assert keyword in about_function(name, KNOWN)


def test_a_function_without_its_argument() -> None:
    assert "sin(x)" in about_name("sin")
