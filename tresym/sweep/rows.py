"""The rows of a sweep: certified or float64 numbers.

A row depends on its entry and the digits only, so it is the same wherever it is computed.
"""

from __future__ import annotations

import math
import threading
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.racket.body import Shape
from tresym.racket.flip import uniform
from tresym.racket.flip.defect import checked_gamma
from tresym.racket.flip.model_selection import climb
from tresym.racket.flip.phase_folding import float_defect
from tresym.racket.formulas import printed, stable
from tresym.reals.numbers.arithmetic import ball_precision, balls, bits
from tresym.reals.numbers.exact import InputError, decimal_ball, fraction_text
from tresym.sweep.source import Entry, Part

ERROR_BITS = 128
"""Working precision in bits of the errors, which have six digits."""

FLOAT_DIGITS = 15

FLOAT_NOISE = 1e-10
"""Smaller relative errors are left out in float64, where rounding contributes about 1e-13."""

_one_at_a_time = threading.Lock()
"""The working precision belongs to the process, so its threads compute in turn."""


class SweepRow(NamedTuple):
    """A row of the table: text, numbers, and None where a column does not apply.

    ``defect`` and ``radius`` (radians) are decimal text; the true value is within ``radius`` of
    ``defect``. In float64 ``defect`` is a float and ``radius`` None, and the table has a column
    ``defect_float64`` instead of the two. Each ``error_…`` is formula/ε − 1 to six digits (in
    float64 to 1e-12), or None if the digits do not suffice to show it. On the separatrix the
    formulas are the paper's asymptotic one, its correct leading term, and the explicit formulas for
    all shapes; elsewhere it is the paper's formula linear in γ.
    """

    line: int
    name: str | None
    a: str | None = None
    b: str | None = None
    gamma: str | None = None
    defect: str | float | None = None
    radius: str | None = None
    rung: str | None = None
    realizable: bool | None = None
    error_paper: float | None = None
    error_leading: float | None = None
    error_one_line: float | None = None
    error_balanced: float | None = None
    error_one_step: float | None = None
    error_linear: float | None = None
    problem: str | None = None


def _leading(a: Any, b: Any, m: Any) -> Any:
    return stable.leading_term(m.sqrt(a * b), m.sqrt(b / a), m)


FORMULAS: dict[str, Callable[[Any, Any, Any], Any]] = {
    "error_paper": printed.asymptotic_defect,
    "error_leading": _leading,
    "error_one_line": uniform.one_line,
    "error_balanced": uniform.balanced,
    "error_one_step": uniform.one_step,
}


def compute(part: Part, digits: int | None) -> list[SweepRow]:
    """Compute the rows of a part.

    Args:
        part: the entries to compute.
        digits: certified digits; None for float64.
    """
    with _one_at_a_time:
        entries = list(part.entries())
        if digits is None:
            return float_rows(entries)
        return [certified_row(entry, digits) for entry in entries]


def certified_row(entry: Entry, digits: int) -> SweepRow:
    """Compute one row in ball arithmetic, to ``digits`` certified digits."""
    row = _blank(entry)
    if row.problem is not None:
        return row
    shape, gamma = _asked(entry)
    try:
        answer = climb(shape, gamma, digits)
        errors = _certified_errors(shape, gamma, answer.defect, digits)
    except (InputError, ArithmeticError) as error:
        return row._replace(problem=_one_line(error))
    with ball_precision(bits(digits, 64)):
        mid, rad = decimal_ball(answer.defect, digits)
    return row._replace(defect=mid, radius=rad, rung=answer.model, **errors)


def _certified_errors(shape: Shape, gamma: fmpq, defect: arb, digits: int) -> dict[str, Any]:
    if gamma != 0:
        middle = climb(shape, 0, digits).defect
        with ball_precision(ERROR_BITS):
            estimate = printed.linear_defect(middle, arb(shape.b), arb(gamma))
            return {"error_linear": _shown_error(estimate / defect - 1)}
    with ball_precision(ERROR_BITS):
        a, b = arb(shape.a), arb(shape.b)
        return {
            name: _shown_error(formula(a, b, balls) / defect - 1)
            for name, formula in FORMULAS.items()
        }


