"""Bring linear boundary value problems with boundary layers to a normal form.

Example: e*y'' + (1 + x)*y' + y == 0 with values at 0 and 1 is tⁿ y'' + a y' + b y = f with t = e,
n = 1, a = 1 + x and b = 1, and has a layer at the lower end, since a > 0; with a < 0 the ends are
exchanged. With a = 0 and b < 0 there are layers at both ends. Approximations are sums of
exponentials (:mod:`tresym.asymptotics.layer_sums`), of which each decays away from one end.
"""

from __future__ import annotations

from functools import partial
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.boundary_values import between, ends
from tresym.asymptotics.differential_problem import OpenError, Problem
from tresym.asymptotics.layer_sums import Exponent, Layered, Part, Reader, known_sign
from tresym.asymptotics.readable_terms import readable
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
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
from tresym.reals.signs.definedness import continuous_on
from tresym.reals.signs.interior import PROVING, is_zero
from tresym.reals.signs.sign import proof, sign


class Condition(NamedTuple):
    """The function, or its derivative, has a value at the lower (0) or upper (1) end."""

    end: int
    order: int
    value: Expr


ONE_LAYER, TWO_LAYERS, SECOND, FIRST = "one layer", "two layers", "second order", "first order"
"""Boundary value problems with a layer at one end or at both; initial value problems."""
DAMPED = "layers anywhere"
"""A boundary value problem in which the factor of the function is negative, so that the largest
error is bounded, but errors in layers may spread."""


class Layer(NamedTuple):
    """The problem L y = top y'' + a y' + b y = f in normal form, with the layer at the lower end.

    Attributes:
        reader: reads expressions as sums of exponentials.
        kind: which of the four kinds.
        low, high: the ends; an initial value problem may have no upper one.
        n: the power of t that is small beside 1: at y'', and at y' in an equation of first order.
        top, a, b, f: smooth parts: powers of t with factors.
        conditions: values at the ends.
        mirrored: whether the ends were exchanged, so that x stands for low + high − x.
        closed: the conditions with x between the ends.
        fixed: those without x.
    """

    reader: Reader
    kind: str
    low: Expr
    high: Expr | None
    n: int
    top: Part
    a: Part
    b: Part
    f: Part
    conditions: tuple[Condition, ...]
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

    @property
    def width(self) -> int:
        """The power of t that is the width of a layer."""
        return self.n // 2 if self.kind == TWO_LAYERS else self.n

    @property
    def gain(self) -> int:
        """The power of t that a residual in the layer at the lower end gains."""
        return self.n if self.kind in (ONE_LAYER, SECOND) else 0

    @property
    def loose(self) -> tuple[bool, bool]:
        """Whether errors in the layer at an end are negligible for each fixed x beside it."""
        return self.kind not in (SECOND, DAMPED), self.kind == TWO_LAYERS

    def turned(self, e: Expr) -> Expr:
        """Return an expression for exchanged ends, if they are exchanged."""
        if not self.mirrored or self.high is None:
            return e
        return substitute(e, {self.x: self.low + self.high - symbol(self.x)})

    def place(self, k: int) -> Expr:
        """Return the lower or the upper end."""
        if k == 1 and self.high is None:
            raise OpenError("there is no upper end")
        return self.low if k == 0 or self.high is None else self.high

    def end(self, k: int) -> Expr:
        """Return the lower or the upper end, in the original variables."""
        return self.place(1 - k if self.mirrored else k)

    def at_zero(self, part: Part) -> Expr:
        """Return the limit of a smooth part."""
        return ZERO if part.power else tidied(substitute(part.factor, {self.t: ZERO}))

    def residual(self, curve: Layered) -> Layered:
        """Return L Y − f."""
        r = self.reader
        slope = r.derivative(curve)
        return r.sum(
            [
                r.product({(): self.top}, r.derivative(slope)),
                r.product({(): self.a}, slope),
                r.product({(): self.b}, curve),
                {(): Part(self.f.power, -self.f.factor)},
            ]
        )


