"""Compute ε(γ) for every γ in [−b, a] as a ball with any number of digits.

The symmetric trajectory passes ψ = π/2 at φ = 0, and ε(γ) is its ψ half a turn before: with the
phase φ(u) of :mod:`tresym.racket.motion.orbit`, ε = ψ(u) where φ(u) = −π. This ε exists and is
unique, since φ(u) is strictly increasing. If the trajectory has no turning point in between, this
is the paper's equation F(ε, γ) = π. Otherwise the phase π is reduced to the first quarter of the
orbit (:mod:`tresym.racket.flip.phase_folding`). Then one or two evaluations of F are enough
(:func:`quick`). At γ* and at the ends of the range this fails, and φ is inverted numerically with
proof (:func:`inverted`).
"""

from __future__ import annotations

from contextlib import suppress
from functools import lru_cache
from typing import NamedTuple

from flint import arb, fmpq

from tresym.racket.flip.phase_folding import Fold, folded
from tresym.racket.motion.carlson import amplitude, by_flint, turn
from tresym.racket.motion.gauss import ball_ending, turn_by_gauss
from tresym.racket.motion.orbit import Level, angle_at, exact_level, orbit, time_of
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits
from tresym.reals.numbers.exact import InputError, fraction_text, shortened

PRECISION_LIMIT = 400_000
"""The working precision in bits beyond which a computation is given up."""

FLOAT_BITS = 46
"""Bits of the float64 approximation that are expected to be correct; this only affects speed."""


class Defect(NamedTuple):
    """Balls around ε and the flip Δψ = π − 2ε, in radians."""

    defect: arb
    flip: arb


def checked_gamma(a: fmpq, b: fmpq, gamma: fmpq) -> fmpq:
    """Return ``gamma`` if it is in [−b, a].

    Raises:
        InputError: it is not.
    """
    if (gamma + b).p < 0 or (a - gamma).p < 0:  # the sign of the numerator is the fastest test
        low, high = (shortened(fraction_text(end)) for end in (-b, a))
        raise InputError(f"gamma: must be between -b and a, here between {low} and {high}")
    return gamma


