"""Read the notation of differential equations in typed text.

Example: ``x(t) == cos(t) given x''(t) == -x(t), x(0) == 1, x'(0) == 0``. A letter that is
differentiated is a function, whatever letter it is; inside the program it has the prefix ``fn_`` if
the grammar reserves its name for variables. The slope at a point may be written ``x'(0)``,
``diff(x(0), t)`` or ``at(diff(x(t), t), t, 0)``; the first two become the third.
"""

from __future__ import annotations

import re

from tresym.reals.language.calls import KNOWN, UNKNOWN
from tresym.reals.numbers.exact import InputError

PREFIX = "fn_"
_NAME = r"(?<![\w.'])([A-Za-z]\w*)"
_DIFFERENTIATED = re.compile(rf"\b(?:diff|Derivative)\s*\(\s*{_NAME}\s*\(")
_PRIMED = re.compile(rf"{_NAME}\s*('+)\s*\(")
_AT_POINT = re.compile(rf"\b(?:diff|Derivative)\s*\(\s*{_NAME}\s*\(")
_CLOSED = re.compile(r"\s*,\s*([A-Za-z]\w*)\s*(?:,\s*(\d+)\s*)?\)")
_NO_FUNCTIONS = KNOWN | {"pi", "E", "e"}


def with_differential_notation(claim: str, given: str) -> tuple[str, str]:
    """Return a claim and its conditions in the grammar, if the conditions contain derivatives.

    Raises:
        InputError: a letter is a function and a variable, or it is unclear by what is
            differentiated.
    """
    under = f"{claim.partition(' given ')[2]}, {given}"
    if not (_DIFFERENTIATED.search(under) or _PRIMED.search(under)):
        return claim, given
    both = f"{claim} , {given}"
    names = {m[1] for e in (_DIFFERENTIATED, _PRIMED) for m in e.finditer(both)} - _NO_FUNCTIONS
    foreign = {name for name in names if not UNKNOWN.fullmatch(name)}
    for name in sorted(foreign):
        if re.search(rf"(?<![\w.]){name}\b(?!\s*'*\s*\()", both):
            raise InputError(
                f"{name} is used both as a function and as a variable: write {name} with its "
                "argument everywhere, as in the derivative"
            )

    def renamed(text: str) -> str:
        for name in sorted(foreign):
            text = re.sub(rf"(?<![\w.]){name}(?=\s*'*\s*\()", PREFIX + name, text)
        return text

    claim, given = renamed(claim), renamed(given)
    by = _variables(f"{claim} , {given}")
    return _slopes(claim, by), _slopes(given, by)


def without_prefix(text: str) -> str:
    """Return text with the names of functions as they were typed.

    Example:
        >>> without_prefix("fn_x(t) == cos(t)")
        'x(t) == cos(t)'
    """
    return re.sub(rf"\b{PREFIX}(?=\w)", "", text)


def _variables(text: str) -> dict[str, str]:
    """Return by what variable each function is differentiated."""
    found: dict[str, str] = {}
    for m in _DIFFERENTIATED.finditer(text):
        inside, end = _argument(text, m.end())
        closed = _CLOSED.match(text, end)
        if closed is not None and inside == closed[1]:
            found[m[1]] = inside
    for m in _PRIMED.finditer(text):
        inside, _ = _argument(text, m.end())
        if re.fullmatch(r"[A-Za-z]\w*", inside) and inside not in _NO_FUNCTIONS:
            found.setdefault(m[1], inside)
    return found


def _slopes(text: str, by: dict[str, str]) -> str:
    """Return the text with primes and derivatives at a point written as at(diff(f, x), x, p)."""
    while (m := _PRIMED.search(text)) is not None:
        inside, end = _argument(text, m.end())
        name, order = m[1], len(m[2])
        if name not in by and len(set(by.values())) != 1:
            shown = name.removeprefix(PREFIX)
            raise InputError(f"write {shown}' as diff({shown}(x), x), with its variable")
        x = by.get(name) or next(iter(by.values()))
        times = f", {order}" if order > 1 else ""
        slope = f"diff({name}({x}), {x}{times})"
        slope = slope if inside == x else f"at({slope}, {x}, {inside})"
        text = text[: m.start()] + slope + text[end:]
    at = 0
    while (m := _AT_POINT.search(text, at)) is not None:
        inside, end = _argument(text, m.end())
        closed, at = _CLOSED.match(text, end), m.end()
        if closed is None or by.get(m[1]) != closed[1]:
            continue
        x = closed[1]
        after = re.match(r"\s*\(", text[closed.end() :])
        if inside == x and after is not None:  # diff(y(t), t)(0)
            inside, end = _argument(text, closed.end() + after.end())
        elif closed is not None:
            end = closed.end()
        if re.search(rf"(?<![\w.]){x}\b", inside):
            continue
        times = f", {closed[2]}" if closed[2] else ""
        slope = f"at(diff({m[1]}({x}), {x}{times}), {x}, {inside})"
        text = text[: m.start()] + slope + text[end:]
        at = m.start() + len(slope)
    return text


def _argument(text: str, start: int) -> tuple[str, int]:
    """Return what stands in the parenthesis that was opened, and where it has ended."""
    depth = 1
    for n in range(start, len(text)):
        depth += (text[n] in "([{") - (text[n] in ")]}")
        if not depth:
            return text[start:n].strip(), n + 1
    raise InputError("a parenthesis is not closed")
