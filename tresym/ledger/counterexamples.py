"""Search for counterexamples to a claim, and confirm them in ball arithmetic.

The equations that a claim uses are eliminated first. Each equation either defines a symbol, or is
solved for a symbol in which it is linear, or (at most one equation) is satisfied numerically: the
search finds a tiny segment at whose ends the difference of its sides has opposite signs. The
statement is then evaluated in ball arithmetic at exact points that satisfy the conditions; it is
violated if the balls of its two sides exclude the relation.

Balls are computed from the SymPy expression as it was written, integrals included
(`tresym.ledger.ball_evaluation`). The code shares nothing with the expression trees and decision
procedures whose results it may contradict.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache

from flint import arb, fmpq
from sympy import (
    Basic,
    Derivative,
    Eq,
    Equivalent,
    Integer,
    Integral,
    MatrixBase,
    Subs,
    Symbol,
    Tuple,
    true,
)
from sympy.core.relational import Relational

from tresym.ledger.ball_evaluation import differentiated
from tresym.ledger.claim import Claim, equal, parts_of
from tresym.ledger.conversion import MAX_PASSES, CircularError, tree
from tresym.ledger.sample_points import (
    BITS,
    POINTS,
    Conditions,
    Place,
    World,
    names_of,
    need_unbound,
    places,
    points_for,
    reached,
)
from tresym.reals import cross_check
from tresym.reals.decisions.identity import decide
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import generalised
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval, fraction_text
from tresym.reals.verdict import Verdict

Rules = dict[Basic, Basic]
LOOKS = ((BITS, POINTS), (1024, 2))
"""Pairs of a precision in bits and the number of points tried with it."""
ENOUGH, TRIED = (6, 1), (16, 12)
"""Effort of the independent check: points evaluated and points tried, each for cheap relations and
for those with an integral or an implicit equation. They do not depend on time, so that a busy
machine checks as much as an idle one."""
LARGE = 400
"""Size (number of nodes) of the largest expression in which symbols are substituted."""


@dataclass(frozen=True)
class Violation:
    """A point of violation (the centre, if it is a segment) and a sentence that describes it."""

    point: Mapping[str, fmpq]
    why: str


@lru_cache(maxsize=4096)
def violation(says: Basic, given: Conditions, known: tuple[Basic, ...] = ()) -> Violation | None:
    """Return a point where ``given`` and ``known`` hold but ``says`` fails; None if not found.

    Args:
        says: a relation, a `Tuple` of relations (one of them must fail), or an `Equivalent` of two
            equations.
        given: the conditions of the claim.
        known: relations of the claims that are used.

    Example:
        >>> from sympy import Symbol
        >>> from tresym.ledger.claim import equal
        >>> x = Symbol("x", real=True)
        >>> violation(equal(x**2, x), (x > 3,)).why[:14]
        'violated at x '
    """
    for relation, there in _relations(says, known):
        world = _world(given, there)
        points = points_for(world, world.names(*relation.args))
        for bits, count in LOOKS:
            for place in points.first(count):
                with ball_precision(bits):
                    left, right = world.values(relation.args, place)
                    if excluded(left - right, relation.rel_op):
                        return _violated_at(place)
    return None


def contradiction(says: Basic, given: Conditions, known: tuple[Basic, ...] = ()) -> str | None:
    """Look for a violation at the points of the independent check; describe it, or return None.

    The points come from `tresym.reals.cross_check`, not from the sampling that the provers and
    :func:`violation` use.

    Args:
        says: the statement, as for :func:`violation`.
        given: the conditions of the claim.
        known: relations that are assumed.
    """
    relations = tuple(_relations(says, known))
    for relation, there in relations:
        world = _world(given, there)
        shown = 0
        expensive = bool(world.implicit) or relation.has(Integral)
        with ball_precision(BITS):
            for tried, place in enumerate(places(world, world.names(*relation.args)), 1):
                if place is not None:
                    sides = world.values(relation.args, place)
                    shown += sides[0].is_finite() and sides[1].is_finite()
                    if excluded(sides[0] - sides[1], relation.rel_op):
                        seen = " and ".join(map(cross_check.said, sides))
                        return f"{_violated_at(place).why}: the sides are {seen}"
                if shown >= ENOUGH[expensive] or tried >= TRIED[expensive]:
                    break
    return None


def _relations(
    says: Basic, known: tuple[Basic, ...]
) -> Iterator[tuple[Relational, tuple[Basic, ...]]]:
    """Yield the scalar relations of ``says``, each with the relations assumed for it.

    For an equivalence, each side is tested under the assumption of the other.
    """
    if isinstance(says, Equivalent) and len(says.args) == 2:
        first, second = says.args
        yield from _relations(second, (*known, first))
        yield from _relations(first, (*known, second))
    elif isinstance(says, Tuple):
        for part in says.args:
            yield from _relations(part, known)
    elif isinstance(says, Relational):
        yield from ((entry, known) for entry in scalars(says))


def somewhere(given: Conditions, known: tuple[Basic, ...]) -> tuple[Rules, tuple[Place, ...]]:
    """Return the substitution rules of ``known`` and points (or segments) where all may hold.

    Derivatives in the rules of symbols that occur in ``given`` are carried out where this removes
    the integral.
    """
    world, rules = _world(given, known), {}
    spoken_of = names_of(*given)
    for left, right in world.rules:
        done = differentiated(right) if isinstance(right, Derivative) else right
        rules[left] = right if left not in spoken_of or done.has(Integral) else done
    return rules, tuple(points_for(world, world.names(*rules.values()), enough=1))


def excluded(difference: arb, relation: str) -> bool:
    """Return whether the ball ``difference`` shows that ``difference relation 0`` is false.

    Args:
        difference: a ball that contains left minus right side.
        relation: one of ``== != > >= < <=``.
    """
    if not difference.is_finite():
        return False
    return bool(
        {
            "==": not difference.contains(0),
            "!=": difference.is_zero(),
            ">": difference <= 0,
            ">=": difference < 0,
            "<": difference >= 0,
            "<=": difference > 0,
        }[relation]
    )


def _violated_at(place: Mapping[Symbol, Interval]) -> Violation:
    """Describe the violation at a place."""
    named = sorted((s.name, (i.low + i.high) / 2, i.low == i.high) for s, i in place.items())
    where = [f"{n} = {fraction_text(v)}" for n, v, exact in named if exact]
    where += [f"a root {n} near {float(v.p) / float(v.q)!r}" for n, v, exact in named if not exact]
    why = "violated at " + (", ".join(where) or "the constants themselves")
    return Violation({n: v for n, v, _ in named}, why)


def scalars(equation: Basic) -> list[Basic]:
    """Return the entries of an equation of matrices; any other relation alone in a list."""
    left, right = equation.args if isinstance(equation, Relational) else (None, None)
    if isinstance(left, MatrixBase) and isinstance(right, MatrixBase):
        return [equal(p, q) for p, q in zip(left, right, strict=True)]
    return [equation]


# Points where the conditions and all used equations hold


@lru_cache(maxsize=512)
def _world(given: Conditions, known: tuple[Basic, ...]) -> World:
    """Turn the equations of ``known`` into rules where possible; keep the others as implicit."""
    relations = [entry for relation in known for entry in scalars(relation)]
    equations = [r for r in relations if isinstance(r, Eq)]
    rules: dict[Symbol, Basic] = {}
    pending = []
    for left, right in (equation.args for equation in equations):
        new = isinstance(left, Symbol) and left not in rules
        if new and left not in reached(right.free_symbols, rules):
            rules[left] = right
        elif left != right:
            pending.append((left, right))
    need_unbound(rules.values(), rules)
    conditioned = names_of(*given)
    plain = tuple(c for c in given if not c.has(Integral, Derivative, Subs, Eq))
    implicit = []
    for left, right in pending:
        large = _size((left, right), rules) > LARGE
        solved = _solved(left - right, conditioned, rules) if large else None
        if solved is None:
            left, right = put_in(left, rules), put_in(right, rules)
            if left == right or _identical(left, right, plain):
                continue
            solved = _solved(left - right, conditioned, rules)
        if solved is None:
            implicit.append(left - right)
        else:
            rules[solved[0]] = solved[1]
    # An equation that could not be solved may have become an identity by the rules found later.
    same = (_identical(put_in(e, rules), Integer(0), plain) for e in implicit)
    implicit = [e for e, holds in zip(implicit, same, strict=True) if not holds]
    asked = dict.fromkeys((*given, *(r for r in relations if not isinstance(r, Eq))))
    small = [c for c in asked if _size((c,), rules) <= LARGE]
    others = tuple(c for c in asked if c not in small)
    need_unbound((*implicit, *others), rules)
    conditions = dict.fromkeys(c for c in (put_in(c, rules) for c in small) if c != true)
    return World(tuple(conditions), tuple(rules.items()), tuple(implicit), others)


def _size(sides: Iterable[Basic], rules: Mapping[Symbol, Basic]) -> int:
    """Return the number of nodes that ``sides`` would have with all rules substituted."""
    known: dict[Basic, int] = {}

    def size(e: Basic) -> int:
        if e not in known:
            known[e] = size(rules[e]) if e in rules else 1 + sum(map(size, e.args))
        return known[e]

    return sum(map(size, sides))


@lru_cache(maxsize=512)
def _identical(left: Basic, right: Basic, given: Conditions) -> bool:
    """Return whether the two sides are proved equal under ``given``."""
    one, other = generalised(tree(left), tree(right))
    return decide(one, other, Given.from_sympy(*given)).verdict is Verdict.PROVED


def rules_of(claims: Iterable[Claim]) -> Rules:
    """Return the equations stated by the claims, as rules from left side to right side."""
    parts = (p for claim in claims for p in parts_of(claim.says) if isinstance(p, Eq))
    return {e.lhs: e.rhs for part in parts for e in scalars(part) if not e.lhs.is_number}


def put_in(expression: Basic, rules: Rules) -> Basic:
    """Replace left sides by right sides until nothing changes, using SymPy's ``xreplace``.

    Raises:
        CircularError: a symbol is defined in terms of itself, or occurs where a variable is bound
            on which its definition depends.
    """
    for _ in range(MAX_PASSES):
        for node in expression.atoms(Integral, Derivative, Subs):
            bound = set(node.variables)
            for left, right in rules.items():
                if node == left:  # the node itself is replaced as a whole, so nothing is captured
                    continue
                if bound & (left.free_symbols | right.free_symbols) and node.has(left):
                    raise CircularError(
                        f"{left} is defined in terms of a variable that is bound where it occurs"
                    )
        replaced = expression.xreplace(rules)
        if replaced == expression:
            return expression
        expression = replaced
    raise CircularError(f"the definitions of {sorted(map(str, rules))} are circular")


def _solved(
    difference: Basic, conditioned: frozenset[Symbol], rules: Mapping[Symbol, Basic]
) -> tuple[Symbol, Basic] | None:
    """Solve ``difference = 0`` for a symbol in which it is linear; None if there is none.

    Symbols that occur in no condition (not in ``conditioned``) are preferred.
    """
    names = difference.free_symbols
    if difference.has(Integral):
        return None
    for symbol in sorted(names.difference(rules), key=lambda s: (s in conditioned, s.name)):
        slope = difference.diff(symbol)
        alone = symbol not in reached(names - {symbol}, rules)
        if alone and slope != 0 and symbol not in slope.free_symbols:
            return symbol, -difference.subs(symbol, 0) / slope
    return None
