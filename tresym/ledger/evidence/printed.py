"""Printed numbers: what the paper prints, checked against what its inputs allow.

Inputs and outputs are intervals of half a unit in their last printed place. A printed value is
REFUTED only if no inputs that round to the printed inputs give it, and accepted (ENCLOSED) only
with exact inputs, inside those intervals, whose value is inside the printed interval.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import product

from flint import arb, fmpq

from tresym.ledger.claim import Printed
from tresym.ledger.finding import Finding
from tresym.reals.balls.boxes import halves, inconsistent
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits
from tresym.reals.numbers.exact import Interval, decimal_ball, printed
from tresym.reals.verdict import Verdict

DIGITS = 50
BITS = 128
GRID = 12
"""Inputs are tried on a grid of this many steps along each side of their box."""
HALVINGS = 40
WIDEST = 2
"""A printed value is taken to half a unit of its last place, or where it says so to a whole one."""
CELLS = 4096
"""At most this many cells when the range over the box of inputs is enclosed."""

Box = tuple[Interval, ...]


def judge_printed(number: Printed) -> Finding:
    """The verdict on one printed number, with its value at the inputs as printed."""
    if not 1 <= number.half_units <= WIDEST:
        return Finding(Verdict.UNDECIDED, f"{number.half_units} half units are no last place")
    target = _target(number)
    box = tuple(_interval(v) for v in number.inputs.values())
    centre = tuple((i.low + i.high) / 2 for i in box)
    with ball_precision(bits(DIGITS, 64)) as m:
        why = inconsistent(number.formula, box)
        if why is not None:
            return Finding(Verdict.UNDECIDED, why)
        value = decimal_ball(number.formula(*(arb(p) for p in centre), m), DIGITS)
    # The whole box at once: cheap, and no inputs need be looked for where it misses.
    missed = _misses(number, box, target)
    witness = None if missed else _find_inputs(number, box, target)
    if witness is not None:
        names = dict(zip(number.inputs, witness, strict=True))
        exact = "the inputs as printed" if witness == centre else "inputs that round to them"
        why = f"{exact} give a value that {_near(number)}"
        return Finding(Verdict.ENCLOSED, why, value=value, witness=names)
    if missed or _excluded(number, box, target):
        point = dict(zip(number.inputs, centre, strict=True))
        why = f"no inputs that round to the printed ones give {number.text}; as printed they give "
        return Finding(Verdict.REFUTED, why + value.mid[:12], value=value, witness=point)
    return Finding(Verdict.UNDECIDED, "neither inputs nor an exclusion were found", value=value)


def _near(number: Printed) -> str:
    if number.half_units == 1:
        return f"rounds to {number.text}"
    return f"is {number.text} to within {number.half_units} half units of its last place"


def _target(number: Printed) -> Interval:
    interval = printed(number.text)
    centre = (interval.low + interval.high) / 2
    half = (interval.high - interval.low) / 2 * number.half_units
    return Interval(centre - half, centre + half)


def _interval(value: str | fmpq) -> Interval:
    return printed(value) if isinstance(value, str) else Interval(value, value)


def _find_inputs(number: Printed, box: Box, target: Interval) -> tuple[fmpq, ...] | None:
    """Exact inputs in the box whose value lies in the printed interval, centre first.

    Where no point of the grid will do, the segment between a point below and one above is halved.
    """
    below: tuple[fmpq, ...] | None = None
    above: tuple[fmpq, ...] | None = None
    for point in _grid(box):
        side = _side(number, point, target)
        if side == 0:
            return point
        below, above = (point, above) if side == -1 else (below, point) if side else (below, above)
    for _ in range(HALVINGS):
        if below is None or above is None:
            return None
        middle = tuple((p + q) / 2 for p, q in zip(below, above, strict=True))
        side = _side(number, middle, target)
        if side == 0:
            return middle
        below, above = (middle, above) if side == -1 else (below, middle)
    return None


def _side(number: Printed, point: tuple[fmpq, ...], target: Interval) -> int | None:
    """0 inside the printed interval, −1 below it, 1 above it, None where a ball cannot tell."""
    with ball_precision(BITS) as m:
        value = number.formula(*(arb(p) for p in point), m)
        if value > target.low and value < target.high:
            return 0
        return -1 if value < target.low else 1 if value > target.high else None


def _grid(box: Box) -> Iterator[tuple[fmpq, ...]]:
    yield tuple((i.low + i.high) / 2 for i in box)
    steps = GRID if len(box) <= 2 else 4
    sides = [
        [i.low]
        if i.low == i.high
        else [i.low + (i.high - i.low) * n / steps for n in range(steps + 1)]
        for i in box
    ]
    yield from product(*sides)


def _excluded(number: Printed, box: Box, target: Interval) -> bool:
    """True when balls over the whole box of inputs stay outside the printed interval."""
    pending, seen = [box], 0
    while pending:
        cell = pending.pop()
        seen += 1
        if _misses(number, cell, target):
            continue
        widest = max(range(len(cell)), key=lambda n: cell[n].high - cell[n].low, default=None)
        if widest is None or cell[widest].low == cell[widest].high or seen > CELLS:
            return False
        pending.extend(halves(cell, widest))
    return True


def _misses(number: Printed, cell: Box, target: Interval) -> bool:
    """True when the ball over a box of inputs stays outside the printed interval."""
    with ball_precision(BITS):
        value = number.formula(*(i.ball() for i in cell), balls)
        return bool(value.is_finite() and (value > target.high or value < target.low))
