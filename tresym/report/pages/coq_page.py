"""Proofs in Coq: the mark of a claim, and the page that lists which claims Coq proves."""

from __future__ import annotations

from collections import Counter
from functools import lru_cache
from typing import Any

from tresym.coq.export import Entry, entries, stored
from tresym.ledger.paper import sections


@lru_cache(maxsize=4)
def found(labels: tuple[str, ...] | None = None) -> dict[str, Entry]:
    """What Coq has of the claims."""
    return entries(stored(), labels)


def mark(label: str, known: dict[str, Entry]) -> dict[str, Any] | None:
    """The theorem of a claim and its status, None where Coq has proved nothing of it."""
    entry = known.get(label)
    if entry is None or entry.theorem is None or entry.status == "none":
        return None
    return {"theorem": entry.theorem.name, "status": entry.status}


def shown(label: str, known: dict[str, Entry]) -> dict[str, Any] | None:
    """The same, with what the theorem says and rests on, for the claim's page."""
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
    """Which claims Coq proves, and why it does not prove the others."""
    known, store = found(), stored()
    counts = Counter(entry.status for entry in known.values())
    kinds = Counter(
        row.get("assumptions", "")
        for label, row in store["claims"].items()
        if label in known and known[label].status == "proved"
    )
    lines = [
        f"Coq {store['coq']} proves {counts['proved']} of the {len(known)} claims, and "
        f"{counts['partial']} more if claims that it does not prove are assumed. The table gives "
        "the reason for the others.",
        "",
        *(f"- {n} theorems: {text}." for text, n in kinds.most_common() if text),
        f"- For {len(store.get('possible', {}))} sets of conditions Coq proves that some point "
        "satisfies them, so that no theorem is empty because its conditions contradict each other.",
        "",
    ]
    for title, claims in sections():
        lines += [f"## {title}", "", "| claim | Coq | why not |", "|---|---|---|"]
        for claim in claims:
            entry = known[claim.label]
            status = {"none": "not"}.get(entry.status, entry.status)
            lines.append(f"| `{claim.label}` | {status} | {_cell(entry.why)} |")
        lines.append("")
    return "\n".join(lines)


def _cell(text: str) -> str:
    return " ".join(text.replace("|", r"\|").split())
