"""The ledger's claims as theorems: their definitions, their conditions, and what is said."""

import re
from functools import cache

import pytest

from tresym.coq.ledger_statements import Joint, name_of, stamp, theorem_of
from tresym.coq.statement import NotExportedError, Theorem
from tresym.coq.theorem_trees import Fails
from tresym.ledger.claim import Claim, Definition, Printed
from tresym.ledger.formulas import Tending
from tresym.ledger.paper import all_claims
from tresym.reals.language.compound import Somewhere
from tresym.reals.language.expression import number, symbol
from tresym.reals.language.formula import Relation
from tresym.reals.verdict import Verdict


@cache
def exported() -> list[tuple[Claim, Theorem | Joint]]:
    found = []
    for claim in all_claims():
        try:
            found.append((claim, theorem_of(claim)))
        except NotExportedError:
            continue
    return found


def single() -> list[tuple[Claim, Theorem]]:
    return [(claim, t) for claim, t in exported() if isinstance(t, Theorem)]


def test_theorems_of_claims_have_names_of_their_own() -> None:
    names = [t.name for _, t in exported()]
    assert len(set(names)) == len(names)
    assert all(re.fullmatch(r"claim_\w+", name) for name in names)
    assert len(exported()) > 600


def test_conditions_of_a_claim_are_premises() -> None:
    for claim, t in single():
        if type(claim.statement).__name__ == "Tending":
            assert all(str(c.left) in t.body for c in claim.given)
            continue
        assert len(t.given) >= len(set(claim.given)) - 1, t.name
        if isinstance(t.says, Relation):
            assert t.says not in t.given, t.name


def test_all_that_is_spoken_of_is_quantified() -> None:
    for _, t in single():
        spoken = set(re.findall(r"[A-Za-z_][\w']*", re.sub(r"\(\*.*?\*\)", "", t.body)))
        assert spoken.issuperset({"forall"} if t.variables and not t.exists else set()), t.name


def test_a_bound_whose_symbols_have_their_meaning_on_boxes_is_not_exported() -> None:
    """Its premises say nothing of ε, so that the theorem would be false."""
    (claim,) = (claim for claim in all_claims() if claim.label == "eq_epsilon_gen")
    with pytest.raises(NotExportedError, match="what its symbols mean on the boxes"):
        theorem_of(claim)


def test_what_is_refuted_is_that_there_is_a_counterexample() -> None:
    for claim, t in single():
        refuted = claim.expect is Verdict.REFUTED
        if isinstance(claim.statement, Tending):  # an order fails as a whole
            assert refuted == isinstance(t.says, Fails)
            continue
        if isinstance(claim.statement, Somewhere):  # at no point: it holds of all
            assert not t.exists
            assert t.says == Relation(symbol("b"), "<", number(1))
            continue
        assert t.exists == (refuted != isinstance(claim.proof, Printed)), t.name


def test_a_definition_says_that_there_is_what_it_defines() -> None:
    found = [t for claim, t in single() if isinstance(claim.proof, Definition)]
    assert len(found) > 10
    assert all("exists" in t.body for t in found)


def test_what_is_assumed_has_no_theorem() -> None:
    claim = next(c for c in all_claims() if isinstance(c.proof, Definition) and c.proof.assumes)
    with pytest.raises(NotExportedError, match="assumption"):
        theorem_of(claim)


def test_a_definition_for_one_case_has_its_conditions_before_it() -> None:
    cases = [conditions for _, t in single() for conditions, _ in t.definitions if conditions]
    assert cases
    assert all(condition.sign != "==" for conditions in cases for condition in conditions)


def test_names_and_stamps() -> None:
    assert name_of("eq:gamma") == "claim_eq_gamma"
    x = symbol("x")
    one = Theorem("claim_other", (), (), (), (), Relation(x, "==", x))
    other = Theorem("claim_other", (), (), (), (), Relation(x, ">=", x))
    assert stamp(one) != stamp(other)


def test_the_equations_of_a_symbol_that_has_several_are_premises() -> None:
    whole = next(t for claim, t in single() if claim.label == "eq_gamma")
    left = [meaning.left.args[0] for _, meaning in whole.definitions]
    assert left.count("M1") == 2  # what it is by the velocity, and by the angles


def test_a_root_is_the_one_zero_between_two_ends() -> None:
    whole = next(t for claim, t in single() if claim.label == "larger_ab_smaller_eps0")
    first, second = re.findall(
        r"is_root \(fun epsilon : R => .*?\) 0 \(\(1 / 2\) \* PI\)", whole.body
    )
    assert "a1" in first
    assert "a2" in second  # each at its own values


def test_at_most_one_says_that_two_are_the_same() -> None:
    whole = next(t for claim, t in single() if claim.label == "one_rotating_level")
    *_, says = whole.body.splitlines()
    *conditions, last = says.split(" -> ")
    assert len(conditions) == 6
    assert len(set(last.split(" = "))) == 2
    assert sum("RInt" in condition for condition in conditions) == 2


def test_of_a_refuted_conjunction_the_refuted_parts_are_said() -> None:
    for claim, t in exported():
        if isinstance(t, Joint) and claim.expect is Verdict.REFUTED:
            assert t.parts
            assert all(part.expect is Verdict.REFUTED for part in t.parts)


def test_an_order_is_a_bound_at_all_points_that_are_near() -> None:
    said = {claim.label: t.body for claim, t in single() if isinstance(claim.statement, Tending)}
    assert said["product_is_approached"].split(" : R, ")[:2] == [
        "  forall v_bound",
        "v_bound > 0 -> exists v_near",
    ]
    assert "exists v_bound : R, exists v_near" in said["eps0_smooth"]
    assert "~" in said["d24"]
    assert "epsilon0 < (1 / 2) * PI" in said["d24"]  # the defect is what it is defined to be
    smooth = said["G_is_smooth"]  # the derivative exists there, and has the bound
    assert re.search(r"exists (\w+) : R, is_derive .* \1 /\\ Rabs \1 <= v_bound \* Rabs 1", smooth)
