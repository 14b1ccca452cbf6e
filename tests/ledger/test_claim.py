"""Claims: frozen, equal by label, and what they rest on read off their evidence."""

from __future__ import annotations

from dataclasses import FrozenInstanceError

import pytest
from sympy import Derivative, Integer, Subs, Symbol, Tuple, sin

from tresym.ledger.claim import (
    Claim,
    Definition,
    ImplicitFunction,
    UniqueRoot,
    all_of,
    at,
    by,
    equal,
    equations,
    formally,
    parts_of,
    step,
    together,
)
from tresym.ledger.finding import Premise
from tresym.ledger.reasons import algebra, citing, substituting
from tresym.reals.verdict import Verdict

x, y = (Symbol(name, real=True) for name in "xy")


def named(label: str, proof: object = Definition()) -> Claim:
    return Claim(label, equal(x, y), proof)


A, B, C, D = (named(label) for label in "ABCD")
RESTS = [
    (by(algebra), []),
    (by(substituting(A, B), citing(A)), [A, B]),
    ((step(x, substituting(B)), step(y, citing(A))), [B, A]),
    (together(by(substituting(A)), by(citing(B))), [A, B]),
    (UniqueRoot(by(citing(A)), by(citing(B)), by(citing(C))), [A, B, C]),
    (ImplicitFunction(A, x, y, Integer(0), by(citing(C)), (B,)), [A, B, C]),
    (all_of(A, B), [A, B]),
    (formally(A), [A]),
    (Definition(), []),
]


@pytest.mark.parametrize(("proof", "uses"), RESTS, ids=[type(p).__name__ for p, _ in RESTS])
def test_every_kind_of_evidence_names_what_it_uses(proof: object, uses: list[Claim]) -> None:
    assert list(named("E", proof).uses) == uses


def test_foundations_come_first_and_once() -> None:
    lower = named("lower", by(citing(A)))
    upper = named("upper", by(citing(lower, A, B)))
    assert upper.rests_on == (A, lower, B)


def test_a_claim_is_all_that_it_says_and_does_not_change() -> None:
    assert named("A") == A
    assert named("A", by(algebra)) != A
    assert hash(named("A", by(algebra))) == hash(A)
    assert A != B
    assert A != "A"
    with pytest.raises(FrozenInstanceError):
        A.expect = Verdict.REFUTED


def test_a_definition_is_expected_to_be_one() -> None:
    assert (A.kind, A.expect) == ("definition", Premise.DEFINED)
    assert named("A", Definition("so it is")).expect is Premise.ASSUMED
    assert named("A", by(algebra)).expect is Verdict.PROVED


def test_equations_are_not_evaluated() -> None:
    assert equal(x, x).args == (x, x)
    assert equations((x, y), (y, x)) == Tuple(equal(x, y), equal(y, x))
    assert parts_of(Tuple(x > 0, y > 0)) == (x > 0, y > 0)
    assert parts_of("prose") == ("prose",)
    assert isinstance(at(x**2, {x: 3}), Subs)


def test_a_derivative_at_equal_values_is_refused() -> None:
    e = Derivative(sin(x * y), x)
    assert isinstance(at(e, {x: 1, y: 2}), Subs)
    with pytest.raises(ValueError, match="equal values"):
        at(e, {x: 1, y: 1})
