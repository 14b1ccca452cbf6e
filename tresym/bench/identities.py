"""Deciding identities: the steps of the ledger's chains and false variants of them, against SymPy.

An identity is two consecutive expressions of a chain with all definitions put in. The peers are
what a reader would type: does ``simplify(x - y)`` come to 0, is ``x.equals(y)``, does
``trigsimp(x - y)``? Symbols that the conditions make positive are declared so to SymPy, without
which it does worse. A false variant is one that balls show violated; of ``simplify`` and
``trigsimp`` no more is asked there than not to come to 0.
"""

from __future__ import annotations

import math
import statistics
import time
from collections.abc import Callable, Iterator
from functools import partial
from itertools import islice, pairwise
from typing import Any, NamedTuple

import sympy

from tresym.bench.run import (
    FAILED,
    RIGHT,
    TIMED_OUT,
    WRONG,
    Contender,
    Judged,
    Keep,
    Measurement,
    Pace,
    Timing,
    forget,
    interleave,
)
from tresym.ledger import paper
from tresym.ledger.claim import Chain, Claim, Together, chains_of
from tresym.ledger.evidence.manifest import manifest_sign
from tresym.ledger.meaning import conditions, known, tree
from tresym.ledger.mutants.changes import mutations
from tresym.ledger.paper import all_claims
from tresym.ledger.second_look import put_in, rules_of
from tresym.reals.advocate import contradiction
from tresym.reals.decisions.identity import decide
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict

OURS = "tresym, exact normal form"
OPEN = (sympy.Integral, sympy.Derivative, sympy.Subs, sympy.MatrixBase)
EVERY = 2
"""SymPy is asked one identity in so many, as it takes its time."""
VARIANTS = 12
"""Changes that are tried on an identity until one is shown false."""


class Identity(NamedTuple):
    """Two sides, the conditions, whether they are equal, and a name."""

    name: str
    left: Any
    right: Any
    given: Any
    true: bool


PACE = Pace(rounds=3, limit=1.0, patience=0.05)


def measure(keep: Keep = forget, pace: Pace = PACE) -> Measurement:
    """The workload ``identities``: all of them by ours, one in ``EVERY`` by SymPy as well."""
    contenders = (c for n, pair in enumerate(pairs()) for c in _of_pair(n, pair))
    timings, complete = interleave(contenders, pace, keep)
    says = "is an identity of the ledger true, is a false variant of it?"
    notes = {"summary": summary(timings, pace.limit), "advocate": advocate()}
    return Measurement("identities", says, timings, OURS, notes=notes, complete=complete)


def advocate() -> float:
    """The median, over the true identities, of the advocate's time by the decision's."""
    parts = []
    for identity in (identity for identity in identities() if identity.true):
        left, right = tree(identity.left), tree(identity.right)
        given = known(conditions(identity.given))
        start = time.process_time()
        decide(left, right, given)
        spent = time.process_time() - start
        contradiction((left, "==", right), given.comparisons, spent=spent)
        parts.append((time.process_time() - start) / spent - 1)
    return float(f"{statistics.median(parts):.3g}")


def _of_pair(n: int, pair: list[Identity]) -> Iterator[Contender]:
    for identity in pair:
        ours, *peers = _contenders(identity)
        yield ours
        if n % EVERY == 0:
            yield from peers


def pairs() -> Iterator[list[Identity]]:
    """Each identity of the ledger with a false variant of it, where one is found."""
    pair: list[Identity] = []
    for identity in identities():
        if identity.true and pair:
            yield pair
            pair = []
        pair.append(identity)
    yield pair


def identities() -> Iterator[Identity]:
    """Each identity of the ledger, followed by a false variant of it."""
    seen = set()
    for claim in all_claims():
        steps = [pair for proof in _chains(claim) for pair in pairwise(_expressions(*proof))]
        for number, (left, right) in enumerate(steps, 1):
            if left == right or (left, right) in seen or left.has(*OPEN) or right.has(*OPEN):
                continue
            seen.add((left, right))
            name = f"{claim.label}, step {number}"
            if _verdict(left, right, claim.given) is Verdict.PROVED:
                yield Identity(name, left, right, claim.given, True)
                yield from _variant(name, left, right, claim.given)


