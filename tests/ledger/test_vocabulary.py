"""The words of a proof: none stands for two things."""

from importlib import import_module

from sympy import Symbol
from tresym.proofs import PARTS

from tresym.ledger import vocabulary
from tresym.ledger.paper import racket
from tresym.racket import notation


def test_the_words_and_the_symbols_are_told_apart() -> None:
    words = [*vocabulary.__all__, *notation.__all__]
    assert len(words) == len({*words})
    assert {*vocabulary.__all__} <= {*vars(vocabulary)}
    assert {*notation.__all__} <= {*vars(notation)}


def test_no_part_gives_a_word_another_meaning() -> None:
    for part in PARTS:
        if racket().source_of(part).suffix != ".py":
            continue
        bound = vars(import_module(f"tresym.proofs.{part}"))
        for word in vocabulary.__all__:
            meant = getattr(vocabulary, word)
            assert bound.get(word, meant) is meant, (part, word)


def test_a_symbol_of_the_notation_is_exported() -> None:
    symbols = {name for name, value in vars(notation).items() if isinstance(value, Symbol)}
    assert symbols == {*notation.__all__}
