"""Say whether an order with parameters holds with one constant for all of their values.

``x/(x + y) == O(x) given y > 0 as x -> 0+`` holds for each fixed y, but the constant 1/y is
unbounded: the order is not uniform. ``sin(a*x) == a*x + O(x**3) given 0 < a < 1 as x -> 0+`` is
uniform with the constant 1/6. A claim that says ``uniformly`` asks for one constant.

- *Uniform*: |left| ≤ C |right| is decided as an inequality for all values of the parameters on a
  range of the path's variable, with C from samples. If the parameters lie in a bounded closed box,
  Taylor's theorem in the path's variable is tried next: the coefficients of the left side below the
  order p of the right side vanish identically, and balls bound the p-th one over the box.
- *Not uniform*: the limit of the ratio, a function of the parameters, tends to infinity as one of
  them tends to an end of its range.

An order in several variables, ``sin(x + y) == x + y + O((abs(x) + abs(y))**3) as (x, y) -> (0,
0)``, means one constant for all points near the end. The point is written as r times a point of the
boundary of a cube, and the order must be uniform on each of its faces as r → 0+.
"""

from __future__ import annotations

import heapq
from collections.abc import Iterator, Mapping
from dataclasses import replace
from itertools import count

from flint import arb, arb_series, ctx, fmpq

from tresym.asymptotics.constants import rounded
from tresym.asymptotics.order_claims import region
from tresym.asymptotics.path_claims import neighbourhood
from tresym.reals.balls.taylor import InSeries
from tresym.reals.decisions.answer import Answer, Decide, constant_ball, exact_text, worst
from tresym.reals.decisions.path_regions import along
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.expansions.scale import T
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    fresh,
    multiply,
    number,
    power,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.formula import Compared
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import Path
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.interior import is_zero
from tresym.reals.verdict import Verdict

FAR = (1, 2, 10, 100)
"""Ranges of the path's variable: up to the reciprocals of these, or from them on."""
SAMPLES = 150
BLUNT = 1.2
"""A constant beyond this multiple of the largest ratio seen is tried on a shorter range."""
LARGEST = 10**6
HIGHEST = 8
"""The highest order of the right side for which Taylor's theorem is tried."""
PIECES = 250
PRECISION = 200
MARGIN = arb("1.1")
SHORTEST = fmpq(1, 2**12)
_INFINITE = (INFINITY, -INFINITY)


def with_uniformity(
    answer: Answer, claim: Comparison, statement: Statement, decided: Decide
) -> Answer:
    """Return an answer to an order with parameters that says whether it is uniform.

    Args:
        answer: the answer for each fixed value of the parameters.
        claim: the order.
        statement: its conditions and its path.
        decided: the procedure for inequalities at points.
    """
    path = statement.path
    if path is None or claim.relation != "O" or (not answer and not statement.uniformly):
        return answer
    if answer.verdict is Verdict.REFUTED:
        return answer
    names = sorted((symbols(claim.left) | symbols(claim.right)) - {path.name})
    if not names or claim.derivatives or statement.equations or statement.integers:
        return _asked(answer, statement)
    if answer.uniform:
        return answer
    shown = ", ".join(names)
    against = _unbounded(claim, statement, names)
    if against is not None:
        if statement.uniformly:
            why = f"it holds for each fixed {shown} at most, but not uniformly: {against}"
            return Answer(Verdict.REFUTED, why, witness={}, uniform=False)
        return replace(
            answer,
            why=f"{answer.why}; for each fixed {shown}, not uniformly: {against}",
            uniform=False,
        )
    found = _uniform(claim, statement, names, decided)
    if found is not None:
        return found
    if statement.uniformly:
        return Answer(Verdict.UNDECIDED, f"no constant was found that serves for all {shown}")
    return replace(answer, why=f"{answer.why}; for each fixed {shown}")


def _asked(answer: Answer, statement: Statement) -> Answer:
    if statement.uniformly and answer and answer.uniform is None:
        if statement.equations or statement.integers:
            return Answer(
                Verdict.UNDECIDED, "uniformity under equations or for integers is not supported"
            )
        return answer  # without parameters there is one constant
    return answer


def _unbounded(claim: Comparison, statement: Statement, names: list[str]) -> str | None:
    """Return in words why no constant serves for all values of the parameters, or None."""
    path, given = statement.path, statement.given
    assert path is not None
    ratio = claim.left / claim.right
    for side in path.sides:
        far = given & neighbourhood(path, side, number(10))
        for name in names:
            for point, direction in _ends(name, given):
                end = Path(name, point, (direction,))
                if limit_of(ratio, name, point, direction, far) in _INFINITE:
                    return f"left/right is unbounded as {end}, however near {path.name} is"
        for part in _signs(names, given):
            limit = limit_of(ratio, path.name, path.point, side, part)
            if limit is None or limit in _INFINITE or not symbols(limit):
                continue
            found = _unbounded_limit(limit, names, part)
            if found is not None:
                return found
    return None


