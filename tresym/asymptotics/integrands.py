"""Write an integrand as a sum of c(x) e^(−λ(x) p(t)) q(t), by the laws of powers and logarithms.

Factors that hold both x and t must be exponentials, or powers whose exponent holds x. Exponents are
multiplied out; what holds x alone goes to c, what holds t alone to q, and the rest must have one
factor λ of x in common. Hyperbolic functions of both become exponentials.

Example: ``t**n*exp(-n*t**2/2)/(1 + t)`` has λ = n, p = t²/2 − log t and q = 1/(1 + t).
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product
from typing import NamedTuple

from tresym.asymptotics.lemma import End
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    integer,
    multiply,
    power,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.sign import sign

MOST_TERMS = 24
Term = tuple[Expr, Expr]
"""A factor without t, and one without x."""


class Exponential(NamedTuple):
    """The integrand ``factor``·e^(−``rate``·p)·q, where ``rate`` tends to +∞."""

    factor: Expr
    rate: Expr
    p: Expr
    q: Expr


def exponentials(body: Expr, t: str, end: End) -> list[Exponential] | None:
    """Return the integrand as such a sum, or None."""
    found = []
    for term in _summands(body, t, end):
        part = _exponential(term, t, end)
        if part is None:
            return None
        found.append(part)
    return found


def _summands(body: Expr, t: str, end: End) -> Iterator[Expr]:
    """Yield the terms of the integrand, products of sums with x multiplied out."""
    x = end.name
    factors = factors_in(body)
    choices = []
    for f in factors:
        both = {t, x} <= symbols(f)
        if both and f.op in ("cosh", "sinh"):
            u = f.args[0]
            last = apply("exp", -u) / 2 * (1 if f.op == "cosh" else -1)
            choices.append([apply("exp", u) / 2, last])
        elif both and f.op == "+":
            choices.append([part for arg in f.args for part in _summands(arg, t, end)])
        elif both and f.op == "log" and (parts := separated(f, t, end)):
            choices.append([of_x * of_t for of_x, of_t in parts])
        else:
            choices.append([f])
    for combination in product(*choices):
        yield multiply(*combination)


def _exponential(term: Expr, t: str, end: End) -> Exponential | None:
    x = end.name
    outside, weight, exponents = [], [], []
    for f in factors_in(term):
        if t not in symbols(f):
            outside.append(f)
        elif x not in symbols(f):
            weight.append(f)
        elif f.op == "exp":
            exponents.append(f.args[0])
        elif f.op == "^" and x in symbols(f.args[1]):
            exponents.append(f.args[1] * apply("log", f.args[0]))
        else:
            split = separated(f, t, end)
            if split is None or len(split) != 1:
                return None
            outside.append(split[0][0])
            weight.append(split[0][1])
    groups: list[tuple[Expr, list[Expr]]] = []
    for u in exponents:
        terms = separated(u, t, end)
        if terms is None:
            return None
        for of_x, of_t in terms:
            if t not in symbols(of_t):
                outside.append(apply("exp", of_x * of_t))
            elif x not in symbols(of_x):
                weight.append(apply("exp", of_x * of_t))
            else:
                _grouped(groups, of_x, of_t, end)
    if len(groups) != 1:
        return None
    rate, parts = groups[0]
    last = end.limit(rate)
    p = add(*parts)
    if last == -INFINITY:
        rate = -rate
    elif last == INFINITY:
        p = add(*(-part for part in parts))
    else:
        return None
    return Exponential(_shorter(multiply(*outside), end), rate, p, multiply(*weight))


def _shorter(e: Expr, end: End) -> Expr:
    """Return the normal form of a factor, if it is shorter."""
    near = Given(((end.side * symbol(end.name), ">", end.side * (end.point or ZERO)),))
    form = normal_form(e, end.given & near)
    return form if form.size < e.size else e


def _grouped(groups: list[tuple[Expr, list[Expr]]], of_x: Expr, of_t: Expr, end: End) -> None:
    """Add a term to the group whose factor of x is a multiple of its own."""
    for rate, parts in groups:
        ratio = normal_form(of_x / rate, end.given & Given(((symbol(end.name), ">", ZERO),)))
        if end.name not in symbols(ratio):
            parts.append(ratio * of_t)
            return
    groups.append((of_x, [of_t]))


def separated(u: Expr, t: str, end: End) -> list[Term] | None:
    """Return terms of products of a function of x and a function of t whose sum is ``u``."""
    found = _separated(u, t, end)
    return None if found is None or len(found) > MOST_TERMS else found


def _separated(u: Expr, t: str, end: End) -> list[Term] | None:
    x = end.name
    if t not in symbols(u):
        return [(u, ONE)]
    if x not in symbols(u):
        return [(ONE, u)]
    if u.op == "+":
        parts = [_separated(arg, t, end) for arg in u.args]
        return None if None in parts else [term for part in parts for term in part or ()]
    if u.op == "*":
        return _multiplied([_separated(arg, t, end) for arg in u.args])
    if u.op == "^" and u.args[1].op == "number":
        n, inner = integer(u.args[1]), _separated(u.args[0], t, end)
        if inner is not None and len(inner) == 1:
            of_x, of_t = inner[0]
            if n is None and not _is_positive(of_x, end):
                return None
            return [(power(of_x, u.args[1]), power(of_t, u.args[1]))]
        return _multiplied([inner] * n) if n is not None and 1 < n < 5 else None
    if u.op == "log":
        inner = _separated(u.args[0], t, end)
        if inner is None or len(inner) != 1 or not _is_positive(inner[0][0], end):
            return None
        of_x, of_t = inner[0]
        return [(_log(of_x, end), ONE), (ONE, apply("log", of_t))]
    return None


def _log(e: Expr, end: End) -> Expr:
    if e.op == "^" and e.args[1].op == "number" and _is_positive(e.args[0], end):
        return e.args[1] * _log(e.args[0], end)
    return ZERO if e == ONE else apply("log", e)


def _is_positive(e: Expr, end: End) -> bool:
    near = Given(((symbol(end.name), ">" if end.side > 0 else "<", end.point or ZERO),))
    return sign(e, end.given & near) == "+"


def _multiplied(parts: list[list[Term] | None]) -> list[Term] | None:
    if None in parts or len(parts) == 0:
        return None
    size = 1
    for part in parts:
        size *= len(part or ())
    if size > MOST_TERMS:
        return None
    return [
        (multiply(*(of_x for of_x, _ in terms)), multiply(*(of_t for _, of_t in terms)))
        for terms in product(*(part or () for part in parts))
    ]
