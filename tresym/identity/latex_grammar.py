"""The grammar of LaTeX expressions: recursive descent from tokens to text.

The text is of the expression grammar of :mod:`tresym.identity.parsing`, with the additions that
:mod:`tresym.identity.latex` lists.
"""

from __future__ import annotations

import re
from typing import NamedTuple, NoReturn

from tresym.exact import InputError
from tresym.identity.latex_tokens import (
    CLOSING,
    FUNCTIONS,
    GREEK,
    LETTERS_OF_FUNCTIONS,
    RELATIONS,
    RESERVED,
    STOPS,
)


class Piece(NamedTuple):
    """Text and how strongly it binds: 1 sum, 2 product, 3 power, 4 atom."""

    text: str
    strength: int = 4
    symbol: bool = False

    def within(self, strength: int) -> str:
        """The text, in parentheses where what surrounds it binds more strongly."""
        return self.text if self.strength >= strength else f"({self.text})"


class Reader:
    """Recursive descent over the tokens; every method returns text of the expression grammar."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = tokens
        self.at = 0
        self.differentials: list[str] = []
        self.integrals = 0

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

    def skip_stops(self) -> None:
        """Step over commas, full stops and implication arrows."""
        while self.peek() in STOPS:
            self.at += 1

    # sums and products

    def sum(self) -> Piece:
        """Terms joined by + and −."""
        terms = [self.signed()]
        while self.peek() in ("+", "-"):
            operator = self.take()
            terms.append(Piece(f" {operator} {self.product().within(2)}"))
        if len(terms) == 1:
            return terms[0]
        return Piece("".join(t.text for t in terms), 1)

    def signed(self) -> Piece:
        """The first term of a sum, perhaps with a sign."""
        if self.peek() in ("+", "-"):
            sign = self.take()
            piece = self.product()
            return Piece(f"-{piece.within(2)}", 1) if sign == "-" else piece
        return self.product()

    def product(self) -> Piece:
        """Factors side by side; a slash divides by one factor, and what follows it is refused."""
        factors, operators = [self.factor_or_differential()], [""]
        while not (self.integrals and factors[-1] is None):
            if self.peek() in ("/", "\\cdot", "\\times", "*"):
                operators.append("/" if self.take() == "/" else "*")
            elif self.starts_factor():
                if operators[-1] == "/" and not self.at_differential():
                    self.refuse("what is below the slash? Write it with \\frac or in brackets,")
                if _is_number(self.peek()) and _is_number(self.tokens[self.at - 1]):
                    self.refuse("two numbers side by side: one with spaces, or a product?")
                operators.append("*")
            else:
                break
            factors.append(self.factor_or_differential())
        return _joined(factors, operators)

    def factor_or_differential(self) -> Piece | None:
        """A factor, or None where the differential of an integral was stepped over."""
        if not self.at_differential():
            return self.factor()
        self.take("d")
        self.differentials.append(self.symbol())
        return None

    def starts_factor(self) -> bool:
        """Whether the next token begins another factor of the same product."""
        token = self.peek()
        if not token or token in RELATIONS or token in STOPS:
            return False
        return token not in CLOSING and not token.startswith(("\\end", "\\right"))

    def at_differential(self) -> bool:
        """Inside an integral, ``d`` before a symbol."""
        return bool(self.integrals) and self.peek() == "d" and _is_letter(self.peek(1))

    # factors

    def factor(self) -> Piece:
        """A base with its powers, evaluation bars and values at a point."""
        base = self.base()
        while True:
            if self.peek() == "^":
                self.at += 1
                base = Piece(f"{base.within(4)}**{self.script().within(4)}", 3)
            elif self.peek() == "|" and self.peek(1) == "_":
                self.at += 2
                base = self.evaluated(base.text)
            elif self.peek() == "(" and _is_derivative(base.text) and self.is_list():
                base = Piece(f"value({base.text}, {', '.join(self.arguments())})")
            else:
                return base

    def script(self) -> Piece:
        """An exponent: one token or a group."""
        if self.peek() == "{":
            return self.group()
        token = self.peek()
        if token.isdigit() and len(token) > 1:
            # x^12 is x¹·2 in TeX.
            self.refuse("an exponent of several digits needs braces")
        return self.base()

    def evaluated(self, text: str) -> Piece:
        """The place of an evaluation bar, ``_{x = value}``."""
        self.take("{")
        name = self.sum().text
        self.take("=")
        value = self.sum().text
        self.take("}")
        return Piece(f"at({text}, {name}, {value})")

    def group(self) -> Piece:
        """What stands in braces."""
        self.take("{")
        piece = self.sum()
        self.take("}")
        return piece

    def base(self) -> Piece:
        """A bracket, a command with its arguments, a number or a name."""
        token = self.peek()
        if token in ("(", "[", "\\{"):
            return self.bracket()
        if token == "{":
            return Piece(self.group().within(4))
        if token in ("|", "\\left|"):
            return self.absolute()
        if token == "\\left.":
            return self.barred()
        if token == "\\frac" or token in ("\\dfrac", "\\tfrac"):
            return self.fraction()
        if token == "\\sqrt":
            return self.root()
        if token == "\\int":
            return self.integral()
        if token == "\\infty":
            self.take()
            return Piece("inf")
        if token == "\\dot":
            return self.dotted()
        if token.lstrip("\\") in FUNCTIONS and token.startswith("\\"):
            return self.function()
        if re.fullmatch(r"\d.*|\.\d+", token):
            return Piece(self.take())
        if _is_letter(token) or token in ("\\pi", "\\Delta", "\\partial") or token.isalpha():
            return self.named()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        self.refuse("this is not read")

    def bracket(self) -> Piece:
        """A bracket; with limits behind it, the difference of values at its ends."""
        opening = self.take()
        piece = self.sum()
        closing = self.take()
        if closing.removeprefix("\\right") != {"(": ")", "[": "]", "\\{": "\\}"}[opening]:
            self.at -= 1
            self.refuse(f"the bracket {opening} is not closed")
        if opening == "[" and self.peek() == "_":
            self.at += 1
            low = self.script().text
            self.take("^")
            return Piece(f"between({piece.text}, {low}, {self.script().text})")
        return Piece(f"({piece.text})") if piece.strength < 4 else piece

    def absolute(self) -> Piece:
        """An absolute value."""
        self.at += 1
        piece = self.sum()
        if self.take() not in ("|", "\\right|"):
            self.at -= 1
            self.refuse("the bar | is not closed")
        return Piece(f"abs({piece.text})")

    def barred(self) -> Piece:
        """``\\left. … \\right|_{x = value}``."""
        self.take("\\left.")
        piece = self.sum()
        self.take("\\right|")
        self.take("_")
        return self.evaluated(piece.text)

    def root(self) -> Piece:
        """A square root, or a root with an index."""
        self.take("\\sqrt")
        if self.peek() == "[":
            self.take()
            index = self.sum().text
            self.take("]")
            radicand = self.argument_group()
            return Piece(f"{radicand.within(4)}**(1/{index})", 3)
        return Piece(f"sqrt({self.argument_group().text})")

    def argument_group(self) -> Piece:
        """The argument of a command: a group, or one token."""
        return self.group() if self.peek() == "{" else self.base()

    def fraction(self) -> Piece:
        """A fraction, unless it is a derivative."""
        derivative = self.derivative()
        if derivative is not None:
            return derivative
        self.take()
        if re.fullmatch(r"\d\d", self.peek()):
            # TeX's \frac12 is one half.
            digits = self.take()
            return Piece(f"{digits[0]}/{digits[1]}", 2)
        top = self.numerator()
        return Piece(f"{top.within(2)}/{self.argument_group().within(4)}", 2)

    def numerator(self) -> Piece:
        """What stands above the line."""
        if self.peek() == "{" and self.peek(1) == "}":
            self.refuse("an empty numerator")
        return self.argument_group()

    def derivative(self) -> Piece | None:
        """``\\frac{dy}{dx}`` as one symbol, ``\\frac{d}{dx} e`` as ``diff(e, x)``; else None."""
        start = self.at
        self.take()
        order, below = self._higher_order()
        if order:
            return Piece(f"diff({self.factor().text}, {below}, {order})")
        found = self._derivative_parts()
        if found is None:
            self.at = start
            return None
        above, below, d = found
        if not above:
            return Piece(f"diff({self.factor().text}, {below})")
        return Piece(f"{d}{above}_{d}{below}")

    def _higher_order(self) -> tuple[int, str]:
        """The order and the variable of ``{d^n}{dx^n}``, which is stepped over; else 0."""
        for kind in ("d", "\\partial"):
            match = re.match(
                rf"{{ {re.escape(kind)} \^ (?P<n>{{ \d+ }}|\d+) }} {{ {re.escape(kind)} "
                r"(?P<x>[A-Za-z]|\\[a-z]+) \^ (?P=n) } ",
                " ".join(self.tokens[self.at :]) + " ",
            )
            if match:
                self.at += match[0].count(" ")
                return int(match["n"].strip("{} ")), match["x"].lstrip("\\")
        if self.tokens[self.at : self.at + 3] in (["{", "d", "^"], ["{", "\\partial", "^"]):
            self.refuse("a derivative of higher order is written \\frac{d^2}{dx^2} f, here")
        return 0, ""

    def _derivative_parts(self) -> tuple[str, str, str] | None:
        above = self._differential_group()
        if above is None:
            return None
        below = self._differential_group()
        if below is None or not below[1] or below[0] != above[0]:
            return None
        return above[1], below[1], above[0]

    def _differential_group(self) -> tuple[str, str] | None:
        """``{d y}`` or ``{\\partial y}`` or ``{d}``: what kind, and of what."""
        if self.peek() != "{" or self.peek(1) not in ("d", "\\partial"):
            return None
        kind = "d" if self.peek(1) == "d" else "partial"
        self.at += 2
        name = ""
        if _is_letter(self.peek()):
            name = self.symbol()
        if self.peek() != "}":
            return None
        self.at += 1
        return kind, name.rstrip("_")

    def dotted(self) -> Piece:
        """A time derivative, as one symbol."""
        self.take("\\dot")
        braced = self.peek() == "{"
        if braced:
            self.at += 1
        name = self.symbol()
        if braced:
            self.take("}")
        return Piece(f"d{name}_dt")

    def function(self) -> Piece:
        """A function; without brackets its argument is one symbol, fraction or root."""
        name = FUNCTIONS[self.take()[1:]]
        exponent = ""
        if self.peek() == "^":
            self.at += 1
            exponent = self.script().within(4)
            if exponent.startswith("(-"):
                self.refuse("a negative power of a function can mean its inverse: write \\arc… or")
        argument = self.argument()
        text = f"{name}({argument})"
        return Piece(f"{text}**{exponent}", 3) if exponent else Piece(text)

    def argument(self) -> str:
        """The argument of a function; one that could end in two places is refused."""
        if self.peek() in ("(", "[", "{"):
            inner = self.base().text
            return inner[1:-1] if _is_enclosed(inner) else inner
        text = ""
        while re.fullmatch(r"\d.*", self.peek()):
            text += f"{self.take()}*"
        piece = self.factor()
        if piece.symbol or text or piece.text == "pi":
            ahead = self.peek()
            if ahead == "/" or (_is_letter(ahead) and not (ahead == "d" and self.integrals)):
                self.refuse("where does the function's argument end? Write it in brackets,")
        return text + piece.within(3 if text else 1)

    def integral(self) -> Piece:
        """``∫_{low}^{high} … dx``: all terms that carry the differential."""
        self.take("\\int")
        if self.peek() != "_":
            self.refuse("an integral needs its limits")
        self.at += 1
        low = self.script().text
        self.take("^")
        high = self.script().text
        outer, self.differentials = self.differentials, []
        self.integrals += 1
        body = self.integrand()
        variables = set(self.differentials)
        self.integrals -= 1
        self.differentials = outer
        if len(variables) != 1:
            self.refuse("an integral needs one variable and its differential")
        return Piece(f"integral({body}, {variables.pop()}, {low}, {high})")

    def integrand(self) -> str:
        """The terms that carry the differential of the integral."""
        body = self.signed().text
        if not self.differentials:
            self.refuse("the differential of the integral is missing")
        while self.peek() in ("+", "-"):
            before, count = self.at, len(self.differentials)
            operator = self.take()
            term = self.product().within(2)
            if len(self.differentials) == count:
                self.at = before
                break
            body += f" {operator} {term}"
        return body

    # names

    def named(self) -> Piece:
        """A symbol, an inline derivative, ``e^{…}``, or an author's function."""
        token = self.peek()
        if token in ("d", "\\partial") and self.inline_derivative():
            return self.slashed_derivative()
        if token == "e" and self.peek(1) == "^":
            self.at += 2
            return Piece(f"exp({self.script().text})")
        if token == "e":
            self.take()
            return Piece("E")
        if token == "\\pi":
            self.take()
            return Piece("pi")
        if token in ("O", "o") and self.peek(1) == "(":
            self.take()
            return Piece(f"{token}({', '.join(self.arguments())})")
        name = self.symbol()
        if self.peek() == "(" and self.is_application(name):
            return Piece(f"{name}({', '.join(self.arguments())})")
        return Piece(name, symbol=True)

    def inline_derivative(self) -> bool:
        """``dy/dx`` in a line."""
        start, d = self.at, self.peek()
        self.at += 1
        ok = _is_letter(self.peek())
        if ok:
            self.symbol()
            ok = self.peek() == "/" and self.peek(1) == d and _is_letter(self.peek(2))
        self.at = start
        return ok

    def slashed_derivative(self) -> Piece:
        """``dy/dx`` as one symbol."""
        d = "d" if self.take() == "d" else "partial"
        above = self.symbol().rstrip("_")
        self.at += 2
        return Piece(f"{d}{above}_{d}{self.symbol().rstrip('_')}")

    def symbol(self) -> str:
        """A letter with its subscript as a name."""
        token = self.take()
        prefix = ""
        if token == "\\Delta":
            prefix, token = "Delta_", self.take()
        if not (_is_letter(token) or token.isalpha()):
            self.at -= 1
            self.refuse("a symbol is expected")
        name = prefix + token.removeprefix("\\")
        if self.peek() == "_":
            self.at += 1
            name += self.subscript()
        return f"{name}_" if name in RESERVED else name

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
        if not re.fullmatch(r"[A-Za-z0-9]+", text):
            self.refuse(f"the subscript {text!a} is not read")
        return text if text[0].isdigit() else f"_{text}"

    def is_list(self) -> bool:
        """Whether the bracket that opens here holds a comma of its own."""
        depth, i = 0, self.at
        while i < len(self.tokens):
            token = self.tokens[i]
            depth += (token in ("(", "[", "{")) - (token in (")", "]", "}"))
            if depth == 0:
                return False
            if depth == 1 and token == ",":
                return True
            i += 1
        return False

    def is_application(self, name: str) -> bool:
        """f(…), any name before a list, or before one symbol alone, as in ε(γ)."""
        if name in LETTERS_OF_FUNCTIONS or self.is_list():
            return True
        start = self.at
        self.at += 1
        alone = _is_letter(self.peek())
        if alone:
            self.symbol()
            alone = self.peek() == ")"
        self.at = start
        return alone

    def arguments(self) -> list[str]:
        """The arguments of an author's function."""
        self.take("(")
        found = [self.sum().text]
        while self.peek() == ",":
            self.take()
            found.append(self.sum().text)
        self.take(")")
        return found


