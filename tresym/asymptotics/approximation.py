"""Carry expansions through an expression: from its integrals, sums and unknowns to the whole.

A value is an explicit main part A and an error g ≥ 0, meaning f = A + O(g) along the path, or
f = A + o(g). Sums add errors; products and powers multiply relative errors, which must tend to 0;
logarithm, exponential and the functions with a bounded derivative carry them on. Another function
is expanded to first order where its second derivative is bounded:
|f(A + δ) − f(A)| ≤ (|f′(A)| + C |δ|) |δ|.

Example: with n! = S(1 + O(1/n)), ``factorial(2*n)/factorial(n)**2`` is S(2n)/S(n)²·(1 + O(1/n)).
With y = x + O(1) as x → ∞, ``log(y)`` is log x + O(1/x).
"""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import NamedTuple

from flint import arb, fmpq

from tresym.asymptotics.lemma import End
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    add,
    apply,
    integer,
    multiply,
    number,
    power,
    rebuild,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs.sign import sign

LIPSCHITZ = frozenset(("sin", "cos", "atan", "tanh", "asinh", "abs"))
"""Functions with a derivative of at most 1."""
_ARGUMENT = "[u]"
_HALF = number(fmpq(1, 2))
_EXPONENTIALS: dict[str, Callable[[Expr], Expr]] = {
    "sinh": lambda u: (apply("exp", u) - apply("exp", -u)) / 2,
    "cosh": lambda u: (apply("exp", u) + apply("exp", -u)) / 2,
    "tanh": lambda u: 1 - 2 / (apply("exp", 2 * u) + 1),
    "coth": lambda u: 1 + 2 / (apply("exp", 2 * u) - 1),
    "sech": lambda u: 2 / (apply("exp", u) + apply("exp", -u)),
    "csch": lambda u: 2 / (apply("exp", u) - apply("exp", -u)),
}
"""Hyperbolic functions by exponentials, for arguments that tend to infinity."""
SMOOTH = frozenset(
    (
        *("sin", "cos", "tan", "cot", "sec", "csc", "asin", "acos", "atan"),
        *("sinh", "cosh", "tanh", "coth", "sech", "csch", "asinh", "acosh", "atanh"),
        *("erf", "erfc", "lambertw"),
    )
)
"""Functions that are analytic wherever a ball around a point has a finite second derivative."""
MOST_FACTORS = 8
"""Powers up to this one are products where their error is not small."""
NEAR = arb("0 +/- 1e-20")


class Approximation(NamedTuple):
    """f = ``main`` + O(``error``); the error is ``ZERO`` where main is f itself.

    Attributes:
        small: f is ``main`` + o(``error``).
    """

    main: Expr
    error: Expr
    small: bool = False


def approximated(e: Expr, known: Mapping[Expr, Approximation], end: End) -> Approximation | None:
    """Return an explicit approximation of ``e``, or None where its error may be too large.

    Args:
        known: approximations of the integrals, sums, factorials and unknowns in it.
    """
    unknowns = frozenset(str(node.args[0]) for node in known if node.op == "symbol")
    return _approximated(e, known, unknowns, end)


def _approximated(
    e: Expr, known: Mapping[Expr, Approximation], unknowns: frozenset[str], end: End
) -> Approximation | None:
    if e in known:
        return known[e]
    if e.op in LEAVES or (not e.hidden and unknowns.isdisjoint(symbols(e))):
        return Approximation(e, ZERO)
    if e.names or e.op == "unknown":
        return None
    parts = [_approximated(arg, known, unknowns, end) for arg in e.args]
    found = [part for part in parts if part is not None]
    if len(found) < len(parts):
        return None
    small = all(part.small for part in found if part.error != ZERO)
    if not small:  # an error o(g) is one of O(g)
        found = [part._replace(small=False) for part in found]
    whole = _composed(e, found, end)
    return None if whole is None else whole._replace(small=small and whole.error != ZERO)


