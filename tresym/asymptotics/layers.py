"""Decide orders for boundary value problems with boundary layers.

Example: the solution of e*y'' + y' == 0, y(0) == 0, y(1) == 1 is 1 − exp(−x/e) + O(e) as e → 0+,
uniformly for 0 <= x <= 1. The highest derivative has a small factor: away from x = 0 the solution
is close to one of the equation y' = 0 without it, and near x = 0 it changes fast, so as to reach
its boundary value. Equations of second order that are linear in y become, with t a root of e,

    L y = tⁿ y'' + a y' + b y = f,   l <= x <= h,

with a, b and f smooth where t = 0. There are two kinds:

*One layer*: a > 0 where t = 0 (for a < 0 exchange the ends). Let W be positive with LW < 0; then
LD >= 0 and D <= 0 at the ends imply D <= 0, and there is exactly one solution (generalized maximum
principle). With W' a + bW = −1 outside and W = exp(−βs), s = (x − l)/tⁿ, β < a, in the layer: if an
approximation Y has a residual that is O(tᵏ) + O(tᵏ⁻ⁿ e^{−λs}) with λ > 0, and errors O(tᵏ) at the
ends, then y = Y + O(tᵏ), uniformly between the ends. An error of any size in the layer, or at l,
contributes O(e^{−βs}), which vanishes faster than all powers for each fixed x > l.

*Two layers*: b < 0 where t = 0. Then constants are such functions W: residual and errors at the
ends O(tᵏ) make an error O(tᵏ).

The residual of Y is read as a sum of exponentials with smooth factors
(:mod:`tresym.asymptotics.layer_sums`), so that its orders are shown exactly. A claim is refuted by
the composite that is true: the outer solution and the layers are computed order by order
(:mod:`tresym.asymptotics.composites`), are shown as above, and what is left is an explicit claim.

Sources: M. H. Protter and H. F. Weinberger, *Maximum Principles in Differential Equations*, 1984,
section 1.5; W. Eckhaus, *Asymptotic Analysis of Singular Perturbations*, 1979, chapter 4.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.boundary_values import between, ends
from tresym.asymptotics.composites import inner, outer
from tresym.asymptotics.constants import rounded
from tresym.asymptotics.differential_problem import OpenError, Problem, problem_of
from tresym.asymptotics.explicit_claims import curve_of_claim
from tresym.asymptotics.layer_sums import Exponent, Layered, Part, Reader, known_sign
from tresym.asymptotics.lemma import rounded_up
from tresym.asymptotics.order_claims import region
from tresym.asymptotics.readable_terms import readable
from tresym.reals.decisions.answer import Answer, Decide, constant_ball, exact_text
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    ONE,
    ZERO,
    Expr,
    add,
    number,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

LEMMA = (
    "residual and maximum principle for a boundary layer (Protter and Weinberger 1984, "
    "section 1.5; Eckhaus 1979, chapter 4)"
)
REACHES = (fmpq(1, 2), fmpq(1, 5), fmpq(1, 10), fmpq(1, 20), fmpq(1, 100), fmpq(1, 1000))
SHARP = arb("1.5")
"""A shorter range of the parameter is taken if the constant gets smaller by this factor."""
HIGHEST = 4
"""The highest power of t up to which orders are shown."""


class Layer(NamedTuple):
    """The problem L y = f in normal form, with the layer at the lower end if there is one.

    Attributes:
        reader: reads expressions as sums of exponentials.
        low, high: the ends.
        n: the power of t at y''.
        a, b, f: smooth parts: powers of t with factors.
        values: at the lower and the upper end.
        both: whether both ends have layers.
        mirrored: whether the ends were exchanged, so that x stands for low + high − x.
        closed: the conditions with x between the ends.
        fixed: those without x.
    """

    reader: Reader
    low: Expr
    high: Expr
    n: int
    a: Part
    b: Part
    f: Part
    values: tuple[Expr, Expr]
    both: bool
    mirrored: bool
    closed: Given
    fixed: Given

    @property
    def x(self) -> str:
        """The variable."""
        return self.reader.x

    @property
    def t(self) -> str:
        """The small parameter's root."""
        return self.reader.t

    def turned(self, e: Expr) -> Expr:
        """Return an expression for exchanged ends, if they are exchanged."""
        if not self.mirrored:
            return e
        return substitute(e, {self.x: self.low + self.high - symbol(self.x)})

    def end(self, k: int) -> Expr:
        """Return the lower or the upper end, in the original variables."""
        return (self.low, self.high)[1 - k if self.mirrored else k]

    def at_zero(self, part: Part) -> Expr:
        """Return the limit of a smooth part."""
        return ZERO if part.power else tidied(substitute(part.factor, {self.t: ZERO}))

    def residual(self, curve: Layered) -> Layered:
        """Return L Y − f."""
        r = self.reader
        slope = r.derivative(curve)
        return r.sum(
            [
                r.product({(): Part(self.n, ONE)}, r.derivative(slope)),
                r.product({(): self.a}, slope),
                r.product({(): self.b}, curve),
                {(): Part(self.f.power, -self.f.factor)},
            ]
        )


