"""Prove the sign of an expression: the methods in one list, cheapest first.

:func:`sign` and :func:`proof` are the entry points. For example, exp(x) − 1 − x is not negative:
the signs of its parts say nothing, and it is not a polynomial, but Taylor's theorem about 0 proves
it. A method in :data:`METHODS` takes
a difference, a relation to zero and the conditions. It returns a sentence that proves the relation
in the interior of the conditions and, by continuity, at the limits of interior points; or it
returns None.

Only the first method also proves the relation at isolated points of the conditions, so it is tried
first. The results of the others count only where the conditions are shown to have no isolated
points (see :mod:`tresym.reals.signs.closure`).

The claims of the ledger need only the few methods in :data:`FEW`, so that the trusted code of the
ledger does not include the others.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import lru_cache, partial

from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import generalised
from tresym.reals.language.expression import Expr
from tresym.reals.signs.absolute_value_cases import MAX_CASES, by_cases
from tresym.reals.signs.closure import has_inside, is_regular
from tresym.reals.signs.concavity import sign_by_concavity
from tresym.reals.signs.interior import (
    PROVING,
    REMEMBERED,
    by_signs_of_parts,
    jumps,
    sign_inside,
    strict_by_conditions,
)
from tresym.reals.signs.polynomials import sign_of_polynomial
from tresym.reals.signs.structural import FLIP, signs_of_parts, signs_seen
from tresym.reals.signs.taylor import sign_by_taylor
from tresym.reals.signs.transformations import by_equivalents

METHODS: tuple[Callable[..., str | None], ...] = (
    by_signs_of_parts,
    sign_of_polynomial,
    sign_by_concavity,
    sign_by_taylor,
    by_cases,
    by_equivalents,
)
"""Every method, cheapest first. Each docstring states the method, an example and its limits."""
DIRECT = METHODS[:4]
"""The methods that work on a difference without splitting cases or transforming it."""
FEW = (by_signs_of_parts, sign_by_concavity, sign_by_taylor)
"""The direct methods that claims of the ledger need."""
Prover = Callable[[Expr, str, Given], str | None]
"""A function with the signature of :func:`proof`, without the number of cases."""


def proof(difference: Expr, relation: str, given: Given, cases: int = MAX_CASES) -> str | None:
    """Prove ``difference relation 0`` in the interior of ``given`` and at limits of its points.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        given: the conditions.
        cases: how many nested absolute values may be split by the sign of their arguments.

    Returns:
        A sentence that states the proof, or None if no method succeeds.
    """
    (difference,) = generalised(difference)
    sentence = directly(difference, relation, given)
    if sentence is None and cases:
        sentence = by_cases(difference, relation, given, partial(proof, cases=cases - 1))
    return by_equivalents(difference, relation, given, directly) if sentence is None else sentence


def directly(difference: Expr, relation: str, given: Given) -> str | None:
    """Prove the relation as :func:`proof` does, without splitting cases or transforming it."""
    sentences = (method(difference, relation, given) for method in DIRECT)
    return next((sentence for sentence in sentences if sentence is not None), None)


def proof_for_ledger(difference: Expr, relation: str, given: Given) -> str | None:
    """Prove the relation as :func:`proof` does, with only the methods that ledger claims need."""
    sentence = _by_few(difference, relation, given)
    return by_equivalents(difference, relation, given, _by_few) if sentence is None else sentence


def _by_few(difference: Expr, relation: str, given: Given) -> str | None:
    """Try the methods in :data:`FEW`."""
    sentences = (method(difference, relation, given) for method in FEW)
    return next((sentence for sentence in sentences if sentence is not None), None)


def sign(e: Expr, given: Given, wanted: str | None = None, dear: bool = True) -> str | None:
    """Return the proven sign of ``e`` at every point where ``given`` holds and ``e`` is defined.

    Args:
        e: the expression.
        given: the conditions.
        wanted: the relation that the caller needs, as for :func:`sign_by`.
        dear: whether all methods may be tried. If false, only the cheap methods are used.

    Returns:
        As for :func:`sign_by`.

    Example:
        >>> from tresym.reals.domain.conditions import Given
        >>> from tresym.reals.language.expression import ONE, symbol
        >>> sign(symbol("x") ** 2 + ONE, Given())
        '+'
    """
    return sign_by(e, given, wanted, proof if dear else None)


@lru_cache(maxsize=REMEMBERED)
def sign_by(
    e: Expr, given: Given, wanted: str | None = None, prover: Prover | None = None
) -> str | None:
    """Return the proven sign of ``e``, with the expensive methods that the caller chooses.

    Args:
        e: the expression.
        given: the conditions.
        wanted: a relation of ``e`` to zero: ``> >= < <= !=``. The expensive methods are tried only
            for this relation, and not at all once it is proved. None means that no relation is
            sought.
        prover: the expensive methods, such as :func:`proof`; None for none.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"`` or ``"<=0"``; ``"!="`` if that was wanted and nothing
        stronger is proved; None if nothing is proved.
    """
    (e,) = generalised(e)
    if wanted in ("<", "<="):
        return FLIP[sign_by(-e, given, wanted.replace("<", ">"), prover)]
    enough = ("+", "-", "0") if wanted is None else PROVING[wanted]
    parts = signs_of_parts(e, given)
    its_sign = parts.sign
    if its_sign in enough or its_sign in ("+", "-", "0"):
        return its_sign
    if wanted == "!=" and parts.nonzero:
        return "!="
    if its_sign is None and len(signs_seen(e, given)) > 1:
        return None
    if not (is_regular(given) and has_inside(given)):
        return its_sign
    its_sign = sign_inside(e, given) or its_sign
    if its_sign in (">=0", "<=0") and wanted in (">", "!="):
        up, side = ("+", e) if its_sign == ">=0" else ("-", -e)
        its_sign = up if strict_by_conditions(side, given) else its_sign
    if prover is None or wanted is None or its_sign in (*enough, "+", "-", "0"):
        return its_sign
    if its_sign == "<=0" and wanted == ">":
        return its_sign
    if jumps((e,), given):
        return (
            its_sign  # the methods prove almost all points, which says nothing about points of jump
        )
    against = signs_seen(e, given)
    for up, side in (("+", e), ("-", -e))[: 1 + (wanted == "!=")]:
        if (-1 if up == "+" else 1) in against:
            continue
        if prover(side, wanted.replace("!=", ">"), given) is not None:
            return ">=0" if wanted == ">=" else up
    return its_sign
