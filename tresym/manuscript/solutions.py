r"""Check a solution against the equation that stands before it.

After ``\ddot{x} + \omega^2 x = 0`` the line ``x = A\cos\omega t`` is no definition: it is put into
the equation, and the residual is decided like any other claim. An expansion, ``x = 1 - \epsilon/2 +
O(\epsilon^2)`` after ``\epsilon x^3 + x^2 = 1``, becomes a claim about the root of the equation,
``x == 1 - epsilon/2 + O(epsilon**2) given epsilon*x**3 + x**2 == 1 as epsilon -> 0``, which the
lemmas on roots decide. If several roots remain, the one near the first term is meant.

A residual that does not vanish refutes the solution only if the solution contains all quantities of
the equation and its sentence calls it a solution: letters have other meanings elsewhere, and what
solves a part of a problem is often written with the same sign.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Sequence
from typing import NamedTuple

from tresym.manuscript.classification import CONSTANTS, NO_VARIABLES, Attempt
from tresym.manuscript.terms import base_of, unknown_in
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import elementary, outermost
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import ZERO, Expr, replaced, substitute, symbols
from tresym.reals.language.formula import Compared
from tresym.reals.normal.to_expression import normal_form
from tresym.reals.numbers.exact import InputError

_DERIVATIVE = re.compile(r"(?:d|partial)(\d?)[A-Za-z]\w*?_(?:d|partial)([A-Za-z]\w*?)\d?")
_PRIMES = re.compile(r"\w+?_prime(\d?)")
_VARIABLES = ("t", "x", "s", "z", "r", "theta", "tau", "xi")
"""Letters by which a function marked with primes is differentiated, the usual ones first."""
_AT_START = re.compile(r"[A-Za-z]+_?0")
"""Names of initial values."""
_CALLED = re.compile(
    r"\b(?:solutions?|solv\w+|roots?|satisf\w+|fulfil\w+|obeys?|exact(?:ly)?)\b", re.IGNORECASE
)
_ROUGH = re.compile(
    r"\b(?:approximat\w*|roughly|leading|order|outer|inner|trial|try|guess\w*|ansatz|suppose|assum\w+"
    r"|small|large|limit|neglect\w*|ignor\w*|particular case|special case|if|when|stationary)\b",
    re.IGNORECASE,
)


class Stated(NamedTuple):
    """An equality that may be an equation for some of its symbols.

    Attributes:
        line: where it stands.
        display, shown: its display and its text, by which it is found again.
        terms: the tokens of its sides.
        sides: its sides as they were read.
        names: its symbols and unknown functions; of derivatives the differentiated symbol.
    """

    line: int
    display: int
    shown: str
    terms: tuple[Sequence[str], Sequence[str]]
    sides: Compared
    names: frozenset[str]


class Value(NamedTuple):
    """An initial or boundary value: the symbol, the order of its derivative, the token of the
    point, the display, the tokens of the value, and the text."""

    name: str
    order: int
    point: str
    display: int
    value: Sequence[str]
    shown: str


class Solves(NamedTuple):
    """What a link solves.

    Attributes:
        display, shown: the equation's display and text.
        line: where the equation stands.
        complete: whether the solution has all quantities of the equation.
        called: whether its sentence calls it a solution, so that it is refuted if it is none.
        beside: claims that it takes the stated values, each with the text of the value.
        otherwise: status and reason if the equation turns out to be none, or is not decided.
    """

    display: int
    shown: str
    line: int
    complete: bool
    called: bool
    otherwise: tuple[str, str]
    beside: tuple[tuple[str, str], ...] = ()


def names_of(left: Expr, right: Expr) -> frozenset[str]:
    """Return the symbols and unknown functions of an equality, with the base of derivatives."""
    names = symbols(left) | symbols(right) | unknown_in(left, right)
    return frozenset(base_of(name) for name in names - NO_VARIABLES)


def equation_for(stated: Sequence[Stated], name: str) -> Stated | None:
    """Return the last equality that contains a symbol and may be an equation for it."""
    return next((one for one in reversed(stated) if name in one.names), None)


def residual(
    read: Callable[[Sequence[str]], Expr], equation: Stated, name: str, value: Expr
) -> Compared | None:
    """Return the equation with the solution put in, or None if it cannot be put in.

    Args:
        read: reads the tokens of a side, with the definition of the solution known.
        name, value: the solution.
    """
    lone = [str(side) for side in equation.sides[::2]]
    if name in lone and lone.count(name) == 1 and len(equation.names) > 1:
        other = equation.sides[2 if lone[0] == name else 0]
        if isinstance(other, Expr) and name not in symbols(other) | unknown_in(other):
            return None  # it defines the symbol, and is no equation for it
    try:
        sides = [read(term) for term in equation.terms]
        named = elementary(*sides) and name in symbols(sides[0]) | symbols(sides[1])
        if named and name not in symbols(normal_form(sides[0] - sides[1], Given())):
            return None  # it cancels, as y in x + y = 3 + y
        sides = [_with_derivatives(side, name, value) for side in sides]
        sides = [substitute(side, {name: value}) for side in sides]
    except (InputError, LookupError):
        return None
    left, right = sides
    if unknown_in(left, right) or name in symbols(left) | symbols(right):
        return None
    return left, "==", right


def _with_derivatives(e: Expr, name: str, value: Expr) -> Expr:
    """Return ``e`` with the derivatives of the symbol worked out.

    Raises:
        LookupError: the text does not say by which variable a derivative is meant.
    """
    put: dict[str, Expr] = {}
    for one in symbols(e):
        if one == name or base_of(one) != name:
            continue
        if (marked := _DERIVATIVE.fullmatch(one)) is not None:
            times, by = int(marked[1] or 1), marked[2]
        elif (marked := _PRIMES.fullmatch(one)) is not None:
            times = int(marked[1] or 1)
            by = next(iter(v for v in _VARIABLES if v in symbols(value)), "")
        else:
            raise LookupError(one)
        if by not in symbols(value) or not elementary(value):
            raise LookupError(one)  # its symbols may depend on the variable
        slope = value
        for _ in range(times):
            slope = differentiate(slope, by)
        put[one] = slope
    return substitute(e, put)


def at_points(
    equation: Stated,
    values: Sequence[Value],
    parameters: Sequence[str],
    solution: Expr,
    read: Callable[[Sequence[str]], Expr],
) -> Iterator[tuple[str, str]]:
    """Yield the claims that a solution takes stated values, each with the text of the value."""
    by = next(iter(parameters), "")
    for name in sorted(symbols(equation.sides[0]) | symbols(equation.sides[2])):
        if not by and (marked := _DERIVATIVE.fullmatch(name)) is not None:
            by = marked[2]
    by = by or next((v for v in _VARIABLES if v in symbols(solution)), "")
    if not by or not elementary(solution):
        return
    if any(
        CONSTANTS.fullmatch(name) for name in symbols(solution) - names_of(*equation.sides[::2])
    ):
        return  # the values determine the constants
    for one in values:
        if one.display != equation.display:
            continue  # it may be that of another part of the problem
        try:
            slope, point, value = solution, read([one.point]), read(one.value)
        except InputError:
            continue
        for _ in range(one.order):
            slope = differentiate(slope, by)
        if elementary(value) and not unknown_in(value):
            yield f"{substitute(slope, {by: point})} == {value}", " ".join(one.shown.split())


def is_complete(equation: Stated, name: str, value: Expr) -> bool:
    """Whether a solution has all quantities of its equation, and none but constants beside."""
    own = names_of(*equation.sides[::2]) - {name}
    inside = symbols(value) - NO_VARIABLES
    more = inside - own
    return own <= inside and all(
        CONSTANTS.fullmatch(one) or one in _VARIABLES or _AT_START.fullmatch(one) for one in more
    )


def is_called_solution(words: str) -> bool:
    """Whether the words around a formula call it an exact solution."""
    return bool(_CALLED.search(words)) and not _ROUGH.search(words)


def expansion_claims(
    equation: Stated, name: str, relation: str, value: Expr, path: str
) -> Iterator[Attempt]:
    """Yield claims about the root of an equation whose expansion is stated.

    The root is the only one, or the one near the first term of the expansion.
    """
    left, _, right = equation.sides
    variable, _, end = path.partition(" -> ")
    names = symbols(left) | symbols(right)
    if not elementary(left, right) or not {name, variable} <= names:
        return
    if any(base_of(one) != one for one in names) or name in symbols(value):
        return
    if any(one.partition("_")[0] in names - {one} for one in names if "_" in one):
        return  # Y_X beside Y is a derivative
    shown = f"{name} {relation} {value}"
    given = f"{left} == {right}"
    for more in ("", *_branches(name, value, variable, end)):
        for to in dict.fromkeys((path, f"{variable} -> 0+" if end == "0" else path)):
            under = f" given {given}{more} as {to}"
            yield Attempt(
                shown + under, "", shown, sides=(Expr("symbol", (name,)), relation, value)
            )


def _branches(name: str, value: Expr, variable: str, end: str) -> Iterator[str]:
    """Yield conditions by which the root near the first term is meant."""
    orders = {node: ZERO for node in outermost(value) if node.op in ("O", "o")}
    bare = replaced(value, orders)
    if end in ("oo", "-oo"):
        yield f", {name} > 1"
        return
    try:
        first = substitute(bare, {variable: ZERO})
    except (InputError, ZeroDivisionError):
        return
    if symbols(first) or first.op in ("O", "o"):
        return
    if first == ZERO:
        yield f", abs({name}) < 1/2"
        yield f", abs({name}) < 1/10"
        return
    yield f", abs({name} - ({first})) < abs({first})/2"
    yield f", abs({name} - ({first})) < abs({first})/8"
