"""The ledger as files of Coq, one for each part of the proofs, and an index of what is proved.

The proofs that Coq accepted are kept in ``coq.json`` beside the claims, each with a stamp of its
statement: a statement that has changed since is written without a proof, in a comment.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Iterable, Mapping
from importlib import import_module
from pathlib import Path
from typing import Any, NamedTuple

from tresym.coq.ledger import candidates, stamp, theorems_of
from tresym.coq.numbers import numbers
from tresym.coq.search import prelude, trial, version
from tresym.coq.statement import NotExportedError, Theorem
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.paper import PAPER, file_of, sections
from tresym.output import write_text
from tresym.reals.numbers.exact import InputError

STORE = "coq.json"
MOST, AT_ONCE, SECONDS = 8, 40, 1200.0
HEAD = """(* {title} *)

Require Import Reals Lra Lia Psatz.
From Coquelicot Require Import Coquelicot.
From Interval Require Import Tactic.
Require Import Tresym.
Open Scope R_scope.
"""
MAKEFILE = """all: Makefile.coq
\t$(MAKE) -f Makefile.coq

Makefile.coq: _CoqProject
\tcoq_makefile -f _CoqProject -o Makefile.coq

.PHONY: all
"""


class Entry(NamedTuple):
    """What Coq has of a claim.

    Attributes:
        theorems: its statements, none where its kind is not exported yet.
        proofs: for each its proof, None where there is none.
        why: what is missing.
    """

    theorems: tuple[Theorem, ...]
    proofs: tuple[str | None, ...]
    why: str

    @property
    def status(self) -> str:
        """``proved``, ``partial`` where a part is, or ``none``."""
        if not self.theorems or not any(self.proofs):
            return "none"
        return "proved" if all(self.proofs) else "partial"


def stored() -> dict[str, Any]:
    """The proofs that Coq accepted."""
    path = file_of(STORE)
    if not path.is_file():
        return {"coq": "", "claims": {}}
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def entry(claim: Claim, store: Mapping[str, Any]) -> Entry:
    """The claim's theorems with the proofs that are stored for these very statements."""
    try:
        found = tuple(theorems_of(claim))
    except NotExportedError as error:
        return Entry((), (), str(error))
    kept = store["claims"].get(claim.label)
    if kept is None or kept["statement"] != stamp(found):
        return Entry(found, (None,) * len(found), "no proof is stored for this statement")
    proofs = tuple(kept["proofs"].get(theorem.name) for theorem in found)
    return Entry(found, proofs, "" if all(proofs) else "Coq has accepted no proof of some part")


def search(
    claims: Iterable[Claim], say: Callable[[str], object] = lambda _: None
) -> dict[str, Any]:
    """Find proofs anew, by asking Coq."""
    jobs = []
    for claim in claims:
        try:
            found = theorems_of(claim)
        except NotExportedError:
            continue
        for theorem in found:
            try:
                jobs.append((theorem, list(candidates(claim, theorem))[:MOST]))
            except (InputError, OverflowError, RecursionError):
                continue  # an expression on the way grew too large
    won: dict[str, str] = {}
    for start in range(0, len(jobs), AT_ONCE):
        todo = jobs[start : start + AT_ONCE]
        for n in range(MOST):
            todo = [job for job in todo if job[0].name not in won and len(job[1]) > n]
            held = trial([(t, proofs[n]) for t, proofs in todo], SECONDS) if todo else []
            won |= {t.name: p[n] for (t, p), ok in zip(todo, held, strict=True) if ok}
        say(f"{len(won)} of {min(start + AT_ONCE, len(jobs))} statements proved")
    return {"coq": version(), "claims": _kept(claims, won)}


def _kept(claims: Iterable[Claim], won: Mapping[str, str]) -> dict[str, Any]:
    kept = {}
    for claim in claims:
        try:
            found = theorems_of(claim)
        except NotExportedError:
            continue
        proofs = {t.name: won[t.name] for t in found if t.name in won}
        if proofs:
            kept[claim.label] = {"statement": stamp(found), "proofs": proofs}
    return kept


def save(store: Mapping[str, Any]) -> None:
    """Keep the proofs beside the claims."""
    write_text(str(file_of(STORE)), json.dumps(store, indent=0, ensure_ascii=False) + "\n")


def write(folder: Path, labels: Iterable[str], store: Mapping[str, Any]) -> dict[str, Any]:
    """Write the files into ``folder``; returns the index.

    Raises:
        InputError: an unknown label, or a folder that cannot be written.
    """
    wanted = set(labels)
    known = {claim.label for _, claims in sections() for claim in claims}
    if wanted - known:
        raise InputError(f"no claim is called {', '.join(sorted(wanted - known))}")
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise InputError(f"{folder}: cannot be made ({error.strerror})") from None
    write_text(str(folder / "Tresym.v"), prelude())
    write_text(str(folder / "Numbers.v"), numbers())
    files, index = ["Tresym.v", "Numbers.v"], {}
    entries: dict[str, Entry] = {}
    for part, (title, claims) in zip(_parts(), sections(), strict=True):
        chosen = [claim for claim in claims if not wanted or claim.label in wanted]
        if not chosen:
            continue
        name = part.title().replace("_", "") + ".v"
        texts = [HEAD.format(title=title)]
        for claim in chosen:
            found = entries[claim.label] = entry(claim, store)
            texts += [_text(t, p) for t, p in zip(found.theorems, found.proofs, strict=True)]
            index[claim.label] = _row(claim, found, name, entries)
        write_text(str(folder / name), "\n".join(texts))
        files.append(name)
    write_text(str(folder / "_CoqProject"), "\n".join(["-R . Racket", *files]) + "\n")
    write_text(str(folder / "Makefile"), MAKEFILE)
    text = json.dumps(index, indent=1, ensure_ascii=False) + "\n"
    write_text(str(folder / "index.json"), text)
    return index


def _parts() -> tuple[str, ...]:
    found: tuple[str, ...] = import_module(PAPER).PARTS
    return found


def _text(theorem: Theorem, proof: str | None) -> str:
    if proof is None:
        return f"(* Not proved in Coq:\n{theorem.text}\n*)\n"
    return f"{theorem.text}\nProof.\n{proof}\nQed.\nPrint Assumptions {theorem.name}.\n"


def _row(claim: Claim, found: Entry, file: str, entries: Mapping[str, Entry]) -> dict[str, Any]:
    """The claim in the index; a sentence that says several claims has those of them."""
    if isinstance(claim.proof, AllOf):
        parts = [entries.get(part.label) for part in claim.proof.claims]
        states = {part.status if part else "none" for part in parts}
        status = "proved" if states == {"proved"} else "partial" if states != {"none"} else "none"
        names = [t.name for part in parts if part for t in part.theorems]
        return {"file": file, "theorems": names, "status": status, "why": "", "together": True}
    return {
        "file": file,
        "theorems": [t.name for t in found.theorems],
        "statement": stamp(found.theorems) if found.theorems else None,
        "status": found.status,
        "why": found.why,
        "together": False,
    }
