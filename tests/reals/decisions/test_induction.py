"""Sums, products and derivatives of order n: induction needs its base and its step."""

import pytest
from cases import cases

import tresym
from tresym.checking.dispatch import _bounded
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.induction import _end, _induction, _tends
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

FAIL = cases(__file__, "FAIL")
ORDERS_HOLD = cases(__file__, "ORDERS_HOLD")
ORDERS_FALSE = cases(__file__, "ORDERS_FALSE")


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_is_refuted_at_some_n(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


def test_what_is_said_of_n_is_another_thing_at_n_plus_one() -> None:
    product = "*".join(f"(n - {k})" for k in range(9))
    false = f"2*sum(1/k, k, 1, n) == 2*sum(1/k, k, 1, n) + {product}*(m - 2*n + 2)"
    assert not tresym.check(false, given="m == 2*n")
    true = "sum(1/k, k, 1, n) == sum(1/k, k, 1, n)*(m - 2*n + 1)"
    assert tresym.check(true, given="m == 2*n").verdict is not Verdict.REFUTED
    assert tresym.check("sum(m, k, 1, n) == 2*n**2", given="m == 2*n")
    one = "2*sum(1/k, k, 1, n + 1) - 2/(n + 1) == 2*sum(1/k, k, 1, n)"
    false = f"{one} + (1 + sign(x - 9))*(1 + sign(n - x))"
    assert not tresym.check(false, given="x < n")


@pytest.mark.parametrize(
    ("claim", "least"),
    [
        ("sum(k, k, 1, n) == n*(n + 1)/2 + 1", 0),  # the step holds, the base does not
        ("sum(k, k, 1, n) == n", 0),  # the base holds, the step does not
        ("sum(k, k, 1, n) == n**2", 1),
    ],
)
def test_induction_needs_its_base_and_its_step(claim: str, least: int) -> None:
    statement = read(claim, "n integer")
    (comparison,) = statement.comparisons
    assert not _induction(comparison, statement, "n", least, _bounded)


def test_terms_that_know_the_end_are_not_added_to_what_was() -> None:
    (comparison,) = read("sum(n, k, 1, n) == n*(n - 1)/2").comparisons
    assert _end(comparison.left) is None


@pytest.mark.parametrize(("least", "told"), [(-3, True), (0, True), (1, False), (3, False)])
def test_from_where_a_sum_is_spoken_of_is_told(least: int, told: bool) -> None:
    answer = tresym.check(f"sum(1, k, 1, n) == n given n integer, n >= {least}")
    assert answer.verdict is Verdict.PROVED
    assert ("below which no claim is made" in answer.why) is told


@pytest.mark.parametrize(
    ("form", "limit"),
    cases(__file__, "a_power_beats_powers_of_n_and_nothing_else"),
)
def test_a_power_beats_powers_of_n_and_nothing_else(form: str, limit: str | None) -> None:
    found = _tends(parse(form), "n", Given())
    assert found == (None if limit is None else parse(limit))


@pytest.mark.parametrize("claim", ORDERS_HOLD)
def test_derivatives_of_order_n(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.PROVED
    assert tresym.check(answer.read_as).verdict is Verdict.PROVED


@pytest.mark.parametrize("claim", ORDERS_FALSE)
def test_derivatives_of_order_n_that_are_false(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness
    assert "n" in answer.witness
