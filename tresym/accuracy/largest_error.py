"""Enclose the largest error of an approximation on a region, absolute and relative.

The largest |exact − approx| and |exact − approx|/|exact| are found from both sides by
:mod:`tresym.reals.expansions.maxima`. An approximation is an expression, or a list of coefficients
of a polynomial, lowest power first. Its decimals are exact numbers; with ``stored="double"`` they
are what a program computes with, the nearest numbers of binary64. A hexadecimal floating-point
number such as ``0x1.921fb54442d18p+1`` is exact. The error of rounding during the computation of
the approximation is not part of this.

Example: the formula 9.4.1 of Abramowitz and Stegun for J₀ on 0 ≤ x ≤ 3, with the printed bound
5·10⁻⁸, has a largest error between 4.87·10⁻⁸ and 4.89·10⁻⁸.
"""

from __future__ import annotations

import re
import time
from decimal import Decimal
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.accuracy.constants import jets_and_values
from tresym.accuracy.values import read
from tresym.asymptotics.constants import rounded
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.maxima import EXPLICIT, Evaluations, Maximum, largest
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import ONE, ZERO, Expr, substitute, symbol, symbols
from tresym.reals.language.formula import MIRRORED
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, quoted
from tresym.reals.signs.interior import is_zero

FORMATS = {"exact": None, "double": (53, -1074), "single": (24, -149)}
"""How decimals of the approximation are read: the bits of a number, and the smallest power of 2."""
CLOSE = fmpq(1, 1000)
"""How close the two bounds of an error shall be."""
PRECISION = 256
BESIDE = 100
"""An end such as π is replaced by a rational number that is 2^−100 away."""
_DECIMAL = re.compile(
    r"(?<![\w.])(?:(?P<hex>0[xX][0-9a-fA-F]+\.?[0-9a-fA-F]*[pP][+-]?\d+)"
    r"|(?P<decimal>(?:\d+\.\d*|\.\d+)(?:[eE][+-]?\d+)?|\d+[eE][+-]?\d+)[fF]?)(?!\w)"
)


class Bounds(NamedTuple):
    """Bounds of the largest error.

    Attributes:
        low, high: decimal bounds of it, rounded outward; ``high`` is empty if none was found, and
            ``oo`` if the error is proved to be unbounded.
        where: a point at which the error is at least ``low``, or beside which it is unbounded;
            empty if it is approached at an end.
    """

    low: str
    high: str
    where: str

    def __str__(self) -> str:
        if self.high == "oo":
            return f"unbounded near {self.where}" if self.where else "unbounded"
        where = f", at {self.where}" if self.where else ""
        if not self.high:
            return f"at least {self.low}{where}; no upper bound was found"
        return f"{self.low} to {self.high}{where}" if self.low != self.high else self.low + where


class LargestError(NamedTuple):
    """The largest errors of an approximation on a region.

    Attributes:
        exact, approximation, region: what was asked.
        stored: how decimals of the approximation were read.
        absolute, relative: the errors.
        seconds: processor time.
    """

    exact: str
    approximation: str
    region: str
    stored: str
    absolute: Bounds
    relative: Bounds
    seconds: float

    def __bool__(self) -> bool:
        return bool(self.absolute.high)

    def __str__(self) -> str:
        as_read = "" if self.stored == "exact" else f", decimals in {self.stored} precision"
        rows = [
            ("largest absolute error", self.absolute),
            ("largest relative error", self.relative),
            ("of", self.approximation + as_read),
            ("for", self.exact),
            ("on", self.region),
        ]
        return "\n".join(f"{name:<22}  {value}" for name, value in rows)

    def as_json(self) -> dict[str, Any]:
        """Return the errors for JSON."""
        return {
            "exact": self.exact,
            "approximation": self.approximation,
            "on": self.region,
            "stored": self.stored,
            "absolute": self.absolute._asdict(),
            "relative": self.relative._asdict(),
            "seconds": round(self.seconds, 6),
        }


