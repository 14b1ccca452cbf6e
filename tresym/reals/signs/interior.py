"""Signs in the interior of the conditions, and by continuity at limits of interior points.

Closed conditions may hold at single points elsewhere, of which nothing is shown here.
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound
from tresym.reals.language.expression import LEAVES, UNWORKED, ZERO, Expr, replaced, symbols
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.structural import Parts

Ask = Callable[[Expr, str, Given], str | None]
"""A prover of a relation to zero under conditions: a sentence, or None."""
PROVING = {">": ("+",), ">=": ("+", ">=0", "0"), "!=": ("+", "-", "!=")}
"""The signs of a difference that prove its relation to zero."""
REMEMBERED = 4096
"""Signs kept: the same questions come back at every step of a chain, and of an expansion."""


@lru_cache(maxsize=REMEMBERED)
def sign_inside(e: Expr, given: Given) -> str | None:
    """The proven sign of ``e`` at the points where ``given`` holds that are limits from inside it.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"``, ``"<=0"``, or None where nothing is proved. The
        strict signs hold on closed ends too.
    """
    parts = Parts(given)
    found = parts.sign(e)
    if found in ("+", "-", "0"):
        return found
    found = _open_sign(e, given) or found
    if found in (">=0", "<=0") and parts.nonzero(e):
        return "+" if found == ">=0" else "-"
    return found


def strict_by_conditions(e: Expr, given: Given) -> bool:
    """Whether ``e`` is a strict condition and what is not negative inside, by the normal form."""
    return any(
        c.relation == ">"
        and symbols(c.expression) <= symbols(e)
        and bound(c.expression, ">")[0].op != "symbol"
        and _open_sign(e - c.expression, given) in (">=0", "0")
        for c in given.conditions
    )


def is_nonzero(e: Expr, given: Given) -> bool:
    """Whether ``e`` is shown to vanish nowhere under ``given``."""
    return sign_inside(e, given) in ("+", "-") or Parts(given).nonzero(e)


def is_zero(e: Expr, given: Given) -> bool:
    """Whether the normal form of ``e`` is 0."""
    try:
        return bool(Field(given).normal(e)[0].num.is_zero())
    except (TooLargeError, UndefinedError):
        return False


def jumps(expressions: Iterable[Expr], given: Given) -> list[Expr]:
    """The nodes ``sign u`` and ``atan2(y, x)`` in them that are not shown to be continuous.

    They jump where u is 0, and where y is 0 and x is negative; no other function does so where it
    is defined, and no product of sign u and what vanishes with u.
    """
    found: list[Expr] = []
    seen: set[Expr] = set()
    stack = list(expressions)
    while stack:
        node = stack.pop()
        if node in seen or node.op in LEAVES or node.op in UNWORKED:
            continue
        seen.add(node)
        for arg in node.args:
            calm = node.op == "*" and arg.op == "sign" and _vanishes_beside(arg, node.args)
            stack.append(arg.args[0] if calm else arg)
        if (
            node.op in ("sign", "atan2")
            and not is_nonzero(node.args[0], given)
            and sign_inside(node.args[0], given) != "0"
            and not (node.op == "atan2" and sign_inside(node.args[1], given) == "+")
        ):
            found.append(node)
    return found


def _vanishes_beside(node: Expr, factors: tuple[Expr, ...]) -> bool:
    """Whether one of the factors is continuous, and 0 where the argument of the node is."""
    known = {node.args[0]: ZERO, -node.args[0]: ZERO}
    return any(
        Parts(Given()).sign(rest) == "0" and not jumps((factor,), Given())
        for factor in factors
        if not symbols(rest := replaced(factor, known))
    )


def _open_sign(e: Expr, given: Given) -> str | None:
    """The sign on the open domain, which bounds the sign on its closure where ``e`` has no jump."""
    if jumps((e,), given):
        return None
    try:
        field = Field(given)
        (value,) = field.normal(e)
        if value.num.is_zero():
            return "0"
        num, den = (without_powers(field, p) for p in (value.num, value.den))
        found = _factored_sign(field, num) * _factored_sign(field, den)
    except (TooLargeError, UndefinedError):
        return None
    return {1: ">=0", -1: "<=0", 0: None}[found]


def without_powers(field: Field, p: Poly) -> Poly:
    """``p`` with each symbol that is positive, and whose root occurs, as a power of that root."""
    for position, order, _ in field.relations:
        generator = field.at(position)
        base = generator.data[0] if generator.kind == "root" else None
        if base is None or len(base) != 1 or base.total_degree() != 1 or field.sign(base) <= 0:
            continue
        (inner,) = field.used(base)
        if p.degrees()[inner] > 0 and p.degrees()[position] > 0:
            power = field.variables[position] ** order
            parts = field.split(p, inner)
            p = sum((part * power**k for k, part in parts.items()), field.zero_poly)
    return p


def _factored_sign(field: Field, p: Poly) -> int:
    """The sign of ``p`` where it is not zero, even factors left out; 0 if unknown."""
    found = field.sign(p)
    if found:
        return found
    content, parts = field.factor(p)
    total = 1 if content > 0 else -1
    for part, multiplicity in parts:
        if multiplicity % 2:
            total *= field.sign(part)
    return total


def by_signs_of_parts(
    difference: Expr, relation: str, given: Given, ask: Ask | None = None
) -> str | None:
    """Signs of parts: of terms, factors and arguments, with the ranges of functions and conditions.

    A sum is a polynomial in its parts: squares, conditions taken out of it, and the exact normal
    form tell its sign.

    Decides ``1 - b/(a + b)*cos(t)**2 > 0 given a > 0, b > 0``. Ends where two conditions
    must be multiplied with each other, or more than two be taken out.
    """
    found = sign_inside(difference, given)
    if found not in PROVING[relation]:
        apart = relation == "!=" and Parts(given).nonzero(difference)
        return "the difference vanishes nowhere by the signs of its parts" if apart else None
    return (
        f"the difference {_WORDS.get(found or '', 'is nowhere negative')} by the signs of its parts"
    )


_WORDS = {"+": "is positive", "-": "is negative", "0": "has normal form 0"}
