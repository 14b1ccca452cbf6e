"""Prove the sign of a polynomial on a product of intervals."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from itertools import product

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
    sign = coefficient_sign(p, spans)
    if sign is None and len(p) <= MAX_QUADRATIC:
        for i in range(start, len(spans)):
            sign = sign or quadratic_sign(p, i, partial(sign_on_box, spans=spans, start=i + 1))
    return sign


def coefficient_sign(p: Poly, spans: list[Interval]) -> str | None:
    """The sign of all coefficients once every span is mapped to [0, ∞]."""
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
    coefficients = []
    while not p.is_zero():
        coefficients.append(p.subs({i: 0}))
        p = (p - coefficients[-1]) / u
        if len(coefficients) > MAX_DEGREE + 1:
            raise TooLargeError(
                f"a polynomial of degree over {MAX_DEGREE} in a variable with a range"
            )
    result = coefficients.pop() if coefficients else context.constant(0)
    below = bottom
    for part in reversed(coefficients):
        result, below = result * top + part * below, below * bottom
    return result
