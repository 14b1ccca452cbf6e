"""Expand the roots of two equations for two unknowns by Newton's method in a tube.

Example: ``x == 1 - e*sin(1) + O(e**2) given x + e*sin(x + y) == 1, y + e*x*exp(y)*cos(x*y) == 0,
0 < x, x < 2, -1 < y, y < 1 as e -> 0``.

*The tube.* Let A be an approximation, J the Jacobian matrix of F, and Y the inverse of its limit at
A. If Y J → 1 for all points A + O(g), and Y F(A) = O(g), then the map y ↦ y − Y F(y) contracts such
a tube into itself, and F has exactly one root there, at a distance O(g) from A (R. Krawczyk 1969).
A − Y F(A) is the next approximation.

*The branch.* The conditions must keep the unknowns in a rectangle. If Y is a constant matrix and
each row of Y J − 1 has absolute sum less than 1 on all of it, F takes no value twice there: by the
mean value theorem for each component of Y F.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from itertools import product

from flint import fmpq

from tresym.asymptotics.approximation import Approximation, approximated, size
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.asymptotics.tubes import STEPS, Equation, simplified
from tresym.reals.decisions.answer import Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.leading_terms import written_term
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.like_terms import collected
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof

LEMMA = "Newton's method for two equations in a tube (Krawczyk 1969)"
LARGEST = 1500
"""The largest size of an expression whose leading term is looked for."""
FAR = (10, 1000, 10**6)
"""From where on F is shown to take no value twice."""
_INFINITE = (INFINITY, -INFINITY)
Pair = tuple[Expr, Expr]


class System:
    """Two equations for two unknowns, and the expansion of the root that conditions select.

    Attributes:
        names: the unknowns.
        equations: for each of them an equation with the interval of the unknown and the conditions.
    """

    def __init__(self, equations: tuple[Equation, Equation], start: Pair) -> None:
        """Begin with an approximation of the root."""
        self.equations = equations
        self.names = equations[0].name, equations[1].name
        self.end = equations[0].end
        self.f = equations[0].f, equations[1].f
        self.jacobian = tuple(tuple(differentiate(f, name) for name in self.names) for f in self.f)
        self.inverse = self._limit_of_inverse(start)
        self.found: list[tuple[Pair, Expr] | None] = []
        self.next: Pair | None = start
        self.last: Expr | None = None
        self.proved: dict[int, bool] = {}
        self.selected: bool | None = None

    def terms(self, order: int) -> tuple[Pair, Expr] | None:
        """Return the approximations after ``order`` − 1 corrections, and the size of the next."""
        while len(self.found) < min(order, STEPS) and None not in self.found:
            self.found.append(self._step())
        return self.found[order - 1] if order <= len(self.found) else None

    def _limit_of_inverse(self, at: Pair) -> list[list[Expr]] | None:
        """Return the limit of the inverse of the Jacobian matrix at a point."""
        put = dict(zip(self.names, at, strict=True))
        (a, b), (c, d) = ([substitute(e, put) for e in row] for row in self.jacobian)
        scale = 1 / (a * d - b * c)
        rows = [[d * scale, -b * scale], [-c * scale, a * scale]]
        found = [[self.end.limit(e) for e in row] for row in rows]
        known = [[e for e in row if e is not None and e not in _INFINITE] for row in found]
        return known if all(len(row) == 2 for row in known) else None

    def _corrections(self, at: Pair) -> list[Expr]:
        """Return −Y F(A)."""
        put = dict(zip(self.names, at, strict=True))
        values = [tidied(substitute(f, put)) for f in self.f]
        return [
            -add(ZERO, *(e * v for e, v in zip(row, values, strict=True)))
            for row in self.inverse or ()
        ]

    def _step(self) -> tuple[Pair, Expr] | None:
        main, end = self.next, self.end
        if main is None or self.inverse is None:
            return None
        first: list[Expr] = []
        gauges: list[Expr] = []
        for old, correction in zip(main, self._corrections(main), strict=True):
            if correction.size > LARGEST:
                return None
            if is_zero(correction, end.given):
                first.append(old)
                continue
            found = written_term(correction, end.name, end.point, end.side, end.given)
            if found is None:
                return None
            first.append(collected(old + simplified(found[0])))
            gauges.append(size(simplified(found[1]), end))
        if not gauges:
            self.next = None
            return main, ZERO
        gauge = gauges[0]
        if len(gauges) > 1 and end.limit(gauges[0] / gauges[1]) == ZERO:
            gauge = gauges[1]
        elif len(gauges) > 1 and end.limit(gauges[0] / gauges[1]) is None:
            gauge = add(*gauges)
        if self.last is not None and end.limit(gauge / self.last) != ZERO:
            return None
        self.next, self.last = (first[0], first[1]), gauge
        return main, gauge

    def prove(self, order: int, ask: Obligations) -> bool:
        """Prove that one root is near the approximation, and that the conditions select it."""
        if order not in self.proved:
            found = self.terms(order)
            self.proved[order] = found is not None and self._in_a_tube(*found, ask)
        if not self.proved[order]:
            return False
        if self.selected is None:
            found = self.terms(order)
            assert found is not None
            self.selected = self._is_selected(*found, ask)
        return self.selected

    def _in_a_tube(self, main: Pair, error: Expr, ask: Obligations) -> bool:
        end = self.end
        if error == ZERO:
            return True
        ask.missing = f"the Jacobian matrix is about constant near {self._at(main)}"
        known = {
            symbol(name): Approximation(e, error) for name, e in zip(self.names, main, strict=True)
        }
        if any(approximated(f, known, end) is None for f in self.f):
            return False
        put = dict(zip(self.names, main, strict=True))
        for (i, row), j in product(enumerate(self.inverse or ()), (0, 1)):
            entries = [approximated(jacobian[j], known, end) for jacobian in self.jacobian]
            at_main = [substitute(jacobian[j], put) for jacobian in self.jacobian]
            whole = add(ZERO, *(e * value for e, value in zip(row, at_main, strict=True)))
            last = end.limit(whole)
            if last is None or not is_zero(last - (1 if i == j else 0), end.given):
                return False
            for e, entry in zip(row, entries, strict=True):
                if entry is None:
                    return False
                if entry.error != ZERO and end.limit(abs(e) * entry.error) != ZERO:
                    return False
        sizes = (end.limit(abs(e) / error) for e in self._corrections(main))
        return all(e is not None and e not in _INFINITE for e in sizes)

    def _at(self, main: Pair) -> str:
        return ", ".join(f"{n} = {e}" for n, e in zip(self.names, main, strict=True))

    def _is_selected(self, main: Pair, error: Expr, ask: Obligations) -> bool:
        end = self.end
        known = {
            symbol(name): Approximation(e, error) for name, e in zip(self.names, main, strict=True)
        }
        path = Path(end.name, end.point, (end.side,))
        for left, relation, right in self.equations[0].links:
            ask.missing = f"the root satisfies {left} {relation} {right}"
            gap = approximated(left - right, known, end)
            if gap is None or (gap.error != ZERO and end.limit(gap.error / gap.main) != ZERO):
                return False
            if not ask.holds(gap.main, relation, ZERO, end.given, path):
                return False
        ask.missing = "no other root satisfies the conditions"
        matrix = self._constant_inverse()
        return matrix is not None and any(self._is_injective(matrix, far) for far in FAR)

    def _constant_inverse(self) -> list[list[fmpq]] | None:
        """Return about the inverse of the Jacobian matrix in numbers."""
        rows = []
        with ball_precision():
            for row in self.inverse or ():
                if any(map(symbols, row)):
                    return None
                values = [evaluate(e, {}) * 1024 for e in row]
                rows.append([fmpq(int(v.mid().floor().fmpq().p), 1024) for v in values])
        return rows

    def _is_injective(self, matrix: list[list[fmpq]], far: int) -> bool:
        """Return whether F takes no value twice on the rectangle of the conditions."""
        first, _ = self.equations
        inside = first.end.given & first.near(far)
        for here in self.equations:
            inside &= here.between(here.low, here.high)
        smooth = (*self.f, *(e for row in self.jacobian for e in row))
        if any(continuous_on(e, inside, proof) is not None for e in smooth):
            return False
        for i, row in enumerate(matrix):
            gaps = [
                add(ZERO, *(number(y) * self.jacobian[k][j] for k, y in enumerate(row)))
                - (ONE if i == j else ZERO)
                for j in (0, 1)
            ]
            for signs in product((1, -1), repeat=2):
                total = add(*(s * e for s, e in zip(signs, gaps, strict=True)))
                if not first.holds((tidied(total), "<", ONE), inside):
                    return False
        return True


class Component(Expansion):
    """One unknown of a system."""

    lemma = LEMMA

    def __init__(self, system: System, which: int) -> None:
        """Take the first (0) or the second (1) unknown."""
        self.system, self.which = system, which

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the approximation after ``order`` − 1 corrections, and the size of the next."""
        found = self.system.terms(order)
        return None if found is None else (found[0][self.which], found[1])

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove that one root is near the approximation, and that the conditions select it."""
        return Bound() if self.system.prove(order, ask) else None


def system_of(
    f: Pair,
    names: tuple[str, str],
    end: End,
    intervals: tuple[Pair, Pair],
    links: tuple[Compared, ...],
    ask: tuple[Statement, Decide],
) -> tuple[Equation, Equation]:
    """Return two equations, each with the interval of one unknown."""
    one, two = (
        Equation(name, g, end, interval, links, ask)
        for name, g, interval in zip(names, f, intervals, strict=True)
    )
    return one, two


def starts_of(
    f: Pair, names: tuple[str, str], end: End, zeros: Callable[[Expr, str, Given], list[Expr]]
) -> Iterator[Pair]:
    """Yield roots of the two equations in the limit, where they are linear in an unknown.

    Args:
        f: the equations.
        names: the unknowns.
        end: one side of the path.
        zeros: finds exact zeros of a function of one variable.
    """
    limits = [end.limit(g) for g in f]
    if any(e is None or e in _INFINITE for e in limits):
        return
    for k, i in product((0, 1), repeat=2):
        one, other = limits[k], limits[1 - k]
        assert one is not None
        assert other is not None
        x, y = names[i], names[1 - i]
        slope = tidied(differentiate(one, x))
        if symbols(slope) or slope == ZERO:
            continue
        value = tidied(-substitute(one, {x: ZERO}) / slope)
        rest = substitute(other, {x: value})
        for zero in zeros(rest, y, end.given):
            found = {y: zero, x: tidied(normal_form(substitute(value, {y: zero}), Given()))}
            yield found[names[0]], found[names[1]]
