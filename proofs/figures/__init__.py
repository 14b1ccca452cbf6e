"""The paper's figures, recomputed: each module has ``data()``, the arrays, and ``draw(data)``.

Tests compare the arrays of ``data()`` with what the captions say. The pictures are SVG, or PDF and
PNG on request. They are the same bytes on every build with the same matplotlib: they contain no
dates and no random names.
"""

from __future__ import annotations

from importlib import import_module

from tresym.reals.numbers.exact import InputError, quoted
from tresym.report.figures import KINDS, MM_PER_INCH, MOVING, kind_of

FIGURES = {
    "racket-frame": "Fig. 1: the frame attached to the racket",
    "euler-angles": "Fig. 2: the Euler angles",
    "momentum-sphere": "Fig. 3: energy ellipsoid and momentum sphere, and the curves on it",
    "flip-portrait": "Fig. 4: phase portrait of the flip angle psi",
    "handle-portrait": "Fig. 5: phase portrait of the angle theta",
    "handle-curves": "Fig. 6: the curve of the handle on the sphere",
    "symmetric-flips": "Fig. 7: the symmetric trajectories of one full turn",
    "defect-map": "Fig. 8: epsilon over epsilon_0 and gamma, exact beside linear",
    "flip-curves": "Fig. 9: psi over phi, six values of gamma",
    "flip-map": "Fig. 10: the flip of every start, and a zoom",
    "shape-map": "Fig. 11: epsilon_0 over the shapes, with the bodies",
    "racket-flip": "an animation: two turns of the racket in space",
}
"""The figures of ``tresym figure``, by name; the module of ``a-b`` is ``a_b.py``."""

PRINTED_MM = {
    "racket-frame": 84, "euler-angles": 140, "momentum-sphere": 140, "flip-portrait": 112,
    "handle-portrait": 112, "handle-curves": 130, "symmetric-flips": 118, "defect-map": 140,
    "flip-curves": 108, "flip-map": 140, "shape-map": 140, "racket-flip": 146,
}  # fmt: skip
"""The width of each figure in an article, whose lines are 146 mm long."""
SMALLER_TEXT = {"momentum-sphere": 0.8}
"""The size of the text in these, relative to the other figures."""
OF_A_BODY = ("flip-portrait", "flip-map", "flip-curves", "racket-flip")
"""The figures that can be drawn for any body."""


def svg(name: str) -> str:
    """Return the figure ``name`` as the text of an SVG file.

    Raises:
        InputError: there is no such figure, or matplotlib is not installed.
    """
    return picture(name).decode()


def picture(
    name: str,
    kind: str = "svg",
    body: tuple[float, float] | None = None,
    gamma: float | None = None,
    width: float | None = None,
    dpi: int = 200,
) -> bytes:
    """Return the figure ``name`` as the bytes of a file.

    Args:
        name: one of ``FIGURES``.
        kind: one of ``KINDS``.
        body: (a, b) of a shape, for a figure of ``OF_A_BODY``; the standard racket otherwise.
        gamma: the only level that flip-curves shows; None shows six.
        width: width of the picture in millimetres; the height follows. None means the default size.
        dpi: dots per inch of a PNG, and of an animation with a width.

    Raises:
        InputError: there is no such figure, an argument does not apply to it, or matplotlib is not
            installed.
    """
    if name not in FIGURES:
        raise InputError(f"figure: {quoted(name)} is not known; known: {', '.join(FIGURES)}")
    if body is not None and name not in OF_A_BODY:
        raise InputError(f"figure: only {', '.join(OF_A_BODY)} can be drawn for your own body")
    if gamma is not None and name != "flip-curves":
        raise InputError("figure: --gamma is an option of flip-curves")
    if kind in MOVING and name != "racket-flip":
        raise InputError(
            f"figure: {name} is not an animation and cannot be saved as {kind.upper()}"
        )
    module = import_module(f"{__name__}.{name.replace('-', '_')}")
    given = {key: x for key, x in (("body", body), ("gamma", gamma)) if x is not None}
    if name == "racket-flip" and kind in ("svg", *MOVING):
        found = module.data(**given)
        if kind == "svg":
            return str(module.draw(found, width)).encode()
        pixels = module.WIDTH if width is None else round(width / MM_PER_INCH * dpi)
        return bytes((module.film if kind == "mp4" else module.moving)(found, pixels))
    from tresym.report.figures import style

    with style.looks():
        drawn = module.strip if name == "racket-flip" else module.draw
        figure = drawn(module.data(**given))
        if width is not None:
            share = width / MM_PER_INCH / figure.get_figwidth()
            figure.set_size_inches(figure.get_size_inches() * share)
            style.fit_words(figure, share)
        if kind == "svg":
            return style.svg_text(figure, FIGURES[name]).encode()
        return style.bitmap_or_page(figure, FIGURES[name], kind, dpi)


def printed(name: str, kind: str = "pdf") -> bytes:
    """Return a figure for an article: in the fonts of LaTeX, and legible in grey.

    Args:
        name: one of ``FIGURES``.
        kind: ``pdf`` or ``svg``.

    Raises:
        InputError: matplotlib is not installed.
    """
    from tresym.report.figures import style

    module = import_module(f"{__name__}.{name.replace('-', '_')}")
    with style.looks(printed=True):
        figure = (module.strip if name == "racket-flip" else module.draw)(module.data())
        style.set_formulas(figure)
        share = PRINTED_MM[name] / MM_PER_INCH / figure.get_figwidth()
        figure.set_size_inches(figure.get_size_inches() * share)
        if name in SMALLER_TEXT:
            style.scale_words(figure, SMALLER_TEXT[name])
        if kind == "svg":
            return style.svg_text(figure, FIGURES[name]).encode()
        return style.bitmap_or_page(figure, FIGURES[name], kind)


__all__ = ["FIGURES", "KINDS", "OF_A_BODY", "kind_of", "picture", "printed", "svg"]
