"""Run the independent check on a user's claim before it passes."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from functools import partial
from itertools import islice

from flint import arb

from tresym.asymptotics.numerical_evidence import Ray, contradicts
from tresym.asymptotics.refutation_check import arbitrary, parameters
from tresym.checking.original_values import against, has_numbers
from tresym.checking.solution_check import contradiction as against_solution
from tresym.reals.cross_check import (
    FALSE,
    conditions,
    contradiction,
    exceptional_points,
    program,
    said,
    where,
)
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.path_regions import conditions_of
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, factorial_arguments, implied_integers
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import is_infinite, outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    DOTS,
    ZERO,
    Expr,
    apply,
    instantiate,
    integer,
    number,
    rebuild,
    replaced,
    substitute,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number

BITS, NEAR_BITS = 512, 12_000
ORDERS_TRIED = 4
ASSIGNMENTS, TRIES = 5, 60
"""Values of the parameters that are attacked, and tried for that."""
EXCEPTIONAL, SERIES_TRIED = 6, 12
"""Exceptional values of the parameters that are attacked along a path, and in a series."""
LENGTHS, TOO_SMALL = (24, 96, 384), arb((1, -30))
"""Numbers of terms of partial sums, and the least difference that counts."""
VALUES = (*map(arb, (1, -2, 0, 2, 3, -1)), arb(1) / 2, arb(5) / 3, arb(-3) / 4, arb(7))
HALVINGS = (0, 1, 2, 3, 5, 8, 13, 21, 34, 55)
"""How often the range of an order is halved on the way to its end."""


def attack(
    comparison: Comparison,
    statement: Statement,
    answer: Answer,
    anywhere: bool = False,
) -> str | None:
    """Return a numerical contradiction to a proved comparison, in words, or None.

    Args:
        anywhere: whether bases of powers need not be positive where an exponent is a variable.
    """
    functions, derivatives = comparison.differentiated, comparison.derivatives
    reduced = statement.premises or statement.recurrences or statement.implicit
    reduced = reduced or statement.has_initial_values
    if statement.path is not None and not reduced and any(arbitrary(comparison)):
        return None  # the explicit claim for an exponential function was attacked itself
    if statement.path is not None and has_numbers(comparison.left, comparison.right):
        return _attack_original(comparison, statement, statement.path, answer)
    if any(map(is_infinite, outermost(comparison.left, comparison.right))):
        # what was put in for it was attacked itself, but not where a parameter is exceptional
        return None if statement.path is not None else _attack_series(comparison, statement)
    if any(node.op == "root" for node in outermost(comparison.left, comparison.right)):
        return None  # the claim with a variable in place of the root was attacked itself
    if statement.premises or statement.recurrences:
        return None  # the explicit claim to which it was reduced was attacked itself
    if statement.has_initial_values:
        return against_solution(comparison, statement, answer)
    if statement.path is not None and statement.path.together:
        return None  # the claim on each face of a cube around the point was attacked itself
    if comparison.relation in ("O", "Theta") and statement.path is None:
        return _attack_root(comparison, statement, replace(answer, region="0 < 1"))
    if statement.implicit:
        return _attack_root(comparison, statement, answer)
    if statement.path is not None and statement.path.name in statement.given.names:
        links = statement.given.comparisons  # what is left holds for all values near the end
        kept = [x for x in links if statement.path.name not in symbols(x[0]) | symbols(x[2])]
        statement = replace(statement, given=Given(tuple(kept)))
    if statement.path is not None:
        against = _attack_order(comparison, statement, answer)
        return against or _attack_path(comparison, statement, statement.path)
    if statement.bounds_derivatives:
        return None  # they are bounded at all points, and are seen at one only
    claim = (comparison.left, comparison.relation, comparison.right)
    if any(DOTS.args[0] in symbols(e) for e in claim[::2]):
        return _attack_dots(comparison, statement)  # its coefficients were attacked themselves
    if any(node.op == "derivative" for node in outermost(*claim[::2])):
        return None  # what Leibniz's rule makes of it was attacked itself
    equations = tuple((x, "==", y) for x, y in statement.equations)
    given = (*statement.given.comparisons, *equations)
    trees = (*claim[::2], *statement.said)
    given = (*given, *((e, ">=", ZERO) for e in factorial_arguments(trees)))
    integers = implied_integers(trees, statement.integers)
    orders = {
        node.args[2] for node in outermost(comparison.left, comparison.right) if node.op == "nth"
    }
    if not orders:
        return contradiction(claim, given, functions, derivatives, integers, anywhere)
    for k in range(ORDERS_TRIED):
        put = {str(order): number(k) for order in orders}
        left, right = (with_orders(e, put) for e in claim[::2])
        there = [(substitute(x, put), r, substitute(y, put)) for x, r, y in given]
        against = contradiction((left, claim[1], right), there, integers=integers)
        if against is not None:
            return f"{against}, where {', '.join(put)} = {k}"
    return None


def _attack_root(claim: Comparison, statement: Statement, answer: Answer) -> str | None:
    """Where the constant certified for a root on a region is exceeded, in words.

    The claim without a constant was attacked after the root was eliminated.
    """
    if answer.constant is None or answer.region is None:
        return None
    high = parse_number(answer.constant.mid) + parse_number(answer.constant.rad)
    size = apply("abs", claim.left) - number(high) * apply("abs", claim.right)
    equations = tuple((x, "==", y) for x, y in statement.equations)
    given = (*statement.given.comparisons, *equations, *conditions_of(answer.region))
    return contradiction((size, "<=", ZERO), given, integers=statement.integers)


def _exceptional(
    comparison: Comparison, statement: Statement, moving: Iterable[str] = ()
) -> Iterator[tuple[dict[str, arb], Comparison]]:
    """Yield exceptional values of the parameters, and the claim with what vanishes there as 0."""
    sides = [comparison.left, comparison.right]
    trees = [*sides, *comparison.differentiated]
    names = sorted(frozenset().union(*map(symbols, [*trees, *statement.said])))
    ends = {str(INFINITY), DOTS.args[0], *moving}
    names = [name for name in names if name not in ends]
    equations = tuple((x, "==", y) for x, y in statement.equations)
    integers = implied_integers([*trees, *statement.said], statement.integers)
    given = (*statement.given.comparisons, *equations)
    for e, _, point in exceptional_points(trees, names, given, integers, frozenset(ends)):
        change = partial(replaced, known={e: ZERO, -e: ZERO})
        yield dict(zip(names, point, strict=True)), comparison.mapped(change)


def _attack_series(comparison: Comparison, statement: Statement) -> str | None:
    """Where the sides of an equation with series keep apart at exceptional values, in words.

    Partial sums converge to different values if their difference changes ever less and is much
    larger than its last change.
    """
    dotted = any(DOTS.args[0] in symbols(e) for e in (comparison.left, comparison.right))
    if comparison.relation != "==" or dotted:
        return None
    with ball_precision(BITS):
        for at, claim in islice(_exceptional(comparison, statement), SERIES_TRIED):
            nodes = [n for n in outermost(claim.left, claim.right) if is_infinite(n)]
            gaps = []
            for terms in LENGTHS:
                cut = {
                    node: rebuild(node, (node.args[0], node.args[1], node.args[1] + terms))
                    for node in nodes
                    if node.op in ("sum", "product") and node.args[1] != -INFINITY
                }
                sides = [replaced(e, cut) for e in (claim.left, claim.right)]
                found = program(sides, [*at], statement.integers)([*at.values()])
                gaps += [] if found is None else [abs(found[0] - found[1])]
            if len(gaps) < len(LENGTHS):
                continue
            first, second = abs(gaps[1] - gaps[0]), abs(gaps[2] - gaps[1])
            settles = second <= first / 2 or second < TOO_SMALL**2
            if settles and gaps[2] > 8 * second and gaps[2] > TOO_SMALL:
                return f"partial sums keep the sides apart at {where([*at], [*at.values()])}"
    return None


def _attack_dots(comparison: Comparison, statement: Statement) -> str | None:
    """Where the sides differ whatever the dots stand for, at exceptional values, in words."""
    with ball_precision(BITS):
        anything = arb(0, arb(10) ** 1000)
        for at, claim in islice(_exceptional(comparison, statement), SERIES_TRIED):
            names = [*at, DOTS.args[0]]
            values = program([claim.left, claim.right], names, statement.integers)
            found = values([*at.values(), anything])
            if found is not None and FALSE[claim.relation](found[0], found[1]):
                shown = where([*at], [*at.values()])
                return f"its sides differ at {shown}, whatever the dots stand for"
    return None


def with_orders(e: Expr, put: Mapping[str, Expr]) -> Expr:
    """Return ``e`` after substituting ``put`` and carrying out derivatives of fixed order."""
    e = substitute(e, put)
    known = {}
    for node in outermost(e):
        order = integer(node.args[2]) if node.op == "nth" else None
        if order is not None:
            known[node] = instantiate(node.args[0], (node.args[1],))
            for _ in range(order):
                known[node] = differentiate(known[node], str(node.args[1]))
    return replaced(e, known)


def _attack_order(claim: Comparison, statement: Statement, answer: Answer) -> str | None:
    """Where the ratio exceeds the constant of an O that is certified on the region, in words."""
    path = statement.path
    if path is None or answer.constant is None or answer.region is None:
        return None
    at = next(_assignments(claim, statement), None)
    if at is None:
        return None
    with ball_precision(BITS):
        constant = arb(parse_number(answer.constant.mid)) + arb(parse_number(answer.constant.rad))
        value = program((claim.left, claim.right, *claim.differentiated), [*at, path.name])
        for x in _along(path, arb(parse_number(answer.region.split()[-1]))):
            found = value([*at.values(), x])
            if found is not None and abs(found[0]) > constant * abs(found[1]):
                sides = f"{said(found[0])} and {said(found[1])}"
                return (
                    f"at {where([path.name], [x])} its sides are {sides}, which "
                    "violates the bound with the constant C"
                )
    return None


def _attack_original(
    claim: Comparison, statement: Statement, path: Path, answer: Answer
) -> str | None:
    """Where quadrature and summation contradict a claim about integrals or sums, in words."""
    bound = reach = None
    if answer.constant is not None and answer.region is not None:
        bound = arb(parse_number(answer.constant.mid)) + arb(parse_number(answer.constant.rad))
        reach = arb(parse_number(answer.region.split()[-1]))
    for at in islice(_assignments(claim, statement), ASSIGNMENTS):
        found = against(claim, path, at, bound, reach)
        if found:
            return found
    return None


def _attack_path(claim: Comparison, statement: Statement, path: Path) -> str | None:
    """Where numbers along the path show the claim to fail, in words.

    The parameters have a few values that satisfy everything that is said of them.
    """
    for at in islice(_assignments(claim, statement), ASSIGNMENTS):
        for side in path.sides:
            if contradicts(Ray(claim, path, side, at, statement.integers)):
                given = f" for {where([*at], [*at.values()])}" if at else ""
                return f"numerical values near the end of the path contradict it{given}"
    with ball_precision(NEAR_BITS):
        exceptional = list(islice(_exceptional(claim, statement, (path.name,)), EXCEPTIONAL))
    for at, there in exceptional:
        for side in path.sides:
            if contradicts(Ray(there, path, side, at, statement.integers)):
                shown = where([*at], [*at.values()])
                return f"numerical values near the end of the path contradict it for {shown}"
    return None


def _assignments(claim: Comparison, statement: Statement) -> Iterator[dict[str, arb]]:
    """Values of the parameters at which all conditions are shown, small integers among them."""
    names = parameters(claim, statement)
    solved = _solved(statement)
    if solved is None:
        return  # the cases of its equations were attacked themselves
    free = [name for name in names if name not in solved]
    found_at: list[dict[str, arb]] = []
    with ball_precision(NEAR_BITS):
        links = statement.given.comparisons
        holds = conditions(names, links, statement.integers)
        values = program([*solved.values()], free, statement.integers)
        for k in range(TRIES if free else 1):
            chosen = {
                name: VALUES[(k + k // 5 * j + 2 * j) % len(VALUES)] for j, name in enumerate(free)
            }
            if any(
                chosen[name].unique_fmpz() is None for name in statement.integers if name in chosen
            ):
                continue
            found = values([*chosen.values()])
            if found is None:
                continue
            at = chosen | dict(zip(solved, found, strict=True))
            whole = all(at[n].unique_fmpz() is not None for n in statement.integers if n in at)
            if whole and holds([at[name] for name in names]):
                found_at.append({name: at[name] for name in names})
            if len(found_at) == ASSIGNMENTS:
                break
    yield from found_at


def _solved(statement: Statement) -> dict[str, Expr] | None:
    """The variables that the equations give in terms of others; None where that is not seen."""
    found: dict[str, Expr] = {}
    for left, right in statement.equations:
        e = substitute(left - right, found)
        for name in sorted(symbols(e)):
            slope = tidied(differentiate(e, name))
            rest = substitute(e, {name: ZERO})
            if slope.op == "number" and slope != ZERO:
                put_in = {name: -rest / slope}
                found = {n: substitute(value, put_in) for n, value in found.items()} | put_in
                break
        else:
            return None
    return found


def _along(path: Path, reach: arb) -> Iterator[arb]:
    """Points of the region that ends at ``reach``, on each side of the path."""
    end = None if path.point is None else program([path.point], [])([])
    for side in path.sides:
        for halvings in HALVINGS:
            for more in (0, 3, 5):
                part = arb(8 - more) / 8 / 2**halvings
                if path.point is None:
                    yield abs(reach) / part * side
                elif end is not None:
                    yield end[0] + reach * part * side
