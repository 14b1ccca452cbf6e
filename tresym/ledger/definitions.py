"""The table of definitions: one for the whole paper, checked before anything rests on it.

Each symbol is defined once, or once in each of several cases, by symbols that do not come back to
it and by a term that exists under the conditions of its definition. Two definitions of one symbol
together prove anything, and so do two that go round in a circle. What is defined is a constant: it
is bound nowhere, and no symbol passes for another of its name.
"""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache
from itertools import combinations
from typing import NamedTuple

from sympy import Basic, Derivative, Eq, Integral, Subs, Symbol
from sympy.core.relational import Equality, Relational

from tresym.ledger.claim import Claim, Definition, UniqueRoot, equal, expressions, parts_of
from tresym.ledger.evidence.defined import Conditions
from tresym.ledger.evidence.integrals import NotShownError, need_value
from tresym.ledger.evidence.manifest import is_manifest
from tresym.ledger.finding import Finding
from tresym.ledger.meaning import DEFINING, CircularError, Rules, definitions, put_in
from tresym.ledger.second_look import satisfiable, scalars
from tresym.reals.places.conditions import Given
from tresym.reals.verdict import Verdict

UNDECIDED = Verdict.UNDECIDED


class Entry(NamedTuple):
    """A line of the table: what is defined, by what, and the claim that says so."""

    symbol: Basic
    """A symbol; or the integral of an equation for what stands under it."""
    meaning: Basic
    claim: Claim


def table(claims: Iterable[Claim]) -> tuple[Entry, ...]:
    """What the claims define, or assume, in order."""
    defining = (claim for claim in claims if isinstance(claim.proof, DEFINING))
    return tuple(Entry(*rule, c) for c in defining for rule in definitions((c,)).items())


def implicit(claims: Iterable[Claim]) -> tuple[Eq, ...]:
    """The equations for integrals that the claims assume, and that restrict their symbols."""
    return tuple(equal(e.symbol, e.meaning) for e in _restrictions(table(claims)))


def _restrictions(entries: tuple[Entry, ...]) -> list[Entry]:
    """The equations for integrals, but for those that only give a symbol of their own its value."""

    def own(entry: Entry) -> bool:
        others = (e.symbol.free_symbols | e.meaning.free_symbols for e in entries if e != entry)
        return entry.meaning.is_Symbol and not any(
            entry.meaning in names for names in (entry.symbol.free_symbols, *others)
        )

    return [e for e in entries if not e.symbol.is_Symbol and not own(e)]


def judge_definition(claim: Claim, proof: Definition) -> Finding:
    """A definition holds when its symbols are new, each defined once, by what has a value.

    An equation for an integral defines a symbol in it only where it is assumed, by name, that there
    is one; a point is looked for that satisfies it.
    """
    why = _ill_defined(claim, proof)
    if why is not None:
        return Finding(UNDECIDED, why)
    names = ", ".join(sorted(str(entry.symbol) for entry in table((claim,))))
    why = f"assumed: {proof.assumes}" if proof.assumes else f"introduces {names}"
    return Finding(proof.premise, why)


def _ill_defined(claim: Claim, proof: Definition) -> str | None:
    given = claim.given
    if Given.from_sympy(*given).satisfying_point() is None:
        return "no exact point is found that satisfies the conditions"
    if not all(isinstance(part, Equality) for part in parts_of(claim.says)):
        return "a definition consists of equations"
    pairs = [entry.args for part in parts_of(claim.says) for entry in scalars(part)]
    explicit = {left: right for left, right in pairs if isinstance(left, Symbol)}
    integrals = [left for left, _ in pairs if isinstance(left, Integral)]
    if not pairs or len(explicit) + len(integrals) < len(pairs):
        return "a definition gives each of its symbols one value"
    earlier = definitions(claim.rests_on)
    for symbol, meaning in explicit.items():
        if symbol in earlier or put_in(meaning, explicit).has(symbol):
            return f"{symbol} is not a new symbol"
    try:
        for e in (*explicit.values(), *integrals):
            need_value(e, proof.claims, given)
    except NotShownError as error:
        return str(error)
    if integrals and not proof.assumes:
        return "that an equation has a solution, and one, is shown or assumed by name"
    if integrals and not satisfiable(given, parts_of(claim.says)):
        return "no point is found that satisfies the equation"
    return None


def captured(claim: Claim) -> str | None:
    """Why the claim does not keep its symbols apart, or None where it does.

    One is bound, and is defined or what another that stands there is defined by; or one is two.
    """
    entries = {e.symbol: e for e in table((*claim.rests_on, claim)) if e.symbol.is_Symbol}
    hidden = _hidden(entries.values())
    for e in expressions(claim):
        for symbol in e.atoms(Symbol):
            if symbol != Symbol(symbol.name, real=True):
                return f"{symbol} is not the real symbol of that name"
        for node in e.atoms(Integral, Derivative, Subs):
            for symbol in node.atoms(Symbol):
                if symbol in entries and symbol in node.variables:
                    return f"{symbol} is defined by {entries[symbol].claim.label}, and bound here"
                for variable in hidden.get(symbol, frozenset()).intersection(node.variables):
                    return f"{symbol} is defined by way of {variable}, which is bound here"
    if isinstance(claim.proof, UniqueRoot) and claim.proof.variable in entries:
        return f"{claim.proof.variable} is defined, and bound here"
    return None


