"""Give an order that is decided the smallest constant, on a region that is natural to quote.

The methods that decide orders prove some constant, which may be far from the smallest: where an
asymptotic series is bounded at x = 1, it is useless. Here the supremum of |left|/|right| is
enclosed from both sides (:mod:`tresym.reals.expansions.maxima`), by polynomials on the finite part
of the region and by several terms of the expansion beside its end. A finite supremum proves the
order as well.

For example, ``erfc(x) == exp(-x**2)/(x*sqrt(pi)) + O(exp(-x**2)/x**3) as x -> oo`` has the constant
1/(2√π), not only for x ≥ 1 but for all x > 0.

A region x ≥ a for x → ∞ becomes x > 0 if the supremum is the same there. Regions that are asked
for may be any interval at whose end, or inside which, the path ends: ``on x > 0``, ``on abs(x) <=
pi/2``.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from dataclasses import replace
from math import factorial

from flint import arb, fmpq

from tresym.asymptotics.order_claims import region as region_text
from tresym.reals.decisions.answer import Answer, constant_ball
from tresym.reals.decisions.closed_values import RULES, certified_evaluation
from tresym.reals.decisions.path_regions import interval_of, reach_of
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import UndefinedError
from tresym.reals.expansions.maxima import EXPLICIT, Evaluations, Maximum, exact_ends
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.claims import chained
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import (
    ONE,
    Expr,
    apply,
    number,
    opened,
    rebuild,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError
from tresym.reals.resource_limits import TimeUp, time_left, time_limit
from tresym.reals.values.jets import Jets
from tresym.reals.verdict import Verdict

CLOSE = fmpq(1, 100)
SHARP = fmpq(1, 50)
"""A constant is left as it is if it is at most so much larger than the smallest."""
SECONDS = 2.5
ASKED_SECONDS = 20.0
SHARE = 0.5
"""The part of the time that is left for a claim which the search may use."""
HIGHEST = 6
"""Sums of 1/k, …, 1/k^6 are known."""
_ABOUT = re.compile(r"C about [-+.\de]+")
Ends = tuple[Expr | None, Expr | None]


def sharpened(answer: Answer, comparison: Comparison, statement: Statement) -> Answer:
    """Return the answer with the smallest constant, if it is found and the answer has none as good.

    Args:
        answer: ENCLOSED or PROVED, or UNDECIDED where a region is asked for.
        comparison: the claim, an O with a path.
        statement: its conditions; the path may ask for a region.
    """
    path = statement.path
    if comparison.relation != "O" or path is None or path.together or path.expression is not None:
        return answer
    if statement.equations or comparison.derivatives or statement.uniformly:
        return answer
    left, right = for_reals(comparison.left), for_reals(comparison.right)
    if (symbols(left) | symbols(right)) - {INFINITY.args[0]} != {path.name}:
        return answer
    if not elementary(left, right) and not _has_jets(left, right, answer, path):
        return answer
    asked = bool(path.region) or (path.reach is not None and not answer)
    if not asked and (not answer or _is_sharp(answer)):
        return answer
    try:
        with time_limit(_allowed(asked)):
            found = _found(left, right, answer, path)
    except (TimeUp, InputError, ZeroDivisionError, OverflowError):
        return answer
    if found is None:
        return answer
    best, region = found
    with ball_precision():
        constant = best.low.union(best.high)
        about = best.high.upper().str(6, radius=False)
    why = answer.why if answer else "|left| <= C |right| with C about 0"
    if _ABOUT.search(why):
        why = _ABOUT.sub(f"C about {about}", why)
    else:
        why += "; the constant is the supremum of |left/right|, enclosed from both sides"
    verdict = answer.verdict if answer else Verdict.ENCLOSED
    return replace(
        answer, verdict=verdict, why=why, constant=constant_ball(constant), region=region,
        cause=answer.cause if answer else None, smallest=True,
    )  # fmt: skip


def _allowed(asked: bool) -> float:
    """The seconds for the search: what is proved already must not be lost at the claim's limit."""
    most, left = ASKED_SECONDS if asked else SECONDS, time_left()
    return most if left is None else min(most, left * SHARE)


