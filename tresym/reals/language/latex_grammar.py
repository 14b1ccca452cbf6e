"""The grammar of LaTeX expressions: a recursive-descent parser."""

from __future__ import annotations

import re
from collections.abc import Callable
from math import factorial

from tresym.reals.language.binders import (
    antiderivative,
    at,
    derivative,
    integral,
    limit,
    nth_derivative,
    order,
    outermost,
    total,
)
from tresym.reals.language.calls import INFINITY, call
from tresym.reals.language.expression import (
    DOTS,
    MAX_DERIVATIVES,
    MINUS_ONE,
    ONE,
    ORDERS,
    PI,
    E,
    Expr,
    add,
    apply,
    extreme,
    multiply,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.latex_cursor import (
    BRACKETS,
    CLOSED,
    DIFFERENTIALS,
    FRACTIONS,
    INDICES,
    INSTEAD,
    NO_DERIVATIVE,
    OPENING,
    OPERATORS,
    TIME,
    WORDS_BELOW,
    Author,
    Cursor,
    Function,
    derived,
    is_derivative,
    is_letter,
    is_number,
)
from tresym.reals.language.latex_operands import (
    Piece,
    Reach,
    Rule,
    after_braces,
    after_bracket,
    after_derivative,
    after_derivative_of_bracket,
    after_nested,
    after_open,
    decimal,
    joined,
    whole,
)
from tresym.reals.language.latex_tokens import (
    ELLIPSIS,
    EXTREMES,
    FUNCTIONS,
    LETTERS_OF_FUNCTIONS,
    RELATIONS,
    STOPS,
)
from tresym.reals.language.parsing import sum_of
from tresym.reals.numbers.exact import InputError

MAX_FACTORIAL = 100
OPENING_ARGUMENTS = ("(", "[", "\\{")
FORCES = frozenset(("F", "G"))
"""Letters of functions that are also usual for numbers."""
VARIABLES = frozenset(("x", "t", "s", "theta"))
"""Letters of what is differentiated by, where a prime behind a bracket does not say by what."""
TOTALS = {"\\sum": "sum", "\\prod": "product"}
BINOMIALS = ("\\binom", "\\tbinom", "\\dbinom")


class Reader(Cursor):
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
        if not self.is_product(name, inner):
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

    def degrees(self) -> bool:
        """Whether ``^\\circ`` stands here, which is stepped over."""
        for form in (["^", "\\circ"], ["^", "{", "\\circ", "}"]):
            if self.tokens[self.at : self.at + len(form)] == form:
                self.at += len(form)
                return True
        return False

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

    def evaluated(self, e: Expr) -> Piece:
        """``e`` at the place of a bar, ``_{x = 1}``, or its difference between two, ``_0^1``."""
        ends: dict[str, Expr] = {}
        names: frozenset[str] = frozenset()
        while self.peek() in ("_", "^") and self.peek() not in ends:
            mark = self.take()
            ends[mark], name = self.end()
            names |= frozenset((name,) if name else ())
        if not names:
            names = symbols(e).difference(*map(symbols, ends.values()))
            own = self.author.variable if self.author else ""
            names = frozenset((own,)) & names or names
        if len(names) != 1 or "_" not in ends:
            self.refuse("a bar or bracket with limits needs its variable: write the values out,")
        (name,) = names
        low = at(e, {name: ends["_"]})
        if "^" not in ends:
            return Piece(low)
        self.bar = self.at, name
        if ends["^"] in (INFINITY, -INFINITY):
            return Piece(limit(e - low, name, ends["^"]))
        return Piece(at(e, {name: ends["^"]}) - low, 0)

    def end(self) -> tuple[Expr, str]:
        """An end of an interval, and its variable where that is named, as in ``_{x=0}``."""
        start = self.at
        if self.peek() == "{" and is_letter(self.peek(1)):
            self.at += 1
            name = self.symbol()
            if self.peek() == "=":
                self.at += 1
                value = self.sum().tree
                self.take("}")
                return value, name
            self.at = start
        return self.script().tree, ""

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

    def barred(self) -> Piece:
        """``\\left. … \\right|_{x = value}``, and between two values."""
        self.take("\\left.")
        piece = self.sum()
        self.take("\\right|")
        return self.evaluated(piece.tree)

    def root(self) -> Piece:
        """A square root, or a root with an index; an odd one is real for every real number."""
        self.take("\\sqrt")
        if self.peek() != "[":
            return Piece(sqrt(self.argument_group().tree))
        self.take()
        index = self.sum()
        self.take("]")
        inside = self.argument_group().tree
        whole = index.tree.op == "number" and index.tree.args[0].q == 1
        n = int(index.tree.args[0].p) if whole else 0
        if n < 0:
            self.refuse("a root with a negative index: write 1 over the root,")
        if n % 2 == 0 or inside.op == "number":
            return Piece(inside ** (1 / index.tree), 3)
        if n == 3:
            return Piece(apply("cbrt", inside))
        return Piece(apply("sign", inside) * abs(inside) ** (1 / index.tree), 2)

    def extreme(self) -> Piece:
        """``\\max(x, y)``, ``\\min\\{x, y, z\\}``."""
        token = self.take()
        if self.peek() not in ("(", "\\{") or not self.is_list():
            self.refuse(f"{token} takes a list in brackets: write {token}(x, y),")
        return Piece(extreme(EXTREMES[token], self.arguments()))

    def argument_group(self) -> Piece:
        """The argument of a command, an exponent: a group, or one token."""
        if self.peek() == "{":
            return self.enclosed()
        if is_number(self.peek()) and len(self.peek()) > 1:
            # x^12 is x¹·2 in TeX.
            self.refuse("of several digits TeX takes one: what belongs together needs braces")
        if self.kind(self.at) in ("function", "inverse"):
            self.refuse("of a function and its argument TeX takes the name: they need braces")
        return self.base()

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

    def derivative(self) -> Piece:
        """``\\frac{dy}{dx}``, a symbol of an author's, or ``\\frac{d}{dx}`` of what follows."""
        above, below, self.at = self.halves(self.at)
        kind, above, times = above[0], above[1:], 1
        if "^" in (*above[:1], *below):
            length = 4 if above[1:2] == ["{"] else 2
            order, above = above[:length], above[length:]
            digits = "".join(order).strip("^{}")
            if below[-length:] == order and len(digits) == 1 and is_letter(digits) and not above:
                return self.repeated(digits, below[:-length])
            if below[-length:] != order or not digits.isdigit():
                self.refuse("a derivative of higher order is written \\frac{d^2}{dx^2} f, here")
            if len(digits) > 2 or not 1 <= (times := int(digits)) <= MAX_DERIVATIVES:
                self.refuse(f"the order of a derivative goes from 1 to {MAX_DERIVATIVES}")
            below = below[:-length]
        variable = Reader(below[1:], self.author)
        name = variable.symbol()
        if variable.peek():
            variable.refuse("one variable is expected")
        if not above:
            return self.differentiated(kind, name, times)
        function = Reader(above, self.author)
        piece = function.product()
        if function.peek():
            function.refuse("one product is expected")
        if not (piece.symbol and piece.strength == 4):
            return self.slope(piece, kind, name, times)
        return self.of_symbol(kind, piece.symbol, name, times)

    def repeated(self, order: str, below: list[str]) -> Piece:
        """``\\frac{d^n}{dx^n}`` of what follows."""
        variable = Reader(below[1:], self.author)
        name = variable.symbol()
        if variable.peek():
            variable.refuse("one variable is expected")
        return self.followed(name, lambda e: Piece(nth_derivative(e.tree, name, symbol(order))))

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

    def dotted(self) -> Piece:
        """``\\dot x`` and ``\\ddot x``, derivatives by the time."""
        times = len(self.take()) - 3
        name = self.argument_group().symbol
        if not name:
            self.refuse("one letter is expected under the dots,")
        return self.of_symbol("d", name, "" if self.author and self.author.strict else "t", times)

    def slope(self, e: Piece, kind: str, name: str, times: int = 1) -> Piece:
        """The derivative of ``e``, in which ``d/dx`` needs the variable: else it is a symbol's."""
        known = name in e.names or not e.names or kind == "\\partial" or _has_derivative(e)
        if not known and not self.guesses:
            if e.symbol and e.strength == 4:
                return self.of_symbol(kind, e.symbol, name, times)
            self.refuse(NO_DERIVATIVE)
        tree = e.tree
        for _ in range(times):
            tree = derivative(tree, name)
        return Piece(tree)

    def differentiated(self, kind: str, name: str, times: int = 1) -> Piece:
        """What follows ``d/dx``, differentiated."""
        return self.followed(name, lambda e: self.slope(e, kind, name, times))

    def followed(self, name: str, applied: Callable[[Piece], Piece]) -> Piece:
        """``applied`` to the product that follows; what does not know the variable may be left."""
        bracket = self.peek() in (*BRACKETS, "{")
        rule = after_derivative_of_bracket if bracket else after_derivative
        return self.operand(
            applied, self.factor(), rule, lambda e: name in e.names or _has_derivative(e)
        )

    def limit(self) -> Piece:
        """``\\lim_{x \\to p}`` of the product that follows."""
        self.take("\\lim")
        self.take("_")
        self.take("{")
        name = self.symbol()
        if RELATIONS.get(self.take()) != "->":
            self.refuse("a limit is written \\lim_{x \\to 0},")
        point, side = self.point()
        self.take("}")
        return self.followed(name, lambda e: Piece(limit(e.tree, name, point, side)))

    def point(self) -> tuple[Expr, int]:
        """Where a path ends, and the side it comes from: ``0``, ``0^+``, ``\\pi^{-}``, ``0+``."""
        found = self.sum().tree
        side = self.sides()
        self.at += len(side)
        return found, ("+" in side) - ("-" in side)

    # functions

    def function(self) -> Piece:
        """A function, perhaps with a power of it or the base of a logarithm, and its argument."""
        start = self.at
        name = FUNCTIONS[self.take()[1:]]
        more: list[Expr] = []
        if name == "log" and self.peek() == "_":
            self.at += 1
            more = [self.script().tree]
        exponent = None
        if self.peek() == "^":
            self.at += 1
            exponent = self.script().tree

        def applied(argument: Piece) -> Piece:
            tree = call(name, [argument.tree, *more])
            if exponent is None:
                return Piece(tree)
            inverse = self.author and (self.author.longer or self.author.inverses)
            if exponent == MINUS_ONE and inverse:
                return Piece(call(_inverse(name), [argument.tree]))
            if exponent == MINUS_ONE and not (self.author and self.author.shorter):
                self.two_readings(f"{_inverse(name)}({argument.tree})", f"1/{tree}")
            return Piece(tree**exponent, 3)

        return self.argument(start, applied, after_bracket if name != "exp" else whole)

    def argument(self, start: int, applied: Callable[[Piece], Piece], rule: Rule) -> Piece:
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
            nested = self.kind(self.at) in ("function", "inverse") or self.is_exponential(self.at)
            return self.operand(applied, self.factor(), after_nested if nested else after_open)
        if self.peek() == "^" and doubtful and not self.guesses:
            self.take()
            exponent = self.script().tree
            inside = applied(Piece(inner.tree**exponent, 3))
            self.two_readings(inside, Piece(applied(inner).tree ** exponent))
        return self.operand(applied, inner, rule)

    def printed(self, start: int, applied: Callable[[Piece], Piece]) -> Piece:
        """The argument in braces of the function at ``start``, if print says the same without."""
        name, inside = (
            self.tokens[start : self.at],
            self.tokens[self.at + 1 : self.partner(self.at)],
        )
        inner = self.enclosed()
        if inside[0] in ("+", "-"):
            if inner.strength == 0 and not self.guesses:
                self.refuse("braces do not print: write brackets around what stands in them,")
        elif not self.guesses:
            shown = Reader([*name, *inside], Author()).sum()
            if shown.tree != applied(inner).tree:
                self.two_readings(applied(inner), shown)
        return inner

    # integrals

    def integral(self) -> Piece:
        """``∫_{low}^{high} … dx``, or without ends: all terms that carry the differential."""
        self.take("\\int")
        ends: list[Expr] = []
        named = {""}
        if self.peek() in ("_", "^"):
            first = self.take()
            one, name = self.end()
            self.take("^" if first == "_" else "_")
            other, second = self.end()
            named |= {name, second}
            ends = [one, other] if first == "_" else [other, one]
        outer, self.differentials = self.differentials, []
        self.integrals += 1
        body = self.integrand()
        variables = set(self.differentials)
        self.integrals -= 1
        self.differentials = outer
        if len(variables) != 1 or not named <= variables | {""}:
            self.refuse("an integral needs one variable and its differential")
        name = variables.pop()
        return Piece(integral(body, name, *ends) if ends else antiderivative(body, name))

    def total(self) -> Piece:
        """``\\sum_{k=low}^{high}`` and ``\\prod`` of the product that follows."""
        kind = TOTALS[self.take()]
        self.take("_")
        self.take("{")
        name = self.symbol()
        self.take("=")
        low = self.sum().tree
        self.take("}")
        self.take("^")
        high = self.script().tree
        factors, operators = [self.factor_or_differential()], [""]
        while factors[-1] is not None and self.continues():
            self.extend(factors, operators)
        piece, last = joined(factors, operators), factors[-1]
        if kind == "product" and len(factors) > 1 and last and name not in last.names:
            one = total(kind, joined(factors[:-1], operators[:-1]).tree, name, low, high)
            both = joined([Piece(one, 2), last], ["", operators[-1]])
            self.two_readings(Piece(total(kind, piece.tree, name, low, high)), both)
        return Piece(total(kind, piece.tree, name, low, high), 2)

    def binomial(self) -> Piece:
        """``\\binom{n}{k}``: for a number k the product, else by factorials, 0 ≤ k ≤ n."""
        self.take()
        above, below = self.argument_group().tree, self.argument_group().tree
        k = _whole(below)
        if k is None or k > MAX_FACTORIAL:
            n, m, rest = (call("factorial", [e]) for e in (above, below, above - below))
            return Piece(n / (m * rest))
        factors = [above - n for n in range(k)]
        return Piece(multiply(*factors) / factorial(k)) if k else Piece(ONE)

    def factorial(self, base: Piece) -> Piece:
        """``3!``, ``n!`` and ``(n + 1)!``."""
        n = _whole(base.tree)
        if base.strength < 4 or self.peek(1) == "!" or (n or 0) > MAX_FACTORIAL:
            self.refuse("the factorial is read of a name, a small number or a bracket,")
        self.take()
        return Piece(call("factorial", [base.tree]) if n is None else number(factorial(n)))

    def integrand(self) -> Expr:
        """The terms that carry the differential of the integral."""
        terms = [self.signed().tree]
        while not self.differentials and self.peek() in ("+", "-"):  # up to the differential
            terms.append(self.signed().tree)
        if not self.differentials:
            self.refuse("the differential of the integral is missing")
        while self.peek() in ("+", "-"):
            before, count = self.at, len(self.differentials)
            sign = -1 if self.take() == "-" else 1
            term = self.product().tree
            if len(self.differentials) == count:
                self.at = before
                break
            terms.append(term if sign == 1 else -term)
        return add(*terms)

    # names

    def named(self) -> Piece:
        """A symbol, an inline derivative, ``e^{…}``, an order, or an author's function."""
        token, start = self.peek(), self.at
        if token in DIFFERENTIALS and is_letter(self.peek(1)):
            self.at += 1
            above = self.symbol()
            if self.peek() == "/" and self.peek(1) == token and is_letter(self.peek(2)):
                if not self.author:
                    self.refuse(NO_DERIVATIVE)
                self.at += 2
                return derived(token, above, self.symbol())
            self.at = start
        if not self.guesses:
            self.check_name()
        if self.is_exponential(self.at):
            self.at += 2
            return Piece(apply("exp", self.script().tree))
        if token == "\\pi" or (token == "e" and not (self.author and self.author.letter_e)):
            self.take()
            return Piece(E if token == "e" else PI)
        if token in ORDERS and self.peek(1) == "(":
            self.take()
            return Piece(order(token, self.enclosed().tree))
        if self.author and self.is_term():
            return self.term()
        name = self.symbol()
        primes = self.primes() if self.author else 0
        if primes:
            return self.primed(name, primes)
        if self.author and self.peek() == "(" and (self.is_list() or self.is_argument(name)):
            return self.value(name, self.author.functions.get(name))
        return Piece(symbol(name), symbol=name)

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

    def indices_below(self) -> list[Expr]:
        """The indices in the subscript here."""
        inside = self.tokens[self.at + 1 : self.partner(self.at)] if self.peek() == "{" else []
        letters = [t for t in inside if t.isalpha() and len(t) == 1]
        numbered = len(inside) == 2 and inside[0] in "13456789" and len(letters) == 1
        if len(inside) > 1 and (len(letters) == len(inside) or numbered):  # a_{2n} is an even one
            self.at += len(inside) + 2
            indices = [number(int(t)) if t.isdigit() else symbol(t) for t in inside]
        elif "," in inside:
            self.at += 1
            indices = [self.sum().tree]
            while self.peek() == ",":
                self.take()
                indices.append(self.sum().tree)
            self.take("}")
        else:
            indices = [self.script().tree]
        return indices

    def is_argument(self, name: str) -> bool:
        """Whether the bracket here is the argument of ``name``: f(…), or one symbol, ε(γ)."""
        known = self.author and self.author.functions.get(name)
        if self.author and self.author.strict and (known or name in self.author.called):
            return name in self.author.called or bool(known and known.parameters)
        if self.author and name in FORCES & self.author.bare - self.author.applied:
            return False
        if name in LETTERS_OF_FUNCTIONS or known:
            return True
        if not self.guesses:
            return False
        start = self.at
        self.at += 1
        alone = is_letter(self.peek())
        if alone:
            self.symbol()
            alone = self.peek() == ")"
        self.at = start
        return alone

    def value(self, name: str, function: Function | None) -> Piece:
        """A function of the author's: what it is at its arguments, ε for ε(γ) of bare symbols."""
        start, values = self.at, self.arguments()
        if function is not None and len(values) == len(function.parameters):
            given = dict(zip(function.parameters, values, strict=True))
            return Piece(substitute(function.body, given))
        if not self.guesses and function is not None and not function.parameters:
            return Piece(symbol(name))
        if not self.guesses and name not in ("Gamma", "zeta") and function is None:
            return Piece(unknown(name, tuple(values)))
        if any(value.op != "symbol" for value in values) or not self.guesses:
            self.at = start
            self.refuse(f"{name}(…) is a function that is not known: write out what it is,")
        return Piece(symbol(name))

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

    def primed(self, name: str, primes: int) -> Piece:
        """``f'`` and ``f'(x)``: the derivative of what f stands for, or a symbol of its own."""
        known = self.author.derivative(name, "", primes) if self.author else None
        if known is None or self.author is None:
            if self.peek() == "(" and not self.guesses:
                return Piece(unknown(name, tuple(self.arguments()), (primes,)))
            called = f"{name}_prime{'' if primes == 1 else primes}"
            return Piece(symbol(called), symbol=called)
        if self.peek() != "(":
            return Piece(known)
        parameters, values = self.author.functions[name].parameters, self.arguments()
        if len(values) != 1:
            self.refuse(f"{name}' takes one argument,")
        return Piece(at(known, {parameters[0]: values[0]}))

    def arguments(self) -> list[Expr]:
        """What stands in a bracket, apart by commas."""
        opening = self.take()
        found = [self.sum().tree]
        while self.peek() == ",":
            self.take()
            found.append(self.sum().tree)
        self.take(BRACKETS[opening])
        return found


def _whole(e: Expr) -> int | None:
    """The natural number that ``e`` is, or None."""
    is_natural = e.op == "number" and e.args[0].q == 1 and e.args[0] >= 0
    return int(e.args[0].p) if is_natural else None


def _has_derivative(piece: Piece) -> bool:
    return any(node.op == "derivative" for node in outermost(piece.tree))


def _inverse(name: str) -> str:
    return {"log": "exp", "exp": "log"}.get(name) or (name[1:] if name[0] == "a" else f"a{name}")
