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

from flint import fmpq
from sympy import (
    Abs,
    Basic,
    Derivative,
    Eq,
    Integer,
    Rational,
    Subs,
    Symbol,
    Tuple,
    oo,
    simplify,
    true,
)
from sympy.core.relational import Ge, Gt, Le, Lt, Relational

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
    parts_of,
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
    tree,
)
from tresym.ledger.counterexamples import violation
from tresym.ledger.evidence.asymptotics import SIDES, ordered
from tresym.ledger.evidence.at_point import place_of
from tresym.ledger.evidence.decided import Decided, judge_decided
from tresym.ledger.evidence.integrals import NotShownError, need, need_smooth, with_bounds
from tresym.ledger.evidence.premises import instantiated
from tresym.ledger.evidence.sign_prover import continuous_on, is_manifest, manifest_sign, undefined
from tresym.ledger.finding import Finding, StepFinding
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
from tresym.ledger.statements import (
    As,
    ExactlyOne,
    Infimum,
    StrictlyDecreasing,
    StrictlyIncreasing,
    Under,
)
from tresym.reals.decisions.claim_parsing import stated
from tresym.reals.decisions.identity import decide_continuous
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, worked_out
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ONE, ZERO, Expr, substitute, symbol, symbols
from tresym.reals.language.formula import Relation
from tresym.reals.language.paths import Path
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, fraction_text
from tresym.reals.verdict import Verdict

RISES = {StrictlyIncreasing: 1, StrictlyDecreasing: -1}
FLIPPED = {">": "<", "<": ">", ">=": "<=", "<=": ">="}
BITS, PAIRS = 200, 24
NEAR = tuple(10**n for n in range(1, 7))
"""How near to its limit t is taken when conditions are shown for all t beyond."""


# A part of a cited claim


def parts_under(says: Basic, given: tuple[Basic, ...]) -> Iterator[tuple[Basic, tuple[Basic, ...]]]:
    """Yield the parts of a statement, each with all of its conditions."""
    for part in parts_of(says):
        if isinstance(part, Under):
            yield from parts_under(part.args[0], (*given, *part.args[1].args))
        elif isinstance(part, Tuple):
            yield from parts_under(part, given)
        else:
            yield part, given


def _parts_of(claim: Claim) -> Iterator[tuple[Basic, tuple[Basic, ...]]]:
    """Yield the parts of a claim's statement with their conditions; none if it has no formula."""
    if claim.statement is not None:
        yield from parts_under(claim.statement, claim.given)


def cited(claim: Claim, claims: Iterable[Claim]) -> Finding | None:
    """Return PROVED if each part of the statement is a part of one of the claims.

    The conditions of that claim must be among those of the part, or follow from them.

    Returns:
        The finding, or None if there is no formula to compare.

    Raises:
        NotShownError: a part is none of a claim, or a condition could not be shown.
    """
    says = claim.statement
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


def _implied(asked: tuple[Basic, ...], given: tuple[Basic, ...]) -> bool:
    """Return whether each condition asked for is given, or follows by its sign."""
    for condition in asked:
        if condition in given:
            continue
        plain = tuple(c for c in given if isinstance(c, Gt | Ge | Lt | Le))
        if not isinstance(condition, Gt | Ge | Lt | Le) or len(plain) < len(given):
            return False
        (relation,) = conditions((condition,))
        if not is_manifest(relation, conditions(plain)):
            return False
    return True


# Roots


def _values(claim: Claim) -> tuple[dict[Basic, Basic], tuple[Basic, ...]]:
    """Return the conditions ``symbol = value`` as replacements, and the others with these made.

    Raises:
        NotShownError: an equation does not give a free symbol a value, or gives one twice.
    """
    values: dict[Basic, Basic] = {}
    for condition in claim.given:
        if isinstance(condition, Eq):
            symbol, value = condition.args
            fits = isinstance(symbol, Symbol) and symbol not in values
            need(
                fits and symbol.name not in defined(claim), f"{condition} gives no variable a value"
            )
            need(not value.free_symbols & {symbol, *values}, f"{condition} is circular")
            values[symbol] = value
    for symbol in values:
        others = (v for v in values.values() if symbol in v.free_symbols)
        need(next(others, None) is None, f"the value of another symbol depends on {symbol}")
    rest = (c.xreplace(values) for c in claim.given if not isinstance(c, Eq))
    return values, tuple(c for c in rest if c is not true)


