"""Prove that every point of the conditions is a limit of interior points.

A proof in the interior of the conditions extends to such limits by continuity, but not to isolated
points: ``x**2*(x - 1) >= 0`` also holds at x = 0, which is not a limit of interior points. A proof
under closed conditions therefore counts only where one of these criteria excludes isolated points:

- Every closed condition is concave (``x + y <= 1``, ``abs(x) <= y``, ``x**2 + y**2 <= 1``).
  Together with the ranges of the variables they describe a convex set, which has interior points.
- The closed conditions are polynomials in one variable with simple zeros and no common zero.
- All closed conditions that depend on some variable increase strictly in it, and the others are
  ranges of other variables. A small step in this variable leads into the interior (``x*y >= 1``
  with y > 0).
- One closed condition is strictly convex in a variable, and the others are ranges of other
  variables. A small step in one of the two directions leads into the interior (``b**2 >= 4*a*c``).
- There is only one closed condition, and it is a polynomial of degree 2 (``x*y >= 0``).

Strict conditions describe an open set and change nothing here, as long as the domain of their
operations is open. The domain of a root is not: ``sqrt(x**2*(x - 1)) < 5`` holds at the isolated
point x = 0. So "the radicand is not negative" is treated as one more closed condition.
"""

from __future__ import annotations

from contextlib import suppress
from functools import lru_cache, reduce
from itertools import combinations
from math import prod

from flint import fmpq, fmpq_mat, fmpz_poly

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.functions.table import names
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import Expr, number, symbol, symbols
from tresym.reals.language.like_terms import scaled
from tresym.reals.normal.polynomials import degree, polynomial
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import PROVING, REMEMBERED, jumps
from tresym.reals.signs.interior import sign_inside as sign
from tresym.reals.signs.structural import WEAK, Parts

MAX_QUADRATIC = 5
"""The maximal number of variables of a quadratic condition."""

ONLY_INSIDE = (
    "the claim holds in the interior of the conditions and at limits of interior points, but a "
    "condition with >= or <= may also hold at isolated points, where nothing is proved; write the "
    "conditions with > or < to exclude such points"
)
"""The reason given when a proof is not enough because :func:`is_regular` is false."""

_SMOOTH = {"+", "*"} | names(lambda row: row.smooth)
"""Operations that have a derivative wherever they are defined."""


@lru_cache(maxsize=REMEMBERED)
def is_regular(given: Given) -> bool:
    """Return whether every point of the conditions is shown to be a limit of interior points."""
    given = _without_implied(given)
    spoken_of = tuple(c.expression for c in given.conditions)
    if jumps(spoken_of, given):
        return False
    needed = [part for part in needs(spoken_of) if sign(part[0], Given()) not in PROVING[part[1]]]
    if any(e.loose for e, _ in needed):  # it speaks of a bound variable
        return False
    given = given & Given(tuple(bound(*part) for part in needed))
    closed = [c.expression for c in given.beyond_box if c.relation == ">="]
    if not closed or all(map(_is_concave, closed)):
        return True
    everything = [c.expression for c in given.conditions if c.relation == ">="]
    names = sorted(frozenset().union(*map(symbols, closed)))
    if len(names) == 1:
        return _has_simple_zeros([e for e in everything if symbols(e) == set(names)], given)
    if any(_rise_together(everything, closed, x, way, given) for x in names for way in "+-"):
        return True
    return len(closed) == 1 and (
        (len(everything) == 1 and _is_quadratic(closed[0]))
        or any(_is_convex_in(x, everything, given) for x in names)
    )


@lru_cache(maxsize=REMEMBERED)
def has_inside(given: Given) -> bool:
    """Return whether a point is found that satisfies every condition strictly.

    The conditions ``x >= y, y >= x`` have no such point, so that every statement about their
    interior is true and proves nothing.
    """
    atoms = Parts(Given()).atoms
    with suppress(TooLargeError, UndefinedError):
        closed = [atoms.of(c.expression) for c in given.conditions if c.relation == ">="]
        keys = {x.key for x in closed}
        if any((-x).key in keys for x in closed):
            return False
    return next(given.points((), 1), None) is not None


def _without_implied(given: Given) -> Given:
    """Remove products ``p >= 0`` that follow from the other conditions."""
    for n, condition in enumerate(given.conditions):
        if condition.relation == ">=" and condition.expression.op == "*":
            others = Given(given.comparisons[:n] + given.comparisons[n + 1 :])
            if Parts(others).sign(condition.expression) in WEAK:
                return _without_implied(others)
    return given


