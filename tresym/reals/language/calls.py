"""Functions of the grammar by their names, and the constants that it writes by names."""

from __future__ import annotations

import re
from collections.abc import Callable

from tresym.reals.functions.table import TABLE
from tresym.reals.language.expression import (
    FUNCTIONS,
    Expr,
    angle,
    apply,
    extreme,
    sqrt,
    symbol,
    unknown,
)
from tresym.reals.language.suggestions import about_function
from tresym.reals.numbers.exact import InputError

_ALIASES = {alias: row.name for row in TABLE.values() for alias in row.aliases}
_RECIPROCALS = {alias: row.name for row in TABLE.values() for alias in row.of_reciprocal}
"""Names for the function of the reciprocal argument: asec(x) is acos(1/x)."""
_GUDERMANNIAN: dict[str, Callable[[Expr], Expr]] = {
    "gd": lambda x: 2 * apply("atan", apply("tanh", x / 2)),
    "agd": lambda x: apply("asinh", apply("tan", x)),
}
"""Source: DLMF 4.23.39 and 4.23.41."""
_FOLDED = {"max": 1, "min": -1, "Max": 1, "Min": -1}
KNOWN = FUNCTIONS.union(
    *(_ALIASES, _RECIPROCALS, _FOLDED, _GUDERMANNIAN, ("sqrt", "atan2", "diff", "Derivative"))
)
"""The names of functions."""
UNKNOWN = re.compile(r"(?:[fghuvwyzFGHUVW]|phi|psi|theta|Phi|Psi)(?:_?\d)?|fn_\w+|factorial")
"""The names of arbitrary functions, and ``factorial``.

The reader of manuscripts writes an arbitrary function of another name with the prefix ``fn_``.
"""
FACTORIAL = "factorial"
INFINITY = symbol("oo")
"""Infinity is not a number; it is allowed only as the end of a path or interval, or as a limit."""
INFINITE = {
    f"{sign}{name}": -INFINITY if sign == "-" else INFINITY
    for sign in ("", "+", "-")
    for name in ("oo", "inf", "infinity", "Infinity")
}
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
    name = _ALIASES.get(name, name)
    if name == "atan2" and len(values) == 2:
        return angle(*values)
    if name == "log" and len(values) == 2:
        return apply("log", values[0]) / apply("log", values[1])
    if name in _FOLDED and len(values) > 1:
        return extreme(_FOLDED[name], values)
    if name in _GUDERMANNIAN and len(values) == 1:
        return _GUDERMANNIAN[name](values[0])
    if name == FACTORIAL and len(values) == 1:
        return unknown(name, tuple(values))
    if name not in KNOWN:
        raise unknown_function_error(name)
    if len(values) != 1:
        raise InputError(f"{name} takes one argument, {len(values)} given")
    if name == "sqrt":
        return sqrt(values[0])
    if name in _RECIPROCALS:
        return apply(_RECIPROCALS[name], 1 / values[0])
    return apply(name, values[0])
