"""The files of a manuscript as one text: inputs, conditionals, comments, and notes in comments.

``\\input``, ``\\include`` and ``\\subfile`` are followed inside the project: the nearest folder
with one of ``PROJECT`` in it, or the manuscript's own folder. Of a conditional that ``\\newif``
declares, and of ``\\iftrue`` and ``\\iffalse``, the branch that TeX takes is read. The macros of
the author's own packages are read, and for a chapter alone those of the main file that inputs it.
"""

from __future__ import annotations

import os
import re
from bisect import bisect_right
from collections.abc import Iterator
from contextlib import suppress
from itertools import islice
from pathlib import Path
from typing import NamedTuple

from tresym.ledger.latex_source import read_any_text, read_text
from tresym.manuscript.macros import DEFINITIONS, definition
from tresym.manuscript.markdown import as_latex, is_markdown, markdown_cells
from tresym.reals.numbers.exact import InputError

MAX_CHARACTERS = 20_000_000
MAX_FILES = 500
MAX_DEPTH = 4
"""Folders around a chapter in which its main file is sought, and inputs in inputs there."""
MAX_PREAMBLE = 400_000
PROJECT = (".git", "latexmkrc", ".latexmkrc", "pyproject.toml")
"""Files and folders that mark the top folder of a project."""
_HIDDEN = re.compile(
    r"""(?P<verbatim>\\begin\{(?P<name>verbatim\*?|lstlisting|minted|comment|filecontents\*?)\}
          .*? (?:\\end\{(?P=name)\}|\Z))
      | (?P<verb>\\(?:verb\*?|lstinline)(?P<bar>[^a-zA-Z\s*{\[])[^\n]*?(?P=bar))
      | (?P<url>\\(?:url|href|path)\s*\{[^{}\n]*\})
      | (?P<command>\\(?:[a-zA-Z]+|.))
      | %(?P<comment>[^\n]*)""",
    re.VERBOSE | re.DOTALL,
)
_NOTE = re.compile(r"\s*tresym:\s*(.*)", re.IGNORECASE)
_INPUT = re.compile(r"\\(?:input|include|subfile)(?![a-zA-Z])\s*(?:\{\s*([^{}]*?)\s*\}|([\w./-]+))")
_PACKAGES = re.compile(r"\\(?:usepackage|RequirePackage)\s*(?:\[[^\[\]]*\]\s*)?\{([\w./,\s-]*)\}")
_SUBFILE = re.compile(r"\\documentclass\s*\[\s*([^\[\]]*?)\s*\]\s*\{subfiles\}")
_BODY = re.compile(r"\\begin\s*\{document\}(.*?)(?:\\end\s*\{document\}|\Z)", re.DOTALL)
_CONDITIONAL = re.compile(
    r"\\(?:newif\s*\\if(?P<new>[a-zA-Z@]+)|if(?P<name>[a-zA-Z@]*)|(?P<turn>else|fi)"
    r"|(?P<set>[a-zA-Z@]+)(?P<value>true|false))(?![a-zA-Z@])"
)
_PRIMITIVES = frozenset(
    (
        *("", "x", "num", "dim", "odd", "cat", "case", "defined", "csname", "mmode", "vmode"),
        *("hmode", "inner", "void", "hbox", "vbox", "eof"),
    )
)
"""Conditionals of TeX that end in ``\\fi`` and are not evaluated."""
_OPENS = re.compile(r"\\begin\s*\{|\\end\s*\{|\\\[|\\\]|\$\$")


class Note(NamedTuple):
    """A directive: a comment ``% tresym: …`` of the author's, and its place."""

    text: str
    file: str
    line: int


def _resolved(path: Path, main: Path) -> Path:
    """Return a path without symbolic links.

    Raises:
        InputError: the links lead back to themselves.
    """
    try:
        return path.resolve()
    except (OSError, RuntimeError):
        raise InputError(f"{main}: cannot be read (a loop of symbolic links)") from None


