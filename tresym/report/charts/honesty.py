"""Draw claimed errors against true errors."""

from __future__ import annotations

from typing import Any

from tresym.report.charts.common import BLACK, BLUE, GREEN, ORANGE, PURPLE, RED, SKY, YELLOW
from tresym.report.figures import style

PANELS = (
    (62, "tresym", {"tresym, balls": (BLUE, "o"), "tresym, float64 map": (SKY, "^")}),
    (
        62,
        "quadrature",
        {
            "mpmath quad, tanh-sinh": (ORANGE, "^"),
            "mpmath quad, gauss-legendre": (RED, "v"),
            "scipy quad": (BLACK, "x"),
        },
    ),
    (
        62,
        "root finders",
        {
            "mpmath findroot, printed equation": (RED, "v"),
            "mpmath findroot over quad": (ORANGE, "^"),
            "scipy brentq, printed equation": (GREEN, "x"),
        },
    ),
    (
        17,
        "ODE solvers",
        {"scipy RK45": (YELLOW, "p"), "scipy DOP853": (PURPLE, "d"), "heyoka": (BLACK, "x")},
    ),
)


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows, with the counts."""
    points = data["points"]
    ours = [p for p in points if p["method"] == "tresym, balls"]
    others = [p for p in points if not p["method"].startswith("tresym")]
    over = sum(p["claims"] > p["digits"] + 1 for p in others)
    most = max(others, key=lambda p: p["claims"] - p["digits"])
    return (
        "Digits that a method claims for its result against the correct digits of the result, "
        "counted with a ball (more than 60 are shown as 60). On the line the claim is exact; in "
        "the hatched half the method claims too much. The claim is the radius of a ball, the error "
        "estimate of the float64 map or of quad, or the tolerance of a root finder or ODE solver "
        f"that returned without a warning. {over} of {len(others)} results of other methods claim "
        f"over a digit too much (the worst: {most['method']}, {most['claims']:g} claimed, "
        f"{most['digits']:g} correct). "
        f"{sum(p['claims'] > p['digits'] for p in ours)} of {len(ours)} balls claim too much."
    )


def conclusion(data: dict[str, Any]) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""
    ours = [p for p in data["points"] if p["method"] == "tresym, balls"]
    others = [p for p in data["points"] if not p["method"].startswith("tresym")]
    over = sum(p["claims"] > p["digits"] + 1 for p in others)
    wrong = sum(p["claims"] > p["digits"] for p in ours)
    return (
        f"{wrong} of {len(ours)} balls of tresym claim a digit that is not right; {over} of "
        f"{len(others)} results of other methods claim at least one digit too many without a "
        "warning."
    )


def draw(data: dict[str, Any]) -> Any:
    """Draw four panels; the last has its own scale."""
    figure, grid = style.canvas(7.2, 7.4, 2, 2)
    figure.get_layout_engine().set(h_pad=0.1, hspace=0.04)
    for sheet, (top, title, methods) in zip(grid.flat, PANELS, strict=True):
        ends = [-top / 60, top]
        sheet.fill_between(
            ends,
            [ends[0], ends[0]],
            ends,
            facecolor="0.96",
            edgecolor="0.86",
            hatch="///",
            linewidth=0,
        )
        sheet.plot(ends, ends, color="0.3", linewidth=0.9)
        for method, (colour, marker) in methods.items():
            some = [p for p in data["points"] if p["method"] == method]
            face = {} if marker == "x" else {"markerfacecolor": "white"}
            sheet.plot(
                [p["claims"] for p in some],
                [p["digits"] for p in some],
                linestyle="",
                color=colour,
                marker=marker,
                markersize=4.2,
                markeredgewidth=0.9,
                label=f"{method} ({len(some)})",
                **face,
            )
        sheet.set_title(title, loc="left")
        sheet.legend(loc="upper left", handletextpad=0.2, fontsize=7)
        sheet.set_xlim(*ends)
        sheet.set_ylim(*ends)
        sheet.set_aspect("equal")
    grid[0, 0].text(44, 12, "claims more\nthan it has", ha="center", fontsize=8, color="0.35")
    for row in grid:
        row[0].set_ylabel("true digits")
    for sheet in grid[-1]:
        sheet.set_xlabel("digits claimed")
    return figure
