"""Claims made of claims: conjunctions, equivalences, numbers of solutions, shapes, vectors."""

import mpmath
import pytest
from cases import cases

import tresym
from tresym.checking import check
from tresym.reals.language.readings import in_latex, need_variables, read_as
from tresym.reals.numbers.exact import InputError
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize("claim", cases(__file__, "TRUE"))
def test_a_true_claim_passes(claim: str) -> None:
    assert check(claim)


@pytest.mark.parametrize("claim", cases(__file__, "FALSE"))
def test_a_false_claim_is_refuted_with_a_witness(claim: str) -> None:
    answer = check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


@pytest.mark.parametrize(("claim", "message"), cases(__file__, "REFUSED"))
def test_what_has_no_meaning_is_refused(claim: str, message: str) -> None:
    with pytest.raises(InputError) as found:
        check(claim)
    assert message in str(found.value)


def test_what_is_read_is_read_again() -> None:
    for claim in (*cases(__file__, "TRUE"), *cases(__file__, "FALSE")):
        shown = read_as(claim)
        assert read_as(shown) == shown, claim
        assert in_latex(shown)


def test_latex_and_words_are_read_alike() -> None:
    assert read_as(r"x = 0 \iff e^x = 1") == "x == 0 <=> E**x == 1"
    assert read_as("x == 0 iff exp(x) == 1") == "x == 0 <=> exp(x) == 1"
    assert read_as("exp(x) is increasing in x") == "increasing(exp(x), x)"
    assert in_latex("exactly one x in (0, oo): x == a given a > 0") == (
        r"\exists!\, x \in (0, \infty):\ x = a \quad (a > 0)"
    )


def test_names_are_still_checked() -> None:
    with pytest.raises(InputError, match="xy is no known name"):
        need_variables("xy > 0 and x > 0")
    need_variables("exactly one angle in (0, 1): angle == 1/2")


def test_a_witness_of_several_solutions_is_one() -> None:
    answer = tresym.check("exactly one x in (-oo, oo): x**3 - 3*x == a", suggest=False)
    assert answer.witness is not None
    roots = mpmath.polyroots([1, 0, -3, -mpmath.mpf(int(answer.witness["a"]))])
    assert sum(abs(mpmath.im(root)) < 1e-9 for root in roots) > 1
