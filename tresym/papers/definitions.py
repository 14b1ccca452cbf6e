"""Definitions of a file of claims, and how they are put into claims.

``u := root(x - e*sin(x) - M, x, M - 2, M + 2)`` defines a quantity and ``f(x) := x*exp(x)`` a
function. A claim about u is a claim about the expression, which is put in before the claim is
decided.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from tresym.reals.decisions.statement import functions
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    Expr,
    bind,
    instantiate,
    rebuild,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.exact import InputError

PREFIX = "fn_"
"""What the grammar puts before the name of a function of several letters."""


@dataclass(frozen=True)
class Definition:
    """The definition of a quantity, or of a function.

    Attributes:
        line: where it stands in the file, from 1.
        name: what is defined.
        parameters: the arguments of a function; none for a quantity.
        text: the right side as written.
        written: the right side, with the names of other definitions.
        expression: the right side with the definitions above it put in.
        given: the declared conditions about its variables.
        place: where it stands in print, such as the number of an equation.
    """

    line: int
    name: str
    parameters: tuple[str, ...]
    text: str
    written: Expr
    expression: Expr
    given: tuple[Compared, ...] = ()
    place: str = ""

    @property
    def head(self) -> Expr:
        """The left side: ``u``, or ``f(x)``."""
        return (
            unknown(self.name, tuple(map(symbol, self.parameters)))
            if self.parameters
            else symbol(self.name)
        )


def define(
    line: int,
    name: str,
    parameters: tuple[str, ...],
    text: str,
    written: Expr,
    known: Mapping[str, Definition],
) -> Definition:
    """Return a definition whose right side may use the definitions ``known``."""
    return Definition(line, name, parameters, text, written, expanded(written, known))


def as_called(text: str, known: Iterable[str]) -> str:
    """Return the text with defined functions under names that the grammar takes for functions.

    Example:
        >>> as_called("2*mean(x) + meaning(x)", ["mean"])
        '2*fn_mean(x) + meaning(x)'
    """
    for name in known:
        text = re.sub(rf"(?<![\w\\]){re.escape(name)}(?=\s*\()", f"{PREFIX}{name}", text)
    return text


def expanded(e: Expr, known: Mapping[str, Definition]) -> Expr:
    """Return ``e`` with the definitions put in for their names and for calls of functions.

    A definition is an abbreviation: in ``diff(u, a)`` with ``u := a**2`` the derivative is that of
    a².

    Raises:
        InputError: a function is called with another number of arguments, or the name of a
            definition is the variable of an integral, a sum or a derivative.

    Example:
        >>> from tresym.reals.language.parsing import as_written
        >>> f = define(1, "f", ("x",), "x**2", as_written("x**2"), {})
        >>> str(expanded(as_written("fn_f(a + 1)"), {"f": f}))
        '(a + 1)**2'
    """
    quantities = {d.name: d.expression for d in known.values() if not d.parameters}
    calls = {PREFIX + d.name: d for d in known.values() if d.parameters}

    def walk(node: Expr) -> Expr:
        if node.op == "symbol":
            return quantities.get(node.args[0], node)
        if node.op in LEAVES:
            return node
        if node.names:
            return under(node)
        args = tuple(map(walk, node.args)) if node.op != "unknown" else node.args
        if node.op != "unknown":
            return rebuild(node, args)
        args = tuple(map(walk, node.args[1:]))
        name, orders = node.args[0].args
        return _call(calls[name], orders, args) if name in calls else unknown(name, args, orders)

    def under(node: Expr) -> Expr:
        """A binder: its variable has its own name inside, where a definition may depend on it."""
        for name in node.names:
            if name in quantities:
                raise InputError(
                    f"{name} is defined on line {known[name].line}, so it cannot be the variable "
                    "of an integral, a sum, a limit or a derivative: use another letter there"
                )
        if not symbols(node.args[0]).isdisjoint(node.names):
            raise InputError(f"{node.names[0]} is used inside and outside of {node}: rename one")
        body = walk(instantiate(node.args[0], tuple(map(symbol, node.names))))
        return Expr(node.op, (bind(body, node.names), *map(walk, node.args[1:])), node.names)

    return walk(e) if quantities or calls else e


def _call(definition: Definition, orders: tuple[int, ...], values: tuple[Expr, ...]) -> Expr:
    parameters = definition.parameters
    if len(values) != len(parameters):
        takes = "1 argument" if len(parameters) == 1 else f"{len(parameters)} arguments"
        raise InputError(f"{definition.name} takes {takes}, {len(values)} given")
    body = definition.expression
    for parameter, times in zip(parameters, orders, strict=True):
        for _ in range(times):
            body = differentiate(body, parameter)
    return substitute(body, dict(zip(parameters, values, strict=True)))


def names_in(e: Expr) -> frozenset[str]:
    """Return the names of the variables and of the functions in an expression."""
    return symbols(e) | {node.args[0].args[0].removeprefix(PREFIX) for node in functions(e)}
