"""Claims whose truth is computed beside them in fractions: ``python tests/known.py N SEED``

Each is cheap to decide and hostile: isolated points, poles, jumps, ends that touch, tiny and huge
constants, inverse functions out of range, conditions that are equations or ask for integers. Its
truth is worked out here, by nothing that the deciders use: a function that is piecewise linear, or
a product of factors of known sign, is looked at in exact fractions at each of its corners and once
between any two; a power series is multiplied out; an identity is made false at a known point.

All of a chunk are decided in one process, each within a second of its time; a verdict against the
truth is printed and counts as a failure. ``deep.py`` goes through the chunks.
"""

import random
import resource
import signal
import sys
import time
from collections import Counter
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import BrokenExecutor
from contextlib import contextmanager
from fractions import Fraction as Q
from itertools import pairwise
from math import ceil, factorial, floor
from typing import Any, NamedTuple

import chunks

from tresym.checking.dispatch import decide_claim
from tresym.reals.numbers.exact import InputError
from tresym.reals.processes import Processes

CLAIMS, BATCH = 5000, 100
"""In a chunk, and in a call."""
SECONDS, HANGS, MEMORY = 0.015, 2.0, 4 * 10**9
"""Of the processor's time a claim may take, in Python and in FLINT; and bytes."""


class Claim(NamedTuple):
    """A text and its truth; None where no point was meant, and neither may be said."""

    text: str
    truth: bool | None


# Functions of one variable that are linear, or constant, between corners

Value = Q | None
FAR, WIDE = Q(10) ** 60, Q(5)
"""No corner lies beyond; and that of a wave is looked for in a shorter interval."""


class Piecewise(NamedTuple):
    """Text in ``x``, its value at a fraction (None: undefined), and where it may not be linear."""

    text: str
    at: Callable[[Q], Value]
    corners: frozenset[Q]
    constant: bool = False

    def linear_pieces(self) -> Iterator[tuple[Value, Value, Q, Q]]:
        """Slope and value at 0 between two corners, None where it is undefined there."""
        for low, high in pairwise([-FAR, *sorted(self.corners), FAR]):
            p, q = (2 * low + high) / 3, (low + 2 * high) / 3
            u, v = self.at(p), self.at(q)
            if u is None or v is None:
                yield None, None, low, high
            else:
                slope = (v - u) / (q - p)
                yield slope, u - slope * p, low, high

    def crosses(
        self, levels: Callable[[Q, Q], Iterable[Q]] = lambda low, high: (Q(0),), far: Q = FAR
    ) -> set[Q]:
        """Where it takes one of the levels between two corners."""
        found = set()
        for slope, start, low, high in self.linear_pieces():
            if slope and start is not None:
                p, q = (min(max(x, -far), far) for x in (low, high))
                ends = sorted((slope * p + start, slope * q + start))
                found |= {(level - start) / slope for level in levels(*ends)}
        return {x for x in found if -far < x < far}


def shown(q: Q) -> str:
    return str(q) if q >= 0 and q.denominator == 1 else f"({q})"


def line(slope: Q, start: Q) -> Piecewise:
    parts = [] if slope == 0 else ["x" if slope == 1 else f"{shown(slope)}*x"]
    parts += [shown(start)] if start or not parts else []
    return Piecewise(f"({' + '.join(parts)})", lambda x: slope * x + start, frozenset(), slope == 0)


def sign(q: Q) -> Q:
    return Q((q > 0) - (q < 0))


def where(test: Callable[[Q], bool], value: Callable[[Q], Q]) -> Callable[[Q], Value]:
    return lambda e: value(e) if test(e) else None


def same(e: Q) -> Q:
    return e


def anywhere(e: Q) -> bool:
    return True


def nonzero(e: Q) -> bool:
    return e != 0


Row = tuple[str, Any, Any]


def listed(first: Any, second: Any, texts: str) -> Iterator[Row]:
    """A row for each of the texts, which go apart by bars."""
    return ((text, first, second) for text in " ".join(texts.split()).split(" | "))


# Text of one argument, its value at a fraction, and whether it is constant between corners.
CORNERED: tuple[Row, ...] = (
    *listed(where(anywhere, abs), False, """
        abs({e}) | sqrt({e}**2) | ({e}**2)**(1/2) | {e}*sign({e}) | acosh(cosh({e})) |
        sqrt(abs({e}))**2 | max({e}, -{e}) | abs(-abs({e})) | {e}*sign({e})**3 |
        abs({e})*sign({e})**2 | cbrt(abs({e})**3)
    """),
    *listed(where(nonzero, abs), False, """
        exp(log(abs({e}))) | exp(log({e}**2)/2) | {e}**2/abs({e}) | 1/abs(1/{e}) |
        {e}*atan2({e}, 0)*2/pi | abs({e}**2/{e})
    """),
    *listed(where(anywhere, same), False, """
        log(exp({e})) | tan(atan({e})) | sinh(asinh({e})) | cbrt({e}**3) | cbrt({e})**3 |
        atanh(tanh({e})) | tan(asin(sin(atan({e})))) | asinh(sinh({e})) | sign({e})*abs({e}) |
        sign({e})*sqrt({e}**2) | max({e}, {e}) | -min(-{e}, -{e})
    """),
    *listed(where(nonzero, same), False, """
        1/(1/{e}) | {e}**2/{e} | abs({e})**2/{e} | 1/tan(atan(1/{e})) | abs({e})*({e}/abs({e})) |
        {e}*({e}/{e}) | tan(pi/2 - atan(1/{e}))
    """),
    *listed(where(lambda e: e >= 0, same), False, """
        sqrt({e})**2 | ({e}**(1/2))**2 | ({e}**3)**(1/3) | {e}**(2/3)*{e}**(1/3) |
        sqrt({e})*sqrt(abs({e})) | cbrt({e})*{e}**(1/6)*sqrt({e})
    """),
    *listed(where(lambda e: e > 0, same), False, """
        exp(log({e})) | 2**(log({e})/log(2)) | exp(2*log({e}))/{e} | sqrt({e})/(1/sqrt({e})) |
        {e}*(log({e}) - log({e}) + 1)
    """),
    *listed(where(anywhere, sign), True, """
        sign({e}) | sin(pi/2*sign({e})) | sign({e}**3) | tan(pi/4*sign({e})) | sign({e})**3 |
        sign(sinh({e})) | sign(atan({e})) | sign(sign({e})) | 4/pi*atan(sign({e})) |
        max(min(sign({e}), 1), -1) | 2/pi*asin(sign({e})) | sign(exp({e}) - 1) |
        1 - 2/pi*acos(sign({e}))
    """),
    *listed(where(nonzero, sign), True, """
        abs({e})/{e} | {e}/abs({e}) | 2/pi*atan2({e}, 0) | 2/pi*(atan({e}) + atan(1/{e})) |
        sqrt({e}**2)/{e} | 1 - 2/pi*atan2(0, {e}) | cos(atan2(0, {e})) | tan(atan2({e}, abs({e}))) |
        abs(cbrt({e}))/cbrt({e}) | sign(1/{e}) | 2/pi*atan2({e}**3, 0)
    """),
    *listed(where(anywhere, lambda e: abs(sign(e))), True, """
        sign({e})**2 | abs(sign({e})) | sign(abs({e})) | sign({e}**2) | sqrt(sign({e})**2) |
        2/pi*acos(cos(pi/2*sign({e}))) | 1 - cos(pi/2*sign({e}))
    """),
    *listed(where(nonzero, lambda e: Q(1)), True, """
        {e}/{e} | ({e}/abs({e}))**2 | 2*atan2(0, {e}**2) + 1 | sign({e})**2*{e}/{e} |
        exp({e}*0/{e})
    """),
    *listed(where(lambda e: e == 0, lambda e: Q(0)), True, """
        sqrt(-abs({e})) | sqrt({e})*sqrt(-{e}) | sqrt(-{e}**2) | acos(1 + abs({e})) |
        asin(sign({e}))*sqrt(-{e}**2) | acosh(1 - {e}**2) | sqrt({e}) - sqrt(-{e}) |
        (-abs({e}))**(1/2)
    """),
    *listed(where(lambda e: e > 0, lambda e: Q(0)), True, """
        log({e}) - log({e}) | log({e}**2) - 2*log({e}) | log({e}/{e})*log({e})
    """),
)  # fmt: skip


