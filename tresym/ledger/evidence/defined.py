"""Where SymPy expressions are defined: the one table, asked in SymPy's language."""

from __future__ import annotations

from sympy import Basic, Derivative, Integral, Subs

from tresym.ledger.meaning import to_expression, to_given
from tresym.reals.language.expression import Expr
from tresym.reals.signs import defined

Conditions = tuple[Basic, ...]


def undefined(e: Basic, given: Conditions) -> Expr | None:
    """The first part of ``e`` that is not shown to be defined under ``given``, or None.

    An integral or a derivative has conditions of its own; what is put in is looked at in place.
    """
    return defined.undefined(to_expression(_put_in(e)), to_given(given))


def _put_in(e: Basic) -> Basic:
    if isinstance(e, Integral | Derivative) or not e.has(Subs):
        return e
    if isinstance(e, Subs):
        if e.has(Integral, Derivative):
            return e
        return e.expr.xreplace(dict(zip(e.variables, e.point, strict=True)))
    return e.func(*map(_put_in, e.args))


def continuous_on(e: Basic, given: Conditions) -> Basic | Expr | None:
    """As `undefined`, but roots must stay off zero: then ``e`` is smooth there.

    A substitution or an integral inside ``e`` has variables that the conditions do not mean.
    """
    hidden = e.atoms(Integral, Subs)
    if hidden:
        return hidden.pop()
    inner = (node.expr for node in e.atoms(Derivative))
    trees = (to_expression(part) for part in (e, *inner))
    return next(filter(None, (defined.continuous_on(t, to_given(given)) for t in trees)), None)
