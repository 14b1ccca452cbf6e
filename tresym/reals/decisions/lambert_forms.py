"""Eliminate Lambert's W: with x = y e^y, y >= -1, the value W(x) is y.

The function y e^y increases from −1/e to ∞ on [−1, ∞), so that the claim for all x is the claim for
all y. ``lambertw(x) <= log(x) given x >= E`` becomes ``y <= log(y*exp(y)) given y*exp(y) >= E``,
and the path x → ∞ becomes y → ∞. This needs W of one variable alone, ``lambertw(x)``.
"""

from __future__ import annotations

from dataclasses import replace

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    MINUS_ONE,
    ZERO,
    Expr,
    apply,
    fresh,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

MARK = "[W]"


def decide_without_lambert(
    comparison: Comparison, statement: Statement, decided: Decide
) -> Answer | None:
    """Decide a claim about W(x) as one about y with x = y e^y; None if that is not possible."""
    name = _variable(comparison, statement)
    if name is None or comparison.derivatives or statement.integers:
        return None
    path = statement.path
    if path is not None and (path.name != name or (path.point, path.sides) not in _PATHS):
        return None
    trees = (comparison.left, comparison.right, *statement.said)
    new = fresh("w", frozenset().union({name}, *map(symbols, trees)))
    y = symbol(new)
    x = y * apply("exp", y)

    def changed(e: Expr) -> Expr:
        plain = replaced(e, {apply("lambertw", symbol(name)): symbol(MARK)})
        return substitute(plain, {name: x, MARK: y})

    there = statement.given.mapped(changed) if statement.given.comparisons else Given()
    if path is None:
        there = there & Given(((y, ">=", MINUS_ONE),))
    equations = tuple((changed(left), changed(right)) for left, right in statement.equations)
    along = path and replace(path, name=new, reach=None)  # a region speaks of x
    answer = decided(
        comparison.mapped(changed),
        replace(statement, given=there, equations=equations, path=along),
    )
    if not answer and (path is None or answer.verdict is not Verdict.REFUTED):
        return None
    why = f"with {name} = {x} and lambertw({name}) = {new}: {answer.why}"
    witness = None if answer.witness is None else dict(answer.witness)
    if witness is not None and new in witness:
        witness[name] = str(substitute(x, {new: parse(witness.pop(new))}))
    return replace(answer, why=why, witness=witness, region=None, constant=None)


_PATHS = ((None, (1,)), (ZERO, (1,)), (ZERO, (-1,)))


def _variable(comparison: Comparison, statement: Statement) -> str | None:
    """Return the variable of which alone W is taken, or None."""
    trees = (comparison.left, comparison.right, *statement.said)
    arguments = {node.args[0] for node in operations(trees) if node.op == "lambertw"}
    if len(arguments) != 1 or any(e.hidden for e in trees):
        return None
    (inner,) = arguments
    return str(inner.args[0]) if inner.op == "symbol" and symbols(inner) else None
