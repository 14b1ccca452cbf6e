"""Enclose finite sums and products, and infinite ones by two bounds of what is left out.

A finite sum is added term by term. Of an infinite one Σ a(k) the terms below N are added, and
the rest is

- at most |a(N)|/(1 − q), if |a(k + 1)/a(k)| ≤ q < 1 for all k ≥ N. The ratio is formed
  symbolically, so that factorials and powers cancel. Example: Σ 1/k!.
- else given by the Euler–Maclaurin formula (DLMF 2.10.1), with the remainder
  |R| ≤ 4 (2π)^(−2m) ∫ |f^(2m)| from N to ∞ and Cauchy's bound of the derivative on |z − t| = t/8:
  |R| ≤ 4 (2m)! (4/π)^(2m) ∫ t^(−2m) max |f(z)|. Example: Σ 1/k². If the signs alternate, two
  successive terms are one term.

Both bounds hold for all k ≥ N by :mod:`tresym.reals.values.growth`. An infinite product of positive
factors is the exponential of the sum of their logarithms.
"""

from __future__ import annotations

from collections.abc import Mapping
from math import factorial

from flint import acb, arb, arb_series, ctx, fmpq

from tresym.reals.balls.taylor import InSeries
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import InBalls, Rule, UndefinedError, rational_power, real_power
from tresym.reals.language.binders import integral as integral_node
from tresym.reals.language.binders import worked_out
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    Expr,
    apply,
    number,
    opened,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.values.exact_values import rational
from tresym.reals.values.growth import DivergesError, FartherError, Growth, Scale, Sum, Term
from tresym.reals.values.improper import integral

MOST = 100_000
"""The number of terms that are added at most."""
STARTS = (4, 16, 64, 256, 1024)
"""The numbers N from which the ratio of successive terms is bounded."""
SLOWEST = fmpq(31, 32)
"""A ratio above this is left to the Euler–Maclaurin formula."""
LARGEST_STEP = 12
"""The largest coefficient of the index in a factorial."""


def factorial_value(e: Expr, outer: InBalls) -> arb:
    """Return the factorial of a natural number; other unknown functions have no value."""
    if e.args[0].args[0] != FACTORIAL:
        raise UndefinedError
    x = outer.value(e.args[1])
    if not (x.is_integer() and x >= 0):
        raise UndefinedError
    return (x + 1).gamma()


def _power(e: Expr, outer: InBalls) -> arb:
    """Return a power; an exponent that is an integer for this index counts as a written one."""
    base, exponent = e.args
    y = exponent.args[0] if exponent.op == "number" else outer.value(exponent)
    if isinstance(y, arb):
        if not y.is_integer():
            return real_power(outer.value(base), y)
        y = y.fmpq()
    return rational_power(outer.value(base), y)


def _rules(outer: InBalls) -> Mapping[str, Rule]:
    """Return the rules for terms with an integer index: powers and factorials have values."""
    return {**outer.rules, "unknown": factorial_value, "^": _power}


def total(e: Expr, outer: InBalls) -> arb:
    """Return a ball for a sum or a product, finite or infinite.

    Args:
        e: the node.
        outer: the evaluation that it is part of.

    Raises:
        UndefinedError: no value is proved.
        DivergesError: the series diverges.
    """
    low, high = e.args[1:]
    (name,), body = opened(e, (*symbols(low), *symbols(high)))
    body = worked_out(body)
    first = _whole(low, outer)
    if high != INFINITY:
        last = _whole(high, outer)
        if last - first + 1 > MOST:
            raise InputError(f"the sum has more than {MOST} terms")
        return _added(e.op, body, name, first, last, outer)
    if e.op == "product":
        return _series(apply("log", body), name, first, outer).exp()
    return _series(body, name, first, outer)


def _whole(end: Expr, outer: InBalls) -> int:
    """Return the exact integer that an end is."""
    found = rational(end)
    if found is None:
        if INFINITY.args[0] in symbols(end):
            raise UndefinedError
        value = outer.value(end)
        if not value.is_integer():
            raise UndefinedError
        found = value.fmpq()
    if found.q != 1:
        raise InputError(f"the ends of a sum must be integers; {end} is not")
    return int(found.p)


def _added(
    kind: str, body: Expr, name: str, first: int, last: int, outer: InBalls, step: int = 1
) -> arb:
    total = arb(0 if kind == "sum" else 1)
    rules = _rules(outer)
    for k in range(first, last + 1, step):
        term = outer.inner({name: arb(k)}, rules).value(body)
        total = total + term if kind == "sum" else total * term
    return total