def _signs(names: list[str], given: Given) -> Iterator[Given]:
    """Yield the conditions, and those with one parameter of one sign."""
    yield given
    for name in names:
        where = given.box.get(name)
        if where is None or ((where.low or -1) < 0 < (where.high or 1)):
            for relation in (">", "<"):
                yield given & Given(((symbol(name), relation, ZERO),))


def _unbounded_limit(limit: Expr, names: list[str], given: Given) -> str | None:
    for name in names:
        others = [n for n in names if n != name and n in symbols(limit)]
        for at in _points(others, name, given):
            there = substitute(limit, at)
            for point, direction in _ends(name, given):
                value = limit_of(there, name, point, direction, Given())
                if value in _INFINITE:
                    end = Path(name, point, (direction,))
                    fixed = "".join(f", {n} = {x}" for n, x in at.items())
                    return f"the limit {limit} of left/right is unbounded as {end}{fixed}"
    return None


def _points(others: list[str], name: str, given: Given) -> Iterator[dict[str, Expr]]:
    """Yield a few values of the other parameters, under the conditions on them alone."""
    if not others:
        yield {}
        return
    alone = Given(tuple(x for x in given.comparisons if name not in symbols(x[0]) | symbols(x[2])))
    if any(
        {name} < symbols(x[0]) | symbols(x[2]) for x in given.comparisons
    ):  # the range of the parameter depends on others
        return
    for at in alone.points(others, 2):
        yield {n: number(at[n]) for n in others}


def _ends(name: str, given: Given) -> Iterator[tuple[Expr | None, int]]:
    """Yield the ends of the range of a parameter, and 0 inside it, with directions."""
    where = given.box.get(name)
    low = None if where is None else where.low
    high = None if where is None else where.high
    exact = {
        side.args[0]
        for x in given.comparisons
        for side in (x[0], x[2])
        if side.op == "number" and symbols(x[0]) | symbols(x[2]) == {name}
    }
    if low is None:
        yield None, -1
    elif low in exact:
        yield number(low), 1
    if high is None:
        yield None, 1
    elif high in exact:
        yield number(high), -1
    if (low is None or low < 0) and (high is None or high > 0):
        yield ZERO, 1
        yield ZERO, -1


# One constant


def _uniform(
    claim: Comparison, statement: Statement, names: list[str], decided: Decide
) -> Answer | None:
    """Return the order with one constant on a range of the path's variable, or None."""
    path = statement.path
    assert path is not None
    reaches = [1 / path.reach] if path.reach is not None else list(map(fmpq, FAR))
    best: Answer | None = None
    for far in reaches:
        found, seen = [], 0.0
        for side in path.sides:
            sample = _sampled(claim, statement, side, far)
            bound = _by_taylor(claim, statement, side, far, names)
            searched = statement.uniformly or _is_algebraic(claim)
            if searched and (bound is None or (best is None and bound > arb(sample * BLUNT))):
                other = _by_inequality(claim, statement, side, far, sample, decided)
                bound = bound if other is None else other
            if bound is None:
                break
            seen = max(seen, sample)
            found.append(bound)
        if len(found) < len(path.sides):
            continue
        constant = _most(found)
        why = (
            f"|left| <= C |right| with C = {rounded(constant, 1)} for all values of "
            f"{', '.join(names)}"
        )
        answer = Answer(
            Verdict.ENCLOSED,
            why,
            constant=constant_ball(constant),
            region=region(path, 1 / far),
            uniform=True,
        )
        if constant <= arb(seen * BLUNT):
            return answer
        best = best or answer
    return best


def _is_algebraic(claim: Comparison) -> bool:
    """Return whether both sides are free of functions, so that their inequality is decided fast.

    For other claims the search for a constant takes far longer than the order itself, and is left
    out unless the claim asks for one constant.
    """
    return all(map(_without_functions, (claim.left, claim.right)))


def _without_functions(e: Expr) -> bool:
    if e.op in ("number", "symbol", "pi"):
        return True
    return e.op in ("+", "*", "^", "abs") and all(map(_without_functions, e.args))


def _sampled(claim: Comparison, statement: Statement, side: int, far: fmpq) -> float:
    """Return the largest ratio at sample points."""
    path = statement.path
    assert path is not None
    near = statement.given & neighbourhood(path, side, number(far))
    ratio = claim.left / claim.right
    largest = 0.0
    with ball_precision():
        for at in near.points(sorted(symbols(ratio) | {path.name}), SAMPLES):
            value = abs(evaluate(ratio, at))
            if value.is_finite():
                largest = max(largest, float(value.mid()))
    return largest


