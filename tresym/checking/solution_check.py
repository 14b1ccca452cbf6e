"""Check claims about solutions of differential equations by solving the equations numerically.

Example: before ``y(t) == exp(t) given diff(y(t), t) == y(t), y(0) == 1`` passes, the equation is
solved by Taylor steps from its initial value to points of this module's own choice, and both sides
are compared there. A refuted equation is contradicted if both sides agree to many digits at all of
these points.

The module shares the expression trees with the lemma in
:mod:`tresym.asymptotics.initial_values`, and nothing else: it finds the system in the equations by
itself, in numbers. It proves nothing: the solution is computed twice, with different orders and
tolerances, and 20 times the difference is taken for the error. Step sizes follow the last Taylor
coefficients, so that a step stays well inside the circle of convergence and none leads across a
pole. Source: À. Jorba and M. Zou, "A software package for the numerical integration of ODEs by
means of high-order Taylor methods", Experimental Mathematics 14 (2005) 99.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from contextlib import contextmanager
from typing import Any, NamedTuple

from flint import arb, arb_series, ctx, fmpq

from tresym.reals.cross_check import FALSE, conditions, said
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.path_regions import conditions_of
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.operation_domains import operations
from tresym.reals.language.comparisons import Comparison
from tresym.reals.language.expression import Expr, replaced, symbol, symbols, unknown
from tresym.reals.language.paths import Path
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, parse_number
from tresym.reals.verdict import Verdict

BITS = 200
RUNS = ((26, arb("1e-32")), (22, arb("1e-26")))
"""Order and tolerance of the two integrations, whose difference tells the error."""
STEPS = 240
"""The most steps of one integration."""
SECANTS, SLACK = 8, arb("1e-16")
"""Steps of the secant method for boundary values, and the error that is assumed of its result."""
SMALLEST = arb("1e-6")
"""The step below which a singularity is near."""
LEAST = arb("1e-22")
"""The least error that is assumed."""
TIMES = tuple(
    fmpq(*x) for x in ((1, 3), (-2, 7), (11, 10), (2, 5), (9, 10), (29, 10), (-1, 8), (-13, 10))
)
"""Where claims are looked at, as distances from the initial point."""
LATE = (fmpq(6), fmpq(12), fmpq(25))
FAR = (fmpq(10), fmpq(20), fmpq(40))
"""Where claims as t -> oo are looked at."""
SMALL = (fmpq(1, 16), fmpq(1, 128), fmpq(1, 1024))
"""Values of a small parameter."""
LONG = (fmpq(1, 10), fmpq(1, 20), fmpq(1, 40))
"""Values of a small parameter e for claims on intervals of the length of 1/e."""
STIFF = (fmpq(1, 4), fmpq(1, 16), fmpq(1, 64))
"""Values of a small parameter at the highest derivative of an equation that is not linear."""
SECULAR = (fmpq(1, 6), fmpq(1, 12), fmpq(1, 24))
"""Values of a small parameter e at which times of the order of 1/e are looked at."""
PARAMETERS = (fmpq(3, 2), fmpq(2, 3), fmpq(-5, 4), fmpq(1, 5), fmpq(7, 2))
CHOICES = 3
AGREED = arb("1e-15")
GROWS = 3
"""Between values of the small parameter the ratio of a false order grows by a power of 8."""

Numbers = dict[str, arb]


class _UnsupportedError(Exception):
    """The problem cannot be solved here, so that nothing is contradicted."""


class _System(NamedTuple):
    """Equations in numbers: gap = 0 is linear in its highest derivative.

    Attributes:
        time: the independent variable.
        state: the functions and their derivatives below the highest, as function and order.
        gaps: for each function its equation, with symbols for its derivatives.
        start: the initial point.
        values: for each of the state the equation that gives its initial value; one is left out
            if ``end`` gives it.
        end: of a boundary value problem, the other point, the variable and the equation there.
    """

    time: str
    state: tuple[tuple[str, int], ...]
    gaps: dict[str, Expr]
    start: Expr
    values: dict[tuple[str, int], Expr]
    end: tuple[Expr, tuple[str, int], Expr] | None = None


def contradiction(claim: Comparison, statement: Statement, answer: Answer) -> str | None:
    """Return where the solution in balls contradicts the answer to a claim, in words, or None.

    Args:
        claim: a comparison about solutions of the equations of the statement.
        statement: the equations, initial values and conditions.
        answer: the verdict that is checked, a pass or a refutation.
    """
    try:
        with ball_precision(BITS), _taylor():
            system = _system(statement)
            if statement.path is None:
                return _at_points(claim, statement, system, answer)
            if statement.path.name == system.time and statement.path.point is not None:
                return _near(claim, statement, system, statement.path, answer)
            if statement.path.name == system.time:
                return _far_out(claim, statement, system, answer)
            return _small_parameter(claim, statement, system, statement.path, answer)
    except (_UnsupportedError, InputError, ZeroDivisionError):
        return None


# The system


def _system(statement: Statement) -> _System:
    gaps = [left - right for left, right in statement.equations]
    nodes = {node for gap in gaps for node in functions(gap)}
    slopes = [node for node in nodes if any(node.args[0].args[1])]
    times = {n.args[1].args[0] for n in slopes if len(n.args) == 2 and n.args[1].op == "symbol"}
    if len(times) != 1 or any(len(node.args) != 2 for node in nodes):
        raise _UnsupportedError
    (time,) = times
    moving = {node for node in nodes if node.args[1] == symbol(time)}
    highest: dict[str, int] = {}
    for node in moving:
        name, (order,) = node.args[0].args
        highest[name] = max(order, highest.get(name, 0))
    equations: dict[str, Expr] = {}
    given: dict[Expr, dict[tuple[str, int], Expr]] = {}
    for gap in gaps:
        inside = set(functions(gap))
        if inside & moving:
            tops = [n for n, k in highest.items() if unknown(n, (symbol(time),), (k,)) in inside]
            if len(tops) != 1 or tops[0] in equations or inside - moving:
                raise _UnsupportedError
            equations[tops[0]] = replaced(gap, {x: _mark(*_key(x)) for x in inside})
        elif len(inside) == 1:
            (node,) = inside
            here = given.setdefault(node.args[1], {})
            if _key(node) in here:
                raise _UnsupportedError
            here[_key(node)] = replaced(gap, {node: symbol("[V]")})
    state = tuple((n, k) for n, order in sorted(highest.items()) for k in range(order))
    if any(node.op in ("abs", "sign", "cbrt") for node in operations(equations.values())):
        raise _UnsupportedError  # a step may lead across a corner
    if set(equations) != set(highest):
        raise _UnsupportedError
    points = sorted(given, key=lambda point: -len(given[point]))
    if len(points) == 1 and set(given[points[0]]) == set(state):
        return _System(time, state, equations, points[0], given[points[0]])
    if len(points) != 2 or len(given[points[1]]) != 1 or len(given[points[0]]) != len(state) - 1:
        raise _UnsupportedError
    ((key, last),) = given[points[1]].items()
    if key not in state or not set(given[points[0]]) < set(state):
        raise _UnsupportedError
    return _System(time, state, equations, points[0], given[points[0]], (points[1], key, last))


def _key(node: Expr) -> tuple[str, int]:
    name, (order,) = node.args[0].args
    return name, order


def _mark(name: str, order: int) -> Expr:
    return symbol(f"[{name}|{order}]")


def _linear_root(e: Expr, name: str, at: Mapping[str, Any]) -> Any:
    """Return the root of an expression that is linear in a symbol, as a ball or a series."""
    mark = symbol(name)
    if e.op == "+" and mark in e.args and sum(name in symbols(arg) for arg in e.args) == 1:
        return -_value(e, {**at, name: arb_series([0])})
    low, high = (_value(e, {**at, name: arb_series([n])}) for n in (0, 1))
    slope = high - low
    if ctx.cap == 1:
        twice = _value(e, {**at, name: arb_series([2])})
        if not (twice - high - slope)[0].contains(0) or slope[0].contains(0):
            raise _UnsupportedError
    return -low / slope


# Expressions in truncated power series


@contextmanager
def _taylor() -> Iterator[None]:
    """Restore the length of power series, which FLINT keeps for the whole program."""
    before = ctx.cap
    try:
        yield
    finally:
        ctx.cap = before


_SERIES: dict[str, Any] = {
    "exp": lambda x: x.exp(),
    "log": lambda x: x.log(),
    "sin": lambda x: x.sin(),
    "cos": lambda x: x.cos(),
    "tan": lambda x: x.tan(),
    "cot": lambda x: 1 / x.tan(),
    "sec": lambda x: 1 / x.cos(),
    "csc": lambda x: 1 / x.sin(),
    "atan": lambda x: x.atan(),
    "asin": lambda x: x.asin(),
    "acos": lambda x: x.acos(),
    "sinh": lambda x: (x.exp() - (-x).exp()) / 2,
    "cosh": lambda x: (x.exp() + (-x).exp()) / 2,
    "tanh": lambda x: 1 - 2 / ((2 * x).exp() + 1),
    "coth": lambda x: 1 + 2 / ((2 * x).exp() - 1),
    "sech": lambda x: 2 / (x.exp() + (-x).exp()),
    "csch": lambda x: 2 / (x.exp() - (-x).exp()),
    "asinh": lambda x: (x + (x * x + 1).sqrt()).log(),
    "acosh": lambda x: (x + (x - 1).sqrt() * (x + 1).sqrt()).log(),
    "atanh": lambda x: ((1 + x) / (1 - x)).log() / 2,
    "erf": lambda x: x.erf(),
    "lambertw": lambda x: x.lambertw(),
}


def _value(e: Expr, at: Mapping[str, Any], known: dict[Expr, Any] | None = None) -> Any:
    """Return an expression as a power series, at series for its symbols."""
    known = {} if known is None else known
    if e in known:
        return known[e]
    op, args = e.op, e.args
    if op == "symbol":
        if args[0] not in at:
            raise _UnsupportedError
        found = at[args[0]]
    elif op == "number":
        found = arb_series([arb(args[0])])
    elif op == "pi":
        found = arb_series([arb.pi()])
    elif op in ("+", "*"):
        found = _value(args[0], at, known)
        for arg in args[1:]:
            other = _value(arg, at, known)
            found = found + other if op == "+" else found * other
    elif op == "^":
        found = _power(_value(args[0], at, known), args[1], at, known)
    elif op == "abs":
        found = _value(args[0], at, known)
        if found[0].contains(0):
            raise _UnsupportedError
        found = found if found[0] > 0 else -found
    elif op in _SERIES and len(args) == 1:
        found = _SERIES[op](_value(args[0], at, known))
    else:
        raise _UnsupportedError
    known[e] = found
    return found


def _constants(values: Numbers) -> dict[str, Any]:
    """Return constants as series; their length is that of all series at the moment."""
    return {name: arb_series([x]) for name, x in values.items()}


def _power(base: Any, exponent: Expr, at: Mapping[str, Any], known: dict[Expr, Any]) -> Any:
    if exponent.op == "number" and exponent.args[0].q == 1 and abs(exponent.args[0].p) <= 60:
        n = int(exponent.args[0].p)
        found = arb_series([1])
        for _ in range(abs(n)):
            found = found * base
        return found if n >= 0 else 1 / found
    if not base[0] > 0:
        raise _UnsupportedError
    if exponent.op == "number" and exponent.args[0] == fmpq(1, 2):
        return base.sqrt()
    return (_value(exponent, at, known) * base.log()).exp()


# Taylor steps


class _Solver:
    """Solve a system by Taylor steps, twice, so that the difference tells the error."""

    def __init__(self, system: _System, parameters: Numbers) -> None:
        self.system = system
        self.parameters = parameters
        ctx.cap = 1
        at = _constants(parameters)
        self.start = _value(system.start, at)[0]
        self.order = {n: sum(key[0] == n for key in system.state) for n, _ in system.state}
        self.begin = [
            _linear_root(system.values[key], "[V]", at)[0] if key in system.values else arb(0)
            for key in system.state
        ]
        self.knots: dict[tuple[int, int], list[tuple[arb, list[arb]]]] = {}
        if not all(x.is_finite() for x in (*self.begin, self.start)):
            raise _UnsupportedError
        self.slack = arb(0)
        if system.end is not None:
            self._shoot(*system.end)
            self.slack, self.knots = SLACK, {}

    def _shoot(self, point: Expr, key: tuple[str, int], equation: Expr) -> None:
        """Find the initial value that is not given by the secant method from the boundary value."""
        (k,) = (n for n, key in enumerate(self.system.state) if key not in self.system.values)
        at = _constants(self.parameters)
        end, wanted = _value(point, at)[0], _linear_root(equation, "[V]", at)[0]

        def missed(x: arb) -> arb:
            self.knots = {}
            self.begin[k] = arb(x.mid())
            state = self.at(end)
            if state is None:
                raise _UnsupportedError
            return arb((state[self.system.state.index(key)] - wanted).mid())

        x, y = arb(0), arb(1)
        gap, other = missed(x), missed(y)
        for _ in range(SECANTS):
            if abs(other) < LEAST:
                return
            slope = (other - gap) / (y - x)
            if not abs(slope) > arb("1e-12"):
                raise _UnsupportedError  # the boundary values may determine no solution
            x, gap, y = y, other, arb((y - other / slope).mid())
            other = missed(y)
        if not abs(other) < 100 * LEAST * (1 + abs(wanted)):
            raise _UnsupportedError

    def slopes(self, time: Any, state: Sequence[Any], sign: int) -> list[Any]:
        """Return the derivatives of the state, as series."""
        at = _constants(self.parameters) | {self.system.time: time}
        places = dict(zip(self.system.state, state, strict=True))
        at |= {str(_mark(*key).args[0]): x for key, x in places.items()}
        tops = {
            name: _linear_root(gap, str(_mark(name, self.order[name]).args[0]), at)
            for name, gap in self.system.gaps.items()
        }
        return [
            sign * (places[name, k + 1] if (name, k + 1) in places else tops[name])
            for name, k in self.system.state
        ]

    def coefficients(self, time: arb, state: Sequence[arb], sign: int, n: int) -> list[list[arb]]:
        """Return the Taylor coefficients of order up to n of the solution through a point."""
        found = [[x] for x in state]
        for k in range(n):
            ctx.cap = k + 1
            t = arb_series([time, sign] if k else [time])
            slopes = self.slopes(t, [arb_series(x) for x in found], sign)
            for row, slope in zip(found, slopes, strict=True):
                row.append(arb((slope[k] / (k + 1)).mid()))
        return found

    def at(self, target: arb) -> list[arb] | None:
        """Return the state at a point, as balls around two results; None if it is not reached."""
        gap = target - self.start
        if gap.contains(0):
            return [x + arb(0, self.slack) for x in self.begin] if gap.is_zero() else None
        runs = [self._run(target, n) for n in range(len(RUNS))]
        if any(run is None for run in runs):
            return None
        fine, coarse = (run for run in runs if run is not None)
        return [
            x + arb(0, 20 * abs(x - y).upper() + (LEAST + self.slack) * (1 + abs(x).upper()))
            for x, y in zip(fine, coarse, strict=True)
        ]

    def _run(self, target: arb, run: int) -> list[arb] | None:
        (order, tolerance), target = RUNS[run], arb(target.mid())
        sign = 1 if target > self.start else -1
        begin = arb(self.start.mid()), [arb(x.mid()) for x in self.begin]
        knots = self.knots.setdefault((run, sign), [begin])
        time, state = [knot for knot in knots if not sign * (knot[0] - target) > 0][-1]
        for _ in range(STEPS - len(knots)):
            try:
                rows = self.coefficients(time, state, sign, order)
            except (_UnsupportedError, ZeroDivisionError):
                return None
            if not all(c.is_finite() for row in rows for c in row):
                return None
            h = abs(target - time)
            for row in rows:
                size = 1 + abs(row[0])
                for n in (order - 1, order):
                    if not row[n].is_zero():
                        bound = (tolerance * size / abs(row[n])).root(n)
                        h = h if h < bound else arb(bound.mid())
            last = not h < abs(target - time)
            state = []
            for row in rows:
                value = arb(0)
                for c in reversed(row):
                    value = value * h + c
                state.append(arb(value.mid()))
            if last:
                return state
            time = arb((time + sign * h).mid())
            if sign * (time - knots[-1][0]) > 0:
                knots.append((time, state))
            if h < SMALLEST:
                return None
        return None


# Claims


class _Look:
    """Both sides of a claim at a time, for fixed values of the parameters."""

    def __init__(
        self, claim: Comparison, statement: Statement, system: _System, parameters: Numbers
    ) -> None:
        self.claim, self.system, self.parameters = claim, system, parameters
        self.solver = _Solver(system, parameters)
        sides = (claim.left, claim.right)
        self.nodes = sorted({node for e in sides for node in functions(e)}, key=str)
        if any(len(n.args) != 2 or n.args[1].hidden for n in self.nodes):
            raise _UnsupportedError
        self.trees = sides

    def sides(self, offsets: Sequence[fmpq | arb]) -> Iterator[tuple[arb, list[arb] | None]]:
        """Yield times of the initial point and on, with both sides there, if they are known."""
        times = [self.solver.start + arb(x) for x in offsets]
        moves = any(self.system.time in symbols(e) for e in self.trees) or any(
            self.system.time in symbols(node.args[1]) for node in self.nodes
        )
        for t in times if moves else times[:1]:
            yield t, self._sides(t)

    def _sides(self, t: arb) -> list[arb] | None:
        ctx.cap = 1
        here = _constants(self.parameters)
        here[self.system.time] = arb_series([t])
        places: dict[Expr, Expr] = {}
        values = dict(here)
        for k, node in enumerate(self.nodes):
            state = self.solver.at(_value(node.args[1], here)[0])
            if state is None:
                return None
            ctx.cap = 1
            name, order = _key(node)
            if (name, order) in self.system.state:
                x = state[self.system.state.index((name, order))]
            elif order == self.solver.order[name]:  # the highest derivative
                where = _value(node.args[1], here)
                slopes = self.solver.slopes(where, [arb_series([x]) for x in state], 1)
                x = slopes[self.system.state.index((name, order - 1))][0]
            else:
                return None
            places[node] = symbol(f"[N{k}]")
            values[f"[N{k}]"] = arb_series([x])
        try:
            found = [_value(replaced(e, places), values)[0] for e in self.trees]
        except (_UnsupportedError, ZeroDivisionError):
            return None
        return found if all(x.is_finite() for x in found) else None


def _choices(
    claim: Comparison, statement: Statement, system: _System, moving: Sequence[str] = ()
) -> Iterator[Numbers]:
    """Yield values of the parameters that satisfy the conditions without the time."""
    trees = [claim.left, claim.right, *statement.said]
    names = sorted(frozenset().union(*map(symbols, trees)) - {system.time, *moving, "oo"})
    links = [
        link
        for link in statement.given.comparisons
        if not (symbols(link[0]) | symbols(link[2])) & {system.time, *moving}
    ]
    if any(e.hidden for link in links for e in link[::2]) or statement.integers:
        raise _UnsupportedError
    holds = conditions(names, links, ())
    count = 0
    for k in range(len(PARAMETERS) * (3 if names else 0) or 1):
        point = [
            arb(PARAMETERS[(k + (k // 5 + 1) * j) % len(PARAMETERS)]) for j in range(len(names))
        ]
        if holds(point):
            yield dict(zip(names, point, strict=True))
            count += 1
            if count == CHOICES:
                return


def _allowed(statement: Statement, system: _System, at: Numbers, t: arb) -> bool:
    """Whether a time satisfies the conditions."""
    names = [*at, system.time]
    links = [x for x in statement.given.comparisons if system.time in symbols(x[0]) | symbols(x[2])]
    return bool(conditions(names, links, ())([*at.values(), t]))


def _at_points(
    claim: Comparison, statement: Statement, system: _System, answer: Answer
) -> str | None:
    agreed = compared = 0
    for at in _choices(claim, statement, system):
        look = _Look(claim, statement, system, at)
        for t, sides in look.sides((*TIMES, *LATE[:2])):
            if sides is None or not _allowed(statement, system, at, t):
                continue
            compared += 1
            if answer and FALSE[claim.relation](sides[0], sides[1]):
                return _shown(system.time, t, sides)
            gap = sides[0] - sides[1]
            agreed += bool(abs(gap) < AGREED * (1 + abs(sides[0])))
    refuted = answer.verdict is Verdict.REFUTED and claim.relation == "=="
    if refuted and compared >= 3 and agreed == compared:
        return "both sides agree wherever the equation was solved numerically"
    return None


def _shown(time: str, t: arb, sides: Sequence[arb]) -> str:
    return (
        f"the equation, solved numerically up to {time} = {said(t)}, gives {said(sides[0])} and "
        f"{said(sides[1])} for the two sides"
    )


def _far_out(
    claim: Comparison, statement: Statement, system: _System, answer: Answer
) -> str | None:
    """Whether the error of a limit or order settles at a value that is not 0, for large times."""
    path = statement.path
    if path is None or path.sides != (1,) or path.point is not None:
        return None
    names = frozenset().union(*map(symbols, (claim.left, claim.right, *statement.said)))
    if not answer and (answer.verdict is not Verdict.REFUTED or names - {system.time, "oo"}):
        return None
    for at in _choices(claim, statement, system):
        sizes = []
        for _, sides in _Look(claim, statement, system, at).sides(FAR):
            if sides is None:
                break
            left, right = sides
            if claim.relation == "->":
                sizes.append(left - right)
            elif claim.relation == "~":
                sizes.append(left / right - 1)
            elif claim.relation == "o":
                sizes.append(left / right)
            elif claim.relation == "O":
                sizes.append(abs(left / right))
        if len(sizes) != len(FAR) or not all(x.is_finite() for x in sizes):
            continue
        verdict = _of_sizes(claim.relation, sizes, bool(answer))
        if verdict:
            return verdict
    return None


def _near(
    claim: Comparison, statement: Statement, system: _System, path: Path, answer: Answer
) -> str | None:
    """Whether the error of a limit or order that passes does not vanish towards a point."""
    if not answer or path.point is None or claim.relation not in ("O", "o", "~", "->"):
        return None
    ctx.cap = 1
    end = _value(path.point, {})[0]
    for at in _choices(claim, statement, system):
        look = _Look(claim, statement, system, at)
        for side in path.sides:
            offsets = [end - look.solver.start + side * arb(e) for e in SMALL]
            sizes = []
            for _, sides in look.sides(offsets):
                if sides is None:
                    break
                left, right = sides
                if claim.relation == "->":
                    sizes.append(abs(left - right))
                else:
                    sizes.append(abs(left / right - (claim.relation == "~")))
            if len(sizes) != len(SMALL) or not all(x.is_finite() for x in sizes):
                continue
            first, second, third = sizes
            shown = f"{said(first)}, {said(second)} and {said(third)}"
            if claim.relation == "O":
                if third > GROWS * second and second > GROWS * first:
                    return f"numerically the ratio of the sides grows as {shown}"
            elif third > arb("1e-15") and 2 * third > second and 2 * second > first:
                return f"numerically the error does not vanish: {shown}"
    return None


def _of_sizes(relation: str, sizes: Sequence[arb], passed: bool) -> str | None:
    """Return what errors at three times, each the double of the last, say against a verdict."""
    first, second, third = sizes
    earlier, later = second - first, third - second
    small = (
        abs(third) < arb("1e-3") and 2 * abs(third) < abs(second) and 2 * abs(second) < abs(first)
    )
    if relation == "O":
        if passed and third > 50 * second and second > 5 * first and third > 1:
            return f"numerically the ratio of the sides grows to {said(third)}"
        if not passed and third < second + AGREED and second < first + AGREED:
            return "numerically the ratio of the sides stays bounded"
    elif not passed:
        return "numerically the error vanishes" if small else None
    elif abs(third) > arb("0.05") and 10 * abs(later) < abs(third):
        if abs(later) < abs(third) / 1000 or 5 * abs(later) < 3 * abs(earlier):
            return f"numerically the error settles near {said(third)}"
    elif third > 1 and 5 * third > 7 * second and 5 * second > 7 * first and first > 0:
        return f"numerically the error grows to {said(third)}"
    return None


def _small_parameter(
    claim: Comparison, statement: Statement, system: _System, path: Path, answer: Answer
) -> str | None:
    """Whether the ratio of error and comparison function grows, at fixed times."""
    linear = (
        len(system.gaps) == 1
        and len(system.state) <= 2
        and all(
            _is_linear(gap, [str(_mark(*key).args[0]) for key in system.state], path.name)
            for gap in system.gaps.values()
        )
    )
    if path.point is None and linear and claim.relation in ("O", "o", "->"):
        return _layer(claim, statement, system, path, answer)
    if path.point is None or symbols(path.point) or claim.relation not in ("O", "o", "->"):
        return None
    ctx.cap = 1
    end = _value(path.point, {})[0]
    if any(
        {path.name, system.time} <= symbols(link[0]) | symbols(link[2])
        for link in statement.given.comparisons
    ):
        return _slowly(claim, statement, system, path, answer)
    stiff = _is_singular(system, path, end)
    if stiff and linear:
        return _layer(claim, statement, system, path, answer)
    region = _region(answer)
    times = (fmpq(0), *TIMES[:4], *(() if stiff else LATE if region else LATE[:1]))
    bounded = tried = 0
    for at in _choices(claim, statement, system, (path.name,)):
        for side in path.sides:
            table: dict[int, list[arb]] = {}
            smalls = list(STIFF if stiff else SMALL)
            for e in smalls:
                here = at | {path.name: end + side * arb(e)}
                look = _Look(claim, statement, system, here)
                for k, (t, sides) in enumerate(look.sides(times)):
                    if sides is None or not _allowed(statement, system, at, t):
                        continue
                    left, right = sides
                    size = abs(left - right) if claim.relation == "->" else abs(left / right)
                    if size.is_finite():
                        table.setdefault(k, []).append(size)
                    if answer and _exceeds(answer, region, here | {system.time: t}, sides):
                        return _shown(system.time, t, sides)
            against: dict[fmpq, str] = {}
            for k, sizes in table.items():
                if len(sizes) != len(smalls):
                    continue
                first, second, third = sizes
                tried += 1
                if answer and times[k] <= LATE[0] and (said_so := _against(claim.relation, sizes)):
                    against[times[k]] = said_so
                elif claim.relation == "O":
                    bounded += bool(third < 2 * second + AGREED) and bool(
                        second < 2 * first + AGREED
                    )
                else:
                    bounded += bool(4 * third < second + AGREED) and bool(
                        4 * second < first + AGREED
                    )
            if against and stiff:
                return next(iter(against.values()))
            if against:
                least = fmpq(1, 2 ** (20 + 4 * int(max(map(abs, against)).ceil())))
                nearer = [at | {path.name: end + side * arb(least / 8**n)} for n in range(3)]
                for t in _going_on(claim, statement, system, nearer, [*against]):
                    return against[t]
    if answer and (statement.uniformly or answer.uniform) and claim.relation == "O":
        grown = _secular(claim, statement, system, path, end)
        if grown:
            return grown
    refuted = answer.verdict is Verdict.REFUTED and not statement.uniformly
    if refuted and tried >= 2 and bounded == tried:
        return "numerically the ratio of the sides stays bounded"
    return None


def _slowly(
    claim: Comparison, statement: Statement, system: _System, path: Path, answer: Answer
) -> str | None:
    """Whether an error grows on intervals that get longer as the parameter gets smaller."""
    import numpy as np

    from tresym.checking.layer_check import UnsupportedError, swung, value

    if system.end is not None or len(system.gaps) != 1 or path.sides != (1,):
        return None
    ((name, gap),) = system.gaps.items()
    marks = tuple(str(_mark(name, k).args[0]) for k in range(len(system.state) + 1))
    nodes = {node for e in (claim.left, claim.right) for node in functions(e)}
    if nodes != {unknown(name, (symbol(system.time),), (0,))}:
        return None
    trees = [replaced(e, dict.fromkeys(nodes, symbol("[N]"))) for e in (claim.left, claim.right)]
    for at in _choices(claim, statement, system, (path.name,)):
        sizes = []
        for small in LONG:
            ctx.cap = 1
            here = at | {path.name: arb(small)}
            series = _constants(here)
            if not _value(system.start, series)[0].is_zero():
                return None
            values = tuple(
                float(_linear_root(system.values[key], "[V]", series)[0]) for key in system.state
            )
            plain = {n: float(x) for n, x in here.items()}
            ends = [
                t / small
                for t in (fmpq(5), fmpq(3), fmpq(2), fmpq(1), fmpq(1, 2))
                if _allowed(statement, system, here, arb(t / small))
            ]
            if not ends:
                return None
            try:
                times, ys = swung(gap, marks, plain, system.time, values, float(ends[0]))
                ts = np.array(times)
                place = {**plain, system.time: ts, "[N]": np.array(ys)}
                left, right = (value(e, place) + 0 * ts for e in trees)
            except (UnsupportedError, ZeroDivisionError, OverflowError):
                return None
            error = abs(left - right) if claim.relation == "->" else abs(left / right)
            sizes.append(float(error.max()))
        first, second, third = sizes
        shown = f"{first:.6g}, {second:.6g} and {third:.6g}"
        if claim.relation == "O" and answer and third > 1.7 * second > 1.7**2 * first > 1e-2:
            return f"numerically the ratio of the sides grows as {shown}"
        if claim.relation == "O" and not answer and third < 1.1 * second < 1.1**2 * first:
            return f"numerically the ratio of the sides stays bounded: {shown}"
        if claim.relation != "O" and answer and third > 0.9 * second > 0.9**2 * first > 1e-6:
            return f"numerically the error does not vanish: {shown}"
    return None


def _is_singular(system: _System, path: Path, end: arb) -> bool:
    """Whether the equation has no solved form at the path's end."""
    if len(system.gaps) != 1 or len(system.state) > 2:
        return False
    ((name, gap),) = system.gaps.items()
    mark = str(_mark(name, len(system.state)).args[0])
    names = symbols(gap) - {mark}
    at = _constants({n: arb(fmpq(3, 7)) for n in names} | {path.name: end})
    try:
        low, high = (_value(gap, {**at, mark: arb_series([n])})[0] for n in (0, 1))
    except ZeroDivisionError:
        return True
    return not (high - low).is_finite() or bool((high - low).contains(0))


