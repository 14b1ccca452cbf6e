"""The Möbius map: values keep their signs, and the ends of the range are 0 and infinity."""

import pytest
from flint import Ordering, fmpq, fmpz_mpoly, fmpz_mpoly_ctx

from tresym.reals.normal.box import MAX_DEGREE, on_orthant
from tresym.reals.numbers.factoring import TooLargeError

CONTEXT = fmpz_mpoly_ctx.get(["x", "y"], Ordering.lex)
X, Y = CONTEXT.gens()
POLYNOMIALS = [X**3 * Y - 2 * X + 5, X**2 - Y, 7 * X, Y**2 + 1, CONTEXT.constant(0)]


def _at(p: fmpz_mpoly, x: fmpq, y: fmpq) -> fmpq:
    return sum((fmpq(c) * x ** int(m[0]) * y ** int(m[1]) for m, c in p.terms()), fmpq(0))


@pytest.mark.parametrize(
    ("low", "high"),
    [
        (fmpq(1, 2), fmpq(3)),
        (fmpq(-2, 3), None),
        (None, fmpq(5, 7)),
        (fmpq(0), None),
        (fmpq(0), fmpq(0)),
    ],
)
@pytest.mark.parametrize("p", POLYNOMIALS, ids=str)
def test_values_keep_their_signs(p: fmpz_mpoly, low: fmpq | None, high: fmpq | None) -> None:
    q = on_orthant(p, 0, low, high)
    for u in (fmpq(0), fmpq(1, 3), fmpq(4), fmpq(1000)):
        if low is None or high is None:
            x = high - u if low is None else low + u
        else:
            x = (low + high * u) / (1 + u)
        for y in (fmpq(-3), fmpq(2, 5)):
            before, after = _at(p, x, y), _at(q, u, y)
            assert (before > 0) == (after > 0)
            assert (before < 0) == (after < 0)


def test_no_power_is_multiplied_out_beyond_the_limit() -> None:
    p = X ** (MAX_DEGREE + 1) - Y
    assert on_orthant(p, 0, fmpq(0), None) == p
    assert on_orthant(X**MAX_DEGREE, 0, fmpq(1), None).degrees()[0] == MAX_DEGREE
    for ends in ((fmpq(1), None), (fmpq(0), fmpq(1)), (None, fmpq(0))):
        with pytest.raises(TooLargeError):
            on_orthant(p, 0, *ends)
