"""Signs that are manifest: by structure and ranges, or as a sum of conditions known to hold."""

from __future__ import annotations

from functools import lru_cache

from sympy import Basic, Mul, cos, expand, pi, sin, true
from sympy.core.relational import Relational

from tresym.ledger.meaning import REMEMBERED, to_expression, to_given
from tresym.reals.decisions.identity import decide
from tresym.reals.signs.sign import sign
from tresym.reals.verdict import Verdict

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
    found = sign(to_expression(e), to_given(conditions))
    if found in ("+", "-", "0", "<=0"):
        return found
    if isinstance(e, sin | cos):
        found = _in_half_turn(e, conditions) or found
    if isinstance(e, Mul):
        found = _product([manifest_sign(f, conditions, depth) for f in e.args]) or found
    if found == "+" or depth == 0 or (found == ">=0" and isinstance(e, Mul)):
        return found
    by_parts = _split(e, conditions, depth)
    return "+" if by_parts == "+" else found or by_parts


def is_stated(e: Basic, conditions: tuple[Basic, ...]) -> bool:
    """Whether a condition says as it stands that ``e`` is not negative."""
    return any(c.rel_op != "!=" and c.gts - c.lts == e for c in conditions)


def _split(e: Basic, conditions: tuple[Basic, ...], depth: int) -> str | None:
    """The sign of ``e`` as a condition and a rest that is not negative."""
    found = None
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
        if _are_equal(e, known + rest, conditions):
            if rest_sign == "+" or condition.rel_op in (">", "<"):
                return "+"
            found = ">=0"
    return found


def _are_equal(e: Basic, parts: Basic, conditions: tuple[Basic, ...]) -> bool:
    """Under no conditions, as sums mostly are, or under these, where points are hard to find."""
    left, right = to_expression(e), to_expression(parts)
    worlds = (to_given(given) for given in ((), conditions))
    return any(decide(left, right, w, frozenset()).verdict is Verdict.PROVED for w in worlds)


def _in_half_turn(e: Basic, conditions: tuple[Basic, ...]) -> str | None:
    """``+`` inside the half turn where the sine or cosine is positive, ``>=0`` with its ends."""
    (angle,) = e.args
    ends = (angle, pi - angle) if isinstance(e, sin) else (angle + pi / 2, pi / 2 - angle)
    return _product([manifest_sign(end, conditions) for end in ends])


def is_manifest(relation: Basic, conditions: tuple[Basic, ...]) -> bool:
    """Whether the proven sign of the difference of the two sides shows the inequality.

    SymPy has evaluated a relation of constants to true or false.
    """
    if not isinstance(relation, Relational):
        return relation is true
    allowed = {
        ">": ("+",),
        ">=": ("+", "0", ">=0"),
        "<": ("-",),
        "<=": ("-", "0", "<=0"),
        "!=": ("+", "-"),
    }.get(relation.rel_op, ())
    return manifest_sign(relation.lhs - relation.rhs, conditions) in allowed


def _product(signs: list[str | None]) -> str | None:
    """The sign of a product of factors none of which is negative."""
    if not all(s in NON_NEGATIVE for s in signs):
        return None
    return "+" if set(signs) == {"+"} else ">=0"
