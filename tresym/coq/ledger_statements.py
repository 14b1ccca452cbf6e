"""Turn the claims of the ledger into Coq theorems with their premises.

- The definitions of the symbols in a claim, and its assumptions, are premises (equations).
- A definition has a theorem of its own: the defined value exists.
- A refutation states that some point satisfies the conditions and violates the statement.
- A conjunction of claims is the conjunction of their theorems; if it is refuted, of the theorems of
  its refuted parts.
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from functools import cache
from hashlib import sha256
from typing import Any, TypeAlias

from tresym.coq.implicit_statements import Implicit
from tresym.coq.solution_statements import Along
from tresym.coq.statement import (
    Condition,
    Every,
    Fails,
    Formula,
    NotExportedError,
    One,
    Some,
    Theorem,
    Wherever,
)
from tresym.coq.theorem_form import arranged, entry_of_a_matrix, first_one_first
from tresym.coq.theorem_trees import Part, defined
from tresym.ledger.claim import (
    AllOf,
    Claim,
    Counterexample,
    Definition,
    Dominated,
    Follows,
    FromSlope,
    FromTheEdge,
    ImplicitFunction,
    InfimumBy,
    MonotoneOf,
    Printed,
    Root,
    RootMonotone,
)
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.deductions import parts_under
from tresym.ledger.evidence.refutation import denied_part
from tresym.ledger.formulas import (
    EqualMatrices,
    Rounded,
    Tending,
    Under,
    in_trees,
    mapped,
    parts_of,
)
from tresym.ledger.paper import file_of
from tresym.reals.language.binders import outermost
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.compound import Count, Equivalent, Somewhere, Together
from tresym.reals.language.expression import (
    ZERO,
    Expr,
    fresh,
    number,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Conjunction, Equivalence, Relation
from tresym.reals.language.named_claims import Conserved
from tresym.reals.language.paths import Path
from tresym.reals.numbers.exact import InputError, printed
from tresym.reals.verdict import Verdict

DEDUCED = (*(Follows, RootMonotone, MonotoneOf, FromSlope, FromTheEdge, InfimumBy, Dominated),)
"""Evidence whose last step has no statement in Coq yet; the claims that it names may have."""


@dataclass(frozen=True)
class Joint:
    """The conjunction of the theorems of other claims.

    Attributes:
        name: the name of the theorem.
        parts: the other claims.
        whole: whether the conjunction is what the claim states. If not, Coq proves parts of it.
    """

    name: str
    parts: tuple[Claim, ...]
    whole: bool = True

    @property
    def body(self) -> str:
        """The proposition as Coq text."""
        return "  " + " /\\ ".join(f"says_{stem(part.label)}" for part in self.parts)

    @property
    def text(self) -> str:
        """The statement as a sentence of Coq."""
        return f"Theorem {self.name} :\n{self.body}."


Exported: TypeAlias = Theorem | Joint | Implicit | Along
"""The theorem of a claim."""


def stem(label: str) -> str:
    """Return the label with all characters that Coq does not allow in names replaced."""
    return re.sub(r"\W", "_", label, flags=re.ASCII)


def name_of(label: str) -> str:
    """Return the name of a claim's theorem."""
    return "claim_" + stem(label)


@cache
def lemmas() -> str:
    """Return the exported ``Racket.v``: hand-written lemmas that the proofs of several claims use.

    It is the file of that name in ``proofs/coq`` followed by those in ``proofs/coq/lemmas``.
    """
    folder = file_of("coq")
    files = [folder / "Racket.v", *sorted(folder.glob("lemmas/*.v"))]
    return "\n".join(path.read_text(encoding="utf-8") for path in files)


def theorem_of(claim: Claim) -> Exported:
    """Return the Coq theorem of a claim.

    Raises:
        NotExportedError: this kind of claim cannot be exported yet.
    """
    found = _theorem_of(claim)
    stamp(found)  # which prints it
    return found


