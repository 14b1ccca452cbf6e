"""Derive a statement from claims: bounds, monotone dependence, infima and orders.

Each function judges one type of evidence from `tresym.ledger.claim` and raises `NotShownError` if a
side condition is missing.

- A part of a cited claim, under conditions that imply the claim's own (`cited`).
- A root lies above v if the monotone function whose zero it is has the sign of the lower end at v.
- A root y(x) of h(y, x) = 0 is strictly monotone if −(∂h/∂x)/(∂h/∂y) has one sign at every zero
  (implicit function theorem, mean value theorem); then so is f(y), if f is.
- e > v for all x on one side of an edge, if e is monotone in x and the bound holds at the edge.
- v is the infimum of e if e > v, and e < v + r at points where r tends to 0.
- d = O(g) or o(g) as t tends to a point, if |d| <= m, where m/g depends on t only and is O(1) or
  o(1).

Example: ε₀ is the zero of h(ε; a, b), which increases with ε. Where h = 0, ∂h/∂a > 0. So ε₀
decreases strictly in a.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import lru_cache
from itertools import islice
from typing import Any

from flint import fmpq

from tresym.asymptotics.order_claims import decide_order
from tresym.checking.dispatch import decide_claim
from tresym.ledger.claim import (
    Claim,
    Dominated,
    FromSlope,
    FromTheEdge,
    InfimumBy,
    MonotoneOf,
    Root,
    RootBound,
    RootMonotone,
)
from tresym.ledger.conversion import (
    REMEMBERED,
    CircularError,
    Conditions,
    conditions,
    defined,
    dependencies,
    dependent,
    known,
    put_in,
    put_into,
)
from tresym.ledger.counterexamples import violation
from tresym.ledger.evidence.asymptotics import solved_for_order
from tresym.ledger.evidence.at_point import place_of
from tresym.ledger.evidence.decided import Decided, judge_decided
from tresym.ledger.evidence.integrals import NotShownError, need, need_smooth, with_bounds
from tresym.ledger.evidence.premises import instantiated
from tresym.ledger.evidence.sign_prover import continuous_on, is_manifest, manifest_sign, undefined
from tresym.ledger.finding import Finding, StepFinding
from tresym.ledger.formulas import (
    Condition,
    Says,
    Tending,
    Under,
    in_order,
    in_trees,
    is_bound,
    is_equation,
    names_of,
    parts_of,
)
from tresym.ledger.judged_roots import without
from tresym.ledger.reasons import citing
from tresym.ledger.refutations import (
    PROVED,
    REFUTED,
    all_facts_behind,
    facts_used,
    need_all,
    need_possible,
)
from tresym.reals.decisions.claim_parsing import stated
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.compound import Count, Shape, Together
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    instantiate,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.like_terms import collected
from tresym.reals.language.named_claims import Extremum
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, fraction_text
from tresym.reals.verdict import Verdict

RISES = {"increasing": 1, "decreasing": -1}
FLIPPED = {">": "<", "<": ">", ">=": "<=", "<=": ">="}
BITS, PAIRS = 200, 24
NEAR = tuple(10**n for n in range(1, 7))
"""How near to its limit t is taken when conditions are shown for all t beyond."""


# A part of a cited claim


def parts_under(
    says: Any, given: Iterable[Any] = ()
) -> Iterator[tuple[Says, tuple[Condition, ...]]]:
    """Yield the parts of a statement, each with all of its conditions."""
    conditions_ = tuple(map(in_trees, given))
    for part in parts_of(in_trees(says)):
        if isinstance(part, Under):
            yield from parts_under(part.formula, (*conditions_, *part.given))
        elif isinstance(part, Together):
            yield from parts_under(part, conditions_)
        else:
            yield part, conditions_


def _parts_of(claim: Claim) -> Iterator[tuple[Says, tuple[Condition, ...]]]:
    """Yield the parts of a claim's statement with their conditions; none if it has no formula."""
    if claim.statement is not None:
        yield from parts_under(claim.statement, claim.given)


