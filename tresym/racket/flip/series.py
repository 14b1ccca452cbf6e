"""The flip defect to all orders in ε*: ε₀ = ε*(1 + c₁ε*² + c₂ε*⁴ + …), with exact coefficients.

With R = b/a the exact separatrix equation is log(ε₀/ε*) = Q(ε₀²), where

    2w Q′(w) = 1 − (1 − b sin²e) (e/sin e) (1 + R sin²e)^(−1/2),      w = e²,   Q(0) = 0,

so ε₀² is the root w of w = y exp 2Q(w), y = ε*². Lagrange inversion gives the coefficients
c_n = [wⁿ] exp((2n+1) Q(w)) / (2n+1), polynomials of degree n in b and R.

*Size of the coefficients.* Every Taylor coefficient of 1 − 2wQ′ is bounded in absolute value by
that of (1 + bS)(√w/sin √w)(1 − RS)^(−1/2) with S = sinh²√w. Hence those of Q are bounded by those
of a function M with M(ρ) = q = ½[(1 + bS)(√ρ/sin √ρ)(1 − RS)^(−1/2) − 1] and S = sinh²√ρ, if RS < 1
and ρ ≤ 1 (:func:`majorant`).
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache
from typing import TYPE_CHECKING, Any

from flint import arb, fmpq, fmpq_mpoly, fmpq_mpoly_ctx

from tresym.racket.formulas import stable
from tresym.reals.language.expression import number, trees
from tresym.reals.numbers.arithmetic import to_mp

if TYPE_CHECKING:
    from sympy.polys.rings import PolyElement


@lru_cache(maxsize=8)
def coefficients(order: int) -> tuple[fmpq_mpoly, ...]:
    """Return c₀ = 1, c₁, …, c_order as exact polynomials in b and R = b/a, by python-flint."""
    ring = fmpq_mpoly_ctx.get(("b", "R"), "deglex")
    b, R = ring.gens()
    return tuple(_lagrange(order, b, R, ring.constant(1), lambda q: q))


def coefficients_sympy(order: int) -> tuple[PolyElement, ...]:
    """Return the same coefficients in SymPy's ring ℚ[b, R], computed by SymPy."""
    from sympy import QQ
    from sympy.polys.rings import ring

    made, b, R = ring("b, R", QQ)
    return tuple(_lagrange(order, b, R, made.one, lambda q: QQ(int(q.p), int(q.q))))


def _lagrange(order: int, b: Any, R: Any, one: Any, number: Callable[[fmpq], Any]) -> list[Any]:
    """c₀ … c_order over any ring that contains b, R and the rationals ``number`` makes."""
    slopes = _slope_series(order, b, R, one, number)
    found = []
    for n in range(order + 1):
        power = [one]  # exp((2n+1) Q) by its differential equation, term by term
        for i in range(1, n + 1):
            total = sum((slopes[j] * power[i - j] for j in range(1, i + 1)), start=0 * one)
            power.append(total * number(fmpq(2 * n + 1, 2 * i)))
        found.append(power[n] * number(fmpq(1, 2 * n + 1)))
    return found


def _slope_series(order: int, b: Any, R: Any, one: Any, number: Callable[[fmpq], Any]) -> list[Any]:
    """The coefficients of 2w Q′(w) up to w^order."""
    sinc, term = [fmpq(1)], fmpq(1)
    for n in range(1, order + 1):
        term = -term / (2 * n * (2 * n + 1))
        sinc.append(term)
    powers = [_reciprocal(sinc)]  # (e/sin e) sin²ʲe
    square = [fmpq(0), *_product(sinc, sinc)[:order]]
    for _ in range(order + 1):
        powers.append(_product(powers[-1], square))
    slopes = [0 * one]
    for n in range(1, order + 1):
        total, binomial = 0 * one, fmpq(1)
        for j in range(n + 1):
            even, odd = powers[j][n] * binomial, powers[j + 1][n] * binomial
            total += R**j * (number(odd) * b - number(even) * one)
            binomial = binomial * (fmpq(-1, 2) - j) / (j + 1)
        slopes.append(total)
    return slopes


