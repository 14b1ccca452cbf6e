"""Decide claims in which the root of an equation occurs, ``root(f, y, low, high)``.

The root becomes a variable y under the equation f = 0 and the conditions low < y < high. What holds
for every such y holds for the root, where it exists. A counterexample is one only if the root is
shown to exist there and to be the only one. Example: ``root(y*exp(y) - x, y, 0, oo) <= log(x) given
x >= E`` becomes ``y <= log(x) given y*exp(y) == x, 0 < y, x >= E``.

More methods: a claim without variables is decided by balls around the roots; if f is strictly
increasing between the ends, y ≤ g means f(g) ≥ 0 for every g between them; and on a bounded box of
parameters balls enclose the roots (roots_over_boxes.py).
"""

from __future__ import annotations

from dataclasses import replace
from itertools import islice

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, Decide, failing, refuted
from tresym.reals.decisions.equations import point_of
from tresym.reals.decisions.root_values import between, enclosed, slope_sign
from tresym.reals.decisions.roots_over_boxes import FEW, decide_over_boxes, is_for_balls
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import stands
from tresym.reals.domain.operation_domains import operations
from tresym.reals.functions.row import everywhere
from tresym.reals.functions.table import names
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ZERO,
    Expr,
    fresh,
    integer,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import MIRRORED, NEGATED, Compared
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

PRECISIONS = (128, 600, 2400)
LOOKED_AT = 12
"""Points of the conditions at which it is seen whether the roots exist."""
_NOWHERE = (
    "no point was found at which {} is shown to exist and to be the only zero between its ends"
)


def root_nodes(*trees: Expr) -> list[Expr]:
    """Return the closed root nodes in the trees, outermost ones first, each once."""
    nodes: dict[Expr, None] = {}

    def walk(e: Expr) -> None:
        if not e.hidden or e.op in LEAVES:
            return
        if e.op == "root" and not e.loose:
            nodes[e] = None
        else:
            for arg in e.args:
                walk(arg)

    for e in trees:
        walk(e)
    return list(nodes)


