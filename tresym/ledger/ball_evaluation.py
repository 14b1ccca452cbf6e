"""Evaluate SymPy expressions as written in ball arithmetic, including integrals.

Used by the counterexample search. It shares no code with the expression trees and decision
procedures, so that an error there cannot hide a counterexample. Integrals are enclosed by
`acb.integral` (Arb's adaptive Gauss–Legendre integration); SymPy is only used to differentiate.
"""

from __future__ import annotations

import operator
from collections.abc import Callable, Iterable, Mapping
from functools import lru_cache
from typing import Any

from flint import acb, arb, ctx, fmpq
from sympy import (
    Add,
    Basic,
    Derivative,
    Integral,
    Mul,
    NumberSymbol,
    Pow,
    Rational,
    Subs,
    Symbol,
    exp,
)

from tresym.reals.language.expression import FUNCTIONS
from tresym.reals.numbers.arithmetic import side
from tresym.reals.resource_limits import held

Values = Mapping[Symbol, Any]
Program = Callable[["At"], Any]

EVALUATIONS = 120
"""Maximal number of evaluations of an integrand (the limit of `acb.integral`)."""
NODES = 1 << 15
"""Number of compiled expressions in the cache."""
NO_RULES: dict[Symbol, Basic] = {}


class At:
    """A point of evaluation with a cache: each subexpression is evaluated once per point.

    Attributes:
        values: real or complex balls by symbol.
        analytic: for integrands: whether to return NaN also where a part is not analytic.
        outer: the enclosing point, which has the values of all other symbols; or None.
        rules: the meanings of symbols without a value; used at the outermost point only.
    """

    __slots__ = ("analytic", "known", "outer", "rules", "values")

    def __init__(
        self,
        values: Values,
        analytic: bool = False,
        outer: At | None = None,
        rules: Mapping[Symbol, Basic] = NO_RULES,
    ) -> None:
        self.values, self.analytic, self.outer, self.rules = values, analytic, outer, rules
        self.known: dict[_Node, Any] = {}

    def of(self, name: Symbol) -> Any:
        """Return the value of a symbol, evaluating its rule if it has no value."""
        return self.values[name] if name in self.values else value(self.rules[name], self)


class _Node:
    """An expression compiled to a function of a point; integrands are called thousands of times."""

    __slots__ = ("compute", "names")

    def __init__(self, names: Iterable[Basic], compute: Program) -> None:
        self.names, self.compute = frozenset(names), compute

    def __call__(self, at: At) -> Any:
        outer = at.outer
        while outer is not None and self.names.isdisjoint(at.values):
            at, outer = outer, outer.outer
        found = at.known.get(self)
        if found is None:
            found = at.known[self] = self.compute(at)
        return found


def value(e: Basic, point: Values | At, analytic: bool = False) -> Any:
    """Return a ball that contains the value of ``e``; not finite if ``e`` may be undefined.

    Args:
        e: a SymPy expression.
        point: real or complex balls by symbol, or a point of evaluation.
        analytic: for integrands: return a non-finite ball also where ``e`` may not be analytic.

    Example:
        >>> from flint import arb
        >>> from sympy import Symbol, log
        >>> x = Symbol("x", real=True)
        >>> value(log(x), {x: arb(1)})
        0
    """
    return _node(e)(point if isinstance(point, At) else At(point, analytic))


@lru_cache(maxsize=NODES)
def _node(e: Basic) -> _Node:
    match e:
        case Symbol():
            return _Node((e,), lambda at: at.of(e))
        case Rational():
            exact = fmpq(int(e.p), int(e.q))
            return _Node((), lambda at: arb(exact))
        case NumberSymbol():
            constant = {"pi": arb.pi, "E": arb.const_e}[str(e)]
            return _Node((), lambda at: constant())
        case Add() | Mul():
            return _fold(operator.add if isinstance(e, Add) else operator.mul, e.args)
        case exp():
            argument = _node(e.args[0])
            return _Node(argument.names, lambda at: argument(at).exp())
        case Pow():
            return _power(_node(e.base), e.exp)
        case Derivative() if (done := differentiated(e)) != e:
            return _node(done)
        case Subs():
            return _substituted(e)
        case Integral() if len(e.limits) == 1 and len(e.limits[0]) == 3:
            return _integral(e)
        case _ if len(e.args) == 1 and (name := e.func.__name__) in (*FUNCTIONS, "Abs"):
            x = _node(e.args[0])
            return _Node(x.names, lambda at: _function(name, x(at), at.analytic))
        case _:
            return _Node((), lambda at: arb.nan())


