"""Equations step by step: what Coq is asked, and that falsehoods are not proved."""

from __future__ import annotations

import shutil
import time

import pytest

from tresym.coq.asked import theorems
from tresym.coq.dialogue import Dialogue
from tresym.coq.search import by_steps
from tresym.coq.stepwise import stepwise
from tresym.coq.writing import spelled
from tresym.reals.decisions.reading import read
from tresym.reals.language.parsing import parse

needs_coq = pytest.mark.skipif(shutil.which("coqc") is None, reason="coqc is not installed")


def test_what_is_spelled() -> None:
    assert spelled(parse("abs(x)")) == parse("abs(x)")
    assert str(spelled(parse("asinh(x)"))) == "log(x + sqrt(x**2 + 1))"


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


TRUE = (
    "sqrt(x**2)*sign(x) == x",
    "asin(x/sqrt(1 + x**2)) == atan(x)",
    "exp(log(x)/2) == sqrt(x)",
    "log(x**2) == 2*log(x) + sign(x) - 1",
)
FALSE = (
    "sqrt(x**2) == x",
    "2*atan(x) == atan(2*x/(1 - x**2))",
    "log(x**2) == 2*log(abs(x)) + sign(x) - 1",
    "sign(x)**2 == 1",
)


@needs_coq
@pytest.mark.slow
def test_coq_accepts_what_is_true_alone() -> None:
    with Dialogue() as coq:
        coq.begin()
        for claim in (*TRUE, *FALSE):
            (theorem,) = theorems(read(claim))
            found = by_steps(theorem, coq, time.monotonic() + 300)
            assert (found is not None) is (claim in TRUE)
