"""Search for repairs of refuted claims of the ledger, to compare them with the corrections.

The search is :func:`tresym.repair.search.alternatives`: statements that differ by one edit,
or that have a natural condition added. It is tried only for a single comparison of elementary
expressions of moderate size. The time limit is generous, so that slow machines find the same.
"""

from __future__ import annotations

from typing import NamedTuple

from tresym.ledger.claim import Claim
from tresym.ledger.formulas import relations_of
from tresym.reals.decisions.answer import Alternative
from tresym.reals.decisions.claim_parsing import stated
from tresym.reals.decisions.statement import Statement
from tresym.reals.language.binders import elementary
from tresym.reals.language.compound import Together
from tresym.reals.language.formula import Relation
from tresym.reals.numbers.exact import InputError
from tresym.repair.search import alternatives

SECONDS = 60.0
"""Time limit for one claim."""
MOST_SIZE = 60
"""The largest expression size of a claim for which a repair is searched."""


class Searched(NamedTuple):
    """Whether a repair was looked for, and what was found."""

    tried: bool
    found: Alternative | None = None


def search(claim: Claim) -> Searched:
    """Search for a true statement near a refuted claim.

    Returns:
        ``tried`` is False if the claim is a sentence, not elementary, or too large; ``found`` is
        None if no repair was found.
    """
    formula = claim.says if claim.means is None else claim.means
    if not isinstance(formula, Relation) or not elementary(formula.left, formula.right):
        return Searched(False)
    try:
        given = tuple((c.left, c.sign, c.right) for c in relations_of(Together(claim.given)))
        statement = stated(((formula.left, formula.sign, formula.right),), given)
    except InputError:
        return Searched(False)
    if _size(statement) > MOST_SIZE:
        return Searched(False)
    found = alternatives(statement.read_as, SECONDS, 1, (), False, False)
    return Searched(True, found[0] if found else None)


def _size(statement: Statement) -> int:
    return sum(c.left.size + c.right.size for c in statement.comparisons)
