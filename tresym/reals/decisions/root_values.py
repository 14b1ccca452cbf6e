"""Enclose the only zero of a function between two ends, to any number of digits.

``root(f, x, low, high)`` has a value if there is exactly one zero of f strictly between the ends.
Example: ``root(x*exp(x) - 3, x, 0, oo)`` is 1.04990889… Three things are proved:

- *Existence*: f has opposite signs at the ends of a small bracket and no jump inside it.
- *Uniqueness* by monotonicity: f is analytic between the ends, and its derivative has one sign
  there (by the exact methods of :mod:`tresym.reals.signs`). Ends may be infinite.
- *Uniqueness* by subdivision otherwise: on each small interval, balls exclude 0 from f or from
  its derivative. Where f vanishes at an end itself, the first derivative that does not vanish there
  shows that f has no zero beside it.

The variables of f may be balls; the result then holds for every choice of values in them. Source:
R. E. Moore, R. B. Kearfott, M. J. Cloud, *Introduction to Interval Analysis*, SIAM 2009, chapter 8.
"""

from __future__ import annotations

from collections.abc import Iterator
from functools import lru_cache

from flint import arb, fmpq

from tresym.reals.domain import binder_values
from tresym.reals.domain.binder_values import At, along, bracket, jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import InBalls, UndefinedError
from tresym.reals.language.binders import (
    derivative,
    elementary,
    outermost,
    under_the_integral,
    worked_out,
)
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
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.arithmetic import ball_precision, side
from tresym.reals.numbers.exact import rational_ends
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof, sign

FAR = (2, 5, 12, 30, 80, 300)
"""Powers of 2 at which a finite end is tried in place of an infinite one."""
PIECES = 3000
"""The number of intervals of a subdivision."""
ORDERS = 5
"""Derivatives that are looked at where f vanishes at an end."""
SPLIT = fmpq(499, 1024)
"""Where an interval is divided: not in the middle, where exact zeros lie."""


def enclosed(e: Expr, at: At) -> arb:
    """Return a ball that contains ``e`` with its roots at ``at``; NaN if no value is proved."""
    return binder_values.enclosed(e, at, {"root": enclosed_root})


def enclosed_root(e: Expr, outer: InBalls) -> arb:
    """Return a ball around the value of a node ``root``.

    Raises:
        UndefinedError: it is not shown that there is exactly one zero between the ends.
    """
    (name,), body = opened(e)
    names = sorted(symbols(e) - {INFINITY.args[0]})
    exact: dict[str, Expr] = {}
    bounds: list[Compared] = []
    for n in names:
        here = outer.at[n]
        if isinstance(here, fmpq) or here.is_exact():
            exact[n] = number(here if isinstance(here, fmpq) else here.fmpq())
            continue
        low, high = rational_ends(outer.value(symbol(n)))[:2]
        if low is None or high is None:
            raise UndefinedError
        bounds += [(symbol(n), ">=", number(low)), (symbol(n), "<=", number(high))]
    fixed = substitute(e, exact)
    if jumps(body) or not (is_only(fixed, tuple(bounds)) or _only_by_subdivision(e, outer)):
        raise UndefinedError
    middle = {n: outer.value(symbol(n)).mid() for n in symbols(body) if n != name}
    near, over = (along(name, body, at, outer) for at in (middle, outer.at))
    for ends in brackets(e, outer):
        try:
            return bracket(near, over, *ends)
        except UndefinedError:
            continue
    raise UndefinedError


def brackets(e: Expr, outer: InBalls) -> Iterator[tuple[arb, arb]]:
    """Yield finite intervals in which the zero is looked for."""
    low, high = e.args[1:]
    if INFINITY not in (low, high) and -INFINITY not in (low, high):
        yield outer.value(low), outer.value(high)
        return
    for k in FAR:
        far = arb((1, k))
        if low == -INFINITY:
            last = far if high == INFINITY else outer.value(high)
            yield (-far if high == INFINITY else last - far), last
        else:
            first = outer.value(low)
            yield first, first + far


@lru_cache(1 << 10)
def is_only(e: Expr, bounds: tuple[Compared, ...] = ()) -> bool:
    """Return whether a root node is shown to have at most one zero, by a derivative of one sign.

    Args:
        e: the node.
        bounds: conditions on its variables.
    """
    return bool(slope_sign(e, Given(bounds)))


