"""Exponential polynomials, and the linear differential equations that they solve.

An exponential polynomial is a sum of terms c tᵏ e^{at} cos(bt) and c tᵏ e^{at} sin(bt) with
rational a and b². A linear system u' = M u + f(t) with a rational matrix and such an f has a
solution of the same kind if the characteristic polynomial of M splits into such factors: every
component is annihilated by P(d/dt), where P is the characteristic polynomial times the annihilator
of f, so that its derivatives at 0, which the equation gives, determine its coefficients.

Example: x'' + x = cos t with x(0) = x'(0) = 0 has P = (s² + 1)², and x = t sin(t)/2.

What is found here is a suggestion: the lemmas put it into the equation.
Source: E. A. Coddington and N. Levinson, *Theory of Ordinary Differential Equations*, 1955,
section 3.4.
"""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from math import isqrt
from typing import NamedTuple

from flint import fmpq, fmpq_mat, fmpz_poly

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    number,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision

HIGHEST = 8
"""The highest power of an exponential polynomial."""
MOST_TERMS = 400
LARGEST = 14
"""The largest degree of the polynomial that annihilates a solution."""


class Term(NamedTuple):
    """tᵏ e^{at} cos(bt), or sin(bt), without its coefficient.

    Attributes:
        k: the power of t.
        rate: a.
        square: b², at least 0.
        odd: whether it is a sine; not with b = 0.
    """

    k: int
    rate: fmpq
    square: fmpq
    odd: bool

    def key(self) -> tuple[int, int, int, int, int, bool]:
        """Return something that can be compared and hashed."""
        a, b = self.rate, self.square
        return self.k, int(a.p), int(a.q), int(b.p), int(b.q), self.odd


Polynomial = dict[Term, Expr]
"""Coefficients by terms."""


def _root(x: fmpq) -> fmpq | None:
    """Return the square root of a rational number, if it is rational."""
    p, q = int(x.p), int(x.q)
    a, b = isqrt(p) if p >= 0 else -1, isqrt(q)
    return fmpq(a, b) if a >= 0 and a * a == p and b * b == q else None


def polynomial(e: Expr, name: str) -> Polynomial | None:
    """Return an expression as an exponential polynomial in a variable, or None if it is none."""
    if name not in symbols(e):
        return {} if e == ZERO else {Term(0, fmpq(0), fmpq(0), False): e}
    op, args = e.op, e.args
    if op == "symbol":
        return {Term(1, fmpq(0), fmpq(0), False): ONE}
    if op in ("+", "*"):
        parts = [polynomial(arg, name) for arg in args]
        found: Polynomial | None = {} if op == "+" else polynomial(ONE, name)
        for part in parts:
            if part is None or found is None:
                return None
            found = plus(found, part) if op == "+" else times(found, part)
        return found
    if op == "^" and args[1].op == "number" and args[1].args[0].q == 1:
        n = int(args[1].args[0].p)
        if n < 0:
            base = args[0]
            if base.op == "^" or base.op not in ("exp",):
                return None
            return polynomial(apply("exp", base.args[0] * n), name)
        base_ = polynomial(args[0], name)
        found = polynomial(ONE, name)
        for _ in range(min(n, HIGHEST + 1)):
            found = None if found is None or base_ is None else times(found, base_)
        return found if n <= HIGHEST else None
    if op == "^" and args[0] == apply("exp", ONE):
        return polynomial(apply("exp", args[1]), name)
    if op in ("exp", "sin", "cos", "sinh", "cosh"):
        return _of_line(op, args[0], name)
    return None