class Needs(NamedTuple):
    """What is asked of an approximation.

    Attributes:
        order: the power of t.
        near: for each end, whether all points near it count together.
        at: for each end, whether the end itself counts.
    """

    order: int
    near: tuple[bool, bool]
    at: tuple[bool, bool]


class GapError(Exception):
    """An approximation is not shown to be as good as is needed; the text says where it fails."""


def decide_layers(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide an order for a linear problem with boundary layers; None if there are none.

    Raises:
        OpenError: what is missing.
    """
    path = statement.path
    if path is None or path.point != ZERO or claim.relation not in ("O", "o", "->"):
        return None
    small = symbol(path.name)
    positive = statement.given & Given(((small, ">", ZERO),))
    try:
        problem = problem_of(replace(statement, given=positive))
    except OpenError:
        return None
    if path.name == problem.time or sorted(key[1] for key in problem.state) != [0, 1]:
        return None
    found = layer_of(problem, statement, path.name, [claim.left, claim.right])
    if found is None:
        return None
    name, _ = min(problem.state, key=lambda key: key[1])
    e = curve_of_claim(claim, problem)[problem.state[name, 0]]
    gauge = claim.right if claim.relation != "->" else ONE
    if path.sides != (1,):
        raise OpenError(
            f"the side of a boundary layer depends on the sign of {small}: write {small} -> 0+"
        )
    return _decided(claim, e, gauge, found, problem, statement, decided)


def layer_of(problem: Problem, statement: Statement, small: str, more: list[Expr]) -> Layer | None:
    """Return the normal form of a problem; None if its coefficients are smooth.

    Raises:
        OpenError: it has none of the two kinds.
    """
    if problem.is_initial:
        return None
    x = problem.time
    (name,) = {key[0] for key in problem.state}
    y, slope = problem.state[name, 0], problem.state[name, 1]
    right = problem.right[slope]
    links = statement.given.comparisons
    if any(small in symbols(value.point) for value in problem.given):
        raise OpenError("the ends of the interval must not depend on the small parameter")
    tied = [link for link in links if small in symbols(link[0]) | symbols(link[2])]
    plain = Given(tuple(link for link in links if link not in tied))
    if any(
        symbols(link[0]) | symbols(link[2]) != {small} or small_is_bounded(link, small)
        for link in tied
    ):
        raise OpenError("conditions on the small parameter are not supported")
    fixed, closed = between(problem, plain)
    low, high = ends(problem, fixed)
    inside = fixed & Given(((symbol(x), ">=", low), (symbol(x), "<=", high)))
    parts = [tidied(-differentiate(right, slope)), tidied(-differentiate(right, y))]
    if any({y, slope} & symbols(part) for part in parts):
        return None
    free = tidied(substitute(right, {y: ZERO, slope: ZERO}))
    given = {v.point: v for v in problem.given}
    values = [given[point].value for point in (low, high)]
    if small not in set().union(*map(symbols, (*parts, free))):
        return None
    reader = Reader(x, small, inside, [*parts, free, *values, *more])
    read = [_smooth_part(reader, part, inside) for part in (*parts, free)]
    n = -min((p.power for p in read if p.factor != ZERO), default=0)
    if n <= 0:
        return None
    if any(given[point].variable != y for point in (low, high)):
        raise OpenError("boundary layers are supported for values of the function at both ends")
    if closed is fixed:
        raise OpenError(
            f"say where {x} lies: the solution has a boundary layer, and the claim is "
            f"meant for {low} <= {x} <= {high}"
        )
    a, b, f = (Part(p.power + n, p.factor) if p.factor != ZERO else Part(0, ZERO) for p in read)
    layer = Layer(
        reader, low, high, n, a, b, f, (values[0], values[1]), False, False, inside, fixed
    )
    first = known_sign(layer.at_zero(a), inside)
    if first < 0:
        mirror = partial(substitute, mapping={x: low + high - symbol(x)})
        return layer._replace(
            a=a._replace(factor=tidied(mirror(-a.factor))),
            b=b._replace(factor=tidied(mirror(b.factor))),
            f=f._replace(factor=tidied(mirror(f.factor))),
            values=(values[1], values[0]),
            mirrored=True,
        )
    if first > 0:
        return layer
    if known_sign(layer.at_zero(b), inside) < 0:
        if 2 * a.power < n and a.factor != ZERO and not is_zero(a.factor, inside):
            raise OpenError(
                "the factor of the first derivative is too large beside that of the "
                "function for two boundary layers"
            )
        if n % 2:  # the layers are as wide as its square root
            root = symbol(small) ** number(fmpq(1, 2 * reader.q))
            return layer_of(problem, statement, small, [*more, root])
        return layer._replace(both=True)
    raise OpenError(
        f"boundary layers are supported where the factor of the first derivative, "
        f"{layer.at_zero(a)}, has one sign from {low} to {high}, or that of the function is "
        f"negative with the sign of the highest derivative: neither is shown"
    )


def small_is_bounded(link: tuple[Expr, str, Expr], small: str) -> bool:
    """Whether a condition on the small parameter alone excludes values near 0."""
    left, relation, right = link
    gap = right - left if relation[0] == "<" else left - right
    if relation not in ("<", "<=", ">", ">="):
        return True
    near = Given(((symbol(small), ">", ZERO), (symbol(small), "<", number(fmpq(1, 10**6)))))
    return sign(gap, near, ">") not in PROVING[">"]


def _smooth_part(reader: Reader, e: Expr, inside: Given) -> Part:
    found = reader.read(e)
    if found and set(found) != {()}:
        raise OpenError(
            "the coefficients of the equation must be smooth but for powers of the small parameter"
        )
    part = found.get((), Part(0, ZERO))
    if is_zero(part.factor, reader.given):
        return Part(0, ZERO)
    first = reader._first(part.factor) if reader.t in symbols(part.factor) else 0
    factor = part.factor
    if first:
        factor = normal_form(factor / symbol(reader.t) ** first, reader.given)
    need_smooth_at_zero(reader, factor, inside)
    return Part(part.power + first, factor)


def need_smooth_at_zero(reader: Reader, e: Expr, inside: Given) -> None:
    """Require that an expression is smooth in x and t near t = 0 for all x between the ends.

    Raises:
        OpenError: that is not shown.
    """
    gap = continuous_on(substitute(e, {reader.t: ZERO}), inside, proof)
    if gap is not None:
        raise OpenError(f"{e} is not shown to be smooth where {reader.small} = 0: {gap}")


# Orders


def _decided(
    claim: Comparison,
    e: Expr,
    gauge: Expr,
    layer: Layer,
    problem: Problem,
    statement: Statement,
    decided: Decide,
) -> Answer:
    order = gauge_order(layer, gauge) + (claim.relation != "O")
    if order > HIGHEST * layer.reader.q:
        raise OpenError(f"orders up to {layer.reader.small}**{HIGHEST} are supported")
    closed, apart = _ends_of_conditions(problem, statement, layer)
    if statement.uniformly:
        closed = (not apart[0], not apart[1])  # by continuity
    uniform = Needs(order, (not apart[0], not apart[1]), closed)
    fixed = Needs(order, (False, False), closed)
    small = layer.reader.small
    shown = power_of(small, order, layer.reader.q)
    asked = (uniform,) if statement.uniformly else (uniform, fixed)
    gap: GapError | None = None
    parameters = layer_parameters(layer, e)
    for needs in asked:
        try:
            check(layer, e, needs)
        except GapError as error:
            gap = gap or error
            continue
        why = (
            f"{e} satisfies the equation and the boundary values up to an error that the maximum "
            f"principle bounds by a multiple of {shown}, "
        )
        if needs is uniform and not parameters and claim.relation == "O":
            known = _with_constant(layer, e, gauge, order, statement)
            if known is not None:
                return known
        if needs is uniform and not parameters:
            return Answer(Verdict.PROVED, f"{why}uniformly in {layer.x}", lemma=LEMMA, uniform=True)
        if needs is uniform:
            if statement.uniformly:
                names = ", ".join(sorted(parameters))
                raise OpenError(
                    f"it holds uniformly in {layer.x} for fixed {names}, but no "
                    f"constant was found that serves for all {names}"
                )
            return Answer(Verdict.PROVED, f"{why}uniformly in {layer.x}", lemma=LEMMA)
        return Answer(Verdict.PROVED, f"{why}for each fixed {layer.x}", lemma=LEMMA)
    found = _refuted(claim, e, gauge, layer, asked[-1], statement, decided)
    if found is not None:
        return found
    raise OpenError(f"it is not shown: {gap}")


def _with_constant(
    layer: Layer, e: Expr, gauge: Expr, order: int, statement: Statement
) -> Answer | None:
    """Return the answer with a constant for all small values of the parameter, or None."""
    from tresym.asymptotics.layer_constants import error_constant

    path = statement.path
    needs = Needs(order, (True, True), (True, True))
    try:
        check(layer, e, needs)
    except GapError:
        return None
    if path is None or layer.reader.nearly_one:
        return None
    curve = read_curve(layer, layer.turned(e))
    _, factor = layer.reader.read(gauge)[()]
    best: tuple[arb, fmpq] | None = None
    for reach in REACHES if path.reach is None else (path.reach,):
        found = error_constant(layer, curve, order, reach)
        if found is None:
            continue
        if best is not None and not found * SHARP < best[0]:
            break
        best = found, reach
        if found <= 1:
            break
    if best is None:
        return None
    with ball_precision():
        constant = arb((best[0] / abs(evaluate(factor, {}))).upper())
        shown = rounded(constant, 1)
        ball = constant_ball(arb(rounded_up(constant, 6)))
    why = (
        f"|left| <= C |right| with C = {shown} for all {layer.x} between {layer.end(0)} and "
        f"{layer.end(1)}: a positive function on which the equation is negative bounds the error"
    )
    return Answer(
        Verdict.ENCLOSED,
        why,
        lemma=LEMMA,
        constant=ball,
        region=region(path, best[1]),
        uniform=True,
    )


def composite(layer: Layer, order: int) -> Expr:
    """Return the composite expansion up to terms of an order, in the original variables.

    Args:
        layer: the problem.
        order: the power of t of the error.

    Raises:
        OpenError: it is not found.
    """
    r = layer.reader
    parts = (layer.a, layer.b, layer.f)
    end = None if layer.both else (layer.high, layer.values[1])
    terms = outer(r, parts, layer.n, order, layer.fixed, end)
    t = symbol(r.t)
    total: Expr = ZERO
    for i, term in enumerate(terms):
        total = total + (term * t**i if i else term)
    width = layer.n // 2 if layer.both else layer.n
    for point, value, direction in (
        (layer.low, layer.values[0], 1),
        *(((layer.high, layer.values[1], -1),) if layer.both else ()),
    ):
        there = dict(r.coefficients(r.read(value).get((), Part(0, ZERO)), order))
        starts = [
            tidied(normal_form(there.get(i, ZERO) - substitute(term, {r.x: point}), layer.fixed))
            for i, term in enumerate(terms)
        ]
        total = total + inner(
            r, layer.a, layer.b, layer.n, width, point, direction, starts, layer.fixed
        )
    found = layer.turned(substitute(total, {r.t: symbol(r.small) ** number(fmpq(1, r.q))}))
    terms = list(found.args) if found.op == "+" else [found]
    return tidied(add(*(readable(term, r.small, 1) for term in terms)))


def _refuted(
    claim: Comparison,
    e: Expr,
    gauge: Expr,
    layer: Layer,
    needs: Needs,
    statement: Statement,
    decided: Decide,
) -> Answer | None:
    """Refute a claim at an end, or by the composite that is shown to be true."""
    small = symbol(layer.reader.small)
    asked = claim.relation if claim.relation != "->" else "o"

    def fails(error: Expr, point: Expr, there: dict[str, fmpq]) -> bool:
        put = {name: number(value) for name, value in there.items()}
        at = partial(substitute, mapping={**put, layer.x: substitute(point, put)})
        plain = Statement((), Given(), statement.path, "")
        found = decided(Comparison(tidied(at(error)), asked, at(gauge)), plain)
        return found.verdict is Verdict.REFUTED

    names = sorted(layer_parameters(layer, e))
    places = list(layer.fixed.points(names, 3)) if names else [{}]
    for end in (0, 1):
        if needs.at[end]:
            for there in places:
                point = layer.end(end)
                gap = e - layer.values[end]
                if fails(gap, point, there):
                    why = f"the boundary value at {point} is {layer.values[end]}, not "
                    why += f"{tidied(substitute(e, {layer.x: point}))}"
                    return Answer(
                        Verdict.REFUTED,
                        why,
                        witness={layer.x: exact_text(point), **_texts(there)},
                        lemma=LEMMA,
                    )
    true = composite(layer, needs.order)
    try:
        check(layer, true, Needs(needs.order, (True, True), (True, True)))
    except GapError as error:
        raise OpenError(f"it is not shown, nor is {true}: {error}") from None
    shown = power_of(layer.reader.small, needs.order, layer.reader.q)
    whole = statement.given & Given(((small, ">", ZERO),))
    inside = Given(
        tuple(
            c
            for c in whole.comparisons
            if layer.reader.small not in (symbols(c[0]) | symbols(c[2]))
        )
    )
    for there in places:
        for point in _points(layer, needs, inside, there):
            if fails(e - true, point, there):
                fixed = layer.reader.small not in symbols(point)
                witness = {layer.x: exact_text(point)} if fixed else {}
                why = (
                    f"{layer.x} = {point}: the solution is {true} + O({shown}), uniformly in "
                    f"{layer.x}, and this differs from {e} by more"
                )
                return Answer(
                    Verdict.REFUTED, why, witness={**witness, **_texts(there)}, lemma=LEMMA
                )
    return None


def _texts(there: dict[str, fmpq]) -> dict[str, str]:
    return {name: exact_text(number(value)) for name, value in there.items()}


def _points(layer: Layer, needs: Needs, given: Given, there: dict[str, fmpq]) -> Iterator[Expr]:
    """Yield points at which a claim may fail: fixed ones, and moving ones in the layers."""
    at = given.mapped(partial(substitute, mapping={n: number(x) for n, x in there.items()}))
    yield from (number(point[layer.x]) for point in at.points([layer.x], 3))
    width = fmpq(layer.n, layer.reader.q) / (2 if layer.both else 1)
    for s in (fmpq(1), fmpq(1, 3)):
        step = number(s) * symbol(layer.reader.small) ** number(width)
        for end in (0, 1) if layer.both else (0,):
            if needs.near[end]:
                yield layer.end(end) + (step if (end == 0) != layer.mirrored else -step)


def power_of(small: str, order: int, q: int) -> str:
    """Return t to a power in words of the small parameter."""
    power = fmpq(order, q)
    return (
        "1"
        if not order
        else small
        if power == 1
        else f"{small}**({power})"
        if (power.q != 1)
        else f"{small}**{power}"
    )


def layer_parameters(layer: Layer, e: Expr) -> frozenset[str]:
    """Return the parameters beside the variable and the small one."""
    trees = [layer.a.factor, layer.b.factor, layer.f.factor, *layer.values, layer.low, layer.high]
    return symbols(e).union(*map(symbols, trees)) - {layer.x, layer.t, layer.reader.small}


def gauge_order(layer: Layer, gauge: Expr) -> int:
    """Return the power of t that a comparison function is a multiple of.

    Raises:
        OpenError: it is no such multiple.
    """
    found = layer.reader.read(gauge)
    if set(found) == {()}:
        v, g = found[()]
        if layer.x not in symbols(g) and layer.t not in symbols(g) and known_sign(g, layer.fixed):
            return v
    raise OpenError("the comparison function must be a power of the small parameter")


def _ends_of_conditions(
    problem: Problem, statement: Statement, layer: Layer
) -> tuple[tuple[bool, bool], tuple[bool, bool]]:
    """Return for each end whether the conditions contain it, and whether they keep away from it."""
    x = symbol(problem.time)
    contain, apart = [True, True], [False, False]
    for left, relation, right in statement.given.comparisons:
        if x not in (left, right):
            continue
        end = right if left == x else left
        below = (relation[0] == "<") == (left == x)
        k = 1 if below else 0
        gap = layer.high - end if below else end - layer.low
        if sign(gap, layer.fixed, ">") in PROVING[">"]:
            contain[k], apart[k] = False, True
        elif not relation.endswith("="):
            contain[k] = False
    if layer.mirrored:
        contain.reverse()
        apart.reverse()
    return (contain[0], contain[1]), (apart[0], apart[1])


def check(layer: Layer, e: Expr, needs: Needs) -> None:
    """Show that y = Y + O(tᵏ).

    Args:
        layer: the problem.
        e: the approximation Y, in the original variables.
        needs: the order and where it is needed.

    Raises:
        GapError: an error is not shown to be small enough.
        OpenError: Y is no sum of exponentials.
    """
    r = layer.reader
    curve = read_curve(layer, layer.turned(e))
    k = needs.order
    loose = (True, layer.both)
    for end, point, value in zip((0, 1), (layer.low, layer.high), layer.values, strict=True):
        if not needs.at[end] and loose[end] and not needs.near[end]:
            continue
        error = r.sum([at_point(layer, curve, point), r.read(-value)])
        for key, part in error.items():
            if key and r._is_flat(key):
                continue
            if key:
                raise OpenError("an exponential at an end of the interval is not small")
            for power, c in r.coefficients(part, k):
                if not is_zero(c, layer.fixed):
                    there = power_of(r.small, power, r.q)
                    raise GapError(
                        f"its value at {layer.end(end)} differs from {value} by ({c})*{there}"
                    )
    for key, part in layer.residual(curve).items():
        kind = kind_of(layer, key)
        need_smooth_at_zero(r, part.factor, layer.closed)
        if kind is None:
            continue
        place, scale = kind
        if place is None:
            for power, c in r.coefficients(part, k):
                if not is_zero(c, r.given):
                    raise GapError(
                        f"the residual of the equation is ({tidied(layer.turned(c))})*"
                        f"{power_of(r.small, power, r.q)} outside the layers"
                    )
            continue
        if loose[place] and not needs.near[place]:
            continue
        gain = layer.n if not layer.both and place == 0 and scale == layer.n else 0
        point = (layer.low, layer.high)[place]
        for power, c in r.coefficients(part, k - gain):
            d = 0
            while power + d * scale < k - gain:
                if not is_zero(substitute(c, {layer.x: point}), layer.fixed):
                    raise GapError("the residual of the equation in the layer is of lower order")
                c = differentiate(c, layer.x)
                d += 1


def read_curve(layer: Layer, e: Expr) -> Layered:
    """Return an approximation as a sum of exponentials that do not grow."""
    r = layer.reader
    curve = r.read(e)
    nearly = dict.fromkeys(r.nearly_one.values(), ONE)
    found = {}
    for key, part in curve.items():
        kind_of(layer, key)
        factor = substitute(part.factor, nearly) if nearly else part.factor
        need_smooth_at_zero(r, factor, layer.closed)
        found[key] = part._replace(factor=factor)
    return found


def at_point(layer: Layer, curve: Layered, point: Expr) -> Layered:
    """Return the value of a sum of exponentials at a point."""
    put = partial(substitute, mapping={layer.x: point})
    terms = []
    for key, (v, g) in curve.items():
        there = tuple((k, c) for k, f in key if (c := tidied(normal_form(put(f), Given()))) != ZERO)
        terms.append({there: Part(v, put(g))})
    return layer.reader.sum(terms)


def kind_of(layer: Layer, key: Exponent) -> tuple[int | None, int] | None:
    """Return the end and the scale of a layer, (None, 0) for the smooth part, None if negligible.

    Raises:
        OpenError: the exponential is no layer.
    """
    if not key:
        return None, 0
    leading = key[0][1]
    scale = -key[0][0]
    slope = differentiate(leading, layer.x)
    for end, point, direction in ((0, layer.low, -1), (1, layer.high, 1)):
        there = [substitute(f, {layer.x: point}) for _, f in key]
        at_end = all(is_zero(value, layer.fixed) for value in there)
        if at_end and known_sign(slope * direction, layer.closed) > 0:
            return end, scale
    if known_sign(leading, layer.closed) < 0:
        return None
    shown = " + ".join(f"({f})/{power_of(layer.reader.small, -k, layer.reader.q)}" for k, f in key)
    raise OpenError(f"exp({shown}) is not shown to vanish away from one end")
