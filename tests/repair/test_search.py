"""What is true instead: each suggestion holds, and the likeliest comes first."""

import pytest
from cases import cases

import tresym
from tresym.reals.language.parsing import parse
from tresym.repair import check, suggestions
from tresym.repair.search import alternatives

LONG = 20.0


def first(claim: str) -> str:
    found = alternatives(claim, LONG)
    return f"{found[0].claim} given {found[0].given}".removesuffix(" given ") if found else ""


@pytest.mark.parametrize(
    ("claim", "right"),
    cases(__file__, "the_first_suggestion_is_the_right_one"),
)
def test_the_first_suggestion_is_the_right_one(claim: str, right: str) -> None:
    assert first(claim) == right


def test_every_suggestion_is_decided_like_any_claim() -> None:
    for found in alternatives("sin(3*x) == 3*sin(x) + 4*sin(x)**3", LONG):
        again = check(found.claim, found.given, suggest=False)
        assert again.verdict.value == found.verdict


@pytest.mark.parametrize(
    "equation",
    [
        *("x**2 - 5*x + 6 == 0", "tan(x) == x", "sin(2*x) == sin(x)", "cos(2*x) == cos(x)"),
        *("x**2 + y**2 == 1", "p*V == n*R*T", "exp(x) == 3*x", "x == cos(x)", "x**2 == 2*x"),
        *("sqrt(x + 1) == x - 1", "a**2 + b**2 == c**2", "1/x + 1/(x + 1) == 1", "x**2 == x"),
        *("abs(x - 1) == 2", "x*exp(x) == 1", "x + 1/x == 3"),
    ],
)
def test_an_equation_to_be_solved_has_no_repair(equation: str) -> None:
    assert alternatives(equation, LONG) == ()


def test_no_condition_empties_a_sum_or_repeats_the_claim() -> None:
    assert not any("n" in f.given for f in alternatives("sum(c*x, k, 1, n) == 0", LONG))
    assert not any(f.given == "x >= 1" for f in alternatives("x >= 1", LONG))


def test_symbols_that_stand_for_something_are_kept() -> None:
    put = (("r", parse("sqrt(a**2 + b**2)")),)
    found = alternatives("r**2 == a**2 - b**2", LONG, put=put)
    assert found[0].claim == "r**2 == a**2 + b**2"


def test_caution_finds_nothing_beside_what_may_hold() -> None:
    assert alternatives("x**2 + y**2 <= 1", LONG, cautious=True) == ()
    assert alternatives("sin(x)**2 + cos(x)**2 == 1", LONG, cautious=True) == ()


def test_suggestions_come_in_order_and_none_where_nothing_is_read() -> None:
    asked = [("sqrt(x**2) == x", (), False, True), ("what is this", (), False, True)]
    one, none = suggestions(asked, 1, LONG)
    assert one[0].given == "x >= 0"
    assert none == ()


def test_check_suggests_unless_told_not_to() -> None:
    assert tresym.check("sqrt(x**2) == x").instead[0].given == "x >= 0"
    assert tresym.check("sqrt(x**2) == x", suggest=False).instead == ()
    assert tresym.check("sqrt(x**2) == abs(x)").instead == ()
    json = tresym.check("sqrt(x**2) == x").as_json()["instead"][0]
    assert sorted(json) == ["claim", "edit", "given", "verdict"]


@pytest.mark.parametrize(
    ("claim", "why"),
    [
        ("sin(x) == x - x**3/4 + O(x**5) as x -> 0", "the coefficient of x**3 is -1/6, not -1/4"),
        ("sqrt(1 + x) ~ 1 + x/3 as x -> 0", "the coefficient of x is 1/2, not 1/3"),
        ("exp(x) == 2 + x + O(x**2) as x -> 0", "the expansion is x + 1"),
    ],
)
def test_a_wrong_coefficient_is_named(claim: str, why: str) -> None:
    found = alternatives(claim, LONG)
    assert any(one.edit.startswith(why) for one in found)


@pytest.mark.slow
@pytest.mark.parametrize(
    ("claim", "true"),
    [
        (
            "Ei(x) == exp(x)/x*(1 - 1/x + O(1/x**2)) as x -> oo",
            "Ei(x) == exp(x)/x*(1 + 1/x + O(x**(-2)))",
        ),
        (
            "factorial(n) == sqrt(2*pi*n)*(n/E)**n*(1 + 1/(6*n) + O(1/n**2)) as n -> oo",
            "factorial(n) == sqrt(2*pi*n)*(n/E)**n*(1 + 1/(12*n) + O(n**(-2)))",
        ),
        (
            "erfc(x) == exp(-x**2)/(2*x*sqrt(pi))*(1 + O(1/x**2)) as x -> oo",
            "erfc(x) == exp(-x**2)/(sqrt(pi)*x)*(1 + O(x**(-2)))",
        ),
        (
            "cosh(x) == exp(x)*(1 + O(exp(-2*x))) as x -> oo",
            "cosh(x) == exp(x)*(1 + O(exp(-2*x)))/2",
        ),
    ],
)
def test_a_misprint_in_a_product_with_an_order_is_named(claim: str, true: str) -> None:
    assert true in [one.claim for one in alternatives(claim, LONG)]
