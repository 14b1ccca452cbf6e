"""Search for a Coq proof: try candidates one after the other and keep the first that holds.

The resulting file is self-contained: definitions and lemmas (``Tresym.v``), the statement, the
proof, and the command that prints its assumptions. Only this module and `tresym.coq.coqtop` run
Coq.
"""

from __future__ import annotations

import shutil
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from importlib.resources import files

from tresym.coq.allowed_axioms import assumptions
from tresym.coq.bound_proofs import Prove, bound_proofs, no_search
from tresym.coq.bound_statements import BoundTheorem, sums_in
from tresym.coq.checked_proofs import by_machine
from tresym.coq.coqtop import (
    HEAD,
    TEXT_SECONDS,
    Dialogue,
    axioms,
    declares,
    prelude,
    version,
)
from tresym.coq.equations import equation_proofs
from tresym.coq.inequalities import inequality_proofs
from tresym.coq.residual_proofs import has_residual, residual_proofs
from tresym.coq.statement import Theorem
from tresym.coq.stepwise_equations import stepwise
from tresym.reals.numbers.exact import InputError, decimal_above

CONSTANT_SECONDS = 20.0
MISSING = "coqc is not installed, so the proof has not been checked by Coq"
"""Lines in which make says where it is, beside what Coq prints."""


@dataclass(frozen=True)
class Outcome:
    """The result of an export.

    Attributes:
        accepted: whether Coq accepts the file; None if Coq is not installed.
        says: a sentence for the user.
        text: the file.
    """

    accepted: bool | None
    says: str
    text: str


def proofs(theorem: Theorem | BoundTheorem, prove: Prove = lambda _: None) -> Iterator[str]:
    """Yield proofs to try, the most likely first.

    Args:
        theorem: the theorem.
        prove: a prover of lemmas, for theorems about integrals, sums and limits.
    """
    try:
        if isinstance(theorem, BoundTheorem):
            yield from bound_proofs(theorem, prove)
            return
        if has_residual(theorem):
            yield from residual_proofs(theorem, prove)
        if theorem.relation == "==":
            yield from equation_proofs(theorem)
        else:
            yield from inequality_proofs(theorem)
    except (InputError, OverflowError, RecursionError):  # an expression on the way grew too large
        return


def export(
    theorems: Sequence[Theorem | BoundTheorem],
    also: BoundTheorem | None = None,
    seconds: float = 120,
) -> Outcome:
    """Search for proofs of the theorems that Coq accepts.

    Args:
        theorems: the theorems.
        also: an order with its constant, which the file also contains if a proof is found.
        seconds: wall time for the search.
    """
    unsearched = next((why for theorem in theorems if (why := no_search(theorem))), None)
    if unsearched is not None:
        return Outcome(False, unsearched, file_of(theorems, [None] * len(theorems)))
    if shutil.which("coqc") is None:
        found = [next(proofs(theorem), None) for theorem in theorems]
        return Outcome(None, MISSING, file_of(theorems, found))
    proved_by: list[str] = []
    lemmas = HEAD + bound(theorems)
    start = time.monotonic()
    with Dialogue(lemmas=lemmas) as coq:
        coq.begin()
        for theorem in theorems:
            proof = found_by(theorem, coq, start + seconds)
            if proof is None or not is_proved(theorem, proof, coq):
                says = f"no proof of {theorem.name} was found that Coq accepts"
                return Outcome(False, says, file_of(theorems, proved_by))
            proved_by.append(proof)
        if also is not None:
            proof = found_by(also, coq, min(start + seconds, time.monotonic() + CONSTANT_SECONDS))
            if proof is not None and is_proved(also, proof, coq):
                theorems = [*theorems, also]
                proved_by.append(proof)
    took = time.monotonic() - start
    says = f"accepted by Coq {version()} in {took:.1f} s; {_rests(lemmas, proved_by)}"
    says += "".join(map(_constant_text, theorems))
    return Outcome(True, says, file_of(theorems, proved_by))


