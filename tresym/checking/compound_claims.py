"""Decide claims made of claims, each form by a lemma whose obligations are decided like any claim.

- ``A and B``: each part.
- ``A <=> B``: B under the condition A, and A under B; of two equations first whether the quotient
  of their differences, or of a logarithm or the like of their sides, is a factor without zeros. A
  part that holds nowhere implies every other.
- ``exactly one x in (a, b): f == g``: by the intermediate value theorem a solution exists if f − g
  has opposite signs near the ends, and it is the only one where f − g is monotone, or where its
  second derivative has one sign. Without parameters balls count the solutions.
- ``at some point: A``: such a point, or a proof that A fails everywhere.
- ``increasing(f, x)``: f is continuous on an interval and has a positive derivative inside;
  ``convex(f, x)``: its second derivative is not negative. Otherwise the definition itself is
  decided: ``f(x_1) < f(x_2) given x_1 < x_2``, and ``f((x_1 + x_2)/2) <= (f(x_1) + f(x_2))/2``.
"""

from __future__ import annotations

import operator
import time
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from itertools import chain, islice, pairwise, product
from typing import Any

from flint import arb, fmpq

from tresym.checking.extremum_claims import decide_extremum
from tresym.checking.motion_claims import decide_conserved, decide_equilibrium
from tresym.reals.cross_check import somewhere
from tresym.reals.decisions.answer import Answer, Obligation, refuted, worst
from tresym.reals.decisions.claim_parsing import statement_of
from tresym.reals.decisions.root_values import enclosed
from tresym.reals.decisions.roots import root_nodes
from tresym.reals.decisions.roots_over_boxes import FEW, decide_over_boxes
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate, stands
from tresym.reals.domain.operation_domains import bound, needs, operations
from tresym.reals.language.binders import derivative, elementary, outermost, worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.claims import Written
from tresym.reals.language.compound import (
    Compound,
    Count,
    Equivalent,
    Formula,
    Shape,
    Somewhere,
    Together,
    leaves,
    shown,
)
from tresym.reals.language.expression import (
    HALF,
    ONE,
    ZERO,
    Expr,
    apply,
    bind,
    fresh,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED, Compared, chained
from tresym.reals.language.named_claims import Conserved, Equilibrium, Extremum
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.signs.definedness import continuous_on, undefined
from tresym.reals.signs.interior import is_zero, jumps
from tresym.reals.signs.sign import proof
from tresym.reals.signs.sign import sign as sign_of
from tresym.reals.verdict import Verdict

Check = Callable[[Any], Answer]
"""Decides a statement that was read."""
UNDECIDED = Verdict.UNDECIDED
PARAMETERS = 6
"""Points of the conditions at which solutions are counted to refute a claim."""
SEVERAL = 3
"""The most parameters for which all combinations of 0, 1 and −1 are tried."""
SIZE = 3
"""The least number of operations in an expression that is replaced by a variable."""
POINTS, FEWER = 60, 6
"""Points at which a claim that holds somewhere is tried."""
GRID = 96
"""Points of an interval at which a change of sign is looked for."""
INJECTIVE = ("log", "exp", "atanh", "tanh", "atan", "asinh", "sinh")
"""Functions that are applied to both sides of an equation."""
MEAN_VALUE = "intermediate value theorem, and monotony by the derivative"


def decide_compound(claim: Compound, check: Check) -> Answer:
    """Decide a claim that is made of others.

    Args:
        claim: the claim.
        check: decides a statement.
    """
    start = time.process_time()
    answer = _Deciding(claim, check).formula(claim.formula)
    return replace(
        answer,
        statement=" ".join(claim.text.split())[:400],
        given=chained(claim.given),
        read_as=str(claim),
        seconds=time.process_time() - start,
    )


_COMPARE: Mapping[str, Callable[[Any, Any], bool]] = {
    "<": operator.lt, "<=": operator.le, ">": operator.gt, ">=": operator.ge,
    "==": operator.eq, "!=": operator.ne,
}  # fmt: skip


class _Deciding:
    """Decides formulas by the dispatcher for comparisons."""

    def __init__(self, whole: Compound, check: Check) -> None:
        self.whole, self.check = whole, check

    def formula(self, formula: Formula) -> Answer:
        if isinstance(formula, Together):
            return self.together(formula)
        if isinstance(formula, Equivalent):
            return self.equivalent(formula)
        if isinstance(formula, Count):
            return self.count(formula)
        if isinstance(formula, Shape):
            return self.shape(formula)
        if isinstance(formula, Somewhere):
            return self.somewhere(formula)
        if isinstance(formula, Conserved):
            return decide_conserved(formula, self.asked)
        if isinstance(formula, Equilibrium):
            return decide_equilibrium(formula, self.asked)
        if isinstance(formula, Extremum):
            return decide_extremum(formula, self.asked)
        return self.check(statement_of(formula))

    def asked(self, link: Compared, given: Iterable[Compared], path: Path | None = None) -> Answer:
        """Decide a comparison under conditions; what cannot be stated is UNDECIDED."""
        numbers = path is None and not given and link[0].op == link[2].op == "number"
        if numbers and _COMPARE[link[1]](link[0].args[0], link[2].args[0]):
            return Answer(Verdict.PROVED, "these are numbers", read_as=chained((link,)))
        try:
            return self.check(statement_of(Written((link,), tuple(given), path)))
        except InputError as error:
            return Answer(UNDECIDED, str(error), read_as=chained((link,)))

    # A and B

    def together(self, formula: Together) -> Answer:
        answers = [self.formula(part) for part in formula.parts]
        weakest = worst(answers)
        if weakest:
            why = f"all {len(answers)} parts hold"
            reasons = dict.fromkeys(answer.why for answer in answers)
            why += f": {'; '.join(reasons)}" if len(reasons) < 3 else ""
            return Answer(weakest.verdict, why, obligations=tuple(map(_obligation, answers)))
        broken = answers.index(weakest)
        why = f"part {broken + 1}, {shown(formula.parts[broken], self.whole)}: {weakest.why}"
        return replace(weakest, why=why, obligations=tuple(map(_obligation, answers)))

    # A <=> B

    def equivalent(self, formula: Equivalent) -> Answer:
        answers = [self.pair(*pair) for pair in pairwise(formula.parts)]
        weakest = worst(answers)
        if len(answers) > 1 and not weakest:
            step = answers.index(weakest) + 1
            return replace(weakest, why=f"step {step} of {len(answers)}: {weakest.why}")
        if len(answers) == 1:
            return weakest
        obligations = tuple(part for answer in answers for part in answer.obligations)
        return replace(weakest, obligations=obligations)

    def pair(self, one: Formula, other: Formula) -> Answer:
        first, second = (
            tuple(link for leaf in leaves(part) if isinstance(leaf, Written) for link in leaf[0])
            for part in (one, other)
        )
        (leaf, *_) = (leaf for leaf in leaves(one) if isinstance(leaf, Written))
        given = leaf.given
        sides = [side for link in (*first, *second) for side in link[::2]]
        proved = None
        if len(first) == len(second) == 1 and first[0][1] == second[0][1] == "==":
            proved = self.by_a_factor(first[0], second[0], given)
        if proved is None:
            proved = self.for_every_value(first, second, given)
        if proved is None:
            ways = ((first, second), (second, first))
            both = [self.implied(*way, given) for way in ways]
            weakest = worst(both)
            if not weakest:
                a, b = ways[both.index(weakest)]
                why = f"{chained(b)} does not follow from {chained(a)}: {weakest.why}"
                return replace(weakest, why=why, obligations=tuple(map(_obligation, both)))
            why = f"each follows from the other: {both[0].why}; {both[1].why}"
            proved = Answer(weakest.verdict, why, obligations=tuple(map(_obligation, both)))
        if not _has_a_point(sides, given):
            why = f"no point was found at which both sides are defined ({proved.why})"
            return Answer(UNDECIDED, why)
        return proved

    def for_every_value(
        self, first: tuple[Compared, ...], second: tuple[Compared, ...], given: tuple[Compared, ...]
    ) -> Answer | None:
        """Prove an equivalence for every value of the expressions that both parts contain."""
        shared = _in_both(first, second)
        if not shared:
            return None
        taken = {*_taken((*first, *second, *given))}
        put: dict[Expr, Expr] = {}
        signs: list[Compared] = []
        for e in shared:
            name = fresh("u", taken)
            taken.add(name)
            put[e] = symbol(name)
            if self.asked((e, ">", ZERO), given):
                signs.append((symbol(name), ">", ZERO))
        one, other, where = (
            tuple((replaced(x, put), sign, replaced(y, put)) for x, sign, y in part)
            for part in (first, second, given)
        )
        answers = []
        for a, b in ((one, other), (other, one)):
            answers.append(self.implied(a, b, (*where, *signs)))
            if not answers[-1]:
                return None
        values = ", ".join(f"{name} = {e}" for e, name in put.items())
        why = f"each follows from the other for every value of {values}"
        obligations = tuple(map(_obligation, answers))
        return Answer(worst(answers).verdict, why, obligations=obligations)

    def implied(
        self, first: tuple[Compared, ...], second: tuple[Compared, ...], given: Iterable[Compared]
    ) -> Answer:
        """Decide what is claimed second where the first holds."""
        answers = []
        for link in second:
            found = self.asked(link, (*given, *first))
            if found.verdict is UNDECIDED and len(first) == 1:
                against = self.asked(_negated(first[0]), given)
                if against:
                    found = replace(against, why=f"{chained(first)} holds nowhere: {against.why}")
                elif first[0][1] != "!=" and link[1] != "!=":
                    other = self.asked(_negated(first[0]), (*given, _negated(link)))
                    found = other if other else found
            answers.append(found)
        return worst(answers)

    def by_a_factor(
        self, first: Compared, second: Compared, given: tuple[Compared, ...]
    ) -> Answer | None:
        """Prove that two equations have the same solutions by a factor without zeros."""
        sides = (*first[::2], *second[::2])
        links = (*given, *_needed(sides))
        where = Given(tuple(link for link in links if link[1] not in ("==", "in"))).unfolded()
        for a, b in _transformed(first, second):
            gaps = [x - y for x, _, y in (a, b)]
            if ZERO in gaps or not elementary(*gaps) or not all(map(symbols, gaps)):
                continue
            quotient = _factor(gaps[0], gaps[1], where)
            if quotient is None:
                continue
            asked = [
                ((gaps[0], "==", quotient * gaps[1]), given),
                ((quotient, "!=", ZERO), given),
            ]
            # A function of both sides is defined wherever the equation is, or else it loses points.
            for own, moved in ((first, a), (second, b)):
                if own != moved and any(
                    undefined(side, where, proof) is not None for side in moved[::2]
                ):
                    break
            else:
                if undefined(quotient, where, proof) is not None:
                    continue
                answers = [self.asked(*part) for part in asked]
                weakest = worst(answers)
                if weakest:
                    why = (
                        f"{_difference(a)} is {_difference(b)} times {quotient}, which has no zero"
                    )
                    obligations = tuple(map(_obligation, answers))
                    return Answer(weakest.verdict, why, obligations=obligations)
        return None

    # exactly one x in (a, b): f == g

    def count(self, claim: Count) -> Answer:
        left, _, right = claim.equation
        name = fresh(claim.name, _taken(claim.given, claim.low, claim.high))
        f = worked_out(substitute(left - right, {claim.name: symbol(name)}))
        if name not in symbols(f):
            return Answer(UNDECIDED, f"{claim.name} does not stand in the equation")
        if not elementary(f):
            return self.at_most_one_by_slope(claim, f, name)
        search = _Solutions(claim, f, name)
        if any(claim.closed):
            return self.on_closed(search)
        return self.between_the_ends(search)

    def at_most_one_by_slope(self, claim: Count, f: Expr, name: str) -> Answer:
        """Show that ``f``, with integrals, is strictly monotone: its derivative has one sign."""
        if claim.how != "at most one" or any(claim.closed):
            return Answer(UNDECIDED, "solutions are counted of elementary equations only")
        x, slope = symbol(name), derivative(f, name)
        ends = ((claim.low, "<", x), (x, "<", claim.high))
        finite = (link for link in ends if not symbols(link[0] - link[2]) & {INFINITY.args[0]})
        inside = (*claim.given, *finite)
        marks = {node: symbol(f"[{n}]") for n, node in enumerate(dict.fromkeys(outermost(f)))}
        gap = continuous_on(replaced(f, marks), Given(inside), proof)
        if gap is not None:
            return Answer(UNDECIDED, f"{gap} is not shown to be continuous")
        tried = []
        for sign in (">", "<"):
            found = self.asked((slope, sign, ZERO), inside)
            if found:
                return _by_lemma(MEAN_VALUE, [found])
            tried.append(found)
        return _not_shown(tried)

    def on_closed(self, search: _Solutions) -> Answer:
        """Count where an end belongs to the interval: it is a solution itself, or it is not."""
        claim = search.claim
        at_ends: list[Answer] = []
        found = 0
        for n, end in enumerate((claim.low, claim.high)):
            if not claim.closed[n]:
                continue
            value = substitute(search.f, {search.name: end})
            apart = self.asked((value, "!=", ZERO), claim.given)
            if apart:
                at_ends.append(apart)
                continue
            same = self.asked((value, "==", ZERO), claim.given)
            if not same or undefined(value, search.plain, proof) is not None:
                why = f"it is not shown whether the end {end} is a solution: {apart.why}"
                return _first(Answer(UNDECIDED, why), search.refuted_by_counting)
            at_ends.append(same)
            found += 1
        if found:
            return self.with_a_solution_at_an_end(search, at_ends, found)
        open_ = _Solutions(claim._replace(closed=(False, False)), search.f, search.name)
        return self.between_the_ends(open_)

    def with_a_solution_at_an_end(
        self, search: _Solutions, at_ends: list[Answer], found: int
    ) -> Answer:
        """Count where one end or both are solutions, if the interval contains them at all."""
        claim = search.claim
        asked: list[Answer] = []
        if found == 2 and claim.how != "at least one":  # two solutions, unless the ends coincide
            apart = self.asked((claim.low, "<", claim.high), claim.given)
            at = search.point_of_parameters() if apart else None
            if at is not None:
                return refuted("both ends are solutions", at)
            return _first(Answer(UNDECIDED, apart.why), search.refuted_by_counting)
        if not search.is_unbounded and claim.how != "at most one":
            sign = "<=" if all(claim.closed) else "<"
            asked.append(self.asked((claim.low, sign, claim.high), claim.given))
        if claim.how != "at least one":
            asked.append(self.asked((search.f, "!=", ZERO), search.inside))
        if not all(asked):
            return _first(_not_shown(asked), search.refuted_by_counting)
        shown_ = (*at_ends, *asked)
        why = "an end is a solution"
        why += "" if claim.how == "at least one" else ", and there is none between the ends"
        return Answer(worst(shown_).verdict, why, obligations=tuple(map(_obligation, shown_)))

    def between_the_ends(self, search: _Solutions) -> Answer:
        claim = search.claim
        wrong = search.refuted_by_counting()
        if wrong is not None:
            return wrong
        if search.gap is not None and claim.how != "at most one":
            why = f"it is not shown that both sides are smooth in the interval: {search.gap}"
            none = partial(self.none_between, search)
            beside = partial(self.none_beside, search)
            return _first(Answer(UNDECIDED, why), none, search.by_balls, beside)
        exists = self.signs_at_the_ends(search) if claim.how != "at most one" else []
        if claim.how == "at least one":
            if _all_hold(exists):
                return _by_lemma("intermediate value theorem", exists)
            ways = self.none_between, self.crossing, self.none_at_a_point
            return _first(_not_shown(exists), *(partial(way, search) for way in ways))
        only = self.only_one(search, _all_hold(exists))
        if _all_hold(only) and (_all_hold(exists) or claim.how == "at most one"):
            return _by_lemma(MEAN_VALUE, [*exists, *only])
        none = partial(self.none_between, search)
        none_at = partial(self.none_at_a_point, search)
        apart = partial(self.none_beside, search)
        return _first(_not_shown([*exists, *only]), none, search.by_balls, none_at, apart)

    def crossing(self, search: _Solutions) -> Answer | None:
        """Show that there is a solution by the signs at two points of the interval."""
        low, high = search.claim.low, search.claim.high
        if not search.parameters:
            found = search.solutions({})
            return Answer(Verdict.ENCLOSED, f"there is a solution {found[0]}") if found else None
        if search.is_unbounded:
            return None
        length = self.asked(search.length, search.claim.given)
        for part in (HALF, HALF * HALF, ONE - HALF * HALF) if length else ():
            middle = substitute(search.f, {search.name: low + (high - low) * part})
            for sign, other in (("<", ">"), (">", "<")):
                inner = self.asked((middle, sign, ZERO), search.claim.given)
                for n in (0, 1) if inner else ():
                    end = self.near_end(search, n, other)
                    if end:
                        return _by_lemma("intermediate value theorem", [length, inner, end])
        return None

    def none_between(self, search: _Solutions) -> Answer | None:
        """An answer where there is no solution at all."""
        found = self.asked((search.f, "!=", ZERO), search.inside)
        if not found or search.gap_of_definition() is not None:
            return None
        if search.claim.how == "at most one":
            return replace(found, why=f"there is no solution: {found.why}")
        at = search.point_of_parameters()
        return None if at is None else refuted(f"there is no solution: {found.why}", at)

    def none_beside(self, search: _Solutions) -> Answer | None:
        """Show that a rational solution is the only one, as where the graph touches the axis."""
        zero = search.rational_zero()
        if zero is None or search.gap_of_definition() is not None:
            return None
        x, at = symbol(search.name), number(zero)
        sides = [self.asked((search.f, "!=", ZERO), (*search.inside, (x, sign, at)))
                 for sign in ("<", ">")]  # fmt: skip
        if not all(sides):
            return None
        why = f"{search.claim.name} = {zero} is a solution, and there is none beside it"
        return Answer(worst(sides).verdict, why, obligations=tuple(map(_obligation, sides)))

    def none_at_a_point(self, search: _Solutions) -> Answer | None:
        """Refute that there is a solution at values of the parameters at which there is none."""
        if search.claim.how == "at most one" or not search.parameters:
            return None
        for at in islice(chain(search.special_points(), search.points_of_parameters()), PARAMETERS):
            put = {name: number(x) for name, x in at.items()}
            f = substitute(search.f, put)
            inside = tuple(
                (substitute(x, put), sign, substitute(y, put))
                for x, sign, y in search.inside
                if search.name in _taken(((x, sign, y),))
            )
            if undefined(f, Given(inside), proof) is None:
                found = self.asked((f, "!=", ZERO), inside)
                if found:
                    return refuted(f"there is no solution: {found.why}", at)
        return None

    def signs_at_the_ends(self, search: _Solutions) -> list[Answer]:
        """The obligations that the difference has opposite signs near the ends."""
        length = [] if search.is_unbounded else [self.has_length(search)]
        best: list[Answer] = []
        for signs in (("<", ">"), (">", "<")):
            if length and not length[0]:
                return length
            first = self.near_end(search, 0, signs[0])
            tried = [*length, first]
            if first:
                tried.append(self.near_end(search, 1, signs[1]))
                if all(tried):
                    return tried
            best = max(tried, best, key=lambda row: sum(map(bool, row)))
        return best

    def has_length(self, search: _Solutions) -> Answer:
        low, _, high = search.length
        if sign_of(high - low, search.plain, dear=False) == "+":
            return Answer(Verdict.PROVED, "by its sign", read_as=chained((search.length,)))
        return self.asked(search.length, search.claim.given)

    def near_end(self, search: _Solutions, n: int, sign: str) -> Answer:
        """Decide the sign near an end: of the value there, or in the limit."""
        claim, end = search.claim, (search.claim.low, search.claim.high)[n]
        given = claim.given
        if end in (INFINITY, -INFINITY):
            return self.asked((search.f, sign, ZERO), given, Path(search.name, None, (2 * n - 1,)))
        if search.reaches(n):
            found = self.asked((substitute(search.f, {search.name: end}), sign, ZERO), given)
            if found:
                return found
        return self.asked((search.f, sign, ZERO), given, Path(search.name, end, (1 - 2 * n,)))

    def only_one(self, search: _Solutions, crosses: bool) -> list[Answer]:
        """The obligation that there is one solution at most."""
        if search.gap is not None:
            why = f"it is not shown that both sides are smooth in the interval: {search.gap}"
            return [Answer(UNDECIDED, why)]
        slope = worked_out(derivative(search.f, search.name))
        tried = []
        # A derivative that is not negative will do where f is analytic and is not constant.
        for sign in (">=", "<=") if crosses else (">", "<"):
            found = self.asked((slope, sign, ZERO), search.inside)
            if found:
                return [found]
            tried.append(found)
        ends = symbols(search.claim.low) | symbols(search.claim.high)
        if not crosses and symbols(slope) == {search.name} and not ends - {INFINITY.args[0]}:
            where = Given(tuple(c for c in search.inside if search.name in _taken((c,))))
            for sign in (">=", "<="):
                found = self.asked((slope, sign, ZERO), where.comparisons)
                if found and self.is_nowhere_constant(slope, where, search.name):
                    return [found]
        curvature = worked_out(derivative(slope, search.name))
        for sign in (">=", "<=") if crosses else ():
            found = self.asked((curvature, sign, ZERO), search.inside)
            if found:
                return [found]
        return tried[:1]

    # at some point: f == g

    def somewhere(self, claim: Somewhere) -> Answer:
        """Find a point at which all comparisons hold, or show that one of them fails everywhere."""
        links, given, left = _with_values(claim)
        if left or any(sign == "in" for _, sign, _ in given):
            why = "points are sought where conditions are inequalities without integrals and roots"
            return Answer(UNDECIDED, why)
        where = Given(given).unfolded()
        names = sorted({n for link in links for side in link[::2] for n in symbols(side)})
        names = sorted({*names, *where.names} - {INFINITY.args[0]})
        found = _holds_at(_middles(where, names), links, where)
        for link in () if found else links:
            against = _over_boxes(_negated(link), given)
            if against:
                return _fails_everywhere(link, against)
        count = FEWER if any(e.hidden for link in links for e in link[::2]) else POINTS
        found = found or _holds_at(islice(where.points(names, count), count), links, where)
        if found:
            return found
        for link in links:
            against = self.asked(_negated(link), claim.given)
            if against:
                return _fails_everywhere(link, against)
            if against.verdict is Verdict.REFUTED and len(links) == 1:
                why = f"its opposite fails: {against.why}"
                return Answer(Verdict.PROVED, why, obligations=(_obligation(against),))
        return Answer(UNDECIDED, "no point was found at which it holds")

    # increasing(f, x)

    def shape(self, claim: Shape) -> Answer:
        f = worked_out(claim.function)
        by_slope = self.by_derivative(claim, f)
        if by_slope is not None and by_slope:
            return by_slope
        found = self.by_definition(claim, f)
        if found.verdict is UNDECIDED and by_slope is not None:
            return replace(by_slope, verdict=UNDECIDED, witness=None, values=None, cause=None)
        return found

    def by_derivative(self, claim: Shape, f: Expr) -> Answer | None:
        """Prove a shape by the sign of a derivative inside of an interval."""
        given = claim.given
        if claim.name not in symbols(f) or any(sign in ("==", "in") for _, sign, _ in given):
            return None
        if not elementary(f) or not _is_interval(claim):
            return None
        where = Given(given).unfolded()
        inside = tuple(map(_inner(claim.name), given))
        open_ = Given(inside).unfolded()
        curved = claim.how in ("convex", "concave")
        slope = worked_out(derivative(f, claim.name))
        slope = worked_out(derivative(slope, claim.name)) if curved else slope
        gap = undefined(f, where, proof) or continuous_on(f, open_, proof)
        if gap is not None or jumps((f,), where) or not elementary(slope):
            return None
        sign = ">=" if claim.how in ("increasing", "nondecreasing", "convex") else "<="
        weak = claim.how not in ("increasing", "decreasing")
        found = self.asked((slope, sign if weak else sign[0], ZERO), inside)
        name = "second derivative" if curved else "derivative"
        if not found and not weak and not symbols(f) - {claim.name}:
            # Zeros of the derivative of an analytic function that is not constant are isolated.
            again = self.asked((slope, sign, ZERO), inside)
            if again and self.is_nowhere_constant(slope, open_, claim.name):
                found = again
        if found:
            why = f"the sign of its {name}, {found.read_as}: {found.why}"
            lemma = "second derivative and convexity" if curved else "derivative and monotony"
            return Answer(found.verdict, why, lemma=lemma, obligations=(_obligation(found),))
        return Answer(UNDECIDED, f"its {name}: {found.why}", obligations=(_obligation(found),))

    def is_nowhere_constant(self, slope: Expr, given: Given, name: str) -> bool:
        with ball_precision():
            points = islice(given.points([name], 20), 20)
            return any(not evaluate(slope, point).contains(0) for point in points)

    def by_definition(self, claim: Shape, f: Expr) -> Answer:
        """Decide the inequality between values at two points that defines the shape."""
        taken = _taken(claim.given, f)
        one = fresh(f"{claim.name}_1", taken)
        two = fresh(f"{claim.name}_2", {*taken, one})
        places = ({claim.name: symbol(x)} for x in (one, two))
        given = [
            (substitute(left, put), sign, substitute(right, put))
            for put in places
            for left, sign, right in claim.given
        ]
        first, second = (substitute(f, {claim.name: symbol(x)}) for x in (one, two))
        order = (symbol(one), "<", symbol(two))
        curved = claim.how in ("convex", "concave")
        if curved and not _is_interval(claim):
            return Answer(UNDECIDED, f"{claim.how} is said of functions on an interval")
        if curved:
            middle = substitute(f, {claim.name: HALF * (symbol(one) + symbol(two))})
            first, second = middle, HALF * (first + second)
        sign = {"convex": "<=", "concave": ">=", "increasing": "<", "decreasing": ">",
                "nondecreasing": "<=", "nonincreasing": ">="}[claim.how]  # fmt: skip
        found = self.asked((first, sign, second), (*dict.fromkeys(given), order))
        where = Given(tuple(c for c in claim.given if c[1] not in ("==", "in")))
        if curved and found and (jumps((f,), Given()) or undefined(f, where, proof) is not None):
            return Answer(UNDECIDED, f"convexity is shown at midpoints only ({found.why})")
        why = found.why if not found else f"by its definition, {found.read_as}: {found.why}"
        return replace(found, why=why, obligations=(_obligation(found),))


class _Solutions:
    """An equation f = 0 in an interval, and what balls and the rules of domains say of it."""

    def __init__(self, claim: Count, f: Expr, name: str) -> None:
        self.claim, self.f, self.name = claim, f, name
        low, high = claim.low, claim.high
        links: list[Compared] = []
        if low != -INFINITY:
            links.append((symbol(name), ">", low))
        if high != INFINITY:
            links.append((symbol(name), "<", high))
        self.inside = (*claim.given, *links)
        self.is_unbounded = low == -INFINITY or high == INFINITY
        self.length = (low, "<", high)
        self.plain = Given(tuple(c for c in claim.given if c[1] not in ("==", "in"))).unfolded()
        self.gap = continuous_on(f, self.plain & Given(tuple(links)), proof)
        self.parameters = sorted((symbols(f) | symbols(low) | symbols(high) | self.plain.names)
                                 - {name, INFINITY.args[0]})  # fmt: skip

    def gap_of_definition(self) -> Expr | None:
        """A part of the equation that is not shown to be defined in the interval."""
        links = tuple(link for link in self.inside if link[1] not in ("==", "in"))
        return undefined(self.f, Given(links).unfolded(), proof)

    def reaches(self, n: int) -> bool:
        """Whether the difference is continuous up to an end."""
        end = (self.claim.low, self.claim.high)[n]
        value = substitute(self.f, {self.name: end})
        return undefined(value, self.plain, proof) is None and not jumps((self.f,), Given())

    def points_of_parameters(self) -> Iterator[dict[str, fmpq]]:
        """Yield points of the parameters at which the interval is not empty, where it is seen."""
        if any(sign in ("==", "in") for _, sign, _ in self.claim.given):
            return
        if not self.parameters:
            yield {}
            return
        for point in islice(self.plain.points(self.parameters, 4 * PARAMETERS), 4 * PARAMETERS):
            at = {n: fmpq(x) for n, x in point.items()}
            with ball_precision():
                ends = [_end_value(end, at) for end in (self.claim.low, self.claim.high)]
            if all(not isinstance(x, arb) or x.is_finite() for x in ends):
                yield at

    def point_of_parameters(self) -> dict[str, fmpq] | None:
        """A point of the parameters, at which a claim about all of them can be refuted."""
        return next(self.points_of_parameters(), None)

    def refuted_by_counting(self) -> Answer | None:
        """Refute a number of solutions by two of them, or by an interval without points."""
        how = self.claim.how
        for at in chain(self.special_points(), islice(self.points_of_parameters(), PARAMETERS)):
            if how != "at most one" and self.is_empty(at):
                return refuted("the interval is empty", at)
            found = [] if how == "at least one" else self.solutions(at)
            if len(found) > 1:
                return refuted(f"there are several solutions, {' and '.join(found)}", at)
        return None

    def special_points(self) -> Iterator[dict[str, fmpq]]:
        """Yield points at which all parameters are 0, 1 or −1, where the conditions allow it."""
        if any(sign in ("==", "in") for _, sign, _ in self.claim.given):
            return
        if not 0 < len(self.parameters) <= SEVERAL:
            return
        for values in product((0, 1, -1), repeat=len(self.parameters)):
            at = {name: fmpq(x) for name, x in zip(self.parameters, values, strict=True)}
            with ball_precision():
                holds = all(condition.holds_exactly(at) for condition in self.plain.conditions)
            if holds:
                yield at

    def is_empty(self, at: Mapping[str, fmpq]) -> bool:
        """Whether no number lies in the interval: its ends are in the wrong order, or coincide."""
        with ball_precision():
            low, high = (_end_value(end, at) for end in (self.claim.low, self.claim.high))
            if low is None or high is None:
                return False
            return bool(low > high or (low == high and not all(self.claim.closed)))

    def solutions(self, at: Mapping[str, fmpq]) -> list[str]:
        """Return where up to two different solutions lie at values of the parameters."""
        with ball_precision():
            low, high = (_end_value(end, at) for end in (self.claim.low, self.claim.high))
            if low is not None and high is not None and not low <= high:
                return []
            places = _places(low, high)
            places += [x for n, x in enumerate((low, high))
                       if self.claim.closed[n] and isinstance(x, fmpq)]  # fmt: skip
            signs: list[tuple[fmpq, int]] = []
            for x in sorted(set(places)):
                value = evaluate(self.f, {**at, self.name: x})
                if value > 0 or value < 0:
                    signs.append((x, 1 if value > 0 else -1))
                elif value.is_finite() and self.vanishes(x, at):
                    signs.append((x, 0))
        found: list[str] = []
        for (x, one), (y, other) in pairwise([*signs, *signs[-1:]]):
            if one == 0:
                found.append(f"at {self.claim.name} = {x}")
            elif one * other < 0 and self.is_continuous(x, y, at):
                found.append(f"between {x} and {y}")
            if len(found) == 2:
                break
        return found

    def rational_zero(self) -> fmpq | None:
        """A rational solution inside of the interval, of an equation without parameters."""
        if self.parameters or self.claim.given:
            return None
        with ball_precision():
            low, high = (_end_value(end, {}) for end in (self.claim.low, self.claim.high))
            places = _places(low, high)
        return next((x for x in places if self.vanishes(x, {})), None)

    def vanishes(self, x: fmpq, at: Mapping[str, fmpq]) -> bool:
        put = {n: number(v) for n, v in {**at, self.name: x}.items()}
        return is_zero(substitute(self.f, put), Given())

    def is_continuous(self, x: fmpq, y: fmpq, at: Mapping[str, fmpq]) -> bool:
        f = substitute(self.f, {n: number(v) for n, v in at.items()})
        there = symbol(self.name)
        between = Given(((there, ">=", number(x)), (there, "<=", number(y))))
        return continuous_on(f, between, proof) is None

    def by_balls(self) -> Answer | None:
        """Count by balls where there are no parameters."""
        if self.parameters or self.claim.given:
            return None
        node = Expr("root", (bind(self.f, (self.name,)), self.claim.low, self.claim.high),
                    (self.name,))  # fmt: skip
        try:
            with ball_precision():
                value = enclosed(node, {})
        except InputError:
            return None
        if not value.is_finite():
            return None
        near = value.str(6, radius=False)
        why = f"balls show that there is one solution and no other, near {near}"
        return Answer(Verdict.ENCLOSED, why)


def _holds_at(
    points: Iterable[Mapping[str, Any]], links: Sequence[Compared], where: Given
) -> Answer | None:
    """The first of several points at which all comparisons hold."""
    for point in points:
        at = {name: fmpq(x) for name, x in point.items()}
        with ball_precision():
            inside = all(c.holds_exactly(at) for c in where.conditions)
            values = [enclosed(x - y, at) for x, _, y in links] if inside else []
        if inside and all(map(partial(_stands_at, at), links, values)):
            shown_at = ", ".join(f"{name} = {x}" for name, x in at.items())
            return Answer(Verdict.ENCLOSED, f"it holds at {shown_at}" if shown_at else "it holds")
    return None


def _fails_everywhere(link: Compared, against: Answer) -> Answer:
    why = f"{chained((link,))} fails everywhere: {against.why}"
    return replace(refuted(why, {}), obligations=(_obligation(against),))


def _over_boxes(link: Compared, given: tuple[Compared, ...]) -> Answer | None:
    """An answer by balls over the ranges of the variables, where a few parts of them suffice."""
    statement = statement_of(Written((link,), given, None))
    (comparison,) = statement.comparisons
    nodes = root_nodes(comparison.left, comparison.right)
    found = decide_over_boxes(comparison, statement, nodes, FEW)
    return None if found is None else replace(found, read_as=statement.read_as)


def _with_values(
    claim: Somewhere,
) -> tuple[tuple[Compared, ...], tuple[Compared, ...], list[Compared]]:
    """The comparisons and conditions with the values of equations ``x == …`` put in, and others."""
    links, given = claim.comparisons, claim.given
    for _ in claim.given:
        known = next(
            ((x, y) for x, sign, y in given if sign == "==" and x.op == "symbol"
             and x.args[0] not in symbols(y)), None
        )  # fmt: skip
        if known is None:
            break
        put = {known[0].args[0]: known[1]}
        links, given = (
            tuple((substitute(x, put), sign, substitute(y, put)) for x, sign, y in part)
            for part in (links, given)
        )
        given = tuple(link for link in given if link[0] != link[2])
    sides = [side for link in links for side in link[::2]]
    given = (*given, *_needed(sides))
    left = [link for link in given if link[1] == "==" or not elementary(link[0], link[2])]
    return links, given, left


def _needed(sides: Iterable[Expr]) -> tuple[Compared, ...]:
    """What must hold for the sides to be defined, of their elementary parts."""
    found = (part for part in needs(sides) if elementary(part[0]) and not part[0].loose)
    return tuple(bound(*part) for part in found if symbols(part[0]))


def _middles(where: Given, names: Sequence[str]) -> Iterator[dict[str, fmpq]]:
    """Yield the middle of the ranges of all variables, if they are bounded."""
    box = [where.box.get(name) for name in names]
    if all(side is not None and None not in (side.low, side.high) for side in box):
        yield {n: side.middle for n, side in zip(names, box, strict=True) if side is not None}


def _stands_at(at: Mapping[str, fmpq], link: Compared, value: arb) -> bool:
    """Whether a comparison holds at a point; an equation exactly."""
    if not value.is_finite():
        return False
    if link[1] in ("==", "<=", ">=") and value.contains(0):
        put = {name: number(x) for name, x in at.items()}
        return is_zero(substitute(link[0] - link[2], put), Given())
    return stands(value, link[1])


def _end_value(end: Expr, at: Mapping[str, fmpq]) -> fmpq | arb | None:
    """An end of an interval: exact where it is rational, None where it is infinite."""
    if end in (INFINITY, -INFINITY):
        return None
    value = substitute(end, {n: number(v) for n, v in at.items()})
    if value.op == "number":
        return value.args[0]
    return evaluate(end, at)


def _places(low: fmpq | arb | None, high: fmpq | arb | None) -> list[fmpq]:
    """Rational points strictly inside of an interval, some of them near its ends."""
    first, last = (_rational(x) for x in (low, high))
    if first is not None and last is not None:
        if not first < last:
            return []
        part = (last - first) / GRID
        inner = [first + part * n for n in range(1, GRID)]
        inner += [first + part / 2**k for k in (2, 5, 9)] + [last - part / 2**k for k in (2, 5, 9)]
        whole = [fmpq(n) for n in range(-20, 21) if first < n < last]
    else:
        start = first if first is not None else last if last is not None else fmpq(0)
        steps = [fmpq(n, 8) for n in range(1, 64)] + [fmpq(2**k) for k in range(3, 12)]
        steps += [fmpq(1, 2**k) for k in range(4, 12)]
        up = [start + x for x in steps] if last is None else []
        down = [start - x for x in steps] if first is None else []
        inner = up + down + ([start] if first is last is None else [])
        whole = [
            fmpq(n)
            for n in range(-20, 21)
            if (first is None or n > first) and (last is None or n < last)
        ]
    found = inner + whole
    with ball_precision():
        return [x for x in found if (low is None or x > low) and (high is None or x < high)]


def _rational(x: fmpq | arb | None) -> fmpq | None:
    if x is None or isinstance(x, fmpq):
        return x
    return fmpq(int((x.mid() * 1024).fmpq().floor()), 1024) if x.is_finite() else None


def _all_hold(answers: Sequence[Answer]) -> bool:
    """Whether there are obligations, and all of them hold."""
    return bool(answers) and all(answers)


def _first(otherwise: Answer, *ways: Callable[[], Answer | None]) -> Answer:
    """Return the first answer that is found, a refutation as well as a proof."""
    found = (way() for way in ways)
    return next((answer for answer in found if answer is not None), otherwise)


def _not_shown(answers: Sequence[Answer]) -> Answer:
    """What is missing of the obligations of a lemma, which refutes nothing."""
    broken = worst(answers)
    why = f"not shown: {broken.read_as} ({broken.why})" if broken.read_as else broken.why
    return Answer(UNDECIDED, why, obligations=tuple(map(_obligation, answers)))


def _by_lemma(lemma: str, answers: Sequence[Answer]) -> Answer:
    weakest = worst(answers)
    why = "; ".join(dict.fromkeys(answer.read_as for answer in answers))
    return Answer(
        weakest.verdict, f"by {why}", lemma=lemma, obligations=tuple(map(_obligation, answers))
    )


def _obligation(answer: Answer) -> Obligation:
    claim, _, given = answer.read_as.partition(" given ")
    given, _, path = given.partition(" as ")
    return Obligation(claim + (f" as {path}" if path else ""), given, answer.verdict.value)


def _negated(link: Compared) -> Compared:
    return link[0], NEGATED[link[1]], link[2]


def _difference(link: Compared) -> str:
    return f"{link[0]} - ({link[2]})"


def _taken(given: Iterable[Compared], *trees: Expr) -> frozenset[str]:
    sides = (side for link in given for side in link[::2])
    return frozenset().union(*map(symbols, (*sides, *trees)))


def _has_a_point(sides: Sequence[Expr], given: Sequence[Compared]) -> bool:
    """Whether a point of the conditions is found at which all sides are defined."""
    if not elementary(*sides):
        return True  # the parts are decided by procedures that look for such a point
    integers = [str(x.args[0]) for x, sign, _ in given if sign == "in"]
    links = [link for link in given if link[1] != "in"]
    if not any(map(symbols, sides)) and not links:
        with ball_precision():
            return all(evaluate(side, {}).is_finite() for side in sides)
    return somewhere(sides, links, integers)


def _in_both(first: Iterable[Compared], second: Iterable[Compared]) -> list[Expr]:
    """The largest expressions that stand in both of two formulas, not only as a power."""

    def inner(links: Iterable[Compared]) -> dict[Expr, None]:
        found = operations([side for link in links for side in link[::2]])
        return {e: None for e in found if symbols(e) and not e.loose and elementary(e)}

    also = inner(second)  # in the order of the first formula, which is the same in every run
    both = [e for e in inner(first) if e in also and len(list(operations((e,)))) >= SIZE]
    return [e for e in both if not any(e != f and e in set(operations((f,))) for f in both)]


def _transformed(first: Compared, second: Compared) -> Iterator[tuple[Compared, Compared]]:
    """Yield two equations, and with an injective function applied to both sides of one of them."""
    yield first, second
    for op in INJECTIVE:
        yield (apply(op, first[0]), "==", apply(op, first[2])), second
        yield first, (apply(op, second[0]), "==", apply(op, second[2]))


def _factor(f: Expr, g: Expr, given: Given) -> Expr | None:
    """Return f/g if it is simple: a quotient in lowest terms, or a number at several points."""
    names = sorted(symbols(f) | symbols(g))
    ratios = []
    with ball_precision():
        for point in islice(given.points(names, 12), 12):
            above, below = evaluate(f, point), evaluate(g, point)
            if above.is_finite() and below.is_finite() and (below > 0 or below < 0):
                ratios.append(above / below)
            if len(ratios) == 3:
                break
        if len(ratios) < 2:
            return None
        middle = ratios[0]
        for bottom in (1, 2, 3, 4):
            scaled = (middle * bottom).unique_fmpz()
            if scaled is not None and scaled != 0:
                value = fmpq(int(scaled), bottom)
                if all((ratio - value).contains(0) for ratio in ratios):
                    return number(value)
            near = round(float(middle.mid()) * bottom) if abs(float(middle.mid())) < 1e6 else 0
            if near and all((ratio - fmpq(near, bottom)).contains(0) for ratio in ratios):
                return number(fmpq(near, bottom))
    quotient = in_lowest_terms(f / g)
    return None if quotient == f / g else quotient


def _is_interval(claim: Shape) -> bool:
    """Whether the values of the variable form an interval, for all values of the others."""
    x = symbol(claim.name)
    for left, sign, right in Given(claim.given).unfolded().comparisons:
        if claim.name not in symbols(left) | symbols(right):
            continue
        sides = (left, right) if left == x else (right, left)
        if sides[0] != x or claim.name in symbols(sides[1]) or sign not in ("<", "<=", ">", ">="):
            return False
    return True


def _inner(name: str) -> Callable[[Compared], Compared]:
    """Conditions on the variable without the ends of its interval."""

    def strictly(link: Compared) -> Compared:
        left, sign, right = link
        about = name in symbols(left) | symbols(right)
        return (left, sign[0], right) if about and sign in ("<=", ">=") else link

    return strictly
