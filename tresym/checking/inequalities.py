"""Inequalities: a point that refutes, a proven sign, Taylor's theorem, and then boxes.

A claim ``left >= right`` speaks of every real point of ``given`` where both sides are defined, like
an identity, and nothing is proved where no such point is found.
"""

from __future__ import annotations

from dataclasses import replace
from itertools import islice, product

from flint import arb, fmpq

from tresym.arithmetic import ball_precision
from tresym.checking.answer import Answer, refuted
from tresym.checking.boxes import search
from tresym.checking.cones import sign_on_cones
from tresym.checking.domain import bound, equal_at, with_domain
from tresym.checking.taylor import sign_by_taylor
from tresym.exact import fraction_text
from tresym.identity.bounds import sign
from tresym.identity.decide import sampled_values
from tresym.identity.evaluation import evaluate
from tresym.identity.expression import Expr, rebuild, symbols
from tresym.identity.given import Given, corners
from tresym.verdict import Verdict

LOOKS = ((128, 40), (700, 10))
HALVINGS = 40
MAX_PAIRS = 8
MAX_CASES = 3
_STRICT = {">": ("+",), ">=": ("+", ">=0", "0"), "!=": ("+", "-")}


def decide_inequality(left: Expr, relation: str, right: Expr, given: Given) -> Answer:
    """PROVED, ENCLOSED, REFUTED or UNDECIDED for ``left relation right``."""
    if relation in ("<", "<="):
        found = decide_inequality(right, relation.replace("<", ">"), left, given)
        values = found.values and (found.values[1], found.values[0])
        return replace(found, values=values)
    names = sorted(symbols(left) | symbols(right) | given.names)
    defined, refutation = _sampled(left, relation, right, given, names)
    if refutation is not None:
        return refutation
    if defined is None:
        return Answer(
            Verdict.UNDECIDED,
            "no exact point was found inside the conditions where both sides are defined, "
            "and nothing is proved vacuously; a condition that bounds the variables may help",
        )
    if not symbols(left) | symbols(right):
        return _constants(left, relation, right)
    difference = left - right
    region = with_domain(given, left, right)
    proof = _proved(difference, relation, region)
    if proof is not None:
        return Answer(Verdict.PROVED, f"{proof}; both sides are defined at {_shown(defined)}")
    if relation == "!=":
        return _apart(left, right, region, defined)
    return search(left, right, relation == ">", region, given)


def _proved(difference: Expr, relation: str, region: Given, depth: int = 0) -> str | None:
    """A sentence that proves ``difference relation 0``, absolute values taken apart by cases."""
    found = sign(difference, region)
    if found in _STRICT[relation]:
        return f"the difference {_words(found)} by the signs of its parts"
    proof = sign_on_cones(difference, relation, region)
    if proof is not None:
        return proof
    proof = sign_by_taylor(difference, relation, region)
    if proof is not None:
        return f"Taylor's theorem: {proof}"
    inner = _absolute(difference)
    if inner is None or depth == MAX_CASES:
        return None
    for side in (inner, -inner):
        case = region & Given((bound(side, ">="),))
        if _proved(_without(difference, inner, side), relation, case, depth + 1) is None:
            return None
    return f"by cases, in the sign of {inner}"


def _absolute(e: Expr) -> Expr | None:
    """The argument of an absolute value in ``e`` that has none within, if there is one."""
    for arg in e.args if e.op not in ("number", "symbol", "pi") else ():
        found = _absolute(arg)
        if found is not None:
            return found
    return e.args[0] if e.op == "abs" else None


def _without(e: Expr, inner: Expr, side: Expr) -> Expr:
    """``e`` with ``abs(inner)`` replaced by ``side``."""
    if e.op in ("number", "symbol", "pi"):
        return e
    if e.op == "abs" and e.args[0] == inner:
        return side
    return rebuild(e, tuple(_without(arg, inner, side) for arg in e.args))


def _sampled(
    left: Expr, relation: str, right: Expr, given: Given, names: list[str]
) -> tuple[dict[str, fmpq] | None, Answer | None]:
    """A point where both sides are defined, and a refutation where a point gives one."""
    defined = None
    for bits, count in LOOKS:
        for point, (x, y) in sampled_values(left, right, given, names, count, bits):
            defined = point
            if relation != "!=" and x < y:
                return defined, refuted(f"it fails at {_shown(point)}", point, x, y)
            if relation != ">=" and x.overlaps(y) and equal_at(left, right, point):
                return defined, refuted(f"both sides are equal at {_shown(point)}", point, x, y)
    return defined, _at_corners(left, relation, right, given, names) if defined else None


