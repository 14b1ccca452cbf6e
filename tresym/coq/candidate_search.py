"""Search for a Coq proof: try candidates one after the other and keep the first that holds.

The resulting file is self-contained: definitions and lemmas (``Tresym.v``), the statement, the
proof, and the command that prints its assumptions. Only this module and `tresym.coq.coqtop` run
Coq.
"""

from __future__ import annotations

import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from importlib.resources import files
from pathlib import Path

from tresym.coq.allowed_axioms import assumptions
from tresym.coq.bound_proofs import Prove, bound_proofs, no_search
from tresym.coq.bound_statements import BoundTheorem
from tresym.coq.coqtop import HEAD, TEXT_SECONDS, Dialogue, library, prelude, version
from tresym.coq.equations import equation_proofs
from tresym.coq.inequalities import inequality_proofs
from tresym.coq.statement import Theorem
from tresym.coq.stepwise_equations import stepwise
from tresym.reals.numbers.exact import InputError

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
        if theorem.relation == "==":
            yield from equation_proofs(theorem)
        else:
            yield from inequality_proofs(theorem)
    except (InputError, OverflowError, RecursionError):  # an expression on the way grew too large
        return


def export(theorems: Sequence[Theorem | BoundTheorem], seconds: float = 120) -> Outcome:
    """Search for proofs of the theorems and let Coq check the complete file.

    Args:
        theorems: the theorems.
        seconds: wall time for the search, and again for the final check.
    """
    unsearched = next((why for theorem in theorems if (why := no_search(theorem))), None)
    if unsearched is not None:
        return Outcome(False, unsearched, file_of(theorems, [None] * len(theorems)))
    if shutil.which("coqc") is None:
        found = [next(proofs(theorem), None) for theorem in theorems]
        return Outcome(None, MISSING, file_of(theorems, found))
    found = []
    lemmas = HEAD + bound(theorems)
    with Dialogue(lemmas=lemmas) as coq:
        coq.begin()
        deadline = time.monotonic() + seconds
        for theorem in theorems:
            proof = found_by(theorem, coq, deadline)
            if proof is None:
                says = f"no proof of {theorem.name} was found that Coq accepts"
                return Outcome(False, says, file_of(theorems, found))
            found.append(proof)
    text = file_of(theorems, found)
    # Coq reads the lemmas as compiled files; they are long, and compiled once for all claims.
    start = HEAD + "Require Import Racket.\n"
    accepted, output, took = run(start + proved(theorems, found), seconds, library(lemmas))
    if not accepted:
        return Outcome(False, f"Coq does not accept the proof ({output})", text)
    return Outcome(
        True, f"accepted by Coq {version()} in {took:.1f} s; {assumptions(output)}", text
    )


def bound(theorems: Iterable[Theorem | BoundTheorem]) -> str:
    """Return the texts of ``Bound.v`` and ``Orders.v`` if one of the theorems needs them."""
    found = [theorem for theorem in theorems if isinstance(theorem, BoundTheorem)]
    names = ["Bound.v"] if found else []
    names += ["Orders.v"] if any(theorem.statement.path for theorem in found) else []
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
        if coq.accepts(f"Goal\n{theorem.body}.\nProof.\n{proof}\nQed.", min(left, TEXT_SECONDS)):
            return proof
    if isinstance(theorem, Theorem) and theorem.relation == "==" and theorem.by is None:
        return by_steps(theorem, coq, deadline)
    return None


def by_steps(theorem: Theorem, coq: Dialogue, deadline: float) -> str | None:
    """Prove an equation step by step, asking Coq after every step; None if that fails."""

    def begin() -> None:
        coq.begin()
        coq.holds("Abort All.")
        coq.holds(f"Goal\n{theorem.body}.")

    def ask(sentence: str) -> bool:
        return time.monotonic() < deadline and coq.holds(sentence)

    proof = stepwise(theorem, ask, begin)
    held = proof is not None and coq.holds("Qed.")
    coq.holds("Abort All.")
    return proof if held else None


def run(text: str, seconds: float, options: tuple[str, ...] = ()) -> tuple[bool, str, float]:
    """Run coqc on the text; return whether it accepts it, its output or error, and the time."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "claim.v"
        path.write_text(text, encoding="utf-8")
        start = time.perf_counter()
        try:
            done = subprocess.run(
                ["coqc", "-q", *options, path.name],
                cwd=folder,
                capture_output=True,
                text=True,
                timeout=seconds,
            )
        except subprocess.TimeoutExpired:
            return False, f"Coq did not finish within {seconds:g} s", seconds
    took = time.perf_counter() - start
    if done.returncode == 0:
        return True, done.stdout, took
    lines = done.stderr.split("Error:")[-1].split()
    return False, " ".join(lines)[:200], took
