"""Enclose the largest error of an approximation on a region, absolute and relative.

The largest |exact − approx| and |exact − approx|/|exact| are found from both sides by
:mod:`tresym.reals.expansions.maxima`. An approximation is an expression, or a list of coefficients
of a polynomial, lowest power first. Its decimals are exact numbers; with ``stored="double"`` they
are what a program computes with, the nearest numbers of binary64. A hexadecimal floating-point
number such as ``0x1.921fb54442d18p+1`` is exact. The error of rounding during the computation of
the approximation is not part of this; for a Python function it is told beside it, see
:mod:`tresym.accuracy.python_functions`.

Example: the formula 9.4.1 of Abramowitz and Stegun for J₀ on 0 ≤ x ≤ 3, with the printed bound
5·10⁻⁸, has a largest error between 4.87·10⁻⁸ and 4.89·10⁻⁸.
"""

from __future__ import annotations

import re
import time
from collections.abc import Callable
from fractions import Fraction
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.accuracy.constants import jets_and_values
from tresym.accuracy.python_functions import Program, Rounding, read_function, rounding
from tresym.accuracy.sampled import names_function
from tresym.accuracy.stored_numbers import nearest, readable
from tresym.accuracy.values import read
from tresym.asymptotics.constants import rounded
from tresym.reals.decisions.path_regions import interval_of
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.maxima import EXPLICIT, Maximum, exact_ends
from tresym.reals.language.binders import elementary
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import ONE, Expr, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, quoted
from tresym.reals.signs.interior import is_zero

FORMATS = {"exact": None, "double": (53, -1074), "single": (24, -149)}
"""How decimals of the approximation are read: the bits of a number, and the smallest power of 2."""
CLOSE = fmpq(1, 1000)
"""How close the two bounds of an error shall be."""
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
        rounding: what rounding adds, for a Python function.
    """

    exact: str
    approximation: str
    region: str
    stored: str
    absolute: Bounds
    relative: Bounds
    seconds: float
    rounding: Rounding | None = None

    def __bool__(self) -> bool:
        return bool(self.absolute.high)

    def __str__(self) -> str:
        as_read = "" if self.stored == "exact" else f", decimals in {self.stored} precision"
        rows = [
            ("largest absolute error", self.absolute),
            ("largest relative error", self.relative),
            *([("rounding adds", self.rounding)] if self.rounding else []),
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
            "rounding": self.rounding and self.rounding._asdict(),
            "seconds": round(self.seconds, 6),
        }


def largest_error(
    exact: str | Expr, approx: str | Expr | Callable[..., Any], on: str, stored: str = "exact"
) -> LargestError:
    """Return the largest absolute and relative error of an approximation on a region.

    Args:
        exact: the function, in one variable.
        approx: the approximation, ``[c0, c1, …]``, the coefficients of a polynomial, or a Python
            function, also as ``"FILE.py:FUNCTION"``, which is read from its source and not run.
            Its constants are stored in double precision, unless ``stored`` is ``"single"``.
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
    program = _program(approx, stored)
    formula = approx if program is None else program.expression(interval(on)[0])
    stored = "double" if program is not None and stored == "exact" else stored
    assert isinstance(formula, str | Expr)
    absolute, relative = (error_bounds(exact, formula, on, stored, kind) for kind in (False, True))
    added = None
    if program is not None:
        with ball_precision():
            ends = [end and evaluate(end, {}) for end in interval(on)[1:]]
        if ends[0] is not None and ends[1] is not None:
            added = rounding(program, ends[0], ends[1], stored)
    shown = program.name if program is not None else approx
    left, right = (
        str(e) if isinstance(e, Expr) else " ".join(str(e).split()) for e in (exact, shown)
    )
    seconds = time.process_time() - start
    return LargestError(left, right, on.strip(), stored, absolute, relative, seconds, added)


def _program(approx: str | Expr | Callable[..., Any], stored: str) -> Program | None:
    """Return the operations of an approximation that is a Python function."""
    if isinstance(approx, Expr) or (isinstance(approx, str) and not names_function(approx)):
        return None
    return read_function(approx, "double" if stored == "exact" else stored)


def errors_at(
    exact: str, approx: str, on: str, stored: str, count: int
) -> list[tuple[float, float]]:
    """Return points and the errors there on a bounded region, for a picture.

    Raises:
        InputError: the region is not bounded, or the functions are not explicit.
    """
    name, low, high = interval(on)
    if low is None or high is None:
        raise InputError("error: a picture needs a bounded region")
    program = _program(approx, stored)
    g = read(as_stored(approx, stored, name)) if program is None else program.expression(name)
    found: list[tuple[float, float]] = []
    with ball_precision(200):
        ends = [evaluate(end, {}) for end in (low, high)]
        for k in range(count + 1):
            x = arb((ends[0] + (ends[1] - ends[0]) * k / count).mid())
            value = evaluate(read(exact) - g, {name: x})
            if value.is_finite():
                found.append((float(x), float(value.mid())))
    return found


def error_bounds(
    exact: str | Expr,
    approx: str | Expr,
    on: str,
    stored: str = "exact",
    relative: bool = False,
    close: fmpq = CLOSE,
) -> Bounds:
    """Return the largest absolute or relative error alone; see :func:`largest_error`.

    Args:
        close: how close its two bounds shall be.
    """
    name, low, high = interval(on)
    if stored not in FORMATS:
        raise InputError(f"{quoted(stored)}: decimals are read as {', '.join(FORMATS)}")
    f = read(exact)
    g = read(as_stored(approx, stored, name)) if isinstance(approx, str) else approx
    others = (symbols(f) | symbols(g)) - {name, INFINITY.args[0]}
    if others:
        raise InputError(f"{', '.join(sorted(others))}: the region is one of {name} alone")
    return _bounds(f, g, f if relative else ONE, name, low, high, close)


def _bounds(
    f: Expr, g: Expr, below: Expr, name: str, low: Expr | None, high: Expr | None, close: fmpq
) -> Bounds:
    """Return the largest |f − g|/|below| on an interval."""
    above = f - g
    if elementary(above) and is_zero(above, Given()):
        return Bounds("0", "0", "")
    how = EXPLICIT if elementary(above, below) else jets_and_values()
    return _written(exact_ends(above, below, name, low, high, close, how), name)


def _written(found: Maximum, name: str) -> Bounds:
    where = ""
    if found.at is not None:
        with ball_precision():
            where = f"{name} = {_short(arb(found.at))}"
    low = readable(rounded(found.low, -1))
    if found.unbounded:
        return Bounds(low, "oo", where)
    return Bounds(low, readable(rounded(found.high, 1)) if found.high.is_finite() else "", where)


def _short(x: arb) -> str:
    n = x.unique_fmpz() if x.is_exact() else None
    return str(n) if n is not None else x.str(8, radius=False)


def interval(region: str) -> tuple[str, Expr | None, Expr | None]:
    """Return the variable of a region and its ends; None for an infinite one.

    Raises:
        InputError: it is no interval of one variable.
    """
    found = interval_of(Given.parse(region).comparisons)
    if found is None:
        raise InputError("write a region of one variable, such as 0 <= x <= 1, abs(x) <= 1, x >= 1")
    return found


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