def _by_inequality(
    claim: Comparison,
    statement: Statement,
    side: int,
    far: fmpq,
    sample: float,
    decided: Decide,
) -> arb | None:
    """Return a constant for which the inequality is decided at all points of a range."""
    path = statement.path
    assert path is not None
    near = statement.given & neighbourhood(path, side, number(far))
    if not 0 < sample < LARGEST:
        return None
    for more in (1.02, 1.5):
        constant = fmpq(int(sample * more * 10**6) + 100, 10**6)
        left = apply("abs", claim.left)
        right = number(constant) * _size(claim.right, near)
        plain = replace(statement, path=None, given=near, uniformly=False)
        if decided(Comparison(left, "<=", right), plain):
            return arb(constant)
    return None


def _size(e: Expr, given: Given) -> Expr:
    """Return the absolute value of ``e``."""
    from tresym.reals.signs.sign import sign

    return e if sign(e, given, ">=") in ("+", ">=0") else apply("abs", e)


def _by_taylor(
    claim: Comparison, statement: Statement, side: int, far: fmpq, names: list[str]
) -> arb | None:
    """Return a constant by Taylor's theorem in the path's variable, for parameters in a box."""
    path, box = statement.path, statement.given.box
    assert path is not None
    ends = [box.get(name) for name in names]
    if any(where is None or where.low is None or where.high is None for where in ends):
        return None
    put = {path.name: along(path, side)}
    f, g = substitute(claim.left, put), substitute(claim.right, put)
    positive = statement.given & Given(((symbol(T), ">", ZERO),))
    found = _homogeneous(g, T)
    if found is not None and found[0].q == 1 and 0 <= found[0] <= HIGHEST:
        order, h = int(found[0].p), found[1]
    else:
        for order in range(HIGHEST + 1):
            h = normal_form(g * symbol(T) ** -order if order else g, positive)
            if T not in symbols(h):
                break
        else:
            return None
    e = f
    for _ in range(order):
        if not is_zero(substitute(e, {T: ZERO}), statement.given):
            return None
        e = differentiate(e, T)
    start = [(where.low, where.high) for where in ends if where is not None]
    start.append((fmpq(0), fmpq(1) / far))
    return _largest(f, h, order, [*names, T], tuple(start))


_Box = tuple[tuple[fmpq, fmpq], ...]


def _largest(f: Expr, h: Expr, order: int, names: list[str], start: _Box) -> arb | None:
    """Return a bound of the Taylor coefficient of an order over h, on a box of the variables."""

    def bound(box: _Box) -> arb:
        at = {n: arb(a).union(arb(b)) for n, (a, b) in zip(names, box, strict=True)}
        return abs(_coefficient(f, order, at) / evaluate(h, at))

    number_ = count()
    with ball_precision(PRECISION):
        heap: list[tuple[float, int, arb, _Box]] = []

        def add(box: _Box) -> None:
            value = bound(box)
            key = -float(value.upper()) if value.is_finite() else -1e300
            heapq.heappush(heap, (key, next(number_), value, box))

        add(start)
        low = arb(0)
        for _ in range(PIECES):
            _, _, value, box = heap[0]
            middle = bound(tuple(((a + b) / 2, (a + b) / 2) for a, b in box))
            if middle.is_finite():
                low = low.max(middle.lower())
            if value.is_finite() and value.upper() <= low * MARGIN:
                return arb(value.upper())
            heapq.heappop(heap)
            k = max(range(len(box)), key=lambda i: box[i][1] - box[i][0])
            a, b = box[k]
            if b - a < SHORTEST:
                return None
            add((*box[:k], (a, (a + b) / 2), *box[k + 1 :]))
            add((*box[:k], ((a + b) / 2, b), *box[k + 1 :]))
        return _most([value.upper() for _, _, value, _ in heap]) if heap[0][2].is_finite() else None


def _most(values: list[arb]) -> arb:
    return max(values, key=lambda x: float(x.mid()))


def _coefficient(f: Expr, order: int, at: Mapping[str, arb]) -> arb:
    """Return the Taylor coefficient in t over the values of all variables."""
    before = ctx.cap
    ctx.cap = order + 1
    try:
        known = {n: arb_series([v], ctx.cap) for n, v in at.items()}
        series = InSeries(None, known | {T: arb_series([at[T], 1], ctx.cap)}).value(f)
        return series[order] if series.prec > order else arb.nan()
    except (ValueError, ZeroDivisionError, AttributeError, TypeError, KeyError):
        return arb.nan()
    finally:
        ctx.cap = before


