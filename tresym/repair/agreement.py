"""Whether a changed claim agrees with the values of the original, at points and in the limit."""

from __future__ import annotations

import math
from typing import NamedTuple, TypeAlias

from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    Expr,
    instantiate,
    number,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.paths import Path
from tresym.repair.floating import Points, UnsupportedError
from tresym.repair.samples import held, near_end

NEARER = (3e-3, 3e-4)
ORDER_STEPS = (0.1, 0.03)
"""The distances from the end of a path at which asymptotic statements are tested."""


Definitions: TypeAlias = tuple[tuple[str, Expr], ...]
"""Symbols and their definitions, in the order of substitution."""


class Claim(NamedTuple):
    """The parts of a claim: a chain, its conditions, its path, and definitions of symbols."""

    terms: tuple[Expr, ...]
    relations: tuple[str, ...]
    given: tuple[Compared, ...]
    path: Path | None
    put: Definitions = ()

    @property
    def links(self) -> list[Compared]:
        """Return the comparisons of neighbouring sides."""
        return [*zip(self.terms, self.relations, self.terms[1:], strict=False)]

    @property
    def integers(self) -> list[str]:
        """Return the variables that are integers by the conditions."""
        return [str(left) for left, relation, _ in self.given if relation == "in"]

    def defined(self) -> Claim:
        """Return the claim with the definitions of its symbols substituted."""
        terms = self.terms
        for name, value in self.put:
            terms = tuple(substitute(term, {name: value}) for term in terms)
        return self._replace(terms=terms, put=())

    def says(self) -> str:
        """Return the chain in the text grammar."""
        rest = (f" {r} {t}" for r, t in zip(self.relations, self.terms[1:], strict=True))
        return str(self.terms[0]) + "".join(rest)

    def text(self, more: str = "") -> str:
        """Return the claim in the text grammar, optionally with one more condition."""
        under = ", ".join(filter(None, (chained(self.given), more)))
        text = self.defined().says() + (f" given {under}" if under else "")
        return text + (f" as {self.path}" if self.path is not None else "")


def agrees_with_values(claim: Claim, link: Compared, points: Points) -> bool:
    """Return whether a comparison holds at two or more points, and fails at no more than one."""
    left, _, right = link
    path = claim.path
    if left.op == "limit" or right.op == "limit":
        node, value = (left, right) if left.op == "limit" else (right, left)
        (name,), body = opened(node, symbols(value))
        end = node.args[1]
        return _tends(points, name, end, int(node.args[2].args[0].p), (body, "->", value))
    if path is not None:
        end = path.point if path.point is not None else number(path.sides[0]) * INFINITY
        return _tends(points, path.name, end, path.sides[0], link)
    found = held(points, without_integrals(link))
    fails = found.count(False)
    if points.count == 1:
        return found == [True]
    return found.count(True) >= 2 and fails <= (1 if found.count(True) > 4 else 0)


def _tends(points: Points, name: str, end: Expr, side: int, link: Compared) -> bool:
    """Return whether an asymptotic statement is seen to hold near the end of its path."""
    left, relation, right = link
    orders = [node for node in outermost(right) if node.op in ("O", "o")]
    if relation == "==" and len(orders) == 1:
        rest = replaced(right, {orders[0]: number(0)})
        left, relation, right = left - rest, orders[0].op, orders[0].args[0]
    if relation not in ("->", "~", "O", "o"):
        raise UnsupportedError(relation)
    gaps = []
    for step in NEARER if relation in ("->", "~") else ORDER_STEPS:
        near = near_end(points, name, end, side, step)
        if right in (INFINITY, -INFINITY):
            sign = 1 if right == INFINITY else -1
            gaps.append([1 / (sign * x) if x * sign > 0 else math.nan for x in near.values(left)])
            continue
        rows = near.values(left), near.values(right)
        if relation == "->":
            gaps.append([abs(x - y) / max(1.0, abs(y)) for x, y in zip(*rows, strict=True)])
        else:
            shift = 1 if relation == "~" else 0
            gaps.append([abs(x / y - shift) if y else math.nan for x, y in zip(*rows, strict=True)])
    most = {"O": 1.8, "o": 0.9, "->": 0.8, "~": 0.8}[relation]
    pairs = [(x, y) for x, y in zip(*gaps, strict=True) if math.isfinite(x + y)]
    holds = [y <= most * x or y < 1e-6 for x, y in pairs]
    return holds.count(True) >= 1 and holds.count(False) <= len(holds) // 3


def without_integrals(link: Compared) -> Compared:
    """Return an equation of indefinite integrals as one of their derivatives."""
    left, relation, right = link
    nodes = [node for node in outermost(left, right) if node.op == "antiderivative"]
    if not nodes:
        return link
    by = str(nodes[0].args[1])
    return _slope(left, by), relation, _slope(right, by)


def _slope(e: Expr, by: str) -> Expr:
    """Return the derivative by a variable; that of an indefinite integral is its integrand."""
    nodes = [node for node in dict.fromkeys(outermost(e)) if node.op == "antiderivative"]
    marks = {node: symbol(f"[{n}]") for n, node in enumerate(nodes)}
    plain = replaced(e, marks)
    slope = differentiate(plain, by)
    for node, mark in marks.items():
        inner = instantiate(node.args[0], (node.args[1],))
        slope = slope + differentiate(plain, str(mark)) * inner
    return substitute(slope, {str(mark): number(0) for mark in marks.values()})
