"""Points at which an existential theorem holds, written for Coq.

The witness gives values for some of the variables. Definitions and conditions that are equations
determine others, and the remaining ones are chosen such that the conditions hold. The defect of a
shape is a number that Coq knows to lie between two decimals.
"""

from __future__ import annotations

from collections.abc import Iterator

from flint import fmpq

from tresym.coq.equations import exchanged
from tresym.coq.statement import Theorem, term, variable
from tresym.coq.theorem_trees import Condition
from tresym.ledger.claim import Claim, Counterexample
from tresym.ledger.judge import judge_evidence
from tresym.ledger.paper import racket
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    ONE,
    Expr,
    number,
    substitute,
    symbol,
    symbols,
)

PRECISION = 300
WAYS = "", "inverse_sines; ", "laws; unfold root, acosh, atanh in *; inverse_sines; "


def point_proofs(claim: Claim, whole: Theorem) -> Iterator[str]:
    """Yield scripts for the existence of a point: a counterexample, or inputs of a number."""
    point = witness(claim)
    if point is not None:
        yield from proofs_at(point, whole)


def proofs_at(point: dict[str, fmpq], whole: Theorem) -> Iterator[str]:
    """Yield scripts for an existential theorem; variables without a value are chosen."""
    root = next((m for _, m in whole.definitions if m.left.op == "tanh"), None)
    defect = next(iter(symbols(root.left) - {"a", "b"}), "") if root else ""
    values = chosen(whole, {name: x for name, x in point.items() if name != defect}, defect)
    lines = []
    if root:
        a, b = values.get("a", ONE), values.get("b", ONE)
        if a.op != "number" or b.op != "number":
            return
        enclosed = racket().enclosed
        if enclosed is None:
            return
        low, high = enclosed(a.args[0], b.args[0])
        lines.append(
            f"destruct (defect_exists {term(a, 3)} {term(b, 3)} {low} {high}) as "
            "[E_0 [[L_1 L_2] E_1]]; [lra | lra | lra | unfold turn_short; "
            f"apply not_below; interval with (i_prec {PRECISION}) | unfold turn_short; "
            f"interval with (i_prec {PRECISION}) |]."
        )
    texts = [
        "E_0" if name == defect else f"({term(values.get(name, ONE))})" for name in whole.variables
    ]
    texts = [text.replace(variable(defect), "E_0") if defect else text for text in texts]
    if texts:
        lines.append(f"exists {', '.join(texts)}.")
    equal = "reflexivity | exact E_1 | lra" if root else "reflexivity"
    for way in WAYS:
        yield "\n".join([*lines, f"repeat split; first [{equal} | {way}numeric]."])


def witness(claim: Claim) -> dict[str, fmpq] | None:
    """Return the exact point at which the claim fails."""
    if isinstance(claim.proof, Counterexample):
        return dict(claim.proof.point)
    found = judge_evidence(claim)
    return dict(found.witness) if found and found.witness else None


def chosen(whole: Theorem, point: dict[str, fmpq], free: str) -> dict[str, Expr]:
    """Choose values for the variables: from the point, from equations, or by sampling."""
    values = {name: number(x) for name, x in point.items()}
    equations = [(m.left, m.right) for _, m in whole.definitions if m.sign == "=="]
    equations += [(x, y) for x, sign, y in whole.given if sign == "=="]
    for _ in equations:
        for x, y in equations:
            if x.op != "symbol" or x.args[0] in values or not elementary(y):
                continue
            value = substitute(y, values)
            if symbols(value) <= {free}:  # a number, or as it is written
                written = exchanged(y, {symbol(name): v for name, v in values.items()})
                values[str(x.args[0])] = value if value.op == "number" else written
    left: list[Condition] = []
    for x, sign, y in whole.given:
        x, y = substitute(x, values), substitute(y, values)
        if sign != "==" and symbols(x) | symbols(y) and free not in symbols(x) | symbols(y):
            left.append((x, sign, y))
    if left and (found := Given(tuple(left)).satisfying_point()):
        values |= {name: number(x) for name, x in found.items() if name not in values}
    return values
