"""The grammar of LaTeX expressions: a recursive-descent parser."""

from __future__ import annotations

import re
from collections.abc import Callable
from math import factorial

from tresym.reals.language.binders import (
    at,
    derivative,
)
from tresym.reals.language.calls import INFINITY, call
from tresym.reals.language.expression import (
    DOTS,
    ONE,
    PI,
    add,
    number,
    symbols,
    unknown,
)
from tresym.reals.language.latex_calculus import TOTALS
from tresym.reals.language.latex_cursor import (
    BRACKETS,
    CLOSED,
    FRACTIONS,
    INDICES,
    INSTEAD,
    NO_DERIVATIVE,
    OPENING,
    OPERATORS,
    TIME,
    WORDS_BELOW,
    derived,
    is_derivative,
    is_letter,
    is_number,
)
from tresym.reals.language.latex_functions import FORCES, MAX_FACTORIAL, FunctionReader, natural
from tresym.reals.language.latex_operands import (
    Piece,
    Reach,
    Rule,
    after_derivative,
    after_nested,
    after_open,
    decimal,
    joined,
)
from tresym.reals.language.latex_tokens import (
    ELLIPSIS,
    EXTREMES,
    FUNCTIONS,
    LETTERS_OF_FUNCTIONS,
    RELATIONS,
    STOPS,
    WITH_ORDER,
)
from tresym.reals.language.parsing import sum_of
from tresym.reals.numbers.exact import InputError

OPENING_ARGUMENTS = ("(", "[", "\\{")
VARIABLES = frozenset(("x", "t", "s", "theta"))
"""Letters of what is differentiated by, where a prime behind a bracket does not say by what."""
BINOMIALS = ("\\binom", "\\tbinom", "\\dbinom")


