"""The style of all figures, and how they are saved; the only module that imports matplotlib.

Rotating motions are solid and dark, oscillating ones dashed and lighter, the separatrix dotted, so
that they can be distinguished without colour. The two colours are from the palette of Okabe and
Ito.
"""

from __future__ import annotations

import io
import math
import os
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from tresym.reals.numbers.exact import InputError
from tresym.report.figures.grid import on_grid

ROTATING = {"color": "#0072b2", "linewidth": 1.1, "linestyle": "-"}
OSCILLATING = {"color": "#d55e00", "linewidth": 1.1, "linestyle": (0, (5, 1.6))}
SEPARATRIX = {"color": "black", "linewidth": 1.5, "linestyle": (0, (1, 1.4))}
QUIET = {"color": "0.75", "linewidth": 0.7, "linestyle": "-"}
INK = "0.15"

_LOOKS = {
    "svg.hashsalt": "tresym",
    "svg.fonttype": "path",
    "pdf.fonttype": 42,
    "path.simplify": True,
    "text.hinting": "none",  # letters as wide as they are drawn, so that none is cut off
    "font.family": "DejaVu Sans",
    "font.size": 9,
    "axes.titlesize": 9,
    "axes.labelsize": 9,
    "axes.linewidth": 0.7,
    "axes.edgecolor": INK,
    "xtick.labelsize": 8,
    "ytick.labelsize": 8,
    "legend.fontsize": 8,
    "legend.frameon": False,
    "hatch.linewidth": 0.5,
    "figure.dpi": 100,
    "savefig.facecolor": "white",
    "mathtext.fontset": "dejavusans",
}


@contextmanager
def looks() -> Iterator[None]:
    """Use the settings with which every figure is drawn and saved, whatever the user's own are.

    Raises:
        InputError: matplotlib is not installed.
    """
    # Figures are saved, never shown; a backend that a notebook has set may be missing here.
    if "matplotlib" not in sys.modules:
        os.environ["MPLBACKEND"] = "agg"
    try:
        import matplotlib
    except ModuleNotFoundError:
        raise InputError("figure: needs matplotlib (pip install -e '.[docs]')") from None
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_LOOKS)
        yield


def canvas(
    width: float, height: float, rows: int = 1, columns: int = 1, **options: Any
) -> tuple[Any, Any]:
    """Return a matplotlib figure of this size in inches, and its array of axes (rows, columns)."""
    from matplotlib.figure import Figure

    figure = Figure(figsize=(width, height), layout="constrained")
    return figure, figure.subplots(rows, columns, squeeze=False, **options)


def _settle(figure: Any) -> None:
    """Lay the picture out once and round the positions of its axes.

    The layout solver differs in its last bits from run to run.
    """
    figure.draw_without_rendering()
    figure.set_layout_engine("none")
    for axes in figure.axes:
        axes.set_position([round(x, 4) for x in axes.get_position(original=True).bounds])


def fit_words(figure: Any, least: float) -> None:
    """Set the text of a narrower picture as large as possible without clipping or overlap.

    Args:
        figure: the picture.
        least: how much narrower it is than as drawn; text is not made smaller than in proportion.
    """
    words = [(word, word.get_fontsize()) for word in _words(figure)]
    ruled = [each for each in figure.axes if each.axison]
    axes = [axis for each in ruled for axis in (each.xaxis, each.yaxis)]
    marks = [
        (axis, axis.get_ticklabels()[0].get_fontsize())
        for axis in axes
        if len(axis.get_ticklabels())
    ]

    def stand(share: float) -> bool:
        for word, size in words:
            word.set_fontsize(share * size)
        for axis, size in marks:
            axis.set_tick_params(labelsize=share * size)
        figure.draw_without_rendering()
        shown = [word for word, _ in words]
        shown += [mark for axis, _ in marks for mark in axis.get_ticklabels()]
        boxes = [x.get_window_extent() for x in shown if x.get_visible() and x.get_text()]
        return _apart(boxes, figure.bbox)

    share = min(least, 1.0)
    stand(share)
    while share < 1 and stand(min(1.05 * share, 1.0)):
        share = min(1.05 * share, 1.0)
    stand(share)


def _words(figure: Any) -> Iterator[Any]:
    """All text of a picture except the numbers at its ticks."""
    yield from figure.texts
    for axes in figure.axes:
        yield from (axes.title, axes.xaxis.label, axes.yaxis.label, *axes.texts)
        if (legend := axes.get_legend()) is not None:
            yield from legend.get_texts()


def _apart(boxes: list[Any], frame: Any) -> bool:
    within = all(
        box.x0 >= frame.x0 and box.x1 <= frame.x1 and box.y0 >= frame.y0 and box.y1 <= frame.y1
        for box in boxes
    )
    return within and not any(x.overlaps(y) for n, x in enumerate(boxes) for y in boxes[:n])


def svg_text(figure: Any, title: str) -> str:
    """Return the figure as SVG with a title, without dates or names of the machine."""
    _settle(figure)
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    text = "\n".join(line.rstrip() for line in out.getvalue().splitlines()) + "\n"
    return on_grid(text, title).replace(" <metadata>", f" <title>{title}</title>\n <metadata>", 1)


def bitmap_or_page(figure: Any, title: str, kind: str, dpi: int = 200) -> bytes:
    """Return the figure as the bytes of a PDF page, or of a PNG with ``dpi`` dots per inch."""
    _settle(figure)
    out = io.BytesIO()
    ours: dict[str, dict[str, Any]] = {
        "pdf": {"CreationDate": None, "Creator": "tresym", "Producer": None},
        "png": {"Software": "tresym"},
    }
    metadata = {"Title": title, **ours[kind]}
    figure.savefig(out, format=kind, dpi=dpi, metadata=metadata)
    return out.getvalue()


def halo() -> list[Any]:
    """Return path effects for a white edge around text, readable on any background."""
    from matplotlib.patheffects import withStroke

    return [withStroke(linewidth=2.2, foreground="white")]


def pi_ticks(axis: Any, parts: Sequence[Fraction | int]) -> None:
    """Set ticks at these multiples of π, with labels to match."""
    axis.set_ticks(
        [float(x) * math.pi for x in parts], [multiple_of_pi(Fraction(x)) for x in parts]
    )


def multiple_of_pi(x: Fraction) -> str:
    """Return a multiple of π as text, such as ``π/2``."""
    if x == 0:
        return "0"
    sign, top = "−" if x < 0 else "", abs(x.numerator)
    bottom = "" if x.denominator == 1 else f"/{x.denominator}"
    return f"{sign}{'' if top == 1 else top}π{bottom}"


def kind(gamma: float) -> dict[str, Any]:
    """Return the line style of an orbit of this γ."""
    return OSCILLATING if gamma < 0 else ROTATING if gamma > 0 else SEPARATRIX


def legend(axes: Any, kinds: Sequence[tuple[str, dict[str, Any]]], **options: Any) -> None:
    """Add a legend of line styles, whatever was drawn with them."""
    from matplotlib.lines import Line2D

    axes.legend([Line2D([], [], **line) for _, line in kinds], [x for x, _ in kinds], **options)


ORBITS = (
    ("rotating, γ > 0", ROTATING),
    ("oscillating, γ < 0", OSCILLATING),
    ("separatrix, γ = 0", SEPARATRIX),
)
"""The three kinds of orbit, for :func:`legend`."""
