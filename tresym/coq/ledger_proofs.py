"""Find Coq proofs for the claims of the ledger, one claim at a time.

Coq's answers are stored in a file, so that an interrupted search can be continued. The proof of a
lemma that is stored with a claim is not searched for again. Time limits are in CPU seconds, so that
the results do not depend on the load of the machine.
"""

from __future__ import annotations

import json
import re
import time
from collections.abc import Callable, Iterable, Iterator, Mapping
from contextlib import suppress
from hashlib import sha256
from itertools import islice
from pathlib import Path
from typing import Any

from tresym.coq.candidate_search import by_steps
from tresym.coq.checked_proofs import checked, digest, library
from tresym.coq.coqtop import Dialogue
from tresym.coq.definedness import satisfiable, strengthen, trial
from tresym.coq.export import applied, library_text
from tresym.coq.ledger_statements import (
    Exported,
    Joint,
    conditions_of,
    lemmas,
    name_of,
    stamp,
    theorem_of,
)
from tresym.coq.lemma_proofs import Plan, candidates, plans, without_definitions
from tresym.coq.statement import NotExportedError, Theorem, comparison, term, variable
from tresym.coq.witness_points import WAYS, proofs_at
from tresym.ledger.claim import Claim
from tresym.ledger.conversion import known
from tresym.reals.language.expression import number, symbols
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import TimeUp, time_limit

_AND = " /\\ "
_LEMMA = re.compile(r"Theorem \w+ :\n(.*?)\.\nProof\.\n(.*?)\nQed\.", re.DOTALL)
UNWRITTEN = ArithmeticError, AttributeError, RecursionError, TypeError, ValueError, NotExportedError
WRITING_SECONDS, CLAIM_SECONDS, STEPPED_SECONDS, TEXTS = 1.5, 30, 60, 150
EFFORTS = (3, 2), (8, 4)  # how many proofs of a lemma are tried, and seconds for a sentence


class Memory:
    """Coq's answers about texts, and the accepted proofs of lemmas, stored in a file."""

    def __init__(self, path: Path | None, store: Mapping[str, Any] | None = None) -> None:
        self.path = path
        self.known: dict[str, bool | str] = {}
        self.coq: Dialogue | None = None
        self.count = 0
        self.most, self.patience = EFFORTS[-1]
        if path is not None and path.is_file():
            self.known = json.loads(path.read_text(encoding="utf-8"))
        for row in store["claims"].values() if store else ():
            if checked(row, applied(row, store or {}), library_text()):
                for body, proof in _LEMMA.findall(row["lemmas"]):
                    self.known |= {_key("lemma", body): proof, _key(_proof(body, proof)): True}
        for row in store.get("possible", {}).values() if store else ():
            if checked(row, (), library_text()):
                self.known[_key(_proof(row["body"], row["script"]))] = True

    def accepts(self, text: str, patience: int | None = None) -> bool:
        """Return whether Coq accepts the text.

        Args:
            text: Coq text.
            patience: CPU seconds per sentence; the whole text may take four times as long. None
                means the current default.
        """
        patience = patience or self.patience
        key, lost = _key(text), f"{_hash(text)} {patience} {_hash(library_text())}"
        if key not in self.known and lost not in self.known:
            self.count += 1
            coq = self.dialogue()
            if self.count % TEXTS == 0:
                coq.end()  # its definitions accumulate and use memory
            coq.patience = patience
            ok = coq.accepts(text.replace("@", str(self.count)), 4.0 * patience)
            self.known[key if ok else lost] = ok
        return key in self.known

    def dialogue(self) -> Dialogue:
        """Return the running Coq process; start one if there is none."""
        self.coq = self.coq or Dialogue(lemmas=lemmas())
        return self.coq

    def close(self) -> None:
        """End the Coq process."""
        if self.coq is not None:
            self.coq.end()
            self.coq.folder.cleanup()

    def keep(self) -> None:
        """Write the answers to the file."""
        if self.path is not None:
            self.path.parent.mkdir(parents=True, exist_ok=True)
            self.path.write_text(json.dumps(self.known), encoding="utf-8")


def _hash(text: str) -> str:
    return sha256(text.encode()).hexdigest()[:20]


def _key(*texts: str) -> str:
    """Return a hash of the texts and of all lemmas, definitions and tactics that they name."""
    pieces = library(library_text())
    return digest([*texts, pieces.common, pieces.behind("\n".join(texts))])


def _proof(body: str, script: str) -> str:
    """Return a theorem with its proof; ``@`` stands for a number."""
    return f"Theorem trial_@ :\n{body}.\nProof.\n{script}\nQed."


def search(
    claims: Iterable[Claim],
    memory: Memory,
    keep: Callable[[str, dict[str, Any]], object],
    say: Callable[[str], object] = lambda _: None,
) -> None:
    """Search for proofs of the claims, first with little effort, then with more.

    Args:
        claims: the claims.
        memory: Coq's answers so far.
        keep: called with the label and the proof of each claim that was proved.
        say: called with a progress line for each claim.
    """
    left = []
    for claim in claims:
        with suppress(NotExportedError):
            left.append((claim, theorem_of(claim)))
    for memory.most, memory.patience in EFFORTS:
        todo, left = left, []
        for claim, whole in todo:
            row, missing = found(claim, whole, memory)
            say(f"{claim.label}: {f'not proved ({missing})' if row is None else 'proved'}")
            if row is not None:
                keep(claim.label, row)
            else:
                left.append((claim, whole))
            memory.keep()