def solve(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect:
    """Compute ε(γ) and the flip, each to ``digits`` certified digits.

    Raises:
        InputError: γ outside [−b, a].
        ArithmeticError: the precision limit is reached.
    """
    checked_gamma(a, b, gamma)
    return quick(a, b, gamma, digits) or inverted(a, b, gamma, digits)


def inverted(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect:
    """Compute ε(γ) for any γ in [−b, a], by inverting the phase at increasing precision.

    At γ = −b, the stable rotation with ψ = π/2, the flip is 0. A flip so small that its ball still
    contains 0 at eight times the precision that the digits need is only proved to be below
    10^−digits.

    Raises:
        ArithmeticError: the precision limit is reached.
    """
    precision = bits(digits, 48)
    if gamma == -b:
        with ball_precision(precision):
            return Defect(arb.pi() / 2, arb(0))
    while precision < PRECISION_LIMIT:
        with ball_precision(precision), suppress(ArithmeticError):
            angle = defect_on(a, b, exact_level(a, b, gamma))
            found = Defect(angle, arb.pi() - 2 * angle)
            if all(settled(x, digits, precision) for x in found):
                return found
        precision += precision // 2
    raise ArithmeticError("the precision limit is reached")


def settled(x: arb, digits: int, precision: int) -> bool:
    """Return whether ``x`` proves the digits, or contains 0 at eight times the precision needed."""
    if proves(x, digits):
        return True
    small = arb(fmpq(1, 10) ** digits)
    return precision > 8 * bits(digits, 48) and x.contains(0) and bool(x.rad() < small)


def defect_on(a: fmpq, b: fmpq, level: Level) -> arb:
    """Compute ε on a level −b < γ ≤ a at the working precision, by inverting the phase.

    Raises:
        ArithmeticError: the precision is not sufficient.
    """
    on = orbit(a, b, level)
    return arb.pi() / 2 - angle_at(on, time_of(on, arb.pi()))


def quick(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect | None:
    """Compute ε(γ) from F in the first quarter of the orbit.

    A float64 solution is improved by the Taylor series of the flow dψ/dφ, whose argument is the
    phase that is still missing. Each round quadruples the number of correct digits, and the last
    one encloses the solution.

    Returns: None if float64 finds no solution, or the digits are not reached (near γ* and the ends
    of the
        range of γ).
    """
    found = folded(float(arb(a)), float(arb(b)), float(arb(gamma)))
    if found is None:
        return None
    fold, near = found[0], arb(found[1])
    with suppress(ArithmeticError):
        for precision in _rounds(bits(digits, 24)):
            with ball_precision(precision):
                angle = corrected(arb(a), arb(b), arb(gamma), near, fold)
                answer = unfolded(angle, fold)
            if proves(answer.defect, digits) and proves(answer.flip, digits):
                return answer
            near = angle.mid()
    return None


@lru_cache(maxsize=64)
def _rounds(precision: int) -> tuple[int, ...]:
    """The precisions of the rounds: each four times the one before, and a last one in reserve."""
    rounds = [precision]
    while rounds[0] > 4 * FLOAT_BITS + 10:
        rounds.insert(0, rounds[0] // 4 + 10)
    return (*rounds, precision + precision // 4 + 32)


def unfolded(angle: arb, fold: Fold) -> Defect:
    """Return ε = s·e + nπ and π − 2ε from the reduced angle e."""
    sign, turns = fold.unfolding
    angle, pi = sign * angle, arb.pi()
    if not turns:
        return Defect(angle, pi - 2 * angle)
    return Defect(angle + turns * pi, (1 - 2 * turns) * pi - 2 * angle)


def corrected(a: arb, b: arb, gamma: arb, near: arb, fold: Fold) -> arb:
    """Enclose the reduced angle from the exact point ``near``, at the working precision.

    ψ(φ) solves ψ′ = √G(ψ), ψ″ = G′/2, ψ‴ = G″ψ′/2, G = (a + bs²)(γ + bs²)/(1 − bs²)², s = sin ψ.
    The solution from ``near`` reaches the angle after the phase h by which F(near, γ) is too large
    (on the way back, 2Q − F too small). By the mean value theorem it stays within r of ``near`` if
    |h| √G < r for all angles there, and Taylor's remainder is bounded over these angles.

    Raises:
        ArithmeticError: nothing is proved (turning point, or precision too low).
    """
    sine, cosine = near.sin_cos()
    square = b * sine * sine
    z, inverse = gamma + square, 1 / (1 - square)
    if not (z > 0 and sine > 0 and cosine > 0 and near < 2):
        raise ArithmeticError("not between the turning point and pi/2 at this precision")
    phase = _turn(sine, cosine, z, a, b, gamma, back=fold.back)
    phase -= fold.phase(arb.pi(), lambda: quarter_phase(a, b, gamma))
    if fold.back:
        phase = -phase
    speed = ((a + square) * z).sqrt() * inverse
    product, total = 2 * (1 + a) * (1 + gamma), 2 + a + gamma
    bend = (product * inverse - total) * inverse * inverse * b * sine * cosine
    reach = 2 * abs(phase * speed).upper()
    # Sine and cosine are Lipschitz with constant 1.
    around = arb(0, reach)
    fast, curved = flow(sine + around, cosine + around, a, b, gamma)
    if not abs(phase) * fast < reach:
        raise ArithmeticError("the flow is not enclosed")
    return near + phase * (speed + phase * (bend + phase * fast * curved / 6) / 2)


def flow(sine: arb, cosine: arb, a: arb, b: arb, gamma: arb) -> tuple[arb, arb]:
    """Return √G and G″, which bound Taylor's remainder.

    With w = 1/(1 − b sin²ψ), q = b sin 2ψ and K = (1+a)(1+γ), G = Kw² − (2+a+γ)w + 1 and w′ = qw².
    """
    square = b * sine * sine
    inverse = 1 / (1 - square)
    slope, product = 2 * b * sine * cosine, (1 + a) * (1 + gamma)
    by_inverse = 2 * product * inverse - (2 + a + gamma)
    bent = inverse * slope * slope * (by_inverse + product * inverse)
    second = 2 * inverse * inverse * (bent + by_inverse * (b - 2 * square))
    return ((a + square) * (gamma + square)).sqrt() * inverse, second


def quarter_phase(a: arb, b: arb, gamma: arb) -> arb:
    """Return the phase of the first quarter: F from ψ = 0, or from the turning point if γ < 0."""
    if gamma > 0:
        return _turn(arb(0), arb(1), gamma, a, b, gamma)
    return _turn((-gamma / b).sqrt(), (1 + gamma / b).sqrt(), arb(0), a, b, gamma)


def _turn(sine: arb, cosine: arb, z: arb, a: arb, b: arb, gamma: arb, *, back: bool = False) -> arb:
    """F, or 2Q − F if ``back``: by the Gauss transformation, near π/2 by Carlson's integrals."""
    tangent = sine / cosine
    square = tangent * tangent
    if (a + b) * square < 100 * a:
        return turn_by_gauss(tangent, z * (1 + square), a, b, gamma, balls, ball_ending(), back)
    at = amplitude(sine, cosine, z, a, b, gamma, balls)
    found = turn(by_flint(at, b / a), a, b, gamma, balls)
    return 2 * quarter_phase(a, b, gamma) - found if back else found
