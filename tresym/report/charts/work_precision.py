"""Draw work-precision diagrams with the Pareto front and the selected model."""

from __future__ import annotations

from typing import Any

from tresym.report.charts.common import (
    BLACK,
    BLUE,
    DASHDOT,
    DASHED,
    DOTTED,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    SOLID,
    YELLOW,
    Mark,
    time_axis,
)
from tresym.report.figures import style

MARKS = {
    "tresym, float64 arrays": Mark(BLUE, "*", SOLID, True),
    "tresym, asymptotic": Mark(SKY, "v", SOLID, True),
    "tresym, separatrix": Mark(BLUE, "o", SOLID, True),
    "tresym, carlson": Mark(GREEN, "s", SOLID, True),
    "tresym, planar": Mark(BLACK, "D", SOLID, True),
    "mpmath Newton, phase equation": Mark(SKY, "o", DASHED, False),
    "mpmath findroot, printed equation": Mark(RED, "v", DASHED, False),
    "mpmath findroot over R_F, R_J": Mark(GREEN, "s", DASHED, False),
    "mpmath findroot over quad": Mark(ORANGE, "^", DASHED, False),
    "mpmath odefun": Mark(PURPLE, "P", DASHED, False),
    "scipy brentq, printed equation": Mark(RED, "<", DOTTED, False),
    "scipy brentq over R_F, R_J": Mark(GREEN, "h", DOTTED, False),
    "scipy brentq over quad": Mark(ORANGE, ">", DOTTED, False),
    "scipy solve_ivp, RK45": Mark(YELLOW, "p", DASHDOT, False),
    "scipy solve_ivp, DOP853": Mark(PURPLE, "d", DASHDOT, False),
    "heyoka, Taylor": Mark(BLACK, "X", DASHDOT, False),
}
"""Methods of tresym are filled and solid, others open and dashed."""