def _of_line(op: str, line: Expr, name: str) -> Polynomial | None:
    slope = normal_form(differentiate(line, name), Given())
    if symbols(slope):
        return None
    shift = normal_form(substitute(line, {name: ZERO}), Given())
    if op in ("exp", "sinh", "cosh"):
        if slope.op != "number":
            return None
        rate = slope.args[0]
        if op == "exp":
            return {Term(0, rate, fmpq(0), False): apply("exp", shift) if shift != ZERO else ONE}
        up = _of_line("exp", line, name)
        down = _of_line("exp", -line, name)
        if up is None or down is None:
            return None
        sign = ONE if op == "cosh" else -ONE
        half = number(fmpq(1, 2))
        return plus(
            {x: half * c for x, c in up.items()}, {x: sign * half * c for x, c in down.items()}
        )
    square = normal_form(slope**2, Given())
    if square.op != "number":
        return None
    with ball_precision():
        positive = bool(evaluate(slope, {}) > 0)
    even, odd = (Term(0, fmpq(0), square.args[0], x) for x in (False, True))
    s, c = (apply(x, shift) if shift != ZERO else y for x, y in (("sin", ZERO), ("cos", ONE)))
    sign = ONE if positive else -ONE
    found = {even: c, odd: -sign * s} if op == "cos" else {even: s, odd: sign * c}
    return {term: x for term, x in found.items() if x != ZERO}


def plus(one: Polynomial, other: Polynomial) -> Polynomial:
    """Return the sum."""
    found = dict(one)
    for term, c in other.items():
        found[term] = found[term] + c if term in found else c
    return _reduced(found)


def times(one: Polynomial, other: Polynomial) -> Polynomial | None:
    """Return the product, or None if a frequency is not the root of a rational number."""
    if len(one) * len(other) > MOST_TERMS:
        return None
    found: Polynomial = {}
    for x, c in one.items():
        for y, d in other.items():
            for term, factor in _product(x, y):
                if term is None or term.k > HIGHEST:
                    return None
                value = number(factor) * c * d
                found[term] = found[term] + value if term in found else value
    return _reduced(found)


def _product(x: Term, y: Term) -> Iterable[tuple[Term | None, fmpq]]:
    k, rate = x.k + y.k, x.rate + y.rate
    if x.square == 0 or y.square == 0:
        square, odd = (y.square, y.odd) if x.square == 0 else (x.square, x.odd)
        return [(Term(k, rate, square, odd), fmpq(1))]
    root = _root(x.square * y.square)
    if root is None:
        return [(None, fmpq(0))]
    total, gap = x.square + y.square + 2 * root, x.square + y.square - 2 * root
    half = fmpq(1, 2)
    up = 1 if x.square >= y.square else -1  # the sign of the difference of the frequencies
    if x.odd and y.odd:
        return [(Term(k, rate, gap, False), half), (Term(k, rate, total, False), -half)]
    if not x.odd and not y.odd:
        return [(Term(k, rate, gap, False), half), (Term(k, rate, total, False), half)]
    sign = up if x.odd else -up
    parts: list[tuple[Term | None, fmpq]] = [(Term(k, rate, total, True), half)]
    if gap != 0:
        parts.append((Term(k, rate, gap, True), half * sign))
    return parts


def _reduced(p: Polynomial) -> Polynomial:
    found = {}
    for term, c in p.items():
        c = c if c.op == "number" else normal_form(c, Given())
        if c != ZERO:
            found[term] = c
    return found


def slope(p: Polynomial) -> Polynomial:
    """Return the derivative."""
    found: Polynomial = {}
    for term, c in p.items():
        parts = [(term, number(term.rate) * c)]
        if term.k:
            parts.append((term._replace(k=term.k - 1), term.k * c))
        if term.square != 0:
            b = sqrt(number(term.square))
            parts.append((term._replace(odd=not term.odd), (b if term.odd else -b) * c))
        found = plus(found, {})
        for other, value in parts:
            found[other] = found[other] + value if other in found else value
    return _reduced(found)


def expression(p: Polynomial, name: str) -> Expr:
    """Return an exponential polynomial as an expression, slowest terms first."""
    t = symbol(name)
    terms = []
    for term in sorted(p, key=lambda x: (-float(x.rate.p) / float(x.rate.q), x.key())):
        e = p[term]
        if term.k:
            e = e * t**term.k
        if term.rate != 0:
            e = e * apply("exp", number(term.rate) * t)
        if term.square != 0:
            e = e * apply("sin" if term.odd else "cos", _frequency(term.square) * t)
        terms.append(e)
    return add(*terms) if terms else ZERO


def _frequency(square: fmpq) -> Expr:
    root = _root(square)
    return number(root) if root is not None else normal_form(sqrt(number(square)), Given())


