"""The values of a claim's symbols at a point, by the definitions of the claims that it uses."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from functools import partial

from flint import arb, fmpq

from tresym.ledger.claim import Claim, Root
from tresym.ledger.conversion import DEFINING, Conditions, conditions, definitions
from tresym.ledger.formulas import in_order
from tresym.reals.domain.binder_values import At, bracketed, enclosing, value, value_or_nan
from tresym.reals.domain.evaluation import UndefinedError, stands
from tresym.reals.language.binders import root
from tresym.reals.language.compound import Count
from tresym.reals.language.expression import Expr, symbol
from tresym.reals.language.formula import names


@dataclass(frozen=True)
class Rule:
    """The meaning of a symbol, or of a unique root, valid where the conditions hold.

    Attributes:
        meaning: the defining expression.
        given: the conditions.
        claim: the claim that states the rule; None for an equation among the conditions.
    """

    meaning: Expr
    given: Conditions
    claim: Claim | None


Rules = Mapping[str, tuple[Rule, ...]]
"""The meanings of each symbol; of several, the one whose conditions hold is used."""


class Place(dict[str, arb]):
    """Balls for the symbols at given inputs; defined symbols are computed on first use."""

    def __init__(
        self,
        inputs: Mapping[str, arb],
        rules: Rules,
        roots: Mapping[Expr, Rule],
        constant: Place | None = None,
    ) -> None:
        """Store the inputs, the rules for symbols and roots, and the values without inputs."""
        super().__init__(inputs)
        self.rules, self.roots, self.constant = rules, roots, constant
        self._walker = enclosing(self, {"root": partial(bracketed, self._is_one)})

    def __missing__(self, name: str) -> arb:
        if self.constant is not None and name in self.rules and self.constant[name].is_finite():
            return self.constant[name]
        if name not in self.rules:
            raise UndefinedError
        self[name] = arb.nan()  # a circular definition gives NaN instead of endless recursion
        for rule in self.rules[name]:
            if self.meets(rule.given):
                self[name] = self.value(rule.meaning)
        return self[name]

    def value(self, e: Expr) -> arb:
        """Return a ball for ``e``; NaN if it is not shown to be defined."""
        return value_or_nan(e, self._walker)

    def meets(self, given: Conditions) -> bool:
        """Return whether balls confirm the conditions."""
        return all(stands(self.value(c.left - c.right), c.sign) for c in given)

    def _is_one(self, node: Expr, at: At) -> bool:
        """Return whether a claim guarantees that the root is unique at the values ``at``."""
        rule = self.roots.get(in_order(node))
        differences = ((c.left - c.right, c.sign) for c in rule.given) if rule else ()
        return rule is not None and all(
            stands(value(e, at, self._is_one), sign) for e, sign in differences
        )


def place_of(point: Mapping[str, fmpq], claims: Iterable[Claim]) -> Place:
    """Return the values at exact coordinates and of the symbols that the claims define from them.

    A defined symbol is computed from its definition, even if ``point`` gives it a value. It has no
    value if balls do not confirm the conditions of its definition.
    """
    claims = tuple(claims)
    rules = rules_by(c for c in claims if isinstance(c.proof, (*DEFINING, Root)))
    given = {name: arb(x) for name, x in point.items() if name not in rules}
    return Place(given, rules, roots_by(claims))


def rules_by(claims: Iterable[Claim]) -> Rules:
    """Return the equations of the claims for symbols, and their roots, as rules."""
    rules: dict[str, tuple[Rule, ...]] = {}
    for claim in claims:
        meanings = definitions((claim,))
        if isinstance(claim.proof, Root):
            found = one_root(claim.proof.unique)
            meanings = {} if found is None else {symbol(str(claim.proof.symbol)): found[1]}
        for left, right in meanings.items():
            if left.op == "symbol":
                rule = Rule(right, conditions(claim.given), claim)
                rules[left.args[0]] = (*rules.get(left.args[0], ()), rule)
    return rules


def roots_by(claims: Iterable[Claim]) -> dict[Expr, Rule]:
    """Return rules for the roots that the claims prove to be unique."""
    return {in_order(node): Rule(node, given, used) for node, given, used in roots_of(claims)}


def one_root(unique: Claim) -> tuple[str, Expr] | None:
    """Return the unknown and the root of which the claim states that it is the only one, or None.

    Example: that exactly one ``x in (0, 2)`` solves ``x**2 == a`` gives x and ``root(x**2 - a, x,
    0, 2)``.
    """
    says = unique.statement
    if not isinstance(says, Count) or says.how not in ("exactly one", "at most one"):
        return None
    left, sign, right = says.equation
    if sign != "==" or says.closed != (False, False) or says.given:
        return None
    return says.name, root(left - right, says.name, says.low, says.high)


def roots_of(claims: Iterable[Claim]) -> Iterator[tuple[Expr, Conditions, Claim]]:
    """Yield the roots that the claims state to be unique, with the conditions and the claim."""
    for claim in claims:
        found = one_root(claim)
        if found is not None:
            name, node = found
            yield node, tuple(c for c in conditions(claim.given) if name not in names(c)), claim
