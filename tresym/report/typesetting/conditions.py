"""Gather conditions as a mathematician writes them: 0 < I₁ < I₂ < I₃, 0 < b ≤ 1."""

from __future__ import annotations

from collections.abc import Sequence
from functools import lru_cache
from typing import NamedTuple

from sympy import Add, Basic, Expr, Integer, true
from sympy.core.relational import GreaterThan, LessThan, StrictGreaterThan, StrictLessThan

from tresym.ledger.conversion import conditions
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.report.typesetting.latex import expression_latex, says_latex


class _Between(NamedTuple):
    """``low`` < ``high``, or ≤; both are symbols or numbers."""

    low: Expr
    high: Expr
    sign: str


def gathered(given: Sequence[Basic]) -> list[str]:
    """Return the conditions in LaTeX, with bounds joined to chains.

    A bound that follows from a chain is left out. So is a condition on one symbol that follows from
    the bounds of that symbol, such as sin θ > 0.
    """
    bounds = {condition: bound for condition in given if (bound := _bound(condition)) is not None}
    given = [c for c in given if c in bounds or not _shown(c, tuple(bounds))]
    left = list(dict.fromkeys(bounds.values()))
    left = [bound for bound in left if not _follows(bound, left)]
    shown = []
    for condition in given:
        bound = bounds.get(condition)
        if condition == true:
            continue
        if bound is None:
            shown.append(says_latex(condition))
        elif bound in left:
            shown.append(_joined(_path_through(bound, left)))
    return list(dict.fromkeys(shown))


def _shown(condition: Basic, bounds: tuple[Basic, ...]) -> bool:
    """Whether the condition is about one symbol and follows from its bounds."""
    spoken_of = condition.free_symbols
    own = tuple(bound for bound in bounds if bound.free_symbols == spoken_of)
    return len(spoken_of) == 1 and bool(own) and _follows_from(condition, own)


@lru_cache(maxsize=1024)
def _follows_from(condition: Basic, bounds: tuple[Basic, ...]) -> bool:
    return all(is_manifest(part, conditions(bounds)) for part in conditions((condition,)))


def _bound(condition: Basic) -> _Between | None:
    if not isinstance(condition, GreaterThan | StrictGreaterThan | LessThan | StrictLessThan):
        return None
    low, high = condition.lts, condition.gts
    if low == 0 and isinstance(high, Add) and len(high.args) == 2:
        negative = [term for term in high.args if (-term).is_Symbol]
        if len(negative) == 1:
            low, high = -negative[0], high - negative[0]
    if not all(_is_plain(end) for end in (low, high)):
        return None
    strict = isinstance(condition, StrictGreaterThan | StrictLessThan)
    return _Between(low, high, "<" if strict else r"\le")


def _is_plain(e: Expr) -> bool:
    return bool(e.is_Symbol or e.is_number or (-e).is_Symbol)


def _follows(bound: _Between, bounds: list[_Between]) -> bool:
    """Whether a chain of other bounds connects the same ends, at least as strictly."""
    ends = [(b.high, b.sign == "<") for b in bounds if b.low == bound.low and b != bound]
    seen = set()
    while ends:
        end, strict = ends.pop()
        if end == bound.high and (strict or bound.sign != "<"):
            return True
        if (end, strict) not in seen and end.is_Symbol:
            seen.add((end, strict))
            ends += [(b.high, strict or b.sign == "<") for b in bounds if b.low == end]
    return False


def _path_through(bound: _Between, left: list[_Between]) -> list[_Between]:
    """A chain that contains ``bound``; its bounds are removed from ``left``."""
    left.remove(bound)
    path = [bound]
    while path[-1].high.is_Symbol and (after := [b for b in left if b.low == path[-1].high]):
        path.append(after[0])
        left.remove(after[0])
    while path[0].low.is_Symbol and (before := [b for b in left if b.high == path[0].low]):
        path.insert(0, before[0])
        left.remove(before[0])
    return path


def _joined(path: list[_Between]) -> str:
    if len(path) == 1 and path[0].low == Integer(0):
        sign = ">" if path[0].sign == "<" else r"\ge"
        return f"{expression_latex(path[0].high)} {sign} 0"
    ends = "".join(f" {bound.sign} {expression_latex(bound.high)}" for bound in path)
    return expression_latex(path[0].low) + ends
