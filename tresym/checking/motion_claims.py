"""Decide what is said of the solutions of a system of differential equations x' = F(x).

- ``conserved(f) along …``: f is smooth, and its derivative along the motion, Σ F_i ∂f/∂x_i, is 0.
- ``stable …``: the roots of the characteristic polynomial of the linearised system have negative
  real parts (Routh and Hurwitz), or a function V with a strict minimum at the equilibrium does not
  grow along the motion (Lyapunov). V is the one named after ``by``, a square, or made of functions
  that the motion conserves (:mod:`tresym.checking.first_integrals`, energy–Casimir method).
- ``unstable …``: a root has a positive real part, or a positive definite function grows along the
  motion (Lyapunov's first theorem on instability).
- With one variable the first derivative of F that is not 0 decides.

A claim with parameters is refuted at values of these, by a proof of the contrary.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from itertools import combinations, islice, product

from flint import fmpq

from tresym.checking.first_integrals import null_space, plane_integrals, quadratic_integrals
from tresym.reals.decisions.answer import Answer, Obligation, refuted, worst
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import analytic_of, bound, needs, operations
from tresym.reals.language.binders import derivative, elementary, worked_out
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    add,
    multiply,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.named_claims import ASYMPTOTICALLY, UNSTABLE, Conserved, Equilibrium
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import undefined
from tresym.reals.signs.interior import jumps
from tresym.reals.signs.sign import proof
from tresym.reals.verdict import Verdict

Ask = Callable[[Compared, Iterable[Compared]], Answer]
"""Decides a comparison under conditions."""
UNDECIDED = Verdict.UNDECIDED
POINTS = 40
"""Points at which a derivative along the motion is tried."""
PARAMETERS = 6
"""Values of the parameters at which the contrary is tried."""
LARGEST = 4
"""The most variables whose characteristic polynomial is looked at."""
ORDER = 7
"""The highest derivative that is worked out at an equilibrium of one variable."""
NEAR = number(fmpq(1, 8))
"""How far from the equilibrium a function is looked at, where it is not looked at everywhere."""
KINKS = frozenset(("abs", "sign", "atan2", "floor", "ceiling", "max", "min"))
"""Functions with corners or jumps."""
ALONG = "derivative along the motion"


# A conserved function


def decide_conserved(claim: Conserved, asked: Ask) -> Answer:
    """Decide whether a function is constant along the solutions."""
    f, rates = worked_out(claim.function), tuple(map(worked_out, claim.rates))
    if not elementary(f, *rates):
        return Answer(UNDECIDED, "conserved functions and motions are elementary expressions here")
    slope = along(f, claim.names, rates)
    if not elementary(slope):
        return Answer(UNDECIDED, f"the derivative of {f} is not worked out")
    found = asked((slope, "==", ZERO), claim.given)
    link = _obligation(found)
    where = _plain((*claim.given, *_needed(rates)))
    if found:
        gap = undefined(f, where, proof) or undefined(slope, where, proof)
        gap = gap or next(iter(jumps((f,), where)), None)
        if gap is not None or _has_floors(f):
            why = f"{f} is not shown to be continuous wherever the motion is: {gap or f}"
            return Answer(UNDECIDED, why, obligations=(link,))
        why = f"its {ALONG}, {slope}, is 0: {found.why}" if slope != ZERO else f"its {ALONG} is 0"
        return Answer(found.verdict, why, lemma=ALONG, obligations=(link,))
    if any(sign in ("==", "in") for _, sign, _ in claim.given):
        why = f"its {ALONG} is not shown to be 0 where the conditions hold: {found.why}"
        return Answer(UNDECIDED, why, obligations=(link,))
    names = sorted(symbols(f).union({*claim.names}, *map(symbols, rates)))
    for point in islice(where.points(names, POINTS), POINTS):
        at = {name: fmpq(x) for name, x in point.items()}
        with ball_precision():
            value = evaluate(slope, at)
            moved = (value > 0 or value < 0) and _is_smooth_at(at, (f, slope, *rates))
        if moved:
            why = f"its {ALONG}, {slope}, is not 0"
            return replace(refuted(why, at), obligations=(link,))
    return Answer(UNDECIDED, f"its {ALONG}: {found.why}", obligations=(link,))


def along(f: Expr, names: Sequence[str], rates: Sequence[Expr]) -> Expr:
    """The derivative of ``f`` along the motion."""
    slopes = (worked_out(derivative(f, name)) for name in names)
    return add(*(slope * rate for slope, rate in zip(slopes, rates, strict=True)))


def _is_smooth_at(at: Mapping[str, fmpq], sides: Sequence[Expr]) -> bool:
    """Whether all sides are analytic in a neighbourhood of a point, by balls."""
    for node in operations(sides):
        for part, sign in analytic_of(node):
            value = evaluate(part, at)
            if not (value > 0 or (sign == "!=" and value < 0)):
                return False
        if node.op in KINKS:
            values = [evaluate(part, at) for part in node.args]
            if node.op not in ("abs", "sign") or not (values[0] > 0 or values[0] < 0):
                return False
    return True


# Equilibria


def decide_equilibrium(claim: Equilibrium, asked: Ask) -> Answer:
    """Decide whether a point is an equilibrium, and of which kind."""
    trees = [*claim.rates, *claim.point, *([] if claim.by is None else [claim.by])]
    if not elementary(*map(worked_out, trees)):
        return Answer(UNDECIDED, "motions and their equilibria are elementary expressions here")
    claim = claim._replace(
        rates=tuple(map(worked_out, claim.rates)), point=tuple(map(worked_out, claim.point)),
        by=None if claim.by is None else worked_out(claim.by),
    )  # fmt: skip
    found = _Equilibrium(claim, asked).decided()
    if found.verdict is not UNDECIDED:
        return found
    for values in _values_of_parameters(claim):
        put = {name: number(x) for name, x in values.items()}
        there = _Equilibrium(_put(claim, put), asked).decided()
        if there.verdict is Verdict.REFUTED:
            return replace(refuted(there.why, values), obligations=there.obligations)
    return found


def _put(claim: Equilibrium, put: Mapping[str, Expr]) -> Equilibrium:
    return claim._replace(
        point=tuple(substitute(p, put) for p in claim.point),
        rates=tuple(substitute(rate, put) for rate in claim.rates),
        by=None if claim.by is None else substitute(claim.by, put),
        given=tuple(
            link for left, sign, right in claim.given
            for link in ((substitute(left, put), sign, substitute(right, put)),)
            if symbols(link[0]) | symbols(link[2])
        ),
    )  # fmt: skip


def _values_of_parameters(claim: Equilibrium) -> Iterator[dict[str, fmpq]]:
    """Yield values of the parameters that the conditions allow, 0, 1 and −1 first."""
    outer, _ = _parted(claim)
    if any(sign in ("==", "in") for _, sign, _ in outer):
        return
    where = Given(outer).unfolded()
    names = where.names.union(*map(symbols, (*claim.rates, *claim.point)))
    names = frozenset(names) - {*claim.names}
    if not names:
        return
    wanted = sorted(names)
    if len(wanted) <= 3:
        for values in product((0, 1, -1), repeat=len(wanted)):
            at = {name: fmpq(x) for name, x in zip(wanted, values, strict=True)}
            with ball_precision():
                holds = all(condition.holds_exactly(at) for condition in where.conditions)
            if holds:
                yield at
    for point in islice(where.points(wanted, PARAMETERS), PARAMETERS):
        yield {name: fmpq(x) for name, x in point.items()}


def _parted(claim: Equilibrium) -> tuple[tuple[Compared, ...], tuple[Compared, ...]]:
    """The conditions on the parameters, and those on the variables."""
    inner = tuple(link for link in claim.given if _about(link, claim.names))
    return tuple(link for link in claim.given if link not in inner), inner


class _Equilibrium:
    """One equilibrium, with parameters or without."""

    def __init__(self, claim: Equilibrium, asked: Ask) -> None:
        self.claim, self.asked = claim, asked
        self.outer, self.inner = _parted(claim)
        self.plain = _plain(self.outer)
        self.place = dict(zip(claim.names, claim.point, strict=True))
        self.shifts = [symbol(name) - p for name, p in self.place.items()]

    def decided(self) -> Answer:
        claim = self.claim
        at_rest: list[Answer] = []
        gap = self.not_smooth(claim.rates)
        if gap is not None:
            return Answer(UNDECIDED, f"the motion is not shown to be smooth near the point: {gap}")
        for left, sign, right in self.inner:
            if sign in ("==", "in"):
                return Answer(UNDECIDED, "conditions on the variables are inequalities here")
            there = (self.at(left), sign if sign == "!=" else sign[0], self.at(right))
            at_rest.append(self.asked(there, self.outer))
            sides = (undefined(side, self.plain, proof) for side in there[::2])
            if not at_rest[-1] or any(gap is not None for gap in sides):
                why = f"{chained(((left, sign, right),))} is not shown to hold near the point"
                return Answer(UNDECIDED, why)
        for rate in claim.rates:
            value = self.at(rate)
            found = self.asked((value, "==", ZERO), self.outer)
            if found.verdict is Verdict.REFUTED and found.witness is not None:
                why = f"the point is no equilibrium, since {value} is not 0: {found.why}"
                return replace(found, why=why, obligations=(_obligation(found),))
            if not found:
                why = f"the point is not shown to be an equilibrium: {found.why}"
                return Answer(UNDECIDED, why, obligations=(_obligation(found),))
            at_rest.append(found)
        holds = self.unstable() if claim.how == UNSTABLE else self.stable()
        if holds is not None:
            links = (*map(_obligation, at_rest), *holds.obligations)
            return replace(holds, obligations=links)
        if not self.parameters():
            fails = self.stable() if claim.how == UNSTABLE else self.unstable()
            if fails is None and claim.how == ASYMPTOTICALLY:
                fails = self.by_functions(lambda v: self.not_attracting(v))
            if fails is not None:
                return replace(refuted(fails.why, {}), obligations=fails.obligations)
        return Answer(UNDECIDED, "neither the linearised motion nor a function of Lyapunov decides")

    def parameters(self) -> frozenset[str]:
        trees = (*self.claim.rates, *self.claim.point)
        return frozenset().union(self.plain.names, *map(symbols, trees)) - {*self.claim.names}

    def at(self, e: Expr) -> Expr:
        return substitute(e, self.place)

    def not_smooth(self, sides: Sequence[Expr]) -> Expr | None:
        """A part that is not shown to be analytic in a neighbourhood of the point."""
        if any(undefined(p, self.plain, proof) is not None for p in self.claim.point):
            return next(p for p in self.claim.point if undefined(p, self.plain, proof) is not None)
        for node in operations(sides):
            if node.op in KINKS and node.op not in ("abs", "sign"):
                return node
            wanted = analytic_of(node)
            if node.op in ("abs", "sign"):
                wanted = [*wanted, (node.args[0], "!=")]
            for part, sign in wanted:
                there = self.at(part)
                if undefined(there, self.plain, proof) is not None:
                    return part
                if not self.asked((there, sign, ZERO), self.outer):
                    return part
        return None

    # The linearised motion

    def coefficients(self) -> list[Expr]:
        """Of the characteristic polynomial, after that of the highest power, which is 1."""
        size = len(self.claim.names)
        matrix = [
            [self.at(worked_out(derivative(rate, name))) for name in self.claim.names]
            for rate in self.claim.rates
        ]
        found = []
        for k in range(1, size + 1):
            minors = (
                _determinant([[matrix[i][j] for j in rows] for i in rows])
                for rows in combinations(range(size), k)
            )
            found.append(multiply(number(fmpq((-1) ** k)), add(*minors)))
        return found

    def hurwitz(self) -> list[Expr]:
        """What is positive if and only if all roots have negative real parts."""
        a = self.coefficients()
        if len(a) < 3:
            return a
        if len(a) == 3:
            return [a[0], a[2], a[0] * a[1] - a[2]]
        return [a[0], a[2], a[3], a[0] * a[1] * a[2] - a[2] * a[2] - a[0] * a[0] * a[3]]

    def by_roots(self, grows: bool) -> Answer | None:
        """Decide by the signs of the real parts of the roots."""
        if len(self.claim.names) > LARGEST:
            return None
        if not grows:
            answers = [self.shown(e, ">") for e in self.hurwitz()]
            if not all(answers):
                return None
            why = "the roots of the characteristic polynomial have negative real parts"
            return _by("Routh and Hurwitz", why, answers)
        for e in dict.fromkeys((*self.coefficients(), *self.hurwitz())):
            found = self.shown(e, "<")
            if found:
                why = (
                    f"a root of the characteristic polynomial has a positive real part, as {e} < 0"
                )
                return _by("linearisation", why, [found])
        return None

    def shown(self, e: Expr, sign: str) -> Answer:
        """Whether a value at the point has a sign, for all parameters, and exists for all."""
        if undefined(e, self.plain, proof) is not None:
            return Answer(UNDECIDED, f"{e} is not shown to be defined")
        return self.asked((e, sign, ZERO), self.outer)

    # One variable

    def by_order(self, grows: bool, strictly: bool) -> Answer | None:
        """Decide a motion of one variable by the first derivative that is not 0."""
        if len(self.claim.names) > 1:
            return None
        e, zeros = self.claim.rates[0], []
        for order in range(1, ORDER + 1):
            e = worked_out(derivative(e, self.claim.names[0]))
            value = self.at(e)
            if not elementary(value) or undefined(value, self.plain, proof) is not None:
                return None
            zero = self.asked((value, "==", ZERO), self.outer)
            if zero:
                zeros.append(zero)
                continue
            sign = "!=" if grows and order % 2 == 0 else ">" if grows else "<"
            found = self.asked((value, sign, ZERO), self.outer)
            if not found or (not grows and order % 2 == 0):
                return None
            why = f"the derivative of order {order} is the first that is not 0, {value} {sign} 0"
            return _by("one variable", why, [*zeros, found])
        return None

    # Functions of Lyapunov

    def stable(self) -> Answer | None:
        strictly = self.claim.how == ASYMPTOTICALLY
        found = self.by_roots(False) or self.by_order(False, strictly)
        if found is None and not self.parameters() and self.by_roots(True) is not None:
            return None
        if found is None:
            sign = "<" if strictly else "<="
            found = self.by_functions(lambda v: self.lyapunov(v, sign))
        return self.by_polynomials() if found is None and not strictly else found

    def unstable(self) -> Answer | None:
        found = self.by_roots(True) or self.by_order(True, False)
        return found or self.by_functions(lambda v: self.lyapunov(v, ">"))

    def by_functions(self, tried: Callable[[Expr], Answer | None]) -> Answer | None:
        for v in dict.fromkeys(self.functions()):
            if elementary(v) and self.not_smooth((v,)) is None:
                found = tried(v)
                if found is not None:
                    return found
        return None

    def functions(self) -> Iterator[Expr]:
        """Yield functions that may have a minimum at the point and not grow along the motion."""
        if self.claim.by is not None:
            yield self.claim.by
            yield -self.claim.by
        yield add(*(u * u for u in self.shifts))
        if len(self.claim.names) == 2:
            yield from self.of_the_plane()

    def of_the_plane(self) -> Iterator[Expr]:
        """Yield a quadratic function that the linear part conserves, and first integrals."""
        x, y = self.claim.names
        (a, b), (c, _) = (
            [self.at(worked_out(derivative(rate, name))) for name in (x, y)]
            for rate in self.claim.rates
        )
        u, v = self.shifts
        if elementary(a, b, c):
            form = b * v * v + number(fmpq(2)) * a * u * v - c * u * u
            yield form
            yield -form
        for integral in plane_integrals((x, y), self.claim.rates):
            yield integral
            yield -integral

    def lyapunov(self, v: Expr, sign: str) -> Answer | None:
        """Show that a function has a strict minimum there, and how it changes along the motion."""
        slope = along(v, self.claim.names, self.claim.rates)
        if not elementary(slope) or not self.may_be(slope, sign):
            return None
        minimum = self.strict_minimum(v)
        if minimum is None:
            return None
        change = self.changes(slope, sign)
        if change is None:
            return None
        falls = {"<=": "does not grow", "<": "falls", ">": "grows"}[sign]
        why = f"{v} has a strict minimum there and {falls} along the motion"
        return _by("Lyapunov's function", why, [*minimum, change])

    def by_polynomials(self) -> Answer | None:
        """Show stability by polynomials that the motion conserves (energy–Casimir method).

        If the gradient of a combination of them is 0 at the point, and its second derivatives are
        positive definite where the gradients of all of them are 0, then the combination plus a
        large multiple of the squares of their changes has a strict minimum.
        """
        names, rates = self.claim.names, self.claim.rates
        integrals = quadratic_integrals(names, rates) if len(names) <= LARGEST else []
        if not integrals or self.not_smooth(integrals) is not None:
            return None
        slopes = [
            [in_lowest_terms(self.at(worked_out(derivative(h, name)))) for name in names]
            for h in integrals
        ]
        tangent, divisors = null_space(slopes, len(names))
        flat, _ = null_space(list(zip(*slopes, strict=True)), len(integrals))
        for vector in flat:
            for sign in (1, -1):
                terms = (c * h for c, h in zip(vector, integrals, strict=True) if c != ZERO)
                v = in_lowest_terms(number(fmpq(sign)) * add(*terms))
                shown = self.minimum_on(v, tangent)
                if shown is None or self.not_smooth((v,)) is not None:
                    continue
                asked = [self.asked((e, "!=", ZERO), self.outer) for e in divisors]
                asked += [
                    self.asked((along(h, names, rates), "==", ZERO), self.claim.given)
                    for h in integrals
                ]
                if all(asked):
                    why = f"{v} has a minimum there among the points with the values of what is "
                    why += f"conserved, {', '.join(map(str, integrals))}"
                    return _by("energy–Casimir method", why, [*shown, *asked])
        return None

    def minimum_on(self, v: Expr, tangent: Sequence[Sequence[Expr]]) -> list[Answer] | None:
        """Show that the gradient of v is 0, and its second derivatives positive in directions."""
        names = self.claim.names
        slopes = [worked_out(derivative(v, name)) for name in names]
        answers = [
            self.asked((in_lowest_terms(self.at(e)), "==", ZERO), self.outer) for e in slopes
        ]
        second = [[self.at(worked_out(derivative(e, name))) for name in names] for e in slopes]
        form = [
            [
                add(*(s * second[i][j] * t for i, s in enumerate(one) for j, t in enumerate(other)))
                for other in tangent
            ]
            for one in tangent
        ]
        for k in range(1, len(form) + 1):
            minor = in_lowest_terms(_determinant([row[:k] for row in form[:k]]))
            answers.append(self.shown(minor, ">"))
            if not answers[-1]:
                return None
        return answers if all(answers) else None

    def not_attracting(self, v: Expr) -> Answer | None:
        """Show that a conserved function has a strict minimum, so that nothing tends to it."""
        minimum = self.strict_minimum(v)
        slope = along(v, self.claim.names, self.claim.rates)
        if minimum is None or not elementary(slope):
            return None
        change = self.asked((slope, "==", ZERO), self.claim.given)
        if not change:
            return None
        why = f"{v} is conserved and has a strict minimum there, so that no solution tends to it"
        return _by("conserved function", why, [*minimum, change])

    def may_be(self, e: Expr, sign: str) -> bool:
        """Whether balls at points nearby do not exclude a sign of what is 0 at the point."""
        values = [{}] if not self.parameters() else islice(_values_of_parameters(self.claim), 2)
        for at in values:
            with ball_precision():
                centre = [evaluate(p, at) for p in self.claim.point]
                for direction in islice(product((0, 1, -1, 2), repeat=len(centre)), 1, 40):
                    for width in (fmpq(1, 16), fmpq(1, 128)):
                        there = {
                            name: x + width * d
                            for name, x, d in zip(self.claim.names, centre, direction, strict=True)
                        }
                        value = evaluate(e, {**at, **there})
                        if value < 0 if sign[0] == ">" else value > 0:
                            return False
        return True

    def changes(self, slope: Expr, sign: str) -> Answer | None:
        """The sign of the change along the motion, everywhere or near the point."""
        apart = (add(*(u * u for u in self.shifts)), ">", ZERO)
        away = () if sign == "<=" else (apart,)
        if sign == "<=":
            found = self.asked((slope, "==", ZERO), self.claim.given)
            if found:
                return found
        found = self.asked((slope, sign, ZERO), (*self.claim.given, *away))
        if found:
            return found
        near = tuple(
            link for name, p in self.place.items()
            for link in ((symbol(name), ">", p - NEAR), (symbol(name), "<", p + NEAR))
        )  # fmt: skip
        found = self.asked((slope, sign, ZERO), (*self.claim.given, *near, *away))
        return found if found else None

    def strict_minimum(self, v: Expr) -> list[Answer] | None:
        """The obligations that a function has a strict minimum at the point."""
        slopes = [worked_out(derivative(v, name)) for name in self.claim.names]
        if not elementary(*slopes) or not self.may_be(v - self.at(v), ">"):
            return None
        answers = [self.asked((self.at(slope), "==", ZERO), self.outer) for slope in slopes]
        if not all(answers):
            return None
        hessian = [
            [in_lowest_terms(self.at(worked_out(derivative(slope, n)))) for n in self.claim.names]
            for slope in slopes
        ]
        if not elementary(*(e for row in hessian for e in row)):
            return None
        minors = [
            self.shown(in_lowest_terms(_determinant([row[:k] for row in hessian[:k]])), ">")
            for k in range(1, len(hessian) + 1)
        ]
        if all(minors):
            return [*answers, *minors]
        apart = (add(*(u * u for u in self.shifts)), ">", ZERO)
        above = self.asked((v - self.at(v), ">", ZERO), (*self.claim.given, apart))
        return [*answers, above] if above else None


def _determinant(rows: Sequence[Sequence[Expr]]) -> Expr:
    """The determinant of a small matrix, expanded by its first row."""
    if len(rows) == 1:
        return rows[0][0]
    terms = []
    for n, entry in enumerate(rows[0]):
        rest = [(*row[:n], *row[n + 1 :]) for row in rows[1:]]
        terms.append(number(fmpq((-1) ** n)) * entry * _determinant(rest))
    return add(*terms)


def _about(link: Compared, names: Iterable[str]) -> bool:
    return bool((symbols(link[0]) | symbols(link[2])) & {*names})


def _plain(given: Iterable[Compared]) -> Given:
    """The inequalities among elementary expressions."""
    return Given(tuple(
        link for link in given if link[1] not in ("==", "in") and elementary(link[0], link[2])
    )).unfolded()  # fmt: skip


def _needed(sides: Iterable[Expr]) -> tuple[Compared, ...]:
    return tuple(bound(*part) for part in needs(sides) if symbols(part[0]))


def _has_floors(f: Expr) -> bool:
    return any(node.op in ("floor", "ceiling") for node in operations((f,)))


def _by(lemma: str, why: str, answers: Sequence[Answer]) -> Answer:
    links = tuple(map(_obligation, answers))
    return Answer(worst(answers).verdict, why, lemma=lemma, obligations=links)


def _obligation(answer: Answer) -> Obligation:
    claim, _, given = answer.read_as.partition(" given ")
    return Obligation(claim, given, answer.verdict.value)