def _refuted(says: Basic, claim: Claim) -> Finding | None:
    """Return REFUTED with a point that contradicts a relation under the conditions, or None."""
    values = tuple(c for c in claim.given if isinstance(c, Eq))
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
        need(isinstance(unique, ExactlyOne), "no root is defined")
        assert isinstance(unique, ExactlyOne)
        values, plain = _values(claim)
        self.values = {symbol.name: tree(value) for symbol, value in values.items()}
        self.symbol, self.given = proof.symbol, conditions(plain)
        need_possible(replace(claim, given=plain))
        self.variable = unique.variable.name
        need(self.variable not in self.values, "the unknown must have no value")
        sides = (unique.difference, unique.low, unique.high)
        self.h, self.low, self.high = (substitute(tree(e), self.values) for e in sides)
        asked = conditions(proof.unique.given)
        for condition in asked:
            here = Relation(
                substitute(condition.left, self.values),
                condition.sign,
                substitute(condition.right, self.values),
            )
            shown = here in self.given or is_manifest(here, self.given)
            need(shown, f"{root.label} defines {proof.symbol} only where {condition}")
        free = without(self.variable, asked)
        self.rises = _direction(*map(tree, sides), self.variable, free)

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
    says = claim.statement
    need(isinstance(says, Gt | Ge | Lt | Le), "this evidence shows a bound on a root")
    assert isinstance(says, Relational)
    zero = _Zero(claim, proof.root)
    turned = says.lhs != zero.symbol
    root, bound = (says.rhs, says.lhs) if turned else (says.lhs, says.rhs)
    relation = FLIPPED[says.rel_op] if turned else says.rel_op
    need(root == zero.symbol, f"one side must be {zero.symbol}")
    free = {zero.symbol.name, zero.variable}.isdisjoint(map(str, bound.free_symbols))
    behind = dependencies((*claim.rests_on, claim))
    need(
        free and zero.symbol.name not in _behind(bound, behind),
        f"the bound must not depend on {zero.symbol}",
    )
    try:
        shown = _bound(claim, zero, substitute(tree(bound), zero.values), relation, proof.sign)
    except NotShownError:
        refuted = _refuted(says, claim)
        if refuted is None:
            raise
        return refuted
    return shown


def _behind(e: Basic, behind: Mapping[str, frozenset[str]]) -> frozenset[str]:
    return frozenset().union(*(behind.get(str(s), frozenset()) for s in e.free_symbols))


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


