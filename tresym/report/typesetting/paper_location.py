"""The place of a claim in the paper: section and equation number.

Sections and equations are numbered as in the journal, those of the appendix with its letter.
"""

from __future__ import annotations

from bisect import bisect_right
from functools import lru_cache
from typing import NamedTuple

from tresym.ledger.claim import Claim
from tresym.ledger.paper import display_lines, index


class _Section(NamedTuple):
    name: str
    line: int
    numbered: dict[int, str]
    """The numbers of its equations, by the line of the source on which they begin."""


def place_text(claim: Claim) -> str:
    """Return the place of a claim in the paper, such as ``Sect. 3, eq. (12)``.

    Returns:
        A dash for a lemma that is not in the paper.
    """
    where = claim.where
    if where is None:
        return "—"
    line = where.line or display_lines().get(where.display)
    parts = [_found(line)] if line else []
    parts += [_CELLS.get(where.cell, where.cell)] if where.cell else []
    parts += ["read more strictly"] if claim.paper_says else []
    return ", ".join(parts) or "—"


def _found(line: int) -> str:
    """The place of a line: its equation, table or figure, else its section and last equation."""
    section = _within(line)
    kind, number = _floats().get(line, ("", ""))
    if kind in ("Table", "Fig."):
        return f"{section.name}, {kind} {number}"
    name = f"{kind} {number}" if kind else section.name
    if line in section.numbered:
        return f"{name}, eq. ({section.numbered[line]})"
    if kind:
        return name
    before = [number for at, number in section.numbered.items() if at < line]
    if before:
        return f"{section.name}, after eq. ({before[-1]})"
    after = next(iter(section.numbered.values()), None)
    return f"{section.name}, before eq. ({after})" if after else section.name


@lru_cache(maxsize=1)
def _sections() -> tuple[_Section, ...]:
    """The sections in order, with their numbered equations."""
    starts = [(section["name"], section["line"]) for section in index()["sections"]]
    ends = [*(line for _, line in starts[1:]), 10**9]
    lines = [display["line"] for display in index()["displays"] if display["kind"] == "equation"]
    found, count, lettered = [], 0, False
    for (name, start), end in zip(starts, ends, strict=True):
        if name.startswith("App.") and not lettered:
            count, lettered = 0, True
        letter = f"{name[-1]}." if lettered else ""
        here = [line for line in lines if start <= line < end]
        found.append(
            _Section(name, start, {line: f"{letter}{count + n}" for n, line in enumerate(here, 1)})
        )
        count += len(here)
    return tuple(found)


_CELLS = {"I1, I2, I3": "moments", "epsilon0": "ε₀", "flip": "Δψ"}
_KINDS = {"figure": "Fig.", "table": "Table", "theorem": "Theorem", "remark": "Remark"}


@lru_cache(maxsize=1)
def _floats() -> dict[int, tuple[str, str]]:
    """The kind and number of the theorem, remark, table or figure on each line that has one.

    Theorems and remarks are numbered together within their section.
    """
    counts: dict[str, int] = {}
    found: dict[int, tuple[str, str]] = {}
    for other in index()["others"]:
        kind, start = _KINDS[other["kind"]], other["line"]
        counted = kind if kind in ("Table", "Fig.") else "Theorem"
        number = counts[counted] = counts.get(counted, 0) + 1
        section = "" if counted == kind != "Theorem" else f"{_within(start).name.split()[-1]}."
        found |= dict.fromkeys(range(start, other["end"] + 1), (kind, f"{section}{number}"))
    return found


def _within(line: int) -> _Section:
    sections = _sections()
    return sections[bisect_right([s.line for s in sections], line) - 1]
