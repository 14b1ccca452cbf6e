"""A handbook's displays, held as printed, and false copies of them: ``python tests/handbook.py``

The displays are true. In each copy one digit, one sign or one factor of a right side is another; a
copy that is held is printed, to be looked at: a constant C may have either sign. The counts are in
docs/measurements/papers.json.
"""

import random
import re
import tempfile
from collections import Counter
from collections.abc import Iterator
from pathlib import Path

from tresym.manuscript.deciding import Row, decided
from tresym.manuscript.links import read_links
from tresym.manuscript.source import read_manuscript

LIST = Path(__file__).parent / "data" / "handbook.tex"
LIMIT = 150.0
"""Seconds of a clock on the wall, that of a busy machine."""


def changed(text: str, r: random.Random) -> Iterator[str]:
    """Displays with one digit, one sign or one factor changed."""
    for display in re.findall(r"\\begin\{equation\}(.*?)\\end\{equation\}", text, re.DOTALL):
        claim = re.split(r"\\q?quad", display)[0]
        left, equal, right = claim.partition("=")
        if not equal or re.match(r"\s*e\s*$", left) or "O(" in right:
            continue
        digits = list(re.finditer(r"(?<![\d.^_{])\d(?![\d.!])", right))
        signs = list(re.finditer(r"[+-]|\\pm|\\mp", right))
        if digits:
            k = r.choice(digits)
            yield f"{left}={right[: k.start()]}{int(k[0]) % 9 + 1}{right[k.end() :]}"
        if signs:
            k = r.choice(signs)
            other = {"+": "-", "-": "+", r"\pm": r"\mp", r"\mp": r"\pm"}[k[0]]
            yield f"{left}={right[: k.start()]}{other}{right[k.end() :]}"
        if not digits and not signs:
            yield f"{left}=2\\cdot {right}"


def rows(text: str) -> list[Row]:
    """The rows of a manuscript."""
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "list.tex"
        path.write_text(text, encoding="utf-8")
        return decided(read_links(read_manuscript(path)), LIMIT)


def main() -> None:
    """Decide the list and its copies."""
    text = LIST.read_text(encoding="utf-8")
    found = rows(text)
    print("true:", dict(Counter(row.status for row in found)))
    for row in found:
        if row.status not in ("PROVED", "ENCLOSED"):
            print(row.link.display.number, row.status, row.link.read_as or row.link.shown, row.why)
    head = text[: text.index(r"\section")]
    copies = [f"% tresym: claim\n\\[{copy}\\]" for copy in changed(text, random.Random(7))]
    found = rows(head + "\n".join(copies) + "\n\\end{document}")
    print("false:", dict(Counter(row.status for row in found)))
    for row in found:
        if row.status in ("PROVED", "ENCLOSED"):
            print(row.link.display.number, row.status, row.link.read_as)


if __name__ == "__main__":
    main()
