"""The methods of the sign prover, as a list in Markdown."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any

from tresym.reals.signs.sign import METHODS


def methods() -> str:
    """A paragraph for each method, cheapest first: what it is, an example, and where it ends."""
    return "\n".join(map(_item, METHODS)) + "\n"


def example(method: Callable[..., Any]) -> str:
    """A claim that the method decides by itself."""
    found = re.search(r"Decides ``(.+?)``", _says(method))
    if found is None:
        raise ValueError(f"{method.__name__} names no claim that it decides")
    return found.group(1)


def _item(method: Callable[..., Any]) -> str:
    title, rest = _says(method).split(": ", 1)
    return f"- **{title}.** {rest[0].upper()}{rest[1:]}".replace("``", "`")


def _says(method: Callable[..., Any]) -> str:
    """The docstring up to the arguments, on one line."""
    text = inspect.getdoc(method) or ""
    return " ".join(text.split("Args:")[0].split())
