"""How far an operand extends in print: arguments of functions, and of ``d/dx``.

An argument without brackets is the product that follows, up to the next function, sign, relation
or closing bracket: ``\\sin\\frac{1}{2}x`` is sin(x/2), ``\\sin n\\pi`` is sin(nπ). A bracket right
after the name is the whole argument, ``\\sin(x)y`` is sin(x)·y. ``d/dx`` takes the product that
follows. Where books differ the reach is in doubt, and the reader writes both readings out.
"""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import NamedTuple, TypeAlias

from tresym.reals.language.expression import Expr, multiply, symbols
from tresym.reals.language.expression import number as exact
from tresym.reals.numbers.exact import parse_number


class Piece(NamedTuple):
    """A tree, and how it stands in print.

    Attributes:
        tree: what it is.
        strength: how strongly it binds: 0 sum, 1 signed product, 2 product, 3 power, 4 atom.
        symbol: the name, or what a power is of; a bracket behind it can hold its argument.
        printed: the digits of a decimal, ``1e-2`` of a power of ten.
    """

    tree: Expr
    strength: int = 4
    symbol: str = ""
    printed: str = ""

    @property
    def names(self) -> frozenset[str]:
        """The variables in it."""
        return symbols(self.tree)


class Ahead(NamedTuple):
    """What comes next in a product.

    Attributes:
        kind: ``function``, ``inverse`` of one, ``derivative``, ``letter``, ``bracket``,
            ``fraction`` or ``other``, and nothing where the product ends.
        operator: ``*`` or ``/`` where one is written, else nothing.
        spaced: whether the author put a space before it.
    """

    kind: str
    operator: str = ""
    spaced: bool = False


class Reach(Enum):
    """Whether what comes next is part of the operand."""

    ENDS = "ends"
    GOES_ON = "goes on"
    DOUBT = "in doubt"


Rule: TypeAlias = Callable[[Piece, Ahead], Reach]


def after_open(so_far: Piece, ahead: Ahead) -> Reach:
    """An argument without brackets.

    A number, as in ``\\sin 2(x+y)``, takes whatever follows; once it holds a variable only letters
    are sure, because ``\\sin\\theta(1+x)`` is mostly a product and ``\\sin k(x-t)`` is not. Another
    function ends it, but ``\\sin 2\\ln x`` and ``\\cos n\\arccos x`` are in doubt.
    """
    applied = ahead.kind in ("function", "inverse")
    if ahead.kind in ("", "derivative") or (applied and ahead.operator):
        return Reach.ENDS
    if ahead.operator or ahead.kind == "inverse":
        return Reach.DOUBT
    if applied:
        number = not so_far.names and "pi" not in str(so_far.tree)
        return Reach.DOUBT if number else Reach.ENDS
    if ahead.spaced or (ahead.kind != "letter" and so_far.names):
        return Reach.DOUBT
    return Reach.GOES_ON


def after_bracket(inner: Piece, ahead: Ahead) -> Reach:
    """An argument in brackets: in doubt where it needs them as a factor too, ``\\sin(n+1)x``."""
    factor = ahead.kind in ("letter", "bracket", "fraction") and not ahead.operator
    return Reach.DOUBT if factor and inner.strength == 0 else Reach.ENDS


def whole(_: Piece, __: Ahead) -> Reach:
    """``\\exp(…)``, and SymPy's brackets in braces: the whole argument."""
    return Reach.ENDS


def after_derivative(_: Piece, ahead: Ahead) -> Reach:
    """What ``d/dx`` is applied to: the product, in doubt from a written sign or another d/dx on."""
    if not ahead.kind:
        return Reach.ENDS
    doubtful = ahead.operator or ahead.kind == "derivative"
    return Reach.DOUBT if doubtful else Reach.GOES_ON


def ends_before(*kinds: str) -> Rule:
    """A rule by which these end the operand, and whatever else follows is in doubt."""
    return lambda _, ahead: Reach.ENDS if ahead.kind in kinds else Reach.DOUBT


after_nested = ends_before("", "derivative")
"""An argument that is itself a function and what it is applied to: ``\\ln\\sin x\\cos x``."""
after_braces = ends_before("", "function", "derivative")
"""An argument in braces, which do not print, or in bars, which stay: ``\\sin{x}y``."""
after_derivative_of_bracket = ends_before("")
"""``\\frac{d}{dx}(…)``, and what follows the bracket."""


def joined(factors: list[Piece | None], operators: list[str]) -> Piece:
    """The product of ``factors``; differentials (None) are left out."""
    kept = [(f, op) for f, op in zip(factors, operators, strict=True) if f is not None]
    if len(kept) == 1:
        return kept[0][0]
    printed = ""
    if len(kept) == 2 and kept[1][1] == "*" and kept[1][0].printed.startswith("1e"):
        first = kept[0][0].printed
        printed = first + kept[1][0].printed[1:] if first and "e" not in first else ""
    tree = multiply(*(1 / f.tree if op == "/" else f.tree for f, op in kept))
    return Piece(tree, 4 if printed else 2, printed=printed)


def decimal(text: str) -> Piece:
    """A decimal as it is printed."""
    return Piece(exact(parse_number(text)), printed=text)
