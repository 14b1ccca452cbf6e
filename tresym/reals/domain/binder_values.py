"""Enclose the values of integrals (rigorous quadrature) and of roots (change of sign).

The variables of the expression may be balls; the result then holds for every choice of values in
them. FLINT evaluates an integrand in complex balls where it asks whether the integrand is analytic.
Everywhere else the integrand is evaluated in real balls, which give NaN where it is undefined, so
that it is proved to be defined on the whole interval. The search for a root is heuristic. The proof
consists of opposite signs at the two ends of a bracket, and of finite values inside it, by which
the function has no jump there.
"""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Callable, Mapping
from functools import partial

from flint import acb, arb, ctx, fmpq

from tresym.reals.domain.evaluation import InBalls, UndefinedError
from tresym.reals.domain.integrands import Integrand
from tresym.reals.language.binders import worked_out
from tresym.reals.language.expression import LEAVES, MINUS_ONE, Expr, opened, symbol, symbols
from tresym.reals.numbers.arithmetic import WORKING, ball_precision, balls, side
from tresym.reals.resource_limits import held

At = Mapping[str, arb | fmpq]
Unique = Callable[[Expr, At], bool]
"""Decide whether a node is known to have at most one root at these values of the variables."""
Root = Callable[[Expr, "Enclosing"], arb]

JUMPS = frozenset(("sign", "atan2"))
"""Operations whose balls remain finite at jumps."""
ROUGH = 64
"""The precision in bits of the first search for a root."""
ENDS = (*range(2, 25), 32, 48, 72, 108, 162, 243, 364)
"""The search for a change of sign looks 2^−n of the width from each end, for these n."""
STEPS = 60
EVALUATIONS = 20_000
"""The maximal number of evaluations for one integral, at a low precision."""
MORE_EVALUATIONS = 100
"""How many more there may be for each bit of accuracy beyond the usual precision."""
SPARE = 6
"""The bits requested of an integral beyond the accuracy of its integrand."""
WIDER = 8
"""How often the width of a bracket is doubled."""


NO_OTHER: Mapping[str, Root] = {}


def no_root(e: Expr, outer: Enclosing) -> arb:
    """Refuse to evaluate roots.

    Raises:
        UndefinedError: always.
    """
    raise UndefinedError


class Enclosing(InBalls):
    """Evaluate in balls, including integrals, roots and values at a point.

    Like every evaluation in balls it raises ``UndefinedError`` where a value is not proved to
    exist.
    """

    def __init__(self, at: At, root: Root = no_root, own: Mapping[str, Root] = NO_OTHER) -> None:
        """Prepare an evaluation.

        Args:
            at: the values of the variables; the mapping may compute them on demand.
            root: a function that encloses a root and proves that it exists.
            own: functions that enclose other operations, or the same in another way.
        """
        super().__init__(balls, at, {})
        self.root, self.own = root, own

    def _computed(self, e: Expr) -> arb:
        if e.op in self.own:
            return self.own[e.op](e, self)
        if e.op == "integral":
            return self.integral(e)
        if e.op == "root":
            return self.root(e, self)
        if e.op == "at":
            names, body = opened(e)
            points = dict(zip(names, map(self.value, e.args[1:]), strict=True))
            return Inner(self, points).value(body)
        if e.op == "derivative" and (found := worked_out(e)).op != "derivative":
            return self.value(found)
        if e.names or e.op in ("O", "o"):
            raise UndefinedError
        if e.op == "*":
            return self._quotient(e)
        return super()._computed(e)

    def _quotient(self, e: Expr) -> arb:
        """Return a product as one quotient, so that a fraction of integers is rounded only once."""
        above, below = arb(1), arb(1)
        for factor in e.args:
            if factor.op == "^" and factor.args[1] == MINUS_ONE:
                below *= self.value(factor.args[0])
            else:
                above *= self.value(factor)
        return above / below

    def integral(self, e: Expr) -> arb:
        """Return an integral between finite ends, by quadrature."""
        low, high = (self.value(end) for end in e.args[1:])
        (name,), body = opened(e)
        integrand = Integrand(worked_out(body), name, self.value)
        # A tolerance far below the accuracy of the integrand would only waste evaluations.
        known = integrand.real(((low + high) / 2).mid()).rel_accuracy_bits()
        return quadrature(integrand, low, high, max(known, 0) + SPARE)