# Waves: texts in {e}, of period 2 in {e}; linear or constant between multiples of a half.
def _wave(e: Q) -> Q:
    """asin(sin(pi e)) / pi."""
    e = (e + Q(1, 2)) % 2 - Q(1, 2)
    return e if e <= Q(1, 2) else 1 - e


def _saw(e: Q) -> Q:
    """atan2(sin(pi e), cos(pi e)) / pi, in (-1, 1]."""
    e = e % 2
    return e if e <= 1 else e - 2


def _whole(e: Q) -> bool:
    return e.denominator == 1


WAVES: tuple[tuple[str, Callable[[Q], Value], bool], ...] = (
    ("asin(sin(pi*{e}))/pi", _wave, False),
    ("1/2 - acos(sin(pi*{e}))/pi", _wave, False),
    ("acos(cos(pi*{e}))/pi", lambda e: abs(_saw(e)), False),
    ("1/2 - asin(cos(pi*{e}))/pi", lambda e: abs(_saw(e)), False),
    ("atan2(sin(pi*{e}), cos(pi*{e}))/pi", _saw, False),
    ("2/pi*atan(tan(pi*{e}/2))", where(lambda e: e % 2 != 1, _saw), False),
    ("2/pi*atan(sin(pi*{e})/(1 + cos(pi*{e})))", where(lambda e: e % 2 != 1, _saw), False),
    (
        "2/pi*atan((1 - cos(pi*{e}))/sin(pi*{e}))",
        where(lambda e: not _whole(e), _saw),
        False,
    ),
    ("sign(sin(pi*{e}))", lambda e: sign(_wave(e)), True),
    ("sign(cos(pi*{e}/2))", lambda e: sign(_wave((e + 1) / 2)), True),
    (
        "sqrt(sin(pi*{e})**2)/sin(pi*{e})",
        where(lambda e: not _whole(e), lambda e: sign(_wave(e))),
        True,
    ),
    ("sqrt(-sin(pi*{e})**2)", where(_whole, lambda e: Q(0)), True),
    (
        "sqrt(1 - cos(pi*{e})**2)/abs(sin(pi*{e}))",
        where(lambda e: not _whole(e), lambda e: Q(1)),
        True,
    ),
)  # fmt: skip


def halves(low: Q, high: Q) -> Iterator[Q]:
    return (Q(k, 2) for k in range(ceil(2 * low), floor(2 * high) + 1))


class Dice(random.Random):
    """Random numbers of the kinds that hurt."""

    def small(self) -> Q:
        return Q(self.choice([0, 0, 1, 1, -1, 2, -2, 3, -3]), self.choice([1, 1, 1, 2, 3]))

    def odd(self) -> Q:
        """Mostly small; sometimes tiny, huge, or near to a small one."""
        kind = self.random()
        if kind < 0.8:
            return self.small()
        tiny = Q(1, 10 ** self.choice([3, 9, 12, 20, 40]))
        return self.small() + self.choice([1, -1]) * tiny if kind < 0.95 else tiny

    def apart(self) -> Q:
        return self.choice([1, -1]) * Q(1, self.choice([1, 7, 100, 10**9, 10**20, 10**40]))


def piecewise(r: Dice, depth: int, waves: bool) -> Piecewise:
    """A random one, so deep."""
    kind = r.random()
    if depth == 0 or kind < 0.1:
        return line(r.choice([Q(1), Q(-1), Q(2), Q(1, 3)]), r.odd())
    e = piecewise(r, depth - 1, waves)
    if kind < 0.65:
        wavy = waves and r.random() < 0.5 and depth == 1
        text, value, constant = r.choice(WAVES if wavy else CORNERED)
        inside = e.crosses(halves, WIDE) if wavy else e.crosses()

        def at(x: Q) -> Value:
            found = e.at(x)
            return None if found is None else value(found)

        corners = e.corners | inside
        return Piecewise(f"({text.format(e=e.text)})", at, frozenset(corners), constant)
    f = piecewise(r, depth - 1, waves)
    ways: list[tuple[str, Callable[[Q, Q], Q]]] = [
        ("({} + {})", lambda u, v: u + v),
        ("({} - {})", lambda u, v: u - v),
    ]
    if e.constant or f.constant:
        ways.append(("({}*{})", lambda u, v: u * v))
    extremes: list[tuple[str, Callable[[Q, Q], Q]]] = [
        ("max({}, {})", max),
        ("min({}, {})", min),
        ("(({0} + {1} + abs({0} - {1}))/2)", max),
    ]
    way, join = r.choice(ways + extremes)

    def joined(x: Q) -> Value:
        u, v = e.at(x), f.at(x)
        return None if u is None or v is None else join(u, v)

    both = Piecewise("", _difference(e, f), e.corners | f.corners)
    corners = both.corners | (both.crosses() if join in (max, min) else frozenset())
    text = way.format(e.text, f.text)
    return Piecewise(text, joined, frozenset(corners), e.constant and f.constant)


