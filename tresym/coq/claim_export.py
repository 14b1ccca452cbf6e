"""Export a user's claim to Coq: what ``tresym check --coq`` writes."""

from __future__ import annotations

from itertools import pairwise

from tresym.coq.bound_statements import BoundTheorem, bound_theorem
from tresym.coq.statement import Condition, NotExportedError, Theorem
from tresym.reals.decisions.claim_parsing import statement_of
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.operation_domains import needs
from tresym.reals.language.binders import derivative, elementary
from tresym.reals.language.claims import Written
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.compound import Compound, Equivalent, Formula, Together, leaves
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import Relation


def theorems(statement: Statement, name: str = "claim") -> list[Theorem] | list[BoundTheorem]:
    """Return a theorem for each comparison of a claim.

    Args:
        statement: the parsed claim.
        name: the name of the theorem; numbered if there are several comparisons.

    Raises:
        NotExportedError: this kind of claim cannot be exported yet.
    """
    count = len(statement.comparisons)
    names = [name] if count == 1 else [f"{name}_{n + 1}" for n in range(count)]
    pairs = [*zip(statement.comparisons, names, strict=True)]
    bound = statement.path is not None or not all(elementary(c.left, c.right) for c, _ in pairs)
    if statement.equations and (
        bound or not elementary(*(side for pair in statement.equations for side in pair))
    ):
        raise NotExportedError(
            "conditions that are equations are exported to Coq only for inequalities and equations "
            "of elementary functions"
        )
    if bound:
        return [bound_theorem(comparison, statement, name) for comparison, name in pairs]
    if statement.integers:
        raise NotExportedError("claims about integers without a sum are not exported to Coq yet")
    equal = ((left, "==", right) for left, right in statement.equations)
    given = (*statement.given.comparisons, *equal)
    return [theorem(comparison, given, name) for comparison, name in pairs]


def theorems_of_parts(whole: Compound, name: str = "claim") -> list[Theorem] | list[BoundTheorem]:
    """Return the theorems of a conjunction of comparisons, or of an equivalence of them.

    Raises:
        NotExportedError: it is made of claims in another way, or a part is not exported yet.
    """
    parts = _implications(whole.formula)
    if parts is None:
        raise NotExportedError(
            "of claims made of claims conjunctions and equivalences of comparisons are exported to "
            "Coq as yet"
        )
    found: list[Theorem] = []
    bounds: list[BoundTheorem] = []
    for n, part in enumerate(parts, 1):
        for one in theorems(statement_of(part), f"{name}_{n}"):
            if isinstance(one, Theorem):
                found.append(one)
            else:
                bounds.append(one)
    if found and bounds:
        raise NotExportedError("limits and inequalities at points are exported to Coq one by one")
    return found or bounds


def _implications(formula: Formula) -> list[Written] | None:
    """The comparisons of a conjunction, or those that an equivalence claims under one another."""
    if isinstance(formula, Written):
        return [formula]
    if isinstance(formula, Equivalent):
        parts = [[leaf for leaf in leaves(p) if isinstance(leaf, Written)] for p in formula.parts]
        pairs = [*pairwise(parts), *((b, a) for a, b in pairwise(parts))]
        return [
            leaf._replace(given=(*leaf.given, *(link for other in a for link in other.comparisons)))
            for a, b in pairs
            for leaf in b
        ]
    if isinstance(formula, Together):
        inner = [_implications(part) for part in formula.parts]
        return None if None in inner else [leaf for part in inner for leaf in part or ()]
    return None


def theorem(claim: Comparison, given: tuple[Condition, ...] = (), name: str = "claim") -> Theorem:
    """Return the theorem for one comparison.

    Args:
        claim: the comparison.
        given: the conditions.
        name: the name of the theorem.

    Raises:
        NotExportedError: the claim contains a derivative that is not one side of an equation.
    """
    left, right, by = claim.left, claim.right, None
    parts = needs([left, right, *(side for x, _, y in given for side in (x, y))])
    if claim.derivatives:
        found, *others = claim.derivatives
        side = {left: right, right: left}.get(found.value) if claim.relation == "==" else None
        if others or found.order != 1 or side is None:
            raise NotExportedError(
                "only a first derivative that is one side of an equation is exported to Coq yet"
            )
        inside = [
            (e, ">" if sign == ">=" and found.by in symbols(e) else sign)
            for e, sign in needs([found.function])
        ]
        parts, left, right, by = [*inside, *parts], found.function, side, found.by
    parts = [part for part in dict.fromkeys(parts) if not _plain(*part)]
    used = [left, right, *(e for e, _ in parts), *(e for x, _, y in given for e in (x, y))]
    variables = frozenset().union(*map(symbols, used), {by} if by else ())
    says = Relation(derivative(left, by) if by else left, claim.relation, right)
    return Theorem(name, tuple(sorted(variables)), (), given, tuple(parts), says)


def _plain(e: Expr, relation: str) -> bool:
    """Return whether the relation is obvious, because it is about a rational number."""
    return e.op == "number" and bool(e.args[0] > 0 or (relation == ">=" and e.args[0] == 0))
