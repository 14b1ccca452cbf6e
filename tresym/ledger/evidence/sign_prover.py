"""Ask the sign prover, and the table of domains, under the conditions of a claim.

An unevaluated integral, derivative or limit is treated as a variable about which nothing is known.
"""

from __future__ import annotations

from tresym.ledger.conversion import Conditions, known
from tresym.ledger.formulas import in_order
from tresym.reals.language.binders import generalised
from tresym.reals.language.expression import LEAVES, ZERO, Expr, multiply, number, rebuild
from tresym.reals.language.formula import Relation
from tresym.reals.language.like_terms import collected
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
    return any(in_order(c.left - c.right) == in_order(e) for c in up)


def is_manifest(relation: Relation, given: Conditions) -> bool:
    """Return whether the sign prover shows the inequality; always False for an equation."""
    if relation.sign == "==":
        return False
    up = relation.upward
    difference = collected(up.left - up.right)
    return manifest_sign(difference, given, up.sign) in PROVING[up.sign]


def undefined(e: Expr, given: Conditions) -> Expr | None:
    """Return the first subexpression that is not shown to be defined under ``given``, or None."""
    return definedness.undefined(shortened(e, given), known(given))


def shortened(e: Expr, given: Conditions) -> Expr:
    """Return the expression with (√x)⁻³ and such as one power of x, where x is shown positive.

    A product with a factor 0 is 0 where the others are shown to have values. The result has a value
    where the expression has one.
    """
    if e.op in LEAVES or e.names:
        return e
    args = tuple(shortened(arg, given) for arg in e.args)
    e = e if args == e.args else rebuild(e, args)
    if e.op == "*" and e.args[0] == ZERO:
        defined = definedness.undefined(multiply(*e.args[1:]), known(given)) is None
        return ZERO if defined else e
    inner = e.args[0] if e.op == "^" else e
    if e.op != "^" or inner.op != "^" or {e.args[1].op, inner.args[1].op} != {"number"}:
        return e
    x, r, exponent = inner.args[0], inner.args[1].args[0], e.args[1].args[0]
    if r.q == 1 or not is_manifest(Relation(x, ">", ZERO), given):
        return e
    return x ** number(r * exponent)


def continuous_on(e: Expr, given: Conditions) -> Expr | None:
    """Return the first subexpression not shown to be continuous under ``given``, or None."""
    return definedness.continuous_on(e, known(given))
