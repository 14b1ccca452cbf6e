"""The flip of very many starts at once, in float64.

The closed form of :mod:`tresym.flip.float_orbit`, start by start. There are no special cases: every
start is on a rotating or an oscillating orbit, and the separatrix is taken as an orbit so near to
it that float64 cannot tell. Starts near the unstable points have a Δψ accurate relative to itself.
NaN is said only where no such start exists.

With the extra ``tresym[fast]`` large maps run compiled, on all cores; the answers are the same up
to the last digits. Near the unstable points errors grow by e^(√(ab) Δφ) whatever the method;
how far a float64 start determines its answer is what :func:`flip_uncertainty` says.
"""

from __future__ import annotations

import math
import os
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tresym.body import Exact
from tresym.body import shape as exact_shape
from tresym.flip import float_orbit
from tresym.flip.float_orbit import LEVELS

Floats = NDArray[np.float64]

CHUNK = 2048
"""Starts per pass: what is needed of one pass stays in the cache."""

LARGE = 50_000
"""Starts from which a map is worth the second it takes to load numba."""


class Arrivals(NamedTuple):
    """Arrays of ends: Δψ in radians, cos θ and sin θ, and the time passed in units of I₂/M."""

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
    """Δψ (radians) of each start (ψ₀, dψ/dφ) after ``precession`` radians of φ.

    Args:
        a: I₂/I₁ − 1 > 0.
        b: 1 − I₂/I₃, in (0, 1].
        psi0: angles in radians; broadcast against ``rate`` and ``precession``.
        rate: dψ/dφ at the start.
        precession: Δφ, of either sign.

    Returns:
        Float64 of the broadcast shape; NaN where no body of this shape has such a start.

    Raises:
        InputError: a or b out of range.
    """
    return arrivals(a, b, psi0, rate, precession).turn


def arrivals(
    a: Exact | float, b: Exact | float, psi0: ArrayLike, rate: ArrayLike, precession: ArrayLike
) -> Arrivals:
    """Where each start comes to; arguments as for :func:`flip_map`."""
    return Arrivals(*_arrive(*_floats(a, b), psi0, rate, precession)[:4])


def flip_uncertainty(
    a: Exact | float,
    b: Exact | float,
    psi0: ArrayLike,
    rate: ArrayLike,
    precession: ArrayLike = 2 * math.pi,
) -> Floats:
    """The error of :func:`flip_map` at each start, in radians: an estimate that errs upwards.

    64 roundings of each of a, b, ψ₀ and the rate, carried to the result by the map's own
    derivatives, as differences; and 64 of what is added up to Δψ. The counts are from comparisons
    with balls. Infinite above 0.01: the orbit passes so close to an unstable point, or turns so
    often, that float64 starts do not determine the answer.
    """
    p, q = _floats(a, b)
    psi, speed = np.asarray(psi0, dtype=np.float64), np.asarray(rate, dtype=np.float64)
    found = _arrive(p, q, psi, speed, precession)
    here, total, reach = found[0], found[4], found[5]
    step = 2.0**-42
    for change in np.eye(4):
        there = _changed(p, q, psi, speed, precession, 1 - step * change)
        if np.isnan(there).any():
            # Next to the largest rate the start may exist on one side only.
            other = _changed(p, q, psi, speed, precession, 1 + step * change)
            there = np.where(np.isnan(there), other, there)
        total = total + np.abs(there - here) / step
    # On an oscillating orbit no answer is off by more than the range of ψ.
    error = np.minimum(64 * np.finfo(float).eps * total, 2 * reach)
    error = np.where(np.isnan(error) | (error > 0.01), np.inf, error)
    return np.where(np.isnan(here), np.nan, error)


def _changed(
    a: float, b: float, psi: Floats, rate: Floats, precession: ArrayLike, factors: Floats
) -> Floats:
    changed = a * factors[0], min(b * factors[1], 1.0), psi * factors[2], rate * factors[3]
    return _arrive(*changed, precession)[0]


def _floats(a: Exact | float, b: Exact | float) -> tuple[float, float]:
    """The shape in float64; what is given exactly is checked exactly."""
    from fractions import Fraction

    given = [Fraction(x) if isinstance(x, float) else x for x in (a, b)]
    shape = exact_shape(*given)
    return int(shape.a.p) / int(shape.a.q), int(shape.b.p) / int(shape.b.q)


def _arrive(
    a: float, b: float, psi: ArrayLike, rate: ArrayLike, precession: ArrayLike
) -> tuple[Floats, ...]:
    """All six numbers of :func:`tresym.flip.float_orbit.arrive`, for broadcast starts."""
    given = [np.asarray(x, dtype=np.float64) for x in (psi, rate, precession)]
    starts = np.broadcast_arrays(*given)
    flat = [np.ascontiguousarray(x).ravel() for x in starts]
    found = np.empty((6, flat[0].size))
    compiled = _compiled() if found.shape[1] >= LARGE else None
    if compiled is None:
        _in_chunks(a, b, flat, found)
    else:
        _in_threads(compiled, a, b, flat, found)
    return tuple(row.reshape(starts[0].shape) for row in found)


def _compiled() -> Callable[..., None] | None:
    """The compiled map, or None without numba."""
    try:
        from tresym.flip.compiled import arrive_each
    except ImportError:
        return None
    return arrive_each


def _in_chunks(a: float, b: float, starts: list[Floats], found: Floats) -> None:
    work = np.empty((5, LEVELS + 1, min(CHUNK, found.shape[1])))
    with np.errstate(all="ignore"):
        for part in _parts(found.shape[1], CHUNK):
            size = part.stop - part.start
            psi, rate, precession = (x[part] for x in starts)
            room = work[:, :, :size]
            found[:, part] = float_orbit.arrive(a, b, psi, rate, precession, room)


def _in_threads(
    arrive_each: Callable[..., None], a: float, b: float, starts: list[Floats], found: Floats
) -> None:
    workers = os.cpu_count() or 1

    def fill(part: slice) -> None:
        work = np.empty((5, LEVELS + 1))
        arrive_each(a, b, *(x[part] for x in starts), work, found[:, part])

    with ThreadPoolExecutor(workers) as pool:
        list(pool.map(fill, _parts(found.shape[1], -(-found.shape[1] // (4 * workers)))))


def _parts(size: int, step: int) -> Iterator[slice]:
    return (slice(i, min(i + step, size)) for i in range(0, size, step))
