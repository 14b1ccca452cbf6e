"""Read the letter gamma as Euler's constant where a claim holds for no other number.

``sum(1/k, k, 1, n) == log(n) + gamma + O(1/n) as n -> oo`` is false at gamma = 2, but its author
means 0.5772…, which is written EulerGamma. A refuted claim that says nothing else of the variable
gamma is decided again with the constant. If it holds then, and fails at numbers just below and
above, the constant is meant. Of an inequality such as gamma > 1/2 both readings remain, as they do
where it is not known whether a claim holds with the constant; any other claim that holds for other
numbers, too, is one of a variable.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace

from flint import fmpq

from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.expression import Expr, number, substitute, symbols
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

LETTER, CONSTANT = "gamma", "EulerGamma"
NEAR = (fmpq(577, 1000), fmpq(578, 1000))
"""Numbers below and above Euler's constant, 0.57721…"""


def with_euler_constant(
    answer: Answer, statement: Statement, decided: Callable[[Statement], Answer]
) -> Answer:
    """Return a refutation by a value of gamma, or what is decided of Euler's constant.

    Args:
        answer: the answer to the claim with a variable of that name.
        statement: the claim and its conditions.
        decided: the answer to another claim.
    """
    sides = [side for c in statement.comparisons for side in (c.left, c.right)]
    if answer.verdict is not Verdict.REFUTED or not any(LETTER in symbols(e) for e in sides):
        return answer
    path = statement.path
    along = path is not None and LETTER in (path.name, *path.together)
    if along or LETTER in statement.integers or any(LETTER in symbols(e) for e in statement.said):
        return answer

    def of(value: Expr) -> Answer:
        def change(e: Expr) -> Expr:
            return substitute(e, {LETTER: value})

        comparisons = tuple(c.mapped(change) for c in statement.comparisons)
        shown = re.sub(rf"\b{LETTER}\b(?!\()", str(value), statement.read_as)
        return decided(replace(statement.mapped(change), comparisons=comparisons, read_as=shown))

    found = of(parse(CONSTANT))
    if found.verdict is Verdict.REFUTED:
        also = f"; with Euler's constant, {CONSTANT}, for {LETTER}: {found.why}"
        return replace(answer, why=answer.why + also)
    if found and all(of(number(value)).verdict is Verdict.REFUTED for value in NEAR):
        return replace(found, why=f"{LETTER} is read as Euler's constant, {CONSTANT}: {found.why}")
    if found and not any(c.relation in ("<", "<=", ">", ">=") for c in statement.comparisons):
        why = f"{LETTER} is read as a variable, not Euler's constant, which is {CONSTANT}"
        return replace(answer, why=f"{answer.why}; {why}")
    why = (
        f"two readings remain: with Euler's constant, {CONSTANT}, for {LETTER} it is "
        f"{found.verdict.value}, but for the variable: {answer.why}; write {CONSTANT}, or say "
        f"what {LETTER} is by a condition"
    )
    return Answer(Verdict.UNDECIDED, why)
