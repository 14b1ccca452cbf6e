"""Write the ledger as Coq files, one for each part of the proofs, with an index.

The proofs that Coq accepted are stored in ``coq.json`` in the package of proofs, each with a hash
of its statement and a stamp of all that Coq's answer depends on. If the statement has changed
since, the claim is exported without a proof. If anything else has changed, the proof is exported,
so that Coq can check it, but the claim does not count as proved until then. A proof may apply the
theorems of other claims; if one of those is not proved, it becomes a premise, and the claim counts
as partially proved.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any, NamedTuple

from tresym.coq import checked_proofs
from tresym.coq.allowed_axioms import assumptions
from tresym.coq.coqtop import HEAD, prelude
from tresym.coq.ledger_statements import (
    DEDUCED,
    Exported,
    Joint,
    lemmas,
    name_of,
    stamp,
    stem,
    theorem_of,
)
from tresym.coq.statement import NotExportedError, Theorem, condition
from tresym.ledger.claim import AllOf, Claim
from tresym.ledger.paper import all_claims, file_of, racket, sections
from tresym.output import check_replaceable, make_folder, write_text
from tresym.reals.numbers.exact import InputError

STORE = "coq.json"
MAKEFILE = """all: Makefile.coq
\t$(MAKE) -f Makefile.coq

Makefile.coq: _CoqProject
\tcoq_makefile -f _CoqProject -o Makefile.coq

