"""The flip of very many starts at once, in float64.

The same closed form as :mod:`tresym.flip.orbit`, start by start: Gauss transformation for the
phases, theta series for Jacobi's functions, Newton's method in the time u. There are no special
cases: every start is on a rotating or an oscillating orbit, and the separatrix is taken as an orbit
so near to it (1 − k² = 1e-280) that float64 cannot tell. Starts near the unstable points have a Δψ
accurate relative to itself. NaN is said only where no such start exists.

Near the unstable points errors grow by e^(√(ab) Δφ) whatever the method; how far a float64 start
determines its answer is what :func:`flip_uncertainty` says.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import ArrayLike, NDArray

from tresym.body import Exact
from tresym.body import shape as exact_shape
from tresym.flip.carlson import Amplitude, by_gauss

Floats = NDArray[np.float64]

CHUNK = 4096
"""Starts per pass: what is needed of one pass stays in the cache."""

FLOOR = 1e-280
"""The least k² and 1 − k²; below, float64 sees no difference in any angle."""

LINEAR = 1e-9
"""Angles below which the motion about an unstable point is linear to float64 accuracy."""


class _Orbits(NamedTuple):
    """Arrays of orbits, with the names of :mod:`tresym.flip.orbit`; ``unit``: ψ − π/2 from u."""

    rotating: Any
    speed: Floats
    characteristic: Floats
    modulus: Floats
    complement: Floats
    sine_scale: Floats
    cosine_scale: Floats


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
    p, q = _floats(a, b)
    given = [np.asarray(x, dtype=np.float64) for x in (psi0, rate, precession)]
    starts = np.broadcast_arrays(*given)
    shape = starts[0].shape
    psi, speed, turns = (x.ravel() for x in starts)
    found = np.empty((4, psi.size))
    with np.errstate(all="ignore"):
        for i in range(0, psi.size, CHUNK):
            part = slice(i, i + CHUNK)
            found[:, part] = _chunk(p, q, psi[part], speed[part], turns[part])
    return Arrivals(*(row.reshape(shape) for row in found))


def flip_uncertainty(
    a: Exact | float,
    b: Exact | float,
    psi0: ArrayLike,
    rate: ArrayLike,
    precession: ArrayLike = 2 * math.pi,
) -> Floats:
    """The error to expect of :func:`flip_map` at each start (an estimate, not a bound; radians).

    512 √(1 + a/1000) roundings of each of a, b, ψ₀, the rate and Δψ, carried to the result by the
    map's own derivatives, as differences; the count is from a comparison with balls. Infinite
    above 0.01: the orbit passes so close to an unstable point, or turns so often, that float64
    starts do not determine the answer.
    """
    p, q = _floats(a, b)
    psi, speed = np.asarray(psi0, dtype=np.float64), np.asarray(rate, dtype=np.float64)
    here = flip_map(p, q, psi, speed, precession)
    step = 2.0**-42
    total = np.abs(here)
    for change in np.eye(4):
        there = _changed(p, q, psi, speed, precession, 1 - step * change)
        if np.isnan(there).any():
            # Next to the largest rate the start may exist on one side only.
            other = _changed(p, q, psi, speed, precession, 1 + step * change)
            there = np.where(np.isnan(there), other, there)
        total = total + np.abs(there - here) / step
    error = 512 * math.sqrt(1 + p / 1000) * np.finfo(float).eps * total
    return np.where(error > 0.01, np.inf, error)


def _changed(
    a: float, b: float, psi: Floats, rate: Floats, precession: ArrayLike, factors: Floats
) -> Floats:
    return flip_map(
        a * factors[0],
        min(b * factors[1], 1.0),
        psi * factors[2],
        rate * factors[3],
        precession,
    )


def _floats(a: Exact | float, b: Exact | float) -> tuple[float, float]:
    """The shape in float64; what is given exactly is checked exactly."""
    from fractions import Fraction

    given = [Fraction(x) if isinstance(x, float) else x for x in (a, b)]
    shape = exact_shape(*given)
    return int(shape.a.p) / int(shape.a.q), int(shape.b.p) / int(shape.b.q)


def _chunk(a: float, b: float, psi: Floats, rate: Floats, precession: Floats) -> Arrivals:
    sine, cosine = np.sin(psi), np.cos(psi)
    scale, clock = a + b * sine * sine, (1 - b) + b * cosine * cosine
    moment = rate * clock
    handle = moment / scale
    rest = (scale - moment) * (scale + moment) / (scale * scale)
    exists = rest >= -8 * np.finfo(float).eps
    rest = np.maximum(rest, 0.0)
    rise, fall = np.abs(handle) * np.sqrt(scale), math.sqrt(b) * np.abs(sine)
    gamma = (rise - fall) * (rise + fall)
    below, above = rest * scale, rise * rise + b * cosine * cosine
    orbits = _orbits(a, b, gamma, below, above)
    # By symmetry: rotating orbits with ψ increasing, and 0 ≤ ψ ≤ π.
    mirror = np.where(orbits.rotating & (handle < 0), -1.0, 1.0)
    side = np.where(mirror * sine < 0, -1.0, 1.0)
    up, along = np.abs(sine), side * cosine
    at = _entry(a, b, orbits.rotating, above, up, along, np.abs(handle), rest, orbits.modulus)
    far = Amplitude(1.0, np.zeros_like(up), np.sqrt(orbits.complement), orbits.modulus)
    quarter_time, quarter_phase = _times(a, b, orbits, far)
    times = _times(a, b, orbits, at)
    back = ~orbits.rotating & (handle < 0)
    begin_time, begin_phase = (
        np.where(back, 2 * far - np.copysign(x, -along), np.copysign(x, -along))
        for far, x in zip((quarter_time, quarter_phase), times, strict=True)
    )
    end = begin_phase + precession
    halves = np.rint(end / (2 * quarter_phase))
    time = _invert(a, b, orbits, end - 2 * halves * quarter_phase, quarter_time, quarter_phase)
    there = _jacobi(orbits, time)
    turned = np.where(~orbits.rotating & (halves % 2 == 1), -1.0, 1.0)
    x = orbits.cosine_scale * np.where(orbits.rotating, there.cn, there.dn)
    y = turned * orbits.sine_scale * there.sn
    base0, offset0 = _from_saddle(along, up)
    base1, offset1 = _from_saddle(-y, x)
    whole = np.where(orbits.rotating, halves, 0.0) + (base1 - base0)
    turn = mirror * (math.pi * whole + (offset1 - offset0))
    turn = _linear(a, b, sine, cosine, rate, precession, turn)
    tilt = mirror * turned * np.where(orbits.rotating, there.dn, there.cn)
    found = (
        turn,
        np.sqrt(above / (a + b)) * tilt,
        np.sqrt(below / (a + b * x * x / (x * x + y * y))),
        (time + 2 * halves * quarter_time - begin_time) / orbits.speed,
    )
    return Arrivals(*(np.where(exists, value, np.nan) for value in found))


def _orbits(a: float, b: float, gamma: Floats, below: Floats, above: Floats) -> _Orbits:
    rotating = gamma >= 0
    square = np.where(rotating, a * above, b * below)
    other = np.where(rotating, b * below, a * above)
    return _Orbits(
        rotating,
        np.sqrt(square),
        np.where(rotating, b / a, above / below),
        np.maximum(other / square, FLOOR),
        np.maximum(np.abs(gamma) * (a + b) / square, FLOOR),
        np.sqrt(np.where(rotating, a + b, above * (a + b))),
        np.sqrt(np.where(rotating, a, b * below)),
    )


def _entry(
    a: float,
    b: float,
    rotating: Any,
    above: Floats,
    up: Floats,
    along: Floats,
    handle: Floats,
    rest: Floats,
    modulus: Floats,
) -> Amplitude:
    """The amplitude of a start with sin ψ, cos ψ, |cos θ| and sin²θ; sn is taken positive."""
    root, long = np.sqrt(a + b * up * up), np.abs(along)
    upright, level = math.sqrt(a + b) * up / root, handle * np.sqrt((a + b) / above)
    sn = np.where(rotating, math.sqrt(a) * long / root, long * np.sqrt(b * rest / above))
    return Amplitude(
        np.minimum(sn, 1.0),
        np.where(rotating, upright, level),
        np.where(rotating, level, upright),
        modulus,
    )


def _from_saddle(cosine: Floats, sine: Floats) -> tuple[Floats, Floats]:
    """An angle from 0 to π as the nearer end, in half turns from π/2, and the offset from there."""
    angle = np.arctan2(sine, np.abs(cosine))
    before = cosine >= 0
    return np.where(before, -0.5, 0.5), np.where(before, angle, -angle)


def _near(ratio: Floats) -> float | None:
    """End the Gauss transformation when nobody gains from another step."""
    return 1.0 if np.nanmax(np.abs(ratio), initial=0.0) < 1e-8 else None


def _times(a: float, b: float, orbits: _Orbits, at: Amplitude) -> tuple[Floats, Floats]:
    """u and φ at an amplitude with sn ≥ 0."""
    n = orbits.characteristic
    found = by_gauss(at._replace(sn=np.maximum(at.sn, 1e-100)), n, np, _near)
    return found.time, ((1 - b) * found.time + (a + b) * n * found.third) / orbits.speed


def _jacobi(orbits: _Orbits, time: Floats) -> Amplitude:
    """sn, cn, dn at |u| ≤ K: the theta series of :mod:`tresym.flip.jacobi`, terms above 1e-16."""
    k, k1 = np.sqrt(orbits.modulus), np.sqrt(orbits.complement)
    direct, dual = _mean(k1), _mean(k)
    hyperbolic = k1 <= k
    at = np.empty((3, time.size))
    for kind, series in ((hyperbolic, _hyperbolic), (~hyperbolic, _circular)):
        if kind.any():
            at[:, kind] = series(k[kind], k1[kind], direct[kind], dual[kind], time[kind])
    return Amplitude(at[0], at[1], at[2], orbits.modulus)


def _mean(x: Floats) -> Floats:
    """The arithmetic-geometric mean of 1 and x."""
    high, low = np.ones_like(x), x
    for _ in range(16):
        high, low = (high + low) / 2, np.sqrt(high * low)
        if not np.any(high - low > 1e-8 * high):
            break
    return (high + low) / 2


def _circular(k: Floats, k1: Floats, direct: Floats, dual: Floats, time: Floats) -> Any:
    q = np.exp(-math.pi * direct / dual)
    root = np.sqrt(np.sqrt(q))
    sine, cosine = np.sin(direct * time), np.cos(direct * time)
    # Multiples of the argument; U with sin 3ζ = sine · U₂ and so on.
    c2 = 1 - 2 * sine * sine
    c4, c6 = 2 * c2 * c2 - 1, c2 * (4 * c2 * c2 - 3)
    q2, q4 = q * q, (q * q) ** 2
    odd = q * (c2 + q4 * q4 * c6)
    even = q4 * c4
    three, four = 1 + 2 * (odd + even), 1 - 2 * (odd - even)
    one = sine * (1 - q2 * (1 + 2 * c2) + q4 * q2 * (1 + 2 * c2 + 2 * c4))
    two = cosine * (1 + q2 * (2 * c2 - 1) + q4 * q2 * (1 - 2 * c2 + 2 * c4))
    ratio = 2 * root / np.sqrt(k)
    return ratio * one / four, ratio * np.sqrt(k1) * two / four, np.sqrt(k1) * three / four


def _hyperbolic(k: Floats, k1: Floats, direct: Floats, dual: Floats, time: Floats) -> Any:
    """With y the argument, E = e^(−2|y|), w = q e^(2|y|) ≤ 1: every series divided by e^|y|/2."""
    y = dual * np.abs(time)
    log_nome = -math.pi * dual / direct
    q, log_w = np.exp(log_nome), 2 * y + log_nome
    w, e = np.exp(log_w), np.exp(-2 * y)
    e2, q2 = e * e, q * q
    e4, qw, q4w2 = e2 * e2, q * w, (q2 * w) ** 2
    last, e7 = (qw * q2) ** 3, e4 * e2 * e
    one = -np.expm1(-2 * y) - qw * (1 - e2 * e) + q4w2 * (1 - e4 * e) - last * (1 - e7)
    two = 1 + e + qw * (1 + e2 * e) + q4w2 * (1 + e4 * e) + last * (1 + e7)
    first, second, third = w * e2, (qw) ** 2 * (1 + e4), (q2 * w) ** 3 * (1 + e4 * e2)
    three = 1 + w + first + second + third
    four = -np.expm1(log_w) - first + second - third
    root = np.sqrt(np.sqrt(q))
    half = np.exp(-y) / root
    sn = np.copysign(one / two / np.sqrt(k), time)
    return sn, half * np.sqrt(k1 / k) * four / two, half * np.sqrt(k1) * three / two


def _invert(
    a: float, b: float, orbits: _Orbits, phase: Floats, far_time: Floats, far_phase: Floats
) -> Floats:
    """u with φ(u) = ``phase``, |u| ≤ K, by Newton's method.

    φ is convex in u > 0 with (1−b)/ω ≤ φ′ ≤ 1/ω, so after one step the iterates come down to the
    root from above; bounds from both ends keep them in the quarter.
    """
    goal = np.abs(phase)
    low = np.maximum(orbits.speed * goal, 0.0)
    high = np.maximum(far_time - orbits.speed * np.maximum(far_phase - goal, 0.0), low)
    time = np.clip(goal * far_time / far_phase, low, high)
    open_ = np.arange(time.size)
    for _ in range(40):
        some = _Orbits(*(x[open_] if np.ndim(x) else x for x in orbits))
        at = _jacobi(some, time[open_])
        at = at._replace(cn=np.maximum(at.cn, 0.0))
        part = some.characteristic * at.sn * at.sn
        slope = ((1 - b) + (a + b) * part / (1 + part)) / some.speed
        found = by_gauss(at._replace(sn=np.maximum(at.sn, 1e-100)), some.characteristic, np, _near)
        value = ((1 - b) * time[open_] + (a + b) * some.characteristic * found.third) / some.speed
        step = (value - goal[open_]) / np.maximum(slope, 1e-300)
        after = np.clip(time[open_] - step, low[open_], high[open_])
        moved = np.abs(after - time[open_])
        time[open_] = after
        open_ = open_[moved > 1e-9 * np.maximum(after, 1e-3)]
        if not open_.size:
            break
    return np.copysign(time, phase)


def _linear(
    a: float,
    b: float,
    sine: Floats,
    cosine: Floats,
    rate: Floats,
    precession: Floats,
    turn: Floats,
) -> Floats:
    """``turn``, or the linear motion about an unstable point for starts that stay close to it."""
    growth = math.sqrt(a * b)
    offset = np.arctan2(sine * np.sign(cosine), np.abs(cosine))
    reach = np.abs(offset) + np.abs(rate) * (1 / a + np.abs(precession))
    small = reach * np.cosh(growth * precession) < LINEAR
    turn = np.where(reach == 0, 0.0, turn)
    spread = 2 * np.sinh(growth * precession / 2) ** 2
    drift = np.sinh(growth * precession) / growth
    return np.where(small, offset * spread + rate * drift, turn)