def _is_linear(gap: Expr, marks: Sequence[str], small: str) -> bool:
    """Whether an equation is linear in the function and its derivative, seen at a few points."""
    base = {n: arb(fmpq(3, 7)) for n in symbols(gap) - {*marks}} | {small: arb(fmpq(1, 3))}

    def value(*points: int) -> Any:
        return _value(gap, _constants(base | dict(zip(marks, map(arb, points), strict=True))))[0]

    zero, one, two = (value(*[k] * len(marks)) for k in (0, 1, 2))
    gaps = [two - 2 * one + zero]
    if len(marks) == 2:
        gaps += [value(2, 0) - 2 * value(1, 0) + zero, value(0, 2) - 2 * value(0, 1) + zero]
    return all(x.contains(0) for x in gaps)


def _layer(
    claim: Comparison, statement: Statement, system: _System, path: Path, answer: Answer
) -> str | None:
    """Whether the largest ratio of error and comparison function grows as a layer gets thinner."""
    import numpy as np

    from tresym.checking.layer_check import UnsupportedError, marched, solved, value

    if path.sides != (1,):
        return None
    ((name, gap),) = system.gaps.items()
    marks = [str(_mark(name, k).args[0]) for k in range(len(system.state) + 1)]
    nodes = {node for e in (claim.left, claim.right) for node in functions(e)}
    if nodes != {unknown(name, (symbol(system.time),), (0,))}:
        return None
    if system.end is not None and (system.end[1][1] or (name, 0) not in system.values):
        return None
    trees = [replaced(e, dict.fromkeys(nodes, symbol("[N]"))) for e in (claim.left, claim.right)]
    whole = statement.uniformly or answer.uniform is True
    for at in _choices(claim, statement, system, (path.name,)):
        sizes: list[tuple[float, float]] = []
        for small in SMALL:
            ctx.cap = 1
            parameter = arb(small) if path.point is not None else 1 / arb(small)
            here = at | {path.name: parameter}
            series = _constants(here)
            plain = {n: float(x) for n, x in here.items()}
            start = float(_value(system.start, series)[0])
            values = [
                float(_linear_root(system.values[key], "[V]", series)[0])
                for key in system.state
                if key in system.values
            ]
            try:
                if system.end is None:
                    xs, ys, errors = marched(
                        gap, (*marks,), plain, system.time, start, (*values,), float(small)
                    )
                else:
                    other = float(_value(system.end[0], series)[0])
                    last = float(_linear_root(system.end[2], "[V]", series)[0])
                    pairs = sorted([(start, values[0]), (other, last)])
                    xs, ys, errors = solved(
                        gap,
                        (marks[0], marks[1], marks[2]),
                        plain,
                        system.time,
                        (pairs[0][0], pairs[1][0]),
                        (pairs[0][1], pairs[1][1]),
                        float(small),
                    )
                place = {**plain, system.time: xs, "[N]": ys}
                left, right = (value(e, place) + 0 * xs for e in trees)
            except UnsupportedError:
                return None
            if claim.relation != "->" and not right.all():
                return None
            error = abs(left - right) if claim.relation == "->" else abs(left / right)
            slack = errors if claim.relation == "->" else errors / abs(right)
            length = xs[-1] - xs[0]
            chosen = (
                range(0, len(xs), 3)
                if whole
                else [
                    int(np.argmin(abs(xs - (xs[0] + k * length))))
                    for k in (0, 0.2, 0.45, 0.7, 0.9, 1)
                ]
            )
            kept = [k for k in chosen if _allowed(statement, system, here, arb(float(xs[k])))]
            if not kept or not np.isfinite(error[kept]).all():
                return None
            low = float((error[kept] - 2 * slack[kept]).max())
            sizes.append((low, float((error[kept] + 2 * slack[kept]).max())))
            region = _region(answer)
            if answer and region is not None and answer.constant is not None:
                inside = conditions([path.name], region, ())([parameter])
                most = parse_number(answer.constant.mid) + parse_number(answer.constant.rad)
                if inside and low > float(arb(most).upper()):
                    return f"numerically the ratio of the sides is {low:.6g}"
        (first_low, one), (low, two), (least, three) = sizes
        growing = least > GROWS * two and low > GROWS * one
        shown = f"{one:.6g}, {two:.6g} and {three:.6g}"
        if answer and claim.relation == "O" and growing:
            return f"numerically the ratio of the sides grows as {shown}"
        if not answer and claim.relation == "O" and 5 * three < 6 * low and 5 * two < 6 * first_low:
            return f"numerically the ratio of the sides stays bounded: {shown}"
        if answer and claim.relation != "O" and least > 1e-6 and 2 * least > two > 2 * one / 4:
            return f"numerically the error does not vanish: {shown}"
    return None


