"""Round SVG output to a grid, so that it does not depend on the last bits of floats.

Sines and matrix products differ there from one processor to the next. Places are therefore written
on a grid far above that, and what else would show these bits is taken out.
"""

from __future__ import annotations

import base64
import hashlib
import io
import math
import re

_SECTION = (3 - math.sqrt(5)) / 2
_PLACES = re.compile(
    r'(?<=[\s"])(?:(?:d|x|y|width|height|viewBox)="[^"]*"|(?:translate|rotate)\([^)]*\))'
)
_FACTORS = re.compile(r"matrix\([^)]*\)")
_NUMBER = re.compile(r"-?\d+(?:\.\d*)?(?:e[-+]?\d+)?")
_AGAIN = re.compile(r"^(L .*\n)\1+", re.MULTILINE)
_HOME = re.compile(r"(M (\S+ \S+)\n(?:[LQC] .*\n)*?)L \2\nz")
_NAME = re.compile(r'(?<=[#"])([a-zC]*)[0-9a-f]{10}(?=[_")])')
_IMAGE = re.compile(r'(?<=data:image/png;base64,)[^"]*')


def coordinate(x: float, digits: int = 2) -> str:
    """A coordinate to so many decimals.

    The cells of the grid meet at the golden section between two decimals, not in the middle: what
    is drawn at a round number would lie just there, where the last bit decides.
    """
    text = f"{math.floor(x * 10**digits + _SECTION) / 10**digits:.{digits}f}"
    return text.rstrip("0").rstrip(".")


def on_grid(text: str, title: str) -> str:
    """The SVG that matplotlib writes, on the grid.

    A point where the last one was is left out, as is the first of a closed line at its end: which
    of them were equal as floats is chance. Names are hashes of places in full; they are made anew
    of the title and their order.
    """
    text = _PLACES.sub(lambda part: _rounded(part[0], 2), text)
    text = _FACTORS.sub(lambda part: _rounded(part[0], 5), text)
    names: dict[str, str] = {}

    def named(found: re.Match[str]) -> str:
        order = f"{title}{len(names)}".encode()
        return names.setdefault(found[0], found[1] + hashlib.sha256(order).hexdigest()[:10])

    return _NAME.sub(named, _HOME.sub(r"\1z", _AGAIN.sub(r"\1", text)))


def _rounded(text: str, digits: int) -> str:
    return _NUMBER.sub(lambda found: coordinate(float(found[0]), digits), text)


def shown(text: str) -> str:
    """The text with each image in it as its pixels: how a PNG is packed is up to the zlib there."""
    return _IMAGE.sub(_pixels, text) if "data:image" in text else text


def _pixels(found: re.Match[str]) -> str:
    from PIL import Image

    image = Image.open(io.BytesIO(base64.b64decode(found[0])))
    return f"{image.size} {hashlib.sha256(image.convert('RGBA').tobytes()).hexdigest()}"
