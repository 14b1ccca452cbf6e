"""Sums, products and derivatives of order n: induction needs its base and its step."""

import pytest

import tresym
from tresym.checking.dispatch import _bounded
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.induction import _end, _induction, _tends
from tresym.reals.domain.conditions import Given
from tresym.reals.language.parsing import parse
from tresym.reals.verdict import Verdict

HOLD = [
    "sum(k, k, 1, n) == n*(n + 1)/2",
    "sum(k**3, k, 1, n) == sum(k, k, 1, n)**2",
    "sum(x**k, k, 0, n) == (1 - x**(n + 1))/(1 - x) given x != 1",
    "sum(1/(k*(k + 1)), k, 1, n) == n/(n + 1)",
    "product(1 - 1/k**2, k, 2, n) == (n + 1)/(2*n)",
    "sum((-1)**k, k, 0, n) == (1 + (-1)**n)/2",
    "sum(sin(k*x), k, 1, n) == sin(n*x/2)*sin((n + 1)*x/2)/sin(x/2)",
    "sum(1/k**2, k, 1, n) <= 2 - 1/n given n >= 1",
    "sum(k, k, 1, n) > 0 given n >= 1",
    "sum(k, k, 1, n) > 0 given n > 0",
    "sum(1/k, k, 1, n) == 2*sum(1/k, k, 1, n) - sum(1/k, k, 1, n)",
    "sum(a*k + b, k, 1, n) == a*n*(n + 1)/2 + b*n",
    "sum(2**k, k, 0, n - 1) == 2**n - 1",
    "product(2, k, 1, n) == 2**n",
    "sum(k*factorial(k), k, 1, n) == factorial(n + 1) - 1",
    "sum(k/factorial(k + 1), k, 1, n) == 1 - 1/factorial(n + 1)",
    "product(2*k - 1, k, 1, n) == factorial(2*n)/(2**n*factorial(n))",
    "sum(k, k, 1, 10) == 55",
    "sum(k, k, 1, 0) == 0",
    "product(k, k, 1, 0) == 1",
    "sum(sum(j, j, 1, 3)*k, k, 1, 4) == 60",
    "sum(k*k_1, k, 1, 3) == 6*k_1",
    "sum(x**k, k, 0, oo) == 1/(1 - x) given abs(x) < 1",
    "sum(k*x**k, k, 1, oo) == x/(1 - x)**2 given abs(x) < 1",
    "sum((-1)**k/2**k, k, 0, oo) == 2/3",
    "sum(1/(k*(k + 1)), k, 1, oo) == 1",
]
FAIL = [
    "sum(n, k, 1, n) == n*(n - 1)/2",
    "sum(k, k, 1, n) == n*(n + 1)/3",
    "sum(x**k, k, 0, n) == (1 - x**n)/(1 - x) given x != 1",
    "sum(k, k, 1, n) == n*(n + 1)/2 + (n - 1)*(n - 2)*(n - 3)*(n - 4) given n >= 1",
    "product(k + 1, k, 1, n) == n*(n + 1)",
    "sum(k*factorial(k), k, 1, n) == factorial(n + 1)",
    "sum(k/factorial(k + 1), k, 1, n) == 1 - 1/factorial(n)",
    "sum(k, k, 1, 10) == 56",
    "sum(x**k, k, 1, oo) == 1/(1 - x) given abs(x) < 1",
    "sum(1/(k*(k + 1)), k, 1, oo) == 2",
    "sum(k, k, 1, n) < 100 given n >= 1",
    "sum(k, k, 1, n) == n*(n + 1)/2 + 1 given n >= 3",
]
OPEN = [
    "sum(k, k, 1, n) > 0",  # of no term it is 0: from where on is not said
    "sum(k, k, 1, n) == sum(k, k, 1, m)",
    "sum(k, k, 5, 1) == 0",
    "sum(1/k**3, k, 1, 1000000) == 1",
    "sum(k, k, 1, n/2) == 1",
    "sum(1/(k - 3), k, 1, n) == 1 given n >= 3",  # a term is not defined
]
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
ORDERS_HOLD = [
    "diff(log(x), x, n) == (-1)**(n - 1)*factorial(n - 1)*x**(-n) given n integer, n >= 1",
    "diff(sin(x), x, n) == sin(x + n*pi/2) given n integer, n >= 0",
    "diff(exp(a*x), x, n) == a**n*exp(a*x)",
    "diff(1/(1 - x), x, n) == factorial(n)/(1 - x)**(n + 1)",
    "diff(x*exp(x), x, n) == (x + n)*exp(x)",
    "diff(1/sqrt(x), x, n) == (-1)**n*factorial(2*n)/(4**n*factorial(n))*x**(-1/2 - n)",
    "diff(2**x, x, n) == log(2)**n*2**x",
    r"\frac{d^n}{dx^n}\cos x=\cos\left(x+\frac{n\pi}{2}\right)",
    r"\frac{d^{n}}{dx^{n}}\ln(1+x)=(-1)^{n-1}\frac{(n-1)!}{(1+x)^{n}} \text{ for } n \ge 1",
]
ORDERS_FALSE = [
    "diff(log(x), x, n) == (-1)**n*factorial(n - 1)*x**(-n) given n integer, n >= 1",
    "diff(log(x), x, n) == (-1)**(n - 1)*factorial(n)*x**(-n) given n integer, n >= 1",
    "diff(sin(x), x, n) == cos(x + n*pi/2)",
    "diff(sin(x), x, n) == sin(x + n*pi/2) + n*(n - 1)*(n - 2)",
    "diff(exp(a*x), x, n) == n*a*exp(a*x) given n >= 1",
    "diff(x*exp(x), x, n) == (x + 2*n)*exp(x)",
]
ORDERS_NEVER = [
    "diff(log(x), x, n) == (-1)**(n - 1)*factorial(n - 1)*x**(-n)",  # n = 0 has none
    "diff(sin(x), x, n) == sin(x + n*pi/2) + n*(n - 1)*(n - 2)*(n - 3)*(n - 4)",
    "diff(sin(x), x, n/2) == sin(x)",
    "diff(sin(x), x, n) <= 1",
    # nothing is said at n = 20 and 21, so nothing follows beyond
    "diff(exp(x), x, n) == exp(x)*((3 + sign(n - 41/2))/2 + sqrt((n - 199/10)*(n - 211/10))"
    " - sqrt((n - 199/10)*(n - 211/10)))",
    # at x = 0 the right side has a value and no derivative
    "diff(exp(x), x, n) == exp(x) + (abs(n - 10) + n - 10)*(1 - sign(x)) + sqrt(x) - sqrt(x)",
    "diff(exp(x), x, n) == exp(x) + (abs(n - 10) + n - 10)*(1 - sign(x)) + asin(x - 1)"
    " - asin(x - 1)",
    "diff(exp(x), x, n) == exp(x) + x**(n/2) - x**(n/2)",
    # what is said of n is another thing at n + 1
    "diff(exp(x), x, n) == exp(x) + n*(n - 1)*(n - 2)*(n - 3)*(n - 4)*(m - 2*n + 2) given m == 2*n",
    "diff(sin(x), x, n)**2 == sin(x)**2",
]


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
    [
        ("1 - (1/2)**n", "1"),
        ("2 - (n + 2)*(1/2)**n", "2"),
        ("exp(n)*(1/2)**n", None),
        ("1/(1 + exp(n)*(1/2)**n)", None),
        ("1/(1 + exp(n)*(1/2)**n) + n**3*(1/2)**n", None),
        ("sin((1/2)**n*exp(n))", None),
        ("2**n", None),
        ("(-1)**n", None),
        ("n", None),
        ("(1/2)**n + (1/3)**n", None),
        ("n**n", None),
    ],
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
