"""List all messages on one page: errors, reasons of verdicts, hints and help texts.

The sources are parsed, and every string with at least a few words in it is listed by module, except
docstrings. A gap ``…`` stands for a value that is inserted when the message is written.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from pathlib import Path

import tresym

PARTS = ("commands", "reals", "manuscript", "ledger", "coq", "racket", "sweep", "output.py")
"""Packages whose strings are shown to users."""
LEAST_WORDS = 3
_WORD = re.compile(r"(?<![\w\\{])[A-Za-z][a-z]+(?![\w}(=])")


def messages() -> str:
    """Write the page of messages in Markdown."""
    lines = [
        "The messages of tresym, by module: errors, reasons of verdicts, hints and help texts. A "
        "gap … stands for a value. The list is extracted from the sources."
    ]
    for path in _files():
        found = list(dict.fromkeys(_messages(path)))
        if found:
            name = path.relative_to(_root()).with_suffix("").as_posix()
            lines += ["", f"## `{name}`", ""]
            lines += [f"- `` {text} ``" for text in found]
    return "\n".join(lines) + "\n"


def _root() -> Path:
    return Path(tresym.__file__).resolve().parent


def _files() -> Iterator[Path]:
    for part in PARTS:
        place = _root() / part
        yield from sorted(place.rglob("*.py")) if place.is_dir() else [place]


def _messages(path: Path) -> Iterator[str]:
    """The strings of a module with at least a few words, in their order."""
    tree = ast.parse(path.read_text(encoding="utf-8"))
    skipped = set(_silent(tree))
    found = []
    for node in ast.walk(tree):
        if id(node) in skipped:
            continue
        if isinstance(node, ast.JoinedStr):
            skipped |= {id(inner) for inner in ast.walk(node)}
            pieces = (v.value if isinstance(v, ast.Constant) else "…" for v in node.values)
            found.append((node.lineno, node.col_offset, "".join(map(str, pieces))))
        elif isinstance(node, ast.Constant) and isinstance(node.value, str):
            found.append((node.lineno, node.col_offset, node.value))
    for _, _, text in sorted(found):
        shown = " ".join(text.split())
        if len(_WORD.findall(shown)) >= LEAST_WORDS and not re.search("`|</m", shown):
            yield shown


def _silent(tree: ast.Module) -> Iterator[int]:
    """Docstrings, and strings that document a constant."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant):
            yield id(node.value)