def _series(body: Expr, name: str, first: int, outer: InBalls) -> arb:
    """Return Σ body for all values of the index from ``first`` on."""
    try:
        ratio = _ratio(body, name)
    except InputError:
        ratio = None
    slow: arb | None = None
    if ratio is not None:
        for start in STARTS:
            growth = Growth(name, fmpq(start), outer.value)
            try:
                terms = growth.terms(ratio)
                if terms and terms[0].scale.growth() > 0 and not growth.lead(terms)[0].contains(0):
                    raise DivergesError
                q = abs(growth.range(terms)) if terms else arb(0)
            except FartherError:
                continue
            except DivergesError:
                raise
            except UndefinedError:
                break
            slow = growth.range(terms) if terms else arb(0)
            if q < SLOWEST:
                return _geometric(body, name, first, max(start, first), q.upper(), outer)
            if q > 1:
                raise DivergesError
    if slow is not None and slow < 0:
        one, other = (_without_sign(body, name, first + j) for j in (0, 1))
        _need_vanishing(one, name, outer)
        pair = one + substitute(other, {name: symbol(name) + 1})
        return _euler_maclaurin(pair, name, first, outer, step=2)
    return _euler_maclaurin(body, name, first, outer)


def _need_vanishing(term: Expr, name: str, outer: InBalls) -> None:
    """Require that the terms of a series tend to 0.

    Raises:
        DivergesError: they are shown not to.
        UndefinedError: neither is shown.
    """
    for start in STARTS:
        growth = Growth(name, fmpq(start), outer.value)
        try:
            terms = growth.terms(term)
        except FartherError:
            continue
        if not terms or terms[0].scale.growth() < 0:
            return
        lead, _ = growth.lead(terms)
        raise DivergesError if lead > 0 or lead < 0 else UndefinedError
    raise UndefinedError


def _without_sign(body: Expr, name: str, parity: int) -> Expr:
    """Return the term for an index of known parity: (−1)^k is a number then."""

    def walk(e: Expr) -> Expr:
        if e.op == "^" and e.args[0] == MINUS_ONE and e.args[1].op != "number":
            slope = _slope(e.args[1], name)
            start = rational(substitute(e.args[1], {name: number(0)}))
            if slope is not None and start is not None and start.q == 1:
                return MINUS_ONE if (slope * parity + int(start.p)) % 2 else ONE
        return e if e.op in LEAVES else rebuild(e, tuple(map(walk, e.args)))

    return walk(body)


def _geometric(body: Expr, name: str, first: int, start: int, q: arb, outer: InBalls) -> arb:
    """Return a series whose terms fall from ``start`` on by at least the factor q each time."""
    found = _added("sum", body, name, first, start - 1, outer)
    rules = _rules(outer)
    for k in range(start, start + MOST):
        term = outer.inner({name: arb(k)}, rules).value(body)
        rest = (abs(term) / (1 - q)).upper()
        if rest < arb((1, -ctx.prec)):
            return found + arb(0, rest)
        found += term
    raise UndefinedError


def _ratio(body: Expr, name: str) -> Expr | None:
    """Return a(k + 1)/a(k) with factorials and powers of numbers cancelled."""
    k = symbol(name)
    marks: dict[Expr, tuple[Expr, Expr]] = {}

    def marked(e: Expr, after: bool) -> Expr:
        if name not in symbols(e):
            return e
        if e.op == "unknown" and e.args[0].args[0] == FACTORIAL:
            step = _slope(e.args[1], name)
            if step is None or abs(step) > LARGEST_STEP:
                raise InputError("the ratio of two terms has no value here")
            mark = marks.setdefault(e, (symbol(f"[{len(marks)}]"), ONE))[0]
            if not after:
                return mark
            for j in range(1, step + 1):
                mark = mark * (e.args[1] + j)
            for j in range(-step):
                mark = mark / (e.args[1] - j)
            return mark
        if e.op == "^" and name not in symbols(e.args[0]):
            step = _slope(e.args[1], name)
            if step is not None:
                mark = marks.setdefault(e, (symbol(f"[{len(marks)}]"), ONE))[0]
                return mark * power(e.args[0], number(step)) if after else mark
        if e.op in LEAVES:
            return substitute(e, {name: k + 1}) if after else e
        return rebuild(e, tuple(marked(arg, after) for arg in e.args))

    if body.hidden and not _only_factorials(body):
        return None
    ratio = normal_form(marked(body, True) / marked(body, False), Given(((k, ">", ONE),)))
    return ratio if symbols(ratio).isdisjoint(str(m) for m, _ in marks.values()) else None


