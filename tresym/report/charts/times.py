"""Draw one workload: the time of every method in every scene."""

from __future__ import annotations

from typing import Any

from tresym.report.charts.common import BLUE, RED, span, time_axis, time_span, time_text, worded
from tresym.report.figures import style


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows."""
    says = worded(data["says"])
    title = says[0].upper() + says[1:] if says[0].isascii() else says
    reference = worded(data["reference"])
    return (
        f"{title}: {data['clock']} of one result, logarithmic, with the quartiles, and the ratio "
        f"to “{reference}”, formed round by round in one interleaved run. Filled: tresym; open: "
        "other methods with all digits correct; cross: fewer digits than asked for, or no result, "
        "with the reason."
    )


def conclusion(data: dict[str, Any]) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""
    ours, ratios = [], []
    for scene in dict.fromkeys(row["scene"] for row in data["rows"]):
        right = [r for r in data["rows"] if r["scene"] == scene and r["outcome"] == "right"]
        own = [r["seconds"] for r in right if r["ours"] and r["seconds"]]
        others = [r["seconds"] for r in right if not r["ours"] and r["seconds"]]
        ours += [min(own)] if own else []
        ratios += [min(others) / min(own)] if own and others else []
    wrong = sum(not r["ours"] and r["outcome"] != "right" for r in data["rows"])
    total = sum(not r["ours"] for r in data["rows"])
    sentence = f"tresym takes {time_span(ours)} of processor time for one result"
    if ratios:
        sentence += (
            f"; the fastest other method with all digits right takes {span(ratios)} times as long"
        )
    return f"{sentence}, and {wrong} of the {total} results of other methods are not right."


def draw(data: dict[str, Any]) -> Any:
    """Draw a line for each method, in groups."""
    rows = data["rows"]
    scenes = list(dict.fromkeys(r["scene"] for r in rows))
    count = len(rows) + (len(scenes) if len(scenes) > 1 else 0)
    figure, grid = style.canvas(7.4, 0.75 + 0.17 * count)
    sheet = grid[0, 0]
    seconds = [r["seconds"] for r in rows if r["seconds"]]
    low, high = min(seconds) / 2, max(seconds) * 40
    place, ticks, labels = 0, [], []
    for scene in scenes:
        if len(scenes) > 1:
            sheet.text(low * 1.1, place, scene, va="center", fontsize=8, fontweight="bold")
            place += 1
        for row in (r for r in rows if r["scene"] == scene):
            _line(sheet, row, place, low, high)
            ticks.append(place)
            labels.append(worded(row["method"]))
            place += 1
    sheet.set_yticks(ticks, labels, fontsize=7.5)
    sheet.tick_params(axis="y", length=0)
    sheet.set_ylim(place - 0.4, -0.6)
    sheet.set_xscale("log")
    time_axis(sheet.xaxis, low, max(seconds))
    sheet.set_xlim(low, high)
    sheet.grid(axis="x", color="0.92", linewidth=0.6)
    sheet.set_axisbelow(True)
    sheet.set_xlabel("time of one answer")
    return figure


def _line(sheet: Any, row: dict[str, Any], place: int, low: float, high: float) -> None:
    if row["seconds"] is None:
        words = f"{row['outcome']}: {row['why']}"
        words = words.partition(" (")[0]
        sheet.text(low * 1.3, place, f"× {words}", va="center", fontsize=6.5, color=RED)
        return
    colour, right = BLUE if row["ours"] else "0.2", row["outcome"] == "right"
    begin, end = row["quartiles"]
    sheet.plot((begin, end), (place, place), color=colour, linewidth=2.5, alpha=0.4, zorder=2)
    sheet.plot(
        row["seconds"],
        place,
        marker="o" if right else "x",
        markersize=5,
        color=colour if right else RED,
        markerfacecolor=colour if row["ours"] else "white",
        markeredgewidth=1,
        zorder=3,
    )
    words = time_text(row["seconds"])
    if row["ratio"] is not None and row["ratio"] != 1:
        words += f", {row['ratio']:,.3g}×" if row["ratio"] < 1000 else f", {row['ratio']:,.0f}×"
    if not right:
        words += f"; {row['why']}"
    if row["seconds"] ** 2 > low * high and not right:
        sheet.text(row["seconds"] / 1.35, place, words, va="center", ha="right", fontsize=6.5)
    else:
        sheet.text(max(end, row["seconds"]) * 1.35, place, words, va="center", fontsize=6.5)
