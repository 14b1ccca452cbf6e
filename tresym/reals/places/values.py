"""The value of an expression in balls, NaN wherever it is not shown to be defined."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from functools import reduce
from operator import add, mul

from flint import arb, fmpq

from tresym.reals.language.expression import Expr

_NAN = arb.nan()
_ELSEWHERE = frozenset(("abs", "cbrt", "sign"))


class _UndefinedError(Exception):
    """The point is outside the real domain, or the ball is too wide to tell."""


def evaluate(e: Expr, point: Mapping[str, arb | fmpq], known: dict[Expr, arb] | None = None) -> arb:
    """A ball that contains ``e`` at ``point``, of balls or exact numbers, at working precision.

    NaN where ``e`` is undefined in the reals (radicand < 0, argument of ``log`` ≤ 0, argument of
    ``asin`` out of range, division by a ball that contains 0) or where the balls cannot tell.

    Args:
        known: values at the same point, which are used and added to.

    Raises:
        KeyError: a variable of ``e`` is not in ``point``.
    """
    done = {} if known is None else known

    def walk(node: Expr) -> arb:
        value = done.get(node)
        if value is None:
            value = _value(node, point, walk)
            if not value.is_finite():
                raise _UndefinedError
            done[node] = value
        return value

    try:
        return walk(e)
    except _UndefinedError:
        return _NAN


def undefined_parts(expressions: Iterable[Expr], point: Mapping[str, arb | fmpq]) -> set[Expr]:
    """The innermost parts that have no real value at ``point``, or none that the balls show."""
    found: set[Expr] = set()
    known: dict[Expr, arb] = {}
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or evaluate(node, point, known).is_finite():
            continue
        seen.add(node)
        inner = [arg for arg in node.args if isinstance(arg, Expr)]
        broken = [arg for arg in inner if not evaluate(arg, point, known).is_finite()]
        stack.extend(broken)
        if not broken:
            found.add(node)
    return found


def _value(node: Expr, point: Mapping[str, arb | fmpq], walk: Callable[[Expr], arb]) -> arb:
    op, args = node.op, node.args
    if op == "number":
        return arb(args[0])
    if op == "symbol":
        return arb(point[args[0]])
    if op == "pi":
        return arb.pi()
    if op == "^":
        return _power(args[0], args[1], walk)
    values = [walk(arg) for arg in args]
    if op in ("+", "*"):
        return reduce(add if op == "+" else mul, values)
    return _angle(*values) if op == "atan2" else _function(op, values[0])


def _angle(y: arb, x: arb) -> arb:
    """``atan2(y, x)``; all of [−π, π] for a ball that meets the negative x-axis and more."""
    if y.contains(0) and x.contains(0):
        raise _UndefinedError
    return arb.atan2(y, x)


def _power(base: Expr, exponent: Expr, walk: Callable[[Expr], arb]) -> arb:
    x = walk(base)
    if exponent.op != "number":
        return (walk(exponent) * x.log()).exp()
    r: fmpq = exponent.args[0]
    p, q = int(r.p), int(r.q)
    if p < 0 and x.contains(0):
        raise _UndefinedError
    if q == 1:
        return _natural_power(x, p) if x.contains(0) else x**p
    if not x >= 0:
        raise _UndefinedError
    root = x.sqrt() if q == 2 else _root(x, q)
    return root if p == 1 else root**p


def _natural_power(x: arb, n: int) -> arb:
    """``x**n`` for a ball that contains 0, from its ends; FLINT's is NaN where the middle is 0."""
    if n == 0:
        return arb(1)
    if n % 2:
        return (x.lower() ** n).union(x.upper() ** n)
    return arb(0).union(x.abs_upper() ** n)


def _function(name: str, x: arb) -> arb:
    if name not in _ELSEWHERE:
        return getattr(x, name)()
    if name == "abs":
        return abs(x)
    if name == "cbrt":
        return _cube_root(x)
    if x.contains(0):
        return arb(0, 0 if x.is_zero() else 1)
    return arb(1 if x > 0 else -1)


def _cube_root(x: arb) -> arb:
    """The real cube root of any ball."""
    if x >= 0:
        return _root(x, 3)
    if x < 0:
        return -((-x).root(3))
    return (-_root(-x.lower(), 3)).union(_root(x.upper(), 3))


def _root(x: arb, n: int) -> arb:
    """The root of ``x ≥ 0``; FLINT's is NaN for a ball that contains 0."""
    if x > 0:
        return x.root(n)
    high = x.upper()
    return arb(0).union(high.root(n)) if high > 0 else arb(0)
