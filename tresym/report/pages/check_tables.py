"""Tables of the saved measurements of ``tresym check``, in Markdown."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

_METHODS = {
    "tresym check": "`tresym check`",
    "sympy simplify": "`simplify(diff(F, x) - f) == 0`",
    "sympy equals": "`diff(F, x).equals(f)`",
}
KINDS = {
    "inequalities": (
        "inequalities with exp, log, sin, atan, roots in one to four variables",
        "MetiTarski",
    ),
    "approximations": (
        "interval and Taylor-model inequalities, tight polynomial approximations",
        "coq-interval, PVS, dReal",
    ),
    "orders": (
        "limits and orders, nested exponentials, mixed bases",
        "Real_Asymp, SymPy's gruntz",
    ),
    "angles": (
        "trigonometric identities of school and olympiad kind, angles kπ/n",
        "Lean benchmarks",
    ),
    "simplifications": (
        "simplification tests, rewrite rules, a formula archive",
        "SymPy, Herbie, Fungrim",
    ),
    "tables": ("antiderivatives", "Rubi"),
}
"""Lists of tests/data/claims: what kind of claims they hold, and whose ground it is."""
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


def by_kind(data: Mapping[str, Any]) -> str:
    """The saved lists as a table in Markdown, a kind a row.

    Args:
        data: what ``python tests/unseen.py save`` wrote.
    """
    lines = [
        "| kind | tools made for it | true | held | false | refuted | wrong | median | 99 % |",
        "|---|---|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for name, (kind, peers) in KINDS.items():
        n = data[name]
        share = f"{n['held']} ({100 * n['held'] / n['true']:.1f} %)"
        counts = _cells((n["true"], share, n["false"], n["refuted"], n["wrong"]))
        lines.append(f"| {kind} | {peers} | {counts} | {n['median']} ms | {n['p99']} ms |")
    return "\n".join(lines) + "\n"


def by_source(data: Mapping[str, Any]) -> str:
    """The saved counts of manuscripts that were read as they are, a source a row, and their sum.

    Args:
        data: docs/measurements/papers.json.
    """
    columns = ("displays", "links", "elementary", "held", "refuted")
    lines = [
        "| source | displays | links | elementary and true | held | refuted | |",
        "|---|--:|--:|--:|--:|--:|---|",
    ]
    for row in data["rows"]:
        lines.append(f"| {row['source']} | {_cells(row[c] for c in columns)} | {row['note']} |")
    total = [sum(row[column] for row in data["rows"]) for column in columns]
    own = data["handbook"]
    return "\n".join(
        [
            *lines,
            f"| together | {_cells(total)} | |",
            "",
            f"Of a handbook's chapter on elementary functions, `tests/data/handbook.tex`, "
            f"{own['held']} of {own['links']} links are held as printed ({own['first_sight']} at "
            f"first sight) and {own['refuted']} are refuted; of {own['changed']} copies with a "
            f"digit, a sign or a factor changed {own['changed_held']} false ones are held.",
            "",
        ]
    )


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
