"""What running text mentions: names in it, and which of them depend on others."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence

from tresym.manuscript.display import Said, statements
from tresym.reals.language.calls import INTEGERS
from tresym.reals.language.expression import (
    Expr,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.numbers.exact import InputError

_L = r"([a-zA-Z]|\\[a-zA-Z]+)"
_D = r"\s*(?:d|\\mathrm\s*\{?d\}?|\\partial)(?:\s*\^\s*\{?\d\}?)?\s*"
_DERIVATIVES = (
    (rf"\\d?dot\s*\{{?\s*{_L}", "t"),
    (r"(?<![a-zA-Z\\])([a-zA-Z])(?:_\w)?'", ""),
    (rf"\\[dt]?frac\s*\{{{_D}{_L}\s*\}}\s*\{{{_D}{_L}", ""),
)
"""How derivatives of symbols are written."""


def reaches(name: str, names: Iterable[str], known: Mapping[str, Expr]) -> bool:
    """Whether the definition of ``name`` contains one of ``names``, directly or indirectly."""
    reached, left = set(), {name}
    while left:
        reached |= left
        left = {s for n in left if n in known for s in symbols(known[n])} - reached
    return not reached.isdisjoint(names)


def dependent(text: str) -> dict[str, set[str]]:
    """Return the letters that are differentiated, and by which variables (``""`` for any)."""
    found: dict[str, set[str]] = {}
    for pattern, by in _DERIVATIVES:
        for match in re.finditer(pattern, text):
            name, *rest = (part.lstrip("\\") for part in match.groups())
            found.setdefault(name, set()).add(rest[0] if rest else by)
    return found


def quietly(tex: str) -> list[Said]:
    """Return the chains of an inline formula, none if it cannot be split."""
    try:
        return statements(tex) if len(tex) < 400 else []
    except InputError:
        return []


def names_in(comparisons: Iterable[Compared]) -> frozenset[str]:
    """Return the names that occur in comparisons."""
    return frozenset().union(*(symbols(a) | symbols(b) for a, _, b in comparisons))


def about(names: frozenset[str], given: Sequence[Compared]) -> list[Compared]:
    """Return the conditions on these variables, and on variables connected to them."""
    reached, size = set(names), 0
    while len(reached) != size:
        size = len(reached)
        for left, _, right in given:
            own = (symbols(left) | symbols(right)) - symbols(INTEGERS)
            if own & reached:
                reached |= own
    kept = [c for c in given if (symbols(c[0]) | symbols(c[2])) & reached]
    return list(dict.fromkeys(kept))
