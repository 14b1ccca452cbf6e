"""The figures of the paper as a Python function."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from tresym.report.pages.python_api import Picture

if TYPE_CHECKING:
    from tresym.racket.body import Body, NamedBody


def figure(
    name: str, path: str | os.PathLike[str] | None = None, body: Body | NamedBody | None = None
) -> Picture:
    """Draw a figure of the paper.

    Args:
        name: a figure that ``tresym figure`` lists, such as ``"flip-map"``.
        path: where to save it as well; the ending (.svg, .pdf, .png) says in which format.
        body: draw it for this body; possible for flip-portrait, flip-map, flip-curves and
            racket-flip.

    Returns:
        The figure as SVG; a notebook shows it.

    Raises:
        InputError: an unknown figure, a body for a figure that has none, or no matplotlib.

    Example:
        >>> import tresym
        >>> tresym.figure("flip-portrait")  # doctest: +SKIP
        Picture(41922 bytes of SVG)
    """
    from tresym.proofs import figures
    from tresym.proofs.figures.curves import floats

    shape = None if body is None else floats(body.shape)
    if path is not None:
        from tresym.output import write_bytes

        target = os.fspath(path)
        write_bytes(target, figures.picture(name, figures.kind_of(target), shape))
    return Picture(figures.picture(name, "svg", shape))
