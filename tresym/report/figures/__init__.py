"""Draw pictures with matplotlib: their style, the grid of their coordinates, the kinds of files.

The pictures are SVG, or PDF and PNG on request. They are the same bytes on every build with the
same matplotlib: they contain no dates and no random names. The figures of a paper are its own:
those of the racket are in :mod:`tresym.proofs.figures`.
"""

from __future__ import annotations

from pathlib import PurePath

from tresym.reals.numbers.exact import InputError

KINDS = ("svg", "pdf", "png", "gif", "mp4")
MOVING = ("gif", "mp4")
"""The file formats of pictures, and those of animations."""
MM_PER_INCH = 25.4


def kind_of(path: str | None) -> str:
    """Return the kind of picture that a file of this name holds; SVG without a file or an ending.

    Raises:
        InputError: an ending of no known kind.
    """
    ending = "" if path is None else PurePath(path).suffix[1:].lower()
    if ending and ending not in KINDS:
        raise InputError(
            f"{path}: a picture is saved as .svg, .pdf or .png; an animation also as .gif or .mp4"
        )
    return ending or "svg"