def _joined(factors: list[Piece | None], operators: list[str]) -> Piece:
    """The product of ``factors``; differentials (None) are left out."""
    kept = [(f, op) for f, op in zip(factors, operators, strict=True) if f is not None]
    if not kept:
        return Piece("1")
    if len(kept) == 1:
        return kept[0][0]
    text = kept[0][0].within(2) + "".join(op + factor.within(3) for factor, op in kept[1:])
    return Piece(_power_of_ten(text), 2)


def _is_number(token: str) -> bool:
    return token[:1].isdigit() or token[:1] == "."


def _is_letter(token: str) -> bool:
    return (
        (len(token) == 1 and token.isascii() and token.isalpha())
        or token[1:] in GREEK
        or (token == "\\Delta")
    )


def _is_derivative(text: str) -> bool:
    return re.search(r"\b(d|partial)[A-Za-z]\w*_(d|partial)[A-Za-z]", text) is not None


def _is_enclosed(text: str) -> bool:
    """Whether one pair of parentheses encloses all of ``text``."""
    if not (text.startswith("(") and text.endswith(")")):
        return False
    depth = 0
    for i, character in enumerate(text):
        depth += (character == "(") - (character == ")")
        if depth == 0:
            return i == len(text) - 1
    return False


def _power_of_ten(text: str) -> str:
    """``1.09*10**(-2)`` is the decimal ``1.09e-2``: a printed number keeps its digits."""
    return re.sub(r"(?<![\w.)])(\d+(?:\.\d+)?)\*10\*\*\(?(-?\d+)\)?(?![\w.])", r"\1e\2", text)
