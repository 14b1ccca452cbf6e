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
from typing import NamedTuple

from sympy import Basic, Derivative, Eq, Integral, Subs, Symbol

from tresym.ledger.claim import Claim, Definition, Root, equal, expressions, parts_of
from tresym.ledger.conversion import (
    DEFINING,
    Behind,
    CircularError,
    Conditions,
    conditions,
    known,
    misread,
    sides,
    tree,
)
from tresym.ledger.counterexamples import scalars
from tresym.ledger.evidence.integrals import NotShownError, need_value
from tresym.ledger.evidence.satisfiability import satisfiable
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.finding import Finding
from tresym.ledger.statements import Binding, ExactlyOne
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.language.formula import names
from tresym.reals.numbers.exact import InputError
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
    written: Eq

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
        Entry(tree(e.lhs), tree(e.rhs), claim, e)
        for claim in claims
        if isinstance(claim.proof, INTRODUCING)
        for e in _equations(claim)
    )


def _equations(claim: Claim) -> Iterator[Eq]:
    """Yield the scalar equations of a claim as written.

    For a root, the equation relates the symbol to the function that vanishes at it, with a fresh
    variable in place of the bound one.
    """
    if isinstance(claim.proof, Root):
        new, root = claim.proof.symbol, claim.proof.unique.statement
        if isinstance(root, ExactlyOne) and root.difference is not None:
            stand_in = Symbol(f"[{new}]", real=True)
            yield equal(new, root.difference.xreplace({root.variable: stand_in}))
        return
    parts = (part for part in parts_of(claim.says) if isinstance(part, Eq))
    yield from (entry for part in parts for entry in scalars(part))


def restrictions(claims: Iterable[Claim]) -> tuple[Eq, ...]:
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
    if not all(isinstance(part, Eq) for part in parts_of(claim.says)):
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
    if integrals and not satisfiable(claim.given, parts_of(claim.says)):
        return "no point was found that satisfies the equation"
    return None


def _no_root(claim: Claim, proof: Root) -> str | None:
    """Return why the symbol does not name the unique root, or None if it does."""
    unique = proof.unique.statement
    shown = proof.unique.expect is Verdict.PROVED and proof.unique.given == claim.given
    if not shown or not isinstance(unique, ExactlyOne) or unique.difference is None:
        return "no claim with the same conditions proves that there is exactly one root"
    if claim.says != proof.says:
        return "the statement must be the equation of the root and the interval that contains it"
    asked = (unique.difference, unique.low, unique.high, *claim.given)
    if any(proof.symbol in e.free_symbols for e in asked):
        return f"{proof.symbol} is not a new symbol"
    earlier = {entry.symbol for entry in table(claim.rests_on)}
    return f"{proof.symbol} is not a new symbol" if tree(proof.symbol) in earlier else None


def captured(claim: Claim) -> str | None:
    """Return why a defined symbol is captured by a bound variable, or None if none is.

    A symbol must not be both defined and bound, and it must not occur where a variable is bound on
    which its definition depends: there it denotes a number, not a function of that variable.
    """
    entries = table((*claim.rests_on, claim))
    written = [e for e in expressions(claim) if isinstance(e, Basic)]
    bound: set[str] = set()
    for e in written:
        binders = e.atoms(Integral, Derivative, Subs, Binding)
        bound |= {v.name for node in binders for v in node.variables}
    for entry in entries:
        if entry.symbol.op == "symbol" and symbols(entry.symbol) <= bound:
            return (
                f"{entry.symbol} is defined by {entry.claim.label}, so it must not be used as a "
                "bound variable"
            )
    behind = _behind(entries)
    roots = [root for e in written for root in e.atoms(Binding)]
    for root in roots:
        for symbol in sorted(root.free_symbols, key=str):
            if root.variable.name in behind.get(symbol.name, ()):
                return CAPTURED.format(symbol)
    found = next((name for e in written if bound for name in _misread(e, behind)), None)
    return None if found is None else CAPTURED.format(found)


def confused(claim: Claim) -> str | None:
    """Return why the SymPy assumptions of a symbol are not allowed, or None if they are.

    Symbols are identified by name, and the only assumption that a symbol may carry is that it is
    real. Any other assumption would be used by SymPy without standing among the conditions.
    """
    known: dict[str, Symbol] = {}
    for one in (*claim.rests_on, claim):
        for symbol in one.symbols:
            if known.setdefault(symbol.name, symbol) != symbol:
                return f"{one.label} contains two symbols named {symbol} with different assumptions"
            if symbol not in (Symbol(symbol.name, real=True), Symbol(symbol.name)):
                return (
                    f"SymPy assumes more about {symbol} than that it is real; state such "
                    "assumptions as conditions (given)"
                )
    return None


def _misread(e: Basic, behind: Behind) -> Iterator[str]:
    """Yield the symbols in ``e`` whose definitions depend on a variable that is bound there."""
    try:
        yield from (name for side in sides(e) if (name := misread(side, behind)) is not None)
    except InputError:  # an expression that cannot be converted plays no part in a decision
        return


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


def _agree(one: Entry, two: Entry, once: tuple[Eq, ...]) -> bool:
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
