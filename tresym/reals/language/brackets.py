"""Text outside of brackets: where a word stands, and the parts between such words.

``split("f(x, y), z", ",")`` has two parts, because the first comma stands in brackets.
"""

from __future__ import annotations

import re


def places(text: str, pattern: str) -> list[tuple[int, int]]:
    """Where a pattern matches outside of all brackets."""
    found: list[tuple[int, int]] = []
    depth, after = 0, 0
    for match in re.finditer(rf"[()\[\]{{}}]|(?P<word>{pattern})", text):
        if match.start() < after:
            continue
        if match["word"] is None:
            depth += 1 if match[0] in "([{" else -1
        elif depth == 0:
            found.append(match.span())
            after = match.end()
    return found


def split(text: str, pattern: str) -> list[str]:
    """Split a text where a pattern matches outside of all brackets."""
    parts, start = [], 0
    for first, end in places(text, pattern):
        parts.append(text[start:first])
        start = end
    return [*parts, text[start:]]


def closing(text: str) -> int | None:
    """Return where the bracket at the start is closed, brackets of any kind counted alike."""
    depth = 0
    for n, sign in enumerate(text):
        depth += (sign in "([{") - (sign in ")]}")
        if depth == 0:
            return n
    return None


def encloses(text: str) -> bool:
    """Return whether one pair of round brackets encloses the whole text."""
    return text[:1] == "(" and text[-1:] == ")" and closing(text) == len(text) - 1
