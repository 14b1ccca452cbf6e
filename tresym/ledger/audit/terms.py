"""Comparable trees: what LaTeX says and what a claim says, in one language.

Integrals, evaluation bars, orders and the author's functions are no expressions. Each becomes a
symbol, and two of them the same symbol when they are of one kind and all their parts agree; then
equality is a matter of balls at exact points. A function that the paper itself defines is put in.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from typing import Any

from flint import arb

from tresym.reals.language.expression import (
    FUNCTIONS,
    ZERO,
    Expr,
    differentiate,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.latex_tokens import CALLS
from tresym.reals.language.parsing import parse
from tresym.reals.language.sympy import from_sympy
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.places.conditions import Given
from tresym.reals.places.values import evaluate

BITS = 192
ENOUGH = 5
"""Points at which both sides are defined and agree before two expressions count as the same."""
AT_LEAST = 3
TRIES = 120
SMALL = 1e-12

_DERIVATIVE = re.compile(r"(?:d|partial)(\w+?)_(?:d|partial)(\w+)")
_PLAIN = FUNCTIONS | {"sqrt", "ln", "Abs"}


@dataclass(frozen=True)
class Function:
    """A function that the paper defines: its parameters, and its value as text."""

    parameters: tuple[str, ...]
    body: str


@dataclass(frozen=True)
class _Stand:
    """Something that is no expression, and the symbol that stands for it."""

    kind: str
    parts: tuple[Expr, ...]
    name: str


@dataclass
class Terms:
    """Builds comparable trees under the conditions ``given``.

    Attributes:
        functions: the author's functions by name.
        reads: names and calls that the claim writes otherwise, as text of the grammar.
        given: the claim's conditions; agreement is tried only where they hold.
        variable: of a bracket with limits, which LaTeX does not name.
    """

    functions: Mapping[str, Function] = field(default_factory=dict)
    reads: Mapping[str, str] = field(default_factory=dict)
    given: Given = field(default_factory=Given)
    variable: str = ""
    stands: list[_Stand] = field(default_factory=list)

    def from_text(self, text: str) -> Expr:
        """The tree of what the LaTeX reader wrote.

        Raises:
            InputError: text that is neither of the grammar nor of the reader's additions.
        """
        tree = self._read(text)
        names = {name: self._named(name) for name in symbols(tree)}
        return substitute(tree, {name: e for name, e in names.items() if e is not None})

    def _read(self, text: str) -> Expr:
        """Special calls are cut out of the text, read on their own, and put back."""
        pieces: list[str] = []
        put_back: dict[str, Expr] = {}
        at = 0
        for call in _special_calls(text):
            name, end = f"cut{len(put_back)}", call.end_col_offset or len(text)
            pieces.append(text[at : call.col_offset] + name)
            written = self.reads.get(text[call.col_offset : end])
            put_back[name] = parse(written) if written else self._call(text, call)
            at = end
        return substitute(parse("".join(pieces) + text[at:]), put_back)

    def _named(self, name: str) -> Expr | None:
        """What a name of the LaTeX stands for, if not itself."""
        if name in self.reads:
            return parse(self.reads[name])
        derivative = _DERIVATIVE.fullmatch(name)
        if derivative and derivative[1] in self.functions:
            body = self.from_text(self.functions[derivative[1]].body)
            if not _has_stand(body):
                return differentiate(body, derivative[2])
        return symbol(name.rstrip("_")) if name.endswith("_") else None

    def _call(self, text: str, call: ast.Call) -> Expr:
        assert isinstance(call.func, ast.Name)
        parts = [text[a.col_offset : a.end_col_offset] for a in call.args]
        match call.func.id, parts:
            case "integral", [body, x, low, high]:
                ends = self.from_text(low), self.from_text(high)
                return self.integral(self.from_text(body), x, *ends)
            case "at", [e, x, value]:
                return self.at(self.from_text(e), x, self.from_text(value))
            case "between", [e, low, high]:
                tree = self.from_text(e)
                ends = self.from_text(low), self.from_text(high)
                return _put(tree, self.variable, ends[1]) - _put(tree, self.variable, ends[0])
            case "diff", [e, x]:
                return self.derivative(self.from_text(e), x.rstrip("_"))
            case name, _:
                return self.application(name, parts)

    def application(self, name: str, parts: list[str]) -> Expr:
        """A function the paper defines, at its arguments; ε(γ) with bare symbols is just ε."""
        function = self.functions.get(name)
        if function is not None and len(parts) == len(function.parameters):
            values = [self.from_text(part) for part in parts]
            body = self.from_text(function.body)
            return substitute(body, dict(zip(function.parameters, values, strict=True)))
        if name not in CALLS and all(part.isidentifier() for part in parts):
            return self.from_text(name)
        return self.stand(name, *(self.from_text(part) for part in parts))

    def from_sympy(self, e: Any) -> Expr:
        """The tree of what a claim says.

        Raises:
            InputError: SymPy expressions that are neither elementary nor one of the kinds above.
        """
        import sympy

        put_back: dict[str, Expr] = {}
        opaque: dict[Any, Any] = {}
        for node in dict.fromkeys(_outermost(e)):
            name = f"cut{len(put_back)}"
            put_back[name] = self._node(node)
            opaque[node] = sympy.Symbol(name, real=True)
        return substitute(from_sympy(e.xreplace(opaque) if opaque else e), put_back)

    def _node(self, node: Any) -> Expr:
        kind = type(node).__name__
        if kind == "Integral":
            variable, low, high = node.limits[0]
            ends = self.from_sympy(low), self.from_sympy(high)
            return self.integral(self.from_sympy(node.function), variable.name, *ends)
        if kind == "Derivative":
            tree = self.from_sympy(node.expr)
            for variable in node.variables:
                tree = self.derivative(tree, variable.name)
            return tree
        if kind == "Subs":
            tree = self.from_sympy(node.expr)
            for variable, value in zip(node.variables, node.point, strict=True):
                tree = self.at(tree, variable.name, self.from_sympy(value))
            return tree
        name = "O" if kind == "Order" else node.func.__name__
        if name not in CALLS and all(a.is_Symbol for a in node.args):
            return symbol(name)
        arguments = node.args[:1] if kind == "Order" else node.args
        return self.stand(name, *(self.from_sympy(a) for a in arguments))

    def integral(self, body: Expr, x: str, low: Expr, high: Expr) -> Expr:
        """The integral, on whose interval the integrands are compared."""
        inside = (symbol(x) - low) * (high - symbol(x))
        return self.stand(f"integral over {x}", body, low, high, where=((inside, ">", ZERO),))

    def derivative(self, e: Expr, x: str) -> Expr:
        """The derivative, carried out; of anything else a symbol, ``partialF_partialx`` of F."""
        if not _has_stand(e):
            return differentiate(e, x)
        for name, function in self.functions.items():
            if self.from_text(function.body) == e:
                return symbol(f"partial{name}_partial{x}")
        return self.stand("diff", e, symbol(x))

    def at(self, e: Expr, x: str, value: Expr) -> Expr:
        """``e`` where ``x`` has the value: put in, or a symbol where ``x`` is not seen in ``e``."""
        if x in symbols(e) and e != symbol(x) and not _has_stand(e):
            return _put(e, x, value)
        return self.stand(f"at {x}", e, value)

    def stand(
        self, kind: str, *parts: Expr, where: tuple[tuple[Expr, str, Expr], ...] = ()
    ) -> Expr:
        """The symbol for something of this kind with these parts."""
        given = self.given & Given(where)
        for known in self.stands:
            if known.kind == kind and len(known.parts) == len(parts):
                pairs = zip(known.parts, parts, strict=True)
                if all(agree(p, q, given) for p, q in pairs):
                    return symbol(known.name)
        new = _Stand(kind, parts, f"[{kind} {len(self.stands)}]")
        self.stands.append(new)
        return symbol(new.name)

    def same(self, x: Expr, y: Expr) -> bool:
        """Whether two trees agree under the conditions."""
        return agree(x, y, self.given)


def _has_stand(e: Expr) -> bool:
    """Whether something in ``e`` is no expression."""
    return any(name.startswith("[") for name in symbols(e))


def _put(e: Expr, x: str, value: Expr) -> Expr:
    return substitute(e, {x: value})


def agree(x: Expr, y: Expr, given: Given) -> bool:
    """Whether balls at exact points of ``given`` overlap wherever both sides are defined.

    Agreement guards against slips of transcription; it is no proof and gives no verdict.
    """
    if x == y:
        return True
    seen = 0
    for point in given.points(symbols(x) | symbols(y), TRIES):
        with ball_precision(BITS):
            at = {name: arb(value) for name, value in point.items()}
            difference = evaluate(x - y, at)
            if not difference.is_finite() or difference.rad() > SMALL:
                continue
            if not difference.contains(0):
                return False
        seen += 1
        if seen == ENOUGH:
            return True
    return seen >= AT_LEAST


def _special_calls(text: str) -> Iterator[ast.Call]:
    """Outermost calls that the expression grammar does not know, from left to right."""
    try:
        tree = ast.parse(text, mode="eval")
    except SyntaxError:
        raise InputError(f"{text!a} is not an expression") from None

    def walk(node: ast.AST) -> Iterator[ast.Call]:
        if isinstance(node, ast.Call) and isinstance(node.func, ast.Name):
            known = node.func.id in _PLAIN
            if not known or node.func.id == "diff":
                yield node
                return
        for child in ast.iter_child_nodes(node):
            yield from walk(child)

    return iter(sorted(walk(tree), key=lambda call: call.col_offset))


def _outermost(e: Any) -> Iterator[Any]:
    """Outermost integrals, derivatives, substitutions, orders and undefined functions."""
    from sympy import Derivative, Integral, Order, Subs
    from sympy.core.function import AppliedUndef

    if isinstance(e, Derivative | Integral | Subs | Order | AppliedUndef):
        yield e
        return
    for argument in e.args:
        yield from _outermost(argument)
