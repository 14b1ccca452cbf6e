"""Expressions as people type them, written in the grammar: ``2x`` as ``2*x``.

A recursive descent over :mod:`tresym.reals.language.spelling_tokens`. It knows implicit products,
functions without parentheses (``sin 2x``), powers of functions (``sin^2 x``), factorials and
degrees; :mod:`tresym.reals.language.spelling_operators` knows integrals, sums, limits and
derivatives. What can be read in two ways is refused, with both written out. Nothing is evaluated:
the result is text, which the strict reader of :mod:`tresym.reals.language.parsing` reads.
"""

from __future__ import annotations

import re
from itertools import pairwise

from tresym.reals.functions.table import TABLE
from tresym.reals.language.calls import KNOWN, MODULUS, UNKNOWN
from tresym.reals.language.expression import ORDERS
from tresym.reals.language.spelling_operators import (
    BIG,
    CLOSING,
    INFINITE,
    RESERVED,
    SIDES,
    NotSpelledError,
    OperatorSpeller,
    Range,
    bare,
    two,
)
from tresym.reals.language.spelling_tokens import END, Token
from tresym.reals.numbers.exact import InputError

_CAPITALS = {row.mathematica: row.name for row in TABLE.values() if row.theory and row.arity == 1}
_CAPITALS |= {
    f"Arc{alias[1:].capitalize()}": alias
    for row in TABLE.values()
    for alias in row.of_reciprocal
    if not alias.startswith("arc")
}
FUNCTIONS = {
    **{name: name for name in KNOWN - {"diff", "Derivative"}},
    **_CAPITALS,
    **{"Sqrt": "sqrt", "Ln": "log", "fabs": "abs"},
    **{"tg": "tan", "ctg": "cot", "arctg": "atan", "arcctg": "acot"},
    **{"factorial": "factorial", "Factorial": "factorial"},
}
_CHOOSE = frozenset(("binomial", "Binomial", "binom", "choose", "comb", "nCr", "C"))
_LOGARITHMS = frozenset(("log", "ln", "Log", "Ln"))
_DERIVED = frozenset(("D", "diff", "Derivative"))


class Speller(OperatorSpeller):
    """Reads tokens from left to right; what it returns is text of the grammar."""

    def __init__(self, found: list[Token]) -> None:
        super().__init__(found)
        self.bars = 0
        names = [token.text for token in found if token.kind == "name"]
        self.brackets = any(
            token.text in FUNCTIONS or token.text in BIG or token.text == "D"
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
                        f"two readings remain: write factorial(factorial({bare(text)})), or the "
                        "double factorial as a product"
                    )
                text = f"factorial({bare(text)})"
            elif self.peek().text == "°" or self.peek().text in ("deg", "degrees"):
                self.next()
                text = f"({text}*pi/180)"
            elif self.peek().text == "'":
                self.next()
                text = f"diff({bare(text)}, {self.only_variable(text)})"
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
            return self.big(BIG[token.text], token)
        if token.text in ("(", "["):
            return f"({self.inside(CLOSING[token.text])})"
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
        if name in BIG and self.is_big(name):
            return self.big(BIG[name], token)
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
        if name in _LOGARITHMS and opens and (found := self.to_base(name)):
            return found
        if name in MODULUS and self.brackets:
            return self.function(MODULUS[name])
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
        elif self.peek().kind == "number" or self.starts_factor() or self.peek().text == "-":
            args = [self.bare_argument(name, exponent)]
        else:
            raise NotSpelledError
        text = f"{name}({', '.join(args)})"
        if prime:
            text = f"diff({text}, {self.only_variable(args[0])})"
        if exponent.startswith("-"):
            other = f"a{name}({args[0]})" if f"a{name}" in KNOWN else f"the inverse of {name}"
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
        return token.text in FUNCTIONS or token.text in BIG

    def to_base(self, name: str) -> str:
        """``Log[2, 8]`` of Mathematica, base first, and ``log[2](8)`` of Maple; else nothing."""
        start, square = self.at, self.peek().text == "["
        args = self.plain_arguments()
        if square and len(args) == 1 and self.peek().text == "(" and not self.peek().spaced:
            (x,) = self.plain_arguments(1)
            return f"log({x}, {args[0]})"
        if len(args) == 2 and square:
            return f"log({args[1]}, {args[0]})"
        if len(args) == 2 and name[0].isupper():
            raise two(f"log({args[0]}, {args[1]})", f"log({args[1]}, {args[0]})")
        self.at = start
        return ""

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
            depth += (token.text in CLOSING) - (token.text in (")", "]", "}"))
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
        close = CLOSING[self.need("(", "[")]
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
            return Range("", (), SIDES[self.next().text.strip("'\"")])
        if token.text in ("right", "left"):
            return Range("", (), SIDES[self.next().text])
        if token.text in ("(", "{") and after.kind == "name" and self.peek(2).text == ",":
            self.at += 1
            name = self.name()
            ends = []
            while self.take(","):
                ends.append(self.sum())
            self.need(CLOSING[token.text])
            return Range(name, tuple(ends))
        if token.kind == "name" and after.text in ("=", "->"):
            self.at += 2
            return self.tending(token.text, after.text)
        return self.sum()
