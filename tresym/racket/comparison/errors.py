"""Certified errors of each formula for ε₀, shape by shape.

The relative error of a formula is formula/ε₀ − 1. The exact ε₀ is an expression, by the root of the
phase equation, and so is each formula; :func:`tresym.accuracy.values.certified` encloses them.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from flint import arb, fmpq

from tresym.accuracy.values import certified
from tresym.racket.flip import series, uniform
from tresym.racket.formulas import printed, stable
from tresym.reals.language.binders import root
from tresym.reals.language.expression import PI, Expr, number, symbol, trees

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


SMALLEST = 20_000
"""An error below 2 to the power of minus this is not told apart from 0."""


def exact_defect(a: fmpq, b: fmpq) -> Expr:
    """Return ε₀ of a shape as an expression with the root of the phase equation."""
    k, r = trees.sqrt(number(a * b)), trees.sqrt(number(b / a))
    phase = symbol("P")
    equation = phase - stable.phase_map(phase, k, r, trees)
    return stable.defect_at(root(equation, "P", PI, 3 * PI / 2), k, r, trees)


def relative_error(formula: Formula, a: fmpq, b: fmpq, digits: int = 4) -> arb:
    """Compute formula/ε₀ − 1 at a shape, to ``digits`` certified digits.

    Raises:
        InputError: the error is smaller than 10⁻⁶⁰⁰⁰ (it may be zero).
    """
    shown = formula(number(a), number(b), trees)
    return certified(shown / exact_defect(a, b) - 1, digits, smallest=SMALLEST)


def errors_at(a: fmpq, b: fmpq, digits: int = 4) -> dict[str, arb]:
    """Compute the relative error of every formula at a shape."""
    return {name: relative_error(formula, a, b, digits) for name, formula in FORMULAS.items()}


def _slopes(a: fmpq, b: fmpq) -> tuple[Expr, Expr]:
    """Return dε/dγ at γ = 0 as expressions: the closed form, and its leading term."""
    exact, p, q = exact_defect(a, b), number(a), number(b)
    rate = -printed.defect_per_turn(exact, p, q, number(1), trees)
    slope = rate * stable.turn_slope(exact, p, q, trees)
    return slope, printed.defect_slope_asymptotic(exact, q)


def slope_at(a: fmpq, b: fmpq, digits: int = 20) -> tuple[arb, arb]:
    """Return dε/dγ at γ = 0 in closed form, and its leading term −1/(4bε₀)."""
    slope, leading = (certified(e, digits) for e in _slopes(a, b))
    return slope, leading


def slope_with_error(a: fmpq, b: fmpq, digits: int = 4) -> tuple[arb, arb, arb]:
    """Return :func:`slope_at` and the relative error of the leading term, to certified digits.

    The error decreases like ε₀², so the precision is raised until it is distinguished from 0.
    """
    slope, leading = _slopes(a, b)
    error = certified(leading / slope - 1, digits, smallest=SMALLEST)
    return *slope_at(a, b), error


def linear_thresholds(a: fmpq, b: fmpq, digits: int = 20) -> tuple[arb, arb]:
    """Return the γ for which the printed linear formula gives ε = ∓π/12, from the exact ε₀."""
    exact, edge = exact_defect(a, b), PI / 12
    low, high = (certified(4 * number(b) * exact * (exact + e), digits) for e in (edge, -edge))
    return low, high
