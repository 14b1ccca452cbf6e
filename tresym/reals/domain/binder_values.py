"""Enclose the values of integrals (rigorous quadrature) and of roots (change of sign).

For example, ∫ exp(−x²) dx from 0 to 1 is enclosed in 0.7468241328… ± 10⁻³⁸, and the root of
cos(x) − x between 0 and 1 in 0.7390851332….

The variables of the expression may be balls; the result then holds for every choice of values in
them. FLINT evaluates an integrand in complex balls where it asks whether the integrand is analytic.
Everywhere else the integrand is evaluated in real balls, which give NaN where it is undefined, so
that it is proved to be defined on the whole interval. The search for a root is heuristic. The proof
consists of opposite signs at the two ends of a bracket, and of finite values inside it, by which
the function has no jump there.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from functools import partial

from flint import acb, arb, ctx, fmpq

from tresym.reals.domain import gauss_legendre
from tresym.reals.domain.compiled import Compiled
from tresym.reals.domain.evaluation import NO_RULES, InBalls, Rule, UndefinedError
from tresym.reals.language.binders import worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import LEAVES, Expr, opened, symbol, symbols
from tresym.reals.numbers.arithmetic import WORKING, ball_precision, side
from tresym.reals.resource_limits import held

At = Mapping[str, arb | fmpq]
Unique = Callable[[Expr, At], bool]
"""Decide whether a node is known to have at most one root at these values of the variables."""

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


def integral(e: Expr, outer: InBalls) -> arb:
    """Return an integral between finite ends, by quadrature."""
    if not {INFINITY, -INFINITY}.isdisjoint(e.args[1:]):
        raise UndefinedError
    low, high = (outer.value(end) for end in e.args[1:])
    (name,), body = opened(e)
    integrand = Compiled(worked_out(body), (name,), outer.value)
    # A tolerance far below the accuracy of the integrand would only waste evaluations.
    known = integrand.real(((low + high) / 2).mid()).rel_accuracy_bits()
    return quadrature(integrand, low, high, max(known, 0) + SPARE)


def _at_point(e: Expr, outer: InBalls) -> arb:
    """Return the value of an expression at a point: its variables are those of the point."""
    names, body = opened(e)
    return outer.inner(dict(zip(names, map(outer.value, e.args[1:]), strict=True))).value(body)


def _derivative(e: Expr, outer: InBalls) -> arb:
    written = worked_out(e)
    if written.op == "derivative":
        raise UndefinedError
    return outer.value(written)


BINDERS: Mapping[str, Rule] = {"integral": integral, "at": _at_point, "derivative": _derivative}


def enclosing(at: At, rules: Mapping[str, Rule] = NO_RULES) -> InBalls:
    """Return an evaluation in balls that includes integrals, derivatives and values at a point.

    Args:
        at: the values of the variables.
        rules: how other operations are enclosed, such as roots, or the same in another way.
    """
    return InBalls(at, {**BINDERS, **rules})


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
    if isinstance(integrand, gauss_legendre.Integrand):
        found = gauss_legendre.integral(integrand, low, high, wanted)
        if found is not None and found.is_finite():
            return found
    tolerance = arb((1, -wanted))
    most = EVALUATIONS + MORE_EVALUATIONS * max(0, wanted - WORKING)
    fine = {"rel_tol": tolerance, "abs_tol": tolerance, "eval_limit": most}
    with held():
        return acb.integral(integrand, acb(low), acb(high), **fine).real


def enclosed(e: Expr, at: At, rules: Mapping[str, Rule] = NO_RULES) -> arb:
    """Return a ball that contains ``e`` at ``at``; NaN if the value is not proved to exist.

    Args:
        e: the expression.
        at: the values of its variables.
        rules: how operations such as roots are enclosed.
    """
    return value_or_nan(e, enclosing(at, rules))


def value_or_nan(e: Expr, walker: InBalls) -> arb:
    """Return the same as :func:`enclosed`, with the values that ``walker`` already knows."""
    try:
        return walker.value(e)
    except UndefinedError:
        return arb.nan()


def jumps(e: Expr) -> bool:
    """Return whether ``e`` may have a value where it is not continuous."""
    inner = (arg for arg in e.args if isinstance(arg, Expr))
    return e.op in JUMPS or (e.op not in LEAVES and any(map(jumps, inner)))


def bracketed(unique: Unique, e: Expr, outer: InBalls) -> arb:
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
    for rough, halving in ((ROUGH, False), (ctx.prec, False), (ctx.prec, True)):
        try:
            x, slope = _approximation(near, low.mid(), high.mid(), rough, halving)
        except UndefinedError:
            continue
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


def along(name: str, body: Expr, at: At, like: InBalls) -> Callable[[arb], arb]:
    """Return ``body`` as a function of one variable, NaN where it is undefined.

    Integrals, roots and other binders are enclosed as ``like`` encloses them.
    """
    outers: dict[int, InBalls] = {}  # by precision, which their known values have

    def outer() -> InBalls:
        return outers.setdefault(ctx.prec, InBalls(at, like.rules))

    try:
        return Compiled(body, (name,), lambda part: outer().value(part)).real
    except UndefinedError:  # a binder with the variable inside: evaluate the tree each time
        return lambda x: value_or_nan(body, outer().inner({name: x}))


def _approximation(
    f: Callable[[arb], arb], low: arb, high: arb, rough: int, halving: bool
) -> tuple[arb, arb]:
    """Return a point near a root between the ends, and the slope there.

    The method is regula falsi with halved weights (the Illinois algorithm), followed by the secant
    method at working precision. The first search has ``rough`` bits. Near an end at which the
    function is small, it moves by little; with ``halving`` every other step halves the interval.

    Raises:
        UndefinedError: no change of sign is found.
    """
    with ball_precision(rough):
        one, two = _change(f, low, high)
        (x, at_x), (y, at_y) = one, two
        for n in range(STEPS):
            z = ((x * at_y - y * at_x) / (at_y - at_x)).mid()
            if halving and n % 2:
                wide = x * y > 0 and not x / 4 < y < 4 * x
                z = ((x * y).sqrt() * (1 if x > 0 else -1) if wide else (x + y) / 2).mid()
            there = f(z)
            value = there.mid()
            close = abs(z - y) < abs(y) * arb((1, -20)) and (n % 2 or not halving)
            if close or side(there) is None:
                break
            at_x, x = (at_y, y) if value * at_y < 0 else (at_x / 2, x)
            y, at_y = z, value
    if y == z:  # the zero was hit exactly
        y = (z + (high - low) * arb((1, -30))).mid()
    elif halving:  # the slope is not taken between points whose values are not apart
        y = (z + abs(z) * arb((1, -(ctx.prec // 4)))).mid()
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
        there = f(y)
        if side(there) is None:  # nearer points differ by rounding errors alone
            break
        at_y = there.mid()
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
    return enclosed(e, at, {"root": partial(bracketed, unique)})