def _equations(given: Iterable[Condition]) -> tuple[Relation, ...]:
    """Return the equations among conditions."""
    return tuple(c for c in given if isinstance(c, Relation) and c.sign == "==")


def _is_ordering(says: Any) -> bool:
    """Return whether a statement is an inequality that orders its sides."""
    return is_bound(says) and says.sign != "!="


def cited(claim: Claim, claims: Iterable[Claim]) -> Finding | None:
    """Return PROVED if each part of the statement is a part of one of the claims.

    The conditions of that claim must be among those of the part, or follow from them.

    Returns:
        The finding, or None if there is no formula to compare.

    Raises:
        NotShownError: a part is none of a claim, or a condition could not be shown.
    """
    says: Any = claim.statement
    if says is None:
        return None
    known = [pair for c in claims for pair in _parts_of(c)]
    for part, given in parts_under(says, claim.given):
        same = [asked for other, asked in known if other == part]
        need(bool(same), f"none of the claims named says that {part}")
        need(
            any(_implied(asked, given) for asked in same),
            f"the claim named says {part} only under conditions that could not be shown: "
            f"{', '.join(map(str, same[0]))}",
        )
    return Finding(PROVED, "each part is one of a claim named")


def _implied(asked: tuple[Condition, ...], given: tuple[Condition, ...]) -> bool:
    """Return whether each condition asked for is given, or follows by its sign."""
    for condition in asked:
        if condition in given:
            continue
        if not _is_ordering(condition) or not all(map(_is_ordering, given)):
            return False
        (relation,) = conditions((condition,))
        if not is_manifest(relation, conditions(given)):
            return False
    return True


# Roots


def _values(claim: Claim) -> tuple[dict[str, Expr], tuple[Condition, ...]]:
    """Return the conditions ``symbol = value`` as replacements, and the others with these made.

    Raises:
        NotShownError: an equation does not give a free symbol a value, or gives one twice.
    """
    values: dict[str, Expr] = {}
    given = claim.given
    for condition in filter(is_equation, given):
        left, value = condition.left, condition.right
        fits = left.op == "symbol" and str(left) not in values
        need(fits and str(left) not in defined(claim), f"{condition} gives no variable a value")
        need(not symbols(value) & {str(left), *values}, f"{condition} is circular")
        values[str(left)] = value
    for name in values:
        others = (v for v in values.values() if name in symbols(v))
        need(next(others, None) is None, f"the value of another symbol depends on {name}")
    plain = conditions(tuple(c for c in given if not is_equation(c)))
    rest = tuple(_put(c, values) for c in plain)
    return values, tuple(c for c in rest if names_of(c) or not is_manifest(c, ()))


def _put(c: Relation, values: Mapping[str, Expr]) -> Relation:
    """Return a relation with values in place of symbols."""
    return Relation(substitute(c.left, values), c.sign, substitute(c.right, values))


def _refuted(says: Says, claim: Claim) -> Finding | None:
    """Return REFUTED with a point that contradicts a relation under the conditions, or None."""
    values = tuple(filter(is_equation, claim.given))
    given = tuple(c for c in claim.given if c not in values)
    try:
        for known in dict.fromkeys((facts_used(claim), all_facts_behind(claim))):
            found = violation(says, given, (*known, *values))
            if found is not None:
                return Finding(REFUTED, found.why, witness=found.point)
    except (CircularError, InputError):
        return None
    return None


