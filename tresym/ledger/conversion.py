"""Convert a claim's SymPy expressions to trees, once each.

Claims are written in SymPy, which proofs read well in and reports print. What decides them gets
trees and formulas alone, in which integrals, derivatives, values and orders are nodes that bind
their variables. Definitions are put in here, and only those that a reason names.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache

from sympy import Basic, MatrixBase
from sympy import Expr as Expression

from tresym.ledger.claim import Claim, Definition, ImplicitFunction, Root
from tresym.reals.domain.conditions import Given
from tresym.reals.language import sympy as door
from tresym.reals.language.binders import elementary, ordered
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    Expr,
    replaced,
    substitute,
    symbols,
)
from tresym.reals.language.formula import Conjunction, Formula, Relation, relations
from tresym.reals.numbers.exact import InputError

Rules = dict[Expr, Expr]
Conditions = tuple[Relation, ...]
Behind = Mapping[str, frozenset[str]]
"""What each symbol is defined by, by name."""
Stage = Relation | tuple[Expr, ...]
"""What a chain passes through: an equation, or the entries of a matrix; a number has one."""

MAX_PASSES = 20
DEFINING = (Definition, ImplicitFunction)
"""Evidence that introduces symbols."""
REMEMBERED = 4096
"""Translations and signs kept: the same conditions come back at every step of a chain."""


class CircularError(ValueError):
    """Definitions that define a symbol by itself, or reach a variable that is bound."""


@lru_cache(maxsize=REMEMBERED)
def tree(e: Basic) -> Expr:
    """The expression tree of ``e``, nothing of it worked out."""
    return door.unworked(e)


@lru_cache(maxsize=REMEMBERED)
def formula(says: Basic) -> Formula:
    """The formula that a statement is."""
    return door.formula(says)


def stage(e: Basic) -> Stage:
    """What a step of a chain writes down.

    Raises:
        InputError: an inequality, or what is neither a formula nor a number.
    """
    if isinstance(e, MatrixBase):
        return tuple(map(tree, e))
    if not e.is_Relational:
        return (tree(e),)
    found = formula(e)
    if isinstance(found, Relation) and found.sign == "==":
        return found
    raise InputError(f"{e} is no step of a chain")


def sides(e: Basic) -> Iterator[Expr]:
    """The trees that a formula, a matrix or a number consists of."""
    if isinstance(e, MatrixBase):
        yield from map(tree, e)
    elif isinstance(e, Expression):
        yield tree(e)
    else:
        for relation in relations(formula(e)):
            yield from (relation.left, relation.right)


def conjuncts(formula: Formula) -> Iterator[Formula]:
    """What a formula says together, conjunctions taken apart."""
    if isinstance(formula, Conjunction):
        for part in formula.parts:
            yield from conjuncts(part)
    else:
        yield formula


@lru_cache(maxsize=REMEMBERED)
def conditions(given: tuple[Basic, ...]) -> Conditions:
    """What is written under "given", as relations.

    Raises:
        InputError: an equation, or an equivalence.
    """
    found = []
    for part in (part for e in given for part in conjuncts(formula(e))):
        if not isinstance(part, Relation) or part.sign == "==":
            raise InputError(f"{part} is not a condition such as a > 0")
        found.append(part)
    return tuple(found)


@lru_cache(maxsize=REMEMBERED)
def known(given: Conditions) -> Given:
    """The conditions that are decided under: those without integrals, derivatives and values."""
    return Given(tuple(c for c in given if elementary(c.left, c.right)))


def definitions(claims: Iterable[Claim]) -> Rules:
    """The equations that the claims say, as replacements of left sides, entry by entry."""
    rules: Rules = {}
    for claim in claims:
        if claim.in_formulas:
            for part in conjuncts(formula(claim.decided)):
                if isinstance(part, Relation) and part.sign == "==" and part.left.op != "number":
                    rules[part.left] = part.right
    return rules


def defined(claim: Claim) -> frozenset[str]:
    """The symbols that are no variables of ``claim``: what it rests on says what they are.

    An equation for an integral may define any symbol in it.
    """
    claims = (claim, *claim.rests_on)
    roots = (c.proof.symbol.name for c in claims if isinstance(c.proof, Root))
    behind = (c for c in claims if isinstance(c.proof, DEFINING))
    return frozenset(roots).union(*(symbols(left) for c in behind for left in definitions((c,))))


def dependencies(claims: Iterable[Claim]) -> Behind:
    """What each symbol that the claims define depends on, directly or by way of others.

    A symbol of an equation that is assumed for an integral depends on all others in it.
    """
    found: dict[str, frozenset[str]] = {}
    for claim in claims:
        given = frozenset(str(s) for condition in claim.given for s in condition.free_symbols)
        for left, behind in _dependencies(claim):
            for name in symbols(left) if left.op == "symbol" else behind:
                found[name] = found.get(name, frozenset()) | (behind | given) - {name}
    for _ in found:
        found = {n: of.union(*(found.get(k, frozenset()) for k in of)) for n, of in found.items()}
    return found


def _dependencies(claim: Claim) -> Iterator[tuple[Expr, frozenset[str]]]:
    """What a claim defines, and the symbols by which it does."""
    if isinstance(claim.proof, Root):
        unique = claim.proof.unique.statement
        yield tree(claim.proof.symbol), frozenset(map(str, unique.free_symbols if unique else ()))
    elif isinstance(claim.proof, DEFINING):
        for left, right in definitions((claim,)).items():
            yield left, symbols(left) | symbols(right)


def dependent(written: Iterable[str], replaced: Iterable[str], behind: Behind) -> str | None:
    """A symbol among those written that is defined by one that is replaced, and keeps its name.

    To put values into a claim is to put them into all that depends on its variables.
    """
    changed = frozenset(replaced)
    found = (n for n in sorted(written) if not changed.isdisjoint(behind.get(n, ())))
    return next(found, None)


def put_in(e: Expr, rules: Rules) -> Expr:
    """Replace left sides by right sides until none is left; what is bound is left alone.

    Raises:
        CircularError: the definitions go round in a circle.
    """
    names = {str(left.args[0]): right for left, right in rules.items() if left.op == "symbol"}
    whole = {ordered(p): q for p, q in rules.items()} if len(names) < len(rules) else None
    for _ in range(MAX_PASSES):
        changed = replaced(ordered(e), whole) if whole else substitute(e, names)
        if changed == e:
            return e
        e = changed
    raise CircularError(f"definitions of {sorted(map(str, rules))} never end")


def put_into(given: Conditions, rules: Rules) -> Conditions:
    """The conditions with definitions put in, each once."""
    changed = (Relation(put_in(c.left, rules), c.sign, put_in(c.right, rules)) for c in given)
    return tuple(dict.fromkeys(changed))


def misread(e: Expr, behind: Behind) -> str | None:
    """The symbol in ``e``, as it was written, that seems to say something else than it does.

    What is defined by x is a number of its own where x is bound, as y = x² is in ``∫ y dx``; a
    reader would take it for a function.
    """
    if e.op in LEAVES:
        return None
    if e.op in BINDERS:
        for name in sorted(symbols(e.args[0])):
            if not behind.get(name, frozenset()).isdisjoint(e.names):
                return name
    found = (misread(arg, behind) for arg in e.args)
    return next((name for name in found if name is not None), None)
