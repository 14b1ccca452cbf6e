"""Try to falsify a statement numerically before it is accepted: an independent check.

This module shares only the expression trees with the provers. It defines the meaning of every
operation again, in balls, and chooses its own points. They lie beyond the first period of
oscillating functions, far out, near zero, just inside every end of the conditions, at different
scales in several variables, on hyperplanes where evaluation is exact, and at pseudo-random places
that are always the same. Before them come the exceptional places, at which proofs by formulas in
general position fail: zeros of the arguments of sign, abs and atan2, of denominators, coefficients
and exponents, and coinciding ends of integrals.

A statement is about the points at which its conditions are proved to hold and all of its parts are
proved to be defined. Only balls contradict it; what is not proved contradicts nothing.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Sequence, Set
from functools import cache, lru_cache, partial
from itertools import pairwise
from math import comb, factorial
from typing import Any, NamedTuple
from zlib import crc32

from flint import acb, acb_series, arb, ctx, fmpq

from tresym.reals.language.expression import (
    DOTS,
    LEAVES,
    ZERO,
    Expr,
    opened,
    replaced,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text

Comparison = tuple[Expr, str, Expr]
Derivative = tuple[Expr, str, int, Expr]
"""A function, a variable, an order, and the stated derivative."""
Tried = list[arb]

BITS = 128
ENOUGH, TRIED = 4, 16
"""The least number of points checked, and of points tried, for an equation without integers."""
SLOWER = 4
"""The factor for all other statements."""
WORK = 400
"""The number of operations after which the attack on an equation ends, if enough points have been
checked, and which are not spent on integrals, sums and the like. It is a count and not a time, so
that the number of points does not depend on how busy the machine is."""
MOST = 600
QUADRATURE, TERMS, LONGEST_POWER, LARGEST_FACTORIAL = 600, 400, 10**5, 1000
"""Limits for integrals, sums, powers and factorials."""
GRID = (-40, -9, -5, -3, -2, -1, 0, 1, 2, 3, 5, 9, 40)
"""The points between which a root of an equation is searched for."""
BRACKETS = sorted(pairwise(GRID), key=lambda pair: abs(pair[0]))
HALVINGS, SECANTS = 90, 14
NEARLY = arb((1, -12))
"""How far from a derivative its formula is at most beside a hole."""
CRITICAL, LARGEST, STARTS, EACH = 10, 40, 8, 2
"""How many exceptional expressions are looked at and how large they are; how many points are tried
for each variable of one, and how many of them are used."""
EXPONENTS = (arb(2), arb(1) / 2, arb(-1), arb(1), arb(3))
BASES = (arb(-1), arb(-2), arb(2), arb(-1) / 2)
POWERS = 40
"""The number of first points for powers; they combine ``BASES`` and ``EXPONENTS``."""
MOST_BITS = 640
"""The precision at which special functions are evaluated at most, since they become slow."""
ROUGH = arb((1, -20))
"""The largest radius of a ball that counts as known."""
TOLERANCE = arb((1, -60))
WIDE = arb((1, -48))
FACTORIAL = "factorial"
INFINITE = "oo"
"""Infinity as an end of an integral; it is not a variable."""

FALSE = {"==": operator.ne, "!=": operator.eq} | {
    ">": operator.le,
    ">=": operator.lt,
    "<": operator.ge,
    "<=": operator.gt,
}
"""The operator that refutes each relation; FLINT returns true only if it is certain."""
SHOWN: dict[str, Callable[[arb, arb], Any]] = {
    "==": lambda x, y: (x - y).is_zero(),
    "!=": operator.ne,
    ">": operator.gt,
    ">=": operator.ge,
    "<": operator.lt,
    "<=": operator.le,
}

STOPPED = "a proof was found, but {}, so the proof must be wrong; please report this claim"
"""The reason given for a statement that this check has contradicted."""


def contradiction(
    claim: Comparison,
    given: Sequence[Comparison] = (),
    functions: Sequence[Expr] = (),
    derivatives: Sequence[Derivative] = (),
    integers: Sequence[str] = (),
    anywhere: bool = False,
) -> str | None:
    """Return where balls contradict ``claim``, in words, or None if no contradiction is found.

    Args:
        claim: a left side, a relation and a right side.
        given: conditions on the points, including equations.
        functions: further expressions that must be defined at the points.
        derivatives: stated derivatives; each is compared with difference quotients of its function.
        integers: the variables that take only integer values.
        anywhere: whether the base of a power with a variable exponent may be non-positive.
    """
    left, relation, right = claim
    field = _REAL._replace(general=_anywhere) if anywhere else _REAL
    trees = [left, right, *functions, *(e for f, _, _, slope in derivatives for e in (f, slope))]
    names = _names(trees, given, [d[1] for d in derivatives])
    patience = 1 if relation == "==" and len(integers) < 1 else SLOWER
    shown, against = 0, ""
    slow = any(e.hidden for e in trees)
    most_points = 0 if slow else patience * WORK // max(1, sum(e.size for e in trees))

    def look(point: Tried | None) -> list[arb] | None:
        nonlocal shown, against
        found = None if point is None else value(point)
        if point is not None and found is not None:
            shown += 1
            if FALSE[relation](found[0], found[1]) and _is_a_limit(beside, point, fixed):
                against = (
                    f"at {where(names, point)} its sides are {said(found[0])} and {said(found[1])}"
                )
            elif shown == 1 and not _are_slopes(value, derivatives, names, point, found):
                against = f"at {where(names, point)} a derivative is no limit of differences"
        return found

    with ball_precision(BITS):
        against = _at_exceptional(trees, relation, names, given, integers, field, derivatives) or ""
        if against:
            return against
        value = program(trees, names, integers, field)
        without = field._replace(integral=lambda *_: arb(0))  # near equal ends it may diverge
        beside = program(trees, names, integers, without)
        raised = _exponents(trees) if anywhere else set()
        tried = Points(names, given, integers, raised)
        still = {*integers, *tried.solved, *raised}
        fixed = [name in still for name in names]
        lowest: list[Any] | None = None
        for count, point in enumerate(tried, 1):
            found = look(point)
            if against:
                return against
            if found and point is not None and relation[0] in "<>" and not any(fixed):
                room = _room(found, relation)
                lowest = [room, point] if lowest is None or room < lowest[0] else lowest
            most = (1 if shown else 5) * patience * TRIED
            enough = shown >= patience * ENOUGH or count >= most
            if raised and count <= POWERS:
                continue
            if enough and count >= most_points:
                break
        for n, point in enumerate(_downhill(lowest, tried.holds)):
            found = look(point)
            if against:
                return against
            if found is not None and lowest and (room := _room(found, relation)) < lowest[0]:
                lowest[:] = room, point
            if n >= max(patience * ENOUGH, most_points // 2):
                break
    return None


# Exceptional places


def critical(trees: Sequence[Expr], moving: Set[str] = frozenset()) -> list[Expr]:
    """Return expressions at whose zeros a proof in general position may fail, the likeliest first.

    Args:
        trees: the sides and conditions of a statement.
        moving: variables that must not occur in them, such as that of a path.
    """
    ranked: dict[Expr, int] = {}

    def add(e: Expr, rank: int) -> None:
        while e.op == "^" and e.args[1].op == "number":
            e = e.args[0]
        if e.op == "*":
            for factor in e.args:
                add(factor, rank)
        elif symbols(e) and not (e.loose or e.hidden or symbols(e) & moving) and e.size <= LARGEST:
            ranked[e] = min(rank, ranked.get(e, rank))

    seen: set[Expr] = set()
    stack = list(trees)
    while stack:
        e = stack.pop()
        if e in seen or e.op in LEAVES:
            continue
        seen.add(e)
        stack += [arg for arg in e.args if isinstance(arg, Expr)]
        if e.op in ("sign", "atan2"):
            add(e.args[0], 0)
        elif e.op in ("abs", "cbrt"):
            add(e.args[0], 1)
        elif e.op == "^":
            low = e.args[1].op != "number" or e.args[1].args[0] < 0 or e.args[1].args[0].q != 1
            add(e.args[0], 2 if low else 3)
            add(e.args[1], 4)
            add(e.args[1] + 1, 5)
        elif e.op == "*":
            for factor in e.args:
                add(factor, 3)
        elif e.op in ("integral", *_BOUND) and not (e.args[1].hidden or e.args[2].hidden):
            add(e.args[2] - e.args[1], 3)
    ranked.pop(DOTS, None)
    return sorted(ranked, key=lambda e: (ranked[e], e.size, str(e)))[:CRITICAL]


def exceptional_points(
    trees: Sequence[Expr],
    names: Sequence[str],
    given: Sequence[Comparison],
    integers: Sequence[str] = (),
    moving: Set[str] = frozenset(),
    speaks: Callable[[Expr, str], bool] = lambda *_: True,
) -> Iterator[tuple[Expr, int, Tried]]:
    """Yield an expression, a variable and a point at which the expression is 0 by that variable.

    The conditions are proved to hold there; ``trees`` must be evaluated with 0 in place of the
    expression, since the point is a ball.

    Args:
        trees: the expressions.
        names: the variables.
        given: the conditions.
        integers: the variables that take only integer values.
        moving: variables that must not occur in the expressions, such as that of a path.
        speaks: whether zeros of an expression by a variable are wanted.
    """
    unchanged: tuple[Points, list[tuple[arb | None, arb | None]]] | None = None
    for e in critical([*trees, *(side for c in given for side in c[::2])], moving):
        if _has_no_zero(e) or not any(speaks(e, name) for name in symbols(e)):
            continue
        known = {e: ZERO, -e: ZERO}
        there = [(replaced(x, known), r, replaced(y, known)) for x, r, y in given]
        if there != [*given] or unchanged is None:
            tried = Points(names, there, integers)
            ranges = [_range(name, tried.bounds) for name in names]
            if there == [*given]:
                unchanged = tried, ranges
        else:
            tried, ranges = unchanged
        sides = program([e, ZERO], names, integers)
        for n, name in enumerate(names):
            if name not in symbols(e) or name in tried.solved or not speaks(e, name):
                continue
            linear = _degree(e, name) == 1
            found = 0
            for k in range(STARTS):
                point: Tried | None = [
                    tried._integer(x, (k * (j + 1)) % 14)
                    if x in integers
                    else _coordinate(k, j, *ranges[j])
                    for j, x in enumerate(names)
                ]
                if point is not None:
                    root = _exceptional_root(sides, point, n, name in integers, linear)
                    point = (
                        None
                        if root is None
                        else tried._moved([*point[:n], root, *point[n + 1 :]], k, n)
                    )
                left = None if point is None else sides(point)
                if point is not None and left and left[0].contains(0) and tried.holds(point):
                    found += 1
                    yield e, n, point
                if found == EACH:
                    break


def _has_no_zero(e: Expr) -> bool:
    """Return whether ``e`` is not 0 by its form, such as ``x**2 + 1``, ``exp(x)`` or ``sec(x)``."""
    return e.op in ("sec", "csc", "sech", "csch") or _at_least(e, 1)


def _at_least(e: Expr, strict: int) -> bool:
    """Return whether ``e`` is seen to be positive where it is defined, or not negative."""
    if e.op == "number":
        return bool(e.args[0] > 0 if strict else e.args[0] >= 0)
    if e.op == "+":
        return all(_at_least(term, 0) for term in e.args) and (
            not strict or any(_at_least(term, 1) for term in e.args)
        )
    if e.op == "*":
        return all(_at_least(factor, strict) for factor in e.args)
    if e.op == "^" and e.args[1].op == "number":
        r = e.args[1].args[0]
        even = r.q % 2 == 0 or (r.q == 1 and r.p % 2 == 0)
        return _at_least(e.args[0], strict) or (even and not strict)
    return e.op in ("pi", "exp", "cosh") or (e.op == "abs" and not strict)


def _degree(e: Expr, name: str) -> int:
    """Return 0 or 1 if ``e`` is seen to be constant or linear in a variable, else 2."""
    if name not in symbols(e):
        return 0
    if e.op == "symbol":
        return 1
    if e.op not in ("+", "*"):
        return 2
    degrees = [_degree(arg, name) for arg in e.args]
    return min(2, max(degrees) if e.op == "+" else sum(degrees))


def _exceptional_root(
    sides: Program, point: Tried, n: int, whole: bool, linear: bool
) -> arb | None:
    """Return a ball that holds a zero of a difference in one variable: exact if it is linear."""

    def gap(x: arb) -> arb | None:
        found = sides([*point[:n], x, *point[n + 1 :]])
        return None if found is None else found[0] - found[1]

    first, second, third = (gap(arb(k)) for k in (0, 1, 2))
    if first is not None and second is not None and third is not None:
        bend = third - 2 * second + first
        if bend.contains(0) and not (second - first).contains(0):
            root = first / (first - second)
            value = gap(root)
            if value is not None and value.contains(0):
                return root if not whole or root.unique_fmpz() is not None else None
        if linear and not first.contains(0):
            return None  # there is no other zero than the one that was tried, if there is any
    return _root(sides, point, n, whole)


def _at_exceptional(
    trees: Sequence[Expr],
    relation: str,
    names: Sequence[str],
    given: Sequence[Comparison],
    integers: Sequence[str],
    field: _Field,
    derivatives: Sequence[Derivative],
) -> str | None:
    """Return where the claim fails at an exceptional place, in words."""
    programs: dict[Expr, Program] = {}
    plain = program(trees, names, integers, field)
    fixed = [name in integers for name in names]
    by = {d[1] for d in derivatives}

    @cache
    def beside(e: Expr) -> list[Expr]:
        known = {e: ZERO, -e: ZERO}
        there = {x: replaced(x, known) for x in dict.fromkeys(trees)}
        return [there[x] for x in trees]

    @cache
    def undefined(e: Expr) -> tuple[bool, bool]:
        """Whether some expression is undefined where ``e`` is 0, and whether both sides are."""
        parts = [_divides_by_zero(x) for x in beside(e)]
        return any(parts), relation == "==" and all(parts[:2])

    def speaks(e: Expr, name: str) -> bool:
        some, both = undefined(e)
        return not some or (name in by and not both)

    for e, n, point in exceptional_points(trees, names, given, integers, speaks=speaks):
        if e not in programs:
            programs[e] = program(beside(e), names, integers, field)
        found = programs[e](point)
        if found is not None and FALSE[relation](found[0], found[1]):
            if _is_a_limit(plain, point, fixed):
                sides = f"its sides are {said(found[0])} and {said(found[1])}"
                return f"at {where(names, point)} {sides}"
        elif found is None and names[n] in by:
            alone = [program([side], names, integers, field)(point) for side in beside(e)[:2]]
            if _fails_at_hole(plain, alone, relation, point, n, derivatives):
                return f"at {where(names, point)} its derivative contradicts it"
    return None


def _divides_by_zero(e: Expr) -> bool:
    """Return whether a power of 0 with a negative exponent stands in ``e``, so that it is undefined
    everywhere.
    """
    if e.op in LEAVES:
        return False
    if e.op == "^" and e.args[0] == ZERO and e.args[1].op == "number" and e.args[1].args[0] < 0:
        return True
    return any(_divides_by_zero(arg) for arg in e.args if isinstance(arg, Expr))


def _fails_at_hole(
    value: Program,
    alone: Sequence[list[arb] | None],
    relation: str,
    point: Tried,
    n: int,
    derivatives: Sequence[Derivative],
) -> bool:
    """Return whether a claim fails where the formula of a derivative has a removable hole.

    The derivative is computed from difference quotients, and must agree with its formula on both
    sides. Numbers this close are no proof, but a proof that they contradict is in doubt.

    Args:
        value: both sides, the functions and their derivatives.
        alone: each side at the hole, None for one that is undefined there.
        relation: the relation that is claimed.
        point: the hole, with values for all variables.
        n: the place of the variable of differentiation.
        derivatives: what was differentiated.
    """
    steps = [sign * arb((1, -size)) for size in (20, 60) for sign in (1, -1)]
    c, near = point[n].mid(), []
    for step in steps:
        found = value([*point[:n], (c + step).mid(), *point[n + 1 :]])
        if found is None:
            return False
        near.append(found)
    for k, (_, _, order, _) in enumerate(derivatives):
        at = len(near[0]) - 2 * (len(derivatives) - k)
        quotient = (near[2][at] - near[3][at]) / (steps[2] - steps[3])
        slopes = [found[at + 1] for found in near]
        if order != 1 or any(abs(slope - quotient) > NEARLY for slope in slopes):
            return False
    if relation != "==":
        same = all(abs(found[0] - found[1]) < NEARLY**2 for found in near[2:])
        return same and relation in ("<", ">", "!=")
    left, right = (side[0] if side else near[2][k] for k, side in enumerate(alone))
    return bool(abs(left - right) > NEARLY)


def somewhere(
    trees: Sequence[Expr], given: Sequence[Comparison] = (), integers: Sequence[str] = ()
) -> bool:
    """Return whether a point is found where the conditions hold and all ``trees`` are defined."""
    names = _names(trees, given)
    with ball_precision(BITS):
        value = program(trees, names, integers)
        points = (point for point in Points(names, given, integers) if point is not None)
        return any(value(point) is not None for point in points)


def _names(
    trees: Sequence[Expr], given: Sequence[Comparison], more: Sequence[str] = ()
) -> list[str]:
    said = (*trees, *(e for c in given for e in c[::2]))
    return sorted(frozenset().union(*map(symbols, said), more) - {INFINITE})


def _exponents(trees: Sequence[Expr]) -> set[str]:
    """Return the variables in exponents, where a negative base requires integer values."""
    found: set[str] = set()
    stack = list(trees)
    while stack:
        e = stack.pop()
        if isinstance(e, Expr):
            stack.extend(e.args)
            found |= symbols(e.args[1]) if e.op == "^" else set()
    return found


class Points:
    """Yield points at which the conditions are proved to hold, and None for each failed trial.

    Attributes:
        solved: the variables whose values are computed from equations.
    """

    def __init__(
        self,
        names: Sequence[str],
        given: Sequence[Comparison],
        integers: Sequence[str] = (),
        raised: Set[str] = frozenset(),
    ) -> None:
        """Prepare the search. If an equation cannot be solved here, no point is found.

        Args:
            names: the variables.
            given: the conditions.
            integers: the variables that take only integer values.
            raised: the variables in exponents; bases are negative at the first points.
        """
        self.names, self.integers, self.raised = names, integers, raised
        self.bounds = [c for c in given if c[1] != "=="]
        self.steps: list[tuple[Program, int]] = []
        self.solved: set[str] = set()
        self.other: list[Comparison] = []
        spoken: set[str] = set()
        equations = [c for c in given if c[1] == "=="]
        for n, (left, relation, right) in enumerate(equations):
            here = symbols(left) | symbols(right)
            later = [symbols(c[0]) | symbols(c[2]) for c in equations[n + 1 :]]
            alone = {side.args[0] for side in (left, right) if side.op == "symbol"}
            ranks = {
                m: (m in integers, m not in alone, m in _all(later), m)
                for m in here - spoken - self.solved
            }
            free = sorted(ranks, key=ranks.__getitem__)
            if free:
                sides = program([left, right], names, integers)
                self.steps.append((sides, names.index(free[0])))
                self.solved.add(free[0])
            else:
                self.other.append((left, relation, right))
            spoken |= here
        self.holds = conditions(names, [*self.bounds, *self.other], integers)

    def __iter__(self) -> Iterator[Tried | None]:
        for k in range(POWERS if self.raised and not self.steps else 0):
            point = [
                EXPONENTS[(k + k // 5 * (j + 1) + j) % 5]
                if name in self.raised
                else BASES[(k // 2 + j + 2) % 4]
                for j, name in enumerate(self.names)
            ]
            at = dict(zip(self.names, point, strict=True))
            whole = all(at[name].is_integer() for name in self.integers if name in at)
            yield point if whole and self.holds(point) else None
        if not self.steps and not self.integers:
            yield from points(self.names, self.bounds, self.holds)
            return
        anywhere: Callable[[Tried], bool] = lambda _: True  # noqa: E731
        for k, free in enumerate(points(self.names, self.bounds, anywhere), 1):
            moved = None if free is None else self._moved(free, k)
            yield moved if moved is not None and self.holds(moved) else None

    def _moved(self, point: Tried, k: int, fixed: int | None = None) -> Tried | None:
        """Return the point with small integers for some coordinates, and with roots for others.

        Args:
            point: values for all variables.
            k: the number of the point.
            fixed: the place of a coordinate that keeps its value.
        """
        point = [
            self._integer(name, (k * (j + 1) + k // 7) % 14)
            if name in self.integers and j != fixed
            else x
            for j, (name, x) in enumerate(zip(self.names, point, strict=True))
        ]
        for sides, n in self.steps:
            root = _root(sides, point, n, self.names[n] in self.integers)
            if root is None:
                return None
            point[n] = root
        return point

    def _integer(self, name: str, away: int) -> arb:
        """Return an integer near an end of its range, or near 0."""
        low, high = _range(name, self.bounds)
        start = arb(-2) if low is None else low.ceil()
        if low is None and high is not None and high < 9:
            return (high.floor() - away).mid()
        return (start + away).mid()


def _all(sets: Sequence[frozenset[str]]) -> frozenset[str]:
    return frozenset().union(*sets)


def _root(sides: Program, point: Tried, n: int, whole: bool) -> arb | None:
    """Return a ball for the ``n``-th coordinate at which the sides are equal; None if not found."""

    def gap(x: arb) -> arb | None:
        found = sides([*point[:n], x, *point[n + 1 :]])
        return None if found is None else found[0] - found[1]

    candidates = [arb(k) for k in GRID]
    values = [gap(x) for x in candidates]
    at = dict(zip(GRID, values, strict=True))
    low, high = at[0], at[1]
    if low is not None and high is not None and low.is_finite() and not (high - low).contains(0):
        linear = (low / (low - high)).mid()
        candidates.append(linear)
        values.append(gap(linear))
    for x, value in zip(candidates, values, strict=True):
        if value is not None and value.is_zero() and (not whole or x.is_integer()):
            return x
    if whole:
        return None
    if len(candidates) > len(GRID):
        step = (1 + abs(candidates[-1])) * arb((1, -80))
        found = _halved(gap, (candidates[-1] - step).mid(), (candidates[-1] + step).mid())
        if found is not None:
            return found
    for x, y in BRACKETS:
        first, last = at[x], at[y]
        if first is not None and last is not None and first * last < 0:
            found = _halved(gap, arb(x), arb(y))
            if found is not None:
                return found
    return None


def _halved(gap: Callable[[arb], arb | None], low: arb, high: arb) -> arb | None:
    """Return a small ball in which the gap changes its sign and is defined throughout."""
    first, last = gap(low), gap(high)
    if first is None or last is None or not (first * last < 0):
        return None
    near = _by_secants(gap, low, high, first, last)
    if near is not None:
        return near
    for n in range(HALVINGS):
        if n == HALVINGS // 4 and gap(low.union(high)) is None:
            return None  # a pole
        middle = ((low + high) / 2).mid()
        value = gap(middle)
        if value is None or not (value > 0 or value < 0):
            break
        low, high = (middle, high) if value * first > 0 else (low, middle)
    both = low.union(high)
    return both if gap(both) is not None else None


def _by_secants(
    gap: Callable[[arb], arb | None], low: arb, high: arb, first: arb, last: arb
) -> arb | None:
    """Return the same by regula falsi with halved weights, which needs fewer values; None if a few
    of them do not lead to a small ball with values of both signs at its ends.
    """
    x, y, at_x, at_y = low, high, first.mid(), last.mid()
    for _ in range(SECANTS):
        if (at_y - at_x).contains(0):
            return None
        z = ((x * at_y - y * at_x) / (at_y - at_x)).mid()
        value = gap(z)
        if value is None or not value.is_finite():
            return None
        if value.contains(0) or abs(z - y) < (1 + abs(z)) * arb((1, -70)):
            step = (1 + abs(z)) * arb((1, -80))
            ends = (z - step).mid(), (z + step).mid()
            values = [gap(end) for end in ends]
            both = ends[0].union(ends[1])
            if None in values or not (values[0] * values[1] < 0) or gap(both) is None:  # type: ignore[operator]
                return None
            return both if low < ends[0] and ends[1] < high else None
        if value * at_y < 0:
            x, at_x = y, at_y
        else:
            at_x = at_x / 2
        y, at_y = z, value.mid()
    return None


def _room(sides: list[arb], relation: str) -> arb:
    """Return approximately how far an inequality is from being false."""
    return (sides[0] - sides[1] if relation[0] == ">" else sides[1] - sides[0]).mid()


def _downhill(lowest: list[Any] | None, holds: Callable[[Tried], bool]) -> Iterator[Tried]:
    """Yield neighbours of the current lowest point, at decreasing distances."""
    part = 1
    while lowest is not None and lowest[1] and part < 1 << 40:
        before = lowest[1]
        for j, x in enumerate(before):
            for step in (abs(x) / 3 / part + arb((1, -30)), -abs(x) / 4 / part - arb((1, -30))):
                point = list(lowest[1])
                point[j] = (point[j] + step).mid()
                if holds(point):
                    yield point
        part *= 1 if lowest[1] is not before else 4


def where(names: Sequence[str], point: Sequence[arb]) -> str:
    """Return a point in words, exactly if that is short."""
    shown = []
    for name, x in zip(names, point, strict=True):
        size = abs(x.mid())
        short = size.is_zero() or arb((1, -60)) < size < arb((1, 60))
        text = fraction_text(exact(x)) if short else ""
        shown.append(f"{name} = {text}" if 0 < len(text) <= 24 else f"{name} near {said(x.mid())}")
    return ", ".join(shown) or "the constants themselves"


def said(x: arb) -> str:
    """Return a ball as text; FLINT does not terminate on numbers of astronomical size."""
    size = abs(x)
    if size.contains(0) or arb((1, -(10**6))) < size < arb((1, 10**6)):
        return str(x.str(12, radius=not x.is_exact()))
    return "too large or too small to be written"


def exact(x: arb) -> fmpq:
    """Return the midpoint of a ball as a rational."""
    mantissa, exponent = (int(part) for part in x.mid().man_exp())
    return fmpq(mantissa * 2 ** max(exponent, 0), 2 ** max(-exponent, 0))


def _is_a_limit(value: Program, point: Tried, fixed: Sequence[bool] = ()) -> bool:
    """Whether all is defined close by: what is so at single points is nobody's claim.

    Args:
        fixed: which coordinates are integers, and stay.
    """
    return any(
        value(
            [
                x + arb((_noise(k, j) % 97 - 48, -60)) * (1 + abs(x)) * (not any(fixed[j : j + 1]))
                for j, x in enumerate(point)
            ]
        )
        for k in range(16)
    )


def _are_slopes(
    value: Program,
    derivatives: Sequence[Derivative],
    names: Sequence[str],
    point: Tried,
    found: list[arb],
) -> bool:
    """Whether difference quotients may be values that the derivatives take near ``point``.

    They are by the mean value theorem, where function and derivative are defined all the way. The
    last values of the program are those of each function and of its derivative, in turn.
    """
    for k, (_, name, order, _) in enumerate(derivatives):
        f, x = len(found) - 2 * (len(derivatives) - k), names.index(name)
        step = arb((1, -min(20, 100 // order))) * (1 + abs(point[x]))
        line = [[*point[:x], point[x] + n * step, *point[x + 1 :]] for n in range(1, order + 1)]
        between = value([*point[:x], point[x].union(line[-1][x]), *point[x + 1 :]])
        ends = [found, *(end for end in map(value, line) if end is not None)]
        if between is None or len(ends) <= order:
            continue
        weights = [comb(order, n) * (-1) ** (order - n) for n in range(order + 1)]
        difference = sum((w * end[f] for w, end in zip(weights, ends, strict=True)), arb(0))
        if not between[f + 1].overlaps(difference / step**order):
            return False
    return True


# What every operation means


class _UndefinedError(Exception):
    """Raised for a value that is not proved to be defined."""


def _sign(x: arb) -> arb:
    """Return the sign."""
    if x.is_zero() or not x.contains(0):
        return arb(0 if x.is_zero() else 1 if x > 0 else -1)
    raise _UndefinedError


def _cbrt(x: arb) -> arb:
    return x if x.is_zero() else _sign(x) * abs(x).root(3)


def _atan2(y: arb, x: arb) -> arb:
    if x > 0 or not y.contains(0):
        return arb.atan2(y, x)
    if y.is_zero() and x < 0:
        return arb.pi()
    raise _UndefinedError


def _general(x: arb, y: arb) -> arb:
    value = (y * x.log()).exp() if x > 0 else x
    if x > 0 and value.is_finite():
        return value
    raise _UndefinedError


def _anywhere(x: arb, y: arb) -> arb:
    """Return the same, also for non-positive bases if the exponent is a number that allows it."""
    if x > 0:
        return _general(x, y)
    if y.is_exact() and abs(y) < LONGEST_POWER and exact(y).q < LONGEST_POWER:
        return _rational(int(exact(y).p), int(exact(y).q))(x)  # as of a number that is written
    raise _UndefinedError


def _to_integer(x: arb, y: arb) -> arb:
    """Return a power whose exponent has only integer variables; n + 1/2 needs x > 0."""
    n = y.unique_fmpz()
    if n is None:
        return _general(x, y)
    if x.contains(0):
        if not 1 <= n <= LONGEST_POWER:
            raise _UndefinedError
        largest = abs(x).upper() ** int(n)
        return arb(0, largest) if n % 2 else arb(0).union(largest)
    if abs(n) <= LONGEST_POWER:
        return x ** int(n)
    size = (n * abs(x).log()).exp()
    return -size if x < 0 and n % 2 else size


def _to_integer_in_sum(x: arb, y: arb) -> arb:
    """The same in a sum or series, where 0**0 is 1."""
    n = y.unique_fmpz()
    if x.is_zero() and n is not None and n >= 0:
        return arb(n == 0)
    return _to_integer(x, y)


def _integrated(
    body: Callable[[arb], arb],
    holomorphic: Callable[[acb], acb],
    low: arb,
    high: arb,
    wide: bool = False,
) -> arb:
    """Return an integral by adaptive quadrature in balls; 0 if the ends are equal.

    If it may be ``wide``, the quadrature ends earlier, and its ball may have any radius.
    """
    if low.is_exact() and high.is_exact() and low == high:
        return arb(0)
    if not (low.is_finite() and high.is_finite()):
        raise _UndefinedError

    def integrand(z: acb, analytic: bool) -> acb:
        try:
            return holomorphic(z) if analytic or z.imag != 0 else acb(body(z.real))
        except _UndefinedError:
            return acb(arb.nan())

    options = {"rel_tol": TOLERANCE, "abs_tol": TOLERANCE**100, "eval_limit": QUADRATURE}
    if wide:
        options = {"rel_tol": WIDE, "abs_tol": WIDE, "eval_limit": QUADRATURE // 5}
    found = acb.integral(integrand, acb(low), acb(high), **options).real
    if not wide and not found.rad() < ROUGH * (1 + abs(found.mid())):
        raise _UndefinedError
    return found


def _added(body: Callable[[arb], arb], low: arb, high: arb, product: bool = False) -> arb:
    """Return a sum or product, term by term."""
    first, last = low.unique_fmpz(), high.unique_fmpz()
    if first is None or last is None or not -1 <= last - first < TERMS:
        raise _UndefinedError
    total = arb(1 if product else 0)
    for k in range(int(first), int(last) + 1):
        total = total * body(arb(k)) if product else total + body(arb(k))
    return total


_BOUND: dict[str, Callable[..., arb]] = {
    "sum": _added,
    "product": partial(_added, product=True),
}


def _rational(p: int, q: int) -> Callable[[arb], arb]:
    """Return x^(p/q) as a function: roots require x ≥ 0, and negative powers x ≠ 0."""

    def power(x: arb) -> arb:
        if (p <= 0 and x.contains(0)) or (q > 1 and not x >= 0):
            raise _UndefinedError
        return x**p if q == 1 else x.root(q) ** p

    return arb.sqrt if p == 1 and q == 2 else power


_BY_NAME: dict[str, Callable[..., arb]] = (
    {
        name: getattr(arb, name)  # FLINT's are not finite outside of the real domain
        for name in (
            *("exp", "log", "sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan"),
            *("sinh", "cosh", "tanh", "coth", "sech", "csch", "asinh", "acosh", "atanh"),
        )
    }
    | {"+": operator.add, "*": operator.mul, "abs": abs}
    | {"sign": _sign, "cbrt": _cbrt, "atan2": _atan2, "^": _general}
)


# Special functions, by other formulas than those of the provers where there are others


def _finite(function: Callable[..., arb]) -> Callable[..., arb]:
    """Return a function that has no value where it is not finite, at not too high a precision."""

    def value(*args: arb) -> arb:
        if ctx.prec > MOST_BITS:  # the ball is wider, and still right
            with ball_precision(MOST_BITS):
                found = function(*args)
        else:
            found = function(*args)
        if not found.is_finite():
            raise _UndefinedError
        return found

    return value


def _on(holds: Callable[..., Any], function: Callable[..., arb]) -> Callable[..., arb]:
    """Return a function that has no value where a condition is not proved."""

    def value(*args: arb) -> arb:
        if not holds(*args):
            raise _UndefinedError
        return function(*args)

    return _finite(value)


def _re(z: acb) -> arb:
    found: arb = z.real
    return found


def _order(x: arb) -> int:
    n = x.unique_fmpz()
    if n is None or n < 0:
        raise _UndefinedError
    return int(n)


def _bessel(kind: str) -> Callable[[arb, arb], arb]:
    def value(nu: arb, x: arb) -> arb:
        if not (x > 0 or (kind in "ji" and nu.is_integer())):
            raise _UndefinedError
        return _re(getattr(acb(x), f"bessel_{kind}")(acb(nu)))

    return value


def _agm_k(x: arb) -> arb:
    return arb.pi() / (2 * arb.agm(arb(1), (1 - x).sqrt()))


def _second_kind(x: arb) -> arb:
    found = acb(x).hypgeom_2f1(acb(fmpq(-1, 2)), acb(fmpq(1, 2)), acb(1))
    return arb.pi() / 2 * _re(found)


def _incomplete(name: str) -> Callable[[arb, arb], arb]:
    def value(phi: arb, m: arb) -> arb:
        if not (abs(phi) < arb.pi() / 2 and m * phi.sin() ** 2 < 1):
            raise _UndefinedError
        s, c = phi.sin(), phi.cos()
        root = 1 - m * s * s
        first = s * _re(acb.elliptic_rf(acb(c * c), acb(root), acb(1)))
        if name == "F":
            return first
        return first - m * s**3 / 3 * _re(acb.elliptic_rd(acb(c * c), acb(root), acb(1)))

    return value


def _polylogarithm(s: arb, x: arb) -> arb:
    if x == 1 and s > 1:
        return s.zeta()
    if not x < 1:
        raise _UndefinedError
    return _re(acb(x).polylog(acb(s)))


def _derivative_of_zeta(n: arb, x: arb) -> arb:
    order = _order(n)
    if x.contains(1) or order > 8:
        raise _UndefinedError
    return _re(acb_series([acb(x), 1], order + 1).zeta()[order]) * factorial(order)


def _lambert(branch: int) -> Callable[[arb], arb]:
    def value(x: arb) -> arb:
        if not (x > -(arb(-1).exp()) and (x < 0 or not branch)):
            raise _UndefinedError
        return _re(acb(x).lambertw(branch))

    return value


def _positive(*args: arb) -> bool:
    return bool(args[-1] > 0)


_SPECIAL: dict[str, Callable[..., arb]] = {
    "gamma": _finite(lambda x: 1 / x.rgamma()),
    "rgamma": _finite(lambda x: x.rgamma()),
    "loggamma": _on(_positive, lambda x: _re(acb(x).lgamma())),
    "digamma": _finite(lambda x: _re(acb(x).digamma())),
    "polygamma": _finite(lambda n, x: _re(acb(x).polygamma(acb(_order(n))))),
    "uppergamma": _on(_positive, lambda s, x: _re(acb(x).gamma_upper(acb(s)))),
    "lowergamma": _on(
        lambda s, x: s > 0 and x > 0, lambda s, x: _re(acb(s).gamma() - acb(x).gamma_upper(acb(s)))
    ),
    "erf": _finite(
        lambda x: 2 * x / arb.pi().sqrt() * (-x * x).hypgeom_1f1(arb(1) / 2, arb(3) / 2)
    ),
    "erfc": _finite(lambda x: _re(acb(x).erfc())),
    "erfi": _finite(lambda x: _re(acb(0, -1) * acb(0, x).erf())),
    "dawson": _finite(lambda x: x * (-x * x).hypgeom_1f1(arb(1), arb(3) / 2)),
    "fresnels": _finite(lambda x: _re(acb(x).fresnel_s())),
    "fresnelc": _finite(lambda x: _re(acb(x).fresnel_c())),
    "expint": _on(_positive, lambda n, x: x ** (n - 1) * x.gamma_upper(1 - n)),
    "Ei": _on(lambda x: not x.contains(0), lambda x: _re(acb(x).ei())),
    "li": _on(lambda x: x > 0 and not x.contains(1), lambda x: _re(acb(x).li())),
    "Si": _finite(lambda x: _re(acb(x).si())),
    "Ci": _on(_positive, lambda x: _re(acb(x).ci())),
    "besselj": _finite(_bessel("j")),
    "bessely": _finite(_bessel("y")),
    "besseli": _finite(_bessel("i")),
    "besselk": _finite(_bessel("k")),
    "airyai": _finite(lambda x: _re(acb(x).airy_ai())),
    "airyaiprime": _finite(lambda x: _re(acb(x).airy_ai(derivative=1))),
    "airybi": _finite(lambda x: _re(acb(x).airy_bi())),
    "airybiprime": _finite(lambda x: _re(acb(x).airy_bi(derivative=1))),
    "elliptic_k": _on(lambda x: x < 1, _agm_k),
    "elliptic_e": _on(lambda x: x < 1, _second_kind),
    "elliptic_f": _finite(_incomplete("F")),
    "elliptic_e_inc": _finite(_incomplete("E")),
    "elliptic_pi": _on(
        lambda n, m: n < 1 and m < 1,
        lambda n, m: _re(
            acb.elliptic_rf(acb(0), acb(1 - m), acb(1))
            + acb(n) / 3 * acb.elliptic_rj(acb(0), acb(1 - m), acb(1), acb(1 - n))
        ),
    ),
    "zeta": _on(lambda x: not x.contains(1), lambda x: _re(acb(x).zeta())),
    "zetaderiv": _finite(_derivative_of_zeta),
    "polylog": _finite(_polylogarithm),
    "lambertw": _finite(_lambert(0)),
    "lambertwm1": _finite(_lambert(-1)),
    "EulerGamma": lambda _: arb.const_euler(),
    "Catalan": lambda _: arb.const_catalan(),
}
_BY_NAME |= _SPECIAL


class _Field(NamedTuple):
    """The meaning of the operations in real or in complex balls."""

    by_name: dict[str, Callable[..., Any]]
    rational: Callable[[int, int], Callable[[Any], Any]]
    general: Callable[[Any, Any], Any]
    integral: Callable[..., arb] | None = None


def _complex_rational(p: int, q: int) -> Callable[[acb], acb]:
    def power(z: acb) -> acb:
        root = z if q == 1 else z.sqrt(analytic=True) if q == 2 else _complex_power(z, fmpq(1, q))
        return root**p

    return power


def _complex_power(z: acb, w: Any) -> acb:
    return (acb(w) * acb(z).log(analytic=True)).exp()


def _log(z: acb) -> acb:
    return z.log(analytic=True)


def _sqrt(z: acb) -> acb:
    return z.sqrt(analytic=True)


_I = acb(0, 1)
_COMPLEX = _Field(
    {
        name: getattr(acb, name)
        for name in (
            *("exp", "sin", "cos", "tan", "cot", "sec", "csc"),
            *("sinh", "cosh", "tanh", "coth", "sech", "csch"),
        )
    }
    | {
        "+": operator.add,
        "*": operator.mul,
        "log": _log,
        "abs": lambda z: z.real_abs(analytic=True),
        "sign": lambda z: z.real_sgn(analytic=True),
        "cbrt": lambda z: _complex_power(z, fmpq(1, 3)) if z.real > 0 else acb(arb.nan()),
        "asin": lambda z: -_I * _log(_I * z + _sqrt(1 - z * z)),
        "acos": lambda z: acb.pi() / 2 + _I * _log(_I * z + _sqrt(1 - z * z)),
        "atan": lambda z: (_log(1 + _I * z) - _log(1 - _I * z)) / (2 * _I),
        "asinh": lambda z: _log(z + _sqrt(z * z + 1)),
        "acosh": lambda z: _log(z + _sqrt(z - 1) * _sqrt(z + 1)),
        "atanh": lambda z: (_log(1 + z) - _log(1 - z)) / 2,
    },
    _complex_rational,
    _complex_power,
)
"""Functions that are holomorphic where their balls are finite."""
_REAL = _Field(_BY_NAME, _rational, _general, _integrated)
ROUGHLY = _REAL._replace(integral=partial(_integrated, wide=True))
"""As in the check, but an integral may have a wide ball."""


def _factorial(x: arb) -> arb:
    n = x.unique_fmpz()
    if n is None or not 0 <= n <= 10**LARGEST_FACTORIAL:
        raise _UndefinedError
    return arb(factorial(int(n))) if n <= LARGEST_FACTORIAL else (x + 1).gamma()


def _instance(seed: int, orders: tuple[int, ...], u: arb) -> arb:
    """Return the value of the function substituted for an arbitrary one, ``1/2 + 3/2 sin(c·x +
    s)``.
    """
    times, turned = sum(orders), u + arb(seed % 5)
    wave = [turned.sin(), turned.cos(), -turned.sin(), -turned.cos()][times % 4]
    for n, order in enumerate(orders):
        wave = wave * arb(1 + n) ** order
    return arb(3) / 2 * wave + (arb(1) / 2 if times == 0 else 0)


def _unknown(*_: Any) -> arb:
    raise _UndefinedError


def has_meaning(e: Expr) -> bool:
    """Return whether every operation in ``e`` has a meaning here, unlike an arbitrary function."""
    known = e.op in LEAVES or e.op in _BOUND or e.op in _BY_NAME or e.op == "integral"
    return known and (e.op in LEAVES or all(map(has_meaning, e.args)))


Program = Callable[[Tried], "list[arb] | None"]


def program(
    trees: Sequence[Expr],
    names: Sequence[str],
    integers: Sequence[str] = (),
    field: _Field = _REAL,
    in_sum: bool = False,
) -> Program:
    """Return ``trees`` as a function of a point; it returns None if some value is not proved
    defined.

    Args:
        trees: the expressions.
        names: the variables.
        integers: those that take only integer values.
        field: the meaning of the operations.
        in_sum: whether ``0**0`` is 1, as in sums and series.
    """
    here: Tried = []
    places: dict[Expr, int] = {}
    start: list[Any] = [None] * len(names)
    steps: list[tuple[Callable[..., arb], int, int | None, int]] = []

    def step(function: Callable[..., arb], i: int, j: int | None = None) -> int:
        steps.append((function, i, j, len(start)))
        start.append(None)
        return len(start) - 1

    def constant(value: Any) -> int:
        start.append(value)
        return len(start) - 1

    def inside(node: Expr, field: _Field = _REAL) -> Callable[[Any], Any]:
        """The body of what binds a variable, as a function of it."""
        (name,), body = opened(node, names)
        counted = (*integers, name) if node.op != "integral" else integers
        run = program([body], [*names, name], counted, field, in_sum or node.op != "integral")

        def value(x: Any) -> Any:
            found = run([*here, x])
            if found is None:
                raise _UndefinedError
            return found[0]

        return value

    def place(node: Expr) -> int:
        k = places.get(node)
        if k is None:
            k = places[node] = placed(node)
        return k

    def placed(node: Expr) -> int:
        op, args = node.op, node.args
        if op == "symbol":
            return constant(arb.pos_inf()) if args[0] == INFINITE else names.index(args[0])
        if op in ("number", "pi"):
            return constant(arb(args[0]) if args else arb.pi())
        if op == "integral" and field.integral is not None:
            value = partial(field.integral, inside(node), inside(node, _COMPLEX))
            return step(value, place(args[1]), place(args[2]))
        if op in _BOUND and field is not _COMPLEX:
            return step(partial(_BOUND[op], inside(node)), place(args[1]), place(args[2]))
        if op == "unknown" and field is not _COMPLEX:
            head, orders = args[0].args
            if head == FACTORIAL and orders == (0,):
                return step(_factorial, place(args[1]))
            total = constant(arb(0))
            for n, arg in enumerate(args[1:], 1):
                total = step(operator.add, total, step(operator.mul, constant(arb(n)), place(arg)))
            return step(partial(_instance, crc32(head.encode()), orders), total)
        if op == "^" and args[1].op == "number":
            k, r = place(args[0]), args[1].args[0]
            return (
                step(operator.mul, k, k) if r == 2 else step(field.rational(int(r.p), int(r.q)), k)
            )
        if (
            op == "^"
            and symbols(args[1])
            and symbols(args[1]) <= {*integers}
            and field is not _COMPLEX
        ):
            raised = _to_integer_in_sum if in_sum else _to_integer
            return step(raised, place(args[0]), place(args[1]))
        function = field.general if op == "^" else field.by_name.get(op, _unknown)
        if function is _unknown:
            return step(_unknown, constant(arb(0)))
        k = place(args[0])
        if len(args) == 1:
            return step(function, k)
        for other in args[1:]:
            k = step(function, k, place(other))
        return k

    ends = [place(e) for e in trees]

    def run(point: Tried) -> list[arb] | None:
        values = [*point, *start[len(point) :]]
        if field is _COMPLEX:
            values = [x if x is None else acb(x) for x in values]
        here[:] = point
        try:
            for function, i, j, k in steps:
                if j is not None:  # finite where its arguments are
                    values[k] = function(values[i], values[j])
                else:
                    values[k] = value = function(values[i])
                    if not value.is_finite():
                        return None
        except _UndefinedError:
            return None
        return [values[k] for k in ends]

    return run


# Where the points lie


def conditions(
    names: Sequence[str], given: Sequence[Comparison], integers: Sequence[str] = ()
) -> Callable[[Tried], bool]:
    """Return a function that decides whether all of ``given`` is proved to hold at a point."""
    sides = program([e for c in given for e in (c[0], c[2])], names, integers)
    relations = [SHOWN[relation] for _, relation, _ in given]

    def holds(point: Tried) -> bool:
        found = sides(point)
        return found is not None and all(
            relation(found[2 * n], found[2 * n + 1]) for n, relation in enumerate(relations)
        )

    return holds


def points(
    names: Sequence[str], given: Sequence[Comparison], holds: Callable[[Tried], bool]
) -> Iterator[Tried | None]:
    """Yield points for all names, the more informative first; None if ``given`` is not proved
    there.
    """
    ranges = [_range(name, given) for name in names]
    inside = outside = None
    for k in range(MOST if names else 1):
        if not given:
            yield _free(k, len(names))
            continue
        point = [_coordinate(k, j, *ends) for j, ends in enumerate(ranges)]
        if holds(point):
            inside = point
            yield point
        else:
            outside = point
            yield None
        if inside and outside and k % 8 == 7:
            yield _at_the_edge(holds, inside, outside)
            outside = None


def _at_the_edge(holds: Callable[[Tried], bool], inside: Tried, outside: Tried) -> Tried:
    """Return a point just inside the conditions, between an inner and an outer point."""
    for _ in range(40):
        middle = [((x + y) / 2).mid() for x, y in zip(inside, outside, strict=True)]
        if holds(middle):
            inside = middle
        else:
            outside = middle
    return inside


def _range(name: str, given: Sequence[Comparison]) -> tuple[arb | None, arb | None]:
    """Return approximately the range that constant bounds give a variable."""
    low: arb | None = None
    high: arb | None = None
    for left, relation, right in given:
        for side, bound, upper in ((left, right, "<"), (right, left, ">")):
            size = side.op == "abs" and relation[0] == upper
            inner = side.args[0] if size else side
            if inner.op != "symbol" or inner.args[0] != name or symbols(bound) or relation == "!=":
                continue
            found = program([bound], [])([])
            if found is None:
                continue
            end = found[0].mid()
            if relation[0] == upper:
                high = end if high is None or end < high else high
            if relation[0] != upper or size:
                end = -end if size else end
                low = end if low is None or end > low else low
    return low, high


@lru_cache(maxsize=1 << 12)
def _free(k: int, count: int) -> Tried:
    """Return the ``k``-th point if there are no conditions."""
    return [_offset(k, j)[0] for j in range(count)]


def _coordinate(k: int, j: int, low: arb | None, high: arb | None) -> arb:
    """Return the ``k``-th value of the ``j``-th variable: outward from 0, or inward from an end."""
    size, part = _offset(k, j)
    end = high if low is None else low
    if end is None:
        return size
    if low is None or high is None:
        away = abs(size) * (1 + abs(end)) if k % 3 == 2 else abs(size)
        return (end - away if low is None else end + away).mid()
    return (high - (high - low) * part if size > 0 else low + (high - low) * part).mid()


_LISTED = (
    *((13, -2, 0), (-11, 18, 0), (9, 18, 0), (0, 0, 0), (-41, -3, 0), (-15, -3, 0), (5, -3, 0)),
    *((11, -3, 1), (-27, -3, 1), (57, -3, 10), (-7, -3, -10), (89, -3, 0), (1, 0, 0), (-1, 0, 0)),
    *((1, -1, 0), (13, -24, 0), (-13, -24, 0), (3, -160, 0), (-3, -160, 0), (19, -3, 0)),
    *((-19, -3, 0), (45, -6, 40), (-23, -4, -40)),
)
"""The first values n·2^e, and how the second variable differs: 1 for sign, else for size."""


@lru_cache(maxsize=1 << 14)
def _offset(k: int, j: int) -> tuple[arb, arb]:
    """Return a signed distance, and one below 1/2 that is near 0 if the first is large or small."""
    if k < len(_LISTED):
        n, e, other = _LISTED[k]
        if other == 1:
            n = -n if j % 2 else n
        elif j % 2:
            e += other
        if abs(n) > 1 and abs(n) != 19:  # those stay equal in all variables
            n, e = n * (16 + 5 * j), e - 4
    else:
        noise = _noise(k, 0 if _noise(k, j) % 16 == 1 else j)
        n = 0 if noise % 16 == 0 else (noise >> 8) % (1 << 20) | 1
        n = -n if noise & 16 else n
        spread = (4, 4, 9, 30, 60)[k % 5]
        e = (noise >> 32) % (2 * spread + 1) - spread - 20
    length = abs(n).bit_length()
    part = arb(0) if abs(n) <= 1 else arb((abs(n), -length - max(abs(length + e), 1)))
    return arb((n, e)), part


def _noise(k: int, j: int) -> int:
    """Return a pseudo-random number that depends only on the arguments."""
    mixed = (k * 0x9E3779B97F4A7C15 + j * 0xC2B2AE3D27D4EB4F + 0x165667B19E3779F9) % (1 << 64)
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9 % (1 << 64)
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EB % (1 << 64)
    return mixed ^ mixed >> 31
