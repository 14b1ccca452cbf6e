"""Deciding identities between real elementary expressions, exactly.

What a claim means: equal at every real point of ``given`` where both sides are defined (see
decide.py for the exact promise). Only python-flint is loaded; SymPy only inside
:func:`from_sympy` and :func:`to_sympy`.
"""

from tresym.identity.bounds import nonzero_denominators, sign
from tresym.identity.decide import Decision, decide
from tresym.identity.evaluation import evaluate
from tresym.identity.expression import (
    Expr,
    differentiate,
    from_sympy,
    substitute,
    symbols,
    to_sympy,
    trees,
)
from tresym.identity.field import ALL_THEORIES
from tresym.identity.given import Given
from tresym.identity.parsing import parse, parse_claim

__all__ = [
    "ALL_THEORIES",
    "Decision",
    "Expr",
    "Given",
    "decide",
    "differentiate",
    "evaluate",
    "from_sympy",
    "nonzero_denominators",
    "parse",
    "parse_claim",
    "sign",
    "substitute",
    "symbols",
    "to_sympy",
    "trees",
]
