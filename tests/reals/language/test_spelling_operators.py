"""Derivatives, integrals, sums and limits as they are typed."""

import pytest
from cases import cases

from tresym.reals.language.parsing import as_written
from tresym.reals.language.spelling import Speller
from tresym.reals.language.spelling_tokens import tokens
from tresym.reals.numbers.exact import InputError


@pytest.mark.parametrize(
    ("typed", "meant"),
    cases(__file__, "typed_operators"),
)
def test_typed_operators(typed: str, meant: str) -> None:
    speller = Speller(tokens(typed)[1])
    found = speller.sum()
    assert speller.at == len(speller.tokens)
    assert as_written(found) == as_written(meant)


@pytest.mark.parametrize(
    "typed",
    ["sum_(k=1)^n k + 1", "lim x->0 x + 1", "d/dx x + 1", "d/dx (x^2) x", "dy/dx", "d^2y/dx^2"],
)
def test_how_far_an_operator_reaches_is_not_guessed(typed: str) -> None:
    with pytest.raises(InputError):
        Speller(tokens(typed)[1]).sum()
