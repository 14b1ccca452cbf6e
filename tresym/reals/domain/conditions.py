"""Represent conditions on real symbols: the ranges and the inequalities of a claim.

A condition is a comparison of two expressions. Conditions that bound one symbol by a constant form
a box; an irrational bound is rounded outward there. Every point that this module returns is checked
against all conditions in ball arithmetic, so that it is a proven witness.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import cached_property, lru_cache, partial
from itertools import count, islice
from typing import Any

from flint import arb, fmpq

from tresym.reals.computed_once import Kept
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.narrow_regions import windows
from tresym.reals.domain.sample_points import _sample, corners
from tresym.reals.language.expression import ONE, PI, ZERO, Expr, apply, number, symbol, symbols
from tresym.reals.language.formula import MIRRORED
from tresym.reals.language.parsing import parse_conditions
from tresym.reals.language.sympy import conditions_from_sympy
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval, rational_ends

_TRIES = 3000
REMEMBERED = 1024
"""The number of conditions whose points are kept."""


@dataclass(frozen=True)
class Condition:
    """The condition ``expression relation 0``, with relation ``>``, ``>=`` or ``!=``."""

    expression: Expr
    relation: str

    def holds(self, point: Mapping[str, arb | fmpq], known: dict[Expr, arb] | None = None) -> bool:
        """Return whether balls prove that the condition holds strictly at ``point``.

        Args:
            point: a ball or an exact number for each symbol.
            known: values of subexpressions at the point; they are used, and new ones are added.
        """
        value = evaluate(self.expression, point, known)
        if self.relation == "!=":
            return bool(value > 0 or value < 0)
        return bool(value > 0)

    def holds_exactly(self, point: Mapping[str, arb | fmpq]) -> bool:
        """Return the same as :meth:`holds`, but allow equality if the relation is ``>=``."""
        if self.holds(point):
            return True
        value = evaluate(self.expression, point)
        return self.relation == ">=" and bool(value >= 0)


@dataclass(frozen=True)
class Given:
    """A conjunction of conditions on real symbols. ``Given()`` is the empty conjunction.

    Attributes:
        comparisons: triples of a left side, a relation (``< <= > >= !=``) and a right side.

    Example:
        >>> given = Given.parse("a > 0, 0 < b <= 1")
        >>> given.box["b"].high
        1
    """

    comparisons: tuple[tuple[Expr, str, Expr], ...] = ()

    @staticmethod
    def parse(text: str) -> Given:
        """Parse conditions such as ``"a > 0, 0 < b <= 1, I1 < I2 < I3, psi != 0"``.

        Raises:
            InputError: the text does not follow the grammar of
                :mod:`tresym.reals.language.parsing`.
        """
        return Given(tuple(parse_conditions(text)))

    @staticmethod
    def from_sympy(*relationals: Any) -> Given:
        """Convert SymPy relationals (``Gt``, ``Ge``, ``Lt``, ``Le``, ``Ne``, and ``And`` of them).

        Raises:
            InputError: an argument is another condition or contains a derivative.
        """
        return Given(conditions_from_sympy(*relationals))

    def unfolded(self) -> Given:
        """Return the conditions with constant bounds of ``|u|`` and ``log u`` solved for ``u``."""
        return Given(tuple(link for part in self.comparisons for link in _unfolded(part)))

    def mapped(self, change: Callable[[Expr], Expr]) -> Given:
        """Return the conditions with ``change`` applied to every side."""
        return Given(tuple((change(x), relation, change(y)) for x, relation, y in self.comparisons))

    def __and__(self, other: Given) -> Given:
        return Given(self.comparisons + other.comparisons)

    def __str__(self) -> str:
        return ", ".join(f"{left} {sign} {right}" for left, sign, right in self.comparisons)

    @cached_property
    def conditions(self) -> tuple[Condition, ...]:
        """Return every comparison as an expression compared with zero."""
        return tuple(
            Condition(left - right, sign)
            if sign in (">", ">=", "!=")
            else Condition(right - left, MIRRORED[sign])
            for left, sign, right in self.comparisons
        )

    @cached_property
    def names(self) -> frozenset[str]:
        """Return the symbols in the conditions."""
        return frozenset().union(*(symbols(c.expression) for c in self.conditions))

    @cached_property
    def box(self) -> dict[str, Interval]:
        """Return the constant bounds of single symbols."""
        box: dict[str, Interval] = {}
        for bound in self._bounds():
            _tighten(box, *bound)
        for condition in 2 * (*self.conditions, *self._implied):
            _propagate(box, condition)
        for condition in self.conditions:
            _within_even_powers(box, condition)
        return box

    @cached_property
    def half_turns(self) -> dict[str, Interval]:
        """Return the same bounds in multiples of π, exact where a bound is written as one."""
        turns: dict[str, Interval] = {}
        for side, relation, bound in self._bounds():
            r = _pi_multiple(bound)
            _tighten(turns, side, relation, bound / PI if r is None else number(r))
        for condition in 2 * (*self.conditions, *self._implied):
            _propagate(turns, condition, homogeneous=True)
        return turns

    def _bounds(self) -> Iterator[tuple[Expr, str, Expr]]:
        """Yield each comparison of an expression with a constant, the expression on the left."""
        for left, sign, right in self.unfolded().comparisons:
            for side, bound, relation in ((left, right, sign), (right, left, MIRRORED[sign])):
                if not symbols(bound):
                    yield side, relation, bound

    @cached_property
    def _implied(self) -> tuple[Condition, ...]:
        """Return what ``u > |v|`` implies without absolute values: ``u > v``, ``u > −v``, ``u >
        0``.
        """
        result = []
        for left, sign, right in self.comparisons:
            for side, bound, relation in ((left, right, sign), (right, left, MIRRORED[sign])):
                if side.op == "abs" and symbols(bound) and relation in ("<", "<="):
                    inner = side.args[0]
                    parts = (bound - inner, bound + inner, bound)
                    result += [Condition(part, MIRRORED[relation]) for part in parts]
        return tuple(result)

    @cached_property
    def beyond_box(self) -> tuple[Condition, ...]:
        """Return the conditions that are not constant bounds of one symbol, and what they imply."""
        plain = {"symbol"}
        return self._implied + tuple(
            condition
            for (left, _, right), condition in zip(self.comparisons, self.conditions, strict=True)
            if condition.relation == "!="
            or not (
                (left.op in plain and not symbols(right))
                or (right.op in plain and not symbols(left))
            )
        )

    def satisfying_point(self, names: Iterable[str] = ()) -> dict[str, fmpq] | None:
        """Return an exact point that satisfies every condition, or None if none is found.

        Args:
            names: further symbols for which the point has values.
        """
        wanted = sorted(self.names | set(names))
        for point in self.points(wanted, 1):
            return point
        for corner in corners(wanted, self.box):
            with ball_precision():
                if all(condition.holds_exactly(corner) for condition in self.conditions):
                    return corner
        return None

    def points(self, names: Iterable[str], n: int, start: int = 0) -> Iterator[dict[str, fmpq]]:
        """Yield at most ``n`` exact rational points in the interior of the conditions.

        The points are always the same. Both signs of a symbol come early if they are allowed; small
        and large values and values near the bounds come later. Balls prove that every condition
        holds strictly at each point.

        Args:
            names: further symbols for which the points have values.
            n: the maximal number of points.
            start: how many candidates of the sequence are skipped.
        """
        wanted = tuple(sorted(self.names | set(names)))
        return map(dict, _points(self, wanted, start).first(n))

    def _candidates(self, wanted: tuple[str, ...], start: int) -> Iterator[dict[str, fmpq]]:
        """Yield the points; without conditions there is no end of them."""
        ranges = [self.box.get(name, Interval()) for name in wanted]
        if any(r.low is not None and r.high is not None and r.low >= r.high for r in ranges):
            return
        if self._contradict:
            return
        found, conditions = False, list(self.conditions)
        for k in islice(count(start), _TRIES if conditions else None):
            point = {
                name: _sample(where, k, j)
                for j, (name, where) in enumerate(zip(wanted, ranges, strict=True))
            }
            if _hold(conditions, point):
                yield point
                found = True
        if not found:
            yield from filter(partial(_hold, conditions), self._far(wanted, ranges))

    @property
    def _contradict(self) -> bool:
        """Whether conditions say ``u > 0`` and ``-u > 0``, so that no point satisfies both."""
        bounds = {c.expression for c in self.conditions if c.relation != "!="}
        return any(-e in bounds for e in bounds)

    def _far(self, wanted: tuple[str, ...], ranges: list[Interval]) -> Iterator[dict[str, fmpq]]:
        """Yield candidates for conditions that hold only far away or on narrow sets."""
        starts = [
            {name: _sample(ranges[j], k, j) for j, name in enumerate(wanted)} for k in range(4)
        ]
        yield from windows([c.expression for c in self.conditions if c.relation != "!="], starts)


@lru_cache(maxsize=REMEMBERED)
def _points(given: Given, wanted: tuple[str, ...], start: int) -> Kept[dict[str, fmpq]]:
    """Return the points of the conditions, each of which is computed once in a process."""
    return Kept(lambda: given._candidates(wanted, start))


def _hold(conditions: list[Condition], point: dict[str, fmpq]) -> bool:
    """Return whether all conditions hold; move one that fails to the front of the list."""
    known: dict[Expr, arb] = {}
    with ball_precision():
        for n, condition in enumerate(conditions):
            if not condition.holds(point, known):
                conditions.insert(0, conditions.pop(n))
                return False
    return True


def _tighten(box: dict[str, Interval], side: Expr, relation: str, bound: Expr) -> None:
    """Narrow the range of the symbol ``side`` by ``side relation bound``."""
    if side.op != "symbol" or relation == "!=":
        return
    low, high = _enclosure(bound)
    if low is None or high is None:
        return
    is_open = relation in ("<", ">") or low != high
    above = relation in (">", ">=")
    half = Interval(low, None, is_open) if above else Interval(None, high, False, is_open)
    box[side.args[0]] = box.get(side.args[0], Interval()) & half


def _unfolded(link: tuple[Expr, str, Expr]) -> Iterator[tuple[Expr, str, Expr]]:
    left, sign, right = link
    for side, relation, bound in ((left, sign, right), (right, MIRRORED[sign], left)):
        if symbols(bound) or side.op not in ("abs", "log") or not symbols(side):
            continue
        inner = side.args[0]
        if side.op == "abs" and relation in ("<", "<="):
            yield from _unfolded((inner, relation, bound))
            yield from _unfolded((inner, MIRRORED[relation], -bound))
            return
        if side.op == "log" and relation != "!=":
            if relation in ("<", "<="):
                yield from _unfolded((inner, ">", ZERO))
            yield from _unfolded((inner, relation, ONE if bound == ZERO else apply("exp", bound)))
            return
    yield link


def _propagate(box: dict[str, Interval], condition: Condition, homogeneous: bool = False) -> None:
    """Narrow the symbols of a linear condition: with a > 0, x > a gives x > 0."""
    form = linear_form(condition.expression)
    if condition.relation == "!=" or form is None or (homogeneous and form[""] != 0):
        return
    for name, slope in form.items():
        total, relation = form[""], condition.relation
        for other, c in form.items():
            if other in ("", name):
                continue
            where = box.get(other, Interval())
            end, is_open = (where.high, where.high_open) if c > 0 else (where.low, where.low_open)
            if end is None:
                break
            total += c * end
            relation = ">" if is_open else relation
        else:
            if name:
                sign = relation if slope > 0 else MIRRORED[relation]
                _tighten(box, symbol(name), sign, number(-total / slope))


def _within_even_powers(box: dict[str, Interval], condition: Condition) -> None:
    """Narrow the symbols of a bounded sum of even powers, such as x**2 + 4*y**4 < 1."""
    form = _sum_of(condition.expression, even=True)
    if condition.relation == "!=" or form is None or any(c > 0 for key, c in form.items() if key):
        return
    for key, c in form.items():
        if key and form[""] > 0:
            name, n = key.split("**")
            with ball_precision():
                end = number(arb(-form[""] / c).root(int(n)).upper().fmpq())
            _tighten(box, symbol(name), "<" if condition.relation == ">" else "<=", end)
            _tighten(box, symbol(name), condition.relation, -end)


def linear_form(e: Expr) -> dict[str, fmpq] | None:
    """Return the coefficients of a linear expression, its constant under "", or None."""
    return _sum_of(e, even=False)


def _sum_of(e: Expr, even: bool) -> dict[str, fmpq] | None:
    """Return the coefficients of symbols, or of their even powers; None for other sums."""
    form = {"": fmpq(0)}
    stack = [(e, fmpq(1))]
    while stack:
        term, scale = stack.pop()
        if term.op == "+":
            stack.extend((arg, scale) for arg in term.args)
        elif term.op == "*" and len(term.args) == 2 and term.args[0].op == "number":
            stack.append((term.args[1], scale * term.args[0].args[0]))
        elif term.op == "number":
            form[""] += scale * term.args[0]
        elif _is_even_power(term) if even else term.op == "symbol":
            key = "**".join(str(part.args[0]) for part in (term.args if even else (term,)))
            form[key] = form.get(key, fmpq(0)) + scale
        else:
            return None
    return {key: c for key, c in form.items() if c != 0 or not key}


def _is_even_power(e: Expr) -> bool:
    if e.op != "^" or e.args[0].op != "symbol" or e.args[1].op != "number":
        return False
    n = e.args[1].args[0]
    return bool(n.q == 1 and n > 0 and n.p % 2 == 0)


def _enclosure(e: Expr) -> tuple[fmpq | None, fmpq | None]:
    """Return rational ends that enclose the constant ``e``, equal if it is rational."""
    if e.op == "number":
        return e.args[0], e.args[0]
    with ball_precision():
        return rational_ends(evaluate(e, {}))[:2]


def _pi_multiple(e: Expr) -> fmpq | None:
    """Return r if ``e`` is written as r·π, else None."""
    if e.op == "pi":
        return fmpq(1)
    if e.op == "number" and e.args[0] == 0:
        return fmpq(0)
    if e.op == "*" and [arg.op for arg in e.args] == ["number", "pi"]:
        return e.args[0].args[0]
    return None


def positive(*names: str) -> Given:
    """Return the condition that every named symbol is positive."""
    return Given(tuple((symbol(name), ">", number(0)) for name in names))
