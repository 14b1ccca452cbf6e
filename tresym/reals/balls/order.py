"""Order statements about one small parameter: O, o, ~ and "at most C times", decided.

A statement is about two functions of one variable on a path: x → 0+ by default, or x → c from a
side, or x → ±∞; a problem with several variables names its path by composition. Both functions run
as germs (:mod:`tresym.reals.balls.germ`), so the ratio's leading term and a remainder that holds on
a whole interval (0, t₀] of the small parameter are certified; beyond t₀ boxes take over
(:mod:`tresym.reals.balls.boxes`). A wrong exponent is refuted with the true order; a wrong constant
with a rational point at which it fails. Uniform statements about regions of several variables are
bounds on boxes and belong to the enclosure.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator
from dataclasses import dataclass, field, replace
from typing import Any

from flint import arb, ctx, fmpq

from tresym.reals.balls.boxes import Bound, Counterexample, Open, box, decide_bound, supremum
from tresym.reals.balls.germ import (
    Germ,
    Germs,
    LogarithmError,
    RamifiedError,
    UnresolvedError,
    as_ball,
    is_zero,
)
from tresym.reals.numbers.arithmetic import WORKING, ball_precision, balls
from tresym.reals.numbers.exact import fraction_text
from tresym.reals.verdict import Verdict

Function = Callable[[Any, Any], Any]

KINDS = ("O", "o", "~", "<=")
MOST_HALVINGS = 16
ORIGIN = fmpq(0)
ONE = fmpq(1)


@dataclass(frozen=True)
class Order:
    """``function = kind(gauge)`` as the variable tends to a point; a frozen statement.

    Attributes:
        kind: ``O``, ``o``, ``~``, or ``<=`` for |function| ≤ constant · |gauge| on the range.
        function: of the variable and the arithmetic.
        gauge: likewise; must not vanish near the point.
        at: the point; None for infinity.
        side: +1 for from above (or +∞), −1 for from below (or −∞).
        constant: C, for ``<=``.
        upto: the range 0 < t ≤ upto of the small parameter t = |x − at|, or 1/|x| at infinity, for
            ``<=``; None for all t > 0.
    """

    kind: str
    function: Function
    gauge: Function
    at: fmpq | None = ORIGIN
    side: int = 1
    constant: fmpq | None = None
    upto: fmpq | None = ONE

    def __post_init__(self) -> None:
        if self.kind not in KINDS:
            raise ValueError(f"{self.kind!r} is not one of {', '.join(KINDS)}")
        if (self.kind == "<=") != (self.constant is not None):
            raise ValueError("a constant belongs to '<=', and to nothing else")

    def at_parameter(self, function: Function, t: Any, m: Any) -> Any:
        """``function`` where the small parameter is ``t``."""
        if self.at is None:
            return function(self.side / t, m)
        return function(self.at + t * self.side if self.at else t * self.side, m)


@dataclass(frozen=True)
class Size:
    """A leading term: coefficient · t^power · exp(Σ exponent_j / t^j).

    ``logarithmic`` says that t stands for 1/log(1/parameter) instead of the parameter itself, and
    then exp(−1/t) is the parameter.
    """

    coefficient: arb
    power: fmpq
    exponent: tuple[arb, ...] = ()
    logarithmic: bool = False

    def text(self, name: str = "t") -> str:
        """The leading term in plain text, coefficients to six digits."""
        parts = [self.coefficient.str(6, radius=False)]
        if self.logarithmic:
            return " * ".join([*parts, *self._logarithmic_parts(name)])
        if self.power != 0:
            parts.append(f"{name}^({fraction_text(self.power)})")
        for j, p in enumerate(self.exponent):
            if not p.is_zero():
                parts.append(f"exp({p.str(6, radius=False)}" + (f"/{name}^{j})" if j else ")"))
        return " * ".join(parts)

    def _logarithmic_parts(self, name: str) -> Iterator[str]:
        """t^power and exp(exponent_j / t^j) in powers of the parameter and of its logarithm."""
        far = re.fullmatch(r"\(1/(\w+)\)", name)
        base, side = (far[1], 1) if far else (name, -1)
        logarithm = f"log({base})" if far else f"log(1/{name})"
        if self.power != 0:
            yield f"{logarithm}^({fraction_text(-self.power)})"
        for j, p in enumerate(self.exponent):
            if j == 1 and not p.is_zero():
                whole = p.unique_fmpz()
                shown = (side * p).str(6, radius=False) if whole is None else str(side * whole)
                yield f"{base}^({shown})"
            elif not p.is_zero():
                yield f"exp({p.str(6, radius=False)}" + (f" * {logarithm}^{j})" if j else ")")


@dataclass(frozen=True)
class Judgement:
    """What an order statement came to.

    Attributes:
        verdict: ENCLOSED, REFUTED or UNDECIDED.
        ratio: leading term of function/gauge.
        true_order: leading term of the function.
        constant: for O a ball around the supremum of |function/gauge| on the range; C for <=.
        upto: the range of the small parameter on which the constant holds; None for all.
        points: for REFUTED, a parameter on the path at which the ratio was found.
        real: whether both functions are shown to be real on the range, by no point of it.
    """

    verdict: Verdict
    ratio: Size | None = None
    true_order: Size | None = None
    constant: arb | None = None
    upto: fmpq | None = None
    points: dict[str, fmpq] = field(default_factory=dict)
    real: bool = False


@dataclass(frozen=True)
class _Expansion:
    """The two functions and their ratio as germs; t is the small parameter's own parameter."""

    function: Germ
    ratio: Germ
    index: int
    logarithmic: bool
    reach: fmpq
    """The expansion holds for 0 < parameter ≤ reach."""

    def size(self, germ: Germ) -> Size:
        """The leading term of a germ, in the small parameter."""
        power = fmpq(germ.power, self.index)
        exponent = tuple(as_ball(p) for p in germ.exponent)
        return Size(germ.leading, power, exponent, self.logarithmic)


