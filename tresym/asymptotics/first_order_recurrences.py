"""Solve linear recurrences of first order a(j + 1) = c(j) a(j) + g(j) with a rational function c.

Example: ``T(n) == n*T(n-1)`` with T(0) = 1 is n!, and ``T(n) == T(n-1) + 1/n`` is a sum.

From a(m) on, a(j) = P(j) (a(m) + Σ g(k)/P(k + 1)) with k = m, …, j − 1, where P(j) is the product
of c(m), …, c(j − 1). For c(j) = λ Π (j − rᵢ)/Π (j − sᵢ) with rational rᵢ, sᵢ < m this is a power of
λ times quotients Γ(j − r)/Γ(m − r), which are factorials for integers r, and rational functions
where some rᵢ − sᵢ is an integer.
"""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice
from math import factorial
from typing import NamedTuple

from flint import fmpq

from tresym.asymptotics.rational_functions import over, roots_of
from tresym.reals.decisions.hypergeometric import OpenError
from tresym.reals.decisions.hypergeometric import polynomial as in_one_variable
from tresym.reals.decisions.readable_witnesses import tidied
from tresym.reals.decisions.statement import Statement, functions
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, total
from tresym.reals.language.calls import FACTORIAL
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    LEAVES,
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    apply,
    integer,
    number,
    power,
    replaced,
    substitute,
    symbol,
    symbols,
    unknown,
)
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.numbers.exact import InputError

MOST_APART = 6
"""Whole differences of a root and a pole up to which their quotient is a rational function."""


class FirstOrder(NamedTuple):
    """A recurrence a(j + 1) = c(j) a(j) + g(j) with its first value.

    Attributes:
        name: the function symbol.
        n: the index.
        first: the index of the first value.
        lowest: the recurrence at n contains a(n + lowest) and none below it.
        factor: c, as a function of n.
        added: g, as a function of n.
        values: the first value.
    """

    name: Expr
    n: str
    first: int
    lowest: int
    factor: Expr
    added: Expr
    values: tuple[fmpq, ...]

    def terms(self) -> Iterator[fmpq]:
        """Yield a(first), a(first + 1), … as long as they are rational."""
        value, j = self.values[0], self.first
        while True:
            yield value
            c, g = (_exact(substitute(e, {self.n: number(j)})) for e in (self.factor, self.added))
            if c is None or g is None:
                return
            value, j = c * value + g, j + 1

    def between(self, low: int, high: int) -> dict[Expr, Expr]:
        """Return a(low), …, a(high) exactly, from the first value on."""
        known = enumerate(islice(self.terms(), max(0, high - self.first) + 1), self.first)
        return {
            Expr("unknown", (self.name, number(k))): number(v) for k, v in known if low <= k <= high
        }

    def closed(self) -> Expr | None:
        """Return a(n) as a function of n with factorials, gamma functions and a sum, or None."""
        whole = self._product()
        if whole is None:
            return None
        start = number(self.values[0])
        if self.added == ZERO:
            return start * whole
        k = "k" if self.n != "k" else "j"
        below = substitute(whole, {self.n: symbol(k) + 1})
        term = substitute(self.added, {self.n: symbol(k)}) / below
        if not _alternates(term):
            term = in_lowest_terms(term)
        return whole * (start + total("sum", term, k, number(self.first), symbol(self.n) - 1))

    def _product(self) -> Expr | None:
        """Return c(first) … c(n − 1)."""
        n = symbol(self.n)
        try:
            form = in_lowest_terms(self.factor)
            above, below = (in_one_variable(part, self.n) for part in over(form))
        except (InputError, OpenError, ZeroDivisionError):
            return None
        roots: list[list[fmpq]] = []
        for p in (above, below):
            found = [r for r, times in roots_of(p) for _ in range(times)]
            if len(found) != p.degree() or any(r >= self.first for r in found):
                return None
            roots.append(found)
        lead = above[above.degree()] / below[below.degree()]
        steps = n - self.first
        whole = ONE if abs(lead) == 1 else power(number(abs(lead)), steps)
        if lead < 0:
            whole = power(MINUS_ONE, steps) * whole
        zeros, poles = roots
        for r in list(zeros):
            s = next((s for s in poles if (r - s).q == 1 and abs(r - s) <= MOST_APART), None)
            if s is not None:
                zeros.remove(r)
                poles.remove(s)
                whole = whole * _quotient(n, r, s) / _quotient(number(self.first), r, s)
        for r in zeros:
            whole = whole * _gamma(n - number(r)) / _gamma(number(self.first - r))
        for s in poles:
            whole = whole / _gamma(n - number(s)) * _gamma(number(self.first - s))
        return whole


