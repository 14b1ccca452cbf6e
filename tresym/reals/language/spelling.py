"""Expressions as people type them, written in the grammar: ``2x`` as ``2*x``.

A recursive descent over :mod:`tresym.reals.language.spelling_tokens`. It knows implicit products,
functions without parentheses (``sin 2x``), powers of functions (``sin^2 x``), factorials, degrees,
and the integrals, sums, limits and derivatives of handwriting, SymPy, Mathematica and Maple. What
can be read in two ways is refused, with both written out. Nothing is evaluated: the result is text,
which the strict reader of :mod:`tresym.reals.language.parsing` reads.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from itertools import pairwise
from typing import NamedTuple

from tresym.reals.language.expression import ORDERS
from tresym.reals.language.parsing import KNOWN, UNKNOWN
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
_CAPITALS = {
    f"{prefix}{name.capitalize()}": f"{short}{name}"
    for prefix, short in (("", ""), ("Arc", "a"))
    for name in (
        *("sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh", "coth", "sech", "csch"),
    )
}
FUNCTIONS = {
    **{name: name for name in KNOWN - {"diff", "Derivative"}},
    **_CAPITALS,
    **{"Sqrt": "sqrt", "Exp": "exp", "Log": "log", "Ln": "log", "Sign": "sign", "fabs": "abs"},
    **{"tg": "tan", "ctg": "cot", "arctg": "atan", "arcctg": "acot", "CubeRoot": "cbrt"},
    **{"factorial": "factorial", "Factorial": "factorial"},
}
_CHOOSE = frozenset(("binomial", "Binomial", "binom", "choose", "comb", "nCr", "C"))
_BIG = {
    **dict.fromkeys(("∫", "int", "Int", "integral", "integrate", "Integral", "Integrate"), "int"),
    **dict.fromkeys(("∑", "sum", "Sum", "summation"), "sum"),
    **dict.fromkeys(("∏", "prod", "product", "Product"), "product"),
    **dict.fromkeys(("lim", "limit", "Limit"), "limit"),
}
_DERIVED = frozenset(("D", "diff", "Derivative"))
_CLOSING = {"(": ")", "[": "]", "{": "}"}
_SIDES = {"+": "1", "-": "-1", "+-": "0", "right": "1", "left": "-1"}


class NotSpelledError(Exception):
    """The text is not understood here either: what the strict reader says of it stands."""


def two(one: str, other: str) -> InputError:
    """The refusal of what can be read in two ways."""
    return InputError(f"two readings remain: write {_bare(one)} or {_bare(other)}")


def _bare(text: str) -> str:
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


class Speller:
    """Reads tokens from left to right; what it returns is text of the grammar."""

    def __init__(self, found: list[Token]) -> None:
        self.tokens = found
        self.at = 0
        self.bars = 0
        self.under: list[str] = []
        """The big operators that are open: what ends their bodies is no factor."""
        names = [token.text for token in found if token.kind == "name"]
        self.brackets = any(
            token.text in FUNCTIONS or token.text in _BIG or token.text == "D"
            for token, after in pairwise(found)
            if after.text == "[" and not after.spaced
        )
        self.alone = {
            token.text
            for token, after in zip(found, [*found[1:], END], strict=True)
            if token.kind == "name" and after.text not in ("(", "[")
        } - RESERVED
        self.names = set(names)
        self.maple = any(token.text == ".." for token in found)

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

    # Sums and products.

    def sum(self) -> str:
        """An expression."""
        text = self.product()
        while self.peek().text in ("+", "-"):
            sign = self.next().text
            text += f" {sign} {self.product()}"
        return text

    def product(self) -> str:
        """Factors, between some of which the sign is left out."""
        text = last = self.unary()
        slash = ""
        while True:
            if self.peek().text in ("*", "/"):
                sign = self.next().text
                if sign == "/":
                    slash = text
                last = self.unary()
                text = f"{text}{sign}{last}"
                slash = slash if sign == "/" else ""
            elif self.starts_factor():
                factor = self.power()
                if slash:
                    raise two(f"({slash}/{last})*{factor}", f"{slash}/({last}*{factor})")
                text = f"{text}*{factor}"
            else:
                return text

    def starts_factor(self) -> bool:
        """Whether a factor follows without a sign."""
        token = self.peek()
        if token.kind == "name":
            if not token.spaced and self.at and self.tokens[self.at - 1].text == "0":
                raise NotSpelledError  # 0x10 is no product
            ends = "int" in self.under and re.fullmatch("d[a-zA-Z]", token.text)
            return token.text not in RESERVED and not ends
        if token.kind == "number":
            if self.at and self.tokens[self.at - 1].kind == "number":
                raise NotSpelledError
            return True
        if token.text == "(" and self.peek(1).text in RESERVED:
            return False
        return token.text in ("(", "∫", "∑", "∏") or (token.text == "|" and not self.bars)

    def unary(self) -> str:
        """A power with its signs."""
        if self.peek().text in ("+", "-"):
            sign = self.next().text
            inner = self.unary()
            return f"(-{inner})" if sign == "-" else inner
        return self.power()

    def power(self) -> str:
        """``a^b``, with what stands behind ``a``."""
        base = self.behind(self.atom())
        if not self.take("^", "**"):
            return base
        first = self.peek()
        exponent = self.unary()
        after, closed = self.peek(), first.text == "("
        last = self.tokens[self.at - 1]
        plain = last.kind in ("number", "name") and not closed
        glued = not after.spaced and "name" in (after.kind, last.kind)
        if plain and glued and self.starts_factor():
            factor = self.power()
            raise two(f"{base}**{exponent}*{factor}", f"{base}**({exponent}*{factor})")
        return f"{base}**{exponent}"

    def behind(self, text: str) -> str:
        """What stands behind an operand: ``!``, ``°``, ``'``."""
        while True:
            if self.peek().text == "!":
                self.next()
                if self.peek().text == "!" and not self.peek().spaced:
                    raise InputError(
                        f"two readings remain: write factorial(factorial({_bare(text)})), or the "
                        "double factorial as a product"
                    )
                text = f"factorial({_bare(text)})"
            elif self.peek().text == "°" or self.peek().text in ("deg", "degrees"):
                self.next()
                text = f"({text}*pi/180)"
            elif self.peek().text == "'":
                self.next()
                text = f"diff({_bare(text)}, {self.only_variable(text)})"
            else:
                return text

    def only_variable(self, text: str) -> str:
        """The one variable of a text, by which a derivative without a name is."""
        names = set(re.findall(r"[A-Za-z_]\w*(?!\w*\()", text)) - {"pi", "E", "e"}
        if len(names) != 1:
            raise InputError("a derivative is written diff(f, x), with the variable it is by")
        return names.pop()

    # Operands.

    def atom(self) -> str:
        """A number, a name, a function at its arguments, or what is in parentheses."""
        token = self.next()
        if token.kind == "number" or token.text == "...":
            return token.text
        if token.text in ("∫", "∑", "∏"):
            return self.big(_BIG[token.text], token)
        if token.text in ("(", "["):
            return f"({self.inside(_CLOSING[token.text])})"
        if token.text == "|":
            self.bars += 1
            text = self.sum()
            self.need("|")
            self.bars -= 1
            return f"abs({text})"
        if token.kind != "name" or token.text in RESERVED:
            raise NotSpelledError
        return self.named(token)

    def inside(self, close: str) -> str:
        """The expression up to a closing bracket, which bars and big operators do not cross."""
        bars, self.bars, under, self.under = self.bars, 0, self.under, []
        text = self.sum()
        self.need(close)
        self.bars, self.under = bars, under
        return text

    def named(self, token: Token) -> str:
        """What begins with a name."""
        name, after = token.text, self.peek().text
        if name in INFINITE:
            return "oo"
        if name == "d" and (found := self.derivative()):
            return found
        if re.fullmatch("d[a-zA-Z]", name) and after == "/" and self.peek(1).text[:1] == "d":
            raise InputError(f"a derivative is written diff(f, x): write {name[1:]} out")
        opens = after in ("(", "[") and not (after == "[" and self.peek().spaced)
        if name in _BIG and self.is_big(name):
            return self.big(_BIG[name], token)
        if name in _DERIVED and opens:
            return self.derived()
        if name in _CHOOSE and opens and (name != "C" or self.has_comma()):
            n, k = self.plain_arguments(2)
            return f"(factorial({n})/(factorial({k})*factorial({n} - ({k}))))"
        if base := re.fullmatch(r"log_?(\d+|[a-z])", name):
            return self.logarithm(base[1])
        if name in ("lg", "ld") and opens:
            (x,) = self.plain_arguments(1)
            raise two(f"log({x}, 10)", f"log({x}, 2)")
        if name in ("pow", "Power") and opens:
            x, y = self.plain_arguments(2)
            return f"({x})**({y})"
        if name == "Rational" and opens:
            p, q = self.plain_arguments(2)
            return f"({p}/{q})"
        if name in FUNCTIONS:
            return self.function(FUNCTIONS[name])
        if after == "'":
            return self.primed(name)
        if opens:
            return self.letter(name, token)
        return self.constant(name)

    def constant(self, name: str) -> str:
        """A name that stands by itself."""
        if name == "Pi":
            if self.brackets or self.maple:
                return "pi"
            raise InputError("two readings remain: write pi, or the variable Pi by another name")
        if name == "I":
            raise InputError("complex numbers are not read: all variables are real")
        letters = set(name)
        short = 1 < len(name) < 4 and name.isalpha() and name not in KNOWN | {"pi"}
        if short and letters <= self.alone:
            raise InputError(
                f"two readings remain: write {'*'.join(name)}, or the variable {name} by another "
                "name"
            )
        return name

    def letter(self, name: str, token: Token) -> str:
        """A letter before parentheses: a function that is left unknown, or a factor."""
        if name in self.alone or name in ("pi", "E", "e"):
            self.need_product(name)
            return self.constant(name)
        if UNKNOWN.fullmatch(name) or name in ORDERS:
            return f"{name}({', '.join(self.plain_arguments())})"
        if len(name) == 1:
            raise InputError(
                f"{name} is no function; for a product write {name}*(…), for a function f(…)"
            )
        return f"{name}({', '.join(self.plain_arguments())})"

    def need_product(self, name: str) -> None:
        """That no value of a function is meant by what is read as a product."""
        inside = self.peek(1)
        if inside.kind == "number" and self.peek(2).text in (")", "]"):
            raise InputError(
                f"two readings remain: write {name}*{inside.text}, or the value of the function "
                f"{name} as at(f, x, {inside.text})"
            )
        closing = next((n for n, t in enumerate(self.tokens) if n > self.at and t.text == ")"), 0)
        if UNKNOWN.fullmatch(name) and name not in {t.text for t in self.tokens[self.at : closing]}:
            raise NotSpelledError

    def primed(self, name: str) -> str:
        """``f'(x)`` of a function that is left unknown, behind its name."""
        start = self.at
        while self.take("'"):
            pass
        times = self.at - start
        if not UNKNOWN.fullmatch(name) or self.peek().text != "(":
            raise InputError(f"a derivative is written diff(f, x): write {name} out, or {name}(x)")
        (x,) = self.plain_arguments(1)
        if not x.isidentifier():
            raise InputError(f"a derivative at a point is written at(diff({name}(x), x), x, {x})")
        return f"diff({name}({x}), {x}{f', {times}' if times > 1 else ''})"

    def function(self, name: str) -> str:
        """A function of the grammar with its argument, in parentheses or not, its power between."""
        exponent = ""
        if self.peek().text in ("^", "**"):
            self.next()
            sign = self.take("-")
            closed = self.take("(")
            exponent = (sign or self.take("-")) + self.next().text
            if closed:
                self.need(")")
            if not re.fullmatch(r"-?(?:\d+|[a-z])", exponent):
                raise NotSpelledError
        prime = self.take("'")
        if self.peek().text in ("(", "["):
            args = self.plain_arguments()
        elif self.starts_factor() or self.peek().text in ("-", "√"):
            args = [self.bare_argument(name, exponent)]
        else:
            raise NotSpelledError
        text = f"{name}({', '.join(args)})"
        if prime:
            text = f"diff({text}, {self.only_variable(args[0])})"
        if exponent.startswith("-"):
            inverse = {"sin", "cos", "tan", "cot", "sec", "csc", "sinh", "cosh", "tanh"}
            other = f"a{name}({args[0]})" if name in inverse else f"the inverse of {name}"
            raise two(f"1/{text}" if exponent == "-1" else f"{text}**({exponent})", other)
        return f"{text}**{exponent}" if exponent else text

    def bare_argument(self, name: str, exponent: str) -> str:
        """The argument of a function that stands without parentheses, as in ``sin 2x``."""
        sign = "-" if self.take("-") else ""
        factors = [self.factor()]
        while self.starts_factor() and not self.is_function(self.peek()):
            before = self.tokens[self.at - 1]
            if self.peek().text in ("(", "|") and before.kind != "number":
                break
            factors.append(self.factor())
        text = sign + "*".join(factors)
        power = f"**{exponent}" if exponent else ""
        if len(factors) > 1 and name in ("sqrt", "cbrt"):
            rest = "*".join(factors[1:])
            raise two(f"{name}({factors[0]})*{rest}", f"{name}({text})")
        after = self.peek().text
        if after == "(":
            raise two(f"{name}({text}){power}*(…)", f"{name}({text}*(…)){power}")
        if after in ("^", "**"):
            self.next()
            k = self.unary()
            raise two(f"{name}({text}**{k}){power}", f"{name}({text})**{k}")
        ended = name in ("sqrt", "cbrt") or self.is_function(self.peek(1))
        if after in ("*", "/") and not ended:
            self.next()
            factor = self.unary()
            inner = f"{name}({text}{after}{factor}){power}"
            raise two(f"{name}({text}){power}{after}{factor}", inner)
        return text

    def factor(self) -> str:
        """One factor of a bare argument."""
        return self.behind(self.atom())

    def is_function(self, token: Token) -> bool:
        """Whether a token begins a function or a big operator."""
        return token.text in FUNCTIONS or token.text in _BIG

    def logarithm(self, base: str) -> str:
        """``log2(x)``, ``log_10 x``."""
        if self.peek().text in ("(", "["):
            (x,) = self.plain_arguments(1)
        elif self.starts_factor():
            x = self.bare_argument("log", "")
        else:
            raise NotSpelledError
        return f"log({x}, {base})"

    # Arguments.

    def has_comma(self) -> bool:
        """Whether the parentheses that follow hold several arguments."""
        depth = 0
        for token in self.tokens[self.at :]:
            depth += (token.text in _CLOSING) - (token.text in (")", "]", "}"))
            if token.text == "," and depth == 1:
                return True
            if depth == 0:
                return False
        return False

    def plain_arguments(self, count: int | None = None) -> list[str]:
        """The arguments of a function, expressions all of them."""
        found = self.arguments()
        if any(isinstance(item, Range) for item in found):
            raise NotSpelledError
        if count is not None and len(found) != count:
            raise NotSpelledError
        return [str(item) for item in found]

    def arguments(self) -> list[str | Range]:
        """What stands in parentheses or brackets, between commas."""
        close = _CLOSING[self.need("(", "[")]
        bars, self.bars, under, self.under = self.bars, 0, self.under, []
        found: list[str | Range] = []
        while True:
            found.append(self.item())
            if not self.take(","):
                break
        self.need(close)
        self.bars, self.under = bars, under
        return found

    def item(self) -> str | Range:
        """One argument: an expression, a range, or the side of a limit."""
        token, after = self.peek(), self.peek(1)
        if token.text == "dir" and after.text == "=":
            self.at += 2
            token = self.peek()
        if token.kind == "quoted":
            return Range("", (), _SIDES[self.next().text.strip("'\"")])
        if token.text in ("right", "left"):
            return Range("", (), _SIDES[self.next().text])
        if token.text in ("(", "{") and after.kind == "name" and self.peek(2).text == ",":
            self.at += 1
            name = self.name()
            ends = []
            while self.take(","):
                ends.append(self.sum())
            self.need(_CLOSING[token.text])
            return Range(name, tuple(ends))
        if token.kind == "name" and after.text in ("=", "->"):
            self.at += 2
            return self.tending(token.text, after.text)
        return self.sum()

    def tending(self, name: str, sign: str) -> Range:
        """``x = a .. b``, ``x = a`` or ``x -> a+``, behind the sign."""
        low = self.signed_end() if sign == "->" else self.sum()
        if self.take(".."):
            return Range(name, (low, self.sum()))
        side = ""
        if sign == "->" and self.peek().text in ("+", "-", "^"):
            self.take("^")
            side = _SIDES[self.need("+", "-")]
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
        return f"diff({_bare(body)}, {name}{order})"

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
            return self.inside(_CLOSING[self.next().text])
        sign = "-" if self.take("-") else ""
        token = self.next()
        if token.kind not in ("number", "name"):
            raise NotSpelledError
        return sign + ("oo" if token.text in INFINITE else token.text)

    def bound_variable(self, kind: str) -> Range:
        """``k=1`` or ``x->0`` under a sum or a limit."""
        close = _CLOSING.get(self.take("(", "{"), "")
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
    return _bare(text) != text


def _limit(body: str, found: Range) -> str:
    side = f", {found.side}" if found.side else ""
    return f"limit({_bare(body)}, {found.name}, {found.ends[0]}{side})"


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