def _only_factorials(e: Expr) -> bool:
    if e.op == "unknown":
        return e.args[0].args[0] == FACTORIAL and _only_factorials(e.args[1])
    return e.op in LEAVES or (not e.names and all(map(_only_factorials, e.args)))


def _slope(e: Expr, name: str) -> int | None:
    """Return the integer a if ``e`` is a·k + b with a number b, as far as arithmetic shows it."""
    values = [substitute(e, {name: number(n)}) for n in range(3)]
    first = normal_form(values[1] - values[0], Given())
    second = normal_form(values[2] - values[1], Given())
    r = rational(first)
    affine = e.op in ("symbol", "+", "*") and not any(
        arg.op == "^" and name in symbols(arg) for arg in _parts(e)
    )
    return int(r.p) if first == second and r is not None and r.q == 1 and affine else None


def _parts(e: Expr) -> list[Expr]:
    return [e, *(part for arg in e.args for part in _parts(arg))] if e.op in ("+", "*") else [e]


def _euler_maclaurin(body: Expr, name: str, first: int, outer: InBalls, step: int = 1) -> arb:
    """Return the sum over first, first + step, … of a function that is analytic to the right."""
    if body.hidden:
        raise UndefinedError
    for begin in STARTS:
        flat = Growth(name, fmpq(max(begin, first)), outer.value)
        try:
            terms = flat.terms(body)
            flat.tail(terms, flat.top)
        except FartherError:
            continue
        if not terms or terms[0].scale.exps:
            return _exponential(body, name, first, flat, terms, outer, step)
        break
    m = ctx.prec // 6 + 4
    start = first + step * max(8 * m, -first)
    turn = acb(arb(1, 0.125), arb(0, 0.125))
    for _ in STARTS:
        growth = Growth(name, fmpq(start), outer.value, turn=turn)
        try:
            rest = growth.tail(_damped(growth.terms(body), 2 * m), growth.top)
            break
        except FartherError:
            start += step * start
    else:
        raise UndefinedError
    rest = 4 * rest / step * factorial(2 * m) * (4 * step / arb.pi()) ** (2 * m)
    found = _added("sum", body, name, first, start - 1, outer, step)
    tail = integral(integral_node(body, name, number(start), INFINITY), outer)
    jet = _jet(body, name, arb(start), 2 * m, outer)
    found += tail / step + jet[0] / 2
    for j in range(1, m + 1):  # f^(2j−1)(N)/(2j−1)! is the coefficient of the jet
        found -= arb.bernoulli(2 * j) / (2 * j) * jet[2 * j - 1] * step ** (2 * j - 1)
    return found + arb(0, rest.upper())


def _exponential(
    body: Expr, name: str, first: int, growth: Growth, terms: Sum, outer: InBalls, step: int
) -> arb:
    """Return a sum whose terms decay exponentially: the rest is below the integral of its bound."""
    cut = max(first, int(growth.start.p))
    while cut - first < MOST * step:
        rest = growth.tail(terms, arb(cut)) if terms else arb(0)
        if rest < arb((1, -ctx.prec)):
            last = first + (cut - first) // step * step + step
            return _added("sum", body, name, first, last, outer, step) + arb(0, rest.upper())
        cut += max(step, cut // 4)
    raise UndefinedError


def _damped(terms: Sum, n: int) -> Sum:
    """Return the terms times t^−n."""
    return tuple(Term(c, m * Scale((), fmpq(-n), fmpq(0)), fixed) for c, m, fixed in terms)


def _jet(body: Expr, name: str, x: arb, n: int, outer: InBalls) -> list[arb]:
    """Return the Taylor coefficients of a function at a point.

    Raises:
        UndefinedError: they are not found.
    """
    before = ctx.cap
    ctx.cap = n
    try:
        at = {name: arb_series([x, 1], n)}
        at |= {other: outer.value(symbol(other)) for other in symbols(body) - {name}}
        series = InSeries(None, at).value(body)
        found = [series[j] for j in range(n)]
    except (ValueError, ZeroDivisionError):
        raise UndefinedError from None
    finally:
        ctx.cap = before
    if not all(c.is_finite() for c in found):
        raise UndefinedError
    return found
