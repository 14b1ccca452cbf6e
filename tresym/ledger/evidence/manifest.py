"""Signs under SymPy conditions: the one prover of signs, asked in SymPy's language."""

from __future__ import annotations

from sympy import Basic, true
from sympy.core.relational import Relational

from tresym.ledger.meaning import to_expression, to_given
from tresym.reals.signs.sign import sign

NON_NEGATIVE = ("+", "0", ">=0")
PROVING = {
    ">": ("+",),
    ">=": NON_NEGATIVE,
    "<": ("-",),
    "<=": ("-", "0", "<=0"),
    "!=": ("+", "-", "!="),
}


def manifest_sign(e: Basic, conditions: tuple[Basic, ...], wanted: str | None = None) -> str | None:
    """The proven sign of ``e`` under ``conditions``, or None."""
    return sign(to_expression(e), to_given(conditions), wanted)


def is_stated(e: Basic, conditions: tuple[Basic, ...]) -> bool:
    """Whether a condition says as it stands that ``e`` is not negative."""
    return any(c.rel_op != "!=" and c.gts - c.lts == e for c in conditions)


def is_manifest(relation: Basic, conditions: tuple[Basic, ...]) -> bool:
    """Whether the proven sign of the difference of the two sides shows the inequality.

    SymPy has evaluated a relation of constants to true or false.
    """
    if not isinstance(relation, Relational):
        return relation is true
    wanted = relation.rel_op
    if wanted not in PROVING:
        return False
    return manifest_sign(relation.lhs - relation.rhs, conditions, wanted) in PROVING[wanted]
