"""Recognise the value of an integral, a sum, a limit or a constant from its digits.

A number is compared with rational multiples of π, √2, log 2, e and similar constants, with square
roots and logarithms of rationals, and with sums of two of these. A sum up to n is compared with
polynomials and rational functions of n. The result is a guess, which is then decided like any
claim.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from fractions import Fraction

from flint import fmpq, fmpq_mat, fmpz_poly

from tresym.reals.language.binders import elementary, is_infinite, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    FUNCTIONS,
    HALF,
    PI,
    ZERO,
    E,
    Expr,
    add,
    apply,
    multiply,
    number,
    power,
    sqrt,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.repair.floating import Points, UnsupportedError

CLOSE = 3e-10
MOST_BELOW = 60
"""The largest denominator of rational factors."""
DEGREE = 7
"""The maximal degree of a closed form, numerator plus denominator."""
_WORKED = ("integral", "sum", "product", "limit")


def _bases() -> list[tuple[Expr, float]]:
    roots = [sqrt(number(n)) for n in (2, 3, 5, 6)]
    logs = [apply("log", number(n)) for n in (2, 3, 5)]
    plain = [PI, sqrt(PI), *roots, *logs, E, power(E, number(-1)), power(PI, number(-1))]
    plain += [PI * root for root in roots[:2]] + [PI**n for n in (2, 3, 4)]
    plain += [PI * logs[0], E**2, sqrt(2 * PI), power(sqrt(PI), number(-1))]
    points = Points({})
    return [(base, points.values(base)[0]) for base in plain]


BASES = _bases()


def recognised(value: float, most: int = 4) -> list[Expr]:
    """Return closed forms of a number, the simplest first."""
    found: list[tuple[float, Expr]] = []
    if not math.isfinite(value):
        return []
    for base, unit in ((number(1), 1.0), *BASES):
        ratio = _rational(value / unit, 1000 if unit == 1 else MOST_BELOW)
        if ratio is not None:
            weight = (base.size - 1) * 6 + _weight(ratio)
            found.append((weight, multiply(number(ratio), base)))
    for power_, make in ((value * value, sqrt), (math.exp(value) if value < 9 else 0.0, _log)):
        ratio = _rational(power_, MOST_BELOW)
        if ratio is not None and ratio > 0 and not (make is sqrt and _is_square(ratio)):
            tree = make(number(ratio))
            sign = value < 0 and make is sqrt
            found.append((20 + _weight(ratio), -tree if sign else tree))
    if not found:
        found += _two_terms(value)
    return [tree for _, tree in sorted(found, key=lambda pair: pair[0])[:most]]


def _log(e: Expr) -> Expr:
    return apply("log", e)


def _is_square(ratio: Fraction) -> bool:
    return all(math.isqrt(n) ** 2 == n for n in (ratio.numerator, ratio.denominator))


def _weight(ratio: Fraction) -> float:
    return math.log2(abs(ratio.numerator) + 1) + 1.5 * math.log2(ratio.denominator)


def _rational(x: float, below: int) -> Fraction | None:
    if not math.isfinite(x) or abs(x) > 1e7:
        return None
    found = Fraction(x).limit_denominator(below)
    near = abs(float(found) - x) <= CLOSE * max(1.0, abs(x)) / found.denominator
    return found if near and (found or abs(x) < CLOSE) else None


def _two_terms(value: float) -> Iterator[tuple[float, Expr]]:
    """A rational number and a rational multiple of one of the bases."""
    for base, unit in BASES[:11]:
        for q in (1, 2, 3, 4, 6, 8):
            for p in range(-12, 13):
                if p == 0 or math.gcd(p, q) != 1:
                    continue
                rest = _rational(value - p / q * unit, 24)
                if rest is not None:
                    share = Fraction(p, q)
                    tree = multiply(number(share), base) + number(rest)
                    yield 30 + _weight(share) + _weight(rest), tree


def worked_side(comparison: Compared) -> int | None:
    """Which side is to be worked out, 0 or 2; None where neither is, or both."""
    left, relation, right = comparison
    if relation not in ("==", "->"):
        return None
    hard = [any(node.op in _WORKED for node in outermost(side)) for side in (left, right)]
    if hard[0] != hard[1]:
        return 0 if hard[0] else 2
    if hard[0] or symbols(left) | symbols(right) or not elementary(left, right):
        return None
    heights = [sum(op in FUNCTIONS for op in _operations(side)) for side in (left, right)]
    return 0 if heights[0] >= heights[1] else 2


def _operations(e: Expr) -> Iterator[str]:
    yield e.op
    for arg in e.args:
        if isinstance(arg, Expr):
            yield from _operations(arg)


def values(comparison: Compared, given: Sequence[Compared]) -> Iterator[Expr]:
    """Yield possible values of the side that is to be evaluated."""
    side = worked_side(comparison)
    if side is None or comparison[1] == "->":
        return
    tree, other = comparison[::2] if side == 0 else comparison[::-2]
    names = symbols(tree) - symbols(INFINITY)
    try:
        if not names:
            (value,) = Points({}).values(tree)
            shares = () if math.isfinite(value) else (HALF, number(2), number(-1), HALF * HALF)
            yield from (share * other for share in shares)
            yield from (found for found in recognised(value) if found != tree)
        elif len(names) == 1 and not any(map(is_infinite, outermost(tree))):
            (name,) = names
            if any(link == (symbol(name), "in", link[2]) for link in given):
                yield from _closed_forms(tree, name)
    except UnsupportedError:
        return


def _closed_forms(tree: Expr, name: str) -> Iterator[Expr]:
    """Yield a rational function of ``name`` that equals a sum at the first integers."""
    places = [fmpq(n) for n in range(1, DEGREE + 6)]
    rows = Points({name: [float(n.p) for n in places]}).values(tree)
    known = [
        (n, fmpq(value.numerator, value.denominator))
        for n, y in zip(places, rows, strict=True)
        if (value := _rational(y, 100_000)) is not None
    ]
    if len(known) < DEGREE + 3:
        return
    for total in range(DEGREE + 1):
        for below in range(min(total, 3) + 1):
            found = _quotient(known, total - below, below)
            if found is not None:
                yield _written(found[0], name) / _written(found[1], name)
                return


def _quotient(
    known: list[tuple[fmpq, fmpq]], above: int, below: int
) -> tuple[list[fmpq], list[fmpq]] | None:
    """Return the coefficients of the rational function through all points, monic below, or None."""
    size = above + below + 1
    rows = [
        [*(x**k for k in range(above + 1)), *(-y * x**k for k in range(below))]
        for x, y in known[:size]
    ]
    right = [[y * x**below] for x, y in known[:size]]
    try:
        solution = fmpq_mat(rows).solve(fmpq_mat(right))
    except ZeroDivisionError:
        return None
    p = [solution[k, 0] for k in range(above + 1)]
    q = [*(solution[above + 1 + k, 0] for k in range(below)), fmpq(1)]
    fits = all(_at(p, x) == y * _at(q, x) and _at(q, x) != 0 for x, y in known)
    return (p, q) if fits else None


def _at(coefficients: list[fmpq], x: fmpq) -> fmpq:
    return sum((c * x**k for k, c in enumerate(coefficients)), fmpq(0))


def _written(coefficients: list[fmpq], name: str) -> Expr:
    """Return a polynomial as a product of its factors."""
    below = math.lcm(*(int(c.q) for c in coefficients))
    constant, factors = fmpz_poly([int((c * below).p) for c in coefficients]).factor()
    x = symbol(name)
    parts = [number(fmpq(int(constant), below))]
    for factor, times in factors:
        terms = [
            multiply(number(int(c)), x**k) if k else number(int(c))
            for k, c in enumerate(factor.coeffs())
        ]
        parts.append(add(*reversed([t for t in terms if t != ZERO])) ** times)
    return multiply(parts[0], *sorted(parts[1:], key=lambda part: part.size))