# Several variables


def decide_together(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide an order in several variables that tend to a point together.

    Args:
        claim: the order.
        statement: its path has the variables and the point.
        decided: the procedure for orders in one variable.
    """
    path = statement.path
    assert path is not None
    names, points = path.together, path.points
    if claim.relation not in ("O", "o", "->"):
        return Answer(Verdict.UNDECIDED, "in several variables only O, o and limits are supported")
    if (
        statement.equations
        or statement.integers
        or claim.derivatives
        or any(set(names) & (symbols(x[0]) | symbols(x[2])) for x in statement.given.comparisons)
    ):
        return Answer(
            Verdict.UNDECIDED,
            "in several variables conditions on them, equations and derivatives are not supported",
        )
    taken = symbols(claim.left) | symbols(claim.right) | {*names}
    r = fresh("r", taken)
    answers = []
    for k, name in enumerate(names):
        for side in (1, -1):
            shape = {n: fresh(f"{n}_", taken | {r}) for n in names if n != name}
            put = {name: points[k] + side * symbol(r)}
            links: list[Compared] = []
            for n, point in zip(names, points, strict=True):
                if n != name:
                    put[n] = point + symbol(r) * symbol(shape[n])
                    links += [
                        (symbol(shape[n]), ">=", MINUS_ONE),
                        (symbol(shape[n]), "<=", ONE),
                    ]
            face = claim.mapped(lambda e, put=put: substitute(e, put))  # type: ignore[misc]
            inside = replace(
                statement,
                path=Path(r, ZERO, (1,)),
                given=statement.given & Given(tuple(links)),
                uniformly=True,
            )
            found = _on_face(face, inside, decided)
            answers.append(found)
            if found.verdict is Verdict.REFUTED:
                where = ", ".join(f"{n} = {e}" for n, e in put.items())
                at = {n: parse(text) for n, text in (found.witness or {}).items()}
                there = {n: exact_text(substitute(e, at)) for n, e in put.items()}
                return replace(found, why=f"along {where}: {found.why}", witness=there)
            if not found:
                return found
    constants = [a.constant for a in answers if a.constant is not None]
    if len(constants) < len(answers):
        return replace(worst(answers), constant=None, region=None, uniform=True)
    largest = max(constants, key=lambda c: float(c.mid) + float(c.rad))
    reaches = [fmpq(*map(int, (a.region or "1").split()[-1].split("/"))) for a in answers]
    shown = " and ".join(
        f"|{n} - {p}|" if p != ZERO else f"|{n}|" for n, p in zip(names, points, strict=True)
    )
    least = min(reaches)
    return replace(
        worst(answers),
        constant=largest,
        region=f"{shown} at most {least}, not all 0",
        uniform=True,
    )


def _homogeneous(e: Expr, r: str) -> tuple[fmpq, Expr] | None:
    """Return k and a factor free of r with e = r^k times it for r > 0; None if that is not seen."""
    if r not in symbols(e):
        return fmpq(0), e
    if e.op == "symbol":
        return fmpq(1), ONE
    parts = [_homogeneous(arg, r) for arg in e.args]
    if None in parts:
        return None
    degrees = [part[0] for part in parts if part is not None]
    rests = [part[1] for part in parts if part is not None]
    if e.op == "*":
        return sum(degrees, fmpq(0)), multiply(*rests)
    if e.op == "abs":
        return degrees[0], ONE if rests[0] == ONE else apply("abs", rests[0])
    if e.op == "^" and e.args[1].op == "number":
        return degrees[0] * e.args[1].args[0], power(rests[0], e.args[1])
    if e.op == "+" and len({*map(str, degrees)}) == 1:
        return degrees[0], add(*rests)
    return None


def _on_face(claim: Comparison, statement: Statement, decided: Decide) -> Answer:
    """Decide an order on a face, o by O of a slightly larger order."""
    if claim.relation == "->":
        claim = Comparison(claim.left - claim.right, "o", ONE)
    if claim.relation == "O":
        return decided(claim, statement)
    path = statement.path
    assert path is not None
    fixed = decided(claim, replace(statement, uniformly=False))
    if fixed.verdict is Verdict.REFUTED:
        return fixed
    stronger = claim.right * symbol(path.name) ** number(fmpq(1, 2))
    for gauge in (claim.right * symbol(path.name), stronger):
        found = decided(Comparison(claim.left, "O", gauge), statement)
        if found:
            return replace(found, constant=None, region=None)
    return Answer(Verdict.UNDECIDED, f"it is not shown to hold in all directions: {found.why}")
