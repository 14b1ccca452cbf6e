"""Benchmark of identities: steps of the ledger's proofs and false variants, against SymPy.

An identity consists of two consecutive expressions of a proof with all definitions substituted.
SymPy is asked as a user would: whether ``simplify(x - y)`` or ``trigsimp(x - y)`` is 0, and whether
``x.equals(y)``. Symbols that are positive by the conditions are declared so to SymPy, which helps
it. A false variant is one that balls prove false; there ``simplify`` and ``trigsimp`` count as
right if the result is not 0.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator
from functools import partial
from itertools import islice, pairwise, zip_longest
from typing import Any, NamedTuple

import sympy

from tresym.checking import check
from tresym.dev.bench.run import (
    FAILED,
    RIGHT,
    WRONG,
    Contender,
    Judged,
    Pace,
    Timing,
    Workload,
    tally,
)
from tresym.ledger.claim import Chain, Claim, Step
from tresym.ledger.conversion import conditions, definitions, known, put_in
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.sign_prover import manifest_sign
from tresym.ledger.formulas import in_trees
from tresym.ledger.paper import all_claims
from tresym.reals.decisions.identity import decide
from tresym.reals.language.binders import worked_out
from tresym.reals.language.expression import symbols
from tresym.reals.language.formula import Relation
from tresym.reals.language.to_sympy import to_sympy
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.repair.edits import changes

OURS = "tresym, exact normal form"
PUBLIC = "tresym check, from text"
OPEN = (sympy.Integral, sympy.Derivative, sympy.Subs, sympy.MatrixBase)
EVERY = 2
"""SymPy, which is slow, gets every identity whose number is a multiple of this."""
VARIANTS = 12
"""Changes that are tried on an identity until one is proved false."""


class Identity(NamedTuple):
    """Two sides, the conditions, whether they are equal, and a name."""

    name: str
    left: Any
    right: Any
    given: Any
    true: bool


PACE = Pace(rounds=3, limit=1.0, patience=0.05)


def contenders(_: Any) -> Iterator[Contender]:
    """Yield all identities for tresym, and one in ``EVERY`` for SymPy."""
    for n, pair in enumerate(pairs()):
        for identity in pair:
            yield from islice(_contenders(identity), None if n % EVERY == 0 else 2)


def notes(timings: list[Timing], _: Any) -> dict[str, Any]:
    """Return outcomes and ratios by method, for true and for false identities."""

    def named(who: Contender) -> str:
        return f"{who.method}, {'false' if who.scene.endswith('made false') else 'true'} ones"

    return {"summary": tally(timings, OURS, PACE.limit, "identities", named)}


WORKLOAD = Workload(contenders, PACE, OURS, notes=notes)


def pairs() -> Iterator[list[Identity]]:
    """Yield each identity of the ledger with a false variant of it, if one is found."""
    seen = set()
    for claim in all_claims():
        steps = [pair for proof in _chains(claim) for pair in pairwise(_expressions(*proof))]
        for number, (left, right) in enumerate(steps, 1):
            if left == right or (left, right) in seen or left.has(*OPEN) or right.has(*OPEN):
                continue
            seen.add((left, right))
            name = f"{claim.label}, step {number}"
            if _verdict(left, right, claim.given) is Verdict.PROVED:
                true = Identity(name, left, right, claim.given, True)
                yield [true, *_variant(name, left, right, claim.given)]


def _chains(claim: Claim) -> Iterator[tuple[Any, Chain, tuple[Claim, ...]]]:
    """The steps of a claim between numbers, with its statement and the claims that are put in."""
    proof = claim.proof
    if not isinstance(proof, Decided):
        return
    for says, chain in zip_longest(claim.parts, proof.steps, fillvalue=()):
        if isinstance(says, Relation) and says.sign == "==":
            yield says, chain or (Step(None, ()),), proof.put


def _expressions(says: Any, chain: Chain, put: tuple[Claim, ...]) -> list[Any]:
    """The expressions of a chain, with the definitions that it uses substituted."""
    named = (claim for link in chain for reason in link.reasons for claim in reason.claims)
    rules = definitions((*put, *named))
    links = [says.right if link.expression is None else link.expression for link in chain]
    return [to_sympy(worked_out(put_in(e, rules))) for e in (says.left, *links)]


def _variant(name: str, left: Any, right: Any, given: Any) -> Iterator[Identity]:
    """The first change of the right side that balls prove false."""
    e = in_trees(right)
    edits = sorted(changes(e, sorted(symbols(e))), key=lambda change: change.rank)
    for changed in (to_sympy(edit.tree) for edit in edits[:VARIANTS]):
        if _verdict(left, changed, given) is Verdict.REFUTED:
            yield Identity(f"{name}, made false", left, changed, given, False)
            return


def _verdict(left: Any, right: Any, given: Any) -> Verdict:
    try:
        return decide(in_trees(left), in_trees(right), known(conditions(given))).verdict
    except InputError:
        return Verdict.UNDECIDED


def _contenders(identity: Identity) -> Iterator[Contender]:
    trees = in_trees(identity.left), in_trees(identity.right)
    given = known(conditions(identity.given))
    said = ", ".join(f"{x} {relation} {y}" for x, relation, y in given.comparisons)
    left, right = _declared(identity)
    works: dict[str, Callable[[], Any]] = {
        OURS: lambda: decide(*trees, given).verdict,
        PUBLIC: lambda: check(f"{trees[0]} == {trees[1]}", said).verdict,
        "sympy simplify": lambda: sympy.simplify(left - right) == 0,
        "sympy equals": lambda: left.equals(right),
        "sympy trigsimp": lambda: sympy.trigsimp(left - right) == 0,
    }
    for name, work in works.items():
        judge = partial(_judge, identity, name)
        yield Contender(identity.name, name, work, judge, name in (OURS, PUBLIC))


def _declared(identity: Identity) -> tuple[Any, Any]:
    """Both sides, with the symbols declared positive that are so by the conditions."""
    symbols = identity.left.free_symbols | identity.right.free_symbols
    positive = {
        s: sympy.Symbol(s.name, positive=True)
        for s in symbols
        if manifest_sign(in_trees(s), conditions(identity.given)) == "+"
    }
    return identity.left.xreplace(positive), identity.right.xreplace(positive)


def _judge(identity: Identity, method: str, answer: Any) -> Judged:
    if method in (OURS, PUBLIC):
        answer = {Verdict.PROVED: True, Verdict.REFUTED: False}.get(answer)
    if answer is identity.true:
        return Judged(outcome=RIGHT)
    if answer is None or (answer is False and method in ("sympy simplify", "sympy trigsimp")):
        return Judged(outcome=FAILED, why="not decided")
    return Judged(outcome=WRONG, why=f"says {answer}")
