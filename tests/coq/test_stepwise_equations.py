"""Equations step by step: what Coq is asked, and that falsehoods are not proved."""

import time

import pytest
from cases import cases

from tresym.coq.candidate_search import by_steps
from tresym.coq.claim_export import theorems
from tresym.coq.coqtop import Dialogue
from tresym.coq.proof_script import spelled
from tresym.coq.stepwise_equations import stepwise
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.language.parsing import parse


def test_what_is_spelled() -> None:
    assert spelled(parse("abs(x)")) == parse("abs(x)")
    assert str(spelled(parse("asinh(x)"))) == "log(x + sqrt(x**2 + 1))"
    assert spelled(parse("asinh(x)"), plainly=True) == parse("asinh(x)")


def test_angles_are_taken_as_coarse_as_they_are_asked_for() -> None:
    (theorem,) = theorems(read("cos(6*x) == 2*cos(3*x)**2 - 1"))
    asked: list[str] = []
    proof = stepwise(theorem, lambda sentence: asked.append(sentence) is None, asked.clear)
    assert proof
    assert "sin (3 * x)" in proof
    assert "some_name (sin x)" not in proof


def test_a_sign_and_an_absolute_value_go_together() -> None:
    (theorem,) = theorems(read("sign(x**3)*abs(x**3)**(1/3) == x"))
    proof = stepwise(theorem, lambda _: True, lambda: None)
    assert proof
    assert "sign_root" in proof
    assert "destruct (R" not in proof  # there are no cases


def test_each_sentence_is_asked_and_what_is_refused_is_left_out() -> None:
    (theorem,) = theorems(read("cbrt(x**3) == x"))
    asked: list[str] = []

    def ask(sentence: str) -> bool:
        asked.append(sentence)
        return "R_" not in sentence

    proof = stepwise(theorem, ask, asked.clear)
    assert proof == "\n".join(asked)
    assert "root_unique_3" in proof


def test_nothing_is_found_where_coq_refuses_all() -> None:
    (theorem,) = theorems(read("cbrt(x**3) == x"))
    assert stepwise(theorem, lambda _: False, lambda: None) is None


TRUE = tuple(cases(__file__, "TRUE"))
FALSE = tuple(cases(__file__, "FALSE"))


@pytest.mark.coq
def test_coq_accepts_what_is_true_alone() -> None:
    with Dialogue() as coq:
        coq.begin()
        for claim in (*TRUE, *FALSE):
            (theorem,) = theorems(read(claim))
            found = by_steps(theorem, coq, time.monotonic() + 300)
            assert (found is not None) is (claim in TRUE)
