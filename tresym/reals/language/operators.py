r"""Operators that bind a variable: integrals, sums, products, limits and roots in every notation.

``\int_0^1 x\,dx``, ``∫_0^1 x dx``, ``Integrate[x, {x, 0, 1}]`` and ``integral(x, x, 0, 1)`` are
``Operator("integral", "x", (0, 1))`` applied to x. A reader finds the parts, each in its notation;
what the operators are called, how many ends they have and what they build is here.

Example:
    >>> from tresym.reals.language.expression import ONE, ZERO, symbol
    >>> str(applied(Operator("integral", "x", (ZERO, ONE)), symbol("x")))
    'integral(x, x, 0, 1)'
    >>> written(Operator("integral", "x", ("0", "1")), "x")
    'integral(x, x, 0, 1)'
"""

from __future__ import annotations

from typing import Generic, NamedTuple, TypeVar

from tresym.reals.language.binders import antiderivative, integral, limit, root, total
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
CALLED = {name: name for name in ("integral", "sum", "product", "limit", "root")} | {
    "prod": "product"
}
"""Names of an operator in the strict grammar."""
ENDS = {"integral": (0, 2), "sum": (2,), "product": (2,), "limit": (1,), "root": (2,)}
"""How many ends an operator can have: none of an integral leaves it indefinite."""


class Operator(NamedTuple, Generic[T]):
    """An operator without its body.

    Attributes:
        kind: a key of ``ENDS``; empty where only a range is written, as in ``{x, 0, 1}``.
        name: the variable that is bound.
        ends: the first and the last value, or the point of a limit.
        side: from which side a limit comes: from above, 1, from below, −1.
    """

    kind: str
    name: str
    ends: tuple[T, ...] = ()
    side: str = ""

    @property
    def complete(self) -> bool:
        """Whether it has the ends that it needs."""
        return len(self.ends) in ENDS[self.kind]


def applied(operator: Operator[Expr], body: Expr) -> Expr:
    """Return the tree of the operator on ``body``, in which its variable is bound."""
    kind, name, ends, side = operator
    match kind:
        case "integral":
            return integral(body, name, *ends) if ends else antiderivative(body, name)
        case "limit":
            return limit(body, name, ends[0], int(side or "0"))
        case "root":
            return root(body, name, *ends)
    return total(kind, body, name, *ends)


def written(operator: Operator[str], body: str) -> str:
    """Return the operator on ``body`` in the strict grammar."""
    kind, name, ends, side = operator
    return f"{kind}({', '.join((body, name, *ends, *filter(None, (side,))))})"
