"""A reader of the terms of Coq that shares nothing with the printer of statements."""

import re
from collections.abc import Callable

from flint import arb

TOKEN = re.compile(r"\d+|[A-Za-z_][\w']*|<->|<>|<=|>=|->|=>|/\\|[-+*/^()=<>:,.!~]")
COMMENT = re.compile(r"\(\*.*?\*\)")

ONE: dict[str, Callable[[arb], arb]] = {
    "sqrt": lambda x: x.sqrt(),
    "Rabs": lambda x: abs(x),
    "sign": lambda x: x.sgn(),
    "ln": lambda x: x.log(),
    "arcsinh": lambda x: x.asinh(),
    **{
        name: (lambda x, name=name: getattr(x, name)())  # type: ignore[misc]
        for name in ("exp", "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan")
    },
    **{
        name: (lambda x, name=name: getattr(x, name)())  # type: ignore[misc]
        for name in ("sinh", "cosh", "tanh", "coth", "sech", "csch", "acosh", "atanh")
    },
}


def odd_root(n: int, x: arb) -> arb:
    return -((-x).root(n)) if x < 0 else x.root(n)


TWO: dict[str, Callable[[arb, arb], arb]] = {
    "Rpower": lambda x, y: (y * x.log()).exp(),
    "atan2": lambda y, x: arb.atan2(y, x),
    "root": lambda n, x: odd_root(int(n.unique_fmpz()), x),
}


class Terms:
    """Coq's grammar of terms, as far as statements use it: a term is its value."""

    def __init__(self, text: str, at: dict[str, arb]) -> None:
        self.tokens = TOKEN.findall(COMMENT.sub("", text))
        self.place = 0
        self.at = at

    def peek(self, ahead: int = 0) -> str:
        place = self.place + ahead
        return self.tokens[place] if place < len(self.tokens) else ""

    def take(self, *tokens: str) -> str:
        found = self.peek()
        assert found
        assert not tokens or found in tokens, (found, tokens)
        self.place += 1
        return found

    def sum(self) -> arb:
        value = self.product()
        while self.peek() in ("+", "-"):
            value = value + self.product() if self.take() == "+" else value - self.product()
        return value

    def product(self) -> arb:
        value = self.factor()
        while self.peek() in ("*", "/"):
            value = value * self.factor() if self.take() == "*" else value / self.factor()
        return value

    def factor(self) -> arb:
        if self.peek() in ("/", "-"):
            return 1 / self.factor() if self.take() == "/" else -self.factor()
        base = self.application()
        if self.peek() == "^":
            self.take()
            return base ** int(self.take())
        return base

    def application(self) -> arb:
        name = self.peek()
        if name in ONE:
            self.take()
            return ONE[name](self.atom())
        if name in TWO:
            self.take()
            first = self.atom()
            return TWO[name](first, self.atom())
        return self.atom()

    def atom(self) -> arb:
        token = self.take()
        if token == "(":
            value = self.sum()
            self.take(")")
            return value
        if token == "PI":
            return arb.pi()
        assert re.fullmatch(r"\w[\w']*", token), token
        return arb(int(token)) if token.isdigit() else self.named(token)

    def named(self, name: str) -> arb:
        return self.at[name]