def judge_root_monotone(claim: Claim, proof: RootMonotone) -> Finding:
    """Return PROVED if the implicit derivative of the root by the parameter has one sign.

    Raises:
        NotShownError: the function is not shown to be smooth, the conditions do not describe an
            interval of the parameter, or the sign is not shown.
    """
    says = claim.statement
    need(type(says) in RISES, "this evidence shows that a root is strictly monotone")
    assert isinstance(says, StrictlyIncreasing | StrictlyDecreasing)
    zero, (e, x) = _Zero(claim, proof.root), says.args
    need(not zero.values, "the conditions must not be equations")
    need(e == zero.symbol, f"the expression must be {zero.symbol}; use MonotoneOf for others")
    need(isinstance(x, Symbol), "the parameter must be a symbol")
    used = tuple(c for c in claim.rests_on if c is not proof.root)
    need(x.name not in defined(claim), f"{x} is defined, so that it is no parameter")
    spoken = symbols(zero.h) | symbols(zero.low) | symbols(zero.high)
    need(
        dependent(spoken - {x.name}, (x.name,), dependencies(used)) is None,
        f"a symbol of the function is defined in terms of {x}",
    )
    fixed = x.name not in symbols(zero.low) | symbols(zero.high) and x.name != zero.variable
    need(fixed, f"the ends must not depend on {x}")
    _need_interval(zero.given, x.name)
    v = tree(Symbol(zero.variable, real=True))
    inside = (
        *without(zero.variable, zero.given),
        Relation(v, ">", zero.low),
        Relation(v, "<", zero.high),
    )
    need_smooth(zero.h, inside)
    start = zero.at(differentiate(zero.h, x.name), tree(zero.symbol))
    wanted = "<" if zero.rises * RISES[type(says)] > 0 else ">"
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
    sign = {">": Gt, ">=": Ge, "<": Lt, "<=": Le}[wanted]
    says = sign(to_sympy(start), 0, evaluate=False)
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
    says = claim.statement
    need(type(says) in RISES, "this evidence shows that an expression is strictly monotone")
    assert isinstance(says, StrictlyIncreasing | StrictlyDecreasing)
    need_possible(claim)
    (e, x), given = says.args, conditions(claim.given)
    found = [
        (part, asked)
        for part, asked in _parts_of(proof.inner)
        if type(part) in RISES and part.args[1] == x
    ]
    need(bool(found), f"{proof.inner.label} does not say that anything is monotone in {x}")
    part, asked = found[0]
    y = part.args[0]
    need(isinstance(y, Symbol), "the inner expression must be a symbol")
    # Between two of its values a root takes all others, as it is continuous in the parameter.
    ways = getattr(proof.inner.proof, "parts", (proof.inner.proof,))
    need(any(isinstance(way, RootMonotone) for way in ways), f"{y} must be shown to be continuous")
    need(_implied(asked, claim.given), f"a condition of {proof.inner.label} could not be shown")
    written, whole = tree(e), symbols(tree(e))
    behind = dependencies((*claim.rests_on, claim))
    others = whole - {y.name}
    alone = x.name not in others and dependent(others, (x.name,), behind) is None
    need(alone, f"the expression depends on {x} not only by {y}")
    _need_interval(given, x.name)
    near = with_bounds(given, (citing(*proof.bounds),))
    need_smooth(written, near)
    slope = manifest_sign(differentiate(written, y.name), near)
    need(slope in ("+", "-"), f"could not show the sign of the derivative by {y}")
    rises = RISES[type(part)] * (1 if slope == "+" else -1)
    if rises != RISES[type(says)]:
        refuted = _not_monotone(claim)
        need(refuted is not None, "it is monotone in the other direction")
        assert refuted is not None
        return refuted
    return Finding(PROVED, f"{y} is strictly monotone in {x}, and so is the expression in {y}")


def _not_monotone(claim: Claim) -> Finding | None:
    """Return REFUTED with two points that contradict a statement on monotone dependence."""
    says = claim.statement
    assert isinstance(says, StrictlyIncreasing | StrictlyDecreasing)
    (e, x), given = says.args, Given(conditions(claim.given))
    names = {s.name for c in claim.given for s in c.free_symbols} | {x.name}
    names -= defined(claim)
    points = [*islice(given.points(sorted(names), PAIRS), PAIRS)]
    for one in points:
        for value in {p[x.name] for p in points}:
            other = {**one, x.name: value}
            if value <= one[x.name]:
                continue
            with ball_precision(BITS):
                places = [place_of(p, claim.rests_on) for p in (one, other)]
                if not places[1].meets(conditions(claim.given)):
                    continue
                gap = places[1].value(tree(e)) - places[0].value(tree(e))
                if gap.is_finite() and bool(gap * RISES[type(says)] < 0):
                    where = ", ".join(f"{n} = {fraction_text(v)}" for n, v in one.items())
                    why = f"violated from {where} to {x} = {fraction_text(value)}"
                    witness: dict[str, fmpq] = {**one, f"{x.name}'": value}
                    return Finding(REFUTED, why, witness=witness)
    return None


# Bounds for all values of a parameter


