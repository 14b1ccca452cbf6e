"""Model no more than the scene needs: each cell's rung and cost, and the next rung's cost."""

from __future__ import annotations

from typing import Any

from tresym.report.charts.common import BLACK, BLUE, GREEN, ORANGE, RED, time_axis
from tresym.report.figures import style

RUNGS = {
    "float64 arrays": ("*", ORANGE),
    "asymptotic": ("v", RED),
    "separatrix": ("o", BLUE),
    "carlson": ("s", GREEN),
    "planar": ("D", BLACK),
}


def caption(data: dict[str, Any]) -> str:
    """What to see, with what is saved altogether."""
    pairs = [p for p in _pairs(data) if p[2] is not None]
    ratios = sorted(heavier["seconds"] / own["seconds"] for _, own, heavier in pairs)
    return (
        "Each table cell and each figure panel (by a point of it): the digits it needs (in "
        "brackets), the time of one answer on the rung it takes (filled), and what the next "
        "heavier rung would have cost for the same digits (open). The heavier rung costs "
        f"{ratios[0]:.2g} to {ratios[-1]:.0f} times as much, {ratios[len(ratios) // 2]:.2g} times "
        "in the median. On the last rung there is no next. Bars: quartiles."
    )


def _pairs(data: dict[str, Any]) -> list[tuple[dict[str, Any], dict[str, Any], Any]]:
    """Each cell with its own row and the next rung's (None on the last)."""
    rows = {(r["scene"], r["method"]): r for r in data["rows"] if r["seconds"]}
    found = []
    for cell in data["cells"]:
        scene = f"{cell['where']}: {cell['cell']}"
        own, *heavier = (rows.get((scene, rung)) for rung in cell["rungs"])
        if own is not None:
            found.append((cell, own, heavier[0] if heavier else None))
    return found


def draw(data: dict[str, Any]) -> Any:
    """A line for each cell, in groups, in two columns."""
    pairs = _pairs(data)
    middle = _break(pairs)
    columns = (pairs[:middle], pairs[middle:])
    longest = max(len(c) + len({p[0]["where"] for p in c}) for c in columns)
    figure, grid = style.canvas(7.6, 0.9 + 0.125 * longest, 1, 2, sharex=True)
    seconds = [r["seconds"] for _, own, other in pairs for r in (own, other) if r is not None]
    for sheet, column in zip(grid[0], columns, strict=True):
        _column(sheet, column, longest)
        sheet.set_xscale("log")
        sheet.set_xlim(min(seconds) / 2, max(seconds) * 2)
        time_axis(sheet.xaxis, min(seconds), max(seconds))
        sheet.grid(axis="x", color="0.92", linewidth=0.6)
        sheet.set_axisbelow(True)
        sheet.set_xlabel("processor time of one answer")
    _legend(figure)
    return figure


def _break(pairs: list[Any]) -> int:
    """Where the second column begins: at the start of the group nearest the middle."""
    starts = [i for i in range(1, len(pairs)) if pairs[i][0]["where"] != pairs[i - 1][0]["where"]]
    return min(starts, key=lambda i: abs(i - len(pairs) / 2))


def _column(sheet: Any, pairs: list[Any], longest: int) -> None:
    place, ticks, labels, where = 0, [], [], None
    for cell, own, other in pairs:
        if cell["where"] != where:
            where = cell["where"]
            sheet.text(
                -0.03,
                place,
                where,
                transform=sheet.get_yaxis_transform(),
                ha="right",
                va="center",
                fontsize=6,
                fontweight="bold",
            )
            place += 1
        for row, filled in ((other, False), (own, True)):
            if row is not None:
                _dot(sheet, row, place, filled)
        if other is not None:
            ends = own["seconds"], other["seconds"]
            sheet.plot(ends, (place, place), color="0.75", linewidth=0.8, zorder=1)
        ticks.append(place)
        labels.append(f"{cell['cell']} [{cell['digits']}]")
        place += 1
    sheet.set_yticks(ticks, labels, fontsize=6)
    sheet.tick_params(axis="y", length=0)
    sheet.set_ylim(longest, -1)


def _dot(sheet: Any, row: dict[str, Any], place: int, filled: bool) -> None:
    marker, colour = RUNGS[row["method"]]
    low, high = row["quartiles"]
    sheet.plot((low, high), (place, place), color=colour, linewidth=2.2, alpha=0.5, zorder=2)
    sheet.plot(
        row["seconds"],
        place,
        marker=marker,
        markersize=6 if marker == "*" else 3.8,
        color=colour,
        markerfacecolor=colour if filled else "white",
        markeredgewidth=0.8,
        zorder=3,
    )


def _legend(figure: Any) -> None:
    from matplotlib.lines import Line2D

    handles = [
        Line2D([], [], linestyle="", marker=m, color=c, markersize=5, label=name)
        for name, (m, c) in RUNGS.items()
    ]
    figure.legend(handles=handles, loc="outside upper center", ncols=5, fontsize=7)