class _Zero:
    """A symbol defined as the only zero, between two ends, of a strictly monotone function."""

    def __init__(self, claim: Claim, root: Claim) -> None:
        """Require that ``root`` defines a root, and that its conditions hold under the claim's."""
        proof = root.proof
        need(isinstance(proof, Root), f"{root.label} does not define a root")
        assert isinstance(proof, Root)
        unique = proof.unique.statement
        one = unique if isinstance(unique, Count) and unique.how == "exactly one" else None
        need(one is not None, "no root is defined")
        assert one is not None
        self.values, plain = _values(claim)
        self.symbol, self.given = str(proof.symbol), conditions(plain)
        need_possible(replace(claim, given=plain))
        self.variable = one.name
        need(self.variable not in self.values, "the unknown must have no value")
        sides = (in_order(one.equation[0] - one.equation[2]), one.low, one.high)
        self.h, self.low, self.high = (substitute(e, self.values) for e in sides)
        asked = conditions(proof.unique.given)
        for condition in asked:
            here = _put(condition, self.values)
            shown = here in self.given or is_manifest(here, self.given)
            need(shown, f"{root.label} defines {proof.symbol} only where {condition}")
        free = without(self.variable, asked)
        self.rises = _direction(*sides, self.variable, free)

    def at(self, e: Expr, value: Expr) -> Expr:
        """Return ``e`` with the value in place of the variable."""
        return substitute(e, {self.variable: value})


@lru_cache(maxsize=REMEMBERED)
def _direction(h: Expr, low: Expr, high: Expr, name: str, given: Conditions) -> int:
    """Return 1 if ``h``, which has one zero between the ends, is negative below it, else -1.

    It is continuous, so that it has one sign below its zero and one above, those at the ends.

    Raises:
        NotShownError: continuity or the signs at the ends are not shown.
    """
    x = symbol(name)
    gap = continuous_on(h, (*given, Relation(x, ">=", low), Relation(x, "<=", high)))
    need(gap is None, f"could not show that {gap} stays away from its singularity")
    asked = tuple((c.left, c.sign, c.right) for c in given)
    for way, signs in ((1, "<>"), (-1, "><")):
        ends = (
            (substitute(h, {name: e}), s, ZERO) for e, s in zip((low, high), signs, strict=True)
        )
        if all(decide_claim(stated((link,), asked)).verdict is PROVED for link in ends):
            return way
    raise NotShownError("could not show the signs of the function at the ends")


def judge_root_bound(claim: Claim, proof: RootBound) -> Finding:
    """Return PROVED if the function has the right sign at the bound, REFUTED at a counterexample.

    Raises:
        NotShownError: the bound is not shown to lie between the ends, or the sign is not shown.
    """
    says: Any = claim.statement
    need(_is_ordering(says), "this evidence shows a bound on a root")
    zero = _Zero(claim, proof.root)
    z = symbol(zero.symbol)
    turned = says.left != z
    root, bound = (says.right, says.left) if turned else (says.left, says.right)
    relation = FLIPPED[says.sign] if turned else says.sign
    need(root == z, f"one side must be {z}")
    free = {zero.symbol, zero.variable}.isdisjoint(symbols(bound))
    behind = dependencies((*claim.rests_on, claim))
    need(
        free and zero.symbol not in _behind(bound, behind),
        f"the bound must not depend on {z}",
    )
    try:
        shown = _bound(claim, zero, substitute(bound, zero.values), relation, proof.sign)
    except NotShownError:
        refuted = _refuted(says, claim)
        if refuted is None:
            raise
        return refuted
    return shown


def _behind(e: Expr, behind: Mapping[str, frozenset[str]]) -> frozenset[str]:
    return frozenset().union(*(behind.get(name, frozenset()) for name in symbols(e)))


def _bound(claim: Claim, zero: _Zero, bound: Expr, relation: str, shown_by: Decided) -> Finding:
    """Show that the root is related to the bound, by the sign of the function there."""
    near = with_bounds(zero.given, (citing(*shown_by.cited),))
    for wanted in (Relation(bound, ">=", zero.low), Relation(bound, "<=", zero.high)):
        need(is_manifest(wanted, near), f"could not show that {wanted}, between the ends")
    # The root lies above v if h(v) has the sign that h has at the lower end: − if h increases.
    sign = relation if zero.rises < 0 else FLIPPED[relation]
    steps = _steps_to_sign(claim, zero.at(zero.h, bound), sign, shown_by)
    need_all(steps)
    why = f"the function whose zero is {zero.symbol} is {sign} 0 at the bound"
    return Finding(PROVED, why, steps=steps)


