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
from pathlib import Path
from typing import NoReturn

from tresym.reals.numbers.exact import InputError

MAX_BYTES = 10_000_000

DISPLAYS = frozenset(
    name + star
    for name in ("equation", "displaymath", "align", "gather", "multline", "eqnarray")
    for star in ("", "*")
)
FLOATS = {"table": "table", "table*": "table", "figure": "figure", "figure*": "figure"}

ENCODINGS = {
    "utf8": "utf-8",
    "utf8x": "utf-8",
    "ascii": "ascii",
    "latin1": "iso8859-1",
    "latin2": "iso8859-2",
    "latin9": "iso8859-15",
    "ansinew": "cp1252",
    "applemac": "mac-roman",
    "cp1250": "cp1250",
    "cp1252": "cp1252",
}
"""Encodings as the package inputenc names them, and as Python does."""

_MARKS = re.compile(
    r"""(?P<comment>%[^\n]*)
      | \\begin\s*\{(?P<begin>[^{}\s]+)\}
      | \\end\s*\{(?P<end>[^{}\s]+)\}
      | (?P<open>\\\[) | (?P<close>\\\])
      | (?P<escaped>\\[^a-zA-Z]|\\[a-zA-Z]+)
      | (?P<dollars>\$\$?)""",
    re.VERBOSE | re.DOTALL,
)
_COMMENT = re.compile(r"(?<!\\)((?:\\\\)*)%[^\n]*(?:\n|$)")
_INNER_DISPLAY = re.compile(r"\\begin\{equation\}.*?\\end\{equation\}", re.DOTALL)
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
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


def read_source(path: Path) -> str:
    """Return the text of a LaTeX document, with line ends as newlines.

    UTF-8 is tried first, then the encoding that the file declares with inputenc.

    Args:
        path: the file.

    Raises:
        InputError: the file does not exist, is too large, is not text, cannot be decoded, or is not
            a LaTeX document.
    """
    text = read_text(path)
    if "\\begin{document}" not in text:
        raise InputError(f"{path}: no \\begin{{document}} in it; a LaTeX source is expected")
    return text


def read_text(path: Path) -> str:
    """Return the text of a LaTeX file that need not be a complete document; see `read_source`."""
    text = _decoded(_bytes(path), path)
    return text.replace("\r\n", "\n").replace("\r", "\n")


def _bytes(path: Path) -> bytes:
    try:
        if path.exists() and not path.is_file() and not path.is_dir():
            raise InputError(f"{path}: is no regular file; a pipe may never end")
        with open(path, "rb") as file:
            data = file.read(MAX_BYTES + 1)
    except (FileNotFoundError, ValueError):  # the latter for a NUL in its name
        raise InputError(f"{path}: no such file") from None
    except OSError as error:
        raise InputError(f"{path}: cannot be read ({error.strerror})") from None
    if len(data) > MAX_BYTES:
        raise InputError(f"{path}: larger than {MAX_BYTES // 1_000_000} MB; no paper is")
    return data


def _decoded(data: bytes, path: Path) -> str:
    if data.startswith((b"\xff\xfe", b"\xfe\xff")):
        return _decode(data, "utf-16", path)
    if b"\0" in data:
        raise InputError(f"{path}: holds NUL bytes; a LaTeX source is text")
    try:
        return data.decode("utf-8-sig")
    except UnicodeDecodeError:
        declared = re.search(rb"\\usepackage\s*\[(\w+)\]\s*\{inputenc\}", data)
        if declared is None:
            raise InputError(
                f"{path}: is not UTF-8 and declares no encoding; "
                "add \\usepackage[latin1]{inputenc}, or whichever it is"
            ) from None
    name = declared[1].decode("ascii")
    if name not in ENCODINGS:
        raise InputError(f"{path}: the encoding {name} is not known; save the file as UTF-8")
    return _decode(data, ENCODINGS[name], path)


def _decode(data: bytes, encoding: str, path: Path) -> str:
    try:
        return data.decode(encoding)
    except UnicodeDecodeError as error:
        line = data.count(b"\n", 0, error.start) + 1
        raise InputError(f"{path}: line {line} is not {encoding}; save the file as UTF-8") from None


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
    label = _LABEL.search(body if display else _INNER_DISPLAY.sub("", body))
    return Piece(
        kind,
        label[1].strip() if label else unnamed,
        text.count("\n", 0, start) + 1,
        text.count("\n", 0, stop) + 1,
        " ".join(body.split()),
        number if display else None,
    )


class _Scanner:
    """A single pass over the body; keeps a stack of open environments and a list of closed ones."""

    def __init__(self, text: str, name: str) -> None:
        self.text = text
        self.name = name
        self.stack: list[tuple[str, int, int]] = []
        self.found: list[_Found] = []

    def run(self, at: int, stop: int) -> list[_Found]:
        while (mark := _MARKS.search(self.text, at, stop)) is not None:
            at = mark.end()
            if mark["dollars"]:
                at = self.dollars(mark["dollars"], mark.start())
            elif opened := mark["begin"] or (mark["open"] and "brackets"):
                self.open(opened, mark.start(), at)
            elif closed := mark["end"] or (mark["close"] and "brackets"):
                self.close(closed, mark.start())
        if self.stack:
            name, line, _ = self.stack[-1]
            self.fail(f"{_shown(name)}, opened in line {line}, is not closed")
        return sorted(self.found, key=lambda found: found[1])

    def dollars(self, signs: str, at: int) -> int:
        """Handle ``$`` (inline formula) and ``$$`` (display); return the next position."""
        inside = self.stack[-1][0] if self.stack else ""
        if inside == "$":
            self.close("$", at)
            return at + 1
        if inside != "dollars":
            self.open("$" if signs == "$" else "dollars", at, at + len(signs))
        elif signs == "$":
            self.fail(f"line {self.line(at)}: $$ is closed by a single $")
        else:
            self.close("dollars", at)
        return at + len(signs)

    def open(self, name: str, at: int, start: int) -> None:
        """Open ``name``; a display inside an inline formula means that that was not closed."""
        line = self.line(at)
        around = [o for o in self.stack if o[0] == "$" or _is_display(o[0])]
        if around and _is_display(name):
            self.fail(
                f"{_shown(around[0][0])}, opened in line {around[0][1]}, is open in line {line}"
            )
        self.stack.append((name, line, start))

    def close(self, name: str, at: int) -> None:
        shown = f"line {self.line(at)}: {_shown(name, closing=True)}"
        if not self.stack:
            self.fail(f"{shown} closes nothing")
        last, line, start = self.stack.pop()
        if last != name:
            self.fail(f"{shown} where {_shown(last)}, opened in line {line}, is to be closed")
        if name != "$":
            self.found.append((name, start, at))

    def line(self, at: int) -> int:
        return self.text.count("\n", 0, at) + 1

    def fail(self, why: str) -> NoReturn:
        raise InputError(f"{self.name}: {why}")


def _is_display(name: str) -> bool:
    return name in DISPLAYS or name in ("brackets", "dollars")


def _shown(name: str, closing: bool = False) -> str:
    """Return an environment or delimiter as the author wrote it."""
    if name == "brackets":
        return "\\]" if closing else "\\["
    if name == "dollars":
        return "$$"
    if name == "$":
        return "the formula $"
    return f"\\{'end' if closing else 'begin'}{{{name}}}"
