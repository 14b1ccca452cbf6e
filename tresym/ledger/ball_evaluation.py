"""Evaluate expressions as written in balls, with symbols that stand for other expressions.

Used by the search for counterexamples. The meaning of every operation is that of the independent
check (:mod:`tresym.reals.cross_check`), not that of the decision procedures, so that an error there
cannot hide a counterexample. A symbol with a rule is evaluated when it is first asked for, at most
once at a point; it is not put in, since the result would often be too long.

Example: with the rule y := x**2, the value of ``y + 1`` where x = 3 is 10.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from flint import arb, ctx

from tresym.reals import cross_check
from tresym.reals.decisions.root_values import by_leibniz
from tresym.reals.language.binders import worked_out
from tresym.reals.language.expression import Expr, symbols
from tresym.reals.numbers.exact import InputError

PROGRAMS = 1 << 12
"""Number of compiled expressions in the cache."""
Meanings = Mapping[str, Expr]
"""The meanings of symbols that have no value of their own."""
NO_RULES: Meanings = {}


class Place:
    """Values of the symbols at a point; those with a rule are evaluated on first use."""

    def __init__(self, values: Mapping[str, arb], rules: Meanings = NO_RULES) -> None:
        self.values, self.rules = dict(values), rules

    def value(self, e: Expr) -> arb:
        """Return a ball for ``e``; NaN if it may be undefined, or if a symbol has no value."""
        names, run = _program(e, ctx.prec)
        found = run([self.of(name) for name in names]) if run is not None else None
        return arb.nan() if found is None else found[0]

    def of(self, name: str) -> arb:
        """Return the value of a symbol."""
        if name not in self.values:
            known = self.rules.get(name)
            self.values[name] = arb.nan() if known is None else self.value(known)
        return self.values[name]


def value(e: Expr, point: Mapping[str, arb]) -> arb:
    """Return a ball that contains the value of ``e``; NaN if ``e`` may be undefined.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> value(parse("log(x)"), {"x": arb(1)})
        0
    """
    return Place(point).value(e)


@lru_cache(maxsize=PROGRAMS)
def _program(e: Expr, bits: int) -> tuple[tuple[str, ...], cross_check.Program | None]:
    """Return the names of the symbols of an expression, and how it is computed from them.

    A program holds its constants in the precision in which it was made, ``bits``.
    """
    names = tuple(sorted(symbols(e) - {cross_check.INFINITE}))
    try:
        return names, cross_check.program(
            [by_leibniz(worked_out(e))], names, field=cross_check.ROUGHLY
        )
    except (InputError, ValueError):
        return names, None
