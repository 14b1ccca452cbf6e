"""Expand the root of an equation by its residual in a tube whose slope may depend on the path.

Example: ``y == u - 1/u + O(1/u**3) given y**3 - u*y**2 + u*cos(y/u**4) == 0, y > 2 as u -> oo``.
The residual of A = u − 1/u is O(1/u), the slope there about u², and so the error is O(1/u³).

*The tube.* Let A be an approximation and d the leading term of −F(A)/F_y(A), Newton's correction.
If F_y(y)/F_y(A) → 1 for every y = A + O(d), then F has exactly one root y = A + O(d) near the end
of the path, and y − A = −F(A)/F_y(A)·(1 + o(1)): F changes its sign between A − K d and A + K d
for every K > 1, since |F(A)| is about |F_y(A) d|. The orders are carried through F_y as in
:mod:`tresym.asymptotics.approximation`. A + d is the next approximation.

*The branch.* The conditions on y select this root if it satisfies them near the end, and no other
root does. For the latter the y-axis is divided at points left and right of A. On the part around A
the slope must have one sign; on the others F must not vanish where the conditions hold, or have a
slope of the same sign up to the part around A.

Source: the mean value theorem; N. G. de Bruijn, *Asymptotic Methods in Analysis*, 1958, chapter 2.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from itertools import islice, pairwise

from flint import fmpq

from tresym.asymptotics.approximation import Approximation, approximated, size
from tresym.asymptotics.lemma import Bound, End, Expansion, Obligations
from tresym.reals.decisions.answer import Decide
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs, operations
from tresym.reals.expansions.leading_terms import leading_sign, written_term
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    add,
    apply,
    factors_in,
    multiply,
    number,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.language.parsing import Compared
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof, sign

LEMMA = "residual and slope of the equation in a tube (de Bruijn 1958, chapter 2)"
FAR = (10, 1000)
"""From where on signs of the equation and of its slope are asked for."""
STEPS = 4
"""Newton's corrections of one approximation."""
LARGEST = 400
"""The largest size of an expression whose leading term is looked for."""
RADII = (fmpq(1, 2), fmpq(1, 8), fmpq(1, 50))
MOST_PARTS = 9
"""Intervals beside that around the root that are looked at."""
SAMPLES = 12
MOST_FAILURES = 12
"""Inequalities that are not proved, after which no further ones are tried for an equation."""
PLACES = 3
"""Points at which a second root is looked for in numbers."""
BOUNDS = tuple(
    (fmpq(a, 1000), fmpq(b, 1000))
    for a, b in ((0, 1), (0, 10), (0, 100), (0, 1000), (999, 1000), (990, 1000), (900, 1000))
)
"""Bounds that are tried for parts of an equation that depend on the path variable."""
_INFINITE = (INFINITY, -INFINITY)
_TRIGONOMETRIC = frozenset(("sin", "cos", "tan", "cot", "sec", "csc"))