def _theorem_of(claim: Claim) -> Exported:
    proof = claim.proof
    if isinstance(proof, ImplicitFunction):
        return _implicit(claim, proof)
    if isinstance(proof, Root):
        return Joint(name_of(claim.label), (proof.unique,))  # there is exactly one
    if isinstance(proof, Definition) and proof.assumes:
        raise NotExportedError(
            "an assumption has no theorem of its own; it is a premise of the theorems that use it"
        )
    if isinstance(proof, Boxes) and proof.meant is not None:  # its statement alone may be false
        raise NotExportedError("what its symbols mean on the boxes is not exported to Coq yet")
    if isinstance(proof, (AllOf, *DEDUCED)):
        parts = (p for p in claim.uses if not _assumed(p) and not isinstance(p.proof, Root))
        if claim.expect is Verdict.REFUTED:  # since some of its parts are
            parts = (p for p in parts if p.expect is Verdict.REFUTED)
        joined = tuple(parts)
        if not joined:
            raise NotExportedError("its evidence names no claim that Coq could prove")
        return Joint(name_of(claim.label), joined, _is_their_conjunction(claim))
    statement = claim.statement
    if statement is None:
        raise NotExportedError("a sentence without a formula cannot be exported to Coq")
    try:
        written = in_one_form(statement)
        if (kept := parts_of(written)) and all(isinstance(e, Conserved) for e in kept):
            return _along(claim, kept)
        if isinstance(written, Tending):
            return tending(claim, written)
        if isinstance(written, Somewhere) and claim.expect is Verdict.REFUTED:
            somewhere = (Relation(*c) for c in written.comparisons)
            return theorem(claim, denied(Conjunction(tuple(somewhere))))  # at no point
        says = read(written)
        if isinstance(proof, Definition):
            return existence(claim, says)
        if isinstance(proof, Printed):
            refuted = claim.expect is Verdict.REFUTED
            return theorem(claim, denied(says) if refuted else says, exists=not refuted)
        if claim.expect is Verdict.REFUTED:
            above: tuple[Any, ...] = ()
            if isinstance(proof, Counterexample):
                found = denied_part(statement, proof.point)
                above, says = (found[0], read(found[1])) if found else ((), says)
            return theorem(claim, denied(says), above, exists=True)
        return theorem(claim, says)
    except (InputError, TypeError, AttributeError, ValueError) as error:
        raise NotExportedError(
            f"the statement cannot be converted to real expressions ({error})"
        ) from None


def in_one_form(says: Any) -> Any:
    """Return a statement, or an expression, as trees in the form of the texts of theorems."""
    found = in_trees(says)
    if isinstance(found, Expr):
        return arranged(found)
    if isinstance(found, Together):
        return Together(tuple(map(in_one_form, found.parts)))
    if isinstance(found, Equivalent) and len(found.parts) == 2:
        first, second = mapped(found, arranged).parts
        if isinstance(first, Relation) and isinstance(second, Relation):
            return Equivalent(first_one_first((first, second)))
    return mapped(found, entry_of_a_matrix if isinstance(found, EqualMatrices) else arranged)


def _along(claim: Claim, kept: Sequence[Conserved]) -> Along:
    """Return that quantities are constant along the solutions of their common system."""
    ((unknowns, rates),) = {(e.names, e.rates) for e in kept}
    quantities = tuple(e.function for e in kept)
    given = conditions_of(claim.given)
    there = [c for c in given if free(c) & {*unknowns}]
    whole = [*rates, *quantities, *(side for c in given for side in (c.left, c.right))]
    parts = dict.fromkeys(part for e in whole for part in defined(e) if symbols(part[0]))
    names = frozenset().union(*map(symbols, whole)) - {*unknowns}
    if definitions(claim, names)[0]:
        raise NotExportedError("a system with defined symbols is not exported to Coq yet")
    return Along(
        name_of(claim.label),
        tuple(sorted(names)),
        tuple((c.left, c.sign, c.right) for c in given if c not in there),
        unknowns,
        rates,
        tuple((c.left, c.sign, c.right) for c in there),
        tuple(parts),
        quantities,
    )


