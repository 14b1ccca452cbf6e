"""Claims as tests write them down for the judge, and the verdict on one."""

from sympy import Symbol

from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import differentiation, exponentials, inverses, roots, trigonometry
from tresym.reals.verdict import Verdict

a, b, r, x, y, t = (Symbol(name, real=True) for name in "abrxyt")
EVERYTHING = (roots, trigonometry, exponentials, inverses, differentiation)


def verdict(claim: Claim, **found: Finding) -> Verdict:
    return judge(claim, found).verdict


def claim(says: object, proof: object, given: tuple = (), **rest: object) -> Claim:
    return Claim(label="planted", says=says, proof=proof, given=given, **rest)


def judged(claim: Claim) -> Finding:
    """The finding on a claim, after those on all that it depends on, which must hold."""
    found: dict[str, Finding] = {}
    for one in claim.rests_on:
        found[one.label] = judge(one, found)
        assert found[one.label].verdict.holds, (one.label, found[one.label].why)
    return judge(claim, found)


def verdict_on(says: object, proof: object, *given: object) -> Verdict:
    """The verdict on a planted claim, after those on all that it depends on."""
    return judged(claim(says, proof, given)).verdict