def judge_order(
    statement: Order, precision: int = WORKING, halvings: int = MOST_HALVINGS
) -> Judgement:
    """Decide an order statement; UNDECIDED where the expansion or the boxes do not suffice."""
    judge = _at_most if statement.kind == "<=" else _compared
    with ball_precision(precision):
        for expansion in _expansions(statement, halvings):
            try:
                found = judge(statement, expansion)
            except UnresolvedError:
                continue
            return found if _agrees(statement, expansion) else Judgement(Verdict.UNDECIDED)
    return Judgement(Verdict.UNDECIDED)


def _expansions(statement: Order, most: int = MOST_HALVINGS) -> Iterator[_Expansion]:
    """Expansions on shorter and shorter ranges, at two orders."""
    index, logarithmic = 1, False
    start = statement.upto or fmpq(1)
    for order in (8, 16):
        halvings = 0
        while halvings < most:
            if index == 1 and not logarithmic:
                reach = own = start / 2**halvings
            else:
                own = fmpq(1, 2**halvings)
                reach = _reach(own, index, logarithmic)
            try:
                if reach <= start:
                    yield _expansion(statement, own, order, index, logarithmic, reach)
            except UnresolvedError:
                pass
            except RamifiedError as error:
                index, halvings = index * error.index, -1
                if index > 12:
                    return
            except LogarithmError:
                if logarithmic:
                    return
                index, logarithmic, halvings = 1, True, -1
            halvings += 1


def _reach(own: fmpq, index: int, logarithmic: bool) -> fmpq:
    """A rational not above the parameter itself, where its own parameter is ``own``."""
    if not logarithmic:
        return own**index
    return fmpq(1, 2 ** (1 + int(3 / (2 * own))))  # 2^(−3/2) < exp(−1)


def _expansion(
    statement: Order, own: fmpq, order: int, index: int, logarithmic: bool, reach: fmpq
) -> _Expansion:
    m = Germs(own, order)
    t = m.exp(-1 / m.x) if logarithmic else m.x**index
    function = m.germ(statement.at_parameter(statement.function, t, m))
    gauge = m.germ(statement.at_parameter(statement.gauge, t, m))
    if function.vanishes:
        if statement.kind == "~" and gauge.vanishes:
            raise UnresolvedError("both functions are zero")
        return _Expansion(function, function, index, logarithmic, reach)
    ratio = function / gauge
    if not (function.range().is_finite() and ratio.range().is_finite()):
        raise UnresolvedError("a formula is not defined on the whole range")
    return _Expansion(function, ratio, index, logarithmic, reach)


def _compared(statement: Order, expansion: _Expansion) -> Judgement:
    """O, o and ~ from the leading term of the ratio.

    Raises:
        UnresolvedError: it does not settle the statement.
    """
    ratio = expansion.ratio
    growth = -1 if ratio.vanishes else ratio.growth()
    certain = not ratio.vanishes and not ratio.leading.contains(0)
    if statement.kind == "O":
        holds, fails = growth <= 0, growth > 0 and certain
    elif statement.kind == "o":
        holds, fails = growth < 0, growth >= 0 and certain
    else:
        exact = bool(ratio.terms) and is_zero(ratio.terms[0] - 1) and not ratio.exponent
        holds = growth == 0 and exact
        fails = growth < 0 or (certain and (growth > 0 or not _limit(ratio).contains(1)))
    sizes = expansion.size(ratio), expansion.size(expansion.function)
    if holds:
        constant = _supremum(statement, expansion) if statement.kind == "O" else None
        return Judgement(Verdict.ENCLOSED, *sizes, constant=constant, upto=expansion.reach)
    if fails:
        return Judgement(Verdict.REFUTED, *sizes, points={"t": expansion.reach / 16})
    raise UnresolvedError("the leading term does not settle the statement")


def _limit(ratio: Germ) -> arb:
    """The limit of a ratio of growth 0: c₀ exp(p₀)."""
    return ratio.leading * (as_ball(ratio.exponent[0]).exp() if ratio.exponent else arb(1))


