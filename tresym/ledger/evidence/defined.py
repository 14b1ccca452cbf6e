"""Where an expression is defined: every division, root and logarithm shown harmless.

A proof divides only where the denominator is shown non-zero and takes roots and logarithms only
where their arguments are shown to allow it, everywhere under the conditions given.
"""

from __future__ import annotations

from tresym.ledger.evidence.manifest import NON_NEGATIVE, manifest_sign
from tresym.ledger.meaning import Conditions, known
from tresym.reals.language.binders import elementary, generalised, worked_out
from tresym.reals.language.expression import LEAVES, UNWORKED, Expr, opened
from tresym.reals.places.domain import _needs
from tresym.reals.signs.sign import nonzero_denominators

SHOWING = {">": ("+",), ">=": NON_NEGATIVE, "!=": ("+", "-")}
"""The signs that show what an operation asks for."""


def undefined(e: Expr, given: Conditions) -> Expr | None:
    """The first part of ``e`` that is not shown to be defined under ``given``, or None.

    What is not worked out is not looked into; a value at a point is looked at in place.
    """
    if e.op in UNWORKED:
        if e.op != "at" or not elementary(opened(e)[1], *e.args[1:]):
            return None
        return undefined(worked_out(e), given)
    if e.op in LEAVES:
        return None
    for needed, relation in _asks(e):
        if not _shown(needed, relation, given):
            return needed
    return next((gap for arg in e.args if (gap := undefined(arg, given)) is not None), None)


def _shown(e: Expr, relation: str, given: Conditions) -> bool:
    if manifest_sign(e, given) in SHOWING[relation]:
        return True
    if relation != "!=":
        return False
    (plain,) = generalised(e)
    return nonzero_denominators(1 / plain, known(given)) is None


def continuous_on(e: Expr, given: Conditions) -> Expr | None:
    """As `undefined`, but roots must stay off zero: then ``e`` is smooth there.

    What is not worked out is not shown to be smooth.
    """
    if e.op in UNWORKED:
        return e
    if e.op in LEAVES:
        return None
    for needed, relation in (*_asks(e), *_kinks(e)):
        strict = ">" if relation == ">=" else relation
        if not _shown(needed, strict, given):
            return needed
    return next((gap for arg in e.args if (gap := continuous_on(arg, given)) is not None), None)


def _asks(e: Expr) -> list[tuple[Expr, str]]:
    """What the operation asks for; of arc sines by the square, which is known more often."""
    if e.op in ("asin", "acos", "atanh"):
        return [(1 - e.args[0] ** 2, ">" if e.op == "atanh" else ">=")]
    return _needs(e)


def _kinks(e: Expr) -> list[tuple[Expr, str]]:
    """What must not vanish where the operation is to be smooth."""
    return [(e.args[0], "!=")] if e.op in ("abs", "sign", "cbrt", "atan2") else []
