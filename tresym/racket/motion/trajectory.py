"""ψ and θ after any precession Δφ, from any start, certified.

A start is (ψ₀, dψ/dφ) or (ψ₀, θ₀), exact. Whether its orbit rotates, oscillates or is the
separatrix is decided exactly: γ is an exact rational if sin²ψ₀ and the other data are rational, and
otherwise a ball that is narrowed until its sign is known. (If ψ₀ or θ₀ is a non-zero rational
number of radians, γ is not 0, by the theorem of Lindemann and Weierstrass; the same holds for a
rational rate and an irrational algebraic sin²ψ₀.)
"""

from __future__ import annotations

from contextlib import suppress
from typing import NamedTuple

from flint import arb, ctx, fmpq

from tresym.racket.angle import Angle
from tresym.racket.body import Shape
from tresym.racket.motion.carlson import Amplitude, by_flint
from tresym.racket.motion.orbit import Level, Orbit, angle_at, handle_at, orbit, phase, time_of
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError

MAX_EXTRA_BITS = 150_000
"""Bits of precision beyond those that the digits need, at which a start is refused."""


class Start(NamedTuple):
    """A start of the planar system: ψ₀ with either the rate dψ/dφ or the angle θ₀."""

    psi: Angle
    rate: fmpq | None = None
    theta: Angle | None = None


class State(NamedTuple):
    """A start in numbers: exact rationals if they are rational, else balls.

    ``sin2`` and ``cos2`` are sin²ψ₀ and cos²ψ₀; ``handle`` is cos θ₀ (a ball), ``handle2`` and
    ``sine2`` are cos²θ₀ and sin²θ₀.
    """

    sin2: fmpq | arb
    cos2: fmpq | arb
    handle: arb
    handle2: fmpq | arb
    sine2: fmpq | arb


class Arrival(NamedTuple):
    """The end of a motion: γ of its orbit, the change Δψ, and ψ, θ at the end (radians)."""

    gamma: fmpq | arb
    turn: arb
    psi: arb
    theta: arb


class UndecidedError(ArithmeticError):
    """The working precision is not sufficient; a higher one may be."""


def state(shape: Shape, start: Start) -> State:
    """Return the start in numbers at the working precision.

    Raises:
        InputError: no body of that shape has this rate, or no finite rate exists (b = 1, ψ₀ =
            ±π/2).
        UndecidedError: the precision does not show whether the rate is possible.
    """
    square = start.psi.rational_square()
    sin, cos = start.psi.sin_cos()
    sin2, cos2 = (square, 1 - square) if square is not None else (sin * sin, cos * cos)
    if start.theta is not None:
        if not 0 <= start.theta.ball() <= arb.pi() and start.theta.halves != 1:
            raise InputError("theta0: must be in [0, pi]")
        sine2 = start.theta.rational_square()
        sine, handle = start.theta.sin_cos()
        if sine2 is not None:
            return State(sin2, cos2, handle, 1 - sine2, sine2)
        return State(sin2, cos2, handle, handle * handle, sine * sine)
    if start.rate is None:
        raise InputError("start: give a rate or an angle theta with psi")
    return _from_rate(shape, start.rate, sin2, cos2)


def _from_rate(shape: Shape, rate: fmpq, sin2: fmpq | arb, cos2: fmpq | arb) -> State:
    """cos θ₀ = rate (1 − b sin²ψ₀)/(a + b sin²ψ₀), which must lie in [−1, 1]."""
    a, b = shape
    numerator, denominator = rate * (1 - b + b * cos2), a + b * sin2
    if isinstance(numerator, fmpq) and numerator == 0 and rate != 0:
        raise InputError(
            "rate: at b = 1 and psi0 = pi/2 the precession stands still, so that dpsi/dphi is "
            "not finite; give theta0 instead"
        )
    slack = (denominator - numerator) * (denominator + numerator)
    if slack < 0:
        raise InputError(
            "rate: no body of this shape has it here; its absolute value must be at most "
            "(a + b sin^2 psi0)/(1 - b sin^2 psi0)"
        )
    if not slack >= 0:
        raise UndecidedError("whether this rate is possible is not decided at this precision")
    square = denominator * denominator
    return State(
        sin2,
        cos2,
        arb(numerator) / arb(denominator),
        numerator * numerator / square,
        slack / square,
    )


def level(shape: Shape, at: State) -> tuple[fmpq | arb, Level]:
    """Return γ of a state, exact if it is rational, and its level with the sign of γ decided.

    Raises:
        UndecidedError: the sign of γ is not decided at this precision.
    """
    a, b = shape
    scale = a + b * at.sin2
    gamma = at.handle2 * scale - b * at.sin2
    below, above = at.sine2 * scale, at.handle2 * scale + b * at.cos2
    if not (gamma > 0 or gamma < 0 or gamma == 0):
        raise UndecidedError("the sign of gamma is not decided at this precision")
    regime = 1 if gamma > 0 else -1 if gamma < 0 else 0
    return gamma, Level(arb(gamma), arb(below), arb(above), regime)


