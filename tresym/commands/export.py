"""``tresym export``: write the ledger as Coq theorems with their proofs."""

from __future__ import annotations

import argparse
import json
import shutil
import sys
from collections import Counter
from collections.abc import Sequence
from contextlib import closing
from pathlib import Path
from typing import Any

from tresym.commands import claims_file
from tresym.commands.claims_file import is_file_of_claims
from tresym.commands.parser import Commands, add_options
from tresym.reals.numbers.exact import InputError


def add(commands: Commands) -> None:
    """Add `tresym export` to the command line."""
    parser = commands.add_parser(
        "export",
        help="export the ledger, or a file of claims, to Coq",
        description="Write each claim as a theorem of Coq with its proof: one file per part of the "
        "proofs, a Makefile that has Coq check them, and index.json.",
    )
    parser.add_argument(
        "labels",
        nargs="*",
        metavar="[FILE.tresym] LABEL",
        help="claims of the file, or of the racket paper, such as eq_gamma",
    )
    parser.add_argument("--coq", required=True, metavar="DIR", help="the folder to write")
    add_options(
        parser,
        ("--search", "search for missing proofs with coqtop, and store the proofs that are found"),
        (
            "--check",
            "store that Coq has checked the files in the folder; "
            "said.txt must hold the output of make",
        ),
    )


def run(args: argparse.Namespace) -> int:
    """Run the command and return its exit status."""
    if is_file_of_claims(args.labels):
        if args.search or args.check:
            raise InputError("export: --search and --check are for the racket paper")
        return claims_file.export(args.labels[0], args.labels[1:], args.coq, args.force)
    from tresym.coq.export import stored, write
    from tresym.ledger.paper import racket

    args.labels = [racket().label_of(name) for name in args.labels]
    store = stored()
    if args.check:
        return _check(Path(args.coq), store)
    if args.search:
        if shutil.which("coqtop") is None:
            raise InputError("export: --search needs coqtop, which is not installed")
        store = _search(Path(args.coq), args.labels)
    index = write(Path(args.coq), args.labels, store, args.force)
    counts = Counter(row["status"] for row in index.values())
    print(
        f"{args.coq}: {counts['proved']} of {len(index)} claims proved, {counts['partial']} in "
        f"part, {counts['none']} not; run make in this folder to let Coq check the proofs"
    )
    return 0


def _need_compiled(source: Path, said: Path) -> None:
    """Require that Coq compiled a file since it was written, and that make's output is later.

    Raises:
        InputError: it did not.
    """
    compiled = source.with_suffix(".vo")
    written = source.stat().st_mtime_ns
    if not compiled.is_file() or compiled.stat().st_mtime_ns < written:
        raise InputError(f"export: Coq has not compiled {source} as it is now; run make")
    if said.stat().st_mtime_ns < written:
        raise InputError(f"export: {said} is older than {source}; run make")


def _search(folder: Path, labels: Sequence[str]) -> dict[str, Any]:
    """Search for missing proofs, or those of the labels, and store each one found."""
    from tresym.coq.coqtop import version
    from tresym.coq.export import entries, open_claims, save, stamped, stored
    from tresym.coq.ledger_proofs import Memory, premised_points, search, strengthened, witnesses
    from tresym.coq.statement import Theorem
    from tresym.ledger.paper import all_claims

    def keep(label: str, row: dict[str, Any]) -> None:
        store = stored()
        store["claims"][label] = stamped(row, store, version())
        save(store)

    def say(text: str) -> None:
        print(text, file=sys.stderr, flush=True)

    with closing(Memory(folder / "search.json", stored())) as memory:
        wanted = [c for c in open_claims() if not labels or c.label in labels]
        search(wanted, memory, keep, say)
        for label, entry in entries(stored(), labels or None).items():
            whole = entry.theorem
            if not isinstance(whole, Theorem) or not entry.undefined or entry.left is not None:
                continue
            if found := strengthened(label, whole, memory):
                keep(label, stored()["claims"][label] | {"defined": found})
                say(f"{label}: {len(found['left'])} of {len(whole.defined)} premises stay")
        store = stored()
        if not labels:
            claims = all_claims()
            rows = {c.label: store["claims"].get(c.label) for c in claims}
            store["claims"] = {label: row for label, row in rows.items() if row}
            known = entries(store).values()
            wholes = [e.stronger or e.theorem for e in known if e.undefined]
            points = witnesses(claims, memory)
            points |= premised_points((t for t in wholes if isinstance(t, Theorem)), memory)
            store["possible"] = {k: stamped(r, store, version()) for k, r in points.items()}
            save(store)
    return store


def _check(folder: Path, store: dict[str, Any]) -> int:
    """Store that Coq has checked the proofs in the folder, and what they depend on."""
    from tresym.coq.coqtop import version
    from tresym.coq.export import assumed, contents, save, stamped
    from tresym.coq.ledger_statements import name_of

    path = folder / "said.txt"
    if not path.is_file():
        raise InputError(
            f"export: {path} does not exist; redirect the output of make in {folder} to it"
        )
    found = assumed(folder, path.read_text(encoding="utf-8"))
    index = json.loads((folder / "index.json").read_text(encoding="utf-8"))
    for name, text in contents(index, store)[0].items():
        if name.endswith(".v") and (folder / name).read_text(encoding="utf-8") != text:
            raise InputError(
                f"export: {folder / name} is not what would be exported now; export again, and "
                "run make"
            )
        if name.endswith(".v"):
            _need_compiled(folder / name, path)
    beyond = {name: text for name, text in found.items() if "it rests on the classical" not in text}
    changed = 0
    for label, row in store["claims"].items():
        if label not in index:
            continue  # it is not in this folder
        name = name_of(label)
        text = found.get(name) or found.get(name.replace("claim_", "from_", 1), "")
        changed += (row.get("assumptions") or text) != text
        row["assumptions"] = text
        if text and name not in beyond:
            store["claims"][label] = stamped(row, store, version())
    for key, row in store["possible"].items():
        store["possible"][key] = stamped(row, store, version())
    store["coq"] = version()
    save(store)
    for name, text in beyond.items():
        print(f"{name}: {text}")
    print(
        f"{len(found)} theorems; {len(beyond)} rest on axioms that are not allowed; "
        f"the axioms of {changed} theorems have changed since the last check"
    )
    return 1 if beyond or changed else 0
