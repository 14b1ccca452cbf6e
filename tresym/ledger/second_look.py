"""Violations: a point where everything a claim uses holds, and balls there that exclude it.

The equations a claim uses are put in: each is read as a rule for a symbol, solved for one in which
it is linear, or, when neither will do, met on a tiny segment across which it changes sign. Balls
walk over the SymPy expression as it was written, integrals included: nothing is shared with the
trees and the decision procedures that a violation is to contradict, nor with their making.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from dataclasses import dataclass
from functools import lru_cache
from itertools import pairwise
from time import process_time
from typing import Any

from flint import acb, arb, ctx, fmpq
from sympy import (
    Add,
    Basic,
    Derivative,
    Eq,
    Equivalent,
    Integral,
    MatrixBase,
    Mul,
    NumberSymbol,
    Pow,
    Rational,
    Subs,
    Symbol,
    Tuple,
    exp,
    false,
    together,
)
from sympy.core.relational import Relational

from tresym.ledger.claim import Claim, equal, parts_of
from tresym.ledger.meaning import MAX_PASSES, CircularError, tree
from tresym.reals import advocate
from tresym.reals.decisions.identity import decide
from tresym.reals.language.binders import generalised
from tresym.reals.language.expression import FUNCTIONS
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval, fraction_text
from tresym.reals.places.conditions import Given
from tresym.reals.places.points import Range
from tresym.reals.verdict import Verdict

Conditions = tuple[Basic, ...]
Rules = dict[Basic, Basic]
Values = Mapping[Symbol, Any]
Place = Mapping[Symbol, Interval]
"""Exact values, or tiny segments."""
Program = Callable[[Values, bool], Any]

BITS, ROUGH = 128, 64
POINTS = 40
"""Exact points tried before a relation is taken to be unviolated."""
LOOKS = ((BITS, POINTS), (1024, 2))
ENOUGH, TRIED, SHARE = (2, 1), (8, 2), 0.02
"""The advocate's points: those looked at, those tried (also where an integral or a root makes them
dear), and the part of a decision's time that more may take."""
ROOTS = 2
"""Points on an implicit equation that are looked for."""
SPAN, GRID = fmpq(8), 16
"""Where a root is looked for along an unbounded coordinate, and in how many steps."""
PARAMETERS, CELLS = 2, 256
"""Points tried, and cells cut, to show an interval without a root."""
EVALUATIONS = 120
"""How far an integral is refined."""
PROGRAMS = 4096
"""Expressions kept in the form in which balls walk over them."""
WIDTH = fmpq(1, 2**24)
"""Width of the segment on which an implicit equation holds somewhere."""


@dataclass(frozen=True)
class Violation:
    """The point (its centre, where it is a segment) and a sentence on what happens there."""

    point: Mapping[str, fmpq]
    why: str


@dataclass(frozen=True)
class World:
    """Where a claim is tried: conditions, rules that are put in, equations met by search."""

    conditions: Conditions
    rules: tuple[tuple[Basic, Basic], ...]
    implicit: tuple[Basic, ...]
    """Differences that vanish where the equations used hold."""


@lru_cache(maxsize=4096)
def violation(says: Basic, given: Conditions, known: tuple[Basic, ...] = ()) -> Violation | None:
    """A point under ``given`` where all of ``known`` holds and balls violate ``says``, or None.

    Args:
        says: a relation, a `Tuple` of them (one must fail), or an `Equivalent` of two equations.
        known: relations of the claims that are used.
    """
    for relation, held in _relations(says, known):
        world = _world(given, held)
        left, right = _put_in_world(relation, world)
        points = _points(world, _names(left, right))
        for bits, count in LOOKS:
            for place in points[:count]:
                with ball_precision(bits):
                    point = {s: i.ball() for s, i in place.items()}
                    if excluded(value(left, point) - value(right, point), relation.rel_op):
                        return _violated_at(place)
    return None


