r"""Operators that bind a variable: integrals, sums, products, limits and roots in every notation.

``\int_0^1 x\,dx``, ``∫_0^1 x dx``, ``Integrate[x, {x, 0, 1}]`` and ``integral(x, x, 0, 1)`` are
the integral of x over the ``Range("x", (0, 1))``. A reader finds the parts, each in its notation;
what the operators are called, how many ends they have and what they build is here.

Example:
    >>> from tresym.reals.language.expression import ONE, ZERO, symbol
    >>> str(applied("integral", Range("x", (ZERO, ONE)), symbol("x")))
    'integral(x, x, 0, 1)'
    >>> written("integral", Range("x", ("0", "1")), "x")
    'integral(x, x, 0, 1)'
"""

from __future__ import annotations

from typing import Generic, NamedTuple, TypeVar

from tresym.reals.language.binders import antiderivative, coefficient, integral, limit, root, total
from tresym.reals.language.expression import Expr

T = TypeVar("T")

COMMANDS = {"\\int": "integral", "\\sum": "sum", "\\prod": "product", "\\lim": "limit"}
"""What LaTeX writes for an operator."""
SIGNS = {"∫": "integral", "∑": "sum", "∏": "product"}
WORDS = SIGNS | {
    **dict.fromkeys(("int", "Int", "integral", "integrate", "Integral", "Integrate"), "integral"),
    **dict.fromkeys(("sum", "Sum", "summation"), "sum"),
    **dict.fromkeys(("prod", "product", "Product"), "product"),
    **dict.fromkeys(("lim", "limit", "Limit"), "limit"),
}
"""What people type for an operator, by hand and in SymPy, Mathematica and Maple."""
CALLED = {name: name for name in ("integral", "sum", "product", "limit", "root", "coefficient")} | {
    "prod": "product"
}
"""Names of an operator in the strict grammar."""
ENDS = {
    **{"integral": (0, 2), "sum": (2,), "product": (2,)},
    **{"limit": (1,), "root": (2,), "coefficient": (1,)},
}
"""How many ends an operator can have: none of an integral leaves it indefinite."""


class Range(NamedTuple, Generic[T]):
    """What an operator binds.

    Attributes:
        name: the variable.
        ends: its first and its last value, or the point of a limit.
        side: from which side a limit comes: from above, 1, from below, −1.
    """

    name: str
    ends: tuple[T, ...] = ()
    side: str = ""


def is_complete(kind: str, bound: Range[T]) -> bool:
    """Return whether the range has the ends that this operator needs."""
    return len(bound.ends) in ENDS[kind]


def applied(kind: str, bound: Range[Expr], body: Expr) -> Expr:
    """Return the tree of the operator on ``body``, in which the variable is bound."""
    name, ends, side = bound
    match kind:
        case "integral":
            return integral(body, name, *ends) if ends else antiderivative(body, name)
        case "limit":
            return limit(body, name, ends[0], int(side or "0"))
        case "coefficient":
            return coefficient(body, name, ends[0])
        case "root":
            return root(body, name, *ends)
    return total(kind, body, name, *ends)


def written(kind: str, bound: Range[str], body: str) -> str:
    """Return the operator on ``body`` in the strict grammar."""
    name, ends, side = bound
    return f"{kind}({', '.join((body, name, *ends, *filter(None, (side,))))})"
