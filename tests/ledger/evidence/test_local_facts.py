"""Local facts: shown in order, under the conditions of the claim, and known nowhere else."""

from dataclasses import replace

import pytest
from derivations import by, derived, manifest, step
from sympy import Basic, Gt, Integral, Rational, Symbol, sqrt
from sympy_statements import Under, equal

from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.local_facts import by_facts, facts_of
from tresym.ledger.finding import Finding, Premise
from tresym.ledger.formulas import in_trees
from tresym.ledger.judge import judge
from tresym.ledger.paper import all_claims
from tresym.ledger.reasons import citing, integrating, roots
from tresym.reals.verdict import Verdict

v, x, y = (Symbol(name, real=True) for name in "vxy")
ROOT = equal(sqrt((3 - x) ** 2), 3 - x)
POLE = equal(Integral((3 - v) ** -2, (v, 0, 10)), -Rational(10, 21))
"""False: there is a pole at 3, and x or v below it elsewhere says nothing of that."""
ACROSS = by(integrating(1 / (3 - v)))
NEAR = equal(Integral((3 - v) ** -2, (v, 0, x)), 1 / (3 - x) - Rational(1, 3))


def found(
    says: Basic, knowing: tuple[Basic, ...], given: tuple[Basic, ...] = (), proof=manifest
) -> Verdict:
    return judge(Claim("planted", says, proof, given=given, knowing=knowing), {}).verdict


def test_a_fact_is_shown_and_used() -> None:
    claim = Claim("root", ROOT, by(roots), given=(x < 2,), knowing=(3 - x > 0,))
    finding = judge(claim, {})
    assert finding.verdict is Verdict.PROVED
    assert [s.verdict for s in finding.steps] == [Verdict.PROVED]
    (fact,) = facts_of(claim)
    assert (fact.says, fact.given) == (in_trees(3 - x > 0), claim.given)
    assert by_facts(claim, (fact,)).uses == (fact,)
    assert claim.uses == ()


FALSE = {
    "a fact that is false": (ROOT, (x > 3,), (x < 2,), by(roots)),
    "a fact that is true of some": (ROOT, (3 - x > 0,), (x < 4,), by(roots)),
    "a second fact that is true of some": (ROOT, (4 - x > 0, 3 - x > 0), (x < 4,), by(roots)),
    "a fact of what is free, of what is bound": (POLE, (3 - v > 0,), (v < 2,), ACROSS),
    "a fact of part of the interval": (
        POLE,
        (Under(3 - v > 0, (v >= 0, v <= 2)),),
        (),
        ACROSS,
    ),
    "a fact of no point": (POLE, (Under(3 - v > 0, (v > 3, v < 2)),), (), ACROSS),
    "a fact of what is bound, of what is free": (
        equal(sqrt((3 - v) ** 2), 3 - v),
        (Under(3 - v > 0, (v < 2,)),),
        (),
        by(roots),
    ),
}


@pytest.mark.parametrize("name", FALSE)
def test_no_falsehood_follows_from_a_fact(name: str) -> None:
    says, knowing, given, proof = FALSE[name]
    assert not found(says, knowing, given, proof).holds


def test_a_false_statement_is_refuted_whatever_its_facts() -> None:
    assert found(Gt(x**2, 5, evaluate=False), (x > 9,), (x > 1,)) is Verdict.REFUTED


def test_a_fact_of_what_is_bound_holds_inside() -> None:
    inside = Under(3 - v > 0, (v >= 0, v <= x))
    assert found(NEAR, (inside,), (x > 0, x < 3), ACROSS) is Verdict.PROVED
    assert not found(NEAR, (inside,), (x > 0,), ACROSS).holds


def test_a_fact_is_about_what_its_symbols_are_defined_to_be() -> None:
    meant = Claim("meant", equal(y, 1 + x**2), Definition(), given=(x > 0,))
    held = {"meant": Finding(Premise.DEFINED, "")}
    says = equal(sqrt((y - 1) ** 2) + x, y - 1 + x)
    proof = derived(step(y - 1 + x, roots, citing(meant)))
    for given, verdict in (((x > 0,), Verdict.PROVED), ((x > -1,), Verdict.UNDECIDED)):
        claim = Claim("user", says, proof, given=(*given, y > -9), knowing=(y - 1 > 0,))
        assert judge(claim, held).verdict is verdict
        (fact,) = facts_of(claim)
        shown = verdict is Verdict.PROVED
        assert fact.proof.put == ((meant,) if shown else ())
    other = Claim("other", equal(y, 2), by(), given=(x > 0,))
    cited = Claim("user", says, derived(step(y, citing(other))), given=(x > 0,), knowing=(y > 0,))
    assert facts_of(cited)[0].proof.put == ()


def test_a_fact_rests_on_those_before_it() -> None:
    (claim,) = (claim for claim in all_claims() if claim.label == "d36")
    held = {used.label: Finding(Verdict.PROVED, "") for used in claim.uses}
    assert judge(claim, held).verdict is Verdict.PROVED
    turned = judge(replace(claim, knowing=claim.knowing[::-1]), held)
    assert turned.verdict is Verdict.UNDECIDED
    assert "could not be shown" in turned.why


@pytest.mark.slow
def test_no_fact_of_the_paper_is_idle() -> None:
    known = [claim for claim in all_claims() if claim.knowing]
    assert known
    for claim in known:
        for fact in claim.knowing:
            fewer = replace(claim, knowing=tuple(k for k in claim.knowing if k != fact))
            labels = {used.label: Finding(Verdict.PROVED, "") for used in claim.uses}
            assert not judge(fewer, labels).verdict.holds, (claim.label, fact)