def _exact(e: Expr) -> fmpq | None:
    value = tidied(normal_form(e, Given()))
    return value.args[0] if value.op == "number" else None


def _quotient(x: Expr, r: fmpq, s: fmpq) -> Expr:
    """Return Γ(x − r)/Γ(x − s) where r − s is an integer."""
    apart = int((s - r).p)
    whole = ONE
    if apart > 0:  # (x − s)(x − s + 1) … (x − r − 1)
        for i in range(apart):
            whole = whole * (x - number(s - i))
        return whole
    for i in range(-apart):
        whole = whole / (x - number(r - i))
    return whole


def _gamma(x: Expr) -> Expr:
    """Return Γ(x), as a factorial where x is an integer or an index plus an integer."""
    k = integer(x)
    if k is not None and 0 < k <= 200:
        return number(factorial(k - 1))
    rest = x
    for name in symbols(x):
        rest = rest - symbol(name)
    shift = integer(tidied(normal_form(rest, Given())))
    return apply("gamma", x) if shift is None else unknown(FACTORIAL, (x - 1,))


def _alternates(e: Expr) -> bool:
    """Return whether a power of a negative number depends on a variable."""
    if e.op in LEAVES:
        return False
    base = e.args[0]
    if e.op == "^" and symbols(e.args[1]) and base.op == "number" and base.args[0] < 0:
        return True
    return any(_alternates(arg) for arg in e.args if isinstance(arg, Expr))


def first_order(statement: Statement, n: str) -> FirstOrder | None:
    """Return the recurrence of first order that the equations of a statement are."""
    recurrences = []
    start: tuple[Expr, int, fmpq] | None = None
    for left, right in statement.equations:
        nodes = {node for e in (left, right) for node in functions(e)}
        if any(len(m.args) != 2 for m in nodes) or len({m.args[0] for m in nodes}) != 1:
            return None
        if n in symbols(left) | symbols(right):
            recurrences.append((left, right, nodes))
            continue
        value = tidied(right if left in nodes else left)
        (node,) = nodes if len(nodes) == 1 else (ZERO,)
        index = integer(tidied(node.args[1])) if node != ZERO else None
        if start is not None or index is None or value.op != "number" or node not in (left, right):
            return None
        start = node.args[0], index, value.args[0]
    if len(recurrences) != 1 or start is None:
        return None
    left, right, nodes = recurrences[0]
    places = {m: integer(tidied(normal_form(m.args[1] - symbol(n), Given()))) for m in nodes}
    shifts = sorted(k for k in places.values() if k is not None)
    if len(nodes) != 2 or len(shifts) != 2 or shifts[1] - shifts[0] != 1:
        return None
    if {m.args[0] for m in nodes} != {start[0]}:
        return None
    low = shifts[0]
    marks = {m: symbol("[H]" if k == shifts[1] else "[L]") for m, k in places.items()}
    whole = replaced(left - right, marks)
    if not elementary(whole) or not symbols(whole) <= {"[H]", "[L]", n}:
        return None
    high, lower = (differentiate(whole, name) for name in ("[H]", "[L]"))
    rest = substitute(whole, {"[H]": ZERO, "[L]": ZERO})
    if {"[H]", "[L]"} & (symbols(high) | symbols(lower)):  # not linear
        return None
    if _alternates(high) or _alternates(lower) or high == ZERO:
        return None
    at = {n: symbol(n) - low}
    factor = in_lowest_terms(substitute(-lower / high, at))
    if factor == ZERO or any(
        e.op not in ("+", "*", "^", "number", "symbol") for e in _inner(factor)
    ):
        return None
    added = substitute(-rest / high, at)
    if not _alternates(added):
        added = tidied(normal_form(added, Given()))
    return FirstOrder(start[0], n, start[1], low, factor, added, (start[2],))


def _inner(e: Expr) -> Iterator[Expr]:
    yield e
    if e.op not in LEAVES:
        for arg in e.args:
            yield from _inner(arg)
