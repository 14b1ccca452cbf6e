"""Read how a claim of the ledger is shown, where the engine needs a hint.

Most claims of a paper need none: the engine decides their formula. Behind ``shown by`` stands the
method for the others, and what it needs to know::

    small: sin(x)**2 < 1/100 given x >= -1/20, x <= 1/20 shown by boxes
    slope: v == -y/x given x > 0, y > 0 shown by circle solved for y(c), c == x

A hint names a method, and never a result: each of them is judged as any evidence is
(:mod:`tresym.ledger.judge`), and a false claim passes by none. These are the methods:

- ``boxes``: the relations are evaluated in balls on the box of the conditions, which is divided
  until each of them holds everywhere; ``stored boxes`` checks a division that is stored, since the
  search for it is long.
- ``charts NAME``: charts that are stored in Python, in a module from which the file takes NAME,
  have coordinates and margins (:mod:`tresym.ledger.evidence.chart_bounds`).
- ``variables r == sqrt(b/a), a == b/r**2, r > 0``: the statement is decided in other variables. New
  ones are functions of those of the claim, and what they replace is a function of the new ones.
- ``LABEL solved for y(c), c == x``: LABEL is an equation for y in which c may vary; the claim
  defines a new symbol as dy/dc at c = x (implicit function theorem).
- ``derivative LABEL from START``: f > 0 where x > p, as LABEL says that the derivative of f by x is
  positive, and START that f is 0 or positive at x = p.
- ``LABEL from x == p in BOUND``: a bound on e holds for all x on one side of p, as BOUND says that
  it holds at x = p, and LABEL that e is increasing or decreasing in x.
- ``monotony of LABEL``: f(y) is increasing or decreasing in x, as LABEL says that y is, and
  the derivative of f has one sign.
- ``BOUND approached by ABOVE along x == 1/t``: v is the infimum of e, as BOUND says that e > v, and
  ABOVE that e < v + r, where r tends to 0 as t tends to 0 from above.
- ``parts of LABEL, LABEL``: each part of the statement is one of the claims that are named.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import Any

from tresym.ledger.certificates import certificate
from tresym.ledger.claim import (
    Claim,
    Evidence,
    FromSlope,
    FromTheEdge,
    ImplicitFunction,
    InfimumBy,
    MonotoneOf,
    all_of,
)
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.chart_bounds import Charts
from tresym.ledger.evidence.decided import Decided, InVariables
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.ledger.formulas import names_of
from tresym.reals.language.brackets import split
from tresym.reals.language.expression import Expr
from tresym.reals.numbers.exact import InputError

_BOXES = re.compile(r"(stored\s+)?boxes")
_PARTS = re.compile(r"parts\s+of\s+(.+)", re.DOTALL)
_CHARTS = re.compile(r"charts\s+(\w+)")
_VARIABLES = re.compile(r"variables\s+(.+)", re.DOTALL)
_IS = re.compile(r"(\w+)\s*==\s*(.+)", re.DOTALL)
_SLOPE = re.compile(r"derivative\s+([\w-]+)\s+from\s+([\w-]+)")
_EDGE = re.compile(r"([\w-]+)\s+from\s+(\w+)\s*==\s*(.+?)\s+in\s+([\w-]+)")
_COMPOSED = re.compile(r"monotony\s+of\s+([\w-]+)")
_APPROACHED = re.compile(r"([\w-]+)\s+approached\s+by\s+([\w-]+)\s+along\s+(.+)")
_SOLVED = re.compile(r"([\w-]+)\s+solved\s+for\s+(\w+)\s*\(\s*(\w+)\s*\)\s*,\s*(\w+)\s*==\s*(.+)")


@dataclass(frozen=True)
class Line:
    """What a hint may speak of.

    Attributes:
        label: the claim that is shown.
        uses: the claims after ``using``.
        claim: returns the claim above with a label.
        expression: returns an expression that is written in a text.
        conditions: returns the conditions that are written in a text.
        stated: the statement and its conditions.
        decided: the evidence that the engine decides it with the claims used.
        charts: the stored charts that the file takes, by name.
    """

    label: str
    uses: tuple[Claim, ...]
    claim: Callable[[str], Claim]
    expression: Callable[[str], Expr]
    conditions: Callable[[str], list[Any]]
    stated: tuple[Any, ...]
    decided: Decided
    charts: Mapping[str, Charts]

    def claims(self, *labels: str) -> tuple[Claim, ...]:
        """Return the claims above with these labels."""
        return tuple(map(self.claim, labels))

    def symbol(self, name: str) -> str:
        """Return the name of a variable, as the ledger has it."""
        found = self.expression(name)
        if found.op != "symbol":
            raise InputError(f"'{name}' is not a variable")
        return str(found)


def _values(text: str, line: Line) -> Iterator[tuple[str, Expr]]:
    """Yield the values of ``x == 1, y == 1/t``."""
    for part in map(str.strip, split(text, ",")):
        match = _IS.fullmatch(part)
        if match is None:
            raise InputError(f"'{part}': write along x == 1, y == 1/t")
        yield line.symbol(match[1]), line.expression(match[2])


def way_to_show(text: str, line: Line) -> Evidence:
    """Return the evidence that the words after ``shown by`` describe.

    Raises:
        InputError: no method is called so, or what it needs is missing.
    """
    if match := _BOXES.fullmatch(text):
        return Evaluated(line.uses, stored=certificate(line.label) if match[1] else None)
    if match := _CHARTS.fullmatch(text):
        return _charted(match[1], line)
    if match := _VARIABLES.fullmatch(text):
        return replace(line.decided, variables=_variables(match[1], line))
    if match := _COMPOSED.fullmatch(text):
        return MonotoneOf(line.claim(match[1]), line.uses)
    if match := _APPROACHED.fullmatch(text):
        along = tuple(_values(match[3], line))
        return InfimumBy(line.claim(match[1]), line.claim(match[2]), along, line.uses)
    if line.uses:
        raise InputError(f"'{text}' names the claims behind it, so that nothing stands after using")
    if match := _PARTS.fullmatch(text):
        return all_of(*(line.claim(label.strip()) for label in match[1].split(",")))
    if match := _SLOPE.fullmatch(text):
        return FromSlope(line.claim(match[1]), line.claim(match[2]))
    if match := _EDGE.fullmatch(text):
        x, at = line.symbol(match[2]), line.expression(match[3])
        return FromTheEdge(line.claim(match[1]), line.claim(match[4]), at, x)
    if match := _SOLVED.fullmatch(text):
        if match[3] != match[4]:
            raise InputError(f"'{text}': the parameter {match[3]} needs a value, {match[3]} == x")
        unknown, parameter = map(line.symbol, (match[2], match[3]))
        at = line.expression(match[5])
        return ImplicitFunction(line.claim(match[1]), unknown, parameter, at)
    raise InputError(f"'{text}' is no way to show a claim: see the page about adding a claim")


def _charted(name: str, line: Line) -> Evidence:
    """Return stored charts, with the claims that are used."""
    if name not in line.charts:
        raise InputError(f"{name} are no charts: write use {name} from FILE")
    made = line.charts[name].made(line.claims)
    if isinstance(made, Boxes):
        return replace(made, claims=line.uses, stored=certificate(line.label))
    known = line.decided
    return replace(
        made, put=known.put, cited=known.cited, also=known.also, stored=certificate(line.label)
    )


def _variables(text: str, line: Line) -> InVariables:
    """Return other variables, each with its value, and conditions on them."""
    values: dict[str, Expr] = {}
    old: dict[str, Expr] = {}
    where: list[Any] = []
    known = names_of(*line.stated)
    for part in map(str.strip, split(text, ",")):
        match = _IS.fullmatch(part)
        if match is None:
            where += line.conditions(part)
            continue
        name = line.symbol(match[1])
        (old if name in known else values)[name] = line.expression(match[2])
    return InVariables(values, old, tuple(where))
