"""Lists of inputs that the tests read from ``tests/data/lists``: one entry a line.

The lists of ``tests/reals/decisions/test_identity.py`` stand in
``tests/data/lists/reals/decisions/identity.txt``. A list begins with its name in brackets. Lines
that begin with ``#`` say why the entry after them is there. An entry of several texts separates
them by `` | ``; the words True, False and None and the names of verdicts are these values::

    [TRUE]
    sqrt(x^2) | x | x>=0
    # on a short stretch alone
    sqrt(x^2) | -x | x<0
"""

from functools import cache
from pathlib import Path
from typing import Any

from tresym.reals.verdict import Verdict

_TESTS = Path(__file__).parent
_VALUES = {"True": True, "False": False, "None": None} | Verdict.__members__


@cache
def _lists(file: Path) -> dict[str, list[Any]]:
    lists: dict[str, list[Any]] = {}
    for line in file.read_text(encoding="utf-8").splitlines():
        if line.startswith("["):
            entries = lists.setdefault(line.strip("[]"), [])
        elif line and not line.startswith("#"):
            texts = [text.strip() for text in f"{line} ".split(" | ")]
            values = tuple(_VALUES.get(text, text) for text in texts)
            entries.append(values if len(values) > 1 else values[0])
    return lists


def cases(module: str, name: str) -> list[Any]:
    """The list of this name that belongs to a module of tests: texts, or tuples of texts."""
    inner = Path(module).relative_to(_TESTS)
    file = _TESTS / "data" / "lists" / inner.parent / f"{inner.stem.removeprefix('test_')}.txt"
    return list(_lists(file)[name])