def _difference(e: Piecewise, f: Piecewise) -> Callable[[Q], Value]:
    def at(x: Q) -> Value:
        u, v = e.at(x), f.at(x)
        return None if u is None or v is None else u - v

    return at


RELATIONS: dict[str, Callable[[Any, Any], bool]] = {
    "==": lambda u, v: u == v,
    "!=": lambda u, v: u != v,
    ">=": lambda u, v: u >= v,
    ">": lambda u, v: u > v,
    "<=": lambda u, v: u <= v,
    "<": lambda u, v: u < v,
}
MIRRORED = {"==": "==", "!=": "!=", ">=": "<=", ">": "<", "<=": ">=", "<": ">"}


class Region(NamedTuple):
    """Conditions on ``x``: a text, whether a point is inside, and where that may change."""

    text: tuple[str, ...]
    holds: Callable[[Q], bool]
    ends: frozenset[Q]
    integer: bool = False


def region(r: Dice, corners: list[Q], bounded: bool) -> Region:
    """Random conditions, their ends often at corners or very near them."""
    texts: list[str] = []
    tests: list[Callable[[Q], bool]] = []
    ends: set[Q] = set()

    def end() -> Q:
        at = r.choice(corners) if corners and r.random() < 0.7 else r.odd()
        return at + r.apart() if r.random() < 0.15 else at

    def asked(text: str, test: Callable[[Q], bool], *at: Q) -> None:
        texts.append(text)
        tests.append(test)
        ends.update(at)

    if bounded:
        wide = r.choice([Q(1), Q(2), Q(3), Q(5, 2)])
        asked(f"-{shown(wide)} <= x <= {shown(wide)}", lambda x: -wide <= x <= wide, -wide, wide)
    for _ in range(r.choice([0, 1, 1, 1, 2])):
        c, d = sorted((end(), end()))
        p, q = shown(c), shown(d)
        kind = r.randrange(12)
        if kind < 4:
            name = r.choice([">=", ">", "<=", "<"])
            relation = RELATIONS[name]
            asked(f"x {name} {p}", lambda x, c=c, f=relation: f(x, c), c)
        elif kind < 7:
            low, high = r.choice(["<", "<="]), r.choice(["<", "<="])
            between = RELATIONS[low], RELATIONS[high]
            asked(
                f"{p} {low} x {high} {q}",
                lambda x, c=c, d=d, f=between: f[0](c, x) and f[1](x, d),
                *(c, d),
            )
        elif kind == 7:
            asked(f"x != {p}", lambda x, c=c: x != c, c)
        elif kind == 8:
            asked(f"x == {p}", lambda x, c=c: x == c, c)
        elif kind == 9:
            asked(f"(x - {p})*(x - {q}) == 0", lambda x, c=c, d=d: x in (c, d), c, d)
        elif kind == 10:
            name = r.choice([">=", ">", "<=", "<"])
            relation = RELATIONS[name]
            asked(
                f"(x - {p})*(x - {q}) {name} 0",
                lambda x, c=c, d=d, f=relation: f((x - c) * (x - d), 0),
                *(c, d),
            )
        else:
            asked(f"abs(x - {p}) <= {q}", lambda x, c=c, d=d: abs(x - c) <= d, c - d, c + d)
    integer = r.random() < 0.08
    if integer:
        texts.append("x integer")
    return Region(tuple(texts), lambda x: all(test(x) for test in tests), frozenset(ends), integer)


def places(corners: Iterable[Q], integer: bool) -> Iterator[Q]:
    """Every corner, and a point between any two; of integers, those and some on either side."""
    inner = sorted(corners) or [Q(0)]
    for low, high in pairwise([inner[0] - 5, *inner, inner[-1] + 5]):
        if not integer:
            yield (low + high) / 2
        elif floor(low) + 1 < high:
            yield Q(floor(low) + 1)
    yield from (x for x in inner if not integer or _whole(x))


# Strictly monotone functions: where they are defined, and whether they rise or fall.
OUTER: tuple[Row, ...] = (
    *listed(anywhere, 1, """
        {} | {} | {} | atan({}) | cbrt({}) | exp({}) | ({})**3 | sinh({}) | 2*({}) - 1 | tanh({}) |
        10**30*({})
    """),
    *listed(anywhere, -1, "-({}) | exp(-({})) | 1/10**30 - ({})/10**30 | -asinh({})"),
    *listed(lambda e: e > 0, 1, "log({})"),
    *listed(lambda e: e >= 0, 1, "sqrt({}) | ({})**(1/4)"),
)  # fmt: skip

# What x may be: which values it takes, and where these end.
INNER: tuple[Row, ...] = (
    *listed(anywhere, (), " | ".join(["x"] * 20)),
    *listed(anywhere, (), """
        (y - z) | (2*t + 1) | cbrt(t) | log(t) | sinh(t) | (3 - t) | (10**20*t) | (t**3) | tan(t) |
        (t/10**20) | (y*z) | log(y/z)
    """),
    *listed(lambda x: x > 0, (Q(0),), "exp(t) | (1/t**2)"),
    *listed(lambda x: x >= 0, (Q(0),), "sqrt(t) | (t**2) | abs(t) | (y**2 + z**2)"),
    *listed(lambda x: x != 0, (Q(0),), "(1/t)"),
    *listed(lambda x: x >= 1, (Q(1),), "cosh(t) | (1 + t**2)"),
    *listed(lambda x: abs(x) <= 1, (Q(1), Q(-1)), "sin(t) | cos(y) | (2*t/(1 + t**2))"),
    *listed(lambda x: abs(x) < 1, (Q(1), Q(-1)), "tanh(t) | (2/pi*atan(t))"),
    *listed(lambda x: abs(x) >= 2, (Q(2), Q(-2)), "(t + 1/t) | (y/z + z/y)"),
)  # fmt: skip


def written(relation: str, left: str, right: str, region: Region, inner: str) -> str:
    given = ", ".join(region.text)
    text = f"{left} {relation} {right}" + (f" given {given}" if given else "")
    return replaced(text, {"x": inner})


def replaced(text: str, values: dict[str, str]) -> str:
    """The single letters of a text replaced, all at once."""
    found = []
    for i, letter in enumerate(text):
        beside = text[i - 1 : i] + text[i + 1 : i + 2] if i else text[1:2]
        found.append(values.get(letter, letter) if not any(map(str.isalpha, beside)) else letter)
    return "".join(found)


