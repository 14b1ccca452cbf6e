"""Whose formula it is: what an author's letters mean, where print alone does not tell.

``V(2r)`` is the value of a function V for an author who has one; of anybody else it is refused,
because it may be a product as well.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from tresym.reals.language.binders import repeated_derivative
from tresym.reals.language.expression import Expr, symbols


@dataclass(frozen=True)
class Function:
    """A function that an author defines: its parameters, and its value."""

    parameters: tuple[str, ...]
    body: Expr


@dataclass(frozen=True)
class Author:
    """Somebody whose claims are compared with what is read, and whose symbols are any quantities.

    ``f(x)``, ``dy/dx``, ``\\dot x`` and the word "hot" are symbols for him, and of two readings the
    shorter one is taken, where he does not ask that both are told.

    Attributes:
        functions: those that he defines, by name; without parameters, a symbol that stands for a
            value.
        variable: that of a bracket with limits, where print does not tell.
        strict: what can be read in two ways is refused, as for anybody else, and f is left unknown
            in ``f(x)`` where it is not defined.
        shorter: how far an argument goes is no question: the shorter reading is meant, and V(x) is
            a product.
        longer: the longer reading is meant, of ``\\sin^{-1}`` the inverse function, and V(x) is the
            value of a function V.
        letter_e: ``e`` is a variable of his, and no number.
        letter_delta: ``\\Delta`` is a symbol of his, by itself.
        called: names of functions of his, some of which may be unknown.
        applied: names that stand before an argument in brackets elsewhere.
        bare: names that stand without a bracket elsewhere.
        numbers: names that are said to be numbers.
        sequences: letters whose subscripts number terms: ``a_k`` is a(k).
        inverses: ``\\sin^{-1}`` is the inverse function, as words of his say.
        imaginary: ``i`` is read as a symbol, which stands for the imaginary unit.
    """

    functions: Mapping[str, Function] = field(default_factory=dict)
    variable: str = ""
    strict: bool = False
    shorter: bool = False
    longer: bool = False
    letter_e: bool = False
    letter_delta: bool = False
    called: frozenset[str] = frozenset()
    applied: frozenset[str] = frozenset()
    bare: frozenset[str] = frozenset()
    numbers: frozenset[str] = frozenset()
    sequences: frozenset[str] = frozenset()
    inverses: bool = False
    imaginary: bool = False

    def derivative(self, name: str, by: str, times: int) -> Expr | None:
        """The derivative of one of his functions, ``by`` its variable if that is not named."""
        known = self.functions.get(name)
        if known is None or not self.strict:
            return None
        by = by or (known.parameters[0] if len(known.parameters) == 1 else "")
        if by not in symbols(known.body) and by not in known.parameters:
            return None
        return repeated_derivative(known.body, by, times)
