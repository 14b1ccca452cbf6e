"""Look for functions that are constant along a motion x' = F(x), to use them with Lyapunov.

- Polynomials of degree 2, of a motion by polynomials: their coefficients solve linear equations, so
  of Euler's equations energy and square of the angular momentum are found.
- In the plane, H with ∂H/∂y = μ F₁ and ∂H/∂x = −μ F₂, for simple factors μ: denominators of F,
  powers of the variables, their sines and cosines. So the energy of a pendulum is found, and the
  constant of the motion of Lotka and Volterra.

Nothing is proved here: who uses a candidate shows what it needs.
"""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from itertools import islice, product

from flint import fmpq

from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import derivative, elementary, worked_out
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    multiply,
    number,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import in_lowest_terms

TERMS = 60
"""The most terms of a sum that is multiplied out."""
FACTORS = 24
"""The most factors μ that are tried."""
_PRIMITIVES = {
    "exp": (1, "exp"), "sin": (-1, "cos"), "cos": (1, "sin"), "sinh": (1, "cosh"),
    "cosh": (1, "sinh"),
}  # fmt: skip
Monomial = tuple[int, ...]


# In the plane


def plane_integrals(names: Sequence[str], rates: Sequence[Expr]) -> Iterator[Expr]:
    """Yield candidates H of a motion of two variables."""
    x, y = names
    for factor in islice(_factors(names, rates), FACTORS):
        p, q = (in_lowest_terms(factor * rate) for rate in rates)
        gap = in_lowest_terms(worked_out(derivative(p, x)) + worked_out(derivative(q, y)))
        if gap != ZERO:
            continue
        first = antiderivative(p, y)
        if first is None:
            continue
        rest = in_lowest_terms(-q - worked_out(derivative(first, x)))
        second = None if y in symbols(rest) else antiderivative(rest, x)
        if second is not None:
            yield in_lowest_terms(first + second)


def _factors(names: Sequence[str], rates: Sequence[Expr]) -> Iterator[Expr]:
    below = {
        node.args[0]: None
        for node in operations(tuple(rates))
        if node.op == "^" and node.args[1].op == "number" and node.args[1].args[0] < 0
    }
    common = [ONE, *(e for e in below if symbols(e) & {*names})]
    x, y = map(symbol, names)
    for e in common:
        yield e
        for v in (x, y):
            yield e / v
        yield e / (x * y)
        trig = {n.args[0] for n in operations(tuple(rates)) if n.op in ("sin", "cos")}
        for angle in (angle for angle in (x, y) if angle in trig):
            yield e * apply("sin", angle)
            yield e * apply("cos", angle)


def antiderivative(f: Expr, name: str) -> Expr | None:
    """Return an antiderivative of a sum of simple terms, or None.

    Example:
        >>> str(antiderivative(symbol("x") * symbol("a"), "x"))
        'a/2*x**2'
    """
    x = symbol(name)
    terms: list[Expr] = []
    for factors in islice(_products(f), TERMS + 1):
        power, outer, inner = fmpq(0), [], []
        for factor in factors:
            if name not in symbols(factor):
                outer.append(factor)
            elif factor == x:
                power += 1
            elif factor.op == "^" and factor.args[0] == x and factor.args[1].op == "number":
                power += factor.args[1].args[0]
            else:
                inner.append(factor)
        value = _of_a_product(power, inner, name)
        if value is None or len(terms) == TERMS:
            return None
        terms.append(multiply(*outer, value))
    return add(*terms)


def _of_a_product(power: fmpq, inner: Sequence[Expr], name: str) -> Expr | None:
    x = symbol(name)
    if not inner:
        return apply("log", x) if power == -1 else number(1 / (power + 1)) * x ** number(power + 1)
    if power != 0 or any(e.op not in _PRIMITIVES for e in inner):
        return None
    argument = inner[0].args[0]
    slope = worked_out(derivative(argument, name))
    if any(e.args[0] != argument for e in inner) or name in symbols(slope):
        return None
    if len(inner) == 1:
        sign, op = _PRIMITIVES[inner[0].op]
        return number(sign) * apply(op, argument) / slope
    if sorted(e.op for e in inner) == ["cos", "sin"]:
        return apply("sin", argument) ** number(2) / (number(2) * slope)
    return None


def _products(e: Expr) -> Iterator[tuple[Expr, ...]]:
    """Yield the products whose sum is ``e``, sums in brackets multiplied out."""
    exponent = e.args[1].args[0] if e.op == "^" and e.args[1].op == "number" else None
    if e.op == "+":
        for term in e.args:
            yield from _products(term)
    elif e.op == "*":
        for parts in product(*(list(islice(_products(arg), TERMS)) for arg in e.args)):
            yield tuple(factor for part in parts for factor in part)
    elif exponent is not None and e.args[0].op == "*":
        yield tuple(_power(arg, exponent) for arg in e.args[0].args)
    elif exponent is not None and e.args[0].op in ("+", "sin", "cos") and exponent in (2, 3):
        for parts in product(list(islice(_products(e.args[0]), TERMS)), repeat=int(exponent)):
            yield tuple(factor for part in parts for factor in part)
    else:
        yield (e,)


