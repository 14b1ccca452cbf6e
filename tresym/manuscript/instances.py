r"""The independent check of a manuscript's claims: instances in which sequences and functions vary.

What has passed is asked once more with definite sequences in place of ``a_k``, definite functions
in place of unknown ones, and functions of the variable in place of symbols under an integral or a
derivative that no one calls a number. An instance that is refuted speaks against the pass. The
reader's own guards play no part here: ``a_k`` is a term because k is bound, and f is a function
because of its letter.
"""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping

from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import FACTORIAL, ROUNDED
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    Expr,
    bind,
    instantiate,
    number,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared

_TERM = re.compile(r"(?:[a-zA-Z]|[a-z]{2,7})_([a-zA-Z]\w*)")
_FUNCTIONS = re.compile(r"[fghuvwFGHUV][1-9]?")
_FUNCTIONS_UNDER = ("integral", "antiderivative", "derivative", "limit")
VARIANTS = 2


def instances(compared: Compared, constants: frozenset[str]) -> Iterator[tuple[str, str]]:
    """Claims that hold if ``compared`` does, each with what was put in for what varies.

    Args:
        constants: symbols that are said to be numbers.
    """
    left, relation, right = compared
    names = dict(_varying((left, right), constants))
    unknown = {
        str(n.args[0].args[0]) for e in (left, right) for n in _nodes(e) if n.op == "unknown"
    }
    unknown -= {FACTORIAL, *ROUNDED}
    if not names and not unknown:
        return
    for variant in range(VARIANTS):
        chosen = {name: 2 + k for k, name in enumerate(sorted({*names, *unknown}))}
        one, other = (_put(e, names, chosen, variant) for e in (left, right))
        x = symbol("x")
        told = ", ".join(
            f"{n} = {_value((x,), k, variant)} of its variable" for n, k in chosen.items()
        )
        yield f"{one} {relation} {other}", told


def _nodes(e: Expr) -> Iterator[Expr]:
    """All nodes that are not elementary, inner ones too."""
    for node in outermost(e):
        yield node
        for arg in node.args:
            if isinstance(arg, Expr) and arg.op != "function":
                yield from _nodes(arg)


def _varying(sides: tuple[Expr, Expr], constants: frozenset[str]) -> Iterator[tuple[str, str]]:
    """The symbols that vary with a variable that is bound, and that variable."""
    binders = [node for e in sides for node in _nodes(e) if node.op in BINDERS and node.names]
    for node in binders:
        ends = frozenset().union(*map(symbols, node.args[1:]))
        inside = symbols(node.args[0]) - constants - ends
        for name in sorted(inside | {s for e in sides for s in symbols(e)} - constants):
            term = _TERM.fullmatch(name)
            if (term and node.names[0] in re.sub(r"plus|minus", "", term[1])) or (
                name in inside and node.op in _FUNCTIONS_UNDER and _FUNCTIONS.fullmatch(name)
            ):
                yield name, node.names[0]


def _value(args: tuple[Expr, ...], k: int, variant: int) -> Expr:
    """A definite function of its arguments."""
    first, *rest = args
    value = number(k) * first**2 + 1 if variant else first + number(k)
    for n, arg in enumerate(rest, 2):
        value = value + number(n) * arg * first
    return value


def _put(e: Expr, names: Mapping[str, str], chosen: Mapping[str, int], variant: int) -> Expr:
    """The expression with definite functions put in."""
    if e.op == "symbol" and str(e) in names:
        return _value((symbol(names[str(e)]),), chosen[str(e)], variant)
    if e.op in LEAVES or e.op == "function":
        return e
    if e.op == "unknown" and e.args[0].args[0] in chosen:
        return _applied(
            e, tuple(_put(a, names, chosen, variant) for a in e.args[1:]), chosen, variant
        )
    if e.op in BINDERS and e.names:
        body = instantiate(e.args[0], tuple(map(symbol, e.names)))
        inner = bind(_put(body, names, chosen, variant), e.names)
        ends = tuple(_put(a, names, chosen, variant) for a in e.args[1:])
        return Expr(e.op, (inner, *ends), e.names)
    if e.op == "unknown":
        return e
    return rebuild(e, tuple(_put(a, names, chosen, variant) for a in e.args))


def _applied(e: Expr, args: tuple[Expr, ...], chosen: Mapping[str, int], variant: int) -> Expr:
    """The value of a definite function, or of a partial derivative of it."""
    name, orders = e.args[0].args
    places = [symbol(f"place_{n}") for n in range(len(args))]
    value = _value(tuple(places), chosen[name], variant)
    for place, times in zip(places, orders, strict=True):
        for _ in range(times):
            value = differentiate(value, str(place))
    return substitute(value, {str(p): a for p, a in zip(places, args, strict=True)})
