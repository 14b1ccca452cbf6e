"""Round SVG output to a grid, so that it does not depend on the last bits of floats.

The last bits of sines and matrix products differ between processors. Coordinates are therefore
rounded to a grid far coarser than that, and everything else that depends on these bits is removed.
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
_METADATA = re.compile(r"^ *<metadata>.*?</metadata>\n", re.MULTILINE | re.DOTALL)
_INDENT = re.compile(r"^ +(?=<)", re.MULTILINE)
_GROUP = re.compile(r'<g id="(?!text_)[^"]*"')
_LETTER = re.compile(r'(<use xlink:href="#[^"]*") transform="translate\((\S+) 0\)"')
_STEP = re.compile(r"\n([LQCz]) ?(?=[-\d\n\"])")
_GLYPH = re.compile(r'(?<=[#"])(DejaVuSans[A-Za-z-]*)-(?=[0-9a-f]+")')
_IMAGE = re.compile(r'(?<=data:image/png;base64,)[^"]*')


def coordinate(x: float, digits: int = 2) -> str:
    """Return a coordinate rounded to ``digits`` decimals.

    The cells of the grid meet at the golden section between two decimals, not in the middle. Round
    coordinates such as 0.5 would lie exactly in the middle, where the last bit decides.
    """
    text = f"{math.floor(x * 10**digits + _SECTION) / 10**digits:.{digits}f}"
    return text.rstrip("0").rstrip(".")


def on_grid(text: str, title: str) -> str:
    """Return an SVG of matplotlib rounded to the grid.

    A point equal to the one before is left out, and so is the repeated first point of a closed
    line: whether they were equal as floats depends on the machine. Names, which matplotlib makes as
    hashes of exact coordinates, are made again from the title and their order.
    """
    text = _PLACES.sub(lambda part: _rounded(part[0], 2), text)
    text = _FACTORS.sub(lambda part: _rounded(part[0], 5), text)
    names: dict[str, str] = {}

    def named(found: re.Match[str]) -> str:
        order = f"{title}{len(names)}".encode()
        return names.setdefault(found[0], found[1] + hashlib.sha256(order).hexdigest()[:6])

    return _NAME.sub(named, _HOME.sub(r"\1z", _AGAIN.sub(r"\1", text)))


def compact(text: str, described: str) -> str:
    """Return an SVG of matplotlib in fewer bytes, with its description in place of the metadata.

    Most of a chart's bytes place letters, one ``use`` for each: they lose their indentation, and
    the glyphs their long names. Of groups only texts keep names.
    """
    text = _INDENT.sub("", _METADATA.sub(lambda _: described, text, count=1))
    text = _GROUP.sub("<g", text)
    text = _STEP.sub(r"\1", _LETTER.sub(r'\1 x="\2"', text))
    return _GLYPH.sub(lambda font: "".join(c for c in font[1] if c.isupper()), text)


def _rounded(text: str, digits: int) -> str:
    return _NUMBER.sub(lambda found: coordinate(float(found[0]), digits), text)


def shown(text: str) -> str:
    """Return the text with images replaced by their pixels, which do not depend on zlib."""
    return _IMAGE.sub(_pixels, text) if "data:image" in text else text


def _pixels(found: re.Match[str]) -> str:
    from PIL import Image

    image = Image.open(io.BytesIO(base64.b64decode(found[0])))
    return f"{image.size} {hashlib.sha256(image.convert('RGBA').tobytes()).hexdigest()}"
