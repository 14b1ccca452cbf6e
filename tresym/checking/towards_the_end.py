"""Compare both sides of an order or a limit at points on the way to the end of its path.

    sides_of(answer).rows(STEPS)    # points x, and both sides and their ratio there, as balls

One point of a path refutes nothing about its end. A few ratios that do not tend to what is claimed
show at a glance what an expansion proves.
"""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import dataclass

from flint import arb, fmpq

from tresym.asymptotics.lemma import asserted_terms
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.decisions.path_regions import along
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.expansions.scale import T
from tresym.reals.language.binders import elementary
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import Expr, number, substitute, symbols
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, decimal_ball
from tresym.reals.resource_limits import TimeUp, time_limit

STEPS = tuple(fmpq(1, 4**n) for n in range(6))
"""Where the two sides are compared: values of the small parameter."""
RATIO = "left/right"
FEWEST, MOST = 3, 4
"""How many points a line of text names."""
SECONDS = 0.5
"""Processor time for a line of text."""


@dataclass(frozen=True)
class Sides:
    """Both sides of an order or a limit in one variable, and the path on which they are compared.

    Attributes:
        end: the path.
        heads: what is computed, as text: the expression of a limit, or both sides and their ratio.
        parts: the expressions.
    """

    end: Path
    heads: tuple[str, ...]
    parts: tuple[Expr, ...]

    def rows(self, steps: Iterable[fmpq]) -> list[tuple[Expr, list[arb]]]:
        """Return points of the path with the values there, where they can be enclosed."""
        rows = []
        with ball_precision():
            for t in steps:
                point = along(self.end, self.end.sides[0])
                x = substitute(point, {T: number(t)})
                at = {self.end.name: x}
                try:
                    found = [certified_evaluation().value(substitute(e, at)) for e in self.parts]
                    found += [found[0] / found[1]] if len(found) > 1 else []
                except (UndefinedError, InputError, ZeroDivisionError):
                    continue
                if all(value.is_finite() and value.rad() < 1e-3 for value in found):
                    rows.append((x, found))
        return rows


def sides_of(answer: Answer) -> Sides | None:
    """Return the sides of a claim if they can be compared on the way to the end.

    They can for one comparison in the variable of its path alone.

    Args:
        answer: the answer to the claim.
    """
    try:
        statement = read(answer.read_as)
    except InputError:
        return None
    comparisons, end = statement.comparisons, statement.path
    if end is None or end.together or len(comparisons) != 1 or statement.equations:
        return None
    (compared,) = comparisons
    names = symbols(compared.left) | symbols(compared.right)
    if names - {end.name} or compared.derivatives:
        return None
    if compared.relation == LIMIT:
        return Sides(end, (str(compared.left),), (compared.left,))
    if compared.relation == "~" and len(terms := asserted_terms(compared.right, end.name)) > 1:
        compared = Comparison(compared.left - compared.right, "o", terms[-1])
    heads = (str(compared.left), str(compared.right), RATIO)
    return Sides(end, heads, (compared.left, compared.right))


def in_a_line(answer: Answer) -> str:
    """Return what a refuted claim looks like on the way to the end, in a line; empty if unknown.

    Integrals, sums and roots, which may take long, are left to :meth:`Sides.rows`.

    Example:
        >>> import tresym
        >>> in_a_line(tresym.check("sin(x) ~ 2*x as x -> 0"))
        'left/right is 0.4207 at x = 1, 0.4948 at 1/4, 0.4997 at 1/16, 0.4999 at 1/64'
    """
    sides = sides_of(answer)
    if sides is None or not elementary(*sides.parts):
        return ""
    try:
        with time_limit(SECONDS):
            rows = sides.rows(STEPS)[:MOST]
    except TimeUp:
        return ""
    if len(rows) < FEWEST:
        return ""
    places = [str(x) for x, _ in rows]
    places[0] = f"{sides.end.name} = {places[0]}"
    shown = (
        f"{_short(values[-1])} at {place}" for place, (_, values) in zip(places, rows, strict=True)
    )
    return f"{sides.heads[-1]} is {', '.join(shown)}"


def _short(value: arb) -> str:
    return f"{float(decimal_ball(value, 8).mid):.4g}"
