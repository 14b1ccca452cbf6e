"""Draw the stability atlas: digits lost by printed and stable forms, side by side."""

from __future__ import annotations

from typing import Any

import numpy as np

from tresym.report.figures import style

PARTS = {
    "separatrix": ("separatrix",),
    "levels": ("levels",),
    "turning": ("turning point", "stable rotation"),
}
COLUMNS = (
    (16, "printed", "float64, as printed"),
    (16, "stable", "float64, stable form"),
    (50, "printed", "50 digits, as printed"),
    (50, "stable", "50 digits, stable form"),
)
MOST = 16.0
LINES = (2, 8)


def caption(data: dict[str, Any], part: str) -> str:
    """Describe what the chart shows."""
    where = {
        "separatrix": "over the shapes, at the root ε₀ of each",
        "levels": "over the start ψ and the level γ of the standard racket",
        "turning": "over the distance from a turning point (standard racket), and near the stable "
        "rotation γ = a",
    }[part]
    more = {
        "separatrix": " For large ab the printed form fails at any fixed precision.",
        "levels": " At the lower right γ is a small difference of the given numbers themselves.",
        "turning": "",
    }[part]
    return (
        f"Decimal digits lost {where}: white none, black 16 or more; the lines are at 2 (thin) and "
        "8 (thick) digits. The true value is computed as a ball from the same rounded numbers, so "
        f"that only the loss in the formula is shown.{more}"
    )


def conclusion(data: dict[str, Any], part: str) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""

    def share(form: str) -> str:
        grids = (g for g in data["grids"] if g["plane"] in PARTS[part])
        maps = [g["lost"] for g in grids if (g["digits"], g["form"]) == (16, form)]
        lost = np.concatenate([np.array(rows, dtype=float).ravel() for rows in maps])
        known = lost[~np.isnan(lost)]
        return f"{100 * (known > LINES[0]).mean():.0f} %"

    return (
        f"In float64 the formulas as printed lose more than {LINES[0]} of 16 digits at "
        f"{share('printed')} of the points of these maps, and the stable forms of the same "
        f"formulas at {share('stable')}."
    )


def draw(data: dict[str, Any], part: str) -> Any:
    """Draw a row for each formula, in four columns."""
    planes = {p["plane"]: p for p in data["planes"]}
    names = [g["pair"] for g in data["grids"] if g["plane"] in PARTS[part]]
    pairs = list(dict.fromkeys(names))
    figure, grid = style.canvas(7.6, 0.9 + 1.5 * len(pairs), len(pairs), 4, sharey="row")
    for row, pair in zip(grid, pairs, strict=True):
        row[0].set_title(pair, loc="left", fontsize=8, fontweight="bold")
        row[0].set_ylabel(planes[_plane_of(data, pair)]["y"][0], fontsize=7.5)
        for sheet, (digits, form, title) in zip(row, COLUMNS, strict=True):
            found = next(
                g
                for g in data["grids"]
                if (g["pair"], g["digits"], g["form"]) == (pair, digits, form)
            )
            image = lost_map(sheet, found, planes[found["plane"]])
            if pair == pairs[0]:
                above = {"xytext": (0, 17), "textcoords": "offset points", "ha": "center"}
                sheet.annotate(title, (0.5, 1), xycoords="axes fraction", fontsize=8.5, **above)
            sheet.set_xlabel(planes[found["plane"]]["x"][0], fontsize=7.5, labelpad=1)
    bar = figure.colorbar(image, ax=grid, location="right", shrink=0.5, aspect=30, pad=0.01)
    bar.set_label("digits lost")
    bar.set_ticks([0, 2, 4, 8, 12, 16], labels=["0", "2", "4", "8", "12", "16+"])
    return figure


def _plane_of(data: dict[str, Any], pair: str) -> str:
    return str(next(g["plane"] for g in data["grids"] if g["pair"] == pair))


def lost_map(sheet: Any, found: dict[str, Any], plane: dict[str, Any]) -> Any:
    """Draw a map of the digits lost, with lines at 2 and 8 digits.

    Args:
        sheet: the axes.
        found: a mapping with the rows ``lost``.
        plane: for ``x`` and ``y`` the name and the range of the logarithm of the parameter.
    """
    lost = np.ma.masked_invalid(np.array(found["lost"], dtype=float))
    (_, left, right), (_, bottom, top) = plane["x"], plane["y"]
    x, y = np.linspace(left, right, lost.shape[1]), np.linspace(bottom, top, lost.shape[0])
    half_x, half_y = (x[1] - x[0]) / 2, (y[1] - y[0]) / 2
    image = sheet.imshow(
        lost,
        extent=(left - half_x, right + half_x, bottom - half_y, top + half_y),
        origin="lower",
        aspect="auto",
        interpolation="none",
        cmap="Greys",
        vmin=0,
        vmax=MOST,
    )
    if lost.max() > LINES[0] > lost.min():
        sheet.contour(x, y, lost, LINES, colors="#d55e00", linewidths=(0.7, 1.6))
    if lost.max() < LINES[0]:
        words = f"at most {lost.max():.1f}"
        sheet.text(0.5, 0.5, words, transform=sheet.transAxes, ha="center", fontsize=7, color="0.4")
    _powers(sheet.xaxis, left, right)
    _powers(sheet.yaxis, bottom, top)
    sheet.tick_params(labelsize=6.5)
    return image


def _powers(axis: Any, low: float, high: float) -> None:
    """About four ticks at powers of ten."""
    step = max(1, round((high - low) / 4))
    ticks = [n for n in range(round(low), round(high) + 1) if (n - round(high)) % step == 0]
    axis.set_ticks(ticks, [f"$10^{{{n}}}$" for n in ticks])
