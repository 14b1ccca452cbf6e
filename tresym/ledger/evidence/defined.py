"""Where expressions are defined, asked under the conditions of a claim."""

from __future__ import annotations

from tresym.ledger.meaning import Conditions, known
from tresym.reals.language.expression import Expr
from tresym.reals.signs import defined


def undefined(e: Expr, given: Conditions) -> Expr | None:
    """The first part of ``e`` that is not shown to be defined under ``given``, or None."""
    return defined.undefined(e, known(given))


def continuous_on(e: Expr, given: Conditions) -> Expr | None:
    """The first part of ``e`` that is not shown to stay off its singularities, or None."""
    return defined.continuous_on(e, known(given))
