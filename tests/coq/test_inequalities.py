"""Proofs of inequalities: found by the ways of the prover of signs, and accepted by Coq."""

import pytest
from cases import cases

from tresym.coq.candidate_search import export
from tresym.coq.claim_export import theorems
from tresym.coq.inequalities import inequality_proofs
from tresym.coq.reductions import reductions
from tresym.coq.statement import formula
from tresym.reals.decisions.claim_parsing import read


@pytest.mark.parametrize(
    ("claim", "left"),
    [
        ("x**x >= exp(-1/E) given x > 0", "(-1) * / (exp 1) <= x * ln x"),
        ("tanh(x) >= x/(1 + x) given x >= 0", "0 <= tanh x * (x + 1) + (-1) * x"),
        ("abs(sin(2*x)) <= 2*abs(sin(x))", "Rabs (sin (2 * x)) <= 2 * sin x"),
    ],
)
def test_what_implies_it(claim: str, left: str) -> None:
    (theorem,) = theorems(read(claim))
    assert left in [formula(step.says) for way in reductions(theorem) for step in way.steps]


@pytest.mark.parametrize(
    ("claim", "words"),
    cases(__file__, "the_way_of_the_prover_of_signs"),
)
def test_the_way_of_the_prover_of_signs(claim: str, words: str) -> None:
    (theorem,) = theorems(read(claim))
    assert any(words in proof for proof in list(inequality_proofs(theorem))[:5])


@pytest.mark.coq
@pytest.mark.parametrize(
    ("claim", "true"),
    cases(__file__, "coq_accepts_what_is_true_alone"),
)
def test_coq_accepts_what_is_true_alone(claim: str, true: bool) -> None:
    assert export(theorems(read(claim)), 300).accepted is true
