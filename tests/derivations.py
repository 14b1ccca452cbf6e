"""Evidence of the ledger in short: that the engine decides a claim, by steps or at once.

``by(substituting(d))`` puts the equation of ``d`` in, ``by(integrating(x**2/2))`` is a step by a
rule for integrals, ``derived(step(e), step(None))`` goes by way of ``e``.
"""

from __future__ import annotations

from typing import Any

from tresym.ledger.claim import (
    Claim,
    Reason,
    Step,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.integrals import RULES
from tresym.reals.language.expression import Expr


def step(expression: Any, *reasons: Reason) -> Step:
    """The step to an expression, or to the right side of the statement."""
    return Step(expression, reasons)


def derived(*links: Step) -> Decided:
    """A derivation of one relation; its steps name what is put in, and what may be used."""
    reasons = [reason for link in links for reason in link.reasons]
    put, cited = _claims(reasons, "substituting"), _claims(reasons, "citing")
    steps = tuple(Step(k.expression, _of_steps(k.reasons)) for k in links)
    stops = isinstance(steps[-1].expression, Expr)
    return Decided(put, cited, steps=((*steps, Step(None, ())) if stops else steps,))


def by(*reasons: Reason) -> Decided:
    """A derivation in one step if a rule for integrals is named, or none."""
    if any(reason.name in RULES for reason in reasons):
        return derived(step(None, *reasons))
    return Decided(_claims(reasons, "substituting"), _claims(reasons, "citing"))


def _claims(reasons: list[Reason] | tuple[Reason, ...], name: str) -> tuple[Claim, ...]:
    found = [claim for reason in reasons if reason.name == name for claim in reason.claims]
    return tuple({id(claim): claim for claim in found}.values())


def _of_steps(reasons: tuple[Reason, ...]) -> tuple[Reason, ...]:
    return tuple(reason for reason in reasons if reason.name != "citing")


manifest = Decided()
"""The engine decides the statement as it stands."""
