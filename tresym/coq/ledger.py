"""The ledger's claims as theorems of Coq: what each says, and proofs of it to try.

The definitions that a claim speaks of are premises, each an equation of a symbol and its meaning.
A printed number is that there are inputs that round to the printed ones whose value rounds to it;
a counterexample that there is a point at which the conditions hold and the statement does not.
"""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from hashlib import sha256
from itertools import chain
from typing import Any

from flint import fmpq
from sympy import Basic, Derivative, Eq, Integral, MatrixBase, Subs, Symbol
from sympy.core.relational import Relational

from tresym.coq.equations import exchanged
from tresym.coq.search import proofs
from tresym.coq.statement import NotExportedError, Theorem, term
from tresym.ledger.claim import AllOf, Claim, Counterexample, Definition, Printed, parts_of
from tresym.ledger.evidence.denial import denied_at
from tresym.ledger.evidence.printed import judge_printed
from tresym.ledger.meaning import definitions
from tresym.reals.language.expression import Expr, number, symbol, symbols, trees
from tresym.reals.language.sympy import from_sympy
from tresym.reals.numbers.exact import InputError, printed
from tresym.reals.places.conditions import Given
from tresym.reals.places.domain import needs
from tresym.reals.verdict import Verdict

RELATIONS = {
    "Equality": "==",
    "Unequality": "!=",
    "StrictGreaterThan": ">",
    "GreaterThan": ">=",
    "StrictLessThan": "<",
    "LessThan": "<=",
}
BOUND = (Derivative, Integral, Subs)
Condition = tuple[Expr, str, Expr]


def name_of(label: str) -> str:
    """The theorem of a claim."""
    return "claim_" + re.sub(r"\W", "_", label, flags=re.ASCII)


def theorems_of(claim: Claim) -> list[Theorem]:
    """What the claim says, a theorem for each of its relations.

    Raises:
        NotExportedError: a kind of claim that has no statement in Coq yet.
    """
    proof = claim.proof
    if claim.expect is Verdict.REFUTED and not isinstance(proof, Counterexample):
        raise NotExportedError("it is refuted, and its witness is not exported yet")
    if isinstance(proof, Definition):
        raise NotExportedError("a definition is a premise of what speaks of it")
    try:
        if isinstance(proof, Printed):
            return [_printed(claim, proof)]
        if isinstance(proof, Counterexample):
            return [_counterexample(claim, proof)]
        if claim.statement is None or isinstance(proof, AllOf):
            raise NotExportedError("a sentence whose formula is not at hand is not exported yet")
        found = list(chain.from_iterable(map(_entries, parts_of(claim.statement))))
        return [
            _theorem(claim, relation, name_of(claim.label) + (f"_{n}" if len(found) > 1 else ""))
            for n, relation in enumerate(found, 1)
        ]
    except (InputError, TypeError, AttributeError, ValueError) as error:
        raise NotExportedError(f"what is said is not read as real expressions ({error})") from None


def _entries(relation: Basic) -> Iterator[Basic]:
    """A relation, those of the entries where it is one of matrices."""
    if isinstance(relation, Eq) and isinstance(relation.lhs, MatrixBase):
        for left, right in zip(relation.lhs, relation.rhs, strict=True):
            yield Eq(left, right, evaluate=False)
    else:
        yield relation


def _theorem(claim: Claim, relation: Basic, name: str) -> Theorem:
    kind = type(relation).__name__
    if not isinstance(relation, Relational) or kind not in RELATIONS:
        raise NotExportedError(f"{kind} is not exported yet")
    left, right, by = relation.lhs, relation.rhs, None
    if kind == "Equality" and isinstance(left, Derivative) and len(left.variables) == 1:
        left, by = left.expr, left.variables[0].name
    if left.has(*BOUND) or right.has(*BOUND):
        raise NotExportedError("integrals and derivatives inside expressions are not exported yet")
    sides = from_sympy(left), from_sympy(right)
    given = Given.from_sympy(*claim.given).comparisons
    put_in = _definitions(claim, [*sides, *(e for x, _, y in given for e in (x, y))])
    if (sides[0], "==", sides[1]) in put_in:
        raise NotExportedError("it says what a definition says")
    given = (*put_in, *given)
    inner = needs([sides[0]]) if by else []
    inside = [(e, ">" if sign == ">=" and by in symbols(e) else sign) for e, sign in inner]
    parts = [*inside, *needs([*sides, *(e for x, _, y in given for e in (x, y))])]
    return _made(name, given, parts, sides, RELATIONS[kind], by)


def _made(
    name: str,
    given: tuple[Condition, ...],
    parts: Iterable[tuple[Expr, str]],
    sides: tuple[Expr, Expr],
    relation: str,
    by: str | None = None,
    exists: bool = False,
) -> Theorem:
    parts = tuple(part for part in dict.fromkeys(parts) if symbols(part[0]))
    used = [*sides, *(e for e, _ in parts), *(e for x, _, y in given for e in (x, y))]
    names = frozenset().union(*map(symbols, used), {by} if by else ())
    return Theorem(name, tuple(sorted(names)), given, parts, *_three(sides, relation), by, exists)


