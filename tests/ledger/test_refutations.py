"""Counterexamples to claims, and conditions that no point satisfies."""

from dataclasses import replace

import pytest
from derivations import by, derived, manifest, step
from planted_claims import EVERYTHING, a, b, claim, t, verdict, x, y
from sympy import (
    Gt,
    Integral,
    Rational,
    Tuple,
    atan,
    cos,
    exp,
    log,
    pi,
    sin,
    sqrt,
)
from sympy_statements import ExactlyOne, equal

from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import (
    algebra,
    citing,
    roots,
    substituting,
)
from tresym.ledger.refutations import seen_false
from tresym.reals.verdict import Verdict

FALSE = {
    "wrong sign": (equal(cos(x) ** 2 - sin(x) ** 2, 2 * sin(x) ** 2 - 1), ()),
    "wrong branch of a root": (equal(sqrt(x**2), x), ()),
    "true only for positive b": (equal(sqrt(a * b**2), b * sqrt(a)), (a > 0,)),
    "a defect of 1e-60": (equal(sin(x) ** 2 + cos(x) ** 2, 1 + Rational(1, 10**60)), ()),
    "off by a constant": (equal(log(2 * x), log(x)), (x > 0,)),
    "arctan of the inverse": (equal(atan(x) + atan(1 / x), pi / 2), ()),
    "double angle of arctan": (equal(2 * atan(x), atan(2 * x / (1 - x**2))), ()),
}


@pytest.mark.parametrize("name", FALSE)
def test_false_identities_are_refuted_with_a_witness(name: str) -> None:
    says, given = FALSE[name]
    finding = judge(claim(says, by(*EVERYTHING), given), {})
    assert finding.verdict is Verdict.REFUTED


def test_unsatisfiable_conditions_prove_nothing() -> None:
    assert verdict(claim(equal(a, a), by(), (a > 1, a < 0))) is Verdict.UNDECIDED
    assert verdict(claim(a >= a - 1, by(), (a > 1, a < 0))) is Verdict.UNDECIDED


def test_conditions_may_hold_at_a_point_alone() -> None:
    """At x = 0, where the condition holds too, the equation says 1 = −1."""
    says = equal(sqrt(x**2 - 2 * x + 1), x - 1)
    proof = derived(step(x - 1, roots))
    assert verdict(claim(says, proof, (x**2 * (x - 1) >= 0,))) is Verdict.UNDECIDED
    assert verdict(claim(says, proof, (x**2 * (x - 1) >= 0, x > 0))) is Verdict.PROVED


def root(function: object, slope: object, low: object, high: object, *given: object) -> Verdict:
    stated = ExactlyOne(x, low, high, equal(function, 0))
    return verdict(claim(stated, Decided(), given))


def test_conditions_with_integrals_alone_may_hold_nowhere() -> None:
    nowhere = Integral(exp(t), (t, 0, 1)) < 0
    for proof in (by(algebra), Decided(), manifest):
        assert not verdict(claim(nowhere, proof, (nowhere,))).holds
        assert not verdict(claim(Gt(x**2 + 1, 0, evaluate=False), proof, (nowhere,))).holds


def test_conditions_of_what_is_not_elementary_are_met_nowhere() -> None:
    area = Integral(exp(t**2), (t, 0, x))
    says = Gt(x**2 + 1, 0, evaluate=False)
    for given in ((area > 5,), (area > 5, area < 1), (area < 0, x > 0)):
        assert verdict(claim(says, manifest, given)) is Verdict.UNDECIDED
        assert verdict(claim(says, Decided(), given)) is Verdict.UNDECIDED


def test_a_true_claim_with_a_broken_chain_is_not_refuted() -> None:
    rest = Claim("rest", equal(y, 1 - x), Definition())
    lemma = Claim("lemma", equal(x + y, 1), by(substituting(rest)))
    held = {"lemma": Finding(Verdict.PROVED, "assumed")}
    says = equal(x**2 + x * y, x)
    assert judge(Claim("user", says, by(substituting(lemma))), held).verdict is Verdict.UNDECIDED


def test_a_definition_that_contradicts_a_condition_proves_nothing() -> None:
    nought = Claim("nought", equal(x, 0), Definition())
    held = {"nought": judge(nought, {})}
    for proof in (by(substituting(nought)), Decided((nought,))):
        user = Claim("user", equal(1 / x, 2), proof, given=(x > 0,))
        assert not judge(user, held).verdict.holds


def test_a_condition_against_a_definition_or_a_cited_bound_proves_nothing() -> None:
    half = Claim("half", equal(x, Rational(1, 2)), Definition())
    proof = derived(step(Rational(1, 2), substituting(half)))
    bound = Claim("bound", Gt(1 - x, 0, evaluate=False), proof)
    held = {"half": judge(half, {})}
    held["bound"] = judge(bound, held)
    assert held["bound"].verdict is Verdict.PROVED
    says = Gt(1 - x, 0, evaluate=False)
    steps = derived(step(1 - x, citing(bound)))
    assert not judge(Claim("user", says, steps, given=(x > 5,)), held).verdict.holds
    third = Claim("third", equal(y, x + 1), by(substituting(half)))
    held["third"] = Finding(Verdict.PROVED, "assumed")
    third = replace(third, says=equal(y, Rational(3, 2)))
    says = Gt(y + x, 6, evaluate=False)
    assert not judge(Claim("…", says, Decided((third,)), given=(x > 5,)), held).verdict.holds
    root, says = Decided(), ExactlyOne(x, 0, 1, equal(x**3 + a * x, a))
    assert verdict(claim(says, root, (a > 0,))) is Verdict.PROVED
    assert not verdict(claim(says, root, (a > 0, a < 0))).holds
    assert not verdict(claim("one root", root, (a > 0,))).holds
    other = ExactlyOne(x, 0, 1, x**3 + a * x > a)
    assert verdict(claim(other, root, (a > 0,))) is Verdict.UNDECIDED


def test_whichever_part_is_false_is_refuted() -> None:
    both = Decided()
    right, wrong = equal(x + x, 2 * x), equal(x + x, 3 * x)
    for parts in ((right, wrong), (wrong, right)):
        assert judge(claim(Tuple(*parts), both), {}).verdict is Verdict.REFUTED
        assert seen_false(claim(Tuple(*parts), both)).verdict is Verdict.REFUTED
    assert seen_false(claim(Tuple(right, right), both)).verdict is Verdict.UNDECIDED
