"""Draw times for identities: SymPy against tresym."""

from __future__ import annotations

from typing import Any

from tresym.report.charts.common import BLUE, ORANGE, RED, tick_text
from tresym.report.figures import style

METHODS = {
    "sympy simplify": (RED, "v"),
    "sympy equals": (BLUE, "s"),
    "sympy trigsimp": (ORANGE, "^"),
}
OURS = "tresym, exact normal form"


def caption(data: dict[str, Any]) -> str:
    """Describe what the chart shows, with the counts."""
    notes = data["notes"]["summary"]
    words = []
    for method in METHODS:
        true, false = (notes[f"{method}, {kind} ones"] for kind in ("true", "false"))
        words.append(
            f"{method.removeprefix('sympy ')} decides {true.get('right', 0)} of "
            f"{true['identities']} true ones and takes {true['ratio']:g} (false ones: "
            f"{false['ratio']:g}) times as long in the geometric mean"
        )
    ours = [notes[f"{OURS}, {kind} ones"] for kind in ("true", "false")]
    total = sum(n["identities"] for n in ours)
    right, wrong = (sum(n.get(word, 0) for n in ours) for word in ("right", "wrong"))
    return (
        "Each mark is one identity of the ledger or a false variant of it: time of a SymPy method "
        f"against the time of tresym, which decides {right} of {total}, {wrong} wrongly (SymPy "
        "gets every second one). Open: decided; cross: undecided, wrong, or stopped at the limit. "
        f"Lines: 1, 100 and 10 000 times slower. {'; '.join(words)}."
    )


def conclusion(data: dict[str, Any]) -> str:
    """Say in a sentence what a reader learns, with the numbers of the measurement."""
    notes = data["notes"]["summary"]

    def counted(method: str) -> tuple[int, int]:
        found = [notes[f"{method}, {kind} ones"] for kind in ("true", "false")]
        return sum(n.get("right", 0) for n in found), sum(n["identities"] for n in found)

    right, total = counted(OURS)
    best, (most, of) = max(((m, counted(m)) for m in METHODS), key=lambda each: each[1][0])
    return (
        f"tresym decides {right} of {total} identities and false variants of them rightly; of "
        f"every second one, SymPy's best method here, {best.removeprefix('sympy ')}, decides "
        f"{most} of {of}."
    )


def draw(data: dict[str, Any]) -> Any:
    """Draw true identities on the left, false ones on the right."""
    figure, grid = style.canvas(7.4, 4.1, 1, 2, sharex=True, sharey=True)
    ours = {r["scene"]: r["seconds"] for r in data["rows"] if r["method"] == OURS and r["seconds"]}
    for sheet, false in zip(grid[0], (False, True), strict=True):
        for factor, line in ((1, "-"), (100, "--"), (10_000, ":")):
            x = (1e-6, 10)
            sheet.plot(
                x, [factor * v for v in x], color="0.6", linewidth=0.8, linestyle=line, zorder=1
            )
        for method, (colour, marker) in METHODS.items():
            rows = [
                r
                for r in data["rows"]
                if r["method"] == method
                and r["scene"] in ours
                and r["scene"].endswith("made false") == false
            ]
            _dots(sheet, rows, ours, colour, marker, method)
        sheet.set_title("false variants" if false else "true identities", loc="left")
        sheet.set_xscale("log")
        sheet.set_yscale("log")
        sheet.set_xlabel("time by tresym")
    grid[0, 0].set_ylabel("time by SymPy")
    times = list(ours.values())
    others = [r["seconds"] for r in data["rows"] if r["method"] in METHODS and r["seconds"]]
    for axis, values, limits in (
        (sheet.xaxis, times, sheet.set_xlim),
        (sheet.yaxis, others, sheet.set_ylim),
    ):
        limits(min(values) / 2, max(values) * 3)
        exponents = [n for n in range(-6, 2) if min(values) / 2 < 10.0**n < max(values) * 3]
        axis.set_ticks([10.0**n for n in exponents], [tick_text(n) for n in exponents])
        axis.set_ticks([], minor=True)
    handles, labels = grid[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside upper center", ncols=3)
    return figure


def _dots(
    sheet: Any,
    rows: list[dict[str, Any]],
    ours: dict[str, float],
    colour: str,
    marker: str,
    label: str,
) -> None:
    for right in (True, False):
        timed = [r for r in rows if r["seconds"] or r["outcome"] == "timed out"]
        some = [r for r in timed if (r["outcome"] == "right") == right]
        sheet.plot(
            [ours[r["scene"]] for r in some],
            [r["seconds"] or _limit(r) for r in some],
            linestyle="",
            color=colour,
            marker=marker if right else "x",
            markersize=4,
            markerfacecolor="white",
            markeredgewidth=0.8,
            label=label if right else None,
            zorder=3 if right else 2,
        )


def _limit(row: dict[str, Any]) -> float:
    """The seconds in "more than 2 s of processor time"."""
    return next(float(word) for word in row["why"].split() if word.replace(".", "").isdigit())
