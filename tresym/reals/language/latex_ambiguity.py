"""What print leaves open: letters, brackets and powers that can be meant in two ways.

In ``x(x + 1)`` the bracket is a factor; in ``V(2r)`` it may hold the argument of a function V, and
in ``[x]`` it may be an integer part. Here is told which of them are in doubt.
"""

from __future__ import annotations

from tresym.reals.language.expression import symbols
from tresym.reals.language.latex_cursor import (
    BRACKETS,
    INSTEAD,
    OPENING,
    Cursor,
    is_letter,
)
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import (
    FUNCTIONS,
    GREEK,
    LETTERS_OF_FUNCTIONS,
    RELATIONS,
    STOPS,
    Spaced,
)

FORCES = frozenset(("F", "G"))
"""Letters of functions that are also usual for numbers."""
WORDS = sorted((*FUNCTIONS, "sqrt", *(g for g in GREEK if len(g) > 3)), key=len, reverse=True)


def check_name(cursor: Cursor) -> None:
    """Refuse letters that are no variable of the author's."""
    token = cursor.peek()
    counts = cursor.counting or token in cursor.indices or cursor.peek(1) == "_"
    counts = counts or (token == "i" and cursor.author is not None and cursor.author.imaginary)
    if token in ("i", "j") and not counts:
        cursor.refuse(INSTEAD["\\imath"])
    if token == "d" and is_letter(cursor.peek(1)):
        cursor.refuse(
            "d before a letter is a differential: write \\frac{d}{dx} (…) for a derivative, "
            "d\\cdot x for a product,"
        )
    for name in WORDS:
        letters = cursor.tokens[cursor.at : cursor.at + len(name)]
        if letters == list(name) and not any(isinstance(x, Spaced) for x in letters[1:]):
            apart = "\\,".join(name)
            cursor.refuse(f"letters in a row are a product: write \\{name}, or {apart},")


def check_bracket(cursor: Cursor, opening: str, inner: Piece, start: int) -> None:
    """Refuse braces and square brackets that may be a fractional or an integer part.

    They are brackets where they hold another bracket, and square ones where a product or a
    power needs them.
    """
    inside = cursor.tokens[start + 1 : cursor.at - 1]
    if {*inside} & {"(", "[", "\\{", "\\left|", "\\frac", "\\sqrt", "\\dfrac", "\\tfrac"}:
        return
    before = cursor.tokens[start - 1] if start else ""
    free = before in ("", "+", *OPENING, *RELATIONS, *STOPS) and not cursor.continues()
    factor = 1 < inner.strength < 4 and before != "}"
    lone = len(inside) == 1 or factor or (free and inner.strength < 2)
    if opening == "\\{" or (lone and cursor.peek() != "^") or len(inside) == 1:
        what = {"\\{": "a fractional part or a set", "[": "an integer part"}[opening]
        close = BRACKETS[opening].removeprefix("\\")
        shown = f"{opening.removeprefix(chr(92))}{inner.tree}{close}"
        cursor.refuse(f"{shown} may be {what}: write round brackets,")


def check_power_of_e(cursor: Cursor, exponent: Piece) -> None:
    """Refuse a power of the letter e that may be the exponential function."""
    if symbols(exponent.tree) or exponent.tree.op != "number":
        cursor.two_readings(f"exp({exponent.tree})", f"e**({exponent.tree}) of the variable e")


def is_product(cursor: Cursor, name: str, inner: Piece) -> bool:
    """Whether a bracket behind a symbol can be nothing but a factor."""
    raised = cursor.peek() == "^" and 1 < inner.strength < 4
    if name in LETTERS_OF_FUNCTIONS - FORCES or not cursor.author:
        return name not in LETTERS_OF_FUNCTIONS and (inner.strength == 0 or raised)
    lower = len(name) == 1 and name.islower()
    if cursor.tokens[cursor.at - 3 : cursor.at : 2] == ["[", "]"]:
        return False  # d[n], a value in a list
    if name in cursor.author.numbers:
        return True
    if name in inner.names:
        return lower or inner.strength == 0
    if name in cursor.author.applied:
        return False
    if lower:
        return inner.strength < 2 or raised
    return (inner.strength == 0 or raised) and (name == "pi" or name in cursor.author.bare)


_COEFFICIENTS = frozenset("ABCDKabck")


def _is_own_factor(cursor: Cursor) -> bool:
    """Whether the letter before the bracket here stands in it as a number: R(1 - R²) is a product;
    f(f(x)) is none."""
    letter, inside = cursor.tokens[cursor.at - 1], cursor.tokens[cursor.at + 1 :]
    inside = inside[: cursor.partner(cursor.at) - cursor.at - 1]
    places = [n for n, token in enumerate(inside) if token == letter]
    constant = letter in _COEFFICIENTS and letter in (cursor.author.bare if cursor.author else ())
    if constant and inside[:1] and inside[0].isdigit() and {"+", "-"} & {*inside[1:2]}:
        return True  # A(1 - e^{-x}), where A stands alone elsewhere
    return bool(places) and all(inside[n + 1 : n + 2] not in (["("], ["_"]) for n in places)


def is_argument(cursor: Cursor, name: str) -> bool:
    """Whether the bracket here is the argument of ``name``: f(…), or one symbol, ε(γ)."""
    known = cursor.author and cursor.author.functions.get(name)
    if cursor.author and cursor.author.strict and _is_own_factor(cursor):
        return False
    if cursor.author and cursor.author.strict and (known or name in cursor.author.called):
        return name in cursor.author.called or bool(known and known.parameters)
    if cursor.author and name in FORCES & cursor.author.bare - cursor.author.applied:
        return False
    if name in LETTERS_OF_FUNCTIONS or known:
        return True
    if not cursor.guesses:
        return False
    start = cursor.at
    cursor.at += 1
    alone = is_letter(cursor.peek())
    if alone:
        cursor.symbol()
        alone = cursor.peek() == ")"
    cursor.at = start
    return alone
