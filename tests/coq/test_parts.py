"""Claims made of claims in Coq: one theorem for each comparison, two for an equivalence."""

import pytest

from tresym.coq.claim_export import theorems_of_parts
from tresym.coq.statement import NotExportedError, Theorem
from tresym.reals.language.compound import read_compound


def texts(claim: str) -> list[str]:
    whole = read_compound(claim)
    assert whole is not None
    found = theorems_of_parts(whole)
    return [" ".join(one.text.split()) for one in found if isinstance(one, Theorem)]


def test_an_equivalence_is_two_implications() -> None:
    assert texts("x > 1 <=> 2*x > 2 given x > 0") == [
        "Theorem claim_1 : forall x : R, x > 0 -> (* given *) x > 1 -> (* given *) 2 * x > 2.",
        "Theorem claim_2 : forall x : R, x > 0 -> (* given *) 2 * x > 2 -> (* given *) x > 1.",
    ]


def test_a_conjunction_has_the_conditions_of_its_parts() -> None:
    assert texts("(x > 0 given x > 1) and x**2 >= 0") == [
        "Theorem claim_1 : forall x : R, x > 1 -> (* given *) x > 0.",
        "Theorem claim_2 : forall x : R, x ^ 2 >= 0.",
    ]


@pytest.mark.parametrize("claim", ["exactly one x in (0, 1): x == 1/2"])
def test_what_is_not_exported_is_refused(claim: str) -> None:
    with pytest.raises(NotExportedError):
        texts(claim)
