"""Compute ε(γ) for every γ in [−b, a] as a ball with any number of digits.

ε(γ) is read on the symmetric trajectory through ψ = π/2 at φ = 0, half a turn before: with the
phase φ(u) of :mod:`tresym.racket.motion.orbit`, ε = ψ(u) where φ(u) = −π. It exists and is unique,
as φ(u) increases strictly. Where the trajectory has not turned this is the paper's F(ε, γ) = π,
elsewhere it is folded to that (:mod:`tresym.racket.flip.phase_folding`), and one evaluation of F or
two are enough (:func:`quick`). Where that does not do, at γ* and at the ends of the range, φ is
inverted.
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
"""Bits of working precision at which a request is given up."""

FLOAT_BITS = 46
"""Bits of the float64 start that are taken to be right; nothing rests on it but speed."""


class Defect(NamedTuple):
    """Balls around ε and the flip Δψ = π − 2ε (radians)."""

    defect: arb
    flip: arb


def checked_gamma(a: fmpq, b: fmpq, gamma: fmpq) -> fmpq:
    """``gamma`` if it is in [−b, a]; InputError otherwise."""
    if (gamma + b).p < 0 or (a - gamma).p < 0:  # as integers, whose signs are known at once
        low, high = (shortened(fraction_text(end)) for end in (-b, a))
        raise InputError(f"gamma: must be between -b and a, here between {low} and {high}")
    return gamma


def solve(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect:
    """ε(γ) and the flip, each to ``digits`` certified digits: :func:`quick`, or :func:`inverted`.

    Raises:
        InputError: γ outside [−b, a].
        ArithmeticError: the precision limit is reached.
    """
    checked_gamma(a, b, gamma)
    return quick(a, b, gamma, digits) or inverted(a, b, gamma, digits)


def inverted(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect:
    """ε(γ) at any γ in [−b, a], by inverting the phase at rising precision.

    At γ = −b, which is the stable rotation ψ = π/2, the flip is 0. Elsewhere one that cannot be
    told from 0 at eight times the precision the digits need is only shown to be below 10^−digits.

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
    """Whether ``x`` proves the digits, or cannot be told from 0 at eight times what they need."""
    if proves(x, digits):
        return True
    small = arb(fmpq(1, 10) ** digits)
    return precision > 8 * bits(digits, 48) and x.contains(0) and bool(x.rad() < small)


def defect_on(a: fmpq, b: fmpq, level: Level) -> arb:
    """ε of a level −b < γ ≤ a, at the working precision, by inverting the phase.

    Raises:
        ArithmeticError: the precision does not suffice.
    """
    on = orbit(a, b, level)
    return arb.pi() / 2 - angle_at(on, time_of(on, arb.pi()))


def quick(a: fmpq, b: fmpq, gamma: fmpq, digits: int) -> Defect | None:
    """ε(γ) from F in the first quarter, where π is folded to; beyond a half period from its Q too.

    A float64 solution is corrected by the Taylor series of the flow dψ/dφ, of which the phase that
    is missing is the argument; each round quadruples the digits. None where float64 has no
    solution, or the digits are not reached (at γ* and at the ends of the range of γ).
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
    """Precisions that each quadruple what is known, from float64; the last is one to spare."""
    rounds = [precision]
    while rounds[0] > 4 * FLOAT_BITS + 10:
        rounds.insert(0, rounds[0] // 4 + 10)
    return (*rounds, precision + precision // 4 + 32)


def unfolded(angle: arb, fold: Fold) -> Defect:
    """ε = s e + nπ and π − 2ε."""
    sign, turns = fold.unfolding
    angle, pi = sign * angle, arb.pi()
    if not turns:
        return Defect(angle, pi - 2 * angle)
    return Defect(angle + turns * pi, (1 - 2 * turns) * pi - 2 * angle)


def corrected(a: arb, b: arb, gamma: arb, near: arb, fold: Fold) -> arb:
    """The folded angle from the exact point ``near``, at the working precision.

    ψ(φ) solves ψ′ = √G(ψ), ψ″ = G′/2, ψ‴ = G″ψ′/2, G = (a + bs²)(γ + bs²)/(1 − bs²)²; the solution
    from ``near`` is there after the phase h that F(near, γ) has too much (on the way back, that
    2Q − F has too little). By the mean value theorem it stays among the angles within r of
    ``near`` if |h| √G < r for all of them, and Taylor's remainder is taken there.

    Raises:
        ArithmeticError: nothing is shown (turning point, or precision too low).
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
    # Within ``reach`` of the angle, sine and cosine change by no more.
    around = arb(0, reach)
    fast, curved = flow(sine + around, cosine + around, a, b, gamma)
    if not abs(phase) * fast < reach:
        raise ArithmeticError("the flow is not enclosed")
    return near + phase * (speed + phase * (bend + phase * fast * curved / 6) / 2)


def flow(sine: arb, cosine: arb, a: arb, b: arb, gamma: arb) -> tuple[arb, arb]:
    """√G and G″, for the remainder.

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
    """The phase of the first quarter: F from ψ = 0, or from the turning point where γ < 0."""
    if gamma > 0:
        return _turn(arb(0), arb(1), gamma, a, b, gamma)
    return _turn((-gamma / b).sqrt(), (1 + gamma / b).sqrt(), arb(0), a, b, gamma)


def _turn(sine: arb, cosine: arb, z: arb, a: arb, b: arb, gamma: arb, *, back: bool = False) -> arb:
    """F, or 2Q − F: by the Gauss transformation, but where the angle is near π/2."""
    tangent = sine / cosine
    square = tangent * tangent
    if (a + b) * square < 100 * a:
        return turn_by_gauss(tangent, z * (1 + square), a, b, gamma, balls, ball_ending(), back)
    at = amplitude(sine, cosine, z, a, b, gamma, balls)
    found = turn(by_flint(at, b / a), a, b, gamma, balls)
    return 2 * quarter_phase(a, b, gamma) - found if back else found
