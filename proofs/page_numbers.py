"""Numbers of the racket that articles and pages quote by name, computed here."""

from __future__ import annotations

from flint import arb, fmpq
from tresym.proofs.tables import digits_of, rounded_to

from tresym.racket.body import NAMED_BODIES
from tresym.reals.numbers.arithmetic import ball_precision, balls

DIGITS = 6


def named_numbers() -> dict[str, str]:
    """Compute the numbers that do not depend on verdicts.

    Returns:
        Text by name, rounded to the nearest, and under ``NAME_down`` and ``NAME_up`` rounded to
        either side, for sentences with "more than" or "at most": for each named body
        ``defect_NAME`` (ε₀ in radians), ``degrees_NAME`` (the same in degrees), ``misses_NAME``
        (2ε₀ in degrees), ``share_NAME`` (x in Δψ = π(1 − x)) and ``paper_error_NAME`` (error of the
        paper's formula, in per cent); the smallest defect of rigid bodies; and how many operations
        F and the float64 map take.
    """
    found: dict[str, str] = {}
    for name in NAMED_BODIES:
        found |= _of_body(name)
    with ball_precision(128):
        floor = 2 * (-arb.pi()).exp().atan()
        found |= _each_way("floor", floor, DIGITS)
        found |= _each_way("floor_degrees", 180 * floor / arb.pi(), 3)
        found |= _each_way("floor_misses", 360 * floor / arb.pi(), 3)
    from tresym.racket.comparison.operation_counts import map_operations, turn_calls

    found["calls_near"], found["calls_far"] = (str(turn_calls(g)) for g in (fmpq(0), fmpq(1, 100)))
    found["map_operations"] = str(map_operations())
    return found


def _of_body(name: str) -> dict[str, str]:
    from tresym.racket.flip.separatrix import solve
    from tresym.racket.formulas import printed

    shape = NAMED_BODIES[name].shape
    defect = solve(*shape, 50).defect
    with ball_precision(256):
        estimate = printed.asymptotic_defect(arb(shape.a), arb(shape.b), balls)
        values = {
            "defect": (defect, DIGITS),
            "degrees": (180 * defect / arb.pi(), 3),
            "misses": (360 * defect / arb.pi(), 3),
            "share": (2 * defect / arb.pi(), 3),
            "paper_error": (100 * (estimate / defect - 1), 2),
        }
        key = name.replace("-", "_")
        found: dict[str, str] = {}
        for kind, (value, digits) in values.items():
            found |= _each_way(f"{kind}_{key}", value, digits)
    return found


def _each_way(name: str, x: arb, digits: int) -> dict[str, str]:
    """Return a number as text, rounded to the nearest, down and up."""
    return {name: digits_of(x, digits)} | {
        f"{name}_{way}": rounded_to(x, digits, way) for way in ("down", "up")
    }
