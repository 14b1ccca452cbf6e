"""Write expressions as polynomials in their parts, and find rational linear dependences."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence
from fractions import Fraction
from itertools import product
from math import lcm

from tresym.reals.language.expression import ZERO, Expr, add, apply, multiply, number, power

Monomial = frozenset[tuple[Expr, int]]
Vector = dict[Monomial, Fraction]
MAX_TERMS = 400


def expanded(e: Expr) -> Vector:
    """Return ``e`` as a polynomial with rational coefficients.

    Parts other than sums and products count as variables.
    """
    if e.op == "number":
        return {frozenset(): Fraction(int(e.args[0].p), int(e.args[0].q))} if e.args[0] != 0 else {}
    if e.op == "+":
        return _total(expanded(arg) for arg in e.args)
    if e.op == "*":
        result: Vector = {frozenset(): Fraction(1)}
        for arg in e.args:
            result = _product(result, expanded(arg))
        return result
    if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
        n, inner = int(e.args[1].args[0].p), expanded(e.args[0])
        if len(inner) == 1:
            ((monomial, c),) = inner.items()
            return {frozenset((part, k * n) for part, k in monomial): c**n}
        if 0 < n <= 12:
            result = inner
            for _ in range(n - 1):
                result = _product(result, inner)
            return result
    return {frozenset(((e, 1),)): Fraction(1)}


def _total(vectors: Iterable[Vector]) -> Vector:
    result: Vector = {}
    for vector in vectors:
        for monomial, c in vector.items():
            result[monomial] = result.get(monomial, Fraction(0)) + c
    return {monomial: c for monomial, c in result.items() if c}


def _product(x: Vector, y: Vector) -> Vector:
    if len(x) * len(y) > MAX_TERMS:
        raise OverflowError
    return _total({_times(m, n): a * b} for m, a in x.items() for n, b in y.items())


def _times(x: Monomial, y: Monomial) -> Monomial:
    exponents = dict(x)
    for part, n in y:
        exponents[part] = exponents.get(part, 0) + n
    return frozenset((part, n) for part, n in exponents.items() if n)


def scaled(e: Expr, by: Fraction) -> Expr:
    """Return ``by·e``."""
    return e if by == 1 else multiply(number(by), e)


def combination(basis: Sequence[Vector], v: Vector) -> list[Fraction] | None:
    """Return the coefficients of ``v`` in independent vectors, or None if there are none."""
    rows = sorted({m for w in (*basis, v) for m in w}, key=str)
    matrix = [[w.get(m, Fraction(0)) for w in (*basis, v)] for m in rows]
    n, done = len(basis), 0
    for column in range(n):
        pivot = next(i for i in range(done, len(matrix)) if matrix[i][column])
        matrix[done], matrix[pivot] = matrix[pivot], matrix[done]
        matrix[done] = [x / matrix[done][column] for x in matrix[done]]
        for i, row in enumerate(matrix):
            if i != done and row[column]:
                matrix[i] = [x - row[column] * y for x, y in zip(row, matrix[done], strict=True)]
        done += 1
    if any(row[n] for row in matrix[done:]):
        return None
    return [row[n] for row in matrix[:n]]


def whole_basis(
    terms: Sequence[Expr], first: Sequence[Expr] = ()
) -> tuple[list[Expr], dict[Expr, list[int]]]:
    """Return independent expressions of which all ``terms`` are integer linear combinations.

    Args:
        terms: the expressions.
        first: expressions that are preferred for the basis.
    """
    chosen: list[Expr] = []
    vectors: list[Vector] = []
    found: dict[Expr, list[Fraction]] = {}
    rest = sorted(set(terms), key=lambda e: (e.size, str(e)))
    for e in dict.fromkeys((*first, *rest)):
        v = expanded(e)
        c = combination(vectors, v)
        if not v:
            c = []
        elif c is None:
            chosen.append(e)
            vectors.append(v)
            c = [Fraction(0)] * (len(chosen) - 1) + [Fraction(1)]
        found[e] = c
    bottoms = [1] * len(chosen)
    for c in found.values():
        for j, x in enumerate(c):
            bottoms[j] = lcm(bottoms[j], x.denominator)
    whole = {}
    for e, c in found.items():
        padded = [*c, *[Fraction(0)] * (len(chosen) - len(c))]
        whole[e] = [int(x * d) for x, d in zip(padded, bottoms, strict=True)]
    bases = [scaled(e, Fraction(1, d)) for e, d in zip(chosen, bottoms, strict=True)]
    return bases, whole


def as_expression(terms: Vector) -> Expr:
    """Return the expression of a polynomial."""
    parts = sorted(((str(sorted(map(str, m))), m, c) for m, c in terms.items()), key=lambda p: p[0])
    return add(*(_term(m, c) for _, m, c in parts)) if parts else ZERO


def _term(m: Monomial, c: Fraction) -> Expr:
    """Return one term of a polynomial as an expression."""
    factors = [power(part, number(n)) for part, n in sorted(m, key=str)]
    return multiply(number(c), *factors)


def without_squares(terms: Vector, angles: Sequence[Expr]) -> Iterator[Vector]:
    """Eliminate the squares of the sine, or of the cosine, of each angle."""
    for choice in product(("sin", "cos"), repeat=len(angles)):
        found = terms
        for name, angle in zip(choice, angles, strict=True):
            found = without_square(found, name, angle)
        yield found


def without_square(terms: Vector, name: str, angle: Expr) -> Vector:
    """Reduce to terms in which the sine (or cosine) of the angle occurs at most once."""
    gone = apply(name, angle)
    cofunction = apply("cos" if name == "sin" else "sin", angle)
    found: Vector = {}
    for monomial, c in terms.items():
        powers = dict(monomial)
        n = powers.pop(gone, 0)
        half, odd = divmod(n, 2)
        if odd:
            powers[gone] = 1
        coefficient = Fraction(1)
        for k in range(half + 1):  # (1 − kept²)^half
            own = dict(powers)
            if k:
                own[cofunction] = own.get(cofunction, 0) + 2 * k
            key = frozenset((part, m) for part, m in own.items() if m)
            found[key] = found.get(key, Fraction(0)) + c * coefficient
            coefficient = -coefficient * (half - k) / (k + 1)
    return {key: c for key, c in found.items() if c}
