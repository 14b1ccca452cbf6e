"""Notes to the reader in a manuscript's comments, ``% tresym: …``."""

from __future__ import annotations

import re
from dataclasses import dataclass, fields, replace
from pathlib import Path

from tresym.ledger.latex_source import read_text
from tresym.manuscript.files import Note
from tresym.manuscript.kinds_in_prose import BY_NAME
from tresym.manuscript.source import Display, Event
from tresym.reals.language.parsing import parse_given
from tresym.reals.numbers.exact import InputError

KINDS = ("define", "assume", "solve", "claim")
_LET = re.compile(r"(.+?)\s+(?:is |are |an? )*([a-z]+?)(?:s| number| variable)?")


@dataclass(frozen=True)
class Orders:
    """The meaning of one or more directives.

    Attributes:
        given: conditions to the end of the section.
        forget: whether such conditions end here.
        kind: the kind of the next display: define, assume, solve or claim.
        sources: labels of the displays from which the next one follows.
        path: the path of the orders and limits in the next display.
        shorter: whether the shorter argument is meant in the next display: sin(x)*(y + z).
        skip: why the next display is to be skipped; None if it is not.
        lets: symbols in LaTeX, with their kinds.
    """

    given: str = ""
    forget: bool = False
    kind: str = ""
    sources: tuple[str, ...] = ()
    path: str = ""
    shorter: bool = False
    skip: str | None = None
    lets: tuple[tuple[str, str], ...] = ()

    def with_(self, later: Orders) -> Orders:
        """Return both together, for the next display."""
        found = {f.name: getattr(later, f.name) or getattr(self, f.name) for f in fields(self)}
        if later.skip is not None:
            found["skip"] = later.skip
        return replace(self, **found)


def orders_of(note: Note) -> Orders:
    """Parse a directive.

    Raises:
        InputError: it is not understood; the message says where it is and what can be written.
    """
    word, _, rest = note.text.partition(" ")
    rest = rest.strip()
    word = word.rstrip(":")
    place = f"{note.file}, line {note.line}" if note.file else f"line {note.line}"
    if word == "given" and rest:
        try:
            parse_given(rest)
        except InputError as error:
            raise InputError(f"{place}: {error}") from None
        return Orders(given=rest)
    if word == "let" and rest:
        return _let(rest, place)
    if word == "forget" and not rest:
        return Orders(forget=True)
    if word in KINDS and not rest:
        return Orders(kind=word)
    if word == "shorter" and not rest:
        return Orders(shorter=True)
    if word == "from" and rest:
        return Orders(sources=tuple(re.split(r"[,\s]+", rest)))
    if word == "as" and "->" in rest:
        return Orders(path=rest)
    if word == "skip":
        return Orders(skip=rest or "no reason is given")
    raise InputError(
        f"{place}: the directive {note.text[:60]!a} is not understood; write given CONDITIONS, "
        "let SYMBOLS KIND, forget, define, assume, solve, claim, from LABELS, as PATH, shorter or "
        "skip: WHY"
    )


def _let(text: str, place: str) -> Orders:
    """Parse ``T operator, A B matrix, s > 0``: kinds of symbols, and conditions.

    Raises:
        InputError: a part is neither.
    """
    lets: list[tuple[str, str]] = []
    given: list[str] = []
    for part in filter(None, (part.strip() for part in text.split(","))):
        if re.search(r"[<>]|!=", part):
            given.append(part)
            continue
        found = _LET.fullmatch(part)
        kind = BY_NAME.get(found[2].replace("matrice", "matrix")) if found else None
        if found is None or kind is None:
            raise InputError(
                f"{place}: {part[:60]!a} is not understood; write let SYMBOLS "
                "KIND with one of the kinds "
                f"{', '.join(BY_NAME)}, or a condition"
            )
        lets.append((found[1], kind))
    conditions = ", ".join(given)
    try:
        parse_given(conditions) if given else None
    except InputError as error:
        raise InputError(f"{place}: {error}") from None
    return Orders(given=conditions, lets=tuple(lets))


def with_notes(events: list[Event], path: Path) -> list[Event]:
    """Return the manuscript with directives from a separate file added.

    Each line of the file has the number of a display, at least 8 hexadecimal digits of the SHA-256
    hash of its text, and a directive.

    Raises:
        InputError: a line is not understood, or its hash is not that of the display.
    """
    found: dict[int, tuple[Note, ...]] = {}
    displays = {event.number: event for event in events if isinstance(event, Display)}
    for line, text in enumerate(read_text(path).split("\n"), 1):
        if not text.strip() or text.startswith("#"):
            continue
        number, _, rest = text.strip().partition(" ")
        digest, _, note = rest.strip().partition(" ")
        display = displays.get(int(number)) if number.isdecimal() and len(number) < 6 else None
        if display is None or len(digest) < 8:
            raise InputError(
                f"{path}, line {line}: write a display's number, its hash and a directive"
            )
        if not display.sha256.startswith(digest):
            raise InputError(
                f"{path}, line {line}: the hash is not that of display "
                f"{number}; the text has changed"
            )
        found[display.number] = (*found.get(display.number, ()), Note(note, path.name, line))
    return [
        replace(e, notes=(*e.notes, *found.get(e.number, ()))) if isinstance(e, Display) else e
        for e in events
    ]
