"""Reading LaTeX mathematics as text of the expression grammar.

`read_latex` turns a displayed formula into chains of relations; `read_expression` one expression
into text that :func:`tresym.identity.parse` accepts. Nothing is guessed: what can be read in two
ways is refused, with a line that says how to write it.

Read are sums, products by juxtaposition, ``\\frac``, ``\\sqrt``, powers, absolute values, the
elementary functions, ``e^{…}``, arrays, and the usual relations, ``\\in`` an interval among them.
Symbols become names: ``\\psi_0`` is ``psi0``, ``\\theta_{\\min}`` is ``theta_min``,
``\\Delta\\psi`` is ``Delta_psi``; names that the grammar reserves get an underscore (``lambda_``).
``\\frac{d\\psi}{d\\phi}`` and ``\\dot\\theta`` are the symbols ``dpsi_dphi`` and ``dtheta_dt``.

Beyond the grammar of expressions the text has calls that stand for what is not an expression:
``integral(f, x, low, high)``, ``at(e, x, value)`` for an evaluation bar, ``between(e, low, high)``
for a bracket with limits, ``value(e, p, …)`` for a value at a point, ``O(e)``, ``o(e)``, ``inf``,
and functions of the author's such as ``f(a, b)``.
"""

from __future__ import annotations

import re
from dataclasses import dataclass
from typing import NamedTuple, NoReturn

from tresym.exact import InputError

MAX_CHARACTERS = 10_000
MAX_DEPTH = 60


def _words(text: str) -> frozenset[str]:
    return frozenset(text.split())


_TRIGONOMETRIC = ("sin", "cos", "tan", "sinh", "cosh", "tanh")
FUNCTIONS = {
    **{name: name for name in (*_TRIGONOMETRIC, "cot", "sec", "csc", "coth", "exp", "log")},
    "ln": "log",
    **{f"arc{name}": f"a{name}" for name in (*_TRIGONOMETRIC, "sec", "csc")},
    **{f"ar{name}": f"a{name}" for name in ("sinh", "cosh", "tanh")},
    **{f"a{name}": f"a{name}" for name in _TRIGONOMETRIC},
}
"""Commands and upright words that apply a function, and the function."""
GREEK = _words(
    "alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi rho sigma tau "
    "upsilon phi chi psi omega varepsilon vartheta varphi varrho varsigma "
    "Gamma Theta Lambda Xi Sigma Upsilon Phi Psi Omega ell hbar"
)
RELATIONS = {
    **dict.fromkeys(("=", ":=", "\\equiv"), "="),
    **dict.fromkeys(("<", "\\lt"), "<"),
    **dict.fromkeys((">", "\\gt"), ">"),
    **dict.fromkeys(("\\le", "\\leq", "\\leqslant"), "<="),
    **dict.fromkeys(("\\ge", "\\geq", "\\geqslant"), ">="),
    **dict.fromkeys(("\\ne", "\\neq"), "!="),
    **dict.fromkeys(("\\simeq", "\\approx", "\\sim"), "~"),
    **dict.fromkeys(("\\to", "\\rightarrow"), "->"),
    "\\ll": "<<",
    "\\gg": ">>",
    "\\in": "in",
}
"""Relations as they are written, and as they are read."""
CALLS = _words("integral at between value diff O o")
"""Calls in the text that are the reader's own, not the author's functions."""
_LETTERS_OF_FUNCTIONS = _words("f g h F G")
_RESERVED = _words("E lambda pi") | frozenset(FUNCTIONS.values())
_SPACES = {"\\ "} | _words(
    "\\, \\; \\: \\! \\quad \\qquad \\displaystyle \\textstyle \\limits \\nonumber \\notag ~"
)
_SIZES = _words("\\big \\Big \\bigl \\bigr \\Bigl \\Bigr \\bigg \\Bigg")
_ARRAYS = _words("array aligned align align* gathered cases equation equation* split")
_STOPS = (",", ".", ";", "\\Rightarrow", "\\Longrightarrow", "\\implies")
_CLOSING = _words("+ - ) ] \\} } & : / |")
_UNITS = _words("rad s m kg cm mm")
_CONDITIONS = _words("for if when")