class Equation:
    """The equation F(y, x) = 0 with the conditions that select its root.

    Attributes:
        name: the unknown y.
        f: F.
        end: one side of the path, with the conditions on the parameters.
        low, high: constants between which the conditions keep y; infinite where they do not. F has
            no root at these ends where they satisfy the conditions.
        links: all conditions that contain y.
    """

    def __init__(
        self,
        name: str,
        f: Expr,
        end: End,
        interval: tuple[Expr, Expr],
        links: tuple[Compared, ...],
        ask: tuple[Statement, Decide],
    ) -> None:
        """Take an equation apart.

        Args:
            name: the unknown.
            f: the function whose root it is.
            end: one side of the path.
            interval: the ends between which constant conditions keep the unknown.
            links: the conditions on the unknown.
            ask: the statement without its conditions on the unknown, and what decides obligations.
        """
        self.name, self.f, self.end, self.links = name, f, end, links
        self.low, self.high = interval
        self.slope = differentiate(f, name)
        self.statement, self.decided = ask
        self.failures = 0

    def near(self, far: int) -> Given:
        """Return the conditions that the path variable is near its end."""
        from tresym.asymptotics.path_claims import neighbourhood

        path = Path(self.end.name, self.end.point, (self.end.side,))
        return neighbourhood(path, self.end.side, number(far))

    def holds(self, claim: Compared, given: Given) -> bool:
        """Return whether an inequality holds under conditions."""
        left, relation, right = claim
        whole = {"+": (">", ">=", "!="), "-": ("<", "<=", "!="), ">=0": (">=",), "<=0": ("<=",)}
        there = replace(self.statement, path=None, equations=(), given=given)
        try:
            if relation in whole.get(sign(left - right, given, relation, dear=False) or "", ()):
                return True
            if self.failures >= MOST_FAILURES:
                return False
            self.failures += 1
            if Obligations(there, self.decided).holds(left, relation, right, given):
                self.failures -= 1
                return True
            bounded = self._with_bounds(left - right, given)
            if bounded is None:
                return False
            e, inside = bounded
            found = Obligations(there, self.decided).holds(e, relation, ZERO, inside)
            self.failures -= found
            return found
        except InputError:  # an intermediate expression exceeds the size limit
            return False

    def between(self, low: Expr, high: Expr) -> Given:
        """Return the conditions that y lies between two ends.

        They belong to the interval unless they are those of the conditions, at which F has no root.
        """
        y = symbol(self.name)
        links: list[Compared] = []
        if low not in _INFINITE:
            links.append((low, "<" if low == self.low else "<=", y))
        if high not in _INFINITE:
            links.append((y, "<" if high == self.high else "<=", high))
        return Given(tuple(links))

    def is_positive(self, e: Expr) -> bool:
        """Return whether ``e`` is positive wherever the conditions hold near the end."""
        where = self.between(self.low, self.high) & Given(self.links)
        if not _is_likely((e, ">", ZERO), self.end.given & self.near(FAR[0]) & where):
            return False
        return any(
            self.holds((e, ">", ZERO), self.end.given & self.near(far) & where) for far in FAR
        )

    def _with_bounds(self, e: Expr, given: Given) -> tuple[Expr, Given] | None:
        """Return ``e`` with variables between bounds for parts that depend on the path variable.

        Example: 1/cosh(x + 2*pi*n) lies between 0 and 1/100 for x > 0 and n > 10, and cos(y/u)
        between −1 and 1.
        """
        known: dict[Expr, Expr] = {}
        found = _marked(e, self.end.name, known)
        links: list[Compared] = []
        for part, mark in known.items():
            bounds = self._bounds(part, given)
            if bounds is None:
                return None
            links += [(number(bounds[0]), "<=", mark), (mark, "<=", number(bounds[1]))]
        all_links = (*given.comparisons, *links)
        kept = (x for x in all_links if symbols(x[0]) | symbols(x[2]) <= symbols(found))
        return (found, Given(tuple(kept))) if known else None

    def _bounds(self, part: Expr, given: Given) -> tuple[fmpq, fmpq] | None:
        """Return numbers between which a part is proved to lie."""
        if part.op in ("sin", "cos"):
            return fmpq(-1), fmpq(1)
        names = sorted(symbols(part) | given.names)
        with ball_precision():
            values = [evaluate(part, point) for point in given.points(names, SAMPLES)]
        for low, high in BOUNDS:
            if values and not any(value < low or value > high for value in values):
                pair = (part, ">=", number(low)), (part, "<=", number(high))
                if all(self._is_bounded(link, given) for link in pair):
                    return low, high
        return None

    def _is_bounded(self, link: Compared, given: Given) -> bool:
        """Return whether a bound holds, in terms of the one argument that a part may have."""
        there = replace(self.statement, path=None, equations=(), given=given)
        if Obligations(there, self.decided).holds(*link, given):
            return True
        arguments = {arg for node in operations((link[0],)) for arg in _arguments(node)}
        w = symbol("[w]")
        if len(arguments) != 1:
            return False
        (argument,) = arguments
        part = replaced(link[0], {argument: w})
        if self.end.name in symbols(part) or self.name in symbols(part):
            return False
        gap = tidied(normal_form(argument, Given()))
        start = next((far for far in (30, 10, 3) if sign(gap - far, given) == "+"), None)
        if start is None:
            return False
        inside = Given(((w, ">", number(start)),))
        return Obligations(there, self.decided).holds(part, link[1], link[2], inside)


def _marked(e: Expr, name: str, known: dict[Expr, Expr]) -> Expr:
    """Return ``e`` with symbols for its parts made of functions of a variable.

    The functions in one product are one part.

    Args:
        e: an expression.
        name: the variable.
        known: the symbols for parts; new ones are added.
    """
    if name not in symbols(e):
        return e
    if _is_of_functions(e):
        return known.setdefault(e, symbol(f"[{len(known)}]"))
    if e.op == "*":
        inner = [f for f in e.args if name in symbols(f) and _is_of_functions(f)]
        rest = [_marked(f, name, known) for f in e.args if f not in inner]
        if inner:
            part = multiply(*inner)
            rest.append(known.setdefault(part, symbol(f"[{len(known)}]")))
        return multiply(*rest)
    return e if e.op in LEAVES else rebuild(e, tuple(_marked(a, name, known) for a in e.args))