def _power(e: Expr, exponent: fmpq) -> Expr:
    if e.op == "^" and e.args[1].op == "number":
        return e.args[0] ** number(e.args[1].args[0] * exponent)
    return e ** number(exponent)


# Polynomials


def quadratic_integrals(names: Sequence[str], rates: Sequence[Expr]) -> list[Expr]:
    """Return polynomials of degree 2 without a constant term that a motion conserves.

    Example:
        >>> x, y = symbol("x"), symbol("y")
        >>> [str(h) for h in quadratic_integrals(("x", "y"), (y, -x))]
        ['x**2 + y**2']
    """
    fields = [_polynomial(rate, names) for rate in rates]
    if any(field is None for field in fields):
        return []
    size = len(names)
    units = [tuple(int(i == j) for j in range(size)) for i in range(size)]
    squares = [_sum(units[i], units[j]) for i in range(size) for j in range(i, size)]
    basis = [*units, *squares]
    rows: dict[Monomial, list[Expr]] = {}
    for column, monomial in enumerate(basis):
        for i, field in enumerate(fields):
            if not monomial[i] or field is None:
                continue
            lower = tuple(n - (j == i) for j, n in enumerate(monomial))
            for other, coefficient in field.items():
                row = rows.setdefault(_sum(lower, other), [ZERO] * len(basis))
                row[column] = row[column] + number(fmpq(monomial[i])) * coefficient
    return [
        add(*(c * _of(m, names) for c, m in zip(vector, basis, strict=True) if c != ZERO))
        for vector in null_space(list(rows.values()), len(basis))[0]
    ]


def null_space(rows: Sequence[Sequence[Expr]], columns: int) -> tuple[list[list[Expr]], list[Expr]]:
    """Return a basis of the solutions of linear equations, by Gauss and Jordan, and its divisors.

    It is a basis for all values of the parameters at which the divisors are not 0.
    """
    divisors: list[Expr] = []
    left = [[in_lowest_terms(e) for e in row] for row in rows]
    pivots: list[tuple[int, list[Expr]]] = []
    for column in range(columns):
        pivot = next((row for row in left if row[column] != ZERO), None)
        if pivot is None:
            continue
        left = [row for row in left if row is not pivot]
        scale = pivot[column]
        divisors.append(scale)
        pivot = [in_lowest_terms(e / scale) for e in pivot]
        left = [_minus(row, row[column], pivot) for row in left]
        pivots = [(n, _minus(row, row[column], pivot)) for n, row in pivots]
        pivots.append((column, pivot))
    taken = {n for n, _ in pivots}
    found = []
    for free in (n for n in range(columns) if n not in taken):
        vector = [ZERO] * columns
        vector[free] = ONE
        for n, row in pivots:
            vector[n] = -row[free]
        found.append(vector)
    return found, divisors


def _minus(row: Sequence[Expr], factor: Expr, pivot: Sequence[Expr]) -> list[Expr]:
    if factor == ZERO:
        return list(row)
    return [in_lowest_terms(e - factor * p) for e, p in zip(row, pivot, strict=True)]


def _polynomial(e: Expr, names: Sequence[str]) -> dict[Monomial, Expr] | None:
    """The coefficients of a polynomial in the variables; None if it is none, or too long."""
    found: dict[Monomial, Expr] = {}
    if not elementary(e):
        return None
    for count, factors in enumerate(_products(e)):
        if count > TERMS:
            return None
        powers = [0] * len(names)
        outer: list[Expr] = []
        for factor in factors:
            if not symbols(factor) & {*names}:
                outer.append(factor)
                continue
            base, exponent = factor, fmpq(1)
            if factor.op == "^" and factor.args[1].op == "number":
                base, exponent = factor.args[0], factor.args[1].args[0]
            if base.op != "symbol" or exponent.q != 1 or exponent < 0:
                return None
            powers[list(names).index(base.args[0])] += int(exponent)
        key = tuple(powers)
        found[key] = found.get(key, ZERO) + multiply(*outer)
    return found


def _of(monomial: Monomial, names: Sequence[str]) -> Expr:
    powers = (symbol(n) ** number(fmpq(k)) for n, k in zip(names, monomial, strict=True) if k)
    return multiply(*powers)


def _sum(one: Monomial, other: Monomial) -> Monomial:
    return tuple(a + b for a, b in zip(one, other, strict=True))