_TOKEN = re.compile(
    r"""(?P<space>\s+|%[^\n]*\n?)
      | (?P<command>\\(?:begin|end)\s*\{[a-zA-Z*]+\}|\\[a-zA-Z]+|\\.)
      | (?P<number>\d+(?:\.\d+)?|\.\d+)
      | (?P<other>:=|.)""",
    re.VERBOSE | re.DOTALL,
)


@dataclass(frozen=True)
class Relations:
    """A chain of relations: ``terms[0] ops[0] terms[1] ops[1] terms[2] …``.

    ``condition`` is the chain under which it is said to hold ("For γ > 0:" above a column).
    """

    terms: tuple[str, ...]
    ops: tuple[str, ...]
    condition: Relations | None = None

    def __str__(self) -> str:
        text = self.terms[0]
        for op, term in zip(self.ops, self.terms[1:], strict=True):
            text += f" {op} {term}"
        return text


class _Piece(NamedTuple):
    """Text and how strongly it binds: 1 sum, 2 product, 3 power, 4 atom."""

    text: str
    strength: int = 4
    symbol: bool = False

    def within(self, strength: int) -> str:
        return self.text if self.strength >= strength else f"({self.text})"


def read_expression(source: str) -> str:
    """One LaTeX expression as text of the expression grammar.

    Raises:
        InputError: LaTeX that is not read; one line says what and, where it helps, how to write it.
    """
    reader = _Reader(_tokens(source))
    text = reader.sum().text
    reader.skip_stops()
    if reader.peek():
        reader.refuse("an operation or the end is expected")
    return text


def read_latex(source: str, words: frozenset[str] = frozenset({"hot"})) -> tuple[Relations, ...]:
    """The relations that a displayed formula states, in order.

    Args:
        source: what stands between the delimiters of the display.
        words: runs of letters that are one name (the rest are products of letters).

    Raises:
        InputError: LaTeX that is not read; one line says what and, where it helps, how to write it.
    """
    return tuple(_statements(_tokens(source, words)))


def _tokens(source: str, words: frozenset[str] = frozenset()) -> list[str]:
    if len(source) > MAX_CHARACTERS:
        raise InputError(f"LaTeX: {len(source)} characters are beyond the limit {MAX_CHARACTERS}")
    raw = _merged(
        [m[0] for m in _TOKEN.finditer(_without_labels(source)) if m.lastgroup != "space"], words
    )
    depth = 0
    for token in raw:
        depth += (token in "{([") - (token in "})]")
        if depth > MAX_DEPTH:
            raise InputError(f"LaTeX: nested deeper than {MAX_DEPTH} levels")
    return raw


def _without_labels(source: str) -> str:
    """Without labels and the optional space after a line's end; upright text as commands."""
    source = re.sub(r"\\(?:label|tag|color)\s*\{[^{}]*\}", " ", source)
    source = re.sub(r"\\\\\s*\[[^\[\]]*\]", r"\\\\ ", source)
    return re.sub(
        r"(\\(?:text|textrm|mathrm|operatorname|mbox|textup))\s*\{([^{}]*)\}", _text, source
    )


def _text(match: re.Match[str]) -> str:
    """Upright text: a function's name, a differential's d, a unit, or a condition's "for"."""
    word = match[2].strip()
    if word in FUNCTIONS:
        return f"\\{word} "
    if word == "d":
        return " d "
    if word in _UNITS:
        return " "
    if word.lower() in _CONDITIONS:
        return " \\conditionfor "
    return f"{match[1]} "


def _merged(raw: list[str], words: frozenset[str]) -> list[str]:
    """Tokens without spacing and sizes; declared words become one token."""
    kept = [t for t in raw if t not in _SPACES and t not in _SIZES]
    result: list[str] = []
    i = 0
    while i < len(kept):
        word = next((w for w in words if kept[i : i + len(w)] == list(w)), None)
        if word:
            result.append(word)
            i += len(word)
        elif kept[i] in ("\\left", "\\right"):
            delimiter = kept[i + 1] if i + 1 < len(kept) else ""
            # "\left." and "\right." are invisible partners of an evaluation bar.
            result.append(f"{kept[i]}{delimiter}" if delimiter in (".", "|") else delimiter)
            i += 2
        else:
            result.append(
                {"\\lbrace": "\\{", "\\rbrace": "\\}", "\\vert": "|"}.get(kept[i], kept[i])
            )
            i += 1
    return result