def layer_of(
    problem: Problem, statement: Statement, small: str, more: list[Expr], anywhere: bool = False
) -> Layer | None:
    """Return the normal form of a problem; None if its coefficients are smooth.

    Args:
        problem: of first or second order.
        statement: its conditions.
        small: the small parameter.
        more: other expressions that will be read.
        anywhere: whether the conditions need not say where x lies.

    Raises:
        OpenError: it has none of the kinds that are supported.
    """
    x = problem.time
    (name,) = {key[0] for key in problem.state}
    y = problem.state[name, 0]
    slope = problem.state.get((name, 1), "")
    right = problem.right[slope or y]
    parts = [
        tidied(-differentiate(right, slope)) if slope else ONE,
        tidied(-differentiate(right, y)),
    ]
    if any({y, slope} & symbols(part) for part in parts):
        return None
    free = tidied(substitute(right, {y: ZERO, **({slope: ZERO} if slope else {})}))
    if small not in set().union(*map(symbols, (*parts, free))):
        return None
    plain = _without_small(problem, statement, small)
    fixed, inside, low, high, missing = interval_of(problem, plain)
    values = [v.value for v in problem.given]
    reader = Reader(x, small, inside, [*parts, free, *values, *more])
    read = [smooth_part(reader, part, inside) for part in (*parts, free)]
    n = -min((p.power for p in read if p.factor != ZERO), default=0)
    if n <= 0:
        return None
    if missing and not anywhere:
        raise OpenError(
            f"say where {x} lies: the solution has a boundary layer, and the claim is "
            f"meant for {low} <= {x}" + ("" if high is None else f" <= {high}")
        )
    top = Part(n, ONE) if slope else Part(0, ZERO)
    a, b, f = (Part(p.power + n, p.factor) if p.factor != ZERO else Part(0, ZERO) for p in read)
    conditions = tuple(
        Condition(0 if v.point == low else 1, 0 if v.variable == y else 1, v.value)
        for v in problem.given
    )
    kind = ONE_LAYER if not problem.is_initial else SECOND if slope else FIRST
    layer = Layer(reader, kind, low, high, n, top, a, b, f, conditions, False, inside, fixed)
    first = known_sign(layer.at_zero(a), inside) if slope else 0
    second = 0 if first else known_sign(layer.at_zero(b), inside)
    if kind == SECOND:
        if first > 0:
            return layer
        raise OpenError(
            "initial layers of equations of second order are supported where the "
            f"factor of the first derivative, {layer.at_zero(a)}, is positive"
        )
    if kind == FIRST:
        if second > 0:
            return layer
        raise OpenError(
            "initial layers are supported where the factor of the function, "
            f"{layer.at_zero(b)}, is positive with the sign of the derivative"
        )
    if high is None:
        return None
    if first < 0:
        mirror = partial(substitute, mapping={x: low + high - symbol(x)})
        layer = layer._replace(
            a=a._replace(factor=tidied(mirror(-a.factor))),
            b=b._replace(factor=tidied(mirror(b.factor))),
            f=f._replace(factor=tidied(mirror(f.factor))),
            conditions=tuple(
                Condition(1 - c.end, c.order, -c.value if c.order else c.value) for c in conditions
            ),
            mirrored=True,
        )
    if first:
        if any(c.order and c.end for c in layer.conditions):
            raise OpenError("a slope is supported at the end with the boundary layer only")
        return layer
    if second < 0:
        if 2 * a.power < n and a.factor != ZERO and not is_zero(a.factor, inside):
            if any(c.order for c in conditions):
                raise OpenError("values of the function must be given at both ends")
            return layer._replace(kind=DAMPED)
        if n % 2:  # the layers are as wide as its square root
            root = symbol(small) ** number(fmpq(1, 2 * reader.q))
            return layer_of(problem, statement, small, [*more, root], anywhere)
        return layer._replace(kind=TWO_LAYERS)
    raise OpenError(
        f"boundary layers are supported where the factor of the first derivative, "
        f"{layer.at_zero(a)}, has one sign from {low} to {high}, or that of the function is "
        f"negative with the sign of the highest derivative: neither is shown"
    )


def _without_small(problem: Problem, statement: Statement, small: str) -> Given:
    """Return the conditions without those that the small parameter satisfies near 0."""
    links = statement.given.comparisons
    if any(small in symbols(value.point) for value in problem.given):
        raise OpenError("the ends of the interval must not depend on the small parameter")
    tied = [link for link in links if small in symbols(link[0]) | symbols(link[2])]
    if any(
        symbols(link[0]) | symbols(link[2]) != {small} or small_is_bounded(link, small)
        for link in tied
    ):
        raise OpenError("conditions on the small parameter are not supported")
    return Given(tuple(link for link in links if link not in tied))