def _is_their_conjunction(claim: Claim) -> bool:
    """Return whether a claim states no more than all the claims that it names, as they state it."""
    proof = claim.proof
    if not isinstance(proof, AllOf) or proof.words or claim.statement is None:
        return False
    if claim.expect is Verdict.REFUTED:
        return True
    known = {
        pair
        for part in proof.claims
        if part.statement is not None and not _assumed(part)
        for pair in parts_under(part.statement, part.given)
    }
    return {*parts_under(claim.statement, claim.given)} <= known


def _implicit(claim: Claim, proof: ImplicitFunction) -> Implicit:
    """Return the implicit function theorem for the equation of a claim."""
    (slope,) = relations(read(claim.says))
    (equation,) = relations(read(proof.equation.decided))
    unknown, parameter = str(proof.unknown), str(proof.parameter)
    given = tuple(c for c in conditions_of(claim.given) if parameter not in free(c))
    at = in_one_form(proof.at)
    names = free(equation).union(free(slope), symbols(at), *map(free, given))
    names -= {parameter, slope.left.args[0]}
    return Implicit(
        name_of(claim.label),
        tuple(sorted(names)),
        tuple((c.left, c.sign, c.right) for c in given),
        equation,
        unknown,
        parameter,
        at,
        slope,
    )


def conditions_of(given: Iterable[Any]) -> list[Relation]:
    """Return the conditions as relations, equations included."""
    return [part for e in given for part in relations(read(e))]


def _inequalities(given: Iterable[Any]) -> tuple[Relation, ...]:
    """Return the conditions of a definition as relations.

    Raises:
        InputError: one is an equation.
    """
    found = tuple(conditions_of(given))
    if any(c.sign == "==" for c in found):
        raise InputError("the condition of a definition must be an inequality such as a > 0")
    return found


def relations(says: Formula) -> Iterator[Relation]:
    """Yield the relations of a conjunction."""
    if isinstance(says, Relation):
        yield says
    elif isinstance(says, Conjunction):
        for part in says.parts:
            yield from relations(part)


def _assumed(claim: Claim) -> bool:
    return isinstance(claim.proof, Definition) and bool(claim.proof.assumes)


def read(says: Any) -> Formula:
    """Convert a statement to a formula."""
    return _read(in_one_form(says))


def _read(says: Any) -> Formula:
    if isinstance(says, Relation):
        return says
    if isinstance(says, Together):
        return Conjunction(tuple(map(_read, says.parts)))  # type: ignore[arg-type]
    if isinstance(says, EqualMatrices):
        return Conjunction(says.entries)
    if isinstance(says, Equivalent) and len(says.parts) == 2:
        return Equivalence(*map(_read, says.parts))  # type: ignore[arg-type]
    if isinstance(says, Under):
        given = (part for c in says.given for part in relations(_read(c)))
        return Wherever(tuple(given), _read(says.formula))
    if isinstance(says, Count) and says.how == "exactly one":
        x = symbol(says.name)
        between = Relation(x, ">", says.low), Relation(x, "<", says.high)
        return One(says.name, Conjunction((*between, Relation(*says.equation))))
    if isinstance(says, Count) and says.how == "at most one":
        return _at_most_one(says)
    if isinstance(says, Rounded):
        return _rounded(says)
    raise InputError(f"{says} is not a relation such as a > 0")


def _at_most_one(says: Count) -> Formula:
    """Return that two values between the ends that both satisfy the equation are equal."""
    inner = Relation(*says.equation)
    x, other = symbol(says.name), symbol(fresh(f"{says.name}'", free(inner)))
    there = [
        part
        for one in (x, other)
        for part in (
            Relation(one, ">", says.low),
            Relation(one, "<", says.high),
            Relation(
                substitute(inner.left, {says.name: one}),
                inner.sign,
                substitute(inner.right, {says.name: one}),
            ),
        )
    ]
    return Wherever(tuple(there), Relation(other, "==", x))


def _rounded(says: Rounded) -> Formula:
    """Return that a term lies within the tolerance around the printed decimal."""
    e, interval = says.term, printed(says.text)
    middle, half = (interval.low + interval.high) / 2, (interval.high - interval.low) / 2
    half *= says.half_units
    if e.op == "symbol":
        low, high = number(middle - half), number(middle + half)
        return Conjunction((Relation(e, ">=", low), Relation(e, "<=", high)))
    return Relation(abs(e - number(middle)), "<=", number(half))


