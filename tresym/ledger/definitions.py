"""The table of definitions of the whole paper, checked before any claim is judged.

Each symbol is defined once, or once in each of several cases, by symbols that do not come back to
it and by a term that exists under the conditions of its definition. Two definitions of one symbol
together prove anything, and so do two that go round in a circle. What is defined is a constant: it
is bound nowhere, nor does it stand where what it is defined by is bound.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

from sympy import Basic, Derivative, Eq, Integral, Subs, Symbol

from tresym.ledger.claim import Claim, Definition, Root, UniqueRoot, equal, expressions, parts_of
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
INTRODUCING = (*DEFINING, Root)
"""Evidence that puts symbols on the table."""


class Entry(NamedTuple):
    """A line of the table: what is defined, by what, and the claim that says so."""

    symbol: Expr
    """A symbol; or the integral of an equation for what stands under it."""
    meaning: Expr
    claim: Claim
    written: Eq

    @property
    def explicit(self) -> bool:
        """Whether the symbol stands for its meaning; else that is what vanishes at it."""
        return self.symbol.op == "symbol" and not isinstance(self.claim.proof, Root)

    @property
    def names(self) -> frozenset[str]:
        """The symbols of both sides."""
        return symbols(self.symbol) | symbols(self.meaning)


def table(claims: Iterable[Claim]) -> tuple[Entry, ...]:
    """What the claims define, or assume, in order."""
    return tuple(
        Entry(tree(e.lhs), tree(e.rhs), claim, e)
        for claim in claims
        if isinstance(claim.proof, INTRODUCING)
        for e in _equations(claim)
    )


def _equations(claim: Claim) -> Iterator[Eq]:
    """The equations of a claim, entry by entry, as they are written.

    A root is put beside the function that vanishes at it, of a variable that nothing binds.
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
    """The equations for integrals that the claims assume, and that restrict their symbols.

    One that only gives a symbol of its own its value restricts nothing.
    """
    entries = table(claims)

    def own(entry: Entry) -> bool:
        others = (e.names for e in entries if e != entry)
        return entry.meaning.op == "symbol" and not any(
            symbols(entry.meaning) <= names for names in (symbols(entry.symbol), *others)
        )

    return tuple(e.written for e in entries if e.symbol.op != "symbol" and not own(e))


def judge_definition(claim: Claim, proof: Definition | Root) -> Finding:
    """A definition holds when its symbols are new, each defined once, by what has a value.

    An equation for an integral defines a symbol in it only where it is assumed, by name, that there
    is one; a point is looked for that satisfies it.
    """
    why = _ill_defined(claim, proof) if isinstance(proof, Definition) else _no_root(claim, proof)
    if why is not None:
        return Finding(UNDECIDED, why)
    names = ", ".join(sorted(str(entry.symbol) for entry in table((claim,))))
    assumes = proof.assumes if isinstance(proof, Definition) else ""
    why = f"assumed: {assumes}" if assumes else f"introduces {names}"
    return Finding(proof.expect, why)


def _ill_defined(claim: Claim, proof: Definition) -> str | None:
    given, entries = conditions(claim.given), table((claim,))
    if known(given).satisfying_point() is None:
        return "no exact point is found that satisfies the conditions"
    if not all(isinstance(part, Eq) for part in parts_of(claim.says)):
        return "a definition consists of equations"
    explicit = {e.symbol: e.meaning for e in entries if e.symbol.op == "symbol"}
    integrals = [e.symbol for e in entries if e.symbol.op == "integral"]
    if not entries or len(explicit) + len(integrals) < len(entries):
        return "a definition gives each of its symbols one value"
    try:
        for e in (*explicit.values(), *integrals):
            need_value(e, given)
    except NotShownError as error:
        return str(error)
    if integrals and not proof.assumes:
        return "that an equation has a solution, and one, is shown or assumed by name"
    if integrals and not satisfiable(claim.given, parts_of(claim.says)):
        return "no point is found that satisfies the equation"
    return None


