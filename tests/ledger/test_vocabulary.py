"""The words of a proof: each is used, none stands for two things."""

import re
from importlib import import_module
from pathlib import Path

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


def test_a_proof_uses_each_word() -> None:
    assert [word for word in vocabulary.__all__ if not re.search(rf"\b{word}\b", WRITTEN)] == []


def test_no_part_gives_a_word_another_meaning() -> None:
    for part in PARTS:
        bound = vars(import_module(f"tresym.proofs.{part}"))
        for word in vocabulary.__all__:
            meant = getattr(vocabulary, word)
            assert bound.get(word, meant) is meant, (part, word)


def test_a_symbol_of_the_notation_is_exported() -> None:
    symbols = {name for name, value in vars(notation).items() if isinstance(value, Symbol)}
    assert symbols == {*notation.__all__}
