"""Find and certify the expansion of an expression: ``tresym.expand``.

The terms are found by :mod:`tresym.asymptotics.expansion`, and the statement with them is decided
like any claim, so that the answer carries the constant and the region of the error.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Any

from tresym.asymptotics.expansion import MOST, terms_of
from tresym.asymptotics.explicit_terms import Terms
from tresym.asymptotics.recurrences import explicit_sequence, growth
from tresym.checking import check
from tresym.checking.dispatch import decide_within_limits
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.roots import as_variables, root_nodes
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.expression import Expr, opened, symbol
from tresym.reals.language.readings import in_latex
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


@dataclass(frozen=True)
class Expansion:
    """An expansion with its certificate.

    Attributes:
        exact: the expression, as text.
        path: where the variable tends.
        terms: the terms as text, the largest first.
        gauge: the comparison function of the error as text; empty if the terms are all of it.
        answer: the verdict of the claim ``exact == terms + O(gauge)``, with constant and region.
        relation: ``~`` or ``Theta`` where only the order of growth is claimed, the one term.
    """

    exact: str
    path: str
    terms: tuple[str, ...]
    gauge: str
    answer: Answer
    relation: str = ""

    @property
    def claim(self) -> str:
        """The claim that was decided, in the grammar of text."""
        return self.answer.read_as

    def __str__(self) -> str:
        if self.relation:
            whole = joined(self.terms)
            said = f"~ {whole}" if self.relation == "~" else f"= {self.relation}({whole})"
            return f"{self.exact} {said}   as {self.path}   ({self.answer.verdict.value})"
        said = f"{self.exact} = {joined(self.terms)}"
        if not self.gauge:
            return f"{said}   ({self.answer.verdict.value})"
        lines = [f"{said} + O({self.gauge})   as {self.path}   ({self.answer.verdict.value})"]
        if self.answer.constant is not None:
            where = f" on {self.answer.region}" if self.answer.region else ""
            lines.append(f"  constant   {self.answer.constant_text()}{where}")
        return "\n".join(lines)

    def as_latex(self) -> str:
        """Return the expansion in LaTeX."""
        return in_latex(self.claim)

    def as_json(self) -> dict[str, Any]:
        """Return a JSON value: ``exact, path, terms, gauge, claim``, and ``answer`` as of check."""
        return {
            "exact": self.exact,
            "path": self.path,
            "terms": list(self.terms),
            "gauge": self.gauge or None,
            "claim": self.answer.as_json(),
        }


def joined(terms: tuple[str, ...]) -> str:
    """Return a sum of terms as text."""
    text = " + ".join(terms) if terms else "0"
    return text.replace("+ -", "- ")


def expand(exact: str, path: str, terms: int = 3, given: str = "", region: str = "") -> Expansion:
    """Return the first terms of the expansion of an expression along a path, certified.

    Args:
        exact: an explicit expression, integrals, sums or factorials, a root of an equation
            ``root(f, y, low, high)``, or an unknown or a sequence a(n) that an equation in
            ``given`` determines.
        path: such as ``"x -> 0"``.
        terms: the number of terms.
        given: conditions; for an unknown also its equation.
        region: where the constant of the error is asked for, such as ``"0 < x <= 1/2"``.

    Returns:
        The terms, the order of the error, and the verdict with constant and region.

    Raises:
        InputError: the text cannot be parsed, or no expansion is found.

    Example:
        >>> print(expand("tan(x)", "x -> 0"))
        tan(x) = x + x**3/3 + 2*x**5/15 + O(x**7)   as x -> 0   (ENCLOSED)
          constant   between 0.0907400 and 0.0912021 on 0 < |x| <= 1
        >>> expand("y", "e -> 0", given="y**5 + e*y == 1, y > 0").terms
        ('1', '-e/5', '-e**2/25')
    """
    if not 1 <= terms <= MOST:
        raise InputError(f"the number of terms goes from 1 to {MOST}")
    under = f" given {given}" if given.strip() else ""
    statement = read(f"{exact} == O(1){under} as {path}")
    if statement.path is None or statement.path.together or statement.path.expression is not None:
        raise InputError("give a path of one variable, such as x -> 0+")
    if statement.recurrences:
        sequence = _of_sequence(exact, statement, under)
        if sequence is not None:
            return sequence
    found = _terms(statement, terms)
    if found is None:
        raise InputError(
            f"no expansion of {exact} as {path} was found: it is sought in powers, exponentials "
            "and logarithms"
        )
    shown = tuple(map(str, found.terms))
    gauge = "" if found.gauge is None else str(found.gauge)
    if not gauge:
        answer = check(f"{exact} == {joined(shown)}{under}")
        return Expansion(exact, str(statement.path), shown, "", answer)
    on = f" on {region}" if region else ""
    together = " uniformly" if statement.has_initial_values and found.uniform else ""
    answer = check(f"{exact} == {joined(shown)} + O({gauge}){together}{under} as {path}{on}")
    if answer.verdict is Verdict.REFUTED:
        raise InputError(
            f"the expansions from the two sides of {path} differ: give one side, such as "
            f"{statement.path.name} -> {statement.path.point}+"
        )
    return Expansion(exact, str(statement.path), shown, gauge, answer)


def _of_sequence(exact: str, statement: Statement, under: str) -> Expansion | None:
    """Return the explicit form of a sequence, or the order of growth of a recursive algorithm."""
    (claim,) = statement.comparisons
    path = statement.path
    assert path is not None
    solution = explicit_sequence(statement)
    if solution is not None and not any(x.op == "sum" for x in outermost(solution[0])):
        form, first = solution
        where = f"{under}, {path.name} integer, {path.name} >= {first}"
        return Expansion(exact, str(path), (str(form),), "", check(f"{exact} == {form}{where}"))
    known = growth(claim.left, statement)
    if known is None:
        return None
    relation, scale = known
    right = f"~ {scale}" if relation == "~" else f"== {relation}({scale})"
    answer = check(f"{exact} {right}{under} as {path}")
    if not answer:
        raise InputError(f"the order of growth of {exact} is not proved: {answer.why}")
    return Expansion(exact, str(path), (str(scale),), "", answer, relation)


def _terms(statement: Statement, count: int) -> Terms | None:
    """Return the terms of the left side of a statement."""
    (claim,) = statement.comparisons
    path = statement.path
    assert path is not None
    if statement.has_initial_values and claim.left.op == "unknown":
        found = _of_solution(statement, count)
        if found is not None:
            return found
    nodes = root_nodes(claim.left)
    if nodes:
        statement = _with_variable(statement, claim.left, nodes)
    name = statement.comparisons[0].left
    return terms_of(name if nodes else claim.left, statement, count, decide_within_limits)


def _of_solution(statement: Statement, count: int) -> Terms | None:
    """Return the terms of the solution of a differential equation with layers or slow times."""
    from tresym.asymptotics.differential_problem import OpenError
    from tresym.asymptotics.layers import layer_terms
    from tresym.asymptotics.slow_times import slow_terms

    path = statement.path
    if path is None:
        return None
    try:
        slow = slow_terms(statement)
        if slow is not None:
            return Terms((slow,), symbol(path.name), uniform=True)
        found = layer_terms(statement, count)
    except OpenError as error:
        raise InputError(str(error)) from None
    return None if found is None else Terms(tuple(found[0]), found[1], uniform=True)


def _with_variable(statement: Statement, e: Expr, nodes: list[Expr]) -> Statement:
    """Return the statement with a variable under an equation for a root."""
    if len(nodes) != 1 or e != nodes[0] or not elementary(*opened(nodes[0])[1:]):
        raise InputError("one root of an explicit equation is expanded at a time")
    (claim,) = statement.comparisons
    general, inside = as_variables(claim, statement, nodes)
    return replace(inside, comparisons=(general,))
