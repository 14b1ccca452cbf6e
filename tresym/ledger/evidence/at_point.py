"""The values of a claim's symbols at an exact point, and what is defined there."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from typing import cast

from flint import arb, ctx, fmpq
from sympy import Basic

from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import Conditions, conditions, tree
from tresym.ledger.definitions import Entry, table
from tresym.ledger.statements import AtMostOne, ExactlyOne, TheRoot
from tresym.reals.domain.binder_values import At, Unique, bracket, value
from tresym.reals.domain.evaluation import UndefinedError, evaluate, stands
from tresym.reals.language.binders import ordered
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import names
from tresym.reals.numbers.arithmetic import side

Values = Mapping[str, fmpq | arb]


def values_at(point: Mapping[str, fmpq], claims: Iterable[Claim]) -> dict[str, arb]:
    """Return balls for the coordinates and for the symbols that the claims define from them.

    A defined symbol is computed from its definition, even if ``point`` gives it a value. It is left
    out if balls do not confirm the conditions of its definition.

    Args:
        point: exact coordinates by symbol name.
        claims: the claims whose definitions are used.
    """
    waiting = [e for e in table(claims) if e.symbol.op == "symbol"]
    defined = {str(e.symbol.args[0]) for e in waiting}
    known = {name: arb(x) for name, x in point.items() if name not in defined}
    while waiting:
        ready = [e for e in waiting if _asked(e) <= {*known}]
        if not ready:
            break
        for entry in ready:
            given = conditions(entry.claim.given)
            if all(stands(evaluate(c.left - c.right, known), c.sign) for c in given):
                name = str(entry.symbol.args[0])
                value = _root(entry, known) if not entry.explicit else None
                known[name] = evaluate(entry.meaning, known) if value is None else value
        waiting = [e for e in waiting if e not in ready]
    return known


def _asked(entry: Entry) -> frozenset[str]:
    """Return the symbols that must have values before the entry can be evaluated."""
    own = {f"[{entry.symbol.args[0]}]"}
    asked = (symbols(side) for c in conditions(entry.claim.given) for side in (c.left, c.right))
    return (symbols(entry.meaning) - own).union(*asked)


def _root(entry: Entry, known: Values) -> arb:
    """Return a ball around the unique root of the entry, located by a change of sign."""
    assert isinstance(entry.claim.proof, Root)
    one = entry.claim.proof.unique.statement
    assert isinstance(one, ExactlyOne)
    name = f"[{entry.symbol.args[0]}]"
    low, high = (evaluate(tree(end), known) for end in (one.low, one.high))
    return changing_sign(low, high, lambda x: evaluate(entry.meaning, {**known, name: x}))


def one_root(unique: Claim) -> Expr:
    """Return the root whose uniqueness the claim states (`ExactlyOne` or `AtMostOne`)."""
    return tree(TheRoot(*cast(Basic, unique.statement).args))


def roots_of(claims: Iterable[Claim]) -> Iterator[tuple[Expr, Conditions, Claim]]:
    """Yield the roots that the claims state to be unique, with the conditions and the claim."""
    for claim in claims:
        says = claim.statement
        if isinstance(says, ExactlyOne | AtMostOne) and says.difference is not None:
            bound = says.variable.name
            given = tuple(c for c in conditions(claim.given) if bound not in names(c))
            yield one_root(claim), given, claim


def unique_by(claims: Iterable[Claim]) -> Unique:
    """Return a test whether one of the claims guarantees that a root is unique at given values."""
    known = {ordered(node): given for node, given, _ in roots_of(claims)}

    def unique(node: Expr, at: At) -> bool:
        given = known.get(ordered(node))
        return given is not None and all(
            stands(value(c.left - c.right, at, unique), c.sign) for c in given
        )

    return unique


def changing_sign(low: arb, high: arb, function: Callable[[arb], arb]) -> arb:
    """Return a ball around the sign change of a function between two ends.

    Uses the secant method, and bisection if that fails. The ball is not finite if the values at
    the ends do not have opposite signs.

    Args:
        low: the lower end.
        high: the upper end.
        function: a function from balls to balls.
    """
    first = side(function(low))
    if {first, side(function(high))} != {1, -1}:
        return arb.nan()
    try:
        return bracket(function, function, low, high)
    except UndefinedError:
        pass
    for _ in range(2 * ctx.prec):
        middle = ((low + high) / 2).mid()
        found = side(function(middle))
        if found is None or not low < middle < high:
            break
        low, high = (middle, high) if found == first else (low, middle)
    return low.union(high)