def settled(
    relation: str,
    points: Iterable[Q],
    inside: Callable[[Q], bool],
    sides: Callable[[Q], tuple[Q, Q] | None],
) -> bool | None:
    """Whether the relation holds at each of the points inside, None where there is none."""
    found = [pair for x in points if inside(x) and (pair := sides(x)) is not None]
    return all(RELATIONS[relation](*pair) for pair in found) if found else None


def corners(r: Dice) -> Claim:
    """Two piecewise linear functions compared."""
    waves = r.random() < 0.3
    depth = r.choice([1, 1, 1, 2]) if waves else r.choice([1, 1, 1, 2, 2, 3])
    e = piecewise(r, depth, waves)
    f = piecewise(r, r.choice([0, 0, 1]), False)
    kind = r.random()
    if kind < 0.35:  # e compared with its own value by another writing, or with one of its pieces
        pieces = [p for p in e.linear_pieces() if p[0] is not None]
        slope, start, *_ = r.choice(pieces) if pieces else (Q(0), Q(0))
        f = line(slope or Q(0), start or Q(0))
    elif kind < 0.6:
        known = [v for x in e.corners if (v := e.at(x)) is not None]
        f = line(Q(0), r.choice(known) if known else r.small())
    if r.random() < 0.1:
        tiny, g = r.apart(), f
        shifted = Piecewise(f"({g.text} + {shown(tiny)})", lambda x: None, g.corners)
        f = shifted._replace(at=lambda x: None if (v := g.at(x)) is None else v + tiny)
    both = Piecewise("", _difference(e, f), e.corners | f.corners)
    outer, defined, way = r.choice(OUTER)
    inner, taken, at = r.choice(INNER)
    if waves and inner not in ("x", "(3 - t)", "(2*t + 1)"):
        inner, taken, at = "x", anywhere, ()
    where = region(r, sorted(both.corners), waves)
    if where.integer:
        inner, taken, at = "x", anywhere, ()
    seen = both.corners | both.crosses() | where.ends | set(at) | e.crosses() | f.crosses()
    relation = r.choice([*RELATIONS, "==", "==", ">="])

    def sides(x: Q) -> tuple[Q, Q] | None:
        u, v = e.at(x), f.at(x)
        if u is None or v is None or not defined(u) or not defined(v):
            return None
        return (u, v) if way > 0 else (v, u)

    points = places(seen, where.integer)
    truth = settled(relation, points, lambda x: where.holds(x) and taken(x), sides)
    left, right = (outer.format(g.text) for g in (e, f))
    return Claim(written(relation, left, right, where, inner), truth)


# Products of factors whose sign is known everywhere

Sign = Callable[[Q, Q], "int | None"]


def _sign_of(x: Q, c: Q) -> int:
    return (x > c) - (x < c)


# Text in x and its zero c; the sign at x; other ends where the sign may change, above c.
FACTORS: tuple[Row, ...] = (
    *listed(_sign_of, (), """
        (x - c) | (x - c) | (x - c) | (x - c)**3 | (exp(x) - exp(c)) | sinh(x - c) | cbrt(x - c) |
        atan(x - c) | (x**3 - (c)**3) | (exp(x - c) - 1) | (atan(x) - atan(c)) | sign(x - c) |
        tanh(x - c) | (x + sin(x) - c - sin(c)) | ((x - c) + (x - c)**3) | (x*exp(0) - c) |
        (asinh(x) - asinh(c))
    """),
    *listed(lambda x, c: abs(_sign_of(x, c)), (), """
        (x - c)**2 | (x - c)**2 | abs(x - c) | (x - c)**4 | (cosh(x - c) - 1) |
        (exp(x - c) - 1 - (x - c)) | (x**2 - 2*(c)*x + (c)**2) | sqrt((x - c)**2) |
        (x - c)**(2)*exp(x) | abs(sign(x - c))
    """),
    *listed(lambda x, c: _sign_of(x, c) or None, (), """
        1/(x - c) | 1/(x - c)**3 | (x - c)/abs(x - c) | (1/(exp(x - c) - 1)) | atan2(x - c, 0) |
        atan(1/(x - c))
    """),
    *listed(lambda x, c: 1 if x != c else None, (), """
        1/(x - c)**2 | 1/abs(x - c) | ((x - c)/(x - c)) | exp(1/(x - c)) | exp(-1/(x - c)**2)
    """),
    *listed(lambda x, c: _sign_of(x, c) if x >= c else None, (), """
        sqrt(x - c) | (x - c)**(3/2) | acosh(x - c + 1) | (x - c)**(1/4)
    """),
    *listed(lambda x, c: 1 if x > c else None, (), """
        1/sqrt(x - c) | exp(log(x - c)) | (x - c)**(-1/3) | (x - c)**pi
    """),
    *listed(lambda x, c: 0 if x == c else None, (), """
        sqrt(-(x - c)**2) | acosh(1 - (x - c)**2)
    """),
    *listed(lambda x, c: _sign_of(x, c) if x > c - 1 else None, (Q(-1),), """
        log(x - c + 1)
    """),
    *listed(lambda x, c: _sign_of(x, c) if abs(x - c) <= 1 else None, (Q(-1), Q(1)), """
        asin(x - c) | (acos(c - x) - pi/2)
    """),
    *listed(lambda x, c: _sign_of(c + 1, x) if abs(x - c) <= 1 else None, (Q(-1), Q(1)), """
        acos(x - c)
    """),
    *listed(lambda x, c: _sign_of(x, c) * _sign_of(x, c + 1), (Q(1),), """
        ((x - c)*(x - c - 1)) | ((x - c)**2 - (x - c)) | ((x - c - 1/2)**2 - 1/4) |
        (abs(x - c - 1/2) - 1/2)
    """),
    *listed(lambda x, c: 1, (), """
        exp(x) | (1 + x**2) | (x**2 + x + 1) | (2 + cos(x)) | cosh(x) | (pi - 3) |
        (1 + abs(x - c)) | (sqrt(1 + x**2) - x) | (1/10**30) | (pi/2 - atan(x)) | (1 - tanh(x))
    """),
    *listed(lambda x, c: -1, (), """
        (-1) | (3 - pi) | (sin(x) - 2) | (-1/10**40)
    """),
)  # fmt: skip


