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
    "orders": ("limits and orders, nested exponentials, mixed bases", "Real_Asymp, SymPy's gruntz"),
    "angles": (
        "trigonometric identities of school and olympiad kind, angles kπ/n",
        "Lean benchmarks",
    ),
    "simplifications": (
        "simplification tests, rewrite rules, a formula archive",
        "SymPy, Herbie, Fungrim",
    ),
    "tables": ("antiderivatives", "Rubi"),
    "special": (
        "special functions: identities, values, inequalities, limits",
        "Mathematica, Fungrim",
    ),
}
"""Lists in tests/data/claims: the kind of claims, and tools made for such claims."""
_VERDICTS = ("PROVED", "ENCLOSED", "REFUTED", "UNDECIDED")
_LISTS = ("true inequalities", "false inequalities", "true orders", "false orders")


def measured(data: Mapping[str, Any]) -> str:
    """Return tables of the benchmark ``check``: verdicts, outcomes and times of each method.

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
        "| method | pairs | decided | undecided | wrong | timed out | time |",
        "|---|--:|--:|--:|--:|--:|--:|",
    ]
    for method, counts in notes["peers"].items():
        outcomes = (counts.get(word, 0) for word in ("right", "failed", "wrong", "timed out"))
        ratio = f"{counts['ratio']:.3g} ×"
        lines.append(f"| {_METHODS[method]} | {counts['pairs']} | {_cells(outcomes)} | {ratio} |")
    return "\n".join(lines) + "\n"


def by_kind(data: Mapping[str, Any]) -> str:
    """Return a table of the saved lists of claims, one row for each kind.

    Args:
        data: what ``python tests/unseen.py save`` wrote.
    """
    lines = [
        "| kind | tools made for it | true | proved | false | refuted | wrong | median | 99 % |",
        "|---|---|--:|--:|--:|--:|--:|--:|--:|",
    ]
    for name, (kind, peers) in KINDS.items():
        n = data[name]
        share = f"{n['held']} ({100 * n['held'] / n['true']:.1f} %)"
        counts = _cells((n["true"], share, n["false"], n["refuted"], n["wrong"]))
        lines.append(f"| {kind} | {peers} | {counts} | {n['median']} ms | {n['p99']} ms |")
    return "\n".join(lines) + "\n"


def by_source(data: Mapping[str, Any]) -> str:
    """Return a table of the manuscripts that were checked unchanged, one row for each, and the sum.

    Args:
        data: docs/measurements/papers.json.
    """
    columns = ("displays", "links", "elementary", "held", "refuted")
    lines = [
        "| source | displays | relations | elementary and true | proved | refuted | |",
        "|---|--:|--:|--:|--:|--:|---|",
    ]
    for row in data["rows"]:
        lines.append(f"| {row['source']} | {_cells(row[c] for c in columns)} | {row['note']} |")
    total = [sum(row[column] for row in data["rows"]) for column in columns]
    own = data["handbook"]
    return "\n".join(
        [
            *lines,
            f"| total | {_cells(total)} | |",
            "",
            f"In a handbook's chapter on elementary functions, `tests/data/handbook.tex`, "
            f"{own['held']} of {own['links']} relations are proved as printed "
            f"({own['first_sight']} when first tried) and {own['refuted']} are refuted. "
            f"Of {own['changed']} copies with one digit, sign or factor changed, "
            f"{own['changed_held']} false ones are proved.",
            "",
        ]
    )


def _times(notes: Mapping[str, Any]) -> list[str]:
    """A sentence on the times for inequalities and orders, if they were measured."""
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