def _is_concave(e: Expr) -> bool:
    """Return whether ``e`` is a concave polynomial of degree at most 2 minus ``|linear|`` terms."""
    plain = number(0)
    for term in e.args if e.op == "+" else (e,):
        factor, inner = scaled(term)
        if inner.op != "abs":
            plain = plain + term
        elif factor > 0 or not _is_linear(inner.args[0]):
            return False
    return _is_linear(plain) or _is_concave_polynomial(plain)


def _is_linear(e: Expr) -> bool:
    """Return whether ``e`` is linear in its symbols; its coefficients may be any constants."""
    return not any(symbols(differentiate(e, x)) for x in symbols(e))


def _is_concave_polynomial(e: Expr) -> bool:
    """Return whether ``e`` is a concave polynomial of degree at most 2."""
    terms = polynomial(e)
    if terms is None or any(degree(m) > 2 for m in terms):
        return False
    used = sorted({name for m in terms if degree(m) == 2 for name, _ in m})
    if len(used) > MAX_QUADRATIC:
        return False
    # The negated Hessian is positive semidefinite iff no principal minor is negative.
    curved = fmpq_mat(len(used), len(used))
    for monomial, value in terms.items():
        at = [name for name, k in monomial for _ in range(k)]
        if len(at) == 2:
            row, column = (used.index(name) for name in at)
            curved[row, column] -= value
            curved[column, row] -= value
    return all(
        fmpq_mat([[curved[i, j] for j in kept] for i in kept]).det() >= 0
        for size in range(1, len(used) + 1)
        for kept in combinations(range(len(used)), size)
    )


def _has_simple_zeros(closed: list[Expr], given: Given) -> bool:
    """Return whether these polynomials in one variable have simple zeros and no common zero.

    Zeros of odd order are allowed as well, and zeros of even order where the conditions exclude
    them.
    """
    seen: list[fmpz_poly] = []
    for e in dict.fromkeys(closed):
        terms = polynomial(e)
        if terms is None:
            return False
        common = prod((value.q for value in terms.values()), start=fmpq(1))
        coefficients = {degree(m): (value * common).p for m, value in terms.items()}
        p = fmpz_poly([coefficients.get(k, 0) for k in range(max(coefficients, default=0) + 1)])
        for factor, power in p.factor()[1] if terms else ():
            values = (number(fmpq(c)) for c in reversed(factor.coeffs()))
            part = reduce(lambda total, c: total * symbol(*symbols(e)) + c, values)
            if power % 2 and factor in seen:
                return False
            if power % 2 == 0 and sign(part, given) not in ("+", "-"):
                return False
            seen += [factor] * (power % 2)
    return True


def _rise_together(
    everything: list[Expr], closed: list[Expr], x: str, way: str, given: Given
) -> bool:
    """Return whether a small step of ``x`` leads inside all closed conditions that depend on it."""
    if any(x not in symbols(e) for e in closed):
        return False
    return all(
        _is_smooth(e, given) and sign(differentiate(e, x), given) == way
        for e in everything
        if x in symbols(e)
    ) and all(_is_smooth(c.expression, given) for c in given.beyond_box)


def _is_quadratic(e: Expr) -> bool:
    """Return whether ``e`` is a polynomial of degree at most 2.

    If it is not concave, it increases along some line, so that its zeros are limits of interior
    points.
    """
    terms = polynomial(e)
    return terms is not None and all(degree(m) <= 2 for m in terms)


def _is_convex_in(x: str, everything: list[Expr], given: Given) -> bool:
    """Return whether exactly one closed condition depends on ``x`` and is strictly convex in it."""
    depending = [e for e in everything if x in symbols(e)]
    if len(depending) != 1:
        return False
    second = differentiate(differentiate(depending[0], x), x)
    smooth = all(_is_smooth(c.expression, given) for c in given.beyond_box)
    return smooth and sign(second, given) == "+"


def _is_smooth(e: Expr, given: Given) -> bool:
    """Whether ``e`` is shown to have a derivative wherever it is defined."""
    if e.op in ("number", "symbol", "pi"):
        return True
    if e.op == "^":
        base, exponent = e.args
        whole = exponent.op == "number" and exponent.args[0].q == 1
        return _is_smooth(base, given) and (
            whole or (_is_smooth(exponent, given) and sign(base, given) == "+")
        )
    return e.op in _SMOOTH and all(_is_smooth(arg, given) for arg in e.args)
