"""Evaluate expressions in floating point at several points at once, to filter candidates.

Nothing is proved here: candidates that agree in floating point are decided exactly afterwards.
Values of subtrees are cached, so that a tree which differs from another one in a single place costs
only the path from that place to the root. Integrals are computed by double-exponential quadrature
(H. Takahasi and M. Mori, 1974), infinite sums by Levin's u-transform.
"""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from itertools import pairwise
from typing import NamedTuple

from flint import arb

from tresym.reals.functions.row import Function
from tresym.reals.functions.table import TABLE
from tresym.reals.language.binders import worked_out
from tresym.reals.language.calls import FACTORIAL, INFINITY
from tresym.reals.language.expression import Expr, opened, symbols
from tresym.reals.numbers.arithmetic import ball_precision

NAN = math.nan
Row = list[float]
MOST_TERMS = 400
FEWEST_TERMS = 8
LEVIN_TERMS = 22
STEP = 0.05
"""The step size of a quadrature."""
CUT = 1e-11
"""The relative error allowed by cutting off a ray."""
NEGLIGIBLE = 1e-9
"""An integrand may be undefined this near to an end, or beyond the inverse of this distance."""


class UnsupportedError(Exception):
    """Raised for a node that cannot be evaluated in floating point."""


class Points:
    """Several points, with the values of variables and of expressions.

    Example:
        >>> from tresym.reals.language.parsing import parse
        >>> Points({"x": [0.0, 4.0, -1.0]}).values(parse("sqrt(x)"))
        [0.0, 2.0, nan]
    """

    def __init__(self, at: Mapping[str, Sequence[float]], count: int = 0) -> None:
        """Create points.

        Args:
            at: the values of each variable, one for each point.
            count: the number of points if there is no variable.
        """
        self.at = {name: list(values) for name, values in at.items()}
        self.count = len(next(iter(self.at.values()))) if self.at else count or 1
        self._known: dict[Expr, Row] = {}

    def values(self, e: Expr) -> Row:
        """Return the value at each point; NaN where there is none.

        Raises:
            UnsupportedError: the expression contains a node without a floating-point value.
        """
        found = self._known.get(e)
        if found is None:
            found = self._known[e] = self._computed(e)
        return found

    def _computed(self, e: Expr) -> Row:
        op, args = e.op, e.args
        if op == "number":
            return [_quotient(int(args[0].p), int(args[0].q))] * self.count
        if op == "symbol":
            if args[0] not in self.at:
                raise UnsupportedError(args[0])
            return self.at[args[0]]
        if op == "pi":
            return [math.pi] * self.count
        if op in ("integral", "sum", "product"):
            return self._bound(e)
        if op in ("derivative", "at") and (found := worked_out(e)).op != op:
            return self.values(found)
        if op == "unknown":
            return self._unknown(e)
        if e.names:
            raise UnsupportedError(op)
        rows = [self.values(arg) for arg in args if isinstance(arg, Expr)]
        if op == "^" and args[1].op == "number":
            return _powers(rows[0], int(args[1].args[0].p), int(args[1].args[0].q))
        function = _OPERATIONS.get(op)
        if function is None:
            raise UnsupportedError(op)
        return [_applied(function, *values) for values in zip(*rows, strict=True)]

    def _unknown(self, e: Expr) -> Row:
        """Evaluate an arbitrary function as one fixed sine wave, whose derivatives are known."""
        (name, orders), rows = e.args[0].args, [self.values(arg) for arg in e.args[1:]]
        if name == FACTORIAL:
            return [_applied(lambda x: math.gamma(x + 1), x) for x in rows[0]]
        seed = sum((n + 1) * ord(c) for n, c in enumerate(name)) % 97 / 97
        slopes = [0.6 + 0.5 * seed + 0.3 * n for n in range(len(rows))]
        factor = math.prod(s**k for s, k in zip(slopes, orders, strict=True))
        turn = seed + sum(orders) * math.pi / 2
        return [
            factor * math.sin(turn + sum(s * x for s, x in zip(slopes, point, strict=True)))
            for point in zip(*rows, strict=True)
        ]

    def _bound(self, e: Expr) -> Row:
        """Evaluate integrals, sums and products, only once if no variable is free in them."""
        (name,), body = opened(e, self.at)
        lows, highs = (self._ends(arg) for arg in e.args[1:])
        free = symbols(e) & self.at.keys()
        result: Row = []
        for n, (low, high) in enumerate(zip(lows, highs, strict=True)):
            if n and not free:
                result.append(result[0])
                continue
            here = {other: self.at[other][n] for other in free}
            result.append(_VALUES[e.op](worked_out(body), name, low, high, here))
        return result

    def _ends(self, e: Expr) -> Row:
        ends = {INFINITY: math.inf, -INFINITY: -math.inf}
        return [ends[e]] * self.count if e in ends else self.values(e)


