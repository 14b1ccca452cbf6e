"""Tools for rows: sharp balls of monotone functions, jets, and factors of asymptotic expansions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import acb, arb, arb_series, ctx, fmpq

from tresym.reals.functions.row import Conditions, Function

WIDE = arb((1, -24))
"""The relative radius from which a ball is evaluated at its two ends."""
NAN = arb.nan()
ORDERS = (1, 2, 3, 5, 8, 13)

Ball = Callable[[arb], arb]


def literal(e: Any) -> fmpq | None:
    """Return the rational number that an argument is, or None."""
    if isinstance(e, arb):
        n = e.unique_fmpz() if e.is_exact() else None
        return None if n is None else fmpq(n)
    found: fmpq | None = e.args[0] if getattr(e, "op", "") == "number" else None
    return found


def whole(e: Any) -> int | None:
    """Return the integer that an argument is, or None."""
    r = literal(e)
    return None if r is None or r.q != 1 else int(r.p)


def real_part(z: acb) -> arb:
    """Return the real part of a value that is known to be real; NaN if it is not finite."""
    found: arb = z.real
    return found if z.is_finite() else NAN


def on_the_right(f: Callable[..., acb]) -> Callable[..., acb]:
    """Return a function in complex balls where the last argument has a positive real part.

    Its cut lies on the negative axis or left of it, so that it is analytic there.
    """

    def value(*arguments: Any) -> acb:
        *first, z = map(acb, arguments)
        return f(*first, z) if z.real > 0 else acb(NAN)

    return value


def is_wide(x: arb) -> bool:
    """Whether a ball is so wide that it is better evaluated at its ends."""
    return bool(x.rad() > WIDE * (WIDE + abs(x.mid())))


def monotone(f: Ball) -> Ball:
    """Return the enclosure of a function that is monotone on every interval of its domain."""

    def value(x: arb) -> arb:
        if x.is_finite() and is_wide(x):
            found: arb = f(x.lower()).union(f(x.upper()))
            return found if found.is_finite() else f(x)
        return f(x)

    return value


def with_slope(f: Ball, slope: Ball) -> Ball:
    """Return the enclosure of a function by the mean value theorem, and directly."""

    def value(x: arb) -> arb:
        rough = f(x)
        if not (x.is_finite() and is_wide(x)):
            return rough
        finer: arb = f(x.mid()) + slope(x) * (x - x.mid())
        if not finer.is_finite():
            return rough
        return finer.intersection(rough) if rough.is_finite() else finer

    return value


def composed(jets: Callable[[arb, int], list[arb]], s: arb_series) -> arb_series:
    """Return f∘s from the Taylor coefficients of f at the constant term of s."""
    n = min(ctx.cap, s.prec)
    found = arb_series(jets(s[0], n), n)
    moved = arb_series([arb(0), *(s[k] for k in range(1, n))], n)
    return found(moved)


def jets_of(name: str, *args: Any) -> Callable[[arb, int], list[arb]]:
    """Return the Taylor coefficients of a function that FLINT evaluates at power series."""

    def jets(x: arb, n: int) -> list[arb]:
        before, ctx.cap = ctx.cap, n
        try:
            found = getattr(arb_series([x, 1], n), name)(*args)
        finally:
            ctx.cap = before
        return [found[k] for k in range(n)]

    return jets


def derived(jets: Callable[[arb, int], list[arb]], times: int) -> Callable[[arb, int], list[arb]]:
    """Return the Taylor coefficients of a derivative."""

    def found(x: arb, n: int) -> list[arb]:
        known = jets(x, n + times)
        result = []
        for k in range(n):
            factor = 1
            for j in range(times):
                factor *= k + times - j
            result.append(known[k + times] * factor)
        return result

    return found


def _factor_name(name: str) -> str:
    """Return the name of a factor as it is printed: T with the name as its subscript."""
    return rf"T_{{\mathrm{{{name.replace('_tail', '').replace('_', ' ')}}}}}"


def positive(v: Any, m: Any) -> Conditions:
    """Return the condition of a factor of an expansion: v > 0."""
    return ((v, ">"),)


def factor(
    name: str,
    coefficient: Callable[[int], fmpq],
    exact: Ball | None,
    remainder: Callable[[arb, int], arb] | None = None,
    source: str = "",
    first: int = 0,
) -> Function:
    """Return the row of a factor of an asymptotic expansion in v → 0+.

    Args:
        name: its name.
        coefficient: the coefficient of vᵏ.
        exact: the value for v > 0 from the function that is expanded, or None.
        remainder: a bound of |R_n(v)|/vⁿ for 0 < v ≤ s; by default the next coefficient that is
            not 0 times the power of s, as for an enveloping series.
        source: the theorem that states the bound.
        first: the index from which the series is enveloping; earlier terms are added up.
    """

    def bound(s: arb, n: int) -> arb:
        if remainder is not None:
            return remainder(s, n)
        total, k = arb(0), n
        while k < first or coefficient(k) == 0:
            total += abs(arb(coefficient(k))) * s ** (k - n)
            k += 1
        return total + abs(arb(coefficient(k))) * s ** (k - n)

    def value(v: arb) -> arb:
        found = exact(v) if exact is not None and v > 0 else NAN
        if found.is_finite() and not is_wide(v):
            return found
        top = arb(v.upper())
        if not v.lower() >= 0 and not (v.contains(0) and top > 0):
            return NAN
        inside = arb(0).union(top) if v.contains(0) else v
        for n in ORDERS:
            total = arb(0)
            for k in reversed(range(n)):
                total = total * inside + arb(coefficient(k))
            finer = total + arb(0, 1) * bound(top, n) * inside**n
            if finer.is_finite():
                found = found.intersection(finer) if found.is_finite() else finer
        return found

    return Function(
        name=name, family="factors of expansions", needs=positive, derivatives=(None,), ball=value,
        taylor=lambda k, m: coefficient(k), remainder=bound, internal=True, source=source,
        latex=_factor_name(name),
    )  # fmt: skip


def _sum(terms: Any, v: arb) -> arb:
    total = arb(0)
    for term in reversed(terms):
        total = total * v + term
    return total


def parametric(name: str, term: Any, exact: Any, rest: Any, source: str) -> Function:
    """Return the row of a factor with a parameter; ``term(ν, k)`` is the coefficient of vᵏ."""

    def value(nu: arb, v: arb) -> arb:
        found = exact(nu, v) if v > 0 and not is_wide(v) else NAN
        top = arb(v.upper())
        if found.is_finite() or not top > 0:
            return found
        if not (v > 0 or v.contains(0)):
            return NAN
        inside = arb(0).union(top) if v.contains(0) else v
        for n in ORDERS:
            bound = rest(nu, top, n)
            if bound.is_finite():
                finer = _sum([arb(1) * term(nu, k) for k in range(n)], inside)
                finer += arb(0, 1) * bound * inside**n
                found = found.intersection(finer) if found.is_finite() else finer
        return found

    return Function(
        name=name, family="factors of expansions", arity=2,
        needs=lambda nu, v, m: positive(v, m), derivatives=(None, None), ball=value,
        taylor=lambda nu, k, m: term(nu if literal(nu) is None else literal(nu), k),
        remainder=lambda nu, s, n: rest(nu, s, n), internal=True, source=source,
        latex=_factor_name(name),
    )  # fmt: skip