def _no_root(claim: Claim, proof: Root) -> str | None:
    """Why the symbol is no name for the one root: another is said to be meant, or it is not new."""
    unique = proof.unique.statement
    shown = isinstance(proof.unique.proof, UniqueRoot) and proof.unique.given == claim.given
    if not shown or not isinstance(unique, ExactlyOne) or unique.difference is None:
        return "that there is one root is not shown, or under other conditions"
    if claim.says != proof.says:
        return "what is said is not what the root is"
    asked = (unique.difference, unique.low, unique.high, *claim.given)
    if any(proof.symbol in e.free_symbols for e in asked):
        return f"{proof.symbol} is not a new symbol"
    earlier = {entry.symbol for entry in table(claim.rests_on)}
    return f"{proof.symbol} is not a new symbol" if tree(proof.symbol) in earlier else None


def captured(claim: Claim) -> str | None:
    """Why the claim does not keep its symbols apart: one is bound, and defined.

    Nor may a symbol stand where what it is defined by is bound: it is a number there.
    """
    entries = table((*claim.rests_on, claim))
    written = [e for e in expressions(claim) if isinstance(e, Basic)]
    bound: set[str] = set()
    for e in written:
        binders = e.atoms(Integral, Derivative, Subs, Binding)
        bound |= {v.name for node in binders for v in node.variables}
    for entry in entries:
        if entry.symbol.op == "symbol" and symbols(entry.symbol) <= bound:
            return f"{entry.symbol} is defined by {entry.claim.label}, and bound here"
    behind = _behind(entries)
    roots = [root for e in written for root in e.atoms(Binding)]
    for root in roots:
        for symbol in sorted(root.free_symbols, key=str):
            if root.variable.name in behind.get(symbol.name, ()):
                return f"{symbol} stands where what it is defined by is bound"
    found = next((name for e in written if bound for name in _misread(e, behind)), None)
    return None if found is None else f"{found} stands where what it is defined by is bound"


def confused(claim: Claim) -> str | None:
    """Why symbols are not what their names say: SymPy assumes more of one than that it is real.

    What it assumes is in no condition, and two symbols of one name are one to all that decides.
    """
    known: dict[str, Symbol] = {}
    for one in (*claim.rests_on, claim):
        for symbol in one.symbols:
            if known.setdefault(symbol.name, symbol) != symbol:
                return f"two symbols of {one.label} are called {symbol}, with other assumptions"
            if symbol not in (Symbol(symbol.name, real=True), Symbol(symbol.name)):
                return f"what is assumed of {symbol} beside that it is real belongs under given"
    return None


def _misread(e: Basic, behind: Behind) -> Iterator[str]:
    try:
        yield from (name for side in sides(e) if (name := misread(side, behind)) is not None)
    except InputError:  # what is no expression of ours decides nothing
        return


def _behind(entries: Iterable[Entry]) -> Behind:
    """What each symbol is defined by, or under a condition on, directly or by way of others."""
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
    """Why the definitions among ``claims`` are no table: two of one symbol, or a circle."""
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
    """The claim and its place in the paper."""
    place = claim.where
    if place is None:
        return claim.label
    parts = (("display", place.display), ("line", place.line), ("cell", place.cell))
    return f"{claim.label} ({', '.join(f'{name} {at}' for name, at in parts if at is not None)})"


def _agree(one: Entry, two: Entry, once: tuple[Eq, ...]) -> bool:
    """Whether two equations for a symbol are for different cases, or one is assumed by name.

    What is assumed must be possible as the other symbols are defined.
    """
    given, others = conditions(one.claim.given), conditions(two.claim.given)
    if _exclude(given, others) or _exclude(others, given):
        return True
    if not (_assumes(one.claim) or _assumes(two.claim)):
        return False
    both, pair = (*one.claim.given, *two.claim.given), (one.written, two.written)
    try:
        return satisfiable(both, (*once, *pair))
    except CircularError:  # a symbol is bound there: the equations are taken as they stand
        return satisfiable(both, pair)


def _exclude(given: Conditions, others: Conditions) -> bool:
    """Whether one of ``others`` is shown to fail wherever ``given`` holds."""
    return any(is_manifest(condition.negated, given) for condition in others)


def _assumes(claim: Claim) -> bool:
    return isinstance(claim.proof, Definition) and bool(claim.proof.assumes)


def _circle(meanings: dict[Expr, list[Entry]]) -> str | None:
    """A symbol that is defined by itself, by way of others."""
    behind = _behind(entry for found in meanings.values() for entry in found)
    for left, found in meanings.items():
        if left.op == "symbol" and symbols(left) <= behind[str(left.args[0])]:
            return f"{left} is defined by itself in {_where(found[0].claim)}"
    return None