def _along(body: Expr, name: str, places: Row, here: Mapping[str, float]) -> Row:
    fixed = {other: [value] * len(places) for other, value in here.items()}
    return Points({**fixed, name: places}).values(body)


def _integral(body: Expr, name: str, low: float, high: float, here: Mapping[str, float]) -> float:
    if low == high:
        return 0.0
    if low > high:
        return -_integral(body, name, high, low, here)
    parts: tuple[tuple[float, float, bool], ...]
    if low == -math.inf and high < math.inf:
        middle = high - 1.0
        parts = ((middle, high, False), (-middle, math.inf, True))
    else:
        parts = ((low, high, False),)
    return sum(_quadrature(body, name, *part, here) for part in parts)


def _quadrature(
    body: Expr, name: str, low: float, high: float, mirrored: bool, here: Mapping[str, float]
) -> float:
    """Integrate over a finite range, a ray or the line; over −x if ``mirrored``."""
    ends = math.isfinite(low), math.isfinite(high)
    for substitution in _SUBSTITUTIONS.get(ends, ()):  # no end of a range may be undefined
        steps = range(round(substitution.first / STEP), round(substitution.last / STEP) + 1)
        nodes = [substitution.node(k * STEP, low, high) for k in steps]
        places = [-x if mirrored else x for x, _ in nodes]
        values = _along(body, name, places, here)
        parts = []
        for (x, slope), value in zip(nodes, values, strict=True):
            near = min(abs(x - low), abs(x - high)) < NEGLIGIBLE or abs(x) > 1 / NEGLIGIBLE
            parts.append(0.0 if near and not math.isfinite(value) else value * slope * STEP)
        fine, coarse = _total(parts), 2 * _total(parts[::2])
        cut_off = math.inf in (high, -low) and abs(parts[-1]) > CUT * max(1e-6, abs(fine))
        if not cut_off and abs(fine - coarse) <= 1e-6 * max(1e-6, abs(fine)):
            return fine
    return NAN


class _Substitution(NamedTuple):
    """A change of the variable of integration: its range, and a function of node and weight."""

    first: float
    last: float
    node: Callable[[float, float, float], tuple[float, float]]


def _between(t: float, low: float, high: float) -> tuple[float, float]:
    u, slope = math.pi / 2 * math.sinh(t), math.pi / 2 * math.cosh(t)
    x = low + (high - low) / (1 + math.exp(-2 * u))
    return x, (high - low) / 2 * slope / math.cosh(u) ** 2


def _decaying(t: float, low: float, high: float) -> tuple[float, float]:
    """Substitute for integrands that decay exponentially."""
    x = math.exp(t - math.exp(-t))
    return low + x, x * (1 + math.exp(-t))


def _beyond(t: float, low: float, high: float) -> tuple[float, float]:
    x = math.exp(math.pi / 2 * math.sinh(t))
    return low + x, x * math.pi / 2 * math.cosh(t)


def _everywhere(t: float, low: float, high: float) -> tuple[float, float]:
    u = math.pi / 2 * math.sinh(t)
    return math.sinh(u), math.cosh(u) * math.pi / 2 * math.cosh(t)


