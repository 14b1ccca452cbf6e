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
        ("f == O(x) as x ->", "has no end"),
        ("exp(x) approx 1", "<= 0.005"),
        ("x +", "after its last sign"),
        ("not x", "contrary"),
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


SUGGESTED = [
    ("x*y > 0 given x > 0 y > 0", "x*y > 0 given x > 0, y > 0"),
    ("exp(x) approx 1 + x", "abs(exp(x) - (1 + x)) <= 0.005 given abs(x) <= 0.05"),
    ("max(x) > 0", "max(x, 1) > 0"),
    ("int(x**2, 0, 1) == 1/3", "integral(x**2, x, 0, 1) == 1/3"),
    ("erfinv(x) > 0 given x > 0", "y > 0 given erf(y) == x, x > 0"),
    ("1 > oo", "x -> oo as x -> oo"),
    ("K natural", "n > 0 given n integer, n >= 1"),
    ("n!! > 0", "factorial2(2*m - 1) > 0 given m integer, m > 0"),
    ("tan^-1(x) < 2", "atan(x) < 2"),
    ("lambda > 0", "lambda_ > 0"),
]
"""What is refused, and what its message advises, filled in for the example."""


@pytest.mark.parametrize(("wrong", "right"), SUGGESTED)
def test_what_is_advised_can_be_read(wrong: str, right: str) -> None:
    import tresym

    with pytest.raises(tresym.InputError):
        tresym.check(wrong)
    assert tresym.check(right, limit=1).verdict
