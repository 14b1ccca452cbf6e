"""Names in LaTeX: symbols with their subscripts, and what is no real variable.

``dy/dx`` and a dot are symbols of an author's; anybody else is told what to write.
"""

from __future__ import annotations

import re

from tresym.reals.language.expression import symbol
from tresym.reals.language.latex_cursor import Cursor, is_letter, is_number
from tresym.reals.language.latex_reach import Piece
from tresym.reals.language.latex_tokens import FUNCTIONS, GREEK, RESERVED, Spaced

WORDS = sorted((*FUNCTIONS, "sqrt", *(g for g in GREEK if len(g) > 3)), key=len, reverse=True)
NO_DERIVATIVE = (
    "a derivative of a symbol is not known: write \\frac{d}{dx} (…) with what it stands for,"
)
INSTEAD = {
    **dict.fromkeys(
        ("\\dot", "\\ddot", "'", "\\prime"),
        "the derivative of a symbol is not known: write \\frac{d}{dt} (…) with what it stands for, "
        "or a variable of its own name,",
    ),
    **dict.fromkeys(
        ("\\imath", "\\jmath"),
        "variables are real, and this is read as the imaginary unit: write another letter, and "
        "\\cos x and \\sin x for the parts of e^{ix},",
    ),
}
"""Tokens that are refused, and what to write instead."""


class Names(Cursor):
    """Reads names."""

    def check_name(self) -> None:
        """Refuse letters that are no variable of the author's."""
        token = self.peek()
        if token in ("i", "j") and self.peek(1) != "_":
            self.refuse(INSTEAD["\\imath"])
        if token == "d" and is_letter(self.peek(1)):
            self.refuse(
                "d before a letter is a differential: write \\frac{d}{dx} (…) for a derivative, "
                "d\\cdot x for a product,"
            )
        for name in WORDS:
            letters = self.tokens[self.at : self.at + len(name)]
            if letters == list(name) and not any(isinstance(x, Spaced) for x in letters[1:]):
                apart = "\\,".join(name)
                self.refuse(f"letters in a row are a product: write \\{name}, or {apart},")

    def dotted(self) -> Piece:
        """A time derivative, as one symbol of an author's."""
        self.take("\\dot")
        braced = self.peek() == "{"
        self.at += braced
        name = self.symbol()
        if braced:
            self.take("}")
        return Piece(symbol(f"d{name}_dt"))

    def inline_derivative(self) -> bool:
        """``dy/dx`` in a line."""
        start, d = self.at, self.peek()
        self.at += 1
        ok = is_letter(self.peek())
        if ok:
            self.symbol()
            ok = self.peek() == "/" and self.peek(1) == d and is_letter(self.peek(2))
        self.at = start
        return ok

    def slashed_derivative(self) -> Piece:
        """``dy/dx`` as one symbol of an author's."""
        if not self.author:
            self.refuse(NO_DERIVATIVE)
        kind = self.take()
        above = self.symbol()
        self.at += 2
        return derived(kind, above, self.symbol())

    def symbol(self) -> str:
        """A letter with its subscript as a name."""
        token = self.take()
        prefix = ""
        if token == "\\Delta":
            prefix, token = "Delta_", self.take()
        if not (is_letter(token) or token.isalpha()):
            self.at -= 1
            self.refuse("a symbol is expected")
        name = prefix + token.removeprefix("\\")
        if self.peek() == "_":
            self.at += 1
            name += self.subscript()
        return allowed(name)

    def subscript(self) -> str:
        """A subscript as the end of a name."""
        if self.peek() == "{":
            self.at += 1
            parts = []
            while self.peek() != "}":
                parts.append(self.take().removeprefix("\\"))
            self.take("}")
            text = "".join(parts)
        else:
            text = self.take().removeprefix("\\")
            if is_number(text) and len(text) > 1:
                self.refuse("a subscript of several digits needs braces")
        if not re.fullmatch(r"[A-Za-z0-9]+", text):
            self.refuse(f"the subscript {text!a} is not read")
        return text if text[0].isdigit() else f"_{text}"


def allowed(text: str) -> str:
    """A name that the grammar of expressions does not reserve."""
    return f"{text}_" if text in RESERVED else text


def derived(kind: str, above: str, below: str) -> Piece:
    """The symbol of an author's that stands for a derivative."""
    d = kind.removeprefix("\\")
    return Piece(symbol(f"{d}{above.rstrip('_')}_{d}{below.rstrip('_')}"))


def is_derivative(piece: Piece) -> bool:
    """Whether there is a symbol in it that stands for a derivative."""
    return any(re.match(r"(d|partial)[A-Za-z]\w*_(d|partial)[A-Za-z]", x) for x in piece.names)
