"""A denial is worth what the claims it rests on are worth."""

from flint import fmpq
from sympy import Symbol, sqrt

from tresym.ledger.claim import Claim, by, equal
from tresym.ledger.evidence.denial import Denied
from tresym.ledger.judge import judge
from tresym.ledger.reasons import roots
from tresym.reals.verdict import Verdict

x = Symbol("x", real=True)
CASE = {"x": fmpq(1)}
RIGHT = Claim("right", equal(sqrt(x**2), x), by(roots), given=(x > 0,))
WRONG = Claim("wrong", equal(sqrt(x**2), x), by(roots))


def verdict(*claims: Claim, case: dict[str, fmpq] | None = None) -> Verdict:
    found = {claim.label: judge(claim, {}) for claim in claims}
    denial = Claim("never", "It never happens.", Denied(claims, CASE if case is None else case))
    return judge(denial, found).verdict


def test_an_instance_that_holds_denies() -> None:
    assert verdict(RIGHT) is Verdict.REFUTED


def test_nothing_is_denied_by_what_does_not_hold() -> None:
    assert verdict(WRONG) is Verdict.UNDECIDED
    assert verdict(RIGHT, WRONG) is Verdict.UNDECIDED


def test_a_denial_needs_a_claim_and_a_case() -> None:
    assert verdict() is Verdict.UNDECIDED
    assert verdict(RIGHT, case={}) is Verdict.UNDECIDED
