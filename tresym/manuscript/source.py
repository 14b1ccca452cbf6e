"""The surface of a manuscript: its files, comments, macros, and the displays in its prose.

Nothing is typeset. Comments that begin with ``tresym:`` are kept as notes to the reader, verbatim
text is passed over, and the author's macros are written out.
"""

from __future__ import annotations

import hashlib
import re
from collections.abc import Iterator
from contextlib import suppress
from dataclasses import dataclass, field
from pathlib import Path
from typing import NamedTuple, NoReturn, TypeAlias

from tresym.ledger.latex_source import (
    DISPLAYS,
    LABEL,
    MARKS,
    NotClosedError,
    display_at,
    end_of_display,
    unbalanced,
)
from tresym.manuscript.files import Files, Note
from tresym.manuscript.macros import DEFINITIONS, Macro, definition, group, written_out
from tresym.reals.numbers.exact import InputError

MAX_DISPLAY = 20_000
MAX_BRACES = 100
MAX_DISPLAYS = 5000

STATEMENT, PROOF, EXAMPLE, LIST, ITEM, CASE = (
    "statement",
    "proof",
    "example",
    "list",
    "item",
    "case",
)
_SCOPES = {
    STATEMENT: r"theorem|thm|lem(?:ma)?|prop(?:osition)?|cor(?:ollary)?|conj(?:ecture)?|claim|fact",
    PROOF: r"proof|pf|solutions?|soln?|answer|hint",
    EXAMPLE: r"ex|eg|exam|exam?ples?|exer|exercises?|problems?|prob|questions?|remarks?|rem|rmk",
    LIST: r"enumerate|itemize|description|parts|tasks|[a-z]*(?:list|enum|item)",
    CASE: r"case",
}
_SCOPE = {
    kind: re.compile(rf"(?:n|my|the)?(?:{words})(?:wrap|box|env|s|\d+)?")
    for kind, words in _SCOPES.items()
}
_NEWTHEOREM = re.compile(
    r"\\newtheorem\*?\s*\{([^{}]*)\}\s*(?:\[[^\[\]]*\])?\s*\{\s*(?:\\\w+\s*)?(\w+)"
)
_TITLE = re.compile(r"\*?\s*(?:\[[^\[\]]*\])?\s*\{(?:[^{}]|\{[^{}]*\})*\}")
_MARKED = re.compile(r"\x01(\d+)\x02")
_MARKS = re.compile(
    MARKS
    + r"""| (?P<section>\\(?:chapter|section|subsection|part|appendix)(?![a-zA-Z]))
      | \x01(?P<note>\d+)\x02
      | (?P<item>\\item(?![a-zA-Z]))
      | (?<![^\n])[ \t]*(?:\\noindent\s*)?(?P<styled>
          \\(?:textbf|emph|textit|textsc|underline|paragraph|subsubsection)\*?\s*\{\s*(?:\\\w+\s*)?
          |\{\s*\\(?:bf|it|em|sc|bfseries|itshape|scshape)\s+|\\(?=[a-z]+\s*\{))?
        (?P<heading>(?i:example|exercise|problem|question|solution|answer|theorem|lemma|proposition
          |corollary|proof|definition|remark|case))(?![a-zA-Z])
        (?(styled)(?=[^\n]{0,60}[}.:]|\s*\{)|(?=\s*\(?[\d.ivxIVX]{0,5}\)?[.:]))
      | (?:\A|(?<=[.:;!?}\n]))\s*(?P<spoken>(?!(?i:as\s+in|like|recall))(?:[A-Za-z]+,?\s+){0,4}?(?i:
          (?:the|our|my|an?|this)\s+(?:first|second|third|fourth|fifth|sixth|next|last|final|new
          |further|different|other)|another|one\s+more)\s+(?:[a-z]+\s+)?(?i:example)(?![a-z]))
      | (?P<command>\\(?:[a-zA-Z]+|.))
      | (?P<inline>\$)""",
    re.VERBOSE | re.DOTALL,
)


