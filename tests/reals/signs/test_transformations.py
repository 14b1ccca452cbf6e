"""Inequalities equivalent to a given one: the same sign at every point, and none where not so."""

from collections.abc import Iterator

import pytest
from falsehoods import Inequality, is_false_at, read
from flint import arb

from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import ONE, Expr
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.signs import transformations as module
from tresym.reals.signs.interior import PROVING
from tresym.reals.signs.sign import sign
from tresym.reals.signs.transformations import Link, by_equivalents, equivalents, holds

FOUND = {
    "exp(x)*y >= z given y > 0, z > 0": "logarithms",
    "x**y > y**x given x > 0, y > 0": "logarithms",
    "2**x >= 3*exp(x)*y**2 given y > 0": "logarithms",
    "log(x) + log(y) >= 1 given x > 0, y > 0": "exponentials",
    "2*log(x) - log(1 + x**2)/2 >= 0 given x > 0": "exponentials",
    "log(x) < 3*log(y) + pi given x > 0, y > 0": "exponentials",
    "x*(y - 1) >= 0 given x > 0": "factors of known sign",
    "(y**2 - 1)/(1 + x**2) >= 0": "factors of known sign",
    "(1 - y)/x >= 0 given x < 0": "factors of known sign",
    "(x - y)**2*(x + y) >= 0": "factors of known sign",
    "x**6 - 2*x**3 + 2 > 0 given x >= 0": "x**3",
    "x**4 - 3*x**2*y + y >= 0": "x**2",
    "x**4*y - x**2 >= 1 given x >= 2, y > 3": "x**2",
    "exp(x**2) >= 1 + x**2": "x**2",
}


def _easier(inequality: Inequality) -> Iterator[tuple[Expr, Given, str]]:
    left, relation, right, given = inequality
    for links in equivalents(left - right, relation, given):
        if all(holds(link, relation) for link in links):
            yield links[-1].easy, links[-1].where, "".join(link.words for link in links)


def _points(inequality: Inequality) -> list[dict[str, arb]]:
    """Exact points of the conditions, in balls."""
    names = sorted({"x", "y", "z"})
    found = list(inequality.given.points(names, 30))
    assert len(found) == 30
    return [{name: arb(value) for name, value in point.items()} for point in found]


def _sign(e: Expr, at: dict[str, arb]) -> int:
    value = evaluate(e, at)
    return (1 if value > 0 else 0) - (1 if value < 0 else 0)


@pytest.mark.parametrize("claim", FOUND)
def test_what_is_easier_has_the_same_sign(claim: str) -> None:
    inequality = read(claim)
    kinds = [
        (difference, where, words)
        for difference, where, words in _easier(inequality)
        if FOUND[claim] in words
    ]
    assert kinds
    with ball_precision(300):
        for difference, where, words in kinds:
            for point in _points(inequality):
                moved = dict(point)
                if "written for" in words:
                    name, power = words.split("written for ")[1].rstrip(", ").split("**")
                    moved[name] = point[name] ** int(power)
                assert all(c.holds_exactly(moved) for c in where.conditions)
                assert _sign(difference, moved) == _sign(inequality.difference, point)


FALSE = {
    # logarithms of what is not positive
    "y*exp(x) >= 2*y given x >= 1": "x = 1, y = -1",
    "y*exp(x) >= 2*y given x >= 1, y >= -1/2": "x = 2, y = -1/2",
    "-exp(x) >= -exp(2*x)": "x = -1",
    # x**3 for x: not where x may be negative, nor where another condition has x
    "x**3 + 8 >= 0": "x = -3",
    "x**3 >= 0 given x > -1": "x = -1/2",
    "x**2 >= 1 given x >= -1": "x = 0",
    "x**3 >= -1 given x >= -2, y > 0": "x = -3/2, y = 1",
    "x**2 + y >= 5 given x >= 0, x + y >= 5": "x = 1/2, y = 9/2",
    "x**2 >= 2 given x >= 0, x**2 + x >= 2": "x = 1",
    "x**2 + y >= 2 given x + y >= 2": "x = 1/2, y = 3/2",
    # factors of one sign, of which the sign of none is forgotten
    "x*(y - 1)**3 >= 0 given x < 0, y > 1": "x = -1, y = 2",
    "(1 - x**2 - x**4)*y >= 0 given y > 0, x > 1": "x = 2, y = 1",
}


def _settles(claim: str) -> bool:
    """Whether the sign of an equivalent difference proves the claim."""
    inequality = read(claim)
    return any(
        sign(difference, where) in PROVING[inequality.relation]
        for difference, where, _ in _easier(inequality)
    )


@pytest.mark.parametrize("claim", FALSE)
def test_near_falsehoods_have_no_easier_form_that_is_true(claim: str) -> None:
    assert is_false_at(claim, FALSE[claim])
    assert not _settles(claim)


def _holds(hard: str, easy: str, scale: object, given: str = "", **more: str) -> bool:
    """Whether ``hard > 0`` under ``given`` follows from ``easy > 0``, or as ``relation`` says."""
    under = Given.parse(given)
    where = Given.parse(more.get("where", given))
    link = Link(parse(hard), under, parse(easy), where, scale, "")
    return holds(link, more.get("relation", ">"))


def test_links_that_hold() -> None:
    assert _holds("exp(x) - 2", "x - log(2)", parse("2"))
    assert _holds("log(x) + log(y)", "x*y - 1", ONE, "x > 0, y > 0")
    assert _holds("y*(x**2 + 1)", "y", None, relation=">=")
    assert _holds("x**4 - 2", "x**2 - 2", {"x": parse("x**2")}, where="x >= 0")


def test_a_link_that_does_not_hold_is_none() -> None:
    # the scale may be negative, or zero, or another number
    assert not _holds("y*(exp(x) - 1)", "x", parse("y"))
    assert not _holds("y**2*(exp(x) - 1)", "x", parse("y**2"))
    assert not _holds("exp(x) - 2", "x", ONE)
    # a factor has no sign, or may be zero where that counts
    assert not _holds("x*y", "y", None, relation=">=")
    assert not _holds("y*(x**2 + 1)", "y", None)
    # what is easier is not defined everywhere
    assert not _holds("exp(x) - 1", "sqrt(x)**2", ONE)
    assert not _holds("x", "sqrt(x)**2", None, relation=">=")
    assert not _holds("x**2", "sqrt(x - 5)**2 + 5", {"x": parse("x**2")})
    # a power does not meet the conditions, or makes another inequality
    assert not _holds("x**3 + 8", "x + 8", {"x": parse("x**3")}, where="x >= 0")
    assert not _holds("x**4 - 2", "x - 2", {"x": parse("x**2")}, where="x >= 0")


def test_an_easier_form_that_does_not_follow_proves_nothing(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    good = Link(parse("x*y"), Given.parse("y > 0"), parse("x"), Given.parse("y > 0"), None, "")
    bad = Link(parse("x"), Given.parse("y > 0"), parse("x**2"), Given.parse("y > 0"), None, "")
    for links, found in (((good,), "so it is"), ((bad,), None), ((good, bad), None)):
        monkeypatch.setattr(module, "equivalents", lambda *_, links=links: [links])
        proof = by_equivalents(parse("x*y"), ">=", Given.parse("y > 0"), lambda *_: "so it is")
        assert proof == found
