"""Parse a LaTeX source into its displays, theorems, tables and figures.

Nothing is typeset and no macro is expanded. The result contains the place of each piece, its label,
and the SHA-256 hash of its text, with comments removed and white space normalised. Hence a changed
sign counts as an alteration, but a changed line break or encoding does not.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass, field
from typing import NoReturn

from tresym.ledger.latex_source import (
    DISPLAYS,
    LABEL,
    MARKS,
    NotClosedError,
    display_at,
    end_of_display,
    unbalanced,
)
from tresym.reals.numbers.exact import InputError

FLOATS = {"table": "table", "table*": "table", "figure": "figure", "figure*": "figure"}


_MARKS = re.compile(
    MARKS + r"""| (?P<close>\\\]) | (?P<escaped>\\[^a-zA-Z]|\\[a-zA-Z]+) | (?P<formula>\$)""",
    re.VERBOSE | re.DOTALL,
)
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%[^\n]*(?:\n|$)")
_INNER_DISPLAY = re.compile(r"\\begin\{equation\}.*?\\end\{equation\}", re.DOTALL)
_FORMULA = re.compile(r"(?<!\\)\$[^$]+\$")
_HEADING = re.compile(r"\\(?:sub)*section\b")
_THEOREM = re.compile(r"\\newtheorem\*?\s*\{\s*(\w+)\s*\}\s*(?:\[\w+\])?\s*\{([^{}]*)\}")


@dataclass(frozen=True)
class Piece:
    r"""A display or a numbered piece of the source.

    Attributes:
        kind: ``equation``, ``brackets`` (``\[ \]``), ``dollars`` (``$$ $$``) etc., or ``theorem``,
            ``remark``, ``table``, ``figure``.
        label: the author's ``\label``, else ``d07`` for a display, ``remark1`` for other pieces.
        line: its first line, counted from 1.
        end: its last line.
        text: the text between the delimiters, without comments, with single spaces.
        number: the position of a display in the file, from 1; None for other pieces.
    """

    kind: str
    label: str
    line: int
    end: int
    text: str = field(repr=False)
    number: int | None = None

    @property
    def sha256(self) -> str:
        """The hash of the text in UTF-8."""
        return _sha256(self.text)


def hash_of(lines: Sequence[str]) -> str:
    """Return the hash of some lines, computed as for a piece."""
    return _sha256(_body("\n".join(lines)))


def _sha256(text: str) -> str:
    return hashlib.sha256(text.encode()).hexdigest()


def _body(text: str) -> str:
    """Return the text without comments and with single spaces."""
    return " ".join(_COMMENT.sub(r"\1", text).split())


@dataclass(frozen=True)
class Source:
    """The pieces of a LaTeX source: displays, and theorems, remarks, tables and figures."""

    displays: tuple[Piece, ...]
    others: tuple[Piece, ...]
    text: tuple[Piece, ...] = ()
    """The lines of the running text that hold a formula, or one of the words asked for."""


def scan(text: str, name: str = "the source", words: Sequence[str] = ()) -> Source:
    """Return the pieces of a LaTeX document in order.

    Args:
        text: the document.
        name: its name, for messages.
        words: beginnings of words; a line of running text with one of them is a piece, as is a line
            with a formula.

    Raises:
        InputError: an environment or formula is not closed, or closed by another one.
    """
    start = text.index("\\begin{document}")
    stop = text.find("\\end{document}")
    if stop < 0:
        raise InputError(f"{name}: \\end{{document}} is missing; the file is cut off")
    found = _Scanner(text, name).run(start + len("\\begin{document}"), stop)
    theorems = {m[1]: m[2].strip().lower() for m in _THEOREM.finditer(text, 0, start)}
    displays = [p for p in found if _is_display(p[0])]
    kinds = {**FLOATS, **theorems}
    others = [(kinds[p[0]], *p[1:]) for p in found if p[0] in kinds]
    return Source(
        tuple(_piece(text, p, n, f"d{n:02d}", True) for n, p in enumerate(displays, start=1)),
        tuple(_others(text, others)),
        tuple(
            _running_text(
                text, (start, stop), [p for p in found if _stands_apart(p[0], kinds)], words
            )
        ),
    )


def _stands_apart(name: str, kinds: dict[str, str]) -> bool:
    return _is_display(name) or name in kinds


def _running_text(
    text: str, body: tuple[int, int], apart: list[_Found], words: Sequence[str]
) -> Iterator[Piece]:
    """Yield lines outside displays, floats and theorems with a formula or one of the words."""
    masked = [*text]
    for _, start, stop in apart:
        masked[start:stop] = ["\n" if c == "\n" else " " for c in text[start:stop]]
    marking = re.compile(rf"\b(?:{'|'.join(map(re.escape, words))})" if words else r"(?!)", re.I)
    first = text.count("\n", 0, body[0]) + 1
    for n, line in enumerate("".join(masked)[body[0] : body[1]].split("\n"), first):
        cleaned = _body(line)
        if _HEADING.match(cleaned):
            continue
        if _FORMULA.search(cleaned) or (
            marking.search(cleaned) and not cleaned.startswith("\\bibitem")
        ):
            yield Piece("text", f"line{n}", n, n, cleaned)


_Found = tuple[str, int, int]


def _others(text: str, others: list[_Found]) -> list[Piece]:
    """Yield the numbered pieces; without a label they are named by kind and position."""
    counts: dict[str, int] = {}
    pieces = []
    for kind, start, stop in others:
        counts[kind] = counts.get(kind, 0) + 1
        number = counts[kind]
        pieces.append(_piece(text, (kind, start, stop), number, f"{kind}{number}", False))
    return pieces


def _piece(text: str, found: _Found, number: int, unnamed: str, display: bool) -> Piece:
    kind, start, stop = found
    body = _COMMENT.sub(r"\1", text[start:stop])
    # A theorem's own label stands outside the displays in it.
    label = LABEL.search(body if display else _INNER_DISPLAY.sub("", body))
    return Piece(
        kind,
        label[1].strip() if label else unnamed,
        text.count("\n", 0, start) + 1,
        text.count("\n", 0, stop) + 1,
        " ".join(body.split()),
        number if display else None,
    )


class _Scanner:
    """A single pass over the body, with a stack of the environments around the displays."""

    def __init__(self, text: str, name: str) -> None:
        self.text = _COMMENT.sub(lambda m: m[1] + re.sub(r"[^\n]", " ", m[0][len(m[1]) :]), text)
        self.name = name
        self.stack: list[tuple[str, int, int]] = []
        self.found: list[_Found] = []

    def run(self, at: int, stop: int) -> list[_Found]:
        while (mark := _MARKS.search(self.text, at, stop)) is not None:
            at = mark.end()
            if kind := display_at(mark):
                end, after = self.end_of(kind, mark.start(), at, stop)
                self.found.append((kind, at, end))
                at = after
            elif mark["formula"]:
                at = self.end_of_formula(mark.start(), stop)
            elif mark["begin"]:
                self.stack.append((mark["begin"], self.line(mark.start()), at))
            elif mark["end"] or mark["close"]:
                self.close(mark)
        if self.stack:
            name, line, _ = self.stack[-1]
            self.fail(f"\\begin{{{name}}}, opened in line {line}, is not closed")
        return sorted(self.found, key=lambda found: found[1])

    def end_of(self, kind: str, start: int, at: int, stop: int) -> tuple[int, int]:
        """Return where a display ends, and where to continue."""
        opened = f"{self.text[start:at]}, opened in line {self.line(start)},"
        try:
            end, after = end_of_display(self.text, kind, at, stop)
        except NotClosedError:
            end = stop
        for mark in _MARKS.finditer(self.text, at, end):
            if display_at(mark) and kind != "dollars":
                self.fail(f"{opened} is open in line {self.line(mark.start())}")
            if end == stop and mark["end"] and kind != "dollars":
                self.fail(
                    f"line {self.line(mark.start())}: {mark[0]} where {opened} is to be closed"
                )
            if end == stop and mark["formula"] and kind == "dollars":
                self.fail(f"line {self.line(mark.start())}: $$ is closed by a single $")
        if end == stop:
            self.fail(f"{opened} is not closed")
        if problem := unbalanced(self.text[at:end]):
            self.fail(f"line {self.line(start)}: {problem}")
        return end, after

    def end_of_formula(self, start: int, stop: int) -> int:
        """Return where the formula ends that a ``$`` opens; no display may begin in it."""
        for mark in _MARKS.finditer(self.text, start + 1, stop):
            if mark["formula"] or mark["dollars"]:
                return mark.start() + 1
            if display_at(mark):
                break
        self.fail(f"the formula $, opened in line {self.line(start)}, is not closed")

    def close(self, mark: re.Match[str]) -> None:
        """Close the innermost environment."""
        shown = f"line {self.line(mark.start())}: {mark[0]}"
        if not self.stack or mark["close"]:
            self.fail(f"{shown} closes nothing")
        last, line, start = self.stack.pop()
        if last != mark["end"]:
            self.fail(f"{shown} where \\begin{{{last}}}, opened in line {line}, is to be closed")
        self.found.append((last, start, mark.start()))

    def line(self, at: int) -> int:
        return self.text.count("\n", 0, at) + 1

    def fail(self, why: str) -> NoReturn:
        raise InputError(f"{self.name}: {why}")


def _is_display(name: str) -> bool:
    return name in DISPLAYS or name in ("brackets", "dollars")
