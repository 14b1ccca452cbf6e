"""Check every refutation of an asymptotic claim against the complete statement.

A refutation is accepted only if its values of the parameters satisfy all conditions (inequalities,
equations, integrality), and if the numerical evidence of
:mod:`tresym.asymptotics.numerical_evidence` shows that the claim fails on a side of
its path. Without oscillation the refutation comes from exact leading terms, and it is enough that
the numbers do not contradict it: they cannot resolve an error of 1e-30. Otherwise the answer is
UNDECIDED.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import chain, islice, product

from flint import arb

from tresym.asymptotics.numerical_evidence import Ray, fails, oscillating
from tresym.reals.cross_check import program
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.readable_witnesses import MOST_TRIED, SIMPLE, constants_hold
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, number, substitute, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

BITS = 12_000
NEAR = arb((1, -300))
SEVERAL = 20


def checked(answer: Answer, claim: Comparison, statement: Statement) -> Answer:
    """Return the refutation of a claim along a path, or UNDECIDED if it is not confirmed."""
    path = statement.path
    if path is None:
        raise TypeError("a claim along a path needs its path")
    reduced = statement.implicit or statement.premises or statement.recurrences
    if reduced or statement.has_initial_values or path.together:
        return answer  # the explicit claim to which it was reduced was confirmed itself
    if any(arbitrary(claim)):
        return answer  # the explicit claim for a polynomial in place of f was confirmed itself
    if answer.uniform is False:
        return answer  # it fails uniformly in the parameters, by the limit of the ratio
    names = parameters(claim, statement)
    point = _exact_values(answer.witness or {})
    at = {name: point[name] for name in names if name in point}
    missing = [name for name in names if name not in at]
    for more in _completions(missing, statement, at):
        exact = bool(answer.lemma)  # what is left of it was confirmed itself
        if any(_fails(claim, statement, side, point | more, missing, exact) for side in path.sides):
            others = {name: str(value) for name, value in more.items()}
            return replace(answer, witness=others | dict(answer.witness or {}))
        why = "numerical values along the path do not confirm this"
        break
    else:
        why = "the values found could not be shown to satisfy the conditions"
    why = f"a refutation was found ({answer.why}), but {why}"
    return replace(answer, verdict=Verdict.UNDECIDED, why=why, witness=None, values=None)


def arbitrary(claim: Comparison) -> Iterator[str]:
    """Yield the names of the functions that are left unknown, other than n!."""
    called = (f.args[0].args[0] for e in (claim.left, claim.right) for f in functions(e))
    return (name for name in called if name != FACTORIAL)


def parameters(claim: Comparison, statement: Statement) -> list[str]:
    """Return the variables of a statement other than that of its path."""
    path = statement.path
    trees = [claim.left, claim.right, *claim.differentiated, *statement.said]
    trees += [path.point] if path is not None and path.point is not None else []
    own = {INFINITY.args[0]} | ({path.name} if path is not None else set())
    return sorted(frozenset().union(*map(symbols, trees)) - own)


def _exact_values(witness: Mapping[str, str]) -> dict[str, Expr]:
    found = {}
    for name, text in witness.items():
        try:
            found[name] = parse(text)
        except InputError:  # an interval
            continue
    return {name: value for name, value in found.items() if not symbols(value)}


def _completions(
    missing: list[str], statement: Statement, at: Mapping[str, Expr]
) -> Iterator[dict[str, Expr]]:
    """Values of further parameters with which everything that is said of all of them holds."""
    simple = product(map(number, SIMPLE), repeat=len(missing))
    tried = (dict(zip(missing, values, strict=True)) for values in islice(simple, MOST_TRIED))
    rest = statement.given.mapped(lambda e: substitute(e, at))
    inside = rest.points(missing, SEVERAL) if missing else ()
    others = ({name: number(value.ceil()) for name, value in point.items()} for point in inside)
    for more in chain(tried, others):
        if _satisfies({**at, **more}, statement):
            yield more


def _satisfies(at: Mapping[str, Expr], statement: Statement) -> bool:
    """Whether exact values satisfy the conditions, integers among them, and the equations."""
    whole = (at[name] for name in statement.integers if name in at)
    if not all(value.op == "number" and value.args[0].q == 1 for value in whole):
        return False
    links = statement.given.mapped(lambda e: substitute(e, at)).comparisons
    return constants_hold(links) is not None and all(
        equal_at(substitute(left, at), substitute(right, at), {})
        for left, right in statement.equations
    )


def _fails(
    claim: Comparison,
    statement: Statement,
    side: int,
    point: Mapping[str, Expr],
    chosen: list[str],
    settled: bool = False,
) -> bool:
    """Whether numbers support a refutation at a point; of ``chosen`` parameters it told nothing.

    Args:
        settled: whether it is enough that no numbers speak against it.
    """
    path = statement.path
    assert path is not None
    with ball_precision(BITS):
        values = {name: evaluate(point[name], {}) for name in parameters(claim, statement)}
    ray = Ray(claim, path, side, values, statement.integers)
    shown = fails(ray)
    sides = symbols(claim.left) | symbols(claim.right)
    exact = path.name not in statement.integers and sides.isdisjoint(chosen)
    if shown or (shown is None and (settled or (exact and not oscillating(ray)))):
        return True
    return path.name in point and _touches(claim, values, path.name, point[path.name])


def _touches(claim: Comparison, values: Mapping[str, arb], name: str, x: Expr) -> bool:
    """Whether both sides agree at the point that is named, as far as balls can tell."""
    if claim.relation not in (">", "<", "!="):
        return False
    trees = [claim.left, claim.right, *claim.differentiated]
    with ball_precision(BITS):
        found = program(trees, [*values, name])([*values.values(), evaluate(x, {})])
        return found is not None and bool(abs(found[0] - found[1]).upper() < NEAR)
