"""The equations of the claims that evidence uses, each only where its conditions are shown.

Example: √(x²) = x is a claim under x > 0. It is put into another claim only if the conditions
there, and the equations of claims accepted before it, show x > 0.
"""

from __future__ import annotations

from tresym.ledger.claim import Claim
from tresym.ledger.conversion import Conditions, Rules, conditions, definitions, put_into
from tresym.ledger.evidence.integrals import need
from tresym.ledger.evidence.sign_prover import is_manifest
from tresym.reals.language.formula import Relation


def instantiated(used: tuple[Claim, ...], given: Conditions) -> tuple[Rules, Conditions]:
    """Return the substitution rules of the claims used, and the conditions after substitution.

    Every condition of each claim must follow from ``given``, possibly with the rules of claims
    accepted before it. A claim's own equation, or one that still waits for it, is never used to
    show its condition, since that would be circular.

    Args:
        used: the claims whose equations are substituted.
        given: the conditions at hand.

    Raises:
        NotShownError: the condition of a claim could not be shown.
    """
    rules: Rules = {}
    meant, waiting = given, used
    while waiting:
        unmet = {claim: unmet_condition(claim, rules, meant) for claim in waiting}
        ready = tuple(claim for claim in waiting if unmet[claim] is None)
        first = unmet[waiting[0]]
        need(
            bool(ready),
            f"{waiting[0].label} is used here but holds only under {first}, which could not be "
            "shown",
        )
        rules |= definitions(ready)
        waiting = tuple(claim for claim in waiting if unmet[claim] is not None)
        meant = tuple(dict.fromkeys((*given, *put_into(given, rules))))
    return rules, meant


def unmet_condition(claim: Claim, rules: Rules, given: Conditions) -> Relation | None:
    """Return the first condition of ``claim`` that is not shown from ``given``, or None.

    Args:
        claim: a claim that is used.
        rules: substitutions applied to its conditions.
        given: the conditions at hand.
    """
    for condition in conditions(claim.given):
        (meant,) = put_into((condition,), rules)
        if not {condition, meant} & {*given} and not is_manifest(meant, given):
            return condition
    return None
