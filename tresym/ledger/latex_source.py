"""LaTeX sources: their text, and where their displays and environments begin and end.

The audit of a paper and the reader of manuscripts walk over the same marks. In ``\\[ x = 1 \\]``
the first mark opens a display; :func:`end_of_display` says where it ends, and :func:`unbalanced`
what is wrong with the environments in it.
"""

from __future__ import annotations

import re
from pathlib import Path

from tresym.reals.numbers.exact import InputError

MAX_BYTES = 10_000_000
DISPLAYS = frozenset(
    name + star
    for name in (
        *("equation", "displaymath", "align", "gather", "multline", "eqnarray", "flalign"),
        *("alignat", "dmath", "xalignat", "math"),
    )
    for star in ("", "*")
)
"""Environments that are displays; ``\\[`` opens the display ``brackets``, ``$$`` ``dollars``."""
LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
MARKS = r"""\\begin\s*\{(?P<begin>[^{}\s]+)\}
      | \\end\s*\{(?P<end>[^{}\s]+)\}
      | (?P<open>\\\[)
      | (?P<dollars>\$\$)"""
"""What opens and ends environments, and opens displays: a part of a verbose pattern."""
_CLOSING_BRACKET = re.compile(r"\\\\|\\\]")
_BEGIN = re.compile(r"\\begin\{([^{}]*)\}")
_ENVIRONMENT = re.compile(r"\\(begin|end)\s*\{([^{}]*)\}")
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


class NotClosedError(Exception):
    """A display is not closed; the message says of what kind it is."""


def display_at(mark: re.Match[str]) -> str:
    """Return the kind of display that a mark opens; empty if it opens none."""
    if mark["begin"] in DISPLAYS:
        return mark["begin"]
    return "brackets" if mark["open"] else "dollars" if mark["dollars"] else ""


def end_of_display(text: str, kind: str, at: int, stop: int) -> tuple[int, int]:
    """Return where the display whose text begins at ``at`` ends, and where the text goes on.

    Markdown has displays inside ``$$``, which are then parts of that display.

    Raises:
        NotClosedError: it is not closed before ``stop``, or before the next display.
    """
    if kind == "brackets":
        ends = (m for m in _CLOSING_BRACKET.finditer(text, at, stop) if m[0] == "\\]")
        found = next(ends, None)
        end, after = found.span() if found else (-1, -1)
    else:
        closing = "$$" if kind == "dollars" else f"\\end{{{kind}}}"
        end = text.find(closing, at, stop)
        after = end + len(closing)
    if end < 0:
        raise NotClosedError(f"the display ({kind}) is not closed")
    inner = [mark[1] for mark in _BEGIN.finditer(text, at, end) if mark[1] in DISPLAYS]
    if kind in ("dollars", "brackets") and not unbalanced(text[at:end]):
        inner = []
    if inner:
        raise NotClosedError(f"the display ({kind}) is not closed before the next one")
    return end, after


def unbalanced(text: str) -> str:
    """Return what is wrong with the environments in the text of a display; empty if nothing is."""
    opened: list[str] = []
    for mark in _ENVIRONMENT.finditer(text):
        if mark[1] == "begin":
            opened.append(mark[2])
        elif not opened or opened.pop() != mark[2]:
            return f"\\end{{{mark[2]}}} closes nothing in the display"
    return f"\\begin{{{opened[-1]}}} is not closed in the display" if opened else ""


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


def read_any_text(path: Path) -> tuple[str, bool]:
    """Return the text of a LaTeX file as `read_text` does, and whether its encoding was guessed.

    One that is not UTF-8 and declares no encoding is read as Latin-1, in which each byte is a
    character: a wrong guess changes letters with accents, not formulas.
    """
    try:
        return read_text(path), False
    except _UndeclaredError:
        text = _bytes(path).decode("latin-1")
    return text.replace("\r\n", "\n").replace("\r", "\n"), True


class _UndeclaredError(InputError):
    """A file that is not UTF-8 declares no encoding."""


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
            raise _UndeclaredError(
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
