"""The paper whose claims are in the ledger, loaded on demand.

The judge does not depend on a particular paper: the package of proofs imports the ledger, and the
ledger loads it by name.
"""

from __future__ import annotations

import json
import re
from collections.abc import Iterable
from functools import lru_cache
from importlib import import_module
from importlib.resources import files
from pathlib import Path
from typing import Any, NamedTuple

from sympy import Symbol

from tresym.ledger.claim import Claim

QUOTED = re.compile("“([^”]*)”")
PAPER = "tresym.proofs"
"""The package of proofs: it has ``claims()``, ``parts()``, an index of the paper and box proofs."""


def all_claims(labels: Iterable[str] = ()) -> tuple[Claim, ...]:
    """Return the claims of the proofs, each after the claims that it depends on.

    Args:
        labels: if given, only the modules that contain these claims and their dependencies are
            loaded. If empty, or if a label is not found, all modules are.
    """
    proofs, asked = import_module(PAPER), set(labels)
    found = _each_after_its_own(proofs.claims(proofs.written_in(asked))) if asked else ()
    if found and asked <= {claim.label for claim in found}:
        return found
    return _each_after_its_own(proofs.claims())


def _each_after_its_own(claims: Iterable[Claim]) -> tuple[Claim, ...]:
    order: dict[Claim, None] = {}
    for claim in claims:
        order.update(dict.fromkeys((*claim.rests_on, claim)))
    return tuple(order)


def sections() -> tuple[tuple[str, tuple[Claim, ...]], ...]:
    """Return the parts of the proofs in the paper's order: a title and the claims of each."""
    stated: tuple[tuple[str, tuple[Claim, ...]], ...] = import_module(PAPER).parts()
    return stated


class Correction(NamedTuple):
    """A printed statement that does not hold; listed once, however often it is printed."""

    title: str
    quote: str
    """A short quotation from the paper."""
    labels: tuple[str, ...]
    """The refuted claims that state it; the first one is the main one."""
    why: str = ""
    """Why it does not hold, if the note of the main claim does not say so."""


def corrections() -> tuple[Correction, ...]:
    """Return the printed statements that do not hold, the most important ones first."""
    found: tuple[Correction, ...] = import_module(f"{PAPER}.corrections").CORRECTIONS
    return found


def quotes(claims: Iterable[Claim]) -> dict[str, str]:
    """Return the passages of the paper that the claims and the corrections quote, by label."""
    own = {claim.label: " ".join(QUOTED.findall(claim.paper_says)) for claim in claims}
    return {c.labels[0]: c.quote for c in corrections()} | {k: v for k, v in own.items() if v}


def alike() -> tuple[Symbol, Symbol]:
    """Return the two symbols of the paper that are most easily confused."""
    pair: tuple[Symbol, Symbol] = import_module(PAPER).alike()
    return pair


def file_of(name: str) -> Path:
    """Return the path of a file in the package of proofs."""
    return Path(str(files(PAPER))) / name


@lru_cache(maxsize=1)
def index() -> dict[str, Any]:
    """Return the index of the displays, theorems, tables and figures of the paper."""
    found: dict[str, Any] = json.loads(file_of("index.json").read_text(encoding="utf-8"))
    return found


def display_lines() -> dict[int | None, int]:
    """Return the line of the paper's source on which each display begins, by display number."""
    return {display["number"]: display["line"] for display in index()["displays"]}
