"""Factor polynomials in the generators canonically, so that equal values have equal factors.

For example, with g = √2 the polynomial x − g becomes (x² − 2)·(x + g)^(−1), so that its product
with x + g has the one factor x² − 2. A factorisation that :mod:`.denesting` proposes is verified by
multiplying it out. The factors over the integers are FLINT's.
"""

from __future__ import annotations

from functools import partial

from flint import fmpq, fmpz

from tresym.reals.normal.denesting import canonical
from tresym.reals.normal.ring import Fraction, Poly, Ring, UndefinedError, small_factor
from tresym.reals.numbers.factoring import TooLargeError, primes_of

MAX_FACTOR_TERMS = 1000

PowersOfFactors = dict[str, tuple[Poly, fmpq]]
"""Canonical factors with their exponents, by the text of the factor."""


def factor_polynomial(ring: Ring, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
    """Return ``p`` as an integer times powers of canonical factors; exponents may be negative.

    Raises:
        TooLargeError: ``p`` has more than :data:`MAX_FACTOR_TERMS` terms.
    """
    key = str(p)
    factored = ring.factored.get(key)
    if factored is None:
        factored = ring.factored[key] = _factor(ring, p)
    return factored


def _factor(ring: Ring, p: Poly) -> tuple[fmpz, list[tuple[Poly, int]]]:
    if p.is_constant():
        return p.leading_coefficient(), []
    if len(p) > MAX_FACTOR_TERMS:
        raise TooLargeError(
            f"factoring a polynomial of {len(p)} terms (the limit is {MAX_FACTOR_TERMS})"
        )
    if len(p) == 1:
        ((monomial, value),) = p.terms()
        return value, [(ring.variables[i], int(k)) for i, k in enumerate(monomial) if k]
    if p.total_degree() == 1:
        content = p.content()
        unit = content if p.leading_coefficient() > 0 else -content
        raw = [(p // ring.context.constant(unit), 1)]
    else:
        unit, raw = small_factor(ring, p)
    merged: dict[str, tuple[Poly, int]] = {}
    for factor, exponent in raw:
        if factor.leading_coefficient() < 0:
            factor = -factor
            unit = unit if exponent % 2 == 0 else -unit
        scale, parts = canonical(ring, factor, partial(factor_polynomial, ring))
        if not multiplies(ring, factor, scale, parts):
            scale, parts = fmpz(1), [(factor, 1)]
        unit *= scale**exponent
        for part, k in parts:
            name = str(part)
            merged[name] = (part, merged.get(name, (part, 0))[1] + k * exponent)
    return unit, [item for item in merged.values() if item[1]]


def multiplies(ring: Ring, f: Poly, unit: fmpz, parts: list[tuple[Poly, int]]) -> bool:
    """Return whether the product is ``f`` at almost all points, where no factor vanishes."""
    if parts == [(f, 1)]:
        return bool(unit == 1)
    top, bottom = ring.context.constant(unit), f
    for part, k in parts:
        top, bottom = (top * part**k, bottom) if k > 0 else (top, bottom * part**-k)
        if k < 0 and ring.is_mixed(part) and ring.is_mixed(ring.reduce(part * f)):
            return False
    return bool(ring.reduce(top - bottom).is_zero())


def factor_fraction(ring: Ring, x: Fraction) -> tuple[int, PowersOfFactors]:
    """Return ``x`` as a sign times powers of canonical factors, primes among them.

    Raises:
        UndefinedError: ``x`` is zero.
    """
    if x.num.is_zero():
        raise UndefinedError("a logarithm or negative power of zero")
    result: PowersOfFactors = {}
    sign = 1
    for p, side in ((x.num, 1), (x.den, -1)):
        unit, parts = factor_polynomial(ring, p)
        sign = sign if unit > 0 else -sign
        for prime, k in primes_of(abs(unit)):
            parts = [*parts, (ring.context.constant(prime), k)]
        for part, k in parts:
            key = str(part)
            old = result.get(key, (part, fmpq(0)))[1]
            result[key] = (part, old + side * k)
    return sign, {key: value for key, value in result.items() if value[1] != 0}
