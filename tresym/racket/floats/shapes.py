"""ε₀ of arrays of shapes, in float64.

The phase P = π + arctan(r tanh kP), k = √(ab), r = √(b/a), is computed by two steps of Halley's
method from a rational initial value, the first with a rough arctangent. The last step is applied to
sinh kP by the addition theorem, so that no function is evaluated twice.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import numpy as np
from numpy.typing import ArrayLike, NDArray

Floats = NDArray[np.float64]

CHUNK = 8192
"""Shapes per pass, few enough that the arrays of one pass stay in the cache."""


def defects(a: ArrayLike, b: ArrayLike) -> Floats:
    """Return ε₀ (radians) of each shape, with a relative error of about 2e-15 · (1 + π√(ab)).

    Returns:
        NaN unless a > 0 and 0 < b ≤ 1. Values below 1e-300 may underflow to 0.
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
    step, _ = _halley(phase, k, r, _rough_arctan)
    phase -= step
    step, tangent = _halley(phase, k, r, np.arctan)
    # sinh and 1 over cosh kP after the step, which is below 1e-4.
    small = k * step
    hyperbolic = tangent * (1 + small * small / 2) - small * (1 + small * small / 6)
    exponential = np.exp(-k * phase)
    ratio = 2 * exponential / (1 + exponential * exponential) / (np.sqrt(1 + r * r) * hyperbolic)
    return np.where(valid, np.arctan(ratio), np.nan)


def _guess(k: Floats, r: Floats) -> Floats:
    """P to a few parts in a thousand, without a transcendental function."""
    x = 3.3 * k
    square = x * x
    ratio = r * np.minimum(x * (27 + square) / (27 + 9 * square), 1.0)
    inner, outer = ratio / (1 + 0.28 * ratio * ratio), ratio / (ratio * ratio + 0.28)
    return np.pi + np.where(ratio < 1, inner, np.pi / 2 - outer)


def _rough_arctan(x: Floats) -> Floats:
    """arctan x for x ≥ 0, to 1e-5 (Abramowitz and Stegun 4.4.49)."""
    turned = x > 1
    y = np.where(turned, 1 / x, x)
    s = y * y
    y = y * (0.9998660 + s * (-0.3302995 + s * (0.1801410 + s * (-0.0851330 + s * 0.0208351))))
    return np.where(turned, np.pi / 2 - y, y)


def _halley(phase: Floats, k: Floats, r: Floats, arctan: Callable[[Floats], Floats]) -> Any:
    """The step of Halley's method for P − π − arctan(r tanh kP), and tanh kP."""
    rest = -np.expm1(-2 * k * phase)
    tangent = rest / (2 - rest)
    ratio = r * tangent
    over = 1 / (1 + ratio * ratio)
    sech2 = (1 - tangent) * (1 + tangent)
    residual = phase - np.pi - arctan(ratio)
    falling = k * r * sech2 * over
    slope = 1 - falling
    bend = 2 * k * falling * tangent * (1 + r * r * sech2 * over)
    newton = residual / slope
    return newton / (1 - newton * bend / (2 * slope)), tangent
