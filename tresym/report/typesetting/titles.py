"""The title of every claim, from a file or made from its label."""

from __future__ import annotations

import re
from collections.abc import Mapping

from tresym.ledger.paper import racket

_OBJECT = {"str": "standard racket", "book": "book"} | {
    f"racket_{n}": f"racket {n}" for n in (1, 2, 3)
}
_CELL = re.compile(
    rf"table_({'|'.join(_OBJECT)})_(a|b|epsilon0|flip|order|realizable)(_formula|_from_epsilon0)?"
)
_CELLS = {
    "a": "a", "b": "b", "epsilon0": "ε₀", "flip": "the flip", "order": "the order of the moments",
    "realizable": "the moments of a rigid body",
}  # fmt: skip
_BY = {None: "", "_formula": " by the formula", "_from_epsilon0": " from the printed ε₀"}
_RANGE = re.compile(r"(repaired|second_order)_from_(\d+)(?:_(\d+))?")
_SHARP = "_too_small"
_LETTERS = {
    "epsilon0": "ε₀", "epsilon": "ε", "eps0": "ε₀", "gamma": "γ", "psi": "ψ", "theta": "θ",
    "kappa": "κ", "lambda": "λ", "mu": "μ", "pi": "π", "e1": "e₁", "e2": "e₂", "e3": "e₃",
    "newton": "Newton",
}  # fmt: skip


def by_hand() -> Mapping[str, str]:
    """Return the titles from titles.txt beside the proofs, by label."""
    return racket().titles


def shown_name(label: str) -> str:
    """Return the readable name of a claim, which commands accept as its label."""
    return racket().name_of(label)


def title(label: str) -> str:
    """Return the title of a claim, without a full stop."""
    found = by_hand().get(label)
    if found:
        return found
    if label.endswith(_SHARP):
        whole = title(label.removesuffix(_SHARP))
        return f"A smaller constant fails: {whole[:1].lower()}{whole[1:]}"
    if cell := _CELL.fullmatch(label):
        return f"Table 1, {_OBJECT[cell[1]]}: {_CELLS[cell[2]]}{_BY[cell[3]]}"
    if bound := _RANGE.fullmatch(label):
        least = bound[2] + (f"/{bound[3]}" if bound[3] else "")
        return f"{title(bound[1])} from a = {least}"
    words = " ".join(_LETTERS.get(word, word) for word in label.split("_"))
    return words[:1].upper() + words[1:] if words[0].isascii() else words