_SUBSTITUTIONS = {
    (True, True): [_Substitution(-3.1, 3.1, _between)],
    (True, False): [_Substitution(-6.0, 7.0, _decaying), _Substitution(-4.2, 4.2, _beyond)],
    (False, False): [_Substitution(-4.2, 4.2, _everywhere)],
}


def _sum(body: Expr, name: str, low: float, high: float, here: Mapping[str, float]) -> float:
    if high == math.inf and math.isfinite(low) and low == round(low):
        places = [low + k for k in range(LEVIN_TERMS)]
        return _levin(_along(body, name, places, here))
    terms = _terms(body, name, low, high, here)
    return NAN if terms is None else _total(terms)


def _product(body: Expr, name: str, low: float, high: float, here: Mapping[str, float]) -> float:
    terms = _terms(body, name, low, high, here) if high < math.inf else None
    return NAN if terms is None else math.prod(terms)


def _terms(body: Expr, name: str, low: float, high: float, here: Mapping[str, float]) -> Row | None:
    whole = math.isfinite(low) and math.isfinite(high) and {low % 1, high % 1} == {0.0}
    if not whole or not -1 <= high - low <= MOST_TERMS:
        return None
    places = [low + k for k in range(int(high - low) + 1)]
    return _along(body, name, places, here) if places else []


def _levin(terms: Row) -> float:
    """Return the sum of a series by Levin's u-transform of its first terms; NaN if it fails."""
    if not all(map(math.isfinite, terms)):
        return NAN
    ends = terms[-1] == 0
    terms = [term for term in terms if term != 0]  # the transform divides by each term
    if ends and len(terms) < FEWEST_TERMS:
        return _total(terms)
    found = [_transformed(terms, n) for n in range(len(terms) - 8, len(terms) - 2)]
    steps = [(abs(y - x), y) for x, y in pairwise(found)]
    gap, value = min(steps, default=(math.inf, NAN))
    return value if gap <= 1e-7 * max(1.0, abs(value)) else NAN


def _transformed(terms: Row, n: int) -> float:
    above = below = partial = 0.0
    for k in range(n + 1):
        partial += terms[k]
        weight = (-1) ** k * math.comb(n, k) * ((k + 1) / (n + 1)) ** (n - 2)
        weight /= terms[k]
        above, below = above + weight * partial, below + weight
    return above / below if below else NAN


_VALUES: dict[str, Callable[..., float]] = {
    "integral": _integral,
    "product": _product,
    "sum": _sum,
}


def _total(terms: Row) -> float:
    try:
        return math.fsum(terms)
    except (OverflowError, ValueError):  # of infinite terms
        return NAN


def _quotient(p: int, q: int) -> float:
    try:
        return p / q
    except OverflowError:
        return NAN


def _applied(function: Callable[..., float], *values: float) -> float:
    try:
        return function(*values)
    except (ValueError, ZeroDivisionError, OverflowError):
        return NAN


def _powers(row: Row, p: int, q: int) -> Row:
    """Return rational powers, which require x ≥ 0 unless the exponent is an integer."""
    if q == 1:
        return [_applied(math.pow, x, p) for x in row]
    return [_applied(math.pow, x, p / q) if x >= 0 else NAN for x in row]


def _power(x: float, y: float) -> float:
    return x**y if x > 0 or y == round(y) else NAN


def _by_ball(row: Function) -> Callable[..., float]:
    """Return a special function in double precision, by its ball."""

    def value(*args: float) -> float:
        if not all(map(math.isfinite, args)):
            return NAN
        with ball_precision(64):
            found = row.ball(*map(arb, args))
        return float(found.mid()) if found.is_finite() else NAN

    return value


_OPERATIONS: dict[str, Callable[..., float]] = {
    "+": lambda *terms: sum(terms),
    "*": lambda *factors: math.prod(factors),
    "^": _power,
    **{name: row.double or _by_ball(row) for name, row in TABLE.items()},
}