def decide_roots(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim that contains roots of equations.

    Args:
        claim: the comparison.
        statement: its conditions.
        decided: the procedure for claims with equations as conditions.
    """
    nodes = root_nodes(claim.left, claim.right, *claim.differentiated)
    for node in nodes:
        if not elementary(*opened(node)[1:], *node.args[1:]):
            free = (symbols(claim.left) | symbols(claim.right)) - {INFINITY.args[0]}
            if free or statement.path is not None:
                return Answer(
                    Verdict.UNDECIDED,
                    "a root of an equation that contains an integral, a sum or another root is "
                    "supported only in claims without variables",
                )
    free = (symbols(claim.left) | symbols(claim.right)) - {INFINITY.args[0]}
    # Equations may have no solution.
    if not free and (not statement.equations or point_of(statement) is not None):
        result = _constants(claim, {})
        if result is not None:
            return result
    if not all(_is_smooth(d.function, nodes) for d in claim.derivatives if root_nodes(d.function)):
        return Answer(
            Verdict.UNDECIDED,
            "the derivative of a function of a root is supported only where both the function and "
            "the equation are made of functions that are smooth for all real numbers",
        )
    if free and is_for_balls(claim, statement, nodes):
        by_balls = decide_over_boxes(claim, statement, nodes, FEW)
        if by_balls is not None:
            return by_balls
    general, inside = as_variables(claim, statement, nodes)
    answer = decided(general, inside)
    if statement.path is not None:
        return answer
    if answer.verdict is Verdict.UNDECIDED and len(nodes) == 1:
        answer = _by_monotonicity(claim, statement, nodes[0], decided) or answer
    if answer.verdict is Verdict.UNDECIDED:
        by_balls = decide_over_boxes(claim, statement, nodes)
        if by_balls is not None:
            return by_balls
    if answer.verdict is Verdict.REFUTED:
        return _confirmed(answer, claim, statement, nodes)
    if answer:
        missing = _missing(nodes, claim, statement)
        if missing is not None:
            why = f"{_NOWHERE.format(missing)} ({answer.why})"
            return Answer(Verdict.UNDECIDED, why)
        return replace(answer, why=f"for every solution of the equation: {answer.why}", region=None)
    return answer


def as_variables(
    claim: Comparison, statement: Statement, nodes: list[Expr]
) -> tuple[Comparison, Statement]:
    """Return the claim and its conditions with a variable for each root."""
    trees = (claim.left, claim.right, *claim.differentiated, *statement.said)
    taken = {*frozenset().union(*map(symbols, trees))}
    if statement.path is not None:
        taken.add(statement.path.name)
    put: dict[Expr, Expr] = {}
    equations, links = list(statement.equations), list(statement.given.comparisons)
    for node in nodes:
        name = fresh(node.names[0], taken)
        taken.add(name)
        put[node] = symbol(name)
        (own,), body = opened(node)
        equations.append((substitute(body, {own: symbol(name)}), ZERO))
        links += [
            (x, relation, y)
            for x, relation, y in between(node, name).comparisons
            if y not in (INFINITY, -INFINITY)
        ]
    # The derivative of a smooth function of a root exists wherever its formula has a value.
    slopes = tuple(d for d in claim.derivatives if not root_nodes(d.function))
    general = replace(claim, derivatives=slopes).mapped(lambda e: replaced(e, put))
    return general, replace(statement, equations=tuple(equations), given=Given(tuple(links)))


def _is_smooth(e: Expr, nodes: list[Expr]) -> bool:
    """Return whether the function and the equations of its roots are smooth where they are real.

    The formula of such a derivative has no value where the derivative does not exist.
    """
    outside = replaced(e, dict.fromkeys(nodes, ZERO))
    bodies = [opened(node)[1] for node in nodes]
    return all(_is_entire(op) for op in operations((outside,))) and all(
        _is_entire(op) or op.op == "log" for op in operations(bodies)
    )


def _is_entire(op: Expr) -> bool:
    return op.op in _ENTIRE or (op.op == "^" and integer(op.args[1]) is not None)


_ENTIRE = {"+", "*"} | names(lambda row: row.smooth and row.needs is everywhere)


def _constants(claim: Comparison, at: dict[str, fmpq]) -> Answer | None:
    """Decide a claim at a point by balls; None if they overlap."""
    for precision in PRECISIONS:
        with ball_precision(precision):
            left, right = (enclosed(e, at) for e in (claim.left, claim.right))
            if not (left.is_finite() and right.is_finite()):
                return None
            if stands(left - right, NEGATED[claim.relation]):
                return refuted(failing(claim.relation), at, left, right)
            if stands(left - right, claim.relation):
                return Answer(Verdict.ENCLOSED, "balls around the roots prove it")
    return None


def _missing(nodes: list[Expr], claim: Comparison, statement: Statement) -> Expr | None:
    """Return a root that is not shown to exist at any point tried, or None."""
    names = frozenset().union(*(symbols(e) for e in (claim.left, claim.right, *nodes)))
    names -= {INFINITY.args[0]}
    missing = nodes[0]
    for at in _points(sorted(names), statement):
        with ball_precision():
            lost = next((n for n in nodes if not enclosed(n, at).is_finite()), None)
            if lost is None:
                return None
            missing = lost
    return missing


def _points(names: list[str], statement: Statement) -> list[dict[str, fmpq]]:
    if statement.equations:
        return []
    if not names and not statement.given.names:
        return [{}]
    points = islice(statement.given.points(names, 4 * LOOKED_AT), 4 * LOOKED_AT)
    whole = statement.integers
    rounded = ({n: x.ceil() if n in whole else x for n, x in at.items()} for at in points)
    return list(islice(({n: fmpq(x) for n, x in at.items()} for at in rounded), LOOKED_AT))


def _confirmed(
    answer: Answer, claim: Comparison, statement: Statement, nodes: list[Expr]
) -> Answer:
    """Return the refutation if the roots exist at its point, else UNDECIDED."""
    own = frozenset().union(*(symbols(e) for e in (claim.left, claim.right, *statement.said)))
    own -= {INFINITY.args[0]}
    try:
        point = {n: parse(text) for n, text in (answer.witness or {}).items() if n in own}
    except InputError:
        point = {}
    if own <= point.keys():
        with ball_precision(PRECISIONS[1]):
            at = {n: enclosed(e, {}) for n, e in point.items()}
            exact = {n: e.args[0] if e.op == "number" else at[n] for n, e in point.items()}
            values = [enclosed(e, exact) for e in (*nodes, claim.left, claim.right)]
        if all(x.is_finite() for x in values[: len(nodes)]):
            left, right = values[len(nodes) :]
            if _contradicts(left, right, claim.relation) or left.overlaps(right):
                shown = {n: str(e) for n, e in point.items()}
                return replace(answer, witness=shown)
    why = f"a counterexample was found ({answer.why}), but {_NOWHERE.format(nodes[0])}"
    return Answer(Verdict.UNDECIDED, why)


def _contradicts(left: arb, right: arb, relation: str) -> bool:
    return stands(left - right, NEGATED[relation])


def _by_monotonicity(
    claim: Comparison, statement: Statement, node: Expr, decided: Decide
) -> Answer | None:
    """Decide ``root relation g`` by the sign of the function at g, where it is monotone."""
    relation = claim.relation
    if relation not in ("<", "<=", ">", ">=") or claim.derivatives or statement.equations:
        return None
    mark = "[r]"
    gap = replaced(claim.left - claim.right, {node: symbol(mark)})
    factor = differentiate(gap, mark)
    rest = substitute(gap, {mark: ZERO})
    if factor.op != "number" or factor == ZERO or root_nodes(rest):
        return None
    bound = -rest / factor
    relation = relation if factor.args[0] > 0 else MIRRORED[relation]
    slope = slope_sign(node, statement.given)
    if not slope or any(op.op == "sign" for op in operations((bound,))):
        return None
    (name,), body = opened(node, symbols(bound))
    low, high = node.args[1:]
    inside: list[Compared] = []
    for end, beyond in ((low, ">"), (high, "<")):
        if end in (INFINITY, -INFINITY):
            continue
        fails_beyond = relation[0] == ("<" if end is low else ">")
        if fails_beyond and not decided(Comparison(bound, beyond, end), statement):
            return None
        inside.append((bound, beyond, end))
    # The function at the bound has the sign of the slope if the root lies below it.
    at_bound = slope * substitute(body, {name: bound})
    reduced = Comparison(at_bound, MIRRORED[relation], ZERO)
    answer = decided(reduced, replace(statement, given=statement.given & Given(tuple(inside))))
    if not answer:
        return None
    return replace(answer, why=f"the function is monotone, and at {bound} {answer.why}")
