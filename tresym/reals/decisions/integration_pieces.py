"""Where an interval of integration is cut: at zeros of absolute values, and at turns of angles."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import pairwise

from flint import fmpq

from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import preorder, singularities
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    HALF,
    LEAVES,
    ONE,
    PI,
    ZERO,
    Expr,
    apply,
    number,
    rebuild,
    sqrt,
    substitute,
    symbols,
)
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MINUS_INFINITY = -INFINITY
CUTS, DENOMINATOR = 12, 5040
"""Pieces into which an interval is cut at most."""
TURNS = 40
"""Multiples of π at which a sine or a cosine in the integrand is looked at."""


def pieces_of(
    name: str, parts: Iterable[Expr], low: Expr, high: Expr
) -> Iterator[tuple[Expr, Expr]]:
    """Yield the parts of the interval between the points where ``parts`` may be singular."""
    cuts: list[Expr] = []
    within = (c for c in _cuts(name, parts) if not symbols(c) and _is_between(low, c, high))
    for c in sorted(within, key=_middle):
        if not cuts or _is_between(cuts[-1], c, INFINITY):
            cuts.append(c)
    ends = [low, *cuts[:CUTS], high]
    yield from pairwise(ends)


def _middle(e: Expr) -> fmpq:
    with ball_precision():
        return evaluate(e, {}).mid().fmpq()


def _cuts(name: str, parts: Iterable[Expr]) -> Iterator[Expr]:
    """Points, some of them within the interval, at which a part may be singular."""
    for part, _ in (found for f in parts for found in singularities(f)):
        for cut in (*solutions(part, name), *_roots(part, name), *_turns(part, name)):
            form = normal_form(cut, Given())  # π/2 for acos(0)
            yield form if form.size <= cut.size + 2 else cut


def roots_of_squares(f: Expr, inside: Given) -> Iterator[tuple[Expr, Expr]]:
    """Square roots in ``f``, and the absolute values that they are: √(1 − sin²x) is |cos x|."""
    for root in dict.fromkeys(preorder(f)):
        if root.op != "^" or root.args[1] != HALF:
            continue
        (u, _) = root.args
        waves = {node.args[0] for node in preorder(u) if node.op in ("sin", "cos")}
        bases = [(ONE, apply(wave, a)) for a in waves for wave in ("cos", "sin")]
        bases += [
            (sqrt(number(2)), apply(wave, a / 2 + turn))
            for a in waves
            for turn in (ZERO, PI / 4)
            for wave in ("cos", "sin")
        ]
        if u.op == "^" and u.args[1].op == "number":
            bases.append((ONE, u.args[0] ** (u.args[1].args[0] / 2)))
        if not bases or continuous_on(u, inside) is not None:
            continue
        for scale, base in bases:
            if decide(u, (scale * base) ** 2, inside).verdict is Verdict.PROVED:
                yield root, scale * apply("abs", base)
                break


def _roots(part: Expr, name: str) -> Iterator[Expr]:
    """Zeros of what is linear or quadratic in the variable."""
    at = {name: ZERO}
    slope = differentiate(part, name)
    bend = differentiate(slope, name)
    if name in symbols(differentiate(bend, name)) or name in symbols(substitute(bend, at) - bend):
        return
    try:
        a, b, c = (decided_number(substitute(e, at)) for e in (bend / 2, slope, part))
    except InputError:
        return
    if a is None or b is None or c is None:
        return
    if a != 0 and b * b >= 4 * a * c:
        for side in (1, -1):
            yield (-number(b) + side * sqrt(number(b * b - 4 * a * c))) / number(2 * a)
    elif b != 0:
        yield number(-c / b)


def decided_number(e: Expr) -> fmpq | None:
    """The rational number that ``e`` is by its exact value in balls; None if it is no such."""
    if symbols(e):
        return None
    with ball_precision():
        ball = evaluate(e, {})
        multiple = (ball * DENOMINATOR).unique_fmpz() if ball.is_finite() else None
    return None if multiple is None else fmpq(int(multiple), DENOMINATOR)


def _turns(part: Expr, name: str) -> Iterator[Expr]:
    """Zeros of the sine or cosine of an expression that is linear in the variable."""
    if part.op not in ("sin", "cos"):
        return
    inner = part.args[0]
    slope = differentiate(inner, name)
    if symbols(slope):
        return
    start = substitute(inner, {name: ZERO})
    for n in range(-TURNS, TURNS + 1):
        half = fmpq(1, 2) if part.op == "cos" else fmpq(0)
        yield ((half + n) * PI - start) / slope


def _is_between(low: Expr, c: Expr, high: Expr) -> bool:
    with ball_precision():
        at = evaluate(c, {})
        if symbols(low) - {INFINITY.args[0]} or symbols(high) - {INFINITY.args[0]}:
            return False
        over = low == MINUS_INFINITY or bool(at > evaluate(low, {}))
        return at.is_finite() and over and (high == INFINITY or bool(at < evaluate(high, {})))


def without_corners(e: Expr, given: Given) -> Expr:
    """``e`` without the absolute values and signs of what has one sign."""
    if e.op in LEAVES:
        return e
    args = tuple(without_corners(arg, given) for arg in e.args)
    if e.op in ("abs", "sign"):
        its_sign = sign(args[0], given)
        if its_sign in ("+", "-") or (e.op == "abs" and its_sign in ("0", ">=0", "<=0")):
            up = 1 if its_sign in ("+", "0", ">=0") else -1
            return up * args[0] if e.op == "abs" else number(up)
    return rebuild(e, args)
