"""Findings: the result of judging a claim, as a frozen value.

A statement that is proved or refuted gets a verdict. A definition or an assumption is marked as
such and counted separately, because nothing is proved about it.
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
    """The status of a claim that is not proved but used by others; the value is what is printed."""

    DEFINED = "DEFINED"
    """A well-formed definition: its symbols are new, and their values exist."""
    ASSUMED = "ASSUMED"
    """A named assumption: a law of physics, or the case that is studied."""

    @property
    def holds(self) -> bool:
        """Always True; a definition that is not well-formed is UNDECIDED instead."""
        return True


Ruling = Verdict | Premise
RULINGS: tuple[Ruling, ...] = (*Verdict, *Premise)
"""All possible results of judging a claim, in the order in which they are counted."""
WEAKEST_FIRST: tuple[Ruling, ...] = (
    *(Verdict.REFUTED, Verdict.UNDECIDED, Verdict.ENCLOSED, Verdict.PROVED),
    *(Premise.ASSUMED, Premise.DEFINED),
)
"""The order of strength: a conjunction gets the ruling of its weakest part."""


@dataclass(frozen=True)
class StepFinding:
    """The verdict on one step of a chain; ``why`` is the reason if it is not PROVED."""

    verdict: Verdict
    why: str
    seconds: float = 0.0


@dataclass(frozen=True)
class Finding:
    """The verdict on a claim, with the details that a report shows.

    Attributes:
        verdict: one of the four verdicts, or the kind of premise.
        why: the reason, in one sentence.
        value: for a number, its enclosure in decimal.
        constant: for an order or a bound, its constant in decimal.
        region: where the constant holds, in words.
        parameter: for an order, the limit or the path.
        witness: an exact point that refutes the claim; for a printed number, inputs that give it.
        steps: one finding for each step of a chain, in order.
        conditions: the conditions of the claims used, by label. For a conjunction, its parts hold
            under these conditions; otherwise, they have been shown.
        trees: for bounds on boxes, the bisection trees that prove them.
        seconds: the time taken.
        stopped: whether the claim was about to pass but the independent check contradicted it.
        of: the claim that was judged, or None.
        boxes: for a bound that is proved on boxes, their number.
        follows_from: for a conjunction, the labels of its parts.
        along: for an order that fails along a curve, the curve.
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
    boxes: int = 0
    follows_from: tuple[str, ...] = ()
    along: str = ""
