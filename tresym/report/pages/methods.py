"""Write the list of the methods of the sign prover, from their docstrings."""

from __future__ import annotations

import inspect
import re
from collections.abc import Callable
from typing import Any

from tresym.reals.signs.sign import METHODS


def methods() -> str:
    """Write a paragraph for each method, cheapest first: its idea, an example, and its limits."""
    return "\n".join(map(_item, METHODS)) + "\n"


def example(method: Callable[..., Any]) -> str:
    """Return a claim that the method decides by itself, as its docstring states it.

    Raises:
        ValueError: the docstring has no part ``Decides ``…````.
    """
    found = re.search(r"Decides ``(.+?)``", _says(method))
    if found is None:
        raise ValueError(f"{method.__name__} names no claim that it decides")
    return found.group(1)


def _item(method: Callable[..., Any]) -> str:
    title, rest = _says(method).split(": ", 1)
    return f"- **{title}.** {rest[0].upper()}{rest[1:]}".replace("``", "`")


def _says(method: Callable[..., Any]) -> str:
    """The docstring up to its arguments, on one line."""
    text = inspect.getdoc(method) or ""
    return " ".join(text.split("Args:")[0].split())
