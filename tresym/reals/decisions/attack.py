"""The advocate before a user's claim: what is about to be called proved is attacked at points."""

from __future__ import annotations

from collections.abc import Iterator

from flint import arb

from tresym.reals.advocate import contradiction, program, said, where
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.reading import Comparison, Path, Statement
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number

BITS = 512
HALVINGS = (0, 1, 2, 3, 5, 8, 13, 21, 34, 55)
"""How often the range of an order is halved on the way to its end."""


def attack(
    comparison: Comparison, statement: Statement, answer: Answer, spent: float
) -> str | None:
    """What contradicts a comparison that is about to pass, in words, or None.

    Args:
        spent: seconds that its decision took.
    """
    functions, derivatives = comparison.differentiated, comparison.derivatives
    if statement.path is not None:
        return _attack_order(comparison, statement.path, answer)
    claim = (comparison.left, comparison.relation, comparison.right)
    return contradiction(
        claim, statement.given.comparisons, functions, derivatives, spent, statement.integers
    )


def _attack_order(claim: Comparison, path: Path | None, answer: Answer) -> str | None:
    """Where the ratio exceeds the constant of an O that is certified on the region, in words.

    An o or ~ says nothing of any one point.
    """
    if path is None or answer.constant is None or answer.region is None:
        return None
    with ball_precision(BITS):
        constant = arb(parse_number(answer.constant.mid)) + arb(parse_number(answer.constant.rad))
        value = program((claim.left, claim.right, *claim.differentiated), [path.name])
        for x in _along(path, arb(parse_number(answer.region.split()[-1]))):
            found = value([x])
            if found is not None and abs(found[0]) > constant * abs(found[1]):
                sides = f"{said(found[0])} and {said(found[1])}"
                return f"at {where([path.name], [x])} its sides are {sides}, beyond the constant"
    return None


def _along(path: Path, reach: arb) -> Iterator[arb]:
    """Points of the region that ends at ``reach``, on each side of the path."""
    end = None if path.point is None else program([path.point], [])([])
    for side in path.sides:
        for halvings in HALVINGS:
            for more in (0, 3, 5):
                part = arb(8 - more) / 8 / 2**halvings
                if path.point is None:
                    yield abs(reach) / part * side
                elif end is not None:
                    yield end[0] + reach * part * side