LOW, HIGH = 0.6, 1700.0


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows."""
    return (
        "Correct digits of ε(γ), counted against a ball of 1100 digits (at most those asked for), "
        "against processor time for one result, both logarithmic; up and to the left is better. "
        "Filled and solid: the models of tresym; open and dashed: other libraries. A cross is a "
        "result with fewer digits than were asked for, below 1 digit at the lower edge. The grey "
        "line is the Pareto front of all right results; rings mark the model that tresym selects "
        "for 3 to 1000 digits. Float64 arrays: time per result among 4096."
    )


def draw(data: dict[str, Any]) -> Any:
    """Draw a panel for each scene, and one legend for all."""
    figure, grid = style.canvas(7.6, 9.6, 3, 2, sharex=True, sharey=True)
    scenes = list(dict.fromkeys(row["scene"] for row in data["rows"]))
    seconds = [row["seconds"] for row in data["rows"] if row["seconds"]]
    for sheet, scene in zip(grid.flat, scenes, strict=True):
        rows = [row for row in data["rows"] if row["scene"] == scene]
        show_front(sheet, [r for r in rows if r["seconds"] and r["method"] in MARKS])
        for method, mark in MARKS.items():
            show_method(sheet, [r for r in rows if r["method"] == method], mark)
        _picks(sheet, rows, data["notes"]["picks"][scene])
        _silent(sheet, rows)
        sheet.set_title(scene, loc="left")
        sheet.set_xscale("log")
        sheet.set_yscale("log")
        sheet.grid(color="0.92", linewidth=0.6)
        sheet.set_axisbelow(True)
    sheet.set_ylim(LOW, HIGH)
    sheet.set_yticks([1, 3, 10, 16, 30, 100, 300, 1000], [1, 3, 10, 16, 30, 100, 300, 1000])
    sheet.set_yticks([], minor=True)
    sheet.set_xlim(min(seconds) / 2, max(seconds) * 3)
    time_axis(sheet.xaxis, min(seconds), max(seconds))
    for row in grid:
        row[0].set_ylabel("true digits")
    for sheet in grid[-1]:
        sheet.set_xlabel("time for one answer")
    _legend(figure)
    return figure


def digits_of(row: dict[str, Any]) -> float:
    """Return the correct digits, at most those asked for, within the range of the axis."""
    return max(LOW * 1.25, min(row["digits"], row["asked"]))


def front(rows: list[dict[str, Any]]) -> list[tuple[float, float]]:
    """Return (seconds, digits) of the right answers that no other beats in both: the front."""
    points = sorted((r["seconds"], -digits_of(r)) for r in rows if r["outcome"] == "right")
    found: list[tuple[float, float]] = []
    for seconds, negative in points:
        if not found or -negative > found[-1][1]:
            found.append((seconds, -negative))
    return found


def show_front(sheet: Any, rows: list[dict[str, Any]]) -> None:
    """Draw the Pareto front of measurements as a grey line of steps."""
    points = front(rows)
    x = [p[0] for p in points] + [1e3]
    y = [p[1] for p in points] + [points[-1][1]]
    sheet.plot(x, y, drawstyle="steps-post", color="0.8", linewidth=4, zorder=1)


def show_method(sheet: Any, rows: list[dict[str, Any]], mark: Mark) -> None:
    """Draw the measurements of one method: right answers joined, crosses for the others."""
    right = [r for r in rows if r["outcome"] == "right" and r["seconds"]]
    wrong = [r for r in rows if r["outcome"] == "wrong" and r["seconds"]]
    size = 8 if mark.marker == "*" else 4
    line = {**mark.options, "linewidth": 0.9, "markersize": size, "markeredgewidth": 0.8}
    sheet.plot([r["seconds"] for r in right], [digits_of(r) for r in right], **line, zorder=3)
    crosses = {"color": mark.colour, "marker": "x", "linestyle": "", "markersize": 3.6}
    sheet.plot(
        [r["seconds"] for r in wrong],
        [digits_of(r) for r in wrong],
        **crosses,
        markeredgewidth=0.9,
        zorder=2.5,
    )


def _picks(sheet: Any, rows: list[dict[str, Any]], picks: dict[str, str]) -> None:
    at = {(r["method"], r["asked"]): r for r in rows}
    for digits, model in picks.items():
        row = at[f"tresym, {model}", int(digits)]
        sheet.plot(
            row["seconds"],
            digits_of(row),
            "o",
            markersize=9,
            markerfacecolor="none",
            markeredgecolor=BLACK,
            markeredgewidth=0.8,
            zorder=4,
        )


def _silent(sheet: Any, rows: list[dict[str, Any]]) -> None:
    """The methods that gave no answer, with the number of digits from which they failed."""
    lines = []
    for method in MARKS:
        none = [
            r for r in rows if r["method"] == method and r["outcome"] in ("failed", "timed out")
        ]
        if none and not method.startswith("tresym"):
            least, word = min(r["asked"] for r in none), none[0]["outcome"]
            lines.append(f"{method} {word} from {least:g}")
    if lines:
        sheet.text(
            0.985,
            0.03,
            "no answer:\n" + "\n".join(lines),
            transform=sheet.transAxes,
            ha="right",
            va="bottom",
            fontsize=5.2,
            color="0.4",
            zorder=1.5,
        )


def _legend(figure: Any) -> None:
    from matplotlib.lines import Line2D

    handles: list[Any] = [
        Line2D([], [], linewidth=0.9, markersize=4.5, label=name, **mark.options)
        for name, mark in MARKS.items()
    ]
    handles.append(Line2D([], [], color="0.8", linewidth=4, label="Pareto front"))
    ring: dict[str, Any] = {
        "marker": "o",
        "markersize": 9,
        "markerfacecolor": "none",
        "color": BLACK,
    }
    handles.append(Line2D([], [], linestyle="", label="the model that tresym picks", **ring))
    cross: dict[str, Any] = {"marker": "x", "markersize": 4, "color": "0.3"}
    handles.append(Line2D([], [], linestyle="", label="fewer digits than asked", **cross))
    figure.legend(handles=handles, loc="outside upper center", ncols=3, fontsize=7)