def contradiction(
    says: Basic, given: Conditions, known: tuple[Basic, ...] = (), spent: float = 0.0
) -> str | None:
    """As :func:`violation`, but at the advocate's points: what is seen there, in words, or None.

    Args:
        spent: seconds that the decision took; with more of them, more points are tried.
    """
    relations = tuple(_relations(says, known))
    for relation, held in relations:
        world = _world(given, held)
        left, right = _put_in_world(relation, world)
        start, shown = process_time(), 0
        dear = bool(world.implicit) or relation.has(Integral)
        with ball_precision(BITS):
            for tried, place in enumerate(_places(world, _names(left, right)), 1):
                if place is not None:
                    point = {s: i.ball() for s, i in place.items()}
                    sides = value(left, point), value(right, point)
                    shown += sides[0].is_finite() and sides[1].is_finite()
                    if excluded(sides[0] - sides[1], relation.rel_op):
                        seen = " and ".join(map(advocate.said, sides))
                        return f"{_violated_at(place).why}: the sides are {seen}"
                enough = shown >= ENOUGH[dear] or tried >= TRIED[dear]
                if enough and process_time() - start > SHARE * spent / len(relations):
                    break
    return None


def _relations(
    says: Basic, known: tuple[Basic, ...]
) -> Iterator[tuple[Relational, tuple[Basic, ...]]]:
    """The relations between numbers that ``says`` consists of, each with what is known there."""
    if isinstance(says, Equivalent):
        first, second = says.args
        yield from _relations(second, (*known, first))
        yield from _relations(first, (*known, second))
    elif isinstance(says, Tuple):
        for part in says.args:
            yield from _relations(part, known)
    elif isinstance(says, Relational):
        yield from ((entry, known) for entry in scalars(says))


def _names(*sides: Basic) -> frozenset[Symbol]:
    return frozenset().union(*(side.free_symbols for side in sides))


def _put_in_world(relation: Relational, world: World) -> tuple[Basic, Basic]:
    left, right = (put_in(side, dict(world.rules)) for side in relation.args)
    return left, right


def rootless(
    function: Basic, variable: Symbol, ends: tuple[Basic, Basic], given: Conditions
) -> Violation | None:
    """A point under ``given`` at which balls show ``function`` without root between ``ends``."""
    names = function.free_symbols.union(*(end.free_symbols for end in ends)) - {variable}
    for place in _points(_world(given, ()), frozenset(names))[:PARAMETERS]:
        with ball_precision(BITS):
            point = {s: i.ball() for s, i in place.items()}
            low, high = (value(end, point) for end in ends)
            cells = [
                (low + (high - low) * n / CELLS).union(low + (high - low) * (n + 1) / CELLS)
                for n in range(CELLS)
            ]
            sides = {_side(value(function, {**point, variable: cell})) for cell in cells}
        if sides in ({1}, {-1}):
            return _violated_at(place)
    return None


def somewhere(given: Conditions, known: tuple[Basic, ...]) -> tuple[Rules, tuple[Place, ...]]:
    """Where ``given`` and ``known`` may hold: what is put in, and points or tiny segments.

    What a condition speaks of is put in with derivatives of integrals by their ends carried out.
    """
    world, rules = _world(given, known), {}
    spoken_of = _names(*given)
    for left, right in world.rules:
        done = _differentiated(right) if isinstance(right, Derivative) else right
        rules[left] = right if left not in spoken_of or done.has(Integral) else done
    wanted = _names(*rules.values()).difference(rules)
    return rules, _points(world, wanted, enough=1)


def excluded(difference: arb, relation: str) -> bool:
    """Whether a ball shows that ``difference`` does not stand in ``relation`` to zero."""
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
    named = sorted((s.name, (i.low + i.high) / 2, i.low == i.high) for s, i in place.items())
    where = [f"{n} = {fraction_text(v)}" for n, v, exact in named if exact]
    where += [f"a root {n} near {float(v.p) / float(v.q)!r}" for n, v, exact in named if not exact]
    why = "violated at " + (", ".join(where) or "the constants themselves")
    return Violation({n: v for n, v, _ in named}, why)


def scalars(equation: Basic) -> list[Basic]:
    """The entries of an equation of matrices; anything else is its own."""
    left, right = equation.args if isinstance(equation, Relational) else (None, None)
    if isinstance(left, MatrixBase) and isinstance(right, MatrixBase):
        return [equal(p, q) for p, q in zip(left, right, strict=True)]
    return [equation]


# Where everything that is used holds


