"""Evaluate any expression of the grammar at exact parameters, to certified digits.

:func:`value` raises the precision until the ball proves the digits that are asked for. Elementary
functions, integrals (also with infinite ends and integrable singularities), roots of equations,
sums and series are evaluated by the one evaluator of
:mod:`tresym.reals.domain.binder_values`. Nothing is taken from an error estimate. Example:

>>> value("integral(exp(-x**2), x, 0, oo)", digits=20).text
'0.88622692545275801365'
"""

from __future__ import annotations

import re
import time
from collections.abc import Mapping
from dataclasses import dataclass, field
from itertools import pairwise
from math import log10
from typing import Any, TypeAlias

from flint import arb, fmpq, fmpz

from tresym.reals.decisions.closed_values import certified_evaluation
from tresym.reals.decisions.rounding import rounded_numbers
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import InBalls, UndefinedError
from tresym.reals.functions.table import TABLE
from tresym.reals.language.binders import outermost, worked_out
from tresym.reals.language.calls import FACTORIAL, INFINITY, ROUNDED, unknown_function_error
from tresym.reals.language.expression import Expr, number, opened, substitute, symbol, symbols
from tresym.reals.language.parsing import as_written
from tresym.reals.language.sentences import spelled_expression
from tresym.reals.language.typesetting import to_latex
from tresym.reals.language.unicode_input import plain
from tresym.reals.notebook import html_table, in_one_line
from tresym.reals.numbers.arithmetic import ball_precision, bits, side
from tresym.reals.numbers.exact import (
    Decimal,
    InputError,
    as_rational,
    decimal_ball,
    fraction_text,
    whole_number,
)
from tresym.reals.signs.interior import is_zero
from tresym.reals.values.growth import DivergesError

MAX_DIGITS = 10_000
SMALLEST = 4
"""A value below 10^(−4 digits − 100) is not told apart from 0, if nothing else is asked for."""
GUARD = 32
"""The bits beyond the digits with which an expression is tried first."""
AGAIN = 2
"""How often an expression is tried again, at higher precision, that has no value."""
GRID = 400
"""The number of points at which an equation without a proved root is looked at."""

Exact: TypeAlias = str | int | fmpq | Any


@dataclass(frozen=True)
class Value:
    """A certified value.

    Attributes:
        expression: what was evaluated, in the grammar of expressions.
        at: the parameters.
        text: the value as a decimal whose digits are all right: it differs from the value by at
            most half a unit in the last place.
        ball: the same as midpoint and radius.
        digits: the number of digits that was asked for.
        seconds: processor time.
    """

    expression: str
    at: Mapping[str, str]
    text: str
    ball: Decimal
    digits: int
    seconds: float = field(default=0.0, compare=False)

    def __str__(self) -> str:
        return self.text

    def __float__(self) -> float:
        return float(self.text)

    def __repr__(self) -> str:
        return in_one_line(f"Value({self.expression}{self._where(' at ')} = {self.text})")

    def _where(self, before: str) -> str:
        where = ", ".join(f"{name} = {x}" for name, x in self.at.items())
        return before + where if where else ""

    def as_json(self) -> dict[str, Any]:
        """Return the value for JSON."""
        return {
            "expression": self.expression,
            "at": dict(self.at),
            "text": self.text,
            "ball": self.ball._asdict(),
            "digits": self.digits,
            "seconds": round(self.seconds, 6),
        }

    def _repr_html_(self) -> str:
        rows = [("expression", self.expression), ("at", self._where(""))]
        rows += [("± at most", self.ball.rad), ("digits", str(self.digits))]
        return html_table(self.text, [row for row in rows if row[1]])

    def _repr_latex_(self) -> str:
        return f"${to_latex([(read(self.expression), '==', symbol(self.text))])}$"


def value(text: str | Expr, digits: int = 50, **at: Exact) -> Value:
    """Evaluate an expression at exact parameters, to certified digits.

    Args:
        text: the expression: elementary functions, ``integral(f, x, a, b)``, ``root(F, y, a, b)``,
            ``sum(f, k, 1, oo)``, ``diff(f, x)`` and so on.
        digits: how many significant digits are proved.
        at: the value of each variable: a decimal or a fraction as text, an integer, a Fraction, or
            a constant such as ``"pi/2"``.

    Raises:
        InputError: the text cannot be read, a variable has no value, or no value is proved to
            exist; the message is one line that says where and why.

    Example:
        >>> import tresym
        >>> tresym.value("root(y - e*sin(y) - M, y, 0, pi)", digits=30, e="1/2", M=1).text
        '1.49870113351784831405798549726'
    """
    start = time.process_time()
    digits = whole_number(digits, 1, MAX_DIGITS, "digits")
    e = read(text)
    point = {name: constant(x, name) for name, x in at.items()}
    found = certified(placed(e, point), digits)
    shown = {name: str(x) for name, x in point.items()}
    with ball_precision(bits(digits) + 64):
        ball = decimal_ball(found, digits)
    return Value(str(e), shown, rounded(found, digits), ball, digits, time.process_time() - start)


