r"""Write HTML pages with typeset formulas: words, formulas and the page around them.

    words("where $x^2 < 1$ and `x` is real")  # HTML, the formula in MathML

Formulas are converted from LaTeX by math-core, which comes with the extra ``html``. Where it is not
installed, or cannot read a formula, the LaTeX itself is shown; :func:`typesets` says which it is.
A page has its style inside and loads nothing.
"""

from __future__ import annotations

import re
from html import escape

from tresym.manuscript.html import MARK
from tresym.manuscript.printed import latex_as_mathml

_PIECES = re.compile(r"\$([^$\n]+)\$|`([^`\n]+)`|\*\*([^*\n]+)\*\*|\*([^*\s][^*\n]*)\*")
_STYLE = """
body { font: 17px/1.55 Georgia, "Times New Roman", serif; max-width: 44rem; margin: 2rem auto;
  padding: 0 1rem; color: #222; overflow-wrap: break-word }
h1 { font-size: 1.7rem; line-height: 1.25 } h2 { font-size: 1.25rem; margin-top: 2rem }
nav { font: 14px system-ui, sans-serif } a { color: #0b4f8a }
.formula, .wide { overflow-x: auto; overflow-y: hidden; padding: .4rem 0 }
.claim { border-left: 3px solid #bbb; padding-left: 1rem; margin: 1.2rem 0 }
.claim.PROVED, .claim.ENCLOSED { border-color: #080 } .claim.REFUTED { border-color: #c00 }
.claim.UNDECIDED { border-color: #c80 }
.abstract { margin: 1.5rem 2rem; font-size: .95em } .authors { font-style: italic }
table { border-collapse: collapse; font-size: .9em } caption { text-align: left; color: #555 }
td, th { padding: .15rem .8rem .15rem 0; text-align: left; vertical-align: top }
thead th { border-bottom: 1px solid #888 }
math { font-size: 1.08em } code { font-size: .85em; overflow-wrap: anywhere }
img, svg { max-width: 100%; height: auto } footer { color: #555; font-size: .85em }
"""


def typesets() -> bool:
    """Return whether formulas are typeset, which needs math-core."""
    return bool(latex_as_mathml("x"))


def formula(latex: str, block: bool = False) -> str:
    r"""Return a formula as MathML; as its LaTeX if it cannot be converted.

    Args:
        latex: the formula.
        block: whether it stands on a line of its own.

    Example:
        >>> "<math" in formula("x^2") or formula("x^2") == "<code>x^2</code>"
        True
    """
    return latex_as_mathml(latex, block) or f"<code>{escape(latex)}</code>"


def words(text: str) -> str:
    """Return words in HTML, with formulas between dollars, code between back quotes, and stars.

    Example:
        >>> words("if `a < b`, *then* **not** c & d")
        'if <code>a &lt; b</code>, <em>then</em> <strong>not</strong> c &amp; d'
    """
    found, last = "", 0
    for piece in _PIECES.finditer(text):
        found += escape(text[last : piece.start()], quote=False)
        shown, code, strong, emphasis = piece.groups()
        if shown is not None:
            found += formula(shown)
        elif code is not None:
            found += f"<code>{escape(code, quote=False)}</code>"
        else:
            tag, inside = ("strong", strong) if strong is not None else ("em", emphasis)
            found += f"<{tag}>{words(inside)}</{tag}>"
        last = piece.end()
    return found + escape(text[last:], quote=False)


def page(title: str, body: str) -> str:
    """Return a complete page.

    Args:
        title: its title, in plain words.
        body: what it contains, in HTML.
    """
    return (
        f'<!doctype html>\n<html lang="en">\n<meta charset="utf-8">\n{MARK}\n'
        f"<title>{escape(title)}</title>\n"
        f'<meta name="viewport" content="width=device-width">\n<style>{_STYLE}</style>\n'
        f"{body}\n</html>\n"
    )