def judge_from_the_edge(claim: Claim, proof: FromTheEdge) -> Finding:
    """Return PROVED if a bound at one value of x holds for all x on the right side of it.

    Raises:
        NotShownError: a condition could not be shown, or the direction is the wrong one.
    """
    says = claim.statement
    need(isinstance(says, Gt | Ge | Lt | Le), "this evidence shows a bound")
    assert isinstance(says, Relational)
    need_possible(claim)
    monotone = [
        (part, asked)
        for part, asked in _parts_of(proof.monotone)
        if type(part) in RISES and part.args[0] == says.lhs and proof.of in (None, part.args[1])
    ]
    edge = tree(proof.at)
    shown: str | None = f"{proof.monotone.label} is not about {says.lhs}"
    for part, asked in monotone:
        shown = _beyond(claim, proof, part, asked, edge)
        if shown is None:
            why = f"{proof.bound.label} at {part.args[1]} = {proof.at}, and {proof.monotone.label}"
            return Finding(PROVED, why)
    refuted = _refuted(says, claim)
    need(refuted is not None, f"{shown}")
    assert refuted is not None
    return refuted


def _beyond(
    claim: Claim, proof: FromTheEdge, part: Basic, asked: tuple[Basic, ...], edge: Expr
) -> str | None:
    """Return why the bound does not carry over from the edge, or None if it does."""
    says, x = claim.statement, part.args[1]
    assert isinstance(says, Relational)
    given = conditions(claim.given)
    behind = dependencies((*claim.rests_on, claim))
    if x in says.rhs.free_symbols or x.name in _behind(says.rhs, behind):
        return f"the bound depends on {x}"
    if x.name in symbols(edge) or x.name in defined(claim):
        return f"the edge must not depend on {x}, which must be a variable"
    bounds = [c for other, c in _parts_of(proof.bound)
              if other == says]  # fmt: skip
    if not bounds:
        return f"{proof.bound.label} does not state this bound"
    # e >= v and e > v carry over to larger e: up if e rises with x, down if it falls.
    up = (says.rel_op in (">", ">=")) == (RISES[type(part)] > 0)
    side = Relation(tree(x), ">=" if up else "<=", edge)
    if not is_manifest(side, given):
        return f"could not show {side}"
    there = {x.name: edge}
    equations = tuple(c for c in bounds[0] if isinstance(c, Eq))
    for written in equations:
        if written.lhs != x or x in written.rhs.free_symbols:
            return f"{written} gives {x} no value"
        same = decide_continuous(tree(written.rhs), edge, Given(given)).verdict is PROVED
        if not same:
            return f"could not show {written} at the edge"
    plain = tuple(c for c in bounds[0] if c not in equations)
    for condition in (*conditions(asked), *conditions(plain)):
        spoken = symbols(condition.left) | symbols(condition.right)
        if dependent(spoken - {x.name}, (x.name,), behind) is not None:
            return f"a condition speaks of a symbol that depends on {x}"
        at_edge = Relation(
            substitute(condition.left, there), condition.sign, substitute(condition.right, there)
        )
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
    says = claim.statement
    need(isinstance(says, Gt | Ge) and says.rhs == 0, "the statement must be f > 0 or f >= 0")
    assert isinstance(says, Relational)
    need_possible(claim)
    f, slope, start = says.lhs, proof.slope.decided, proof.start.decided
    rising = isinstance(slope, Gt | Ge) and isinstance(slope.lhs, Derivative) and slope.rhs == 0
    need(rising, f"{proof.slope.label} does not say that a derivative is positive")
    assert isinstance(slope, Relational)
    need(slope.lhs.expr == f, f"{proof.slope.label} is not about the derivative of f")
    names = slope.lhs.variables
    need(len(names) == 1, "a first derivative is needed")
    (x,) = names
    begins = isinstance(start, Eq | Gt | Ge) and isinstance(start.lhs, Subs) and start.rhs == 0
    need(begins, f"{proof.start.label} does not state the value of f at a point")
    assert isinstance(start, Relational)
    need(start.lhs.expr == f and start.lhs.variables == (x,), f"{proof.start.label}: another f")
    p = start.lhs.point[0]
    need(x not in p.free_symbols and x.name not in defined(claim), f"{x} must be a variable")
    behind = dependencies((*claim.rests_on, claim))
    free = symbols(tree(f)) - {x.name}
    need(dependent(free, (x.name,), behind) is None, f"a symbol of f is defined in terms of {x}")
    given, asked = conditions(claim.given), conditions(proof.slope.given)
    _need_interval(asked, x.name)
    there = {x.name: tree(p)}
    need(is_manifest(Relation(tree(x), ">", tree(p)), given), f"could not show {x} > {p}")
    at_start = tuple(
        Relation(substitute(c.left, there), c.sign, substitute(c.right, there)) for c in asked
    )
    for condition in (*asked, *at_start, *conditions(proof.start.given)):
        shown = condition in given or is_manifest(condition, given)
        need(shown, f"could not show {condition}")
    need_smooth(tree(f), asked)
    strict = isinstance(slope, Gt) or isinstance(start, Gt) or isinstance(says, Ge)
    need(strict, "f > 0 needs a positive derivative or a positive value at the start")
    return Finding(PROVED, f"it is not negative at {x} = {p}, and its derivative is positive")