def _is_monotone(says: Any) -> bool:
    return isinstance(says, Shape) and says.how in RISES


def judge_root_monotone(claim: Claim, proof: RootMonotone) -> Finding:
    """Return PROVED if the implicit derivative of the root by the parameter has one sign.

    Raises:
        NotShownError: the function is not shown to be smooth, the conditions do not describe an
            interval of the parameter, or the sign is not shown.
    """
    says: Any = claim.statement
    need(_is_monotone(says), "this evidence shows that a root is strictly monotone")
    zero, x = _Zero(claim, proof.root), says.name
    need(not zero.values, "the conditions must not be equations")
    shown = says.function == symbol(zero.symbol)
    need(shown, f"the expression must be {zero.symbol}; use MonotoneOf for others")
    used = tuple(c for c in claim.rests_on if c is not proof.root)
    need(x not in defined(claim), f"{x} is defined, so that it is no parameter")
    spoken = symbols(zero.h) | symbols(zero.low) | symbols(zero.high)
    need(
        dependent(spoken - {x}, (x,), dependencies(used)) is None,
        f"a symbol of the function is defined in terms of {x}",
    )
    fixed = x not in symbols(zero.low) | symbols(zero.high) and x != zero.variable
    need(fixed, f"the ends must not depend on {x}")
    _need_interval(zero.given, x)
    v = symbol(zero.variable)
    inside = (
        *without(zero.variable, zero.given),
        Relation(v, ">", zero.low),
        Relation(v, "<", zero.high),
    )
    need_smooth(zero.h, inside)
    start = zero.at(differentiate(zero.h, x), symbol(zero.symbol))
    wanted = "<" if zero.rises * RISES[says.how] > 0 else ">"
    try:
        steps = _steps_to_sign(claim, start, wanted, proof.slope)
        need_all(steps)
    except NotShownError:
        found = _not_monotone(claim)
        if found is None:
            raise
        return found
    why = f"the derivative of the function by {x} is {wanted} 0 at every root"
    return Finding(PROVED, why, steps=steps)


def _steps_to_sign(
    claim: Claim, start: Expr, wanted: str, shown_by: Decided
) -> tuple[StepFinding, ...]:
    """Return the findings on the steps from an expression to its sign."""
    says = Relation(start, wanted, ZERO)
    plain = tuple(_values(claim)[1])  # the values that equations give are put in
    asked = replace(claim, says=says, means=None, given=plain, proof=shown_by)
    found = judge_decided(asked, shown_by)
    need(found.verdict is PROVED, f"could not show that {start} {wanted} 0: {found.why}")
    return found.steps or (StepFinding(PROVED, found.why),)


def _need_interval(given: Conditions, name: str) -> None:
    """Require that the conditions allow an interval of values: they are linear in the symbol."""
    for condition in given:
        slope = differentiate(condition.left - condition.right, name)
        bend = differentiate(slope, name)
        flat = decide_continuous(bend, ZERO, Given(())).verdict is PROVED
        need(
            flat and condition.sign != "!=",
            f"could not show that the values of {name} with {condition} form an interval",
        )


