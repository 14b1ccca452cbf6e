"""Draw the neighbourhood of a claim as SVG: what it depends on, and what depends on it.

Dependencies are at the left, claims that use the claim at the right. A box links to the page of its
claim, and the colour of its edge shows the verdict.
"""

from __future__ import annotations

from collections.abc import Iterator
from html import escape
from textwrap import wrap
from typing import Any

Record = dict[str, Any]

MOST = 7
"""Most boxes in a column; the number of further ones is shown."""
LETTERS = 24
"""Letters of a title that fit on one of the two lines of a box."""
BOX, HIGH, ACROSS, DOWN = 170, 38, 190, 46
"""Width and height of a box, and the distances between boxes."""


def picture(label: str, claims: dict[str, Record]) -> str:
    """Return an SVG for the page of a claim; empty for a claim without neighbours."""
    columns = [column for column in _columns(label, claims) if column]
    if len(columns) < 2:
        return ""
    shown = [column[:MOST] for column in columns]
    more = [len(column) - len(kept) for column, kept in zip(columns, shown, strict=True)]
    rows = max(len(kept) + bool(n) for kept, n in zip(shown, more, strict=True))
    wide, high = ACROSS * (len(shown) - 1) + BOX, DOWN * (rows - 1) + HIGH
    places = {
        name: (float(ACROSS * x), (high - DOWN * (len(kept) - 1 + bool(n)) - HIGH) / 2 + DOWN * y)
        for x, (kept, n) in enumerate(zip(shown, more, strict=True))
        for y, name in enumerate(kept)
    }
    parts = [*_edges(places, claims), *(_box(n, at, claims[n], label) for n, at in places.items())]
    for x, (kept, n) in enumerate(zip(shown, more, strict=True)):
        if n:
            below = places[kept[-1]][1] + DOWN + HIGH / 2 + 4
            parts.append(f'<text x="{ACROSS * x + 8}" y="{below:g}">and {n} more</text>')
    description = f"What {claims[label]['title']} uses, and what uses it"
    return (
        f'<div class="graph"><svg viewBox="-2 -2 {wide + 4} {high + 4:g}" width="{wide + 4}" '
        f'role="img" aria-label="{escape(description)}">{"".join(parts)}</svg></div>'
    )


def _columns(label: str, claims: dict[str, Record]) -> tuple[list[str], ...]:
    """Dependencies of its dependencies, its direct dependencies, the claim, and what uses it."""
    first = claims[label]["uses"]
    deeper = dict.fromkeys(other for name in first for other in claims[name]["uses"])
    direct = [name for name in first if name not in deeper]
    above = [name for name in claims[label]["used_by"] if name not in deeper]
    return [n for n in deeper if n not in above], direct, [label], above


def _edges(places: dict[str, tuple[float, float]], claims: dict[str, Record]) -> Iterator[str]:
    for name, (x, y) in places.items():
        for used in claims[name]["uses"]:
            if used in places and places[used][0] < x:
                start, end = places[used][0] + BOX, (places[used][1] + HIGH / 2, y + HIGH / 2)
                bend = (x - start) / 2
                yield (
                    f'<path d="M{start:g} {end[0]:g}c{bend:g} 0 {x - start - bend:g} '
                    f'{end[1] - end[0]:g} {x - start:g} {end[1] - end[0]:g}"/>'
                )


def _box(name: str, at: tuple[float, float], claim: Record, own: str) -> str:
    title = claim["title"]
    lines = wrap(title, LETTERS, max_lines=2, placeholder="…")
    first = HIGH / 2 + 4 - 6.5 * (len(lines) - 1)
    kind = claim["verdict"].lower() + (" own" if name == own else "")
    x, y = at
    return (
        f'<a href="{name}.html"><title>{escape(title)} ({claim["verdict"]})</title>'
        f'<rect class="{kind}" x="{x:g}" y="{y:g}" width="{BOX}" height="{HIGH}" rx="4"/>'
        + "".join(
            f'<text x="{x + 8:g}" y="{y + first + 13 * n:g}">{escape(words)}</text>'
            for n, words in enumerate(lines)
        )
        + "</a>"
    )