def quadrature(
    integrand: Callable[[acb, bool], acb], low: arb, high: arb, accuracy: int | None = None
) -> arb:
    """Return the integral of a function between two numbers; not finite if none is proved.

    Args:
        integrand: the function, as FLINT's quadrature requires it.
        low, high: the ends.
        accuracy: the accuracy in bits that is tried for; None for the working precision.
    """
    wanted = ctx.prec if accuracy is None else min(accuracy, ctx.prec)
    tolerance = arb((1, -wanted))
    most = EVALUATIONS + MORE_EVALUATIONS * max(0, wanted - WORKING)
    fine = {"rel_tol": tolerance, "abs_tol": tolerance, "eval_limit": most}
    with held():
        return acb.integral(integrand, acb(low), acb(high), **fine).real


def enclosed(e: Expr, at: At, root: Root = no_root) -> arb:
    """Return a ball that contains ``e`` at ``at``; NaN if the value is not proved to exist.

    Args:
        e: the expression.
        at: the values of its variables.
        root: a function that encloses roots.
    """
    return shown(e, Enclosing(at, root))


def shown(e: Expr, walker: Enclosing) -> arb:
    """Return the same as :func:`enclosed`, with the values that ``walker`` already knows."""
    try:
        return walker.value(e)
    except UndefinedError:
        return arb.nan()


class Inner(Enclosing):
    """Evaluate with additional variables; the other values are taken from outside."""

    def __init__(self, outer: Enclosing, more: dict[str, arb]) -> None:
        super().__init__(ChainMap(more, outer.at), outer.root, outer.own)  # type: ignore[arg-type]
        self.outer, self.names = outer, more.keys()

    def value(self, e: Expr) -> arb:
        """Return the value of ``e``; what does not depend on the new variables is kept outside."""
        if e not in self.known and self.names.isdisjoint(symbols(e)):
            self.known[e] = self.outer.value(e)
        return super().value(e)


def jumps(e: Expr) -> bool:
    """Return whether ``e`` may have a value where it is not continuous."""
    inner = (arg for arg in e.args if isinstance(arg, Expr))
    return e.op in JUMPS or (e.op not in LEAVES and any(map(jumps, inner)))


def bracketed(unique: Unique, e: Expr, outer: Enclosing) -> arb:
    """Return the root of a node, enclosed by a change of sign of a function without jumps.

    Raises:
        UndefinedError: no bracket is found, or uniqueness of the root is not known.
    """
    low, high = (outer.value(end) for end in e.args[1:])
    (name,), body = opened(e)
    if not unique(e, outer.at) or jumps(body):
        raise UndefinedError
    middle = {n: outer.value(symbol(n)).mid() for n in symbols(body) if n != name}
    near, over = (along(name, body, at, outer) for at in (middle, outer.at))
    return bracket(near, over, low, high)