def judge_monotone_of(claim: Claim, proof: MonotoneOf) -> Finding:
    """Return PROVED if the expression depends on x only by a symbol that is monotone in x.

    Raises:
        NotShownError: it depends on x in another way, or the sign of its derivative is not shown.
    """
    says: Any = claim.statement
    need(_is_monotone(says), "this evidence shows that an expression is strictly monotone")
    need_possible(claim)
    written, x, given = says.function, says.name, conditions(claim.given)
    found = [
        (part, asked)
        for part, asked in _parts_of(proof.inner)
        if isinstance(part, Shape) and part.how in RISES and part.name == x
    ]
    need(bool(found), f"{proof.inner.label} does not say that anything is monotone in {x}")
    part, asked = found[0]
    y = str(part.function)
    need(part.function.op == "symbol", "the inner expression must be a symbol")
    # Between two of its values a root takes all others, as it is continuous in the parameter.
    ways = getattr(proof.inner.proof, "parts", (proof.inner.proof,))
    need(any(isinstance(way, RootMonotone) for way in ways), f"{y} must be shown to be continuous")
    need(_implied(asked, claim.given), f"a condition of {proof.inner.label} could not be shown")
    behind = dependencies((*claim.rests_on, claim))
    others = symbols(written) - {y}
    alone = x not in others and dependent(others, (x,), behind) is None
    need(alone, f"the expression depends on {x} not only by {y}")
    _need_interval(given, x)
    near = with_bounds(given, (citing(*proof.bounds),))
    need_smooth(written, near)
    slope = manifest_sign(differentiate(written, y), near)
    need(slope in ("+", "-"), f"could not show the sign of the derivative by {y}")
    rises = RISES[part.how] * (1 if slope == "+" else -1)
    if rises != RISES[says.how]:
        refuted = _not_monotone(claim)
        need(refuted is not None, "it is monotone in the other direction")
        assert refuted is not None
        return refuted
    return Finding(PROVED, f"{y} is strictly monotone in {x}, and so is the expression in {y}")


def _not_monotone(claim: Claim) -> Finding | None:
    """Return REFUTED with two points that contradict a statement on monotone dependence."""
    says, given = claim.statement, conditions(claim.given)
    assert isinstance(says, Shape)
    x = says.name
    names = (names_of(*given) | {x}) - defined(claim)
    points = [*islice(Given(given).points(sorted(names), PAIRS), PAIRS)]
    for one in points:
        for value in {p[x] for p in points}:
            other = {**one, x: value}
            if value <= one[x]:
                continue
            with ball_precision(BITS):
                places = [place_of(p, claim.rests_on) for p in (one, other)]
                if not places[1].meets(given):
                    continue
                gap = places[1].value(says.function) - places[0].value(says.function)
                if gap.is_finite() and bool(gap * RISES[says.how] < 0):
                    where = ", ".join(f"{n} = {fraction_text(v)}" for n, v in one.items())
                    why = f"violated from {where} to {x} = {fraction_text(value)}"
                    witness: dict[str, fmpq] = {**one, f"{x}'": value}
                    return Finding(REFUTED, why, witness=witness)
    return None


# Bounds for all values of a parameter


def judge_from_the_edge(claim: Claim, proof: FromTheEdge) -> Finding:
    """Return PROVED if a bound at one value of x holds for all x on the right side of it.

    Raises:
        NotShownError: a condition could not be shown, or the direction is the wrong one.
    """
    says: Any = claim.statement
    need(_is_ordering(says), "this evidence shows a bound")
    need_possible(claim)
    monotone = [
        (part, asked)
        for part, asked in _parts_of(proof.monotone)
        if isinstance(part, Shape) and part.how in RISES
        if part.function == says.left and (proof.of is None or str(proof.of) == part.name)
    ]
    edge = proof.at
    shown: str | None = f"{proof.monotone.label} is not about {says.left}"
    for part, asked in monotone:
        shown = _beyond(claim, proof, part, asked, edge)
        if shown is None:
            why = f"{proof.bound.label} at {part.name} = {proof.at}, and {proof.monotone.label}"
            return Finding(PROVED, why)
    refuted = _refuted(says, claim)
    need(refuted is not None, f"{shown}")
    assert refuted is not None
    return refuted


