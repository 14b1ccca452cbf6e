"""Pages with the files of the proofs, their lines numbered, to which the pages of claims link."""

from __future__ import annotations

from collections.abc import Iterator

from pygments import highlight
from pygments.formatters import HtmlFormatter
from pygments.lexers import PythonLexer, TextLexer

from tresym.ledger.paper import racket

STYLE = """
body { margin: 0 auto; padding: 1rem; max-width: 76rem; font-size: 14px; }
pre { margin: 0; }
.highlight { overflow-x: auto; }
td.linenos a { color: #666; text-decoration: none; }
span:target, a:target + span { background: #fff3b0; }
"""


def pages() -> Iterator[tuple[str, str]]:
    """Yield a page for each module of the proofs, as the name of its file and its HTML.

    The line n has the address ``#L-n``.
    """
    paper = racket()
    look: HtmlFormatter[str] = HtmlFormatter(
        linenos="table", lineanchors="L", anchorlinenos=True, wrapcode=True
    )
    style = look.get_style_defs(".highlight")
    for module in paper.modules:
        path = paper.source_of(module)
        text = path.read_text(encoding="utf-8")
        lexer = PythonLexer() if path.suffix == ".py" else TextLexer()
        yield (
            f"{module}.html",
            f'<!doctype html>\n<html lang="en"><head><meta charset="utf-8">'
            f'<meta name="viewport" content="width=device-width">'
            f"<title>proofs/{path.name}</title><style>{style}{STYLE}</style></head>\n"
            f'<body><p><a href="../claims/index.html">the ledger</a></p>'
            f"<h1>proofs/{path.name}</h1>\n{highlight(text, lexer, look)}</body></html>\n",
        )
