"""The orbit of a start in float64, for numpy arrays.

The time τ (dφ/dτ = 1 − b sin²ψ, from ψ = π/2) and the phase φ are computed from an angle by the
steps of :mod:`tresym.racket.motion.gauss`. In these variables oscillating and rotating orbits have
the same form: with t = |tan ψ|, p = A t and r ∝ cos θ replace x and y, and r² − p² = γ(a+b) may
have either sign. An angle is computed from a time by the inverse steps, from x = y = L/sinh Lτ:

    z = y′z′/x′,   x, y = x′ ∓ (G² − H²)/(4x′),

without a square root; p and r change sign at ψ = π and at turning points as they should. The angles
arctan(C_n/z_n) with weights 2ⁿ are the argument of a product of complex numbers. Its branch is
known, since φ = τ − ∫ b sin²ψ dτ and this integral lies in [0, π/2] over a quarter of an orbit.
"""

from __future__ import annotations

import math
from typing import Any, NamedTuple

import numpy as np

LEVELS = 12
"""Most Gauss steps; 6 are enough unless γ is within 1e-6 of an end of its range."""

ROUNDS = 40
"""Most steps of Halley's method; two or three are enough, as the phase is nearly linear."""

TINY = 1e-290
"""The least √|γ(a+b)|; the separatrix is replaced by an orbit at this distance."""

LINEAR = 1e-9
"""Angles below which the motion about an unstable point is linear to float64 accuracy."""

SQUARES, GAINS, APARTS, TANGENTS, FAR = range(5)
"""The rows of :attr:`FloatOrbit.work`."""

MIDPOINTS = tuple(math.sin((2 * k + 1) * math.pi / 24) ** 2 for k in range(6))
"""sin² of the points of the midpoint rule on a quarter turn."""


class FloatOrbit(NamedTuple):
    """The constants of an orbit.

    ``steps`` is the number of Gauss steps; ``root`` = √|γ(a+b)|; ``split`` is a quarter of it with
    the sign of γ; ``reach`` = A; ``first`` and ``third`` are C before and after the steps; ``unit``
    is L; and ``drift`` is the factor of τ in ∫ b sin²ψ dτ. ``work`` holds for each step G², C′/C −
    1, G² − H², and tangents at the current point and at the far end.
    """

    a: float
    b: float
    rotating: Any
    root: Any
    split: Any
    reach: Any
    first: Any
    third: Any
    unit: Any
    drift: Any
    steps: int
    work: Any


def largest(x: Any) -> Any:
    """Return the largest element of an array, ignoring NaN."""
    return np.fmax.reduce(x, initial=-np.inf)


def least(x: Any) -> Any:
    """Return the least element of an array, ignoring NaN."""
    return np.fmin.reduce(x, initial=np.inf)


def choose(condition: Any, x: Any, y: Any) -> Any:
    """Return x where the condition holds, else y."""
    return np.where(condition, x, y)


def orbit(
    a: float, b: float, rotating: Any, root: Any, below: Any, above: Any, work: Any
) -> FloatOrbit:
    """Return the orbit for the sign of γ, √|γ(a+b)|, a − γ and γ + b."""
    total = a + b
    high, low = np.sqrt(a * above), np.sqrt(b * below)
    third, far, other = np.sqrt(b * above), np.sqrt(total * above), np.sqrt(b * total)
    first, reach, drift, weight, steps = third, far, third - b, 1.0, 0
    work[SQUARES, 0] = high * high
    # (G − H)/2 is computed from G² − H², without subtraction.
    apart = root * (root / (high + low)) / 2
    while True:
        product, inner = far * other, high * low
        far = (far + other) / 2
        other = np.sqrt((product + inner + third * third) / 2)
        # C′/C − 1, A′ − B′ being (G′² − H′²)/(A′ + B′).
        gain = apart * apart / ((far + other) * other)
        weight *= 2.0
        drift = drift + weight * third * gain
        third = third * (1 + gain)
        high, low = (high + low) / 2, np.sqrt(inner)
        steps += 1
        work[SQUARES, steps], work[GAINS, steps] = high * high, gain
        work[APARTS, steps] = apart * apart
        if steps == LEVELS or not largest(apart - 1e-4 * root) > 0:
            break
        apart = apart * (apart / (high + low)) / 2
    unit = np.sqrt((high * high + inner) / 2)
    return FloatOrbit(
        a,
        b,
        rotating,
        root,
        choose(rotating, root / 4, root / -4),
        reach,
        first,
        third,
        unit,
        drift,
        steps,
        work,
    )


