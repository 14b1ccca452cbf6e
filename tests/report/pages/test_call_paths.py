"""The call paths of the page are those of the sources, and enter no package a third time."""

import ast
from importlib import import_module
from pathlib import Path

import pytest

import tresym
from tresym.report.pages.call_paths import LEDGER, USER, Call, call_paths, callers, entered, package

PATHS = {"a user's claim": USER, "a claim of the paper": LEDGER}


@pytest.mark.parametrize("path", PATHS)
def test_every_call_is_there(path: str) -> None:
    for call in PATHS[path]:
        assert hasattr(import_module(f"tresym.{call.file}"), call.function), call


@pytest.mark.parametrize("path", PATHS)
def test_a_call_names_the_next(path: str) -> None:
    """The file of the caller names the function that it calls, and the file that it is in."""
    for caller, call in callers(PATHS[path]):
        names = _named_in(caller)
        assert call.function in names, (caller, call)
        imported = f"tresym.{call.file}" in names or call.file.split(".")[-1] in names
        assert imported or caller.file == call.file, (caller, call)


def _named_in(call: Call) -> set[str]:
    """All names, attributes, imported modules and what is imported from them, in a file."""
    module = import_module(f"tresym.{call.file}")
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


@pytest.mark.parametrize("path", PATHS)
def test_no_package_is_entered_more_than_twice(path: str) -> None:
    assert max(entered(PATHS[path]).values()) <= 2


def test_packages_are_those_of_the_map() -> None:
    text = (Path(tresym.__file__).parents[1] / "CONTRIBUTING.md").read_text(encoding="utf-8")
    for path in PATHS.values():
        for call in path:
            assert f"| `{package(call.file)}` |" in text


def test_a_package_entered_thrice_is_counted() -> None:
    path = (
        Call(0, "commands.check", "run", ""),
        *(Call(1, f"reals.signs.{name}", "sign", "") for name in "abc"),
    )
    assert entered(path) == {"commands/": 1, "reals/signs/": 3}


def test_both_call_paths_are_on_the_page() -> None:
    page = call_paths()
    assert page.count("\n- `commands/") == 2
    assert " times" not in page
    for call in (*USER, *LEDGER):
        assert f"`{call.function}`: {call.does}" in page
