"""Ask the sign prover, and the table of domains, under the conditions of a claim.

An unevaluated integral, derivative or limit is treated as a variable about which nothing is known.
"""

from __future__ import annotations

from tresym.ledger.conversion import Conditions, known
from tresym.reals.language.binders import generalised, ordered
from tresym.reals.language.expression import Expr
from tresym.reals.language.formula import Relation
from tresym.reals.signs import definedness
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import proof_for_ledger, sign_by

NON_NEGATIVE = PROVING[">="]


def manifest_sign(e: Expr, given: Conditions, wanted: str | None = None) -> str | None:
    """Return the proved sign of ``e`` under the conditions, or None.

    Args:
        e: the expression.
        given: the conditions.
        wanted: the relation of ``e`` to zero that is needed (``> >= < <= !=``); expensive methods
            are tried only for its sake.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"`` or ``"<=0"``, as :func:`sign_by`; ``"!="`` if that is
        wanted and no more is proved; None if nothing is proved.
    """
    (e,) = generalised(e)
    return sign_by(e, known(given), wanted, proof_for_ledger)


def is_stated(e: Expr, given: Conditions) -> bool:
    """Return whether one of the conditions literally states ``e >= 0`` or ``e > 0``."""
    up = (c.upward for c in given if c.sign != "!=")
    return any(ordered(c.left - c.right) == ordered(e) for c in up)


def is_manifest(relation: Relation, given: Conditions) -> bool:
    """Return whether the sign prover shows the inequality; always False for an equation."""
    if relation.sign == "==":
        return False
    up = relation.upward
    return manifest_sign(up.left - up.right, given, up.sign) in PROVING[up.sign]


def undefined(e: Expr, given: Conditions) -> Expr | None:
    """Return the first subexpression that is not shown to be defined under ``given``, or None."""
    return definedness.undefined(e, known(given))


def continuous_on(e: Expr, given: Conditions) -> Expr | None:
    """Return the first subexpression not shown to be continuous under ``given``, or None."""
    return definedness.continuous_on(e, known(given))
