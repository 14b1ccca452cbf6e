"""Notes to the reader in a manuscript's comments, ``% tresym: …``."""

from __future__ import annotations

import re
from dataclasses import dataclass, fields, replace

from tresym.manuscript.surface import Note
from tresym.reals.language.parsing import parse_conditions
from tresym.reals.numbers.exact import InputError

KINDS = ("define", "assume", "solve", "claim")


@dataclass(frozen=True)
class Orders:
    """What notes ask for.

    Attributes:
        given: conditions from here to the end of the section.
        forget: they end here.
        kind: what the next display is: define, assume, solve or claim.
        sources: labels of the displays from which the next one follows.
        path: the path of the orders and limits in the next display.
        skip: why the next display is not to be read.
    """

    given: str = ""
    forget: bool = False
    kind: str = ""
    sources: tuple[str, ...] = ()
    path: str = ""
    skip: str | None = None

    def with_(self, later: Orders) -> Orders:
        """Both, for the next display."""
        found = {f.name: getattr(later, f.name) or getattr(self, f.name) for f in fields(self)}
        if later.skip is not None:
            found["skip"] = later.skip
        return replace(self, **found)


def orders_of(note: Note) -> Orders:
    """What a note asks for.

    Raises:
        InputError: a note that is not understood; one line says where and what can be written.
    """
    word, _, rest = note.text.partition(" ")
    rest = rest.strip()
    word = word.rstrip(":")
    place = f"{note.file}, line {note.line}" if note.file else f"line {note.line}"
    if word == "given" and rest:
        try:
            parse_conditions(rest)
        except InputError as error:
            raise InputError(f"{place}: {error}") from None
        return Orders(given=rest)
    if word == "forget" and not rest:
        return Orders(forget=True)
    if word in KINDS and not rest:
        return Orders(kind=word)
    if word == "from" and rest:
        return Orders(sources=tuple(re.split(r"[,\s]+", rest)))
    if word == "as" and "->" in rest:
        return Orders(path=rest)
    if word == "skip":
        return Orders(skip=rest or "no reason is given")
    raise InputError(
        f"{place}: the note {note.text[:60]!a} is not understood; there are given CONDITIONS, "
        "forget, define, assume, solve, claim, from LABELS, as PATH and skip: WHY"
    )