@lru_cache(maxsize=512)
def _world(given: Conditions, known: tuple[Basic, ...]) -> World:
    relations = [entry for relation in known for entry in scalars(relation)]
    rules: Rules = {}
    pending = []
    for equation in (r for r in relations if isinstance(r, Eq)):
        left, right = (put_in(side, rules) for side in equation.args)
        if isinstance(left, Symbol) and left not in right.free_symbols:
            rules[left] = right
        elif left != right:
            pending.append(equation)
    kept = frozenset().union(*(condition.free_symbols for condition in given))
    implicit = []
    for equation in pending:
        left, right = (put_in(side, rules) for side in equation.args)
        if left == right or _identical(left, right):
            continue
        solved = _solved(left - right, kept)
        if solved is None:
            implicit.append(left - right)
        else:
            rules[solved[0]] = solved[1]
    bounds = [r for r in relations if not isinstance(r, Eq)]
    conditions = dict.fromkeys(put_in(c, rules) for c in (*given, *bounds))
    implicit = [put_in(difference, rules) for difference in implicit]
    return World(tuple(conditions), tuple(rules.items()), tuple(implicit))


@lru_cache(maxsize=512)
def _identical(left: Basic, right: Basic) -> bool:
    one, other = generalised(tree(left), tree(right))
    return decide(one, other).verdict is Verdict.PROVED


def rules_of(claims: Iterable[Claim]) -> Rules:
    """The equations that claims say, entry by entry, as replacements of their left sides."""
    parts = (p for claim in claims for p in parts_of(claim.says) if isinstance(p, Eq))
    return {e.lhs: e.rhs for part in parts for e in scalars(part) if not e.lhs.is_number}


def put_in(expression: Basic, rules: Rules) -> Basic:
    """Replace left sides by right sides until none is left, in SymPy's own way.

    Raises:
        CircularError: a symbol is defined by itself, or by a variable that is bound where it is.
    """
    for _ in range(MAX_PASSES):
        for node in expression.atoms(Integral, Derivative, Subs):
            bound = set(node.variables)
            for left, right in rules.items():
                if node == left:  # it is replaced as it stands, where nothing binds its point
                    continue
                if bound & (left.free_symbols | right.free_symbols) and node.has(left):
                    raise CircularError(f"a definition reaches {left}, where a variable is bound")
        replaced = expression.xreplace(rules)
        if replaced == expression:
            return expression
        expression = replaced
    raise CircularError(f"definitions of {sorted(map(str, rules))} never end")


def _solved(difference: Basic, kept: frozenset[Symbol]) -> tuple[Symbol, Basic] | None:
    """A symbol in which ``difference`` is linear, preferably a free one, and its root."""
    if difference.has(Integral):
        return None
    for symbol in sorted(difference.free_symbols, key=lambda s: (s in kept, s.name)):
        slope = difference.diff(symbol)
        if slope != 0 and symbol not in slope.free_symbols:
            return symbol, together(-difference.subs(symbol, 0) / slope)
    return None


@lru_cache(maxsize=512)
def _points(
    world: World, names: frozenset[Symbol], enough: int = ROOTS
) -> tuple[dict[Symbol, Interval], ...]:
    """Points, or tiny segments, on which every condition and equation holds somewhere."""
    if len(world.implicit) > 1 or false in world.conditions:
        return ()
    symbols, plain, hard = _parts(world, names)

    def starts() -> Iterator[dict[Symbol, Interval]]:
        for named in Given.from_sympy(*plain).points(sorted(symbols), POINTS):
            exact = {symbols[name]: Interval(v, v) for name, v in named.items()}
            with ball_precision(BITS):
                inside = all(_holds(c, {s: i.ball() for s, i in exact.items()}) for c in hard)
            if inside:
                yield exact

    if not world.implicit:
        return tuple(starts())
    found: list[dict[Symbol, Interval]] = []
    for grid in _grids(world):
        found = []
        for exact in starts():
            found += _on_equation(world, exact, grid)
            if len(found) >= enough:
                return tuple(found)
    return tuple(found)


def _places(world: World, names: frozenset[Symbol]) -> Iterator[dict[Symbol, Interval] | None]:
    """As :func:`_points`, from those of the advocate; None where one is not shown to be inside."""
    if len(world.implicit) > 1 or false in world.conditions:
        return
    symbols, plain, hard = _parts(world, names)
    order = sorted(symbols)
    given = Given.from_sympy(*plain).comparisons
    for values in advocate.points(order, given, advocate.conditions(order, given)):
        if values is None:
            yield None
            continue
        ends = (Interval(v, v) for v in map(advocate.exact, values))
        exact = dict(zip((symbols[name] for name in order), ends, strict=True))
        if not all(_holds(c, {s: i.ball() for s, i in exact.items()}) for c in hard):
            yield None
        elif world.implicit:
            yield next(_on_equation(world, exact, _grids(world)[0]), None)
        else:
            yield exact