def _at_corners(
    left: Expr, relation: str, right: Expr, given: Given, names: list[str]
) -> Answer | None:
    """A refutation where variables are 0, 1 or at closed ends of their ranges."""
    for point in dict.fromkeys(tuple(p.items()) for p in corners(names, given.box)):
        exact = dict(point)
        with ball_precision(LOOKS[0][0]):
            at = {name: arb(value) for name, value in point}
            if not all(condition.holds_exactly(at) for condition in given.conditions):
                continue
            x, y = evaluate(left, at), evaluate(right, at)
        if not (x.is_finite() and y.is_finite()):
            continue
        if relation != "!=" and x < y:
            return refuted(f"it fails at {_shown(exact)}", exact, x, y)
        if relation != ">=" and x.overlaps(y) and equal_at(left, right, exact):
            return refuted(f"both sides are equal at {_shown(exact)}", exact, x, y)
    return None


def _constants(left: Expr, relation: str, right: Expr) -> Answer:
    """Both sides are constants, and no ball refuted the claim."""
    if equal_at(left, right, {}):
        if relation == ">=":
            return Answer(Verdict.PROVED, "the two constants are equal")
        return refuted("the two constants are equal", {})
    found = sign(left - right, Given())
    if found in _STRICT[relation]:
        return Answer(Verdict.ENCLOSED, "the balls of the two constants are apart")
    return Answer(Verdict.UNDECIDED, "the balls of the two constants overlap at 1024 bits")


def _apart(left: Expr, right: Expr, region: Given, defined: dict[str, fmpq]) -> Answer:
    """``left != right``: refuted by a zero between two points, or by a strict inequality."""
    names = sorted(defined)
    signs: dict[bool, list[dict[str, fmpq]]] = {True: [], False: []}
    for point, (x, y) in sampled_values(left, right, region, names, *LOOKS[0][::-1]):
        if not x.overlaps(y):
            signs[bool(x > y)].append(point)
    for start, end in islice(product(signs[True], signs[False]), MAX_PAIRS):
        zero = _zero_between(left - right, region, start, end)
        if zero is not None:
            return zero
    above = bool(signs[True])
    if above and signs[False]:
        why = "the difference has both signs, so it may vanish; no zero of it was found"
        return Answer(Verdict.UNDECIDED, why)
    pair = (left, right) if above else (right, left)
    found = search(*pair, True, region, region)
    if found.verdict is not Verdict.REFUTED:
        return found
    point = {name: fmpq(*map(int, text.split("/"))) for name, text in (found.witness or {}).items()}
    if equal_at(left, right, point):
        return refuted(f"both sides are equal at {_shown(point)}", point)
    zero = _zero_between(left - right, region, defined, point)
    if zero is not None:
        return zero
    why = "the difference changes its sign, so it may vanish; no zero of it was found"
    return Answer(Verdict.UNDECIDED, why)


def _zero_between(
    difference: Expr, region: Given, start: dict[str, fmpq], end: dict[str, fmpq]
) -> Answer | None:
    """A refutation of ``difference != 0``, which has two signs at two points, by halving.

    The difference is continuous on the small box about the last two points, as its ball there is
    finite, so it vanishes on the segment between them.
    """
    with ball_precision(LOOKS[-1][0]):
        above = evaluate(difference, {name: arb(x) for name, x in start.items()}) > 0
        for _ in range(HALVINGS):
            middle = {name: (start[name] + end[name]) / 2 for name in start}
            value = evaluate(difference, {name: arb(x) for name, x in middle.items()})
            if not (value > 0 or value < 0):
                return None
            start, end = (middle, end) if (value > 0) == above else (start, middle)
        box = {name: arb(start[name]).union(arb(end[name])) for name in start}
        inside = all(condition.holds(box) for condition in region.conditions)
        if not (inside and evaluate(difference, box).is_finite()):
            return None
    ends = {name: sorted((start[name], end[name])) for name in start}
    witness = {
        name: f"[{fraction_text(low)}, {fraction_text(high)}]" if low < high else fraction_text(low)
        for name, (low, high) in ends.items()
    }
    why = "the difference is continuous there and changes its sign, so it vanishes between"
    return Answer(Verdict.REFUTED, why, witness=witness)


def _words(found: str | None) -> str:
    words = {"+": "is positive", "-": "is negative", "0": "has normal form 0"}
    return words.get(found or "", "is nowhere negative")


def _shown(point: dict[str, fmpq]) -> str:
    shown = ", ".join(f"{name} = {fraction_text(value)}" for name, value in point.items())
    return shown or "the constants themselves"
