"""Propose simpler forms of nested radicals and factors; :mod:`.factors` verifies them.

Where a root makes the factorisation ambiguous, a factor is replaced by its norm and its conjugate.
A nested square root is written with simpler ones where its norm is a square.
"""

from __future__ import annotations

from collections.abc import Callable

from flint import fmpq, fmpz

from tresym.reals.normal.ring import Poly, Ring, small_factor
from tresym.reals.numbers.factoring import primes_of

CONJUGATE_TERMS = 10
Factored = tuple[fmpz, list[tuple[Poly, int]]]


def canonical(ring: Ring, f: Poly, factor: Callable[[Poly], Factored]) -> Factored:
    """Write an irreducible ``f`` by its norm and conjugate where a root makes factors ambiguous.

    Args:
        ring: the ring of ``f``.
        f: an irreducible polynomial.
        factor: the canonical factors of a smaller polynomial.

    Returns:
        A unit and factors with exponents, which may be negative. They are a proposal to be
            verified.
    """
    if len(f) == 1 or len(f) > CONJUGATE_TERMS or ring.is_inverse(f):
        return fmpz(1), [(f, 1)]
    denested = _denested(ring, f, factor)
    if denested is not None:
        return denested
    for position, degree, _ in ring.relations:
        if degree != 2 or f.degrees()[position] != 1 or ring.at(position).kind != "root":
            continue
        parts = ring.split(f, position)
        if len(parts) != 2:
            continue
        x = ring.variables[position]
        base = ring.at(position).data[0]
        if parts[0].gcd(base) == base:
            square = ring.reduce(x * x)
            sign = square // base
            rest = (parts[0] // base) * sign * x + parts[1]
            unit, inner = factor(rest)
            return unit, [(x, 1), *inner]
        if parts[0].leading_coefficient() * parts[1].leading_coefficient() > 0:
            continue
        conjugate = parts[0] - parts[1] * x
        norm = ring.reduce(f * conjugate)
        if norm.is_zero() or ring.is_mixed(norm) or norm.gcd(conjugate) != ring.one_poly:
            continue
        unit, inner = factor(norm)
        if conjugate.leading_coefficient() < 0:
            conjugate, unit = -conjugate, -unit
        return unit, [*inner, (conjugate, -1)]
    return fmpz(1), [(f, 1)]


def _denested(ring: Ring, f: Poly, factor: Callable[[Poly], Factored]) -> Factored | None:
    """Write ``p + q·A`` as ``(p + n + q·A)²/(2(p + n))`` if its norm ``p² − q²A²`` is ``n²``."""
    for position, degree, _ in ring.relations:
        if degree % 2 or ring.at(position).kind != "root" or f.degrees()[position] < degree // 2:
            continue
        parts = ring.split(f, position)
        if set(parts) != {0, degree // 2}:
            continue
        p, surd = parts[0], parts[degree // 2] * ring.variables[position] ** (degree // 2)
        n = _square_root(ring, ring.reduce(p**2 - surd**2))
        if n is None or (p + n).is_zero() or (p - n).is_zero():
            continue
        half = min((p + n, p - n), key=lambda s: (s.total_degree(), len(s), str(s)))
        if ring.is_mixed(half):
            continue
        unit, factors = factor(half + surd)
        below, others = factor(half)
        number = fmpq(unit**2, 2 * abs(below))
        primes = [(ring.context.constant(prime), k) for prime, k in primes_of(number.p)]
        primes += [(ring.context.constant(prime), -k) for prime, k in primes_of(number.q)]
        squares = [(part, 2 * k) for part, k in factors]
        inverse = [(part, -k) for part, k in others]
        return fmpz(1 if below > 0 else -1), [*primes, *squares, *inverse]
    return None


def _square_root(ring: Ring, p: Poly) -> Poly | None:
    """Return a polynomial whose square is ``p``, or None."""
    if p.is_zero() or len(p) > CONJUGATE_TERMS:
        return None
    constant = p.is_constant()
    unit, parts = (p.leading_coefficient(), []) if constant else small_factor(ring, p)
    if unit < 0 or not unit.is_square() or any(k % 2 for _, k in parts):
        return None
    result = ring.context.constant(unit.isqrt())
    for part, k in parts:
        result = result * part ** (k // 2)
    return result
