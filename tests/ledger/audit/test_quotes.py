"""Quotes: their lines by hash, their words in order, and both missed where they are altered."""

import json
from dataclasses import replace
from pathlib import Path

import pytest
from cases import cases

from tresym.ledger.audit.quotes import Quote, load_quotes
from tresym.ledger.audit.source import hash_of
from tresym.ledger.paper import all_claims, corrections, file_of, quotes
from tresym.reals.numbers.exact import InputError

PAPER = "one\nThe flip is $\\arcsin(x)$ % always\nand 0.23 of a turn, 170 times\ntwo"
LINES = PAPER.split("\n")
QUOTE = Quote("c", "The flip is arcsin x, and 0.23 of a turn", 2, 3, hash_of(LINES[1:3]))


def test_a_quote_is_found_where_it_was_taken_from_or_has_moved_to() -> None:
    assert QUOTE.line_in(PAPER) == 2
    assert QUOTE.lost(PAPER) is None
    assert QUOTE.line_in("more\n" + PAPER) == 3
    assert QUOTE.lost("more\n" + PAPER) is None
    assert QUOTE.line_in(PAPER.replace("% always", "% never").replace(" of a", "  of a")) == 2


@pytest.mark.parametrize(("old", "new"), [("0.23", "0.24"), ("flip", "turn"), ("arcsin", "arccos")])
def test_altered_lines_are_noticed(old: str, new: str) -> None:
    assert QUOTE.line_in(PAPER.replace(old, new)) is None


@pytest.mark.parametrize(
    ("text", "lost"),
    cases(__file__, "other_words_are_noticed"),
)
def test_other_words_are_noticed(text: str, lost: str | None) -> None:
    assert replace(QUOTE, text=text).lost(PAPER) == lost


def test_of_every_quote_it_is_kept_from_which_lines_it_was_taken(tmp_path: Path) -> None:
    texts = quotes(all_claims())
    assert {c.labels[0] for c in corrections()} < {*texts}
    index = file_of("index.json")
    assert [q.label for q in load_quotes(index, texts)] == [*texts]
    assert {item["label"] for item in json.loads(index.read_text())["quotes"]} == {*texts}
    with pytest.raises(InputError, match="does not list the source lines of the quotation in c"):
        load_quotes(index, {"c": "words"})
