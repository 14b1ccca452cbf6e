"""Factor integers and integer polynomials, and verify the result.

What FLINT finds is not believed: a unit and factors that do not give the product are an error.
"""

from __future__ import annotations

from math import prod

from flint import fmpz, fmpz_mpoly

MOST_DEGREES = 2000
"""Of a sum to be factored: beyond, FLINT may not end for hours, and hears no interrupt."""


class TooLargeError(Exception):
    """The normal form outgrew its bounds or ran out of generators."""


def factors_of(p: fmpz_mpoly) -> tuple[fmpz, list[tuple[fmpz_mpoly, int]]]:
    """FLINT's unit and factors of ``p``.

    Raises:
        TooLargeError: the degree is beyond the limit, or python-flint cannot sort the factors,
            whose coefficients differ by more than a machine integer.
        ArithmeticError: these are not its factors.
    """
    if len(p) > 1 and p.total_degree() > MOST_DEGREES:
        raise TooLargeError(f"a sum with powers beyond {MOST_DEGREES} is not factored")
    try:
        unit, found = p.factor()
    except OverflowError:
        raise TooLargeError("coefficients too large for the factors to be sorted") from None
    if prod((factor ** int(k) for factor, k in found), start=p.context().constant(unit)) != p:
        raise ArithmeticError("what was found are no factors")
    return unit, [(factor, int(k)) for factor, k in found]


def primes_of(n: fmpz) -> list[tuple[fmpz, int]]:
    """FLINT's prime factors of ``n`` > 0.

    Raises:
        ArithmeticError: these are not its factors.
    """
    found = [(prime, int(k)) for prime, k in n.factor()]
    if prod((prime**k for prime, k in found), start=fmpz(1)) != n:
        raise ArithmeticError("what was found are no factors")
    return found
