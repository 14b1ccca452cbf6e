"""Decide exactly whether algebraic numbers, sums of arc tangents or of logarithms vanish.

The constant generators (roots of integers, possibly nested, and 2cos(π/M)) are algebraic integers.
Let x be an algebraic integer of degree at most d whose conjugates have absolute value at most B.
Its norm is an integer, so that x is zero or |x| ≥ B^(1−d). A ball below that bound therefore proves
x = 0.
"""

from __future__ import annotations

from collections.abc import Iterable

from flint import arb, fmpq, fmpz

from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Fraction, Poly, Ring
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import rational_ends
from tresym.reals.numbers.factoring import TooLargeError

MAX_BITS = 150_000
MAX_MULTIPLE = 200


def is_algebraic(ring: Ring, position: int) -> bool:
    """Return whether a generator is a constant algebraic integer."""
    generator = ring.at(position)
    if generator.kind == "cosine":
        return True
    return generator.kind == "root" and all(
        is_algebraic(ring, i) for i in ring.used(generator.data[0])
    )


def vanishes(ring: Ring, p: Poly) -> bool:
    """Return whether ``p`` is zero when the relations between its algebraic constants are used."""
    return all(algebraic_zero(ring, part) for part in coefficients(ring, p))


def coefficients(ring: Ring, p: Poly) -> Iterable[Poly]:
    """Return the coefficients of ``p`` as a polynomial in its generators that are not algebraic."""
    return ring.grouped(p, [i for i in ring.used(p) if not is_algebraic(ring, i)]).values()


def algebraic_zero(ring: Ring, p: Poly) -> bool:
    """Return whether the algebraic integer ``p`` is proved to be zero."""
    if p.is_zero():
        return True
    if p.is_constant():
        return False
    with ball_precision(64):
        if not ring.ball(p).contains(0):
            return False
        degree = 1
        for i in _involved(ring, p):
            degree *= next(n for position, n, _ in ring.relations if position == i)
        size = _house(ring, p).log().upper() / arb.const_log2() * (degree - 1)
        highest = rational_ends(size).high
    if highest is None or highest > MAX_BITS:
        return False
    bits = max(int(highest.floor()) + 2, 2)
    with ball_precision(bits + 128):
        value = abs(ring.ball(p))
        return bool(value < arb(2) ** (-bits))


def _involved(ring: Ring, p: Poly) -> set[int]:
    """Return the generators in ``p`` and inside its roots."""
    positions: set[int] = set()
    for i in ring.used(p):
        positions.add(i)
        if ring.at(i).kind == "root":
            positions |= _involved(ring, ring.at(i).data[0])
    return positions


def _house(ring: Ring, p: Poly) -> arb:
    """Return a bound on the absolute value of every conjugate of ``p``, at least 1."""
    sizes: dict[int, arb] = {}
    for i in ring.used(p):
        generator = ring.at(i)
        if generator.kind == "cosine":
            sizes[i] = arb(2)
        else:
            sizes[i] = _house(ring, generator.data[0]).root(generator.data[1])
    total = arb(0)
    for monomial, value in p.terms():
        term = arb(abs(value))
        for i, size in sizes.items():
            term = term * size ** int(monomial[i])
        total = total + term
    return arb(1).max(total.upper())


def settled(field: Field, x: Fraction, functions: bool = False) -> Fraction:
    """``x`` with the combinations of logarithms and arc tangents that are known replaced.

    A sum Σ nᵢ log|fᵢ| is 0 where Π fᵢ^nᵢ = ±1. A sum Σ nᵢ atan uᵢ of constants is kπ/12, its
    ball singles out k, where Π (1 + i·uᵢ)^nᵢ exp(−ikπ/12) has a vanishing imaginary part.

    Args:
        functions: ``x`` is not a constant: only logarithms are replaced.
    """
    x = _without_groups(field, x, "log")
    return x if functions else _without_groups(field, x, "atan")


def _without_groups(field: Field, x: Fraction, kind: str) -> Fraction:
    for _ in range(8):
        for factor, terms in _groups(field.ring, x, kind):
            value = _log_sum(field.ring, terms) if kind == "log" else _atan_sum(field, terms)
            if value is not None:
                for position, n in terms.items():
                    value = value - field.ring.fraction(field.ring.at(position)) * n
                x = x + field.ring.make(factor, x.den) * value
                break
        else:
            return x
    return x


def _groups(ring: Ring, x: Fraction, kind: str) -> list[tuple[Poly, dict[int, fmpz]]]:
    """Return monomials of ``x`` with the integer combination of ``kind`` generators each
    multiplies.
    """
    positions = [i for i in ring.used(x.num) if ring.at(i).kind == kind]
    groups: dict[tuple[int, ...], dict[int, fmpz]] = {}
    for monomial, value in x.num.terms():
        present = [i for i in positions if monomial[i]]
        if sum(int(monomial[i]) for i in present) == 1:
            rest = tuple(0 if i in present else int(k) for i, k in enumerate(monomial))
            groups.setdefault(rest, {})[present[0]] = value
    combinations = []
    for rest, terms in groups.items():
        content = fmpz(0)
        for value in terms.values():
            content = content.gcd(value)
        reduced = {i: value // content for i, value in terms.items()}
        if all(abs(n) <= MAX_MULTIPLE for n in reduced.values()):
            combinations.append((ring.context.from_dict({rest: content}), reduced))
    return combinations


def _log_sum(ring: Ring, terms: dict[int, fmpz]) -> Fraction | None:
    """Return 0 if the sum of multiples of logarithms is shown to be 0, else None."""
    product = ring.one
    try:
        for position, n in terms.items():
            base = ring.fraction(ring.at(position).data[0])
            product = product * base ** int(n)
    except TooLargeError:
        return None
    for sign in (1, -1):
        if vanishes(ring, ring.reduce(product.num - sign * product.den)):
            return ring.zero
    return None


def _atan_sum(field: Field, terms: dict[int, fmpz]) -> Fraction | None:
    """Return the multiple of π/12 that equals a sum of arc tangents of constants, or None."""
    real, imaginary = field.ring.one, field.ring.zero
    total = arb(0)
    try:
        for position, n in terms.items():
            u = field.ring.at(position).data[0]
            if not field.ring.is_constant(u):
                return None
            total = total + field.ring.ball(u).atan() * n
            v = u if n > 0 else -u
            for _ in range(abs(int(n))):
                real, imaginary = real - imaginary * v, imaginary + real * v
    except TooLargeError:
        return None
    k = (12 * total / arb.pi()).unique_fmpz()
    if k is None:
        return None
    c, s = field.angles.turn_of_pi(fmpq(k, 12))
    rest = imaginary * c - real * s
    return field.angles.pi(fmpq(k, 12)) if vanishes(field.ring, rest.num) else None
