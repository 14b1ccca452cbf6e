"""The paper's symbols: one name each, and one way to write each."""

import pytest
from cases import cases

from tresym.racket import notation
from tresym.reals.language.expression import Expr
from tresym.report.typesetting.latex import expression_latex

SYMBOLS = {name: x for name, x in vars(notation).items() if isinstance(x, Expr)}


def test_no_two_names_stand_for_one_symbol() -> None:
    assert len(set(SYMBOLS.values())) == len(SYMBOLS)


def test_every_symbol_is_exported() -> None:
    assert {*SYMBOLS} == {*notation.__all__}
    assert {x.op for x in SYMBOLS.values()} == {"symbol"}


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
