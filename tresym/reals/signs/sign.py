"""Prove the sign of an expression: the methods in one list, cheapest first.

A method is a function of a difference, a relation to zero and the conditions, and gives a sentence
that proves the relation where the conditions hold inside, and at limits from there; or None. Only
the first shows it at every single point, and is asked first; the others count where the conditions
are shown to have no other points.

What claims of the ledger need is shown by few of them: its judge does without the others.
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
from tresym.reals.signs.homogenisation import sign_by_homogeneity
from tresym.reals.signs.interior import (
    PROVING,
    REMEMBERED,
    by_signs_of_parts,
    jumps,
    sign_inside,
    strict_by_conditions,
)
from tresym.reals.signs.orthant_cones import sign_on_cones
from tresym.reals.signs.polynomials import sign_of_polynomial
from tresym.reals.signs.structural import FLIP, Parts
from tresym.reals.signs.taylor import sign_by_taylor
from tresym.reals.signs.transformations import by_equivalents

METHODS: tuple[Callable[..., str | None], ...] = (
    by_signs_of_parts,
    sign_on_cones,
    sign_by_homogeneity,
    sign_of_polynomial,
    sign_by_concavity,
    sign_by_taylor,
    by_cases,
    by_equivalents,
)
"""Every method, cheapest first. Each says what it does, an example, and where it ends."""
DIRECT = METHODS[:6]
"""Those that look at a difference as it stands."""
FEW = (by_signs_of_parts, sign_by_concavity, sign_by_taylor)
"""Those of them that claims of the ledger need."""
Prover = Callable[[Expr, str, Given], str | None]
"""What :func:`proof` does."""


def proof(difference: Expr, relation: str, given: Given, cases: int = MAX_CASES) -> str | None:
    """A sentence that proves ``difference relation 0`` inside ``given`` and at limits from there.

    Args:
        difference: what is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        given: the conditions.
        cases: how many absolute values may be taken apart, one in the other.
    """
    (difference,) = generalised(difference)
    found = directly(difference, relation, given)
    if found is None and cases:
        found = by_cases(difference, relation, given, partial(proof, cases=cases - 1))
    return by_equivalents(difference, relation, given, directly) if found is None else found


def directly(difference: Expr, relation: str, given: Given) -> str | None:
    """As :func:`proof`, of the difference as it stands."""
    found = (method(difference, relation, given) for method in DIRECT)
    return next((sentence for sentence in found if sentence is not None), None)


def proof_for_ledger(difference: Expr, relation: str, given: Given) -> str | None:
    """As :func:`proof`, by the methods that the claims of the ledger need."""
    found = _by_few(difference, relation, given)
    return by_equivalents(difference, relation, given, _by_few) if found is None else found


def _by_few(difference: Expr, relation: str, given: Given) -> str | None:
    found = (method(difference, relation, given) for method in FEW)
    return next((sentence for sentence in found if sentence is not None), None)


def sign(e: Expr, given: Given, wanted: str | None = None, dear: bool = True) -> str | None:
    """The proven sign of ``e`` at every point where ``given`` holds and ``e`` is defined.

    Args:
        wanted: as of :func:`sign_by`.
        dear: whether all methods may be tried, and not those alone that show every single point.
    """
    return sign_by(e, given, wanted, proof if dear else None)


@lru_cache(maxsize=REMEMBERED)
def sign_by(
    e: Expr, given: Given, wanted: str | None = None, prover: Prover | None = None
) -> str | None:
    """As :func:`sign`, with dear methods of one's choice.

    Args:
        wanted: a relation of ``e`` to zero, ``> >= < <= !=``. Dear methods are tried for its sake
            alone, and none once it is proved.
        prover: the dear methods, of which none may be tried.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"``, ``"<=0"``, or None where nothing is proved; ``"!="``
        where that is wanted, and no more is proved.
    """
    (e,) = generalised(e)
    if wanted in ("<", "<="):
        return FLIP[sign_by(-e, given, wanted.replace("<", ">"), prover)]
    enough = ("+", "-", "0") if wanted is None else PROVING[wanted]
    parts = Parts(given)
    found = parts.sign(e)
    if found in enough or found in ("+", "-", "0"):
        return found
    if wanted == "!=" and parts.nonzero(e):
        return "!="
    if not (is_regular(given) and has_inside(given)):
        return found
    found = sign_inside(e, given) or found
    if found in (">=0", "<=0") and wanted in (">", "!="):
        up, side = ("+", e) if found == ">=0" else ("-", -e)
        found = up if strict_by_conditions(side, given) else found
    if prover is None or wanted is None or found in (*enough, "+", "-", "0"):
        return found
    if jumps((e,), given):
        return found  # a proof of almost all points says nothing of those where it jumps
    for up, side in (("+", e), ("-", -e))[: 1 + (wanted == "!=")]:
        if prover(side, wanted.replace("!=", ">"), given) is not None:
            return ">=0" if wanted == ">=" else up
    return found
