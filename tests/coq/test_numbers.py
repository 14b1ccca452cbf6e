"""Numbers.v: the digits are those of the racket's own ladder, and Coq proves them."""

import re

import pytest
from coq_runs import run
from mpmath import atan, findroot, mp, mpf, pi, sinh, sqrt, tanh
from tresym.proofs.coq_numbers import DIGITS, numbers

from tresym.coq.candidate_search import prelude
from tresym.racket.body import NAMED_BODIES


def test_the_digits_are_those_of_the_equation() -> None:
    printed = re.findall(r"\(defect \(.*\n +- \((\d+) / 10 \^ (\d+)\)\)", numbers())
    assert len(printed) == len(NAMED_BODIES) == 7
    with mp.workdps(70):
        for body, (top, places) in zip(NAMED_BODIES.values(), printed, strict=True):
            a, b = (mpf(int(x.p)) / int(x.q) for x in (body.shape.a, body.shape.b))
            k, r = sqrt(a * b), sqrt(b / a)
            phase = findroot(lambda t, k=k, r=r: t - k * (pi + atan(r * tanh(t))), k * pi)
            exact = atan(sqrt(a / (a + b)) / sinh(phase))
            assert abs(exact - mpf(int(top)) / mpf(10) ** int(places)) < mpf(10) ** -(DIGITS + 2)


@pytest.mark.coq
def test_coq_proves_them_and_no_other_digit() -> None:
    text = numbers().replace("Require Import Tresym.\n", "")
    accepted, said = run(prelude() + text, 300)
    assert accepted, said
    top = re.findall(r"- \((\d+) / 10", text)[0]
    wrong = text.replace(f"({top} /", f"({int(top) + 10**7} /")
    assert wrong != text
    assert not run(prelude() + wrong, 300)[0]
