"""Tables and charts of a file of claims: the errors of a claim at exact points."""

from __future__ import annotations

import math
import re
from typing import Any

from tresym.accuracy.table import Table, latex_text, letter, raised, written
from tresym.papers.error_rows import chart_points, error_rows, rounded, sides_of
from tresym.papers.reading import Drawn, OwnPaper, PaperClaim
from tresym.reals.language.paths import read_path
from tresym.reals.numbers.exact import InputError

_SUPERSCRIPTS = "⁰¹²³⁴⁵⁶⁷⁸⁹⁻"
_PLAIN = str.maketrans(_SUPERSCRIPTS, "0123456789-")
FORMS = {"article": "latex", "beamer": "latex", "html": "html", "site": "html"}
"""The format of tables in a document of a style; Markdown in the others."""
FEW = 4
"""The digits of errors in a table, whose other columns have as many as the file asks for."""


def error_table(paper: OwnPaper, drawn: Drawn) -> Table:
    """Return a table that the file asks for.

    Raises:
        InputError: the claim has no errors, or the points do not fit.
    """
    claim = paper.claims[drawn.label]
    rows = list(error_rows(claim, drawn))
    names = [value.name for value in rows[0].at]
    _, _, gauge = sides_of(claim)
    heads = [*map(letter, names), "exact", "approximation", "error", "relative error"]
    heads += [f"error/({raised(str(gauge))})"] if gauge is not None else []
    digits, few = drawn.digits, min(FEW, drawn.digits)
    body = []
    for row in rows:
        cells = [str(value.value) for value in row.at]
        cells += [rounded(row.exact, digits), rounded(row.approx, digits)]
        cells += [rounded(row.error, few), rounded(row.relative, few)]
        cells += [rounded(row.ratio, few)] if gauge is not None else []
        body.append(tuple(cells))
    caption = f"Errors of {drawn.label}. Every digit is certified by a ball."
    return Table(caption, tuple(heads), tuple(body), f"{drawn.label}-errors", len(names))


def latex_words(text: str) -> str:
    r"""Return words of a table in LaTeX, with raised exponents.

    Example:
        >>> latex_words("error/(e³)")
        'error/(e\\textsuperscript{3})'
    """
    parts = re.split(f"([{_SUPERSCRIPTS}]+)", text)
    return "".join(
        rf"\textsuperscript{{{part.translate(_PLAIN)}}}" if n % 2 else latex_text(part)
        for n, part in enumerate(parts)
    )


def tables_of(paper: OwnPaper, label: str) -> list[Table]:
    """Return the tables that the file asks for of a claim.

    Raises:
        InputError: no claim has the label, or the file asks for no table of it.
    """
    paper.chosen([label])
    found = paper.drawn("table", label)
    if not found:
        raise InputError(
            f"{paper.name}: no table of {label} is asked for: write the line 'table {label}: "
            "at x == 1/10, 1/100' with the variables of the claim"
        )
    return [error_table(paper, drawn) for drawn in found]


def all_tables(paper: OwnPaper, style: str) -> tuple[dict[int, str], tuple[str, ...]]:
    """Return the tables of a document, and a line for each that cannot be computed.

    Args:
        paper: the file.
        style: ``article`` or ``beamer`` for LaTeX, ``html`` or ``site``, else Markdown.

    Returns:
        The tables by their lines in the file; a line of error has the file and the line.
    """
    form = FORMS.get(style, "markdown")
    found: dict[int, str] = {}
    errors = []
    for drawn in paper.drawn("table"):
        try:
            found[drawn.line] = written(error_table(paper, drawn), form, latex_words)
        except InputError as error:
            errors.append(f"{paper.name}:{drawn.line}:1: {error}")
    return found, tuple(errors)


def chart(paper: OwnPaper, label: str, kind: str = "svg") -> bytes:
    """Return the chart of a claim's error against the variable of its path, on logarithmic scales.

    Args:
        paper: the file.
        label: the claim.
        kind: ``svg``, ``pdf`` or ``png``.

    Raises:
        InputError: no claim has the label, it has no errors, or matplotlib is not installed.
    """
    (claim,) = paper.chosen([label])
    asked = paper.drawn("chart", label)
    drawn = asked[0] if asked else Drawn(claim.line, "chart", label, (), 10)
    drawn = chart_points(claim, drawn._replace(digits=6), paper.drawn("table", label))
    path = None if claim.path is None else read_path(claim.path)
    along = path.name if path else max(drawn.at, key=lambda pair: len(pair[1]))[0]
    curves: dict[str, list[tuple[float, float]]] = {}
    largest = 0.0
    chosen = path is not None and not any(along in dict(one.at) for one in asked)
    for row in error_rows(claim, drawn, skipping=chosen):
        where = {value.name: value.value for value in row.at}
        x = _float_of(where[along], path)
        error = 0.0 if row.error is None else abs(float(row.error.mid))
        others = ", ".join(f"{name} = {v}" for name, v in where.items() if name != along)
        if x > 0 and error > 0:
            curves.setdefault(others, []).append((x, error))
        if row.ratio is not None:
            largest = max(largest, abs(float(row.ratio.mid)))
    if not curves:
        raise InputError(f"chart {label}: every error is 0 or the points are not positive")
    return _drawn(claim, along, curves, path, kind)


def _float_of(x: Any, path: Any) -> float:
    from tresym.accuracy.values import value

    if path is not None and path.point is not None:
        x = x - path.point
    return abs(float(value(x, digits=8)))


def _drawn(
    claim: PaperClaim,
    along: str,
    curves: dict[str, list[tuple[float, float]]],
    path: Any,
    kind: str,
) -> bytes:
    from tresym.report.charts import own

    point = None if path is None or path.point is None else str(path.point)
    label = along if point in (None, "0") else f"|{along} − {point}|"
    steepness = slope(sorted(next(iter(curves.values()))))
    title = f"Error of {claim.label}" + (f", slope {steepness:.2f}" if steepness else "")
    drawn = own.marks_of(curves)
    return own.saved(lambda: own.errors(drawn, label, title, (5.2, 3.4)), title, "", kind)


def slope(points: list[tuple[float, float]]) -> float | None:
    """Return the slope between the two points nearest to the end, on logarithmic scales."""
    if len(points) < 2 or points[0][0] == points[1][0]:
        return None
    (x, y), (z, w) = points[:2]
    return math.log(w / y) / math.log(z / x)
