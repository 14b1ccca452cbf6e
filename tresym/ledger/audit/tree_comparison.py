"""Compare the tree read from LaTeX with the tree of a claim.

Trees are compared in ball arithmetic at exact points. Nodes that bind a variable are compared part
by part, with a common name for their variables.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Any

from flint import arb

from tresym.ledger.formulas import in_trees
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.binders import (
    at,
    derivative,
    elementary,
    ordered,
    outermost,
    worked_out,
)
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    fresh,
    instantiate,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.latex_author import Function
from tresym.reals.numbers.arithmetic import ball_precision

BITS = 192
ENOUGH = 5
"""Number of points at which two expressions must be defined and agree to count as equal."""
AT_LEAST = 3
TRIES = 120
SMALL = 1e-12

_SLOPE = re.compile(r"(d|partial)(\w+?)_(?:d|partial)(\w+)")


def of_claim(e: Any) -> Expr:
    """Return an expression of a claim; a value at a point of a symbol that stands for the value of
    a function becomes a symbol of its own.
    """
    return _values_held(in_trees(e))


def of_display(
    e: Expr, reads: Mapping[Expr, Expr], functions: Mapping[str, Function] | None = None
) -> Expr:
    """Return an expression of a display in a form that can be compared with a claim.

    Args:
        e: the expression as it was read.
        reads: replacements for notation that the claim writes differently.
        functions: functions whose derivatives ``∂F/∂x`` are carried out, unless the claim has a
            symbol for them.
    """
    e = replaced(_claims_names(e), {_claims_names(k): _claims_names(v) for k, v in reads.items()})
    return _values_held(_slopes_opened(e, functions) if functions else e)


def _claims_names(e: Expr) -> Expr:
    """Remove the underscore from names that are reserved in text but not in claims."""
    reserved = (name for name in symbols(e) if name.endswith("_"))
    return substitute(e, {name: symbol(name.rstrip("_")) for name in reserved})


def _values_held(e: Expr) -> Expr:
    """A value at a point of what does not show its variable as a symbol, as in of_claim."""
    if e.op in LEAVES:
        return e
    if e.op == "at" and not e.args[0].loose:
        return symbol(str(ordered(e)))
    return rebuild(e, tuple(map(_values_held, e.args)))


def _slopes_opened(e: Expr, functions: Mapping[str, Function]) -> Expr:
    """``partialF_partialx``, and ``dF_dx`` where F is elementary, as derivatives of what F is."""
    if e.op == "symbol" and (slope := _SLOPE.fullmatch(e.args[0])):
        function = functions.get(slope[2])
        if function and (slope[1] == "partial" or elementary(function.body)):
            return derivative(_claims_names(function.body), slope[3])
    if e.op in LEAVES or e.loose:
        return e
    if e.op == "at":
        body = instantiate(e.args[0], tuple(map(symbol, e.names)))
        values = (_slopes_opened(value, functions) for value in e.args[1:])
        return at(_slopes_opened(body, functions), dict(zip(e.names, values, strict=True)))
    return rebuild(e, tuple(_slopes_opened(arg, functions) for arg in e.args))


def same(x: Expr, y: Expr, given: Given) -> bool:
    """Return whether two trees agree under the conditions."""
    if x == y:
        return True
    x, y = worked_out(x), worked_out(y)
    variables: dict[Expr, Expr] = {}
    for node in outermost(x, y):
        like = next((known for known in variables if _alike(node, known, given)), None)
        variables[node] = variables[like] if like else symbol(f"[{len(variables)}]")
    return agree(replaced(x, variables), replaced(y, variables), given)


def _alike(p: Expr, q: Expr, given: Given) -> bool:
    """Return whether two nodes of one kind agree in all parts, integrands on their interval."""
    if p == q:
        return True
    if (p.op, len(p.names), len(p.args)) != (q.op, len(q.names), len(q.args)):
        return False
    if not all(same(a, b, given) for a, b in zip(p.args[1:], q.args[1:], strict=True)):
        return False
    taken = {*symbols(p), *symbols(q)}
    names = tuple(symbol(fresh(name, taken)) for name in p.names)
    if p.op == "integral":
        low, high = p.args[1:]
        given = given & Given((((names[0] - low) * (high - names[0]), ">", ZERO),))
    return same(instantiate(p.args[0], names), instantiate(q.args[0], names), given)


def agree(x: Expr, y: Expr, given: Given) -> bool:
    """Return whether balls at exact points of ``given`` overlap wherever both sides are defined.

    Agreement detects transcription errors; it is not a proof and gives no verdict.
    """
    if x == y:
        return True
    seen = 0
    for point in given.points(symbols(x) | symbols(y), TRIES):
        with ball_precision(BITS):
            values = {name: arb(value) for name, value in point.items()}
            difference = evaluate(x - y, values)
            if not difference.is_finite() or difference.rad() > SMALL:
                continue
            if not difference.contains(0):
                return False
        seen += 1
        if seen == ENOUGH:
            return True
    return seen >= AT_LEAST
