"""The grammar of LaTeX expressions: recursive descent from tokens to text.

The text is of the expression grammar of :mod:`tresym.identity.parsing`, with the additions that
:mod:`tresym.identity.latex` lists.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import NoReturn

from tresym.exact import InputError
from tresym.identity.latex_reach import (
    Ahead,
    Piece,
    Reach,
    after_braces,
    after_bracket,
    after_derivative,
    after_derivative_of_bracket,
    after_open,
    joined,
    whole,
)
from tresym.identity.latex_tokens import (
    CLOSING,
    FUNCTIONS,
    GREEK,
    LETTERS_OF_FUNCTIONS,
    RELATIONS,
    RESERVED,
    STOPS,
    Spaced,
)

_BRACKETS = {"(": ")", "[": "]", "\\{": "\\}"}
_FRACTIONS = ("\\frac", "\\dfrac", "\\tfrac")
_OPERATORS = ("/", "\\cdot", "\\times", "*")
_DIFFERENTIALS = ("d", "\\partial")
_OPENING, _CLOSED = (*_BRACKETS, "{"), (*_BRACKETS.values(), "}")
_WORDS = sorted((*FUNCTIONS, "sqrt", *(g for g in GREEK if len(g) > 3)), key=len, reverse=True)
_NO_DERIVATIVE = (
    "a derivative of a symbol is not known: write \\frac{d}{dx} (…) with what it stands for,"
)
_INSTEAD = {
    "\\int": "integrals are not read: write \\frac{d}{dx} (F) = f of an antiderivative F,",
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


class Reader:
    """Recursive descent over the tokens; every method returns text of the expression grammar.

    Attributes:
        author: whether ``f(x)``, ``dy/dx`` and ``\\dot x`` are symbols of the author's, and the
            shorter of two readings is taken, as where a claim is compared with what is read. Else
            they are refused.
    """

    def __init__(self, tokens: list[str], author: bool = False) -> None:
        self.tokens = tokens
        self.author = author
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

    def two_readings(self, first: Piece | str, second: Piece | str) -> NoReturn:
        """Refuse what can be read in two ways, with both written out."""
        one, other = (p.text if isinstance(p, Piece) else p for p in (first, second))
        near = " ".join(self.tokens[max(0, self.at - 6) : self.at + 1])
        raise InputError(f"LaTeX: two readings remain: write {one} or {other}, near {near!a}")

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
        return Piece("".join(t.text for t in terms), 0)

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
        while not (self.integrals and factors[-1] is None) and self.continues():
            self.extend(factors, operators)
        return joined(factors, operators)

    def continues(self) -> bool:
        """Whether another factor of the same product follows."""
        return self.peek() in _OPERATORS or self.starts_factor()

    def extend(self, factors: list[Piece | None], operators: list[str]) -> None:
        """One more factor of a product, which a sign may lead in."""
        if self.peek() in _OPERATORS:
            operators.append("/" if self.take() == "/" else "*")
            factors.append(self.factor_or_differential())
            return
        last = factors[-1] or Piece("")
        if operators[-1] == "/" and not self.at_differential():
            self.refuse("what is below the slash? Write it with \\frac or in brackets,")
        if _is_number(self.peek()) and _is_number(self.tokens[self.at - 1]):
            self.refuse("two numbers side by side: one with spaces, or a product?")
        if last.symbol and self.peek() == "(" and not self.author:
            factors.append(self.factor_in_brackets(last))
        else:
            factors.append(self.factor_or_differential())
        operators.append("*")
        if _is_number(last.text) and factors[-1] and re.fullmatch(r"\d+/\d+", factors[-1].text):
            self.two_readings(f"{last.text} + {factors[-1].text}", joined(factors, operators))

    def factor_in_brackets(self, symbol: Piece) -> Piece:
        """The bracket behind a symbol, where a product needs it: x(x + 1), and (a/r)² behind V.

        Without that need, as in x(0), it may hold the argument of a function.
        """
        name = symbol.text.split("*")[0]
        if self.is_list():
            self.refuse(f"{name}(…) is a function that is not known: write out what it is,")
        start = self.at
        inner = self.enclosed()
        needed = inner.strength == 0 or (1 < inner.strength < 4 and self.peek() == "^")
        if not needed or name in LETTERS_OF_FUNCTIONS:
            value = f"{name}_1 for the value of a function {name}"
            self.two_readings(joined([symbol, inner], ["", "*"]), value)
        self.at = start
        return self.factor()

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

    def ahead(self) -> Ahead:
        """What follows in this product."""
        if not self.continues() or self.at_differential():
            return Ahead("")
        operator = self.peek() if self.peek() in _OPERATORS else ""
        i = self.at + bool(operator)
        sign = operator and ("/" if operator == "/" else "*")
        return Ahead(self.kind(i), sign, isinstance(self.tokens[self.at], Spaced))

    def kind(self, i: int) -> str:
        """Of the factor that begins at token ``i``."""
        token = self.tokens[i] if i < len(self.tokens) else ""
        if token.startswith("\\") and token[1:] in FUNCTIONS:
            return "inverse" if FUNCTIONS[token[1:]].startswith("a") else "function"
        if token == "\\int":
            return "function"
        if token in ("\\dot", "\\ddot") or self.is_derivative_at(i):
            return "derivative"
        if token in _BRACKETS:
            return "bracket"
        if token in _FRACTIONS:
            return "fraction"
        exponential = token == "e" and self.tokens[i + 1 : i + 2] == ["^"]
        return "letter" if (_is_letter(token) or token == "\\pi") and not exponential else "other"

    def operand(
        self,
        applied: Callable[[Piece], Piece],
        first: Piece,
        rule: Callable[[Piece, Ahead], Reach],
        matters: Callable[[Piece], bool] = lambda _: True,
    ) -> Piece:
        """``applied`` to ``first`` and to what follows, as far as the rule for it goes.

        Where it is in doubt whether the next factor belongs to it, and that matters, the author's
        reading is the shorter, and anybody else's is refused.
        """
        factors: list[Piece | None] = [first]
        operators = [""]
        while True:
            so_far = joined(factors, operators)
            reach = rule(so_far, self.ahead())
            if reach is Reach.ENDS or (reach is Reach.DOUBT and self.author):
                return applied(so_far)
            self.extend(factors, operators)
            last = factors[-1]
            if reach is Reach.DOUBT and last is not None and matters(last):
                apart = joined([applied(so_far), last], ["", operators[-1]])
                self.two_readings(applied(joined(factors, operators)), apart)

    # factors

    def factor(self) -> Piece:
        """A base with its powers, evaluation bars and values at a point."""
        base = self.base()
        while True:
            if self.peek() == "^":
                self.at += 1
                power = f"{base.within(4)}**{self.script().within(4)}"
                base = Piece(power, 3, base.symbol)
            elif self.peek() == "|" and self.peek(1) == "_":
                self.at += 2
                base = self.evaluated(base.text)
            elif self.peek() == "(" and _is_derivative(base.text) and self.is_list():
                base = Piece(f"value({base.text}, {', '.join(self.arguments())})")
            else:
                return base

    def script(self) -> Piece:
        """An exponent or a limit: a group, or one token."""
        inside = self.tokens[self.at + 1 : self.at + 5]
        raised = self.tokens[self.at - 2]
        if inside[0:1] + inside[2:] == ["(", ")", "}"] and not (
            raised == "e" or _is_number(raised)
        ):
            self.refuse("one thing in brackets above a name counts derivatives: write it without,")
        return self.argument_group()

    def evaluated(self, text: str) -> Piece:
        """The place of an evaluation bar, ``_{x = value}``."""
        if not self.author:
            self.refuse("a value at a point is not read: put the point in,")
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
            return self.braces()
        if token in ("|", "\\left|"):
            return self.absolute()
        if token == "\\left.":
            return self.barred()
        if token in _FRACTIONS:
            return self.fraction()
        if token == "\\sqrt":
            return self.root()
        if token == "\\int" and self.author:
            return self.integral()
        if token == "\\infty":
            self.take()
            return Piece("inf")
        if token == "\\dot" and self.author:
            return self.dotted()
        if token.lstrip("\\") in FUNCTIONS and token.startswith("\\"):
            return self.function()
        if re.fullmatch(r"\d.*|\.\d+", token):
            return Piece(self.take())
        if _is_letter(token) or token in ("\\pi", "\\Delta", "\\partial") or token.isalpha():
            return self.named()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        self.refuse(_INSTEAD.get(token, "this is not read"))

    def enclosed(self) -> Piece:
        """What stands in a bracket."""
        opening = self.take()
        piece = self.sum()
        if self.take() != _BRACKETS[opening]:
            self.at -= 1
            self.refuse(f"the bracket {opening} is not closed")
        return piece

    def bracket(self) -> Piece:
        """A bracket; with limits behind it, the difference of values at its ends."""
        opening, piece = self.peek(), self.enclosed()
        if opening == "[" and self.peek() == "_" and self.author:
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
        """A square root, or a root with an index; an odd one is real for every real number."""
        self.take("\\sqrt")
        if self.peek() != "[":
            return Piece(f"sqrt({self.argument_group().text})")
        self.take()
        index = self.sum()
        self.take("]")
        radicand = self.argument_group()
        if index.text.startswith("-"):
            self.refuse("a root with a negative index: write 1 over the root,")
        if not index.text.isdigit() or int(index.text) % 2 == 0 or _is_number(radicand.text):
            return Piece(f"{radicand.within(4)}**(1/{index.within(4)})", 3)
        if index.text == "3":
            return Piece(f"cbrt({radicand.text})")
        return Piece(f"sign({radicand.text})*abs({radicand.text})**(1/{index.text})", 2)

    def argument_group(self) -> Piece:
        """The argument of a command, an exponent: a group, or one token."""
        if self.peek() == "{":
            return self.group()
        if _is_number(self.peek()) and len(self.peek()) > 1:
            # x^12 is x¹·2 in TeX.
            self.refuse("of several digits TeX takes one: what belongs together needs braces")
        if self.kind(self.at) in ("function", "inverse"):
            self.refuse("of a function and its argument TeX takes the name: they need braces")
        return self.base()

    def braces(self) -> Piece:
        """A factor in braces, which do not print and so must not be needed."""
        before = self.tokens[self.at - 1] if self.at else ""
        piece = self.group()
        opened = before in ("", "+", "|", "\\left|", *_OPENING, *RELATIONS, *STOPS)
        closed = not self.continues() and self.peek() != "^"
        apart = before == "/" or self.peek() == "^" or ("/" in piece.text and not closed)
        needed = apart if piece.strength > 1 else not (opened and closed)
        if needed and piece.strength < 4 and not self.author:
            self.refuse("braces do not print: write brackets around what stands in them,")
        return Piece(piece.within(4), symbol=piece.symbol)

    def fraction(self) -> Piece:
        """A fraction, unless it is a derivative."""
        if self.is_derivative_at(self.at):
            return self.derivative()
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

    def is_derivative_at(self, i: int) -> bool:
        """A fraction whose halves are ``d…`` and ``d`` before a letter."""
        if self.tokens[i : i + 1] == [] or self.tokens[i] not in _FRACTIONS:
            return False
        above = self.tokens[i + 1 : i + 3]
        if above[:1] == ["{"]:
            above, i = above[1:], self.partner(i + 1)
        else:
            i += 1
        below = self.tokens[i + 1 : i + 4]
        return (
            above[0:1] == below[1:2]
            and above[0:1] in (["d"], ["\\partial"])
            and below[:1] == ["{"]
            and len(below) == 3
            and _is_letter(below[2])
        )

    def derivative(self) -> Piece:
        """``\\frac{dy}{dx}``, a symbol of the author's; ``\\frac{d}{dx} e`` is ``diff(e, x)``."""
        self.take()
        if self.peek() in _DIFFERENTIALS:
            self.tokens[self.at : self.at + 1] = ["{", self.peek(), "}"]
        order, below = self.higher_order()
        if order:
            return self.differentiated(below, f", {order}")
        self.take("{")
        kind = self.take().lstrip("\\")
        above = self.product() if self.peek() != "}" else None
        self.take("}")
        self.at += 2
        below = self.symbol()
        self.take("}")
        if above is None:
            return self.differentiated(below)
        if not above.symbol or above.strength < 4:
            return Piece(f"diff({above.text}, {below})")
        if self.author:
            return Piece(f"{kind}{above.text.rstrip('_')}_{kind}{below.rstrip('_')}")
        self.refuse(_NO_DERIVATIVE)

    def differentiated(self, name: str, order: str = "") -> Piece:
        """What follows ``d/dx``, differentiated."""
        bracket = self.peek() in (*_BRACKETS, "{")
        return self.operand(
            lambda e: Piece(f"diff({e.text}, {name}{order})"),
            self.factor(),
            after_derivative_of_bracket if bracket else after_derivative,
            lambda e: name in e.names or "diff(" in e.text,
        )

    def higher_order(self) -> tuple[int, str]:
        """The order and the variable of ``{d^n}{dx^n}``, which is stepped over; else 0."""
        for kind in _DIFFERENTIALS:
            match = re.match(
                rf"{{ {re.escape(kind)} \^ (?P<n>{{ \d+ }}|\d+) }} {{ {re.escape(kind)} "
                r"(?P<x>[A-Za-z]|\\[a-z]+) \^ (?P=n) } ",
                " ".join(self.tokens[self.at :]) + " ",
            )
            if match:
                self.at += match[0].count(" ")
                return int(match["n"].strip("{} ")), _name(match["x"].lstrip("\\"))
        if self.tokens[self.at : self.at + 3] in (["{", "d", "^"], ["{", "\\partial", "^"]):
            self.refuse("a derivative of higher order is written \\frac{d^2}{dx^2} f, here")
        return 0, ""

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
        """A function, perhaps with a power of it or the base of a logarithm, and its argument."""
        start = self.at
        name = FUNCTIONS[self.take()[1:]]
        base = ""
        if name == "log" and self.peek() == "_":
            self.at += 1
            base = f", {self.script().text}"
        exponent = None
        if self.peek() == "^":
            self.at += 1
            exponent = self.script()

        def applied(argument: Piece) -> Piece:
            text = f"{name}({argument.text}{base})"
            if exponent is None:
                return Piece(text)
            if exponent.text == "-1":
                self.two_readings(f"{_inverse(name)}({argument.text})", f"1/{text}")
            return Piece(f"{text}**{exponent.within(4)}", 3)

        return self.argument(start, applied, after_bracket if name != "exp" else whole)

    def argument(
        self, start: int, applied: Callable[[Piece], Piece], rule: Callable[[Piece, Ahead], Reach]
    ) -> Piece:
        """``applied`` to the argument that follows; ``rule`` says how far one in brackets goes."""
        token = self.peek()
        braced = token == "{" and self.peek(1) in _BRACKETS
        if braced and self.partner(self.at + 1) + 1 == self.partner(self.at):
            self.take()
            inner = self.enclosed()
            self.take("}")
            return applied(inner)
        if token in _BRACKETS:
            inner = self.enclosed()
            doubtful = inner.strength < 4 and rule is not whole
        elif token == "{":
            inner = self.printed(start, applied)
            rule, doubtful = after_braces, True
        elif token in ("|", "\\left|"):
            inner, rule, doubtful = self.absolute(), after_braces, True
        else:
            return self.operand(applied, self.factor(), after_open)
        if self.peek() == "^" and doubtful and not self.author:
            self.take()
            power = f"**{self.script().within(4)}"
            inside = applied(Piece(inner.within(4) + power, 3))
            self.two_readings(inside, applied(inner).within(4) + power)
        return self.operand(applied, inner, rule)

    def printed(self, start: int, applied: Callable[[Piece], Piece]) -> Piece:
        """The argument in braces of the function at ``start``, if print says the same without."""
        name, inside = (
            self.tokens[start : self.at],
            self.tokens[self.at + 1 : self.partner(self.at)],
        )
        inner = self.group()
        if inside[0] in ("+", "-"):
            if inner.strength == 0 and not self.author:
                self.refuse("braces do not print: write brackets around what stands in them,")
        elif not self.author:
            shown = Reader([*name, *inside], author=True).sum()
            if shown.text != applied(inner).text:
                self.two_readings(applied(inner), shown)
        return inner

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
        if token in _DIFFERENTIALS and self.inline_derivative():
            return self.slashed_derivative()
        if not self.author:
            self.check_name()
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
        if self.author and self.peek() == "(" and self.is_application(name):
            return Piece(f"{name}({', '.join(self.arguments())})")
        return Piece(name, symbol=True)

    def check_name(self) -> None:
        """Refuse letters that are no variable of the author's."""
        token = self.peek()
        if token in ("i", "j") and self.peek(1) != "_":
            self.refuse(_INSTEAD["\\imath"])
        if token == "d" and _is_letter(self.peek(1)):
            self.refuse(
                "d before a letter is a differential: write \\frac{d}{dx} (…) for a derivative, "
                "d\\cdot x for a product,"
            )
        for name in _WORDS:
            letters = self.tokens[self.at : self.at + len(name)]
            if letters == list(name) and not any(isinstance(x, Spaced) for x in letters[1:]):
                apart = "\\,".join(name)
                self.refuse(f"letters in a row are a product: write \\{name}, or {apart},")

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
        if not self.author:
            self.refuse(_NO_DERIVATIVE)
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
        return _name(name)

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
            if _is_number(text) and len(text) > 1:
                self.refuse("a subscript of several digits needs braces")
        if not re.fullmatch(r"[A-Za-z0-9]+", text):
            self.refuse(f"the subscript {text!a} is not read")
        return text if text[0].isdigit() else f"_{text}"

    def partner(self, i: int) -> int:
        """Where the bracket that opens at token ``i`` is closed, or the end."""
        depth = 0
        for k in range(i, len(self.tokens)):
            depth += (self.tokens[k] in _OPENING) - (self.tokens[k] in _CLOSED)
            if depth == 0:
                return k
        return len(self.tokens)

    def is_list(self) -> bool:
        """Whether the bracket that opens here holds a comma of its own."""
        depth = 0
        for token in self.tokens[self.at : self.partner(self.at)]:
            depth += (token in _OPENING) - (token in _CLOSED)
            if depth == 1 and token == ",":
                return True
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


def _name(text: str) -> str:
    """A name that the grammar of expressions does not reserve."""
    return f"{text}_" if text in RESERVED else text


def _inverse(name: str) -> str:
    return {"log": "exp", "exp": "log"}.get(name) or (name[1:] if name[0] == "a" else f"a{name}")


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
