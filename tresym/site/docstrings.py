"""Convert docstring sections such as ``Args:`` to field lists for Sphinx."""

from __future__ import annotations

import re
from typing import Any

_ALIAS = re.compile(r"TypeAliasForwardRef\('(\w+)'\)")


def restructured(lines: list[str]) -> list[str]:
    """Return the lines of a docstring with its sections as field lists.

    Napoleon is not told the kind of object, since for an attribute it would take the words before a
    colon for its type.
    """
    from sphinx.ext.napoleon import Config, GoogleDocstring

    return GoogleDocstring(lines, Config(napoleon_use_ivar=True)).lines()


def process(app: Any, what: str, name: str, value: Any, options: Any, lines: list[str]) -> None:
    """Sphinx hook: rewrite a docstring in place."""
    lines[:] = restructured(lines)


def skip(app: Any, what: str, name: str, value: Any, skipped: bool, options: Any) -> bool | None:
    """Sphinx hook: skip the fields of named tuples, which the class docstring describes."""
    return True if type(value).__name__ == "_tuplegetter" else None


def signature(
    app: Any, what: str, name: str, value: Any, options: Any, arguments: str, result: str
) -> tuple[str, str]:
    """Sphinx hook: write type aliases by their names, also within a union."""
    plain = [_ALIAS.sub(r"\1", text) if text else text for text in (arguments, result)]
    return plain[0], plain[1]
