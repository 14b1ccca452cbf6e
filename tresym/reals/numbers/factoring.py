"""Factors of integer polynomials, and the one error for what outgrows its bounds."""

from __future__ import annotations

from flint import fmpz, fmpz_mpoly


class TooLargeError(Exception):
    """The normal form outgrew its bounds or ran out of generators."""


def factors_of(p: fmpz_mpoly) -> tuple[fmpz, list[tuple[fmpz_mpoly, int]]]:
    """FLINT's unit and factors of ``p``.

    Raises:
        TooLargeError: python-flint cannot sort factors whose coefficients differ by more than a
            machine integer.
    """
    try:
        return p.factor()
    except OverflowError:
        raise TooLargeError("coefficients too large for the factors to be sorted") from None