class Files:
    """The text of all files, the origin of its lines, and the directives in its comments.

    Attributes:
        missing: input files that do not exist in the project, such as those of TeX packages.
        outside: input files outside the project, which are not read.
        guessed: files read as Latin-1, which are not UTF-8 and declare no encoding.
    """

    def __init__(self, path: Path, root: Path | None = None, text: str | None = None) -> None:
        """Read all files; ``text`` replaces the contents of the first, as in an editor."""
        self._unsaved = text
        self.path, self.folder = path, _resolved(path, path).parent
        self.root = _project(self.folder) if root is None else root.resolve()
        if not self.folder.is_relative_to(self.root):
            raise InputError(f"{path}: is not in the folder {root}")
        self.notes: list[Note] = []
        self.missing: list[str] = []
        self.outside: list[str] = []
        self.guessed: list[str] = []
        self.parts: list[tuple[str, int, str]] = []
        self.size = 0
        self._add_macros_around()
        self._add(path, ())
        self._write_out_environments()
        self.text = _taken("".join(text for _, _, text in self.parts))
        self._starts: list[int] = []
        self._places: list[tuple[str, int]] = []
        offset = 0
        for file, line, text in self.parts:
            self._starts.append(offset)
            self._places.append((file, line))
            for end in re.finditer(r"\n", text):
                line += 1
                self._starts.append(offset + end.end())
                self._places.append((file, line))
            offset += len(text)

    def place(self, at: int) -> tuple[str, int]:
        """Return the file and the line of a position in the text."""
        return self._places[bisect_right(self._starts, at) - 1]

    def _add(self, path: Path, around: tuple[Path, ...], preamble: bool = False) -> None:
        """Add a file and its inputs: the body of an input file, or only the preamble of the main
        file that a subfile names."""
        here = _resolved(path, self.path)
        shown = "" if not around else os.path.relpath(here, self.folder)
        if here in around:
            self.missing.append(f"{shown or path} in itself")
            return
        unsaved = None if around or preamble else self._unsaved
        text = self._read(path) if unsaved is None else unsaved
        if path.suffix == ".ipynb":
            text = markdown_cells(text, str(path))
        page = is_markdown(path.suffix) or path.suffix == ".ipynb"
        text = self._visible(as_latex(text) if page else text, shown)
        self.size += len(text)
        if self.size > MAX_CHARACTERS or len(self.parts) > MAX_FILES:
            raise InputError(f"{self.path}: it is too large with the files that it includes")
        body = _BODY.search(text)
        start, stop = 0, len(text)
        if body is not None and preamble:
            stop = body.start()
        elif body is not None and around:
            start, stop = body.span(1)
        main = None if around else _SUBFILE.search(text)
        if main is not None and (found := self._included(main[1], here.parent)) is not None:
            self._add(found, (here,), preamble=True)
        for mark in _INPUT.finditer(text, start, stop):
            found = self._included(mark[1] or mark[2] or "", here.parent)
            if found is None:
                continue
            self._part(shown, text, start, mark.start())
            self._add(found, (*around, here))
            start = mark.end()
        self._part(shown, text, start, stop)

    def _read(self, path: Path) -> str:
        text, guessed = read_any_text(path)
        if guessed and path.name not in self.guessed:
            self.guessed.append(path.name)
        return text

    def _add_macros_around(self) -> None:
        """Add the macros of the author's packages; of a chapter that is read alone, those of the
        main file that inputs it."""
        text = self._read(self.path) if self._unsaved is None else self._unsaved
        if "\\documentclass" in text or "\\begin{document}" in text:
            made = self._definitions(self.path, text, True)
        else:
            main = next(self._main_files(), None)
            made = "" if main is None else self._definitions(main, _text_of(main))
        if made:
            self.parts.append(("", 0, made + "\n"))

    def _main_files(self) -> Iterator[Path]:
        """The main files that input this one, from its own folder outwards."""
        own = _resolved(self.path, self.path)
        folders = (f for f in (self.folder, *self.folder.parents) if f.is_relative_to(self.root))
        for folder in islice(folders, MAX_DEPTH):
            for main in sorted(folder.glob("*.tex"))[:MAX_FILES]:
                try:
                    text = "" if main.resolve() == own else _shown(_text_of(main))
                except (OSError, RuntimeError):  # symbolic links that lead back to themselves
                    self.missing.append(str(main.relative_to(folder)))
                    continue
                if "\\documentclass" in text and "\\begin{document}" in text:
                    names = (mark[1] or mark[2] or "" for mark in _INPUT.finditer(text))
                    if any(
                        (folder / name).with_suffix("") == own.with_suffix("") for name in names
                    ):
                        yield main

    def _definitions(
        self, path: Path, text: str, packages: bool = False, depth: int = MAX_DEPTH
    ) -> str:
        """The definitions before the document of a file, and of what it inputs there.

        Args:
            packages: only those of the author's packages.
        """
        text = _shown(text).partition("\\begin{document}")[0]
        names = [
            f"{name.strip()}.sty" for m in _PACKAGES.finditer(text) for name in m[1].split(",")
        ]
        for mark in () if packages else _INPUT.finditer(text):
            name = mark[1] or mark[2] or ""
            names += [name, f"{name}.tex"]
        made = []
        for name in names if depth else ():
            try:
                file = (path.parent / name).resolve()
            except (OSError, RuntimeError, ValueError):
                continue
            if file.is_relative_to(self.root) and file.is_file():
                made.append(self._definitions(file, _text_of(file), False, depth - 1))
        for command in () if packages else DEFINITIONS.finditer(text):
            with suppress(InputError):
                found, end = definition(text, command)
                written = " ".join(text[command.start() : end].split())
                itself = any((macro.body or "").count(name) for name, macro in found.items())
                if not (itself or "@" in written or command[0] == "\\let"):
                    made.append(written)  # what TeX does inside is left out, as it may not end
        return " ".join(made)

    def _part(self, file: str, text: str, start: int, end: int) -> None:
        self.parts.append((file, text.count("\n", 0, start) + 1, text[start:end]))

    def _included(self, name: str, beside: Path) -> Path | None:
        """Return the file of that name; None if the project has none, as for a TeX package."""
        outside = False
        for folder in dict.fromkeys((self.folder, beside, self.root)):
            for ending in ("", ".tex"):
                try:
                    found = (folder / (name + ending)).resolve()
                    inside = found.is_relative_to(self.root)
                    if inside and found.is_file():
                        return found
                except (OSError, ValueError):
                    continue
                outside = outside or not inside
        (self.outside if outside else self.missing).append(name)
        return None

    def _visible(self, text: str, file: str) -> str:
        """Return the text without comments and verbatim text, with a mark for each directive.

        Line breaks stay, so that line numbers remain correct.
        """
        text = text.replace("\x01", " ").replace("\x02", " ")
        lines = _Lines(text)

        def replaced(found: re.Match[str]) -> str:
            if found["command"]:
                return found[0]
            if found["comment"] is None:
                return "\n" * found[0].count("\n")
            note = _NOTE.fullmatch(found["comment"])
            if note is None:
                return ""
            self.notes.append(Note(note[1].strip(), file, lines.at(found.start())))
            return f"\x01{len(self.notes) - 1}\x02"

        return _HIDDEN.sub(replaced, text)

    def _write_out_environments(self) -> None:
        """Expand the macros that open or close displays, as ``\\be`` and ``\\ee`` do."""
        found: dict[str, str] = {}
        for _, _, text in self.parts:
            for command in DEFINITIONS.finditer(text):
                try:
                    made, _ = definition(text, command)
                except InputError:
                    continue  # the scanner tells of it
                for name, macro in made.items():
                    body = " ".join((macro.body or "").split())
                    itself = re.search(rf"{re.escape(name)}(?![a-zA-Z])", body)
                    if macro.takes == 0 and not itself and _OPENS.search(body):
                        found[name] = body
        if not found:
            return
        names = "|".join(map(re.escape, sorted(found, key=len, reverse=True)))
        uses = re.compile(
            rf"(?<![\\{{])(?:{names})(?![a-zA-Z])(?!\s*\}}?\s*[\[{{]\s*\\(?:begin|end))"
        )
        self.parts = [
            (file, line, uses.sub(lambda use: found[use[0]], text))
            for file, line, text in self.parts
        ]


