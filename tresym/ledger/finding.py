"""Findings: the result of judging a claim, as a frozen value.

What is shown gets a verdict. What is put in gets the name of that, and is counted apart.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from enum import Enum
from typing import Any

from flint import fmpq

from tresym.reals.numbers.exact import Decimal
from tresym.reals.verdict import Verdict


class Premise(Enum):
    """What a claim is that shows nothing: others may use it. The value is the word printed."""

    DEFINED = "DEFINED"
    """A definition: its symbols are new, and what they stand for exists under its conditions."""
    ASSUMED = "ASSUMED"
    """Put in, and named: physics, or the case that is studied."""

    @property
    def holds(self) -> bool:
        """True: one that is none, or contradicts others, is UNDECIDED."""
        return True


Ruling = Verdict | Premise
RULINGS: tuple[Ruling, ...] = (*Verdict, *Premise)
"""All that the ledger says of claims, in the order in which it is counted."""
WEAKEST_FIRST: tuple[Ruling, ...] = (
    *(Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED, Verdict.PROVED),
    *(Premise.ASSUMED, Premise.DEFINED),
)
"""Claims said together are what the weakest is: what premises alone say is no more than they."""


@dataclass(frozen=True)
class StepFinding:
    """Verdict on one step of a chain, with the reason it is not PROVED when it is not."""

    verdict: Verdict
    why: str
    seconds: float = 0.0


@dataclass(frozen=True)
class Finding:
    """Verdict on a claim, with the evidence that a report shows.

    Attributes:
        verdict: one of the four, or what kind of premise it is.
        why: one sentence.
        value: for a number, the ball in decimal.
        constant: for an order claim or a bound, the constant found, in decimal.
        region: where the constant holds, in words.
        witness: exact point that refutes the claim (or exhibits it, for a printed number).
        steps: one finding for each step of a chain, in order.
        conditions: by label, the conditions of each claim that it uses: of a conjunction those
            under which its parts hold, else those that were shown.
        trees: for bounds on boxes, the bisection tree that closes each.
        seconds: time taken.
        of: the claim that was judged; None where nobody was asked.
        stopped: whether it was about to pass, and the advocate contradicted it.
    """

    verdict: Ruling
    why: str
    value: Decimal | None = None
    constant: Decimal | None = None
    region: str | None = None
    parameter: str | None = None
    witness: Mapping[str, fmpq] | None = None
    steps: tuple[StepFinding, ...] = field(default=())
    conditions: Mapping[str, tuple[Any, ...]] = field(default_factory=dict)
    trees: tuple[str, ...] = ()
    seconds: float = 0.0
    stopped: bool = False
    of: Any = field(default=None, repr=False, compare=False)