def _shown_error(error: arb) -> float | None:
    """An error to six digits, or None if its ball does not show them."""
    if not error.is_finite() or error.rel_accuracy_bits() < 24:
        return None
    return _six_digits(float(error))


def _float_error(error: float) -> float | None:
    """An error computed in float64, or None if most of it is rounding."""
    return _six_digits(error) if abs(error) > FLOAT_NOISE else None


def _six_digits(error: float) -> float | None:
    return float(f"{error:.6g}") if math.isfinite(error) else None


def float_rows(entries: Sequence[Entry]) -> list[SweepRow]:
    """Compute rows in float64: those on the separatrix all at once, the others one by one."""
    rows = [_blank(entry) for entry in entries]
    level = []
    for i, entry in enumerate(entries):
        if rows[i].problem is not None:
            continue
        if entry.gamma == 0:
            level.append(i)
        else:
            rows[i] = _float_row(rows[i], *_asked(entry))
    shapes = [_asked(entries[i])[0] for i in level]
    for i, found in zip(level, _on_separatrix(shapes), strict=True):
        rows[i] = rows[i]._replace(**found)
    return rows


def _on_separatrix(shapes: list[Shape]) -> list[dict[str, Any]]:
    """ε₀ and the errors of the formulas for many shapes in numpy, after two more Newton steps."""
    import numpy as np

    a = np.array([_float(shape.a) for shape in shapes])
    b = np.array([_float(shape.b) for shape in shapes])
    with np.errstate(all="ignore"):
        k, r = np.sqrt(a) * np.sqrt(b), np.sqrt(b / a)
        phase = uniform.newton_phase(np.pi, k, r, np)
        for _ in range(2):
            residual = phase - stable.phase_map(phase, k, r, np)
            phase = phase - residual / stable.phase_slope(phase, k, r, np)
        defect = stable.defect_at(phase, k, r, np)
        errors = [
            list(map(_float_error, (formula(a, b, np) / defect - 1).tolist()))
            for formula in FORMULAS.values()
        ]
    found: list[dict[str, Any]] = []
    for value, *row in zip(defect.tolist(), *errors, strict=True):
        if not value >= 1e-300:
            found.append({"problem": "the defect is too small for float64; use --digits"})
            continue
        found.append({"defect": value, "rung": "float64"} | dict(zip(FORMULAS, row, strict=True)))
    return found


def _float_row(row: SweepRow, shape: Shape, gamma: fmpq) -> SweepRow:
    """A row off the separatrix; if float64 arithmetic fails, a certified value is rounded."""
    try:
        checked_gamma(*shape, gamma)
        value, rung = float_defect(*map(_float, (*shape, gamma))), "float64"
        if value is None:
            answer = climb(shape, gamma, FLOAT_DIGITS)
            value, rung = float(answer.defect), answer.model
        middle = float(climb(shape, 0, FLOAT_DIGITS).defect)
        error = printed.linear_defect(middle, _float(shape.b), _float(gamma)) / value - 1
    except (InputError, ArithmeticError) as error_:
        return row._replace(problem=_one_line(error_))
    return row._replace(defect=value, rung=rung, error_linear=_float_error(error))


def _float(x: fmpq) -> float:
    """The nearest float64, infinite beyond its range."""
    try:
        return int(x.p) / int(x.q)
    except OverflowError:
        return math.copysign(math.inf, float(x.p > 0) - 0.5)


def _asked(entry: Entry) -> tuple[Shape, fmpq]:
    """Shape and γ of an entry without a problem."""
    assert entry.shape is not None
    assert entry.gamma is not None
    return entry.shape, entry.gamma


def _blank(entry: Entry) -> SweepRow:
    """The row before its numbers are computed."""
    if entry.shape is None or entry.gamma is None:
        return SweepRow(entry.line, entry.name, problem=entry.problem)
    a, b, gamma = entry.written or map(fraction_text, (*entry.shape, entry.gamma))
    return SweepRow(
        entry.line,
        entry.name,
        a,
        b,
        gamma,
        realizable=None if entry.problem else entry.shape.realizable,
        problem=entry.problem,
    )


def _one_line(error: Exception) -> str:
    return " ".join(str(error).split()) or type(error).__name__
