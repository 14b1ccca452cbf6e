"""What claims state as formulas, their conditions, and definitions that are put in.

Definitions are put in only where a reason names them. Example: where the claim ``y == x**2`` is put
in, ``y + 1`` becomes ``x**2 + 1``; in ``integral(y, x, 0, 1)``, y would be misread (`misread`).
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from functools import lru_cache
from typing import Any

from tresym.ledger.claim import Claim, Definition, ImplicitFunction, Root
from tresym.ledger.formulas import EqualMatrices, in_trees, names_of
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, ordered
from tresym.reals.language.compound import Equivalent, Together
from tresym.reals.language.expression import (
    BINDERS,
    LEAVES,
    Expr,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Conjunction, Equivalence, Formula, Relation
from tresym.reals.numbers.exact import InputError

Rules = dict[Expr, Expr]
Conditions = tuple[Relation, ...]
Behind = Mapping[str, frozenset[str]]
"""For each defined symbol, the names of the symbols that its definition depends on."""
Stage = Relation | tuple[Expr, ...]
"""A stage of a chain: an equation, or the entries of a matrix (one entry for a number)."""

MAX_PASSES = 20
DEFINING = (Definition, ImplicitFunction)
"""Evidence that introduces symbols."""
REMEMBERED = 4096
"""Size of the caches: the same conditions occur at every step of a chain."""


class CircularError(ValueError):
    """Definitions are circular, or a substitution would capture a bound variable."""


def formula(says: Any) -> Formula:
    """Return the formula of a statement.

    Raises:
        InputError: it is not made of relations.
    """
    says = in_trees(says)
    if isinstance(says, Relation):
        return says
    if isinstance(says, Together):
        return Conjunction(tuple(map(formula, says.parts)))
    if isinstance(says, EqualMatrices):
        return Conjunction(says.entries)
    if isinstance(says, Equivalent) and len(says.parts) == 2:
        return Equivalence(*map(formula, says.parts))
    raise InputError(f"{says} is not a relation such as a > 0")


def stage(e: Any) -> Stage:
    """Return the stage that a step of a chain states.

    Raises:
        InputError: ``e`` is neither an equation nor a number.
    """
    found = in_trees(e)
    if isinstance(found, EqualMatrices):
        raise InputError(f"{e} cannot be a step of a chain: state its entries")
    if isinstance(found, Expr):
        return (found,)
    if isinstance(found, Relation) and found.sign == "==":
        return found
    raise InputError(f"{e} cannot be a step of a chain: state an expression or an equation")


def conjuncts(formula: Formula) -> Iterator[Formula]:
    """Yield the conjuncts of a formula, flattening nested conjunctions."""
    if isinstance(formula, Conjunction):
        for part in formula.parts:
            yield from conjuncts(part)
    else:
        yield formula


@lru_cache(maxsize=REMEMBERED)
def conditions(given: tuple[Any, ...]) -> Conditions:
    """Return the conditions of a claim (``given``) as relations.

    Raises:
        InputError: a condition is an equation or an equivalence.
    """
    found = []
    for part in (part for e in given for part in conjuncts(formula(e))):
        if not isinstance(part, Relation) or part.sign == "==":
            raise InputError(f"{part} is not an inequality such as a > 0, as a condition must be")
        found.append(part)
    return tuple(found)


@lru_cache(maxsize=REMEMBERED)
def known(given: Conditions) -> Given:
    """Return the conditions without integrals, derivatives and substitutions, for the provers."""
    return Given(tuple(c for c in given if elementary(c.left, c.right)))


def definitions(claims: Iterable[Claim]) -> Rules:
    """Return the equations that the claims state, as rules from left side to right side."""
    rules: Rules = {}
    for claim in claims:
        if claim.in_formulas:
            for part in conjuncts(formula(claim.decided)):
                if isinstance(part, Relation) and part.sign == "==" and part.left.op != "number":
                    rules[part.left] = part.right
    return rules


def defined(claim: Claim) -> frozenset[str]:
    """Return the symbols of ``claim`` that are defined by it or by a claim it depends on.

    An equation for an integral may define any symbol in it, so all of them are included.
    """
    claims = (claim, *claim.rests_on)
    roots = (c.proof.symbol for c in claims if isinstance(c.proof, Root))
    behind = (c for c in claims if isinstance(c.proof, DEFINING))
    return frozenset(roots).union(*(symbols(left) for c in behind for left in definitions((c,))))


def dependencies(claims: Iterable[Claim]) -> Behind:
    """Return, for each symbol that the claims define, all symbols it depends on (transitively).

    In an assumed equation for an integral, each symbol depends on all others.
    """
    found: dict[str, frozenset[str]] = {}
    for claim in claims:
        given = names_of(*claim.given)
        for left, behind in _dependencies(claim):
            for name in symbols(left) if left.op == "symbol" else behind:
                found[name] = found.get(name, frozenset()) | (behind | given) - {name}
    for _ in found:
        found = {n: of.union(*(found.get(k, frozenset()) for k in of)) for n, of in found.items()}
    return found


def _dependencies(claim: Claim) -> Iterator[tuple[Expr, frozenset[str]]]:
    """Yield each defined symbol (or integral) of a claim with the symbols of its definition."""
    if isinstance(claim.proof, Root):
        unique = claim.proof.unique.statement
        yield symbol(claim.proof.symbol), names_of(unique) if unique else frozenset()
    elif isinstance(claim.proof, DEFINING):
        for left, right in definitions((claim,)).items():
            yield left, symbols(left) | symbols(right)


def dependent(written: Iterable[str], replaced: Iterable[str], behind: Behind) -> str | None:
    """Return a symbol in ``written`` whose definition depends on a replaced symbol, or None.

    Such a symbol makes an instantiation unsound, because it would keep its name although its value
    changes.

    Args:
        written: names of the symbols in the formula.
        replaced: names of the symbols that are replaced.
        behind: the dependencies of defined symbols, see :func:`dependencies`.
    """
    changed = frozenset(replaced)
    found = (n for n in sorted(written) if not changed.isdisjoint(behind.get(n, ())))
    return next(found, None)


def put_in(e: Expr, rules: Rules) -> Expr:
    """Replace left sides by right sides until nothing changes; bound variables are not touched.

    Raises:
        CircularError: the definitions are circular.
    """
    names = {str(left.args[0]): right for left, right in rules.items() if left.op == "symbol"}
    whole = {ordered(p): q for p, q in rules.items()} if len(names) < len(rules) else None
    for _ in range(MAX_PASSES):
        changed = replaced(ordered(e), whole) if whole else substitute(e, names)
        if changed == e:
            return e
        e = changed
    raise CircularError(f"the definitions of {sorted(map(str, rules))} are circular")


def put_into(given: Conditions, rules: Rules) -> Conditions:
    """Return the conditions with the rules substituted, without repetition."""
    changed = (Relation(put_in(c.left, rules), c.sign, put_in(c.right, rules)) for c in given)
    return tuple(dict.fromkeys(changed))


def misread(e: Expr, behind: Behind) -> str | None:
    """Return a symbol in ``e`` that a reader would misunderstand, or None.

    If y is defined as x², then y is a constant in ``∫ y dx``, because the x of the integral is a
    bound variable; a reader would take y for a function of x.
    """
    if e.op in LEAVES:
        return None
    if e.op in BINDERS:
        for name in sorted(symbols(e.args[0])):
            if not behind.get(name, frozenset()).isdisjoint(e.names):
                return name
    found = (misread(arg, behind) for arg in e.args)
    return next((name for name in found if name is not None), None)