def read(text: str | Expr) -> Expr:
    """Return the expression that a text states, with derivatives and values at points carried out.

    Raises:
        InputError: it cannot be read, or contains a function that is not known.
    """
    if isinstance(text, Expr):
        return text
    if not isinstance(text, str):
        raise InputError("an expression is text such as integral(exp(-x**2), x, 0, oo)")
    e = worked_out(_in_any_spelling(text))
    for node in outermost(e):
        if node.op == "unknown" and node.args[0].args[0] not in (FACTORIAL, *ROUNDED):
            raise unknown_function_error(node.args[0].args[0])
    return e


def _in_any_spelling(text: str) -> Expr:
    """Read an expression in the strict grammar, or else as people type it, such as ``2n!``."""
    try:
        return as_written(plain(text))
    except InputError:
        again = spelled_expression(text)
        if again is None or again == text:
            raise
        return as_written(plain(again))


def constant(x: Exact, name: str) -> Expr:
    """Return an exact parameter as an expression.

    Raises:
        InputError: it is inexact, or contains variables.
    """
    if isinstance(x, Expr):
        return x
    if isinstance(x, str):
        try:
            return number(as_rational(x, name))
        except InputError:
            if not any(c.isalpha() for c in x) and not re.search(r"\d\s*[-+*/^)]", x):
                raise
        e = read(x)
        if symbols(e):
            raise InputError(f"{name}: {x} is not a number")
        return e
    return number(as_rational(x, name))


def placed(e: Expr, at: Mapping[str, Expr]) -> Expr:
    """Return an expression at values of all its variables.

    Raises:
        InputError: a variable has no value, or a value has no variable.
    """
    names = symbols(e) - {INFINITY.args[0]}
    missing = sorted(names - at.keys())
    if missing:
        raise InputError(f"give the value of {missing[0]}, such as {missing[0]}=1/10")
    found = rounded_numbers(substitute(e, at))
    if any(node.op == "coefficient" for node in outermost(found)):
        from tresym.asymptotics.exact_coefficients import with_values

        return with_values(found)
    return found


def certified(e: Expr, digits: int, smallest: int | None = None) -> arb:
    """Return a ball around a closed expression that proves ``digits`` digits; exactly 0 if it is.

    Args:
        e: the expression, without variables.
        digits: the number of significant digits.
        smallest: a value below 2 to the power of minus this is not told apart from 0; if it is not
            given, this depends on the digits.

    Raises:
        InputError: no value is proved to exist, or the value cannot be told apart from 0.
    """
    at_once = _of_numbers(e, digits)
    if at_once is not None:
        return at_once
    wanted, more, undefined = bits(digits, 8), 0, 0
    limit = SMALLEST * bits(digits) + 400 if smallest is None else smallest
    found: arb | None = None
    while more <= limit:
        with ball_precision(bits(digits, GUARD) + more):
            walker = certified_evaluation()
            try:
                found = walker.value(e)
            except DivergesError as error:
                raise InputError(str(error)) from None
            except UndefinedError:  # perhaps only because a divisor is not told apart from 0
                if undefined == AGAIN:
                    raise InputError(_without_value(e, walker)) from None
                undefined += 1
                more = min(max(3 * more, 2 * bits(digits, GUARD)), limit)
                continue
            if found.is_zero() or found.rel_accuracy_bits() >= wanted:
                return found
            lost = wanted - found.rel_accuracy_bits() if not found.contains(0) else 0
        if found.contains(0) and not more and is_zero(e, Given()):
            return arb(0)
        more += max(lost + 16, more, 64) if lost else max(2 * more, bits(digits, 64))
    assert found is not None
    if found.contains(0):
        raise InputError(
            f"the value could not be told apart from 0: it is at most {found.abs_upper().str(3)}"
        )
    raise InputError(f"only the digits {found.str(digits, radius=False)} of the value were proved")


def _of_numbers(e: Expr, digits: int) -> arb | None:
    """Return the value of a function of written numbers; None if it is none, or takes more bits."""
    row = TABLE.get(e.op)
    if row is None or any(arg.op != "number" for arg in e.args):
        return None
    enough = bits(digits, 8)
    try:
        with ball_precision(enough + GUARD - 8):
            found = row.ball(*[arb(arg.args[0]) for arg in e.args])
    except UndefinedError:
        return None
    return found if found.is_finite() and found.rel_accuracy_bits() >= enough else None


