"""The table of definitions of the whole paper, checked before any claim is judged.

The rules are those of conservative definitions in logic:

- A symbol is defined once, or once in each of several mutually exclusive cases. Two definitions of
  the same symbol could prove anything.
- Definitions are not circular.
- The defining term exists under the conditions of the definition.
- A defined symbol is a constant: it is never a bound variable, and it never occurs where a variable
  is bound on which its definition depends. If y is defined as x², then ∫ y dx is rejected, because
  a reader would take y for a function of x.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import combinations
from typing import Any, NamedTuple

from tresym.ledger.claim import Claim, Definition, Root, expressions
from tresym.ledger.conversion import (
    DEFINING,
    Behind,
    CircularError,
    Conditions,
    conditions,
    known,
    misread,
)
from tresym.ledger.evidence.integrals import NotShownError, need_value
from tresym.ledger.evidence.satisfiability import satisfiable
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import (
    Under,
    all_bound,
    in_trees,
    is_equation,
    names_of,
    parts_of,
    relations_of,
    sides_of,
)
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.compound import Count, Equivalent, Together
from tresym.reals.language.expression import Expr, substitute, symbol, symbols
from tresym.reals.language.formula import Relation, names
from tresym.reals.verdict import Verdict

UNDECIDED = Verdict.UNDECIDED
CAPTURED = "{} occurs where a variable is bound on which its definition depends"
INTRODUCING = (*DEFINING, Root)
"""Types of evidence that add symbols to the table."""


class Entry(NamedTuple):
    """A row of the table: a symbol, its meaning, and the claim that defines it."""

    symbol: Expr
    """A symbol; or an integral, if an equation for it determines a symbol in its integrand."""
    meaning: Expr
    """The defining term; for a root, the function that vanishes at it."""
    claim: Claim
    written: Relation

    @property
    def explicit(self) -> bool:
        """Whether the symbol can be replaced by its meaning (not so for roots and integrals)."""
        return self.symbol.op == "symbol" and not isinstance(self.claim.proof, Root)

    @property
    def names(self) -> frozenset[str]:
        """The names of the symbols on both sides."""
        return symbols(self.symbol) | symbols(self.meaning)


def table(claims: Iterable[Claim]) -> tuple[Entry, ...]:
    """Return the definitions and assumptions among ``claims`` as rows of the table, in order."""
    return tuple(
        Entry(e.left, e.right, claim, e)
        for claim in claims
        if isinstance(claim.proof, INTRODUCING)
        for e in _equations(claim)
    )


def _equations(claim: Claim) -> Iterator[Relation]:
    """Yield the scalar equations of a claim as written.

    For a root, the equation relates the symbol to the function that vanishes at it, with a fresh
    variable in place of the bound one.
    """
    if isinstance(claim.proof, Root):
        new, root = str(claim.proof.symbol), claim.proof.unique.statement
        if isinstance(root, Count) and root.equation[1] == "==":
            left, _, right = root.equation
            stand_in = symbol(f"[{new}]")
            yield Relation(symbol(new), "==", substitute(left - right, {root.name: stand_in}))
        return
    parts = (part for part in parts_of(claim.says) if is_equation(part))
    yield from (entry for part in parts for entry in relations_of(part))


def restrictions(claims: Iterable[Claim]) -> tuple[Relation, ...]:
    """Return the assumed equations for integrals that restrict the values of their symbols.

    An equation whose right side is a symbol that occurs nowhere else only names the integral, so
    it restricts nothing.
    """
    entries = table(claims)

    def own(entry: Entry) -> bool:
        others = (e.names for e in entries if e != entry)
        return entry.meaning.op == "symbol" and not any(
            symbols(entry.meaning) <= names for names in (symbols(entry.symbol), *others)
        )

    return tuple(e.written for e in entries if e.symbol.op != "symbol" and not own(e))


def judge_definition(claim: Claim, proof: Definition | Root) -> Finding:
    """Return DEFINED or ASSUMED if the definition is well-formed, else UNDECIDED with the reason.

    Each symbol must be new, defined once, and defined by a term that has a value. An equation for
    an integral may define a symbol in the integrand only if the existence of a solution is assumed
    by name; a point that satisfies the equation must then be found.
    """
    why = _ill_defined(claim, proof) if isinstance(proof, Definition) else _no_root(claim, proof)
    if why is not None:
        return Finding(UNDECIDED, why)
    names = ", ".join(sorted(str(entry.symbol) for entry in table((claim,))))
    assumes = proof.assumes if isinstance(proof, Definition) else ""
    why = f"assumed: {assumes}" if assumes else f"introduces {names}"
    return Finding(proof.expect, why)


def _ill_defined(claim: Claim, proof: Definition) -> str | None:
    """Return why the definition is not well-formed, or None if it is."""
    given, entries = conditions(claim.given), table((claim,))
    if known(given).satisfying_point() is None:
        return "no exact point was found that satisfies the conditions; check the conditions"
    says = claim.says
    if not all(map(is_equation, parts_of(says))):
        return "a definition must consist of equations"
    explicit = {e.symbol: e.meaning for e in entries if e.symbol.op == "symbol"}
    integrals = [e.symbol for e in entries if e.symbol.op == "integral"]
    if not entries or len(explicit) + len(integrals) < len(entries):
        return "a definition must give each of its symbols exactly one value"
    try:
        for e in (*explicit.values(), *integrals):
            need_value(e, given)
    except NotShownError as error:
        return str(error)
    if integrals and not proof.assumes:
        return (
            "the equation must have exactly one solution: prove this, or name the "
            "assumption in Definition(assumes=...)"
        )
    if integrals and not satisfiable(claim.given, parts_of(says)):
        return "no point was found that satisfies the equation"
    return None


def _no_root(claim: Claim, proof: Root) -> str | None:
    """Return why the symbol does not name the unique root, or None if it does."""
    unique: Any = proof.unique.statement
    new = str(proof.symbol)
    shown = proof.unique.expect is Verdict.PROVED and proof.unique.given == claim.given
    exact = isinstance(unique, Count) and unique.how == "exactly one"
    if not shown or not exact or unique.equation[1] != "==":
        return "no claim with the same conditions proves that there is exactly one root"
    if claim.says != in_trees(proof.says):
        return "the statement must be the equation of the root and the interval that contains it"
    asked = (*unique.equation[::2], unique.low, unique.high, *claim.given)
    if new in names_of(*asked):
        return f"{new} is not a new symbol"
    earlier = {entry.symbol for entry in table(claim.rests_on)}
    return f"{new} is not a new symbol" if symbol(new) in earlier else None


def captured(claim: Claim) -> str | None:
    """Return why a defined symbol is captured by a bound variable, or None if none is.

    A symbol must not be both defined and bound, and it must not occur where a variable is bound on
    which its definition depends: there it denotes a number, not a function of that variable.
    """
    entries = table((*claim.rests_on, claim))
    written = [in_trees(e) for e in expressions(claim)]
    bound: set[str] = set()
    for e in written:
        bound |= all_bound(e)
    for entry in entries:
        if entry.symbol.op == "symbol" and symbols(entry.symbol) <= bound:
            return (
                f"{entry.symbol} is defined by {entry.claim.label}, so it must not be used as a "
                "bound variable"
            )
    behind = _behind(entries)
    for counted in (part for e in written for part in _counted(e)):
        for name in sorted(names_of(counted)):
            if counted.name in behind.get(name, ()):
                return CAPTURED.format(name)
    printed = claim.says if claim.means is not None else None  # which is compared, not decided
    decided = (side for e in written if bound and e != printed for side in sides_of(e))
    for node in operations(decided):
        if node.op == "at" and not _depends(node.args[0], len(node.names)):
            return f"{node.args[0]} does not say how it depends on {node.names[0]}"
    sides = (side for e in written if bound for side in sides_of(e))
    found = next(filter(None, (misread(side, behind) for side in sides)), None)
    return None if found is None else CAPTURED.format(found)


def _depends(body: Expr, count: int, depth: int = 0) -> bool:
    """Return whether the body of a binder contains one of its ``count`` variables."""
    if body.op == "bound":
        return depth <= body.args[0] < depth + count
    if body.loose <= depth:
        return False
    inner = depth + len(body.names)
    return any(_depends(e, count, depth if n else inner) for n, e in enumerate(body.args))


def _counted(says: Any) -> Iterator[Count]:
    """Yield the parts of a statement that count solutions."""
    if isinstance(says, Count):
        yield says
    elif isinstance(says, Under):
        yield from _counted(says.formula)
    elif isinstance(says, Together | Equivalent):
        for part in says.parts:
            yield from _counted(part)


def _behind(entries: Iterable[Entry]) -> Behind:
    """Return all symbols on which each definition or its conditions depend, also indirectly."""
    found: dict[str, frozenset[str]] = {}
    for entry in entries:
        if entry.symbol.op == "symbol":
            asked = frozenset().union(*map(names, conditions(entry.claim.given)))
            (name,) = symbols(entry.symbol)
            found[name] = found.get(name, frozenset()) | symbols(entry.meaning) | asked
    for _ in found:
        found = {n: of.union(*(found.get(k, frozenset()) for k in of)) for n, of in found.items()}
    return found


def conflict(claims: Iterable[Claim]) -> str | None:
    """Return why the definitions among ``claims`` conflict, or None if they are consistent.

    They conflict if a symbol has two definitions that are not for exclusive cases, or if they are
    circular.
    """
    return _conflict(tuple(c for c in claims if isinstance(c.proof, INTRODUCING)))


@lru_cache(maxsize=4096)
def _conflict(claims: tuple[Claim, ...]) -> str | None:
    meanings: dict[Expr, list[Entry]] = {}
    for entry in table(claims):
        meanings.setdefault(entry.symbol, []).append(entry)
    circle = _circle(meanings)
    if circle is not None:
        return circle
    once = tuple(f[0].written for f in meanings.values() if f[0].explicit and len(f) == 1)
    for name, found in meanings.items():
        for one, two in combinations(found, 2):
            if one.meaning != two.meaning and not _agree(one, two, once):
                return f"{name} is defined by {_where(one.claim)} and by {_where(two.claim)}"
    return None


def _where(claim: Claim) -> str:
    """Return the label of the claim and its place in the paper."""
    place = claim.where
    if place is None:
        return claim.label
    parts = (("display", place.display), ("line", place.line), ("cell", place.cell))
    return f"{claim.label} ({', '.join(f'{name} {at}' for name, at in parts if at is not None)})"


def _agree(one: Entry, two: Entry, once: tuple[Relation, ...]) -> bool:
    """Return whether two equations for one symbol are compatible.

    They are if their conditions exclude each other, or if one of them is an assumption and a point
    is found that satisfies both, with the other symbols as defined.
    """
    given, others = conditions(one.claim.given), conditions(two.claim.given)
    if _exclude(given, others) or _exclude(others, given):
        return True
    if not (_assumes(one.claim) or _assumes(two.claim)):
        return False
    both, pair = (*one.claim.given, *two.claim.given), (one.written, two.written)
    try:
        return satisfiable(both, (*once, *pair))
    except CircularError:  # substitution would capture a symbol; leave the definitions out
        return satisfiable(both, pair)


def _exclude(given: Conditions, others: Conditions) -> bool:
    """Return whether one of ``others`` is proved to fail wherever ``given`` holds."""
    return any(is_manifest(condition.negated, given) for condition in others)


def _assumes(claim: Claim) -> bool:
    return isinstance(claim.proof, Definition) and bool(claim.proof.assumes)


def _circle(meanings: dict[Expr, list[Entry]]) -> str | None:
    """Return a sentence on a symbol that is defined in terms of itself, or None."""
    behind = _behind(entry for found in meanings.values() for entry in found)
    for left, found in meanings.items():
        if left.op == "symbol" and symbols(left) <= behind[str(left.args[0])]:
            return f"{left} is defined in terms of itself in {_where(found[0].claim)}"
    return None
