"""The paper's symbols: one name each, real and nothing more, and one way to write each."""

import pytest
from cases import cases
from sympy import Symbol

from tresym.racket import notation
from tresym.report.typesetting.latex import expression_latex

SYMBOLS = {name: x for name, x in vars(notation).items() if isinstance(x, Symbol)}


def test_no_two_names_stand_for_one_symbol() -> None:
    assert len(set(SYMBOLS.values())) == len(SYMBOLS)
    assert len({x.name for x in SYMBOLS.values()}) == len(SYMBOLS)


def test_a_symbol_is_real_and_its_sign_is_left_to_the_claims() -> None:
    for x in SYMBOLS.values():
        assert x.is_real is True
        assert x == Symbol(x.name, real=True)
        for assumed in (x.is_zero, x.is_positive, x.is_negative, x.is_integer):
            assert assumed is None, x
        assert (x**2) ** (x**0 / 2) == abs(x) != x


def test_every_symbol_is_written_in_its_own_way() -> None:
    written = [expression_latex(x) for x in SYMBOLS.values()]
    assert len(set(written)) == len(written)
    for text in written:
        assert text.count("{") == text.count("}")


@pytest.mark.parametrize(
    ("name", "text"),
    cases(__file__, "as_the_paper_writes_them"),
)
def test_as_the_paper_writes_them(name: str, text: str) -> None:
    assert expression_latex(SYMBOLS[name]) == text
