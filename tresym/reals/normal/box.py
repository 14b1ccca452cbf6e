"""Prove the sign of a polynomial on a product of intervals."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import product
from math import inf

from flint import fmpq, fmpz_mpoly

from tresym.reals.normal.ring import Poly
from tresym.reals.numbers.exact import Interval
from tresym.reals.numbers.factoring import TooLargeError

MAX_QUADRATIC = 40
MAX_MAPPED = 400
"""The maximal number of terms of a quadratic, and of the result of a Möbius map."""
MAX_DEGREE = 300
"""The maximal degree in a variable with a range."""


REALS = Interval()
ROUNDING = 1e-9
"""The relative size of values that may be due to rounding."""
_SHARES = (0.5, 0.02, 0.9, 0.3, 0.99, 0.12, 0.75, 0.004, 0.62, 0.97)
PLACES = tuple(
    tuple(_SHARES[(n + j * (2 * n + 1) * (n > 0)) % len(_SHARES)] for j in range(8))
    for n in range(8)
)
"""Where a polynomial is looked at, variable by variable: ends, the middle, and mixtures."""
LOOKS = len(PLACES)


def sign_on_box(p: Poly, spans: list[Interval], start: int = 0) -> str | None:
    """Return the sign of ``p`` on a box, from its coefficients or as a quadratic in one variable.

    Args:
        p: the polynomial.
        spans: the range of each variable.
        start: the first variable in which the polynomial is treated as a quadratic.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"``, ``"<=0"``, or None if nothing is proved.
    """
    if p.is_zero():
        return "0"
    if _takes_both_signs(p, spans):
        return None
    sign = _by_coefficients(p, spans)
    if sign is None and len(p) <= MAX_QUADRATIC:
        for i in range(start, len(spans)):
            sign = sign or quadratic_sign(p, i, partial(sign_on_box, spans=spans, start=i + 1))
    return sign


def coefficient_sign(p: Poly, spans: list[Interval]) -> str | None:
    """The sign of all coefficients once every span is mapped to [0, ∞]."""
    return None if _takes_both_signs(p, spans) else _by_coefficients(p, spans)


def _takes_both_signs(p: Poly, spans: list[Interval]) -> bool:
    """Return whether ``p`` is seen to be positive and negative on the box, so that no proof exists.

    Most polynomials that are asked for have no sign, and a look at few points in floating point
    takes less time than every attempt at a proof. A value counts if it is far larger than its error
    can be.
    """
    used = [i for i, degree in enumerate(p.degrees()) if degree > 0]
    alike = len({value > 0 for value in p.coeffs()}) == 1
    if alike and all((low := spans[i].low) is not None and low >= 0 for i in used):
        return False
    seen: bool | None = None
    try:
        values = [float(int(value)) for value in p.coeffs()]
        powers = [[(i, int(m[i])) for i in used if m[i]] for m in p.monoms()]
        for n in range(LOOKS):
            at = {i: _inside(spans[i], PLACES[n][j % 8]) for j, i in enumerate(used)}
            total = size = 0.0
            for value, factors in zip(values, powers, strict=True):
                for i, k in factors:
                    value *= at[i] ** k
                total += value
                size += abs(value)
            if ROUNDING * size < abs(total) < inf:
                if seen is None:
                    seen = total > 0
                elif seen != (total > 0):
                    return True
    except OverflowError:  # too large for floating point
        pass
    return False


def _inside(span: Interval, share: float) -> float:
    """Return a point of a range, at a share of the way from its lower to its upper end."""
    low, high = span.low, span.high
    if low is not None and high is not None:
        start = int(low.p) / int(low.q)
        return start + share * (int(high.p) / int(high.q) - start)
    if low is not None:
        return int(low.p) / int(low.q) + share / (1 - share)
    if high is not None:
        return int(high.p) / int(high.q) - (1 - share) / share
    return (2 * share - 1) / (share - share**2)


def _by_coefficients(p: Poly, spans: list[Interval]) -> str | None:
    """Return the sign of all coefficients, as :func:`coefficient_sign` does."""
    degrees = p.degrees()
    used = [i for i, degree in enumerate(degrees) if degree > 0]
    free = [i for i in used if spans[i].low is None and spans[i].high is None]
    if free and any(int(m[i]) % 2 for m in p.monoms() for i in free):
        return None
    closed = [(i, [0]) for i in free]
    for i in used:
        low, high, low_open, high_open = spans[i]
        if low is None and high is None:
            continue
        try:
            p = on_orthant(p, i, low, high)
        except TooLargeError:
            return None
        first_open = high_open if low is None else low_open
        ends = [] if first_open else [0]
        if low is not None and high is not None and not high_open:
            ends.append(int(degrees[i]))
        if ends:
            closed.append((i, ends))
        if len(p) > MAX_MAPPED:
            return None
    if p.is_zero():
        return "0"  # the range is a single point, at which p vanishes
    signs = {value > 0 for value in p.coeffs()}
    if len(signs) != 1:
        return None
    up = "+" if True in signs else "-"
    monomials = p.monoms()
    for corner in product(*(ends for _, ends in closed)):
        fixed = [(i, k) for (i, _), k in zip(closed, corner, strict=True)]
        if not any(all(int(m[i]) == k for i, k in fixed) for m in monomials):
            return ">=0" if up == "+" else "<=0"
    return up


def quadratic_sign(p: Poly, i: int, ask: Callable[[Poly], str | None]) -> str | None:
    """Return the sign of ``a·u² + b·u + c`` from those of a, c and ``4ac − b²``.

    Args:
        p: a polynomial.
        i: the index of the variable; u is this variable or its square.
        ask: a function that returns the sign of a polynomial in the other variables.

    Returns:
        The sign, or None if it is not proved.
    """
    context, degree = p.context(), int(p.degrees()[i])
    if degree not in (2, 4):
        return None
    parts: dict[int, dict[tuple[int, ...], int]] = {}
    for monomial, value in p.terms():
        others = (*monomial[:i], 0, *monomial[i + 1 :])
        parts.setdefault(int(monomial[i]), {})[others] = value
    c, b, a = (context.from_dict(parts.pop(k, {})) for k in (0, degree // 2, degree))
    lead = None if parts else ask(a)
    if lead is None or lead == "0":
        return None
    rest = ask(4 * a * c - b * b)
    if rest == "+" and lead in ("+", "-"):
        return lead
    up = lead in ("+", ">=0")
    weak = ("+", ">=0", "0") if up else ("-", "<=0", "0")
    if rest in ("+", ">=0", "0") and (lead in ("+", "-") or ask(c) in weak):
        return ">=0" if up else "<=0"
    return None


def on_orthant(p: fmpz_mpoly, i: int, low: fmpq | None, high: fmpq | None) -> fmpz_mpoly:
    """Map the range of a variable to [0, ∞] by a Möbius substitution.

    With two finite ends, x = (low + high·u)/(1 + u), and the result is multiplied by a power of 1 +
    u. Otherwise x = low + u or x = high − u. So u = 0 corresponds to ``low``, or to ``high`` if
    ``low`` is None.

    Args:
        p: the polynomial.
        i: the index of the variable x.
        low: the lower end, or None for −∞.
        high: the upper end, or None for ∞. At least one end is finite.

    Returns:
        The polynomial in u ≥ 0, multiplied by a positive factor.

    Raises:
        TooLargeError: the degree in the variable is more than ``MAX_DEGREE``.
    """
    if high is None and low == 0:
        return p
    context = p.context()
    u = context.gen(i)
    if low is not None and high is not None:
        scale = low.q * high.q
        top, bottom = u * (high * scale).p + (low * scale).p, (u + 1) * scale
    elif low is not None:
        top, bottom = u * low.q + low.p, context.constant(low.q)
    else:
        assert high is not None
        top, bottom = high.p - u * high.q, context.constant(high.q)
    slope = p.derivative(i)
    if slope.is_zero():
        return p
    if slope.derivative(i).is_zero():
        return slope * top + (p - slope * u) * bottom
    coefficients = []
    while not p.is_zero():
        coefficients.append(p.subs({i: 0}))
        p = (p - coefficients[-1]) / u
        if len(coefficients) > MAX_DEGREE + 1:
            raise TooLargeError(
                f"a polynomial of degree over {MAX_DEGREE} in a variable with a range"
            )
    result = coefficients.pop()
    below = bottom
    for part in reversed(coefficients):
        result, below = result * top + part * below, below * bottom
    return result