class Reader(FunctionReader):
    """Recursive descent over the tokens."""

    # sums and products

    def sum(self) -> Piece:
        """Terms joined by + and −."""
        first = self.signed()
        terms = [first.tree]
        while self.peek() in ("+", "-") and not self.sides():
            if self.peek(1) == ELLIPSIS:
                self.at += 2
                terms.append(DOTS)
                continue
            terms.append(-self.product().tree if self.take() == "-" else self.product().tree)
            if self.bar[0] == self.at and self.bar[1] in symbols(add(*terms[:-1])):
                self.refuse("of the terms before an evaluation bar which are meant? Write brackets")
        return first if len(terms) == 1 else Piece(sum_of(*terms), 0)

    def signed(self) -> Piece:
        """The first term of a sum, perhaps with a sign."""
        if self.peek() not in ("+", "-"):
            return self.product()
        sign, piece = self.take(), self.product()
        if sign == "+":
            return Piece(piece.tree, 1)
        return Piece(-piece.tree, 1, printed=piece.printed and f"-{piece.printed}")

    def product(self) -> Piece:
        """Factors side by side; a slash divides by one factor, and what follows it is refused."""
        factors, operators = [self.factor_or_differential()], [""]
        while not (self.integrals and factors[-1] is None) and self.continues():
            self.extend(factors, operators)
        piece = joined(factors, operators)
        if self.at_bar() and self.bars == 0:
            self.at += 1
            piece = self.evaluated(piece.tree)
        return piece

    def extend(self, factors: list[Piece | None], operators: list[str]) -> None:
        """One more factor of a product, which a sign may lead in."""
        if self.peek() in OPERATORS:
            operators.append("/" if self.take() == "/" else "*")
            factors.append(self.factor_or_differential())
            return
        last = factors[-1] or Piece(ONE)
        if operators[-1] == "/" and not self.at_differential():
            self.refuse("what is below the slash? Write it with \\frac or in brackets,")
        if is_number(self.peek()) and is_number(self.tokens[self.at - 1]):
            self.refuse("two numbers side by side: one with spaces, or a product?")
        opening = self.peek(1) if self.peek() == "{" else self.peek()
        name = "pi" if last.tree == PI else last.symbol
        bracket = self.at + (self.peek() == "{")
        limits = opening == "[" and self.tokens[self.partner(bracket) + 1 :][:1] == ["_"]
        if name and opening in OPENING_ARGUMENTS and not limits and not self.guesses:
            value = self.factor_in_brackets(last, name)
            if value is None:
                factors[-1] = self.applied_to_bracket(name)
                return
            factors.append(value)
        else:
            factors.append(self.factor_or_differential())
        operators.append("*")
        new = factors[-1]
        if last.symbol == "d" and new and new.symbol and not self.guesses:
            self.refuse("d before a letter is a differential,")
        if last.printed and new and new.tree.op == "number" and new.strength == 2:
            self.two_readings(f"{last.printed} + {new.tree}", f"{last.printed}*({new.tree})")

    def factor_in_brackets(self, last: Piece, name: str) -> Piece | None:
        """The bracket behind a symbol, where a product needs it: x(x + 1), and (a/r)² behind V.

        Without that need, as in x(0) and V(2r), it may hold the argument of a function; so may a
        sum behind a capital, a Greek or a subscripted letter that never stands alone. An author's
        longer reading is the value of the function, for which None is the answer.
        """
        if self.is_list():
            self.refuse(f"{name}(…) is a function that is not known: write out what it is,")
        start, braced = self.at, self.peek() == "{"
        if self.peek(braced) == "\\{":
            self.refuse("braces behind a name may hold the argument of a transform,")
        self.at += braced
        inner = self.enclosed()
        if braced:
            self.take("}")
        if name != "pi" and not self.is_product(name, inner):
            value = f"{name}_1 for the value of a function {name}"
            if not self.author or not (self.author.longer or self.author.shorter):
                self.two_readings(joined([last, inner], ["", "*"]), value)
            if self.author.longer:
                self.at = start
                return None
        return self.factor(Piece(inner.tree))

    def is_product(self, name: str, inner: Piece) -> bool:
        """Whether a bracket behind a symbol can be nothing but a factor."""
        raised = self.peek() == "^" and 1 < inner.strength < 4
        if name in LETTERS_OF_FUNCTIONS - FORCES or not self.author:
            return name not in LETTERS_OF_FUNCTIONS and (inner.strength == 0 or raised)
        lower = len(name) == 1 and name.islower()
        if name in self.author.numbers:
            return True
        if name in inner.names:
            return lower or inner.strength == 0
        if name in self.author.applied:
            return False
        if lower:
            return inner.strength < 2 or raised
        return (inner.strength == 0 or raised) and (name == "pi" or name in self.author.bare)

    def applied_to_bracket(self, name: str) -> Piece:
        """The value of a function that is left unknown at what the bracket here holds."""
        braced = self.peek() == "{"
        self.at += braced
        value = Piece(unknown(name, (self.enclosed().tree,)))
        if braced:
            self.take("}")
        return self.factor(value)

    def operand(
        self,
        applied: Callable[[Piece], Piece],
        first: Piece,
        rule: Rule,
        matters: Callable[[Piece], bool] = lambda _: True,
    ) -> Piece:
        """``applied`` to ``first`` and to what follows, as far as the rule for it goes.

        Where it is in doubt whether the next factor belongs to it, and that matters, both readings
        are written out; an author's is the shorter one, unless a sign is written.
        """
        factors: list[Piece | None] = [first]
        operators = [""]
        telling = first  # the factor that tells the rule of what kind the operand is so far
        while True:
            ahead = self.ahead()
            reach = rule(telling, ahead)
            shorter = (self.guesses or (self.author and self.author.shorter)) and not ahead.operator
            if reach is Reach.ENDS or (reach is Reach.DOUBT and shorter):
                if rule in (after_open, after_nested, after_derivative):
                    self.open_end = self.at
                return applied(joined(factors, operators))
            self.extend(factors, operators)
            last, both = factors[-1], ["", operators[-1]]
            if last is None:
                continue
            longer = bool(self.author and self.author.longer)
            if reach is Reach.DOUBT and matters(last) and not longer:
                shorter_one = applied(joined(factors[:-1], operators[:-1]))
                self.two_readings(
                    applied(joined(factors, operators)), joined([shorter_one, last], both)
                )
            if telling.tree.op == "number" or not telling.names:
                telling = last if last.names or last.tree.op != "number" else telling

    # factors

    def factor(self, base: Piece | None = None) -> Piece:
        """A base, here or read already, with its powers, evaluation bars and values at a point."""
        raised = base is None and self.is_exponential(self.at)
        base = base or self.base()
        while True:
            if self.degrees():
                base = Piece(base.tree * PI / 180, 2)
            elif self.peek() == "^" and not self.sides():
                if raised:
                    self.refuse("TeX takes one exponent: write brackets or braces,")
                self.at += 1
                raised = True
                exponent = self.script()
                if self.author and self.author.letter_e and base.symbol == "e":
                    self.check_power_of_e(exponent)
                ten = base.printed == "10" and re.fullmatch(r"-?\d+", exponent.printed)
                printed = f"1e{exponent.printed}" if ten else ""
                base = Piece(base.tree**exponent.tree, 3, base.symbol, printed)
            elif self.peek() == "!":
                base = self.factorial(base)
            elif self.peek() == "'" and self.tokens[self.at - 1] == ")" and len(base.names) == 1:
                (name,) = base.names
                if name not in VARIABLES and not self.guesses:
                    self.refuse(
                        f"whether {name} is a function is not said: write \\frac{{d}}{{dx}},"
                    )
                base = Piece(derivative(base.tree, name))
                self.at += 1
            elif self.peek() == "|" and self.peek(1) == "_" and not self.at_bar():
                self.at += 1
                base = self.evaluated(base.tree)
            elif self.peek() == "(" and is_derivative(base) and self.is_list():
                values = {f"p{n}": value for n, value in enumerate(self.arguments(), 1)}
                base = Piece(at(base.tree, values))
            else:
                return base

    def check_power_of_e(self, exponent: Piece) -> None:
        """Refuse a power of the letter e that may be the exponential function."""
        if symbols(exponent.tree) or exponent.tree.op != "number":
            self.two_readings(f"exp({exponent.tree})", f"e**({exponent.tree}) of the variable e")

    def script(self) -> Piece:
        """An exponent or a limit: a group, or one token."""
        inside = self.tokens[self.at + 1 : self.at + 5]
        raised = self.tokens[self.at - 2]
        braced = self.peek() == "{" and inside[0:1] + inside[2:] == ["(", ")", "}"]
        if braced and not (raised == "e" or is_number(raised)):
            self.refuse("one thing in brackets above a name counts derivatives: write it without,")
        return self.argument_group()

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
        if token == "\\int":
            return self.integral()
        if token == "\\lim":
            return self.limit()
        if token in TOTALS:
            return self.total()
        if token in BINOMIALS:
            return self.binomial()
        if token in EXTREMES:
            return self.extreme()
        if token == "\\infty":
            self.take()
            return Piece(INFINITY)
        if token in TIME and self.author:
            return self.dotted()
        if token.lstrip("\\") in FUNCTIONS and token.startswith("\\"):
            return self.function()
        if token.lstrip("\\") in WITH_ORDER and token.startswith("\\"):
            found = self.special_function()
            if found is None:
                self.refuse("the order and the argument of this function are missing")
            return found
        if re.fullmatch(r"\d.*|\.\d+", token):
            return decimal(self.take())
        if is_letter(token) or token in ("\\pi", "\\Delta", "\\partial") or token.isalpha():
            return self.named()
        if not token:
            raise InputError("LaTeX: the formula ends where more is expected")
        self.refuse(INSTEAD.get(token, "this is not read"))

    def enclosed(self) -> Piece:
        """What stands in a bracket, or in braces."""
        opening = self.take()
        piece = self.sum()
        if self.peek() not in ("", CLOSED[OPENING.index(opening)]):
            self.refuse(f"the bracket {opening} is not closed")
        self.take()
        return piece

    def bracket(self) -> Piece:
        """A bracket; with limits behind it, the difference of values at its ends."""
        start, opening, piece = self.at, self.peek(), self.enclosed()
        if opening == "[" and self.peek() == "_":
            return self.evaluated(piece.tree)
        if opening != "(" and not self.guesses:
            self.check_bracket(opening, piece, start)
        return Piece(piece.tree)

    def check_bracket(self, opening: str, inner: Piece, start: int) -> None:
        """Refuse braces and square brackets that may be a fractional or an integer part.

        They are brackets where they hold another bracket, and square ones where a product or a
        power needs them.
        """
        inside = self.tokens[start + 1 : self.at - 1]
        if {*inside} & {"(", "[", "\\{", "\\left|", "\\frac", "\\sqrt", "\\dfrac", "\\tfrac"}:
            return
        before = self.tokens[start - 1] if start else ""
        free = before in ("", "+", *OPENING, *RELATIONS, *STOPS) and not self.continues()
        factor = 1 < inner.strength < 4 and before != "}"
        lone = len(inside) == 1 or factor or (free and inner.strength < 2)
        if opening == "\\{" or (lone and self.peek() != "^") or len(inside) == 1:
            what = {"\\{": "a fractional part or a set", "[": "an integer part"}[opening]
            close = BRACKETS[opening].removeprefix("\\")
            shown = f"{opening.removeprefix(chr(92))}{inner.tree}{close}"
            self.refuse(f"{shown} may be {what}: write round brackets,")

    def absolute(self) -> Piece:
        """An absolute value."""
        self.take()
        self.bars += 1
        piece = self.sum()
        self.bars -= 1
        if self.peek() not in ("", "|", "\\right|"):
            self.refuse("the bar | is not closed")
        self.take()
        return Piece(abs(piece.tree))

    def braces(self) -> Piece:
        """A factor in braces, which do not print and so must not be needed."""
        before, start = self.tokens[self.at - 1] if self.at else "", self.at
        piece = self.enclosed()
        slashed = "/" in self.tokens[start : self.at]
        opened = before in ("", "+", "\\left|", *OPENING, *RELATIONS, *STOPS)
        closed = not self.continues() and self.peek() != "^"
        apart = before == "/" or self.peek() == "^" or (slashed and not closed)
        needed = apart if piece.strength > 1 else not (opened and closed)
        needed = needed and piece.strength < 4
        if self.open_end == self.at - 1:  # as in {\sin x}y
            needed = needed or not (closed or self.ahead().kind in ("function", "derivative"))
        if needed and not self.guesses:
            self.refuse("braces do not print: write brackets around what stands in them,")
        return Piece(piece.tree, symbol=piece.symbol, printed=piece.printed)

    # fractions and derivatives

    def fraction(self) -> Piece:
        """A fraction, unless it is a derivative."""
        if self.is_derivative_at(self.at):
            return self.derivative()
        self.take()
        if re.fullmatch(r"\d\d", self.peek()):
            # TeX's \frac12 is one half.
            top, below = map(decimal, self.take())
        else:
            if self.peek() == "{" and self.peek(1) == "}":
                self.refuse("an empty numerator")
            top, below = self.argument_group(), self.argument_group()
        return Piece(top.tree / below.tree, 2)

    def of_symbol(self, kind: str, above: str, below: str, times: int) -> Piece:
        """The derivative of a symbol of an author's: of what it stands for, or one more symbol."""
        if not self.author:
            self.refuse(NO_DERIVATIVE)
        known = self.author.derivative(above, below, times)
        if self.peek() == "(" and not self.guesses:
            start, product = self.at, self.enclosed().strength == 0
            self.at = start
            if known is not None or not product:
                self.refuse("a derivative at a point is not read,")
        return derived(kind, above, below or "t", times) if known is None else Piece(known)

    def factorial(self, base: Piece) -> Piece:
        """``3!``, ``n!`` and ``(n + 1)!``."""
        n = natural(base.tree)
        if base.strength < 4 or self.peek(1) == "!" or (n or 0) > MAX_FACTORIAL:
            self.refuse("the factorial is read of a name, a small number or a bracket,")
        self.take()
        return Piece(call("factorial", [base.tree]) if n is None else number(factorial(n)))

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

    def term(self) -> Piece:
        """``a_k`` as a(k), ``a_{ij}``, ``a_{1j}`` and ``a_{i,j}`` as functions of two indices."""
        letter = self.take().removeprefix("\\")
        self.take("_")
        self.counting = True  # i is an index there
        try:
            indices = self.indices_below()
        finally:
            self.counting = False
        if self.peek() in ("(", "'"):
            self.refuse(f"{letter} is a sequence, and what stands behind its term is not read,")
        return Piece(unknown(letter, tuple(indices)))
