"""Ask the sign prover, and the table of domains, under the conditions of a claim.

A number that is not worked out, such as an integral, is a variable of which nothing is known.
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
    """The proven sign of ``e`` under the conditions, or None; as :func:`sign_by`."""
    (e,) = generalised(e)
    return sign_by(e, known(given), wanted, proof_for_ledger)


def is_stated(e: Expr, given: Conditions) -> bool:
    """Whether a condition says as it stands that ``e`` is not negative."""
    up = (c.upward for c in given if c.sign != "!=")
    return any(ordered(c.left - c.right) == ordered(e) for c in up)


def is_manifest(relation: Relation, given: Conditions) -> bool:
    """Whether the proven sign of the difference of the two sides shows the inequality."""
    if relation.sign == "==":
        return False
    up = relation.upward
    return manifest_sign(up.left - up.right, given, up.sign) in PROVING[up.sign]


def undefined(e: Expr, given: Conditions) -> Expr | None:
    """The first part of ``e`` that is not shown to be defined under ``given``, or None."""
    return definedness.undefined(e, known(given))


def continuous_on(e: Expr, given: Conditions) -> Expr | None:
    """The first part of ``e`` that is not shown to stay off its singularities, or None."""
    return definedness.continuous_on(e, known(given))