def _beyond(
    claim: Claim, proof: FromTheEdge, part: Shape, asked: tuple[Condition, ...], edge: Expr
) -> str | None:
    """Return why the bound does not carry over from the edge, or None if it does."""
    says: Any = claim.statement
    x = part.name
    given = conditions(claim.given)
    behind = dependencies((*claim.rests_on, claim))
    if x in symbols(says.right) | _behind(says.right, behind):
        return f"the bound depends on {x}"
    if x in symbols(edge) or x in defined(claim):
        return f"the edge must not depend on {x}, which must be a variable"
    bounds = [c for other, c in _parts_of(proof.bound)
              if other == says]  # fmt: skip
    if not bounds:
        return f"{proof.bound.label} does not state this bound"
    # e >= v and e > v carry over to larger e: up if e rises with x, down if it falls.
    up = (says.sign in (">", ">=")) == (RISES[part.how] > 0)
    side = Relation(symbol(x), ">=" if up else "<=", edge)
    if not is_manifest(side, given):
        return f"could not show {side}"
    there = {x: edge}
    equations = _equations(bounds[0])
    for written in equations:
        if written.left != symbol(x) or x in symbols(written.right):
            return f"{written} gives {x} no value"
        same = decide_continuous(written.right, edge, Given(given)).verdict is PROVED
        if not same:
            return f"could not show {written} at the edge"
    plain = tuple(c for c in bounds[0] if c not in equations)
    for condition in (*conditions(asked), *conditions(plain)):
        spoken = symbols(condition.left) | symbols(condition.right)
        if dependent(spoken - {x}, (x,), behind) is not None:
            return f"a condition speaks of a symbol that depends on {x}"
        at_edge = _put(condition, there)
        if not is_manifest(at_edge, given):
            return f"could not show {condition} at the edge"
    for condition in conditions(asked):
        if condition not in given and not is_manifest(condition, given):
            return f"could not show {condition}"
    return None


def judge_from_slope(claim: Claim, proof: FromSlope) -> Finding:
    """Return PROVED if a function that starts at 0 or above has a positive derivative.

    Raises:
        NotShownError: a condition could not be shown, or the claims are about another function.
    """
    says: Any = claim.statement
    above = _is_ordering(says) and says.sign in (">", ">=") and says.right == ZERO
    need(above, "the statement must be f > 0 or f >= 0")
    need_possible(claim)
    slope: Any = proof.slope.decided
    start: Any = proof.start.decided
    f = says.left
    rising = _is_ordering(slope) and slope.sign in (">", ">=") and slope.right == ZERO
    rising = rising and slope.left.op == "derivative" and slope.left.args[1].op == "symbol"
    need(rising, f"{proof.slope.label} does not say that a derivative is positive")
    x = str(slope.left.args[1])
    need(_is_body_of(slope.left, x, f), f"{proof.slope.label} is not about the derivative of f")
    begins = isinstance(start, Relation) and start.sign in ("==", ">", ">=")
    begins = begins and start.left.op == "at" and start.right == ZERO
    need(begins, f"{proof.start.label} does not state the value of f at a point")
    need(_is_body_of(start.left, x, f), f"{proof.start.label}: another f")
    p = start.left.args[1]
    need(x not in symbols(p) and x not in defined(claim), f"{x} must be a variable")
    behind = dependencies((*claim.rests_on, claim))
    free = symbols(f) - {x}
    need(dependent(free, (x,), behind) is None, f"a symbol of f is defined in terms of {x}")
    given, asked = conditions(claim.given), conditions(proof.slope.given)
    _need_interval(asked, x)
    there = {x: p}
    need(is_manifest(Relation(symbol(x), ">", p), given), f"could not show {x} > {p}")
    at_start = tuple(_put(c, there) for c in asked)
    for condition in (*asked, *at_start, *conditions(proof.start.given)):
        shown = condition in given or is_manifest(condition, given)
        need(shown, f"could not show {condition}")
    need_smooth(f, asked)
    strict = ">" in (slope.sign, start.sign) or says.sign == ">="
    need(strict, "f > 0 needs a positive derivative or a positive value at the start")
    return Finding(PROVED, f"it is not negative at {x} = {p}, and its derivative is positive")


def _is_body_of(node: Expr, x: str, f: Expr) -> bool:
    """Return whether a derivative, or a value at one point, is that of ``f`` by the variable."""
    if len(node.names) != 1 or x in symbols(node.args[0]):
        return False
    return in_order(instantiate(node.args[0], (symbol(x),))) == f


