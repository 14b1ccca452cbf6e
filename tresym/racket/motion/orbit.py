"""The exact solution of the planar system on one level of γ, in balls.

In the time τ with dφ/dτ = 1 − b sin²ψ the motion is given by Jacobi's functions of u = ωτ, counted
from ψ = π/2 with ψ increasing:

    γ ≥ 0 (rotating):    ω² = a(γ+b),  n = b/a,          k² = b(a−γ)/(a(γ+b)),
                         ψ − π/2 = arctan(√((a+b)/a) sn/cn),  cos θ = √((γ+b)/(a+b)) dn;
    γ < 0 (oscillating): ω² = b(a−γ),  n = (γ+b)/(a−γ),  k² = a(γ+b)/(b(a−γ)),
                         ψ − π/2 = arctan(√((γ+b)(a+b)/(b(a−γ))) sn/dn),
                         cos θ = √((γ+b)/(a+b)) cn.

On the separatrix k = 1 and the first form holds. In both, with u and J as in
:mod:`tresym.racket.motion.carlson`,

    φ(u) = [(1−b) u + (a+b) n J(u)]/ω,   dφ/du = (1 − b sin²ψ)/ω,

which increases strictly on every orbit and has no singularity at turning points: φ is inverted by
one change of sign, and the answer is unique.
"""

from __future__ import annotations

from typing import NamedTuple

from flint import acb, arb, ctx, fmpq

from tresym.racket.motion.carlson import Amplitude, Integrals, by_flint
from tresym.racket.motion.jacobi import Jacobi, functions, parameter
from tresym.reals.numbers.arithmetic import ball_precision


class Level(NamedTuple):
    """A level of the first integral: γ with a − γ and γ + b, each with its own relative accuracy.

    ``regime`` is the sign of γ, decided exactly: 1 rotating, 0 on the separatrix, −1 oscillating.
    """

    gamma: arb
    below: arb
    above: arb
    regime: int


def exact_level(a: fmpq, b: fmpq, gamma: fmpq) -> Level:
    """Return the level of an exact γ in [−b, a], at the working precision."""
    regime = int(gamma > 0) - int(gamma < 0)
    return Level(arb(gamma), arb(a - gamma), arb(gamma + b), regime)


class Orbit(NamedTuple):
    """An orbit at the precision of its creation; the module docstring defines its constants.

    ``quarter_time`` and ``quarter_phase`` are u and φ from ψ = π/2 to the far end: ψ = π for a
    rotating orbit, the turning point for an oscillating one. On the separatrix both are infinite.
    """

    a: arb
    b: arb
    level: Level
    speed: arb
    characteristic: arb
    elliptic: Jacobi
    quarter_time: arb
    quarter_phase: arb


def orbit(a: fmpq, b: fmpq, level: Level) -> Orbit:
    """Return the orbit of the shape (a, b) on a level −b < γ ≤ a, at the working precision."""
    p, q, total = arb(a), arb(b), arb(a + b)
    gamma, below, above, regime = level
    if regime >= 0:
        speed, n = (p * above).sqrt(), arb(b / a)
        modulus, complement = q * below / (p * above), gamma * total / (p * above)
    else:
        speed, n = (q * below).sqrt(), above / below
        modulus, complement = p * above / (q * below), -gamma * total / (q * below)
    elliptic = parameter(modulus, complement)
    infinite = arb.pos_inf()
    found = Orbit(p, q, level, speed, n, elliptic, infinite, infinite)
    if regime == 0:
        return found
    ends = by_flint(Amplitude(arb(1), arb(0), complement.sqrt(), modulus), n)
    return found._replace(quarter_time=ends.time, quarter_phase=phase(found, ends))


def phase(on: Orbit, at: Integrals) -> arb:
    """Return φ from ψ = π/2, given u and J."""
    weight = (on.a + on.b) * on.characteristic
    return ((1 - on.b) * at.time + weight * at.third) / on.speed


def phase_at(on: Orbit, time: arb) -> arb:
    """Return φ(u) for |u| ≤ 3K/2: by R_J within a quarter of the orbit, by reflection beyond it."""
    far = on.quarter_time
    if abs(time) <= far:
        return _phase_in_quarter(on, time)
    turn = 2 * far if time > 0 else -2 * far
    if abs(time) > far:
        return (2 if time > 0 else -2) * on.quarter_phase - _phase_in_quarter(on, turn - time)
    # u is within the ball of the far end itself, where 0 ≤ dφ/du ≤ 1/ω.
    rest = arb(0, ((abs(time) - far) / on.speed).abs_upper())
    return (1 if time > 0 else -1) * (on.quarter_phase + rest)


def _phase_in_quarter(on: Orbit, time: arb) -> arb:
    at = functions(on.elliptic, time)
    square = at.sn * at.sn
    x, y = (acb((root * root).nonnegative_part()) for root in (at.cn, at.dn))
    rj = acb.elliptic_rj(x, y, 1, 1 + on.characteristic * square).real
    return phase(on, Integrals(time, at.sn * square * rj / 3))


