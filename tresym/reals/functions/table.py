"""The table of all functions, by name."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Any

from tresym.reals.functions.bessel import BESSEL
from tresym.reals.functions.elementary import ABBREVIATIONS as ELEMENTARY_ABBREVIATIONS
from tresym.reals.functions.elementary import ELEMENTARY
from tresym.reals.functions.elliptic import ELLIPTIC
from tresym.reals.functions.error import ERROR
from tresym.reals.functions.exponential_integrals import EXPONENTIAL_INTEGRALS
from tresym.reals.functions.gamma import GAMMA
from tresym.reals.functions.row import Formula, Function
from tresym.reals.functions.zeta import ZETA

TABLE: dict[str, Function] = {
    row.name: row
    for row in (
        *ELEMENTARY,
        *GAMMA,
        *ERROR,
        *EXPONENTIAL_INTEGRALS,
        *BESSEL,
        *ELLIPTIC,
        *ZETA,
    )
}
"""Every row by the name of its function."""


def _beta(x: Any, y: Any, m: Any) -> Any:
    return m.gamma(x) * m.gamma(y) / m.gamma(x + y)


ABBREVIATIONS: dict[tuple[str, int], Formula] = {
    **ELEMENTARY_ABBREVIATIONS,
    ("E1", 1): lambda x, m: m.expint(1, x),
    ("beta", 2): _beta,
    ("Beta", 2): _beta,
    ("trigamma", 1): lambda x, m: m.polygamma(1, x),
    ("dilog", 1): lambda x, m: m.polylog(2, 1 - x),
    ("jv", 2): lambda n, x, m: m.besselj(n, x),
}
"""Names, with the number of arguments, that are replaced by other functions where they are read."""


def names(fact: Callable[[Function], object]) -> frozenset[str]:
    """Return the names of the functions whose row has a fact."""
    return frozenset(name for name, row in TABLE.items() if fact(row))


SPECIAL = names(lambda row: not row.theory)
"""The functions that are not elementary."""
CONSTANTS = names(lambda row: row.constant)
"""Constants, which are functions of the number 1."""


def upright(row: Function) -> str:
    """Return the name of a function as it is printed: ``arcsin`` for asin, ``ln`` for log."""
    return row.mathml or re.sub(r"\\operatorname\{([\w']+)\}|\\(\w+)", r"\1\2", row.latex)


def written_after(row: Function) -> bool:
    """Whether the argument follows the name, unlike that of an absolute value or a root."""
    return bool(row.latex) and "{}" not in row.latex