def travel(shape: Shape, start: Start, precession: Angle, digits: int) -> Arrival:
    """Compute ψ and θ after ``precession`` radians of φ, Δψ with ``digits`` certified digits.

    The digits of Δψ are relative to its size, however small. If Δψ cannot be distinguished from 0
    within ``MAX_EXTRA_BITS`` of the precision, its radius says so; a Δψ that is exactly 0 is
    returned as 0.

    Raises:
        InputError: a start that does not exist, or one too near the separatrix to be decided.
    """
    precision = bits(digits, 64)
    limit = precision + MAX_EXTRA_BITS
    best: Arrival | None = None
    while precision <= limit:
        with ball_precision(precision), suppress(ArithmeticError):
            best = _arrive(shape, start, precession)
        if best is not None:
            if proves(best.turn, digits) and _narrow(best, digits):
                return best
            if precision > 16 * bits(digits, 64) and best.turn.contains(0):
                return best
        precision = precision * 3 // 2 + 64
    if best is None:
        raise InputError("start: too near the separatrix to be distinguished from it")
    return best


def _narrow(arrival: Arrival, digits: int) -> bool:
    """Whether ψ, θ and γ are known to ``digits`` digits, relative or absolute."""
    small = arb(fmpq(1, 10) ** (digits + 1))
    numbers = [arrival.psi, arrival.theta]
    if isinstance(arrival.gamma, arb) and not proves(arrival.gamma, digits):
        return False
    return all(proves(x, digits) or x.rad() < small for x in numbers)


def _arrive(shape: Shape, start: Start, precession: Angle) -> Arrival:
    """The end of the motion at the working precision."""
    at = state(shape, start)
    gamma, on_level = level(shape, at)
    psi0 = start.psi.ball()
    if precession.is_zero or _at_rest(at):
        return Arrival(gamma, arb(0), psi0, _polar(arb(at.sine2), at.handle))
    mirrored = bool(at.handle < 0) and on_level.regime >= 0
    psi = -start.psi if mirrored else start.psi
    on = orbit(shape.a, shape.b, on_level)
    offset, begin = _enter(on, psi, at)
    place = time_of(on, begin + precession.ball())
    turn = angle_at(on, place) - offset
    handle = handle_at(on, place)
    if mirrored:
        turn, handle = -turn, -handle
    end = psi0 + turn
    sine2 = on_level.below / (on.a + on.b * end.sin() ** 2)
    return Arrival(gamma, turn, end, _polar(sine2, handle))


def _polar(sine2: arb, handle: arb) -> arb:
    """θ in [0, π] from sin²θ and cos θ."""
    return arb.atan2(sine2.sqrt(), handle)


def _at_rest(at: State) -> bool:
    """Whether the start is an equilibrium of the planar system: cos θ = 0 and sin ψ cos ψ = 0."""
    return bool(at.handle2 == 0 and (at.sin2 == 0 or at.cos2 == 0))


def _enter(on: Orbit, psi: Angle, at: State) -> tuple[arb, arb]:
    """ψ − π/2 reduced by a multiple of π to [−π/2, π/2], and the phase there."""
    halves = _floor(psi)
    sin, cos = psi.sin_cos()
    if halves % 2:
        sin, cos = -sin, -cos
    offset = (psi.halves - halves - fmpq(1, 2)) * arb.pi() + psi.radians
    a, b, above = on.a, on.b, on.level.above
    root = (a + b * arb(at.sin2)).sqrt()
    modulus = on.elliptic.modulus
    if on.level.regime >= 0:
        dn = abs(at.handle) * ((a + b) / above).sqrt()
        here = Amplitude(-a.sqrt() * cos / root, (a + b).sqrt() * sin / root, dn, modulus)
        return offset, phase(on, by_flint(here, on.characteristic))
    sn = -cos * (arb(at.sine2) * b / above).sqrt()
    cn = at.handle * ((a + b) / above).sqrt()
    here = Amplitude(sn, abs(cn), (a + b).sqrt() * sin / root, modulus)
    begin = phase(on, by_flint(here, on.characteristic))
    if cn < 0:
        begin = 2 * on.quarter_phase - begin
    elif not cn >= 0:
        raise UndecidedError("the direction of the start is not decided at this precision")
    return offset, begin


def _floor(psi: Angle) -> int:
    """⌊ψ/π⌋, exactly."""
    if psi.radians == 0:
        return int(psi.halves.floor())
    with ball_precision(ctx.prec + 64):
        found = (arb(psi.radians) / arb.pi()).floor().unique_fmpz()
    if found is None:
        raise UndecidedError("the half turn of psi0 is not decided at this precision")
    return int(found)