def products(r: Dice) -> Claim:
    """A product of factors of known sign against 0, or one part of it against the other."""
    zeros = [r.odd() for _ in range(2)]
    zeros.append(zeros[0] + r.apart())
    chosen = [(*r.choice(FACTORS), r.choice(zeros)) for _ in range(r.choice([1, 2, 2, 3]))]
    inner, taken, at = r.choice(INNER)
    ends = {c for *_, c in chosen} | {c + d for _, _, more, c in chosen for d in more}
    where = region(r, sorted(ends), False)
    if where.integer:
        inner, taken, at = "x", anywhere, ()

    def sides(x: Q) -> tuple[Q, Q] | None:
        product = 1
        for _, sign_at, _, c in chosen:
            found = sign_at(x, c)
            if found is None:
                return None
            product *= found
        return Q(product), Q(0)

    relation = r.choice([*RELATIONS, ">=", ">", "!="])
    points = places(ends | where.ends | set(at), where.integer)
    truth = settled(relation, points, lambda x: where.holds(x) and taken(x), sides)
    named = [replaced(text, {"c": shown(c)}) for (text, *_, c) in chosen]
    left, right = "*".join(named), "0"
    kind = r.random()
    if kind < 0.2:
        left, right = f"{left} + {named[-1]}", named[-1]
    elif kind < 0.3:
        left, right = f"atan({left})", "0"
    elif kind < 0.4:
        left, right = f"exp({left})", "1"
    if r.random() < 0.2:
        left, right, relation = right, left, MIRRORED[relation]
    return Claim(written(relation, left, right, where, inner), truth)


# Power series at 0

ORDER = 8
Series = tuple[Q, ...]


def times(u: Series, v: Series) -> Series:
    return tuple(sum((u[k] * v[n - k] for k in range(n + 1)), Q(0)) for n in range(ORDER))


def inside(outer: Series, u: Series) -> Series:
    """The outer series at one without a constant term."""
    total: Series = (Q(0),) * ORDER
    for coefficient in reversed(outer):
        total = times(total, u)
        total = (total[0] + coefficient, *total[1:])
    return total


def _odd(value: Callable[[int], Q]) -> Series:
    return tuple(value(n) if n % 2 else Q(0) for n in range(ORDER))


def _even(value: Callable[[int], Q]) -> Series:
    return tuple(Q(0) if n % 2 else value(n) for n in range(ORDER))


def _root(power: Q) -> Series:
    """(1 + x)**power."""
    found = [Q(1)]
    for n in range(1, ORDER):
        found.append(found[-1] * (power - n + 1) / n)
    return tuple(found)