def _parts(
    world: World, names: frozenset[Symbol]
) -> tuple[dict[str, Symbol], list[Basic], list[Basic]]:
    """All symbols by name, the conditions that are plain, and those that are not."""
    conditions = world.conditions
    symbols = {s.name: s for s in names.union(*(e.free_symbols for e in world.implicit))}
    symbols |= {s.name: s for condition in conditions for s in condition.free_symbols}
    hard = [c for c in conditions if c.has(Integral, Derivative, Subs)]
    return symbols, [c for c in conditions if c not in hard], hard


def _grids(world: World) -> tuple[Sequence[int], ...]:
    """An integral is dear: it is first looked at near both ends only."""
    coarse = ((1, GRID - 1),) if world.implicit[0].has(Integral) else ()
    return (*coarse, range(1, GRID))


def _on_equation(
    world: World, exact: dict[Symbol, Interval], grid: Sequence[int]
) -> Iterator[dict[Symbol, Interval]]:
    """At most one segment across the implicit equation, along one coordinate through a point."""
    (difference,) = world.implicit
    plain = (c for c in world.conditions if not c.has(Integral, Derivative, Subs))
    box = Given.from_sympy(*plain).box
    with ball_precision(ROUGH):
        fixed = {s: i.ball() for s, i in exact.items()}
        for symbol in sorted(difference.free_symbols, key=lambda s: (s.name not in box, s.name)):
            low, high = _reach(box.get(symbol.name, Range()))

            def at(v: arb | fmpq, symbol: Symbol = symbol) -> arb:
                return value(difference, {**fixed, symbol: arb(v)})

            segment = _segment(at, [low + (high - low) * n / GRID for n in grid])
            if segment is None or not at(segment.ball()).is_finite():
                continue
            point = {**fixed, symbol: segment.ball()}
            if all(_holds(condition, point) for condition in world.conditions):
                yield {**exact, symbol: segment}
                return


def _reach(where: Range) -> tuple[fmpq, fmpq]:
    low = -SPAN / 2 if where.low is None else where.low
    return low, low + SPAN if where.high is None else where.high


def _segment(function: Callable[[fmpq], arb], grid: Sequence[fmpq]) -> Interval | None:
    """A tiny segment at whose ends ``function`` has opposite signs, between two on ``grid``."""
    signed = ((v, s) for v in grid if (s := _side(function(v))))
    for (start, first), (end, second) in pairwise(signed):
        if first == second:
            continue
        while end - start > WIDTH:
            # Not halved: roots like to lie on halves, where a ball cannot tell the sign.
            middle = (5 * start + 4 * end) / 9
            side = _side(function(middle))
            if not side:
                return None
            start, end = (middle, end) if side == first else (start, middle)
        return Interval(start, end)
    return None


def _side(x: arb) -> int:
    return 1 if x > 0 else -1 if x < 0 else 0


def _holds(condition: Basic, point: Values) -> bool:
    """Whether balls show an inequality, strictly."""
    difference = value(condition.lhs - condition.rhs, point)
    if condition.rel_op == "!=":
        return _side(difference) != 0
    return bool(difference > 0 if condition.rel_op in (">", ">=") else difference < 0)


# Balls over SymPy expressions


def value(e: Basic, point: Values, analytic: bool = False) -> Any:
    """A ball that contains ``e`` at ``point``; not finite where ``e`` is not shown to be defined.

    Args:
        point: symbols to real or complex balls.
        analytic: for integrands: not finite, too, where ``e`` is not shown to be analytic.
    """
    return _program(e)(point, analytic)


@lru_cache(maxsize=PROGRAMS)
def _program(e: Basic, within: Symbol | None = None) -> Program:
    """``e`` as a function of a point, made once: integrands are evaluated thousands of times.

    Args:
        within: of an integrand, its variable: parts without it are looked up in the point.
    """
    if within is not None and e.args and within not in e.free_symbols:
        return lambda point, analytic: point[e]
    match e:
        case Symbol():
            return lambda point, analytic: point[e]
        case Rational():
            exact = fmpq(int(e.p), int(e.q))
            return lambda point, analytic: arb(exact)
        case NumberSymbol():
            constant = {"pi": arb.pi, "E": arb.const_e}[str(e)]
            return lambda point, analytic: constant()
        case Add() | Mul():
            combine = operator.add if isinstance(e, Add) else operator.mul
            return _fold(combine, [_program(argument, within) for argument in e.args])
        case exp():
            argument = _program(e.args[0], within)
            return lambda point, analytic: argument(point, analytic).exp()
        case Pow():
            return _power(_program(e.base, within), e.exp, within)
        case Derivative():
            return _program(_differentiated(e))
        case Subs():
            return _substituted(e)
        case Integral():
            return lambda point, analytic: _integral(e, point)
        case _ if len(e.args) == 1 and (name := e.func.__name__) in (*FUNCTIONS, "Abs"):
            x = _program(e.args[0], within)
            return lambda point, analytic: _function(name, x(point, analytic), analytic)
        case _:
            return lambda point, analytic: arb.nan()


