"""Convert LaTeX to MathML at build time, so that the site needs no network."""

from __future__ import annotations

import base64
import io
import logging
from functools import cache
from pathlib import Path

_LETTERS = ((0x20, 0x7F), (0x391, 0x3F7), (0x1D434, 0x1D468), (0x1D6E2, 0x1D71C))
_SIGNS = (
    "ℎ𝖳−±∓×·⋅÷=≠≈≃∼≤≥<>≪≫∝→←↦⇒⇔⟹⟺∈∉∥∞∂∇∫∑∏√′″…⋯⟨⟩|‖⊤˙"
    "\u00a0\u2009\u2061\u2062\u2063\u0302\u0307\u0308\u20d7"
)
"""Characters that are kept in the font besides upright and italic letters."""

FAMILY = "tresym mathematics"


@cache
def _converter() -> object:
    from math_core import LatexToMathML

    return LatexToMathML()


def mathml(formula: str, block: bool) -> str:
    """Return a formula as MathML.

    Args:
        formula: LaTeX.
        block: whether it is displayed on a line of its own.

    Raises:
        math_core.LatexError: the formula cannot be parsed.
    """
    return str(_converter().convert_with_local_state(formula, displaystyle=block))  # type: ignore


def stylesheet(font: Path) -> str:
    """Return CSS with the mathematical font embedded, reduced to the characters that are used."""
    from fontTools import subset

    logging.getLogger("fontTools").setLevel(logging.WARNING)
    options = subset.Options(
        flavor="woff", layout_features=["ssty", "mark", "mkmk", "ccmp"], notdef_outline=True
    )
    cut = subset.Subsetter(options)
    cut.populate(unicodes=[*map(ord, _SIGNS), *(c for ends in _LETTERS for c in range(*ends))])
    with subset.load_font(str(font), options) as loaded:
        cut.subset(loaded)
        stream = io.BytesIO()
        subset.save_font(loaded, stream, options)
    data = base64.b64encode(stream.getvalue()).decode("ascii")
    return (
        f'@font-face {{ font-family: "{FAMILY}"; font-display: block;\n'
        f"  src: url(data:font/woff;base64,{data}) format('woff'); }}\n"
        f'math {{ font-family: "{FAMILY}", math; }}\n'
    )


def font_file() -> Path:
    """Return the file of STIX Two Math, which comes with ziamath (SIL Open Font License)."""
    import ziamath

    return Path(ziamath.__file__).parent / "fonts" / "STIXTwoMath-Regular.ttf"
