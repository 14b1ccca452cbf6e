"""The table of published approximations with their largest errors, for the site.

The list is docs/examples/approximations.txt, in the form of
:mod:`tresym.accuracy.approximation_list`: facts and coefficients with their source.
"""

from __future__ import annotations

from pathlib import Path

from tresym.accuracy.approximation_list import EXCEEDED, HOLDS, ROUNDED, judge, read_list, table
from tresym.accuracy.table import written

LIST = Path("examples") / "approximations.txt"


def page(docs: Path) -> str:
    """Return the table in Markdown, after a sentence that counts the verdicts.

    Args:
        docs: the folder of the documents.
    """
    rows = [judge(one) for one in read_list((docs / LIST).read_text(encoding="utf-8"))]
    count = {name: sum(one.verdict == name for one in rows) for name in (HOLDS, ROUNDED, EXCEEDED)}
    printed = sum(bool(one.published.bound) for one in rows)
    head = (
        f"The list has {len(rows)} approximations, {printed} of them with a printed bound. "
        f"{count[HOLDS]} bounds hold, {count[ROUNDED]} more are the largest error rounded to the "
        f"printed digits, and {count[EXCEEDED]} exceeded.\n\n"
    ).replace("1 exceeded", "1 is exceeded")
    for one in rows:
        if one.verdict == EXCEEDED:
            place = f" at {one.error.where}" if one.error.where else ""
            head += f"{one.published.source}: the error is {one.error.low}{place}, where "
            head += f"{one.published.bound} is printed.\n\n"
    return head + written(table(rows), "markdown")
