"""Compare a function of your own, in double precision, with the exact expression at points.

    sampled_table("mine.py:my_erf", "erf(x)", "x", ["1/10", "5"])

The function is called with each point rounded to a double, and its result is compared with a ball
around the exact value at that double. So each error is certified, but only at these points: nothing
is said about the points between them, and every output says that the errors are sampled. To load
the function, Python runs its file.
"""

from __future__ import annotations

import inspect
import math
import re
import time
from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass, field
from fractions import Fraction
from typing import Any, NamedTuple

from flint import fmpq

from tresym.accuracy import table as tables
from tresym.accuracy.other_libraries import loaded
from tresym.accuracy.table import Table
from tresym.accuracy.values import Exact, certified, constant, read, rounded
from tresym.reals.language.expression import Expr, number, substitute, symbols
from tresym.reals.language.parsing import parse_given
from tresym.reals.language.unicode_input import plain
from tresym.reals.numbers.arithmetic import ball_precision, bits
from tresym.reals.numbers.exact import Decimal, InputError, decimal_ball, shortened

DIGITS = 15
FEW = 4
"""The digits of errors."""
_NAMED = re.compile(r"[\w./\\~-]+:[A-Za-z_]\w*")


class Sample(NamedTuple):
    """One point.

    Attributes:
        at: the point, as it was asked for.
        double: the double that the function was called with.
        computed: what it returned; None if it raised an exception or returned no finite number.
        exact: a ball around the exact value at the double.
        error: computed − exact; None without a result, or if it cannot be told apart from 0.
        relative: error/exact, None as well where the exact value is 0.
        ulps: the error in units in the last place of the exact value.
        note: why a number is missing.
    """

    at: str
    double: float
    computed: float | None
    exact: Decimal
    error: Decimal | None
    relative: Decimal | None
    ulps: float | None
    note: str = ""


@dataclass(frozen=True)
class SampledTable:
    """The errors of a function at points.

    Attributes:
        function: its name, such as ``mine.py:my_erf``.
        exact: the exact expression, as it was read.
        variable: the name of the variable.
        rows: a row for each point.
        digits: the digits of the exact values.
        seconds: processor time.
    """

    function: str
    exact: str
    variable: str
    rows: tuple[Sample, ...]
    digits: int = DIGITS
    seconds: float = field(default=0.0, compare=False)

    @property
    def worst(self) -> Sample | None:
        """The row with the largest relative error, or the largest error where none is relative."""
        told = [row for row in self.rows if row.error is not None]
        return max(told, key=lambda row: _size(row.relative or row.error), default=None)

    @property
    def table(self) -> Table:
        """The rows as a table of text."""
        heads = (self.variable, "exact", "computed", "error", "relative error", "ulps")
        rows = tuple(
            (
                row.at,
                _text(row.exact, self.digits),
                row.note if row.computed is None else repr(row.computed),
                "" if row.error is None else _text(row.error, FEW),
                "" if row.relative is None else _text(row.relative, FEW),
                "" if row.ulps is None else _ulps(row.ulps),
            )
            for row in self.rows
        )
        return Table(self.caption, heads, rows, "sampled-errors")

    @property
    def caption(self) -> str:
        """What the table shows."""
        return (
            f"{self.function} compared with {self.exact}. The errors are sampled: each is "
            f"certified at the double nearest to {self.variable}, and nothing is claimed between "
            "the points. An ulp is a unit in the last place of the exact value."
        )

    @property
    def notes(self) -> tuple[str, ...]:
        """The sentences below the table."""
        worst = self.worst
        missing = [row for row in self.rows if row.note and row.computed is not None]
        found = tuple(f"at {self.variable} = {row.at}: {row.note}" for row in missing)
        if worst is None:
            return found
        kind = "error" if worst.relative is None else "relative error"
        size = _text(worst.relative or worst.error or worst.exact, FEW).lstrip("-")
        return (*found, f"largest sampled {kind}: {size}, at {self.variable} = {worst.at}")

    def written(self, form: str) -> str:
        """Return the table as text, markdown, latex, csv or html."""
        from html import escape

        text = tables.written(self.table, form)
        if form == "csv":
            return text
        if form == "html":
            return text + "".join(f"<p>{escape(note)}</p>\n" for note in self.notes)
        words = {"markdown": tables.markdown_text, "latex": tables.latex_text}.get(form, str)
        return text + "".join(f"\n{words(note)}\n" for note in self.notes)

    def as_json(self) -> dict[str, Any]:
        """Return the table for JSON; every key is always there."""
        rows = [
            row._asdict()
            | {
                name: None if ball is None else ball._asdict()
                for name, ball in (
                    ("exact", row.exact), ("error", row.error), ("relative", row.relative)
                )
            }
            for row in self.rows
        ]  # fmt: skip
        return {
            "function": self.function,
            "exact": self.exact,
            "variable": self.variable,
            "sampled": True,
            "rows": rows,
            "seconds": round(self.seconds, 3),
        }

    def __str__(self) -> str:
        return self.written("text")

    def _repr_html_(self) -> str:
        return self.written("html")


