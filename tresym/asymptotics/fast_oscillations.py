"""Decide approximations of fast oscillations (WKB, Liouville and Green) of initial value problems.

Example: the solution of y'' + k²(1 + x)²y = 0, y(0) = 1, y'(0) = 0 is
(1 + x)^(−1/2) cos(k(x + x²/2)) + O(1/k) as k → ∞, for each fixed x > 0. With t for 1/k, or a root
of a small parameter, the equation

    y'' + a y' + b y = f,   b = t^{−2m} b̂(x, t),   b̂ > 0,

has an energy E² = y'² + b y² that grows at most by a factor that does not depend on t (Gronwall).
Let Y = A cos(Θ/tᵖ) + B sin(Θ/tᵖ) with A, B and Θ smooth. If its residual is O(tᵏ⁻ᵐ), and its errors
at the start are O(tᵏ) and, of the slope, O(tᵏ⁻ᵐ), then y = Y + O(tᵏ), uniformly on every bounded
interval: the energy of the error is O(tᵏ⁻ᵐ), and the error is at most E/√b.

Source: F. W. J. Olver, *Asymptotics and Special Functions*, 1974, chapter 6.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.differential_problem import OpenError, Problem
from tresym.asymptotics.layer_problems import need_smooth_at_zero, power_of, said, smooth_part
from tresym.asymptotics.layer_sums import Part, Reader, known_sign
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.signs.interior import is_zero
from tresym.reals.verdict import Verdict

LEMMA = "energy of a fast oscillation (Liouville and Green; Olver 1974, chapter 6)"
HIGHEST = 4


class _Wave(NamedTuple):
    """A cos(Θ) + B sin(Θ) + C."""

    cos: Expr
    sin: Expr
    rest: Expr


def decide_oscillation(
    y: Expr, gauge: Expr, strict: bool, problem: Problem, small: str, inside: Given, fixed: Given
) -> Answer | None:
    """Decide y = Y + O(g), or o(g), for a fast oscillation; None if the problem is none.

    Args:
        y: the approximation.
        gauge: the comparison function.
        strict: whether the error must be of smaller order.
        problem: an initial value problem of second order that is linear.
        small: the small parameter, which is positive.
        inside: the conditions with the variable after the initial point.
        fixed: the conditions without the variable.

    Raises:
        OpenError: what is missing.
    """
    x = problem.time
    names = [problem.state[key] for key in sorted(problem.state)]
    right = problem.right[names[1]]
    parts = [tidied(-differentiate(right, name)) for name in reversed(names)]
    if any(set(names) & symbols(part) for part in parts):
        return None
    free = tidied(substitute(right, dict.fromkeys(names, ZERO)))
    trees = [*parts, free, y, gauge, *problem.values.values()]
    reader = Reader(x, small, inside, trees)
    slope, factor, _ = (smooth_part(reader, e, inside) for e in (*parts, free))
    if factor.power >= 0 or slope.power < 0:
        return None
    if factor.power % 2:
        root = symbol(small) ** number(fmpq(1, 2 * reader.q))
        reader = Reader(x, small, inside, [*trees, root])
        slope, factor, _ = (smooth_part(reader, e, inside) for e in (*parts, free))
    if known_sign(substitute(factor.factor, {reader.t: ZERO}), inside) <= 0:
        return None
    m = -factor.power // 2
    order = _order(reader, gauge, fixed) + strict
    if not 0 < order <= HIGHEST * reader.q:
        raise OpenError("the order of the error is not supported")
    wave, phase = _wave(reader, y)
    residual = _plus(
        _derivative(_derivative(wave, phase, x), phase, x),
        _times(parts[0], _derivative(wave, phase, x)),
        _times(parts[1], wave),
        _Wave(ZERO, ZERO, -free),
    )
    why = "the residual of the equation"
    _need(reader, residual, order - m, inside, inside, why)
    start = partial(substitute, mapping={x: problem.start})
    for k, name in enumerate(names):
        there = wave if k == 0 else _derivative(wave, phase, x)
        if not is_zero(start(phase), fixed):
            raise OpenError("the phase must be 0 at the initial point")
        error = start(there.cos) + start(there.rest)
        gap = _Wave(ZERO, ZERO, error - problem.values[name])
        what = "the error of the initial slope" if k else "the error of the initial value"
        _need(reader, gap, order - (m if k else 0), fixed, inside, what)
    shown = power_of(small, order, reader.q)
    why = (
        f"{said(y)} satisfies the equation and the initial values up to an error whose energy "
        f"makes one of {shown}, for each fixed {x}"
    )
    return Answer(Verdict.PROVED, why, lemma=LEMMA)


def _order(reader: Reader, gauge: Expr, fixed: Given) -> int:
    found = reader.read(gauge)
    if set(found) == {()}:
        v, g = found[()]
        if not symbols(g) & {reader.x, reader.t} and known_sign(g, fixed):
            return v
    raise OpenError("the comparison function must be a power of the parameter")


def _wave(reader: Reader, y: Expr) -> tuple[_Wave, Expr]:
    """Return the amplitudes of an approximation and its phase."""
    phases: dict[Expr, int] = {}
    known: dict[Expr, Expr] = {}
    cos, sin = symbol("[C]"), symbol("[S]")
    for node in set(operations((y,))):
        if node.op not in ("sin", "cos") or reader.small not in symbols(node):
            continue
        found = reader.read(node.args[0])
        if set(found) == {()} and found[()].power >= 0:
            continue
        angle = normal_form(node.args[0], reader.given)
        for other in (*phases, angle):
            for side in (1, -1):
                if is_zero(angle - side * other, reader.given):
                    phases.setdefault(other, 1)
                    known[node] = cos if node.op == "cos" else side * sin
                    break
            if node in known:
                break
    if len(phases) > 1:
        raise OpenError("approximations with one phase are supported")
    whole = replaced(y, known)
    a, b = (differentiate(whole, str(mark.args[0])) for mark in (cos, sin))
    if {"[C]", "[S]"} & (symbols(a) | symbols(b)):
        raise OpenError("the approximation must be linear in sine and cosine")
    rest = substitute(whole, {"[C]": ZERO, "[S]": ZERO})
    return _Wave(a, b, rest), next(iter(phases), ZERO)


def _derivative(wave: _Wave, phase: Expr, x: str) -> _Wave:
    turn = differentiate(phase, x)
    return _Wave(
        differentiate(wave.cos, x) + turn * wave.sin,
        differentiate(wave.sin, x) - turn * wave.cos,
        differentiate(wave.rest, x),
    )


def _times(factor: Expr, wave: _Wave) -> _Wave:
    return _Wave(*(factor * e for e in wave))


def _plus(*waves: _Wave) -> _Wave:
    total = _Wave(ZERO, ZERO, ZERO)
    for wave in waves:
        total = _Wave(*(e + f for e, f in zip(total, wave, strict=True)))
    return total


def _need(reader: Reader, wave: _Wave, below: int, given: Given, inside: Given, what: str) -> None:
    """Require that the Taylor coefficients below an order vanish.

    Raises:
        OpenError: one is not shown to vanish.
    """
    for e in wave:
        found = reader.read(e)
        if found and set(found) != {()}:
            raise OpenError("amplitudes must be smooth in the parameter")
        part = found.get((), Part(0, ZERO))
        need_smooth_at_zero(reader, part.factor, inside)
        for power, c in reader.coefficients(part, below):
            if not is_zero(c, given & reader.given):
                size = power_of(reader.small, power, reader.q)
                raise OpenError(f"{what} is ({tidied(c)})*{size} to leading order")
