"""The surface of a manuscript: its files, comments, macros, and the displays in its prose.

Nothing is typeset. ``\\input`` is followed inside the folder of the manuscript, comments that begin
with ``tresym:`` are kept as notes to the reader, verbatim text is passed over, and the author's
macros are written out.
"""

from __future__ import annotations

import hashlib
import re
from bisect import bisect_right
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, NoReturn, TypeAlias

from tresym.ledger.audit.source import read_text
from tresym.manuscript.macros import DEFINITIONS, Macro, definition, group, written_out
from tresym.reals.numbers.exact import InputError

MAX_CHARACTERS = 20_000_000
MAX_DISPLAY = 20_000
MAX_BRACES = 100
MAX_FILES = 500
MAX_DISPLAYS = 5000

DISPLAYS = frozenset(
    name + star
    for name in (
        *("equation", "displaymath", "align", "gather", "multline", "eqnarray", "flalign"),
        *("alignat", "dmath", "xalignat", "math"),
    )
    for star in ("", "*")
)
SCOPES = frozenset(("proof", "example", "exercise", "problem", "solution"))
"""What is put in one of these is not said beyond it."""
STATEMENTS = frozenset(("theorem", "lemma", "proposition", "corollary"))
"""What one of these defines is not said beyond the section."""
_SCOPED = SCOPES | STATEMENTS
_TITLE = re.compile(r"\*?\s*(?:\[[^\[\]]*\])?\s*\{(?:[^{}]|\{[^{}]*\})*\}")
_HIDDEN = re.compile(
    r"""(?P<verbatim>\\begin\{(?P<name>verbatim\*?|lstlisting|minted|comment|filecontents\*?)\}
          .*? (?:\\end\{(?P=name)\}|\Z))
      | (?P<verb>\\(?:verb\*?|lstinline)(?P<bar>[^a-zA-Z\s*{\[])[^\n]*?(?P=bar))
      | (?P<url>\\(?:url|href|path)\s*\{[^{}\n]*\})
      | (?P<off>\\iffalse(?![a-zA-Z]).*?(?:\\fi(?![a-zA-Z])|\Z))
      | (?P<command>\\(?:[a-zA-Z]+|.))
      | %(?P<comment>[^\n]*)""",
    re.VERBOSE | re.DOTALL,
)
_NOTE = re.compile(r"\s*tresym:\s*(.*)", re.IGNORECASE)
_MARKED = re.compile(r"\x01(\d+)\x02")
_INPUT = re.compile(r"\\(?:input|include|subfile)(?![a-zA-Z])\s*(?:\{\s*([^{}]*?)\s*\}|([\w./-]+))")
_MARKS = re.compile(
    r"""\\begin\s*\{(?P<begin>[^{}\s]+)\}
      | \\end\s*\{(?P<end>[^{}\s]+)\}
      | (?P<open>\\\[)
      | (?P<dollars>\$\$)
      | (?P<section>\\(?:chapter|section|subsection|part|appendix)(?![a-zA-Z]))
      | \x01(?P<note>\d+)\x02
      | (?P<command>\\(?:[a-zA-Z]+|.))
      | (?P<inline>\$)""",
    re.VERBOSE | re.DOTALL,
)
_CLOSED = re.compile(r"\\\\|\\\]")
_LABEL = re.compile(r"\\label\s*\{([^{}]*)\}")
_ENVIRONMENT = re.compile(r"\\(begin|end)\s*\{([^{}]*)\}")
_OPENS = re.compile(r"\\begin\s*\{|\\end\s*\{|\\\[|\\\]|\$\$")


class Note(NamedTuple):
    """A comment ``% tresym: …`` of the author's, and where it stands."""

    text: str
    file: str
    line: int


class Section(NamedTuple):
    """A heading: conditions of the section before it are forgotten."""

    line: int


class Scope(NamedTuple):
    """Where a proof or an example opens or ends: what is said in it is forgotten after it.

    Attributes:
        stated: it is a theorem: what is defined in it is forgotten after the section.
    """

    opens: bool
    stated: bool = False


class Prose(NamedTuple):
    """What stands between displays."""

    text: str


@dataclass(frozen=True)
class Display:
    """A display, as it is to be read.

    Attributes:
        number: its place in the manuscript, from 1.
        kind: the environment, ``brackets`` or ``dollars``.
        label: its labels, in order.
        file: nothing for the manuscript itself, else the file that it includes.
        line: its first line there.
        text: between the delimiters, macros written out.
        problem: why it cannot be written out, if so.
        notes: those that stand in it.
    """

    number: int
    kind: str
    labels: tuple[str, ...]
    file: str
    line: int
    text: str = field(repr=False)
    problem: str = ""
    notes: tuple[Note, ...] = ()

    @property
    def sha256(self) -> str:
        """Of the text with white space made single spaces."""
        return hashlib.sha256(" ".join(self.text.split()).encode()).hexdigest()


