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

HOLD = cases(__file__, "HOLD")
FAIL = cases(__file__, "FAIL")
OPEN = cases(__file__, "OPEN")
LATER = "2*sum(1/k, k, 1, n + 1) - 2/(n + 1) == 2*sum(1/k, k, 1, n) + 1 + sign(n - 41/2)"
"""True up to n = 20 and false from 21 on."""
GAPS = [
    f"{LATER} + {gap} - {gap}"
    for gap in (
        "sqrt((n - 199/10)*(n - 211/10))",
        "log((n - 199/10)*(n - 211/10))",
        "((n - 199/10)*(n - 211/10))**n",
        "1/sqrt((n - 199/10)*(n - 211/10))",
        "x**sqrt((n - 199/10)*(n - 211/10))",
    )
]
ORDERS_HOLD = cases(__file__, "ORDERS_HOLD")
ORDERS_FALSE = cases(__file__, "ORDERS_FALSE")
ORDERS_NEVER = cases(__file__, "ORDERS_NEVER")


@pytest.mark.parametrize("claim", HOLD)
def test_what_holds_of_sums(claim: str) -> None:
    assert tresym.check(claim).verdict in (Verdict.PROVED, Verdict.ENCLOSED)


@pytest.mark.parametrize("claim", FAIL)
def test_what_fails_is_refuted_at_some_n(claim: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.REFUTED
    assert answer.witness is not None


@pytest.mark.parametrize("claim", GAPS)
def test_an_induction_has_no_gap(claim: str) -> None:
    """At 20 and 21 nothing is said, so from 22 on nothing follows; it is false there."""
    assert not tresym.check(claim, given="n >= 1")


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
    ("zero", "given"),
    [("abs(x - n) - x + n", "x > n"), ("abs(n - 4) + abs(n - 6) - 2*abs(n - 5)", "n != 5")],
)
def test_what_is_true_where_it_is_claimed_is_never_refuted(zero: str, given: str) -> None:
    claim = f"2*sum(1/k, k, 1, n) == 2*sum(1/k, k, 1, n) + {zero}"
    assert tresym.check(claim, given=given).verdict is not Verdict.REFUTED


@pytest.mark.parametrize("claim", OPEN)
def test_what_is_not_spoken_of_is_not_decided(claim: str) -> None:
    assert tresym.check(claim).verdict is Verdict.UNDECIDED


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


@pytest.mark.parametrize(
    "claim",
    [
        "sum(1/k, k, 1, n) -> 5 as n -> oo",
        "sum(k, k, 1, n) == O(n) as n -> oo",
        "sum(k, k, 1, n + 1/2) == (n + 1)*(n + 2)/2",  # to n + 1, if halves were dropped
        "sum(k, k, 1, 5/2) == 15",
        "sum(integral(x*k, x, 0, n), k, 1, n) == n**2/2",
    ],
)
def test_what_is_no_sum_from_an_integer_to_an_integer_does_not_pass(claim: str) -> None:
    assert not tresym.check(claim)


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


@pytest.mark.parametrize(
    ("claim", "verdict"),
    [
        ("sum(k, k, 1, 300) == 45150", "PROVED"),
        ("sum(k, k, 1, 300) == 45151", "REFUTED"),
        ("sum(1/(k*(k + 1)), k, 1, 5000) == 5000/5001", "PROVED"),
        ("sum(1/sqrt(k), k, 1, n) <= 2*sqrt(n) given n integer, n >= 1", "ENCLOSED"),
        ("sum(1/sqrt(k), k, 1, n) <= 2*sqrt(n) - 6/5 given n integer, n >= 1", "REFUTED"),
        ("sum(1/k, k, 1, n) >= log(n + 1) given n integer, n >= 1", "ENCLOSED"),
        ("sum(1/k, k, 1, n) >= 1 + log(n) given n integer, n >= 1", "REFUTED"),
        ("product(1 - 1/(2*k), k, 1, n) <= 1/sqrt(3*n + 1) given n integer, n >= 1", "PROVED"),
        # each step is right for S = -100 alone: factors are negative
        ("product(k - 5, k, 1, n) >= -100 given n integer, n >= 1", "UNDECIDED"),
        ("product(-k, k, 1, n) <= 1 given n integer, n >= 1", "REFUTED"),
        ("product(1 - 1/k**2, k, 2, oo) == 1/2", "PROVED"),
        ("product(1 - 1/k**2, k, 2, oo) == 1/3", "REFUTED"),
        ("product(1 - 1/k, k, 2, oo) == 1/2", "REFUTED"),
        ("product(1 + 1/k, k, 1, oo) == 2", "UNDECIDED"),
    ],
)
def test_inequalities_by_their_steps_and_long_sums(claim: str, verdict: str) -> None:
    assert tresym.check(claim).verdict.value == verdict


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


def test_what_is_true_of_an_order_is_never_refuted() -> None:
    answer = tresym.check("diff(exp(x), x, n) == exp(x)*(m - 2*n + 1)", given="m == 2*n")
    assert answer.verdict is Verdict.UNDECIDED
    answer = tresym.check("diff(exp(x), x, n) == exp(x) + abs(x - n) - x + n", given="x > n")
    assert answer.verdict is Verdict.UNDECIDED


@pytest.mark.parametrize("claim", ORDERS_NEVER)
def test_derivatives_of_order_n_that_are_not_proved(claim: str) -> None:
    assert not tresym.check(claim)
