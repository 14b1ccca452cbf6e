"""The advocate before a user's claim: what is about to be called proved is attacked at points."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import pairwise

from flint import arb

from tresym.reals.cross_check import conditions, contradiction, program, said, where
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import LIMIT, Comparison, Path, Statement
from tresym.reals.decisions.claim_parsing import functions as unknown
from tresym.reals.language.binders import is_infinite, outermost
from tresym.reals.language.expression import DOTS, symbols
from tresym.reals.language.parsing import INFINITY
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import parse_number
from tresym.reals.verdict import Verdict

BITS, NEAR_BITS = 512, 12_000
SMALL, LESS = arb((1, -4)), arb("0.9")
NEARER = (100, 4000, 10**300)
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
    if any(map(is_infinite, outermost(comparison.left, comparison.right))):
        return None  # what was put in for it was attacked itself
    if statement.path is not None:
        against = _attack_order(comparison, statement.path, answer)
        ranged = answer.verdict is Verdict.ENCLOSED
        return against or _attack_limit(comparison, statement, statement.path, ranged)
    claim = (comparison.left, comparison.relation, comparison.right)
    said = (*claim[::2], *(side for link in statement.given.comparisons for side in link[::2]))
    dotted = any(DOTS.args[0] in symbols(e) for e in claim[::2])
    if any(node.op == "nth" for node in outermost(*claim[::2])):
        return None  # its induction was attacked itself
    if dotted or statement.equations or any(next(unknown(e), None) is not None for e in said):
        return None  # its cases, without equations and such functions, were attacked themselves
    totals = [node for node in outermost(*claim[::2]) if node.op in ("sum", "product")]
    counted = {*statement.integers}.union(*(symbols(node.args[2]) for node in totals))
    return contradiction(
        claim, statement.given.comparisons, functions, derivatives, spent, sorted(counted)
    )


def _attack_order(claim: Comparison, path: Path | None, answer: Answer) -> str | None:
    """Where the ratio exceeds the constant of an O that is certified on the region, in words."""
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


def _attack_limit(claim: Comparison, statement: Statement, path: Path, ranged: bool) -> str | None:
    """Where what must vanish at the end of the path is large, and grows on the way there.

    A limit says nothing of any one point; on the way to far nearer ones it should get smaller. What
    grows there may yet be overtaken where no number can be written: with a range that was
    enclosed (``ranged``) only what stays speaks against it.
    """
    left, right = claim.left, claim.right
    infinite = {INFINITY: 1, -INFINITY: -1}.get(right) if claim.relation == LIMIT else None
    vanishing = {
        LIMIT: left - right if infinite is None else 1 / left,
        "o": left / right,
        "~": left / right - 1,
        "omega": right / left,
    }.get(claim.relation)
    if vanishing is None or (path.point is not None and symbols(path.point)):
        return None
    needed = (vanishing, left, *claim.differentiated)  # what is differentiated must be real there
    names = sorted(set().union(*map(symbols, needed)) - {path.name})
    with ball_precision(NEAR_BITS):
        value = program(needed, [*names, path.name])
        holds = conditions(names, statement.given.comparisons)
        for at in ([arb(k + n) for n in range(len(names))] for k in (1, -2, 3)):
            if not holds(at):
                continue
            for side in path.sides:
                found = [value([*at, x]) for x in _nearer(path, side)]
                known = [values for values in found if values is not None]
                if found[0] is None or found[1] is None:
                    continue
                sizes, f = [abs(values[0]) for values in known], known[-1][1]
                wrong = infinite is not None and bool(f * infinite < 0)
                steps = pairwise(sizes)
                stays = (
                    y > SMALL and y > x * LESS and not (ranged and y * LESS > x) for x, y in steps
                )
                if wrong or all(stays):
                    return f"near the end of the path, {said(known[-1][0])} does not vanish"
    return None


def _nearer(path: Path, side: int) -> Iterator[arb]:
    """Points on one side of the path, each far nearer to its end: what is slow takes its time."""
    end = None if path.point is None else program([path.point], [])([])
    for halvings in NEARER:
        t = arb((side, -halvings))
        if path.point is None:
            yield 1 / t
        elif end is not None:
            yield end[0] + t


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