def largest_error(
    exact: str | Expr, approx: str | Expr, on: str, stored: str = "exact"
) -> LargestError:
    """Return the largest absolute and relative error of an approximation on a region.

    Args:
        exact: the function, in one variable.
        approx: the approximation, or ``[c0, c1, …]``, the coefficients of a polynomial.
        on: the region, such as ``"0 <= x <= 1"``, ``"abs(x) <= pi/4"`` or ``"x >= 1"``.
        stored: how the decimals of ``approx`` are read: ``"exact"``, ``"double"`` or ``"single"``.

    Raises:
        InputError: something cannot be read, or the functions have other variables than the region.

    Example:
        >>> import tresym
        >>> found = tresym.largest_error("sin(x)", "x - x**3/6", "0 <= x <= 1")
        >>> found.absolute.low, found.absolute.high, found.absolute.where
        ('0.00813765', '0.00813766', 'x = 1')
    """
    start = time.process_time()
    name, low, high = interval(on)
    if stored not in FORMATS:
        raise InputError(f"{quoted(stored)}: decimals are read as {', '.join(FORMATS)}")
    f = read(exact)
    g = read(as_stored(approx, stored, name)) if isinstance(approx, str) else approx
    others = (symbols(f) | symbols(g)) - {name, INFINITY.args[0]}
    if others:
        raise InputError(f"{', '.join(sorted(others))}: the region is one of {name} alone")
    absolute, relative = (_bounds(f, g, below, name, low, high) for below in (ONE, f))
    left, right = (str(e) if isinstance(e, Expr) else " ".join(e.split()) for e in (exact, approx))
    seconds = time.process_time() - start
    return LargestError(left, right, on.strip(), stored, absolute, relative, seconds)


def _bounds(
    f: Expr, g: Expr, below: Expr, name: str, low: Expr | None, high: Expr | None
) -> Bounds:
    """Return the largest |f − g|/|below| on an interval."""
    above = f - g
    if elementary(above) and is_zero(above, Given()):
        return Bounds("0", "0", "")
    how = EXPLICIT if elementary(above, below) else jets_and_values()
    beside = _beside_exact_ends(above, below, name, low, high, how)
    if beside is not None:
        return _written(beside, name, symbol(name))
    ends = [end for end in (low, high) if end is not None]
    put = symbol(name)
    if any(end.op != "number" for end in ends):
        assert ends
        if len(ends) == 2:
            put = ends[0] + (ends[1] - ends[0]) * symbol(name)
            first, last = fmpq(0), fmpq(1)
        else:
            put = ends[0] + symbol(name)
            first, last = (None, fmpq(0)) if low is None else (fmpq(0), None)
    else:
        first, last = (None if end is None else end.args[0] for end in (low, high))
    u, v = (substitute(e, {name: put}) for e in (above, below))
    found = largest(u, v, name, first, last, CLOSE, how)
    return _written(found, name, put)


def _beside_exact_ends(
    above: Expr, below: Expr, name: str, low: Expr | None, high: Expr | None, how: Evaluations
) -> Maximum | None:
    """Return the largest ratio where an end is no rational number, as π/2, and nothing is singular.

    The interval between rational numbers very close to the ends is searched, and the ratio on the
    rest is bounded in balls. None if an end is rational and infinite, or the rest has no bound.
    """
    inner: list[fmpq | None] = []
    rest: list[tuple[arb, arb]] = []
    with ball_precision(PRECISION):
        for side, end in ((1, low), (-1, high)):
            if end is None or end.op == "number":
                inner.append(None if end is None else end.args[0])
                continue
            exact = evaluate(end, {})
            if not exact.is_finite():
                return None
            scaled = (exact * arb(2) ** BESIDE).mid().fmpq()
            inner.append((scaled.floor() + 2 * side) / fmpq(2) ** BESIDE)
            rest.append((exact, exact.union(arb(inner[-1]))))
        if not rest:
            return None
        values = [tuple(abs(how.value(above / below, {name: x})) for x in part) for part in rest]
    if not all(value.is_finite() for pair in values for value in pair):
        return None
    found = largest(above, below, name, inner[0], inner[1], CLOSE, how)
    if not found.unbounded:
        for at_end, over in values:
            if at_end.lower() > found.low:
                found = found._replace(low=at_end.lower(), at=None)
            found = found._replace(high=found.high.max(over.upper()))
    return found


