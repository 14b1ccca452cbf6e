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
    """``says`` holds wherever the conditions do."""

    conditions: tuple[Condition, ...]
    says: Formula


class One(NamedTuple):
    """There is exactly one value of the variable that satisfies ``says``."""

    name: str
    says: Formula


class Some(NamedTuple):
    """There are values of the variables that satisfy ``says``."""

    names: tuple[str, ...]
    says: Formula


class Every(NamedTuple):
    """``says`` holds for all values of the variables."""

    names: tuple[str, ...]
    says: Formula


class Fails(NamedTuple):
    """``says`` does not hold."""

    says: Formula


Formula: TypeAlias = Relation | Conjunction | Equivalence | Wherever | One | Some | Every | Fails


class Single:
    """Access to the parts of a theorem whose conclusion is a single relation."""

    says: Formula

    @property
    def by(self) -> str | None:
        """The variable of differentiation, if the left side is a derivative; else None."""
        node = self._relation.left
        return str(node.args[1].args[0]) if node.op == "derivative" else None

    @property
    def left(self) -> Expr:
        """The left side of the relation; for a derivative, the differentiated function."""
        node = self._relation.left
        return node if self.by is None else instantiate(node.args[0], node.args[1:])

    @property
    def relation(self) -> str:
        """The sign of the relation."""
        return self._relation.sign

    @property
    def right(self) -> Expr:
        """The right side of the relation."""
        return self._relation.right

    @property
    def _relation(self) -> Relation:
        if not isinstance(self.says, Relation):
            raise TypeError("the theorem does not state a single relation")
        return self.says


def inside(node: Expr) -> tuple[tuple[str, ...], Expr]:
    """Return the bound variables of a node, renamed if they are free in its body, and the body."""
    names: list[str] = []
    for name in node.names:
        names.append(fresh(name, {*symbols(node.args[0]), *names}))
    return tuple(names), instantiate(node.args[0], tuple(map(symbol, names)))


def put_at(e: Expr) -> Expr:
    """Carry out the substitutions (`at` nodes) in ``e`` whose bodies contain binders."""
    if e.op == "at":
        names, body = inside(e)
        if not elementary(body):
            return put_at(substitute(body, dict(zip(names, e.args[1:], strict=True))))
    if e.op in LEAVES | BINDERS:
        return e
    parts = tuple(map(put_at, e.args))
    return e if parts == e.args else rebuild(e, parts)  # without simplification


def values_of(f: Relation) -> tuple[Relation, dict[Expr, Expr]]:
    """Replace the integrals and derivatives of a relation by names; return it and the names."""
    left, right = put_at(f.left), put_at(f.right)
    nodes = [node for node in dict.fromkeys(outermost(left, right)) if node.op != "at"]
    if not nodes:
        return Relation(left, f.sign, right), {}
    taken = symbols(left) | symbols(right)
    names = {node: symbol(fresh(f"value{n}", taken)) for n, node in enumerate(nodes, 1)}
    return Relation(replaced(left, names), f.sign, replaced(right, names)), names


def defined(e: Expr) -> Iterator[Part]:
    """Return what must be positive or non-zero for ``e`` to be defined, integrals excepted.

    A function that is differentiated must be defined in a neighbourhood of the point.
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
