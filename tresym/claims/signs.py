"""Signs that are manifest: by structure and ranges, or as a sum of conditions known to hold."""

from __future__ import annotations

from functools import lru_cache

from sympy import Basic, Mul, expand
from sympy.core.relational import Relational

from tresym.claims.translate import REMEMBERED, to_expression, to_given
from tresym.identity import decide, sign
from tresym.verdict import Verdict

NON_NEGATIVE = ("+", "0", ">=0")
DEPTH = 2
"""At most this many conditions are taken out of a sum."""


@lru_cache(maxsize=REMEMBERED)
def manifest_sign(e: Basic, conditions: tuple[Basic, ...], depth: int = DEPTH) -> str | None:
    """The proven sign of ``e`` under ``conditions``, or None.

    Where structure alone does not show it, ``e`` is split into a condition (``c > 0`` or
    ``c ≥ 0``) and a rest of known sign. SymPy's expansion only proposes the rest; that the two
    add up to ``e`` is decided exactly.
    """
    given = to_given(conditions)
    found = sign(to_expression(e), given)
    if found is None and isinstance(e, Mul):
        return _product([manifest_sign(factor, conditions, depth) for factor in e.args])
    if found is not None or depth == 0:
        return found
    for condition in conditions:
        if not isinstance(condition, Relational) or condition.rel_op not in (">", ">=", "<", "<="):
            continue
        known = condition.gts - condition.lts
        if known.is_Symbol or not known.free_symbols & e.free_symbols:
            continue
        rest = expand(e - known)
        rest_sign = manifest_sign(rest, conditions, depth - 1)
        if rest_sign not in NON_NEGATIVE:
            continue
        split = decide(to_expression(e), to_expression(known + rest), given, frozenset())
        if split.verdict is Verdict.PROVED:
            return "+" if rest_sign == "+" or condition.rel_op in (">", "<") else ">=0"
    return None


def _product(signs: list[str | None]) -> str | None:
    """The sign of a product of factors none of which is negative."""
    if not all(s in NON_NEGATIVE for s in signs):
        return None
    return "+" if set(signs) == {"+"} else ">=0"