def _statements(tokens: list[str]) -> list[Relations]:
    """The chains of a display: rows and cells of an array, or one formula."""
    if tokens and tokens[0].startswith("\\begin"):
        name = tokens[0][tokens[0].index("{") + 1 : -1]
        if name not in _ARRAYS:
            raise InputError(f"LaTeX: environment {name} is not read")
        if not tokens[-1].startswith("\\end") or tokens[-1][5:-1] != name:
            raise InputError(f"LaTeX: something follows the {name}, or it is not closed")
        return _rows(_body_of(tokens, name))
    return _chains(tokens)


def _body_of(tokens: list[str], name: str) -> list[str]:
    body = tokens[1:-1]
    if name == "array" and body[:1] == ["{"]:
        body = body[body.index("}") + 1 :]
    return body


def _rows(body: list[str]) -> list[Relations]:
    """Each cell is a statement; one that opens with a relation continues the cell before it."""
    cells: list[list[str]] = []
    columns: list[int] = []
    for row in _split(body, "\\\\"):
        for column, cell in enumerate(_split(row, "&")):
            if cell and cell[0] in RELATIONS and cells:
                cells[-1].extend(cell)
            elif cell:
                cells.append(cell)
                columns.append(column)
    found: list[Relations] = []
    conditions: dict[int, Relations] = {}
    for cell, column in zip(cells, columns, strict=True):
        if cell[0] == "\\conditionfor":
            (conditions[column],) = _chains([t for t in cell[1:] if t != ":"])
            continue
        condition = conditions.get(column)
        found.extend(Relations(c.terms, c.ops, condition) for c in _chains(cell))
    return found


def _split(tokens: list[str], separator: str) -> list[list[str]]:
    parts: list[list[str]] = [[]]
    for token in tokens:
        if token == separator:
            parts.append([])
        else:
            parts[-1].append(token)
    return parts


def _chains(tokens: list[str]) -> list[Relations]:
    reader = _Reader(tokens)
    chains: list[Relations] = []
    reader.skip_stops()
    while reader.peek():
        chains.extend(reader.chain())
        reader.skip_stops()
    if not chains:
        raise InputError("LaTeX: a relation such as a = b is expected, there is none")
    return chains


