"""How far an operand goes in print: the argument of a function, and what ``d/dx`` is applied to.

An argument without brackets is the product that follows, up to the next function, sign, relation
or closing bracket: ``\\sin\\frac{1}{2}x`` is sin(x/2), ``\\sin n\\pi`` is sin(nπ). A bracket right
after the name is the whole argument, ``\\sin(x)y`` is sin(x)·y. ``d/dx`` takes the product that
follows. Where books differ the reach is in doubt, and the reader writes both readings out.

The texts that are joined here are of the grammar of :mod:`tresym.reals.language.parsing`.
"""

from __future__ import annotations

import re
from enum import Enum
from typing import NamedTuple

from tresym.reals.language.latex_tokens import FUNCTIONS


class Piece(NamedTuple):
    """Text and how strongly it binds: 0 sum, 1 signed product, 2 product, 3 power, 4 atom.

    ``symbol`` marks a name or a power of one; a bracket behind it can hold its argument.
    """

    text: str
    strength: int = 4
    symbol: bool = False

    def within(self, strength: int) -> str:
        """The text, in parentheses where what surrounds it binds more strongly."""
        return self.text if self.strength >= strength else f"({self.text})"

    @property
    def names(self) -> set[str]:
        """The variables in it."""
        return set(_NAME.findall(self.text)) - {"pi", "E"}


_NAME = re.compile(r"(?<![\w.])[A-Za-z_]\w*(?![\w(])")


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


def after_open(so_far: Piece, ahead: Ahead) -> Reach:
    """An argument without brackets.

    A number, as in ``\\sin 2(x+y)``, takes whatever follows; once it holds a variable only letters
    are sure, because ``\\sin\\theta(1+x)`` is mostly a product and ``\\sin k(x-t)`` is not. Another
    function ends it, but ``\\sin 2\\ln x`` and ``\\cos n\\arccos x`` are in doubt.
    """
    function = re.match(r"(\w+)\(", so_far.text)
    nested = function is not None and function[1] in FUNCTIONS.values()
    applied = ahead.kind in ("function", "inverse")
    if ahead.kind in ("", "derivative") or (applied and ahead.operator and not nested):
        return Reach.ENDS
    if ahead.operator or nested or ahead.kind == "inverse":
        return Reach.DOUBT
    if applied:
        number = not so_far.names and "pi" not in so_far.text
        return Reach.DOUBT if number else Reach.ENDS
    if ahead.spaced or (ahead.kind != "letter" and so_far.names):
        return Reach.DOUBT
    return Reach.GOES_ON


def after_bracket(inner: Piece, ahead: Ahead) -> Reach:
    """An argument in brackets: in doubt where it needs them as a factor too, ``\\sin(n+1)x``."""
    factor = ahead.kind in ("letter", "bracket", "fraction") and not ahead.operator
    return Reach.DOUBT if factor and inner.strength == 0 else Reach.ENDS


def after_braces(_: Piece, ahead: Ahead) -> Reach:
    """An argument in braces, which do not print, or in bars, which stay: ``\\sin{x}y``."""
    return Reach.ENDS if ahead.kind in ("", "function", "derivative") else Reach.DOUBT


def whole(_: Piece, __: Ahead) -> Reach:
    """``\\exp(…)``, and SymPy's brackets in braces: the whole argument."""
    return Reach.ENDS


def after_derivative(_: Piece, ahead: Ahead) -> Reach:
    """What ``d/dx`` is applied to: the product, in doubt from a written sign or another d/dx on."""
    if not ahead.kind:
        return Reach.ENDS
    doubtful = ahead.operator or ahead.kind == "derivative"
    return Reach.DOUBT if doubtful else Reach.GOES_ON


def after_derivative_of_bracket(_: Piece, ahead: Ahead) -> Reach:
    """``\\frac{d}{dx}(…)``, and what follows the bracket."""
    return Reach.DOUBT if ahead.kind else Reach.ENDS


def joined(factors: list[Piece | None], operators: list[str]) -> Piece:
    """The product of ``factors``; differentials (None) are left out."""
    kept = [(f, op) for f, op in zip(factors, operators, strict=True) if f is not None]
    if not kept:
        return Piece("1")
    kept = _with_decimals(kept)
    if len(kept) == 1:
        return kept[0][0]
    return Piece(kept[0][0].within(2) + "".join(op + f.within(3) for f, op in kept[1:]), 2)


def _with_decimals(factors: list[tuple[Piece, str]]) -> list[tuple[Piece, str]]:
    """``1.09`` times ``10**(-2)`` is the decimal ``1.09e-2``: a printed number keeps its digits."""
    result = factors[:1]
    for factor, operator in factors[1:]:
        last, before = result[-1]
        power = re.fullmatch(r"10\*\*\(?(-?\d+)\)?", factor.text)
        if power and operator == "*" and before != "/" and re.fullmatch(r"\d+(\.\d+)?", last.text):
            result[-1] = Piece(f"{last.text}e{power[1]}"), before
        else:
            result.append((factor, operator))
    return result
