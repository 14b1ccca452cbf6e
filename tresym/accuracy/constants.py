"""Enclose the best constant of an approximation from both sides, also for roots and integrals.

The best constant of ``exact == approx + O(gauge)`` on a region is the supremum of
|exact − approx|/|gauge| there. For explicit expressions see
:mod:`tresym.asymptotics.constants`. If roots of equations or integrals occur, and the difference f
is analytic at the end of the path, the same subdivision is used with the Taylor coefficients of
:mod:`tresym.reals.values.jets`. The coefficients of f below the order of the gauge must be exactly
0, which no ball shows: each is differentiated symbolically (implicitly, or under the integral), put
at the end, and proved to be 0 by :func:`tresym.check`.

Example: for the root y of y − e sin y = 1, y = 1 + e sin 1 + O(e²) with the best constant on
0 < e ≤ 1/2 between 0.4546 and 0.4604.
"""

from __future__ import annotations

from flint import arb, fmpq

from tresym.accuracy.values import certified, read
from tresym.asymptotics.constants import Constant, along, as_constant, reach_of, rounded
from tresym.asymptotics.constants import constant as of_explicit
from tresym.asymptotics.sharp_constants import CLOSE, SHARP
from tresym.checking import check
from tresym.reals.decisions.closed_values import RULES, certified_evaluation
from tresym.reals.decisions.path_regions import interval_of, reaches_end
from tresym.reals.decisions.root_values import by_leibniz
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.domain.operation_domains import operations
from tresym.reals.expansions.maxima import Evaluations, exact_ends
from tresym.reals.expansions.scale import T
from tresym.reals.expansions.suprema import Evaluation, Supremum, supremum
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    number,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse_given
from tresym.reals.language.paths import Path, read_path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError
from tresym.reals.numbers.exact import near as simplest
from tresym.reals.signs.interior import is_zero
from tresym.reals.values.exact_values import rational
from tresym.reals.values.jets import Jets

MORE = 8
"""The Taylor coefficients beyond the order of the gauge."""
TERMS = (8,)
HIGHEST = 12
"""The highest order of a gauge whose coefficients are proved to be 0."""
SECONDS = 5.0
RANGES = (fmpq(1), fmpq(1, 2), fmpq(1, 4), fmpq(1, 8))
"""The ranges that are tried if no region is asked for."""


def constant(
    exact: str | Expr, approx: str | Expr, gauge: str | Expr, path: str | Path, region: str = ""
) -> Constant | None:
    """Return the best constant of ``exact == approx + O(gauge)`` along a path, from both sides.

    Args:
        exact, approx: the expressions, in the variable of the path alone.
        gauge: the comparison function.
        path: such as ``"x -> 0+"``.
        region: such as ``"0 < x <= 1/2"``; it reaches to the end of the path. If it is empty, the
            longest of a few ranges is chosen on which the constant is found.

    Returns:
        Bounds ``low`` and ``high`` that differ by at most 2 %, the region, and where the supremum
        is taken; None if the order is not shown or the supremum is not found.

    Raises:
        InputError: something cannot be read, or the region does not reach the end of the path.

    Example:
        >>> import tresym
        >>> found = tresym.constant("tan(x)", "x", "x**3", "x -> 0+", "0 < x <= 1")
        >>> found.low, found.high
        ('0.557407', '0.557603')
    """
    f, g = read(exact) - read(approx), read(gauge)
    way = read_path(path) if isinstance(path, str) else path
    if region and _is_natural(region, way):
        return _on_interval(f, g, way, region)
    if elementary(f, g):
        explicit = of_explicit(f, g, way, region)
        return _on_interval(f, g, way, region) if explicit is None and region else explicit
    if (symbols(f) | symbols(g)) - {way.name, INFINITY.args[0]} or _has_infinite_end(f):
        return None
    asked = reach_of(parse_given(region), way) if region else way.reach
    for reach in (asked,) if asked else RANGES:
        found = [(side, _one_sided(f, g, way, side, reach)) for side in way.sides]
        kept = [(side, one) for side, one in found if one is not None]
        if len(kept) == len(found):
            return as_constant(kept, way, reach)
    return None


def _is_natural(region: str, path: Path) -> bool:
    """Whether a region is an interval around or beside the end that reach_of does not read."""
    links = parse_given(region)
    try:
        reach_of(links, path)
    except InputError:
        return reaches_end(links, path)
    return False


