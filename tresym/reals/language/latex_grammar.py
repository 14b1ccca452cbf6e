"""The grammar of LaTeX expressions: recursive descent from tokens to text.

The text is of the expression grammar of :mod:`tresym.reals.language.parsing`, with the additions
that :mod:`tresym.reals.language.latex` lists.
"""

from __future__ import annotations

import re
from collections.abc import Callable

from tresym.reals.language.latex_cursor import (
    BRACKETS,
    DIFFERENTIALS,
    FRACTIONS,
    OPENING,
    OPERATORS,
    is_letter,
    is_number,
)
from tresym.reals.language.latex_names import INSTEAD, NO_DERIVATIVE, Names, allowed, is_derivative
from tresym.reals.language.latex_reach import (
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
from tresym.reals.language.latex_tokens import FUNCTIONS, LETTERS_OF_FUNCTIONS, RELATIONS, STOPS
from tresym.reals.numbers.exact import InputError


class Reader(Names):
    """Recursive descent over the tokens; every method returns text of the expression grammar."""

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
            return Piece(f"-{piece.within(2)}" if sign == "-" else piece.within(2), 1)
        return self.product()

    def product(self) -> Piece:
        """Factors side by side; a slash divides by one factor, and what follows it is refused."""
        factors, operators = [self.factor_or_differential()], [""]
        while not (self.integrals and factors[-1] is None) and self.continues():
            self.extend(factors, operators)
        return joined(factors, operators)

    def extend(self, factors: list[Piece | None], operators: list[str]) -> None:
        """One more factor of a product, which a sign may lead in."""
        if self.peek() in OPERATORS:
            operators.append("/" if self.take() == "/" else "*")
            factors.append(self.factor_or_differential())
            return
        last = factors[-1] or Piece("")
        if operators[-1] == "/" and not self.at_differential():
            self.refuse("what is below the slash? Write it with \\frac or in brackets,")
        if is_number(self.peek()) and is_number(self.tokens[self.at - 1]):
            self.refuse("two numbers side by side: one with spaces, or a product?")
        opening = self.peek(1) if self.peek() == "{" else self.peek()
        if last.symbol and opening == "(" and not self.author:
            factors.append(self.factor_in_brackets(last))
        else:
            factors.append(self.factor_or_differential())
        operators.append("*")
        if last.text == "d" and factors[-1] and factors[-1].symbol and not self.author:
            self.refuse("d before a letter is a differential,")
        if is_number(last.text) and factors[-1] and re.fullmatch(r"\d+/\d+", factors[-1].text):
            self.two_readings(f"{last.text} + {factors[-1].text}", joined(factors, operators))

    def factor_in_brackets(self, symbol: Piece) -> Piece:
        """The bracket behind a symbol, where a product needs it: x(x + 1), and (a/r)² behind V.

        Without that need, as in x(0), it may hold the argument of a function.
        """
        name = symbol.text.split("*")[0]
        if self.is_list():
            self.refuse(f"{name}(…) is a function that is not known: write out what it is,")
        braced = self.peek() == "{"
        self.at += braced
        inner = self.enclosed()
        if braced:
            self.take("}")
        needed = inner.strength == 0 or (1 < inner.strength < 4 and self.peek() == "^")
        if not needed or name in LETTERS_OF_FUNCTIONS:
            value = f"{name}_1 for the value of a function {name}"
            self.two_readings(joined([symbol, inner], ["", "*"]), value)
        return self.factor(Piece(inner.within(4)))

    def factor_or_differential(self) -> Piece | None:
        """A factor, or None where the differential of an integral was stepped over."""
        if not self.at_differential():
            return self.factor()
        self.take("d")
        self.differentials.append(self.symbol())
        return None

    def operand(
        self,
        applied: Callable[[Piece], Piece],
        first: Piece,
        rule: Callable[[Piece, Ahead], Reach],
        matters: Callable[[Piece], bool] = lambda _: True,
    ) -> Piece:
        """``applied`` to ``first`` and to what follows, as far as the rule for it goes.

        Where it is in doubt whether the next factor belongs to it, and that matters, both readings
        are written out; an author's is the shorter one, unless a sign is written.
        """
        so_far = first
        factors: list[Piece | None] = [first]
        operators = [""]
        while True:
            ahead = self.ahead()
            reach = rule(so_far, ahead)
            shorter = self.author and not ahead.operator
            if reach is Reach.ENDS or (reach is Reach.DOUBT and shorter):
                if rule in (after_open, after_derivative):
                    self.open_end = self.at
                return applied(so_far)
            self.extend(factors, operators)
            last, both = factors[-1], ["", operators[-1]]
            longer = joined([so_far, last], both)
            if reach is Reach.DOUBT and last is not None and matters(last):
                self.two_readings(applied(longer), joined([applied(so_far), last], both))
            so_far = longer

    # factors

    def factor(self, base: Piece | None = None) -> Piece:
        """A base, here or read already, with its powers, evaluation bars and values at a point."""
        raised = base is None and self.peek() == "e" and self.peek(1) == "^"
        base = base or self.base()
        while True:
            if self.peek() == "^":
                if raised:
                    self.refuse("TeX takes one exponent: write brackets or braces,")
                self.at += 1
                raised = True
                power = f"{base.within(4)}**{self.script().within(4)}"
                base = Piece(power, 3, base.symbol)
            elif self.peek() == "|" and self.peek(1) == "_":
                self.at += 2
                base = self.evaluated(base.text)
            elif self.peek() == "(" and is_derivative(base.text) and self.is_list():
                base = Piece(f"value({base.text}, {', '.join(self.arguments())})")
            else:
                return base

    def script(self) -> Piece:
        """An exponent or a limit: a group, or one token."""
        inside = self.tokens[self.at + 1 : self.at + 5]
        raised = self.tokens[self.at - 2]
        if inside[0:1] + inside[2:] == ["(", ")", "}"] and not (raised == "e" or is_number(raised)):
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
        if token in FRACTIONS:
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
        if is_letter(token) or token in ("\\pi", "\\Delta", "\\partial") or token.isalpha():
            return self.named()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        self.refuse(INSTEAD.get(token, "this is not read"))

    def enclosed(self) -> Piece:
        """What stands in a bracket."""
        opening = self.take()
        piece = self.sum()
        if self.take() != BRACKETS[opening]:
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
        return Piece(piece.within(4))

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
        if not index.text.isdigit() or int(index.text) % 2 == 0 or is_number(radicand.text):
            return Piece(f"{radicand.within(4)}**(1/{index.within(4)})", 3)
        if index.text == "3":
            return Piece(f"cbrt({radicand.text})")
        return Piece(f"sign({radicand.text})*abs({radicand.text})**(1/{index.text})", 2)

    def argument_group(self) -> Piece:
        """The argument of a command, an exponent: a group, or one token."""
        if self.peek() == "{":
            return self.group()
        if is_number(self.peek()) and len(self.peek()) > 1:
            # x^12 is x¹·2 in TeX.
            self.refuse("of several digits TeX takes one: what belongs together needs braces")
        if self.kind(self.at) in ("function", "inverse"):
            self.refuse("of a function and its argument TeX takes the name: they need braces")
        return self.base()

    def braces(self) -> Piece:
        """A factor in braces, which do not print and so must not be needed."""
        before = self.tokens[self.at - 1] if self.at else ""
        piece = self.group()
        opened = before in ("", "+", "\\left|", *OPENING, *RELATIONS, *STOPS)
        closed = not self.continues() and self.peek() != "^"
        apart = before == "/" or self.peek() == "^" or ("/" in piece.text and not closed)
        needed = apart if piece.strength > 1 else not (opened and closed)
        needed = needed and piece.strength < 4
        if self.open_end == self.at - 1:  # as in {\sin x}y
            needed = needed or not (closed or self.ahead().kind in ("function", "derivative"))
        if needed and not self.author:
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

    def derivative(self) -> Piece:
        """``\\frac{dy}{dx}``, a symbol of the author's; ``\\frac{d}{dx} e`` is ``diff(e, x)``."""
        self.take()
        if self.peek() in DIFFERENTIALS:
            self.tokens[self.at : self.at + 1] = ["{", self.peek(), "}"]
        kind = self.peek(1).lstrip("\\")
        order, below = self.higher_order()
        if order:
            return self.differentiated(kind, below, f", {order}")
        self.at += 2
        above = self.product() if self.peek() != "}" else None
        self.take("}")
        self.at += 2
        below = self.symbol()
        self.take("}")
        if above is None:
            return self.differentiated(kind, below)
        if above.symbol and above.strength == 4 and self.author:
            return Piece(f"{kind}{above.text.rstrip('_')}_{kind}{below.rstrip('_')}")
        if above.symbol and above.strength == 4:
            self.refuse(NO_DERIVATIVE)
        return self.diff(above, kind, below)

    def diff(self, e: Piece, kind: str, name: str, order: str = "") -> Piece:
        """The derivative of ``e``, in which ``d/dx`` needs the variable: else it is a symbol's."""
        constant = not e.names or kind == "partial" or "diff(" in e.text
        if name not in e.names and not constant and not self.author:
            self.refuse(NO_DERIVATIVE)
        return Piece(f"diff({e.text}, {name}{order})")

    def differentiated(self, kind: str, name: str, order: str = "") -> Piece:
        """What follows ``d/dx``, differentiated."""
        bracket = self.peek() in (*BRACKETS, "{")
        return self.operand(
            lambda e: self.diff(e, kind, name, order),
            self.factor(),
            after_derivative_of_bracket if bracket else after_derivative,
            lambda e: name in e.names or "diff(" in e.text,
        )

    def higher_order(self) -> tuple[int, str]:
        """The order and the variable of ``{d^n}{dx^n}``, which is stepped over; else 0."""
        for kind in DIFFERENTIALS:
            match = re.match(
                rf"{{ {re.escape(kind)} \^ (?P<n>{{ \d+ }}|\d+) }} {{ {re.escape(kind)} "
                r"(?P<x>[A-Za-z]|\\[a-z]+) \^ (?P=n) } ",
                " ".join(self.tokens[self.at :]) + " ",
            )
            if match:
                self.at += match[0].count(" ")
                return int(match["n"].strip("{} ")), allowed(match["x"].lstrip("\\"))
        if self.tokens[self.at : self.at + 3] in (["{", "d", "^"], ["{", "\\partial", "^"]):
            self.refuse("a derivative of higher order is written \\frac{d^2}{dx^2} f, here")
        return 0, ""

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
        braced = token == "{" and self.peek(1) in BRACKETS
        if braced and self.partner(self.at + 1) + 1 == self.partner(self.at):
            self.take()
            inner = self.enclosed()
            self.take("}")
            return applied(inner)
        if token in BRACKETS:
            inner = self.enclosed()
            doubtful = rule is not whole and min(inner.strength, applied(inner).strength) < 4
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
        if token in DIFFERENTIALS and self.inline_derivative():
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

    def arguments(self) -> list[str]:
        """The arguments of an author's function."""
        self.take("(")
        found = [self.sum().text]
        while self.peek() == ",":
            self.take()
            found.append(self.sum().text)
        self.take(")")
        return found


def _inverse(name: str) -> str:
    return {"log": "exp", "exp": "log"}.get(name) or (name[1:] if name[0] == "a" else f"a{name}")
