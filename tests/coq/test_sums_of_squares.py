"""Polynomials as sums of squares: what is found adds up, and falsehoods have no certificate."""

from fractions import Fraction

import pytest

from tresym.coq.claim_export import theorems
from tresym.coq.linear_dependence import expanded
from tresym.coq.sums_of_squares import certificate, conditions, nonnegative, square_proofs
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.parsing import parse


@pytest.mark.parametrize(
    ("claim", "squared"),
    [
        ("a**4 + b**4 + c**4 + d**4 >= 4*a*b*c*d", {"c*d - a*b"}),
        ("(a*x + b*y)**2 <= (a**2 + b**2)*(x**2 + y**2)", {"b*x - a*y"}),
        ("a*b*(a + b) <= a**3 + b**3 given a + b >= 0", {"b - a"}),
    ],
)
def test_squares_that_are_found(claim: str, squared: set[str]) -> None:
    (theorem,) = theorems(read(claim))
    d = theorem.left - theorem.right
    d = d if theorem.relation == ">=" else -d
    found = next(filter(None, (certificate(expanded(d), conditions(theorem), n) for n in range(2))))
    assert squared <= {str(base) for _, base in found}


@pytest.mark.parametrize("text", ["x**2 + y**2 - 2*x*y - z**2", "x**4 - x**2", "-1"])
def test_falsehoods_have_none(text: str) -> None:
    assert certificate(expanded(parse(text)), [], 0) is None


def test_a_linear_program() -> None:
    one, two = Fraction(1), Fraction(2)
    assert nonnegative([[one, two], [one, -one]], [two, -one]) == [0, one]
    assert nonnegative([[one, two], [one, -one]], [two, two * 2]) is None


def test_a_strict_sign_is_shown_strictly() -> None:
    (theorem,) = theorems(read("a/(a + b) < 1 given a > 0, b > 0"))
    (proof,) = square_proofs(theorem, theorem.right - theorem.left, strict=True)
    assert "Rdiv_lt_0_compat" in proof
