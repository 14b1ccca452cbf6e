"""Prove signs in the interior of the conditions, and by continuity at limits of interior points.

For example, x·(x − y) for x > y > 0 is a product of a positive symbol and a condition. The normal
form of :mod:`tresym.reals.normal.field` is factored, and the sign of each factor is proved from the
ranges of its generators.

Closed conditions may also hold at isolated points, for which nothing is proved here (see
:mod:`tresym.reals.signs.closure`).
"""

from __future__ import annotations

from collections.abc import Callable, Iterable
from functools import lru_cache

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.operation_domains import bound
from tresym.reals.language.expression import LEAVES, UNWORKED, ZERO, Expr, replaced, symbols
from tresym.reals.normal.factors import factor_polynomial
from tresym.reals.normal.field import Field
from tresym.reals.normal.ring import Poly, UndefinedError
from tresym.reals.numbers.factoring import TooLargeError
from tresym.reals.signs.structural import Parts, signs_of_parts, signs_seen

Ask = Callable[[Expr, str, Given], str | None]
"""A prover of a relation to zero under conditions. It returns a sentence, or None."""
PROVING = {">": ("+",), ">=": ("+", ">=0", "0"), "!=": ("+", "-", "!=")}
"""The signs of a difference that prove its relation to zero."""
SIZES = (10, 24)
"""The numbers of generators of the rings in which a normal form is computed."""
REMEMBERED = 4096
"""The number of cached signs: each step of a chain or expansion asks for the same signs again."""


@lru_cache(maxsize=REMEMBERED)
def sign_inside(e: Expr, given: Given) -> str | None:
    """Return the proven sign of ``e`` in the interior of ``given`` and at limits of interior
    points.

    Args:
        e: the expression.
        given: the conditions.

    Returns:
        ``"+"``, ``"-"``, ``"0"``, ``">=0"``, ``"<=0"``, or None if nothing is proved. The strict
            signs also hold at closed ends.
    """
    parts = signs_of_parts(e, given)
    sign = parts.sign
    if sign in ("+", "-", "0") or (sign is None and len(signs_seen(e, given)) > 1):
        return sign
    sign = _open_sign(e, given) or sign
    if sign in (">=0", "<=0") and parts.nonzero:
        return "+" if sign == ">=0" else "-"
    return sign


def strict_by_conditions(e: Expr, given: Given) -> bool:
    """Return whether ``e`` is a strict condition plus a part not negative in the interior."""
    return any(
        c.relation == ">"
        and symbols(c.expression) <= symbols(e)
        and bound(c.expression, ">")[0].op != "symbol"
        and _open_sign(e - c.expression, given) in (">=0", "0")
        for c in given.conditions
    )


def is_nonzero(e: Expr, given: Given) -> bool:
    """Return whether ``e`` is shown to vanish nowhere under ``given``."""
    return sign_inside(e, given) in ("+", "-") or signs_of_parts(e, given).nonzero


def is_zero(e: Expr, given: Given) -> bool:
    """Return whether the normal form of ``e`` is 0."""
    try:
        return bool(Field(given).normal(e)[0].num.is_zero())
    except (TooLargeError, UndefinedError):
        return False


def jumps(expressions: Iterable[Expr], given: Given) -> list[Expr]:
    """Return the nodes ``sign(u)`` and ``atan2(y, x)`` that are not shown to be continuous.

    They jump where u is 0, and where y is 0 and x is negative. Every other function is continuous
    where it is defined, and so is the product of ``sign(u)`` and a continuous factor that vanishes
    with u.

    Args:
        expressions: the expressions that are searched.
        given: the conditions.
    """
    nodes: list[Expr] = []
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
            nodes.append(node)
    return nodes


def _vanishes_beside(node: Expr, factors: tuple[Expr, ...]) -> bool:
    """Return whether some factor is continuous and is 0 wherever the node's argument is 0."""
    known = {node.args[0]: ZERO, -node.args[0]: ZERO}
    return any(
        Parts(Given()).sign(rest) == "0" and not jumps((factor,), Given())
        for factor in factors
        if not symbols(rest := replaced(factor, known))
    )


def _open_sign(e: Expr, given: Given) -> str | None:
    """Return the sign of ``e`` on the open domain, if ``e`` has no jump there.

    As ``e`` is then continuous, its sign extends to the closure as a non-strict one.
    """
    if jumps((e,), given):
        return None
    found = None
    for size in SIZES:  # operations take less time in a small ring
        field = Field(given, size=size)
        found = _in_field(e, field)
        if not field.ring.full:
            break
    return found


def _in_field(e: Expr, field: Field) -> str | None:
    """Return the sign of the factors of the normal form of ``e``."""
    try:
        (value,) = field.normal(e)
        if value.num.is_zero():
            return "0"
        num, den = (without_powers(field, p) for p in (value.num, value.den))
        number = _factored_sign(field, num) * _factored_sign(field, den)
    except (TooLargeError, UndefinedError):
        return None
    return {1: ">=0", -1: "<=0", 0: None}[number]


def without_powers(field: Field, p: Poly, other: Poly | None = None) -> Poly:
    """Replace each positive symbol whose root occurs in ``p``, or in ``other``, by its power."""
    degrees = (p if other is None else other).degrees()
    for position, order, _ in field.ring.relations:
        generator = field.ring.at(position)
        base = generator.data[0] if generator.kind == "root" else None
        if (
            base is None
            or len(base) != 1
            or base.total_degree() != 1
            or field.signs.sign(base) <= 0
        ):
            continue
        (inner,) = field.ring.used(base)
        if p.degrees()[inner] > 0 and degrees[position] > 0:
            power = field.ring.variables[position] ** order
            parts = field.ring.split(p, inner)
            p = sum((part * power**k for k, part in parts.items()), field.ring.zero_poly)
    return p


def _factored_sign(field: Field, p: Poly) -> int:
    """Return the sign of ``p`` where it is not zero, from its odd factors; 0 if unknown."""
    its_sign = field.signs.sign(p)
    if its_sign:
        return its_sign
    content, parts = factor_polynomial(field.ring, p)
    total = 1 if content > 0 else -1
    for part, multiplicity in parts:
        if multiplicity % 2:
            total *= field.signs.sign(part)
    return total


def by_signs_of_parts(
    difference: Expr, relation: str, given: Given, ask: Ask | None = None
) -> str | None:
    """Signs of parts: the signs of terms, factors and arguments and the ranges of functions combine
    to a sign of the whole.

    A sum is a polynomial in its parts. Its sign follows from squares, from multiples of conditions
    that are subtracted, and from the exact normal form.

    Decides ``1 - b/(a + b)*cos(t)**2 > 0 given a > 0, b > 0``.

    Limits: it fails where two conditions must be multiplied with each other, or more than two
    conditions must be subtracted.

    Args:
        difference: the expression that is compared with zero.
        relation: ``">"``, ``">="`` or ``"!="``.
        given: the conditions.
        ask: not used; every method has the same signature.

    Returns:
        A sentence that states the proof, or None.
    """
    known = sign_inside(difference, given)
    if known not in PROVING[relation]:
        apart = relation == "!=" and signs_of_parts(difference, given).nonzero
        return "the difference vanishes nowhere by the signs of its parts" if apart else None
    return (
        f"the difference {_WORDS.get(known or '', 'is nowhere negative')} by the signs of its parts"
    )


_WORDS = {"+": "is positive", "-": "is negative", "0": "has normal form 0"}
