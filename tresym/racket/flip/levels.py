"""The levels γ at which ε(γ) changes character, and the inverse function γ(ε).

φ_K is the phase from ψ = π/2 to the turning point of an oscillating orbit, Φ(π/2, γ) of the file
proofs/turning.tresym. It rises strictly with γ on (−b, 0) (claim `phase_rises_in_gamma`), from
φ_K(−b) = π(1−b)/(2√(b(a+b))) (`phase_at_bottom`) to infinity, so that at most one level has
φ_K = π/n, and it is found by one change of sign: γ* for n = 1, γ° for n = 2, γ** for n = 3.

- γ > γ*: the trajectory has not turned, F(ε, γ) = π, and dε/dγ < 0 (`rotating_decrease`,
  `unturned_decrease`);
- γ° < γ ≤ γ*: it has turned once, and dε/dγ < 0 still (`turned_decrease`); ε(γ°) = π/2;
- γ < γ°: ε > π/2 as long as φ_K > π/4 (`beyond_right_angle`), and ε rises at γ**
  (`slope_at_turns`): it goes up and down, within [ψ_min, π − ψ_min].

So ε(γ) decreases strictly on [γ°, a] (`decrease_in_gamma`), on all of (−b, a] where there is no γ°,
which is for b ≤ 1/(a+2), the shapes of rigid bodies (`decrease_of_bodies`). A value of at most π/2
is taken at one γ with φ_K > π/4, which is the largest with that value (`one_level`). Values above
π/2 are taken only where ε(γ) is not monotone, and are not looked for.
Levels are computed in x = log of the odds
(γ+b)/(−γ) or (a−γ)/γ, in which all this is nearly linear.
"""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from itertools import count

from flint import arb, fmpq

from tresym.racket.angle import Angle
from tresym.racket.flip.defect import PRECISION_LIMIT, defect_on
from tresym.racket.motion.orbit import Level, exact_level, orbit
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import InputError

RIGHT_ANGLE = Angle(fmpq(1, 2), fmpq(0))
MOST_STEPS = 64
"""Most Newton steps; from a good initial value about twelve are enough."""
FAR = arb((1, 40))
"""The search is restricted to odds between exp(−2⁴⁰) and exp(2⁴⁰)."""


def level_at(a: fmpq, b: fmpq, regime: int, x: arb) -> Level:
    """Return the level with (γ+b)/(−γ) = eˣ (``regime`` −1) or (a−γ)/γ = eˣ (``regime`` 1)."""
    odds = x.exp()
    if regime < 0:
        gamma = -b / (1 + odds)
        return Level(gamma, a - gamma, b * odds / (1 + odds), -1)
    gamma = a / (1 + odds)
    return Level(gamma, a * odds / (1 + odds), gamma + b, 1)


def turning_level(a: fmpq, b: fmpq, digits: int, turns: int = 1) -> arb | None:
    """Compute γ* < 0, the level on which the trajectory of ε(γ) begins at its turning point.

    Above γ* the trajectory has no turning point.

    Args:
        a: shape parameter.
        b: shape parameter.
        digits: certified digits of the level.
        turns: n gives the level with φ_K = π/n: γ* for 1; γ° for 2, below which ε(γ) is not
            monotone; γ** for 3, below which the trajectory has turned more than once.

    Returns:
        None if no level has φ_K = π/n.
    """
    # φ_K(−b) < π/turns, in rationals.
    if not turns * turns * (1 - b) ** 2 < 4 * b * (a + b):
        return None

    def excess(x: arb) -> arb:
        return orbit(a, b, level_at(a, b, -1, x)).quarter_phase - arb.pi() / turns

    return _level_by(excess, a, b, -1, digits)


def level_of(a: fmpq, b: fmpq, defect: Angle, digits: int) -> arb:
    """Compute the largest γ < a with ε(γ) = ``defect`` ≤ π/2, as a ball.

    It is the only such level with φ_K > π/4.

    Raises:
        InputError: a defect above π/2, where ε(γ) is not monotone, or a value that ε does not take;
            the message says which.
    """
    if defect == RIGHT_ANGLE:
        return _right_angle_level(a, b, digits)
    regime = _regime_of(a, b, defect)
    lowest = turning_level(a, b, 20, 3)

    def excess(x: arb) -> arb:
        # Increases with γ.
        return defect.ball() - defect_on(a, b, level_at(a, b, regime, x))

    with ball_precision(128):
        # Below γ** the same value may be taken many times.
        odds = None if lowest is None or regime > 0 else (lowest + b) / -lowest
        start = None if odds is None else odds.upper().log().upper()
    found = _level_by(excess, a, b, regime, digits, start)
    if lowest is not None and not found > lowest:
        raise ArithmeticError("the level found is not above the last turning level")
    return found


def _right_angle_level(a: fmpq, b: fmpq, digits: int) -> arb:
    """γ°, the level on which ε(γ) = π/2."""
    found = turning_level(a, b, digits, 2)
    if found is None:
        raise _out_of_range("less than pi/2")
    return found


def _out_of_range(limit: str) -> InputError:
    return InputError(
        f"defect: no level gamma on which epsilon is monotone has this defect; it must be {limit}"
    )