def _fold(combine: Callable[[Any, Any], Any], arguments: tuple[Basic, ...]) -> _Node:
    parts = [_node(argument) for argument in arguments]
    names = frozenset().union(*(part.names for part in parts))
    first, *others = parts

    def compute(at: At) -> Any:
        found = first(at)
        for part in others:
            found = combine(found, part(at))
        return found

    return _Node(names, compute)


def _substituted(e: Subs) -> _Node:
    inner, points = _node(e.expr), [_node(p) for p in e.point]

    def compute(at: At) -> Any:
        values = [point(at) for point in points]
        return inner(At(dict(zip(e.variables, values, strict=True)), at.analytic, at))

    return _Node((inner.names - {*e.variables}).union(*(p.names for p in points)), compute)


def differentiated(e: Derivative) -> Basic:
    """Carry out a derivative by SymPy's rules, including Leibniz's rule for integrals."""
    found = e.expr
    for variable in e.variables:
        found = found.diff(variable)
    return found


def _power(base: _Node, exponent: Basic) -> _Node:
    if not isinstance(exponent, Rational):
        power = _node(exponent)
        return _Node(
            base.names | power.names, lambda at: _general_power(base(at), power(at), at.analytic)
        )
    p, q = int(exponent.p), int(exponent.q)
    return _Node(base.names, lambda at: _rational_power(base(at), p, q, at.analytic))


def _rational_power(base: Any, p: int, q: int, analytic: bool) -> Any:
    if q > 1:
        if isinstance(base, acb):
            return base.pow(acb(fmpq(p, q)), analytic)
        if not base >= 0:
            return arb.nan()
        base = base.root(q)
    return arb.nan() if p < 0 and base.contains(0) else base**p


def _general_power(base: Any, power: Any, analytic: bool) -> Any:
    if isinstance(base, acb) or isinstance(power, acb):
        return acb(base).pow(acb(power), analytic)
    return (base.log() * power).exp() if base > 0 else arb.nan()


def _function(name: str, x: Any, analytic: bool) -> Any:
    if name == "Abs":
        return abs(x) if isinstance(x, arb) else x.real_abs(analytic)
    if name == "sign":
        if isinstance(x, acb):
            return x.real_sgn(analytic)
        known = side(x)
        return arb(known) if known else arb.nan()
    if analytic and isinstance(x, acb) and name in ("log", "asin", "acos", "atanh", "acosh"):
        return x.log(analytic) if name == "log" else acb(arb.nan())
    return getattr(x, name)()


def _integral(e: Integral) -> _Node:
    """Compile a proper integral over one variable; the enclosure may be wide if it is difficult."""
    variable, *ends = e.limits[0]
    function, (first, last) = _node(e.function), map(_node, ends)

    def compute(at: At) -> arb:
        start, end = first(at), last(at)
        if not (start.is_finite() and end.is_finite()):
            return arb.nan()

        def integrand(z: acb, analytic: bool) -> acb:
            return acb(function(At({variable: z}, analytic, at)))

        tolerance = arb(2) ** -min(48, ctx.prec // 2 + 8)
        fine = {"rel_tol": tolerance, "abs_tol": tolerance, "eval_limit": EVALUATIONS}
        with held():
            found = acb.integral(integrand, acb(start), acb(end), **fine)
        return found.real if found.imag.contains(0) else arb.nan()

    return _Node((function.names - {variable}) | first.names | last.names, compute)