def slope(on: Orbit, at: Amplitude) -> arb:
    """Return dφ/du = (1 − b sin²ψ)/ω, computed as a sum of positive terms."""
    part = on.characteristic * at.sn * at.sn
    return (1 - on.b + (on.a + on.b) * part / (1 + part)) / on.speed


class Place(NamedTuple):
    """A point of an orbit: u reduced to |u| ≤ K, and the number of half periods 2K to add."""

    time: arb
    halves: int


def time_of(on: Orbit, phi: arb) -> Place:
    """Return the point at which the phase is ``phi``, enclosed by a change of sign.

    Raises:
        ArithmeticError: the working precision is not sufficient.
    """
    halves = 0
    if on.level.regime != 0:
        halves = _nearest(phi / (2 * on.quarter_phase))
        phi = phi - 2 * halves * on.quarter_phase
    return Place(_invert(on, phi), halves)


def _nearest(x: arb) -> int:
    """An integer nearest to the midpoint of ``x``."""
    if not x.is_finite() or x.rad() > 0.25:
        raise ArithmeticError("the number of half periods is not known at this precision")
    return int((x.mid() + arb(0.5)).mid().floor().unique_fmpz())


def _invert(on: Orbit, phi: arb) -> arb:
    """u with φ(u) = ``phi``: Newton's method at increasing precision, then a proof by two signs."""
    target = ctx.prec
    guess = _approximate(on, phi.mid())
    correct = 40
    while 2 * correct < target:
        correct = 2 * correct
        with ball_precision(correct + 24):
            guess = _newton(on, phi, guess)
    guess = _newton(on, phi, guess)
    at = slope(on, functions(on.elliptic, guess))
    width = (abs(phase_at(on, guess) - phi) / at).abs_upper() * 2 + arb((1, -2 * target))
    for _ in range(6):
        low, high = (guess - width).mid(), (guess + width).mid()
        if phase_at(on, low) < phi < phase_at(on, high):
            return low.union(high)
        width = width * 1024
    raise ArithmeticError("no change of sign at this precision")


def _newton(on: Orbit, phi: arb, guess: arb) -> arb:
    """One Newton step at the working precision, without an error bound."""
    step = (phase_at(on, guess) - phi) / slope(on, functions(on.elliptic, guess))
    return (guess - step).mid() if step.is_finite() else guess


def _approximate(on: Orbit, phi: arb) -> arb:
    """u to about 40 bits: Newton's method inside a bracket, at 64 bits."""
    with ball_precision(64):
        low, high = _bracket(on, phi)
        guess = (low + high).mid() / 2
        for _ in range(100):
            residual = (phase_at(on, guess) - phi).mid()
            if residual > 0:
                high = guess
            else:
                low = guess
            step = (residual / slope(on, functions(on.elliptic, guess))).mid()
            after = guess - step
            if not low <= after <= high:
                after = (low + high).mid() / 2
            if abs(after - guess) <= abs(guess) * arb((1, -42)):
                return after
            guess = after.mid()
        return guess


def _bracket(on: Orbit, phi: arb) -> tuple[arb, arb]:
    """Two times that enclose the one wanted: (1−b)/ω ≤ dφ/du ≤ 1/ω, and |u| ≤ K.

    On the separatrix K is infinite, but sin²ψ ≤ sech² u there, so that |u| ≤ |φ|ω + b.

    Raises:
        ArithmeticError: the phase is not a finite number.
    """
    if not (phi.is_finite() and on.speed.is_finite()):
        raise ArithmeticError("the phase to be reached is not a finite number")
    sign = -1 if phi < 0 else 1
    near = (abs(phi) * on.speed).mid()
    far = on.quarter_time.mid()
    if on.level.regime == 0:
        far = near + 1
    elif near > far:
        near = arb(0)
    return (near, far) if sign > 0 else (-far, -near)


def angle_at(on: Orbit, place: Place) -> arb:
    """Return ψ − π/2 in radians, continuous along the orbit."""
    at = functions(on.elliptic, place.time)
    if on.level.regime >= 0:
        offset = arb.atan2((on.a + on.b).sqrt() * at.sn, on.a.sqrt() * at.cn)
        return offset + place.halves * arb.pi()
    ratio = (on.level.above * (on.a + on.b) / (on.b * on.level.below)).sqrt()
    offset = (ratio * at.sn / at.dn).atan()
    return -offset if place.halves % 2 else offset


def handle_at(on: Orbit, place: Place) -> arb:
    """Return cos θ."""
    at = functions(on.elliptic, place.time)
    largest = (on.level.above / (on.a + on.b)).sqrt()
    if on.level.regime >= 0:
        return largest * at.dn
    return -largest * at.cn if place.halves % 2 else largest * at.cn