def interval_of(problem: Problem, plain: Given) -> tuple[Given, Given, Expr, Expr | None, bool]:
    """Return the conditions without x and with it, the ends, and whether none speaks of x."""
    x = symbol(problem.time)
    if not problem.is_initial:
        fixed, closed = between(problem, plain)
        low, high = ends(problem, fixed)
        inside = fixed & Given(((x, ">=", low), (x, "<=", high)))
        return fixed, inside, low, high, closed is fixed
    links = plain.comparisons
    own = [link for link in links if problem.time in symbols(link[0]) | symbols(link[2])]
    fixed = Given(tuple(link for link in links if link not in own))
    start, top = problem.start, None
    bounded = False
    for left, relation, right in own:
        end = right if left == x else left
        if x not in (left, right) or problem.time in symbols(end) or relation == "!=":
            raise OpenError(f"the conditions must keep {x} in an interval")
        if (relation[0] == "<") == (left == x):
            later = top is not None and sign(end - top, fixed, ">=") in PROVING[">="]
            sooner = top is None or sign(top - end, fixed, ">=") in PROVING[">="]
            if sign(end - start, fixed, ">") not in PROVING[">"] or not (later or sooner):
                raise OpenError(f"the conditions must keep {x} in an interval after {start}")
            top = top if later else end
        elif sign(end - start, fixed, ">=") not in PROVING[">="]:
            raise OpenError(f"the conditions must keep {x} after {start}")
        else:
            bounded = True
    upper = () if top is None else ((x, "<=", top),)
    inside = fixed & Given(((x, ">=", start), *upper))
    return fixed, inside, start, top, not bounded


def small_is_bounded(link: tuple[Expr, str, Expr], small: str) -> bool:
    """Whether a condition on the small parameter alone excludes values near 0."""
    left, relation, right = link
    gap = right - left if relation[0] == "<" else left - right
    if relation not in ("<", "<=", ">", ">="):
        return True
    near = Given(((symbol(small), ">", ZERO), (symbol(small), "<", number(fmpq(1, 10**6)))))
    return sign(gap, near, ">") not in PROVING[">"]


def smooth_part(reader: Reader, e: Expr, inside: Given) -> Part:
    """Return a coefficient of an equation as a power of t times a factor that is smooth at 0.

    Raises:
        OpenError: it has another form.
    """
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


def power_of(small: str, order: int, q: int) -> str:
    """Return t to a power in words of the small parameter."""
    return str(said(symbol(small) ** number(fmpq(order, q)))) if order else "1"


def small_for(large: str) -> str:
    """Return the name of the small parameter that stands for 1 over a large one."""
    return f"[1/{large}]"


def said(e: Expr) -> Expr:
    """Return an expression in the parameter that was written, which may be a large one."""
    large = {n: 1 / symbol(n[3:-1]) for n in symbols(e) if n.startswith("[1/")}
    if not large:
        return tidied(e)
    (name,) = (n[3:-1] for n in large)
    terms = (substitute(term, large) for term in (e.args if e.op == "+" else (e,)))
    return tidied(add(*(readable(term, name, 1) for term in terms)))


def layer_parameters(layer: Layer, e: Expr) -> frozenset[str]:
    """Return the parameters beside the variable and the small one."""
    trees = [
        layer.a.factor,
        layer.b.factor,
        layer.f.factor,
        *(c.value for c in layer.conditions),
        layer.low,
    ]
    if layer.high is not None:
        trees.append(layer.high)
    return symbols(e).union(*map(symbols, trees)) - {layer.x, layer.t, layer.reader.small}


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
    for end, direction in ((0, -1), (1, 1)):
        if end and layer.high is None:
            continue
        point = layer.place(end)
        there = [substitute(f, {layer.x: point}) for _, f in key]
        at_end = all(is_zero(value, layer.fixed) for value in there)
        if at_end and known_sign(slope * direction, layer.closed) > 0:
            return end, scale
    if known_sign(leading, layer.closed) < 0:
        return None
    shown = " + ".join(f"({f})/{power_of(layer.reader.small, -k, layer.reader.q)}" for k, f in key)
    raise OpenError(f"exp({shown}) is not shown to vanish away from one end")