class _Reader:
    """Recursive descent over the tokens; every method returns text of the expression grammar."""

    def __init__(self, tokens: list[str]) -> None:
        self.tokens = tokens
        self.at = 0
        self.differentials: list[str] = []
        self.integrals = 0

    def peek(self, ahead: int = 0) -> str:
        i = self.at + ahead
        return self.tokens[i] if i < len(self.tokens) else ""

    def take(self, expected: str = "") -> str:
        token = self.peek()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        if expected and token != expected:
            self.refuse(f"{expected} is expected")
        self.at += 1
        return token

    def refuse(self, why: str) -> NoReturn:
        near = " ".join(self.tokens[max(0, self.at - 3) : self.at + 4])
        raise InputError(f"LaTeX: {why} at {self.peek() or 'the end'!a}, near {near!a}")

    def skip_stops(self) -> None:
        while self.peek() in _STOPS:
            self.at += 1

    # relations

    def chain(self) -> list[Relations]:
        """One chain; an interval on its right end becomes two inequalities."""
        terms, ops = [self.sum().text], []
        while self.peek() in RELATIONS:
            op = RELATIONS[self.take()]
            if op == "in":
                low, first, high, second = self.interval()
                return [Relations((low, terms[-1], high), (first, second))]
            ops.append(op)
            terms.append(self.sum().text)
        if not ops:
            self.refuse("a relation such as = is expected")
        if self.peek() and self.peek() not in _STOPS:
            self.refuse("a relation, a comma or the end is expected")
        return [Relations(tuple(terms), tuple(ops))]

    def interval(self) -> tuple[str, str, str, str]:
        opening = self.take()
        if opening not in ("[", "(", "]"):
            self.refuse("an interval is expected")
        low = self.sum().text
        self.take(",")
        high = self.sum().text
        closing = self.take()
        return low, "<=" if opening == "[" else "<", high, "<=" if closing == "]" else "<"

    # sums and products

    def sum(self) -> _Piece:
        terms = [self.signed()]
        while self.peek() in ("+", "-"):
            operator = self.take()
            terms.append(_Piece(f" {operator} {self.product().within(2)}"))
        if len(terms) == 1:
            return terms[0]
        return _Piece("".join(t.text for t in terms), 1)

    def signed(self) -> _Piece:
        if self.peek() in ("+", "-"):
            sign = self.take()
            piece = self.product()
            return _Piece(f"-{piece.within(2)}", 1) if sign == "-" else piece
        return self.product()

    def product(self) -> _Piece:
        """Factors side by side; a slash divides by one factor, and what follows it is refused."""
        factors, operators = [self.factor_or_differential()], [""]
        while not (self.integrals and factors[-1] is None):
            if self.peek() in ("/", "\\cdot", "\\times", "*"):
                operators.append("/" if self.take() == "/" else "*")
            elif self.starts_factor():
                if operators[-1] == "/" and not self.at_differential():
                    self.refuse("what is below the slash? Write it with \\frac or in brackets,")
                operators.append("*")
            else:
                break
            factors.append(self.factor_or_differential())
        return _joined(factors, operators)

    def factor_or_differential(self) -> _Piece | None:
        """A factor, or None where the differential of an integral was stepped over."""
        if not self.at_differential():
            return self.factor()
        self.take("d")
        self.differentials.append(self.symbol())
        return None

    def starts_factor(self) -> bool:
        token = self.peek()
        if not token or token in RELATIONS or token in _STOPS:
            return False
        return token not in _CLOSING and not token.startswith(("\\end", "\\right"))

    def at_differential(self) -> bool:
        """Inside an integral, ``d`` before a symbol."""
        return bool(self.integrals) and self.peek() == "d" and _is_letter(self.peek(1))

    # factors

    def factor(self) -> _Piece:
        base = self.base()
        while True:
            if self.peek() == "^":
                self.at += 1
                base = _Piece(f"{base.within(4)}**{self.script().within(4)}", 3)
            elif self.peek() == "|" and self.peek(1) == "_":
                self.at += 2
                base = self.evaluated(base.text)
            elif self.peek() == "(" and _is_derivative(base.text) and self.is_list():
                base = _Piece(f"value({base.text}, {', '.join(self.arguments())})")
            else:
                return base

    def script(self) -> _Piece:
        """An exponent: one token or a group."""
        if self.peek() == "{":
            return self.group()
        token = self.peek()
        if token.isdigit() and len(token) > 1:
            # x^12 is x¹·2 in TeX.
            self.refuse("an exponent of several digits needs braces")
        return self.base()

    def evaluated(self, text: str) -> _Piece:
        """The place of an evaluation bar, ``_{x = value}``."""
        self.take("{")
        name = self.sum().text
        self.take("=")
        value = self.sum().text
        self.take("}")
        return _Piece(f"at({text}, {name}, {value})")

    def group(self) -> _Piece:
        self.take("{")
        piece = self.sum()
        self.take("}")
        return piece

    def base(self) -> _Piece:
        token = self.peek()
        if token in ("(", "[", "\\{"):
            return self.bracket()
        if token == "{":
            return _Piece(self.group().within(4))
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
            return _Piece("inf")
        if token == "\\dot":
            return self.dotted()
        if token.lstrip("\\") in FUNCTIONS and token.startswith("\\"):
            return self.function()
        if re.fullmatch(r"\d.*|\.\d+", token):
            return _Piece(self.take())
        if _is_letter(token) or token in ("\\pi", "\\Delta", "\\partial") or token.isalpha():
            return self.named()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        self.refuse("this is not read")

    def bracket(self) -> _Piece:
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
            return _Piece(f"between({piece.text}, {low}, {self.script().text})")
        return _Piece(f"({piece.text})") if piece.strength < 4 else piece

    def absolute(self) -> _Piece:
        self.at += 1
        piece = self.sum()
        if self.take() not in ("|", "\\right|"):
            self.at -= 1
            self.refuse("the bar | is not closed")
        return _Piece(f"abs({piece.text})")

    def barred(self) -> _Piece:
        """``\\left. … \\right|_{x = value}``."""
        self.take("\\left.")
        piece = self.sum()
        self.take("\\right|")
        self.take("_")
        return self.evaluated(piece.text)

    def root(self) -> _Piece:
        self.take("\\sqrt")
        if self.peek() == "[":
            self.take()
            index = self.sum().text
            self.take("]")
            radicand = self.argument_group()
            return _Piece(f"{radicand.within(4)}**(1/{index})", 3)
        return _Piece(f"sqrt({self.argument_group().text})")

    def argument_group(self) -> _Piece:
        """The argument of a command: a group, or one token."""
        return self.group() if self.peek() == "{" else self.base()

    def fraction(self) -> _Piece:
        derivative = self.derivative()
        if derivative is not None:
            return derivative
        self.take()
        if re.fullmatch(r"\d\d", self.peek()):
            # TeX's \frac12 is one half.
            digits = self.take()
            return _Piece(f"{digits[0]}/{digits[1]}", 2)
        top = self.numerator()
        return _Piece(f"{top.within(2)}/{self.argument_group().within(4)}", 2)

    def numerator(self) -> _Piece:
        if self.peek() == "{" and self.peek(1) == "}":
            self.refuse("an empty numerator")
        return self.argument_group()

    def derivative(self) -> _Piece | None:
        """``\\frac{dy}{dx}`` as one symbol, ``\\frac{d}{dx} e`` as ``diff(e, x)``; else None."""
        start = self.at
        self.take()
        found = self._derivative_parts()
        if found is None:
            self.at = start
            return None
        above, below, d = found
        if not above:
            return _Piece(f"diff({self.factor().text}, {below})")
        return _Piece(f"{d}{above}_{d}{below}")

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

    def dotted(self) -> _Piece:
        self.take("\\dot")
        braced = self.peek() == "{"
        if braced:
            self.at += 1
        name = self.symbol()
        if braced:
            self.take("}")
        return _Piece(f"d{name}_dt")

    def function(self) -> _Piece:
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
        return _Piece(f"{text}**{exponent}", 3) if exponent else _Piece(text)

    def argument(self) -> str:
        if self.peek() in ("(", "[", "{"):
            inner = self.base().text
            return inner[1:-1] if _is_enclosed(inner) else inner
        text = ""
        while re.fullmatch(r"\d.*", self.peek()):
            text += f"{self.take()}*"
        piece = self.factor()
        if piece.symbol or text:
            ahead = self.peek()
            if _is_letter(ahead) and not (ahead == "d" and self.integrals):
                self.refuse("where does the function's argument end? Write it in brackets,")
        return text + piece.within(3 if text else 1)

    def integral(self) -> _Piece:
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
        return _Piece(f"integral({body}, {variables.pop()}, {low}, {high})")

    def integrand(self) -> str:
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

    def named(self) -> _Piece:
        """A symbol, an inline derivative, ``e^{…}``, or an author's function."""
        token = self.peek()
        if token in ("d", "\\partial") and self.inline_derivative():
            return self.slashed_derivative()
        if token == "e" and self.peek(1) == "^":
            self.at += 2
            return _Piece(f"exp({self.script().text})")
        if token == "e":
            self.take()
            return _Piece("E")
        if token == "\\pi":
            self.take()
            return _Piece("pi")
        if token in ("O", "o") and self.peek(1) == "(":
            self.take()
            return _Piece(f"{token}({', '.join(self.arguments())})")
        name = self.symbol()
        if self.peek() == "(" and self.is_application(name):
            return _Piece(f"{name}({', '.join(self.arguments())})")
        return _Piece(name, symbol=True)

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

    def slashed_derivative(self) -> _Piece:
        d = "d" if self.take() == "d" else "partial"
        above = self.symbol().rstrip("_")
        self.at += 2
        return _Piece(f"{d}{above}_{d}{self.symbol().rstrip('_')}")

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
        return f"{name}_" if name in _RESERVED else name

    def subscript(self) -> str:
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
        if name in _LETTERS_OF_FUNCTIONS or self.is_list():
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
        self.take("(")
        found = [self.sum().text]
        while self.peek() == ",":
            self.take()
            found.append(self.sum().text)
        self.take(")")
        return found


def _joined(factors: list[_Piece | None], operators: list[str]) -> _Piece:
    """The product of ``factors``; differentials (None) are left out."""
    kept = [(f, op) for f, op in zip(factors, operators, strict=True) if f is not None]
    if not kept:
        return _Piece("1")
    if len(kept) == 1:
        return kept[0][0]
    text = kept[0][0].within(2) + "".join(op + factor.within(3) for factor, op in kept[1:])
    return _Piece(_power_of_ten(text), 2)


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