.PHONY: all
"""


class Entry(NamedTuple):
    """The Coq theorem and proof of a claim.

    Attributes:
        theorem: the statement; None if this kind of claim cannot be exported yet.
        lemmas: the lemmas that the proof needs, as Coq text.
        script: a script that Coq accepted, or None.
        premises: labels of the claims whose theorems it applies and that are not proved.
        why: what is missing for a complete proof; empty if nothing is.
        checked: with which version Coq checked exactly this proof, and when; empty if it did not.
        left: the numbers of the premises of definedness that stay; None if none was proved.
        without: the script that proves the theorem without the other premises.
    """

    theorem: Exported | None
    lemmas: str
    script: str | None
    premises: tuple[str, ...]
    why: str
    checked: str = ""
    left: tuple[int, ...] | None = None
    without: str = ""

    @property
    def stronger(self) -> Theorem | None:
        """The theorem without the premises of definedness that are proved, if there are any."""
        if self.left is None or not isinstance(self.theorem, Theorem):
            return None
        return replace(self.theorem, defined=tuple(self.theorem.defined[n] for n in self.left))

    @property
    def undefined(self) -> tuple[str, ...]:
        """The conditions of definedness that stay premises, as Coq text."""
        whole = self.stronger or self.theorem
        if not isinstance(whole, Theorem) or whole.exists or self.script is None:
            return ()
        return tuple(condition(*part) for part in whole.defined)

    @property
    def closed(self) -> bool:
        """Whether Coq proves the theorem, with no premise left."""
        return self.script is not None and not self.premises

    @property
    def status(self) -> str:
        """What Coq proves: ``"proved"``, ``"parts"``, ``"partial"`` or ``"none"``.

        ``"parts"`` means that the theorem is the conjunction of claims from which the claim
        follows, or which support its sentence; ``"partial"``, that a premise is not proved.
        """
        if self.script is None:
            return "none"
        whole = not isinstance(self.theorem, Joint) or self.theorem.whole
        return "partial" if self.premises else "proved" if whole else "parts"


def stored() -> dict[str, Any]:
    """Return the stored proofs that Coq accepted."""
    path = file_of(STORE)
    if not path.is_file():
        return {"coq": "", "claims": {}}
    found: dict[str, Any] = json.loads(path.read_text(encoding="utf-8"))
    return found


def entries(
    store: Mapping[str, Any], wanted: Iterable[str] | None = None, unchecked: bool = False
) -> dict[str, Entry]:
    """Return the theorems of claims, with the proofs that Coq checked for these statements.

    Args:
        store: the stored proofs.
        wanted: labels of claims; the claims whose theorems they apply are added. None means all.
        unchecked: whether proofs whose stamp does not hold count too, to be checked.
    """
    found: dict[str, Entry] = {}
    asked = None if wanted is None else (*wanted,)
    claims = {claim.label: claim for claim in all_claims(_with_applied(asked, store))}
    needed, stack = set(), [*(claims if asked is None else asked)]
    while stack:
        label = stack.pop()
        if label in claims and label not in needed:
            needed.add(label)
            proof = claims[label].proof
            stack += store["claims"].get(label, {}).get("uses", ())
            stack += [c.label for c in claims[label].uses] if _is_joint(proof) else []
    for claim in (c for label, c in claims.items() if label in needed):
        try:
            whole = theorem_of(claim)
        except NotExportedError as error:
            found[claim.label] = Entry(None, "", None, (), str(error))
            continue
        missing = [part.label for part in whole.parts] if isinstance(whole, Joint) else []
        missing = [label for label in missing if label in found and not found[label].theorem]
        if missing:
            why = f"{missing[0]} is not exported: {found[missing[0]].why}"
            found[claim.label] = Entry(None, "", None, (), why)
            continue
        proof_row = store["claims"].get(claim.label)
        if proof_row is None or proof_row["statement"] != stamp(whole):
            why = "no proof is stored for this statement"
            found[claim.label] = Entry(whole, "", None, (), why)
            continue
        seen = checked_proofs.checked(proof_row, applied(proof_row, store), library_text())
        if not seen and not unchecked:
            why = "Coq has not checked its stored proof since that or a lemma it uses was changed"
            found[claim.label] = Entry(whole, "", None, (), why)
            continue
        open_ = tuple(used for used in proof_row["uses"] if not found[used].closed)
        if any(found[used].theorem is None for used in open_):
            found[claim.label] = Entry(
                whole, "", None, (), "its proof applies a theorem that is not exported"
            )
            continue
        if isinstance(whole, Joint) and len(open_) == len(whole.parts):
            found[claim.label] = Entry(whole, "", None, (), "none of its parts is proved")
            continue
        why = f"{', '.join(open_)} not proved" if open_ else ""
        entry = Entry(whole, proof_row["lemmas"], proof_row["script"], open_, why, seen)
        if total := proof_row.get("defined"):
            entry = entry._replace(left=tuple(total["left"]), without=total["script"])
        found[claim.label] = entry
    return found


def _is_joint(proof: Any) -> bool:
    """Return whether the theorem of a claim with this evidence combines those of other claims."""
    return isinstance(proof, (AllOf, *DEDUCED))


def _with_applied(asked: tuple[str, ...] | None, store: Mapping[str, Any]) -> tuple[str, ...]:
    """Return labels with those whose theorems their stored proofs apply; none for all claims."""
    found, stack = set(), [*(asked or ())]
    while stack:
        label = stack.pop()
        if label not in found:
            found.add(label)
            stack += store["claims"].get(label, {}).get("uses", ())
    return tuple(found)


def strengthened(label: str, known: Mapping[str, Entry]) -> bool:
    """Whether a theorem with fewer premises of definedness is proved for a claim."""
    entry = known[label]
    if isinstance(entry.theorem, Joint):
        parts = [part.label for part in entry.theorem.parts]
        return entry.closed and any(strengthened(part, known) for part in parts)
    return entry.stronger is not None


def proposition(label: str, known: Mapping[str, Entry]) -> str:
    """Return the name of the statement that is proved for a claim."""
    return f"{'stronger' if strengthened(label, known) else 'says'}_{stem(label)}"


def stated(label: str, known: Mapping[str, Entry]) -> str:
    """Return the statement that is proved for a claim, as Coq text."""
    entry = known[label]
    if isinstance(entry.theorem, Joint) and strengthened(label, known):
        parts = (proposition(part.label, known) for part in entry.theorem.parts)
        return "  " + " /\\ ".join(parts)
    whole = entry.stronger or entry.theorem
    assert whole is not None
    return whole.body


def library_text() -> str:
    """Return the text of all lemmas, definitions and tactics that proofs may use."""
    return prelude() + lemmas()


def applied(row: Mapping[str, Any], store: Mapping[str, Any]) -> list[str]:
    """Return the hashes of the statements of the theorems that a stored proof applies."""
    rows = store["claims"]
    return [rows[used]["statement"] if used in rows else "" for used in row.get("uses", ())]


def stamped(row: dict[str, Any], store: Mapping[str, Any], coq: str) -> dict[str, Any]:
    """Return a stored proof with the stamp that says that Coq has checked it today."""
    day = datetime.now(UTC).date().isoformat()
    found = checked_proofs.stamp(row, applied(row, store), coq, day, library_text())
    return row | {"checked": {"coq": coq, "day": day, "stamp": found}}


def open_claims() -> list[Claim]:
    """Return the claims for whose current statement no proof is stored."""
    store, found = stored()["claims"], []
    for claim in all_claims():
        try:
            whole = theorem_of(claim)
        except NotExportedError:
            continue
        if store.get(claim.label, {}).get("statement") != stamp(whole):
            found.append(claim)
    return found


def save(store: Mapping[str, Any]) -> None:
    """Write the stored proofs, sorted by label."""
    text = json.dumps(store, indent=0, ensure_ascii=False, sort_keys=True)
    write_text(str(file_of(STORE)), text + "\n")


def contents(
    labels: Iterable[str], store: Mapping[str, Any]
) -> tuple[dict[str, str], dict[str, Any]]:
    """Return the texts of the Coq files by name, and the index.

    ``Statements.v`` contains the statements of all claims. One file for each part of the proofs
    contains the proofs, each with the theorems that it applies as premises. ``Ledger.v`` combines
    them.

    Args:
        labels: labels of claims; all if empty.
        store: the stored proofs.

    Returns:
        The texts, and one row for each claim, by label, as written to ``index.json``.

    Raises:
        InputError: a label is unknown.
    """
    wanted = set(labels)
    claims = {claim.label: claim for claim in all_claims()}
    if wanted - claims.keys():
        raise InputError(f"no claim is labelled {', '.join(sorted(wanted - claims.keys()))}")
    found = entries(store, unchecked=True)
    wanted = _behind(wanted, found, store) if wanted else set(claims)
    chosen = {label: e for label, e in found.items() if label in wanted}
    files = {
        "Tresym.v": prelude(),
        "Racket.v": lemmas(),
        "Statements.v": statements(chosen),
        **racket().coq_files(),
        "Possible.v": possible(store),
    }
    names = dict.fromkeys(chosen, "")
    for part, (title, stated) in zip(_parts(), sections(), strict=True):
        name = part.title().replace("_", "") + ".v"
        texts = [_text(c.label, chosen[c.label], store) for c in stated if c.label in chosen]
        if any(texts):
            files[name] = f"(* {title} *)\n\n{HEAD}Require Import Racket Statements.\n\n"
            files[name] += "\n".join(texts)
        names |= {claim.label: name for claim in stated if claim.label in chosen}
    parts = [name.removesuffix(".v") for name in files if name != "Tresym.v"]
    files["Ledger.v"] = closed(chosen, parts, store)
    files["_CoqProject"] = "\n".join(['-Q . ""', *(n for n in files if n.endswith(".v"))]) + "\n"
    files["Makefile"] = MAKEFILE
    index = {label: _row(label, e, names[label], store) for label, e in chosen.items()}
    files["index.json"] = json.dumps(index, indent=1, ensure_ascii=False) + "\n"
    return files, index


def write(
    folder: Path, labels: Iterable[str], store: Mapping[str, Any], force: bool = False
) -> dict[str, Any]:
    """Write the Coq files of :func:`contents` into a folder and return the index.

    Args:
        folder: the folder; it is created if it does not exist.
        labels: labels of claims; all if empty.
        store: the stored proofs.
        force: whether to replace files that tresym did not write.

    Raises:
        InputError: a label is unknown, or the folder cannot be written.
    """
    files, index = contents(labels, store)
    make_folder(str(folder))
    check_replaceable((str(folder / name) for name in files), force)
    for name, text in files.items():
        write_text(str(folder / name), text)
    return index


def _parts() -> tuple[str, ...]:
    found = racket().modules
    return found


def _behind(wanted: set[str], found: Mapping[str, Entry], store: Mapping[str, Any]) -> set[str]:
    """Return the claims and all claims whose theorems they apply or combine."""
    whole, stack = set(), [*wanted]
    while stack:
        label = stack.pop()
        if label not in whole:
            whole.add(label)
            entry = found[label]
            stack += store["claims"].get(label, {}).get("uses", ()) if entry.script else ()
            if isinstance(entry.theorem, Joint):
                stack += [part.label for part in entry.theorem.parts]
    return whole


def statements(chosen: Mapping[str, Entry]) -> str:
    """Return the text of ``Statements.v``: one definition per claim, whether proved or not."""
    lines = [f"(* What the claims say. *)\n\n{HEAD}"]
    for label, entry in chosen.items():
        if entry.theorem is not None:
            lines.append(f"Definition says_{stem(label)} : Prop :=\n{entry.theorem.body}.\n")
            if strengthened(label, chosen):
                text = stated(label, chosen)
                lines.append(f"Definition stronger_{stem(label)} : Prop :=\n{text}.\n")
    return "\n".join(lines)


def _text(label: str, entry: Entry, store: Mapping[str, Any]) -> str:
    """Return the lemmas and the theorem of a claim, with the theorems it applies as premises."""
    if entry.script is None:
        return ""
    uses = store["claims"][label]["uses"]
    says = " -> ".join(f"says_{stem(name)}" for name in (*uses, label))
    taken = f"intros {' '.join(map(name_of, uses))}.\n" if uses else ""
    unfold = "" if isinstance(entry.theorem, Joint) else f"unfold says_{stem(label)}.\n"
    plain = f"premised_{stem(label)}" if entry.without else name_of(label)
    name = f"from_{stem(label)}" if uses else plain
    before = f"{entry.lemmas}\n" if entry.lemmas else ""
    text = f"{before}Theorem {name} :\n  {says}.\nProof.\n{taken}{unfold}{entry.script}\nQed.\n"
    if entry.without:
        text += (
            f"Theorem stronger_from_{stem(label)} :\n  says_{stem(label)} -> "
            f"stronger_{stem(label)}.\nProof.\nintros premised_{stem(label)}.\n"
            f"unfold stronger_{stem(label)}.\n{entry.without}\nQed.\n"
        )
    return text


def closed(chosen: Mapping[str, Entry], parts: Iterable[str], store: Mapping[str, Any]) -> str:
    """Return the text of ``Ledger.v``: theorems with all premises proved, and their assumptions.

    ``Print Assumptions`` is slow because Coq traverses its whole library. It is therefore called
    only twice: for the theorems whose proofs use no machine arithmetic, and for the others.
    """
    lines = [f"(* The theorems put together. *)\n\n{HEAD}Require Import {' '.join(parts)}.\n"]
    groups: dict[str, list[str]] = {"by_reals": [], "by_machine": []}
    machine: set[str] = set()
    for label, entry in chosen.items():
        if entry.script is None:
            continue
        uses = store["claims"][label]["uses"]
        if not entry.premises:
            lines += _closed(label, uses, chosen)
        if _by_machine(entry) or machine & {*uses}:
            machine.add(label)
        groups["by_machine" if label in machine else "by_reals"].append(_theorem(label, entry))
    for name, theorems in groups.items():
        if theorems:
            lines.append(f"Definition {name} :=\n  ({', '.join(theorems)}).")
            lines.append(f"Print Assumptions {name}.")
    return "\n".join(lines) + "\n"


def _by_machine(entry: Entry) -> bool:
    """Whether a proof, or a lemma or tactic behind it, may use Coq's machine arithmetic."""
    text = f"{entry.lemmas}\n{entry.script}\n{entry.without}"
    return checked_proofs.by_machine(text, library_text())