def judge_infimum(claim: Claim, proof: InfimumBy) -> Finding:
    """Return PROVED if the bound holds and is approached on the path, REFUTED if it fails.

    Raises:
        NotShownError: a condition could not be shown, or the excess does not tend to 0.
    """
    says: Any = claim.statement
    infimum = isinstance(says, Extremum) and says.how == "infimum"
    need(infimum, "this evidence shows an infimum")
    need_possible(claim)
    e, v = says.function, says.value
    need(not symbols(v), "the infimum must be a number")
    bound = Relation(e, ">", v)
    known = [*_parts_of(proof.bound)]
    given = conditions(claim.given)
    rules, meant = instantiated(proof.using, given)
    lower = [asked for other, asked in known if other == bound]
    fits = any(
        all(c in meant or is_manifest(c, meant) for c in put_into(conditions(asked), rules))
        for asked in lower
    )
    if not fits:
        refuted = _refuted(bound, claim)
        need(
            refuted is not None,
            f"{proof.bound.label} does not state {bound} under these conditions",
        )
        assert refuted is not None
        return refuted
    uppers = [
        (other, asked)
        for other, asked in _parts_of(proof.above)
        if isinstance(other, Relation) and other.sign in ("<", "<=") and other.left == e
    ]
    need(bool(uppers), f"{proof.above.label} does not bound {e} from above")
    upper, asked = uppers[0]
    t = symbol("t")
    path = {str(name): in_trees(value) for name, value in proof.along}
    need(not {*path} & defined(claim), "the path must not give a value to a defined symbol")
    need(all(symbols(value) <= {"t"} for value in path.values()), "a path depends on t alone")

    def along(x: Expr) -> Expr:
        return substitute(x, path)

    equations = _equations(asked)
    asked = tuple(c for c in asked if c not in equations)
    needed = [*given, *put_into(conditions(asked), rules)]
    (excess,) = put_into((Relation(upper.right - v, ">", ZERO),), rules)
    rest = along(excess.left)
    loose = symbols(rest).union(*(symbols(along(c.left - c.right)) for c in needed)) - {"t"}
    need(not loose, f"the path gives no value to {', '.join(sorted(loose))}")
    for near in NEAR:
        close = _beside(t, ZERO, 1, near)
        if all(is_manifest(Relation(along(c.left), c.sign, along(c.right)), close) for c in needed):
            break
    else:
        raise NotShownError("could not show that the path satisfies the conditions near t = 0")
    for equation in equations:
        left, right = (along(put_in(side, rules)) for side in (equation.left, equation.right))
        same = decide_continuous(left, right, Given(close)).verdict is PROVED
        need(same and symbols(left) <= {"t"}, f"could not show {equation} on the path")
    shrinks = decide_order(Comparison(rest, "o", ONE), Path("t", ZERO, (1,)))
    need(shrinks.verdict.holds, f"could not show that the excess tends to 0: {shrinks.why}")
    why = f"{proof.bound.label}, and {proof.above.label} as t tends to 0"
    return Finding(shrinks.verdict, why)


# Orders


