"""The page of symbols: a line for each, and nothing assumed that is not named."""

import re
from collections.abc import Callable

import pytest
from derivations import by
from sympy import Symbol
from sympy_statements import equal

from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.definitions import table
from tresym.ledger.finding import Premise
from tresym.ledger.paper import all_claims
from tresym.ledger.verification import Report
from tresym.racket.notation import WORDS, WORDS_OF_PROOFS
from tresym.report.pages.ledger_document import ledger_document
from tresym.report.pages.symbols import anchor, as_used, rows, symbols, used
from tresym.report.typesetting.titles import shown_name
from tresym.site.claims import page


def test_every_definition_and_every_assumption_has_its_line(judged: Callable[..., Report]) -> None:
    report = judged("d24", "eq_gamma", "unturned_decrease")
    defined, assumed = symbols(report).split("## Physical assumptions")
    for row in report.rows:
        entries = table((row.claim,))
        if row.finding.verdict is Premise.ASSUMED:
            assert f"{row.claim.proof.assumes} | `{shown_name(row.claim.label)}`" in assumed
            assert f"`{shown_name(row.claim.label)}`" not in defined
        elif entries:
            assert defined.count(f"| `{shown_name(row.claim.label)}`") == len(entries)
        else:
            assert f"`{shown_name(row.claim.label)}`" not in defined + assumed
    lines = [line for line in (defined + assumed).splitlines() if line.startswith(("| $", "| <"))]
    assert lines
    assert all(line.count("|") in (5, 6) for line in lines)
    assert r"\mathtt" not in defined + assumed


def test_every_symbol_with_words_has_a_line_and_is_not_defined_in_other_words(
    judged: Callable[..., Report],
) -> None:
    page = symbols(judged("eq_gamma"))
    for name, words in WORDS.items():
        assert words
        assert f'<span id="{anchor(name)}"></span>' in page or any(
            row.name == name and row.entry for row in rows()
        )


def test_no_symbol_that_is_defined_lacks_words() -> None:
    assert [row.name for row in rows() if row.entry and not (row.words or row.own)] == []
    assert not {*WORDS} & {*WORDS_OF_PROOFS}


@pytest.mark.parametrize("name", ["kappa", "S", "epsilon0", "epsilon_pi", "epsilon_4", "lambda"])
def test_the_symbols_that_readers_ask_for_are_definitions(name: str) -> None:
    found = [row for row in rows() if row.name == name]
    assert found
    assert all(row.words and row.entry and row.meaning and row.given for row in found)


NAMED = {
    "eq_gamma": {"I1", "M", "theta", "psi", "a", "b", "gamma"},
    "repaired": {"epsilon0", "epsilon_star"},
    "second_order": {"epsilon0", "epsilon_star", "c1"},
    "one_line": {"epsilon0", "epsilon_pi"},
    "sign_squared": {"S"},
}


@pytest.mark.parametrize("label", NAMED)
def test_what_a_claim_uses_is_found_in_formulas_and_in_words(label: str) -> None:
    claims = {claim.label: claim for claim in all_claims()}
    assert {*used(claims[label])} >= NAMED[label]


def test_letters_are_told_apart() -> None:
    x = Symbol("x", real=True)

    def spoken(text: str) -> set[str]:
        return {*used(Claim("one", text, by(), given=()))}

    assert spoken("A flip of ε₀ is small.") == {"epsilon0"}
    assert spoken("bε₀ and c₁ε*² are.") == {"epsilon0", "c1", "epsilon_star"}
    assert spoken("Some motions start at a body.") == set()
    assert spoken("ε′ of it.") == set()
    assert used(Claim("one", equal(x, x), by())) == ["x"]


def test_the_page_of_a_claim_links_its_symbols(judged: Callable[..., Report]) -> None:
    claims = {claim.label: claim for claim in all_claims()}
    found = as_used(claims["repaired"])
    assert all(re.fullmatch(r"symbol-[\w-]+", symbol["anchor"]) for symbol in found)
    from tresym.report.pages.site_data import record

    ledger = record(judged("eq_gamma"))
    text = page("eq_gamma", ledger, None, None)
    assert '<a href="../pages/symbols.html#symbol-gamma">γ</a>' in text
    assert "[Symbols](/pages/symbols.md): " in text


def test_the_ledger_begins_with_the_symbols(judged: Callable[..., Report]) -> None:
    text = ledger_document(judged("eq_gamma"))
    assert text.index(r"\section{Notation}") < text.index(r"\label{claim:eq_gamma}")
    assert r"$\gamma$ & level of the motion" in text
