"""What the search for repairs finds for refuted claims of the ledger, beside the amendments.

The search is that of :mod:`tresym.reals.repair.search`: one edit away, natural conditions. It is
tried for single comparisons of elementary expressions that are not too long, with so much time
that a slower machine finds the same.
"""

from __future__ import annotations

from typing import NamedTuple

from tresym.ledger.claim import Claim
from tresym.reals.decisions.answer import Alternative
from tresym.reals.decisions.claim_parsing import Statement, read
from tresym.reals.numbers.exact import InputError
from tresym.reals.repair.search import alternatives

SECONDS = 60.0
MOST_SIZE = 60
"""Terms and operations of a claim, beyond which no repair is looked for."""


class Searched(NamedTuple):
    """Whether a repair was looked for, and what was found."""

    tried: bool
    found: Alternative | None = None


def search(claim: Claim) -> Searched:
    """Look for what is true instead of a refuted claim."""
    formula = claim.says if claim.means is None else claim.means
    try:
        statement = read(formula, claim.given)
    except (InputError, TypeError, AttributeError):
        return Searched(False)
    if isinstance(formula, str) or _size(statement) > MOST_SIZE:
        return Searched(False)
    found = alternatives(statement.read_as, SECONDS, 1, (), False, False)
    return Searched(True, found[0] if found else None)


def _size(statement: Statement) -> int:
    return sum(c.left.size + c.right.size for c in statement.comparisons)
