"""The Möbius map of a polynomial: a range of a variable becomes [0, ∞], and signs are kept."""

from __future__ import annotations

from flint import fmpq, fmpz_mpoly

from tresym.reals.numbers.factoring import TooLargeError

MAX_DEGREE = 1_000


def on_orthant(p: fmpz_mpoly, i: int, low: fmpq | None, high: fmpq | None) -> fmpz_mpoly:
    """``p`` times something positive, its ``i``-th variable x written as x = M(u), u ≥ 0.

    Where both ends are finite, M(u) = (low + high·u)/(1 + u), and ``p`` is multiplied by a power of
    1 + u; else M(u) = low + u or high − u. One end at least is finite; u = 0 is ``low``, but
    ``high`` where it stands alone.

    Raises:
        TooLargeError: a power of M of more than ``MAX_DEGREE`` would be multiplied out.
    """
    if (low != 0 or high is not None) and int(p.degrees()[i]) > MAX_DEGREE:
        raise TooLargeError("a range is mapped, and a power of it is too large")
    context = p.context()
    u, one = context.gen(i), context.constant(1)
    if low is not None and high is not None:
        scale = low.q * high.q
        top, bottom = one * (low * scale).p + u * (high * scale).p, (one + u) * scale
    elif low is not None:
        top, bottom = one * low.p + u * low.q, one * low.q
    else:
        assert high is not None
        top, bottom = one * high.p - u * high.q, one * high.q
    parts: dict[int, dict[tuple[int, ...], int]] = {}
    for monomial, value in p.terms():
        k = int(monomial[i])
        parts.setdefault(k, {})[(*monomial[:i], 0, *monomial[i + 1 :])] = value
    degree = max(parts, default=0)
    result = context.constant(0)
    for k, part in parts.items():
        result = result + context.from_dict(part) * top**k * bottom ** (degree - k)
    return result