def _supremum(statement: Order, whole: _Expansion) -> arb:
    """A ball that contains the supremum of |ratio| on the range of the expansion.

    Within one per cent where a shorter expansion and boxes beyond it allow, else from the whole.
    """
    if whole.ratio.vanishes:
        return arb(0)
    lower = _limit(whole.ratio).abs_lower() if whole.ratio.growth() == 0 else arb(0)
    upper = whole.ratio.field.values(whole.ratio).abs_upper()

    def size(t: Any, m: Any) -> Any:
        return abs(_ratio(statement, t, m))

    for k in range(4):
        value = size(arb(whole.reach / 2**k), balls)
        lower = lower.max(value.lower()) if value.is_finite() else lower
    for near in _expansions(statement):
        if upper < lower * arb("1.01") or near.reach < whole.reach / 2**12:
            break
        start = near.ratio.field.values(near.ratio).abs_upper()
        if near.reach < whole.reach and start < upper:
            region = box((near.reach, whole.reach))
            beyond = supremum(size, region, budget=500, slopes=True, precision=ctx.prec)
            if beyond is None:
                break  # a longer region would take more boxes still
            lower, upper = lower.max(beyond.low), start.max(beyond.high)
    return lower.union(upper)


def _ratio(statement: Order, t: Any, m: Any) -> Any:
    """function/gauge where the small parameter is ``t``."""
    function = statement.at_parameter(statement.function, t, m)
    return function / statement.at_parameter(statement.gauge, t, m)


def _agrees(statement: Order, expansion: _Expansion) -> bool:
    """Whether balls at points lie on the expansion: a function may go by what it is given."""
    germ = expansion.ratio
    for part in (2, 64):
        own = germ.field.upto / part
        t = (-1 / own).exp() if expansion.logarithmic else own**expansion.index
        gauge = statement.at_parameter(statement.gauge, t, balls)
        value = statement.at_parameter(statement.function, t, balls)
        if not all(isinstance(v, arb | fmpq | int) for v in (value, gauge)):
            return False
        value = arb(value) if germ.vanishes else arb(value) / gauge
        if value.is_finite() and not germ.at(own).overlaps(value):
            return False
    return True


def _at_most(statement: Order, expansion: _Expansion) -> Judgement:
    """|function| ≤ C |gauge|: near the point by the germ of C − |ratio|, then by boxes.

    Raises:
        UnresolvedError: this expansion does not settle the bound near the point.
    """
    sizes = expansion.size(expansion.ratio), expansion.size(expansion.function)
    witness = _violation(statement, expansion.reach)
    if witness is None:
        if not _stays_below(expansion.ratio, statement.constant):
            raise UnresolvedError("the bound is not certain near the point")
        end = _end(statement)
        if expansion.reach < end:
            outcome = decide_bound(_beyond(statement, expansion.reach, end), budget=4000)
            if isinstance(outcome, Open):
                return Judgement(Verdict.UNDECIDED)
            if isinstance(outcome, Counterexample):
                witness = outcome.point[0]
    if witness is not None:
        return Judgement(Verdict.REFUTED, *sizes, points={"t": witness})
    constant = arb(statement.constant)
    return Judgement(Verdict.ENCLOSED, *sizes, constant=constant, upto=statement.upto)


def _stays_below(ratio: Germ, constant: Any) -> bool:
    """|ratio| ≤ ``constant`` on the whole range of the germ."""
    try:
        margin = ratio.field.constant(constant) - abs(ratio)
        if margin.vanishes or margin.range() > 0:
            return True
    except UnresolvedError:
        pass
    return bool(abs(ratio.field.values(ratio)) < constant)


def _end(statement: Order) -> fmpq:
    """Where boxes may stop: the end of the range, or where an expansion at infinity takes over.

    Raises:
        UnresolvedError: no expansion at infinity settles the bound.
    """
    if statement.upto is not None:
        return statement.upto
    far = replace(
        statement,
        function=lambda s, m: statement.at_parameter(statement.function, 1 / s, m),
        gauge=lambda s, m: statement.at_parameter(statement.gauge, 1 / s, m),
        at=fmpq(0),
        side=1,
        upto=fmpq(1),
    )
    for expansion in _expansions(far):
        try:
            if _stays_below(expansion.ratio, statement.constant):
                return 1 / expansion.reach
        except UnresolvedError:
            continue
    raise UnresolvedError("the bound is not certain near infinity")


def _beyond(statement: Order, start: fmpq, end: fmpq) -> Bound:
    """C |gauge| − |function| > 0 on [start, end]."""

    def margin(t: Any, m: Any) -> Any:
        function = statement.at_parameter(statement.function, t, m)
        gauge = statement.at_parameter(statement.gauge, t, m)
        return abs(gauge) * arb(statement.constant) - abs(function)

    return Bound(margin, box((start, end)), slopes=True, precision=ctx.prec)


def _violation(statement: Order, reach: fmpq) -> fmpq | None:
    """A rational parameter in the range at which |function| > C |gauge|, if sampling finds one."""
    doublings = 0 if statement.upto is not None else 12
    for k in range(-doublings, 24):
        t = reach / fmpq(2) ** k
        if abs(_ratio(statement, arb(t), balls)) > arb(statement.constant):
            return t
    return None