SERIES: dict[str, Series] = {
    "exp({})": tuple(Q(1, factorial(n)) for n in range(ORDER)),
    "sin({})": _odd(lambda n: Q((-1) ** (n // 2), factorial(n))),
    "cos({})": _even(lambda n: Q((-1) ** (n // 2), factorial(n))),
    "sinh({})": _odd(lambda n: Q(1, factorial(n))),
    "cosh({})": _even(lambda n: Q(1, factorial(n))),
    "atan({})": _odd(lambda n: Q((-1) ** (n // 2), n)),
    "atanh({})": _odd(lambda n: Q(1, n)),
    "log(1 + {})": tuple(Q(-((-1) ** n), n) if n else Q(0) for n in range(ORDER)),
    "sqrt(1 + {})": _root(Q(1, 2)),
    "cbrt(1 + {})": _root(Q(1, 3)),
    "1/(1 + {})": _root(Q(-1)),
    "1/sqrt(1 - {})": tuple((-1) ** n * c for n, c in enumerate(_root(Q(-1, 2)))),
}


def series(r: Dice, depth: int) -> tuple[str, Series]:
    """A random function that is analytic at 0, and its coefficients."""
    if depth == 0:
        a, n = r.choice([Q(1), Q(1), Q(-1), Q(2), Q(1, 2)]), r.choice([1, 1, 2])
        text = f"{'' if a == 1 else shown(a) + '*'}x{'' if n == 1 else f'**{n}'}"
        return f"({text})", tuple(a if k == n else Q(0) for k in range(ORDER))
    text, u = series(r, depth - 1)
    kind = r.random()
    if kind < 0.6:
        name = r.choice(list(SERIES))
        if u[0]:  # without its constant term
            text, u = f"({text} - {shown(u[0])})", (Q(0), *u[1:])
        return f"({name.format(text)})", inside(SERIES[name], u)
    other, v = series(r, r.randrange(depth))
    if kind < 0.8:
        return f"({text}*{other})", times(u, v)
    sign_, word = r.choice([(1, "+"), (-1, "-")])
    return f"({text} {word} {other})", tuple(p + sign_ * q for p, q in zip(u, v, strict=True))


def expansions(r: Dice) -> Claim:
    """A function against its own Taylor polynomial, right or off by a little."""
    text, u = series(r, r.choice([1, 1, 2]))
    n = r.randint(1, 5)
    polynomial = [shown(c) + f"*x**{k}" for k, c in enumerate(u[:n]) if c]
    right = " + ".join(polynomial) or "0"
    rest: list[Q] = [Q(0)] * n + list(u[n:])
    if r.random() < 0.3:
        k = r.randrange(n)
        rest[k] = -r.apart()
        right += f" + {shown(-rest[k])}*x**{k}"
    first = next((k for k, c in enumerate(rest) if c), None)
    if first is None:
        return expansions(r)
    kind = r.choice(["O", "O", "o", "Theta", "~", "->"])
    m = max(1, first + r.choice([-1, 0, 0, 1]))
    path = r.choice(["0", "0+", "0-"])
    if kind == "->":
        value = rest[first] if m == first else Q(0)
        true = first >= m
        if r.random() < 0.3:
            value, true = value + r.apart(), False
        claim, truth = f"({text} - ({right}))/x**{m} -> {shown(value)}", true
    elif kind == "~":
        c = rest[first] * (1 if r.random() < 0.6 else 1 + r.apart())
        truth = m == first and c == rest[first]
        claim = f"{text} - ({right}) ~ {shown(c)}*x**{m}"
    else:
        truth = {"O": first >= m, "o": first > m, "Theta": first == m}[kind]
        claim = f"{text} == {right} + {kind}(x**{m})"
        if kind == "Theta":
            claim = f"{text} - ({right}) == Theta(x**{m})"
    far = r.random() < 0.25
    if far and path != "0":
        return Claim(
            replaced(claim, {"x": "(1/x)"}) + f" as x -> {'oo' if path == '0+' else '-oo'}", truth
        )
    if r.random() < 0.2:
        a = r.choice([Q(1), Q(-2), Q(1, 3)])
        return Claim(replaced(claim, {"x": f"(x - {shown(a)})"}) + f" as x -> {a}{path[1:]}", truth)
    return Claim(f"{claim} as x -> {path}", truth)


# Identities of several arguments, false ones made so at a point

# Each true, or false at values of u and v at which both sides are defined.
RULES = """
    sin(u + v) == sin(u)*cos(v) + cos(u)*sin(v)
    cos(u)**2 - sin(u)**2 == cos(2*u)
    sin(u)*sin(v) == (cos(u - v) - cos(u + v))/2
    tan(u) + tan(v) == sin(u + v)/(cos(u)*cos(v))
    sin(3*u) == 3*sin(u) - 4*sin(u)**3
    tan(u/2) == (1 - cos(u))/sin(u)
    exp(u + v) == exp(u)*exp(v)
    cosh(u)**2 - sinh(u)**2 == 1
    tanh(u) == 1 - 2/(exp(2*u) + 1)
    log(u*v) == log(u) + log(v)
    log(u*v) == log(abs(u)) + log(abs(v))
    log(u**2) == 2*log(u)
    log(u**2) == 2*log(abs(u))
    log(u/v) == log(-u) - log(-v)
    sqrt(u)*sqrt(v) == sqrt(u*v)
    sqrt(u**2*v) == abs(u)*sqrt(v)
    sqrt(u*v) == sqrt(abs(u))*sqrt(abs(v))
    sqrt(u/v)*v == sqrt(u)*sqrt(v)
    sqrt(u**2 + 2*u*v + v**2) == abs(u + v)
    sqrt(u + 2*sqrt(u*v) + v) == sqrt(u) + sqrt(v)
    (u**2)**(1/4) == sqrt(abs(u))
    u**(2/3) == cbrt(u)**2
    cbrt(u*v) == cbrt(u)*cbrt(v)
    abs(u*v) == abs(u)*abs(v)
    max(u, v) + min(u, v) == u + v
    max(u, v)*min(u, v) == u*v
    sign(u*v) == sign(u)*sign(v)
    atan2(u, v) == 2*atan(u/(sqrt(u**2 + v**2) + v))
    cos(atan2(u, v)) == v/sqrt(u**2 + v**2)
    sin(2*atan(u)) == 2*u/(1 + u**2)
    cos(asin(u)) == sqrt(1 - u**2)
    tan(acos(u))*u == sqrt(1 - u**2)
    asin(u) + acos(u) == pi/2
    asinh(u) == log(u + sqrt(1 + u**2))
    acosh(u) == log(u + sqrt(u**2 - 1))
    atanh(u) == (log(1 + u) - log(1 - u))/2
    acosh(u) == 2*log(sqrt((u + 1)/2) + sqrt((u - 1)/2))
    atan(u) - atan(v) == atan2(u - v, 1 + u*v)
    atan(u) + atan(v) == atan2(u + v, 1 - u*v)
    atan(u) + atan(v) == atan((u + v)/(1 - u*v)) but u = 2, v = 3
    2*atan(u) == asin(2*u/(1 + u**2)) but u = 2, v = 0
    2*atan(u) == acos((1 - u**2)/(1 + u**2)) but u = -1/1000, v = 0
    atan(u) + atan(1/u) == pi/2 but u = -1/1000000, v = 0
    sqrt(u**2) == u but u = -1/1000000000, v = 0
    sqrt(u**2 - 2*u*v + v**2) == u - v but u = 1, v = 100001/100000
    (u**4)**(1/4) == u but u = -3, v = 0
    cbrt(u**2) == cbrt(abs(u))**2 + (abs(u) - u)/10**20 but u = -1, v = 0
    log(u**2*v**2) == 2*log(u) + 2*log(abs(v)) + 1/10**30 but u = 1, v = -1
    log(abs(u*v)) == log(abs(u)) - log(abs(v)) but u = 1, v = 2
    asin(sin(u)) == u but u = 2, v = 0
    acos(cos(u)) == u but u = -1/100, v = 0
    acos(cos(u)) == abs(u) but u = 4, v = 0
    atan(tan(u)) == u but u = 2, v = 0
    atan2(sin(u), cos(u)) == u but u = -22/7, v = 0
    acosh(cosh(u)) == u but u = -1, v = 0
    atan2(u, v) == atan(u/v) but u = 0, v = -1
    atan2(u, v) == atan2(-u, -v) + pi but u = -1, v = 0
    atan2(u, v) + atan2(v, u) == pi/2 but u = -1/10000, v = -1
    sign(u)**2 == 1 but u = 0, v = 0
    sign(u) == u/abs(u) + sign(v) - sign(v)**3
    abs(u + v) == abs(u) + abs(v) but u = 1/1000000000, v = -1
    max(u, v) == (u + v + sqrt((u - v)**2))/2
    max(u, v) == sqrt(max(u**2, v**2)) but u = -2, v = 1
    exp(log(u) + log(v)) == u*v
    u**v == exp(v*log(u))
    (u**v)**2 == u**(2*v)
    (u**2)**v == abs(u)**(2*v)
    (u**2)**(v/2) == u**v + (abs(u) - u)*log(u)
    sqrt(1 - sin(u)**2) == cos(u) but u = 2, v = 0
    sqrt(1 - sin(u)**2) == abs(cos(u))
    sqrt((1 - cos(u))/2) == sin(u/2) but u = -1, v = 0
    sqrt((1 - cos(u))/2) == abs(sin(u/2))
    tan(u/2) == sqrt((1 - cos(u))/(1 + cos(u))) but u = -1, v = 0
    log((1 + sin(u))/(1 - sin(u)))/2 == atanh(sin(u))
    log(tan(u/2 + pi/4)) == atanh(sin(u))
    asinh(tan(u)) == atanh(sin(u)) but u = 2, v = 0
    asinh(tan(u)) == atanh(sin(u))*sign(cos(u))
    sqrt(u)*sqrt(u) == abs(u)
    (u**3)**(1/3) == cbrt(u)**3
    sqrt(5 + 2*sqrt(6))*u == (sqrt(2) + sqrt(3))*u
    sqrt(5 - 2*sqrt(6))*u == (sqrt(2) - sqrt(3))*u but u = 1, v = 0
    cbrt(2 + sqrt(5)) + cbrt(2 - sqrt(5)) + u == 1 + u
    4*atan(1/5) - atan(1/239) + u == pi/4 + u
    diff(u*v, x) == diff(u, x)*v + u*diff(v, x)
"""


def ruled(line: str) -> tuple[str, tuple[Q, Q] | None]:
    """The claim of a line, and the point at which it is false."""
    claim, _, point = line.strip().partition(" but ")
    u, v = (Q(value.partition("=")[2].strip()) for value in point.split(",")) if point else (0, 0)
    return claim, (Q(u), Q(v)) if point else None


# Functions that have a value at 0, and are defined around it, of one or two variables.
AROUND = (
    *("x", "x", "x", "-x", "2*x", "x - y", "y", "y"),
    *("x", "2*x", "x/3", "-x", "x + y", "x*y - y", "x**2 - x", "sin(x)", "exp(x) - 1", "x*y**2"),
    *("atan(x) - y", "x/(1 + y**2)", "x**3", "10**15*x", "x/10**15", "log(1 + x**2) - y", "x**2"),
    *("abs(x)", "x*abs(y)", "sqrt(1 + x**2) - 1", "cbrt(x)", "tanh(x - y)", "x**2 - y**2", "-x**4"),
)


def identities(r: Dice) -> Claim:
    """A known identity at functions of x and y; what is false is false at x = y = 0."""
    rule, at = ruled(r.choice(RULES.strip().splitlines()))
    p, q = at or (r.odd(), r.odd())
    u, v = r.choice(AROUND), r.choice(AROUND)
    values = {"u": f"({u} + {shown(p)})", "v": f"({v} + {shown(q)})"}
    given = r.choice(["", "", "x >= -1", "x**2 + y**2 < 1", "x > -1/10**9, y > -1/10**9"])
    if at is not None and r.random() < 0.3:  # nothing but the point
        given = r.choice(
            ["x == 0, y == 0", "x**2 + y**2 == 0", "x >= 0, x <= 0, y**2 <= 0", "x == y, y == 0"]
        )
    text = replaced(rule, values)
    truth: bool | None = at is None
    if at is None and rule.startswith("diff") and ("abs" in u + v or "cbrt" in u + v):
        given = "x > 1, y > 1"
    if at is None and r.random() < 0.3 and not rule.startswith("diff"):
        # False wherever both are defined; whether they are anywhere is not said.
        return Claim(f"{text} + {shown(r.apart())}" + (f" given {given}" if given else ""), False)
    return Claim(text + (f" given {given}" if given else ""), truth)


# Polynomials on curves with known points

CURVES: tuple[tuple[str, tuple[tuple[Q, Q], ...], str], ...] = (
    ("x**2 + y**2 - 1", ((Q(3, 5), Q(4, 5)), (Q(1), Q(0)), (Q(-5, 13), Q(12, 13))), ""),
    ("x*y - 1", ((Q(2), Q(1, 2)), (Q(-1), Q(-1)), (Q(10**6), Q(1, 10**6))), ""),
    ("y - x**2", ((Q(2), Q(4)), (Q(0), Q(0)), (Q(-1, 3), Q(1, 9))), ""),
    ("x + y - 1", ((Q(1, 2), Q(1, 2)), (Q(1), Q(0)), (Q(10**9), Q(1 - 10**9))), ""),
    ("x**2 + y**2", ((Q(0), Q(0)),), ""),
    ("(x - 1)**2 + (y + 2)**2", ((Q(1), Q(-2)),), ""),
    ("x**2 - 4", ((Q(2), Q(0)), (Q(-2), Q(7))), ""),
    ("x**2 - 4", ((Q(2), Q(0)), (Q(2), Q(-1))), "x > 0"),
    ("x**3 - 8", ((Q(2), Q(0)), (Q(2), Q(3))), ""),
    ("x*y", ((Q(0), Q(3)), (Q(2), Q(0)), (Q(0), Q(0))), ""),
    ("x*y", ((Q(0), Q(1)), (Q(0), Q(2))), "y > 0"),
    ("2*x - 3*y", ((Q(3), Q(2)), (Q(0), Q(0))), ""),
    ("x**2 - y**2", ((Q(1), Q(1)), (Q(1), Q(-1))), ""),
    ("x**2 - y**2", ((Q(1), Q(1)), (Q(3), Q(3))), "x > 0, y > 0"),
    ("abs(x) + abs(y)", ((Q(0), Q(0)),), ""),
    ("abs(x) - y", ((Q(-1), Q(1)), (Q(2), Q(2)), (Q(0), Q(0))), ""),
)

Polynomial = dict[tuple[int, int], Q]


def polynomial(r: Dice, degree: int) -> Polynomial:
    found: Polynomial = {}
    for _ in range(r.choice([1, 2, 3])):
        i = r.randint(0, degree)
        found[i, r.randint(0, degree - i)] = r.odd() or Q(1)
    return found


def said(p: Polynomial) -> str:
    return "(" + " + ".join(f"{shown(c)}*x**{i}*y**{j}" for (i, j), c in p.items()) + ")"


def value(p: Polynomial, x: Q, y: Q) -> Q:
    return sum((c * x**i * y**j for (i, j), c in p.items()), Q(0))


def curves(r: Dice) -> Claim:
    """A polynomial under an equation: changed by a multiple of it, or by what is not 0 there."""
    e, points, more = r.choice(CURVES)
    p, q = polynomial(r, 2), polynomial(r, 1)
    left, right = said(p), f"{said(p)} + ({e})*{said(q)}"
    given = f"{e} == 0" + (f", {more}" if more else "")
    relation = r.choice(["==", "==", ">=", ">", "!="])
    s = polynomial(r, 1)
    x, y = r.choice(points)
    at = value(s, x, y)
    if relation == "==":
        if r.random() < 0.5:
            return Claim(f"{left} == {right} given {given}", True)
        if at == 0:
            s = {(0, 0): r.apart()}
        return Claim(f"{left} == {right} + {said(s)} given {given}", False)
    if relation == "!=":  # they agree where s is 0
        s = {**s, (0, 0): s.get((0, 0), Q(0)) - at}
        return Claim(f"{left} != {right} + {said(s)} given {given}", False)
    kind = r.random()
    square = f"{said(s)}**2"
    if kind < 0.35:
        return Claim(f"{right} + {square} >= {left} given {given}", True)
    if kind < 0.6:
        return Claim(f"{right} + {square} + {shown(abs(r.apart()))} > {left} given {given}", True)
    s = {**s, (0, 0): s.get((0, 0), Q(0)) - at}
    if kind < 0.8:  # it touches at the point
        return Claim(f"{right} + {said(s)}**2 > {left} given {given}", False)
    return Claim(f"{right} + {said(s)}**2 >= {left} + {shown(abs(r.apart()))} given {given}", False)


# Constants

DIGITS = (
    (
        "pi | 4*atan(1) | acos(-1) | atan2(0, -1) | 2*asin(1)",
        "3.14159265358979323846264338327950288419716939937510582097494459",
    ),
    ("E | exp(1)", "2.71828182845904523536028747135266249775724709369995957496696763"),
    (
        "sqrt(2) | 2**(1/2) | 2*sin(pi/4) | 1/sin(pi/4)",
        "1.41421356237309504880168872420969807856967187537694807317667973",
    ),
    (
        "log(2) | -log(1/2) | log(8)/3",
        "0.69314718055994530941723212145817656807550013436025525412068000",
    ),
)


def constants(r: Dice) -> Claim:
    """Numbers that nearly agree, and roots of integers compared by squaring."""
    kind = r.random()
    if kind < 0.5:
        texts, digits = r.choice(DIGITS)
        text = r.choice(texts.split(" | "))
        n = r.randint(3, 55)
        cut = Q(digits[: n + 2])
        below = r.random() < 0.5
        cut += 0 if below else Q(1, 10**n)
        relation = r.choice([*RELATIONS])
        truth = RELATIONS[relation](1 if below else -1, 0)
        return Claim(f"{text} {relation} {shown(cut)}", truth)
    a, b = (r.randint(1, 10 ** r.choice([1, 2, 15])) for _ in range(2))
    relation = r.choice([*RELATIONS])
    if kind < 0.75:  # sqrt(n) + sqrt(n + 2 m) against 2 sqrt(n + m): concave
        text = f"sqrt({a}) + sqrt({a + 2 * b}) {relation} 2*sqrt({a + b})"
        return Claim(text, RELATIONS[relation](-1, 0))
    # (a + b sqrt 2)**2 written out, perhaps off by one
    off = r.choice([0, 0, 1, -1])
    root = f"sqrt({a * a + 2 * b * b + off} + {2 * a * b}*sqrt(2))"
    return Claim(f"{root} {relation} {a} + {b}*sqrt(2)", RELATIONS[relation](off, 0))


KINDS: tuple[tuple[Callable[[Dice], Claim], int], ...] = (
    *(
        (constants, 20),
        (identities, 45),
        (corners, 15),
        (products, 15),
        (expansions, 8),
        (curves, 2),
    ),
)


def made(r: Dice) -> tuple[str, Claim]:
    """A claim and its kind. Few of those without a point: to look for one takes long."""
    makers, weights = zip(*KINDS, strict=True)
    while True:
        maker = r.choices(makers, weights)[0]
        claim = maker(r)
        if claim.truth is not None or r.random() < 0.03:
            return maker.__name__, claim


class TooLong(BaseException):
    """The time of a claim is over."""


@contextmanager
def limited() -> Iterator[None]:
    """Stop what is under way in Python after a while, and this process where FLINT does not end."""

    def stop(number: int, frame: object) -> None:
        raise TooLong

    signal.signal(signal.SIGVTALRM, stop)
    signal.signal(signal.SIGPROF, signal.SIG_DFL)
    signal.setitimer(signal.ITIMER_PROF, HANGS)
    signal.setitimer(signal.ITIMER_VIRTUAL, SECONDS)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.setitimer(signal.ITIMER_PROF, 0)


class Said(NamedTuple):
    """What is said of a claim, why, and after how much time of the processor."""

    verdict: str
    why: str
    seconds: float


def verdict(text: str) -> Said:
    """Decide a claim."""
    start = time.process_time()
    try:
        with limited():
            answer = decide_claim(text)
        said, why = answer.verdict.value, answer.why
    except TooLong:
        said, why = "TIME", ""
    except InputError as error:
        said, why = "NOT READ", str(error)
    except Exception as error:
        said, why = "FAILS", f"{type(error).__name__}: {error}"
    return Said(said, why, time.process_time() - start)


def verdicts(texts: list[str]) -> list[Said]:
    """Decide some claims, all in one call: the way to a process and back is long where many run."""
    return [verdict(text) for text in texts]


def answers(texts: list[str]) -> Iterator[Said]:
    """What is said of each, by a process that is replaced when it dies of one of them."""
    with Processes(1, deaths=1, forked=True) as pool:
        batches = [texts[n : n + BATCH] for n in range(0, len(texts), BATCH)]
        for batch, found in zip(
            batches, pool.in_order(verdicts, ((b,) for b in batches)), strict=True
        ):
            try:
                yield from found.result()
            except BrokenExecutor:
                for text in batch:
                    try:
                        yield pool.submit(verdict, text).result()
                    except BrokenExecutor:
                        yield Said("DIES", "", HANGS)


def is_wrong(said: str, why: str, truth: bool | None) -> bool:
    """Whether a verdict speaks against the truth, or a contradiction was met on the way."""
    holds = said in ("PROVED", "ENCLOSED")
    against = (holds and truth is not True) or (said == "REFUTED" and truth is not False)
    return against or said == "FAILS" or "please report" in why


def main(count: int, seed: int) -> Counter[str]:
    """Decide random claims and print what is wrong; returns how many verdicts are, by kind."""
    r, wrong = Dice(seed), Counter[str]()
    counts: Counter[tuple[str, str, str]] = Counter()
    spent: Counter[tuple[str, str, str]] = Counter()
    asked = [made(r) for _ in range(count)]
    resource.setrlimit(resource.RLIMIT_AS, (MEMORY, resource.getrlimit(resource.RLIMIT_AS)[1]))
    found = answers([claim.text for _, claim in asked])
    for (kind, claim), (said, why, seconds) in zip(asked, found, strict=True):
        row = kind, str(claim.truth), said
        counts[row] += 1
        spent[row] += seconds
        if said in ("NOT READ", "DIES"):
            print(said, claim.text, why, flush=True)
        elif is_wrong(said, why, claim.truth):
            wrong[kind] += 1
            print("WRONG", kind, claim.truth, said, claim.text, "|", why[:200], flush=True)
        chunks.EXAMPLES[kind] += 1
        chunks.DECIDED[kind] += said in ("PROVED", "ENCLOSED", "REFUTED")
    for row, number in sorted(counts.items()):
        kind, truth, said = row
        print(f"{kind:12}{truth:7}{said:12}{number:6}{1000 * spent[row] / number:8.1f} ms each")
    return wrong


def chunk() -> int:
    """The claims of a chunk, unless they are done; returns how many verdicts are wrong."""
    if chunks.done() & {f"tests/known.py::{maker.__name__}" for maker, _ in KINDS}:
        return 0
    began = time.perf_counter()
    wrong = main(CLAIMS, chunks.CHUNK)
    seconds = time.perf_counter() - began
    for kind, number in list(chunks.EXAMPLES.items()):
        outcome = "failed" if wrong[kind] else "passed"
        chunks.record(f"tests/known.py::{kind}", outcome, seconds * number / CLAIMS)
    return wrong.total()


if __name__ == "__main__":
    failed = chunk() if chunks.IN_CHUNKS else main(*map(int, sys.argv[1:3])).total()
    sys.exit(min(1, failed))