def entries(on: FloatOrbit, x: Any, y: Any, z: Any, scale: Any) -> tuple[Any, Any, Any, Any]:
    """Return τ and φ at a start and at the far end.

    The start is given by ``scale`` times its p, r ≥ 0 and z. Both are computed in one loop, since
    their steps do not depend on each other.
    """
    u = choose(on.rotating, 0.0, on.root)
    v = on.root - u
    w = np.sqrt(on.work[SQUARES, 0] + u * u)
    tangent, far_tangent = scale * on.first / z, on.first / w
    on.work[TANGENTS, 0], on.work[FAR, 0] = tangent, far_tangent
    double = scale * scale
    x, u = (x + y) / 2, (u + v) / 2
    for n in range(1, on.steps + 1):
        square, gain, apart = on.work[SQUARES, n], on.work[GAINS, n], on.work[APARTS, n]
        after, far_after = np.sqrt(x * x + double * square), np.sqrt(u * u + square)
        ratio, far_ratio = z / after, w / far_after
        z, w, sum_, far_sum = after, far_after, x + ratio * x, u + far_ratio * u
        more = gain * ratio + double * apart / sum_ / x
        far_more = gain * far_ratio + apart / far_sum / u
        x, u = sum_ / 2, far_sum / 2
        after, far_after = tangent + tangent * more, far_tangent + far_tangent * far_more
        on.work[TANGENTS, n] = tangent * more / (1 + tangent * after)
        on.work[FAR, n] = far_tangent * far_more / (1 + far_tangent * far_after)
        tangent, far_tangent = after, far_after
    long = scale * on.unit
    time = np.log1p(long / x * (1 + long / (z + x))) / on.unit
    far = np.log1p(on.unit / u * (1 + on.unit / (w + u))) / on.unit
    return time, time - spent(on, time, TANGENTS), far, far - spent(on, far, FAR)


def place(on: FloatOrbit, time: Any) -> tuple[Any, Any, Any]:
    """Return p, r and z at a time up to the far end, where p or r is 0, and the tangents."""
    grown = np.expm1(np.maximum(on.unit * time, 1e-100))
    x = on.unit / ((grown + grown / (1 + grown)) / 2)
    z = x + x * (grown * (grown / (1 + grown)) / 2)
    tangent, inverse = on.third / z, 1 / x
    for n in range(on.steps, 0, -1):
        drop = on.work[APARTS, n] * inverse / 4
        y, x = x + drop, x - drop
        inverse = 1 / x
        ratio = y * inverse
        z = z * ratio
        more = on.work[GAINS, n] * ratio + 2 * drop * inverse
        after, tangent = tangent, tangent / (1 + more)
        on.work[TANGENTS, n] = tangent * more / (1 + tangent * after)
    on.work[TANGENTS, 0] = tangent
    drop = on.split * (on.root / x)
    return x - drop, x + drop, z


def spent(on: FloatOrbit, time: Any, row: int) -> Any:
    """Return ∫ b sin²ψ dτ up to τ, in [0, π/2], from the tangents of the angles whose sum it is."""
    real, imaginary = 1.0 + 0.0 * time, on.work[row, on.steps]
    for n in range(on.steps - 1, -1, -1):
        tangent = on.work[row, n]
        real, imaginary = real * real - imaginary * imaginary, 2 * real * imaginary
        real, imaginary = real - imaginary * tangent, imaginary + real * tangent
    found = np.arctan2(imaginary, real) - on.drift * time
    found = found - 2 * math.pi * np.rint((found - math.pi / 4) / (2 * math.pi))
    return np.minimum(np.maximum(found, 0.0), on.b * time)


def of_fast_rotation(on: FloatOrbit, far_time: Any, far_phase: Any) -> tuple[Any, Any]:
    """Return τ and φ of the far end for fast rotation, to a few roundings.

    They are counted many times there. For γ > 8b the integrands over ψ are so smooth that six
    points of the midpoint rule have a relative error below e^(−24 arsinh √8) < 1e-18.
    """
    a, b = on.a, on.b
    gamma = on.root * (on.root / (a + b))
    gamma = choose(on.rotating, gamma, 0.0)
    if largest(gamma) > 8 * b:
        fast = gamma > 8 * b
        time, phase = 0.0 * gamma, 0.0 * gamma
        for square in MIDPOINTS:
            part = b * square
            slowness = math.pi / 12 / np.sqrt((a + part) * (gamma + part))
            time = time + slowness
            phase = phase + (1 - part) * slowness
        far_time, far_phase = choose(fast, time, far_time), choose(fast, phase, far_phase)
    return far_time, far_phase