def _composed(e: Expr, found: list[Approximation], end: End) -> Approximation | None:
    """Return a function of values that are known with an error."""
    if e.op == "+":
        errors = [part.error for part in found if part.error != ZERO]
        return Approximation(add(*(part.main for part in found)), add(ZERO, *errors))
    if e.op == "*":
        return _product(found, end)
    if all(part.error == ZERO for part in found):
        return Approximation(rebuild(e, tuple(part.main for part in found)), ZERO)
    first, second = found[0], found[-1]
    if e.op == "^":
        if second.error == ZERO and e.args[1].op == "number":
            return _power(first, second.main, end)
        if not _is_positive(first.main, end) or not _is_relatively_small(first, end):
            return None
        log = apply("log", first.main)
        error = size(log, end) * second.error
        if first.error != ZERO:
            error = error + (size(second.main, end) + second.error) * first.error / first.main
        whole = _exponential(Approximation(second.main * log, error), end)
        return None if whole is None else whole._replace(main=power(first.main, second.main))
    if e.op == "exp":
        return _exponential(first, end)
    if e.op == "log" and _is_relatively_small(first, end) and _is_positive(first.main, end):
        return Approximation(apply("log", first.main), first.error / size(first.main, end))
    if len(found) > 1:
        return None
    if e.op == "cbrt" and _is_relatively_small(first, end):
        main = apply("cbrt", first.main)
        return Approximation(main, size(main, end) * first.error / size(first.main, end))
    return _by_slope(e.op, first, end)


def _by_slope(name: str, part: Approximation, end: End) -> Approximation | None:
    """Return a function of one argument by bounds of its derivatives near the main part."""
    main, error = apply(name, part.main), part.error
    if name in ("atan", "asinh") and _is_relatively_small(part, end):
        # The derivative at A(1 + o(1)) is at most a constant times that at A.
        below = 1 + part.main**2
        return Approximation(main, error / (below if name == "atan" else power(below, _HALF)))
    start = end.limit(part.main)
    if name in SMOOTH and _tends_to_zero(error, part.small, end):
        slope = differentiate(apply(name, symbol(_ARGUMENT)), _ARGUMENT)
        if name in ("sin", "cos") or _is_regular(differentiate(slope, _ARGUMENT), start):
            at_main = substitute(slope, {_ARGUMENT: part.main})
            return Approximation(main, (size(at_main, end) + error) * error)
    if name in LIPSCHITZ and name != "tanh":
        return Approximation(main, error)
    far = start in (INFINITY, -INFINITY)
    if name in _EXPONENTIALS and far:
        u = symbol(_ARGUMENT)
        whole = _approximated(_EXPONENTIALS[name](u), {u: part}, frozenset((_ARGUMENT,)), end)
        return None if whole is None else whole._replace(main=main)
    return Approximation(main, error) if name in LIPSCHITZ else None


def _is_regular(e: Expr, start: Expr | None) -> bool:
    """Return whether a function of one argument is finite in a ball around a number."""
    if start is None or start in (INFINITY, -INFINITY) or symbols(start):
        return False
    with ball_precision():
        around = evaluate(start, {}) + NEAR
        return bool(evaluate(e, {_ARGUMENT: around}).is_finite())


def size(e: Expr, end: End) -> Expr:
    """Return |e|, without the bars where ``e`` is shown to be positive near the end."""
    return e if _is_positive(e, end) else abs(e)


def _product(parts: list[Approximation], end: End) -> Approximation:
    main = multiply(*(part.main for part in parts))
    sizes = [size(part.main, end) for part in parts]
    for n, part in enumerate(parts):
        if not _is_relatively_small(part, end):
            sizes[n] = sizes[n] + part.error
    errors = [
        multiply(part.error, *(other for m, other in enumerate(sizes) if m != n))
        for n, part in enumerate(parts)
        if part.error != ZERO
    ]
    return Approximation(main, add(ZERO, *errors))


def _power(part: Approximation, exponent: Expr, end: End) -> Approximation | None:
    n = integer(exponent)
    if not _is_relatively_small(part, end):
        return _product([part] * n, end) if n is not None and 1 < n <= MOST_FACTORS else None
    if n is None and not _is_positive(part.main, end):
        return None
    main = power(part.main, exponent)
    return Approximation(main, size(main, end) * part.error / size(part.main, end))


def _exponential(part: Approximation, end: End) -> Approximation | None:
    if end.limit(part.error) in (None, INFINITY, -INFINITY):
        return None
    main = apply("exp", part.main)
    return Approximation(main, main * part.error)


def _is_relatively_small(part: Approximation, end: End) -> bool:
    return part.error == ZERO or _tends_to_zero(part.error / part.main, part.small, end)


def _tends_to_zero(e: Expr, small: bool, end: End) -> bool:
    """Return whether O(e), or o(e) where ``small``, tends to 0."""
    last = end.limit(e)
    return last == ZERO or (small and last not in (None, INFINITY, -INFINITY))


def _is_positive(e: Expr, end: End) -> bool:
    x, side = symbol(end.name), end.side
    near = (side * x, ">", ONE) if end.point is None else (side * x, ">", side * end.point)
    if sign(e, end.given & Given((near,))) == "+":
        return True
    last = end.limit(e)
    if last is None or last == -INFINITY:
        return False
    return last == INFINITY or sign(last, end.given) == "+"
