"""Search for counterexamples to a claim, and confirm them in ball arithmetic.

The equations that a claim uses are eliminated first. Each equation either defines a symbol, or is
solved for a symbol in which it is linear, or (at most one equation) is satisfied numerically: the
search finds a tiny segment at whose ends the difference of its sides has opposite signs. The
statement is then evaluated in ball arithmetic at exact points that satisfy the conditions; it is
violated if the balls of its two sides exclude the relation.

Balls are computed from the expression as it was written, integrals included
(`tresym.ledger.ball_evaluation`), by other code than that of the decision procedures whose results
they may contradict.

Example: ``x**2 == x`` where x > 3 is violated at x = 7/2.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import lru_cache
from typing import Any

from flint import arb, fmpq

from tresym.ledger.conversion import MAX_PASSES, CircularError
from tresym.ledger.formulas import (
    EqualMatrices,
    Says,
    binders_in,
    in_trees,
    names_of,
    relations_of,
)
from tresym.ledger.sample_points import (
    BITS,
    POINTS,
    Conditions,
    Place,
    World,
    need_unbound,
    places,
    points_for,
    reached,
)
from tresym.reals import cross_check
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.root_values import by_leibniz
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, generalised, worked_out
from tresym.reals.language.compound import Equivalent, Together
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Relation
from tresym.reals.language.like_terms import collected
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, fraction_text
from tresym.reals.verdict import Verdict

Rules = dict[Expr, Expr]
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
def violation(says: Says, given: Conditions, known: tuple[Says, ...] = ()) -> Violation | None:
    """Return a point where ``given`` and ``known`` hold but ``says`` fails; None if not found.

    Args:
        says: a relation, several of them (one of them must fail), or an equivalence of two
            equations.
        given: the conditions of the claim.
        known: relations of the claims that are used.

    Example:
        >>> from tresym.reals.language.expression import number
        >>> x = symbol("x")
        >>> above = Relation(x, ">", number(3))
        >>> violation(Relation(x**2, "==", x), (above,)).why[:14]
        'violated at x '
    """
    says, given, known = in_trees(says), _in_trees(given), _in_trees(known)
    for relation, there in _relations(says, known):
        world = _world(given, there)
        sides = (relation.left, relation.right)
        points = points_for(world, world.names(*sides))
        for bits, count in LOOKS:
            for place in points.first(count):
                with ball_precision(bits):
                    left, right = world.values(sides, place)
                    if excluded(left - right, relation.sign):
                        return _violated_at(place)
    return None


def contradiction(says: Says, given: Conditions, known: tuple[Says, ...] = ()) -> str | None:
    """Look for a violation at the points of the independent check; describe it, or return None.

    The points come from `tresym.reals.cross_check`, not from the sampling that the provers and
    :func:`violation` use.

    Args:
        says: the statement, as for :func:`violation`.
        given: the conditions of the claim.
        known: relations that are assumed.
    """
    says, given, known = in_trees(says), _in_trees(given), _in_trees(known)
    for relation, there in _relations(says, known):
        world = _world(given, there)
        ends = (relation.left, relation.right)
        shown = 0
        slow = any(node.op == "integral" for node in binders_in(*ends))
        expensive = bool(world.implicit) or slow
        with ball_precision(BITS):
            for tried, place in enumerate(places(world, world.names(*ends)), 1):
                if place is not None:
                    sides = world.values(ends, place)
                    shown += sides[0].is_finite() and sides[1].is_finite()
                    if excluded(sides[0] - sides[1], relation.sign):
                        seen = " and ".join(map(cross_check.said, sides))
                        return f"{_violated_at(place).why}: the sides are {seen}"
                if shown >= ENOUGH[expensive] or tried >= TRIED[expensive]:
                    break
    return None


def _in_trees(stated: tuple[Any, ...]) -> tuple[Any, ...]:
    return tuple(map(in_trees, stated))


def _relations(says: Says, known: tuple[Says, ...]) -> Iterator[tuple[Relation, tuple[Says, ...]]]:
    """Yield the relations of ``says``, each with what is assumed for it.

    For an equivalence, each side is tested under the assumption of the other.
    """
    if isinstance(says, Equivalent) and len(says.parts) == 2:
        first, second = says.parts
        yield from _relations(second, (*known, first))
        yield from _relations(first, (*known, second))
    elif isinstance(says, Together):
        for part in says.parts:
            yield from _relations(part, known)
    elif isinstance(says, Relation | EqualMatrices):
        yield from ((relation, known) for relation in relations_of(says))


def somewhere(given: Conditions, known: tuple[Says, ...]) -> tuple[Rules, tuple[Place, ...]]:
    """Return the substitution rules of ``known`` and points (or segments) where all may hold.

    Derivatives in the rules of symbols that occur in ``given`` are carried out where this removes
    the integral.
    """
    given, known = _in_trees(given), _in_trees(known)
    world = _world(given, known)
    spoken_of = names_of(*given)
    rules: Rules = {}
    for name, meaning in world.rules:
        done = by_leibniz(worked_out(meaning)) if name in spoken_of else meaning
        rules[symbol(name)] = done if elementary(done) else meaning
    names = world.names(*rules.values())
    return rules, tuple(points_for(world, names, enough=1))


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


def _violated_at(place: Place) -> Violation:
    """Describe the violation at a place."""
    named = sorted((n, (i.low + i.high) / 2, i.low == i.high) for n, i in place.items())
    where = [f"{n} = {fraction_text(v)}" for n, v, exact in named if exact]
    where += [f"a root {n} near {float(v.p) / float(v.q)!r}" for n, v, exact in named if not exact]
    why = "violated at " + (", ".join(where) or "the constants themselves")
    return Violation({n: v for n, v, _ in named}, why)


# Points where the conditions and all used equations hold


@lru_cache(maxsize=512)
def _world(given: Conditions, known: tuple[Says, ...]) -> World:
    """Turn the equations of ``known`` into rules where possible; keep the others as implicit.

    Raises:
        InputError: a condition is none that a point can be tried on.
    """
    if not all(isinstance(c, Relation) for c in given):
        raise InputError("a printed number is no condition on a point")
    relations = [r for says in known for r in relations_of(says)]
    relations += [c for c in given if c.sign == "=="]
    given = tuple(c for c in given if c.sign != "==")
    equations = [r for r in relations if r.sign == "=="]
    rules: dict[str, Expr] = {}
    pending = []
    for left, _, right in equations:
        name = str(left)
        new = left.op == "symbol" and name not in rules
        if new and name not in reached(symbols(right), rules):
            rules[name] = right
        elif left != right:
            pending.append((left, right))
    need_unbound(rules.values(), rules)
    conditioned = names_of(*given)
    plain = tuple(c for c in given if elementary(c.left, c.right))
    implicit: list[Expr] = []
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
    same = [_identical(put_in(e, rules), ZERO, plain) for e in implicit]
    implicit = [e for e, holds in zip(implicit, same, strict=True) if not holds]
    asked = dict.fromkeys((*given, *(r for r in relations if r.sign != "==")))
    small = [c for c in asked if _size((c.left, c.right), rules) <= LARGE]
    others = tuple(c for c in asked if c not in small)
    need_unbound((*implicit, *(side for c in others for side in (c.left, c.right))), rules)
    put = (Relation(put_in(c.left, rules), c.sign, put_in(c.right, rules)) for c in small)
    return World(tuple(dict.fromkeys(put)), tuple(rules.items()), tuple(implicit), others)


def _size(sides: Iterable[Expr], rules: Mapping[str, Expr]) -> int:
    """Return the number of nodes that ``sides`` would have with all rules substituted."""
    known: dict[Expr, int] = {}

    def size(e: Expr) -> int:
        if e not in known:
            rule = rules.get(str(e.args[0])) if e.op == "symbol" else None
            inner = (arg for arg in e.args if isinstance(arg, Expr))
            known[e] = size(rule) if rule is not None else 1 + sum(map(size, inner))
        return known[e]

    return sum(map(size, sides))


@lru_cache(maxsize=512)
def _identical(left: Expr, right: Expr, given: Conditions) -> bool:
    """Return whether the two sides are proved equal under ``given``."""
    one, other = generalised(left, right)
    return decide(one, other, Given(given)).verdict is Verdict.PROVED


def put_in(e: Expr, rules: Mapping[str, Expr]) -> Expr:
    """Replace symbols by their meanings until nothing changes.

    Raises:
        CircularError: a symbol is defined in terms of itself, or occurs where a variable is bound
            on which its meaning depends.
    """
    need_unbound((e,), rules)
    for _ in range(MAX_PASSES):
        changed = substitute(e, rules)
        if changed == e:
            return e
        e = changed
    raise CircularError(f"the definitions of {sorted(rules)} are circular")


def _solved(
    difference: Expr, conditioned: frozenset[str], rules: Mapping[str, Expr]
) -> tuple[str, Expr] | None:
    """Solve ``difference = 0`` for a symbol in which it is linear; None if there is none.

    Symbols that occur in no condition (not in ``conditioned``) are preferred.
    """
    if not elementary(difference):
        return None
    names = symbols(difference)
    for name in sorted(names.difference(rules), key=lambda s: (s in conditioned, s)):
        slope = collected(differentiate(difference, name))
        if name in reached(names - {name}, rules) or name in symbols(slope) or slope == ZERO:
            continue
        try:
            return name, -substitute(difference, {name: ZERO}) / slope
        except ZeroDivisionError:
            continue
    return None
