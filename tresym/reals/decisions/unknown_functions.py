"""Arbitrary functions: treat their values and derivatives as variables.

A claim with f(x) is one about every smooth function f. What holds for all values of the variables
that stand for f(x), f′(x), f(u), … holds for every f. A witness gives each of them a value; there
is a smooth function with these values and slopes where the arguments differ at the witness, and
where that is not shown nothing is refuted.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace

from flint import fmpq

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.integral_rules import Antiderivatives
from tresym.reals.decisions.readable_witnesses import exact_witness
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.domain.operation_domains import bound, needs
from tresym.reals.language.binders import outermost
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.verdict import Verdict

Atoms = dict[Expr, Expr]
"""What stands for the value of an unknown function at arguments that hold no other."""


def decide_unknown(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide a claim about all smooth functions.

    Args:
        decided: the procedure for claims without arbitrary functions.
    """
    antiderivatives = Antiderivatives(statement.given)
    sides = (
        None
        if claim.derivatives
        else [antiderivatives.put_in(e) for e in (claim.left, claim.right)]
    )
    if sides is not None and None not in sides and statement.path is None:
        left, right = (side for side in sides if side is not None)
        claim = replace(claim, left=left, right=right)
    trees = outermost(claim.left, claim.right, *statement.said)
    if statement.path is not None or any(node.op != "unknown" for node in trees):
        why = "integrals, sums, limits and orders of arbitrary functions are not supported"
        return Answer(Verdict.UNDECIDED, why)
    atoms: Atoms = {}
    # Equations about the functions themselves would be asked for again, without end.
    numbers = [pair for pair in statement.equations if not any(map(_has_functions, pair))]
    compared = [c for c in statement.given.comparisons if not any(map(_has_functions, c[::2]))]
    known = replace(statement, equations=tuple(numbers), given=Given(tuple(compared)))

    def is_same(one: Expr, other: Expr) -> bool:
        """Whether both are the same function at arguments that are equal under the conditions."""
        if one.args[0] != other.args[0] or len(one.args) != len(other.args):
            return False
        pairs = list(zip(one.args[1:], other.args[1:], strict=True))
        if any(e.hidden for pair in pairs for e in pair):
            return _is_same(one, other)
        plain = not (known.given.comparisons or known.equations)
        return _is_same(one, other) or (
            not plain and all(decided(Comparison(x, "==", y), known) for x, y in pairs)
        )

    def variable(e: Expr) -> Expr:
        """``e`` with variables for the values of unknown functions, inner ones first."""
        while inner := [node for node in functions(e) if not any(functions_inside(node))]:
            for node in inner:
                if node not in atoms:
                    same = next((v for a, v in atoms.items() if is_same(a, node)), None)
                    atoms[node] = symbol(str(node)) if same is None else same
            e = replaced(e, {node: atoms[node] for node in inner})
        return e

    left, right = variable(claim.left), variable(claim.right)
    plain = statement.mapped(variable)
    real = needs(variable(f) for f in claim.differentiated)
    places = needs(arg for node in atoms for arg in replaced_inside(node, atoms))
    given = plain.given & Given(tuple((e, r.replace(">=", ">"), ZERO) for e, r in real))
    given = given & Given(tuple(bound(*part) for part in places))
    answer = decided(Comparison(left, claim.relation, right), replace(plain, given=given))
    if answer.verdict is Verdict.REFUTED:
        answer = _realised(atoms, answer)
    if answer.verdict is Verdict.REFUTED and not antiderivatives.any_values:
        why = (
            f"it fails for independent values of the integrals ({answer.why}), "
            "but integrals may not take all of these values"
        )
        answer = Answer(Verdict.UNDECIDED, why)
    names = sorted({node.args[0].args[0] for node in atoms})
    what = "some" if answer.verdict is Verdict.REFUTED else "all"
    return replace(answer, why=f"for {what} smooth {', '.join(names)}: {answer.why}")


def _has_functions(e: Expr) -> bool:
    return any(functions(e))


def functions_inside(node: Expr) -> Iterator[Expr]:
    """The unknown functions in the arguments of one."""
    return (inner for arg in node.args[1:] for inner in functions(arg))


def _is_same(one: Expr, other: Expr) -> bool:
    """Whether both are the same function at equal arguments."""
    pairs = zip(one.args[1:], other.args[1:], strict=False)
    return one.args[0] == other.args[0] and all(
        decide(x, y).verdict is Verdict.PROVED for x, y in pairs
    )


def _realised(atoms: Atoms, answer: Answer) -> Answer:
    """The refutation, if some smooth functions have the values of its witness."""
    point = exact_witness(answer)
    if point is not None:
        missing = {name for node in atoms for name in symbols(node)} - point.keys()
        free = {name: number(fmpq(n + 3, n + 2)) for n, name in enumerate(sorted(missing))}
        if _exist(atoms, point | free):
            shown = {name: str(value) for name, value in free.items()}
            return replace(answer, witness=dict(answer.witness or {}) | shown)
    why = (
        f"it fails for independent values of the functions ({answer.why}), "
        "but no functions with all of these values were found"
    )
    return Answer(Verdict.UNDECIDED, why)


def _exist(atoms: Atoms, point: dict[str, Expr]) -> bool:
    """Whether functions with these values exist: their arguments differ, or are one place."""
    point = point | {str(v.args[0]): point.get(str(v.args[0]), ZERO) for v in atoms.values()}
    nodes = []
    with ball_precision():
        for node, variable in atoms.items():
            inner = replaced_inside(node, atoms)
            args = [evaluate(substitute(arg, point), {}) for arg in inner]
            if not all(x.is_finite() for x in args):
                return False
            nodes.append((variable, node.args[0].args, args))
        return all(
            one == other  # the same variable
            or head[0] != heads[0]
            or (head[1] != heads[1] and _are_same(atoms, one, other))
            or any(x != y for x, y in zip(here, there, strict=True))
            for n, (one, head, here) in enumerate(nodes)
            for other, heads, there in nodes[:n]
        )


def replaced_inside(node: Expr, atoms: Atoms) -> tuple[Expr, ...]:
    """The arguments of a function with variables for the values of others."""
    return tuple(replaced(arg, atoms) for arg in node.args[1:])


def _are_same(atoms: Atoms, one: Expr, other: Expr) -> bool:
    """Whether two variables stand for derivatives of a function at one and the same place."""
    first, second = (next(a for a, v in atoms.items() if v == x) for x in (one, other))
    return first.args[1:] == second.args[1:]
