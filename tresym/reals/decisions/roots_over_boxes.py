"""Decide inequalities about roots whose parameters lie in a box, by enclosures of the roots.

``sin(root(cos(x) - a*x, x, 0, pi/2)) < 7/10 given 1 <= a <= 2``: the box of the parameters is
bisected until the claim is seen in each part. Over a part the root of f(x, a) = 0 lies between two
points at which f has opposite signs for every a in it, and is the only one between its ends. The
difference of the sides is evaluated there, and also by its mean value form about the middle, with
the derivative of a root by a parameter, −f_a/f_x. A counterexample is a point of the parameters
with rational coordinates at which balls show that the claim fails.

Source: R. E. Moore, R. B. Kearfott, M. J. Cloud, *Introduction to Interval Analysis*, SIAM 2009,
chapters 6 and 8.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping

from flint import arb, fmpq

from tresym.reals.decisions.answer import Answer, refuted
from tresym.reals.decisions.root_values import brackets, enclosed, slope_sign, unique_in_balls
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.binder_values import At, along, bracket, enclosing, jumps
from tresym.reals.domain.conditions import Condition
from tresym.reals.domain.evaluation import InBalls, UndefinedError, evaluate, stands
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    Expr,
    fresh,
    opened,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import NEGATED
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval
from tresym.reals.verdict import Verdict

BITS = 96
PARTS = 400
"""The most parts of a box of parameters."""
FEW = 24
"""The most parts where a claim is tried by balls before anything else."""
NARROW = fmpq(1, 10)
"""Up to this part of its middle a range is narrow, as that of a rounded number."""
Box = dict[str, Interval]


def is_for_balls(claim: Comparison, statement: Statement, nodes: list[Expr]) -> bool:
    """Return whether balls are worth a try before an equation is solved for a parameter.

    They are where there are several parameters or roots, or narrow ranges as of rounded numbers.
    """
    where = _box(claim, statement)
    narrow = all(
        side.width <= NARROW * max(abs(side.low), abs(side.high)) for side in where.values()
    )
    return bool(where) and (narrow or len(where) > 1 or len(nodes) > 1)


def decide_over_boxes(
    claim: Comparison, statement: Statement, nodes: list[Expr], parts: int = PARTS
) -> Answer | None:
    """Decide an inequality about roots on a bounded box of parameters; None if balls do not.

    Args:
        claim: the comparison.
        statement: its conditions.
        nodes: the roots in it.
        parts: how many parts the box may have.
    """
    if claim.relation not in ("<", "<=", ">", ">=", "!=") or claim.derivatives:
        return None
    where = _box(claim, statement)
    inner = (e for node in nodes for e in (opened(node)[1], *node.args[1:]))
    if not where or not elementary(*inner):
        return None
    search = _Search(claim, statement, nodes)
    if not elementary(search.gap):
        return None
    open_, done = [where], 0
    while open_:
        here = open_.pop()
        done += 1
        if done > parts:
            return None
        found = search.at_middle(here)
        if found is not None:
            return found
        if not search.holds(here):
            open_ += _halves(here)
    if not search.has_a_point:
        return None
    why = f"the roots are enclosed over {done} part{'s' * (done > 1)} of the box of parameters"
    return Answer(Verdict.ENCLOSED, why)


def _box(claim: Comparison, statement: Statement) -> Box:
    """The ranges of the parameters, if all are finite and there is no other kind of condition."""
    names = (symbols(claim.left) | symbols(claim.right)) - {INFINITY.args[0]}
    if statement.path is not None or statement.equations or statement.integers or not names:
        return {}
    box = statement.given.box
    found = {name: box[name] for name in sorted(names) if name in box}
    whole = len(found) == len(names) and all(
        side.low is not None and side.high is not None and side.low < side.high
        for side in found.values()
    )
    return found if whole else {}


def _halves(here: Box) -> list[Box]:
    """The box cut in the middle of the side that is longest beside its distance from 0."""

    def length(name: str) -> fmpq:
        side = here[name]
        return side.width / max(abs(side.low), abs(side.high))

    name = max(here, key=length)
    side = here[name]
    return [
        here | {name: Interval(side.low, side.middle)},
        here | {name: Interval(side.middle, side.high)},
    ]


def _bracketed(
    node: Expr, near: Callable[[arb], arb], whole: Callable[[arb], arb], outer: InBalls
) -> arb | None:
    """A ball around the zero between the ends of a node, which may be infinite."""
    try:
        for low, high in brackets(node, outer):
            try:
                return bracket(near, whole, low, high)
            except UndefinedError:
                continue
    except UndefinedError:
        pass
    return None


class _Search:
    """The difference of both sides as a function of the parameters and of the roots."""

    def __init__(self, claim: Comparison, statement: Statement, nodes: list[Expr]) -> None:
        self.claim, self.nodes = claim, nodes
        self.given = statement.given
        self.has_a_point = False
        taken = {*symbols(claim.left), *symbols(claim.right), *statement.given.names}
        self.marks: dict[Expr, str] = {}
        for node in nodes:
            self.marks[node] = fresh("r", taken)
            taken.add(self.marks[node])
        put = {node: symbol(mark) for node, mark in self.marks.items()}
        self.gap = replaced(claim.left - claim.right, put)
        self.has_jumps = jumps(self.gap)
        self.equations = []
        for node, mark in self.marks.items():
            (own,), body = opened(node, taken)
            self.equations.append(substitute(body, {own: symbol(mark)}))
        self.is_only = [False] * len(nodes)
        self.asked = [False] * len(nodes)
        self.slopes: dict[tuple[Expr, str], Expr] = {}

    def at_middle(self, here: Box) -> Answer | None:
        """A refutation in the middle of a part, where the conditions hold."""
        point = {name: side.middle for name, side in here.items()}
        with ball_precision():
            if not all(condition.holds(point) for condition in self._about(point)):
                return None
            left, right = (enclosed(e, point) for e in (self.claim.left, self.claim.right))
            if not (left.is_finite() and right.is_finite()):
                return None
            self.has_a_point = True
            if stands(left - right, NEGATED[self.claim.relation]):
                return refuted("the two sides differ", point, left, right)
        return None

    def _about(self, point: Mapping[str, fmpq]) -> list[Condition]:
        return [c for c in self.given.conditions if symbols(c.expression) <= point.keys()]

    def holds(self, here: Box) -> bool:
        """Whether balls show the claim over a part, or that no point of it is meant."""
        with ball_precision(BITS):
            over = {name: side.ball() for name, side in here.items()}
            for condition in self._about({name: fmpq(0) for name in here}):
                value = evaluate(condition.expression, over)
                if value < 0 or (condition.relation != ">=" and value.is_zero()):
                    return True
            roots = self.roots(over)
            if roots is None:
                return False
            gap = evaluate(self.gap, {**over, **roots})
            if stands(gap, self.claim.relation):
                return True
            sharper = None if self.has_jumps else self.by_mean_value(here, over, roots)
            return sharper is not None and stands(sharper, self.claim.relation)

    def roots(self, at: At) -> dict[str, arb] | None:
        """Balls around the roots for all values of the parameters in balls; None if not shown."""
        outer = enclosing(at)
        found: dict[str, arb] = {}
        for n, node in enumerate(self.nodes):
            (name,), body = opened(node)
            if jumps(body) or not self.has_one(n, node, at):
                return None
            middle = {x: arb(v).mid() for x, v in at.items()}
            near, whole = (along(name, body, values, outer) for values in (middle, at))
            ball = _bracketed(node, near, whole, outer)
            if ball is None:
                return None
            found[self.marks[node]] = ball
        return found

    def has_one(self, n: int, node: Expr, at: At) -> bool:
        """Whether the equation has one solution at most, for all values of the parameters."""
        if {INFINITY, -INFINITY} & {*node.args[1:]}:
            return self.by_slope(n, node)
        return self.is_only[n] or unique_in_balls(node, at) or self.by_slope(n, node)

    def by_slope(self, n: int, node: Expr) -> bool:
        """Whether the equation is monotone in its unknown, by the rules of signs."""
        if not self.asked[n]:
            self.asked[n] = True
            self.is_only[n] = bool(slope_sign(node, self.given))
        return self.is_only[n]

    def by_mean_value(self, here: Box, over: At, roots: Mapping[str, arb]) -> arb | None:
        """The difference by its value in the middle and its derivatives over the part."""
        middle = {name: arb(side.middle) for name, side in here.items()}
        at_middle = self.roots(middle)
        if at_middle is None:
            return None
        value = evaluate(self.gap, {**middle, **at_middle})
        known = {**over, **roots}
        for name, side in here.items():
            slope = evaluate(self._slope(self.gap, name), known)
            for mark, f in zip(self.marks.values(), self.equations, strict=True):
                by_root = evaluate(self._slope(self.gap, mark), known)
                moved = evaluate(self._slope(f, name), known)
                steep = evaluate(self._slope(f, mark), known)
                slope -= by_root * moved / steep
            value += slope * (side.ball() - arb(side.middle))
        return value if value.is_finite() else None

    def _slope(self, e: Expr, name: str) -> Expr:
        key = e, name
        if key not in self.slopes:
            self.slopes[key] = differentiate(e, name)
        return self.slopes[key]
