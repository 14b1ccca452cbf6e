"""The style of all figures, and how they are saved; the only module that imports matplotlib.

Rotating motions are solid and dark, oscillating ones dashed and lighter, the separatrix dotted, so
that they can be distinguished without colour. The two colours are from the palette of Okabe and
Ito.
"""

from __future__ import annotations

import io
import logging
import math
import os
import re
import sys
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from fractions import Fraction
from typing import Any

from tresym.reals.numbers.exact import InputError
from tresym.report.figures.grid import compact, on_grid

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
    "image.cmap": "PuOr_r",
}
_PRINTED = {
    "font.family": "cmr10",
    "mathtext.fontset": "cm",
    "axes.formatter.use_mathtext": True,
    "image.cmap": "summer",  # light enough for black lines
}
"""What differs in a figure for an article: Computer Modern, and colours that differ in grey."""


@contextmanager
def looks(printed: bool = False) -> Iterator[None]:
    """Use the settings with which every figure is drawn and saved, whatever the user's own are.

    Args:
        printed: whether the figure is for an article, with the fonts of LaTeX; then call
            :func:`set_formulas` before it is saved.

    Raises:
        InputError: matplotlib is not installed.
    """
    # Figures are saved, never shown; a backend that a notebook has set may be missing here.
    if "matplotlib" not in sys.modules:
        os.environ["MPLBACKEND"] = "agg"
    try:
        import matplotlib
    except ModuleNotFoundError:
        raise InputError("figure: needs matplotlib (pip install 'tresym[docs]')") from None
    logging.getLogger("fontTools").setLevel(logging.ERROR)  # it warns of the dates of cmr10
    with matplotlib.rc_context():
        matplotlib.rcdefaults()
        matplotlib.rcParams.update(_LOOKS | (_PRINTED if printed else {}))
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


def fit_words(figure: Any, least: float) -> float:
    """Set the text of a narrower picture as large as possible without clipping or overlap.

    Args:
        figure: the picture.
        least: how much narrower it is than as drawn; text is not made smaller than in proportion.

    Returns:
        The size of the text relative to the size as drawn.
    """
    sizes = scale_words(figure, 1.0)
    share = min(least, 1.0)
    while share < 1 and stands(figure, sizes, min(1.05 * share, 1.0)):
        share = min(1.05 * share, 1.0)
    stands(figure, sizes, share)
    return share


Sizes = tuple[list[tuple[Any, float]], list[tuple[Any, float]]]
"""The texts of a picture and the axes with numbers, each with the size of its letters."""


def scale_words(figure: Any, share: float) -> Sizes:
    """Multiply the size of all text by a factor, and return the sizes before."""
    axes = [axis for each in figure.axes if each.axison for axis in (each.xaxis, each.yaxis)]
    marks = [(axis, axis.get_ticklabels()) for axis in axes]
    sizes = (
        [(word, word.get_fontsize()) for word in _words(figure)],
        [(axis, labels[0].get_fontsize()) for axis, labels in marks if len(labels)],
    )
    _set_sizes(sizes, share)
    return sizes


def _set_sizes(sizes: Sizes, share: float) -> None:
    for word, size in sizes[0]:
        word.set_fontsize(share * size)
    for axis, size in sizes[1]:
        axis.set_tick_params(labelsize=share * size)


def stands(figure: Any, sizes: Sizes, share: float) -> bool:
    """Set text at a share of these sizes; return whether no part is clipped or overlaps another."""
    _set_sizes(sizes, share)
    figure.draw_without_rendering()
    shown = [word for word, _ in sizes[0]]
    shown += [mark for axis, _ in sizes[1] for mark in _in_view(axis)]
    boxes = [x.get_window_extent() for x in shown if x.get_visible() and x.get_text()]
    return _apart(boxes, figure.bbox)


def _in_view(axis: Any) -> Iterator[Any]:
    """The numbers at the ticks of an axis, without those beyond its ends, which are not drawn."""
    low, high = sorted(axis.get_view_interval())
    yield from (tick.label1 for tick in axis.get_major_ticks() if low <= tick.get_loc() <= high)


def _words(figure: Any) -> Iterator[Any]:
    """All text of a picture except the numbers at its ticks."""
    yield from figure.texts
    for axes in figure.axes:
        yield from (axes.title, axes.xaxis.label, axes.yaxis.label, *axes.texts)
        if (legend := axes.get_legend()) is not None:
            yield from legend.get_texts()


_SIGNS = {
    "γ": r"\gamma ", "Δ": r"\Delta ", "ε": r"\epsilon ", "θ": r"\theta ", "π": r"\pi ",
    "φ": r"\phi ", "ψ": r"\psi ", "₀": "_0", "−": "-", "|": r"\vert ",
}  # fmt: skip
"""Characters that occur in formulas alone, as matplotlib writes them."""
_FORMULA = re.compile(
    rf"(?:[^\s,:;]*[{''.join(_SIGNS)}][^\s,:;]*|\b[a-z](?= =))(?: [<>=+−] [^\s,:;]+)*"
)


def set_formulas(figure: Any) -> None:
    """Set the formulas in the text of a figure in italics, as LaTeX does."""
    from matplotlib.text import Text

    for axes in figure.axes:
        for axis in (axes.xaxis, axes.yaxis):
            places = axis.get_ticklocs()
            marks = axis.get_major_formatter().format_ticks(places)
            if any(with_formulas(mark) != mark for mark in marks):
                axis.set_ticks(places, [with_formulas(mark) for mark in marks])
    for word in figure.findobj(Text):
        word.set_text(with_formulas(word.get_text()))


def label(text: str) -> str:
    """Return a text as the present look needs it; for text that is measured while it is drawn."""
    from matplotlib import rcParams

    return with_formulas(text) if rcParams["font.family"] == [_PRINTED["font.family"]] else text


def with_formulas(text: str) -> str:
    """Return a text with its formulas between dollars, as matplotlib reads them."""
    if "$" in text:
        return text.replace(r"\varepsilon", r"\epsilon")
    return _FORMULA.sub(lambda m: f"${''.join(_SIGNS.get(c, c) for c in m[0])}$", text)


def _apart(boxes: list[Any], frame: Any) -> bool:
    within = all(
        box.x0 >= frame.x0 and box.x1 <= frame.x1 and box.y0 >= frame.y0 and box.y1 <= frame.y1
        for box in boxes
    )
    return within and not any(x.overlaps(y) for n, x in enumerate(boxes) for y in boxes[:n])


def svg_text(figure: Any, title: str, caption: str = "") -> str:
    """Return the figure as SVG with title and caption, without dates or names of the machine."""
    _settle(figure)
    out = io.StringIO()
    figure.savefig(out, format="svg", metadata={"Date": None, "Creator": None})
    text = "\n".join(line.rstrip() for line in out.getvalue().splitlines()) + "\n"
    described = f"<desc>{caption}</desc>\n" if caption else ""
    return compact(on_grid(text, title), f"<title>{title}</title>\n{described}")


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
