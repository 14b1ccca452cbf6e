"""Edits: each kind of misprint has its repair among the trees one edit away."""

import pytest
from cases import cases

from tresym.reals.language.parsing import parse, parse_claim
from tresym.repair.edits import SIGN, edits, is_one_edit


def one_edit_away(claim: str, indices: tuple[str, ...] = ()) -> list[str]:
    ((left, relation, right),) = parse_claim(claim)
    found = edits((left, right), (relation,), indices)
    return [f"{e.terms[0]} {e.relations[0]} {e.terms[1]}" for e in found]


@pytest.mark.parametrize(
    ("wrong", "right"),
    cases(__file__, "each_kind_of_misprint_is_one_edit"),
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
