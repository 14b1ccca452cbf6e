"""Draw charts of a user's own expressions: errors, time against true digits, digits lost.

The pictures are built from the parts of the charts of saved measurements.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple
from xml.sax.saxutils import escape

from tresym.accuracy.table import raised
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict
from tresym.report.charts.common import (
    BLACK,
    BLUE,
    DASHED,
    DOTTED,
    GREEN,
    ORANGE,
    PURPLE,
    RED,
    SKY,
    SOLID,
    Mark,
    below,
    time_axis,
)
from tresym.report.typesetting.plain_text import plain

if TYPE_CHECKING:
    from tresym.accuracy.largest_error import LargestError
    from tresym.accuracy.stability import Stability
    from tresym.accuracy.work_precision import Point
    from tresym.entries.reading import Entry

MARKERS = "osD^vP*X"
COLOURS = (BLUE, RED, GREEN, ORANGE, PURPLE, SKY, BLACK)
LINES = (SOLID, DASHED, DOTTED)
WIDEST = 70
"""Signs of a title that fit above a chart."""
ERRORS_DRAWN = 400


class Curve(NamedTuple):
    """The errors of one approximation: points (x, |error|), and the proved bound if there is one.

    ``bound`` is a list of points (x, bound) of a line, ``words`` what the legend says of it.
    """

    name: str
    points: Sequence[tuple[float, float]]
    bound: Sequence[tuple[float, float]] = ()
    words: str = ""


def saved(draw: Callable[[], Any], title: str, caption: str, kind: str) -> bytes:
    """Return a picture as the bytes of an SVG, PDF or PNG file, with its caption below.

    Args:
        draw: draws the figure.
        title: the title of the file.
        caption: the sentences below the picture; none if it is empty.
        kind: svg, pdf or png.
    """
    from tresym.report.figures import style

    with style.looks():
        figure = draw()
        if caption:
            below(figure, caption)
        if kind != "svg":
            return style.bitmap_or_page(figure, title, kind)
        return style.svg_text(figure, escape(title), escape(caption)).encode()


def errors(curves: Sequence[Curve], along: str, title: str, size: tuple[float, float]) -> Any:
    """Draw errors against the parameter on logarithmic scales.

    Args:
        curves: the approximations.
        along: the label of the horizontal axis.
        title: the title.
        size: width and height in inches.
    """
    from tresym.report.figures import style

    if not any(curve.points for curve in curves):
        raise InputError("chart: every error is 0 or the points are not positive")
    figure, ((axes,),) = style.canvas(*size)
    for n, curve in enumerate(curves):
        name, words = typeset(curve.name), typeset(curve.words)
        colour = COLOURS[n % len(COLOURS)]
        look = {"marker": MARKERS[n % len(MARKERS)], "linestyle": LINES[n % len(LINES)]}
        points = sorted(curve.points)
        if points:
            axes.plot(
                *zip(*points, strict=True), color=colour, label=name or None,
                markersize=4, linewidth=0.9, **look,
            )  # fmt: skip
        if curve.bound:
            axes.plot(
                *zip(*curve.bound, strict=True), color=colour, linewidth=2.4, alpha=0.28,
                label=words or None, zorder=1,
            )  # fmt: skip
    axes.set_xscale("log")
    axes.set_yscale("log")
    axes.set_xlabel(typeset(along))
    axes.set_ylabel("|error|")
    axes.grid(color="0.92", linewidth=0.6)
    axes.set_axisbelow(True)
    if any(curve.name or curve.words for curve in curves):
        axes.legend(fontsize=7)
    axes.set_title(typeset(title), fontsize=9)
    return figure


def ratio(
    points: Sequence[tuple[float, float]], along: str, title: str, bound: float | None
) -> str:
    """Return a curve on the way to the end of a path as SVG, with a line for a bound of it.

    Args:
        points: the distance from the end and the value.
        along: the label of the horizontal axis, which is logarithmic.
        title: what is drawn.
        bound: the proved bound of the absolute value, if there is one.
    """
    from tresym.report.figures import style

    def draw() -> Any:
        figure, ((axes,),) = style.canvas(5.2, 2.8)
        axes.plot(*zip(*sorted(points), strict=True), color=BLUE, linewidth=1.1)
        for sign in (1, -1):
            if bound is not None and any(sign * y > 0 for _, y in points):
                axes.axhline(sign * bound, color=RED, linewidth=0.9, linestyle=DASHED)
        axes.set_xscale("log")
        axes.set_xlabel(typeset(along))
        axes.set_title(typeset(title), fontsize=9)
        axes.grid(color="0.92", linewidth=0.6)
        axes.set_axisbelow(True)
        return figure

    return saved(draw, title, "", "svg").decode()


def typeset(text: str) -> str:
    """Return a text with the formulas in it as mathematics between dollars, for a picture.

    Example:
        >>> typeset("error of a**2/16 + 1")
        'error of $\\\\frac{a^{2}}{16} + 1$'
    """
    from matplotlib.mathtext import MathTextParser

    from tresym.reals.language.parsing import parse
    from tresym.reals.language.typesetting import expression_in_latex
    from tresym.report.typesetting.formulas_in_words import parts

    try:
        pieces = [(expression_in_latex(parse(text)), True)] if text.strip() else []
    except InputError:
        pieces = list(parts(text))
    shown = "".join(f"${part}$" if is_formula else part for part, is_formula in pieces)
    try:
        MathTextParser("path").parse(shown)
    except ValueError:  # a command that the letters of pictures do not have
        return text.replace("$", r"\$")
    return shown


def error_chart(
    exact: str,
    approximations: Sequence[str],
    path: str,
    at: Sequence[str] = (),
    given: str = "",
    order: str | None = None,
    region: str = "",
) -> Callable[[str], bytes]:
    """Return a function that draws the errors of approximations as svg, pdf or png.

    The arguments are those of :func:`tresym.accuracy.error_curves.error_curves`.

    Raises:
        InputError: as there.
    """
    from tresym.accuracy.error_curves import error_curves, sampled_points
    from tresym.accuracy.sampled import names_function
    from tresym.reals.language.paths import read_path

    functions = [text for text in approximations if names_function(text)]
    formulas = [text for text in approximations if text not in functions]
    found = error_curves(exact, formulas, path, at, given, order, region) if formulas else []
    curves = [
        Curve(f"{name} (sampled)", sampled_points(name, exact, path, at, given))
        for name in functions
    ]
    for one in found:
        table, words = one.table, ""
        if table.constant is not None:
            words = f"at most {table.constant.high} times {table.gauge}"
        curves.append(Curve(table.approx, one.points, one.bound, words))
    way = read_path(path)
    name = way.name
    along = name if way.point is None or str(way.point) == "0" else f"|{name} − {way.point}|"
    title = f"Errors of approximations of {found[0].table.exact if found else exact}"
    sentences = ["Every point is a certified error."]
    if functions:
        sentences.append(f"The errors of {', '.join(functions)} are sampled at these points alone.")
    for table in (one.table for one in found):
        if table.claim is not None:
            order = f"{table.claim.verdict.value}: the error of {raised(table.approx)} is "
            order += "not " if table.claim.verdict is Verdict.REFUTED else ""
            sentence = f"{order}O({raised(table.gauge)})"
            if table.constant is not None:
                ends = f"between {table.constant.low} and {table.constant.high}"
                region = table.constant.region.replace("<=", "≤").replace(">=", "≥")
                sentence += f"; smallest constant on {region}: {ends}"
            sentences.append(f"{sentence}.")
    caption = " ".join(sentences)
    shown = title if len(plain(typeset(title))) <= WIDEST else "Errors of the approximations"
    return lambda kind: saved(
        lambda: errors(curves, along, shown, (5.6, 3.8)), title, caption, kind
    )


FAR = ("1", "3/2", "2", "3", "5", "7", "10", "15", "20")
"""Where an entry with a limit at infinity is drawn: its error may decay like exp(-x²)."""


def entry_chart(entry: Entry) -> Callable[[str], bytes]:
    """Return a function that draws the error of an entry of the atlas against its bound.

    Raises:
        InputError: the claim is not an equation with one O in one variable, or it cannot be drawn.
    """
    from tresym.accuracy.error_curves import has_value
    from tresym.entries.reading import sides
    from tresym.reals.language.claims import parts_of
    from tresym.reals.language.paths import read_path

    found = sides(entry.claim)
    _, given, path, _ = parts_of(entry.claim)
    if found is None or not path:
        what = "is not an equation with one O along a path"
        raise InputError(f"atlas: {entry.name} has no chart, because its claim {what}")
    exact, approx, gauge = found[0], found[1] or "0", found[2]
    at: tuple[str, ...] = ()
    if read_path(path).point is None:
        at = tuple(x for x in FAR if has_value(exact, approx, path, x, given))
    return error_chart(exact, [approx], path, at, given, gauge, entry.region)


def error_on_region(
    exact: str, approx: str, on: str, found: LargestError
) -> Callable[[str], bytes]:
    """Return a function that draws the error of an approximation on a bounded region.

    Args:
        exact: the function.
        approx: the approximation, as for :func:`tresym.largest_error`.
        on: the region.
        found: the largest errors, of which the absolute one is drawn as lines.

    Raises:
        InputError: the region is not bounded, or the error has no values there.
    """
    from tresym.accuracy.largest_error import errors_at, interval

    points = errors_at(exact, approx, on, found.stored, ERRORS_DRAWN)
    if len(points) < 2:
        raise InputError("error: the error has no values that could be drawn on this region")
    name = interval(on)[0]
    caption = f"The largest absolute error is {found.absolute}."
    if found.rounding is not None:
        caption += f" Rounding adds {found.rounding}."

    def draw() -> Any:
        from tresym.report.figures import style

        figure, ((axes,),) = style.canvas(5.2, 3.0)
        axes.plot(*zip(*points, strict=True), color=BLUE, linewidth=1.1)
        if found.absolute.high not in ("", "oo"):
            for sign in (1, -1):
                bound = sign * float(found.absolute.high)
                axes.axhline(bound, color=RED, linewidth=0.9, linestyle=DASHED)
        axes.set_xlabel(typeset(name))
        axes.set_ylabel("error")
        axes.set_title(typeset(f"{found.exact} - ({found.approximation})"), fontsize=9)
        axes.grid(color="0.92", linewidth=0.6)
        axes.set_axisbelow(True)
        return figure

    return lambda kind: saved(draw, "error of an approximation", caption, kind)


def work_precision(points: Sequence[Point], title: str) -> Any:
    """Draw true digits against time for one expression, with the Pareto front."""
    from tresym.report.charts.work_precision import show_front, show_method
    from tresym.report.figures import style

    names = list(dict.fromkeys(point.method for point in points))
    rows = [
        {
            "method": p.method,
            "asked": p.asked or 16,
            "digits": p.digits,
            "seconds": p.seconds,
            "outcome": "right" if p.asked is None or p.digits >= p.asked - 0.5 else "wrong",
        }
        for p in points
    ]
    figure, ((axes,),) = style.canvas(5.6, 3.8)
    axes.set_xscale("log")
    axes.set_yscale("log")
    if any(row["outcome"] == "right" for row in rows):
        show_front(axes, rows)
    for n, name in enumerate(names):
        ours = any(p.certified for p in points if p.method == name)
        mark = Mark(
            COLOURS[n % len(COLOURS)], MARKERS[n % len(MARKERS)], SOLID if ours else DASHED, ours
        )
        show_method(axes, [row for row in rows if row["method"] == name], mark)
        axes.plot([], [], label=name, linewidth=0.9, markersize=4, **mark.options)
    seconds = [float(row["seconds"]) for row in rows if row["seconds"]]
    low, high = min(seconds) / 2, max(seconds) * 3
    axes.set_xlim(low, high)
    time_axis(axes.xaxis, low, high)
    most = max(float(row["digits"]) for row in rows)
    axes.set_ylim(0.8, 1.6 * max(most, 16))
    ticks = [n for n in (1, 3, 10, 16, 30, 50, 100, 200, 300) if n <= 1.6 * max(most, 16)]
    axes.set_yticks(ticks, ticks)
    axes.set_yticks([], minor=True)
    axes.set_xlabel("time for one answer")
    axes.set_ylabel("true digits")
    axes.grid(color="0.92", linewidth=0.6)
    axes.set_axisbelow(True)
    axes.legend(fontsize=7, loc="lower right")
    axes.set_title(title, fontsize=9)
    return figure


def work_precision_caption(points: Sequence[Point]) -> str:
    """Describe what the chart shows."""
    wrong = sum(p.asked is not None and p.digits < p.asked - 0.5 for p in points)
    others = sum(p.asked is not None for p in points)
    return (
        "True digits of one value, counted against a ball of many more digits, against processor "
        "time, both logarithmic; up and to the left is better. Filled and solid: certified balls; "
        "open and dashed: uncertified. The grey line is the Pareto front. A cross is an answer "
        f"with fewer digits than were asked for ({wrong} of {others})."
    )


def stability(found: Stability) -> Any:
    """Draw the digits that double precision loses: a curve, or a map for two parameters."""
    from tresym.report.figures import style

    if len(found.axes) == 1:
        return _lines(found)
    from tresym.report.charts.atlas import lost_map

    figure, grid = style.canvas(3.7 * len(found.forms), 3.5, 1, len(found.forms))
    first, second = found.axes
    plane = {"x": _range(first), "y": _range(second)}
    image = None
    for sheet, form in zip(grid[0], found.forms, strict=True):
        image = lost_map(sheet, {"lost": form.lost}, plane)
        for axis, one in ((sheet.xaxis, first), (sheet.yaxis, second)):
            if not one.logarithmic:
                _linear(axis, one.values)
        sheet.set_title(_short(form.text), fontsize=8)
        sheet.set_xlabel(first.name)
    grid[0][0].set_ylabel(second.name)
    bar = figure.colorbar(image, ax=grid, location="right", shrink=0.8, aspect=25, pad=0.02)
    bar.set_label("digits lost")
    return figure


def _linear(axis: Any, values: Sequence[float]) -> None:
    from matplotlib.ticker import MaxNLocator

    ticks = MaxNLocator(5).tick_values(values[0], values[-1])
    inside = [t for t in ticks if values[0] <= t <= values[-1]]
    axis.set_ticks(inside, [f"{t:g}" for t in inside])


def _range(axis: Any) -> tuple[str, float, float]:
    ends = axis.values[0], axis.values[-1]
    low, high = (math.log10(x) for x in ends) if axis.logarithmic else ends
    return axis.name, low, high


def _lines(found: Stability) -> Any:
    from tresym.report.figures import style

    (axis,) = found.axes
    figure, ((sheet,),) = style.canvas(5.4, 3.4)
    for n, form in enumerate(found.forms):
        look: dict[str, Any] = {"color": (RED, BLUE)[n % 2], "linestyle": LINES[n % 2]}
        sheet.plot(axis.values, form.lost[0], label=_short(form.text), linewidth=1.1, **look)
    if axis.logarithmic:
        sheet.set_xscale("log")
    sheet.set_ylim(-0.3, 16.3)
    sheet.set_xlabel(axis.name)
    sheet.set_ylabel("digits lost")
    sheet.grid(color="0.92", linewidth=0.6)
    sheet.legend(fontsize=8)
    return figure


def _short(text: str) -> str:
    return text if len(text) <= 46 else text[:43] + "…"


def stability_caption(found: Stability) -> str:
    """Describe what the chart shows."""
    first, *rest = found.forms
    text = (
        f"Decimal digits of double precision that {first.text} loses on {found.given}, against "
        f"balls at the same rounded numbers: at most {_up(first.worst)} at the points of the "
        f"picture, {first.mean:.1f} on average."
    )
    for form in rest:
        text += (
            f" The form {form.text}, {form.verdict} to be the same function, loses at most "
            f"{_up(form.worst)}."
        )
    return text if rest else text + " No other form that loses fewer was found."


def _up(x: float) -> str:
    return f"{math.ceil(10 * x) / 10:.1f}"


def marks_of(curves: Mapping[str, Sequence[tuple[float, float]]]) -> list[Curve]:
    """Return curves without bounds, by name."""
    return [Curve(name, points) for name, points in sorted(curves.items())]
