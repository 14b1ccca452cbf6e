"""Our docstrings for Sphinx: sections such as ``Args:`` become field lists."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

_FIELDS = {"Args": "param", "Attributes": "ivar", "Raises": "raises", "Returns": "returns"}
_ALIAS = re.compile(r"TypeAliasForwardRef\('(\w+)'\)")
_ITEM = re.compile(r"    (\*{0,2}\w+): (.*)")


def restructured(lines: list[str]) -> Iterator[str]:
    """The lines of a docstring with its sections as fields; all else is left as it is."""
    field = ""
    for line in lines:
        head = line.rstrip(":")
        if line.endswith(":") and head in _FIELDS:
            field = _FIELDS[head]
            yield ""
            if field == "returns":
                yield ":returns:"
        elif field and line and not line.startswith(" "):
            field = ""
            yield from ("", line)
        elif field in ("param", "ivar", "raises") and (item := _ITEM.fullmatch(line)):
            yield f":{field} {item[1]}: {item[2]}"
        else:
            yield line


def process(app: Any, what: str, name: str, value: Any, options: Any, lines: list[str]) -> None:
    """Sphinx's hook: rewrite a docstring in place."""
    lines[:] = restructured(lines)


def skip(app: Any, what: str, name: str, value: Any, skipped: bool, options: Any) -> bool | None:
    """Sphinx's hook: the fields of named tuples are told by the tuple's own text."""
    return True if type(value).__name__ == "_tuplegetter" else None


def signature(
    app: Any, what: str, name: str, value: Any, options: Any, arguments: str, result: str
) -> tuple[str, str]:
    """Sphinx's hook: type aliases by their names, also where they stand in a union."""
    plain = [_ALIAS.sub(r"\1", text) if text else text for text in (arguments, result)]
    return plain[0], plain[1]
