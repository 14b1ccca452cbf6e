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
    span,
    time_axis,
    time_span,
    worded,
)
from tresym.report.figures import style

SERIES: dict[str, tuple[Mark, tuple[str, ...]]] = {
    "tresym, the model that it selects": (
        Mark(BLUE, "o", SOLID, True),
        ("tresym, asymptotic", "tresym, separatrix", "tresym, carlson", "tresym, planar"),
    ),
    "tresym, arrays in float64": (Mark(BLACK, "*", SOLID, True), ("tresym, float64 arrays",)),
    "mpmath, the stable equation": (
        Mark(SKY, "v", DASHED, False),
        ("mpmath Newton, phase equation",),
    ),
    "mpmath, the printed equation": (
        Mark(RED, "^", DASHED, False),
        ("mpmath findroot, printed equation",),
    ),
    "mpmath, a root of Carlson integrals": (
        Mark(GREEN, "s", DASHED, False),
        ("mpmath findroot over R_F, R_J",),
    ),
    "mpmath, a root of a quadrature": (
        Mark(ORANGE, "D", DASHED, False),
        ("mpmath findroot over quad",),
    ),
    "scipy, roots in float64": (
        Mark(PURPLE, "<", DOTTED, False),
        (
            "scipy brentq, printed equation",
            "scipy brentq over R_F, R_J",
            "scipy brentq over quad",
        ),
    ),
    "differential equation (mpmath, scipy, heyoka)": (
        Mark(YELLOW, "P", DASHDOT, False),
        ("mpmath odefun", "scipy solve_ivp, RK45", "scipy solve_ivp, DOP853", "heyoka, Taylor"),
    ),
}
"""The series of the chart: their marks, and the methods of the measurement that each has.

Methods of tresym are filled and solid, others open and dashed.
"""

METHODS = {method: mark for mark, methods in SERIES.values() for method in methods}
"""The mark of each method of the measurement."""

LOW, HIGH = 0.6, 1700.0
AT = 50
"""The digits of which the conclusion speaks."""


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows."""
    return (
        "Correct digits of ε(γ), counted against a ball of 1100 digits (at most those asked for), "
        "against processor time for one result, both logarithmic; up and to the left is better. "
        "Filled and solid: the models of tresym; open and dashed: other libraries. A cross is a "
        "result with fewer digits than were asked for, below 1 digit at the lower edge. The grey "
        "line passes through the fastest right results. Lines join the results of one method; two "
        "series have several. Arrays in float64: time per result among 4096."
    )


def conclusion(data: dict[str, Any]) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""
    ours, ratios = [], []
    for scene, picks in data["notes"]["picks"].items():
        rows = [r for r in data["rows"] if r["scene"] == scene and r["asked"] == AT]
        own = [r["seconds"] for r in rows if r["method"] == f"tresym, {picks[str(AT)]}"]
        others = [r for r in rows if not r["method"].startswith("tresym")]
        right = [r["seconds"] for r in others if r["outcome"] == "right" and r["seconds"]]
        ours += own
        ratios += [min(right) / own[0]] if right and own else []
    return (
        f"For {AT} digits tresym takes {time_span(ours)} in the six cases; the fastest other "
        f"method that has {AT} right digits takes {span(ratios)} times as long where there is one."
    )


def draw(data: dict[str, Any]) -> Any:
    """Draw a panel for each scene, and one legend for all."""
    figure, grid = style.canvas(7.6, 9.6, 3, 2, sharex=True, sharey=True)
    scenes = list(dict.fromkeys(row["scene"] for row in data["rows"]))
    seconds = [row["seconds"] for row in data["rows"] if row["seconds"]]
    for sheet, scene in zip(grid.flat, scenes, strict=True):
        rows = [row for row in data["rows"] if row["scene"] == scene]
        show_front(sheet, [r for r in rows if r["seconds"] and r["method"] in METHODS])
        picks = data["notes"]["picks"][scene]
        models = SERIES["tresym, the model that it selects"][1]
        for method, mark in METHODS.items():
            if method not in models:
                show_method(sheet, [r for r in rows if r["method"] == method], mark)
        selected = [(f"tresym, {model}", int(digits)) for digits, model in picks.items()]
        show_method(
            sheet, [r for r in rows if (r["method"], r["asked"]) in selected], METHODS[models[0]]
        )
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


def _silent(sheet: Any, rows: list[dict[str, Any]]) -> None:
    """The methods that gave no answer, with the number of digits from which they failed."""
    lines = []
    for method in METHODS:
        none = [
            r for r in rows if r["method"] == method and r["outcome"] in ("failed", "timed out")
        ]
        if none and not method.startswith("tresym"):
            least, word = min(r["asked"] for r in none), none[0]["outcome"]
            lines.append(f"{worded(method)}: {word} from {least:g} digits")
    if lines:
        sheet.text(
            0.985,
            0.03,
            "no answer:\n" + "\n".join(lines),
            transform=sheet.transAxes,
            ha="right",
            va="bottom",
            fontsize=5.8,
            color="0.4",
            zorder=1.5,
        )


def _legend(figure: Any) -> None:
    from matplotlib.lines import Line2D

    handles: list[Any] = [
        Line2D([], [], linewidth=0.9, markersize=4.5, label=name, **mark.options)
        for name, (mark, _) in SERIES.items()
    ]
    handles.append(Line2D([], [], color="0.8", linewidth=4, label="the fastest right results"))
    cross: dict[str, Any] = {"marker": "x", "markersize": 4, "color": "0.3"}
    handles.append(Line2D([], [], linestyle="", label="fewer digits than asked", **cross))
    figure.legend(handles=handles, loc="outside upper center", ncols=3, fontsize=7)
