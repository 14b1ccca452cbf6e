"""Functions of the grammar by their names, and the constants that it writes by names."""

from __future__ import annotations

import re
from math import factorial

from tresym.reals.functions.table import ABBREVIATIONS, CONSTANTS, SPECIAL, TABLE
from tresym.reals.language.combinatorial import COMBINATORIAL
from tresym.reals.language.expression import (
    FUNCTIONS,
    MINUS_ONE,
    ONE,
    ZERO,
    Expr,
    angle,
    apply,
    as_expr,
    extreme,
    integer,
    number,
    sqrt,
    symbol,
    trees,
    unknown,
)
from tresym.reals.language.like_terms import collected
from tresym.reals.language.suggestions import about_function
from tresym.reals.numbers.exact import InputError

_ALIASES = {alias: row.name for row in TABLE.values() for alias in row.aliases}
_RECIPROCALS = {alias: row.name for row in TABLE.values() for alias in row.of_reciprocal}
"""Names for the function of the reciprocal argument: asec(x) is acos(1/x)."""
_OVERLOADED = {
    ("elliptic_e", 2): "elliptic_e_inc",
    ("gamma", 2): "uppergamma",
    ("Gamma", 2): "uppergamma",
    ("GAMMA", 2): "uppergamma",
    ("PolyGamma", 2): "polygamma",
    ("Psi", 2): "polygamma",
}
"""Names whose meaning depends on the number of arguments."""
_FOLDED = {"max": 1, "min": -1, "Max": 1, "Min": -1}
SPECIAL_NAMES = frozenset(
    name
    for row in TABLE.values()
    if row.name in SPECIAL and not row.internal and not row.constant
    for name in (row.name, *row.aliases)
) | {name for name, _ in (*ABBREVIATIONS, *COMBINATORIAL)}
"""The names of special functions. Without parentheses, such a name is a variable."""
MODULUS = {
    "EllipticK": "elliptic_k",
    "EllipticE": "elliptic_e",
    "EllipticF": "elliptic_f",
    "EllipticPi": "elliptic_pi",
}
"""Names that take the parameter m in Mathematica and the modulus k in Maple."""
MOST_LEFT = 100
"""The largest integer whose factorial is computed where variables cancel."""
KNOWN = FUNCTIONS.union(
    *(_ALIASES, _RECIPROCALS, _FOLDED, ("sqrt", "atan2", "diff", "Derivative")),
    SPECIAL_NAMES,
)
"""The names of functions."""
UNKNOWN = re.compile(
    r"(?:[fghuvwyzFGHUVW]|phi|psi|theta|Phi|Psi)(?:_?\d)?|fn_\w+|factorial|floor|ceiling"
)
"""The names of arbitrary functions, and ``factorial``, ``floor`` and ``ceiling``.

The reader of manuscripts writes an arbitrary function of another name with the prefix ``fn_``.
"""
FACTORIAL = "factorial"
ROUNDED = ("floor", "ceiling")
"""Functions with jumps, which stand as nodes of their own until they are integer variables."""
INFINITY = symbol("oo")
"""Infinity is not a number; it is allowed only as the end of a path or interval, or as a limit."""
INFINITE = {
    f"{sign}{name}": -INFINITY if sign == "-" else INFINITY
    for sign in ("", "+", "-")
    for name in ("oo", "inf", "infinity", "Infinity")
}
NAMED_CONSTANTS = {name: apply(name, ONE) for name in CONSTANTS} | {
    "GoldenRatio": (1 + sqrt(number(5))) / 2
}
"""Constants that are written by name."""
INTEGERS = symbol("ZZ")
"""The set of integers, in conditions such as ``n in ZZ``."""


def unknown_function_error(name: str) -> InputError:
    """Return the error for an unknown function."""
    return InputError(f"unknown function {name}: {about_function(name, KNOWN)}")


def call(name: str, values: list[Expr]) -> Expr:
    """Return a function of the grammar, by any of its names, applied to these arguments.

    Raises:
        InputError: the function is unknown, or the number of arguments is wrong.
    """
    given = len(values)
    if (name, given) in ABBREVIATIONS:
        return as_expr(ABBREVIATIONS[name, given](*values, trees))
    if (name, given) in COMBINATORIAL:
        return COMBINATORIAL[name, given](*values)
    name = _OVERLOADED.get((name, given), _ALIASES.get(name, name))
    if name == "lambertw" and given == 2 and values[1] in (ZERO, MINUS_ONE):
        return apply("lambertwm1" if values[1] == MINUS_ONE else name, values[0])
    if name in SPECIAL and name in SPECIAL_NAMES:
        arity = TABLE[name].arity
        if given != arity:
            raise InputError(f"{name} takes {arity} argument{'s' * (arity > 1)}, {given} given")
        return apply(name, *values)
    if name == "atan2" and len(values) == 2:
        return angle(*values)
    if name == "log" and len(values) == 2:
        return apply("log", values[0]) / apply("log", values[1])
    if name in _FOLDED and len(values) > 1:
        return extreme(_FOLDED[name], values)
    if name in _FOLDED:
        raise InputError(f"{name} takes two or more arguments: write {name}(a, b)")
    if name == "ceil":
        name = "ceiling"
    if name == FACTORIAL and given == 1 and (n := _left_over(values[0])) is not None:
        return number(factorial(n))
    if name in (FACTORIAL, *ROUNDED) and len(values) == 1:
        return unknown(name, tuple(values))
    if given == 1 and (bessel := re.fullmatch(r"([JYIK])_?(\d+)", name)):
        return apply(f"bessel{bessel[1].lower()}", number(int(bessel[2])), values[0])
    if name in MODULUS:
        read = MODULUS[name]
        raise InputError(
            f"two readings remain: write {read}(m) in the parameter m, as in Mathematica, or "
            f"{read}(k**2) in the modulus k, as in Maple"
        )
    if name not in KNOWN:
        raise unknown_function_error(name)
    if len(values) != 1:
        raise InputError(f"{name} takes one argument, {len(values)} given")
    if name == "sqrt":
        return sqrt(values[0])
    if name in _RECIPROCALS:
        return apply(_RECIPROCALS[name], 1 / values[0])
    return apply(name, values[0])


def _left_over(e: Expr) -> int | None:
    """Return the integer ≥ 0 that is left of a sum in which all variables cancel, else None.

    So binomial(n + 2, n), which contains (n + 2 - n)!, is the polynomial (n + 1)(n + 2)/2. Only
    sums of multiples of variables are added up: they have a value everywhere.
    """
    total = [e]
    for part in total:  # which grows
        if part.op == "+" or (part.op == "*" and part.args[0].op == "number"):
            total += part.args
        elif part.op not in ("symbol", "number"):
            return None
    n = integer(collected(e)) if e.op == "+" else None
    return n if n is not None and 0 <= n <= MOST_LEFT else None
