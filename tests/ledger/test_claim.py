"""Claims: frozen, equal by label, and what they rest on read off their evidence."""

from dataclasses import FrozenInstanceError

import pytest
from derivations import by, derived, step
from flint import fmpq
from sympy import Derivative, Integer, Ne, Subs, Symbol, Tuple, sin
from sympy_statements import at, equal, equations

from tresym.ledger.claim import (
    Claim,
    Counterexample,
    Definition,
    ImplicitFunction,
    Place,
    Printed,
    all_of,
    display,
    label_claims,
    line,
    parts_of,
)
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.evidence.refutation import Denied
from tresym.ledger.finding import Premise
from tresym.ledger.formulas import in_trees
from tresym.ledger.judge import judge
from tresym.ledger.reasons import algebra, citing, collecting, substituting
from tresym.reals.verdict import Verdict

x, y = (Symbol(name, real=True) for name in "xy")


def named(label: str, proof: object = Definition()) -> Claim:
    return Claim(label, equal(x, y), proof)


A, B, C, D = (named(label) for label in "ABCD")
RESTS = [
    (by(algebra), []),
    (by(substituting(A, B), citing(A)), [A, B]),
    (derived(step(x, substituting(B)), step(y, citing(A))), [B, A]),
    (by(substituting(A), collecting(B)), [A, B]),
    (ImplicitFunction(A, x, y, Integer(0)), [A]),
    (all_of(A, B), [A, B]),
    (Decided((A,)), [A]),
    (Definition(), []),
]


@pytest.mark.parametrize(("proof", "uses"), RESTS, ids=[type(p).__name__ for p, _ in RESTS])
def test_every_kind_of_evidence_names_what_it_uses(proof: object, uses: list[Claim]) -> None:
    assert list(named("E", proof).uses) == uses


KINDS = [
    (equal(x, y), by(), "identity", Verdict.ENCLOSED),
    (Tuple(x < y, equal(x, y)), by(), "identity", Verdict.ENCLOSED),
    (Tuple(x < y, y >= x), by(), "bound", Verdict.ENCLOSED),
    (x > y, by(), "bound", Verdict.ENCLOSED),
    (Ne(x, y), by(), "identity", Verdict.ENCLOSED),
    ("x is y", all_of(A, B), "statement", Premise.DEFINED),
    ("x is y", all_of(A, named("E", by())), "statement", Verdict.ENCLOSED),
    ("x is y", all_of(), "statement", Verdict.PROVED),
    ("x is y", Decided(), "statement", Verdict.ENCLOSED),
    ("x is 1", Printed(), "number", Verdict.ENCLOSED),
    ("x is 1", Boxes((), (), ""), "bound", Verdict.ENCLOSED),
    (x > y, Boxes((), (), ""), "bound", Verdict.ENCLOSED),
    (equal(x, y), Boxes((), (), ""), "bound", Verdict.ENCLOSED),
    (equal(x, y), Asymptotics(), "order", Verdict.REFUTED),
    ("x is y", Counterexample({"x": fmpq(1)}), "statement", Verdict.REFUTED),
    ("x is y", Denied((A,), {"x": fmpq(1)}), "statement", Verdict.REFUTED),
    (equal(x, y), Definition("a law"), "definition", Premise.ASSUMED),
]


@pytest.mark.parametrize(("says", "proof", "kind", "expect"), KINDS)
def test_kind_and_expectation_are_read_off(
    says: object, proof: object, kind: str, expect: object
) -> None:
    claim = Claim("F", says, proof)
    assert (claim.kind, claim.expect) == (kind, expect)
    other = Claim("F", says, proof, kind="limit", expect=Verdict.UNDECIDED)
    if kind != "definition":
        assert (other.kind, other.expect) == ("limit", Verdict.UNDECIDED)
        assert all_of(other, A).expect is Verdict.UNDECIDED


def test_a_part_labels_the_claims_that_it_names() -> None:
    nameless, other = (Claim(says=equal(x, side), proof=by()) for side in (y, x))
    with pytest.raises(ValueError, match="has no label"):
        hash(nameless)
    label_claims({"first": nameless, "x": x, "second": nameless, "A": other, "B": A})
    assert (nameless.label, other.label, A.label) == ("first", "A", "A")
    assert {nameless} == {nameless}


def test_an_empty_claim_shows_nothing() -> None:
    assert judge(Claim("empty"), {}).verdict is Verdict.UNDECIDED


def test_a_place_is_a_display_or_a_line() -> None:
    assert (display(10), line(40)) == (Place(10, None, None), Place(None, 40, None))


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
    assert named("A", by(algebra)).expect is Verdict.ENCLOSED


def test_equations_are_not_evaluated() -> None:
    assert equal(x, x).args == (x, x)
    assert equations((x, y), (y, x)) == Tuple(equal(x, y), equal(y, x))
    assert parts_of(in_trees(Tuple(x > 0, y > 0))) == (in_trees(x > 0), in_trees(y > 0))
    assert parts_of("prose") == ("prose",)
    assert isinstance(at(x**2, {x: 3}), Subs)


def test_a_derivative_at_equal_values_is_refused() -> None:
    e = Derivative(sin(x * y), x)
    assert isinstance(at(e, {x: 1, y: 2}), Subs)
    with pytest.raises(ValueError, match="get the same value"):
        at(e, {x: 1, y: 1})
