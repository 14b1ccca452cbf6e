"""Laurent expansions at 0 with exact rational coefficients, by the power series of FLINT."""

from __future__ import annotations

from dataclasses import dataclass

from flint import ctx, fmpq, fmpq_series, fmpz

from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import Expr, number

SIZE = 40
"""How many coefficients are had."""


class OpenError(Exception):
    """A series is not of this kind, or a proof failed; the text is the reason."""


def root(value: fmpq, n: int) -> Expr:
    """Return the n-th root of a positive number, as a rational number if it is one."""
    p, q = (fmpz(k).root(n) for k in (value.p, value.q))
    exact = p**n == value.p and q**n == value.q
    return number(fmpq(p, q)) if exact else number(value) ** number(fmpq(1, n))


@dataclass(frozen=True)
class Germ:
    """``y^order Σ series[k] y^k``, with ``series[0]`` not 0 unless all of it is."""

    order: int
    series: list[fmpq]

    def __getitem__(self, m: int) -> fmpq:
        """The coefficient of y^m."""
        k = m - self.order
        if k >= len(self.series):
            raise OpenError("coefficients of this order are beyond the truncation order")
        return self.series[k] if k >= 0 else fmpq(0)


def germ_of(e: Expr, y: str) -> Germ:
    """The expansion of ``e`` at y = 0.

    Raises:
        OpenError: it has none with rational coefficients that is found.
    """
    before, ctx.cap = ctx.cap, SIZE
    try:
        order, s = _expanded(e, y)
        return Germ(order, [s[k] for k in range(s.prec)])
    except (ValueError, ZeroDivisionError) as error:
        raise OpenError(f"no expansion with rational coefficients was found: {error}") from error
    finally:
        ctx.cap = before


def _expanded(e: Expr, y: str) -> tuple[int, fmpq_series]:
    """The order m, and a series s with ``s(0)`` not 0, of y^m s; the order 0 and 0 of zero."""
    if e.op == "number":
        return 0, fmpq_series([e.args[0]])
    if e.op == "symbol":
        if e.args != (y,):
            raise OpenError("the expression has a parameter")
        return 1, fmpq_series([1])
    if e.op == "+":
        parts = [_expanded(arg, y) for arg in e.args]
        order = min(m for m, _ in parts)
        return _lowest(order, sum((_shifted(s, m - order) for m, s in parts), fmpq_series([])))
    if e.op == "*":
        order, product = 0, fmpq_series([1])
        for m, s in (_expanded(arg, y) for arg in e.args):
            order, product = order + m, product * s
        return _lowest(order, product)
    if e.op == "^" and e.args[1].op == "number":
        return _power(*_expanded(e.args[0], y), fmpq(e.args[1].args[0]))
    row = TABLE.get(e.op)
    if row and row.reciprocal:
        return _power(*_expanded(Expr(row.reciprocal, e.args), y), fmpq(-1))
    if row is None or row.rational_series is None:
        raise OpenError(f"no expansion of {e.op} is implemented")
    m, s = _expanded(e.args[0], y)
    if m < 0:
        raise OpenError("the expansion has a pole")
    s = _shifted(s, m)
    return _lowest(0, row.rational_series(s))


def _shifted(s: fmpq_series, m: int) -> fmpq_series:
    """y^m s."""
    return fmpq_series([fmpq(0)] * min(m, SIZE) + s.coeffs(), prec=min(s.prec + m, SIZE))


def _lowest(order: int, s: fmpq_series) -> tuple[int, fmpq_series]:
    """With powers of y taken out; what is known stays as long."""
    m = max(s.valuation(), 0)
    return order + m, fmpq_series(s.coeffs()[m:], prec=s.prec - m)


def _power(order: int, s: fmpq_series, r: fmpq) -> tuple[int, fmpq_series]:
    c = s[0]
    if r.q == 1:
        return order * int(r.p), (s if r > 0 else s.inv()) ** abs(int(r.p))
    front = root(c, int(r.q)) if c > 0 and not order else None  # of y**2 the root is abs(y)
    if front is None or front.op != "number":
        raise OpenError("a power without a Laurent expansion")
    return 0, ((s / c).log() * r).exp() * front.args[0] ** int(r.p)