class Missing(NamedTuple):
    """A file that is included and not there, as of a package of TeX."""

    name: str


Event: TypeAlias = Note | Section | Scope | Prose | Display | Missing


def read_manuscript(path: Path) -> list[Event]:
    """What a manuscript holds, in order, and first which files it lacks.

    Raises:
        InputError: it cannot be read, is not closed, includes itself or files outside its folder,
            or holds no display; one line says which.
    """
    source = _Source(path)
    events = [*map(Missing, source.missing), *_Scanner(source).events()]
    if not any(isinstance(event, Display) for event in events):
        raise InputError(f"{path}: no display in it; write formulas in equation, align or \\[ \\]")
    return events


class _Source:
    """The text of all files, where its lines come from, and the notes in its comments."""

    def __init__(self, path: Path) -> None:
        self.path, self.folder = path, path.resolve().parent
        self.notes: list[Note] = []
        self.missing: list[str] = []
        self.parts: list[tuple[str, int, str]] = []
        self.size = 0
        self._add(path, ())
        self._write_out_environments()
        self.text = "".join(text for _, _, text in self.parts)
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
        """The file and the line of a place in the text."""
        return self._places[bisect_right(self._starts, at) - 1]

    def _add(self, path: Path, around: tuple[Path, ...]) -> None:
        here = path.resolve()
        shown = "" if not around else str(here.relative_to(self.folder))
        if here in around:
            raise InputError(f"{self.path}: {shown or path} includes itself")
        text = self._visible(read_text(path), shown)
        self.size += len(text)
        if self.size > MAX_CHARACTERS or len(self.parts) > MAX_FILES:
            raise InputError(f"{self.path}: with all that it includes it is beyond all bounds")
        start = 0
        for mark in _INPUT.finditer(text):
            name = mark[1] or mark[2] or ""
            found = self._included(name, around)
            if found is None:
                continue
            self._part(shown, text, start, mark.start())
            self._add(found, (*around, here))
            start = mark.end()
        self._part(shown, text, start, len(text))

    def _part(self, file: str, text: str, start: int, end: int) -> None:
        self.parts.append((file, text.count("\n", 0, start) + 1, text[start:end]))

    def _included(self, name: str, around: tuple[Path, ...]) -> Path | None:
        """The file of that name, None where there is none, as of a package of TeX."""
        for ending in ("", ".tex"):
            try:
                found = (self.folder / (name + ending)).resolve()
                is_file = found.is_file()
            except (OSError, ValueError):
                continue
            if not found.is_relative_to(self.folder):
                raise InputError(f"{self.path}: \\input{{{name[:100]}}} leads out of its folder")
            if is_file:
                return found
        self.missing.append(name)
        return None

    def _visible(self, text: str, file: str) -> str:
        """Without comments and verbatim text; each note is a mark, and every line stays."""
        if "\x01" in text or "\x02" in text:
            raise InputError(f"{file or self.path}: holds control characters; LaTeX is text")
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
        """Write out the macros that open or close displays, as ``\\be`` and ``\\ee`` do."""
        found: dict[str, str] = {}
        for _, _, text in self.parts:
            for command in DEFINITIONS.finditer(text):
                try:
                    made, _ = definition(text, command)
                except InputError as error:
                    raise InputError(f"{self.path}: {command[0]}: {error}") from None
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
    """The lines of a text, asked for from first to last."""

    def __init__(self, text: str) -> None:
        self.text, self.seen, self.line = text, 0, 1

    def at(self, place: int) -> int:
        self.line += self.text.count("\n", self.seen, place)
        self.seen = place
        return self.line