def _is_of_functions(e: Expr) -> bool:
    if e.op == "^":
        return _is_of_functions(e.args[0]) and e.args[1].op == "number"
    return bool(_arguments(e))


def _arguments(e: Expr) -> tuple[Expr, ...]:
    """Return the argument of a function of one variable."""
    return e.args if len(e.args) == 1 and e.op not in (*LEAVES, "abs") else ()


class Root(Expansion):
    """The expansion of a root by Newton's corrections of an approximation."""

    lemma = LEMMA

    def __init__(self, equation: Equation, start: Expr) -> None:
        """Begin with an approximation."""
        self.equation = equation
        self.found: list[tuple[Expr, Expr] | None] = []
        self.next: Expr | None = tidied(normal_form(start, Given()))
        self.last: Expr | None = None
        self.selected: bool | None = None

    def terms(self, order: int) -> tuple[Expr, Expr] | None:
        """Return the approximation after ``order`` − 1 corrections, and the size of the next."""
        while len(self.found) < min(order, STEPS) and None not in self.found:
            self.found.append(self._step())
        return self.found[order - 1] if order <= len(self.found) else None

    def _step(self) -> tuple[Expr, Expr] | None:
        main, here = self.next, self.equation
        if main is None:
            return None
        put, end = {here.name: main}, here.end
        residual = tidied(substitute(here.f, put))
        if residual == ZERO or is_zero(residual, end.given):
            self.next = None
            return main, ZERO
        correction = residual * (-1 / substitute(here.slope, put))
        if correction.size > LARGEST:
            return None
        first = written_term(correction, end.name, end.point, end.side, end.given)
        if first is None:
            self.next = None
            gauge = size(correction, end)
            return main, gauge
        gauge = size(simplified(first[1]), end)
        if self.last is not None and end.limit(gauge / self.last) != ZERO:
            return None  # the corrections do not decrease
        self.next = collected(main + simplified(first[0]))
        self.last = gauge
        return main, gauge

    def prove(self, order: int, ask: Obligations) -> Bound | None:
        """Prove that one root is near the approximation, and that the conditions select it."""
        found = self.terms(order)
        if found is None or not self._in_a_tube(*found, ask):
            return None
        if self.selected is None:
            self.selected = _is_selected(self.equation, Approximation(*found), ask)
        return Bound() if self.selected else None

    def _in_a_tube(self, main: Expr, error: Expr, ask: Obligations) -> bool:
        """Return whether F has one root y = main + O(error) near the end of the path."""
        here = self.equation
        end = here.end
        at_main = substitute(here.slope, {here.name: main})
        ask.missing = f"the slope of the equation does not vanish at {here.name} = {main}"
        if error == ZERO:
            return True  # it is a root itself
        y = {symbol(here.name): Approximation(main, error)}
        slope, value = approximated(here.slope, y, end), approximated(here.f, y, end)
        ask.missing = (
            f"the slope of the equation is about constant for {here.name} = {main} + O({error})"
        )
        if slope is None or value is None:
            return False
        if slope.error != ZERO and end.limit(slope.error / at_main) != ZERO:
            return False
        ratio = substitute(here.f, {here.name: main}) / (at_main * error)
        return end.limit(abs(ratio)) not in (None, *_INFINITE)


def simplified(term: Expr) -> Expr:
    """Return a term in normal form, unless that changes functions of constants in it."""
    found = tidied(normal_form(term, Given()))
    halves = any(e.op in _TRIGONOMETRIC and not symbols(e) for e in operations((found,)))
    return tidied(term) if halves else found


def _is_selected(here: Equation, root: Approximation, ask: Obligations) -> bool:
    """Return whether the conditions on y select the root y = main + O(error) and no other."""
    end = here.end
    known = {symbol(here.name): root}
    for left, relation, right in here.links:
        ask.missing = f"the root satisfies {left} {relation} {right}"
        gap = approximated(left - right, known, end)
        if gap is None:
            return False
        if gap.error != ZERO and end.limit(gap.error / gap.main) != ZERO:
            return False
        path = Path(end.name, end.point, (end.side,))
        if not ask.holds(gap.main, relation, ZERO, end.given, path):
            return False
    ask.missing = f"no other root {here.name} satisfies the conditions"
    return any(_is_only(here, root.main, here.near(far)) for far in FAR)


