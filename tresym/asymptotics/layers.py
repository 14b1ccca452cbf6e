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

from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.boundary_values import between, ends, is_linear, unique_by_sign
from tresym.asymptotics.composites import Composite
from tresym.asymptotics.constants import rounded
from tresym.asymptotics.differential_problem import OpenError, Problem, problem_of, residuals
from tresym.asymptotics.explicit_claims import curve_of_claim
from tresym.asymptotics.fast_oscillations import decide_oscillation
from tresym.asymptotics.layer_constants import error_constant
from tresym.asymptotics.layer_problems import (
    Layer,
    at_point,
    interval_of,
    kind_of,
    layer_of,
    layer_parameters,
    need_smooth_at_zero,
    power_of,
    read_curve,
    said,
    small_for,
)
from tresym.asymptotics.layer_sums import Layered, known_sign
from tresym.asymptotics.lemma import rounded_up
from tresym.asymptotics.order_claims import region
from tresym.asymptotics.readable_terms import readable
from tresym.reals.decisions.answer import Answer, Decide, constant_ball, exact_text
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
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
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.paths import Path
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
    if claim.relation not in ("O", "o", "->", "~"):
        return None
    try:
        return _decide(claim, statement, decided)
    except OpenError:
        found = _by_exact_equation(claim, statement, decided) or _as_oscillation(claim, statement)
        if found is None:
            raise
        return found


def _as_oscillation(claim: Comparison, statement: Statement) -> Answer | None:
    """Decide an order for an initial value problem with a fast oscillation."""
    path = statement.path
    if path is None or path.point not in (None, ZERO) or path.sides != (1,):
        return None
    if claim.relation == "~" or statement.uniformly:
        return None
    changed, small, put = _with_small(statement, path)
    claim = claim.mapped(put)
    problem = problem_of(changed)
    if not problem.is_initial or [n for _, n in sorted(problem.state)] != [0, 1]:
        return None
    plain = Given(
        tuple(c for c in changed.given.comparisons if symbols(c[0]) | symbols(c[2]) != {small})
    )
    fixed, inside, _, _, missing = interval_of(problem, plain)
    if missing:
        raise OpenError(f"say that {problem.time} >= {problem.start}")
    name, _ = min(problem.state)
    y = curve_of_claim(claim, problem)[problem.state[name, 0]]
    gauge = claim.right if claim.relation != "->" else ONE
    strict = claim.relation != "O"
    return decide_oscillation(y, gauge, strict, problem, small, inside, fixed)


def _with_small(statement: Statement, path: Path) -> tuple[Statement, str, Callable[[Expr], Expr]]:
    """Return the statement with a small positive parameter, and how a large one is replaced."""
    small, put = path.name, partial(substitute, mapping={})
    if path.point is None:
        small = small_for(path.name)
        put = partial(substitute, mapping={path.name: 1 / symbol(small)})
    changed = replace(statement.mapped(put), path=None)
    positive = changed.given & Given(((symbol(small), ">", ZERO),))
    return replace(changed, given=positive), small, put