def slope_sign(e: Expr, given: Given) -> int:
    """Return 1 or −1 if the function of a root node is analytic and strictly monotone, else 0.

    A derivative that is not negative will do: the zeros of the derivative of an analytic function
    that is not constant are isolated. (A constant function has no change of sign.)
    """
    (name,), body = opened(e, given.names)
    slope = worked_out(derivative(body, name))
    if not elementary(body, slope):
        return 0
    inside = given & between(e, name)
    if continuous_on(body, inside, proof) is not None:
        return 0
    its_sign = sign(slope, inside, ">=")
    if its_sign in ("+", ">=0"):
        return 1
    its_sign = its_sign if its_sign in ("-", "<=0") else sign(slope, inside, "<=")
    return -1 if its_sign in ("-", "<=0") else 0


def between(e: Expr, name: str) -> Given:
    """Return the conditions that the variable ``name`` lies strictly between the ends."""
    low, high = e.args[1:]
    x = symbol(name)
    links = [(x, ">", low)] if low != -INFINITY else []
    return Given(tuple(links + ([(x, "<", high)] if high != INFINITY else [])))


def unique_in_balls(e: Expr, at: At) -> bool:
    """Return whether balls show at most one zero between finite ends, for all values in ``at``."""
    return _only_by_subdivision(e, InBalls(at))


def _only_by_subdivision(e: Expr, outer: InBalls) -> bool:
    """Return whether balls show that there is at most one zero strictly between finite ends."""
    if INFINITY in e.args[1:] or -INFINITY in e.args[1:]:
        return False
    (name,), body = opened(e)
    slope = by_leibniz(differentiate(body, name))
    with ball_precision():
        try:
            low, high = (InBalls(outer.at, outer.rules).value(end) for end in e.args[1:])
        except UndefinedError:
            return False
        f, df = (along(name, g, outer.at, outer) for g in (body, slope))
        if not low < high:
            return False
        ends = [low.lower(), high.upper()]
        beside = [_nonzero_beside(e, end) for end in (0, 1)]
        stack, zeros = [(ends[0], ends[1], True, True)], 0
        for _ in range(PIECES):
            if not stack:
                return True
            a, b, first, last = stack.pop()
            whole = a.union(b)
            if side(f(whole)):
                continue
            if side(df(whole)) and f(whole).is_finite():
                # A monotone function that vanishes at an end has no zero strictly inside.
                if (first and beside[0] == 1) or (last and beside[1] == 1):
                    continue
                signs = side(f(low if first else a)), side(f(high if last else b))
                if None not in signs:
                    zeros += signs[0] != signs[1]
                    if zeros > 1:
                        return False
                    continue
            elif (first and not last and _by_order(e, outer, 0, beside[0], whole)) or (
                last and not first and _by_order(e, outer, 1, beside[1], whole)
            ):
                continue
            middle = (a + (b - a) * arb(SPLIT)).mid()
            if not a < middle < b:
                return False
            stack += [(a, middle, first, False), (middle, b, False, last)]
    return False


def by_leibniz(e: Expr) -> Expr:
    """Return ``e`` with the derivatives of integrals carried out under the integral sign.

    The rule holds where integrand and derivative are continuous; an evaluation of the result in
    balls shows that on the interval of integration.
    """
    known = {}
    for node in outermost(e):
        if node.op != "derivative" or node.args[1].op != "symbol":
            continue
        (name,), body = node.args[1].args, instantiate(node.args[0], node.args[1:])
        if body.op == "integral":
            known[node] = under_the_integral(body, name)
    return replaced(e, known)


def _nonzero_beside(e: Expr, end: int) -> int | None:
    """Return the order of the zero of the function at an end, exactly; 0 if it is no zero.

    None if that is not shown.
    """
    (name,), body = opened(e)
    place = e.args[1 + end]
    for order in range(ORDERS):
        there = substitute(body, {name: place})
        if not is_zero(there, Given()):
            return order
        body = worked_out(derivative(body, name))
        if not elementary(body):
            return None
    return None


def _by_order(e: Expr, outer: InBalls, end: int, order: int | None, whole: arb) -> bool:
    """Return whether a zero of this order at an end excludes another one in a ball around it."""
    if not order:
        return False
    (name,), body = opened(e)
    for _ in range(order):
        body = worked_out(derivative(body, name))
    return side(along(name, body, outer.at, outer)(whole)) is not None
