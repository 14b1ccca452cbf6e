"""A cursor over the tokens of a LaTeX formula: what comes next, and the names the tokens spell.

Behind ``\\sin`` in ``\\sin 2x`` a number is ahead, in ``\\frac{d}{dx} f`` a derivative begins.
``dy/dx`` and a dot are symbols of an author's; anybody else is told what to write.
"""

from __future__ import annotations

import re
from typing import NoReturn

from tresym.reals.language.expression import symbol
from tresym.reals.language.latex_author import Author
from tresym.reals.language.latex_operands import Ahead, Piece
from tresym.reals.language.latex_tokens import (
    CLOSING,
    EXTREMES,
    FUNCTIONS,
    GREEK,
    RELATIONS,
    RESERVED,
    STOPS,
    Spaced,
)
from tresym.reals.language.operators import COMMANDS
from tresym.reals.numbers.exact import AmbiguityError, InputError

BRACKETS = {
    **{"(": ")", "[": "]", "\\{": "\\}"},
    **{"\\lfloor": "\\rfloor", "\\lceil": "\\rceil"},
}
FRACTIONS = ("\\frac", "\\dfrac", "\\tfrac", "\\cfrac", "\\nicefrac", "\\sfrac")
OPERATORS = ("/", "\\cdot", "\\times", "*")
DIFFERENTIALS = ("d", "\\partial")
TIME = ("\\dot", "\\ddot")
INDICES = frozenset("ijklmnpqrsIJKLMN")
"""Letters that number things."""
WORDS_BELOW = frozenset(("min", "in", "lim", "kin", "sim", "rms", "lin", "mn", "im"))
"""Subscripts that are words, though all of their letters are indices."""
SIGNS_BELOW = {"+": "plus", "-": "minus", "*": "star", "ast": "star", "/": "over"}
OPENING, CLOSED = (*BRACKETS, "{"), (*BRACKETS.values(), "}")
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


