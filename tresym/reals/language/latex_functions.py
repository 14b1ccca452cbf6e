"""The grammar of functions and their arguments in LaTeX."""

from __future__ import annotations

from abc import abstractmethod
from collections.abc import Callable
from math import factorial

from tresym.reals.language.calls import call
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    Expr,
    apply,
    multiply,
    sqrt,
)
from tresym.reals.language.latex_calculus import CalculusReader
from tresym.reals.language.latex_cursor import (
    BRACKETS,
    is_letter,
    is_number,
)
from tresym.reals.language.latex_operands import (
    Piece,
    Rule,
    after_braces,
    after_bracket,
    after_nested,
    after_open,
    whole,
)
from tresym.reals.language.latex_tokens import (
    FUNCTIONS,
    LETTERS_OF_FUNCTIONS,
)

MAX_FACTORIAL = 100
FORCES = frozenset(("F", "G"))
"""Letters of functions that are also usual for numbers."""


class FunctionReader(CalculusReader):
    """Read functions with their arguments, roots and binomial coefficients."""

    def degrees(self) -> bool:
        """Whether ``^\\circ`` stands here, which is stepped over."""
        for form in (["^", "\\circ"], ["^", "{", "\\circ", "}"]):
            if self.tokens[self.at : self.at + len(form)] == form:
                self.at += len(form)
                return True
        return False

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

    def binomial(self) -> Piece:
        """``\\binom{n}{k}``: for a number k the product, else by factorials, 0 ≤ k ≤ n."""
        self.take()
        above, below = self.argument_group().tree, self.argument_group().tree
        k = natural(below)
        if k is None or k > MAX_FACTORIAL:
            n, m, rest = (call("factorial", [e]) for e in (above, below, above - below))
            return Piece(n / (m * rest))
        factors = [above - n for n in range(k)]
        return Piece(multiply(*factors) / factorial(k)) if k else Piece(ONE)

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

    def arguments(self) -> list[Expr]:
        """What stands in a bracket, apart by commas."""
        opening = self.take()
        found = [self.sum().tree]
        while self.peek() == ",":
            self.take()
            found.append(self.sum().tree)
        self.take(BRACKETS[opening])
        return found

    @abstractmethod
    def absolute(self) -> Piece:
        """An absolute value."""

    @abstractmethod
    def base(self) -> Piece:
        """A bracket, a command with its arguments, a number or a name."""


def natural(e: Expr) -> int | None:
    """The natural number that ``e`` is, or None."""
    is_natural = e.op == "number" and e.args[0].q == 1 and e.args[0] >= 0
    return int(e.args[0].p) if is_natural else None


def _inverse(name: str) -> str:
    return {"log": "exp", "exp": "log"}.get(name) or (name[1:] if name[0] == "a" else f"a{name}")