class _Lines:
    """Line numbers of a text, for increasing positions."""

    def __init__(self, text: str) -> None:
        self.text, self.seen, self.line = text, 0, 1

    def at(self, place: int) -> int:
        self.line += self.text.count("\n", self.seen, place)
        self.seen = place
        return self.line


def _text_of(path: Path) -> str:
    """What a file holds; nothing where it cannot be read as text."""
    with suppress(InputError, OSError, ValueError):
        return read_text(path) if path.stat().st_size < MAX_PREAMBLE else ""
    return ""


def _shown(text: str) -> str:
    """The text without comments and verbatim text."""
    return _HIDDEN.sub(lambda found: found["command"] or "", text)


def _project(folder: Path) -> Path:
    """Return the nearest folder upwards that is the top of a project, else the folder itself."""
    around = (one for one in (folder, *folder.parents) if any((one / p).exists() for p in PROJECT))
    return next(around, folder)


def _taken(text: str) -> str:
    """Return the text with blanks for the branches of conditionals that TeX does not take."""
    flags = {"true": True, "false": False}
    open_: list[bool | None] = []  # for each open conditional: whether its branch is taken
    kept: list[str] = []
    at = 0
    for mark in _CONDITIONAL.finditer(text):
        off = False in open_
        kept.append(_blank(text[at : mark.start()]) if off else text[at : mark.start()])
        at = mark.end()
        known = True
        if mark["new"]:
            flags.setdefault(mark["new"], False)
        elif mark["set"]:
            known = mark["set"] in flags
            if known and not off:
                flags[mark["set"]] = mark["value"] == "true"
        elif mark["turn"]:
            known = bool(open_) and open_[-1] is not None
            if open_ and mark["turn"] == "fi":
                open_.pop()
            elif known:
                open_[-1] = not open_[-1]
        elif mark["name"] in flags or mark["name"] in _PRIMITIVES:
            open_.append(flags.get(mark["name"]))
            known = mark["name"] in flags
        else:
            known = False
        kept.append(_blank(mark[0]) if known or off else mark[0])
    rest = text[at:]
    return "".join(kept) + (_blank(rest) if False in open_ else rest)


def _blank(text: str) -> str:
    return re.sub(r"[^\n]", " ", text)