def arrival(on: FloatOrbit, phase: Any, far_time: Any, far_phase: Any) -> tuple[Any, Any, Any]:
    """Return τ, p and r where φ = ``phase``, by Halley's method in a bracket.

    ``phase`` is in [0, φ of the far end]. φ is convex, below its chord and between τ − π/2 and τ.
    The last step is applied to p and r, by p′ = −rz, r′ = −pz, z′ = −pr.
    """
    a, b = on.a, on.b
    high = np.maximum(phase, np.minimum(far_time, phase + math.pi / 2))
    time = np.minimum(np.maximum(phase * (far_time / far_phase), phase), high)
    square = on.reach * on.reach
    for _ in range(ROUNDS):
        p, r, z = place(on, time)
        excess = time - spent(on, time, TANGENTS) - phase
        inverse = 1 / (p * p + square)
        slope = (1 - b) + b * square * inverse
        root = np.sqrt((a + b * p * p * inverse) * inverse / (a + b))
        divisor = slope - excess * (b * p * r * square * inverse * root) / slope
        step = excess / np.maximum(choose(divisor > slope / 2, divisor, slope), TINY)
        after = np.minimum(np.maximum(time - step, phase), high)
        step = after - time
        time = after
        if not largest(np.abs(step) - 3e-6 * np.minimum(time, 1 / z)) > 0:
            break
    half = step / 2
    p, r = (
        p - step * (r * z - half * p * (z * z + r * r)),
        r - step * (p * z - half * r * (z * z + p * p)),
    )
    return time, p, r


class FloatStart(NamedTuple):
    """A start on its orbit, by symmetry with ψ increasing (rotating) and 0 ≤ ψ ≤ π.

    ``mirror`` is −1 if ψ was reflected; ``before`` is ½ if the start lies below π/2, else −½; and
    ``offset`` is the angle from the nearer of the unstable points 0 and π. ``time`` and ``phase``
    are τ and φ of the start, ``far_time`` and ``far_phase`` those of the far end of a quarter.
    """

    sine: Any
    cosine: Any
    exists: Any
    at_rest: Any
    below: Any
    mirror: Any
    before: Any
    offset: Any
    time: Any
    phase: Any
    far_time: Any
    far_phase: Any


def depart(a: float, b: float, psi: Any, rate: Any, work: Any) -> tuple[FloatOrbit, FloatStart]:
    """Return the orbit of a start (ψ, dψ/dφ), and the position of the start on it."""
    sine, cosine = np.sin(psi), np.cos(psi)
    up, long = np.abs(sine), np.abs(cosine)
    scale, clock = a + b * sine * sine, (1 - b) + b * cosine * cosine
    moment = rate * clock
    handle = moment / scale
    level = (scale - moment) * (scale + moment) / (scale * scale)
    rise, fall = np.abs(handle) * np.sqrt(scale), math.sqrt(b) * up
    rotating = rise >= fall
    root = np.sqrt(np.abs(rise - fall)) * np.sqrt(rise + fall) * math.sqrt(a + b)
    below = np.maximum(level, TINY) * scale
    above = np.maximum(rise * rise + b * cosine * cosine, TINY)
    on = orbit(a, b, rotating, np.maximum(root, TINY), below, above, work)
    x, y = np.maximum(on.reach * up, TINY), math.sqrt(a + b) * rise
    time, phase, far_time, far_phase = entries(on, x, y, np.sqrt(above * scale), long)
    far_time, far_phase = of_fast_rotation(on, far_time, far_phase)
    # Below its rounding error: b = 1 and ψ = π/2, where the precession stands still.
    far_phase = np.maximum(far_phase, 1e-16 * far_time)
    mirror = choose(rotating & (handle < 0), -1.0, 1.0)
    before = choose(mirror * sine * cosine >= 0, 0.5, -0.5)
    time, phase = -2 * before * time, -2 * before * phase
    back = (handle < 0) & ~rotating
    time = choose(back, 2 * far_time - time, time)
    phase = choose(back, 2 * far_phase - phase, phase)
    return on, FloatStart(
        sine,
        cosine,
        level >= -2e-15,
        up + rise == 0,
        below,
        mirror,
        before,
        np.arctan2(up, long),
        time,
        phase,
        far_time,
        far_phase,
    )