_INNERS = {"align": "aligned", "eqnarray": "aligned", "flalign": "aligned", "equation": "gathered"}
_INNERS |= {
    "gather": "gathered",
    "multline": "multlined",
    "alignat": "alignedat",
    "math": "gathered",
}
_INNER = re.compile(rf"\\(begin|end)\s*\{{({'|'.join(_INNERS)})\*?\}}")
"""Displays inside ``$$``, in Markdown, and what they are in LaTeX."""
_IN_ORDER = re.compile(
    r"\\in(?![a-zA-Z])(?=\s*(?:\\(?:mathcal|cal)\s*\{?\s*|\{\s*\\cal\s*)?[Oo]\}?\s*(?:\\left\s*)?\()"
)
"""The sign of ``f \\in O(g)``, which says ``f = O(g)``."""
_OPENING = re.compile(
    r"\s*(?:\\begin\s*\{(?P<begin>[a-z]+\*?)\}|(?P<open>\\\[)|(?P<dollars>\$\$))"
    r"(?P<more>\s*(?:\\begin\s*\{(?:aligned|split|gathered)\})?\s*)"
)
"""What a command or an environment of the author begins with that opens a display."""
_BEGUN = re.compile(rf"\\begin\s*\{{(?:{'|'.join(map(re.escape, DISPLAYS))})\}}|\\\[|\n\s*\n")
_CLOSED = re.compile(r"(?:\\end\s*\{[a-z]+\*?\}|\\\]|\$\$)\s*\Z")
_OPTIONS = re.compile(r"\A\s*\[[a-z=\s,\\{}\d.]*\]")
"""Options of the package breqn behind ``\\begin{dmath}``."""
_BRACKETS = frozenset(("\\left", "\\right", "\\middle"))
"""Commands of which an author's new definition changes the space around brackets, not a meaning."""


class Section(NamedTuple):
    """A heading: it ends the conditions before it; that of a chapter ends definitions too."""

    line: int
    chapter: bool = False
    inner: bool = False
    """Whether it is a subsection, which belongs to the section before it."""
    title: str = ""


class Scope(NamedTuple):
    """The beginning or end of a theorem, a proof, an example, a list, an item or a case.

    Attributes:
        opens: whether it begins here.
        kind: which of these it is.
        name: the environment, or "heading" if only a heading opens it.
    """

    opens: bool
    kind: str
    name: str


class Prose(NamedTuple):
    """The text between displays, and where it begins."""

    text: str
    file: str = ""
    line: int = 0


