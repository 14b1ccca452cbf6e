"""Points at which claims of the ledger are tried, and points on their equations."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import islice, pairwise

from flint import arb, fmpq

from tresym.ledger import ball_evaluation
from tresym.ledger.conversion import CircularError
from tresym.ledger.formulas import FALSE, binders_in, names_of
from tresym.reals import cross_check
from tresym.reals.computed_once import Kept
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.sample_points import Range
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.arithmetic import ball_precision, side
from tresym.reals.numbers.exact import Interval

Conditions = tuple[Relation, ...]
Place = Mapping[str, Interval]
"""Exact values (intervals of width 0) or tiny segments, by the names of symbols."""

BITS, ROUGH = 128, 64
POINTS = 40
"""Exact points that are tried before the search for a violation gives up."""
ROOTS = 2
"""Points on an implicit equation that are searched for."""
SPAN, GRID = fmpq(8), 16
"""Length of the interval searched for a root along an unbounded coordinate, and its grid steps."""
COARSE = 32
"""Precision in bits for the signs on the grid."""
FINEST = 3**20
"""Denominator to which the points of the bracketing search are rounded."""
WIDTH = fmpq(1, 2**24)
"""Width of the segment that brackets a root of an implicit equation."""


@dataclass(frozen=True)
class World:
    """The setting of a search: conditions, rules for defined symbols, implicit equations.

    Attributes:
        conditions: conditions with the rules substituted.
        rules: pairs of a defined symbol and its meaning.
        implicit: differences of sides that vanish where the equations hold.
        large: conditions without substitution, because the result would be too long.
    """

    conditions: Conditions
    rules: tuple[tuple[str, Expr], ...]
    implicit: tuple[Expr, ...]
    large: Conditions = ()

    def names(self, *sides: Expr) -> frozenset[str]:
        """Return the free variables (not the defined symbols) on which ``sides`` depend.

        Raises:
            CircularError: a symbol occurs where a variable is bound on which its meaning depends.
        """
        rules = dict(self.rules)
        need_unbound(sides, rules)
        return reached(names_of(*sides), rules).difference(rules)

    def at(self, place: Place) -> ball_evaluation.Place:
        """Return the point of evaluation that corresponds to ``place``."""
        values = {name: where.ball() for name, where in place.items()}
        return ball_evaluation.Place(values, dict(self.rules))

    def values(self, sides: Iterable[Expr], place: Place) -> tuple[arb, ...]:
        """Return a ball for each of ``sides`` at ``place``."""
        here = self.at(place)
        return tuple(map(here.value, sides))


def reached(names: Iterable[str], rules: Mapping[str, Expr]) -> frozenset[str]:
    """Return the symbols ``names`` and all symbols on which their meanings depend."""
    found, waiting = set[str](), [*names]
    while waiting:
        name = waiting.pop()
        if name not in found:
            found.add(name)
            waiting += symbols(rules[name]) if name in rules else ()
    return frozenset(found)


def need_unbound(sides: Iterable[Expr], rules: Mapping[str, Expr]) -> None:
    """Require that no symbol occurs where a variable is bound on which its meaning depends."""
    for node in dict.fromkeys(binders_in(*sides)):
        for name in symbols(node).intersection(rules):
            if not reached((name,), rules).isdisjoint(node.names):
                raise CircularError(
                    f"{name} is defined in terms of a variable that is bound where {name} occurs"
                )


@lru_cache(maxsize=512)
def points_for(
    world: World, names: frozenset[str], enough: int = ROOTS
) -> Kept[dict[str, Interval]]:
    """Return points (or tiny segments that contain one) where all conditions and equations hold.

    Args:
        world: the setting; with more than one implicit equation no points are found.
        names: the variables that need values.
        enough: the number of segments to find on an implicit equation.
    """
    if len(world.implicit) > 1 or FALSE in world.conditions:
        return Kept(lambda: iter(()))
    moving, plain, hard = _parts(world, names)

    def starts() -> Iterator[dict[str, Interval]]:
        for named in Given(tuple(plain)).points(moving, POINTS):
            exact = {name: Interval(v, v) for name, v in named.items()}
            with ball_precision(BITS):
                here = world.at(exact)
                inside = all(_holds(c, here) for c in hard)
            if inside:
                yield exact

    if not world.implicit:
        return Kept(starts)
    found: list[dict[str, Interval]] = []
    for grid in _grids(world):
        found = [*_roots(world, starts(), grid, enough)]
        if len(found) >= enough:
            break
    return Kept(lambda: iter(found))


def _roots(
    world: World, starts: Iterator[dict[str, Interval]], grid: Sequence[int], enough: int
) -> Iterator[dict[str, Interval]]:
    """Yield at most ``enough`` segments that bracket a root of the implicit equation."""
    segments = (segment for exact in starts for segment in _on_equation(world, exact, grid))
    return islice(segments, enough)


def places(world: World, names: frozenset[str]) -> Iterator[dict[str, Interval] | None]:
    """Yield points as `points_for` does, but from the independent check's own sampling.

    None stands for a point that is not shown to satisfy all conditions.
    """
    if len(world.implicit) > 1 or FALSE in world.conditions:
        return
    order, plain, hard = _parts(world, names)
    given = tuple(plain)
    for values in cross_check.points(order, given, cross_check.conditions(order, given)):
        if values is None:
            yield None
            continue
        ends = (Interval(v, v) for v in map(cross_check.exact, values))
        exact = dict(zip(order, ends, strict=True))
        here = world.at(exact)
        if not all(_holds(c, here) for c in hard):
            yield None
        elif world.implicit:
            yield next(_on_equation(world, exact, _grids(world)[0]), None)
        else:
            yield exact


def _parts(world: World, names: frozenset[str]) -> tuple[list[str], list[Relation], list[Relation]]:
    """Return the variables, and the conditions without and with integrals or derivatives."""
    conditions = world.conditions
    large = (side for c in world.large for side in (c.left, c.right))
    moving = names | world.names(*world.implicit, *large) | names_of(*conditions)
    hard = [c for c in conditions if not elementary(c.left, c.right)]
    return sorted(moving), [c for c in conditions if c not in hard], [*hard, *world.large]


def _grids(world: World) -> tuple[Sequence[int], ...]:
    """Return the grids to search for a root; with an integral, a grid of two points comes first."""
    (difference,) = world.implicit
    rules = dict(world.rules)
    meanings = (rules[s] for s in reached(symbols(difference), rules) if s in rules)
    slow = any(node.op == "integral" for node in binders_in(difference, *meanings))
    coarse = ((1, GRID - 1),) if slow else ()
    return (*coarse, range(1, GRID))


def _on_equation(
    world: World, exact: dict[str, Interval], grid: Sequence[int]
) -> Iterator[dict[str, Interval]]:
    """Yield at most one segment that brackets a root, along one coordinate through a point."""
    (difference,) = world.implicit
    plain = (c for c in world.conditions if elementary(c.left, c.right))
    box = Given(tuple(plain)).box
    found: dict[str, Interval] | None = None
    with ball_precision(ROUGH):
        fixed = {s: i.ball() for s, i in exact.items()}
        rules, moving = dict(world.rules), world.names(difference)
        for name in sorted(moving, key=lambda s: (s not in box, s)):
            low, high = _reach(box.get(name, Range()))

            def there(v: arb | fmpq, name: str = name) -> ball_evaluation.Place:
                return ball_evaluation.Place({**fixed, name: arb(v)}, rules)

            def at(
                v: arb | fmpq, there: Callable[[arb | fmpq], ball_evaluation.Place] = there
            ) -> arb:
                return there(v).value(difference)

            segment = _segment(at, [low + (high - low) * n / GRID for n in grid])
            if segment is None or not at(segment.ball()).is_finite():
                continue
            here = there(segment.ball())
            if all(_holds(c, here) for c in (*world.conditions, *world.large)):
                found = {**exact, name: segment}
                break
    if found is not None:
        yield found


def _reach(where: Range) -> tuple[fmpq, fmpq]:
    """Return the ends of the interval to search; missing ends are replaced by finite ones."""
    low = -SPAN / 2 if where.low is None else where.low
    return low, low + SPAN if where.high is None else where.high


def _segment(function: Callable[[fmpq], arb], grid: Sequence[fmpq]) -> Interval | None:
    """Return a tiny segment with opposite signs of ``function`` at its ends, or None."""
    with ball_precision(COARSE):
        signed = [(v, s) for v in grid if (s := side(function(v)))]
    changes = [(v, w) for (v, first), (w, second) in pairwise(signed) if first != second]
    return next(filter(None, (_narrowed(function, *ends) for ends in changes)), None)


def _narrowed(function: Callable[[fmpq], arb], start: fmpq, end: fmpq) -> Interval | None:
    """Shrink a bracket of a root by the secant method; None if a sign cannot be determined."""
    first, last = function(start), function(end)
    while end - start > WIDTH:
        width, share = end - start, first / (first - last)
        # Bisection would often hit the root itself, where a ball cannot determine the sign;
        # hence the fraction 5/9 and denominators that are powers of 3.
        parts = round(float(share.mid()) * FINEST) if share.is_finite() else FINEST * 5 // 9
        middle = start + width * fmpq(min(max(parts, 1), FINEST - 1), FINEST)
        half = max(WIDTH * 4 / 9, min(width / 32, width * width))
        for near in (middle - half, middle + half, (5 * start + 4 * end) / 9):
            v = fmpq((near * FINEST).floor(), FINEST)
            if not start < v < end:
                continue
            found = function(v)
            if not side(found):
                return None
            if side(found) == side(first):
                start, first = v, found
            else:
                end, last = v, found
            if end - start <= 2 * half:
                break
    return Interval(start, end)


def _holds(condition: Relation, here: ball_evaluation.Place) -> bool:
    """Return whether balls show the inequality strictly (``>=`` and ``<=`` as ``>`` and ``<``)."""
    difference = here.value(condition.left) - here.value(condition.right)
    if condition.sign == "!=":
        return bool(side(difference))
    return bool(difference > 0 if condition.sign in (">", ">=") else difference < 0)
