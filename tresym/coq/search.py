"""Proofs found by asking Coq: candidates are tried one after the other, the one that holds is kept.

What is written is a file by itself: the language and its lemmas, the statement, the proof that was
found, and the command that prints what it rests on. Coq is run here and nowhere else in tresym.
"""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
import time
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, replace
from functools import cache
from pathlib import Path

from tresym.coq.dialogue import accepted, prelude
from tresym.coq.equations import equation_proofs
from tresym.coq.inequalities import inequality_proofs
from tresym.coq.statement import Theorem
from tresym.reals.numbers.exact import InputError

SENTENCE_SECONDS = 8
AT_ONCE = 4
MISSING = "coqc is not installed here, so that Coq has not been asked"
_REALS = {
    "ClassicalDedekindReals.sig_not_dec",
    "ClassicalDedekindReals.sig_forall_dec",
    "FunctionalExtensionality.functional_extensionality_dep",
    "Classical_Prop.classic",
}


@dataclass(frozen=True)
class Outcome:
    """What Coq said of a file.

    Attributes:
        accepted: None where Coq is not installed.
        says: a sentence.
        text: the file.
    """

    accepted: bool | None
    says: str
    text: str


def proofs(theorem: Theorem) -> Iterator[str]:
    """Proofs to try, the likeliest first."""
    try:
        if theorem.relation == "==":
            yield from equation_proofs(theorem)
        else:
            yield from inequality_proofs(theorem)
    except (InputError, OverflowError, RecursionError):  # an expression on the way grew too large
        return


def export(theorems: Sequence[Theorem], seconds: float = 120) -> Outcome:
    """A file that proves the theorems, and what Coq says of it."""
    if shutil.which("coqc") is None:
        found = [next(proofs(theorem), None) for theorem in theorems]
        return Outcome(None, MISSING, file_of(theorems, found))
    deadline = time.monotonic() + seconds
    found = []
    for theorem in theorems:
        proof = _first(theorem, deadline)
        if proof is None:
            says = f"no proof of {theorem.name} was found that Coq accepts"
            return Outcome(False, says, file_of(theorems, found))
        found.append(proof)
    text = file_of(theorems, found)
    accepted, said, took = run(text, seconds)
    if not accepted:
        return Outcome(False, f"Coq does not accept the proof ({said})", text)
    return Outcome(True, f"accepted by Coq {version()} in {took:.1f} s; {assumptions(said)}", text)


def file_of(theorems: Sequence[Theorem], found: Sequence[str | None]) -> str:
    """The file: language, statements, proofs, and what they rest on."""
    parts = [prelude()]
    for theorem, proof in zip(theorems, found, strict=False):
        if proof is not None:
            parts.append(
                f"{theorem.text}\nProof.\n{proof}\nQed.\n\nPrint Assumptions {theorem.name}."
            )
    return "\n".join(parts) + "\n"


def _first(theorem: Theorem, deadline: float) -> str | None:
    """The first proof that Coq accepts."""
    candidates = list(dict.fromkeys(proofs(theorem)))
    for start in range(0, len(candidates), AT_ONCE):
        some = candidates[start : start + AT_ONCE]
        left = deadline - time.monotonic()
        if left <= 0:
            return None
        held = trial([(theorem, proof) for proof in some], left)
        found = next((proof for proof, ok in zip(some, held, strict=True) if ok), None)
        if found is not None:
            return found
    return None


def trial(items: Sequence[tuple[Theorem, str]], seconds: float) -> list[bool]:
    """For each theorem whether Coq accepts the proof."""
    texts = [
        f"{replace(theorem, name=f'trial_{n}').text}\nProof.\n{proof}\nQed."
        for n, (theorem, proof) in enumerate(items)
    ]
    return accepted(texts)


def run(text: str, seconds: float) -> tuple[bool, str, float]:
    """Whether coqc accepts the text, what it printed, and the time it took."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "claim.v"
        path.write_text(text, encoding="utf-8")
        start = time.perf_counter()
        try:
            done = subprocess.run(
                ["coqc", "-q", path.name],
                cwd=folder,
                capture_output=True,
                text=True,
                timeout=seconds,
            )
        except subprocess.TimeoutExpired:
            return False, "its time was over", seconds
    took = time.perf_counter() - start
    if done.returncode == 0:
        return True, done.stdout, took
    lines = done.stderr.split("Error:")[-1].split()
    return False, " ".join(lines)[:200], took


@cache
def version() -> str:
    """The version of Coq."""
    done = subprocess.run(["coqc", "--version"], capture_output=True, text=True, check=True)
    match = re.search(r"version (\S+)", done.stdout)
    return match[1] if match else "?"


def assumptions(said: str) -> str:
    """What ``Print Assumptions`` printed, in a sentence."""
    names = set(re.findall(r"^([^\s:]+)\s*:", said, re.MULTILINE)) - {"Axioms"}
    others = sorted(name for name in names if name not in _REALS)
    numbers = [
        name for name in others if re.match(r"(PrimInt63|PrimFloat|Uint63|FloatAxioms|Int63)", name)
    ]
    if len(numbers) < len(others):
        return f"it rests on {', '.join(others)}"
    if numbers:
        return "it rests on the classical reals and on Coq's machine integers and floats"
    return "it rests on the classical reals alone"