@lru_cache(maxsize=PROGRAMS)
def _without(e: Basic, variable: Symbol) -> frozenset[Basic]:
    """The parts of an integrand that its variable is not in, as :func:`_program` looks them up."""
    if not e.args or isinstance(e, Derivative | Subs | Integral):
        inside = not e.args or variable in e.free_symbols
        return frozenset() if inside else frozenset((e,))
    if variable not in e.free_symbols:
        return frozenset((e,))
    return frozenset().union(*(_without(argument, variable) for argument in e.args))


def _fold(combine: Callable[[Any, Any], Any], parts: list[Program]) -> Program:
    first, *rest = parts

    def folded(point: Values, analytic: bool) -> Any:
        found = first(point, analytic)
        for part in rest:
            found = combine(found, part(point, analytic))
        return found

    return folded


def _substituted(e: Subs) -> Program:
    inner = _program(e.expr)
    values = [(variable, _program(p)) for variable, p in zip(e.variables, e.point, strict=True)]

    def substituted(point: Values, analytic: bool) -> Any:
        return inner({**point, **{v: at(point, analytic) for v, at in values}}, analytic)

    return substituted


def _differentiated(e: Derivative) -> Basic:
    """The derivative by SymPy's rules: Leibniz's for integrals, which stay unevaluated."""
    found = e.expr
    for variable in e.variables:
        found = found.diff(variable)
    return found


def _power(base: Program, exponent: Basic, within: Symbol | None) -> Program:
    if not isinstance(exponent, Rational):
        power = _program(exponent, within)
        return lambda point, analytic: _general_power(
            base(point, analytic), power(point, analytic), analytic
        )
    p, q = int(exponent.p), int(exponent.q)
    return lambda point, analytic: _rational_power(base(point, analytic), p, q, analytic)


def _rational_power(base: Any, p: int, q: int, analytic: bool) -> Any:
    if q > 1:
        if isinstance(base, acb):
            return base.pow(acb(fmpq(p, q)), analytic)
        if not base >= 0:
            return arb.nan()
        base = base.root(q)
    return arb.nan() if p < 0 and base.contains(0) else base**p


def _general_power(base: Any, power: Any, analytic: bool) -> Any:
    if isinstance(base, acb) or isinstance(power, acb):
        return acb(base).pow(acb(power), analytic)
    return (base.log() * power).exp() if base > 0 else arb.nan()


def _function(name: str, x: Any, analytic: bool) -> Any:
    if name == "Abs":
        return abs(x) if isinstance(x, arb) else x.real_abs(analytic)
    if name == "sign":
        if isinstance(x, acb):
            return x.real_sgn(analytic)
        side = _side(x)
        return arb(side) if side else arb.nan()
    if analytic and isinstance(x, acb) and name in ("log", "asin", "acos", "atanh", "acosh"):
        return x.log(analytic) if name == "log" else acb(arb.nan())
    return getattr(x, name)()


def _integral(e: Integral, point: Values) -> arb:
    """A proper integral over one variable, enclosed; widely where it is hard."""
    if len(e.limits) != 1 or len(e.limits[0]) != 3:
        return arb.nan()
    variable, low, high = e.limits[0]
    start, end = value(low, point), value(high, point)
    if not (start.is_finite() and end.is_finite()):
        return arb.nan()

    function, at = _program(e.function, variable), dict(point)
    at |= {part: value(part, point) for part in _without(e.function, variable)}

    def integrand(z: acb, analytic: bool) -> acb:
        at[variable] = z
        return acb(function(at, analytic))

    tolerance = arb(2) ** -min(48, ctx.prec // 2 + 8)
    fine = {"rel_tol": tolerance, "abs_tol": tolerance, "eval_limit": EVALUATIONS}
    found = acb.integral(integrand, acb(start), acb(end), **fine)
    return found.real if found.imag.contains(0) else arb.nan()
