"""Check that what passes speaks of something: both sides are defined, terms of sums included.

A claim is about the points at which both sides are defined. A proof is accepted only if there is
such a point: all conditions hold, sums are not empty, and evaluation shows that every part is
defined. Requirements of the terms of a sum or product on the index alone must hold at every index.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import arb, fmpq

from tresym.reals.cross_check import SHOWN, program, somewhere
from tresym.reals.decisions.integer_variables import reduced_in
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import is_infinite, outermost
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    DOTS,
    LEAVES,
    ONE,
    ZERO,
    Expr,
    integer,
    number,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign_by

INSIDE = fmpq(3, 7)
"""Of the way between the ends of an integral: where its integrand is looked at."""
ONE_BY_ONE = 12
"""So many indices are looked at one by one, and all beyond them at once."""
NODES = frozenset(("sum", "product", "unknown", "integral", "nth"))


def unspoken(claim: Comparison, statement: Statement) -> str | None:
    """Return why a proved claim may be vacuous, in words; None if a point shows it is not."""
    sides: tuple[Expr, ...] = (claim.left, claim.right)
    nodes = [node for node in outermost(*sides) if node.op in NODES]
    if not nodes or statement.path is not None or any(DOTS.args[0] in symbols(e) for e in sides):
        return None
    for node in (n for side in sides for n in _sums(side)):
        part = _undefined_at_an_index(node)
        if part is not None:
            return f"{part} could not be shown to keep every term of {node} defined"
    if any(node.op == "derivative" for node in outermost(*sides)):
        return None  # Leibniz's rule has shown a point where its result is defined
    sides = tuple(map(_sampled, sides))
    own = [node for node in outermost(*sides) if node.op in ("sum", "product")]
    terms = [(n.args[2], ">=", n.args[1]) for n in own if symbols(n.args[2]) | symbols(n.args[1])]
    equations = [(x, "==", y) for x, y in statement.equations]
    links = [*statement.given.comparisons, *equations, *terms]
    if not any(symbols(e) for e in (*sides, *statement.said)):
        return None  # the decider has shown what is to be shown of constants
    free = [n for e in (*sides, *statement.said) for n in functions(e) if not n.loose]
    free = [n for n in free if n.args[0].args[0] != FACTORIAL]
    put = {n: symbol(f"[{i}]") for i, n in enumerate(dict.fromkeys(free))}
    given = [(replaced(x, put), relation, replaced(y, put)) for x, relation, y in links]
    places = (arg for n in put for arg in n.args[1:])
    trees = [replaced(e, put) for e in (*sides, *claim.differentiated, *places)]
    if somewhere(trees, given, statement.integers):
        return None
    return "no point was found that satisfies all conditions and where both sides are defined"


def _sampled(e: Expr) -> Expr:
    """``e`` with one value of what is integrated, summed to oo or differentiated in place of it."""
    put = {}
    for node in outermost(e):
        (name,), body = opened(node) if node.names else (("",), node)
        low, high = node.args[1:3] if len(node.args) > 2 else (ZERO, ZERO)
        if node.op == "coefficient":  # of a power series that was found
            put[node] = ONE
        elif node.op == "nth":
            put[node] = substitute(body, {name: node.args[1]})
        elif is_infinite(node):
            put[node] = substitute(body, {name: ONE if low == -INFINITY else low})
        elif node.op == "integral":
            if low == INFINITY or high == -INFINITY:
                low, high = high, low
            start = high - 3 if low == -INFINITY else low
            stop = start + 3 if high == INFINITY else high
            start, stop = (-ONE, ONE) if {low, high} >= {INFINITY, -INFINITY} else (start, stop)
            put[node] = substitute(body, {name: start + (stop - start) * number(INSIDE)})
    return replaced(e, put)


def _sums(e: Expr) -> Iterator[Expr]:
    if e.op not in LEAVES and e.hidden:
        if e.op in ("sum", "product") and not e.loose:
            yield e
        for arg in e.args:
            yield from _sums(arg)


def _undefined_at_an_index(node: Expr) -> Expr | None:
    """Return a part of the terms that may be undefined at some index, or None."""
    (name,), body = opened(node)
    low, high = integer(node.args[1]), integer(node.args[2])
    if low is None:
        return None
    last = low + ONE_BY_ONE if high is None else min(high + 1, low + ONE_BY_ONE)
    for part, relation in needs((body,), powers=False):
        if symbols(part) != {name} or any(n.op != "unknown" for n in outermost(part)):
            continue
        with ball_precision():
            near = (
                program([substitute(part, {name: number(k)})], [])([]) for k in range(low, last)
            )
            if not all(value is not None and SHOWN[relation](value[0], arb(0)) for value in near):
                return part
        if high is None and not _holds_from(part, relation, name, last):
            return part
    return None


def _holds_from(part: Expr, relation: str, name: str, low: int) -> bool:
    """Return whether the relation to zero holds at each integer from ``low`` on."""
    marks = {node: symbol(f"[{i}]") for i, node in enumerate(dict.fromkeys(functions(part)))}
    if any(node.args[0].args != (FACTORIAL, (0,)) for node in marks):
        return False
    inside = Given(tuple((mark, ">=", ONE) for mark in marks.values()))
    x = symbol(name)
    for step in (1, 2):
        shown = []
        for rest in range(step):
            moved = substitute(replaced(part, marks), {name: step * x + rest} if step > 1 else {})
            e = reduced_in(moved, [name], inside)
            given = inside & Given(((x, ">=", number(low // step)),))
            shown.append(sign_by(e, given, relation) in PROVING[relation])
        if all(shown):
            return True
    return False