@dataclass(frozen=True)
class Display:
    """A displayed formula.

    Attributes:
        number: its number in the manuscript, from 1.
        kind: the environment, ``brackets`` or ``dollars``.
        labels: its labels, in order.
        file: the included file that contains it; empty for the manuscript itself.
        line: its first line in that file.
        text: the LaTeX between the delimiters, with macros expanded.
        problem: why its macros cannot be expanded; empty if they can.
        notes: the directives in it.
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
        """The SHA-256 hash of the text with single spaces as white space."""
        return hashlib.sha256(" ".join(self.text.split()).encode()).hexdigest()


class NoDisplayError(InputError):
    """A manuscript has no displayed formula."""


class Missing(NamedTuple):
    """An included file that does not exist, or is outside the project.

    With ``guessed`` a file that was read as Latin-1, as it is not UTF-8 and declares nothing. With
    ``why`` a place at which the source is broken; the rest is read.
    """

    name: str
    outside: bool = False
    guessed: bool = False
    why: str = ""


Event: TypeAlias = Note | Section | Scope | Prose | Display | Missing


def read_manuscript(path: Path, root: Path | None = None, text: str | None = None) -> list[Event]:
    """Return the contents of a manuscript in order; missing files come first.

    Args:
        path: its main file.
        root: the top folder of the project; None to search for it from ``path`` upwards.
        text: the contents of the main file, if an editor has not saved it yet.

    Raises:
        InputError: it cannot be read, or all its displays are broken, or it has none.
    """
    source = Files(path, root, text)
    lacking = [Missing(name) for name in source.missing]
    lacking += [Missing(name, outside=True) for name in source.outside]
    lacking += [Missing(name, guessed=True) for name in source.guessed]
    scanner = _Scanner(source)
    read = [*scanner.events()]
    events = [*lacking, *scanner.faults, *read]
    if not any(isinstance(event, Display) for event in events):
        why = "no display in it; write formulas in equation, align or \\[ \\]"
        raise NoDisplayError(f"{path}: {why}")
    return events


class _Scanner:
    """One pass over the text, which splits it into events."""

    def __init__(self, source: Files) -> None:
        self.source, self.text = source, source.text
        self.macros: dict[str, Macro] = {}
        self.titles = {m[1]: m[2] for m in _NEWTHEOREM.finditer(self.text)}
        self.count = 0
        self.broken: list[tuple[int, str]] = []
        self.faults: list[Missing] = []

    def events(self) -> Iterator[Event]:
        """Yield directives, headings, scopes, prose and displays, in order."""
        at = self.text.find("\\begin{document}")
        whole = at >= 0
        if whole:
            self.define(0, at)
        at = at + len("\\begin{document}") if whole else 0
        stop = self.text.find("\\end{document}", at)
        if whole and stop < 0:
            self.fault(at, "\\end{document} is missing; the file may be cut off")
        stop = stop if stop >= 0 else len(self.text)
        prose = at
        while (mark := _MARKS.search(self.text, at, stop)) is not None:
            at = mark.end()
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
                chapter = mark["section"] in ("\\chapter", "\\part")
                inner = mark["section"] == "\\subsection"
                line, title = self.source.place(at)[1], _TITLE.match(self.text, at, stop)
                if title is not None:
                    prose = at = title.end()
                    words = self.prose(title.start(), title.end()).text
                yield Section(line, chapter, inner, words if title else "")
            elif kind := display_at(mark) or self.own_display(mark[0]):
                yield self.prose(prose, mark.start())
                display, at = self.display(kind, mark.start(), at, stop, mark[0])
                prose = at
                yield display
            elif scope := self.scope(mark):
                yield self.prose(prose, mark.start())
                prose = mark.start("spoken") if mark["spoken"] else at
                yield scope
            elif mark["end"] in DISPLAYS:
                self.fault(mark.start(), f"\\end{{{mark['end']}}} closes nothing")
        yield self.prose(prose, stop)
        if self.broken and len(self.broken) == self.count:
            self.fail(*self.broken[0])

    def scope(self, mark: re.Match[str]) -> Scope | None:
        """Return the scope that opens or ends at a mark, if one does."""
        if mark["item"]:
            return Scope(True, ITEM, ITEM)
        if mark["spoken"]:
            return Scope(True, EXAMPLE, "heading")
        if word := mark["heading"]:
            kind = self.kind_of(word.lower())
            return Scope(bool(kind), kind, "heading")
        name = mark["begin"] or mark["end"] or ""
        kind = self.kind_of(name)
        return Scope(mark["end"] is None, kind, name) if kind else None

    def kind_of(self, name: str) -> str:
        """Return the kind of scope of an environment, by its name or by its declared title."""
        for word in (name, self.titles.get(name, "")):
            word = word.rstrip("*").lower()
            for kind, pattern in _SCOPE.items():
                if pattern.fullmatch(word):
                    return kind
        return ""

    def define(self, start: int, stop: int) -> None:
        """Collect the macros that are defined in a range of the text."""
        at = start
        while (command := DEFINITIONS.search(self.text, at, stop)) is not None:
            at = self.defined(command)

    def defined(self, command: re.Match[str]) -> int:
        try:
            made, end = definition(self.text, command)
        except InputError as error:
            self.fault(command.start(), f"{command[0]}: {error}; the definition is left out")
            return command.end()
        self.macros |= {name: macro for name, macro in made.items() if name not in _BRACKETS}
        return end

    def own_display(self, command: str) -> str:
        """Return the kind of display that a command or environment of the author opens, if any."""
        body = (self.macros.get(command) or Macro(0, None)).body
        found = body and _OPENING.fullmatch(body)
        return display_at(found) if found else ""

    def end_of_own_display(self, kind: str, opening: str, at: int, stop: int) -> tuple[int, int]:
        """Return where a display ends that a command of the author opened, as `end_of_display`."""
        if opening.startswith("\\begin"):
            closers = [opening.replace("\\begin", "\\end", 1)]
        else:
            last = {"brackets": "\\]", "dollars": "$$"}.get(kind, f"\\end{{{kind}}}")
            closers = [n for n, m in self.macros.items() if (m.body or "").strip().endswith(last)]
            closers = [n for n in closers if n != opening and not self.own_display(n)]
        names = "|".join(re.escape(n) + ("" if n[-1] == "}" else "(?![a-zA-Z])") for n in closers)
        found = re.compile(names).search(self.text, at, stop) if names else None
        if found is None or _BEGUN.search(self.text, at, found.start()):
            raise NotClosedError(f"the display ({opening}) is not closed")
        return found.start(), found.end()

    def around(self, opening: str, text: str, closing: str) -> str:
        """Return the text of a display with what the author's commands add to it."""
        first = _OPENING.fullmatch(self.macros[opening].body or "")
        last = (self.macros.get(closing) or Macro(0, "")).body or ""
        inner = _CLOSED.sub("", last)
        return f"{first['more'] if first else ''} {text} {inner}"

    def inline(self, at: int) -> int:
        """Return where an inline formula ends."""
        end = self.text.find("$", at)
        return end + 1 if 0 <= end < at + MAX_DISPLAY else at

    def prose(self, start: int, stop: int) -> Prose:
        start = max(start, stop - MAX_DISPLAY)
        text = self.text[start:stop]
        file, line = self.source.place(min(start, len(self.text) - 1)) if self.text else ("", 0)
        with suppress(InputError):
            text = written_out(text, self.macros) if len(text) < MAX_DISPLAY else text
        return Prose(text, file, line)

    def display(
        self, kind: str, start: int, at: int, stop: int, opening: str
    ) -> tuple[Display, int]:
        """Return the display whose text begins at ``at``, and where to continue."""
        lost = ""
        own = bool(self.own_display(opening))
        try:
            if own:
                end, after = self.end_of_own_display(kind, opening, at, stop)
            else:
                end, after = end_of_display(self.text, kind, at, stop)
        except NotClosedError as error:
            end, after, lost = at, at, str(error)
        text, long = self.text[at:end], end - at > MAX_DISPLAY
        labels = tuple(label.strip() for label in LABEL.findall(text))
        text = "" if long else text
        if kind.startswith("dmath"):
            text = _OPTIONS.sub("", text)
        if own and not lost and not long:
            text = self.around(opening, text, self.text[end:after])
        depth = 0
        for mark in re.finditer(r"\\.|[{}]", text):
            depth += (mark[0] == "{") - (mark[0] == "}")
            if not 0 <= depth <= MAX_BRACES:
                break
        problem = f"the display is longer than {MAX_DISPLAY} characters" if long else ""
        if depth > MAX_BRACES:
            problem = f"braces are nested deeper than {MAX_BRACES} levels in the display"
        problem = lost or problem or ("the braces of the display do not match" if depth else "")
        problem = problem or unbalanced(text)
        if problem:
            self.broken.append((start, problem))
        notes = tuple(self.source.notes[int(mark[1])] for mark in _MARKED.finditer(text))
        text = _MARKED.sub("", text)
        text = _IN_ORDER.sub("=", text)
        if kind in ("dollars", "brackets"):
            text = _INNER.sub(lambda m: rf"\{m[1]}{{{_INNERS[m[2]]}}}", text)
        if kind.startswith(("alignat", "xalignat")) and not problem:
            _, past = group(text, 0)
            text = text[past:]
        try:
            text = text if problem else written_out(text, self.macros)
        except InputError as error:
            problem = str(error)
            if "does not end" in problem:
                self.broken.append((start, problem))
        self.count += 1
        if self.count > MAX_DISPLAYS:
            self.fail(start, f"there are more than {MAX_DISPLAYS} displays")
        file, line = self.source.place(start)
        return Display(self.count, kind, labels, file, line, text, problem, notes), after

    def fault(self, at: int, why: str) -> None:
        """Note a place at which the source is broken."""
        file, line = self.source.place(at)
        self.faults.append(Missing(f"{file or self.source.path.name}, line {line}", why=why))

    def fail(self, at: int, why: str) -> NoReturn:
        file, line = self.source.place(at)
        name = self.source.folder / file if file else self.source.path
        raise InputError(f"{name}: line {line}: {why}")