def is_bounded(p: Polynomial) -> bool:
    """Whether the function is bounded for t >= 0; no coefficient may vanish."""
    return all(x.rate < 0 or (x.rate == 0 and x.k == 0) for x in p)


def decays(p: Polynomial) -> bool:
    """Whether the function tends to 0 as t -> oo."""
    return all(x.rate < 0 for x in p)


# Linear systems


def solve_linear(
    matrix: Sequence[Sequence[fmpq]], forcing: Sequence[Polynomial], start: Sequence[Expr]
) -> list[Polynomial] | None:
    """Return the solution of u' = M u + f(t), u(0) = start; None if it is not found."""
    n = len(matrix)
    m = fmpq_mat(n, n, [x for row in matrix for x in row])
    multiplicity = _roots(m)
    if multiplicity is None:
        return None
    for p in forcing:
        own: dict[tuple[fmpq, fmpq], int] = {}
        for term in p:
            place = term.rate, term.square
            own[place] = max(own.get(place, 0), term.k + 1)
        for place, k in own.items():
            multiplicity[place] = multiplicity.get(place, 0) + k
    basis: list[Term] = []
    for (rate, square), k in multiplicity.items():
        for odd in (False, True) if square != 0 else (False,):
            basis += [Term(j, rate, square, odd) for j in range(k)]
    size = len(basis)
    if size > LARGEST * 2:
        return None
    place_of = {term: i for i, term in enumerate(basis)}
    step = fmpq_mat(size, size)
    for j, term in enumerate(basis):  # sines stand for sin(bt)/b
        step[j, j] = step[j, j] + term.rate
        if term.k:
            i = place_of[term._replace(k=term.k - 1)]
            step[i, j] = step[i, j] + term.k
        if term.square != 0:
            i = place_of[term._replace(odd=not term.odd)]
            step[i, j] = step[i, j] + (1 if term.odd else -term.square)
    row = fmpq_mat(1, size, [int(x.k == 0 and not x.odd) for x in basis])
    table = []
    for _ in range(size):
        table += [row[0, j] for j in range(size)]
        row = row * step
    try:
        inverse = fmpq_mat(size, size, table).inv()
    except ZeroDivisionError:
        return None
    values = [list(start)]
    sources = list(forcing)
    for _ in range(size - 1):
        last = values[-1]
        at_zero = [
            add(*(c for x, c in p.items() if x.k == 0 and not x.odd)) if p else ZERO
            for p in sources
        ]
        values.append(
            [
                _sum([*((m[i, j], last[j]) for j in range(n)), (fmpq(1), at_zero[i])])
                for i in range(n)
            ]
        )
        sources = [slope(p) for p in sources]
    found: list[Polynomial] = []
    for i in range(n):
        q: Polynomial = {}
        for j, term in enumerate(basis):
            c = _sum([(inverse[j, r], values[r][i]) for r in range(size)])
            if c != ZERO:
                q[term] = c / sqrt(number(term.square)) if term.odd else c
        found.append(_reduced(q))
    return found


def _sum(parts: Sequence[tuple[fmpq, Expr]]) -> Expr:
    terms = [number(x) * e for x, e in parts if x != 0 and e != ZERO]
    if not terms:
        return ZERO
    total = add(*terms)
    return total if total.op == "number" else normal_form(total, Given())


def _roots(m: fmpq_mat) -> dict[tuple[fmpq, fmpq], int] | None:
    """Return the multiplicities of the eigenvalues a ± ib, as (a, b²); None if one is no such."""
    p = m.charpoly()
    whole = fmpz_poly([int(c) for c in (p * p.denom()).coeffs()])
    found: dict[tuple[fmpq, fmpq], int] = {}
    for factor, k in whole.factor()[1]:
        c = [fmpq(int(x)) for x in factor.coeffs()]
        if len(c) == 2:
            place = -c[0] / c[1], fmpq(0)
        elif len(c) == 3:
            a = -c[1] / (2 * c[2])
            place = a, c[0] / c[2] - a * a
        else:
            return None
        if place[1] < 0:
            return None
        found[place] = found.get(place, 0) + k
    return found
