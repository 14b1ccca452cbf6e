"""Laurent expansions at 0 with exact rational coefficients.

Each function is expanded by the recurrence that its differential equation gives. Source: R. P.
Brent and P. Zimmermann, *Modern Computer Arithmetic*, § 4.7.
"""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from flint import fmpq

from tresym.reals.decisions.hypergeometric import OpenError, root
from tresym.reals.language.expression import Expr

SIZE = 40
"""How many coefficients are had."""
Row = list[fmpq]
_ZEROS = [fmpq(0)] * (SIZE - 1)


@dataclass(frozen=True)
class Germ:
    """``y^order Σ series[k] y^k``, with ``series[0]`` not 0 unless all of it is."""

    order: int
    series: Row

    def __getitem__(self, m: int) -> fmpq:
        """The coefficient of y^m."""
        k = m - self.order
        if k >= len(self.series):
            raise OpenError("coefficients of this order are beyond the truncation order")
        return self.series[k] if k >= 0 else fmpq(0)

    @property
    def row(self) -> Row:
        """The coefficients from y^0 on."""
        if self.order < 0:
            raise OpenError("the expansion has a pole")
        return ([fmpq(0)] * self.order + self.series)[: max(len(self.series), SIZE)]


def germ_of(e: Expr, y: str) -> Germ:
    """The expansion of ``e`` at y = 0.

    Raises:
        OpenError: it has none with rational coefficients that is found.
    """
    if e.op == "number":
        return _germ(0, [fmpq(e.args[0]), *_ZEROS])
    if e.op == "symbol":
        if e.args != (y,):
            raise OpenError("the expression has a parameter")
        return Germ(1, [fmpq(1), *_ZEROS])
    if e.op == "+":
        return _sum([germ_of(arg, y) for arg in e.args])
    if e.op == "*":
        result = germ_of(e.args[0], y)
        for arg in e.args[1:]:
            other = germ_of(arg, y)
            result = _germ(result.order + other.order, _times(result.series, other.series))
        return result
    if e.op == "^" and e.args[1].op == "number":
        return _power(germ_of(e.args[0], y), fmpq(e.args[1].args[0]))
    rules = _RULES.get(e.op)
    if rules is None:
        raise OpenError(f"no expansion of {e.op} is implemented")
    found = rules(germ_of(e.args[0], y))
    return found if isinstance(found, Germ) else _germ(0, found)


def _sum(parts: list[Germ]) -> Germ:
    order = min(part.order for part in parts)
    size = min(part.order - order + len(part.series) for part in parts)
    return _germ(order, [sum((p[order + k] for p in parts), fmpq(0)) for k in range(size)])


def _germ(order: int, series: Row) -> Germ:
    """With the zeros before the first coefficient taken away; what is known stays as long."""
    first = next((k for k, c in enumerate(series) if c), 0)
    return Germ(order + first, series[first:])


def _times(f: Row, g: Row) -> Row:
    size = min(len(f), len(g))
    return [sum((f[i] * g[k - i] for i in range(k + 1)), fmpq(0)) for k in range(size)]


def _slope(f: Row) -> Row:
    return [c * k for k, c in enumerate(f)][1:]


def _area(f: Row) -> Row:
    return [fmpq(0), *(c / (k + 1) for k, c in enumerate(f))]


def _power(f: Germ, r: fmpq) -> Germ:
    """By f (f^r)′ = r f′ f^r."""
    c = f.series[0]
    if c == 0 or (r.q != 1 and (c < 0 or f.order)):  # of y**2 the root is abs(y)
        raise OpenError("a power without a Laurent expansion")
    result = [c ** int(r.p) if r.q == 1 else _root(c, r)]
    for k in range(1, len(f.series)):
        terms = ((r * i - (k - i)) * f.series[i] * result[k - i] for i in range(1, k + 1))
        result.append(sum(terms, fmpq(0)) / (k * c))
    return Germ(f.order * int(r.p) if f.order else 0, result)


def _root(c: fmpq, r: fmpq) -> fmpq:
    found = root(c, int(r.q))
    if found.op != "number":
        raise OpenError("a coefficient is an irrational root")
    return fmpq(found.args[0]) ** int(r.p)


def _exp(f: Row) -> Row:
    if f[0]:
        raise OpenError("a coefficient is an irrational exponential")
    slope, result = _slope(f), [fmpq(1)]
    for k in range(1, len(f)):
        result.append(sum((slope[i] * result[k - 1 - i] for i in range(k)), fmpq(0)) / k)
    return result


def _waves(f: Row, turn: int) -> tuple[Row, Row]:
    """Sine and cosine (``turn`` −1), or the hyperbolic ones (1)."""
    if f[0]:
        raise OpenError("a coefficient is not rational")
    slope, s, c = _slope(f), [fmpq(0)], [fmpq(1)]
    for k in range(1, len(f)):
        up = sum((slope[i] * c[k - 1 - i] for i in range(k)), fmpq(0)) / k
        over = sum((slope[i] * s[k - 1 - i] for i in range(k)), fmpq(0)) / k * turn
        s.append(up)
        c.append(over)
    return s, c


def _quotient(f: Row, g: Row) -> Germ:
    below = _power(_germ(0, g), fmpq(-1))
    above = _germ(0, f)
    return _germ(above.order + below.order, _times(above.series, below.series))


def _log(f: Germ) -> Row:
    if f.order or f.series[0] != 1:
        raise OpenError("a coefficient is an irrational logarithm")
    slope = _germ(0, _slope(f.series))
    whole = _power(f, fmpq(-1))
    return _area(_times(slope.row, whole.row))


def _integrated(f: Row, square: int, r: fmpq) -> Row:
    """∫ f′ (1 + square f²)^r."""
    if f[0]:
        raise OpenError("a coefficient is not rational")
    inner = [square * c for c in _times(f, f)]
    inner[0] += 1
    return _area(_times(_slope(f), _power(Germ(0, inner), r).series))


_HALF = fmpq(1, 2)
_RULES: dict[str, Callable[[Germ], Germ | Row]] = {
    "exp": lambda f: _exp(f.row),
    "log": _log,
    "sin": lambda f: _waves(f.row, -1)[0],
    "cos": lambda f: _waves(f.row, -1)[1],
    "tan": lambda f: _quotient(*_waves(f.row, -1)),
    "cot": lambda f: _quotient(*_waves(f.row, -1)[::-1]),
    "sec": lambda f: _power(Germ(0, _waves(f.row, -1)[1]), fmpq(-1)),
    "csc": lambda f: _power(_germ(0, _waves(f.row, -1)[0]), fmpq(-1)),
    "sinh": lambda f: _waves(f.row, 1)[0],
    "cosh": lambda f: _waves(f.row, 1)[1],
    "tanh": lambda f: _quotient(*_waves(f.row, 1)),
    "coth": lambda f: _quotient(*_waves(f.row, 1)[::-1]),
    "sech": lambda f: _power(Germ(0, _waves(f.row, 1)[1]), fmpq(-1)),
    "csch": lambda f: _power(_germ(0, _waves(f.row, 1)[0]), fmpq(-1)),
    "atan": lambda f: _integrated(f.row, 1, fmpq(-1)),
    "atanh": lambda f: _integrated(f.row, -1, fmpq(-1)),
    "asin": lambda f: _integrated(f.row, -1, -_HALF),
    "asinh": lambda f: _integrated(f.row, 1, -_HALF),
}