def _regime_of(a: fmpq, b: fmpq, defect: Angle) -> int:
    """1 if ε(γ) = ``defect`` for some γ > 0, −1 if for some γ < 0.

    Raises:
        InputError: no γ has this defect, or it is too near ε(0), ε(a) or π/2 to decide.
    """
    precision = 128
    while precision < PRECISION_LIMIT:
        with ball_precision(precision):
            value = defect.ball()
            middle = defect_on(a, b, exact_level(a, b, fmpq(0)))
            lowest = defect_on(a, b, exact_level(a, b, a))
            if value < lowest:
                raise _out_of_range(f"more than {lowest.str(8, radius=False)}")
            if lowest < value < middle:
                return 1
            if middle < value < arb.pi() / 2:
                return -1
            if value > arb.pi() / 2:
                raise _out_of_range("less than pi/2" if b * (a + 2) <= 1 else "at most pi/2")
        precision *= 2
    raise InputError(
        "defect: too near the defect of the separatrix, or pi/2, to be distinguished from it"
    )


def _level_by(
    excess: Callable[[arb], arb],
    a: fmpq,
    b: fmpq,
    regime: int,
    digits: int,
    start: arb | None = None,
) -> arb:
    """γ where the function ``excess`` of x vanishes, to ``digits`` digits.

    ``excess`` has exactly one sign change, above ``start`` if that is given, and is negative for
    lower γ. For b = 1 the level behaves like the cube root of the distance from ε = π/2, since the
    phase is stationary there. Newton's method then needs a very good initial value, so the number
    of correct bits of the initial value is doubled in each round.
    """
    precision, correct = bits(digits, 64), 30
    limit = 16 * precision
    with ball_precision(128):
        bracket = _bracket(excess, -regime, start)
    while precision < limit:
        with suppress(ArithmeticError):
            with ball_precision(4 * correct + 8):
                near = _refined(excess, *bracket, correct)
            x = _enclosed(excess, near, precision, correct)
            with ball_precision(precision):
                gamma = level_at(a, b, regime, x).gamma
            if proves(gamma, digits):
                return gamma
        precision, correct = precision + precision // 2, 2 * correct
    raise ArithmeticError("the precision limit is reached")


def _bracket(
    excess: Callable[[arb], arb], direction: int, start: arb | None = None
) -> tuple[arb, arb]:
    """Two points around the only sign change of ``excess``, found by doubling the distance.

    Args:
        excess: the function of x.
        direction: 1 if it changes from negative to positive, −1 if from positive to negative.
        start: a point below the sign change; None searches for one.

    Raises:
        ArithmeticError: there is no sign change within reach, or none above ``start``.
    """
    low, width = arb(-1) if start is None else start, arb(1)
    while not direction * excess(low) < 0:
        if start is not None or width > FAR:
            raise ArithmeticError("the level is not above the last turning level")
        low, width = low - width, 2 * width
    high, width = low + 1, arb(1)
    while not direction * excess(high) > 0:
        if width > FAR:
            raise ArithmeticError("no change of sign was found")
        high, width = high + width, 2 * width
    return low, high


def _refined(excess: Callable[[arb], arb], low: arb, high: arb, correct: int) -> arb:
    """A point within about 2^−``correct`` of the root, by the Illinois variant of regula falsi.

    Every third step bisects, since near a cube root the others move one end only slowly.
    """
    at_low, at_high = excess(low).mid(), excess(high).mid()
    before, here = low, high
    near = arb((1, -correct))
    for step in count(1):
        if abs(here - before) <= near or high - low <= near:
            break
        before, here = here, ((low * at_high - high * at_low) / (at_high - at_low)).mid()
        if step % 3 == 0:
            here = ((low + high) / 2).mid()
        value = excess(here).mid()
        if value == 0:
            break
        if (value > 0) == (at_high > 0):
            high, at_high, at_low = here, value, at_low / 2
        else:
            low, at_low, at_high = here, value, at_high / 2
    return here


def _enclosed(excess: Callable[[arb], arb], near: arb, precision: int, correct: int) -> arb:
    """The root as a ball, from a point with ``correct`` correct bits.

    Newton's method is followed by a proof that the signs at two points differ. The slope is a
    difference quotient over a step of a third of the working precision; the precision increases by
    one half in each step.

    Raises:
        ArithmeticError: no change of sign is proved.
    """
    work = 4 * correct + 8
    for _ in range(MOST_STEPS):
        work = min(work, precision)
        with ball_precision(work):
            apart = arb((1, -(work // 3)))
            value = excess(near)
            slope = (excess((near + apart).mid()) - value) / apart
            step = (value / slope).mid()
            near = (near - step).mid()
            if work == precision and abs(step) < arb((1, 16 - precision * 2 // 3)):
                width = abs(excess(near) / slope).abs_upper() * 4 + arb((1, 16 - precision))
                low, high = (near - width).mid(), (near + width).mid()
                if excess(low) * excess(high) < 0:
                    return low.union(high)
                raise ArithmeticError("no change of sign at this precision")
            if not step.is_finite() or (work == precision and abs(step) > 1):
                break
        work = work * 3 // 2
    raise ArithmeticError("Newton's method does not converge at this precision")
