"""Proofs in Coq: the mark of a claim, and the page that lists which claims Coq proves."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache
from typing import Any

from tresym.coq.export import Entry, entries, stored
from tresym.ledger.paper import sections


@lru_cache(maxsize=4)
def found(labels: tuple[str, ...] | None = None) -> dict[str, Entry]:
    """Return what is known in Coq about each claim, by label.

    Args:
        labels: the claims wanted; None means all.
    """
    return entries(stored(), labels)


def mark(label: str, known: dict[str, Entry]) -> dict[str, Any] | None:
    """Return the theorem of a claim and its status.

    Returns:
        None if Coq has proved nothing about the claim.
    """
    entry = known.get(label)
    if entry is None or entry.theorem is None or entry.status == "none":
        return None
    return {"theorem": entry.theorem.name, "status": entry.status}


def shown(label: str, known: dict[str, Entry]) -> dict[str, Any] | None:
    """Return :func:`mark` with the text, premises and assumptions of the theorem, for its page."""
    marked = mark(label, known)
    if marked is None:
        return None
    entry, row = known[label], stored()["claims"][label]
    assert entry.theorem is not None
    return marked | {
        "text": entry.theorem.text,
        "premises": list(entry.premises),
        "assumptions": row.get("assumptions", ""),
    }


def page() -> str:
    """Write the page that lists which claims Coq proves, with the reason where it does not."""
    known, store = found(), stored()
    counts = Counter(entry.status for entry in known.values())
    kinds = Counter(
        row.get("assumptions", "")
        for label, row in store["claims"].items()
        if label in known and known[label].status == "proved"
    )
    lines = [
        f"Coq {store['coq']} proves {counts['proved']} of the {len(known)} claims. It proves "
        f"{counts['partial']} more (marked *partial*) from premises that are not proved in Coq. "
        "The tables give the reason wherever a proof is missing or partial.",
        "",
        *(f"- {n} theorems: {text}." for text, n in kinds.most_common() if text),
        f"- For {len(store.get('possible', {}))} sets of conditions Coq proves that some point "
        "satisfies them, so that no theorem holds only because its conditions contradict each "
        "other.",
        "",
    ]
    for title, claims in sections():
        lines += [f"## {title}", "", "| claim | Coq | reason |", "|---|---|---|"]
        for claim in claims:
            entry = known[claim.label]
            status = {"none": "not proved"}.get(entry.status, entry.status)
            lines.append(f"| `{claim.label}` | {status} | {_cell(entry.why)} |")
        lines.append("")
    return "\n".join(lines)


def _cell(text: str) -> str:
    return " ".join(text.replace("|", r"\|").split())
