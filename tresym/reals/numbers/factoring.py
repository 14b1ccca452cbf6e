"""Factor integers and integer polynomials with FLINT, and verify the result.

A unit and factors whose product is not the input raise an error.
"""

from __future__ import annotations

from math import prod

from flint import fmpz, fmpz_mpoly

MOST_DEGREES = 2000
"""The maximal degree of a sum that is factored: beyond it FLINT may run for hours without
reacting to an interrupt."""
MAX_PRIME_BITS = 160
"""The maximal size of an integer that is factored."""


class TooLargeError(Exception):
    """Raised if a computation exceeds a limit on terms, degree or number of generators."""


def factors_of(p: fmpz_mpoly) -> tuple[fmpz, list[tuple[fmpz_mpoly, int]]]:
    """Return FLINT's unit and irreducible factors of ``p``.

    Returns:
        The unit, and pairs of a factor and its exponent.

    Raises:
        TooLargeError: the degree exceeds the limit, or the coefficients are too large for
            python-flint to sort the factors.
        ArithmeticError: the product of the factors is not ``p``.
    """
    if len(p) > 1 and p.total_degree() > MOST_DEGREES:
        raise TooLargeError(f"factoring a sum of degree over {MOST_DEGREES}")
    try:
        unit, found = p.factor()
    except OverflowError:
        raise TooLargeError("factoring a polynomial with too large coefficients") from None
    if prod((factor ** int(k) for factor, k in found), start=p.context().constant(unit)) != p:
        raise ArithmeticError("the product of the factors that FLINT returned is not the input")
    return unit, [(factor, int(k)) for factor, k in found]


def primes_of(n: fmpz) -> list[tuple[fmpz, int]]:
    """Return FLINT's prime factors of ``n`` > 0 with their exponents; itself if it is too large.

    Raises:
        ArithmeticError: the product of the factors is not ``n``.

    Example:
        >>> primes_of(fmpz(12))
        [(2, 2), (3, 1)]
    """
    if n.bit_length() > MAX_PRIME_BITS:
        return [(n, 1)]
    found = [(prime, int(k)) for prime, k in n.factor()]
    if prod((prime**k for prime, k in found), start=fmpz(1)) != n:
        raise ArithmeticError("the product of the factors that FLINT returned is not the input")
    return found