def _constant_text(theorem: Theorem | BoundTheorem) -> str:
    """Return with which constant an order is proved; empty for another theorem."""
    if isinstance(theorem, Theorem) or theorem.bounded is None:
        return ""
    constant, _, region = theorem.bounded
    return f"; proved with C = {decimal_above(constant.args[0], 3)} on {region}"


def _rests(lemmas: str, found: Iterable[str]) -> str:
    """Return on which axioms the proofs rest: those of the lemmas, which were asked once."""
    says = assumptions(axioms(lemmas))
    machine = any(by_machine(proof, f"{prelude()}\n{lemmas}") for proof in found)
    if machine and "machine" not in says:
        says = says.removesuffix(" alone") + " and at most on Coq's machine integers and floats"
    return says


def is_proved(theorem: Theorem | BoundTheorem, proof: str, coq: Dialogue) -> bool:
    """Return whether Coq has just proved the theorem, by tactics alone.

    The search ran in this process, so that Coq's kernel has seen the proof; this asks that the
    proof declared nothing, and that what Coq kept last is a proof of the statement.
    """
    return not declares(proof) and coq.proved(theorem.body)


def bound(theorems: Iterable[Theorem | BoundTheorem]) -> str:
    """Return the texts of the files of lemmas, beside ``Tresym.v``, that the theorems need."""
    found = [*theorems]
    bounds = [theorem for theorem in found if isinstance(theorem, BoundTheorem)]
    roots = any(isinstance(t, Theorem) and has_residual(t) for t in found)
    sums = any(sums_in(t.claim.left) for t in bounds if t.statement.path is not None)
    orders = any(theorem.statement.path for theorem in bounds)
    names = ["Bound.v"] if bounds else []
    names += ["Orders.v"] if orders else []
    if roots or sums:  # each file uses those before it
        names = ["Bound.v", "Orders.v", "Lemmas.v"]
    texts = (files("tresym.coq").joinpath(name).read_text(encoding="utf-8") for name in names)
    return "\n".join(texts)


def file_of(theorems: Sequence[Theorem | BoundTheorem], found: Sequence[str | None]) -> str:
    """Return the file: prelude, statements, proofs, and ``Print Assumptions`` commands."""
    parts = ["(* Written by tresym. *)\n", prelude(), bound(theorems), proved(theorems, found)]
    return "\n".join(parts)


def proved(theorems: Sequence[Theorem | BoundTheorem], found: Sequence[str | None]) -> str:
    """Return the theorems with their proofs, which follow the lemmas in the file."""
    parts = []
    for theorem, proof in zip(theorems, found, strict=False):
        if proof is not None:
            parts.append(
                f"{theorem.text}\nProof.\n{proof}\nQed.\n\nPrint Assumptions {theorem.name}."
            )
    return "\n".join(parts) + "\n"


def found_by(theorem: Theorem | BoundTheorem, coq: Dialogue, deadline: float) -> str | None:
    """Return the first proof that Coq accepts before the deadline, or None.

    Args:
        theorem: the theorem.
        coq: a running Coq process.
        deadline: a time of ``time.monotonic()``.
    """
    for proof in proofs(theorem, lambda lemma: found_by(lemma, coq, deadline)):
        left = deadline - time.monotonic()
        if left <= 0:
            return None
        if coq.accepts(f"{coq.goal(theorem.body)}\nProof.\n{proof}\nQed.", min(left, TEXT_SECONDS)):
            return proof
    if isinstance(theorem, Theorem) and theorem.relation == "==" and theorem.by is None:
        return by_steps(theorem, coq, deadline)
    return None


def by_steps(theorem: Theorem, coq: Dialogue, deadline: float) -> str | None:
    """Prove an equation step by step, asking Coq after every step; None if that fails."""

    def begin() -> None:
        coq.begin()
        coq.holds("Abort All.")
        coq.holds(coq.goal(theorem.body))

    def ask(sentence: str) -> bool:
        return time.monotonic() < deadline and coq.holds(sentence)

    proof = stepwise(theorem, ask, begin)
    held = proof is not None and coq.holds("Qed.")
    coq.holds("Abort All.")
    return proof if held else None
