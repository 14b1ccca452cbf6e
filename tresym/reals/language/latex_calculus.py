"""The grammar of sums, products, integrals, limits and derivatives in LaTeX."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable

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
    MAX_DERIVATIVES,
    ORDERS,
    PI,
    E,
    Expr,
    add,
    apply,
    extreme,
    number,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.latex_cursor import (
    BRACKETS,
    DIFFERENTIALS,
    NO_DERIVATIVE,
    Author,
    Cursor,
    Function,
    derived,
    is_letter,
)
from tresym.reals.language.latex_operands import (
    Piece,
    Rule,
    after_derivative,
    after_derivative_of_bracket,
    joined,
)
from tresym.reals.language.latex_tokens import (
    EXTREMES,
    OF_GREEK,
    RELATIONS,
    WITH_ORDER,
)

TOTALS = {"\\sum": "sum", "\\prod": "product"}


class CalculusReader(Cursor):
    """Read sums, integrals, limits, derivatives and values at points."""

    def factor_or_differential(self) -> Piece | None:
        """A factor, or None where the differential of an integral was stepped over."""
        if not self.at_differential():
            return self.factor()
        self.take("d")
        self.differentials.append(self.symbol())
        return None

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

    def barred(self) -> Piece:
        """``\\left. … \\right|_{x = value}``, and between two values."""
        self.take("\\left.")
        piece = self.sum()
        self.take("\\right|")
        return self.evaluated(piece.tree)

    def extreme(self) -> Piece:
        """``\\max(x, y)``, ``\\min\\{x, y, z\\}``."""
        token = self.take()
        if self.peek() not in ("(", "\\{") or not self.is_list():
            self.refuse(f"{token} takes a list in brackets: write {token}(x, y),")
        return Piece(extreme(EXTREMES[token], self.arguments()))

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
        variable = type(self)(below[1:], self.author)
        name = variable.symbol()
        if variable.peek():
            variable.refuse("one variable is expected")
        if not above:
            return self.differentiated(kind, name, times)
        function = type(self)(above, self.author)
        piece = function.product()
        if function.peek():
            function.refuse("one product is expected")
        if not (piece.symbol and piece.strength == 4):
            return self.slope(piece, kind, name, times)
        return self.of_symbol(kind, piece.symbol, name, times)

    def repeated(self, order: str, below: list[str]) -> Piece:
        """``\\frac{d^n}{dx^n}`` of what follows."""
        variable = type(self)(below[1:], self.author)
        name = variable.symbol()
        if variable.peek():
            variable.refuse("one variable is expected")
        return self.followed(name, lambda e: Piece(nth_derivative(e.tree, name, symbol(order))))

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
            shown = type(self)([*name, *inside], Author()).sum()
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
        special = None if self.guesses else self.special_function()
        if special is not None:
            return special
        if self.author and self.is_term():
            return self.term()
        name = self.symbol()
        primes = self.primes() if self.author else 0
        if primes:
            return self.primed(name, primes)
        if self.author and self.peek() == "(" and (self.is_list() or self.is_argument(name)):
            return self.value(name, self.author.functions.get(name))
        return Piece(symbol(name), symbol=name)

    def special_function(self) -> Piece | None:
        """``\\Gamma(x)``, ``\\zeta(s)``, ``J_0(x)``, ``\\operatorname{Li}_2(x)``, or None.

        A letter keeps the meaning that it has elsewhere: it must stand before a bracket wherever
        it occurs. Bessel functions are not read in an author's text, where J, K and I are usual
        names of other things.
        """
        start, token = self.at, self.peek()
        order: list[Expr] = []
        if token in OF_GREEK and self.peek(1) in ("(", "^"):
            letter = token.lstrip("\\")
            if self.author and (letter in self.author.bare or letter in self.author.functions):
                return None
            places = [n for n, other in enumerate(self.tokens) if other == token]
            if any(self.tokens[n + 1 : n + 2] not in (["("], ["^"]) for n in places):
                return None
            name = OF_GREEK[token]
            self.at += 1
        elif token.lstrip("\\") in WITH_ORDER and self.peek(1) == "_":
            if self.author and not token.startswith("\\"):
                return None
            name = WITH_ORDER[token.lstrip("\\")]
            if name == "expint":  # E_1 is usual for energies
                return None
            self.at += 2
            order = [self.script().tree]
        else:
            return None
        exponent = None
        if self.peek() == "^":
            self.at += 1
            exponent = self.script().tree
        if self.peek() != "(":
            self.at = start
            return None
        tree = call(name, [*order, *self.arguments()])
        return Piece(tree) if exponent is None else Piece(tree**exponent, 3)

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

    @abstractmethod
    def argument_group(self) -> Piece:
        """The argument of a command, an exponent: a group, or one token."""

    @abstractmethod
    def arguments(self) -> list[Expr]:
        """What stands in a bracket, apart by commas."""

    @abstractmethod
    def enclosed(self) -> Piece:
        """What stands in a bracket, or in braces."""

    @abstractmethod
    def extend(self, factors: list[Piece | None], operators: list[str]) -> None:
        """One more factor of a product, which a sign may lead in."""

    @abstractmethod
    def factor(self, base: Piece | None = None) -> Piece:
        """A base, here or read already, with its powers, evaluation bars and values at a point."""

    @abstractmethod
    def is_argument(self, name: str) -> bool:
        """Whether the bracket here is the argument of ``name``: f(…), or one symbol, ε(γ)."""

    @abstractmethod
    def is_term(self) -> bool:
        """Whether a term of an author's sequence stands here, ``a_k``."""

    @abstractmethod
    def of_symbol(self, kind: str, above: str, below: str, times: int) -> Piece:
        """The derivative of a symbol of an author's: of what it stands for, or one more symbol."""

    @abstractmethod
    def operand(
        self,
        applied: Callable[[Piece], Piece],
        first: Piece,
        rule: Rule,
        matters: Callable[[Piece], bool] = lambda _: True,
    ) -> Piece:
        """``applied`` to ``first`` and to what follows, as far as the rule for it goes."""

    @abstractmethod
    def product(self) -> Piece:
        """Factors side by side; a slash divides by one factor, and what follows it is refused."""

    @abstractmethod
    def script(self) -> Piece:
        """An exponent or a limit: a group, or one token."""

    @abstractmethod
    def signed(self) -> Piece:
        """The first term of a sum, perhaps with a sign."""

    @abstractmethod
    def sum(self) -> Piece:
        """Terms joined by + and −."""

    @abstractmethod
    def term(self) -> Piece:
        """``a_k`` as a(k), ``a_{ij}``, ``a_{1j}`` and ``a_{i,j}`` as functions of two indices."""


def _has_derivative(piece: Piece) -> bool:
    return any(node.op == "derivative" for node in outermost(piece.tree))
