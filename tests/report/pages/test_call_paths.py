"""The walks on the page of the map are those of the sources, and enter no room a third time."""

from __future__ import annotations

import ast
from importlib import import_module
from pathlib import Path

import pytest

import tresym
from tresym.report.pages.call_paths import LEDGER, USER, Station, callers, entered, room, walks

WALKS = {"a user's claim": USER, "a claim of the paper": LEDGER}


@pytest.mark.parametrize("walk", WALKS)
def test_every_station_is_there(walk: str) -> None:
    for station in WALKS[walk]:
        assert hasattr(import_module(f"tresym.{station.file}"), station.function), station


@pytest.mark.parametrize("walk", WALKS)
def test_a_station_names_the_next(walk: str) -> None:
    """The file of the caller names the function that it calls, and the file that it is in."""
    for caller, station in callers(WALKS[walk]):
        names = _named_in(caller)
        assert station.function in names, (caller, station)
        imported = f"tresym.{station.file}" in names or station.file.split(".")[-1] in names
        assert imported or caller.file == station.file, (caller, station)


def _named_in(station: Station) -> set[str]:
    """All names, attributes, imported modules and what is imported from them, in a file."""
    module = import_module(f"tresym.{station.file}")
    assert module.__file__ is not None
    found: set[str] = set()
    for node in ast.walk(ast.parse(Path(module.__file__).read_text(encoding="utf-8"))):
        if isinstance(node, ast.Name):
            found.add(node.id)
        elif isinstance(node, ast.Attribute):
            found.add(node.attr)
        elif isinstance(node, ast.ImportFrom):
            found |= {str(node.module), *(a.name for a in node.names)}
            found |= {f"{node.module}.{alias.name}" for alias in node.names}
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            found.add(node.value)  # the package of the proofs is named, not imported
    return found


@pytest.mark.parametrize("walk", WALKS)
def test_no_room_is_entered_more_than_twice(walk: str) -> None:
    assert max(entered(WALKS[walk]).values()) <= 2


def test_rooms_are_those_of_the_map() -> None:
    text = (Path(tresym.__file__).parents[1] / "CONTRIBUTING.md").read_text(encoding="utf-8")
    for walk in WALKS.values():
        for station in walk:
            assert f"| `{room(station.file)}` |" in text


def test_a_room_entered_thrice_is_counted() -> None:
    walk = (
        Station(0, "commands.check", "run", ""),
        *(Station(1, f"reals.signs.{name}", "sign", "") for name in "abc"),
    )
    assert entered(walk) == {"commands/": 1, "reals/signs/": 3}


def test_both_walks_are_on_the_page() -> None:
    page = walks()
    assert page.count("\n- `commands/") == 2
    assert " times" not in page
    for station in (*USER, *LEDGER):
        assert f"`{station.function}`: {station.does}" in page
