"""Enclose integrals with infinite ends and integrable singularities at an end.

FLINT's quadrature (F. Johansson, *Numerical integration in arbitrary-precision ball arithmetic*,
2018) needs an integrand that is finite on a bounded interval. An integral that is not of this kind
is cut so that each piece has at most one such end, which is then removed in one of three ways:

1. With x = a + v^k, or x = 1/v^k for an infinite end, the integrand becomes analytic at v = 0. The
   exponent k is read off the growth at the end, and the exact normal form cancels v:
   dx/√(1 − x²) at x = 1 becomes 2 dv/√(2 − v²).
2. With x = a + exp(−s) the integrand decays exponentially in s, and the integral is cut where the
   rest is below the accuracy that is wanted.
3. An integrand that decays exponentially at infinity is cut in x itself.

The rest behind a cut is bounded by :mod:`tresym.reals.values.growth`, and added as a ball. A change
of the integrand by algebra might extend its domain; so the integrand as written is proved to be
defined on the whole piece, by the growth near the end and by subdivision elsewhere.

What does not depend on the precision is kept for integrands without other variables: where the
integral is cut, the change of variable, bounds of its growth (a bound in balls holds at any
precision), that it is defined, and the compiled integrand.

Limitations: the integral must converge absolutely, and a singularity inside the interval must be
made an end.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from functools import lru_cache
from itertools import pairwise

from flint import acb, arb, ctx, fmpq

from tresym.reals.domain import binder_values
from tresym.reals.domain.binder_values import quadrature
from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import InBalls, UndefinedError, evaluate
from tresym.reals.domain.operation_domains import needs, operations
from tresym.reals.language.binders import worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    FUNCTIONS,
    LEAVES,
    ONE,
    UNWORKED,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    opened,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.values.exact_values import rational
from tresym.reals.values.growth import DivergesError, FartherError, Growth, Sum

STARTS = tuple(fmpq(4) ** n for n in (1, 2, 3, 4, 6, 8, 12, 16, 24, 32))
"""The numbers T from which a growth is looked for."""
NEAREST = arb((1, 1 << 24))
"""The reciprocal of the least distance from a singular end at which an integral is cut."""
FARTHEST = 4096
"""A cut in x itself lies at most here."""
LARGEST_ROOT = 12
"""The largest exponent k of a substitution x = a + v^k."""
SLACK = 8
"""A value is computed again with more bits, if it has this many fewer than are wanted."""
PIECES = 4000
"""How many pieces the proof of definedness may take."""
KEPT = 256
"""Of how many integrands each result is kept."""
_WHOLE = {"+", "*", "^", "pi"} | FUNCTIONS
"""The operations whose domains are listed in one table."""


def integral(e: Expr, outer: InBalls) -> arb:
    """Return a ball for an integral node.

    Args:
        e: the node.
        outer: the evaluation that it is part of.

    Raises:
        UndefinedError: no value is proved.
        DivergesError: the integral diverges.
    """
    low, high = e.args[1:]
    name, body = _opened(e)
    if INFINITY.args[0] in symbols(low) | symbols(high):
        return _infinite(body, name, low, high, outer)
    first, last = outer.value(low), outer.value(high)
    if first > last:
        return -_finite(body, name, high, low, outer)
    if not first < last:
        return binder_values.integral(e, outer)
    return _finite(body, name, low, high, outer)


@lru_cache(maxsize=KEPT)
def _opened(e: Expr) -> tuple[str, Expr]:
    """Return the variable and the integrand of a node."""
    (name,), body = opened(e, (*symbols(e.args[1]), *symbols(e.args[2])))
    return name, worked_out(body)


def _infinite(body: Expr, name: str, low: Expr, high: Expr, outer: InBalls) -> arb:
    """Return an integral with an infinite end, as a sum of integrals from a number to ∞."""
    if low == high:
        raise UndefinedError
    if low == INFINITY or high == -INFINITY:
        return -_infinite(body, name, high, low, outer)
    mirrored = _at(body, name, -symbol(name))
    if low == -INFINITY and high == INFINITY:
        return _to_infinity(body, name, ZERO, outer) + _to_infinity(mirrored, name, ZERO, outer)
    if low == -INFINITY:
        return _to_infinity(mirrored, name, -high, outer)
    return _to_infinity(body, name, low, outer)


def _to_infinity(body: Expr, name: str, low: Expr, outer: InBalls) -> arb:
    """Return the integral of ``body`` from ``low`` to infinity."""
    growth, terms = _growth(body, name, outer)
    first = outer.value(low)
    if terms and terms[0].scale.exps:
        _need_convergent(growth, terms)
        begin = growth.top.max((first + 1).ceil()).mid()
        found = growth.cut(terms, begin, _farther, FARTHEST)
        if found is not None:
            cut, rest = found
            near = _near(body, name, growth)
            return _finite(near, name, low, number(cut.fmpq()), outer) + _within(rest)
    if not terms:
        return _finite(body, name, low, number(growth.start), outer)
    beyond = max(1, int((first.upper() + 1).ceil().mid().fmpq().p))
    v = symbol(name)
    inverted = _at(body, name, 1 / v, v**-2)
    near = _finite(body, name, low, number(beyond), outer)
    return near + _singular(inverted, name, number(fmpq(1, beyond)), outer)


@lru_cache(maxsize=KEPT)
def _at(body: Expr, name: str, x: Expr, slope: Expr = ONE) -> Expr:
    """Return an expression with ``x`` instead of its variable, times ``slope``."""
    found = substitute(body, {name: x})
    return found if slope == ONE else found * slope


def _alone(body: Expr, name: str) -> bool:
    """Return whether an integrand has no other variables, and nothing that needs a rule."""
    return not body.hidden and symbols(body) <= {name}


def _compiled(body: Expr, name: str, outer: InBalls) -> Compiled:
    return _kept(body, name) if _alone(body, name) else Compiled(body, (name,), outer.value)


@lru_cache(maxsize=KEPT)
def _kept(body: Expr, name: str) -> Compiled:
    return Compiled(body, (name,))


def _near(body: Expr, name: str, growth: Growth) -> Expr:
    return (_kept_near if _alone(body, name) else _scaled_down)(body, name, growth)


def _scaled_down(e: Expr, name: str, growth: Growth) -> Expr:
    """Return an expression with exp(−g) taken out of denominators that grow like exp(g).

    Of 1/(exp(t) − 1) a complex ball with an imaginary part beyond ±π/2 has no value, as its
    denominator may vanish; of exp(−t)/(1 − exp(−t)) it has one.
    """
    if e.op in LEAVES or name not in symbols(e) or e.op in UNWORKED:
        return e
    if e.op != "^" or e.args[1].op != "number" or e.args[0].op != "+" or e.args[1].args[0] > 0:
        return rebuild(e, tuple(_scaled_down(arg, name, growth) for arg in e.args))
    base, exponent = e.args
    try:
        exps = growth.terms(base)[0].scale.exps
    except UndefinedError:
        return e
    if not exps or not all(isinstance(c, fmpq) for _, c in exps) or not exps[0][1] > 0:
        return e
    g = add(*(number(c) * power(symbol(name), number(r)) for r, c in exps))
    scaled = add(*(_times_exponential(term, -g) for term in base.args))
    return apply("exp", exponent * g) * power(scaled, exponent)


_kept_near = lru_cache(maxsize=KEPT)(_scaled_down)


def _times_exponential(term: Expr, g: Expr) -> Expr:
    """Return a term times exp(g), joined with an exponential in it."""
    factors = list(term.args) if term.op == "*" else [term]
    for n, factor in enumerate(factors):
        if factor.op == "exp":
            u = _normal(factor.args[0] + g, Given())
            factors[n] = ONE if u == ZERO else apply("exp", u)
            return multiply(*factors)
    return multiply(*factors, apply("exp", g))


def _growth(
    body: Expr, name: str, outer: InBalls, at_zero: bool = False, disc: bool = False
) -> tuple[Growth, Sum]:
    """Return how an integrand grows, with the first T from which the description holds."""
    if _alone(body, name):
        return _kept_growth(body, name, at_zero, disc)
    return _growth_of(body, name, outer.value, at_zero, disc)


@lru_cache(maxsize=KEPT)
def _kept_growth(body: Expr, name: str, at_zero: bool, disc: bool) -> tuple[Growth, Sum]:
    return _growth_of(body, name, lambda part: InBalls({}).value(part), at_zero, disc)


def _growth_of(
    body: Expr, name: str, known: Callable[[Expr], arb], at_zero: bool, disc: bool
) -> tuple[Growth, Sum]:
    for start in STARTS:
        growth = Growth(name, start, known, at_zero, disc, vanishes=_vanishes)
        try:
            return growth, growth.terms(body)
        except FartherError:
            continue
    raise UndefinedError


def _vanishes(e: Expr) -> bool:
    """Return whether an expression without variables is exactly 0."""
    return not symbols(e) and evaluate(e, {}).is_finite() and _normal(e, Given()) == ZERO


def _farther(cut: arb) -> arb:
    """Return the next cut in x itself."""
    return (cut * (fmpq(5, 4) if cut > 64 else 2)).ceil().mid()


def _nearer(cut: arb) -> arb:
    """Return the next cut near a singular end, by its reciprocal distance."""
    return (cut**2 if cut < arb((1, 64)) else cut ** arb("1.25")).mid()


def _need_convergent(growth: Growth, terms: Sum) -> None:
    """Raise what an integral raises that diverges, or is not seen to converge."""
    with suppress(FartherError):
        growth.tail(terms, growth.top)


def _within(rest: arb) -> arb:
    """Return the ball around 0 of this radius."""
    return arb(0, rest.upper())


def _finite(body: Expr, name: str, low: Expr, high: Expr, outer: InBalls) -> arb:
    """Return an integral between finite ends, low < high, each of which may be singular."""
    cuts = _cuts(body, name, outer.value(low), outer.value(high))
    ends = [low, *map(number, cuts), high]
    return sum((_piece(body, name, a, b, outer) for a, b in pairwise(ends)), arb(0))


def _piece(body: Expr, name: str, low: Expr, high: Expr, outer: InBalls) -> arb:
    """Return an integral over an interval inside which nothing singular is visible."""
    first, last = outer.value(low), outer.value(high)
    compiled = _compiled(body, name, outer)
    bad = [not _analytic(compiled, end, last - first) for end in (first, last)]
    if any(bad):
        try:
            return _apart(body, name, low, high, bad, outer)
        except DivergesError:
            raise
        except UndefinedError:
            pass
    found = quadrature(compiled, first, last)
    if not found.is_finite():
        raise UndefinedError
    return found


def _cuts(body: Expr, name: str, low: arb, high: arb) -> list[fmpq]:
    """Return the rational points inside at which a part that is affine in x may be singular."""
    return sorted(zero for zero in _zeros(body, name) if low < zero < high)


@lru_cache(maxsize=KEPT)
def _zeros(body: Expr, name: str) -> tuple[fmpq, ...]:
    """Return the rational points at which a part that is affine in x may be singular."""
    found: list[fmpq] = []
    for node in operations((body,)):
        if not _may_be_singular(node) or name not in symbols(node.args[0]):
            continue
        part = node.args[0]
        if part.op not in ("+", "*", "symbol"):
            continue
        values = [rational(substitute(part, {name: number(n)})) for n in range(3)]
        a, b, c = values
        if a is None or b is None or c is None:
            continue
        if b - a == c - b and b != a:
            found.append(-a / (b - a))
    return tuple({str(x): x for x in found}.values())


def _may_be_singular(node: Expr) -> bool:
    """Return whether an operation is not analytic where its operand vanishes."""
    if node.op == "^":
        exponent = node.args[1]
        whole = exponent.op == "number" and exponent.args[0].q == 1
        return not (whole and exponent.args[0] > 0)
    return node.op in ("abs", "sign", "cbrt", "log")


def _apart(body: Expr, name: str, low: Expr, high: Expr, bad: list[bool], outer: InBalls) -> arb:
    """Return an integral with singular ends, one at a time."""
    x = symbol(name)
    width = (high - low) / 2 if all(bad) else high - low
    total = arb(0)
    if bad[0]:
        total += _singular(_at(body, name, low + x), name, width, outer)
    if bad[1]:
        total += _singular(_at(body, name, high - x), name, width, outer)
    return total


def _analytic(f: Compiled, end: arb, width: arb) -> bool:
    """Return whether balls show the integrand to be analytic around an end."""
    radius = (width.abs_upper() * arb((1, -16))).mid()
    around = acb(end + arb(0, radius), arb(0, radius))
    return bool(f.holomorphic(around).is_finite()) and f.real(end).is_finite()


def _singular(written: Expr, name: str, width: Expr, outer: InBalls) -> arb:
    """Return the integral of an expression from 0 to ``width``, where it may be singular at 0.

    Raises:
        DivergesError: the integral diverges at 0.
        UndefinedError: no value is proved.
    """
    u = symbol(name)
    if _alone(written, name) and not width.hidden and not symbols(width):
        body, growth, terms = _kept_at_end(written, name, width)
    else:
        body, growth, terms = _at_end(written, name, width, outer)
    end = outer.value(width)
    for k in _roots(terms):
        change = ONE if k == 1 else k * power(u, number(k - 1))
        for form in (body, written):
            regular = _at(form, name, power(u, number(k)), change)
            if form is body:
                regular = _normal(regular, Given(((u, ">", ZERO),)))
            try:
                function = _removed(regular, name, end ** (arb(1) / k), outer)
                found = quadrature(function, arb(0), end ** (arb(1) / k))
            except UndefinedError:
                continue
            if found.is_finite():
                return found
    cut_off = growth.cut(terms, growth.top.max(2 / end).mid(), _nearer, NEAREST)
    if cut_off is None:
        raise UndefinedError
    cut, rest = cut_off
    decay = apply("exp", -u)
    falling = _normal(_at(body, name, decay, decay), Given())
    accuracy, found = ctx.prec, arb.nan()
    for precision in (accuracy + 32, 2 * accuracy + 64):
        with ball_precision(precision):
            again = InBalls(outer.at, outer.rules)
            compiled = _compiled(falling, name, again)
            ends = -again.value(width).log(), cut.log()
            found = quadrature(compiled, *ends, accuracy)
        if found.rad() < arb((1, SLACK - accuracy)) * abs(found).upper().max(1):
            break
    if not found.is_finite():
        raise UndefinedError
    return found + _within(rest)


@lru_cache(maxsize=KEPT)
def _kept_at_end(written: Expr, name: str, width: Expr) -> tuple[Expr, Growth, Sum]:
    return _at_end(written, name, width, InBalls({}))


def _at_end(written: Expr, name: str, width: Expr, outer: InBalls) -> tuple[Expr, Growth, Sum]:
    """Return an integrand between 0 and ``width`` in normal form, and how it grows at 0.

    Raises:
        DivergesError: the integral diverges at 0.
        UndefinedError: it is not shown to converge, or the integrand not to be defined.
    """
    u = symbol(name)
    body = _normal(written, Given(((u, ">", ZERO), (u, "<", width))))
    try:
        growth, terms = _growth(body, name, outer, at_zero=True)
    except UndefinedError:
        growth, terms = _growth(written, name, outer, at_zero=True)
        body = written
    terms = growth.product(terms, growth.terms(u**2))  # du = dt/t²
    _need_defined(written, name, width, outer)
    _need_convergent(growth, terms)
    return body, growth, terms


class _Removed:
    """An integrand with a removable singularity at 0: bounded, and so analytic, on a disc."""

    def __init__(self, inner: Compiled, radius: arb, bound: arb) -> None:
        self.inner, self.radius, self.bound = inner, radius, bound

    def __call__(self, z: acb, analytic: bool) -> acb:
        found = self.inner(z, analytic)
        return found if found.is_finite() else self._bounded(z, found, analytic)

    def _bounded(self, z: acb, found: acb, analytic: bool) -> acb:
        if abs(z) < self.radius:
            return acb(arb(0, self.bound), arb(0, self.bound if analytic else 0))
        return found

    def reals(self, points: list[arb]) -> list[arb] | None:
        return self.inner.reals(points)

    def holomorphics(self, points: list[acb]) -> list[acb]:
        values = zip(points, self.inner.holomorphics(points), strict=True)
        return [v if v.is_finite() else self._bounded(z, v, True) for z, v in values]


def _removed(body: Expr, name: str, end: arb, outer: InBalls) -> Compiled | _Removed:
    """Return the function that an expression is, analytic at 0.

    Raises:
        UndefinedError: it is not shown to be.
    """
    compiled = _compiled(body, name, outer)
    if _analytic(compiled, arb(0), end):
        return compiled
    growth, terms = _growth(body, name, outer, at_zero=True, disc=True)
    if any(t.scale.growth() > 0 for t in terms):
        raise UndefinedError
    bound = abs(growth.range(terms))
    return _Removed(compiled, (1 / growth.top).lower(), bound.upper())


@lru_cache(maxsize=KEPT)
def _normal(e: Expr, given: Given) -> Expr:
    try:
        return normal_form(e, given)
    except InputError:
        return e


def _roots(terms: Sum) -> list[int]:
    """Return the exponents k for which x = v^k may make the integrand analytic."""
    k = 1
    for _, scale, _ in terms:
        if scale.exps or scale.q != 0 or not isinstance(scale.p, fmpq):
            return []
        below = int(scale.p.q)
        k = k * below // _gcd(k, below)
    return [k] if k <= LARGEST_ROOT else []


def _gcd(a: int, b: int) -> int:
    return a if b == 0 else _gcd(b, a % b)


def _need_defined(written: Expr, name: str, width: Expr, outer: InBalls) -> None:
    """Prove that an expression is defined between 0 and ``width``.

    Near 0 its growth is a proof, or the signs of the leading terms of what must be positive or not
    vanish; farther on, balls.

    Raises:
        UndefinedError: it is not proved.
    """
    try:
        growth, _ = _growth(written, name, outer, at_zero=True)
    except UndefinedError:
        growth = _defined_near(written, name, width, outer)
    compiled = _compiled(written, name, outer)
    stack, count = [((1 / growth.top).lower(), outer.value(width).upper())], 0
    while stack:
        a, b = stack.pop()
        count += 1
        if count > PIECES:
            raise UndefinedError
        if not a < b or compiled.real(a.union(b)).is_finite():
            continue
        middle = (a * b).sqrt().mid() if b > 4 * a else ((a + b) / 2).mid()
        stack += [(a, middle), (middle, b)]


def _defined_near(written: Expr, name: str, width: Expr, outer: InBalls) -> Growth:
    """Return a growth from whose T on every condition of definedness holds."""
    if any(node.op not in _WHOLE for node in operations((written,))):
        raise UndefinedError
    u = symbol(name)
    given = Given(((u, ">", ZERO), (u, "<", width)))
    parts = [(_normal(e, given), relation) for e, relation in needs((written,))]
    for start in STARTS:
        growth = Growth(name, start, outer.value, at_zero=True, vanishes=_vanishes)
        try:
            leads = [(growth.lead(growth.terms(e))[0], relation) for e, relation in parts]
        except FartherError:
            continue
        if all(c > 0 or (relation == "!=" and c < 0) for c, relation in leads):
            return growth
    raise UndefinedError
