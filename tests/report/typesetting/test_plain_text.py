"""Formulas at the terminal: letters and signs, and brackets wherever a bar took their place."""

import re

import pytest
from cases import cases

from tresym.ledger.paper import all_claims
from tresym.report.typesetting.latex import says_latex
from tresym.report.typesetting.plain_text import in_lines, plain


@pytest.mark.parametrize(
    ("formula", "shown"),
    cases(__file__, "formulas"),
)
def test_formulas(formula: str, shown: str) -> None:
    assert plain(formula) == shown


@pytest.mark.slow
def test_no_command_is_left_in_any_statement() -> None:
    for claim in all_claims():
        for says in (claim.shown, claim.statement, *claim.given):
            if says is not None:
                text = plain(says if isinstance(says, str) else says_latex(says))
                assert not re.search(r"\\|[{}&]", text), (claim.label, text)


@pytest.mark.parametrize(
    ("text", "lines"),
    [
        ("a word and one", ["a word and", "one"]),
        ("x = −34.5 ± 0.05", ["x =", "−34.5 ± 0.05"]),
        ("a+b−c+de+fgh+i", ["a+b−c+de", "+fgh+i"]),
        ("e^(−π√ab)+x", ["e^(−π√ab)", "+x"]),
        ("12345678901234", ["12345678901234"]),
    ],
)
def test_lines_break_where_nothing_is_torn(text: str, lines: list[str]) -> None:
    assert list(in_lines(text, "", "", 10)) == lines
