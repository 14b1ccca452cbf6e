"""Decide a claim along a path about integrals, sums and factorials by lemmas on them.

Each integral, sum or factorial f is replaced by an explicit A with |f − A| ≤ C g, by the first
lemma of :data:`LEMMAS` that applies, and the errors are carried through the claim
(approximation.py). So its left side is A + O(g), and

- if g = O(right), the left side is O(right) just if A is; so for o and Θ with g = o(right);
- if g = o(A), the left side satisfies any order, limit or sign just if A does.

The order of the expansions is raised until one of these settles the claim; then the lemmas prove
their obligations, and the dispatcher decides the explicit claim that is left, either way: what
refutes a claim is the coefficient that is true. ``f ~ a + b`` asserts every term: the difference is
o of the smallest.

Example: ``integral(exp(-x*t)/(1+t), t, 0, oo) == 1/x + 1/x**2 + O(1/x**3)`` is refuted, since the
left side minus the printed terms is −2/x² + O(1/x³).
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import replace
from functools import partial
from math import factorial

from flint import arb, fmpq

from tresym.asymptotics.approximation import Approximation, approximated
from tresym.asymptotics.lemma import (
    Bound,
    End,
    Expansion,
    Obligations,
    exact_upper,
    folded,
    smallest,
)
from tresym.asymptotics.order_claims import region as region_of
from tresym.asymptotics.rational_functions import over, roots_of
from tresym.reals.decisions.answer import Answer, Decide, worst
from tresym.reals.decisions.hypergeometric import OpenError, polynomial
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import is_infinite, outermost, total
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    number,
    opened,
    rebuild,
    replaced,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import in_lowest_terms
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Decimal, InputError, decimal_above, parse_number
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

MOST = 6
"""The orders that are tried."""
LARGEST = 200
"""The largest integer whose factorial is put in."""
MOST_FAILURES = 2
"""Orders at which a lemma is not proved, after which no further one is tried."""
WAVES = frozenset(("sin", "cos", "tan", "cot", "sec", "csc"))
_INFINITE = (INFINITY, -INFINITY)
Lemma = Callable[[Expr, End], Expansion | None]


def _laplace(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.laplace import laplace

    return laplace(node, end) if node.op == "integral" else None


def _stirling(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.stirling import stirling

    return stirling(node, end)


def _euler_maclaurin(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.euler_maclaurin import euler_maclaurin

    return euler_maclaurin(node, end)


def _alternating(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.alternating_sums import alternating_sum

    return alternating_sum(node, end)


def _regular_parameter(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.regular_parameter import regular_parameter

    return regular_parameter(node, end)


def _stationary_phase(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.stationary_phase import stationary_phase

    return stationary_phase(node, end)


def _complement(node: Expr, end: End) -> Expansion | None:
    """Return a known integral to infinity less the expansion of what is beyond the end."""
    from tresym.asymptotics.complement import complement

    return complement(node, end, (_laplace, _stationary_phase))


def _coefficients(node: Expr, end: End) -> Expansion | None:
    from tresym.asymptotics.coefficients import coefficients

    return coefficients(node, end) if node.op == "coefficient" else None


LEMMAS: tuple[Lemma, ...] = (
    _coefficients,
    _complement,
    _laplace,
    _stirling,
    _alternating,
    _euler_maclaurin,
    _stationary_phase,
    _regular_parameter,
)
"""The lemmas in the order in which they are tried; each applies to its own shape."""


def decide_by_lemmas(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim with integrals, sums or factorials along a path.

    Args:
        decided: decides explicit claims.
    """
    path = statement.path
    if path is None:
        raise TypeError("a claim along a path needs its path")
    if claim.derivatives or statement.equations:
        return Answer(Verdict.UNDECIDED, "no lemma supports derivatives or equations here")
    found = []
    for side in path.sides:
        along = replace(statement, path=replace(path, sides=(side,)))
        found.append(_on_one_side(claim, along, decided))
        if found[-1].verdict is not Verdict.REFUTED and not found[-1]:
            break
        if found[-1].verdict is Verdict.REFUTED:
            return found[-1]
    answer = worst(found)
    return _on_both_sides(answer, found, path) if len(path.sides) > 1 and answer else answer


