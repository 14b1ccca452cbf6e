"""Check every refutation of an asymptotic claim against the complete statement.

A refutation leaves the deciders only if its values of the parameters satisfy everything that was
said of them (inequalities, equations, integrality), and if the numbers of
:mod:`tresym.reals.decisions.asymptotics.numerical_evidence` show the claim to fail on a side of its
path. Where nothing oscillates the refutation is by leading terms, and it is enough that the numbers
do not speak against it: a limit that is wrong by 1e-30 is wrong beyond what they show. Otherwise
the answer is UNDECIDED.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from flint import arb

from tresym.reals.cross_check import program
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.asymptotics.numerical_evidence import Ray, fails, oscillating
from tresym.reals.decisions.claim_parsing import Comparison, Statement
from tresym.reals.decisions.readable_witnesses import constants_hold
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, substitute, symbols
from tresym.reals.language.parsing import INFINITY, parse
from tresym.reals.normal.at_point import equal_at
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

BITS = 12_000
NEAR = arb((1, -300))


def checked(answer: Answer, claim: Comparison, statement: Statement) -> Answer:
    """The refutation of a claim along a path, UNDECIDED where it is not supported."""
    path = statement.path
    if path is None:
        raise TypeError("a claim along a path is read with it")
    names = parameters(claim, statement)
    point = _exact_values(answer.witness or {})
    at = {name: point[name] for name in names if name in point}
    why = _unsupported(at, names, statement)
    if why is None and not any(_fails(claim, statement, side, point) for side in path.sides):
        why = "numbers along the path do not support it"
    if why is None:
        return answer
    why = f"it was taken to be refuted ({answer.why}), but {why}"
    return replace(answer, verdict=Verdict.UNDECIDED, why=why, witness=None, values=None)


def parameters(claim: Comparison, statement: Statement) -> list[str]:
    """The variables of a statement other than that of its path."""
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


def _unsupported(at: Mapping[str, Expr], names: list[str], statement: Statement) -> str | None:
    """What is not shown of the values of the parameters, in words."""
    missing = [name for name in names if name not in at]
    if missing:
        return f"no exact value of {', '.join(missing)} belongs to it"
    for name in statement.integers:
        if name in at and not (at[name].op == "number" and at[name].args[0].q == 1):
            return f"{name} = {at[name]} is no integer"
    links = statement.given.mapped(lambda e: substitute(e, at)).comparisons
    if constants_hold(links) is None:
        return "its values are not shown to satisfy the conditions"
    for left, right in statement.equations:
        if not equal_at(substitute(left, at), substitute(right, at), {}):
            return f"{left} == {right} is not shown at its values"
    return None


def _fails(claim: Comparison, statement: Statement, side: int, point: Mapping[str, Expr]) -> bool:
    path = statement.path
    assert path is not None
    with ball_precision(BITS):
        values = {name: evaluate(point[name], {}) for name in parameters(claim, statement)}
    ray = Ray(claim, path, side, values, statement.integers)
    shown = fails(ray)
    if shown or (shown is None and not oscillating(ray) and path.name not in statement.integers):
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
