"""Compute a rational sample point in every cell of an open cylindrical decomposition.

The algorithm projects with leading coefficients, discriminants and resultants, isolates the real
roots of the univariate polynomials, and lifts. Every connected region where none of the polynomials
vanishes contains at least one of the points (McCallum 1993; Strzeboński 2000).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import pairwise

from flint import fmpq, fmpz_mpoly, fmpz_mpoly_ctx, fmpz_poly

from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.numbers.factoring import TooLargeError, factors_of

MAX_POLYNOMIALS = 40
MAX_DEGREE = 40
MOST_BITS = 10**6
"""Degree times bits of a coefficient of the polynomials whose roots are computed."""


def _everything(point: tuple[fmpq, ...]) -> bool:
    """Accept every point."""
    return True


def sample_points(
    polynomials: list[fmpz_mpoly],
    context: fmpz_mpoly_ctx,
    wanted: Callable[[tuple[fmpq, ...]], bool] = _everything,
) -> Iterator[tuple[fmpq, ...]]:
    """Yield sample points of all open cells of ``polynomials``.

    Args:
        polynomials: the polynomials, whose signs are constant on every cell.
        context: their ring; the points have coordinates in the order of its variables.
        wanted: decides from the first coordinates of a point whether to continue above it.

    Raises:
        TooLargeError: the projections have too many polynomials or too high a degree.
    """
    levels = [_irreducible(polynomials)]
    for variable in range(context.nvars() - 1, 0, -1):
        levels.append(_projection(levels[-1], variable))
    levels.reverse()
    yield from _lift(levels, (), wanted)


def _irreducible(polynomials: list[fmpz_mpoly]) -> list[fmpz_mpoly]:
    """Return the irreducible factors, or raise if they are too many or too large."""
    factors: dict[str, fmpz_mpoly] = {}
    for p in polynomials:
        if p.is_zero() or p.is_constant():
            continue
        for factor, _ in factors_of(p)[1]:
            factors[str(factor)] = factor
    if len(factors) > MAX_POLYNOMIALS or any(
        p.total_degree() > MAX_DEGREE for p in factors.values()
    ):
        raise TooLargeError(
            f"a decomposition by more than {MAX_POLYNOMIALS} polynomials "
            f"or by one of degree over {MAX_DEGREE}"
        )
    return list(factors.values())


def _projection(polynomials: list[fmpz_mpoly], variable: int) -> list[fmpz_mpoly]:
    """Eliminate a variable by leading coefficients, discriminants and resultants."""
    result = [p for p in polynomials if p.degrees()[variable] == 0]
    active = [p for p in polynomials if p.degrees()[variable] > 0]
    for i, p in enumerate(active):
        result.append(_lead(p, variable))
        if p.degrees()[variable] > 1:
            result.append(p.discriminant(variable))
        result.extend(p.resultant(q, variable) for q in active[:i])
    return _irreducible(result)


def _lead(p: fmpz_mpoly, variable: int) -> fmpz_mpoly:
    """Return the leading coefficient in a variable."""
    degree = p.degrees()[variable]
    context = p.context()
    return context.from_dict(
        {(*m[:variable], 0, *m[variable + 1 :]): c for m, c in p.terms() if m[variable] == degree}
    )


def _lift(
    levels: list[list[fmpz_mpoly]],
    point: tuple[fmpq, ...],
    wanted: Callable[[tuple[fmpq, ...]], bool],
) -> Iterator[tuple[fmpq, ...]]:
    """Yield the sample points above ``point``."""
    if not wanted(point):
        return
    k = len(point)
    if k == len(levels):
        yield point
        return
    product = fmpz_poly([1])
    for p in levels[k]:
        line = _restricted(p, point)
        if line.degree() > 0:
            product = product * (line // line.gcd(product))
    for value in between(product):
        yield from _lift(levels, (*point, value), wanted)


def _restricted(p: fmpz_mpoly, point: tuple[fmpq, ...]) -> fmpz_poly:
    """Return ``p`` on the line above ``point``, with denominators cleared."""
    k = len(point)
    coefficients: dict[int, fmpq] = {}
    for monomial, value in p.terms():
        term = fmpq(value)
        for x, n in zip(point, monomial, strict=False):
            term *= x ** int(n)
        coefficients[int(monomial[k])] = coefficients.get(int(monomial[k]), fmpq(0)) + term
    scale = fmpq(1)
    for value in coefficients.values():
        scale *= value.q
    degree = max(coefficients)
    return fmpz_poly([(coefficients.get(i, fmpq(0)) * scale).p for i in range(degree + 1)])


def between(p: fmpz_poly) -> list[fmpq]:
    """Return a simple rational in each interval between the real roots of ``p``.

    Raises:
        TooLargeError: two roots are too close to be separated.
    """
    if p.degree() < 1:
        return [fmpq(0)]
    if p.degree() * max(int(c).bit_length() for c in p.coeffs()) > MOST_BITS:
        raise TooLargeError("a polynomial is too large for its roots to be computed")
    squarefree = p // p.gcd(p.derivative())
    with ball_precision(128):
        roots = [root.real for root, _ in squarefree.complex_roots() if root.imag.is_zero()]
        roots.sort(key=lambda x: x.mid())
        if not roots:
            return [fmpq(0)]
        ends = [(None, None), *((x.lower().fmpq(), x.upper().fmpq()) for x in roots), (None, None)]
    gaps = [Interval(low, high, True, True) for (_, low), (high, _) in pairwise(ends)]
    if any(not gap.low < gap.high for gap in gaps[1:-1]):
        raise TooLargeError("a polynomial has real roots that are too close to be separated")
    middles = [gap.simplest() for gap in gaps]
    if not all(gap.holds(x) for gap, x in zip(gaps, middles, strict=True)):
        raise TooLargeError("no rational point was found between two roots of a polynomial")
    return middles
