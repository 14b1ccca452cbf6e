"""Equalities with derivatives: judged where what is differentiated is real, and there alone."""

import pytest
from cases import cases
from flint import fmpq

from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.equalities import FORMAL, NOWHERE, _is_real, decide_equality
from tresym.reals.decisions.identity import Decision
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

PROVED, REFUTED = Verdict.PROVED, Verdict.REFUTED


def decided(claim: str) -> Decision:
    statement = read(claim)
    (found,) = statement.comparisons
    return decide_equality(found.left, found.right, statement.given, found.differentiated, found.by)


@pytest.mark.parametrize(
    ("true", "false"),
    cases(__file__, "a_claim_and_a_false_one"),
)
def test_a_claim_and_a_false_one(true: str, false: str) -> None:
    assert decided(true).verdict is PROVED
    refuted = decided(false)
    assert refuted.verdict is REFUTED
    assert refuted.values is not None
    assert not refuted.values[0].overlaps(refuted.values[1])


@pytest.mark.parametrize(
    "claim",
    [
        "diff(log(-1 - x**2), x) == 2*x/(1 + x**2)",
        "diff(log(x), x) == 1/x given x < 0",
        "diff(atanh(x), x) == 1/(1 - x**2) given x > 2",
    ],
)
def test_a_proof_of_formal_derivatives_says_so(claim: str) -> None:
    found = decided(claim)
    assert found.verdict is PROVED
    assert FORMAL in found.why


@pytest.mark.parametrize(
    "claim",
    [
        "diff(log(-1 - x**2), x) == 2*x/(1 + x**2) + 1",
        "diff(log(x), x) == 2/x given x < 0",
    ],
)
def test_nothing_is_refuted_where_no_function_is_real(claim: str) -> None:
    found = decided(claim)
    assert found.verdict is Verdict.UNDECIDED
    assert NOWHERE in found.why


def test_a_proof_names_a_point_at_which_the_function_is_real() -> None:
    found = decided("diff(sqrt(3 - x), x) == -1/(2*sqrt(3 - x))")
    assert "the differentiated functions are real at x = 441/388" in found.why
    found = decided("diff(log(x) + log(y), x) == 1/x")  # the sides are defined at a negative y
    assert "the differentiated functions are real at x = " in found.why


def test_points_at_which_a_function_is_not_real_refute_nothing() -> None:
    """The sides differ for x < 0 alone, or at 0 alone, where x**(3/2) has no two sides."""
    assert decided("diff(log(x), x) == 1/x + abs(x) - x").verdict is PROVED
    assert decided("diff(sqrt(x)**3, x)*0 == sign(x) - 1 given x > -1").verdict is not REFUTED


@pytest.mark.parametrize(
    ("functions", "by", "expected"),
    [
        (["x", "log(x + 2)"], ["x"], True),
        (["x", "log(x)"], ["x"], False),
        (["log(x)", "x"], ["x"], False),
        (["sqrt(x + 1)"], ["x"], False),
        (["sqrt(x + 1)"], [], True),
        (["x + z"], ["x"], False),
    ],
)
def test_every_function_is_real_at_a_point_and_beside_it(
    functions: list[str], by: list[str], expected: bool
) -> None:
    assert _is_real(list(map(parse, functions)), by, {"x": fmpq(-1)}) is expected
