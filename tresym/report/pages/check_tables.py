"""What `tresym check` decided in the saved measurement, as tables in Markdown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_METHODS = {
    "tresym check": "`tresym check`",
    "sympy simplify": "`simplify(diff(F, x) - f) == 0`",
    "sympy equals": "`diff(F, x).equals(f)`",
}
_VERDICTS = ("PROVED", "ENCLOSED", "REFUTED", "UNDECIDED")
_LISTS = ("true inequalities", "false inequalities", "true orders", "false orders")


def measured(data: Mapping[str, Any]) -> str:
    """The saved workload ``check`` as tables: verdicts on claims, outcomes and times of methods.

    Args:
        data: what ``tresym bench check --save`` wrote.
    """
    notes = data["notes"]
    rows = [
        ("antiderivatives of our collection", notes["pairs"]),
        ("the same, one change in the integrand", notes["mutants"]),
        ("random identities, true", notes["trial"]["true"]),
        ("random identities, false", notes["trial"]["false"]),
    ]
    rows[2:2] = [(name, notes[name]) for name in _LISTS if name in notes]
    lines = [f"| claims | number | {_cells(_VERDICTS)} |", "|---|--:|--:|--:|--:|--:|"]
    for name, counts in rows:
        number = counts.get("claims", counts.get("identities"))
        lines.append(f"| {name} | {number} | {_cells(counts.get(v, 0) for v in _VERDICTS)} |")
    pairs = notes["pairs"]
    lines += [
        "",
        *_times(notes),
        f"An antiderivative takes {_milliseconds(pairs['median'])} in the median and "
        f"{_milliseconds(pairs['p99'])} at the 99th percentile.",
        "",
        "| method | pairs | decided | open | wrong | late | time |",
        "|---|--:|--:|--:|--:|--:|--:|",
    ]
    for method, counts in notes["peers"].items():
        outcomes = (counts.get(word, 0) for word in ("right", "failed", "wrong", "timed out"))
        ratio = f"{counts['ratio']:.3g} ×"
        lines.append(f"| {_METHODS[method]} | {counts['pairs']} | {_cells(outcomes)} | {ratio} |")
    return "\n".join(lines) + "\n"


def _times(notes: Mapping[str, Any]) -> list[str]:
    """A sentence on the times of inequalities and orders, where they were measured."""
    found = [(name, notes[name]) for name in _LISTS if name in notes]
    if not found:
        return []
    medians = ", ".join(f"{_milliseconds(counts['median'])} for {name}" for name, counts in found)
    longest = max(counts["longest"] for _, counts in found)
    return [f"The median is {medians}; the longest took {longest:.2g} s.", ""]


def _cells(values: Any) -> str:
    return " | ".join(str(value) for value in values)


def _milliseconds(seconds: float) -> str:
    return f"{1000 * seconds:.2g} ms"