def _is_only(here: Equation, main: Expr, near: Given) -> bool:
    """Return whether at most one root satisfies the conditions for all x in a neighbourhood."""
    given = here.end.given & near
    if _has_several(here, given):
        return False
    if _direction(here, given & here.between(here.low, here.high)):
        return True
    for first, last in _around(here, main):
        direction = _direction(here, given & here.between(first, last))
        if (
            direction
            and (first in _INFINITE or last in _INFINITE or _follow(here, first, last))
            and _adds_none(here, given, (here.low, first), direction, inner=1)
            and _adds_none(here, given, (last, here.high), direction, inner=0)
        ):
            return True
    return False


def _has_several(here: Equation, given: Given) -> bool:
    """Return whether numbers show a second root, so that no proof is looked for.

    F changes its sign twice where the conditions hold, at some values of the other variables.
    """
    where = Given(here.links)
    names = sorted((symbols(here.f) | given.names) - {here.name})
    with ball_precision():
        for point in islice(given.points(names, PLACES), PLACES):
            signs: list[int] = []
            for y in _grid(here):
                at = {**point, here.name: y}
                value = evaluate(here.f, at)
                if not all(c.holds_exactly(at) for c in where.conditions):
                    continue
                if value > 0 or value < 0:
                    signs.append(1 if value > 0 else -1)
            if sum(a != b for a, b in pairwise(signs)) > 1:
                return True
    return False


def _grid(here: Equation) -> list[fmpq]:
    """Return numbers between the constant ends of the unknown."""
    steps = [fmpq(k, 64) for k in range(1, 64)]
    if here.low in _INFINITE or here.high in _INFINITE:
        large = [x / (1 - x) * fmpq(1013, 1000) for x in steps]
        powers = [fmpq(2) ** k * fmpq(1013, 1000) for k in range(6, 30)]
        sizes = [*large, *powers]
        if here.low in _INFINITE and here.high in _INFINITE:
            return [*(-x for x in sizes[::-1]), *sizes]
        start = evaluate(here.high if here.low in _INFINITE else here.low, {}).mid().fmpq()
        return [start - x if here.low in _INFINITE else start + x for x in sizes]
    low, high = (evaluate(e, {}).mid().fmpq() for e in (here.low, here.high))
    return [low + (high - low) * x for x in steps]


def _direction(here: Equation, inside: Given) -> int:
    """Return the sign of the slope on an interval of y on which F is continuous, or 0."""
    if continuous_on(here.f, inside, proof) is not None:
        return 0
    sides = [s for s in (1, -1) if _is_likely((s * here.slope, ">", ZERO), inside)]
    return next((s for s in sides if here.holds((s * here.slope, ">", ZERO), inside)), 0)


def _is_likely(claim: Compared, given: Given) -> bool:
    """Return whether an inequality holds at some points; nothing is proved."""
    e = claim[0] - claim[2] if claim[1] == ">" else claim[2] - claim[0]
    names = sorted(symbols(e) | given.names)
    with ball_precision():
        values = (evaluate(e, point) for point in given.points(names, SAMPLES))
        return not any(value < 0 for value in values)


def _around(here: Equation, main: Expr) -> Iterator[tuple[Expr, Expr]]:
    """Yield the ends of intervals around the root."""
    end = here.end
    start = end.limit(main)
    if start is None:
        return
    infinite = start in _INFINITE
    first = written_term(
        main if infinite or start == ZERO else main - start,
        end.name,
        end.point,
        end.side,
        end.given,
    )
    if not infinite:
        for radius in RADII:
            one, two = start - number(radius), start + number(radius)
            yield _inner(here, one, two)
            yield here.low, _inner(here, one, two)[1]
            yield _inner(here, one, two)[0], here.high
    if first is not None:
        base = ZERO if infinite else start
        scale = tidied(normal_form(first[0], Given()))
        ends = [base + number(k) * scale for k in (fmpq(9, 10), fmpq(11, 10))]
        one, two = ends if _follow(here, *ends) else ends[::-1]
        yield one, two
        yield here.low, two
        yield one, here.high


