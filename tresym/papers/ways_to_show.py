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
- ``LABEL solved for y(c), c == x``: LABEL is an equation for y in which c may vary; the claim
  defines a new symbol as dy/dc at c = x (implicit function theorem).
"""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass

from sympy import Expr as Expression
from sympy import Symbol

from tresym.ledger.certificates import certificate
from tresym.ledger.claim import Claim, Evidence, ImplicitFunction
from tresym.ledger.evidence.interval_evaluation import Evaluated
from tresym.reals.numbers.exact import InputError

_BOXES = re.compile(r"(stored\s+)?boxes")
_SOLVED = re.compile(r"([\w-]+)\s+solved\s+for\s+(\w+)\s*\(\s*(\w+)\s*\)\s*,\s*(\w+)\s*==\s*(.+)")


@dataclass(frozen=True)
class Line:
    """What a hint may speak of.

    Attributes:
        label: the claim that is shown.
        uses: the claims after ``using``.
        claim: returns the claim above with a label.
        expression: returns an expression that is written in a text.
    """

    label: str
    uses: tuple[Claim, ...]
    claim: Callable[[str], Claim]
    expression: Callable[[str], Expression]

    def symbol(self, name: str) -> Symbol:
        """Return the symbol with a name."""
        found = self.expression(name)
        if not isinstance(found, Symbol):
            raise InputError(f"'{name}' is not a variable")
        return found


def way_to_show(text: str, line: Line) -> Evidence:
    """Return the evidence that the words after ``shown by`` describe.

    Raises:
        InputError: no method is called so, or what it needs is missing.
    """
    if match := _BOXES.fullmatch(text):
        return Evaluated(line.uses, stored=certificate(line.label) if match[1] else None)
    if match := _SOLVED.fullmatch(text):
        if line.uses:
            raise InputError("an implicit function uses its equation, and no other claim")
        if match[3] != match[4]:
            raise InputError(f"'{text}': the parameter {match[3]} needs a value, {match[3]} == x")
        unknown, parameter = map(line.symbol, (match[2], match[3]))
        at = line.expression(match[5])
        return ImplicitFunction(line.claim(match[1]), unknown, parameter, at, ())
    raise InputError(f"'{text}' is no way to show a claim: see the page about adding a claim")
