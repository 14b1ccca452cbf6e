"""Decide claims about extrema, such as ``infimum(exp(-x), x) == 0`` ``maximum(sin(x), x) == 1``.

The infimum of f is v if f >= v wherever the conditions hold, and if f comes as close to v as one
likes: at a point at which f is v, or along a path at whose end f tends to v. Points are sought
among the ends of the ranges, the zeros of the derivatives, and small numbers; such paths lead to
the ends of one range, while the other variables stay where they are or follow. That f >= v, the
value at the point, and the limit are obligations, decided like any claim. A minimum is an infimum
at a point. A supremum and a maximum are those of −f.

A claim is refuted by a point at which f is smaller than v, or by a number greater than v that f
does not fall below, for some values of the parameters.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import islice, product

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Obligation, refuted, worst
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import needs, operations
from tresym.reals.language.binders import derivative, elementary, worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import (
    HALF,
    ONE,
    PI,
    ZERO,
    Expr,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.named_claims import Extremum
from tresym.reals.language.paths import Path
from tresym.reals.language.solve import solutions
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Verdict

Ask = Callable[..., Answer]
"""Decides a comparison under conditions, and along a path."""
UNDECIDED = Verdict.UNDECIDED
CANDIDATES, SHOWN = 3000, 4
"""Points at which f is evaluated, and those of them that are looked at exactly."""
PATHS = 12
"""Paths along which a limit is looked for."""
SCALE = 2**80
"""Of numbers that are estimated."""
SMALLEST_GAP = fmpq(1, 10**20)
"""Between the claimed value and the extreme value that was found, to look for a number between."""
SAMPLES, PARAMETERS, STEPS = 120, 4, 60
"""Points and values of the parameters at which the smallest value is estimated."""


def decide_extremum(claim: Extremum, asked: Ask) -> Answer:
    """Decide whether a number is the infimum, supremum, minimum or maximum of a function."""
    f, value = worked_out(claim.function), worked_out(claim.value)
    infinite = value in (INFINITY, -INFINITY)
    if not elementary(f) or not (infinite or elementary(value)):
        return Answer(UNDECIDED, "extrema are looked for of elementary expressions only")
    names = claim.names or tuple(sorted(
        frozenset().union(symbols(f), *(symbols(e) for link in claim.given for e in link[::2]))
        - {INFINITY.args[0]}
    ))  # fmt: skip
    while (solved := _solved(claim.given, names)) is not None and len(names) > 1:
        name, e = solved
        f, names = substitute(f, {name: e}), tuple(n for n in names if n != name)
        claim = claim._replace(function=f, names=names, given=_put_in(claim.given, {name: e}))
    search = _Search(claim, names, f, value, asked)
    if any(sign == "in" for _, sign, _ in search.inner):
        return Answer(UNDECIDED, "extrema over integers are not looked for")
    return search.decided()


class _Search:
    """The least value of f, or of −f where the claim is about a greatest one."""

    def __init__(
        self, claim: Extremum, names: tuple[str, ...], f: Expr, value: Expr, asked: Ask
    ) -> None:
        self.claim, self.names, self.asked = claim, names, asked
        self.is_least = claim.how in ("infimum", "minimum")
        self.f, self.value = f, value
        self.is_infinite = value in (INFINITY, -INFINITY)
        self.inner = tuple(link for link in claim.given if _names(link) & {*names})
        self.outer = tuple(link for link in claim.given if link not in self.inner)
        self.plain = _plain(self.outer)
        trees = [f, *(e for link in claim.given for e in link[::2])]
        trees += [] if self.is_infinite else [value]
        used = frozenset().union(*map(symbols, trees))
        self.parameters = sorted(used - {*names, INFINITY.args[0]})

    def decided(self) -> Answer:
        if not self.is_infinite and undefined(self.value, self.plain, proof) is not None:
            why = f"{self.value} is not shown to be defined for all values of the parameters"
            return Answer(UNDECIDED, why)
        strict = self.claim.how in ("minimum", "maximum")
        links: list[Answer] = []
        if not self.is_infinite:
            sign = ">=" if self.is_least else "<="
            found = self.asked((self.f, sign, self.value), self.claim.given)
            if found.verdict is Verdict.REFUTED:
                beyond = "smaller" if self.is_least else "greater"
                why = f"{self.f} is {beyond} than {self.value} at a point: {found.why}"
                return replace(found, why=why, obligations=(_obligation(found),))
            if not found:
                why = f"the bound {found.read_as} is not shown: {found.why}"
                return self.not_the_greatest(why, found)
            links.append(found)
            at = self.attained()
            if at is not None:
                where, shown = at
                place = ", ".join(f"{n} = {e}" for n, e in where.items())
                return self.holds(f"it is attained at {place}", [*links, *shown])
            if strict:
                above = self.asked((self.f, sign[0], self.value), self.claim.given)
                if above:
                    why = f"{self.value} is not attained: {above.why}"
                    return replace(refuted(why, {}), obligations=(_obligation(above),))
                return self.not_the_greatest(f"no point was found at which it is {self.value}")
        for path, others, shown in self.approached():
            moving = f", {', '.join(f'{n} = {e}' for n, e in others.items())}" if others else ""
            return self.holds(f"it is approached as {path}{moving}", [*links, *shown])
        return self.not_the_greatest(f"no point or path was found that leads to {self.value}")

    def holds(self, why: str, answers: Sequence[Answer]) -> Answer:
        bound = "" if self.is_infinite else f"{answers[0].read_as.partition(' given ')[0]}, and "
        obligations = tuple(map(_obligation, answers))
        return Answer(worst(answers).verdict, f"{bound}{why}", obligations=obligations)

    # Points

    def attained(self) -> tuple[dict[str, Expr], list[Answer]] | None:
        """A point of the conditions at which f has the value, for all values of the parameters."""
        for place in islice(self.likely_points(), SHOWN):
            shown = self.shown_at(place)
            if shown is not None:
                return place, shown
        return None

    def shown_at(self, place: Mapping[str, Expr]) -> list[Answer] | None:
        """The obligations that the point satisfies the conditions, and f has the value there."""
        answers: list[Answer] = []
        links = [*self.inner, (self.f, "==", self.value)]
        # Outside of its domain an expression would satisfy everything.
        sides = [substitute(e, place) for link in links for e in link[::2]]
        for e in (*place.values(), *sides):
            if not elementary(e) or undefined(e, self.plain, proof) is not None:
                return None
        if any(not _defined_when_put(e, place, self.plain) for e in (self.f,)):
            return None
        for left, sign, right in links:
            link = substitute(left, place), sign, substitute(right, place)
            answers.append(self.asked(link, self.outer))
            if not answers[-1]:
                return None
        return answers

    def likely_points(self) -> Iterator[dict[str, Expr]]:
        """Yield points at which balls do not exclude the value, for some values of parameters."""
        samples = list(islice(self.values_of_parameters(), 3))
        if not samples:
            return
        for place in islice(self.candidates(), CANDIDATES):
            if all(self.may_be(place, at) for at in samples):
                yield place

    def may_be(self, place: Mapping[str, Expr], at: Mapping[str, fmpq]) -> bool:
        with ball_precision():
            point: dict[str, fmpq | arb] = {**at}
            for name, e in place.items():
                ball = evaluate(e, at)
                if not ball.is_finite():
                    return False
                point[name] = ball
            gap = evaluate(self.f - self.value, point)
            if gap.is_finite() and not gap.contains(0):
                return False
            for left, sign, right in self.inner:
                gap = evaluate(left - right, point)
                if gap.is_finite() and not _may_hold(gap, sign):
                    return False
        return True

    def candidates(self) -> Iterator[dict[str, Expr]]:
        """Yield points that may be extreme: small numbers, ends of ranges, zeros of derivatives."""
        rows = [self.values_of(name) for name in self.names]
        order = sorted(
            product(*(range(len(row)) for row in rows)), key=lambda places: (sum(places), places)
        ) if len(rows) < 4 else product(*(range(min(len(row), 6)) for row in rows))  # fmt: skip
        yield from self.symmetric()
        for places in order:
            chosen = {n: row[k] for n, row, k in zip(self.names, rows, places, strict=True)}
            yield chosen
            for name in self.names if len(self.names) > 1 else ():
                others = {n: e for n, e in chosen.items() if n != name}
                slope = substitute(worked_out(derivative(self.f, name)), others)
                links = [substitute(x - y, others) for x, sign, y in self.inner if sign == "=="]
                for equation in (*links, *([slope] if elementary(slope) else [])):
                    for solved in solutions(equation, name):
                        if name not in symbols(solved):
                            yield {**chosen, name: solved}

    def symmetric(self) -> Iterator[dict[str, Expr]]:
        """Yield points with equal coordinates that satisfy the equations, or are extreme there."""
        if len(self.names) < 2:
            return
        first = self.names[0]
        equal = dict.fromkeys(self.names, symbol(first))
        equations = [substitute(x - y, equal) for x, sign, y in self.inner if sign == "=="]
        slope = worked_out(derivative(substitute(self.f, equal), first))
        for equation in (*equations, *([slope] if elementary(slope) else [])):
            zeros = [*solutions(equation, first), *solutions(in_lowest_terms(equation), first)]
            for e in zeros:
                if first not in symbols(e):
                    yield dict.fromkeys(self.names, e)

    def values_of(self, name: str) -> list[Expr]:
        found: list[Expr] = [*self.ends_of(name)]
        slope = worked_out(derivative(self.f, name))
        if elementary(slope):
            found += solutions(slope, name)
            found += solutions(in_lowest_terms(slope), name)
            found += _zeros_of_quadratic(slope, name)
        if not self.is_infinite:
            found += solutions(self.f - self.value, name)
        found += [ZERO, ONE, -ONE, HALF, number(fmpq(2)), -HALF, number(fmpq(-2))]
        found += [symbol(n) for n in self.parameters]
        for node in operations((self.f,)):
            if node.op in ("sin", "cos"):  # where they are 0, 1 or −1
                turns = (PI * number(fmpq(n, 2)) for n in (0, 1, -1, 2, -2, 3, -3))
                found += [e for turn in turns for e in solutions(node.args[0] - turn, name)]
        if any(op in str(self.f) for op in ("sin", "cos", "tan")):
            found += [PI * HALF, PI, -PI * HALF, PI * HALF * HALF, PI / number(fmpq(3)),
                      PI / number(fmpq(6)), PI * number(fmpq(3, 2))]  # fmt: skip
        return [e for e in dict.fromkeys(found) if not symbols(e) & {*self.names}]

    def ends_of(self, name: str) -> Iterator[Expr]:
        """Yield the ends of the range of a variable, as the conditions write them."""
        for left, _, right in (
            Given(tuple(link for link in self.inner if link[1] not in ("==", "in")))
            .unfolded()
            .comparisons
        ):
            for side, end in ((left, right), (right, left)):
                if name in symbols(side) and not symbols(end) & {*self.names}:
                    yield from (e for e in solutions(side - end, name))

    # Paths

    def approached(self) -> Iterator[tuple[Path, dict[str, Expr], list[Answer]]]:
        """Yield paths through points of the conditions at whose end f tends to the value."""
        for path, others in islice(self.paths(), PATHS):
            shown = self.shown_along(path, others)
            if shown is not None:
                yield path, others, shown

    def paths(self) -> Iterator[tuple[Path, dict[str, Expr]]]:
        samples = list(islice(self.values_of_parameters(), 2))
        if not samples:
            return
        for name in self.names:
            ends: list[tuple[Expr | None, int]] = [(None, 1), (None, -1)]
            points = dict.fromkeys((*self.ends_of(name), ZERO, *self.values_of(name)[:8]))
            ends += [(e, side) for e in points for side in (1, -1)]
            for others in self.others(name):
                f = substitute(self.f, others)
                for end, side in ends:
                    if all(self.may_tend(f, name, end, side, others, at) for at in samples):
                        yield Path(name, end, (side,)), others

    def others(self, name: str) -> Iterator[dict[str, Expr]]:
        """Yield what the other variables are along a path: numbers, or powers of its variable."""
        rest = [n for n in self.names if n != name]
        x = symbol(name)
        rows = [[*self.values_of(n)[:6], x, -x, ONE / x, x * x] for n in rest]
        for values in islice(product(*rows), 40):
            yield dict(zip(rest, values, strict=True))

    def may_tend(
        self, f: Expr, name: str, end: Expr | None, side: int, others: Mapping[str, Expr],
        at: Mapping[str, fmpq],
    ) -> bool:  # fmt: skip
        """Whether f comes closer to the value at two points near the end, by balls."""
        with ball_precision():
            start = fmpq(0)
            if end is not None:
                ball = evaluate(end, at)
                if not ball.is_finite():
                    return False
                start = ball.mid().fmpq() if hasattr(ball.mid(), "fmpq") else fmpq(0)
            gaps = []
            for n in (10, 40):
                step = fmpq(2**n) if end is None else fmpq(1, 2**n)
                point = {**at, name: start + side * step}
                where = {**point}
                for other, e in others.items():
                    inner = evaluate(e, point)
                    if not inner.is_finite():
                        return False
                    where[other] = inner
                if not all(_may_hold(evaluate(x - y, where), s) for x, s, y in self.inner):
                    return False
                value = evaluate(f, where)
                if not value.is_finite():
                    return False
                bound = ZERO if self.is_infinite else self.value
                gaps.append(abs(value - evaluate(bound, at)).mid())
                falls = bool(value < 0) == (self.value == -INFINITY)
                if self.is_infinite and not falls:
                    return False
            if self.is_infinite:
                return bool(gaps[1] * 4 >= gaps[0] * 5)
            return bool(gaps[1] * 5 <= gaps[0] * 4 or gaps[1] < SMALLEST_GAP)

    def shown_along(self, path: Path, others: Mapping[str, Expr]) -> list[Answer] | None:
        """The obligations of a path: the conditions near its end, and the limit there."""
        name, end = path.name, path.point
        f = substitute(self.f, others)
        if end is not None and undefined(end, self.plain, proof) is not None:
            return None
        answers: list[Answer] = []
        along: list[Compared] = []
        for left, sign, right in self.inner:
            link = substitute(left, others), sign, substitute(right, others)
            if link[0] == link[2] and sign in ("==", "<=", ">="):
                continue
            own = path if name in _names(link) else None
            answers.append(self.asked(link, self.outer, own))
            if not answers[-1]:
                return None
            along.append(link)
        x = symbol(name)
        if end is not None:
            along.append((x, ">" if path.sides[0] > 0 else "<", end))
        elif not along:
            along.append((x, ">" if path.sides[0] > 0 else "<", ZERO))
        # The limit is one of points at which f is real, so there must be such points.
        where = self.plain & _plain(along)
        sides = (f, *others.values(), *(e for link in along for e in link[::2]))
        if any(undefined(e, where, proof) is not None for e in sides):
            return None
        answers.append(self.asked((f, "->", self.value), self.outer, path))
        return answers if answers[-1] else None

    # Refutations

    def not_the_greatest(self, otherwise: str, *missing: Answer) -> Answer:
        """Refute the value by a number beyond it that f does not reach, at given parameters."""
        values = () if any(s == "==" for _, s, _ in self.outer) else self.values_of_parameters()
        for at in islice(values, PARAMETERS):
            put = {name: number(x) for name, x in at.items()}
            f = substitute(self.f, put)
            given = tuple(
                link for x, sign, y in self.claim.given
                for link in ((substitute(x, put), sign, substitute(y, put)),) if _names(link)
            )  # fmt: skip
            least = self.least_value(f, given)
            if least is None:
                continue
            with ball_precision():
                value = None if self.is_infinite else evaluate(substitute(self.value, put), {})
            sign = ">=" if self.is_least else "<="
            for number_ in _between(None if value is None else value, least, self.is_least):
                found = self.asked((f, sign, number(number_)), given)
                if found:
                    side = "least" if self.is_least else "most"
                    why = f"{f} is at {side} {number_} everywhere: {found.why}"
                    return replace(refuted(why, at), obligations=(_obligation(found),))
        return Answer(UNDECIDED, otherwise, obligations=tuple(map(_obligation, missing)))

    def least_value(self, f: Expr, given: tuple[Compared, ...]) -> fmpq | None:
        """An estimate of the least value of f (of the greatest, for a supremum)."""
        if any(sign in ("==", "in") for _, sign, _ in given):
            return None
        where = _plain(given)
        best: arb | None = None
        place: dict[str, fmpq] = {}

        def value_at(point: Mapping[str, fmpq]) -> arb | None:
            x = evaluate(f, point)
            return (x if self.is_least else -x) if x.is_finite() else None

        with ball_precision():
            for point in islice(where.points(self.names, SAMPLES), SAMPLES):
                at = {name: fmpq(x) for name, x in point.items()}
                value = value_at(at)
                if value is not None and (best is None or value < best):
                    best, place = value, at
            if best is None:
                return None
            width = fmpq(1)
            for _ in range(STEPS):
                moved = False
                for name in self.names:
                    for step in (width, -width):
                        at = {**place, name: place[name] + step}
                        if all(c.holds(at) for c in where.conditions):
                            value = value_at(at)
                            if value is not None and value < best:
                                best, place, moved = value, at, True
                if not moved:
                    width /= 2
            least = (best.mid() * SCALE).fmpq() if hasattr(best.mid(), "fmpq") else None
        if least is None:
            return None
        least = fmpq(int(least.floor()), SCALE)
        return least if self.is_least else -least

    def values_of_parameters(self) -> Iterator[dict[str, fmpq]]:
        if not self.parameters:
            yield {}
            return
        if any(sign in ("==", "in") for _, sign, _ in self.outer):
            return
        where = self.plain
        if len(self.parameters) <= 2:
            for values in product((0, 1, -1), repeat=len(self.parameters)):
                at = {n: fmpq(x) for n, x in zip(self.parameters, values, strict=True)}
                with ball_precision():
                    inside = all(condition.holds_exactly(at) for condition in where.conditions)
                if inside:
                    yield at
        for point in where.points(self.parameters, 8):
            yield {name: fmpq(x) for name, x in point.items()}


def _between(value: arb | None, least: fmpq, is_least: bool) -> list[fmpq]:
    """Numbers between the value and the extreme value that was found, simple ones first."""
    if value is None:
        beyond = [fmpq(n) for n in (1, 100)]
        return [least - x if is_least else least + x for x in beyond]
    if not value.is_finite():
        return []
    with ball_precision():
        gap = arb(least) - value if is_least else value - arb(least)
        if not gap > SMALLEST_GAP:
            return []
        middle = fmpq(int((value.mid() * SCALE).fmpq().floor()), SCALE)
        parts = ((fmpq(1, 4), fmpq(3, 4)), (fmpq(7, 8), fmpq(31, 32)), (fmpq(1, 50), fmpq(1, 10)))
        found = []
        for part in parts:
            ends = sorted(middle + (least - middle) * x for x in part)
            found.append(Interval(*ends).simplest())
        return [x for x in found if (value < x if is_least else value > x)]


def _zeros_of_quadratic(e: Expr, name: str) -> list[Expr]:
    """The zeros of a polynomial of degree 2 in a variable, whose coefficients may be parameters."""
    second = worked_out(derivative(worked_out(derivative(e, name)), name))
    if not elementary(second) or second == ZERO or name in symbols(second):
        return []
    at_zero = {name: ZERO}
    c, b = substitute(e, at_zero), substitute(worked_out(derivative(e, name)), at_zero)
    root = (b * b - number(fmpq(2)) * second * c) ** HALF
    return [(-b + root) / second, (-b - root) / second]


def _defined_when_put(e: Expr, place: Mapping[str, Expr], plain: Given) -> bool:
    """Whether all operands in an expression are defined at a point, also those that cancel."""
    for part, sign in needs((e,)):
        there = substitute(part, place)
        if undefined(there, plain, proof) is not None:
            return False
        if there.op == "number":
            x = there.args[0]
            if not (x > 0 or (x == 0 and sign == ">=") or (x < 0 and sign == "!=")):
                return False
        elif proof(there, sign, plain) is None:
            return False
    return True


def _may_hold(gap: arb, sign: str) -> bool:
    """Whether balls do not exclude a comparison, given left minus right."""
    if not gap.is_finite():
        return True
    if sign == "==":
        return bool(gap.contains(0))
    if sign in ("<", "<="):
        return not gap > 0
    if sign in (">", ">="):
        return not gap < 0
    return True


def _solved(given: Sequence[Compared], names: Sequence[str]) -> tuple[str, Expr] | None:
    """A variable that an equation determines, because it is affine in it with a number."""
    for left, sign, right in given:
        for name in names if sign == "==" and elementary(left, right) else ():
            slope = worked_out(derivative(left - right, name))
            if slope.op == "number" and slope != ZERO:
                e = -substitute(left - right, {name: ZERO}) / slope
                if not any(True for _ in needs((left, right))):
                    return name, e
    return None


def _put_in(given: Sequence[Compared], put: Mapping[str, Expr]) -> tuple[Compared, ...]:
    changed = ((substitute(x, put), sign, substitute(y, put)) for x, sign, y in given)
    return tuple(
        link for link in changed
        if not (link[1] == "==" and in_lowest_terms(link[0] - link[2]) == ZERO)
    )  # fmt: skip


def _names(link: Compared) -> frozenset[str]:
    return symbols(link[0]) | symbols(link[2])


def _plain(given: Sequence[Compared]) -> Given:
    """The inequalities among elementary expressions."""
    return Given(tuple(
        link for link in given if link[1] not in ("==", "in") and elementary(link[0], link[2])
    )).unfolded()  # fmt: skip


def _obligation(answer: Answer) -> Obligation:
    claim, _, given = answer.read_as.partition(" given ")
    given, _, path = given.partition(" as ")
    return Obligation(claim + (f" as {path}" if path else ""), given, answer.verdict.value)
