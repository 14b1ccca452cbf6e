"""Enclose the value of integrals (rigorous quadrature) and of roots (change of sign).

Over the balls that are given for the variables of an expression the value is enclosed for every
choice of them. An integrand is walked over in complex balls where FLINT asks whether it is
analytic, and in real ones, which say NaN where it is undefined, everywhere else: so it is shown to
be defined on the whole way. What finds a root may be clever; what shows it is the
function at the two ends of a bracket, and its values inside, by which it has no jump there.
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
from tresym.reals.numbers.arithmetic import ball_precision, balls, side
from tresym.reals.resource_limits import held

At = Mapping[str, arb | fmpq]
Unique = Callable[[Expr, At], bool]
"""Whether it is known that a node has one root at most, where the variables have these values."""
Root = Callable[[Expr, "Enclosing"], arb]

JUMPS = frozenset(("sign", "atan2"))
"""Operations whose balls are finite where their values jump."""
ROUGH = 64
"""Bits at which a root is looked for."""
ENDS = 24
"""It is looked for between points as near to the ends as the part 2^−ENDS of the way."""
STEPS = 60
EVALUATIONS = 20_000
"""How far an integral is refined."""
SPARE = 6
"""Bits by which an integral is asked for better than the integrand is known."""
WIDER = 8
"""How often a bracket is doubled."""


def no_root(e: Expr, outer: Enclosing) -> arb:
    """What is known of roots where nothing is asked of them."""
    raise UndefinedError


class Enclosing(InBalls):
    """Values in balls, those of integrals and roots among them, and of what is put in.

    Raises, as all values in balls do, where a value is not shown to exist.
    """

    def __init__(self, at: At, root: Root = no_root) -> None:
        """``at`` may work out what it is asked for; ``root`` finds and shows what a root is."""
        super().__init__(balls, at, {})
        self.root = root

    def _computed(self, e: Expr) -> arb:
        if e.op == "integral":
            return self._integral(e)
        if e.op == "root":
            return self.root(e, self)
        if e.op == "at":
            names, body = opened(e)
            points = dict(zip(names, map(self.value, e.args[1:]), strict=True))
            return _Inner(self, points).value(body)
        if e.op == "derivative" and (found := worked_out(e)).op != "derivative":
            return self.value(found)
        if e.names or e.op in ("O", "o"):
            raise UndefinedError
        if e.op == "*":
            return self._quotient(e)
        return super()._computed(e)

    def _quotient(self, e: Expr) -> arb:
        """A product, what is below divided by: a fraction of integers is rounded but once."""
        above, below = arb(1), arb(1)
        for factor in e.args:
            if factor.op == "^" and factor.args[1] == MINUS_ONE:
                below *= self.value(factor.args[0])
            else:
                above *= self.value(factor)
        return above / below

    def _integral(self, e: Expr) -> arb:
        low, high = (acb(self.value(end)) for end in e.args[1:])
        (name,), body = opened(e)
        integrand = Integrand(worked_out(body), name, self.value)
        # Not asked for much better than the integrand is known.
        known = integrand.real(((low + high) / 2).real.mid()).rel_accuracy_bits()
        tolerance = arb((1, -min(max(known, 0) + SPARE, ctx.prec)))
        fine = {"rel_tol": tolerance, "abs_tol": tolerance, "eval_limit": EVALUATIONS}
        with held():
            return acb.integral(integrand, low, high, **fine).real


def enclosed(e: Expr, at: At, root: Root = no_root) -> arb:
    """A ball that contains ``e`` at ``at``, NaN where none is shown; roots as ``root`` says."""
    return shown(e, Enclosing(at, root))


def shown(e: Expr, walker: Enclosing) -> arb:
    """As :func:`enclosed`, with what the walker knows from before, at the same precision."""
    try:
        return walker.value(e)
    except UndefinedError:
        return arb.nan()


class _Inner(Enclosing):
    """Values where more variables have values, the others known from outside."""

    def __init__(self, outer: Enclosing, more: dict[str, arb]) -> None:
        super().__init__(ChainMap(more, outer.at), outer.root)  # type: ignore[arg-type]
        self.outer, self.names = outer, more.keys()

    def value(self, e: Expr) -> arb:
        if e not in self.known and self.names.isdisjoint(symbols(e)):
            self.known[e] = self.outer.value(e)
        return super().value(e)


def jumps(e: Expr) -> bool:
    """Whether ``e`` may have a value where it is not continuous."""
    inner = (arg for arg in e.args if isinstance(arg, Expr))
    return e.op in JUMPS or (e.op not in LEAVES and any(map(jumps, inner)))


def bracketed(unique: Unique, e: Expr, outer: Enclosing) -> arb:
    """The root that a node is: a bracket with a change of sign, of a function without a jump.

    Raises:
        UndefinedError: none is found, or nothing says that there is one root at most.
    """
    low, high = (outer.value(end) for end in e.args[1:])
    (name,), body = opened(e)
    if not unique(e, outer.at) or jumps(body):
        raise UndefinedError
    middle = {n: outer.value(symbol(n)).mid() for n in symbols(body) if n != name}
    near, over = (_along(name, body, at, outer.root) for at in (middle, outer.at))
    return bracket(near, over, low, high)


def bracket(near: Callable[[arb], arb], over: Callable[[arb], arb], low: arb, high: arb) -> arb:
    """A ball between two ends, at whose own ends ``over`` has opposite signs.

    Args:
        near: a function near ``over`` whose values are sharp: where it is 0 is looked at first.
        over: a function without a jump, of balls.
        low, high: the ends.

    Raises:
        UndefinedError: none is found.
    """
    x, slope = _found(near, low.mid(), high.mid())
    width = (over(x) / slope).abs_upper() * arb("1.25") + abs(x) * arb((1, 8 - ctx.prec))
    for _ in range(WIDER):
        first, last = (x - width).mid(), (x + width).mid()
        both = first.union(last)
        signs = {side(over(first)), side(over(last))}
        if signs == {1, -1} and low < first and last < high and over(both).is_finite():
            return both
        width *= 2
    raise UndefinedError


def _along(name: str, body: Expr, at: At, root: Root) -> Callable[[arb], arb]:
    """``body`` as a function of one variable, NaN where it is undefined."""
    outers: dict[int, Enclosing] = {}

    def function(x: arb) -> arb:
        outer = outers.setdefault(ctx.prec, Enclosing(at, root))  # what is known is so precise
        try:
            return _Inner(outer, {name: x}).value(body)
        except UndefinedError:
            return arb.nan()

    return function


def _found(f: Callable[[arb], arb], low: arb, high: arb) -> tuple[arb, arb]:
    """A point near a root between the ends, to the working precision, and the slope there.

    By regula falsi with halved weights (Illinois) and then by secants.

    Raises:
        UndefinedError: no change of sign is met.
    """
    with ball_precision(ROUGH):
        one, two = _change(f, low, high)
        (x, at_x), (y, at_y) = one, two
        for _ in range(STEPS):
            z = ((x * at_y - y * at_x) / (at_y - at_x)).mid()
            value = f(z).mid()
            if abs(z - y) < abs(y) * arb((1, -20)) or not value:
                break
            at_x, x = (at_y, y) if value * at_y < 0 else (at_x / 2, x)
            y, at_y = z, value
    x, at_x = y, f(y).mid()
    y, at_y = z, f(z).mid()
    slope = (at_y - at_x) / (y - x)
    for _ in range(STEPS):
        step = (at_y / slope).mid()
        x, at_x, y = y, at_y, (y - step).mid()
        if not abs(step) > abs(y) * arb((1, 16 - ctx.prec)):
            break
        at_y = f(y).mid()
        slope = (at_y - at_x) / (y - x)
    if not (slope.is_finite() and slope):
        raise UndefinedError
    return y, slope.mid()


def _change(
    f: Callable[[arb], arb], low: arb, high: arb
) -> tuple[tuple[arb, arb], tuple[arb, arb]]:
    """Two points with values of opposite signs, from the middle towards both ends."""
    middle = ((low + high) / 2).mid()
    last = [(middle, f(middle))] * 2
    for n in range(2, ENDS + 1):
        step = (high - low) * arb((1, -n))
        for end, x in enumerate((low + step, high - step)):
            here = x.mid(), f(x.mid())
            for there in (last[end], last[1 - end]):
                if here[1] * there[1] < 0:
                    return there, here
            if side(here[1]):
                last[end] = here
    raise UndefinedError


def value(e: Expr, at: At, unique: Unique) -> arb:
    """A ball that contains ``e`` at ``at``, at the working precision; NaN where none is shown."""
    return enclosed(e, at, partial(bracketed, unique))
