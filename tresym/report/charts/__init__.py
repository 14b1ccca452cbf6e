"""Charts of saved measurements as SVG: each is a pure function of one JSON file.

The module of a chart has ``draw(data)``, the picture, and ``caption(data)``, a description of what
it shows. The bytes are the same on every build with the same matplotlib. All charts can be read in
black and white: methods differ by marker and line style as well as by colour.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any, NamedTuple

from tresym.reals.numbers.exact import InputError, quoted, shortened


class Chart(NamedTuple):
    """A chart: its title, the workload that is shown, and the module that draws it.

    ``part`` is passed to modules that draw several charts.
    """

    title: str
    workload: str
    module: str
    part: str | None = None


CHARTS = {
    "deciders": Chart(
        "Claims decided within a time, and wrong answers: SymPy, Maxima, z3, testing, tresym",
        "deciders",
        "deciders",
    ),
    "work-precision": Chart(
        "Correct digits against time, six scenes", "precision", "work_precision"
    ),
    "honesty": Chart("Digits claimed and correct digits", "honesty", "honesty"),
    "atlas-separatrix": Chart(
        "Digits lost over the shapes, on the separatrix", "atlas", "atlas", "separatrix"
    ),
    "atlas-levels": Chart("Digits lost over start and level", "atlas", "atlas", "levels"),
    "atlas-turning": Chart(
        "Digits lost near turning points and stable rotations", "atlas", "atlas", "turning"
    ),
    "scaling": Chart("Time against digits, starts and claims", "scaling", "scaling"),
    "identities": Chart("Deciding identities: SymPy against tresym", "identities", "identities"),
    "separatrix": Chart("ε₀ to 50 digits", "separatrix", "times"),
    "many": Chart("A million ε₀ in float64", "many", "times"),
    "turn": Chart("F(ε, γ) to 50 digits", "turn", "times"),
    "defect": Chart("ε(γ) to 50 digits", "defect", "times"),
    "values": Chart("Integrals, roots and functions to 50 digits", "values", "times"),
    "flipmap": Chart("The flip of very many starts", "flipmap", "times"),
}
"""The charts of ``tresym chart``, by name."""


def svg(name: str, source: str | None = None) -> str:
    """Return the chart ``name`` as SVG text; the arguments are those of :func:`picture`.

    Raises:
        InputError: as for :func:`picture`.
    """
    return picture(name, source).decode()


def picture(name: str, source: str | None = None, kind: str = "svg") -> bytes:
    """Return the chart ``name`` as the bytes of an SVG, PDF or PNG file.

    Args:
        name: one of ``CHARTS``.
        source: the file of a measurement; None means the one saved with tresym.
        kind: svg, pdf or png.

    Raises:
        InputError: there is no such chart, the file is not such a measurement, or matplotlib is not
            installed.
    """
    if name not in CHARTS:
        raise InputError(f"chart: {quoted(name)} is not known; known: {', '.join(CHARTS)}")
    chart = CHARTS[name]
    from xml.sax.saxutils import escape

    from tresym.report.charts.saved import load
    from tresym.report.figures import style

    data = load(chart.workload, source)
    module = import_module(f"{__name__}.{chart.module}")
    part = () if chart.part is None else (chart.part,)
    with style.looks():
        try:  # a wrong file may also fail while saving, as with a label of half a formula
            figure, caption = _drawn(chart, module, data, part)
            if kind != "svg":
                return style.bitmap_or_page(figure, chart.title, kind)
            return style.svg_text(figure, escape(chart.title), escape(caption)).encode()
        except (ArithmeticError, AttributeError, LookupError, TypeError, ValueError) as error:
            if source is None or isinstance(error, InputError):
                raise
            name = shortened(source)
            raise InputError(
                f"{name}: is not a measurement as `tresym bench --save` writes it"
            ) from None


def _drawn(
    chart: Chart, module: Any, data: dict[str, Any], part: tuple[str, ...]
) -> tuple[Any, str]:
    """The picture with its caption below, and the caption."""
    from tresym.report.charts.common import below, measured_with

    try:
        figure = module.draw(data, *part)
        caption = f"{module.caption(data, *part)} {measured_with(data)}"
    except (KeyError, TypeError, ValueError, StopIteration) as error:
        raise InputError(
            f"chart: the file is not a measurement of the workload {chart.workload}"
        ) from error
    below(figure, caption)
    return figure, caption