def denied(says: Formula) -> Formula:
    """Return the negation of a statement whose parts are defined.

    Raises:
        NotExportedError: a single point cannot refute this kind of statement.
    """
    if isinstance(says, Conjunction) and len(says.parts) == 1:
        return denied(says.parts[0])
    if isinstance(says, Relation):
        return says.negated
    if isinstance(says, Conjunction) and all(isinstance(part, Relation) for part in says.parts):
        return Fails(says)
    raise NotExportedError("the refutation of this kind of statement is not exported yet")


def free(says: Formula) -> frozenset[str]:
    """Return the free variables of a formula."""
    match says:
        case Relation():
            return symbols(says.left) | symbols(says.right)
        case Wherever():
            asked = (symbols(e) for x, _, y in says.conditions for e in (x, y))
            return frozenset().union(free(says.says), *asked)
        case One():
            return free(says.says) - {says.name}
        case Some() | Every():
            return free(says.says) - {*says.names}
        case Fails():
            return free(says.says)
        case Conjunction():
            return frozenset().union(*map(free, says.parts))
    return free(says.first) | free(says.second)


def asked(says: Formula) -> Iterator[Part]:
    """Return the conditions, in the free variables, under which a formula is defined."""
    match says:
        case Relation():
            yield from (part for e in (says.left, says.right) for part in defined(e))
        case One() | Some() | Every():
            bound = {says.name} if isinstance(says, One) else {*says.names}
            yield from (part for part in asked(says.says) if bound.isdisjoint(symbols(part[0])))
        case Wherever() | Fails():
            yield from asked(says.says)
        case Conjunction():
            for one in says.parts:
                yield from asked(one)
        case Equivalence():
            yield from (*asked(says.first), *asked(says.second))


def theorem(
    claim: Claim, says: Formula, above: tuple[Any, ...] = (), exists: bool = False
) -> Theorem:
    """Return the theorem of a claim: its definitions, conditions, definedness and conclusion.

    Args:
        claim: the claim.
        says: the conclusion.
        above: further conditions.
        exists: whether to state the existence of a point instead of a universal statement.
    """
    given = tuple(dict.fromkeys(conditions_of((*claim.given, *above))))
    sides = [e for x, _, y in given for e in (x, y)]
    parts = [*asked(says), *(part for e in sides for part in defined(e))]
    parts = [part for part in dict.fromkeys(parts) if symbols(part[0])]
    used = [free(says), *map(symbols, sides), *(symbols(e) for e, _ in parts)]
    meanings, names = definitions(claim, frozenset().union(*used))
    put_in = tuple(
        (tuple(c for c in asked if c not in given), meaning) for asked, meaning in meanings
    )
    if exists or isinstance(claim.proof, Printed):  # where the conditions of definitions hold
        conditions_ = (Relation(*c) for asked, _ in put_in for c in asked)
        given = tuple(dict.fromkeys((*given, *conditions_)))
        put_in = tuple(((), meaning) for _, meaning in put_in)
    return Theorem(
        name_of(claim.label), tuple(sorted(names)), put_in, given, tuple(parts), says, exists
    )


def tending(claim: Claim, says: Tending) -> Theorem:
    """Return an order as an ε–δ statement: a bound that holds at all sufficiently near points.

    Where the order is of a derivative, the derivative exists there and has the bound.
    """
    left, _, right = says.relation
    path = says.path
    (node,) = {e for e in outermost(right) if e.op in ("O", "o")}
    k, d = symbol("bound"), symbol("near")
    without, whole = (replaced(right, {node: e}) for e in (ZERO, node.args[0]))
    small = Relation(abs(left - without), "<=", k * abs(whole - without))
    where = [*_beside(path, d)]
    if path.point is not None and len(path.sides) == 2:
        where.append(Relation(symbol(str(path.name)), "!=", path.point))
    given = [*conditions_of(claim.given), *where]
    sides = [e for c in given for e in (c.left, c.right)]
    used = frozenset().union(free(small), *map(symbols, sides)) - {"bound", "near"}
    meanings, names = definitions(claim, used)
    asked_for = [part for e in (left, without, whole, *sides) for part in defined(e)]
    given += [Relation(e, sign, ZERO) for e, sign in dict.fromkeys(asked_for) if symbols(e)]
    inner: Formula = Wherever((*(m for _, m in meanings), *given), small)
    every = Every(tuple(sorted(names)), inner)
    near: Formula = Some(("near",), Conjunction((Relation(d, ">", ZERO), every)))  # type: ignore[arg-type]
    if node.op == "o":
        near = Every(("bound",), Wherever((Relation(k, ">", ZERO),), near))
    else:
        near = Some(("bound",), near)
    refuted = claim.expect is Verdict.REFUTED
    return Theorem(name_of(claim.label), (), (), (), (), Fails(near) if refuted else near)