def _by_exact_equation(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    """Decide an order for a function that satisfies the equation, by its errors at the ends.

    For y'' = f(x, y, y') with f increasing in y the difference of two solutions is largest at an
    end (maximum principle), whatever the layers are.
    """
    path = statement.path
    if path is None or path.point != ZERO or path.sides != (1,) or claim.relation == "~":
        return None
    small = symbol(path.name)
    near = Given(((small, ">", ZERO), (small, "<", number(fmpq(1, 1000)))))
    changed = replace(statement, path=None, given=_without(statement, path.name) & near)
    problem = problem_of(changed)
    if problem.is_initial or [n for _, n in sorted(problem.state)] != [0, 1]:
        return None
    fixed, closed = between(problem, changed.given)
    name, _ = min(problem.state)
    y = problem.state[name, 0]
    if closed is fixed or any(v.variable != y for v in problem.given) or not is_linear(problem):
        return None
    low, high = ends(problem, fixed)
    x = symbol(problem.time)
    inside = fixed & Given(((x, ">=", low), (x, "<=", high)))
    curve = curve_of_claim(claim, problem)
    smooth = all(continuous_on(e, inside, proof) is None for e in curve.values())
    left = residuals(problem, curve)
    if not smooth or not all(is_zero(e, inside) for e in left):
        return None
    if not unique_by_sign(problem, inside, decided):
        return None
    asked = claim.relation if claim.relation != "->" else "o"
    gauge = claim.right if claim.relation != "->" else ONE
    plain = Statement((), _without(changed, path.name), path, "")
    plain = replace(
        plain,
        given=Given(
            tuple(
                c
                for c in plain.given.comparisons
                if problem.time not in symbols(c[0]) | symbols(c[2])
            )
        ),
    )
    for value in problem.given:
        error = substitute(curve[y], {problem.time: value.point}) - value.value
        error = tidied(error)
        if error == ZERO:
            continue
        found = decided(Comparison(error, asked, gauge), plain)
        if not found:
            return None
    names = layer_names(problem, statement) - {problem.time, path.name, *problem.right}
    why = (
        f"{curve[y]} satisfies the equation, and its largest error is that at an end of the "
        "interval (maximum principle)"
    )
    return Answer(Verdict.PROVED, why, lemma=LEMMA, uniform=None if names else True)


def layer_names(problem: Problem, statement: Statement) -> frozenset[str]:
    """Return the variables of a problem and of its conditions."""
    trees = [*problem.right.values(), *(v.value for v in problem.given), *statement.said]
    trees += [e for c in statement.comparisons for e in (c.left, c.right)]
    return frozenset().union(*map(symbols, trees))


def _without(statement: Statement, name: str) -> Given:
    links = statement.given.comparisons
    return Given(tuple(c for c in links if name not in symbols(c[0]) | symbols(c[2])))


def _decide(claim: Comparison, statement: Statement, decided: Decide) -> Answer | None:
    read = _read(statement, [claim.left, claim.right])
    if read is None:
        return None
    found, problem, put = read
    statement, claim = replace(statement.mapped(put), path=statement.path), claim.mapped(put)
    nodes = {f for e in (claim.left, claim.right) for f in functions(e)}
    if nodes and all(problem.time not in symbols(node.args[1]) for node in nodes):
        return _at_points(claim, nodes, found, problem, statement, decided)
    name, _ = min(problem.state, key=lambda key: key[1])
    plain = replace(claim, relation="==") if claim.relation == "~" else claim
    e = curve_of_claim(plain, problem)[problem.state[name, 0]]
    if claim.relation == "~":
        return _equivalent(claim, e, found, problem, statement, decided)
    gauge = claim.right if claim.relation != "->" else ONE
    return _decided(claim, e, gauge, found, problem, statement, decided)


def _read(
    statement: Statement, more: list[Expr]
) -> tuple[Layer, Problem, Callable[[Expr], Expr]] | None:
    """Return the problem with a layer, and how its large parameter is replaced, if there is one."""
    path = statement.path
    if path is None or path.point not in (None, ZERO) or not statement.equations:
        return None
    changed, small, put = _with_small(statement, path)
    try:
        problem = problem_of(changed)
    except OpenError:
        return None
    if path.name == problem.time or [n for _, n in sorted(problem.state)] not in ([0], [0, 1]):
        return None
    nodes = [f for e in more for f in functions(e)]
    fixed = bool(nodes) and all(problem.time not in symbols(f.args[1]) for f in nodes)
    found = layer_of(problem, changed, small, [put(e) for e in more], fixed)
    if found is None:
        return None
    if path.sides != (1,):
        end = "oo" if path.point is None else "0+"
        raise OpenError(
            f"the side of a boundary layer depends on the sign of {path.name}: write "
            f"{path.name} -> {end}"
        )
    return found, problem, put


def _near(layer: Layer) -> Path:
    return Path(layer.reader.small, ZERO, (1,))


def _true(layer: Layer, order: int) -> Expr:
    """Return the composite expansion with an error O(tᵏ), uniform between the ends.

    Raises:
        OpenError: it is not found, or not shown.
    """
    true = composite(layer, order)
    try:
        check(layer, true, Needs(order, (True, True), (True, True)))
    except GapError as error:
        raise OpenError(f"{said(true)} is not shown to be the solution: {error}") from None
    return true


def _at_points(
    claim: Comparison,
    nodes: set[Expr],
    layer: Layer,
    problem: Problem,
    statement: Statement,
    decided: Decide,
) -> Answer:
    """Decide a claim about values such as y(1/2) by the composite expansion."""
    if claim.relation == "~":
        raise OpenError("for values at points, orders and limits are supported")
    gauge = claim.right if claim.relation != "->" else ONE
    order = max(1, gauge_order(layer, gauge) + (claim.relation != "O"))
    true = _true(layer, order)
    small = symbol(layer.reader.small)
    near = layer.fixed & Given(((small, ">", ZERO), (small, "<", number(fmpq(1, 10**6)))))
    known: dict[Expr, Expr] = {}
    marks = {node: symbol(f"[V{k}]") for k, node in enumerate(sorted(nodes, key=str))}
    left = replaced(claim.left, marks)
    for node, mark in marks.items():
        point = node.args[1]
        (derivatives,) = node.args[0].args[1]
        gaps = [point - layer.low, *([] if layer.high is None else [layer.high - point])]
        inside = all(sign(gap, near, ">=") in PROVING[">="] for gap in gaps)
        if derivatives or not inside or (layer.high is None and symbols(point)):
            raise OpenError(f"{node} is not shown to be a value between the ends")
        factor = tidied(differentiate(left, str(mark.args[0])))
        if factor.op != "number" or symbols(claim.right) & {problem.time}:
            raise OpenError(f"the claim must be linear in {node}")
        known[node] = tidied(substitute(true, {layer.x: point}))
    explicit = claim.mapped(partial(replaced, known=known))
    if functions_in(explicit):
        raise OpenError("the claim must be linear in values of the function")
    found = decided(explicit, Statement((), layer.fixed, _near(layer), ""))
    power = power_of(layer.reader.small, order, layer.reader.q)
    why = f"the solution is {said(true)} + O({power}): {found.why}"
    return replace(found, why=why, lemma=LEMMA, constant=None, region=None)


def functions_in(claim: Comparison) -> bool:
    """Whether a claim contains functions that are not explicit."""
    return any(True for e in (claim.left, claim.right) for _ in functions(e))


def _equivalent(
    claim: Comparison,
    e: Expr,
    layer: Layer,
    problem: Problem,
    statement: Statement,
    decided: Decide,
) -> Answer:
    """Decide y ~ Y for each fixed x: the error O(t) must be smaller than Y."""
    size = symbol(layer.reader.small) ** number(fmpq(1, layer.reader.q))
    closed, _ = _ends_of_conditions(problem, statement, layer)
    plain = Statement((), _free(statement, layer), _near(layer), "")
    try:
        check(layer, e, Needs(1, (False, False), closed))
    except GapError as error:
        for c in layer.conditions:
            at_end = tidied(substitute(e, {layer.x: layer.end(c.end)}))
            there = Statement((), layer.fixed, _near(layer), "")
            if c.order or not closed[c.end]:
                continue
            found = decided(Comparison(c.value, "~", at_end), there)
            if found.verdict is Verdict.REFUTED:
                why = f"the boundary value at {layer.end(c.end)} is {said(c.value)}: {found.why}"
                witness = {**dict(found.witness or {}), layer.x: exact_text(layer.end(c.end))}
                return Answer(Verdict.REFUTED, why, witness=witness, lemma=LEMMA)
        true = _true(layer, 1)
        for point in plain.given.points(sorted({layer.x, *layer_parameters(layer, e)}), 3):
            at = partial(substitute, mapping={n: number(x) for n, x in point.items()})
            there = Statement((), Given(), _near(layer), "")
            if not decided(Comparison(size, "o", at(true)), there):
                continue
            found = decided(Comparison(at(true), "~", at(e)), there)
            if found.verdict is Verdict.REFUTED:
                why = f"the solution is {said(true)} to leading order: {found.why}"
                return Answer(Verdict.REFUTED, why, witness=_texts(point), lemma=LEMMA)
        raise OpenError(f"it is not shown: {error}") from None
    if not decided(Comparison(size, "o", e), plain):
        raise OpenError(f"it is not shown that {said(e)} does not vanish")
    why = f"{said(e)} is the solution up to O({said(size)}), for each fixed {layer.x}"
    return Answer(Verdict.PROVED, why, lemma=LEMMA)


def _free(statement: Statement, layer: Layer) -> Given:
    """Return the conditions without those on the small parameter."""
    small = layer.reader.small
    links = statement.given.comparisons
    return Given(tuple(x for x in links if small not in symbols(x[0]) | symbols(x[2])))


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
    bounded = True
    try:
        order = gauge_order(layer, gauge, layer.closed)
    except OpenError:
        bounded = False  # for x near an end the comparison function may vanish
        order = gauge_order(layer, gauge, _free(statement, layer))
        if statement.uniformly:
            raise
    order += claim.relation != "O"
    if order > HIGHEST * layer.reader.q:
        most = power_of(layer.reader.small, HIGHEST, 1)
        raise OpenError(f"orders up to {most} are supported")
    closed, apart = _ends_of_conditions(problem, statement, layer)
    if statement.uniformly:
        closed = (not apart[0], not apart[1])  # by continuity
    uniform = Needs(order, (not apart[0], not apart[1]), closed)
    fixed = Needs(order, (False, False), closed)
    small = layer.reader.small
    shown = power_of(small, order, layer.reader.q)
    asked = (uniform,) if statement.uniformly else (uniform, fixed) if bounded else (fixed,)
    gap: GapError | None = None
    conditions = (symbols(end) for link in statement.given.comparisons for end in link[::2])
    own = {layer.x, layer.t, layer.reader.small}
    parameters = layer_parameters(layer, e).union(*conditions) - own
    for needs in asked:
        try:
            check(layer, e, needs)
        except GapError as error:
            gap = gap or error
            continue
        why = (
            f"{said(e)} satisfies the equation and the boundary values up to an error that the "
            f"maximum principle bounds by a multiple of {shown}, "
        )
        if (
            needs is uniform
            and not parameters
            and claim.relation == "O"
            and (layer.x not in symbols(gauge))
        ):
            known = _with_constant(claim, layer, e, gauge, order, statement)
            if known is not None:
                return known
        if needs is uniform and layer.high is None:
            if statement.uniformly:
                raise OpenError(f"it holds uniformly on every bounded interval of {layer.x}")
            return Answer(Verdict.PROVED, f"{why}for each fixed {layer.x}", lemma=LEMMA)
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


def layer_terms(statement: Statement, count: int) -> tuple[list[Expr], Expr] | None:
    """Return the composite expansion of a solution and the order of its error.

    Args:
        statement: the problem with its path and conditions.
        count: the number of orders.

    Returns:
        The terms and the comparison function; None if there is no boundary layer.

    Raises:
        OpenError: the expansion is not found.
    """
    read = _read(statement, [])
    if read is None:
        return None
    found = read[0]
    e = composite(found, count)
    power = said(symbol(found.reader.small) ** number(fmpq(count, found.reader.q)))
    terms = e.args if e.op == "+" else (e,)
    return [said(term) for term in terms], power


def _with_constant(
    claim: Comparison, layer: Layer, e: Expr, gauge: Expr, order: int, statement: Statement
) -> Answer | None:
    """Return the answer with a constant for all small values of the parameter, or None."""
    path = statement.path
    needs = Needs(order, (True, True), (True, True))
    try:
        check(layer, e, needs)
    except GapError:
        return None
    slopes = any(c.order for c in layer.conditions)
    if path is None or layer.reader.nearly_one or slopes or layer.high is None:
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
        (node,) = set(functions(claim.left))
        times = tidied(differentiate(replaced(claim.left, {node: symbol("[S]")}), "[S]"))
        size = abs(evaluate(times, {})) / abs(evaluate(factor, {}))
        constant = arb((best[0] * size).upper())
        shown = rounded(constant, 1)
        ball = constant_ball(arb(rounded_up(constant, 6)))
    why = (
        f"|left| <= C |right| with C = {shown} for all {layer.x} between {layer.low} and "
        f"{layer.high}: a positive function on which the equation is negative bounds the error"
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
    work = Composite(layer, order)
    for _ in range(order):
        work.step()
    total = work.total()
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
    asked = claim.relation if claim.relation != "->" else "o"

    def fails(error: Expr, point: Expr, there: dict[str, fmpq]) -> bool:
        put = {name: number(value) for name, value in there.items()}
        at = partial(substitute, mapping={**put, layer.x: substitute(point, put)})
        plain = Statement((), Given(), _near(layer), "")
        found = decided(Comparison(tidied(at(error)), asked, at(gauge)), plain)
        return found.verdict is Verdict.REFUTED

    names = sorted(layer_parameters(layer, e))
    places = list(layer.fixed.points(names, 3)) if names else [{}]
    for end, derivatives, value in layer.conditions:
        if not needs.at[end] or derivatives:
            continue
        point = layer.end(end)
        for there in places:
            if fails(e - value, point, there):
                why = (
                    f"the boundary value at {point} is {value}, not "
                    f"{said(tidied(substitute(e, {layer.x: point})))}"
                )
                witness = {layer.x: exact_text(point), **_texts(there)}
                return Answer(Verdict.REFUTED, why, witness=witness, lemma=LEMMA)
    true = _true(layer, needs.order)
    shown = power_of(layer.reader.small, needs.order, layer.reader.q)
    inside = _free(statement, layer)
    for there in places:
        for point in _points(layer, needs, inside, there):
            if fails(e - true, point, there):
                fixed = layer.reader.small not in symbols(point)
                witness = {layer.x: exact_text(point)} if fixed else {}
                why = (
                    f"{layer.x} = {said(point)}: the solution is {said(true)} + O({shown}), "
                    f"uniformly in {layer.x}, and this differs from {said(e)} by more"
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
    width = fmpq(layer.width, layer.reader.q)
    for s in (fmpq(1), fmpq(1, 3)):
        step = number(s) * symbol(layer.reader.small) ** number(width)
        for end in (0,) if layer.high is None else (0, 1):
            if needs.near[end]:
                yield layer.end(end) + (step if (end == 0) != layer.mirrored else -step)


def gauge_order(layer: Layer, gauge: Expr, given: Given | None = None) -> int:
    """Return the power of t that a comparison function is a multiple of.

    Args:
        layer: the problem.
        gauge: the comparison function.
        given: conditions under which its factor must have one sign, if it may depend on x.

    Raises:
        OpenError: it is no such multiple.
    """
    found = layer.reader.read(gauge)
    if set(found) == {()}:
        v, g = found[()]
        if v < 0:
            raise OpenError("an error that may grow without bound says nothing of a layer")
        moving = layer.x in symbols(g)
        where = given if moving else layer.fixed
        if where is not None and layer.t not in symbols(g) and known_sign(g, where):
            return v
    raise OpenError("the comparison function must be a power of the small parameter")


def _ends_of_conditions(
    problem: Problem, statement: Statement, layer: Layer
) -> tuple[tuple[bool, bool], tuple[bool, bool]]:
    """Return for each end whether the conditions contain it, and whether they keep away from it."""
    x = symbol(problem.time)
    contain, apart = [True, layer.high is not None], [False, layer.high is None]
    for left, relation, right in statement.given.comparisons:
        if x not in (left, right):
            continue
        end = right if left == x else left
        below = (relation[0] == "<") == (left == x)
        k = 1 if below else 0
        if below and layer.high is None:
            continue
        gap = layer.place(1) - end if below else end - layer.low
        if sign(gap, layer.fixed, ">") in PROVING[">"]:
            contain[k], apart[k] = False, True
        elif not relation.endswith("="):
            contain[k] = False
    if layer.mirrored:
        contain.reverse()
        apart.reverse()
    return (contain[0], contain[1]), (apart[0], apart[1])


def _derivative(layer: Layer, curve: Layered, order: int) -> Layered:
    return layer.reader.derivative(curve) if order else curve


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
    loose = layer.loose
    for end, derivatives, value in layer.conditions:
        if not needs.at[end] and loose[end] and not needs.near[end]:
            continue
        there = at_point(layer, _derivative(layer, curve, derivatives), layer.place(end))
        error = r.sum([there, r.read(-value)])
        for key, part in error.items():
            if key and r._is_flat(key):
                continue
            if key:
                raise OpenError("an exponential at an end of the interval is not small")
            for power, c in r.coefficients(part, k - (layer.width if derivatives else 0)):
                if not is_zero(c, layer.fixed):
                    size = power_of(r.small, power, r.q)
                    what = "slope" if derivatives else "value"
                    raise GapError(f"its {what} at {layer.end(end)} is wrong by ({c})*{size}")
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
        gain = layer.gain if place == 0 and scale == layer.n else 0
        point = layer.place(place)
        for power, c in r.coefficients(part, k - gain):
            d = 0
            while power + d * scale < k - gain:
                if not is_zero(substitute(c, {layer.x: point}), layer.fixed):
                    raise GapError("the residual of the equation in the layer is of lower order")
                c = differentiate(c, layer.x)
                d += 1
