"""Theorems as trees: what a Coq theorem says, and where its integrals and derivatives exist."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple, TypeAlias

from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    Expr,
    fresh,
    instantiate,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Conjunction, Equivalence, Relation

Part = tuple[Expr, str]
Condition = tuple[Expr, str, Expr]


class Wherever(NamedTuple):
    """What is said wherever the conditions hold."""

    conditions: tuple[Condition, ...]
    says: Formula


class One(NamedTuple):
    """There is one value of the variable, and no other, of which it is said."""

    name: str
    says: Formula


class Some(NamedTuple):
    """There are values of the variables of which it is said."""

    names: tuple[str, ...]
    says: Formula


class Every(NamedTuple):
    """It is said of all values of the variables."""

    names: tuple[str, ...]
    says: Formula


class Fails(NamedTuple):
    """It does not hold."""

    says: Formula


Formula: TypeAlias = Relation | Conjunction | Equivalence | Wherever | One | Some | Every | Fails


class Single:
    """The one relation that a theorem says, taken apart."""

    says: Formula

    @property
    def by(self) -> str | None:
        """Of a derivative that is the left side: the variable."""
        node = self._relation.left
        return str(node.args[1].args[0]) if node.op == "derivative" else None

    @property
    def left(self) -> Expr:
        """The left side of the relation that is said; of a derivative, the function."""
        node = self._relation.left
        return node if self.by is None else instantiate(node.args[0], node.args[1:])

    @property
    def relation(self) -> str:
        """The sign of the relation that is said."""
        return self._relation.sign

    @property
    def right(self) -> Expr:
        """Its right side."""
        return self._relation.right

    @property
    def _relation(self) -> Relation:
        if not isinstance(self.says, Relation):
            raise TypeError("what is said is no single relation")
        return self.says


def inside(node: Expr) -> tuple[tuple[str, ...], Expr]:
    """The variables that a node binds, by names that are not free in its body, and the body."""
    names: list[str] = []
    for name in node.names:
        names.append(fresh(name, {*symbols(node.args[0]), *names}))
    return tuple(names), instantiate(node.args[0], tuple(map(symbol, names)))


def put_at(e: Expr) -> Expr:
    """``e`` with the values put in at which integrals and derivatives are taken."""
    if e.op == "at":
        names, body = inside(e)
        if not elementary(body):
            return put_at(substitute(body, dict(zip(names, e.args[1:], strict=True))))
    if e.op in LEAVES | BINDERS:
        return e
    parts = tuple(map(put_at, e.args))
    return e if parts == e.args else rebuild(e, parts)  # as it is written


def values_of(f: Relation) -> tuple[Relation, dict[Expr, Expr]]:
    """The relation with names for its integrals and derivatives, and what they are names of."""
    left, right = put_at(f.left), put_at(f.right)
    nodes = [node for node in dict.fromkeys(outermost(left, right)) if node.op != "at"]
    if not nodes:
        return Relation(left, f.sign, right), {}
    taken = symbols(left) | symbols(right)
    names = {node: symbol(fresh(f"value{n}", taken)) for n, node in enumerate(nodes, 1)}
    return Relation(replaced(left, names), f.sign, replaced(right, names)), names


def defined(e: Expr) -> Iterator[Part]:
    """What is above zero, or not zero, where ``e`` is defined, but for its integrals.

    What is derived is asked to be defined beside the point, too.
    """
    e = put_at(e)
    names = {node: symbol(f"[{n}]") for n, node in enumerate(outermost(e))}
    hidden = {name.args[0] for name in names.values()}
    yield from (part for part in needs([replaced(e, names)]) if hidden.isdisjoint(symbols(part[0])))
    for node in names:
        for place in node.args[1:]:
            yield from defined(place)
        if node.op in ("derivative", "at"):
            bound, body = inside(node)
            there = dict(zip(bound, node.args[1:], strict=True))
            for part, sign in defined(body):
                edge = sign == ">=" and node.op == "derivative" and bound[0] in symbols(part)
                yield substitute(part, there), ">" if edge else sign
