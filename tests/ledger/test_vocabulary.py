"""The words of a proof: each is used, none stands for two things."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path

import pytest
from sympy import Symbol
from tresym.proofs import PARTS

from tresym.ledger import vocabulary
from tresym.racket import notation

PROOFS = Path(__file__).resolve().parents[2] / "proofs"
WRITTEN = "\n".join(path.read_text(encoding="utf-8") for path in PROOFS.glob("*.py"))


def test_the_words_and_the_symbols_are_told_apart() -> None:
    words = [*vocabulary.__all__, *notation.__all__]
    assert len(words) == len({*words})
    assert {*vocabulary.__all__} <= {*vars(vocabulary)}
    assert {*notation.__all__} <= {*vars(notation)}


@pytest.mark.parametrize("word", vocabulary.__all__)
def test_a_proof_uses_the_word(word: str) -> None:
    assert re.search(rf"\b{word}\b", WRITTEN)


@pytest.mark.parametrize("part", PARTS)
def test_a_part_gives_no_word_another_meaning(part: str) -> None:
    bound = vars(import_module(f"tresym.proofs.{part}"))
    for word in vocabulary.__all__:
        assert bound.get(word, getattr(vocabulary, word)) is getattr(vocabulary, word), word


def test_a_symbol_of_the_notation_is_exported() -> None:
    symbols = {name for name, value in vars(notation).items() if isinstance(value, Symbol)}
    assert symbols == {*notation.__all__}
