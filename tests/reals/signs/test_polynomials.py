"""Polynomials at a point of every open cell: what is proved, and what each projection is for."""

from __future__ import annotations

import pytest
from flint import fmpq

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import Expr
from tresym.reals.signs import polynomials
from tresym.reals.signs.polynomials import cells, sign_of_polynomial


def parts(text: str) -> tuple[Expr, str, Given]:
    """The difference, its relation to zero, and the conditions."""
    statement = read(text)
    (claim,) = statement.comparisons
    return claim.left - claim.right, claim.relation, statement.given


@pytest.mark.parametrize(
    "text",
    [
        "(x**2 + y**2 + z**2)**2 >= 3*(x**3*y + y**3*z + z**3*x)",
        "x**2*y**2*(x**2 + y**2 - 1) >= -1/27",
        "a/(b + c) + b/(c + d) + c/(d + a) + d/(a + b) >= 2 given a > 0, b > 0, c > 0, d > 0",
        "x**4 - 6*x**3*y + 11*x**2*y**2 - 6*x*y**3 + y**4 >= 0",
        "(x**2 - 2*y**2)**2 + (x*y - 3)**2 > 0 given x > 10",
        "x**6 - 3*x**4 + 3*x**2 > -1/1000",
        "1/(x**2 + y**2) >= 0",
        "y - x >= 0 given y >= 5, x <= 5",
        "x + y >= 0 given x >= 0, y >= 0, x != y",
    ],
)
def test_what_is_proved(text: str) -> None:
    assert sign_of_polynomial(*parts(text)) is not None


@pytest.mark.parametrize(
    "text",
    [
        "1 - x*y >= 0",  # false only where the leading coefficient in y is not 0
        "(x - 5)**2 + y**2 - 4 >= 0",  # false only between zeros of the discriminant
        "y - x >= 0 given y >= 5",  # false only beyond the zero of the resultant
        "x >= 0 given x != 0",
        "1/x + y**2 >= 0",
        "x**2/y >= 0",
        "x*y*z*w >= 0 given x > 0, y > 0, z > 0",
        "(x - 1000)**2*(x - 1001) >= 0 given x >= 1000.5, x <= 1001",
        "(x**2 - 2)**2 + (y - 3)**2 >= 1e-9",
    ],
)
def test_what_is_false_has_a_point_against_it(text: str) -> None:
    difference, relation, given = parts(text)
    found = cells(difference, given)
    assert found is not None
    assert found.against is not None
    assert sign_of_polynomial(difference, relation, given) is None


@pytest.mark.parametrize(
    "text",
    [
        "(x**2 - 2)**2 + y**2 > 0",
        "(x*y - 1)**2 + x**2 > 0",
        "x != 0 given x > 1",
        "x >= 5 given x**2 + 1 <= 0",
        "sqrt(x) + 1 >= 0",
        "x**2 + pi >= 0",
        "x**2 + sin(y) >= 0",
        "a**2 + b**2 + c**2 + d**2 + e**2 >= 0",
    ],
)
def test_what_is_not_proved(text: str) -> None:
    assert sign_of_polynomial(*parts(text)) is None


def test_it_gives_up_beyond_its_bound(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(polynomials, "MAX_CELLS", 0)
    assert sign_of_polynomial(*parts("x**4 + y**4 + x*y*(x - 3*y) >= -100 given x + y > 7")) is None


@pytest.mark.parametrize("least", [fmpq(0), fmpq(-1, 10**6)])
def test_a_least_value_that_is_not_positive_shows_nothing(
    least: fmpq, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(polynomials, "_least", lambda *_: least)
    (claim,) = read("(x*y - 1)**2 + (x - y)**2 > 0", "").comparisons
    assert sign_of_polynomial(claim.left, ">", Given()) is None