def _on_interval(f: Expr, g: Expr, path: Path, region: str) -> Constant | None:
    """Return the constant on a region such as x > 0 for x -> oo, or abs(x) <= pi/2 for x -> 0."""
    if (symbols(f) | symbols(g)) != {path.name} or not elementary(f, g):
        return None
    ends = interval_of(parse_given(region))
    assert ends is not None
    found = exact_ends(f, g, path.name, *ends[1:], CLOSE)
    if not found.within(SHARP):
        return None
    where = (
        f"as {path}" if found.at is None else f"{path.name} = {arb(found.at).str(8, radius=False)}"
    )
    return Constant(rounded(found.low, -1), rounded(found.high, 1), region.strip(), where)


def _has_infinite_end(f: Expr) -> bool:
    """Return whether an integral is not over a bounded range; its coefficients are not computed."""
    return any(
        node.op == "integral" and INFINITY.args[0] in symbols(end)
        for node in operations((f,))
        for end in node.args[1:]
    )


def _one_sided(f: Expr, g: Expr, path: Path, side: int, reach: fmpq) -> Supremum | None:
    """Return the supremum of |f/g| on one side of the end."""
    put = {path.name: along(path, side)}
    left, right = (substitute(e, put) for e in (f, g))
    order = _order(right)
    if order is None or not vanishes(left, order):
        return None
    how = Evaluation(lambda at: Jets(at, RULES), _value, order + MORE, TERMS)
    try:
        return supremum(left, right, order, None, reach, 0, how)
    except (InputError, UndefinedError):
        return None


def jets_and_values() -> Evaluations:
    """Return how maxima evaluate roots and integrals: by certified values, and in jets."""
    return Evaluations(_value, lambda at: Jets(at, RULES))


def _value(e: Expr, at: object) -> arb:
    try:
        return certified_evaluation(at).value(e)  # type: ignore[arg-type]
    except UndefinedError:
        return arb.nan()


def _order(gauge: Expr) -> int | None:
    """Return p if the gauge is a number times T^p."""
    t = symbol(T)
    for p in range(HIGHEST + 1):
        ratio = normal_form(gauge / t**p, Given(((t, ">", ZERO),)))
        if not symbols(ratio):
            return p
    return None


def vanishes(f: Expr, order: int) -> bool:
    """Return whether the Taylor coefficients of f in ``T`` below ``order`` are proved to be 0."""
    for k in range(order):
        there = _at_end(f)
        if there is None:
            return False
        if not _is_zero(there):
            return False
        if k + 1 < order:
            f = by_leibniz(differentiate(f, T))
    return True


def _at_end(f: Expr) -> Expr | None:
    """Return an expression at T = 0, with roots that are known there as numbers."""
    there = substitute(f, {T: ZERO})
    known: dict[Expr, Expr] = {}
    for node in outermost(there):
        if node.op == "root":
            value = _root_value(node)
            if value is not None:
                known[node] = value
        elif node.op != "integral":
            return None
    return replaced(there, known)


def _root_value(node: Expr) -> Expr | None:
    """Return a root without variables as an exact number, if a simple one is shown to be it."""
    if symbols(node) - {INFINITY.args[0]}:
        return None
    try:
        near = certified(node, 30)
    except InputError:
        return None
    (name,), body = opened(node)
    for candidate in _candidates(body, name, near):
        value = rational(candidate)
        inside = near.contains(value) if value is not None else _contains(near, candidate)
        if inside and is_zero(substitute(body, {name: candidate}), Given()):
            return candidate
    return None


def _contains(near: arb, candidate: Expr) -> bool:
    try:
        return bool(near.overlaps(certified(candidate, 40)))
    except InputError:
        return False


def _candidates(body: Expr, name: str, near: arb) -> list[Expr]:
    """Return numbers that the root may be: a simple fraction, or a linear equation's solution."""
    found = [number(simplest(near.mid().fmpq(), fmpq(1, 10**12)))]
    zero = substitute(body, {name: ZERO})
    slope = normal_form(differentiate(body, name), Given())
    if name not in symbols(slope) and slope != ZERO:
        found.append(normal_form(-zero / slope, Given()))
    return found


def _is_zero(e: Expr) -> bool:
    if elementary(e):
        return is_zero(e, Given())
    return bool(check(f"{e} == 0", limit=SECONDS))
