"""The advocate: attacks a statement at points that its prover did not choose, before it passes.

It shares the tree of expressions with the provers and nothing else: the meaning of every operation
stands here once more, in balls, and so does the choice of points. They lie past the first period
of what oscillates, far out, near zero, just inside every end of the conditions, with unlike scales
in several variables, on hyperplanes where evaluation is exact, and at random, always the same.

A statement speaks of the points at which its conditions are shown to hold and all of its parts are
shown to be defined; it is contradicted by balls alone. What is not shown contradicts nothing.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache, partial
from itertools import pairwise
from math import comb
from time import perf_counter
from typing import Any

from flint import arb, fmpq

from tresym.reals.language.expression import Expr, opened, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import fraction_text

Comparison = tuple[Expr, str, Expr]
Derivative = tuple[Expr, str, int, Expr]
"""A function, a variable, an order, and what is said to be that derivative."""
Tried = list[arb]

BITS = 128
ENOUGH, TRIED = 4, 16
"""Points looked at, and tried for that, where a bare equation is decided in a millisecond."""
SLOWER = 4
"""How many times as many elsewhere."""
SHARE = 0.06
"""The part of a decision's time that more points may take."""
MOST = 600
PARTS, TERMS, LONGEST_POWER = 64, 40, 10**5
"""Of an integral, of a sum and of a power: how far they are computed."""
INFINITE = "oo"
"""The end of an integral, and no variable."""

FALSE = {"==": operator.ne, "!=": operator.eq} | {
    ">": operator.le,
    ">=": operator.lt,
    "<": operator.ge,
    "<=": operator.gt,
}
"""What shows a relation between two balls to be false: FLINT's answer yes when they are sure."""
SHOWN = {
    "!=": operator.ne,
    ">": operator.gt,
    ">=": operator.ge,
    "<": operator.lt,
    "<=": operator.le,
}

STOPPED = "it was taken to be proved, but {}: the proof is at fault; please report this claim"
"""What is said of a statement that the advocate has stopped."""


def contradiction(
    claim: Comparison,
    given: Sequence[Comparison] = (),
    functions: Sequence[Expr] = (),
    derivatives: Sequence[Derivative] = (),
    spent: float = 0.0,
    integers: Sequence[str] = (),
) -> str | None:
    """Where balls contradict ``claim`` and what they are there, in words; None if nowhere found.

    Args:
        given: conditions on the points.
        functions: what has to be defined there, too.
        derivatives: each is compared with difference quotients of its function.
        spent: seconds that the decision took; with more of them, more points are tried.
        integers: the variables that take the values of integers alone.
    """
    left, relation, right = claim
    trees = [left, right, *functions, *(e for f, _, _, slope in derivatives for e in (f, slope))]
    spoken_of = frozenset().union(
        *map(symbols, trees), *(symbols(e) for c in given for e in c[::2])
    )
    names = sorted(spoken_of.union(d[1] for d in derivatives) - {INFINITE})
    fixed = [name in integers for name in names]
    patience = 1 if relation == "==" else SLOWER
    start, shown, against = perf_counter(), 0, ""

    def has_time(part: int) -> bool:
        return perf_counter() - start < SHARE * spent / part

    def look(point: Tried | None) -> list[arb] | None:
        nonlocal shown, against
        found = None if point is None else value(point)
        if point is not None and found is not None:
            shown += 1
            if FALSE[relation](found[0], found[1]) and _is_a_limit(value, point, fixed):
                against = (
                    f"at {where(names, point)} its sides are {said(found[0])} and {said(found[1])}"
                )
            elif shown == 1 and not _are_slopes(value, derivatives, names, point, found):
                against = f"at {where(names, point)} a derivative is no limit of differences"
        return found

    with ball_precision(BITS):
        value, holds = program(trees, names, integers), conditions(names, given, integers)
        lowest: list[Any] | None = None
        for tried, point in enumerate(points(names, given, holds), 1):
            point = _whole(point, names, integers, tried, holds) if integers else point
            found = look(point)
            if against:
                return against
            if found and point is not None and relation[0] in "<>" and not integers:
                room = _room(found, relation)
                lowest = [room, point] if lowest is None or room < lowest[0] else lowest
            enough = shown >= patience * ENOUGH or tried >= (1 if shown else 5) * patience * TRIED
            if enough and not has_time(1 if lowest is None else 2):
                break
        for n, point in enumerate(_downhill(lowest, holds)):
            found = look(point)
            if against:
                return against
            if found is not None and lowest and (room := _room(found, relation)) < lowest[0]:
                lowest[:] = room, point
            if n >= patience * ENOUGH and not has_time(1):
                break
    return None