class _Scanner:
    """One pass over the text."""

    def __init__(self, source: _Source) -> None:
        self.source, self.text = source, source.text
        self.macros: dict[str, Macro] = {}
        self.count = 0

    def events(self) -> Iterator[Event]:
        """Notes, headings, prose and displays, in order."""
        at = self.text.find("\\begin{document}")
        whole = at >= 0
        if whole:
            self.define(0, at)
        at = at + len("\\begin{document}") if whole else 0
        stop = self.text.find("\\end{document}", at)
        if whole and stop < 0:
            self.fail(at, "\\end{document} is missing; the file is cut off")
        stop = stop if stop >= 0 else len(self.text)
        prose = at
        while (mark := _MARKS.search(self.text, at, stop)) is not None:
            at = mark.end()
            kind = mark["begin"] or ("brackets" if mark["open"] else "")
            kind = kind or ("dollars" if mark["dollars"] else "")
            if mark["command"] and (command := DEFINITIONS.match(self.text, mark.start())):
                at = self.defined(command)
            elif mark["inline"]:
                at = self.inline(at)
            elif mark["section"] or mark["note"]:
                yield self.prose(prose, mark.start())
                prose = at
                if mark["note"]:
                    yield self.source.notes[int(mark["note"])]
                    continue
                yield Section(self.source.place(at)[1])
                if (title := _TITLE.match(self.text, at, stop)) is not None:
                    prose = at = title.end()
            elif kind in DISPLAYS or kind in ("brackets", "dollars"):
                yield self.prose(prose, mark.start())
                display, at = self.display(kind, mark.start(), at, stop)
                prose = at
                yield display
            elif (kind := (kind or mark["end"] or "").rstrip("*").lower()) in _SCOPED:
                yield self.prose(prose, mark.start())
                prose = at
                yield Scope(mark["end"] is None, kind in STATEMENTS)
            elif mark["end"] in DISPLAYS:
                self.fail(mark.start(), f"\\end{{{mark['end']}}} closes nothing")
        yield self.prose(prose, stop)

    def define(self, start: int, stop: int) -> None:
        """The macros that are defined there."""
        at = start
        while (command := DEFINITIONS.search(self.text, at, stop)) is not None:
            at = self.defined(command)

    def defined(self, command: re.Match[str]) -> int:
        try:
            made, end = definition(self.text, command)
        except InputError as error:
            self.fail(command.start(), str(error))
        self.macros |= made
        return end

    def inline(self, at: int) -> int:
        """Step over a formula in the line."""
        end = self.text.find("$", at)
        return end + 1 if 0 <= end < at + MAX_DISPLAY else at

    def prose(self, start: int, stop: int) -> Prose:
        text = self.text[max(start, stop - MAX_DISPLAY) : stop]
        try:
            return Prose(written_out(text, self.macros) if len(text) < MAX_DISPLAY else text)
        except InputError:
            return Prose(text)

    def display(self, kind: str, start: int, at: int, stop: int) -> tuple[Display, int]:
        """The display whose text begins at ``at``, and where to go on."""
        end, after = self.closed(kind, start, at, stop)
        text = self.text[at:end]
        if len(text) > MAX_DISPLAY:
            self.fail(start, f"the display is longer than {MAX_DISPLAY} characters")
        depth = 0
        for mark in re.finditer(r"\\.|[{}]", text):
            depth += (mark[0] == "{") - (mark[0] == "}")
            if not 0 <= depth <= MAX_BRACES:
                break
        if depth > MAX_BRACES:
            self.fail(start, f"braces are nested deeper than {MAX_BRACES} levels in the display")
        if depth:
            self.fail(start, "the braces of the display do not match")
        opened: list[str] = []
        for mark in _ENVIRONMENT.finditer(text):
            if mark[1] == "begin":
                opened.append(mark[2])
            elif not opened or opened.pop() != mark[2]:
                self.fail(start, f"\\end{{{mark[2]}}} closes nothing in the display")
        if opened:
            self.fail(start, f"\\begin{{{opened[-1]}}} is not closed in the display")
        notes = tuple(self.source.notes[int(mark[1])] for mark in _MARKED.finditer(text))
        text = _MARKED.sub("", text)
        if kind.startswith(("alignat", "xalignat")):
            _, past = group(text, 0)
            text = text[past:]
        labels = tuple(label.strip() for label in _LABEL.findall(text))
        problem = ""
        try:
            text = written_out(text, self.macros)
        except InputError as error:
            if "does not end" in str(error):
                self.fail(start, str(error))
            problem = str(error)
        self.count += 1
        if self.count > MAX_DISPLAYS:
            self.fail(start, f"there are more than {MAX_DISPLAYS} displays")
        file, line = self.source.place(start)
        return Display(self.count, kind, labels, file, line, text, problem, notes), after

    def closed(self, kind: str, start: int, at: int, stop: int) -> tuple[int, int]:
        """Where the display ends, and where to go on."""
        if kind == "brackets":
            ends = (m for m in _CLOSED.finditer(self.text, at, stop) if m[0] == "\\]")
            found = next(ends, None)
            end, after = (found.start(), found.end()) if found else (-1, -1)
        else:
            closing = "$$" if kind == "dollars" else f"\\end{{{kind}}}"
            end = self.text.find(closing, at, stop)
            after = end + len(closing)
        if end < 0:
            self.fail(start, f"the display ({kind}) is not closed")
        for mark in re.finditer(r"\\begin\{([^{}]*)\}", self.text[at:end]):
            if mark[1] in DISPLAYS:
                self.fail(start, f"the display ({kind}) is not closed before the next one")
        return end, after

    def fail(self, at: int, why: str) -> NoReturn:
        file, line = self.source.place(at)
        name = self.source.folder / file if file else self.source.path
        raise InputError(f"{name}: line {line}: {why}")