def found(claim: Claim, whole: Exported, memory: Memory) -> tuple[dict[str, Any] | None, str]:
    """Try the plans for a claim; return the first proof that Coq accepts, or what is missing.

    Args:
        claim: the claim.
        whole: its theorem.
        memory: Coq's answers so far.

    Returns:
        The row to store, or None, and a few words on what is missing.
    """
    missing = "no plan"
    for plan in plans(claim, whole):
        shown = []
        for lemma in plan.lemmas:
            proof = lemma_proof(lemma, memory)
            if proof is None:
                missing = f"lemma {lemma.name}"
                break
            shown.append(f"{lemma.text}\nProof.\n{proof}\nQed.")
        else:
            text = _trial(claim, whole, plan)
            if text and memory.accepts(text, CLAIM_SECONDS):
                return {
                    "statement": stamp(whole),
                    "lemmas": "\n".join(shown),
                    "script": plan.script,
                    "uses": list(plan.uses),
                }, ""
            missing = "its lemmas put together"
    return None, missing


def lemma_proof(lemma: Theorem, memory: Memory) -> str | None:
    """Return a proof of a lemma that Coq accepts, or None."""
    try:
        body = lemma.body
        key = _key("lemma", body)
        if key in memory.known and memory.accepts(_proof(body, str(memory.known[key]))):
            return str(memory.known[key])
        for proof in islice(_found_soon(candidates(lemma)), memory.most):
            if memory.accepts(_proof(body, proof)):
                memory.known[key] = proof
                return proof
        if (found := stepped(lemma, memory)) is not None:
            memory.known[key] = found
        return found
    except UNWRITTEN:  # an expression on the way grew too large
        pass
    return None


def stepped(lemma: Theorem, memory: Memory) -> str | None:
    """Prove an equation step by step, asking Coq after every step; None if that fails."""
    if lemma.relation != "==" or lemma.by is not None:
        return None
    plain, intros = without_definitions(lemma)
    proof = by_steps(plain, memory.dialogue(), time.monotonic() + STEPPED_SECONDS)
    proof = proof and proof.replace("intros", intros, 1)
    return proof if proof and memory.accepts(_proof(lemma.body, proof)) else None


def strengthened(label: str, whole: Theorem, memory: Memory) -> dict[str, Any] | None:
    """Return which premises of definedness stay, with a proof of the theorem without the others."""
    found = strengthen(label, whole, memory.dialogue())
    if found and memory.accepts(trial(label, whole, found), CLAIM_SECONDS):
        return found
    return None


def witnesses(claims: Iterable[Claim], memory: Memory) -> dict[str, Any]:
    """Find a point for each set of conditions, with a Coq proof that the conditions hold there."""
    found: dict[str, Any] = {}
    for claim in claims:
        try:
            given = tuple(conditions_of(claim.given))
        except InputError:
            continue
        if any(c.sign == "==" for c in given):
            continue  # the point is given
        names = sorted(frozenset().union(*(symbols(c.left) | symbols(c.right) for c in given)))
        body = " /\\\n".join(f"  {comparison(*c)}" for c in given)
        body = f"  exists {' '.join(map(variable, names))} : R,\n{body}"
        key = _hash(body)
        if not names or key in found:
            continue
        point = known(given).satisfying_point()
        if point is None or not point.keys() >= {*names}:
            continue
        values = ", ".join(f"({term(number(point[name]))})" for name in names)
        scripts = (f"exists {values}. repeat split; {way}numeric." for way in WAYS)
        found |= _first_accepted(body, scripts, memory)
    return found


def premised_points(wholes: Iterable[Theorem], memory: Memory) -> dict[str, Any]:
    """Find a point where the definitions, conditions and remaining premises of a theorem hold."""
    found: dict[str, Any] = {}
    for whole in wholes:
        there = satisfiable(whole)
        with suppress(*UNWRITTEN):
            found |= _first_accepted(there.body, proofs_at({}, there), memory)
    return found


def _first_accepted(body: str, scripts: Iterable[str], memory: Memory) -> dict[str, Any]:
    """Return the first of the proofs that Coq accepts, by the hash of what it proves."""
    for script in scripts:
        if memory.accepts(_proof(body, script)):
            return {_hash(body): {"body": body, "script": script}}
    return {}


def _found_soon(proofs: Iterator[str]) -> Iterator[str]:
    """Yield proofs as long as writing each takes only little CPU time."""
    while True:
        try:
            with time_limit(WRITING_SECONDS):
                proof = next(proofs, None)
        except TimeUp:
            return
        if proof is None:
            return
        yield proof


def _trial(claim: Claim, whole: Exported, plan: Plan) -> str | None:
    """Return a theorem with the lemmas and the applied theorems as premises, or None."""

    def whole_of(theorem: Exported) -> str:
        if not isinstance(theorem, Joint):
            return f"({theorem.body})"
        return f"({_AND.join(whole_of(theorem_of(part)) for part in theorem.parts)})"

    behind = {used.label: used for used in claim.rests_on}
    try:
        used = [whole_of(theorem_of(behind[label])) for label in plan.uses]
        says = whole_of(whole)
    except (KeyError, NotExportedError):
        return None
    premises = [*used, *(f"({lemma.body})" for lemma in plan.lemmas)]
    names = [*map(name_of, plan.uses), *(lemma.name for lemma in plan.lemmas)]
    lines = ["Theorem trial_@ :", " ->\n".join([*premises, says]) + ".", "Proof."]
    lines += [f"intros {' '.join(names)}."] if names else []
    return "\n".join([*lines, plan.script, "Qed."])
