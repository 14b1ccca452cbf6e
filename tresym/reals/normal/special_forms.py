"""Rewrite a special function by its row: special values, recurrences, reflection and symmetry.

Every rule is local, so that equal values get equal forms: a gamma function is moved by its
recurrence until the constant term of its argument lies in [0, 1), and reflected first if the
leading coefficient is negative. So Γ(x + 3)/Γ(x) becomes x (x + 1) (x + 2), and J₂ becomes an
expression in J₀ and J₁. The rules hold wherever all their parts are defined, which is on a dense
set; this is what the normal form needs, see :mod:`tresym.reals.normal.field`.
"""

from __future__ import annotations

from functools import lru_cache
from math import gcd

from flint import fmpq

from tresym.reals.functions.row import Function
from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    apply,
    as_expr,
    multiply,
    number,
    power,
    trees,
)
from tresym.reals.language.like_terms import collected, scaled
from tresym.reals.numbers.exact import InputError

MAX_TIMES = 4
"""The largest multiple to which a multiplication formula is applied."""
MAX_SHIFT = 40
"""The largest distance over which a recurrence is applied."""


@lru_cache(maxsize=1 << 12)
def reduced(e: Expr) -> Expr | None:
    """Return an equal expression in simpler functions, or None if there is none.

    Args:
        e: a special function applied to arguments.

    Example:
        >>> from tresym.reals.language.expression import symbol
        >>> str(reduced(apply("gamma", symbol("x") + 1)))
        'gamma(x)*x'
    """
    try:
        return _reduced(e)
    except InputError:  # a number that is too long to write
        return None


def _reduced(e: Expr) -> Expr | None:
    row = TABLE[e.op]
    if row.constant:
        return None
    args = tuple(map(collected, e.args))
    if row.rewritten is not None:
        other = row.rewritten(*args, trees)
        if other is not None:
            return as_expr(other)
    last = args[-1]
    if last == ZERO:
        other = (
            ZERO if row.vanishes_with_argument else row.taylor and row.taylor(*args[:-1], 0, trees)
        )
        return None if other is None or row.remainder is not None else as_expr(other)
    if _is_negative(last):
        if row.odd:
            return -apply(e.op, *args[:-1], collected(-last))
        if row.even:
            return apply(e.op, *args[:-1], collected(-last))
        other = row.mirror and row.mirror(*args, trees)
        if other is not None:
            return tidy(other)
    times = _multiple(last) if row.multiplied is not None else 1
    if row.multiplied is not None and times > 1:
        other = row.multiplied(times, *args, trees)
        if other is not None:
            return tidy(other)
    other = _shifted(row, args)
    return None if other is None else tidy(other)


def tidy(e: Expr) -> Expr:
    """Return ``e`` with the arguments of special functions collected."""
    args = tuple(tidy(arg) if isinstance(arg, Expr) else arg for arg in e.args)
    if e.op in TABLE and not TABLE[e.op].theory:
        args = tuple(map(collected, args))
    match e.op:
        case "+":
            return add(*args)
        case "*":
            return multiply(*args)
        case "^":
            return power(*args)
    return Expr(e.op, args, e.names) if args != e.args else e


def _shifted(row: Function, args: tuple[Expr, ...]) -> Expr | None:
    """Apply a recurrence once, towards the interval in which arguments are kept."""
    if row.recurrence is None or row.raising is None:
        return None
    constant = _constant(args[row.shifted])
    away = constant - row.start
    if abs(away) > MAX_SHIFT:
        return None
    moved = None
    if away >= row.base:
        moved = row.recurrence(*args, trees)
    elif away < 0:
        moved = row.raising(*args, trees)
    return None if moved is None else as_expr(moved)


def _constant(e: Expr) -> fmpq:
    """Return the rational number in a sum."""
    for term in e.args if e.op == "+" else (e,):
        if term.op == "number":
            return fmpq(term.args[0])
    return fmpq(0)


def _multiple(e: Expr) -> int:
    """Return the common divisor of the coefficients, if they are integers up to MAX_TIMES."""
    terms = [scaled(term)[0] for term in (e.args if e.op == "+" else (e,)) if term.op != "number"]
    if not terms or any(scale.q != 1 for scale in terms):
        return 1
    divisor = gcd(*(int(scale.p) for scale in terms))
    return divisor if divisor <= MAX_TIMES else 1


def _is_negative(e: Expr) -> bool:
    """Whether the leading term of a sum has a negative coefficient; of e and −e one has."""
    if e.op == "number":
        return bool(e.args[0] < 0)
    terms = [scaled(term) for term in (e.args if e.op == "+" else (e,)) if term.op != "number"]
    scale, _ = min(terms, key=lambda pair: (str(pair[1]), pair[0] < 0))
    return bool(scale < 0)


def exponential(e: Expr) -> Expr | None:
    """Return exp(n W(u)) as (u/W(u))ⁿ, from the equation of Lambert's W; None for others."""
    scale, inner = scaled(e.args[0])
    if inner.op not in ("lambertw", "lambertwm1") or scale.q != 1:
        return None
    return power(inner.args[0] / inner, number(scale))
