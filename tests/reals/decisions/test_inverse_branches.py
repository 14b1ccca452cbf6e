"""Inverse functions by their branches: on the branch, and one step beside it."""

import pytest
from cases import cases

import tresym
from tresym.reals.decisions.identity import decide, decide_continuous
from tresym.reals.decisions.inverse_branches import _holds, without_inverse
from tresym.reals.domain.conditions import Given
from tresym.reals.language.expression import Expr
from tresym.reals.language.parsing import parse, parse_claim
from tresym.reals.normal.field import ALL_THEORIES
from tresym.reals.verdict import Verdict

pytestmark = pytest.mark.quick


def _pairs(claim: str) -> list[tuple[Expr, Expr]]:
    body, _, given = claim.partition(" given ")
    ((left, _, right),) = parse_claim(body)
    return list(without_inverse(left, right, Given.parse(given), ALL_THEORIES))


@pytest.mark.parametrize(
    ("claim", "pair"),
    [
        ("asin(sin(7/2)) == pi - 7/2", ("sin(-7/2 + pi)", "sin(7/2)")),
        ("pi/8 == atan(sqrt(2) - 1)", ("tan(pi/8)", "sqrt(2) - 1")),
        ("2*acos(x) == 1 given x > 0", ("cos(1/2)", "x")),
        ("acos(cos(x)) == 2*pi - x given pi <= x <= 2*pi", ("cos(2*pi - x)", "cos(x)")),
        ("2*log(x) == y + 1", ("exp(y/2 + 1/2)", "x")),
        ("y == asinh(x)", ("sinh(y)", "x")),
        ("y == 3*asin(x) given -1/2 <= x <= 1/2, 0 <= y <= 3*pi/2", ("sin(y/3)", "x")),
    ],
)
def test_the_inverse_function_is_taken_away(claim: str, pair: tuple[str, str]) -> None:
    assert tuple(map(parse, pair)) in _pairs(claim)


@pytest.mark.parametrize(
    "claim",
    cases(__file__, "it_is_not_beyond_its_range"),
)
def test_it_is_not_beyond_its_range(claim: str) -> None:
    assert _pairs(claim) == []


@pytest.mark.parametrize(
    ("end", "relation", "given", "holds"),
    cases(__file__, "bounds_of_an_inverse_by_those_of_its_argument"),
)
def test_bounds_of_an_inverse_by_those_of_its_argument(
    end: str, relation: str, given: str, holds: bool
) -> None:
    assert _holds(parse(end), relation, Given.parse(given)) is holds


def test_it_is_used_where_its_theories_are() -> None:
    sides = parse("acos((1 + sqrt(5))/4)"), parse("pi/5")
    assert decide(*sides).verdict is Verdict.PROVED
    for left_out in ("trigonometry", "inverses"):
        found = decide(*sides, theories=ALL_THEORIES - {left_out})
        assert found.verdict is Verdict.UNDECIDED


def test_a_logarithm_is_taken_away_by_exponentials() -> None:
    sides = parse("asinh(2)"), parse("log(2 + sqrt(5)) + log(x**2)/2 - log(x)")
    plain = decide_continuous(*sides, Given.parse("x > 0"))
    assert plain.verdict is Verdict.PROVED
    assert len([*without_inverse(*sides, Given(), ALL_THEORIES)]) == 4
    for left_out in ("exponentials", "inverses"):
        assert not [*without_inverse(*sides, Given(), ALL_THEORIES - {left_out})]


@pytest.mark.parametrize(
    "claim", ["log(x) == asinh(x)", "log(-x)/2 == log(x**2)", "log(x) == 1 - x"]
)
def test_what_is_no_logarithm_of_it_is_not_proved(claim: str) -> None:
    ((left, _, right),) = parse_claim(claim)
    assert decide_continuous(left, right).verdict is not Verdict.PROVED


@pytest.mark.parametrize(
    ("claim", "part"),
    [
        ("tan(pi/2) == 1", "tan(pi/2)"),
        ("1/sin(pi) == 2", "1/sin(pi)"),
        ("cot(0) > 1", "cot(0)"),
        ("log(1 - sqrt(2)) < 0", "log(1 - sqrt(2))"),
        ("sqrt(-2) == 3", "sqrt(-2)"),
    ],
)
def test_what_is_not_defined_is_named(claim: str, part: str) -> None:
    answer = tresym.check(claim)
    assert answer.verdict is Verdict.UNDECIDED
    assert answer.why.startswith(f"{part} is undefined")


def test_a_range_that_an_inverse_never_reaches_is_not_read_off_its_argument() -> None:
    """asin x lies below 3π/2, though x is above sin(3π/2)."""
    given = Given.parse("0 <= x, x <= 1")
    sides = parse("asin(-x)"), parse("2*pi - asin(x)")
    assert not list(without_inverse(*sides, given, ALL_THEORIES))
