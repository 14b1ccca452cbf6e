"""Factors multiply to what they are factors of, or there is the one error."""

from __future__ import annotations

import pytest
from flint import Ordering, fmpz_mpoly, fmpz_mpoly_ctx
from hypothesis import given
from hypothesis import strategies as st

from tresym.reals.numbers.factoring import TooLargeError, factors_of

CONTEXT = fmpz_mpoly_ctx.get(("x", "y"), Ordering.lex)
X, Y = CONTEXT.gens()
terms = st.dictionaries(
    st.tuples(st.integers(0, 2), st.integers(0, 2)), st.integers(-9, 9), min_size=1, max_size=4
)
polynomials = terms.map(CONTEXT.from_dict).filter(lambda p: not p.is_zero())


def product(p: fmpz_mpoly) -> fmpz_mpoly:
    unit, factors = factors_of(p)
    total = CONTEXT.constant(unit)
    for factor, power in factors:
        total *= factor**power
    return total


@given(polynomials, polynomials)
def test_the_factors_of_a_product_multiply_to_it(p: fmpz_mpoly, q: fmpz_mpoly) -> None:
    assert product(p * q * q) == p * q * q
    assert sum(power for _, power in factors_of(p * q)[1]) >= len(factors_of(p)[1])


def test_powers_are_counted() -> None:
    unit, factors = factors_of(-6 * (X - Y) ** 3 * (X + 1))
    assert abs(unit) == 6
    assert sorted(power for _, power in factors) == [1, 3]
    assert factors_of(CONTEXT.constant(-4)) == (-4, [])


@pytest.mark.parametrize("size", [10**30, 10**60])
def test_coefficients_that_cannot_be_sorted_raise_the_one_error(size: int) -> None:
    with pytest.raises(TooLargeError, match="too large"):
        factors_of((size * X + Y) * (X + size * Y))
    assert product(size * X**2 - size * Y**2) == size * X**2 - size * Y**2