def _against(relation: str, sizes: Sequence[arb]) -> str | None:
    """Return what the ratio at three small values of the parameter says against an order."""
    first, second, third = sizes
    if relation == "O":
        shown = f"{said(first)}, {said(second)} and {said(third)}"
        grows = third > GROWS * second and second > GROWS * first
        return f"numerically the ratio of the sides grows as {shown}" if grows else None
    stays = third > arb("1e-15") and 2 * third > second and 2 * second > first
    return f"numerically the ratio of the sides does not vanish: {said(third)}" if stays else None


def _going_on(
    claim: Comparison,
    statement: Statement,
    system: _System,
    nearer: Sequence[Numbers],
    times: Sequence[fmpq],
) -> Iterator[fmpq]:
    """Yield the times at which much smaller values of a parameter speak against an order, too.

    What grows at the first values may do so because they are not yet small beside the others:
    1/(1 - a*e*exp(t)) is far from 1 + a*e*exp(t) at e = 1/128, t = 6.
    """
    sizes: dict[fmpq, list[arb]] = {t: [] for t in times}
    for here in nearer:
        found = _Look(claim, statement, system, here).sides(times)
        for t, sides in zip(times, (sides for _, sides in found), strict=False):
            if sides is not None:
                left, right = sides
                limit = claim.relation == "->"
                sizes[t].append(abs(left - right) if limit else abs(left / right))
    for t, row in sizes.items():
        if len(row) == len(nearer) and _against(claim.relation, row) is not None:
            yield t