def names_function(text: str) -> bool:
    """Return whether a text names a function as ``module:function`` or ``file.py:function``.

    Example:
        >>> names_function("mine.py:my_erf"), names_function("erf(x)")
        (True, False)
    """
    return _NAMED.fullmatch(text.strip()) is not None


def sampled_table(
    function: str,
    exact: str | Expr,
    at: Sequence[Exact],
    variable: str = "",
    given: str = "",
    digits: int = DIGITS,
) -> SampledTable:
    """Compare a function in double precision with an expression at points.

    Args:
        function: ``file.py:function`` or ``module:function``.
        exact: the exact expression.
        at: the points, exact.
        variable: the variable; if the expression has one alone, it need not be named.
        given: values of the other variables, such as ``"M == 1"``, which are passed by name.
        digits: the digits of the exact values.

    Raises:
        InputError: the function cannot be loaded, or the exact value at a point does not exist.
    """
    start = time.process_time()
    e, fixed = read(exact), _fixed(given)
    free = sorted(symbols(e) - fixed.keys())
    name = variable or (free[0] if len(free) == 1 else "")
    if free != [name]:
        if name in free or len(free) > 1:
            other = next(x for x in free if x != name)
            raise InputError(
                f"the expression has the variables {', '.join(free)}: give values to all but one, "
                f"as in --given '{other} == 1'"
            )
        raise InputError(f"the expression {e} does not contain {name or 'a variable'}")
    if not at:
        raise InputError(f"{function} is sampled: name the points, as in --at 1/10,1/2,1")
    call = _caller(loaded(function.strip()), name, fixed)
    rows = tuple(_sample(call, e, name, fixed, point, digits) for point in at)
    return SampledTable(function.strip(), str(e), name, rows, digits, time.process_time() - start)


def _fixed(given: str) -> dict[str, fmpq]:
    """The values of parameters, rounded to doubles."""
    found = {}
    for left, relation, right in parse_given(plain(given)):
        if relation != "==" or left.op != "symbol" or symbols(right):
            raise InputError("with a function of your own, write parameters as in 'M == 1, c == 2'")
        found[str(left.args[0])] = _double(right)[1]
    return found


def _double(x: Expr) -> tuple[float, fmpq]:
    """The double nearest to a constant, and the same exactly."""
    near = float(rounded(certified(x, 40), 30))
    exact = Fraction(near)
    return near, fmpq(exact.numerator, exact.denominator)


def _caller(
    function: Callable[..., Any], name: str, fixed: Mapping[str, fmpq]
) -> Callable[[float], Any]:
    """Return the function of the variable alone, with the parameters passed by name."""
    more = {key: int(x.p) / int(x.q) for key, x in fixed.items()}
    try:
        known = inspect.signature(function).parameters
        by_name = name in known and known[name].kind is not inspect.Parameter.POSITIONAL_ONLY
    except (TypeError, ValueError):  # of a compiled function
        by_name = False
    if by_name:
        return lambda x: function(**{name: x}, **more)
    return lambda x: function(x, **more)


def _sample(
    call: Callable[[float], Any],
    e: Expr,
    name: str,
    fixed: Mapping[str, fmpq],
    point: Exact,
    digits: int,
) -> Sample:
    x = constant(point, name)
    double, at = _double(x)
    closed = substitute(e, {name: number(at), **{key: number(v) for key, v in fixed.items()}})
    exact = certified(closed, digits + 2)
    note, computed = "", None
    try:
        result = float(call(double))
        computed = result if math.isfinite(result) else None
        note = "" if computed is not None else f"returns {result}"
    except Exception as raised:  # of the user's function, whatever it raises
        note = f"raises {type(raised).__name__}: {shortened(' '.join(str(raised).split()), 60)}"
    error = relative = ulps = None
    if computed is not None:
        told = Fraction(computed)
        value = number(fmpq(told.numerator, told.denominator))
        try:
            gap = certified(value - closed, 2 * FEW)
        except InputError:
            note = "the error could not be told apart from 0"
        else:
            with ball_precision(bits(digits) + 64):
                error = decimal_ball(gap, 2 * FEW)
                relative = None if exact.is_zero() else decimal_ball(gap / exact, 2 * FEW)
                ulps = abs(float(gap.mid())) / math.ulp(float(exact.mid()))
    with ball_precision(bits(digits) + 64):
        shown = decimal_ball(exact, digits + 2)
    return Sample(str(point), double, computed, shown, error, relative, ulps, note)


def _size(ball: Decimal | None) -> float:
    return 0.0 if ball is None else abs(float(ball.mid))


def _ulps(x: float) -> str:
    return f"{x:.2f}" if x < 1e4 else f"{x:.2e}".replace("e+", "e")


def _text(ball: Decimal, digits: int) -> str:
    from flint import arb

    with ball_precision(bits(digits) + 64):
        return rounded(arb(ball.mid), digits)
