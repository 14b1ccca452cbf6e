"""Derivatives, integrals, sums and limits as people type them, written in the grammar.

Handwriting (``d/dx f``, ``∫_0^1 f dx``, ``lim x->0 f``), SymPy, Mathematica and Maple.
:mod:`tresym.reals.language.spelling` reads what stands inside.
"""

from __future__ import annotations

import re
from abc import ABC, abstractmethod
from collections.abc import Iterable
from typing import NamedTuple

from tresym.reals.language.spelling_tokens import END, SUB, Token
from tresym.reals.numbers.exact import InputError

INFINITE = frozenset(("oo", "infinity", "Infinity", "inf", "Inf"))
RESERVED = frozenset(
    (
        *("given", "for", "forall", "if", "then", "when", "whenever", "where", "with", "and", "or"),
        *("in", "from", "to", "as", "provided", "assuming", "suppose", "such", "implies", "is"),
        *("equals", "of", "tends", "goes", "approaches", "integer", "integers", "real", "positive"),
        *("negative", "nonnegative", "iff", "not", "degrees", "deg", "let"),
    )
)
BIG = {
    **dict.fromkeys(("∫", "int", "Int", "integral", "integrate", "Integral", "Integrate"), "int"),
    **dict.fromkeys(("∑", "sum", "Sum", "summation"), "sum"),
    **dict.fromkeys(("∏", "prod", "product", "Product"), "product"),
    **dict.fromkeys(("lim", "limit", "Limit"), "limit"),
}
CLOSING = {"(": ")", "[": "]", "{": "}"}
SIDES = {"+": "1", "-": "-1", "+-": "0", "right": "1", "left": "-1"}


class NotSpelledError(Exception):
    """The text is not understood here either: what the strict reader says of it stands."""


def two(one: str, other: str) -> InputError:
    """The refusal of what can be read in two ways."""
    return InputError(f"two readings remain: write {bare(one)} or {bare(other)}")


def bare(text: str) -> str:
    """Without parentheses around all of it."""
    if text.startswith("(") and text.endswith(")"):
        depth = 0
        for n, character in enumerate(text):
            depth += (character == "(") - (character == ")")
            if depth == 0:
                return text[1:-1] if n == len(text) - 1 else text
    return text


class Range(NamedTuple):
    """A variable and its one or two ends, as in ``{k, 1, n}``, or where it tends to."""

    name: str
    ends: tuple[str, ...]
    side: str = ""


