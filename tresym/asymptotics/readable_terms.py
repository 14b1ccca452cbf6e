"""Write leading terms so that a person can read them.

The expansion of a function gives its leading term as a product whose exponents are what the
algorithm made of the function. As t → 0+ the term ``t**2*exp(-1)*exp(pi*pi*sqrt(t**-2)/(-pi))`` is
``t**2*exp(-1 - pi/t)``: factors of e are joined, and the exponent is brought to its normal form,
in which t is positive. The value is the same wherever the condition holds.
"""

from __future__ import annotations

from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import LEAVES, Expr, add, apply, multiply, rebuild, symbol
from tresym.reals.normal.to_expression import normal_form


def readable(e: Expr, name: str, side: int) -> Expr:
    """Return an expression with an equal value that is at most as long as ``e``.

    Args:
        e: a leading term.
        name: the variable of the path.
        side: 1 if the variable is positive near the end of the path, −1 if it is negative, 0 if
            neither is known.
    """
    x = symbol(name)
    given = Given(((x, ">" if side > 0 else "<", x - x),)) if side else Given()
    joined = _joined(e)
    shorter = _walk(joined, given)
    whole = normal_form(shorter, given) if "exp" not in str(shorter) else shorter
    return min((e, joined, shorter, whole), key=lambda form: len(str(form)))


def _walk(e: Expr, given: Given) -> Expr:
    """The expression with every exponent of e in its normal form where that is shorter."""
    if e.op in LEAVES:
        return e
    if e.op in ("exp", "sqrt", "log"):
        inner = e.args[0]
        forms = (inner, _walk(inner, given), normal_form(inner, given))
        return apply(e.op, min(forms, key=lambda form: len(str(form))))
    if e.op not in ("+", "*", "^", "/"):
        return e
    return rebuild(e, tuple(_walk(part, given) for part in e.args))


def _joined(e: Expr) -> Expr:
    """The product with its factors exp(a) and exp(b) as one factor exp(a + b)."""
    if e.op != "*":
        return e
    exponents = [factor.args[0] for factor in e.args if factor.op == "exp"]
    if len(exponents) < 2:
        return e
    others = [factor for factor in e.args if factor.op != "exp"]
    return multiply(*others, apply("exp", add(*exponents)))