class Cursor:
    """The tokens of a formula, and the place in them.

    Attributes:
        author: whose formula it is; of nobody's a symbol is a real variable, and what can be read
            in two ways is refused.
        at: the next token.
        open_end: where the last operand without brackets ended.
        counting: inside the subscript of a term.
        indices: the letters that the sums around bind, so that i is an index there.
        bar: where the limits of the last evaluation bar ended, and its variable.
    """

    def __init__(self, tokens: list[str], author: Author | None = None) -> None:
        self.tokens = tokens
        self.author = author
        self.guesses = author is not None and not author.strict
        self.at = 0
        self.bars = 0
        self.differentials: list[str] = []
        self.integrals = 0
        self.open_end = -1
        self.bar = -1, ""
        self.counting = False
        self.indices: list[str] = []

    def peek(self, ahead: int = 0) -> str:
        """The next token, or one further on; empty at the end."""
        i = self.at + ahead
        return self.tokens[i] if i < len(self.tokens) else ""

    def take(self, expected: str = "") -> str:
        """The next token, which must be the expected one if one is named."""
        token = self.peek()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        if expected and token != expected:
            self.refuse(f"{expected} is expected")
        self.at += 1
        return token

    def refuse(self, why: str) -> NoReturn:
        """Raise the complaint, with the place."""
        near = " ".join(self.tokens[max(0, self.at - 3) : self.at + 4])
        raise InputError(f"LaTeX: {why} at {self.peek() or 'the end'!a}, near {near!a}")

    def two_readings(self, first: Piece | str, second: Piece | str) -> NoReturn:
        """Refuse what can be read in two ways, with both written out."""
        one, other = (_short(str(p.tree) if isinstance(p, Piece) else p) for p in (first, second))
        near = " ".join(self.tokens[max(0, self.at - 6) : self.at + 1])
        raise AmbiguityError(f"LaTeX: two readings remain: write {one} or {other}, near {near!a}")

    def skip_stops(self) -> None:
        """Step over commas, full stops and implication arrows."""
        while self.peek() in STOPS:
            self.at += 1

    def continues(self) -> bool:
        """Whether another factor of the same product follows."""
        return self.peek() in OPERATORS or self.starts_factor()

    def starts_factor(self) -> bool:
        """Whether the next token begins another factor of the same product."""
        token = self.peek()
        if not token or token in RELATIONS or token in STOPS:
            return False
        if token == "|" and not self.bars and self.peek(1) not in ("_", "^"):
            return True
        return token not in CLOSING and not token.startswith(("\\end", "\\right"))

    def at_bar(self) -> bool:
        """Before an evaluation bar with two limits, ``|_0^1``, which takes the whole term."""
        if self.peek() != "|" or self.peek(1) not in ("_", "^"):
            return False
        first = self.at + 2
        after = self.partner(first) + 1 if self.peek(2) == "{" else first + 1
        other = {"_": "^", "^": "_"}[self.peek(1)]
        return self.tokens[after : after + 1] == [other]

    def sides(self) -> list[str]:
        """The tokens here that say from which side a path comes, ``^+``, ``^{-}`` or ``+``."""
        for form in ("^ { + }", "^ { - }", "^ +", "^ -", "+", "-"):
            tokens, end = form.split(), self.at + len(form.split())
            if self.tokens[self.at : end] == tokens:
                return tokens if self.peek(len(tokens)) in ("", "}", *STOPS) else []
        return []

    def at_differential(self) -> bool:
        """Inside an integral, ``d`` before a symbol."""
        return bool(self.integrals) and self.peek() == "d" and is_letter(self.peek(1))

    def ahead(self) -> Ahead:
        """What follows in this product."""
        if not self.continues() or self.at_differential():
            return Ahead("")
        operator = self.peek() if self.peek() in OPERATORS else ""
        i = self.at + bool(operator)
        sign = operator and ("/" if operator == "/" else "*")
        return Ahead(self.kind(i), sign, isinstance(self.tokens[self.at], Spaced))

    def kind(self, i: int) -> str:
        """Of the factor that begins at token ``i``."""
        token = self.tokens[i] if i < len(self.tokens) else ""
        if token.startswith("\\") and token[1:] in FUNCTIONS:
            return "inverse" if FUNCTIONS[token[1:]].startswith("a") else "function"
        if token in COMMANDS or token in EXTREMES:
            return "function"
        if token in ("\\dot", "\\ddot") or self.is_derivative_at(i):
            return "derivative"
        if token in BRACKETS:
            return "bracket"
        if token in FRACTIONS:
            return "fraction"
        letter = is_letter(token) or token == "\\pi"
        return "letter" if letter and not self.is_exponential(i) else "other"

    def is_exponential(self, i: int) -> bool:
        """Whether ``e^…`` begins at token ``i``."""
        return not (self.author and self.author.letter_e) and self.tokens[i : i + 2] == ["e", "^"]

    def is_derivative_at(self, i: int) -> bool:
        """A fraction whose halves are ``d…`` and ``d`` before a letter."""
        if i >= len(self.tokens) or self.tokens[i] not in FRACTIONS:
            return False
        above, below, _ = self.halves(i)
        is_one = above[:1] == below[:1] and below[:1] in (["d"], ["\\partial"])
        return is_one and len(below) > 1 and is_letter(below[1])

    def halves(self, i: int) -> tuple[list[str], list[str], int]:
        """What stands above and below the line of the fraction at token ``i``; where it ends."""
        halves, at = [], i + 1
        for _ in range(2):
            braced = self.tokens[at : at + 1] == ["{"]
            end = self.partner(at) if braced else at + 1
            halves.append(self.tokens[at + braced : end])
            at = end + braced
        return halves[0], halves[1], at

    def partner(self, i: int) -> int:
        """Where the bracket that opens at token ``i`` is closed, or the end."""
        depth = 0
        for k in range(i, len(self.tokens)):
            depth += (self.tokens[k] in OPENING) - (self.tokens[k] in CLOSED)
            if depth == 0:
                return k
        return len(self.tokens)

    def is_list(self) -> bool:
        """Whether the bracket that opens here holds a comma of its own."""
        depth = 0
        for token in self.tokens[self.at : self.partner(self.at)]:
            depth += (token in OPENING) - (token in CLOSED)
            if depth == 1 and token == ",":
                return True
        return False

    def primes(self) -> int:
        """How many primes follow, ``''`` or ``^{\\prime\\prime}``, stepped over."""
        start = self.at
        if self.peek() == "^" and self.peek(1) in ("\\prime", "{"):
            self.at += 1 + (self.peek(1) == "{")
            if self.peek() != "\\prime":
                self.at = start
                return 0
        count = 0
        while self.peek() in ("'", "\\prime"):
            self.at, count = self.at + 1, count + 1
        if self.tokens[start : start + 2] == ["^", "{"]:
            self.take("}")
        return count

    def degrees(self) -> bool:
        """Whether ``^\\circ`` stands here, which is stepped over."""
        for form in (["^", "\\circ"], ["^", "{", "\\circ", "}"]):
            if self.tokens[self.at : self.at + len(form)] == form:
                self.at += len(form)
                return True
        return False

    def is_term(self) -> bool:
        """Whether a term of an author's sequence stands here, ``a_k``."""
        letter = self.peek().removeprefix("\\")
        if not self.author or letter not in self.author.sequences or self.peek(1) != "_":
            return False
        first = self.at + 2
        below = self.tokens[first : self.partner(first)] if self.peek(2) == "{" else [self.peek(2)]
        letters = "".join(t for t in below if t.isalpha())
        named = letters in WORDS_BELOW or any(t.startswith("\\") for t in below)
        return not named and {*letters} <= INDICES

    # names

    def symbol(self) -> str:
        """A letter with its subscript as a name."""
        token = self.take()
        prefix = ""
        if token == "\\Delta" and not self.is_lone_delta():
            prefix, token = "Delta_", self.take()
        if not (is_letter(token) or token.isalpha()):
            self.at -= 1
            self.refuse("a symbol is expected")
        name = prefix + token.removeprefix("\\")
        if self.peek() == "_":
            self.at += 1
            name += self.subscript()
        return allowed(name)

    def is_lone_delta(self) -> bool:
        """Whether a capital delta just taken is an author's symbol, and no difference."""
        if not (self.author and self.author.strict):
            return False
        if not is_letter(self.peek()) or self.is_exponential(self.at):
            return True
        if self.author.letter_delta:
            letter = self.peek()
            self.refuse(
                f"two readings remain: write \\Delta\\cdot {letter} for a product, or another "
                "letter for the \\Delta that stands alone,"
            )
        return False

    def subscript(self) -> str:
        """A subscript as the end of a name."""
        if self.peek() == "{":
            self.at += 1
            parts = []
            while self.peek() != "}":
                parts.append(self.take().removeprefix("\\"))
            self.take("}")
            text = "".join(parts)
            if self.author and self.author.strict:
                text = "".join(SIGNS_BELOW.get(c, c) for c in text).replace(",", "")
            if not text:
                return ""
        else:
            text = self.take().removeprefix("\\")
            if self.author and self.author.strict:
                text = SIGNS_BELOW.get(text, text)
            if is_number(text) and len(text) > 1:
                self.refuse("a subscript of several digits needs braces")
        if not re.fullmatch(r"[A-Za-z0-9]+", text):
            self.refuse(f"the subscript {text!a} is not read")
        return text if text[0].isdigit() else f"_{text}"


def _short(text: str) -> str:
    return text if len(text) <= 200 else f"{text[:140]} … {text[-40:]}"


def is_number(token: str) -> bool:
    """Whether a token is a decimal without its sign."""
    return token[:1].isdigit() or token[:1] == "."


def is_letter(token: str) -> bool:
    """Whether a token begins a symbol: a Latin or Greek letter, or Δ before one."""
    return (
        (len(token) == 1 and token.isascii() and token.isalpha())
        or token[1:] in GREEK
        or (token == "\\Delta")
    )


def allowed(text: str) -> str:
    """A name that the grammar of expressions does not reserve."""
    return f"{text}_" if text in RESERVED else text


def derived(kind: str, above: str, below: str, times: int = 1) -> Piece:
    """The symbol of an author's that stands for a derivative."""
    d, n = kind.removeprefix("\\"), "" if times == 1 else str(times)
    return Piece(symbol(f"{d}{n}{above.rstrip('_')}_{d}{below.rstrip('_')}{n}"))


def is_derivative(piece: Piece) -> bool:
    """Whether there is a symbol in it that stands for a derivative."""
    return any(re.match(r"(d|partial)\d?[A-Za-z]\w*_(d|partial)[A-Za-z]", x) for x in piece.names)
