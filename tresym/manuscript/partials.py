r"""Partial derivatives that are written by subscripts: ``f_x``, ``u_{xt}(x, t)``.

After ``f(x, y) = x^2 y`` the formula ``f_x = 2xy`` states a derivative, and is no definition. It is
read as ``\frac{\partial}{\partial x} f(x, y)`` where f is a known function of at least two
variables, the subscript consists of these, and no other arguments follow: ``f_x(1, 2)`` is left.

Example:
    >>> " ".join(with_partials(["f", "_", "x", "=", "2"], {"f": ("x", "y")}))
    '\\frac { \\partial } { \\partial x } f ( x , y ) = 2'
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence


def with_partials(tokens: Sequence[str], functions: Mapping[str, Sequence[str]]) -> list[str]:
    """Return tokens with partial derivatives of known functions as fractions.

    Args:
        functions: the variables of each function of several variables.
    """
    result: list[str] = []
    at = 0
    while at < len(tokens):
        names = functions.get(tokens[at].removeprefix("\\"), ())
        by, end = _subscript(tokens, at + 1) if len(names) > 1 else ([], at)
        applied = [token for name in names for token in (name, ",")][:-1]
        following = list(tokens[end : end + 1])
        given = following == ["("]
        same = list(tokens[end + 1 : end + 2 + len(applied)]) == [*applied, ")"]
        if not by or not {*by} <= {*names} or (given and not same) or following == ["^"]:
            result.append(tokens[at])
            at += 1
            continue
        for name in reversed(by):
            result += ["\\frac", "{", "\\partial", "}", "{", "\\partial", name, "}"]
        result += [tokens[at], "(", *applied, ")"]
        at = end + (len(applied) + 2 if given else 0)
    return result


def _subscript(tokens: Sequence[str], at: int) -> tuple[list[str], int]:
    """Return the letters of the subscript that begins at a token, and where it ends."""
    if list(tokens[at : at + 1]) != ["_"]:
        return [], at
    inner = list(tokens[at + 1 : at + 2])
    if inner != ["{"]:
        return inner, at + 2
    end = next((n for n in range(at + 2, len(tokens)) if tokens[n] == "}"), at + 2)
    return list(tokens[at + 2 : end]), end + 1