def _hidden(entries: Iterable[Entry]) -> dict[Basic, frozenset[Basic]]:
    """All that stands behind each symbol, by way of others too."""
    names: dict[Basic, frozenset[Basic]] = {}
    for entry in entries:
        of = entry.meaning.free_symbols.union(*(c.free_symbols for c in entry.claim.given))
        names[entry.symbol] = names.get(entry.symbol, frozenset()) | of
    for _ in names:
        names = {s: of.union(*(names.get(n, frozenset()) for n in of)) for s, of in names.items()}
    return names


def conflict(claims: Iterable[Claim]) -> str | None:
    """Why the definitions among ``claims`` are no table: two of one symbol, or a circle."""
    return _conflict(tuple(c for c in claims if isinstance(c.proof, DEFINING)))


def overdetermined(claims: Iterable[Claim]) -> str | None:
    """Why equations for integrals among ``claims`` do not together define what they are to.

    Each defines one symbol, and does not say which: two that share symbols may contradict each
    other, and one whose symbols are all defined may be false.
    """
    return _overdetermined(tuple(c for c in claims if isinstance(c.proof, DEFINING)))


@lru_cache(maxsize=4096)
def _conflict(claims: tuple[Claim, ...]) -> str | None:
    meanings: dict[Basic, list[Entry]] = {}
    for entry in table(claims):
        meanings.setdefault(entry.symbol, []).append(entry)
    circle = _circle(meanings)
    if circle is not None:
        return circle
    once = {s: found[0].meaning for s, found in meanings.items() if s.is_Symbol and len(found) == 1}
    for symbol, found in meanings.items():
        for one, two in combinations(found, 2):
            if one.meaning != two.meaning and not _agree(one, two, once):
                return f"{symbol} is defined by {_where(one.claim)} and by {_where(two.claim)}"
    return None


def _where(claim: Claim) -> str:
    """The claim and its place in the paper."""
    place = claim.where
    if place is None:
        return claim.label
    names = (("display", place.display), ("line", place.line), ("cell", place.cell))
    return f"{claim.label} ({', '.join(f'{name} {at}' for name, at in names if at is not None)})"


def _agree(one: Entry, two: Entry, rules: Rules) -> bool:
    """Whether two equations for a symbol are for different cases, or one is assumed by name.

    What is assumed must be possible as the other symbols are defined.
    """
    earlier, later = one.claim, two.claim
    if _exclude(earlier.given, later.given) or _exclude(later.given, earlier.given):
        return True
    both = (*earlier.given, *later.given)
    assumed = _assumes(earlier) or _assumes(later)
    known = equal(one.symbol, one.meaning), equal(two.symbol, two.meaning)
    try:
        both = tuple(put_in(condition, rules) for condition in both)
        known = tuple(equal(one.symbol, put_in(e.args[1], rules)) for e in known)
    except CircularError:
        pass  # a symbol is bound there, or the equations go on: they are taken as they stand
    return assumed and satisfiable(both, known)


def _exclude(given: Conditions, others: Conditions) -> bool:
    """Whether one of ``others`` is shown to fail wherever ``given`` holds."""
    return any(isinstance(c, Relational) and is_manifest(c.negated, given) for c in others)


def _assumes(claim: Claim) -> bool:
    return isinstance(claim.proof, Definition) and bool(claim.proof.assumes)


def _circle(meanings: dict[Basic, list[Entry]]) -> str | None:
    """A symbol that is defined by itself, by way of others."""
    behind = _hidden(entry for found in meanings.values() for entry in found)
    for symbol, found in meanings.items():
        if symbol.is_Symbol and symbol in behind[symbol]:
            return f"{symbol} is defined by itself in {_where(found[0].claim)}"
    return None


@lru_cache(maxsize=4096)
def _overdetermined(claims: tuple[Claim, ...]) -> str | None:
    entries = table(claims)
    rules = {entry.symbol: entry.meaning for entry in entries if entry.symbol.is_Symbol}
    seen: frozenset[Basic] = frozenset()
    for entry in _restrictions(entries):
        symbols = entry.symbol.free_symbols | entry.meaning.free_symbols
        if symbols & seen:
            return f"{entry.claim.label} is a second equation for the same symbols"
        seen |= symbols
        try:
            left = put_in(entry.symbol - entry.meaning, rules)
        except CircularError as error:
            return str(error)
        if not left.free_symbols:
            return f"{entry.claim.label} leaves nothing to define"
    return None
