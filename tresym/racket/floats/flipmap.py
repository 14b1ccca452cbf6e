"""The flip of many starts at once, in float64.

Each start is computed by the closed form of :mod:`tresym.racket.floats.float_orbit`. There are no
special cases: every start is on a rotating or an oscillating orbit, and the separatrix is replaced
by an orbit so near to it that float64 cannot distinguish the two. For starts near the unstable
points Δψ has a small relative error. The result is NaN only for starts that do not exist.

Near the unstable points errors grow by e^(√(ab) Δφ) with any method; see
:func:`flip_uncertainty` for how accurately a float64 start determines its result.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tresym.racket.body import Exact
from tresym.racket.body import shape as exact_shape
from tresym.racket.floats import float_orbit
from tresym.racket.floats.float_orbit import LEVELS
from tresym.reals.numbers.exact import InputError

Floats = NDArray[np.float64]

CHUNK = 8192
"""Starts per pass, few enough that the arrays of one pass stay in the cache."""

WIDEST = 10**100
"""a and b must lie between this and its inverse, so that squares do not overflow."""


class Arrivals(NamedTuple):
    """Arrays of results: Δψ in radians, cos θ and sin θ, and the time passed in units of I₂/M."""

    turn: Floats
    handle: Floats
    level: Floats
    time: Floats


def flip_map(
    a: Exact | float,
    b: Exact | float,
    psi0: ArrayLike,
    rate: ArrayLike,
    precession: ArrayLike = 2 * math.pi,
) -> Floats:
    """Compute Δψ of each start (ψ₀, dψ/dφ) while φ increases by ``precession``.

    Args:
        a: I₂/I₁ − 1 > 0.
        b: 1 − I₂/I₃, in (0, 1].
        psi0: angles in radians; broadcast against ``rate`` and ``precession``.
        rate: dψ/dφ at the start.
        precession: Δφ in radians, of either sign; by default one full turn.

    Returns:
        Δψ in radians, float64 of the broadcast shape; NaN where no body of this shape has such a
        start, and where an array is masked.

    Raises:
        InputError: a or b out of range, or beyond 1e±100; starts that are not numbers.

    Example:
        >>> import tresym
        >>> [round(float(turn), 6) for turn in tresym.flip_map("1", "0.1", 1.5, [0.1, 0.2])]
        [0.329301, 0.612057]
    """
    p, q = _floats(a, b)
    starts, shape = _broadcast(psi0, rate, precession)
    found = np.empty(starts[0].size)
    for part, values in _in_chunks(float_orbit.turn, p, q, starts):
        found[part] = values
    return found.reshape(shape)


def arrivals(
    a: Exact | float, b: Exact | float, psi0: ArrayLike, rate: ArrayLike, precession: ArrayLike
) -> Arrivals:
    """Compute the end of the motion from each start; the arguments are as for :func:`flip_map`."""
    return Arrivals(*_arrive(*_floats(a, b), psi0, rate, precession)[:4])


def flip_uncertainty(
    a: Exact | float,
    b: Exact | float,
    psi0: ArrayLike,
    rate: ArrayLike,
    precession: ArrayLike = 2 * math.pi,
) -> Floats:
    """Estimate the error of :func:`flip_map` at each start, in radians, from above.

    The estimate assumes 64 roundings of each of a, b, ψ₀ and the rate, propagated by difference
    quotients of the map, and 64 roundings of the terms whose sum is Δψ. These numbers come from
    comparisons with balls.

    Returns:
        Infinity where the estimate exceeds 0.01: the orbit passes so close to an unstable point, or
        turns so often, that float64 starts do not determine the result.
    """
    p, q = _floats(a, b)
    psi, speed = _unmasked(psi0), _unmasked(rate)
    found = _arrive(p, q, psi, speed, precession)
    here, total, reach = found[0], found[4], found[5]
    step = 2.0**-42
    for change in np.eye(4):
        there = _changed(p, q, psi, speed, precession, 1 - step * change)
        if np.isnan(there).any():
            # Near the largest rate, the start may exist on one side only.
            other = _changed(p, q, psi, speed, precession, 1 + step * change)
            there = np.where(np.isnan(there), other, there)
        total = total + np.abs(there - here) / step
    # On an oscillating orbit the error is at most the range of ψ.
    error = np.minimum(64 * np.finfo(float).eps * total, 2 * reach)
    error = np.where(np.isnan(error) | (error > 0.01), np.inf, error)
    return np.where(np.isnan(here), np.nan, error)


def _changed(
    a: float, b: float, psi: Floats, rate: Floats, precession: ArrayLike, factors: Floats
) -> Floats:
    changed = a * factors[0], min(b * factors[1], 1.0), psi * factors[2], rate * factors[3]
    return flip_map(*changed, precession)


def _floats(a: Exact | float, b: Exact | float) -> tuple[float, float]:
    """The shape in float64; exact input is checked before it is rounded."""
    from fractions import Fraction

    a, b = (float(x) if isinstance(x, np.floating) else x for x in (a, b))
    if not all(math.isfinite(x) for x in (a, b) if isinstance(x, float)):
        raise InputError("flip map: a and b must be finite")
    shape = exact_shape(*(Fraction(x) if isinstance(x, float) else x for x in (a, b)))
    if not (shape.a < WIDEST and shape.a * WIDEST > 1 and shape.b * WIDEST > 1):
        raise InputError("flip map: a or b is beyond 1e±100; use flip_angle for such a shape")
    return int(shape.a.p) / int(shape.a.q), int(shape.b.p) / int(shape.b.q)


def _arrive(
    a: float, b: float, psi: ArrayLike, rate: ArrayLike, precession: ArrayLike
) -> tuple[Floats, ...]:
    """All six results of :func:`tresym.racket.floats.float_orbit.arrive`, for broadcast starts."""
    starts, shape = _broadcast(psi, rate, precession)
    found = np.empty((6, starts[0].size))
    for part, values in _in_chunks(float_orbit.arrive, a, b, starts):
        found[:, part] = values
    return tuple(row.reshape(shape) for row in found)


def _broadcast(*given: ArrayLike) -> tuple[list[Floats], tuple[int, ...]]:
    """Flat arrays of equal length, and their broadcast shape."""
    arrays = [_unmasked(x) for x in given]
    try:
        same = np.broadcast_arrays(*arrays)
    except ValueError as error:
        raise InputError(f"flip map: {error}") from None
    return [np.ascontiguousarray(x).ravel() for x in same], same[0].shape


def _unmasked(x: ArrayLike) -> Floats:
    """An array of floats, NaN where it is masked.

    Raises:
        InputError: it is not an array of real numbers.
    """
    try:
        if x is None or np.iscomplexobj(x):  # None would be NaN
            raise TypeError
        if isinstance(x, np.ma.MaskedArray):
            return np.asarray(np.ma.filled(x.astype(np.float64), np.nan))
        return np.asarray(x, dtype=np.float64)
    except (TypeError, ValueError, OverflowError):
        raise InputError("flip map: starts and precession are real numbers, or arrays") from None


def _in_chunks(
    work: Callable[..., Any], a: float, b: float, starts: list[Floats]
) -> Iterator[tuple[slice, Any]]:
    """Each part of the starts, with the result of ``work`` for it."""
    room = np.empty((5, LEVELS + 1, min(CHUNK, starts[0].size)))
    for part in _parts(starts[0].size, CHUNK):
        with np.errstate(all="ignore"):
            values = work(a, b, *(x[part] for x in starts), room[:, :, : part.stop - part.start])
        yield part, values


def _parts(size: int, step: int) -> Iterator[slice]:
    return (slice(i, min(i + step, size)) for i in range(0, size, step))