def judge_infimum(claim: Claim, proof: InfimumBy) -> Finding:
    """Return PROVED if the bound holds and is approached on the path, REFUTED if it fails.

    Raises:
        NotShownError: a condition could not be shown, or the excess does not tend to 0.
    """
    says = claim.statement
    need(isinstance(says, Infimum), "this evidence shows an infimum")
    assert isinstance(says, Infimum)
    need_possible(claim)
    e, v = says.args
    need(not (v.free_symbols), "the infimum must be a number")
    bound = Gt(e, v, evaluate=False)
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
        if isinstance(other, Lt | Le) and other.lhs == e
    ]
    need(bool(uppers), f"{proof.above.label} does not bound {e} from above")
    upper, asked = uppers[0]
    t = Symbol("t", real=True)
    path = {symbol.name: tree(value) for symbol, value in proof.along}
    need(not {*path} & defined(claim), "the path must not give a value to a defined symbol")
    need(all(symbols(value) <= {t.name} for value in path.values()), "a path depends on t alone")

    def along(x: Expr) -> Expr:
        return substitute(x, path)

    equations = [c for c in asked if isinstance(c, Eq)]
    asked = tuple(c for c in asked if c not in equations)
    needed = [*given, *put_into(conditions(asked), rules)]
    (excess,) = put_into((Relation(tree(upper.rhs - v), ">", ZERO),), rules)
    rest = along(excess.left)
    loose = symbols(rest).union(*(symbols(along(c.left - c.right)) for c in needed)) - {t.name}
    need(not loose, f"the path gives no value to {', '.join(sorted(loose))}")
    for near in NEAR:
        close = conditions((t > 0, t < Rational(1, near)))
        if all(is_manifest(Relation(along(c.left), c.sign, along(c.right)), close) for c in needed):
            break
    else:
        raise NotShownError("could not show that the path satisfies the conditions near t = 0")
    close = conditions((t > 0, t < Rational(1, near)))
    for equation in equations:
        left, right = (along(put_in(tree(side), rules)) for side in equation.args)
        same = decide_continuous(left, right, Given(close)).verdict is PROVED
        need(same and symbols(left) <= {t.name}, f"could not show {equation} on the path")
    shrinks = decide_order(Comparison(rest, "o", ONE), Path(t.name, ZERO, (1,)))
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
    says = claim.statement
    stated = ordered(says.args[0]) if isinstance(says, As) else None
    need(stated is not None, "the statement must be an equation with one order")
    assert isinstance(says, As)
    assert stated is not None
    need_possible(claim)
    _, e, point, side = says.args
    need(not isinstance(e, Tuple) and not point.free_symbols, "one expression tends to a number")
    given = conditions(claim.given)
    upper, lower = _sizes(proof.above, stated.difference)
    if proof.below is not None:
        lower = _sizes(proof.below, stated.difference)[1]
    need(upper is not None and lower is not None, "the claims do not bound it from both sides")
    t = Symbol("[t]", real=True)
    end = None if point in (oo, -oo) else tree(point)
    sides = (1,) if point == oo else (-1,) if point == -oo else SIDES[int(side)]
    need(point != -oo and sides != (1, -1), "a limit from one side, or at +oo, is needed")
    away = [(t > near,) if end is None else _beside(t, point, sides[0], near) for near in NEAR]
    for used in proof.claims:
        for written in used.given:
            (condition,) = conditions((written,))
            if condition in given or is_manifest(condition, given):
                continue
            here = _by(e, t, written.lhs - written.rhs, given)
            (there,) = conditions((written.func(here, Integer(0), evaluate=False),))
            need(
                any(is_manifest(there, conditions(close)) for close in away),
                f"{used.label} holds only where {condition}",
            )
    for size in (upper, lower):
        if size == 0:
            continue
        ratio = _by(e, t, size / stated.gauge, given)
        found = decide_order(
            Comparison(worked_out(tree(ratio)), stated.kind, ONE), Path(t.name, end, sides)
        )
        need(found.verdict.holds, f"the bound is not of that order: {found.why}")
    why = f"the difference is at most {upper}, and at least {lower}"
    return Finding(Verdict.ENCLOSED, why, parameter=f"{e} -> {point}")