def _closed(label: str, uses: Iterable[str], chosen: Mapping[str, Entry]) -> Iterator[str]:
    """Yield a theorem with all premises proved, and the stronger one where there is one."""

    def premised(name: str) -> str:
        return f"premised_{stem(name)}" if strengthened(name, chosen) else name_of(name)

    entry, whole = chosen[label], " ".join([f"from_{stem(label)}", *map(premised, uses)])
    if [*uses]:
        yield f"Theorem {premised(label)} : says_{stem(label)}.\nProof.\nexact ({whole}).\nQed."
    if strengthened(label, chosen):
        proof = f"(stronger_from_{stem(label)} {premised(label)})"
        if isinstance(entry.theorem, Joint):
            proof = conjoined([name_of(part.label) for part in entry.theorem.parts])
        yield (f"Theorem {name_of(label)} : stronger_{stem(label)}.\nProof.\nexact {proof}.\nQed.")


def conjoined(names: list[str]) -> str:
    """Return the proof term of a conjunction from the names of its parts' proofs."""
    first, *rest = names
    return f"(conj {first} {conjoined(rest)})" if rest else first


def assumed(folder: Path, output: str) -> dict[str, str]:
    """Return what each theorem depends on, by name, from Coq's output for ``Ledger.v``.

    Args:
        folder: the folder with the exported files.
        output: what Coq printed.

    Raises:
        InputError: the output has another number of blocks than ``Ledger.v`` has groups.
    """
    groups = re.findall(
        r"^Definition (?:by_reals|by_machine) :=\s+\((.*)\)\.$",
        (folder / "Ledger.v").read_text(encoding="utf-8"),
        re.MULTILINE,
    )
    blocks = re.split(r"^(?=Axioms:|Closed under)", output, flags=re.MULTILINE)[1:]
    blocks = blocks[-len(groups) :]  # Ledger.v is read last
    if len(groups) != len(blocks):
        raise InputError(
            f"Coq printed the assumptions of {len(blocks)} groups of theorems, but Ledger.v has "
            f"{len(groups)}"
        )
    return {
        name: assumptions(block).replace("and on Coq's", "and at most on Coq's")
        for group, block in zip(groups, blocks, strict=True)
        for name in group.split(", ")
    }


def _theorem(label: str, entry: Entry) -> str:
    return f"from_{stem(label)}" if entry.premises else name_of(label)


def possible(store: Mapping[str, Any]) -> str:
    """Return the text of ``Possible.v``: a point for each set of conditions.

    The theorems show that the conditions of the claims can be satisfied, so that no theorem holds
    vacuously.
    """
    lines = ["(* Points at which the conditions of the claims hold. *)\n", HEAD]
    lines.append("Require Import Racket.\n")
    for key, row in store.get("possible", {}).items():
        lines.append(f"Theorem possible_{key} :\n{row['body']}.\nProof.\n{row['script']}\nQed.\n")
    return "\n".join(lines)


def _row(label: str, entry: Entry, file: str, store: Mapping[str, Any]) -> dict[str, Any]:
    """Return the row of a claim in the index."""
    theorem = entry.theorem
    return {
        "file": file if entry.script else "",
        "theorem": None if theorem is None else theorem.name,
        "statement": None if theorem is None else stamp(theorem),
        "status": entry.status,
        "premises": list(entry.premises),
        "undefined": list(entry.undefined),
        "assumptions": store["claims"][label].get("assumptions") if entry.script else None,
        "why": entry.why,
    }