def _three(sides: tuple[Expr, Expr], relation: str) -> tuple[Expr, str, Expr]:
    return sides[0], relation, sides[1]


def _definitions(claim: Claim, used: list[Expr]) -> tuple[Condition, ...]:
    """The equations of the symbols in ``used`` and in what defines them, in order."""
    rules = definitions(c for c in claim.rests_on if isinstance(c.proof, Definition))
    meanings = {
        left.name: from_sympy(right)
        for left, right in rules.items()
        if isinstance(left, Symbol) and isinstance(right, Basic) and not right.has(*BOUND)
    }
    found: dict[str, Expr] = {}
    stack = sorted(frozenset().union(*map(symbols, used)))
    while stack:
        name = stack.pop()
        if name in meanings and name not in found:
            found[name] = meanings[name]
            stack += sorted(symbols(meanings[name]))
    return tuple((symbol(name), "==", e) for name, e in found.items())


def _printed(claim: Claim, proof: Printed) -> Theorem:
    """That there are inputs which round to the printed ones and give what rounds to the text."""
    names = [symbol(f"input{n}") for n, _ in enumerate(proof.inputs, 1)]
    value = proof.formula(*names, trees)
    if not isinstance(value, Expr):
        raise NotExportedError("what is printed does not trace to a formula")
    given: list[Condition] = []
    for name, written in zip(names, proof.inputs.values(), strict=True):
        if isinstance(written, str):
            interval = printed(written)
            given += [(name, ">=", number(interval.low)), (name, "<=", number(interval.high))]
        else:
            given.append((name, "==", number(written)))
    target = printed(proof.text)
    middle, half = (target.low + target.high) / 2, (target.high - target.low) / 2
    sides = abs(value - number(middle)), number(half * proof.half_units)
    return _made(name_of(claim.label), tuple(given), needs(sides), sides, "<=", exists=True)


def _counterexample(claim: Claim, proof: Counterexample) -> Theorem:
    """That there is a point which satisfies the conditions and not the statement."""
    denied = denied_at(claim.statement, proof.point) if claim.statement is not None else None
    if denied is None or denied[1].has(*BOUND):
        raise NotExportedError("that the point denies is not exported yet")
    above, violated = denied[0], denied[1].negated
    kind = type(violated).__name__
    sides = from_sympy(violated.lhs), from_sympy(violated.rhs)
    given = Given.from_sympy(*claim.given, *above).comparisons
    return _made(
        name_of(claim.label),
        given,
        needs([*sides, *(e for x, _, y in given for e in (x, y))]),
        sides,
        RELATIONS[kind],
        exists=True,
    )


def candidates(claim: Claim, theorem: Theorem) -> Iterator[str]:
    """Proofs to try."""
    if theorem.exists:
        yield from _at_point(theorem, _point(claim, theorem))
        return
    names = [x.args[0] for x, relation, _ in theorem.given if relation == "=="]
    if not names:
        yield from proofs(theorem)
        return
    meanings = {x: y for x, relation, y in theorem.given if relation == "=="}
    put = ", ".join(term(symbol(name)) for name in names)
    for proof in proofs(_put_in(theorem, meanings)):
        yield proof.replace("intros", f"intros; subst {put.replace(',', '')}", 1)


def _put_in(theorem: Theorem, meanings: Mapping[Expr, Expr]) -> Theorem:
    """The theorem after its definitions are put in, brackets kept."""

    def whole(e: Expr) -> Expr:
        for _ in range(20):
            after = exchanged(e, dict(meanings))
            if after == e:
                break
            e = after
        return e

    given = tuple(
        (whole(x), relation, whole(y)) for x, relation, y in theorem.given if relation != "=="
    )
    parts = tuple((whole(e), sign) for e, sign in theorem.defined)
    names = tuple(name for name in theorem.variables if symbol(name) not in meanings)
    sides = _three((whole(theorem.left), whole(theorem.right)), theorem.relation)
    return Theorem(theorem.name, names, given, parts, *sides, theorem.by)


def _point(claim: Claim, theorem: Theorem) -> dict[str, fmpq]:
    """The point of the evidence."""
    if isinstance(claim.proof, Counterexample):
        return dict(claim.proof.point)
    number: Any = claim.proof
    witness = judge_printed(number).witness or {}
    return {f"input{n}": x for n, x in enumerate(witness.values(), 1)}


def _at_point(theorem: Theorem, point: Mapping[str, fmpq]) -> Iterator[str]:
    values = [f"({term(number(point.get(name, fmpq(1))))})" for name in theorem.variables]
    there = f"exists {', '.join(values)}. " if values else ""
    for first in ("", "laws; unfold root, acosh, atanh in *; "):
        yield f"{there}repeat split; {first}numeric."


def stamp(found: Iterable[Theorem]) -> str:
    """What changes when a statement does."""
    return sha256("\n".join(t.text for t in found).encode()).hexdigest()[:16]