def for_reals(e: Expr) -> Expr:
    """Return a function of a real variable that agrees at the integers n ≥ 1.

    n! is n Γ(n), and sums of powers of 1/k are values of ψ and its derivatives (DLMF 5.15).
    """
    if not e.hidden:
        return e
    if e.op == "unknown" and e.args[0].args == (FACTORIAL, (0,)):
        n = for_reals(e.args[1])
        return n * apply("gamma", n) if symbols(n) else apply("gamma", n + ONE)
    if e.op == "sum":
        return _harmonic(e) or e
    if e.op in ("integral", "root", "product"):
        return e
    return rebuild(e, tuple(for_reals(arg) if isinstance(arg, Expr) else arg for arg in e.args))


def _harmonic(e: Expr) -> Expr | None:
    """Return Σ 1/kˢ from 1 to n by ψ: ζ(s) − (−1)ˢ ψ⁽ˢ⁻¹⁾(n)/(s−1)! + 1/nˢ, and H_n likewise."""
    (name,), body = opened(e)
    n = e.args[2]
    if e.args[1] != ONE or n.op != "symbol":
        return None
    for s in range(1, HIGHEST + 1):
        if body != symbol(name) ** -s:
            continue
        if s == 1:
            return apply("digamma", n) + 1 / n + apply("EulerGamma", ONE)
        rest = apply("polygamma", number(s - 1), n) * (-1) ** s / factorial(s - 1)
        return apply("zeta", number(s)) - rest + n**-s
    return None


def _has_jets(left: Expr, right: Expr, answer: Answer, path: Path) -> bool:
    """Whether the sides are analytic functions near a finite end, with integrals and roots.

    Over an infinite range the search has never ended in its time.
    """
    nodes = list(outermost(left, right))
    proper = not any(INFINITY.args[0] in symbols(end) for node in nodes for end in _limits(node))
    kinds = {node.op for node in nodes}
    return bool(answer) and path.point is not None and proper and kinds <= {"integral", "root"}


def _limits(node: Expr) -> tuple[Expr, ...]:
    """The ends of an integral; none of another operator."""
    return node.args[1:3] if node.op == "integral" else ()


def _is_sharp(answer: Answer) -> bool:
    if answer.constant is None or answer.lemma:
        return False
    with ball_precision():
        ball = abs(arb(answer.constant.mid, answer.constant.rad))
        return bool(ball.upper() <= ball.lower() * (1 + arb(SHARP)))


def _found(left: Expr, right: Expr, answer: Answer, path: Path) -> tuple[Maximum, str] | None:
    """Return the supremum and the region on which it is one."""
    if path.region:
        ends = interval_of(path.region)
        assert ends is not None
        best = _largest(left, right, path, ends[1:])
        return None if best is None else (best, chained(path.region))
    reach = path.reach
    if reach is None and answer.region is not None:
        try:
            reach = reach_of(Given.parse(_plain(answer.region)).comparisons, path)
        except InputError:
            if answer.region != f"{path.name} > 0":
                return None
    if path.point is None and path.reach is None and path.sides == (1,):
        best = _largest(left, right, path, (number(0), None))
        limit = None if reach is None else 1 / reach
        if best is not None and (limit is None or best.at is None or best.at >= limit):
            return best, f"{path.name} > 0"
    if reach is None:
        reach = fmpq(1) if elementary(left, right) else fmpq(1, 2)
    best = _largest(left, right, path, _ends(path, reach))
    return None if best is None else (best, region_text(path, reach))


def _plain(region: str) -> str:
    """Return a region with abs(x) for |x|."""
    return re.sub(r"\|([^|]*)\|", r"abs(\1)", region)


def _ends(path: Path, reach: fmpq) -> Ends:
    """Return the ends of the region on which the small parameter is at most ``reach``."""
    if path.point is None:
        far = number(1 / reach)
        return (far, None) if path.sides == (1,) else (None, -ONE * far)
    below, above = path.point - number(reach), path.point + number(reach)
    return (
        below if -1 in path.sides else path.point,
        above if 1 in path.sides else path.point,
    )


def _largest(left: Expr, right: Expr, path: Path, ends: Ends) -> Maximum | None:
    explicit = elementary(left, right)
    how = EXPLICIT if explicit else Evaluations(_value, lambda at: Jets(at, RULES))
    known = None if explicit or path.point is None else path.point
    best = exact_ends(left, right, path.name, *ends, CLOSE, how, known)
    return best if best is not None and best.within(SHARP) else None


def _value(e: Expr, at: Mapping[str, arb]) -> arb:
    try:
        return certified_evaluation(at).value(e)
    except UndefinedError:
        return arb.nan()