def _chains(claim: Claim) -> Iterator[tuple[Any, Chain]]:
    """The chains of a claim between numbers, with what each shows."""
    proof: Any = claim.proof
    pairs: Any = chains_of(claim.says, proof) if isinstance(proof, tuple | Together) else None
    for says, chain in pairs or ():
        if isinstance(says, sympy.Eq) and chain and not says.has(sympy.MatrixBase):
            yield says, chain


def _expressions(says: Any, chain: Chain) -> list[Any]:
    """The expressions of a chain, with the definitions that it uses put in."""
    used = [claim for link in chain for reason in link.reasons for claim in reason.claims]
    rules = rules_of(used)
    links = [says.rhs if link.expression is None else link.expression for link in chain]
    return [put_in(e, rules).doit(integrals=False) for e in (says.lhs, *links)]


def _variant(name: str, left: Any, right: Any, given: Any) -> Iterator[Identity]:
    """The first change of the right side that balls show to be false."""
    for changed in islice(mutations(right, paper.alike()), VARIANTS):
        if not changed.has(*OPEN) and _verdict(left, changed, given) is Verdict.REFUTED:
            yield Identity(f"{name}, made false", left, changed, given, False)
            return


def _verdict(left: Any, right: Any, given: Any) -> Verdict:
    try:
        return decide(tree(left), tree(right), known(conditions(given))).verdict
    except InputError:
        return Verdict.UNDECIDED


def _contenders(identity: Identity) -> Iterator[Contender]:
    trees = tree(identity.left), tree(identity.right)
    given = known(conditions(identity.given))
    left, right = _declared(identity)
    works: dict[str, Callable[[], Any]] = {
        OURS: lambda: decide(*trees, given).verdict,
        "sympy simplify": lambda: sympy.simplify(left - right) == 0,
        "sympy equals": lambda: left.equals(right),
        "sympy trigsimp": lambda: sympy.trigsimp(left - right) == 0,
    }
    for name, work in works.items():
        yield Contender(identity.name, name, work, partial(_judge, identity, name), name == OURS)


def _declared(identity: Identity) -> tuple[Any, Any]:
    """Both sides with the symbols declared positive that the conditions make so."""
    symbols = identity.left.free_symbols | identity.right.free_symbols
    positive = {
        s: sympy.Symbol(s.name, positive=True)
        for s in symbols
        if manifest_sign(tree(s), conditions(identity.given)) == "+"
    }
    return identity.left.xreplace(positive), identity.right.xreplace(positive)


def _judge(identity: Identity, method: str, answer: Any) -> Judged:
    if method == OURS:
        answer = {Verdict.PROVED: True, Verdict.REFUTED: False}.get(answer)
    if answer is identity.true:
        return Judged(outcome=RIGHT)
    if answer is None or (answer is False and method in ("sympy simplify", "sympy trigsimp")):
        return Judged(outcome=FAILED, why="not decided")
    return Judged(outcome=WRONG, why=f"says {answer}")


def summary(timings: list[Timing], limit: float) -> dict[str, dict[str, Any]]:
    """By method, for true identities and false ones: outcomes, and the geometric mean of ratios.

    The mean is of this method's time by ours over all identities; one that timed out counts with
    the limit, so that the mean is then too small.
    """
    ours = {t.contender.scene: t for t in timings if t.contender.method == OURS}
    found: dict[str, dict[str, Any]] = {}
    for kind in ("true", "false"):
        for method in dict.fromkeys(t.contender.method for t in timings):
            some = [
                t
                for t in timings
                if t.contender.method == method
                and t.contender.scene.endswith("made false") == (kind == "false")
            ]
            outcomes = [t.judged.outcome for t in some]
            ratios = [r for t in some if (r := _ratio(t, ours[t.contender.scene], limit))]
            found[f"{method}, {kind} ones"] = {
                "identities": len(some),
                **{word: outcomes.count(word) for word in dict.fromkeys(outcomes)},
                "ratio": float(f"{math.exp(sum(map(math.log, ratios)) / len(ratios)):.3g}")
                if ratios
                else None,
            }
    return found


def _ratio(timing: Timing, ours: Timing, limit: float) -> float | None:
    if timing.judged.outcome == TIMED_OUT and ours.seconds:
        return limit / ours.quartiles[1]
    return timing.ratio(ours)
