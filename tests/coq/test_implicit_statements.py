"""The implicit function theorem as it is printed for the claims that apply it."""

import pytest

from tresym.coq.coqtop import Dialogue
from tresym.coq.implicit_statements import Implicit
from tresym.coq.ledger_statements import lemmas, theorem_of
from tresym.ledger.claim import (
    ImplicitFunction,
)
from tresym.ledger.paper import all_claims, file_of

CLAIMS = {claim.label: claim for claim in all_claims()}
APPLY_IT = [label for label, claim in CLAIMS.items() if isinstance(claim.proof, ImplicitFunction)]
WRONG = [
    ("((-1) * / v_value1 * v_value2)", "(/ v_value1 * v_value2)"),
    ("((-1) * / v_value1 * v_value2)", "((-1) * / v_value2 * v_value1)"),
    ("((-1) * / v_value1 * v_value2)", "(2 * / v_value1 * v_value2)"),
]


def printed(label: str) -> Implicit:
    found = theorem_of(CLAIMS[label])
    assert isinstance(found, Implicit)
    return found


@pytest.mark.parametrize("label", APPLY_IT)
def test_the_theorem_has_the_equation_as_a_premise_and_a_solution_in_its_conclusion(label):
    body = printed(label).body
    premises, conclusion = body.split("(* equation *)")
    assert "v_solution" not in premises
    assert conclusion.count("is_derive v_solution") == 2  # of one solution, and of every one
    assert "continuous v_solution" in conclusion


def test_the_parameter_is_not_free_in_the_theorem():
    for label in APPLY_IT:
        found = printed(label)
        assert found.parameter not in found.variables
        assert found.unknown in found.variables


@pytest.mark.coq
def test_coq_proves_the_theorem_and_none_with_another_slope():
    with Dialogue(patience=30, lemmas=lemmas()) as coq:
        for label in APPLY_IT[:2]:
            script = file_of("coq").joinpath(f"{label}.v").read_text(encoding="utf-8")
            body = printed(label).body
            assert coq.accepts(f"Theorem stated_{label} :\n{body}.\nProof.\n{script}\nQed.", 120)
            for old, new in WRONG:
                wrong = body.replace(old, new)
                assert wrong != body
                assert not coq.accepts(
                    f"Theorem altered_{label} :\n{wrong}.\nProof.\n{script}\nQed.", 120
                )