def _inner(here: Equation, low: Expr, high: Expr) -> tuple[Expr, Expr]:
    """Return the part of an interval between the constants that bound the unknown."""
    if here.low not in _INFINITE and sign(low - here.low, here.end.given, "<=") in (
        "-",
        "<=0",
        "0",
    ):
        low = here.low
    if here.high not in _INFINITE and sign(high - here.high, here.end.given) in ("+", ">=0", "0"):
        high = here.high
    return low, high


def _follow(here: Equation, first: Expr, last: Expr) -> bool:
    """Return whether one end lies below the other near the end of the path."""
    end = here.end
    return leading_sign(last - first, end.name, end.point, end.side, end.given) == 1


def _adds_none(
    here: Equation, given: Given, ends: tuple[Expr, Expr], direction: int, inner: int
) -> bool:
    """Return whether F has no root between two ends where the conditions hold.

    Roots do not count where F goes on in the direction that it has at the inner end.

    Args:
        here: the equation.
        given: the conditions on the path variable and the parameters.
        ends: the interval.
        direction: the sign of the slope at the inner end.
        inner: which of the ends is the inner one.
    """
    parts = [ends]
    goes_on = True
    for _ in range(MOST_PARTS):
        if not parts:
            return True
        low, high = parts.pop()
        if low == high:
            continue
        closed = given & here.between(low, high)
        if _vanishes_nowhere(here, closed):
            goes_on = False
            continue
        if goes_on and _direction(here, closed) == direction:
            continue
        if {low, high} & {*_INFINITE} or symbols(low) | symbols(high):
            return False
        middle = tidied((low + high) / 2)
        halves = [(low, middle), (middle, high)]
        parts += halves if inner else halves[::-1]
    return not parts


def _vanishes_nowhere(here: Equation, inside: Given) -> bool:
    """Return whether F has no root on an interval where the conditions hold."""
    for left, relation, right in here.links:
        if relation in (">", ">=") and sign(left - right, inside, "<") == "-":
            return True
        if relation in ("<", "<=") and sign(right - left, inside, "<") == "-":
            return True
    asked = inside & Given(here.links)
    return any(
        _is_likely((side * here.f, ">", ZERO), asked)
        and here.holds((side * here.f, ">", ZERO), asked)
        for side in (1, -1)
    )


def conditions_of(f: Expr, name: str, links: tuple[Compared, ...]) -> tuple[Compared, ...]:
    """Return the conditions on y, those among them that F is defined."""
    domain = [bound(*part) for part in needs((f,)) if name in symbols(part[0])]
    return tuple(x for x in (*links, *domain) if name in symbols(x[0]) | symbols(x[2]))


def forms(left: Expr, right: Expr, name: str) -> Iterator[tuple[Expr, tuple[Expr, ...]]]:
    """Yield functions with the same roots, each with what must be positive for that.

    They are the difference of the sides, the same divided by a factor, and the logarithm of the
    quotient of two parts that are equal.
    """
    plain = left - right
    for one, other in ((left, right), (right, left)):
        for f in one.args if one.op == "*" else ():
            if f.op in ("cosh", "exp"):
                yield multiply(*(e for e in one.args if e != f)) - other / f, (f,)
    yield plain, ()
    gap = left - right
    for term in gap.args if gap.op == "+" else ():
        factors = factors_in(term)
        large = any(f.op == "exp" or (f.op == "^" and symbols(f.args[1])) for f in factors)
        if large and name in symbols(term):
            rest = term - gap
            for side in (1, -1):
                yield (
                    _logarithm(side * term) - apply("log", tidied(side * rest)),
                    (side * term, side * rest),
                )


def _logarithm(e: Expr) -> Expr:
    """Return the logarithm of a product of positive factors as a sum."""
    if e.op == "*" and not any(f.op == "number" and f.args[0] < 0 for f in e.args):
        return add(ZERO, *map(_logarithm, e.args))
    if e.op == "exp":
        return e.args[0]
    if e.op == "^":
        return e.args[1] * apply("log", e.args[0])
    return apply("log", e)


def starts(claim: Comparison, name: str) -> Iterator[Expr]:
    """Yield approximations of the root that a claim states."""
    sides = [claim.left] if claim.relation in ("O", "o") else [claim.left - claim.right]
    if claim.relation in ("->", "~") and claim.right in _INFINITE:
        return
    for e in sides:
        factor = differentiate(e, name)
        if factor.op == "number" and factor != ZERO:
            yield tidied(-substitute(e, {name: ZERO}) / factor)