def _whole(
    point: Tried | None,
    names: Sequence[str],
    integers: Sequence[str],
    k: int,
    holds: Callable[[Tried], bool],
) -> Tried | None:
    """The point with small integers for some of its coordinates, if the conditions hold there."""
    if point is None:
        point = [arb(0) for _ in names]
    moved = [
        arb((k * (j + 1) + k // 7) % 14 - 2) if name in integers else x
        for j, (name, x) in enumerate(zip(names, point, strict=True))
    ]
    return moved if holds(moved) else None


def _room(sides: list[arb], relation: str) -> arb:
    """About how far an inequality is from being false."""
    return (sides[0] - sides[1] if relation[0] == ">" else sides[1] - sides[0]).mid()


def _downhill(lowest: list[Any] | None, holds: Callable[[Tried], bool]) -> Iterator[Tried]:
    """Neighbours of the second of ``lowest``, which may move meanwhile, closer and closer."""
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
    """A point in words, exactly where that is short."""
    shown = []
    for name, x in zip(names, point, strict=True):
        size = abs(x.mid())
        short = size.is_zero() or arb((1, -60)) < size < arb((1, 60))
        text = fraction_text(exact(x)) if short else ""
        shown.append(f"{name} = {text}" if 0 < len(text) <= 24 else f"{name} near {said(x.mid())}")
    return ", ".join(shown) or "the constants themselves"


def said(x: arb) -> str:
    """A ball in words; FLINT writes a tower of digits forever."""
    size = abs(x)
    if size.contains(0) or arb((1, -(10**6))) < size < arb((1, 10**6)):
        return str(x.str(12, radius=not x.is_exact()))
    return "too large or too small to be written"


def exact(x: arb) -> fmpq:
    """The middle of a ball."""
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
    """Not shown to be defined."""


def _sign(x: arb) -> arb:
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


def _to_integer(x: arb, y: arb) -> arb:
    """A power whose exponent takes the values of integers alone."""
    n = y.unique_fmpz()
    if n is None or x.contains(0) or abs(n) > LONGEST_POWER:
        raise _UndefinedError
    return x ** int(n)


def _integrated(body: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """An integral, by the balls of its integrand on small parts of the way."""
    if not (low.is_finite() and high.is_finite()):
        raise _UndefinedError
    step = (high - low) / PARTS
    ends = [low + n * step for n in range(PARTS + 1)]
    return sum((body(x.union(y)) for x, y in pairwise(ends)), arb(0)) * step


def _added(body: Callable[[arb], arb], low: arb, high: arb, product: bool = False) -> arb:
    """A sum or a product, term by term."""
    first, last = low.unique_fmpz(), high.unique_fmpz()
    if first is None or last is None or not -1 <= last - first < TERMS:
        raise _UndefinedError
    total = arb(1 if product else 0)
    for k in range(int(first), int(last) + 1):
        total = total * body(arb(k)) if product else total + body(arb(k))
    return total


_BOUND: dict[str, Callable[..., arb]] = {
    "integral": _integrated,
    "sum": _added,
    "product": partial(_added, product=True),
}


def _rational(p: int, q: int) -> Callable[[arb], arb]:
    """x^(p/q): a root of any degree asks for x ≥ 0, a power that is not positive for x ≠ 0."""

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

Program = Callable[[Tried], "list[arb] | None"]


def program(trees: Sequence[Expr], names: Sequence[str], integers: Sequence[str] = ()) -> Program:
    """The values of ``trees`` as a function of a point; None where not all are shown defined."""
    here: Tried = []
    places: dict[Expr, int] = {}
    start: list[Any] = [None] * len(names)
    steps: list[tuple[Callable[..., arb], int, int | None, int]] = []

    def step(function: Callable[..., arb], i: int, j: int | None = None) -> int:
        steps.append((function, i, j, len(start)))
        start.append(None)
        return len(start) - 1

    def inside(node: Expr) -> Callable[[arb], arb]:
        """The body of what binds a variable, as a function of it."""
        (name,), body = opened(node, names)
        counted = (*integers, name) if node.op != "integral" else integers
        run = program([body], [*names, name], counted)

        def value(x: arb) -> arb:
            found = run([*here, x])
            if found is None:
                raise _UndefinedError
            return found[0]

        return value

    def place(node: Expr) -> int:
        k = places.get(node)
        if k is not None:
            return k
        op, args = node.op, node.args
        if op == "symbol" and args[0] == INFINITE:
            k = len(start)
            start.append(arb.pos_inf())
        elif op in _BOUND:
            k = step(partial(_BOUND[op], inside(node)), place(args[1]), place(args[2]))
        elif op == "^" and symbols(args[1]) and symbols(args[1]) <= {*integers}:
            k = step(_to_integer, place(args[0]), place(args[1]))
        elif op == "symbol":
            k = names.index(args[0])
        elif op == "number" or op == "pi":
            k = len(start)
            start.append(arb(args[0]) if args else arb.pi())
        elif op == "^" and args[1].op == "number":
            k, r = place(args[0]), args[1].args[0]
            k = step(operator.mul, k, k) if r == 2 else step(_rational(int(r.p), int(r.q)), k)
        elif len(args) == 1:
            k = step(_BY_NAME[op], place(args[0]))
        else:
            function, k = _BY_NAME[op], place(args[0])
            for other in args[1:]:
                k = step(function, k, place(other))
        places[node] = k
        return k

    ends = [place(e) for e in trees]

    def run(point: Tried) -> list[arb] | None:
        values = [*point, *start[len(point) :]]
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
    """Whether all of ``given`` is shown to hold at a point."""
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
    """Points for all names, the more telling first; None where ``given`` is not shown to hold."""
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
    """A point just inside of the conditions, between two points."""
    for _ in range(40):
        middle = [((x + y) / 2).mid() for x, y in zip(inside, outside, strict=True)]
        if holds(middle):
            inside = middle
        else:
            outside = middle
    return inside


def _range(name: str, given: Sequence[Comparison]) -> tuple[arb | None, arb | None]:
    """Where the bounds by constants put a variable, about."""
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
    """The ``k``-th point where there are no conditions."""
    return [_offset(k, j)[0] for j in range(count)]


def _coordinate(k: int, j: int, low: arb | None, high: arb | None) -> arb:
    """The ``k``-th value of the ``j``-th variable: out from 0, or in from an end of its range."""
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
"""The first values n·2^e, and how the second variable differs: 1 in sign, else in size."""


@lru_cache(maxsize=1 << 14)
def _offset(k: int, j: int) -> tuple[arb, arb]:
    """A signed distance, and one below 1/2 that is near 0 where the first is large or small."""
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
    """The same number for the same arguments, and no pattern in them."""
    mixed = (k * 0x9E3779B97F4A7C15 + j * 0xC2B2AE3D27D4EB4F + 0x165667B19E3779F9) % (1 << 64)
    mixed = (mixed ^ mixed >> 30) * 0xBF58476D1CE4E5B9 % (1 << 64)
    mixed = (mixed ^ mixed >> 27) * 0x94D049BB133111EB % (1 << 64)
    return mixed ^ mixed >> 31
