"""Draw how many claims each tool decides within a time, and how many of its answers are wrong."""

from __future__ import annotations

from typing import Any

from tresym.report.charts.common import (
    BLUE,
    DASHDOT,
    DASHED,
    DOTTED,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    SOLID,
    tick_text,
)
from tresym.report.figures import style

MARKS: dict[str, tuple[str, Any]] = {
    "tresym check": (BLUE, SOLID),
    "testing with mpmath": (PURPLE, DASHED),
    "SymPy": (RED, DASHDOT),
    "Maxima": (ORANGE, DOTTED),
    "z3": (GREEN, (0, (1, 3))),
}
SHORTEST = 1e-3
"""Seconds at the left end of the chart; a faster answer is shown there."""


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows, with the counts."""
    counts = data["notes"]["counts"]
    words = []
    for method in MARKS:
        if method in counts:
            total = _totals(counts[method])
            words.append(f"{method} {total['right']} right and {total['wrong']} wrong")
    ours = _totals(counts["tresym check"])
    limit, maxima = data["notes"]["limit"], data["notes"]["maxima"]
    return (
        f"{sum(ours.values())} claims whose truth is known, about a third of them false, from "
        "lists of six kinds. Left: the percentage that a tool has rightly called true or false "
        f"within a time (processor time of one answer, at most {limit} s). Right: rightly and, in "
        "red, wrongly decided claims of each kind. A tool answers only what its user can type: z3 "
        "knows polynomials only, and testing says true where no test fails, which is no proof. The "
        "lists are those that tresym is tested with, so its share on other people's claims is "
        f"smaller. Answers: {'; '.join(words)}. Maxima {maxima}, from Debian."
    )


def _totals(kinds: dict[str, dict[str, int]]) -> dict[str, int]:
    return {key: sum(kind[key] for kind in kinds.values()) for key in ("right", "wrong", "open")}


def conclusion(data: dict[str, Any]) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""
    counts = {method: _totals(found) for method, found in data["notes"]["counts"].items()}
    ours = counts.pop("tresym check")
    best = max(counts, key=lambda method: counts[method]["right"])
    return (
        f"tresym decides {ours['right']} of {sum(ours.values())} claims rightly and "
        f"{ours['wrong']} wrongly; the next best here, {best}, decides {counts[best]['right']} "
        f"rightly and {counts[best]['wrong']} wrongly."
    )


def draw(data: dict[str, Any]) -> Any:
    """Draw the shares against time, and bars by kind."""
    figure, grid = style.canvas(7.4, 4.2, 1, 2, width_ratios=(1.15, 1))
    rows = data["answers"]
    methods = [name for name in MARKS if any(r["method"] == name for r in rows)]
    claims = len({(r["kind"], r["claim"]) for r in rows})
    limit = data["notes"]["limit"]
    left, right = grid[0]
    for name in methods:
        colour, line = MARKS[name]
        times = sorted(
            max(SHORTEST, r["seconds"]) for r in rows if r["method"] == name and _is_right(r)
        )
        steps = [100 * (n + 1) / claims for n in range(len(times))]
        x, y = [SHORTEST, *times, limit], [0, *steps, (steps or [0])[-1]]
        left.step(x, y, where="post", color=colour, linestyle=line, linewidth=1.6, label=name)
    left.set_xscale("log")
    left.set_xlim(SHORTEST, limit)
    left.set_ylim(0, 100)
    ticks = list(range(-3, 2))
    left.set_xticks([10.0**n for n in ticks], [tick_text(n) for n in ticks])
    left.set_xticks([], minor=True)
    left.set_xlabel("processor time of one answer")
    left.set_ylabel("% of the claims decided rightly")
    left.grid(color="0.92", linewidth=0.6)
    _bars(right, data, methods)
    handles, labels = left.get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=len(labels))
    return figure


def _bars(sheet: Any, data: dict[str, Any], methods: list[str]) -> None:
    counts = data["notes"]["counts"]
    kinds = list(counts["tresym check"])
    width = 0.8 / len(methods)
    for n, name in enumerate(methods):
        for place, kind in enumerate(kinds):
            found = counts[name].get(kind, {"right": 0, "wrong": 0, "open": 0})
            total = sum(found.values()) or 1
            at = place + (n - (len(methods) - 1) / 2) * width
            share, wrong = 100 * found["right"] / total, 100 * found["wrong"] / total
            sheet.barh(at, share, width * 0.9, color=MARKS[name][0])
            if found["wrong"]:
                hatched = {"color": "white", "edgecolor": RED, "hatch": "///"}
                sheet.barh(at, wrong, width * 0.9, left=share, **hatched)
                text = f" {found['wrong']} wrong"
                sheet.text(share + wrong, at, text, va="center", fontsize=6, color=RED)
    sheet.set_yticks(range(len(kinds)), [_on_two_lines(kind) for kind in kinds], fontsize=7.5)
    sheet.set_ylim(len(kinds) - 0.45, -0.55)
    sheet.set_xlim(0, 118)
    sheet.set_xticks(range(0, 101, 25))
    sheet.set_xlabel("% decided rightly (hatched: wrongly)")
    sheet.tick_params(axis="y", length=0)


def _on_two_lines(kind: str) -> str:
    words = kind.split()
    half = (len(words) + 1) // 2
    return kind if len(words) < 3 else " ".join(words[:half]) + "\n" + " ".join(words[half:])


def _is_right(row: dict[str, Any]) -> bool:
    return bool(row["answer"] == ("true" if row["truth"] else "false"))
