"""Edits: each kind of misprint has its repair among the trees one edit away."""

import pytest

from tresym.reals.language.parsing import parse, parse_claim
from tresym.repair.edits import SIGN, edits, is_one_edit


def one_edit_away(claim: str, indices: tuple[str, ...] = ()) -> list[str]:
    ((left, relation, right),) = parse_claim(claim)
    found = edits((left, right), (relation,), indices)
    return [f"{e.terms[0]} {e.relations[0]} {e.terms[1]}" for e in found]


@pytest.mark.parametrize(
    ("wrong", "right"),
    [
        ("cos(2*x) == 2*cos(x)**2 + 1", "cos(2*x) == 2*cos(x)**2 - 1"),  # + and -
        ("sin(-x) == sin(x)", "sin(-x) == -sin(x)"),  # a sign in front
        ("exp(x - y) == exp(x)*exp(y)", "exp(x - y) == exp(x)*1/exp(y)"),  # times and divided by
        ("tan(2*x) == 3*tan(x)/(1 - tan(x)**2)", "tan(2*x) == 2*tan(x)/(1 - tan(x)**2)"),  # ±1
        ("log(x**4) == 2*log(x**2)*x/x", "log(x**4) == 4*log(x**2)*x/x"),  # doubled
        ("2*x == 21*x", "2*x == 12*x"),  # digits swapped
        ("(x + y)**2 == x**2 + 2*x*y + y**3", "(x + y)**2 == x**2 + 2*x*y + y**2"),  # an exponent
        ("sin(2*x) == 2*sin(x)*sin(x)", "sin(2*x) == 2*sin(x)*cos(x)"),  # a function's partner
        ("sinh(2*x) == 2*sin(x)*cosh(x)", "sinh(2*x) == 2*sinh(x)*cosh(x)"),
        ("1 + tan(x)**2 == csc(x)**2", "tan(x)**2 + 1 == sec(x)**2"),
        ("asin(x) + asin(x) == pi/2", "acos(x) + asin(x) == pi/2"),
        ("log(x*y) == log(x) + log(x)", "log(x*y) == log(x) + log(y)"),  # a variable
        ("x == sin(x)", "x == 2*sin(x)"),  # a factor
        ("x == 2*sin(x)", "x == sin(x)"),
        ("x == sin(x)", "x == sin(pi*x)"),
        ("cos(x) == 1 - 2*sin(x/2)", "cos(x) == 1 - 2*sin(x/2)**2"),  # a square
        ("abs(x) == x**2", "abs(x) == sqrt(x**2)"),  # a root
        ("tan(x) == cot(x)", "tan(x) == 1/cot(x)"),  # a reciprocal
        ("sqrt(x**2) == x", "sqrt(x**2) == abs(x)"),  # bars
        ("(1 - x)/(1 + x) == x", "(x + 1)/(1 - x) == x"),  # upside down
        ("sum(k, k, 0, n) == n", "sum(k, k, 1, n) == n"),  # an end
        ("sum(k, k, 1, n) == n", "sum(k, k, 1, n - 1) == n"),
        ("integral(x**2, x, 0, 1) == 1/2", "integral(x, x, 0, 1) == 1/2"),
        ("x < x**2", "x <= x**2"),  # relations
        ("x < x**2", "x > x**2"),
        ("sin(x) == x + O(x**4)", "sin(x) == x + O(x**3)"),
    ],
)
def test_each_kind_of_misprint_is_one_edit(wrong: str, right: str) -> None:
    ((left, relation, side),) = parse_claim(right)
    assert f"{left} {relation} {side}" in one_edit_away(wrong, ("n",))


def test_the_usual_misprints_come_first() -> None:
    first = one_edit_away("cos(2*x) == 2*cos(x)**2 + 1")[:3]
    assert "cos(2*x) == 2*cos(x)**2 - 1" in first


def test_a_sign_in_front_of_a_sum_is_less_usual_than_one_inside() -> None:
    ((left, relation, right),) = parse_claim("x == y - z")
    ranks = {str(e.terms[1]): e.rank for e in edits((left, right), (relation,))}
    assert ranks.get("y + z", SIGN) < ranks.get("-(y - z)", 9)


def test_no_edit_leaves_the_statement_as_it_is() -> None:
    claim = "sin(x)**2 + cos(x)**2 == 1"
    assert str(parse(claim.split(" == ")[0])) + " == 1" not in one_edit_away(claim)


def test_of_an_equality_with_a_lone_variable_variables_alone_are_changed() -> None:
    """p*V = n*R*T is no identity whatever sign or number is another one."""
    assert all("**" not in text and "-" not in text for text in one_edit_away("p*V == n*R*T"))


def test_infinity_is_no_variable() -> None:
    assert not any("x_1, x" in text for text in one_edit_away("limit(a/x, x, oo) == a"))
    assert all("oo" in text for text in one_edit_away("limit(a/x, x, oo) == a"))


@pytest.mark.parametrize(
    ("one", "other", "expected"),
    [("m*c**2", "m*c**3", True), ("m*c**2", "m*c**2", False), ("x**2", "2*x + 1", False)],
)
def test_whether_two_definitions_are_one_edit_apart(one: str, other: str, expected: bool) -> None:
    assert is_one_edit(parse(one), parse(other)) is expected
