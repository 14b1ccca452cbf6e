"""Read a term of a chain, and decide whether a definition can define it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise

from tresym.reals.decisions.statement import functions
from tresym.reals.language.calls import FACTORIAL, ROUNDED
from tresym.reals.language.expression import Expr
from tresym.reals.language.latex_author import Author
from tresym.reals.language.latex_cursor import Cursor, is_letter
from tresym.reals.language.latex_grammar import read_arguments, read_sum
from tresym.reals.language.latex_operands import Piece
from tresym.reals.language.latex_tokens import ELLIPSIS
from tresym.reals.numbers.exact import InputError

_DERIVED = re.compile(r"(?:d|partial)\d?([A-Za-z]\w*?)_(?:d|partial)[A-Za-z]\w*|(\w+?)_prime\d?")
_COUNTED = frozenset("123456789")
_STOPS = (",", ".", ";", ":")
_UNITS = frozenset(("\\mathrm", "\\text", "\\textrm", "\\rm", "\\unit"))


@dataclass(frozen=True)
class Head:
    """The left side of a definition."""

    name: str
    parameters: tuple[str, ...] = ()
    derived: bool = False

    @property
    def base(self) -> str:
        """The differentiated symbol for a derivative, else the name itself."""
        return base_of(self.name) if self.derived else self.name


def head_of(tokens: list[str], author: Author) -> Head | None:
    """Return the symbol, function of symbols, or derivative that ``tokens`` are; else None."""
    try:
        cursor = Cursor(tokens, author)
        if cursor.kind(0) == "letter" and cursor.peek() != "\\pi":
            letter = cursor.peek()
            name = cursor.symbol()
            if not cursor.peek():
                return None if letter == "e" and not author.letter_e else Head(name)
            if cursor.peek() == "(":
                values = read_arguments(cursor)
                if not cursor.peek() and all(value.op == "symbol" for value in values):
                    return Head(name, tuple(str(value) for value in values))
        cursor = Cursor(tokens, author)
        tree = read_sum(cursor).tree
    except (InputError, RecursionError):
        return None
    if (
        cursor.peek()
        or tree.op != "symbol"
        or not _DERIVED.fullmatch(tree.args[0].split("_of_")[0])
    ):
        return None
    return Head(tree.args[0], derived=True)


def base_of(name: str) -> str:
    """Return the symbol that is differentiated in the name of a derivative, else the name."""
    found = _DERIVED.fullmatch(name.split("_of_")[0])
    return (found[1] or found[2]) if found else name


SIGNS = ("+", "-", "|", "\\left|", "\\right|")


def is_plain(term: Sequence[str]) -> bool:
    """Whether a term is a symbol, a number or infinity, perhaps with a sign."""
    bare = [t for t in term if t not in SIGNS]
    if not bare:
        return False
    if len(bare) == 1:
        return bare[0][0].isdigit() or bare[0][0] == "." or bare[0][-1].isalpha()
    return head_of(bare, Author(strict=True)) is not None


def unknown_in(*trees: Expr) -> set[str]:
    """Return the names of the arbitrary functions in the expressions."""
    return {str(f.args[0].args[0]) for e in trees for f in functions(e)} - {FACTORIAL, *ROUNDED}


def read_term(tokens: Sequence[str], author: Author) -> Piece:
    """Parse a term.

    Raises:
        InputError: it cannot be read.
    """
    tokens = _digits_joined(list(tokens))
    while tokens and tokens[-1] in _STOPS:
        tokens.pop()
    cursor = Cursor(tokens, author)
    try:
        piece = read_sum(cursor)
    except RecursionError:
        raise InputError("LaTeX: nested too deeply") from None
    if cursor.peek():
        cursor.refuse("an operation or the end is expected")
    return piece


def with_primed_variables(tokens: Sequence[str]) -> tuple[str, ...]:
    """Rename a variable of integration with a prime, as in ``\\int f(t')\\,dt'``."""
    ends = zip(tokens, tokens[1:], tokens[2:], strict=False)
    by = {b for a, b, c in ends if (a, c) == ("d", "'")}
    result: list[str] = []
    for token in tokens:
        if token == "'" and result and result[-1] in by and "\\int" in tokens:
            result += ["_", "{", *"primed", "}"]
        else:
            result.append(token)
    return tuple(result)


def with_derivatives_counted(tokens: Sequence[str]) -> tuple[str, ...]:
    """``f^{(4)}(x)`` with primes."""
    result: list[str] = []
    at = 0
    while at < len(tokens):
        above = tuple(tokens[at : at + 6])
        counted = above[:3] == ("^", "{", "(") and above[4:] == (")", "}")
        counted = counted and above[3] in _COUNTED and tokens[at + 6 : at + 7] in (["("], ("(",))
        if counted and result and is_letter(result[-1]):
            result += ["'"] * int(above[3])
            at += 6
            continue
        result.append(tokens[at])
        at += 1
    return tuple(result)


def as_derivatives(terms: Sequence[Sequence[str]]) -> tuple[tuple[str, ...], ...] | None:
    """The terms of ``du = 2x\\,dx`` as those of ``du/dx = 2x``; None of another form."""
    head, *others = terms
    if len(head) != 2 or head[0] != "d" or not is_letter(head[1]) or not others:
        return None
    bodies = []
    for term in others:
        *body, d, x = ("", "", *term)
        body = [token for token in body if token]
        last = body[-1] if body else ""
        if (d, x) != ("d", others[0][-1]) or x == head[1] or not is_letter(x):
            return None
        depth = 0
        for n, (token, after) in enumerate(pairwise([*body, ""])):
            depth += (token in ("(", "[", "{", "\\{")) - (token in (")", "]", "}", "\\}"))
            if token == "\\int" or (token == "d" and is_letter(after)):
                return None
            if depth == 0 and n and token in ("+", "-", "\\pm", "\\mp"):
                return None
        if depth or last in ("/", "^", "_", "+", "-", ":"):
            return None
        bodies.append(tuple(body[:-1] if last in ("\\cdot", "\\times") else body) or ("1",))
        if bodies[-1] in (("-",), ("+",)):
            return None
    return ("\\frac", "{", "d", head[1], "}", "{", "d", others[0][-1], "}"), *bodies


def variables_of_integrals(tokens: Sequence[str]) -> set[str]:
    """Return the variables of integration."""
    return {b.removeprefix("\\") for a, b in pairwise(tokens) if a == "d" and "\\int" in tokens}


def first_digits(tokens: Sequence[str]) -> Sequence[str]:
    """Return the digits of ``2.718\\ldots`` without the dots; nothing of another term.

    After nines there is nothing either: 0.99... is 1, whose digits are others.
    """
    bare = list(tokens)
    while bare and bare[-1] in _STOPS:
        bare.pop()
    body = _digits_joined(bare[:-1])
    digits = body[-1] if len(body) == 1 + (body[:1] == ["-"]) else ""
    lone = bare[-1:] == [ELLIPSIS] and "." in digits and digits.replace(".", "").isdigit()
    return body if lone and not digits.endswith("99") else ()


def is_rational(tree: Expr) -> bool:
    """Whether a number is written with rational numbers, the four operations and whole powers."""
    if tree.op in ("+", "*"):
        return all(map(is_rational, tree.args))
    if tree.op == "^":
        base, exponent = tree.args
        return is_rational(base) and exponent.op == "number" and exponent.args[0].q == 1
    return tree.op == "number"


def _digits_joined(tokens: list[str]) -> list[str]:
    """Join groups of digits, ``2.71828 18284 59045``, to one decimal."""
    result: list[str] = []
    for n, token in enumerate(tokens):
        grouped = result and "." in result[-1] and result[-1][0].isdigit() and token.isdigit()
        places = len(result[-1].partition(".")[2]) if grouped else 1
        if grouped and (places % 5 == 0 or places % 3 == 0) and tokens[n - 1][-1:].isdigit():
            result[-1] += token
        else:
            result.append(token)
    return result


def without_units(tokens: Sequence[str]) -> Sequence[str]:
    """Return a number without the unit behind it."""
    start = next((n for n, token in enumerate(tokens) if token in _UNITS), 0)
    numbers = {"\\times", "\\cdot", "^", "{", "}", "-", "+"}
    if start and all(t in numbers or t[0].isdigit() or t[0] == "." for t in tokens[:start]):
        return tokens[:start]
    return tokens


def plain(why: str) -> str:
    """Return an error of the LaTeX parser on one line, without its prefix."""
    return " ".join(why.removeprefix("LaTeX: ").split())
