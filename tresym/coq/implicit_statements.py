"""Print the implicit function theorem for the equation of a claim.

With L(x, p) = r the equation, x₀ the unknown and p₀ the value of the parameter, the theorem is::

    forall symbols, given -> L(x₀, p₀) = r -> exists values of the derivatives, and
      (exists solution, solution p₀ = x₀, it solves the equation near p₀, its derivative is the
       stated one)
      and every continuous solution through x₀ has that derivative.
"""

from __future__ import annotations

from dataclasses import dataclass

from tresym.coq.statement import ATOM, comparison, formula, has_value, term, variable
from tresym.coq.theorem_trees import Condition, Formula, values_of
from tresym.reals.language.expression import Expr, substitute, symbol
from tresym.reals.language.formula import Relation

SOLUTION, NEAR = "solution", "near"


@dataclass(frozen=True)
class Implicit:
    """An equation has a solution near a point, and its derivative there is the stated one."""

    name: str
    variables: tuple[str, ...]
    given: tuple[Condition, ...]
    equation: Relation
    unknown: str
    parameter: str
    at: Expr
    slope: Relation

    @property
    def body(self) -> str:
        """The proposition as Coq text."""
        bare, names = values_of(self.slope)
        solution, near, at = variable(SOLUTION), variable(NEAR), term(self.at, ATOM)
        start = f"{solution} {at} = {variable(self.unknown)}"
        pair = f"{variable(self.unknown)} {variable(self.parameter)}"
        beside = comparison(abs(symbol(self.parameter) - self.at), "<", symbol(NEAR))
        solves = (
            f"(exists {near} : R, 0 < {near} /\\ forall {pair} : R, {beside} -> "
            f"{variable(self.unknown)} = {solution} {variable(self.parameter)} -> "
            f"{formula(self.equation)})"
        )
        has_slope = f"is_derive {solution} {at} {term(bare.right, ATOM)}"
        values = "".join(f"{has_value(node, term(value))} /\\ " for node, value in names.items())
        lines = [f"  forall {' '.join(map(variable, self.variables))} : R,"]
        lines += [f"  {comparison(*c)} ->  (* given *)" for c in self.given]
        lines += [
            f"  {formula(self._there)} ->  (* equation *)",
            f"  exists {' '.join(map(term, names.values()))} : R, {values}",
            f"  (exists {solution} : R -> R, {start} /\\ {solves} /\\ {has_slope}) /\\",
            f"  (forall {solution} : R -> R, {start} -> continuous {solution} {at} -> {solves} -> "
            f"{has_slope})",
        ]
        return "\n".join(lines)

    @property
    def text(self) -> str:
        """The statement as a sentence of Coq."""
        return f"Theorem {self.name} :\n{self.body}."

    @property
    def _there(self) -> Formula:
        """The equation at the point."""
        at = {self.parameter: self.at}
        return Relation(
            substitute(self.equation.left, at),
            self.equation.sign,
            substitute(self.equation.right, at),
        )
