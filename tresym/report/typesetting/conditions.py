"""Gather conditions as a mathematician writes them: 0 < I₁ < I₂ < I₃, 0 < b ≤ 1."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import Any, NamedTuple

from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.ledger.formulas import Condition, in_trees, names_of, parts_of
from tresym.reals.language.binders import ordered
from tresym.reals.language.expression import ZERO, Expr, symbols
from tresym.reals.language.formula import Relation
from tresym.report.typesetting.latex import expression_latex, says_latex


class _Between(NamedTuple):
    """``low`` < ``high``, or ≤; both are symbols or numbers."""

    low: Expr
    high: Expr
    sign: str


def gathered(given: Sequence[Any]) -> list[str]:
    """Return the conditions in LaTeX, with bounds joined to chains.

    A bound that follows from a chain is left out. So is a condition on one symbol that follows from
    the bounds of that symbol, such as sin θ > 0.
    """
    found = [part for condition in given for part in parts_of(in_trees(condition))]
    bounds = {condition: bound for condition in found if (bound := _bound(condition)) is not None}
    found = [c for c in found if c in bounds or not _shown(c, tuple(bounds))]
    left = list(dict.fromkeys(bounds.values()))
    left = [bound for bound in left if not _follows(bound, left)]
    shown = []
    for condition in found:
        bound = bounds.get(condition)
        if bound is None:
            shown.append(says_latex(condition))
        elif bound in left:
            shown.append(_joined(_path_through(bound, left)))
    return list(dict.fromkeys(shown))


def _shown(condition: Condition, bounds: tuple[Relation, ...]) -> bool:
    """Whether the condition is about one symbol and follows from its bounds."""
    spoken_of = names_of(condition)
    own = tuple(bound for bound in bounds if names_of(bound) == spoken_of)
    return len(spoken_of) == 1 and bool(own) and _follows_from(condition, own)


@lru_cache(maxsize=1024)
def _follows_from(condition: Condition, bounds: tuple[Relation, ...]) -> bool:
    return isinstance(condition, Relation) and is_manifest(condition, bounds)


def _bound(condition: Condition) -> _Between | None:
    if not isinstance(condition, Relation) or condition.sign in ("==", "!="):
        return None
    high, sign, low = condition.upward
    if low == ZERO and high.op == "+" and len(high.args) == 2:
        negative = [term for term in high.args if (-term).op == "symbol"]
        if len(negative) == 1:
            (high,) = (term for term in high.args if term != negative[0])
            low = -negative[0]
    if not all(_is_plain(end) for end in (low, high)):
        return None
    return _Between(ordered(low), ordered(high), "<" if sign == ">" else r"\le")


def _is_plain(e: Expr) -> bool:
    return e.op == "symbol" or (-e).op == "symbol" or not (e.hidden or symbols(e))


def _follows(bound: _Between, bounds: list[_Between]) -> bool:
    """Whether a chain of other bounds connects the same ends, at least as strictly."""
    ends = [(b.high, b.sign == "<") for b in bounds if b.low == bound.low and b != bound]
    seen = set()
    while ends:
        end, strict = ends.pop()
        if end == bound.high and (strict or bound.sign != "<"):
            return True
        if (end, strict) not in seen and end.op == "symbol":
            seen.add((end, strict))
            ends += [(b.high, strict or b.sign == "<") for b in bounds if b.low == end]
    return False


def _path_through(bound: _Between, left: list[_Between]) -> list[_Between]:
    """A chain that contains ``bound``; its bounds are removed from ``left``."""
    left.remove(bound)
    path = [bound]
    while path[-1].high.op == "symbol" and (after := [b for b in left if b.low == path[-1].high]):
        path.append(after[0])
        left.remove(after[0])
    while path[0].low.op == "symbol" and (before := [b for b in left if b.high == path[0].low]):
        path.insert(0, before[0])
        left.remove(before[0])
    return path


def _joined(path: list[_Between]) -> str:
    if len(path) == 1 and path[0].low == ZERO:
        sign = ">" if path[0].sign == "<" else r"\ge"
        return f"{expression_latex(path[0].high)} {sign} 0"
    ends = "".join(f" {bound.sign} {expression_latex(bound.high)}" for bound in path)
    return expression_latex(path[0].low) + ends
