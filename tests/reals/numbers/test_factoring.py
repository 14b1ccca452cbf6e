"""Factors multiply to what they are factors of, or there is the one error."""

from typing import Any

import pytest
from flint import Ordering, fmpz, fmpz_mpoly, fmpz_mpoly_ctx
from hypothesis import given
from hypothesis import strategies as st

from tresym.checking.dispatch import decide_claim
from tresym.reals.numbers.factoring import TooLargeError, factors_of, primes_of
from tresym.reals.verdict import Verdict

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


class Lying:
    """A number or polynomial that is not the product of what it says are its factors."""

    def __init__(self, truth: Any, found: Any) -> None:
        self.truth, self.found = truth, found

    def __eq__(self, other: object) -> bool:
        return bool(self.truth == other)

    def factor(self) -> Any:
        return self.found

    def context(self) -> Any:
        return CONTEXT

    def bit_length(self) -> int:
        return 4

    def __len__(self) -> int:
        return 1


P = 6 * (X - Y) ** 2 * (X + 1)


@pytest.mark.parametrize(
    "found",
    [
        (fmpz(6), [(X - Y, 2)]),
        (fmpz(6), [(X - Y, 1), (X + 1, 1)]),
        (fmpz(-6), [(X - Y, 2), (X + 1, 1)]),
        (fmpz(6), [(X - Y, 2), (X + 1, 1), (X, 1)]),
    ],
)
def test_what_is_no_factorisation_is_not_believed(found: Any) -> None:
    assert factors_of(Lying(P, P.factor()))[0] == 6
    with pytest.raises(ArithmeticError):
        factors_of(Lying(P, found))


@pytest.mark.parametrize("found", [[(2, 2)], [(2, 1), (3, 1)], [(2, 2), (3, 1), (5, 1)]])
def test_what_are_no_prime_factors_is_not_believed(found: Any) -> None:
    assert primes_of(fmpz(12)) == [(2, 2), (3, 1)]
    assert primes_of(fmpz(6) ** 200) == [(fmpz(6) ** 200, 1)]
    with pytest.raises(ArithmeticError):
        primes_of(Lying(fmpz(12), found))


def test_a_sum_of_high_degree_is_refused_before_flint_is_asked() -> None:
    """FLINT does not end on it, and is deaf meanwhile; the claim comes to such a one."""
    high = 2 * X**20002 * Y**4 - 2 * X**12006 * Y**8 + 2 * X**11994 - 2 * X**3998 * Y**4
    with pytest.raises(TooLargeError, match="2000"):
        factors_of(high)
    assert sorted(k for _, k in factors_of(X**20002 * Y)[1]) == [1, 20002]
    claim = "sinh(max(2 - x, 2*x + 1/1000)) != sinh(4001/3000)"
    assert decide_claim(claim, "-2 <= x <= 2").verdict is Verdict.REFUTED
