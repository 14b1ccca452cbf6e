"""The paper whose claims are in the ledger, loaded on demand.

The judge knows no paper; the proofs import the ledger, never the other way round.
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
"""A package with ``claims()`` and ``parts()``, an index of the paper and stored box proofs."""


def all_claims(labels: Iterable[str] = ()) -> tuple[Claim, ...]:
    """Every claim of the proofs, each after all that it rests on.

    Args:
        labels: where they are given, no more files are loaded than those in which they are written
            and what these rest on; all, where one is written nowhere.
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
    """The parts of the proofs in the paper's order: a title and the claims stated there."""
    stated: tuple[tuple[str, tuple[Claim, ...]], ...] = import_module(PAPER).parts()
    return stated


class Correction(NamedTuple):
    """What the paper prints and does not hold, once, wherever it is printed."""

    title: str
    quote: str
    """The paper's own words, short."""
    labels: tuple[str, ...]
    """The refuted claims that say it; the first leads."""
    why: str = ""
    """Why it does not hold, where the note of the leading claim does not say it."""


def corrections() -> tuple[Correction, ...]:
    """What the paper prints and does not hold, the weightiest first."""
    found: tuple[Correction, ...] = import_module(f"{PAPER}.corrections").CORRECTIONS
    return found


def quotes(claims: Iterable[Claim]) -> dict[str, str]:
    """The paper's words, as these claims and the corrections quote them, by the claim's label."""
    own = {claim.label: " ".join(QUOTED.findall(claim.paper_says)) for claim in claims}
    return {c.labels[0]: c.quote for c in corrections()} | {k: v for k, v in own.items() if v}


def alike() -> tuple[Symbol, Symbol]:
    """The two symbols of the paper that are most easily taken for each other."""
    pair: tuple[Symbol, Symbol] = import_module(PAPER).alike()
    return pair


def file_of(name: str) -> Path:
    """A file that lies beside the proofs."""
    return Path(str(files(PAPER))) / name


@lru_cache(maxsize=1)
def index() -> dict[str, Any]:
    """The displays, theorems, tables and figures of the paper, without its text."""
    found: dict[str, Any] = json.loads(file_of("index.json").read_text(encoding="utf-8"))
    return found


def display_lines() -> dict[int | None, int]:
    """The line of the paper's source on which each display begins."""
    return {display["number"]: display["line"] for display in index()["displays"]}