def _beside(path: Path, d: Expr) -> Iterator[Relation]:
    """Return that what tends is within ``d`` of its point on its side, or beyond ``d`` at oo."""
    if path.together:
        for name, p in zip(path.together, path.points, strict=True):
            yield from _near(symbol(name), p, (1, -1), d)
    elif path.point is None:
        far = INFINITY if path.sides == (1,) else -INFINITY
        yield from _near(path.expression or symbol(str(path.name)), far, (), d)
    else:
        yield from _near(symbol(str(path.name)), path.point, path.sides, d)


def _near(e: Expr, p: Expr, sides: tuple[int, ...], d: Expr) -> Iterator[Relation]:
    if p == INFINITY:
        yield Relation(e, ">", d)
    elif p == -INFINITY:
        yield Relation(e, "<", -d)
    else:
        yield Relation(e, ">", p if sides == (1,) else p - d)
        yield Relation(e, "<", p if sides == (-1,) else p + d)


Meaning = tuple[tuple[Condition, ...], Relation]


def definitions(claim: Claim, names: frozenset[str]) -> tuple[list[Meaning], frozenset[str]]:
    """Return the equations that define the symbols ``names``, dependencies first, and all symbols.

    This includes assumed equations for integrals of these symbols, and all equations for a symbol
    that has several, which together restrict its value.
    """
    table = [
        (_inequalities(used.given), part)
        for used in claim.rests_on
        if isinstance(used.proof, Definition | ImplicitFunction | Root)
        and used.statement is not None
        for part in relations(read(used.statement))
    ]
    found: set[int] = set()
    several = Counter(part.left for part in {part for _, part in table})

    def speaks(part: Relation) -> bool:
        """Whether the equation is for one of the symbols, or ties or restricts one."""
        sides = (part.left, part.right) if several[part.left] > 1 else (part.left,)
        return any(symbols(side) & names for side in sides)

    while True:
        new = [n for n, (_, part) in enumerate(table) if n not in found and speaks(part)]
        if not new:
            return [table[n] for n in sorted(found)], names
        for n in new:
            conditions_, part = table[n]
            names = names.union(
                free(part), *(symbols(e) for c in conditions_ for e in (c[0], c[2]))
            )
        found.update(new)


def existence(claim: Claim, says: Formula) -> Theorem:
    """Return that the defined value exists under the conditions of its definition."""
    parts = [*relations(says)]
    new = [part.left.args[0] for part in parts if part.left.op == "symbol"]
    inner = Conjunction(tuple(parts)) if len(parts) > 1 else parts[0]
    made = Some(tuple(dict.fromkeys(new)), inner)
    whole = theorem(claim, made)
    needs = [part for p in parts for part in defined(p.right) if symbols(part[0])]
    shown = [Relation(e, sign, ZERO) for e, sign in dict.fromkeys(needs) if not symbols(e) & {*new}]
    remaining = tuple(part for part in whole.defined if (part[0], part[1]) not in set(needs))
    every: Formula = Conjunction((*shown, made)) if shown else made  # type: ignore[arg-type]
    return Theorem(whole.name, whole.variables, whole.definitions, whole.given, remaining, every)


def stamp(found: Exported) -> str:
    """Return a hash of the statement; it changes when the statement does."""
    return sha256(f"{found.text}".encode()).hexdigest()[:16]
