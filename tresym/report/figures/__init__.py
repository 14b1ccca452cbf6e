"""The paper's figures, recomputed: each file has ``data()``, arrays, and ``draw(data)``, a picture.

What a caption says is tested on the arrays of ``data()``. The pictures are SVG (PDF and PNG on
request), the same bytes on every build with the same matplotlib: no dates, no random names.
"""

from __future__ import annotations

from importlib import import_module
from pathlib import PurePath

from tresym.reals.numbers.exact import InputError, quoted

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
"""The figures ``tresym figure`` knows, by name; the file of ``a-b`` is ``a_b.py``."""

KINDS = ("svg", "pdf", "png", "gif", "mp4")
MOVING = ("gif", "mp4")
"""The kinds of file a picture is saved as, and those of what moves."""
MM_PER_INCH = 25.4
OF_A_BODY = ("flip-portrait", "flip-map", "flip-curves", "racket-flip")
"""The figures that are drawn of any body."""


def svg(name: str) -> str:
    """The figure ``name`` as the text of an SVG file.

    Raises:
        InputError: an unknown name, or matplotlib is not installed.
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
    """The figure ``name`` as the bytes of a file of this kind, one of ``KINDS``.

    Args:
        name: one of ``FIGURES``.
        kind: one of ``KINDS``.
        body: (a, b) of a shape, for a figure of ``OF_A_BODY``; the standard racket otherwise.
        gamma: of the one level that flip-curves shall show.
        width: of the picture, in millimetres; its height follows.
        dpi: dots an inch of a PNG.

    Raises:
        InputError: an unknown name, what this figure is not drawn of, or no matplotlib.
    """
    if name not in FIGURES:
        raise InputError(f"figure: {quoted(name)} is not known; known: {', '.join(FIGURES)}")
    if body is not None and name not in OF_A_BODY:
        raise InputError(f"figure: of a body of one's own there are {', '.join(OF_A_BODY)}")
    if gamma is not None and name != "flip-curves":
        raise InputError("figure: --gamma belongs to flip-curves")
    if kind in MOVING and name != "racket-flip":
        raise InputError(f"figure: {name} does not move, so it is no {kind.upper()}")
    module = import_module(f"{__name__}.{name.replace('-', '_')}")
    given = {key: x for key, x in (("body", body), ("gamma", gamma)) if x is not None}
    if name == "racket-flip" and kind in ("svg", *MOVING):
        if width is not None:
            raise InputError("figure: what moves has one size; a PDF or PNG of it is a strip")
        found = module.data(**given)
        if kind == "mp4":
            return bytes(module.film(found))
        return module.moving(found) if kind == "gif" else str(module.draw(found)).encode()
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


def kind_of(path: str | None) -> str:
    """The kind of picture a file of this name holds; SVG where there is no file or no ending.

    Raises:
        InputError: an ending that no picture here has.
    """
    ending = "" if path is None else PurePath(path).suffix[1:].lower()
    if ending and ending not in KINDS:
        raise InputError(
            f"{path}: a picture is saved as .svg, .pdf or .png; what moves, .gif or .mp4 too"
        )
    return ending or "svg"