def _secular(
    claim: Comparison, statement: Statement, system: _System, path: Path, end: arb
) -> str | None:
    """Return how the ratio of a uniform order grows at times of the order of 1/e, or None."""
    for at in _choices(claim, statement, system, (path.name,)):
        sizes = []
        for e in SECULAR:
            look = _Look(claim, statement, system, at | {path.name: end + path.sides[-1] * arb(e)})
            found = [
                abs(sides[0] / sides[1])
                for t, sides in look.sides([1 / e + x for x in (fmpq(0), fmpq(4, 5), fmpq(8, 5))])
                if sides is not None and _allowed(statement, system, at, t)
            ]
            if len(found) == 3 and all(x.is_finite() for x in found):
                sizes.append(found[0].max(found[1]).max(found[2]))
        grows = len(sizes) == len(SECULAR) and 10 * sizes[1] > 15 * sizes[0] > 0
        if grows and 10 * sizes[2] > 15 * sizes[1]:
            return f"numerically the ratio of the sides grows with time to {said(sizes[2])}"
    return None


def _region(answer: Answer) -> Any:
    if answer.constant is None or answer.region is None:
        return None
    return conditions_of(answer.region)


def _exceeds(answer: Answer, region: Any, here: Numbers, sides: Sequence[arb]) -> bool:
    """Whether the constant of an order is exceeded at a point of its region."""
    if (
        region is None
        or answer.constant is None
        or not conditions([*here], region, ())([*here.values()])
    ):
        return False
    high = parse_number(answer.constant.mid) + parse_number(answer.constant.rad)
    return bool(abs(sides[0]) > arb(high) * abs(sides[1]))
