"""Check every refutation at a point against the complete statement.

A refutation is accepted only if its point satisfies all conditions (inequalities, equations, and
integrality, also of ends of sums and arguments of factorials), both sides are defined there, and
the relation fails. This is shown by evaluation in balls, and exactly where two sides must be equal.
The point includes the values of arbitrary functions, and there must be functions with these values.
Three more kinds of evidence are accepted:

- a box in which the difference is continuous and changes sign, so that it vanishes there;
- a root of a polynomial, with coordinates that are polynomials in it; computation is modulo it;
- an integral with a singular or infinite end, or a series: it is evaluated ever closer to that
  end, and the failure of the relation must become more and more pronounced.

Refutations along a path are checked in asymptotics/refutation_check.py.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from itertools import pairwise, product

from flint import arb, fmpq, fmpq_poly

from tresym.checking.claim_cross_check import with_orders
from tresym.reals.cross_check import FALSE, program
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.readable_witnesses import constants_hold, simple_points
from tresym.reals.decisions.rounding import rounded_numbers
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.binder_values import jumps
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.binders import elementary, outermost, worked_out
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    DOTS,
    ONE,
    ZERO,
    Expr,
    number,
    rebuild,
    replaced,
    substitute,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.language.parsing import parse, parse_claim
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Cause, Verdict

PRECISIONS = (128, 1000, 5000)
STEPS = ((4, 12), (7, 40), (10, 120), (14, 380))
"""How near to a singular end (in powers of 2) an integral is computed, and how many terms."""
SHRINKS = arb("0.1")
"""What gets smaller than this part of itself from step to step may vanish in the limit."""
TINY = arb((1, -15))
MOST_CORNERS = 6
TRUSTED = ("integral", "sum", "product")
"""What a decider has worked out, where numbers do not reach it: they must not speak against it."""
Values = list[tuple[Expr, tuple[Expr, ...], Expr]]
"""Of an unknown function: itself, where it is taken, and the value."""


class _UnsupportedError(Exception):
    """A counterexample could not be confirmed; the text is the reason."""


def confirmed(answer: Answer, claim: Comparison, statement: Statement) -> Answer:
    """Return the refutation of a claim at a point, or UNDECIDED if it is not confirmed."""
    sides = claim.left, claim.right
    if any(DOTS.args[0] in symbols(side) for side in sides):
        return answer  # by a coefficient, which is no point
    if claim.relation in ("O", "Theta"):
        return answer  # along a curve on which the ratio is a power
    if statement.has_initial_values:
        return answer  # the failure of the equation or of an initial value was confirmed itself
    if any(node.op == "root" for node in outermost(*sides)):
        return answer  # confirmed with a variable in place of the root, and by balls around it
    if answer.lemma and statement.bounds_derivatives:
        return answer  # the bound of the largest error was confirmed itself
    try:
        if any(text.startswith("[") for text in (answer.witness or {}).values()):
            _in_box(answer.witness or {}, claim, statement)
        else:
            _at_point(answer, claim, statement)
    except (_UnsupportedError, InputError) as error:
        why = f"a counterexample was found ({answer.why}), but {error}"
        cause = Cause.UNCONFIRMED
        open_ = replace(answer, verdict=Verdict.UNDECIDED, why=why, cause=cause)
        return replace(open_, witness=None, values=None)
    return answer


# At a point


def _at_point(answer: Answer, claim: Comparison, statement: Statement) -> None:
    point = {name: parse(text) for name, text in (answer.witness or {}).items()}
    trees = (claim.left, claim.right, *claim.differentiated, *statement.said)
    names = frozenset().union(*map(symbols, trees))
    taken = {name: value for name, value in point.items() if name in names or name.isidentifier()}
    values: Values = []
    called = frozenset(str(f.args[0].args[0]) for e in trees for f in functions(e))
    for name, value in point.items():
        if name not in taken:
            node = worked_out(parse_claim(f"{name} == 0", called)[0][0])
            node = _inside_known(substitute(node, taken), values)
            if node.op != "unknown":
                raise _UnsupportedError(f"its value of {name} cannot be interpreted")
            values.append((node.args[0], node.args[1:], value))
    taken |= _others(taken, claim, statement)
    for name in statement.integers:
        if name in taken and not (taken[name].op == "number" and taken[name].args[0].q == 1):
            raise _UnsupportedError(f"{name} = {taken[name]} is not an integer")
    if _is_shown_in_balls(taken, claim, statement):
        return

    nodes = [node for node in outermost(*trees) if node.op == "nth"]
    orders = {name: taken[name] for node in nodes for name in symbols(node.args[2])}

    def fixed(e: Expr) -> Expr:
        at = _with_coefficients(substitute(with_orders(e, orders), taken))
        return _with_zero_signs(_known(at, values))

    links = [(fixed(x), relation, fixed(y)) for x, relation, y in statement.given.comparisons]
    if constants_hold(links) is None:
        raise _UnsupportedError("it could not be shown to satisfy the conditions")
    for x, y in statement.equations:
        if not equal_at(fixed(x), fixed(y), {}):
            raise _UnsupportedError(f"it could not be shown to satisfy {x} == {y}")
    left, right, *real = map(fixed, (claim.left, claim.right, *claim.differentiated))
    shown = _fails(left, claim.relation, right, real)
    trusted = (*TRUSTED, "derivative")  # by a value that it has
    worked = any(n.op in trusted for n in outermost(left, right))
    if not (shown or (shown is None and worked)):
        raise _UnsupportedError(
            "it could not be confirmed that both sides are defined and the claim fails there"
        )


def _is_shown_in_balls(taken: Mapping[str, Expr], claim: Comparison, statement: Statement) -> bool:
    """Return whether balls show that all conditions hold strictly and the relation fails."""
    trees = [claim.left, claim.right, *claim.differentiated]
    said = statement.said
    if statement.equations or not elementary(*trees, *said):
        return False
    for bits in PRECISIONS:
        with ball_precision(bits):
            names = sorted(taken)
            at = program([taken[name] for name in names], [])([])
            found = None if at is None else program([*trees, *said], names, statement.integers)(at)
            if found is None:
                continue
            rest = found[len(trees) :]
            relations = [relation for _, relation, _ in statement.given.comparisons]
            if FALSE[claim.relation](found[0], found[1]):
                links = zip(relations, rest[::2], rest[1::2], strict=True)
                return all(FALSE[NEGATED[r]](x, y) for r, x, y in links)
    return False


def _others(taken: Mapping[str, Expr], claim: Comparison, statement: Statement) -> dict[str, Expr]:
    """Return values, allowed by the conditions, of variables that the point leaves out."""
    trees = (claim.left, claim.right, *claim.differentiated, *statement.said)
    names = sorted(frozenset().union(*map(symbols, trees)) - taken.keys() - {str(INFINITY)})
    if not names:
        return {}
    links = statement.given.mapped(lambda e: substitute(e, taken)).comparisons
    links = tuple(link for link in links if symbols(link[0]) | symbols(link[2]))
    found = None
    if all(elementary(*link[::2]) for link in links):
        whole = [name for name in statement.integers if name in names]
        found = next(iter(simple_points(names, Given(links), 1, whole)), None)
        found = found or (None if whole else Given(links).satisfying_point(names))
    if found is None:
        raise _UnsupportedError(f"no values of {', '.join(names)} were found that complete it")
    return {name: number(value) for name, value in found.items()}


def _known(e: Expr, values: Values) -> Expr:
    """Return ``e`` with the values of arbitrary functions substituted; unspecified ones are 1.

    Raises:
        _UnsupportedError: it is not known whether an argument is one that has a value already.
    """
    while nodes := [node for node in _unknown(e) if not any(map(_has_unknown, node.args[1:]))]:
        put = {}
        for node in nodes:
            if node.loose:
                raise _UnsupportedError(
                    "a point cannot contradict a claim about a function under an integral"
                )
            same = [value for head, args, value in values if _is_same(head, args, node)]
            if not same:
                values.append((node.args[0], node.args[1:], ONE))
            put[node] = same[0] if same else ONE
        e = replaced(e, put)
    return e


def _with_coefficients(e: Expr) -> Expr:
    """Return ``e`` with floors of numbers, and with coefficients of power series at numbers."""
    e = rounded_numbers(e)
    nodes = {node for node in outermost(e) if node.op == "coefficient"}
    if not nodes:
        return e
    from tresym.asymptotics.exact_coefficients import with_values

    return with_values(e)


def _with_zero_signs(e: Expr) -> Expr:
    """Return ``e`` with sign(u) as 0 for constants u that are exactly 0, as sqrt(2)**2 - 2."""
    nodes = {n for n in operations((e,)) if n.op == "sign" and not (symbols(n) or n.loose)}
    zero = {}
    for node in nodes:
        with ball_precision():
            found = program(node.args, [])([])
        if found is not None and found[0].contains(0) and equal_at(node.args[0], ZERO, {}):
            zero[node] = ZERO
    return replaced(e, zero) if zero else e


def _inside_known(node: Expr, values: Values) -> Expr:
    """The function with the values of others put in for its arguments."""
    if node.op != "unknown":
        return node
    return rebuild(node, (node.args[0], *(_known(arg, values) for arg in node.args[1:])))


def _unknown(e: Expr) -> Iterator[Expr]:
    return (node for node in functions(e) if node.args[0].args[0] != FACTORIAL)


def _has_unknown(e: Expr) -> bool:
    return next(_unknown(e), None) is not None


def _is_same(head: Expr, args: Iterable[Expr], node: Expr) -> bool:
    if head != node.args[0]:
        return False
    pairs = list(zip(args, node.args[1:], strict=True))
    if any(symbols(x) | symbols(y) for x, y in pairs):
        raise _UnsupportedError("an argument of an arbitrary function has no value there")
    with ball_precision():
        for x, y in pairs:
            found = program([x, y], [])([])
            if found is None:
                raise _UnsupportedError("an argument of an arbitrary function is undefined there")
            if not found[0].overlaps(found[1]):
                return False
    if not all(x == y or equal_at(x, y, {}) for x, y in pairs):
        raise _UnsupportedError("two arguments of an arbitrary function may be equal there")
    return True


def _fails(left: Expr, relation: str, right: Expr, real: list[Expr]) -> bool | None:
    """Return whether the relation of two constants fails; None if balls cannot tell."""
    trees = [left, right, *real]
    if any(symbols(e) - {str(INFINITY)} for e in trees):
        return False
    for bits in PRECISIONS:
        with ball_precision(bits):
            found = program(trees, [])([])
            if found is None:
                continue
            if FALSE[relation](found[0], found[1]):
                return True
            if FALSE[NEGATED[relation]](found[0], found[1]):
                return False
            if relation in (">", "<", "!=") and elementary(*trees):
                return equal_at(left, right, {})
    return None if elementary(*trees) else _fails_on_the_way(left, relation, right)


# Singular ends and series


def _fails_on_the_way(left: Expr, relation: str, right: Expr) -> bool | None:
    """Return whether the failure becomes clearer as integrals and series are computed further.

    An integral that has no value may look as if it had one: so both ends are gone to at one pace,
    and then at two.
    """
    vanishes = relation == "==" and all(_vanishes(left, right, pace) for pace in (1, 2))
    return False if vanishes else None


def _vanishes(left: Expr, right: Expr, pace: int) -> bool:
    """Return whether the difference tends to 0 as integrals and series are computed further."""
    nodes = [n for n in outermost(left, right) if n.op in TRUSTED]
    gaps = []
    for near, terms in STEPS:
        put = {node: _cut(node, near, terms, pace) for node in nodes}
        with ball_precision(PRECISIONS[0]):
            found = program([replaced(e, put) for e in (left, right)], [])([])
            if found is not None and (found[0].is_finite() and found[1].is_finite()):
                gaps.append(found[0] - found[1])
    sizes = list(map(abs, gaps))
    if len(gaps) < 3:
        return False
    return all(y < SHRINKS * x for x, y in pairwise(sizes[-3:])) or bool(sizes[-1] < TINY)


def _cut(node: Expr, near: int, terms: int, pace: int = 1) -> Expr:
    """The integral short of its ends, or the first terms of the series."""
    body, low, high = node.args
    if node.op != "integral":
        return rebuild(node, (body, low, low + terms)) if high == INFINITY else node
    small = number(fmpq(1, 2 ** (3 * near)))
    far = number(2 ** (near // 2 + 1))
    far, less = 3 * far, -far  # not the same on both sides: a principal value is none
    start = less if low == -INFINITY else far if low == INFINITY else low
    stop = pace * far if high == INFINITY else pace * less if high == -INFINITY else high
    gap = (stop - start) * small
    return rebuild(node, (body, start + gap, stop - pace * gap))


# A zero between points


def _in_box(witness: Mapping[str, str], claim: Comparison, statement: Statement) -> None:
    """Confirm that the sides of a strict inequality are equal somewhere in the box."""
    box: dict[str, tuple[fmpq, fmpq]] = {}
    for name, text in witness.items():
        ends = [parse(part) for part in text.strip("[]").split(",")]
        if any(end.op != "number" for end in ends):
            raise _UnsupportedError("its intervals do not have rational ends")
        box[name] = ends[0].args[0], ends[-1].args[0]
    sides = (claim.left, claim.right)
    said = statement.said
    if (
        claim.relation not in (">", "<", "!=")
        or statement.equations
        or any(box[n][0] != box[n][1] or box[n][0].q != 1 for n in statement.integers if n in box)
        or not frozenset().union(*map(symbols, (*sides, *said))) <= box.keys()
        or any(map(jumps, sides))
    ):
        raise _UnsupportedError("its intervals do not fit the claim and its conditions")
    names = sorted(box)
    with ball_precision(PRECISIONS[2]):
        whole = [arb(box[name][0]).union(arb(box[name][1])) for name in names]
        given = program([e for x, _, y in statement.given.comparisons for e in (x, y)], names)
        held = given(whole)
        relations = [relation for _, relation, _ in statement.given.comparisons]
        if held is None or not all(
            FALSE[NEGATED[r]](x, y)
            for r, x, y in zip(relations, held[::2], held[1::2], strict=True)
        ):
            raise _UnsupportedError("the conditions could not be shown to hold on its intervals")
        value = program([*sides, *claim.differentiated], names)
        if value(whole) is None:
            raise _UnsupportedError("the sides could not be shown to be defined on its intervals")
        signs = set()
        moving = [name for name in names if box[name][0] < box[name][1]]
        for corner in product((0, 1), repeat=len(moving[:MOST_CORNERS])):
            at = {name: box[name][0] for name in names}
            at |= {name: box[name][k] for name, k in zip(moving, corner, strict=False)}
            found = value([arb(at[name]) for name in names])
            if found is not None:
                signs |= {1} if found[0] > found[1] else {-1} if found[0] < found[1] else set()
    if signs != {1, -1} and not _vanishes_in(claim.left - claim.right, box):
        raise _UnsupportedError("the difference could not be shown to vanish on its intervals")


def _vanishes_in(difference: Expr, box: Mapping[str, tuple[fmpq, fmpq]]) -> bool:
    """Whether a rational function has a zero, perhaps a double one, as one variable moves."""
    moving = [name for name, (low, high) in box.items() if low < high]
    if len(moving) != 1:
        return False
    low, high = box[moving[0]]
    at = {name: fmpq_poly([end]) for name, (end, _) in box.items()}
    found = _quotient(difference, at | {moving[0]: fmpq_poly([0, 1])})
    if found is None:
        return False
    zeros = found[0] // found[0].gcd(found[0].derivative())
    return bool(zeros(low) * zeros(high) <= 0)


def _quotient(e: Expr, at: Mapping[str, fmpq_poly]) -> tuple[fmpq_poly, fmpq_poly] | None:
    """Numerator and denominator of a rational function of polynomials; None for other functions."""
    one = fmpq_poly([1])
    if e.op == "number":
        return fmpq_poly([e.args[0]]), one
    if e.op == "symbol":
        return (at[e.args[0]], one) if e.args[0] in at else None
    if e.op == "^" and e.args[1].op == "number" and e.args[1].args[0].q == 1:
        base, n = _quotient(e.args[0], at), int(e.args[1].args[0])
        if base is None or abs(n) > 50:
            return None
        top, bottom = base if n >= 0 else base[::-1]
        return top ** abs(n), bottom ** abs(n)
    parts = [_quotient(arg, at) for arg in e.args] if e.op in ("+", "*") else [None]
    top, bottom = fmpq_poly([0 if e.op == "+" else 1]), one
    for part in parts:
        if part is None:
            return None
        top = top * part[1] + part[0] * bottom if e.op == "+" else top * part[0]
        bottom = bottom * part[1]
    return top, bottom
