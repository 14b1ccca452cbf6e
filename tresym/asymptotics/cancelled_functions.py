"""Claims along a path in which special functions cancel: x (Γ(x + 1) - x Γ(x)) is 0.

The leading terms of Γ(x + 1) and x Γ(x) are the same, as are all later ones, so that no expansion
says how small the difference is. Their recurrences do: Γ(x + 1) = x Γ(x), J₂ = 2 J₁/x - J₀. Where
the normal form of both sides is free of special functions, the claim is one about elementary
functions, and (n + 2)!/n! = (n + 1) (n + 2) needs no series of Stirling.
"""

from __future__ import annotations

from dataclasses import replace

from flint import arb

from tresym.reals.decisions.answer import Answer, Decide
from tresym.reals.decisions.gamma_forms import with_gamma
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.evaluation import stands
from tresym.reals.domain.operation_domains import needs, operations
from tresym.reals.expansions.leading_terms import leading_sign
from tresym.reals.functions.table import SPECIAL
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, integer, number, substitute, symbols
from tresym.reals.language.like_terms import collected
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.verdict import Verdict


def decide_cancelled(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide a claim along a path of which all special functions cancel; None for any other.

    Factorials speak of integers alone, so that a claim with factorials is not refuted here.
    """
    path = statement.path
    sides = claim.left, claim.right
    plain = tuple(map(with_gamma, sides))
    if path is None or claim.derivatives or statement.equations or any(e.hidden for e in plain):
        return None
    if not any(map(_has_special, plain)):
        return None
    if plain != sides and not _is_among_integers(sides, path):
        return None
    given = statement.given
    left, right = (normal_form(e, given) if _has_special(e) else e for e in plain)
    if _has_special(left) or _has_special(right):
        return None
    pairs = zip(plain, (left, right), strict=True)
    if any(
        new is not old and decide(old, new, given).verdict is not Verdict.PROVED
        for old, new in pairs
    ):
        return None
    if not _is_real(plain, path, statement):
        return None
    found = decided(replace(claim, left=left, right=right), statement)
    if found.verdict is Verdict.UNDECIDED or (plain != sides and not found):
        return None
    why = f"by the recurrences of special functions, the claim is one about {left}: {found.why}"
    return replace(found, why=why)


def _is_among_integers(sides: tuple[Expr, ...], path: Path) -> bool:
    """Return whether the arguments of factorials are integers at points on the way to oo."""
    arguments = [node.args[1] for e in sides for node in functions(e)]
    at = (substitute(e, dict.fromkeys(symbols(e), number(720))) for e in arguments)
    return path.point is None and all(integer(collected(e)) is not None for e in at)


def _has_special(e: Expr) -> bool:
    return any(node.op in SPECIAL for node in operations((e,)))


def _is_real(sides: tuple[Expr, ...], path: Path, statement: Statement) -> bool:
    """Return whether the sides are proved to be real near the end of the path."""
    for e, relation in needs([e for e in sides if e not in (INFINITY, -INFINITY)]):
        for side in path.sides:
            found = leading_sign(e, path.name, path.point, side, statement.given)
            if found is None or not stands(arb(found), relation):
                return False
    return True
