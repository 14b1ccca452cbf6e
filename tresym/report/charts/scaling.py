"""Draw how time grows with digits, starts and claims."""

from __future__ import annotations

from math import ceil
from typing import Any

from tresym.report.charts.common import (
    BLACK,
    BLUE,
    DASHDOT,
    DASHED,
    DOTTED,
    GREEN,
    ORANGE,
    RED,
    SOLID,
    Mark,
    tick_text,
    time_text,
    worded,
)
from tresym.report.figures import style

BY_DIGITS = {
    "tresym, γ = 0": Mark(BLUE, "o", SOLID, True),
    "tresym, γ = 1e-8": Mark(GREEN, "s", SOLID, True),
    "tresym, γ = -0.01 (turned)": Mark(BLACK, "D", SOLID, True),
    "mpmath findroot, printed equation, γ = 0": Mark(RED, "v", DASHED, False),
    "mpmath findroot over R_F, R_J, γ = 1e-8": Mark(GREEN, "s", DASHDOT, False),
    "mpmath findroot over quad, γ = 1e-8": Mark(ORANGE, "^", DOTTED, False),
}


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows."""
    memory = data["memory"]
    starts = [r for r in data["rows"] if r["scene"] == "time against starts" and r["seconds"]]
    per = starts[-1]["seconds"]
    return (
        "Left: processor time of one ε(γ) of the standard racket with 50 to 10 000 digits; a "
        "method that needs more than 2.5 s is not tried with more digits. Middle: the flip of 1 to "
        f"10⁷ starts in float64 ({per * 1e6:.2g} µs per start for many) and the largest amount of "
        f"memory in use, {max(m['megabytes'] for m in memory):.3g} MB, as starts are passed "
        f"{data['notes']['piece']:,} at a time and computed {data['notes']['chunk']:,} at a time. "
        "Right: deciding the first claims of the proofs, with all that they depend on, in a "
        "running process. Thin lines: proportional growth."
    )


def conclusion(data: dict[str, Any]) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""
    rows = [r for r in data["rows"] if r["seconds"]]
    one = [r for r in rows if r["method"] == "tresym, γ = 0"]
    first, last = (end(one, key=lambda r: r["asked"]) for end in (min, max))
    claims = max((r for r in rows if r["scene"] == "time against claims"), key=lambda r: r["asked"])
    return (
        f"{last['asked'] / first['asked']:.0f} times as many digits take "
        f"{last['seconds'] / first['seconds']:.0f} times as long; the memory of the flip map stays "
        f"below {ceil(max(m['megabytes'] for m in data['memory']))} MB for 10⁷ starts; all "
        f"{claims['asked']} claims are judged in {time_text(claims['seconds'])}."
    )


def draw(data: dict[str, Any]) -> Any:
    """Draw three panels; the middle one has memory below."""
    figure, grid = style.canvas(7.6, 4.4, 1, 3, width_ratios=(1.35, 1, 1))
    left, middle, right = grid[0]
    rows = [r for r in data["rows"] if r["seconds"]]
    _digits(left, rows)
    _starts(middle, rows, data["memory"])
    claims = [r for r in rows if r["scene"] == "time against claims"]
    right.plot(
        [r["asked"] for r in claims],
        [r["seconds"] for r in claims],
        label="tresym verify",
        markersize=4,
        linewidth=1,
        **Mark(BLUE, "o", SOLID, True).options,
    )
    _proportional(right, [(r["asked"], r["seconds"]) for r in claims])
    right.set_xlabel("claims")
    right.set_title("claims judged", loc="left")
    for sheet in grid[0]:
        sheet.set_xscale("log")
        sheet.set_yscale("log")
        sheet.grid(color="0.92", linewidth=0.6)
        _seconds(sheet)
    left.set_xticks([50, 200, 1000, 5000], ["50", "200", "1000", "5000"])
    left.set_xticks([], minor=True)
    right.set_xticks([1, 10, 100, 500], ["1", "10", "100", "500"])
    right.set_xticks([], minor=True)
    left.set_ylabel("processor time")
    return figure


def _digits(sheet: Any, rows: list[dict[str, Any]]) -> None:
    for method, mark in BY_DIGITS.items():
        some = [r for r in rows if r["method"] == method]
        sheet.plot(
            [r["asked"] for r in some],
            [r["seconds"] for r in some],
            label=worded(method),
            linewidth=1,
            markersize=4,
            **mark.options,
        )
    sheet.set_xlabel("digits")
    sheet.set_xlim(35, 14_000)
    sheet.set_title("one answer", loc="left")
    sheet.legend(loc="upper center", bbox_to_anchor=(0.5, -0.14), fontsize=6.5)


def _starts(sheet: Any, rows: list[dict[str, Any]], memory: list[dict[str, Any]]) -> None:
    some = [r for r in rows if r["scene"] == "time against starts"]
    times = [(r["asked"], r["seconds"] * r["asked"]) for r in some]
    options = {"linewidth": 1, "markersize": 4}
    sheet.plot(
        *zip(*times, strict=True), label="time", **options, **Mark(BLUE, "o", SOLID, True).options
    )
    _proportional(sheet, times)
    other = sheet.twinx()
    other.plot(
        [m["starts"] for m in memory],
        [m["megabytes"] for m in memory],
        label="memory",
        **options,
        **Mark(RED, "s", DASHED, False).options,
    )
    other.set_yscale("log")
    other.set_ylim(0.01, 1e4)
    other.set_ylabel("memory held at once (MB)")
    sheet.set_xlabel("starts")
    sheet.set_title("the flip map", loc="left")
    lines = [*sheet.get_lines()[:1], *other.get_lines()]
    labels = [line.get_label() for line in lines]
    sheet.legend(lines, labels, loc="upper center", bbox_to_anchor=(0.5, -0.14), ncols=2)


def _proportional(sheet: Any, points: list[tuple[float, float]]) -> None:
    """A thin line of slope one through the last point."""
    x, y = points[-1]
    first = points[0][0]
    sheet.plot([first, x], [y * first / x, y], color="0.6", linewidth=0.7, zorder=1)


def _seconds(sheet: Any) -> None:
    import math

    low, high = sheet.get_ylim()
    exponents = range(math.ceil(math.log10(low)), math.floor(math.log10(high)) + 1)
    shown = [n for n in exponents if len(exponents) < 7 or n % 2 == 0]
    sheet.set_yticks([10.0**n for n in shown], [tick_text(n) for n in shown])
    sheet.set_yticks([], minor=True)