def _product(u: list[fmpq], v: list[fmpq]) -> list[fmpq]:
    """The product of two power series of equal length, to that length."""
    return [sum((u[j] * v[n - j] for j in range(n + 1)), start=fmpq(0)) for n in range(len(u))]


def _reciprocal(u: list[fmpq]) -> list[fmpq]:
    """The reciprocal of a power series with constant term 1."""
    found = [fmpq(1)]
    for n in range(1, len(u)):
        found.append(-sum((u[j] * found[n - j] for j in range(1, n + 1)), start=fmpq(0)))
    return found


def _number(q: fmpq, m: Any) -> Any:
    """An exact rational in the arithmetic ``m``."""
    if m is trees:
        return number(q)
    if hasattr(m, "Rational"):
        return m.Rational(int(q.p), int(q.q))
    if hasattr(m, "mpf"):
        return to_mp(q, m)
    if hasattr(m, "float64"):
        return int(q.p) / int(q.q)
    return arb(q)


@lru_cache(maxsize=8)
def exponent_coefficients(order: int) -> tuple[fmpq_mpoly, ...]:
    """Return q₀ = 0, q₁ = c₁, …, q_order of Q(w) = Σ q_n wⁿ as exact polynomials in b and R."""
    ring = fmpq_mpoly_ctx.get(("b", "R"), "deglex")
    b, R = ring.gens()
    slopes = _slope_series(order, b, R, ring.constant(1), lambda q: q)
    return (slopes[0], *(slope / fmpq(2 * n) for n, slope in enumerate(slopes[1:], 1)))


@lru_cache(maxsize=64)
def _rows(
    family: Callable[[int], tuple[fmpq_mpoly, ...]], order: int
) -> tuple[tuple[tuple[fmpq, ...], ...], ...]:
    """For each polynomial of the family, the n-th of degree n, up to ``order``: for each power of b
    the coefficients of the powers of R, lowest first.
    """
    found = []
    for n, polynomial in enumerate(family(order)):
        table = [[fmpq(0)] * (n + 1 - i) for i in range(n + 1)]
        for (i, j), c in polynomial.to_dict().items():
            table[int(i)][int(j)] = c
        found.append(tuple(tuple(row) for row in table))
    return tuple(found)


def coefficient_values(order: int, b: Any, R: Any, m: Any) -> list[Any]:
    """Return c₀ … c_order at (b, R) in the arithmetic ``m``, by Horner's rule."""
    return _values(coefficients, order, b, R, m)


def exponent_values(order: int, b: Any, R: Any, m: Any) -> list[Any]:
    """Return q₀ … q_order at (b, R) in the arithmetic ``m``."""
    return _values(exponent_coefficients, order, b, R, m)


def _values(
    family: Callable[[int], tuple[fmpq_mpoly, ...]], order: int, b: Any, R: Any, m: Any
) -> list[Any]:
    return [
        _horner([_horner([_number(c, m) for c in row], R) for row in rows], b)
        for rows in _rows(family, order)
    ]


def _horner(terms: list[Any], x: Any) -> Any:
    total = terms[-1]
    for c in reversed(terms[:-1]):
        total = total * x + c
    return total


def expansion(order: int, a: Any, b: Any, m: Any) -> Any:
    """Return ε*(1 + c₁ε*² + … + c_order ε*^{2·order}) in radians."""
    leading = stable.leading_term(m.sqrt(a * b), m.sqrt(b / a), m)
    return leading * _horner(coefficient_values(order, b, b / a, m), leading**2)


def majorant(rho: Any, b: Any, R: Any, m: Any) -> Any:
    """Return q, a bound of |Q(w)| on |w| = ρ ≤ 1; not a number unless R sinh²√ρ < 1."""
    root = m.sqrt(rho)
    square = m.sinh(root) ** 2
    return ((1 + b * square) * (root / m.sin(root)) / m.sqrt(1 - R * square) - 1) / 2
