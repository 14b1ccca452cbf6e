"""Claims along a path: true ones hold, false ones are refuted, and none is proved of nothing."""

import pytest

from tresym.asymptotics.path_claims import (
    _by_exact_limit,
    _by_signs,
    _from_somewhere_on,
    allows,
)
from tresym.reals.decisions.answer import Answer
from tresym.reals.decisions.claim_parsing import read
from tresym.reals.decisions.statement import Statement
from tresym.reals.domain.conditions import Given
from tresym.reals.language.calls import INFINITY
from tresym.reals.language.comparisons import LIMIT, Comparison
from tresym.reals.language.expression import ZERO
from tresym.reals.language.parsing import parse
from tresym.reals.language.paths import Path
from tresym.reals.verdict import Verdict


@pytest.mark.parametrize(
    ("relation", "value", "allowed", "forbidden"),
    [
        ("->", "3", (), ("oo", "-oo", "2", "a")),
        ("o", "", ("0", "a - a"), ("1", "a", "oo", "-oo")),
        ("omega", "", ("0",), ("1", "a", "oo")),
        ("~", "", ("1", "a/a"), ("0", "a", "-1", "oo")),
        ("O", "", ("0", "7", "-a"), ("oo", "-oo")),
        ("Theta", "", ("7", "-a"), ("0", "a - 1", "oo", "-oo")),
        ("<", "", ("-1", "-oo", "-a"), ("0", "1", "oo", "a - 1")),
        ("<=", "", ("-1", "-oo"), ("0", "1", "oo")),
        (">", "", ("1", "oo", "a"), ("0", "-1", "-oo", "1 - a")),
        (">=", "", ("1", "oo"), ("0", "-1", "-oo")),
        ("!=", "", ("1", "-a", "oo", "-oo"), ("0", "a - 1")),
    ],
)
def test_what_a_limit_allows(
    relation: str, value: str, allowed: tuple[str, ...], forbidden: tuple[str, ...]
) -> None:
    """A limit of 0 shows no inequality, and an infinite one no order."""
    given, right = Given.parse("a > 0"), parse(value or "1")
    for text, expected in [*((e, True) for e in allowed), *((e, False) for e in forbidden)]:
        limit = {"oo": INFINITY, "-oo": -INFINITY}.get(text) or parse(text)
        assert allows(LIMIT if value else relation, limit, right, given) is expected, text


SIDES = {"oo": Path("x", None, (1,)), "-oo": Path("x", None, (-1,)), "0": Path("x", ZERO, (1, -1))}


def test_an_exact_limit_is_one_from_each_side() -> None:
    for says, end, holds in (
        ("a*atan(1/x) -> a*pi/2", "0+", True),
        ("a*atan(1/x) -> a*pi/2", "0", False),
        ("a*atan(1/x) -> -a*pi/2", "0", False),
        ("a*sin(x)/x -> a", "0", True),
    ):
        statement = read(says, "", f"x -> {end}")
        assert statement.path is not None
        (claim,) = statement.comparisons
        found = _by_exact_limit(claim, statement.path, statement.given)
        assert (found is not None) is holds
        assert found is None or "left side" in found.why
    ratio = read("a*x == O(x)", "a > 0", "x -> 0+")
    assert ratio.path is not None
    found = _by_exact_limit(ratio.comparisons[0], ratio.path, ratio.given)
    assert found is not None
    assert "ratio" in found.why


@pytest.mark.parametrize(
    ("end", "failing", "verdict"),
    [
        ("oo", (), Verdict.PROVED),
        ("oo", (1, 10), Verdict.PROVED),  # from a later place on
        ("oo", (1, 10, 1000), Verdict.UNDECIDED),
        ("0", (), Verdict.PROVED),
        ("0", (1, 10, 1000), Verdict.UNDECIDED),
        ("0", (-1, -10, -1000), Verdict.UNDECIDED),  # on one of the two sides
        ("0", (1, -10), Verdict.PROVED),
    ],
)
def test_what_holds_from_somewhere_on_is_asked_on_each_side(
    end: str, failing: tuple[int, ...], verdict: Verdict
) -> None:
    statement = read("x**2*(2 + sin(exp(1/x))) > a**2*0", "", f"x -> {end}")
    claim, path = statement.comparisons[0], SIDES[end]

    def decided(_: Comparison, inside: Statement) -> Answer:
        assert inside.path is None
        low, high = inside.given.box["x"].low, inside.given.box["x"].high
        place = low if path.point is None else 1 / high if low == 0 else 1 / low
        return Answer(Verdict.REFUTED if place in failing else Verdict.PROVED, "")

    assert _from_somewhere_on(claim, path, statement, decided).verdict is verdict


def test_each_sign_of_a_parameter_counts() -> None:
    """False for one sign alone, where points that are tried before would have told."""
    for says, holds in (("a", True), ("abs(a)", False), ("-abs(a)", False), ("a + 0/a", False)):
        statement = read(f"sin(a*x)/sin(b*x) -> ({says})/b", "b != 0", "x -> 0")
        assert statement.path is not None
        (claim,) = statement.comparisons
        assert (_by_signs(claim, statement.path, statement.given) is not None) is holds