def bracket(near: Callable[[arb], arb], over: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """Return a ball between two ends such that ``over`` has opposite signs at the ends of the ball.

    Args:
        near: a function close to ``over`` with sharp values, used to find the root approximately.
        over: a function of balls without jumps.
        low: the lower end.
        high: the upper end.

    Raises:
        UndefinedError: no bracket is found.
    """
    try:
        x, slope = _found(near, low.mid(), high.mid(), ROUGH)
    except UndefinedError:
        x, slope = _found(near, low.mid(), high.mid(), ctx.prec)
    small = high.mid() - low.mid() if x.is_zero() else abs(x)
    width = (over(x) / slope).abs_upper() * arb("1.25") + small * arb((1, 8 - ctx.prec))
    for _ in range(WIDER):
        first, last = (x - width).mid(), (x + width).mid()
        both = first.union(last)
        signs = {side(over(first)), side(over(last))}
        if signs == {1, -1} and low < first and last < high and over(both).is_finite():
            return both
        width *= 2
    raise UndefinedError


def along(name: str, body: Expr, at: At, like: Enclosing) -> Callable[[arb], arb]:
    """Return ``body`` as a function of one variable, NaN where it is undefined.

    Integrals, roots and other binders are enclosed as ``like`` encloses them.
    """
    outers: dict[int, Enclosing] = {}

    def function(x: arb) -> arb:
        outer = outers.setdefault(
            ctx.prec, Enclosing(at, like.root, like.own)
        )  # cached values have this precision
        try:
            return Inner(outer, {name: x}).value(body)
        except UndefinedError:
            return arb.nan()

    return function


def _found(f: Callable[[arb], arb], low: arb, high: arb, rough: int) -> tuple[arb, arb]:
    """Return a point near a root between the ends, and the slope there.

    The method is regula falsi with halved weights (the Illinois algorithm), followed by the secant
    method at working precision. The first search has ``rough`` bits.

    Raises:
        UndefinedError: no change of sign is found.
    """
    with ball_precision(rough):
        one, two = _change(f, low, high)
        (x, at_x), (y, at_y) = one, two
        for _ in range(STEPS):
            z = ((x * at_y - y * at_x) / (at_y - at_x)).mid()
            value = f(z).mid()
            if abs(z - y) < abs(y) * arb((1, -20)) or value.is_zero():
                break
            at_x, x = (at_y, y) if value * at_y < 0 else (at_x / 2, x)
            y, at_y = z, value
    if y == z:  # the zero was hit exactly
        y = (z + (high - low) * arb((1, -30))).mid()
    x, at_x = y, f(y).mid()
    y, at_y = z, f(z).mid()
    slope = (at_y - at_x) / (y - x)
    for _ in range(STEPS):
        step = (at_y / slope).mid()
        if step.is_zero():
            break
        x, at_x, y = y, at_y, (y - step).mid()
        if not abs(step) > abs(y) * arb((1, 16 - ctx.prec)):
            break
        at_y = f(y).mid()
        slope = (at_y - at_x) / (y - x)
    if not slope.is_finite() or slope.is_zero():
        raise UndefinedError
    return y, slope.mid()


def _change(
    f: Callable[[arb], arb], low: arb, high: arb
) -> tuple[tuple[arb, arb], tuple[arb, arb]]:
    """Return two points with values of opposite signs, searching from the middle outward."""
    middle = ((low + high) / 2).mid()
    last = [(middle, f(middle))] * 2
    if last[0][1].is_zero():  # not the zero itself, whose sign no other value opposes
        middle = (low + (high - low) * arb("0.46")).mid()
        last = [(middle, f(middle))] * 2
    for n in ENDS:
        step = (high - low) * arb((1, -n))
        for end, x in enumerate((low + step, high - step)):
            here = x.mid(), f(x.mid())
            if here[1].is_zero():  # a bracket around a zero that was hit exactly
                aside = step * arb("0.25")
                one, two = ((y.mid(), f(y.mid())) for y in (x - aside, x + aside))
                if one[1] * two[1] < 0:
                    return one, two
            for there in (last[end], last[1 - end]):
                if here[1] * there[1] < 0:
                    return there, here
            if side(here[1]):
                last[end] = here
    raise UndefinedError


def value(e: Expr, at: At, unique: Unique) -> arb:
    """Return a ball that contains ``e`` at ``at``, at working precision; NaN if none is proved.

    Args:
        e: the expression.
        at: the values of its variables.
        unique: decides whether a node is known to have at most one root.
    """
    return enclosed(e, at, partial(bracketed, unique))
