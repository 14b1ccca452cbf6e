"""Where an expression is defined: every division, root and logarithm shown harmless.

A proof divides only where the denominator is shown non-zero and takes roots and logarithms only
where their arguments are shown to allow it, everywhere under the conditions given.
"""

from __future__ import annotations

from sympy import (
    Abs,
    Basic,
    Derivative,
    Integral,
    Pow,
    Rational,
    Subs,
    acos,
    acosh,
    asin,
    atanh,
    cos,
    cot,
    coth,
    csc,
    log,
    sec,
    sign,
    sin,
    sinh,
    tan,
)

from tresym.ledger.evidence.manifest import NON_NEGATIVE, manifest_sign
from tresym.ledger.meaning import to_expression, to_given
from tresym.reals.signs.sign import nonzero_denominators

POSITIVE = ("+",)
NON_ZERO = ("+", "-")

Conditions = tuple[Basic, ...]


def undefined(e: Basic, given: Conditions) -> Basic | None:
    """The first part of ``e`` that is not shown to be defined under ``given``, or None."""
    for condition, allowed in _conditions(e):
        if not _shown(condition, allowed, given):
            return condition
    if isinstance(e, Subs) and not e.has(Integral, Derivative):
        return undefined(e.expr.xreplace(dict(zip(e.variables, e.point, strict=True))), given)
    if isinstance(e, Integral | Derivative | Subs):
        return None
    for argument in e.args:
        found = undefined(argument, given)
        if found is not None:
            return found
    return None


def _shown(e: Basic, allowed: tuple[str, ...], given: Conditions) -> bool:
    if manifest_sign(e, given) in allowed:
        return True
    reciprocal = to_expression(1 / e)
    return allowed == NON_ZERO and nonzero_denominators(reciprocal, to_given(given)) is None


def _conditions(e: Basic) -> list[tuple[Basic, tuple[str, ...]]]:
    """What must be so for the outermost operation of ``e`` to be defined."""
    match e:
        case Pow():
            base, exponent = e.args
            if not isinstance(exponent, Rational):
                return [] if base.is_positive else [(base, POSITIVE)]
            if exponent.is_integer:
                return [(base, NON_ZERO)] if exponent < 0 else []
            return [(base, POSITIVE if exponent < 0 else NON_NEGATIVE)]
        case log():
            return [(e.args[0], POSITIVE)]
        case asin() | acos():
            return [(1 - e.args[0] ** 2, NON_NEGATIVE)]
        case atanh():
            return [(1 - e.args[0] ** 2, POSITIVE)]
        case acosh():
            return [(e.args[0] - 1, NON_NEGATIVE)]
        case tan() | sec():
            return [(cos(e.args[0]), NON_ZERO)]
        case cot() | csc():
            return [(sin(e.args[0]), NON_ZERO)]
        case coth():
            return [(sinh(e.args[0]), NON_ZERO)]
        case _:
            return []


def continuous_on(e: Basic, given: Conditions) -> Basic | None:
    """As `undefined`, but roots must stay off zero: then ``e`` is smooth there.

    A substitution or an integral inside ``e`` has variables that the conditions do not mean.
    """
    for node in _nodes(e):
        if isinstance(node, Integral | Subs):
            return node
        strict = isinstance(node, Pow) and node.exp.is_Rational and not node.exp.is_integer
        for condition, allowed in _conditions(node):
            wanted = POSITIVE if strict or isinstance(node, asin | acos | acosh) else allowed
            if manifest_sign(condition, given) not in wanted:
                return condition
        if isinstance(node, Abs | sign) and manifest_sign(node.args[0], given) not in NON_ZERO:
            return node.args[0]
    return None


def _nodes(e: Basic) -> list[Basic]:
    return [e, *(node for argument in e.args for node in _nodes(argument))]
