"""Certified errors of an approximation at exact points, for the tables and charts of a file.

The claims of which there are errors are ``A == B + O(g)``, ``A ~ B`` and ``abs(A - B) <= C``. Each
number is a ball of as many digits as are asked for, from :func:`tresym.value`; the error is the
difference of the expressions and not of rounded numbers, so that it has as many true digits.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from decimal import Decimal as Rounded
from decimal import localcontext
from itertools import product
from typing import NamedTuple

from tresym.accuracy.values import value
from tresym.checking import check
from tresym.papers.reading import Drawn, PaperClaim, Value
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import worked_out
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.expression import Expr, number, power, substitute, symbols
from tresym.reals.language.formula import Compared, chained
from tresym.reals.language.paths import read_path
from tresym.reals.numbers.exact import Decimal, InputError, parse_number

FORMS = "A == B + O(g), A ~ B or abs(A - B) <= C"
STEPS = 6
"""The points of a chart whose claim states none: 10^(−k/2) from the end of the path."""
MOST_CELLS = 5000


class ErrorRow(NamedTuple):
    """The numbers at one point.

    Attributes:
        at: the values of the variables.
        exact, approx, error, relative: balls; error = exact − approx, relative to exact.
        ratio: the error over the comparison function of an order, or over the bound.
    """

    at: tuple[Value, ...]
    exact: Decimal
    approx: Decimal
    error: Decimal | None
    relative: Decimal | None
    ratio: Decimal | None


def sides_of(claim: PaperClaim) -> tuple[Expr, Expr, Expr | None]:
    """Return the exact side of a claim, the approximation, and what the error is compared with.

    Raises:
        InputError: the claim is of another form.
    """
    found = claim.asymptotic
    if found is None:
        raise InputError(f"{claim.label}: errors are shown for claims of the form {FORMS}")
    exact, approx, gauge = found
    return worked_out(exact), worked_out(approx), None if gauge is None else worked_out(gauge)


def error_rows(claim: PaperClaim, drawn: Drawn, skipping: bool = False) -> Iterator[ErrorRow]:
    """Yield the errors at the points of a table.

    Args:
        claim: the claim.
        drawn: the table or the chart.
        skipping: whether to leave out points without a value; one at least must have one.

    Raises:
        InputError: a variable has no value, a point violates a condition of the claim, or a number
            is not proved to exist.
    """
    exact, approx, gauge = sides_of(claim)
    found = 0
    points = points_of(claim, drawn)
    for n, point in enumerate(points, 1):
        values = dict(point)
        _need_conditions(claim, values)

        gap, digits = exact - approx, drawn.digits + 2
        try:
            yield ErrorRow(
                tuple(Value(name, x) for name, x in values.items()),
                value(substitute(exact, values), digits).ball,
                value(substitute(approx, values), digits).ball,
                _of_error(gap, values),
                _of_error(gap / exact, values),
                None if gauge is None else _of_error(gap / gauge, values),
            )
        except InputError as error:
            where = ", ".join(f"{name} == {x}" for name, x in values.items())
            if not skipping or (n == len(points) and not found):
                raise InputError(f"{claim.label} at {where}: {error}") from None
        else:
            found += 1


ERROR_DIGITS = 8
"""The digits of errors, of which a table shows fewer."""


def _of_error(e: Expr, values: Mapping[str, Expr]) -> Decimal | None:
    """The ball of an error; None for one that cannot be told apart from 0."""
    try:
        return value(substitute(e, values), ERROR_DIGITS).ball
    except InputError:
        return None


def points_of(claim: PaperClaim, drawn: Drawn) -> list[tuple[tuple[str, Expr], ...]]:
    """Return the points: every combination of the values that are stated.

    Raises:
        InputError: a variable has no value, a value is for no variable, or there are too many.
    """
    exact, approx, gauge = sides_of(claim)
    names = (
        symbols(exact) | symbols(approx) | (symbols(gauge) if gauge is not None else frozenset())
    )
    names -= {INFINITY.args[0]}
    given = dict(drawn.at)
    for name in given:
        if name not in names:
            raise InputError(f"{drawn.kind} {claim.label}: {name} is no variable of the claim")
    missing = sorted(names - given.keys())
    if missing:
        known = "; ".join(
            f"{name} == {missing_value}" for name, missing_value in _some(claim, missing)
        )
        raise InputError(
            f"{drawn.kind} {claim.label}: state values for {missing[0]}, as in at {known}"
        )
    ordered = sorted(given, key=lambda name: name != _variable(claim, drawn))
    several = [[(name, x) for x in given[name]] for name in reversed(ordered)]
    count = 1
    for values in several:
        count *= len(values)
    if count > MOST_CELLS:
        raise InputError(f"{drawn.kind} {claim.label}: {count} points are more than {MOST_CELLS}")
    return [tuple(point) for point in product(*several)]


def _names(claim: PaperClaim) -> frozenset[str]:
    """The variables of the two sides and of what the error is compared with."""
    exact, approx, gauge = sides_of(claim)
    found = symbols(exact) | symbols(approx) | (frozenset() if gauge is None else symbols(gauge))
    return found - {INFINITY.args[0]}


def _some(claim: PaperClaim, names: list[str]) -> Iterator[tuple[str, str]]:
    point = _given(claim).satisfying_point(names) or {}
    for name in names:
        yield name, str(number(point[name])) if name in point else "1"


def _given(claim: PaperClaim) -> Given:
    links = (*claim.conditions, *claim.near_end)
    return Given(tuple(link for link in links if link[1] not in ("==", "in"))).unfolded()


def _variable(claim: PaperClaim, drawn: Drawn) -> str:
    """The variable along which the error is followed."""
    if claim.path is not None:
        return read_path(claim.path).name
    return max(drawn.at, key=lambda pair: len(pair[1]))[0] if drawn.at else ""


def _need_conditions(claim: PaperClaim, values: Mapping[str, Expr]) -> None:
    """Every condition of the claim holds at the point."""
    links: tuple[Compared, ...] = (*claim.conditions, *claim.near_end)
    for left, relation, right in links:
        if relation == "in":
            x = values.get(str(left.args[0]))
            holds = x is None or (x.op == "number" and x.args[0].q == 1)
        else:
            put = substitute(left, values), relation, substitute(right, values)
            holds = bool(symbols(put[0]) | symbols(put[2])) or bool(check(chained((put,))))
        if not holds:
            where = ", ".join(f"{name} == {x}" for name, x in values.items())
            condition = chained(((left, relation, right),))
            raise InputError(f"{claim.label}: the condition {condition} does not hold at {where}")


def chart_points(claim: PaperClaim, drawn: Drawn, tables: tuple[Drawn, ...]) -> Drawn:
    """Return a chart with its points: as given, from a table of the same claim, or along the path.

    Raises:
        InputError: the claim has no path, and neither the chart nor a table states points.
    """
    exact, approx, gauge = sides_of(claim)
    names = (
        symbols(exact) | symbols(approx) | (symbols(gauge) if gauge is not None else frozenset())
    )
    names -= {INFINITY.args[0]}
    at = dict(drawn.at)
    for table in tables:
        at = dict(table.at) | at
    path = None if claim.path is None else read_path(claim.path)
    if path is not None and path.name not in dict(drawn.at):
        steps = [power(number(10), number(-k)) for k in range(1, STEPS + 1)]
        steps = [x / m for x in steps for m in (number(1), number(3))]
        if path.point is None:
            at[path.name] = tuple(1 / x * path.sides[0] for x in steps)
        else:
            at[path.name] = tuple(path.point + path.sides[0] * x for x in steps)
    elif path is None and not any(len(values) > 1 for values in at.values()):
        raise InputError(f"chart {claim.label}: state the points, as in at x == 1/10, 1/2, 1")
    for name, text in _some(claim, sorted(names - at.keys())):
        at[name] = (number(parse_number(text)),)
    return drawn._replace(at=tuple((n, values) for n, values in at.items() if n in names))


def rounded(ball: Decimal | None, digits: int) -> str:
    """Return a ball as text of so many digits, the last of which is right to within one unit."""
    if ball is None:
        return "not told apart from 0"
    if ball.mid == "0":
        return "0"
    with localcontext() as context:
        context.prec = digits
        x = +Rounded(ball.mid)
    exponent = x.adjusted()
    if -4 <= exponent < max(digits, 6):
        return f"{x:f}"
    return f"{x:e}".replace("e+", "e")
