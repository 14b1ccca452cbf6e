"""ε₀ of very many shapes at once, in float64: what an array of shapes takes instead of a loop.

The phase P = π + arctan(r tanh kP), k = √(ab), r = √(b/a), from a rational guess by two of Halley's
steps. Everything comes from E = e^(−2kP) and one arctangent a step; the last step is carried into
sinh kP by the addition theorem, so nothing is evaluated twice.
"""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

CHUNK = 8192
"""Shapes per pass: what is needed of one pass stays in the cache."""


def defects(a: ArrayLike, b: ArrayLike) -> Floats:
    """ε₀ (radians) of each shape a > 0, 0 < b ≤ 1, to some 2e-15 · (1 + π√(ab)) of itself.

    Below 1e-300 it may underflow to 0; outside the range of a and b the answer is NaN.
    """
    with np.errstate(all="ignore"):
        p, q = np.broadcast_arrays(np.asarray(a, np.float64), np.asarray(b, np.float64))
        first, second = p.ravel(), q.ravel()
        found = np.empty(first.size)
        for i in range(0, first.size, CHUNK):
            part = slice(i, i + CHUNK)
            found[part] = _chunk(first[part], second[part])
    return found.reshape(p.shape)


def _chunk(a: Floats, b: Floats) -> Floats:
    valid = (a > 0) & (b > 0) & (b <= 1)
    k, r = np.sqrt(a) * np.sqrt(b), np.sqrt(b / a)
    phase = _guess(k, r)
    for _ in range(2):
        exponential = np.exp(-2 * k * phase)
        rest = -np.expm1(-2 * k * phase)
        step, tangent = _halley(phase, k, r, exponential, rest)
        phase = phase - step
    # sinh k(P − step) / cosh kP: the step is below 1e-4.
    small = k * step
    hyperbolic = tangent * (1 + small * small / 2) - small * (1 + small * small / 6)
    size = np.exp(-k * (phase + step)) / (1 + exponential) * 2
    defect = np.arctan2(size, np.sqrt(1 + r * r) * hyperbolic)
    return np.where(valid, defect, np.nan)


def _guess(k: Floats, r: Floats) -> Floats:
    """P to a few parts in a thousand without a transcendental function."""
    x = 3.3 * k
    ratio = r * (x * (27 + x * x) / (27 + 9 * x * x))
    ratio = np.minimum(ratio, r)
    inner, outer = ratio / (1 + 0.28 * ratio * ratio), ratio / (ratio * ratio + 0.28)
    return np.pi + np.where(ratio < 1, inner, np.pi / 2 - outer)


def _halley(phase: Floats, k: Floats, r: Floats, exponential: Floats, rest: Floats) -> Any:
    """The step of Halley's method for P − π − arctan(r tanh kP), and tanh kP."""
    tangent = rest / (1 + exponential)
    ratio = r * tangent
    over = 1 / (1 + ratio * ratio)
    sech2 = (1 - tangent) * (1 + tangent)
    residual = phase - np.pi - np.arctan(ratio)
    falling = k * r * sech2 * over
    slope = 1 - falling
    bend = 2 * k * falling * tangent * (1 + r * r * sech2 * over)
    newton = residual / slope
    return newton / (1 - newton * bend / (2 * slope)), tangent
