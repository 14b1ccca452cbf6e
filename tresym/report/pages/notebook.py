"""Write a Jupyter notebook: cells of text, and cells of code that compute what the text states."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Any

Cell = dict[str, Any]


def text(words: str) -> Cell:
    """Return a cell of Markdown."""
    return {"cell_type": "markdown", "metadata": {}, "source": words.strip()}


def code(source: str) -> Cell:
    """Return a cell of Python, not yet run."""
    return {
        "cell_type": "code",
        "execution_count": None,
        "metadata": {},
        "outputs": [],
        "source": source,
    }


def verifying(label: str) -> str:
    """Return the code that verifies a claim and shows its verdict."""
    return f'tresym.verify("{label}")["{label}"]'


def book(cells: Iterable[Cell]) -> str:
    """Return a notebook of format 4 as JSON text."""
    kernel = {"display_name": "Python 3", "language": "python", "name": "python3"}
    found = {
        "cells": [{**cell, "id": f"cell-{n}"} for n, cell in enumerate(cells, 1)],
        "metadata": {"kernelspec": kernel, "language_info": {"name": "python"}},
        "nbformat": 4,
        "nbformat_minor": 5,
    }
    return json.dumps(found, ensure_ascii=False, indent=1) + "\n"
