"""Charts of saved measurements as SVG: each is a pure function of one JSON file.

The module of a chart has ``draw(data)``, the picture, ``caption(data)``, a description of what it
shows, and ``conclusion(data)``, a sentence that says what a reader learns. The bytes are the same
on every build with the same matplotlib. All charts can be read in black and white: methods differ
by marker and line style as well as by colour.
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
        "Claims that tresym, SymPy, Maxima, z3 and numerical testing decide",
        "deciders",
        "deciders",
    ),
    "work-precision": Chart(
        "Correct digits against time, in six cases", "precision", "work_precision"
    ),
    "honesty": Chart("Digits claimed, and digits that are right", "honesty", "honesty"),
    "atlas-separatrix": Chart(
        "Digits that formulas lose on the separatrix, by the shape of the body",
        "atlas",
        "atlas",
        "separatrix",
    ),
    "atlas-levels": Chart(
        "Digits that formulas lose, by start and level of the motion", "atlas", "atlas", "levels"
    ),
    "atlas-turning": Chart(
        "Digits that formulas lose near turning points and stable rotations",
        "atlas",
        "atlas",
        "turning",
    ),
    "scaling": Chart(
        "Time against digits, number of starts, and number of claims", "scaling", "scaling"
    ),
    "identities": Chart(
        "Time to decide an identity: SymPy against tresym", "identities", "identities"
    ),
    "separatrix": Chart("The defect ε₀ on the separatrix, to 50 digits", "separatrix", "times"),
    "many": Chart("A million defects ε₀ in float64", "many", "times"),
    "turn": Chart("The integral F(ε, γ), to 50 digits", "turn", "times"),
    "defect": Chart("The defect ε(γ) off the separatrix, to 50 digits", "defect", "times"),
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


def conclusion(name: str, source: str | None = None) -> str:
    """Return what a reader learns from the chart ``name``, in a sentence.

    Raises:
        InputError: as for :func:`picture`.
    """
    from tresym.report.charts.saved import load

    chart = CHARTS[name]
    module = import_module(f"{__name__}.{chart.module}")
    part = () if chart.part is None else (chart.part,)
    return str(module.conclusion(load(chart.workload, source), *part))


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