def _on_both_sides(answer: Answer, found: Sequence[Answer], path: Path) -> Answer:
    """Return the answer with the larger constant of both sides, and the region where both hold."""
    regions = [(one.region or "").replace("-", "") for one in found]
    bare = replace(answer, region=None, constant=None, uniform=None)
    if path.point is None or not all(" <= " in region for region in regions):
        return bare
    balls = [one.constant for one in found if one.constant is not None]
    if len(balls) < len(found):
        return bare
    largest = max(balls, key=lambda ball: parse_number(ball.mid) + parse_number(ball.rad))
    reach = min(parse_number(region.split()[-1]) for region in regions)
    uniform = True if all(one.uniform is True for one in found) else None
    return replace(bare, region=region_of(path, reach), constant=largest, uniform=uniform)


def _on_one_side(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide by expansions, or else by the variable ends of integrals and sums."""
    from tresym.asymptotics.variable_end import decide_variable_end

    found = _Claim(claim, statement, decided).answer()
    if found.verdict is not Verdict.UNDECIDED:
        return found
    other = decide_variable_end(claim, statement, decided)
    return found if other is None or other.verdict is Verdict.UNDECIDED else other


def _without_fixed(e: Expr) -> Expr:
    """Return ``e`` with the values of factorials of integers."""
    fixed = {}
    for node in outermost(e):
        n = integer(node.args[-1]) if node.op == "unknown" else None
        if n is not None and 0 <= n <= LARGEST and node.args[0].args == (FACTORIAL, (0,)):
            fixed[node] = number(factorial(n))
    return replaced(e, fixed) if fixed else e


def _logarithms(e: Expr, given: Given) -> Expr:
    """Return ``e`` with exp of the sum of logarithms for products of positive factors."""
    if not e.hidden or e.op in LEAVES:
        return e
    if e.op == "product" and not is_infinite(e):
        (k,), body = opened(e, given.names)
        low, high = e.args[1:]
        inside = given & Given(((symbol(k), ">=", low),))
        if not body.hidden and sign(body, inside) == "+":
            parts = (total("sum", part, k, low, high) for part in _log_terms(body, k, inside))
            return apply("exp", add(ZERO, *parts))
        return e
    if e.names or e.op == "unknown":
        return e
    return rebuild(e, tuple(_logarithms(arg, given) for arg in e.args))


def _log_terms(e: Expr, k: str, inside: Given) -> list[Expr]:
    """Return terms whose sum is log e: of positive linear factors, where ``e`` has such factors."""
    try:
        form = in_lowest_terms(e)
        above, below = (polynomial(part, k) for part in over(form))
    except (InputError, OpenError, ZeroDivisionError):
        return [apply("log", e)]
    terms: list[Expr] = []
    scale = fmpq(1)
    for p, side in ((above, 1), (below, -1)):
        for root, times in roots_of(p):
            factor = symbol(k) - number(root)
            if sign(factor, inside) != "+":
                return [apply("log", e)]
            terms.append(number(side * times) * apply("log", factor))
        if sum(times for _, times in roots_of(p)) != p.degree():
            return [apply("log", e)]
        scale = scale * p[p.degree()] if side > 0 else scale / p[p.degree()]
    if scale != 1:
        terms.append(apply("log", number(scale)))
    return terms or [ZERO]


def decide_with_expansions(
    claim: Comparison, statement: Statement, decided: Decide, expansions: Mapping[Expr, Expansion]
) -> Answer:
    """Decide a claim on one side of its path in which the expansions of some nodes are known.

    Args:
        claim: the comparison.
        statement: its conditions, without any on these nodes.
        decided: decides explicit claims.
        expansions: variables or other nodes with their expansions.
    """
    given = statement.given
    if given.comparisons and given.satisfying_point(sorted(given.names)) is None:
        why = "no values of the parameters were found that satisfy the conditions; check them"
        return Answer(Verdict.UNDECIDED, why)
    return _Claim(claim, statement, decided, expansions).answer()


def approximations(e: Expr, statement: Statement, decided: Decide) -> Iterator[tuple[Expr, Expr]]:
    """Yield longer and longer explicit approximations of an expression, each with its error.

    Args:
        e: an expression with integrals, sums or factorials.
        statement: the conditions and a path on one side.
        decided: decides explicit claims.
    """
    claim = _Claim(Comparison(e, "O", ONE), statement, decided)
    for node in dict.fromkeys(outermost(claim.claim.left)):
        found = claim._expansion(node)
        if found is None or found.unknown:
            return
        claim.expansions[node] = found
    for order in range(1, MOST + 1):
        known = claim._terms(order)
        whole = None if known is None else approximated(claim.claim.left, known, claim.end)
        if whole is None:
            return
        yield whole.main, whole.error


class _Claim:
    """A claim on one side of its path."""

    def __init__(
        self,
        claim: Comparison,
        statement: Statement,
        decided: Decide,
        expansions: Mapping[Expr, Expansion] | None = None,
    ) -> None:
        claim = claim.mapped(_without_fixed).mapped(partial(_logarithms, given=statement.given))
        self.claim, self.statement, self.decided = claim, statement, decided
        path = statement.path
        assert path is not None
        self.path: Path = path
        names = symbols(claim.left) | symbols(claim.right)
        given = statement.given
        for known in (expansions or {}).values():
            given, names = given & known.constants, names | known.unknown
        self.end = End(path.name, path.point, path.sides[0], given, names)
        self.expansions: dict[Expr, Expansion] = dict(expansions or {})
        self.names = frozenset(str(e.args[0]) for e in self.expansions if e.op == "symbol")
        self.claim = self.claim.mapped(self._with_ordered_ends)

    def _with_ordered_ends(self, e: Expr) -> Expr:
        """Return ``e`` with integrals upwards: those from a larger to a smaller end change sign."""
        known = {}
        for node in outermost(e):
            if node.op == "integral" and self._is_ordered(node.args[2], node.args[1]):
                known[node] = -rebuild(node, (node.args[0], *node.args[:0:-1]))
        return replaced(e, known) if known else e

    def _is_ordered(self, low: Expr, high: Expr) -> bool:
        from tresym.asymptotics.variable_end import near_the_end, sign_between

        return any(sign_between(low, high, near) for near in near_the_end(self.end))

    def answer(self) -> Answer:
        """Return the verdict."""
        sides = [e for e in (self.claim.left, self.claim.right) if e not in _INFINITE]
        nodes = dict.fromkeys(node for e in sides for node in outermost(e))
        for node in nodes:
            if node in self.expansions:
                continue
            found = self._expansion(node)
            if found is None:
                return Answer(Verdict.UNDECIDED, f"no lemma expands {node} as {self.path}")
            self.expansions[node] = found
            given = self.end.given & found.constants
            self.end = self.end._replace(given=given, names=self.end.names | found.unknown)
        why = "the expansions are not long enough to settle the claim"
        failures = 0
        for order in range(1, MOST + 1):
            known = self._terms(order)
            if known is None:
                break
            settled = self._settled(known)
            if settled is None:
                continue
            answer = self._proved(order, known, settled)
            if answer.verdict is not Verdict.UNDECIDED:
                return answer
            why = answer.why
            failures += 1
            if failures == MOST_FAILURES:
                break
        return Answer(Verdict.UNDECIDED, why)

    def _expansion(self, node: Expr) -> Expansion | None:
        if self.path.name not in symbols(node):
            return None
        if node.op == "integral" and not self._is_ordered(*node.args[1:]):
            return None  # a lemma that looks between its ends would look nowhere
        for lemma in LEMMAS:
            found = lemma(node, self.end)
            if found is not None:
                return found
        return None

    def _terms(self, order: int) -> dict[Expr, Approximation] | None:
        known = {}
        for node, expansion in self.expansions.items():
            found = expansion.terms(order)
            if found is None:
                return None
            main, error = map(folded, found)
            known[node] = Approximation(main, error, expansion.is_little_o)
        return known

    def _settled(self, known: dict[Expr, Approximation]) -> tuple[Comparison, Expr] | None:
        """Return an explicit claim that is equivalent, and the error of its left side; or None."""
        left, relation, right = self.claim.left, self.claim.relation, self.claim.right
        if relation == "~":
            return self._equivalence(known)
        if relation in ("<", "<=", ">", ">=", "!="):
            left, right = left - right, ZERO
        if relation == LIMIT and right not in _INFINITE:
            left, right, relation = left - right, ONE, "o"
        f = approximated(left, known, self.end)
        g = Approximation(right, ZERO)
        if right not in _INFINITE and self._unknown(right):
            found = approximated(right, known, self.end)
            if found is None or not self._is_small(found, found.main):
                return None
            g = found
        if f is None:
            return None
        return self._equivalent(f, relation, g.main)

    def _equivalence(self, known: dict[Expr, Approximation]) -> tuple[Comparison, Expr] | None:
        """``f ~ a + b`` as f − a − b = o(the smallest of the terms)."""
        right = approximated(self.claim.right, known, self.end)
        f = approximated(self.claim.left - self.claim.right, known, self.end)
        if right is None or f is None:
            return None
        explicit = not self._unknown(self.claim.right)
        least = smallest(self.claim.right, self.end) if explicit else None
        if least is None:
            if not self._is_small(right, right.main):
                return None
            least = right.main
        return self._equivalent(f, "o", least)

    def _equivalent(
        self, f: Approximation, relation: str, gauge: Expr
    ) -> tuple[Comparison, Expr] | None:
        plain = Comparison(f.main, relation, gauge)
        if f.error == ZERO:
            return plain, ZERO
        if relation in ("O", "o", "Theta", "omega"):
            part = self.end.limit(f.error / gauge)
            small = part == ZERO or (f.small and part not in (None, *_INFINITE))
            if small or (relation in ("O", "omega") and part not in (None, *_INFINITE)):
                return plain, f.error
        if relation == LIMIT and self.end.limit(f.error) not in (None, *_INFINITE):
            return plain, f.error
        if self._is_small(f, f.main):
            return plain, f.error
        return None

    def _unknown(self, e: Expr) -> bool:
        """Return whether an expression is not explicit."""
        return e.hidden or bool(self.names & symbols(e))

    def _is_small(self, f: Approximation, beside: Expr) -> bool:
        """Return whether the error of an approximation is o(``beside``)."""
        part = self.end.limit(f.error / beside)
        return part == ZERO or (f.small and part not in (None, *_INFINITE))

    def _proved(
        self, order: int, known: dict[Expr, Approximation], settled: tuple[Comparison, Expr]
    ) -> Answer:
        explicit, _ = settled
        ask = Obligations(self.statement, self.decided)
        bounds: dict[Expr, Bound] = {}
        said = []
        for node, expansion in self.expansions.items():
            bound = expansion.prove(order, ask)
            if bound is None:
                missing = ask.missing or "a condition of the theorem"
                why = f"by {expansion.lemma}, but this could not be proved: {missing}"
                return Answer(Verdict.UNDECIDED, why)
            bounds[node] = bound
            said.append(_sentence(node, known[node], bound, self.path))
        lemma = "; ".join(dict.fromkeys(e.lemma for e in self.expansions.values()))
        exact = self._is_zero(explicit.left)
        if exact and explicit.relation in ("O", "o"):
            answer = Answer(Verdict.PROVED, "what is left is 0")
        else:
            answer = self._explicit(ask, explicit)
        if answer.verdict is Verdict.UNDECIDED:
            left = f"{explicit.left} {explicit.relation} {explicit.right}"
            why = f"by {lemma}, what is left could not be decided: {left}: {answer.why}"
            return Answer(Verdict.UNDECIDED, why)
        main = [part for part in ask.found if " <= " in part.claim] or ask.found
        why = f"by {lemma}: {'; '.join([*map(str, main[:1]), *said])}"
        constants = frozenset().union(*(e.unknown for e in self.expansions.values()))
        names = symbols(explicit.left) | symbols(explicit.right)
        if answer.verdict is Verdict.REFUTED and constants & names:
            witness = {n: v for n, v in (answer.witness or {}).items() if n not in constants}
            answer = replace(answer, witness=witness)
            if not self._fails_always(explicit):
                why = f"by {lemma}, but it depends on the value of a constant: {'; '.join(said)}"
                return Answer(Verdict.UNDECIDED, why)
        if answer.verdict is Verdict.REFUTED:
            why = f"by {lemma}: {'; '.join(said)}; what is left is false: {answer.why}"
            return replace(answer, why=why, lemma=lemma, obligations=tuple(ask.found), values=None)
        verdict = (
            Verdict.PROVED if ask.verdict is answer.verdict is Verdict.PROVED else Verdict.ENCLOSED
        )
        constant, where = None, None
        names = symbols(self.claim.left) | symbols(self.claim.right)
        free = bool(names - {self.path.name, INFINITY.args[0], *self.names})
        asked = not free or self.statement.uniformly
        if asked and self.claim.relation == "O" and explicit.relation == "O":
            constant, where = self._constant(bounds, known, explicit, answer, exact)
        return Answer(
            verdict,
            why,
            lemma=lemma,
            obligations=tuple(ask.found),
            constant=constant,
            region=where,
            uniform=True if free and constant is not None else None,
        )

    def _explicit(self, ask: Obligations, claim: Comparison) -> Answer:
        """Decide what is left, for real values where nothing depends on integers."""
        whole = [
            n for n in self.statement.integers if n in symbols(claim.left) | symbols(claim.right)
        ]
        given = self.end.given
        left, right = claim.left, claim.right
        answer = ask.ask(left, claim.relation, right, given, self.path)
        waves = any(
            e.op in ("sin", "cos", "tan", "cot", "sec", "csc")
            or (e.op == "^" and e.args[0].op == "number")
            for e in operations((left, right))
        )
        if whole and not answer and (waves or answer.verdict is Verdict.UNDECIDED):
            answer = ask.ask(left, claim.relation, right, given, self.path, whole)
        return answer

    def _fails_always(self, claim: Comparison) -> bool:
        """Return whether a claim fails for all values that the constants may have."""
        given, end = self.end.given, self.end
        if claim.relation in ("<", "<=", ">", ">="):
            return self._fails_by_sign(claim)
        if claim.relation not in ("O", "o", "Theta"):
            return False
        last = end.limit(claim.left / claim.right)
        if last is None or claim.relation != "o":
            return last in _INFINITE
        return last in _INFINITE or sign(last, given, "!=") in PROVING["!="]

    def _fails_by_sign(self, claim: Comparison) -> bool:
        last = self.end.limit(claim.left - claim.right)
        if last is None:
            return False
        wrong = 1 if claim.relation[0] == "<" else -1
        if last in _INFINITE:
            return last == wrong * INFINITY
        return sign(wrong * last, self.end.given) == "+"

    def _is_zero(self, e: Expr) -> bool:
        x, side = symbol(self.path.name), self.path.sides[0]
        start = self.path.point if self.path.point is not None else ZERO
        near = Given(((x, ">" if side > 0 else "<", start),))
        try:
            return decide(e, ZERO, self.statement.given & near).verdict is Verdict.PROVED
        except InputError:
            return False

    def _constant(
        self,
        bounds: dict[Expr, Bound],
        known: dict[Expr, Approximation],
        explicit: Comparison,
        answer: Answer,
        exact: bool,
    ) -> tuple[Decimal | None, str | None]:
        """Return C with |left| ≤ C |right| and where, if the claim is linear in its integrals.

        With parameters C serves for all of their values.
        """
        if any(bound.constant is None for bound in bounds.values()):
            return None, None
        own = {self.path.name, INFINITY.args[0]}
        if any(symbols(node) - own and not bound.uniform for node, bound in bounds.items()):
            return None, None
        shown = (symbols(explicit.left) | symbols(explicit.right)) - own
        if shown and not exact and answer.uniform is not True:
            return None, None
        total, reach = arb(0), [bound.upto for bound in bounds.values()]
        with ball_precision():
            if not exact:
                if answer.constant is None or answer.region is None:
                    return None, None
                total += _ball(answer.constant)
                reach.append(_reach(answer.region, self.path))
            for node, bound in bounds.items():
                factor = _coefficient(self.claim.left, node)
                if factor is None or known[node].error == ZERO:
                    if factor is None:
                        return None, None
                    continue
                gauge = number(bound.constant or fmpq(0)) * factor * known[node].error
                share = self._ratio(gauge, explicit.right)
                if share is None:
                    return None, None
                total += share[0]
                reach.append(share[1])
            limits = [r for r in reach if r is not None]
            constant = Decimal(decimal_above(exact_upper(total), 6), "0")
        return constant, region_of(self.path, min(limits)) if limits else f"{self.path.name} > 0"

    def _ratio(self, above: Expr, below: Expr) -> tuple[arb, fmpq | None] | None:
        """Return the supremum of |above/below| and where."""
        x = symbol(self.path.name)
        last = self.end.limit(abs(above / below))
        free = (symbols(above) | symbols(below)) - {self.path.name}
        if last is None or last in _INFINITE or (symbols(last) and not free):
            return None
        if free:
            statement = replace(self.statement, integers=(), equations=(), path=self.path)
            answer = self.decided(Comparison(above, "O", below), statement)
            if not answer or not answer.constant or not answer.region or answer.uniform is not True:
                return None
            return _ball(answer.constant), _reach(answer.region, self.path)
        if (
            decide(abs(above), last * abs(below), Given(((x, ">", ZERO),))).verdict
            is Verdict.PROVED
        ):
            return evaluate(last, {}), None
        statement = replace(self.statement, integers=(), equations=())
        answer = self.decided(Comparison(above, "O", below), statement)
        if not answer or answer.constant is None or answer.region is None:
            return None
        return _ball(answer.constant), _reach(answer.region, self.path)


def _ball(x: Decimal) -> arb:
    return arb(parse_number(x.mid)) + arb(parse_number(x.rad))


def _reach(text: str, path: Path) -> fmpq | None:
    """Return the largest small parameter of a region as order claims write it."""
    size = abs(parse_number(text.split()[-1]))
    return (1 / size if size else None) if path.point is None else size


def _coefficient(e: Expr, node: Expr) -> Expr | None:
    """Return the factor of ``node`` in an expression that is linear in all its nodes."""
    marks = {other: symbol(f"[{n}]") for n, other in enumerate(dict.fromkeys(outermost(e)))}
    if node not in marks:
        return ZERO
    slope = differentiate(replaced(e, marks), str(marks[node].args[0]))
    names = {str(mark.args[0]) for mark in marks.values()}
    return None if symbols(slope) & names else slope


def _sentence(node: Expr, found: Approximation, bound: Bound, path: Path) -> str:
    """Return what the lemma says of one integral, sum or factorial."""
    if found.error == ZERO:
        return f"{node} = {found.main}"
    if bound.constant is None:
        return f"{node} = {found.main} + {'o' if found.small else 'O'}({found.error})"
    where = f"{path.name} > 0" if bound.upto is None else region_of(path, bound.upto)
    limit = number(bound.constant) * found.error
    return f"{node} = {found.main} + R with |R| <= {limit} for {where}"
