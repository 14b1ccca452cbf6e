"""Check a list of published approximations against the bounds of the error that are printed.

The list is a text of blocks, one for each approximation, separated by empty lines; ``#`` starts a
comment::

    source: Abramowitz and Stegun 7.1.25
    exact: erf(x)
    t = 1/(1 + 0.47047*x)
    approx: 1 - (0.3480242*t - 0.0958798*t**2 + 0.7478556*t**3)*exp(-x**2)
    on: x >= 0
    bound: 2.5e-5

A line ``name = expression`` abbreviates a part. ``bound`` is absolute, or ends in ``relative``, or
is ``none`` where none is printed; ``stored: double`` reads decimals as they are stored. The largest
error of each is enclosed by :func:`tresym.largest_error`. A printed bound holds, is the error
rounded to the printed digits, or is exceeded.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any, NamedTuple

from flint import arb, fmpq

from tresym.accuracy.largest_error import (
    Bounds,
    as_stored,
    error_bounds,
    interval,
)
from tresym.accuracy.table import Table
from tresym.accuracy.values import read
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import Expr, substitute, symbols
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError, quoted

FIELDS = ("source", "exact", "approx", "on", "bound", "stored")
HOLDS, ROUNDED, EXCEEDED, OPEN, NONE = "holds", "rounds to it", "exceeded", "open", ""
CLOSER = fmpq(1, 10**5)
"""How close the bounds of an error are made where the printed one lies between them."""
_DEFINITION = re.compile(r"([A-Za-z]\w*)\s*=\s*(.+)")


class Published(NamedTuple):
    """One approximation as it is printed.

    Attributes:
        source: where.
        exact: the function.
        approx: the formula, with its abbreviations put in; or the text of a list of coefficients.
        on: the region.
        bound: the printed bound; empty if there is none.
        relative: whether it is one of the relative error.
        stored: how decimals are read.
        line: where the block starts.
    """

    source: str
    exact: str
    approx: str | Expr
    on: str
    bound: str
    relative: bool
    stored: str
    line: int


class Judged(NamedTuple):
    """One approximation with its largest error and what that says of the printed bound."""

    published: Published
    error: Bounds
    verdict: str


def read_list(text: str) -> list[Published]:
    """Return the approximations of a list.

    Raises:
        InputError: a line is not understood, or something is missing; the message has the line.
    """
    return [_published(fields, line) for fields, line in _blocks(text)]


def _blocks(text: str) -> Iterator[tuple[dict[str, Any], int]]:
    fields: dict[str, Any] = {}
    start = 1
    for n, line in enumerate([*text.splitlines(), ""], 1):
        plain = line.strip()
        if not plain:
            if fields:
                yield fields, start
            fields, start = {}, n + 1
            continue
        if plain.startswith("#"):
            continue
        name, colon, value = plain.partition(":")
        defined = _DEFINITION.fullmatch(plain)
        if colon and name in FIELDS:
            if name in fields:
                raise InputError(f"line {n}: {name} is given twice")
            fields[name] = value.strip()
        elif defined is not None:
            fields.setdefault("where", []).append((defined[1], defined[2]))
        else:
            raise InputError(
                f"line {n}: {quoted(plain)} is not one of {', '.join(FIELDS)}, or name = expression"
            )


def _published(fields: dict[str, Any], line: int) -> Published:
    missing = [name for name in FIELDS[:4] if not fields.get(name)]
    if missing:
        raise InputError(f"line {line}: {', '.join(missing)} is missing")
    stored = fields.get("stored", "exact")
    bound, _, kind = fields.get("bound", "").partition(" ")
    if kind.strip() not in ("", "relative", "absolute"):
        raise InputError(f"line {line}: write a bound as 5e-8, or 5e-8 relative")
    approx: str | Expr = fields["approx"]
    try:
        name = interval(fields["on"])[0]
        if "where" in fields:
            tree = read(as_stored(fields["approx"], stored, name))
            parts = {short: read(as_stored(text, stored, name)) for short, text in fields["where"]}
            used: set[str] = set()
            for _ in parts:  # a part may be written by others
                used |= symbols(tree) & parts.keys()
                tree = substitute(tree, parts)
            if name in parts or parts.keys() - used or len(parts) < len(fields["where"]):
                raise InputError("define each part once, and use it in the approximation")
            approx = tree
    except InputError as error:
        raise InputError(f"line {line}: {error}") from None
    bound = "" if bound in ("none", "") else bound
    relative = kind.strip() == "relative"
    return Published(
        fields["source"], fields["exact"], approx, fields["on"], bound, relative, stored, line
    )


def judge(one: Published) -> Judged:
    """Return the largest error of an approximation, and whether it keeps the printed bound.

    Raises:
        InputError: something cannot be read; the message has the line.
    """
    try:
        asked = one.exact, one.approx, one.on, one.stored, one.relative
        found = error_bounds(*asked)
        verdict = _verdict(one, found)
        if verdict == OPEN and found.high:
            found = error_bounds(*asked, CLOSER)
            verdict = _verdict(one, found)
    except InputError as error:
        raise InputError(f"line {one.line}: {error}") from None
    return Judged(one, found, verdict)


def _verdict(one: Published, error: Bounds) -> str:
    if not one.bound:
        return NONE
    with ball_precision():
        bound = evaluate(read(one.bound), {})
        if error.high and error.high != "oo" and arb(error.high) <= bound:
            return HOLDS
        if error.high == "oo" or arb(error.low) > bound + _half_unit(one.bound):
            return EXCEEDED
        return ROUNDED if arb(error.low) > bound else OPEN


def _half_unit(text: str) -> arb:
    """Return half a unit of the last printed digit, for 2**-58 that of the exponent."""
    power = re.fullmatch(r"2\*\*(-?\d+)", text)
    if power is not None:
        return arb(2) ** int(power[1]) * (arb(2).sqrt() - 1)
    match = re.fullmatch(r"\d*\.?(\d*)(?:[eE]([-+]?\d+))?", text)
    if match is None:
        return arb(0)
    return arb(10) ** (int(match[2] or 0) - len(match[1])) / 2


def table(rows: list[Judged]) -> Table:
    """Return a list of judged approximations as a table."""
    cells = []
    for one in rows:
        kind = " relative" if one.published.relative else ""
        low, high = one.error.low, one.error.high
        shown = f"{low} to {high}" if high and high != "oo" else f"at least {low}"
        printed = one.published.bound + kind if one.published.bound else "none"
        where = one.error.where or "an end"
        cells.append(
            (one.published.source, one.published.exact, one.published.on, printed, shown, where,
             one.verdict)
        )  # fmt: skip
    heads = ("source", "function", "region", "printed bound", "largest error", "at", "verdict")
    return Table("Largest errors of published approximations", heads, tuple(cells))