class End(NamedTuple):
    """The end of a motion: Δψ, p, r with its sign, τ from ψ = π/2, and the number of half periods.

    ``sum_`` and ``phase`` are the sizes of the terms whose sums are Δψ and φ.
    """

    turn: Any
    p: Any
    r: Any
    time: Any
    halves: Any
    sum_: Any
    phase: Any


def travel(on: FloatOrbit, start: FloatStart, precession: Any) -> End:
    """Return the end after φ has increased by ``precession`` radians."""
    end = start.phase + precession
    halves = np.rint(end / (2 * start.far_phase))
    phase = end - 2 * halves * start.far_phase
    time, p, r = arrival(on, np.abs(phase), start.far_time, start.far_phase)
    odd = halves - 2 * np.rint(halves / 2)
    turned = choose((odd != 0) & ~on.rotating, -1.0, 1.0)
    after = choose(phase < 0, -0.5, 0.5) * turned
    offset = np.arctan2(p, on.reach)
    whole = choose(on.rotating, halves, 0.0) + after + start.before
    apart = 2 * (after * offset + start.before * start.offset)
    return End(
        start.mirror * (math.pi * whole - apart),
        p,
        start.mirror * turned * r,
        np.copysign(time, phase),
        halves,
        math.pi * np.abs(whole) + offset + start.offset,
        np.abs(end),
    )


def turn(a: float, b: float, psi: Any, rate: Any, precession: Any, work: Any) -> Any:
    """Return Δψ for each start (ψ, dψ/dφ) while φ increases by ``precession`` radians.

    Args:
        a: the shape, in float64, like ``b``.
        b: see ``a``.
        psi: ψ of the starts in radians.
        rate: dψ/dφ of the starts.
        precession: Δφ in radians.
        work: memory for 5 (LEVELS + 1) numbers for each start.

    Returns:
        NaN where no such start exists.
    """
    on, start = depart(a, b, psi, rate, work)
    found = linear(on, start, rate, precession, travel(on, start, precession).turn)
    return choose(start.exists, found, np.nan)


def arrive(
    a: float, b: float, psi: Any, rate: Any, precession: Any, work: Any
) -> tuple[Any, Any, Any, Any, Any, Any]:
    """Return Δψ, cos θ, sin θ and the time of each start; the arguments are those of :func:`turn`.

    Two more results are the size of the terms whose sum is Δψ, which determines the rounding error,
    and the range of ψ on the orbit.
    """
    on, start = depart(a, b, psi, rate, work)
    end = travel(on, start, precession)
    square = 1 / (end.p * end.p + on.reach * on.reach)
    scale, clock = a + b * end.p * end.p * square, (1 - b) + b * on.reach * on.reach * square
    handle = end.r * on.reach * np.sqrt(square / (scale * (a + b)))
    around = start.far_time * (1 + 2 * np.abs(end.halves))
    phases = (1 + np.abs(on.drift)) * around + end.phase
    size = end.sum_ + np.abs(handle) * scale / clock * phases
    # At a turning point the speed vanishes, and the phase enters by its square.
    reach = choose(on.rotating, math.pi, 2 * np.arctan2(on.reach, on.root))
    size = size + reach * (phases / start.far_phase) * (phases / start.far_phase) * 6e-14
    exists = start.exists
    return (
        choose(exists, linear(on, start, rate, precession, end.turn), np.nan),
        choose(exists, handle, np.nan),
        choose(exists, np.sqrt(start.below / scale), np.nan),
        choose(exists, end.time + 2 * end.halves * start.far_time - start.time, np.nan),
        choose(start.at_rest, 0.0, size),
        choose(on.rotating, np.inf, reach),
    )


def linear(on: FloatOrbit, start: FloatStart, rate: Any, precession: Any, turned: Any) -> Any:
    """Replace ``turned`` by the linear motion for starts that stay close to an unstable point."""
    growth = math.sqrt(on.a * on.b)
    sine, cosine = start.sine, start.cosine
    reach = np.abs(sine) + np.abs(rate) * (1 / on.a + np.abs(precession))
    if not least(reach) < LINEAR:
        return turned
    offset = np.arctan2(sine * np.sign(cosine), np.abs(cosine))
    small = reach * np.cosh(growth * precession) < LINEAR
    turned = choose(reach == 0, 0.0, turned)
    spread = 2 * np.sinh(growth * precession / 2) ** 2
    drift = np.sinh(growth * precession) / growth
    return choose(small, offset * spread + rate * drift, turned)