def judge_dominated(claim: Claim, proof: Dominated) -> Finding:
    """Return ENCLOSED if bounds whose ratio to the gauge depends on t only show the order.

    Raises:
        NotShownError: the claims do not bound the difference, hold under other conditions, or the
            ratio is not of the order stated.
    """
    says: Any = claim.statement
    stated = solved_for_order(says.relation) if isinstance(says, Tending) else None
    need(stated is not None, "the statement must be an equation with one order")
    assert stated is not None
    need_possible(claim)
    path = says.path
    end, sides = path.point, path.sides
    need(not path.together and not symbols(end or ZERO), "one expression tends to a number")
    given = conditions(claim.given)
    upper, lower = _sizes(proof.above, stated.left, given)
    if proof.below is not None:
        lower = _sizes(proof.below, stated.left, given)[1]
    need(upper is not None and lower is not None, "the claims do not bound it from both sides")
    assert upper is not None
    assert lower is not None
    one_sided = sides == (1,) or (sides == (-1,) and end is not None)
    need(one_sided, "a limit from one side, or at +oo, is needed")
    e, t = path.expression or symbol(str(path.name)), symbol("[t]")
    away = [
        (Relation(t, ">", number(near)),) if end is None else _beside(t, end, sides[0], near)
        for near in NEAR
    ]
    for used in proof.claims:
        for condition in conditions(used.given):
            if condition in given or is_manifest(condition, given):
                continue
            here = _by(e, t, condition.left - condition.right, given)
            there = Relation(here, condition.sign, ZERO)
            need(
                any(is_manifest(there, close) for close in away),
                f"{used.label} holds only where {condition}",
            )
    for size in (upper, lower):
        if size == ZERO:
            continue
        ratio = _by(e, t, size / stated.right, given)
        found = decide_order(
            Comparison(worked_out(ratio), stated.relation, ONE), Path("[t]", end, sides)
        )
        need(found.verdict.holds, f"the bound is not of that order: {found.why}")
    why = f"the difference is at most {upper}, and at least {lower}"
    point = INFINITY if end is None else end
    return Finding(Verdict.ENCLOSED, why, parameter=f"{e} -> {point}")


def _beside(t: Expr, point: Expr, side: int, near: int) -> Conditions:
    """Return that ``t`` lies on one side of a point, nearer than ``1/near``."""
    away = side * (t - point)
    return (Relation(away, ">", ZERO), Relation(away, "<", ONE / near))


def _sizes(claim: Claim, difference: Expr, given: Conditions) -> tuple[Expr | None, Expr | None]:
    """Return what a claim states above and below the difference of an order."""
    upper: Expr | None = None
    lower: Expr | None = None

    def is_it(e: Expr, sign: int = 1) -> bool:
        rest = collected(e - sign * difference)
        return rest == ZERO or decide_continuous(rest, ZERO, Given(given)).verdict is PROVED

    stated = () if isinstance(claim.decided, str) else parts_of(claim.decided)
    for part in filter(_is_ordering, stated):
        less, more = part.left, part.right
        if part.sign in (">", ">="):
            less, more = more, less
        if less.op == "abs" and (is_it(less.args[0]) or is_it(less.args[0], -1)):
            return more, -more
        upper = more if is_it(less) else upper
        lower = less if is_it(more) else lower
        lower = -more if is_it(less, -1) else lower
        upper = -less if is_it(more, -1) else upper
    return upper, lower


def _by(e: Expr, t: Expr, size: Expr, given: Conditions) -> Expr:
    """Return a function of t that is equal to ``size`` where t is ``e``.

    If there is one, it is the value of ``size`` where ``e`` is t and all variables but one are 1.

    Raises:
        NotShownError: none was found, or the equality is not shown.
    """
    if e.op == "symbol":
        found = substitute(size, {str(e): t})
        need(symbols(found) <= symbols(t), f"{size} does not depend on {e} alone")
        return found
    name = min(symbols(e), default="")
    need(bool(name), f"{e} has no variable")
    slope = collected(differentiate(e, name))
    need(name not in symbols(slope), f"{e} must be linear in {name}")
    solved = (t - substitute(e, {name: ZERO})) / slope
    ones = dict.fromkeys((symbols(size) | symbols(e)) - {name}, ONE)
    try:
        found = substitute(substitute(size, {name: solved}), ones)
    except ZeroDivisionError:
        raise NotShownError(f"{size} has no value where other variables are 1") from None
    back = substitute(found, {str(t): e})
    need(elementary(size, back), "the bound must be elementary")
    gap = undefined(size, given) or undefined(back, given)
    need(gap is None, f"could not show that {gap} lies in the domain of its operation")
    same = decide_continuous(size, back, known(given))
    need(same.verdict is Verdict.PROVED, f"could not show that {size} is {back}: {same.why}")
    return found
