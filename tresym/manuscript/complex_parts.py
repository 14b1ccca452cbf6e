r"""Equalities of complex numbers as two of real ones: of the real and of the imaginary parts.

``(2 + i)^2 = 3 + 4i`` says 3 = 3 and 4 = 4, and ``e^{it} = \cos t + i \sin t`` that both cosines
and both sines are equal. All letters but i stand for real numbers here, as everywhere; a text that
calls one of them complex leaves what contains it unread. That i is the imaginary unit must be seen
in the formula itself: it is also an index, or a current. ``\Re(2 + i)`` and ``\Im e^{it}`` are put
in as the parts of their arguments.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from itertools import pairwise
from typing import NamedTuple

from tresym.manuscript.symbols import OPENING, group_end
from tresym.manuscript.terms import read_term, unknown_in
from tresym.reals.language.binders import elementary
from tresym.reals.language.expression import (
    LEAVES,
    ONE,
    ZERO,
    Expr,
    apply,
    bind,
    opened,
    sqrt,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.latex_author import Author
from tresym.reals.numbers.exact import InputError

UNIT = "i"
NUMBERED = 7101
"""The first subscript of the new symbols for parts of arguments."""
HIGHEST = 8
"""The highest power that is multiplied out."""
_LINEAR = frozenset(("integral", "antiderivative", "derivative", "sum"))
_SIGNS = frozenset(("+", "-", "\\pm", "\\mp"))


class Parts(NamedTuple):
    """The real and the imaginary part of a complex number."""

    re: Expr
    im: Expr


def is_imaginary(tokens: Sequence[str]) -> bool:
    """Whether a formula shows i to be the imaginary unit: e^{it}, 2 + 3i, i sin t, i^2."""
    if any(pair in (("_", UNIT), (UNIT, "_")) for pair in pairwise(tokens)):
        return False
    places = [n for n, token in enumerate(tokens) if token == UNIT]
    below = any(_is_below(tokens, n) for n in places)
    asked = bool(places) and not {"\\Re", "\\Im"}.isdisjoint(tokens)
    return not below and (asked or any(_shows(tokens, n) for n in places))


def _is_below(tokens: Sequence[str], n: int) -> bool:
    """Whether a token stands in a subscript."""
    depth = 0
    for k in range(n - 1, 0, -1):
        depth += (tokens[k] == "}") - (tokens[k] == "{")
        if depth < 0:
            return tokens[k - 1] == "_"
    return False


def _shows(tokens: Sequence[str], n: int) -> bool:
    before = tokens[n - 1] if n else ""
    after = tokens[n + 1] if n + 1 < len(tokens) else ""
    if before in ("^", "="):
        return False
    exponent = _exponent_of_e(tokens, n) and (before, after) != ("{", "}")  # e^i may be a vector
    joined = before in _SIGNS and (after.startswith("\\s") or after.startswith("\\c"))
    closes = after in ("", "+", "-", ")", "}", "=", ",", ".", "|", "\\right)", "\\right|")
    first = n > 2 and tokens[n - 2] in _SIGNS and tokens[n - 3][:1].isdigit()
    counted = before[:1].isdigit() and closes and first  # 3 + 4i, but not 2i + 1
    added = before in _SIGNS and closes and n > 1 and tokens[n - 2][:1].isdigit()
    return exponent or joined or counted or added


def _exponent_of_e(tokens: Sequence[str], n: int) -> bool:
    """Whether a token stands in the exponent of e, or in the argument of exp."""
    depth = 0
    for k in range(n - 1, 0, -1):
        depth += (tokens[k] in ("}", ")")) - (tokens[k] in ("{", "("))
        if depth < 0:
            if tokens[k] == "{" and tokens[k - 1] == "^" and k > 1:
                return tokens[k - 2] == "e"
            if tokens[k - 1] == "\\exp":
                return True
            depth = 0
    return False


def parts_of(term: Sequence[str], author: Author) -> Parts | None:
    """Return the parts of a term as tokens; None if it cannot be read or taken apart."""
    try:
        plain, put = _with_parts_put_in(list(term), author)
        tree = read_term(plain, replace(author, imaginary=True)).tree
        return _parts(substitute(tree, put) if put else tree)
    except (InputError, ZeroDivisionError):
        return None


def _with_parts_put_in(term: list[str], author: Author) -> tuple[list[str], dict[str, Expr]]:
    r"""Return a term with new symbols for ``\Re(...)`` and ``\Im(...)``, and what these are.

    Raises:
        InputError: an argument is not taken apart, or it is not clear where it ends.
    """
    put: dict[str, Expr] = {}
    while True:
        at = max((n for n, token in enumerate(term) if token in ("\\Re", "\\Im")), default=-1)
        if at < 0:
            return term, put
        end = _end_of_argument(term, at + 1)
        inner = term[at + 1 : end]
        if {"z", "w"} & {*inner}:
            raise InputError("z and w usually stand for complex numbers")
        if inner[:1] == ["\\{"]:
            inner = ["(", *inner[1:-1], ")"]
        tree = read_term(inner, replace(author, imaginary=True)).tree
        parts = _parts(substitute(tree, put) if put else tree)
        if parts is None:
            raise InputError("the argument of a real or imaginary part is not taken apart")
        new = ["Q", "_", "{", str(NUMBERED + len(put)), "}"]
        (name,) = symbols(read_term(new, author).tree)
        put[name] = parts[term[at] == "\\Im"]
        term = [*term[:at], "(", *new, ")", *term[end:]]


def _end_of_argument(term: Sequence[str], at: int) -> int:
    """Return where the argument that begins at a token ends: a bracket, or one factor alone."""
    first = term[at] if at < len(term) else ""
    if first in (*OPENING, "{"):
        return group_end(term, at) + 1
    end = at + 1
    if first in ("\\frac", "\\dfrac", "\\tfrac"):
        end = group_end(term, group_end(term, at + 1) + 1) + 1
    while term[end : end + 1] in (["^"], ["_"]):
        braced = term[end + 1 : end + 2] == ["{"]
        end = group_end(term, end + 1) + 1 if braced else end + 2
    if not first or (end < len(term) and term[end] not in ("+", "-", ")", "}", "]")):
        raise InputError("it is not clear where the argument of a real part ends")
    return end


def _parts(e: Expr) -> Parts | None:
    if unknown_in(e):
        return None  # which may have complex values
    if UNIT not in symbols(e):
        return Parts(e, ZERO)
    if e == symbol(UNIT):
        return Parts(ZERO, ONE)
    if e.op in _LINEAR:
        return _of_body(e)
    if e.op in LEAVES or (e.hidden and not elementary(e) and e.op not in ("+", "*", "^")):
        return None
    if e.op == "^":
        return _power(*e.args)
    found = [_parts(arg) for arg in e.args]
    inner = [one for one in found if one is not None]
    if len(inner) != len(found):
        return None
    if e.op == "+":
        re, im = ZERO, ZERO
        for one in inner:
            re, im = _plus(re, one.re), _plus(im, one.im)
        return Parts(re, im)
    if e.op == "*":
        product = Parts(ONE, ZERO)
        for one in inner:
            product = _times(product, one)
        return product
    (z,) = inner if len(inner) == 1 else (None,)
    return _function(e.op, z) if z is not None else None


def _function(name: str, z: Parts) -> Parts | None:
    """Return the parts of a function of one variable."""
    a, b = z
    if name == "exp":
        size = ONE if a == ZERO else apply("exp", a)
        return Parts(_product(size, apply("cos", b)), _product(size, apply("sin", b)))
    if name == "abs":
        return Parts(sqrt(a**2 + b**2), ZERO)
    pairs = {
        "cos": (("cos", "cosh", 1), ("sin", "sinh", -1)),
        "sin": (("sin", "cosh", 1), ("cos", "sinh", 1)),
        "cosh": (("cosh", "cos", 1), ("sinh", "sin", 1)),
        "sinh": (("sinh", "cos", 1), ("cosh", "sin", 1)),
    }
    if name not in pairs:
        return None
    (f, g, one), (h, k, other) = pairs[name]
    re = _product(apply(f, a), apply(g, b))
    im = _product(apply(h, a), apply(k, b))
    return Parts(re if one > 0 else -re, im if other > 0 else -im)


def _power(base: Expr, exponent: Expr) -> Parts | None:
    z = _parts(base)
    if z is None or exponent.op != "number" or exponent.args[0].q != 1:
        return None
    n = int(exponent.args[0].p)
    if abs(n) > HIGHEST:
        return None
    product = Parts(ONE, ZERO)
    for _ in range(abs(n)):
        product = _times(product, z)
    if n >= 0:
        return product
    size = product.re**2 + product.im**2
    return Parts(product.re / size, -product.im / size)


def _of_body(e: Expr) -> Parts | None:
    """Return the parts of an integral, a sum or a derivative: those of what stands under it."""
    if any(UNIT in symbols(arg) for arg in e.args[1:]) or UNIT in e.names:
        return None
    names, body = opened(e, (UNIT,))
    inner = _parts(body)
    if inner is None:
        return None
    re, im = (
        ZERO if part == ZERO else Expr(e.op, (bind(part, names), *e.args[1:]), e.names)
        for part in inner
    )
    return Parts(re, im)


def _plus(one: Expr, other: Expr) -> Expr:
    return other if one == ZERO else one if other == ZERO else one + other


def _product(one: Expr, other: Expr) -> Expr:
    if ZERO in (one, other):
        return ZERO
    return other if one == ONE else one if other == ONE else one * other


def _times(one: Parts, other: Parts) -> Parts:
    (a, b), (c, d) = one, other
    re = _plus(_product(a, c), -_product(b, d) if ZERO not in (b, d) else ZERO)
    return Parts(re, _plus(_product(a, d), _product(b, c)))
