"""Settings of a project: ``[tool.tresym]`` in pyproject.toml, or tresym.toml.

They are looked for beside the manuscript, then in the folders above it up to the top of the
project; the command line goes before them.
"""

from __future__ import annotations

import re
import tomllib
from collections.abc import Sequence
from dataclasses import dataclass, fields, replace
from pathlib import Path
from typing import Any

from tresym.manuscript.directives import orders_of
from tresym.manuscript.macros import group
from tresym.manuscript.source import Display, Event, Note, Prose, Section
from tresym.reals.numbers.exact import InputError

_MOST = 40
"""Folders above the manuscript at most that are looked into."""


@dataclass(frozen=True)
class Settings:
    """What a project sets.

    Attributes:
        files: its manuscripts, paths or patterns from the file of the settings.
        limit: seconds for each claim.
        strict: whether nothing may be open.
        baseline: the file of known problems.
        ignore_macros: macros that are left out, with their arguments.
        directives: notes that hold everywhere, as behind ``% tresym:``.
        folder: where the settings stand.
    """

    files: tuple[str, ...] = ()
    limit: str = "5"
    strict: bool = False
    baseline: str = ""
    ignore_macros: tuple[str, ...] = ()
    directives: tuple[str, ...] = ()
    folder: Path = Path()

    def manuscripts(self) -> list[Path]:
        """The files that the settings name.

        Raises:
            InputError: one that is not there.
        """
        found: list[Path] = []
        for name in self.files:
            matching = sorted(self.folder.glob(name))
            if not matching:
                raise InputError(f"{self.folder / name}: no such manuscript, see the setting files")
            found += matching
        return list(dict.fromkeys(found))


def settings_for(folder: Path) -> Settings:
    """Return the settings for a folder, from the nearest settings file upwards.

    Raises:
        InputError: the settings file is not understood; the message says why.
    """
    folder = folder.resolve()
    for place in (folder, *folder.parents)[:_MOST]:
        for name, table in (("tresym.toml", ()), ("pyproject.toml", ("tool", "tresym"))):
            path = place / name
            found = _table(path, table) if path.is_file() else None
            if found is not None:
                return replace(_settings(found, path), folder=place)
        if (place / ".git").exists():
            break
    return Settings(folder=folder)


def _table(path: Path, names: Sequence[str]) -> dict[str, Any] | None:
    """Return a table of a TOML file, None if it has no such table."""
    try:
        found: Any = tomllib.loads(path.read_text(encoding="utf-8"))
    except (OSError, ValueError, RecursionError) as error:
        if names:  # other tools report an invalid pyproject.toml
            return None
        said = str(error).splitlines()[0][:100] if str(error) else "it cannot be read"
        raise InputError(f"{path}: {said}") from None
    for name in names:
        found = found.get(name) if isinstance(found, dict) else None
    return found if isinstance(found, dict) else None


def _settings(found: dict[str, Any], path: Path) -> Settings:
    known = {field.name.replace("_", "-"): field for field in fields(Settings)}
    del known["folder"]
    values: dict[str, Any] = {}
    for key, value in found.items():
        field = known.get(key)
        if field is None:
            raise InputError(
                f"{path}: unknown setting {key[:60]!a}; the settings are {', '.join(known)}"
            )
        if field.name in ("files", "ignore_macros", "directives"):
            fits = isinstance(value, list) and all(isinstance(item, str) for item in value)
            wanted = "a list of strings"
        elif field.name == "strict":
            fits, wanted = isinstance(value, bool), "true or false"
        elif field.name == "limit":
            fits = isinstance(value, int | float | str) and not isinstance(value, bool)
            wanted = "a number of seconds"
        else:
            fits, wanted = isinstance(value, str), "a string"
        if not fits:
            raise InputError(f"{path}: the setting {key} must be {wanted}")
        value = str(value) if field.name == "limit" else value
        values[field.name] = tuple(value) if isinstance(value, list) else value
    for text in values.get("directives", ()):
        orders_of(Note(text, path.name, 0))
        if text.split()[0] not in ("given", "let"):
            raise InputError(f"{path}: only the directives given … and let … can be settings")
    for name in values.get("ignore_macros", ()):
        if not re.fullmatch(r"\\?[A-Za-z@]+", name):
            raise InputError(f"{path}: {name[:60]!a} is not the name of a macro")
    return Settings(**values)


def with_settings(events: Sequence[Event], settings: Settings) -> list[Event]:
    """Return the manuscript with the directives of the settings, and without ignored macros."""
    notes = [Note(text, "settings", 0) for text in settings.directives]
    names = {name.removeprefix("\\") for name in settings.ignore_macros}
    result: list[Event] = [*notes]
    for event in events:
        if names and isinstance(event, Display):
            event = replace(event, text=_without(event.text, names))
        elif names and isinstance(event, Prose):
            event = event._replace(text=_without(event.text, names))
        result.append(event)
        if isinstance(event, Section):  # conditions end there, so they are repeated
            result += notes
    return result


def _without(text: str, names: set[str]) -> str:
    """Return the text without some macros and their arguments."""
    result, at = [], 0
    for match in re.finditer(r"\\([A-Za-z@]+)\*?", text):
        if match.start() < at or match[1] not in names:
            continue
        result.append(text[at : match.start()])
        at = match.end()
        while at < len(text) and text[at] in "[{":
            end = text.find("]", at) + 1 if text[at] == "[" else _end_of_group(text, at)
            if end <= at:
                break
            at = end
        result.append(" ")
    return "".join([*result, text[at:]])


def _end_of_group(text: str, at: int) -> int:
    try:
        return group(text, at)[1]
    except InputError:
        return -1