def _without_value(e: Expr, walker: InBalls) -> str:
    """Return why a closed expression has no proved value."""
    part = walker.broken if walker.broken.size > 1 else e
    if part.op == "root":
        return _about_root(part, walker)
    if part.op == "integral":
        return (
            f"no value of {part} is proved: the integrand must be defined between the ends, and "
            "the integral converge absolutely (cut it at a singularity inside)"
        )
    if part.op in ("sum", "product"):
        return f"no value of {part} is proved: no bound of its tail was found"
    if part.op in ("^", "log", "asin", "acos", "acosh", "atanh"):
        return f"{part} has no real value"
    return f"no value of {part} is proved to exist"


def _about_root(e: Expr, walker: InBalls) -> str:
    """Return what balls see of an equation that has not exactly one root between its ends."""
    (name,), body = opened(e)
    ends = e.args[1:]
    low, high = (
        arb((-1 if end == -INFINITY else 1) * 2**20)
        if end in (INFINITY, -INFINITY)
        else walker.value(end)
        for end in ends
    )
    inside = f"between {ends[0]} and {ends[1]}"
    inner = [low + (high - low) * fmpq(2 * n + 1, 2 * GRID) for n in range(GRID)]
    points = [low, *inner, high]
    signs = []
    for x in points:
        try:
            signs.append(side(certified_evaluation({name: x}).value(body)))
        except UndefinedError:
            signs.append(None)
    known = [s for s in signs if s]
    changes = sum(one != other for one, other in pairwise(known))
    if changes > 1:
        return f"{e}: there are at least {changes} zeros {inside}; give ends around one of them"
    if not known:
        return f"{e}: the function has no values {inside}"
    if not changes:
        return f"{e}: no zero was found {inside}; the function has one sign at {len(known)} points"
    return f"{e}: exactly one zero {inside} could not be proved"


def rounded(x: arb, digits: int) -> str:
    """Return a ball as a decimal with ``digits`` significant digits, correctly rounded.

    Where the ball contains a tie between two decimals, either of them is returned. Zeros before the
    decimal point are written only if they are digits of the number.

    Example:
        >>> rounded(arb(fmpq(2, 3)), 3)
        '0.667'
        >>> rounded(arb(1522756), 3)
        '1.52e6'
    """
    if x.is_zero():
        return "0"
    with ball_precision(bits(digits) + 128):
        low, high = x.lower().fmpq(), x.upper().fmpq()
        middle = x.mid().fmpq()
    one, other = (rounded_number(end, digits) for end in (low, high))
    return one if one == other else rounded_number(middle, digits)


def rounded_number(x: fmpq, digits: int) -> str:
    """Return a rational number rounded to ``digits`` significant digits, half away from zero."""
    if x == 0:
        return "0"
    size = abs(x)
    ratio = size if size >= 1 else 1 / size
    places = int((int(ratio.p) // int(ratio.q)).bit_length() * log10(2))  # off by one at most
    exponent = (places if size >= 1 else -places) - digits
    while True:
        ten = fmpq(10) ** abs(exponent)
        scaled = size / ten if exponent >= 0 else size * ten
        whole = fmpz((scaled + fmpq(1, 2)).floor())
        if whole >= fmpz(10) ** (digits - 1):
            if whole >= fmpz(10) ** digits:
                exponent += 1
                continue
            break
        exponent -= 1
    return plain_decimal(int(whole), exponent, negative=x < 0, exact=scaled == whole)


def plain_decimal(whole: int, exponent: int, negative: bool = False, exact: bool = True) -> str:
    """Return whole·10^exponent as decimal text, in scientific notation if it is far from 1.

    Where the number is rounded before its decimal point, the text is in scientific notation too:
    zeros that fill the places up to the point would look like digits of the number.

    Example:
        >>> plain_decimal(152, 4), plain_decimal(152, 4, exact=False)
        ('1520000', '1.52e6')
    """
    digits = str(fmpz(whole))
    point = len(digits) + exponent
    sign = "-" if negative else ""
    if 0 < point <= len(digits):
        rest = digits[point:]
        return sign + digits[:point] + (f".{rest}" if rest else "")
    if -4 < point <= 0:
        return f"{sign}0.{'0' * -point}{digits}"
    if exact and len(digits) < point <= 16:
        return sign + digits + "0" * (point - len(digits))
    return f"{sign}{digits[0]}{'.' if digits[1:] else ''}{digits[1:]}e{point - 1}"


def point_text(at: Mapping[str, Expr]) -> dict[str, str]:
    """Return exact parameters as text: fractions where they are rational."""
    return {
        name: fraction_text(x.args[0]) if x.op == "number" else str(x) for name, x in at.items()
    }