class OperatorSpeller(ABC):
    """Reads tokens from left to right; what it returns is text of the grammar."""

    def __init__(self, found: list[Token]) -> None:
        self.tokens = found
        self.at = 0
        self.under: list[str] = []
        """The big operators that are open: what ends their bodies is no factor."""

    @abstractmethod
    def sum(self) -> str:
        """An expression."""

    @abstractmethod
    def product(self) -> str:
        """Factors."""

    @abstractmethod
    def behind(self, text: str) -> str:
        """An operand with what stands behind it."""

    @abstractmethod
    def atom(self) -> str:
        """An operand."""

    @abstractmethod
    def inside(self, close: str) -> str:
        """The expression up to a closing bracket."""

    @abstractmethod
    def arguments(self) -> list[str | Range]:
        """What stands in parentheses or brackets, between commas."""

    @abstractmethod
    def has_comma(self) -> bool:
        """Whether the parentheses that follow hold several arguments."""

    @abstractmethod
    def only_variable(self, text: str) -> str:
        """The one variable of a text."""

    def peek(self, ahead: int = 0) -> Token:
        """A token to come."""
        place = self.at + ahead
        return self.tokens[place] if place < len(self.tokens) else END

    def next(self) -> Token:
        """The next token, which is passed."""
        token = self.peek()
        self.at += 1
        return token

    def take(self, *texts: str) -> str:
        """The next token if it is one of these, which is passed; else nothing."""
        if self.peek().text in texts and self.peek().kind != "end":
            return self.next().text
        return ""

    def need(self, *texts: str) -> str:
        """As :meth:`take`, where one must stand."""
        found = self.take(*texts)
        if not found:
            raise NotSpelledError
        return found

    def name(self) -> str:
        """The name of a variable."""
        if self.peek().kind != "name":
            raise NotSpelledError
        return self.next().text

    def tending(self, name: str, sign: str) -> Range:
        """``x = a .. b``, ``x = a`` or ``x -> a+``, behind the sign."""
        low = self.signed_end() if sign == "->" else self.sum()
        if self.take(".."):
            return Range(name, (low, self.sum()))
        side = ""
        if sign == "->" and self.peek().text in ("+", "-", "^"):
            self.take("^")
            side = SIDES[self.need("+", "-")]
        return Range(name, (low,), side)

    def signed_end(self) -> str:
        """A point, behind which ``+`` and ``-`` say from which side."""
        sign = "-" if self.take("-") else ""
        self.take("+")
        text = sign + self.behind(self.atom())
        if self.peek().text in ("/", "*") and self.peek(1).kind in ("number", "name"):
            text += self.next().text + self.behind(self.atom())
        return text

    # Derivatives.

    def derivative(self) -> str:
        """``d/dx f``, ``d^2/dx^2 f`` and ``d(f)/dx``, behind the d; nothing if it is none."""
        start = self.at
        times = self._order()
        if self.take("/") and re.fullmatch(r"d[a-zA-Z]\w*", self.peek().text):
            name = self.next().text[1:]
            if self._order() != times:
                raise NotSpelledError
            return self.body_of_derivative(name, times)
        self.at = start
        if self.peek().text == "(" and not self.peek().spaced:
            self.next()
            body = self.inside(")")
            if self.peek().text == "/" and re.fullmatch(r"d[a-zA-Z]\w*", self.peek(1).text):
                self.next()
                return f"diff({body}, {self.next().text[1:]})"
        self.at = start
        return ""

    def _order(self) -> str:
        if not self.take("^", "**"):
            return ""
        closed = self.take("(")
        found = self.next()
        if closed:
            self.need(")")
        if found.kind != "number":
            raise NotSpelledError
        return found.text

    def body_of_derivative(self, name: str, times: str) -> str:
        """What is differentiated: all factors up to a plus, a minus or a relation."""
        order = f", {times}" if times else ""
        closed = self.peek().text in ("(", "[")
        start = self.at
        body = self.product()
        if closed and self.tokens[start].text == "(" and not _is_closed(body):
            raise two(f"diff({body}, {name}{order})", f"diff(…, {name}{order})*…")
        if not closed and self.peek().text in ("+", "-"):
            sign = self.next().text
            rest = self.sum()
            raise two(
                f"diff({body}, {name}{order}) {sign} {rest}",
                f"diff({body} {sign} {rest}, {name}{order})",
            )
        return f"diff({bare(body)}, {name}{order})"

    def derived(self) -> str:
        """``D[f, x]``, ``D[f, {x, 2}]``, ``diff(f, x)``, ``Derivative(f, (x, 2))``."""
        body, *by = self.arguments()
        if isinstance(body, Range) or not by:
            raise NotSpelledError
        if len(by) == 2 and all(isinstance(item, str) for item in by):
            if not str(by[1]).isdigit():
                return f"diff(diff({body}, {by[0]}), {by[1]})"
            return f"diff({body}, {by[0]}, {by[1]})"
        for item in by:
            if isinstance(item, Range):
                body = f"diff({body}, {', '.join((item.name, *item.ends))})"
            else:
                body = f"diff({body}, {item})"
        return str(body)

    # Integrals, sums, products and limits.

    def is_big(self, name: str) -> bool:
        """Whether such a name begins an integral, a sum or a limit here."""
        after = self.peek()
        return after.kind == "name" or after.text in ("(", "[", SUB, "|") or after.kind == "number"

    def big(self, kind: str, token: Token) -> str:
        """An integral, a sum, a product or a limit."""
        written = token.text not in ("∫", "∑", "∏")
        if written and self.peek().text in ("(", "[") and self.has_comma():
            return self.called(kind, token.text)
        low = high = ""
        found: Range | None = None
        if self.take(SUB):
            if kind == "int":
                low = self.bound()
            else:
                found = self.bound_variable(kind)
            if self.take("^", "**"):
                high = self.bound()
        if kind == "limit":
            return self.limit(found)
        if found is not None and high:
            found = Range(found.name, (found.ends[0], high))
        self.take("of")
        self.under.append(kind)
        body = self.sum() if kind == "int" else self.product()
        self.under.pop()
        if kind == "int":
            return self.integral(body, low, high)
        return self.total(kind, body, found)

    def bound(self) -> str:
        """An end of an integral: signed, or in parentheses."""
        if self.peek().text in ("(", "{"):
            return self.inside(CLOSING[self.next().text])
        sign = "-" if self.take("-") else ""
        token = self.next()
        if token.kind not in ("number", "name"):
            raise NotSpelledError
        return sign + ("oo" if token.text in INFINITE else token.text)

    def bound_variable(self, kind: str) -> Range:
        """``k=1`` or ``x->0`` under a sum or a limit."""
        close = CLOSING.get(self.take("(", "{"), "")
        name = self.name()
        found = self.tending(name, self.need("->" if kind == "limit" else "="))
        if close:
            self.need(close)
        return found

    def integral(self, body: str, low: str, high: str) -> str:
        """An integral behind its integrand: ``dx``, and perhaps ``from a to b``."""
        by = self.peek()
        if re.fullmatch("d[a-zA-Z]", by.text):
            name = self.next().text[1:]
        else:
            name = self.only_variable(body)
            if self.peek().text != "from":
                raise NotSpelledError
        if not high and self.take("from"):
            low = self.sum()
            self.need("to")
            high = self.sum()
        return f"integral({body}, {name}, {low}, {high})" if high else f"integral({body}, {name})"

    def total(self, kind: str, body: str, found: Range | None) -> str:
        """A sum or a product behind its term."""
        if found is None:
            self.need("from", "for")
            name = self.name()
            self.need("=", "from")
            low = self.sum()
            self.need("to", "..")
            found = Range(name, (low, self.sum()))
        if len(found.ends) != 2:
            raise NotSpelledError
        low, high = found.ends
        text = f"{kind}({body}, {found.name}, {low}, {high})"
        if self.peek().text in ("+", "-"):
            sign = self.next().text
            rest = self.product()
            wide = f"{kind}({body} {sign} {rest}, {found.name}, {low}, {high})"
            raise two(f"{text} {sign} {rest}", wide)
        return text

    def limit(self, found: Range | None) -> str:
        """``lim x->0 f``, ``lim_(x->0) f``, ``limit of f as x->0``."""
        self.take("as")
        if found is None and self.peek().text == "(" and self.peek(2).text == "->":
            found = self.bound_variable("limit")
        elif found is None and self.peek(1).text == "->":
            found = self.tending(self.name(), self.next().text)
        self.take("of", ",")
        body = self.product()
        if found is None and self.take("as"):
            name = self.name()
            self.arrow()
            found = self.tending(name, "->")
        if found is None:
            raise NotSpelledError
        text = _limit(body, found)
        if self.peek().text in ("+", "-"):
            sign = self.next().text
            rest = self.product()
            raise two(f"{text} {sign} {rest}", _limit(f"{body} {sign} {rest}", found))
        return text

    def arrow(self) -> None:
        """``->``, or its words."""
        if self.take("tends", "goes"):
            self.need("to")
        else:
            self.need("->", "approaches")

    def called(self, kind: str, name: str) -> str:
        """An integral, a sum or a limit as a function of SymPy, Mathematica or Maple."""
        mathematica = self.peek().text == "["
        body, *rest = self.arguments()
        if isinstance(body, Range):
            raise NotSpelledError
        if kind == "limit":
            return _called_limit(body, rest, name == "Limit" and not mathematica)
        word = {"int": "integral"}.get(kind, kind)
        texts = [item for item in rest if isinstance(item, str)]
        if len(texts) == len(rest) and len(rest) in (1, 3):
            return f"{word}({', '.join((body, *texts))})"
        ranges = [item if isinstance(item, Range) else Range(item, ()) for item in rest]
        for found in reversed(ranges) if mathematica else ranges:
            ends = found.ends
            if kind != "int" and len(ends) == 1:
                ends = ("1", *ends)
            if len(ends) == 1:
                raise NotSpelledError
            body = f"{word}({', '.join((body, found.name, *ends))})"
        return body


def _is_closed(text: str) -> bool:
    return bare(text) != text


def _limit(body: str, found: Range) -> str:
    side = f", {found.side}" if found.side else ""
    return f"limit({bare(body)}, {found.name}, {found.ends[0]}{side})"


def _called_limit(body: str, rest: Iterable[str | Range], right: bool) -> str:
    """A limit as a function, at a finite point from the right if ``right`` and no side is given.

    That is what ``Limit`` means in SymPy.
    """
    texts, side = [], ""
    for item in rest:
        if isinstance(item, str):
            texts.append(item)
        elif item.name:
            texts += [item.name, *item.ends]
            side = item.side or side
        else:
            side = item.side
    if len(texts) == 3:
        side = texts.pop()
    if len(texts) != 2:
        raise NotSpelledError
    if right and not side and texts[1].strip("(-)") != "oo":
        side = "1"
    return _limit(body, Range(texts[0], (texts[1],), side))