def _beside(t: Symbol, point: Basic, side: int, near: int) -> tuple[Basic, ...]:
    away = side * (t - point)
    return (away > 0, away < Rational(1, near))


def _sizes(claim: Claim, difference: Basic) -> tuple[Basic | None, Basic | None]:
    """Return what a claim states above and below the difference of an order."""
    upper: Basic | None = None
    lower: Basic | None = None
    for part in parts_of(claim.decided) if isinstance(claim.decided, Basic) else ():
        if not isinstance(part, Gt | Ge | Lt | Le):
            continue
        less, more = (part.lhs, part.rhs) if isinstance(part, Lt | Le) else (part.rhs, part.lhs)
        if less in (Abs(difference, evaluate=False), Abs(-difference, evaluate=False)):
            return more, -more
        if isinstance(less, Abs) and less.args[0] in (difference, -difference):
            return more, -more
        upper = more if less == difference else upper
        lower = less if more == difference else lower
        if less == -difference:
            lower = -more
        if more == -difference:
            upper = -less
    return upper, lower


def _by(e: Basic, t: Symbol, size: Basic, given: Conditions) -> Basic:
    """Return a function of t that is equal to ``size`` where t is ``e``.

    Raises:
        NotShownError: none was found, or the equality is not shown.
    """
    if isinstance(e, Symbol):
        found = size.xreplace({e: t})
    else:
        (symbol, *_) = sorted(e.free_symbols, key=str)
        slope = e.diff(symbol)
        need(symbol not in slope.free_symbols, f"{e} must be linear in {symbol}")
        positive = Symbol("[s]", positive=True)
        others = {s: Symbol(f"[{s}]", positive=True) for s in size.free_symbols | e.free_symbols}
        solved = (positive - e.subs(symbol, 0)) / slope
        found = simplify(size.xreplace({symbol: solved}).xreplace(others))
        found = found.xreplace({positive: t, **{new: old for old, new in others.items()}})
    need(found.free_symbols <= {t}, f"{size} does not depend on {e} alone")
    if not isinstance(e, Symbol):
        back = tree(found.xreplace({t: e}))
        written = tree(size)
        need(elementary(written, back), "the bound must be elementary")
        gap = undefined(written, given) or undefined(back, given)
        need(gap is None, f"could not show that {gap} lies in the domain of its operation")
        same = decide_continuous(written, back, known(given))
        need(same.verdict is Verdict.PROVED, f"could not show that {size} is {back}: {same.why}")
    return found
