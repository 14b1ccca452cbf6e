"""Certified errors of each formula for ε₀, shape by shape.

The relative error of a formula is formula/ε₀ − 1, computed as a ball at increasing precision until
it proves the digits asked for.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb, fmpq

from tresym.racket.flip import series, uniform
from tresym.racket.flip.separatrix import solve
from tresym.racket.formulas import printed, stable
from tresym.racket.result import proves
from tresym.reals.numbers.arithmetic import ball_precision, balls

Formula = Callable[[Any, Any, Any], Any]

FORMULAS: dict[str, Formula] = {
    "printed": printed.asymptotic_defect,
    "leading": lambda a, b, m: stable.leading_term(m.sqrt(a * b), m.sqrt(b / a), m),
    "first order": lambda a, b, m: series.expansion(1, a, b, m),
    "second order": lambda a, b, m: series.expansion(2, a, b, m),
    "third order": lambda a, b, m: series.expansion(3, a, b, m),
    "one line": uniform.one_line,
    "balanced": uniform.balanced,
    "Newton": uniform.one_step,
}
"""The formulas compared, by name; each is a function of a, b and the arithmetic."""

PRODUCTS = tuple(fmpq(10) ** n for n in range(-3, 5))
"""The values of ab at which the formulas are compared, 10⁻³ … 10⁴."""

WIDTHS = (fmpq(1), fmpq(1, 2), fmpq(1, 10), fmpq(1, 100))
"""The values of b."""


def relative_error(formula: Formula, a: fmpq, b: fmpq, digits: int = 4) -> arb:
    """Compute formula/ε₀ − 1 at a shape, to ``digits`` certified digits.

    Raises:
        ArithmeticError: the error is smaller than 10⁻⁶⁰⁰⁰⁰ of ε₀ (it may be zero).
    """
    working = 60
    while working < 70_000:
        exact = solve(a, b, working).defect
        with ball_precision(4 * working + 64):
            error = formula(arb(a), arb(b), balls) / exact - 1
            if proves(error, digits) and not error.contains(0):
                return error
        working *= 2
    raise ArithmeticError("the relative error is too small to be told from zero")


def errors_at(a: fmpq, b: fmpq, digits: int = 4) -> dict[str, arb]:
    """Compute the relative error of every formula at a shape."""
    return {name: relative_error(formula, a, b, digits) for name, formula in FORMULAS.items()}


def slope_at(a: fmpq, b: fmpq, digits: int = 20) -> tuple[arb, arb]:
    """Return dε/dγ at γ = 0 in closed form, and its leading term −1/(4bε₀)."""
    exact = solve(a, b, digits + 10).defect
    with ball_precision(4 * digits + 128):
        p, q = arb(a), arb(b)
        rate = -printed.defect_per_turn(exact, p, q, 1, balls)
        slope = rate * stable.turn_slope(exact, p, q, balls)
        return slope, printed.defect_slope_asymptotic(exact, q)


def slope_with_error(a: fmpq, b: fmpq, digits: int = 4) -> tuple[arb, arb, arb]:
    """Return :func:`slope_at` and the relative error of the leading term, to certified digits.

    The error decreases like ε₀², so the precision is raised until it is distinguished from 0.
    """
    working = 20
    while True:
        slope, leading = slope_at(a, b, working)
        with ball_precision(4 * working + 128):
            error = leading / slope - 1
        if proves(error, digits) and not error.contains(0):
            return slope, leading, error
        working *= 2


def linear_thresholds(a: fmpq, b: fmpq, digits: int = 20) -> tuple[arb, arb]:
    """Return the γ for which the printed linear formula gives ε = ∓π/12, from the exact ε₀."""
    exact = solve(a, b, digits + 10).defect
    with ball_precision(4 * digits + 128):
        edge = balls.pi / 12
        return 4 * arb(b) * exact * (exact + edge), 4 * arb(b) * exact * (exact - edge)