def _written(found: Maximum, name: str, put: Expr) -> Bounds:
    where = ""
    if found.at is not None:
        with ball_precision():
            where = f"{name} = {_short(evaluate(put, {name: arb(found.at)}))}"
    low = readable(rounded(found.low, -1))
    if found.unbounded:
        return Bounds(low, "oo", where)
    return Bounds(low, readable(rounded(found.high, 1)) if found.high.is_finite() else "", where)


def readable(decimal: str) -> str:
    """Return a decimal with an exponent where it has many zeros: 4.87e-8."""
    x = Decimal(decimal).normalize()
    return decimal if -5 < x.adjusted() < 9 else f"{x:e}".replace("e+", "e")


def _short(x: arb) -> str:
    n = x.unique_fmpz() if x.is_exact() else None
    return str(n) if n is not None else x.str(8, radius=False)


def interval(region: str) -> tuple[str, Expr | None, Expr | None]:
    """Return the variable of a region and its ends; None for an infinite one.

    Raises:
        InputError: it is no interval of one variable.
    """
    wrong = InputError("write a region of one variable, such as 0 <= x <= 1, abs(x) <= 1, x >= 1")
    given = Given.parse(region)
    if len(given.names) != 1:
        raise wrong
    (name,) = given.names
    ends: dict[int, Expr] = {}
    for left, sign, right in given.unfolded().comparisons:
        if sign not in ("<", "<=", ">", ">=") or name in symbols(left) & symbols(right):
            raise wrong
        for side, relation, bound in ((left, sign, right), (right, MIRRORED[sign], left)):
            if name not in symbols(side) or name in symbols(bound):
                continue
            shift = normal_form(side - symbol(name), Given())
            if symbols(shift):
                raise wrong
            end, way = bound - shift if shift != ZERO else bound, 1 if relation[0] == "<" else -1
            with ball_precision():
                kept = ends.get(way)
                if kept is None or way * (evaluate(end, {}) - evaluate(kept, {})) < 0:
                    ends[way] = end
    low, high = ends.get(-1), ends.get(1)
    with ball_precision():
        if low is not None and high is not None and evaluate(low, {}) > evaluate(high, {}):
            raise InputError(f"{region.strip()}: no number satisfies these conditions")
    return name, low, high


def as_stored(text: str, stored: str, name: str) -> str:
    """Return the text of an approximation with its decimals as a program stores them.

    Args:
        text: an expression, or the coefficients of a polynomial in brackets.
        stored: ``"exact"``, ``"double"`` or ``"single"``.
        name: the variable of a polynomial.
    """

    def number_of(found: re.Match[str]) -> str:
        hexadecimal, decimal = found["hex"], found["decimal"]
        if hexadecimal is not None:
            x = Fraction(float.fromhex(hexadecimal))
        elif FORMATS[stored] is None:
            return str(decimal)
        else:
            x = nearest(Fraction(decimal), *FORMATS[stored])  # type: ignore[misc]
        return f"({x})"

    written = _DECIMAL.sub(number_of, text).strip()
    if not written.startswith("["):
        return written
    if not written.endswith("]"):
        raise InputError("write coefficients as [c0, c1, …], lowest power first")
    parts = [part.strip() for part in written[1:-1].split(",")]
    if not all(parts):
        raise InputError("write coefficients as [c0, c1, …], lowest power first")
    return (
        " + ".join(
            f"({part})*{name}**{k}" if k else f"({part})"
            for k, part in enumerate(parts)
            if part != "0"
        )
        or "0"
    )


def nearest(x: Fraction, bits: int, least: int) -> Fraction:
    """Return the floating-point number nearest to x, to even in a tie.

    Args:
        x: a number.
        bits: the bits of the mantissa.
        least: the smallest positive number is 2 to this power.
    """
    if not x:
        return x
    size = abs(x)
    power = size.numerator.bit_length() - size.denominator.bit_length()
    if Fraction(2) ** power > size:
        power -= 1
    unit = Fraction(2) ** max(power - bits + 1, least)
    return round(x / unit) * unit
