"""Expansions that are found and certified, and the true expansion instead of a refuted one."""

from __future__ import annotations

import json

import pytest
from cases import cases

import tresym
from tresym.accuracy.expansion import expand
from tresym.commands import main
from tresym.reals.numbers.exact import InputError

# Coefficients from DLMF 4.19, 4.24, 24.2 and by series reversion.
KNOWN = [
    ("tan(x)", "", "x -> 0", 3, ("x", "x**3/3", "2*x**5/15"), "x**7"),
    ("x/(exp(x) - 1)", "", "x -> 0", 4, ("1", "-x/2", "x**2/12", "-x**4/720"), "x**6"),
    ("asinh(x)", "", "x -> oo", 3, ("log(x)", "log(2)", "x**(-2)/4"), "x**(-4)"),
    ("sqrt(x)", "", "x -> 4", 3, ("2", "(x - 4)/4", "-(x - 4)**2/64"), "(x - 4)**3"),
    ("y", "y**5 + e*y == 1, y > 0", "e -> 0", 3, ("1", "-e/5", "-e**2/25"), "e**3"),
    ("y", "y**3 - u*y**2 + u == 0, y > 2", "u -> oo", 2, ("u", "-1/u"), "u**(-3)"),
    ("root(w*exp(w) - x, w, -1, oo)", "", "x -> 0+", 3, ("x", "-x**2", "3*x**3/2"), "x**4"),
    ("y", "y**3 + y**4 == e, y > 0", "e -> 0+", 2, ("e**(1/3)", "-e**(2/3)/3"), "e"),
]


@pytest.mark.parametrize(("exact", "given", "path", "count", "terms", "gauge"), KNOWN)
@pytest.mark.slow
def test_expansions_are_found_and_certified(
    exact: str, given: str, path: str, count: int, terms: tuple[str, ...], gauge: str
) -> None:
    found = expand(exact, path, count, given)
    assert found.terms == terms
    assert found.gauge == gauge
    assert found.answer
    assert found.answer.constant is not None


IMPLICIT = [
    ("integral(exp(-x*t)/(1 + t), t, 0, oo)", "", "x -> oo", 2, ("1/x", "-x**(-2)"), "x**(-3)"),
    ("sum(1/k, k, 1, n)", "", "n -> oo", 2, ("log(n)", "EulerGamma"), "1/n"),
    ("lambertw(x)", "", "x -> oo", 2, ("log(x)", "-log(log(x))"), "log(log(x))/log(x)"),
    ("x", "x**n == 1 + x, x > 1, n > 0", "n -> oo", 2, ("1", "log(2)/n"), "n**(-2)"),
    (
        "a(n)",
        "a(n + 1) == sin(a(n)), a(0) == 1",
        "n -> oo",
        1,
        ("sqrt(3)*sqrt(1/n)",),
        "log(n)*(1/n)**(3/2)",
    ),
]


@pytest.mark.parametrize(("exact", "given", "path", "count", "terms", "gauge"), IMPLICIT)
def test_integrals_sums_roots_and_sequences_are_expanded(
    exact: str, given: str, path: str, count: int, terms: tuple[str, ...], gauge: str
) -> None:
    found = expand(exact, path, count, given)
    assert found.terms == terms
    assert found.gauge == gauge
    assert found.answer
    assert found.as_latex()


def test_solutions_of_differential_equations_are_not_expanded() -> None:
    with pytest.raises(InputError, match="differential equations"):
        expand("y(t)", "e -> 0", 2, "diff(y(t), t) == e*y(t), y(0) == 1")


def test_a_finite_expansion_is_an_identity() -> None:
    found = expand("(x + 1)**2", "x -> oo", 4)
    assert found.gauge == ""
    assert found.answer.verdict.value == "PROVED"


@pytest.mark.parametrize(
    ("exact", "path", "given"),
    [
        ("sin(1/x)", "x -> 0+", ""),
        ("y", "e -> 0+", "y**2 == e"),
        ("y", "e -> 0+", "y**2 == -1 - e"),
        ("x + y", "(x, y) -> (0, 0)", ""),
    ],
)
def test_without_an_expansion_the_input_is_refused(exact: str, path: str, given: str) -> None:
    with pytest.raises(InputError):
        expand(exact, path, 3, given)


def test_the_command(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(["expand", "tan(x)", "--as", "x -> 0+", "--terms", "2", "--json"]) == 0
    shown = json.loads(capsys.readouterr().out)
    assert shown["terms"] == ["x", "x**3/3"]
    assert shown["claim"]["verdict"] == "ENCLOSED"
    assert main(["expand", "tan(x)", "--as", "x -> 0+", "--format", "latex"]) == 0
    assert r"\frac{x^{3}}{3}" in capsys.readouterr().out


@pytest.mark.parametrize(
    ("claim", "instead"),
    cases(__file__, "the_right_coefficient_comes_first"),
)
def test_the_right_coefficient_comes_first(claim: str, instead: str) -> None:
    assert tresym.check(claim).instead[0].claim == instead
