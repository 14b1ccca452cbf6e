"""Cover the points at which sign and atan2 jump, which a proof on a dense set does not reach.

``sign(u)`` jumps where u is 0, and ``atan2(y, x)`` where y is 0 and x is negative. All other
functions are continuous where they are defined. A claim that is proved at almost all points must
therefore be proved separately at each possible jump, in one of two ways. If the jump lies where a
variable has a certain value, or at a closed end of the conditions, that value is substituted.
Otherwise 0 is substituted for the argument that vanishes there, and the claim must hold for all
values of the variables. For example, ``sign(x)**2 == 1`` holds at almost all points and is false at
x = 0.
"""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from typing import NamedTuple

from flint import fmpq

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import denominators, singularities
from tresym.reals.functions.table import names
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    PI,
    ZERO,
    Expr,
    as_expr,
    number,
    replaced,
    sqrt,
    substitute,
    symbols,
)
from tresym.reals.normal.factors import factor_polynomial
from tresym.reals.normal.field import Field
from tresym.reals.normal.locally_constant import nonzero_inside
from tresym.reals.normal.polynomials import as_expression, terms_in_symbols
from tresym.reals.normal.ring import UndefinedError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.interior import PROVING, is_nonzero, jumps
from tresym.reals.signs.interior import sign_inside as sign

_ZERO_WITH_ARGUMENT = names(lambda row: row.vanishes_with_argument)


class Case(NamedTuple):
    """Describe the claim at one set of jumps.

    Attributes:
        known: the values substituted for subexpressions, such as 0 for u in ``sign(u)``.
        values: the values substituted for variables; empty if the variables are arbitrary.
        given: the remaining conditions.
    """

    known: dict[Expr, Expr]
    values: dict[str, Expr]
    given: Given

    def __str__(self) -> str:
        part, value = next(iter((self.values or self.known).items()))
        return f"where {part} = {value}"

    def of(self, e: Expr) -> Expr:
        """Return ``e`` with the known values substituted."""
        return substitute(replaced(e, self.known), self.values)

    def point(self, witness: Mapping[str, fmpq | Expr] | None) -> dict[str, fmpq] | None:
        """Return a rational point at the jump, or None if there is none.

        Args:
            witness: values of the remaining variables. If it is empty, such values are searched
                for. None means that there are none.
        """
        if not witness and witness is not None:
            others = frozenset().union(*map(symbols, self.values.values()))
            witness = self.given.satisfying_point(others)
        if witness is None or not self.values:
            return None
        at = {name: as_expr(value) for name, value in witness.items()}
        at |= {name: substitute(value, at) for name, value in self.values.items()}
        if any(value.op != "number" for value in at.values()):
            return None
        return {name: value.args[0] for name, value in at.items()}


def cases_at_jumps(sides: tuple[Expr, ...], given: Given) -> Iterator[Case | None]:
    """Yield cases that together cover all jumps of ``sides``; None for a jump not covered."""
    for node in jumps(sides, given):
        for known, values, where in _cases(node, given):
            left = _remaining(where, values)
            if left is None:
                yield None
            elif left is not EMPTY:
                case = Case(known, values, left)
                if not values and all(case.of(side) == side for side in sides):
                    yield None
                elif not _is_nowhere_defined([case.of(e) for e in sides], left):
                    yield case


def _cases(node: Expr, given: Given) -> Iterator[tuple[dict[Expr, Expr], dict[str, Expr], Given]]:
    """Yield the known values, values of variables and conditions at the jumps of one node."""
    parts = list(zeros(node.args[0], given))
    values = [value_at_zero(part) for part in parts]
    if None in values and nonzero_inside(_critical(node), given):
        for condition in given.conditions:
            if condition.relation == ">=":
                end = condition.expression
                yield {end: ZERO}, value_at_zero(end) or {}, given
        return
    for part, at in zip(parts, values, strict=True):
        known = {part: ZERO, -part: ZERO}
        if node.op == "sign":
            yield known, at or {}, given
            continue
        x = node.args[1]
        yield {**known, node: PI}, at or {}, given & Given(((x, "<", ZERO),))
        yield {**known, node: ZERO}, at or {}, given & Given(((x, ">", ZERO),))


EMPTY = Given(((ZERO, ">", ZERO),))
_EXCLUDING = {">": ("-", "0"), ">=": ("-",), "!=": ("0",)}
"""The signs of an expression that contradict each relation to zero."""


def _critical(node: Expr) -> Expr:
    """Return an expression that vanishes exactly at the jumps of a node."""
    if node.op == "sign":
        return node.args[0]
    y, x = node.args
    return sqrt(x**2 + y**2) + x


def zeros(e: Expr, given: Given) -> Iterator[Expr]:
    """Yield expressions at least one of which vanishes wherever ``e`` vanishes."""
    if is_nonzero(e, given):
        return
    if e.op == "*":
        for arg in e.args:
            yield from zeros(arg, given)
    elif e.op in _ZERO_WITH_ARGUMENT or (e.op == "^" and e.args[1].op == "number"):
        yield from zeros(e.args[0], given)
    else:
        factors = [part for part in _polynomials(e) if not is_nonzero(part, given)]
        yield from factors if all(map(value_at_zero, factors)) else [e]


def _polynomials(e: Expr) -> list[Expr]:
    """Return the factors of a continuous ``e`` that is a quotient of polynomials; else ``[e]``."""
    if value_at_zero(e) or jumps((e,), Given()):
        return [e]
    try:
        field = Field(Given())
        (value,) = field.normal(e)
        factors = [part for part, _ in factor_polynomial(field.ring, value.num)[1]]
    except (TooLargeError, UndefinedError):
        return [e]
    terms = [terms_in_symbols(field.ring, part) for part in (value.den, *factors)]
    if value.num.is_zero() or None in terms:
        return [e]
    return [
        sum((number(c) * as_expression(m) for m, c in (part or {}).items()), ZERO)
        for part in terms[1:]
    ]


def value_at_zero(e: Expr, fixed: Iterable[str] = ()) -> dict[str, Expr] | None:
    """Return the value of a variable at which ``e``, linear in it, vanishes; else None.

    Args:
        e: the expression.
        fixed: variables for which no value is wanted.
    """
    for name in sorted(symbols(e) - {*fixed}):
        slope = differentiate(e, name)
        if slope.op == "number" and slope != ZERO:
            return {name: substitute(e, {name: ZERO}) / -slope}
    return None


def _remaining(given: Given, values: dict[str, Expr]) -> Given | None:
    """Return the conditions at ``values``: ``EMPTY`` if one fails, None if that is not decided."""
    kept = []
    for left, relation, right in given.comparisons:
        comparison = substitute(left, values), relation, substitute(right, values)
        (condition,) = Given((comparison,)).conditions
        e = condition.expression
        constant_sign = None if singularities(e) and symbols(e) else sign(e, Given())
        if constant_sign in PROVING[condition.relation]:
            continue
        if constant_sign in _EXCLUDING[condition.relation]:
            return EMPTY
        if not symbols(e):
            return None
        kept.append(comparison)
    remaining = Given(tuple(kept))
    beyond = values and any(c.relation == ">=" for c in remaining.beyond_box)
    return None if beyond else remaining  # isolated points may satisfy those


def _is_nowhere_defined(sides: list[Expr], given: Given) -> bool:
    """Return whether a denominator always vanishes or an operand is always outside its domain."""
    return any(
        any(sign(part, given) == "0" for part in denominators(side))
        or any(positive and sign(part, given) == "-" for part, positive in singularities(side))
        for side in sides
    )
