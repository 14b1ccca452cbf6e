"""What numbers say of a limit, an order or an eventual inequality: balls at points of its path.

An asymptotic claim is read as a quantity that must tend to 0, stay bounded or never occur: the
distance from the limit, the ratio of the two sides, a violation of the inequality. Its supremum is
bounded from below at a few distances from the end, each far nearer than the last. Where sines and
cosines oscillate, points are spread over the periods of every one of them, and the largest value
found is improved by smaller and smaller steps, so that a pole at one phase is met.

None of this is a proof. Numbers that contradict a proof, or do not confirm a refutation, turn the
answer into UNDECIDED. Operations are evaluated by the independent check only.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from itertools import islice, pairwise
from typing import NamedTuple

from flint import arb

from tresym.reals.cross_check import FALSE, Program, has_meaning, program
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import LEAVES, Expr, symbols
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision

DISTANCES = (10**3000, 10**300, 10**30, 4000, 1000, 250, 120, 60, 14, 5, 3, 2)
"""Binary orders of the distances from the end (of x at infinity), the farthest first."""
FINE, COARSE = 250, 60
"""Up to these orders the phases of waves are looked at, the latter for inequalities."""
SETTLED = 14
"""From this order on growth is taken for that of the end."""
WHOLE = (60, 30, 14, 9, 6)
"""The orders for a path through the integers."""
MOST_BITS = 12_000
WAVES = frozenset(("sin", "cos", "tan", "cot", "sec", "csc"))
SPREAD, STEPS = 28, 26
"""Points over the periods of a wave, and how often the best of them is improved."""
STARTS = 5
"""From how many of the largest values smaller steps are taken."""
TINY = arb((1, -40))
SLOWEST, SLOW = arb("0.1"), 20
LAST, POLE, STALLED = 12, 1000, 8
"""By what a value grows in the last of the steps, each a third of the one before, beside a pole."""
SHRINKS, GROWS = arb("0.9"), arb("1.05")
"""By what a quantity that tends to 0 shrinks, or one that is unbounded grows, between distances."""
PERIODIC_GROWS = arb("1.3")
BOUNDED = ("O", "Theta")
CONSTANT, CONSTANT_WITH_WAVES = arb("0.001"), arb("0.05")
"""By which part of itself a quantity may change that is taken to be constant."""
LEAST_EXPONENT, SAME_EXPONENT = arb("0.05"), arb("0.03")
"""The least exponent of growth, and by which part of itself it may change."""
BITS_OF_LAW = 200


class Supremum(NamedTuple):
    """Bounds of the largest value at one distance; ``pole``: it still grows as steps shrink."""

    order: int
    low: arb
    high: arb
    pole: bool = False


@dataclass(frozen=True)
class Ray:
    """One side of a path, its parameters being numbers.

    Attributes:
        claim: what is said.
        path: where its variable goes.
        side: from above or below.
        at: balls of all other variables.
        integers: the variables that are integers, perhaps that of the path among them.
    """

    claim: Comparison
    path: Path
    side: int
    at: Mapping[str, arb]
    integers: Sequence[str] = ()


def fails(ray: Ray) -> bool | None:
    """Return True if numbers show that the claim fails, False if it holds, None otherwise."""
    if not all(map(has_meaning, _sides(ray.claim))):
        return None
    waves = oscillating(ray)
    distances = WHOLE if ray.path.name in ray.integers else DISTANCES
    inequality = ray.claim.relation in FALSE
    most = (COARSE if inequality else FINE) if waves else max(distances)
    told = (_Distance(ray, e, waves).supremum() for e in distances if e <= most)
    last = list(islice((x for x in told if x is not None), 3 if waves else 2))[::-1]
    if len(last) < 2:
        return None
    if all(x.pole for x in last[-2:]):
        return True
    if inequality:
        return None if any(x.pole for x in last) else False
    before, now = last[-2:]
    if ray.claim.relation in BOUNDED:
        grows = PERIODIC_GROWS if waves else GROWS
        grown = all(y.low > grows * x.high for x, y in pairwise(last))
        if grown and now.order >= SETTLED:
            return True
        return False if now.high < grows * before.low and now.high < grows * before.high else None
    if now.low > 0 and now.low > SHRINKS * before.high:
        return True
    return False if now.high < TINY else None


def contradicts(ray: Ray) -> bool:
    """Return whether numbers speak so clearly against a claim that a proof of it is in doubt.

    Finitely many points cannot refute a limit: ``log(log(log(x)))**10/log(log(x))`` tends to 0 and
    still grows at x = 2**(10**3000). So it is not enough that the quantity grows or does not
    shrink. At the three farthest distances u it must also follow a simple law: it is constant, or
    it grows like a power of u, of log(u) or of exp(u), with one exponent.
    """
    if fails(ray) is False or not all(map(has_meaning, _sides(ray.claim))):
        return False
    waves = oscillating(ray)
    distances = WHOLE if ray.path.name in ray.integers else DISTANCES
    inequality = ray.claim.relation in FALSE
    most = (COARSE if inequality else FINE) if waves else max(distances)
    at = (_Distance(ray, e, waves) for e in distances if e <= most)
    if inequality and not waves:
        wrong = ((x.order, x.violation()) for x in at)
        known = list(islice(((n, size) for n, size in wrong if size is not None), 3))
        orders = [arb(n) for n, _ in known]
        return len(known) == 3 and follows_a_law(orders, [size for _, size in known])
    told = list(islice((x for x in (one.supremum() for one in at) if x is not None), 3))
    if all(x.pole for x in told[:2]):
        return bool(told[1:]) and fails(ray) is True
    if len(told) < 3 or any(x.pole for x in told):
        return False
    with ball_precision(BITS_OF_LAW):
        return follows_a_law(
            [_place(x.order, distances) for x in told],
            [x.low for x in told],
            bounded=ray.claim.relation in BOUNDED,
            same=CONSTANT_WITH_WAVES if waves else CONSTANT,
        )


def follows_a_law(
    orders: list[arb], sizes: list[arb], bounded: bool = False, same: arb = CONSTANT
) -> bool:
    """Return whether sizes at distances 2**order, the farthest first, follow a simple law.

    Args:
        orders: the binary orders of the distances.
        sizes: positive numbers.
        bounded: whether a constant is what is claimed, so that only growth speaks against it.
        same: by which part of itself a constant may change.
    """
    if not all(size > 0 for size in sizes):
        return False
    far, middle, near = sizes
    if all(abs(far / other - 1) < same for other in (middle, near)):
        return not bounded
    logs = list(map(_binary, sizes))
    laws = [(logs, orders), (logs, list(map(_binary, orders)))]
    laws += [(list(map(_binary, logs)), orders)] if all(size > 2 for size in logs) else []
    for logs, places in laws:
        first = (logs[0] - logs[1]) / (places[0] - places[1])
        second = (logs[1] - logs[2]) / (places[1] - places[2])
        if first > LEAST_EXPONENT and abs(first - second) < SAME_EXPONENT * first:
            return True
    return False


def _place(order: int, distances: Sequence[int]) -> arb:
    """The binary order of the farthest point that is looked at."""
    return _binary(arb(2) ** order * 149 / 128 + 2 * SPREAD) if distances is WHOLE else arb(order)


def _binary(x: arb) -> arb:
    return x.log() / arb(2).log()


def _sides(claim: Comparison) -> tuple[Expr, ...]:
    return (claim.left, claim.right, *claim.differentiated)


def oscillating(ray: Ray) -> list[Expr]:
    """The arguments of sines and cosines that are not seen to stay bounded along the ray."""
    found = []
    for argument in _waves(ray):
        sizes = [_Distance(ray, e, ()).value(argument) for e in (FINE, FINE // 4)]
        far, near = (None if size is None else abs(size) for size in sizes)
        if far is None or near is None or not (far < 4 or far < near * arb("1.2")):
            found.append(argument)
    return found


def _waves(ray: Ray) -> list[Expr]:
    """The arguments of the sines and cosines in which the variable occurs."""
    found: dict[Expr, None] = {}
    stack = list(_sides(ray.claim))
    while stack:
        e = stack.pop()
        if e.op in LEAVES or ray.path.name not in symbols(e):
            continue
        if e.op in WAVES:
            found[e.args[0]] = None
        stack += [arg for arg in e.args if isinstance(arg, Expr)]
    return [e for e in found if not e.loose]


class _Distance:
    """The points of a ray at about one distance from the end, in u → ∞ with x = u or a ± 1/u."""

    def __init__(self, ray: Ray, order: int, waves: Sequence[Expr]) -> None:
        self.ray, self.names, self.waves = ray, sorted(ray.at), waves
        self.order = order
        self.bits = min((5 if waves else 8) * order + 400, MOST_BITS)
        self.fixed = [arb(ray.at[name]) for name in self.names]
        sides = [e for e in _sides(ray.claim) if e not in (INFINITY, -INFINITY)]
        with ball_precision(self.bits):
            self.start = (arb((149, order - 7)) + arb(61) / 257).mid()  # at no special phase
            self.values = self._program(sides)
            end = [] if ray.path.point is None else [ray.path.point]
            self.end = self._program(end)([*self.fixed, self.start])

    def _program(self, trees: Sequence[Expr]) -> Program:
        return program(trees, [*self.names, self.ray.path.name], self.ray.integers)

    def _x(self, u: arb) -> arb | None:
        if self.ray.path.point is None:
            return self.ray.side * u
        return None if not self.end else self.end[0] + self.ray.side / u

    def size(self, u: arb) -> arb | None:
        """A ball of the quantity at a point; infinite where it fails outright, None if unknown."""
        x = self._x(u) if u >= self.start.floor() else None
        found = None if x is None else self.values([*self.fixed, x])
        return None if found is None else quantity(self.ray.claim, found)

    def violation(self) -> arb | None:
        """How far the two sides are apart at the first point if the inequality fails there."""
        with ball_precision(self.bits):
            x = self._x(self.start)
            found = None if x is None else self.values([*self.fixed, x])
            if found is None or not FALSE[self.ray.claim.relation](found[0], found[1]):
                return None
            return abs(found[0] - found[1])

    def value(self, e: Expr) -> arb | None:
        """A ball of an expression at the first point."""
        with ball_precision(self.bits):
            x = self._x(self.start)
            found = None if x is None else self._program([e])([*self.fixed, x])
            return found[0] if found else None

    def supremum(self) -> Supremum | None:
        """The largest of its values that are told, improved where waves oscillate."""
        with ball_precision(self.bits):
            return self._supremum()

    def _supremum(self) -> Supremum | None:
        places, width = self._places()
        known = [(size, u) for u in places for size in [self.size(u)] if size is not None]
        if not known:
            return None
        known.sort(key=lambda item: _least(item[0]), reverse=True)
        best, pole = known[0][0], not known[0][0].is_finite()
        for size, where in _peaks(known) if width is not None and not pole else []:
            near = width * (where / self.start).max(arb(1))
            found, pole = self._improved(size, where, near)
            pole = pole and bool(_least(found) > _least(known[0][0]) * POLE)
            best = found if pole or _least(found) > _least(best) else best
            if pole:
                break
        high = best.upper()
        for size, _ in known:
            high = high.max(size.upper())
        low = _least(best)
        if not pole and not (high < 2 * low or high < TINY):
            return None
        return Supremum(self.order, low, high, pole)

    def _improved(self, best: arb, where: arb, width: arb) -> tuple[arb, bool]:
        """A larger value close by, and whether it grows without bound as the steps shrink."""
        values = [best]
        for _ in range(STEPS):
            moved = 0
            for k in (-4, -3, -2, -1, 1, 2, 3, 4):
                u = (where + width * k / 4).mid()
                size = self.size(u)
                if size is not None and _least(size) > _least(best):
                    best, place, moved = size, u, k
            if not best.is_finite():
                return best, True
            where = place if moved else where
            if abs(moved) < 4:
                width /= 3
                values.append(best)
            if len(values) > STALLED and _least(best) < _least(values[-STALLED]) * GROWS:
                return best, False
        grows = len(values) > LAST and bool(_least(best) > _least(values[-LAST]) * POLE)
        return best, grows and self.ray.claim.relation not in FALSE

    def _places(self) -> tuple[list[arb], arb | None]:
        """Points to look at, and the distance between them where something oscillates."""
        if self.ray.path.name in self.ray.integers:
            first = self.start.floor()
            return [first + n for n in range(2 * SPREAD)], None
        u, places, least = self.start, [self.start], None
        program_of = [self._program([e]) for e in self.waves]
        step = u * arb((1, -100))
        for values in program_of:
            here, there = (values([*self.fixed, x]) for x in (self._x(u), self._x(u + step)))
            if here is None or there is None:
                continue
            slope = abs((there[0] - here[0]) / step)
            if not (slope * u > SLOWEST and abs(here[0]) > 2 * arb.pi()):  # it does not oscillate
                continue
            period = 2 * arb.pi() / slope
            places += [(u + period * arb(k) / SPREAD).mid() for k in range(1, SPREAD)]
            places += [(u + period * k * arb("1.379")).mid() for k in range(1, SPREAD)]
            if slope * u < SLOW:  # of a logarithm: it oscillates in log u
                turn = 2 * arb.pi() / (slope * u)
                places += [(u * (turn * k / SPREAD).exp()).mid() for k in range(1, SPREAD + 1)]
            width = period / SPREAD
            least = width if least is None or width < least else least
        return places, least


def _least(size: arb) -> arb:
    """A lower bound of a quantity, which is not negative."""
    return arb(size.abs_lower()) if size.is_finite() else size


def _peaks(known: list[tuple[arb, arb]]) -> list[tuple[arb, arb]]:
    """The largest of the values that are larger than their neighbours on both sides."""
    along = sorted(known, key=lambda item: item[1].mid())
    sizes = [arb(-1), *(_least(size) for size, _ in along), arb(-1)]
    ends = zip(sizes, sizes[1:], sizes[2:], along, strict=False)
    peaks = [item for before, here, after, item in ends if before <= here >= after]
    return sorted(peaks, key=lambda item: _least(item[0]), reverse=True)[:STARTS]


def quantity(claim: Comparison, values: Sequence[arb]) -> arb | None:
    """What the claim says to vanish, to be bounded, or never to be; None where it is not told."""
    f, relation = values[0], claim.relation
    if relation in FALSE:
        wrong, right = FALSE[relation](f, values[1]), FALSE[_OPPOSITE[relation]](f, values[1])
        near = 1 / (1 + abs(f - values[1]))  # the nearer to failing, the larger
        return arb.pos_inf() if wrong else near if right else None
    if relation == LIMIT:
        if claim.right not in (INFINITY, -INFINITY):
            return abs(f - values[1])
        f = f if claim.right == INFINITY else -f
        if f < 0 or abs(f) < TINY:
            return arb.pos_inf()
        return 1 / f if f > 0 else None
    g = values[1]
    above, below = (g, f) if relation == "omega" else (f, g)
    if below.contains(0):
        return arb(0) if above.is_zero() else None
    ratio = abs(above / below)
    if relation == "Theta":
        return None if f.contains(0) else ratio.max(abs(g / f))
    return abs(f / g - 1) if relation == "~" else ratio


_OPPOSITE = {">": "<=", ">=": "<", "<": ">=", "<=": ">", "!=": "==", "==": "!="}
