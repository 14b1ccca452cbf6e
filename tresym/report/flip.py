"""A flip as one reads it in a terminal."""

from __future__ import annotations

from flint import arb, fmpq

from tresym.output import bold, dim
from tresym.racket.formulas import printed
from tresym.racket.result import Flip, Journey, proves
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits
from tresym.reals.numbers.exact import decimal_ball, fraction_text

LONGEST_FRACTION = 24


def flip_text(answer: Flip, title: str, colour: bool = False) -> str:
    """The answer in lines for people; ``title`` says which body it is of."""
    with ball_precision(bits(answer.digits, 64)):
        rows = [
            ("shape", _shape(answer)),
            ("defect   ε", _radians(answer.defect, answer.digits)),
            ("flip    Δψ", _radians(answer.turn, answer.digits)),
            *_approximations(answer),
            ("rung", f"{answer.rung}: {answer.why}"),
            ("realizable", _realizable(answer)),
        ]
    lines = [f"  {dim(f'{label:<12}', colour)}{text}" for label, text in rows]
    return "\n".join([bold(title, colour), "", *lines]) + "\n"


def journey_text(answer: Journey, title: str, colour: bool = False) -> str:
    """Where a start comes to, in lines for people."""
    with ball_precision(bits(answer.digits, 64)):
        rows = [
            ("shape", _shape(answer)),
            ("flip    Δψ", _radians(answer.turn, answer.digits)),
            ("ends at  ψ", _radians(answer.psi, answer.digits)),
            ("         θ", _radians(answer.theta, answer.digits)),
            ("rung", f"{answer.rung}: {answer.why}"),
            ("realizable", _realizable(answer)),
        ]
    lines = [f"  {dim(f'{label:<12}', colour)}{text}" for label, text in rows]
    return "\n".join([bold(title, colour), "", *lines]) + "\n"


def _approximations(answer: Flip) -> list[tuple[str, str]]:
    """The defect and the flip as people say them, and what the paper's own formula would give."""
    if not proves(answer.defect, answer.digits):
        return []
    defect, turn, degree = answer.defect, answer.turn, arb.pi() / 180
    rows = [
        ("", f"ε ≈ {_short(defect / degree)}°,   Δψ ≈ {_short(turn / degree)}°"),
        ("", f"Δψ = π(1 {'−' if defect > 0 else '+'} {_short(abs(2 * defect / arb.pi()))})"),
    ]
    if answer.gamma != 0:
        return rows
    a, b = arb(answer.shape.a), arb(answer.shape.b)
    estimate = printed.asymptotic_defect(a, b, balls)
    error = 100 * (estimate / defect - 1)
    size = f"{float(abs(error)):.3g}"
    side = "large" if error > 0 else "small"
    return [
        *rows,
        ("paper", f"its asymptotic formula gives {_short(estimate)}, {size} % too {side}"),
    ]


def _short(x: arb) -> str:
    return str(x.str(6, radius=False))


def _shape(answer: Flip | Journey) -> str:
    parts = []
    gamma = answer.gamma
    named = [("a", answer.shape.a), ("b", answer.shape.b), ("γ", gamma)]
    for name, value in named:
        exact = fraction_text(value) if isinstance(value, fmpq) else ""
        if exact and "/" not in exact and len(exact) <= LONGEST_FRACTION:
            parts.append(f"{name} = {exact}")
        elif exact and len(exact) <= LONGEST_FRACTION:
            parts.append(f"{name} = {exact} ≈ {_short(arb(value))}")
        else:
            parts.append(f"{name} ≈ {_short(arb(value))}")
    return ",   ".join(parts)


def _radians(x: arb, digits: int) -> str:
    """A ball with every digit shown correct to within the radius beside it."""
    if not proves(x, digits):
        mid, rad = decimal_ball(x, digits)
        return f"{mid} ± {rad} rad"
    return x.str(max(digits, 2)).strip("[]").replace("+/-", "±") + " rad"


def _realizable(answer: Flip | Journey) -> str:
    if answer.realizable:
        return "yes: I₃ ≤ I₁ + I₂, so a rigid body can have this shape"
    return "no: b > 1/(a+2), that is I₃ > I₁ + I₂; no rigid body has exactly this shape"
