"""Orders decided from their formulas, and what a path must show before it refutes one."""

from dataclasses import replace
from typing import Any

import pytest
from derivations import by
from sympy import Function, Integer, Rational, Symbol, Tuple, exp, oo, sin, sqrt
from sympy_statements import ExactlyOne, equal, order

from tresym.ledger.claim import (
    Claim,
    Root,
)
from tresym.ledger.evidence import asymptotics
from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.evidence.asymptotics import Asymptotics, solved_for_order
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding
from tresym.ledger.formulas import in_trees
from tresym.ledger.judge import judge
from tresym.reals.decisions.identity import decide
from tresym.reals.verdict import Verdict

a, b, c, t, x, y = (Symbol(name, real=True) for name in "abctxy")
O, o = Function("O"), Function("o")  # noqa: E741


def finding(says: Any, proof: Any = None, *given: Any) -> Finding:
    claim = Claim("planted", "…", proof or Asymptotics(), given=given, means=says)
    found: dict[str, Finding] = {}
    for used in (*claim.rests_on, claim):
        found[used.label] = judge(used, found)
    return found[claim.label]


def verdict(says: Any, proof: Any = None, *given: Any) -> Verdict:
    return finding(says, proof, *given).verdict


@pytest.mark.parametrize(
    "says",
    [
        order(equal(sin(x), x + o(x**3)), x),
        order(equal(sin(x) / x, 1 + x * o(x)), x, side=0),
        order(equal(exp(-1 / x), O(x)), x, side=-1),
        order(equal(exp(-1 / x), O(x)), x, side=0),
        order(equal(x / (x + 2), 1 + o(1 / x)), x, oo),
    ],
)
def test_expansions_refute_an_order_in_one_variable(says: Any) -> None:
    found = finding(says, Asymptotics())
    assert found.verdict is Verdict.REFUTED
    assert found.parameter is not None
    assert found.witness is not None
    assert is_formal(Claim("formal", "…", Asymptotics(), means=says))


@pytest.mark.parametrize(
    "says",
    [
        equal(sin(x), x + O(x**3)),
        order(equal(sin(x), x), x),
        order(equal(sin(x), O(x) + O(x**2)), x),
        order(equal(sin(x), O(x) ** 2), x),
        order(equal(sin(x), sin(O(x))), x),
        order(equal(y * sin(x), O(x)), x),
        order(equal(sin(x), o(x)), x, y),
    ],
)
def test_what_is_no_order_in_one_variable_is_not_decided(says: Any) -> None:
    assert verdict(says) is Verdict.UNDECIDED


def test_conditions_that_decide_nothing_are_refused() -> None:
    false = order(equal(sin(x), o(x)), x)
    assert verdict(false, None, x > 1) is Verdict.UNDECIDED
    used = Claim("used", equal(x + x, 2 * x), by())
    assert verdict(false, Asymptotics(claims=(used,))) is Verdict.UNDECIDED


def test_the_order_meant_is_the_order_said() -> None:
    says = equal(sin(x), x + O(x**3))
    said = Claim("said", says, Decided(), means=order(says, x))
    assert judge(said, {}).verdict.holds
    other = replace(said, says=equal(sin(x), x + O(x**4)))
    assert "differs from the order in" in judge(other, {}).why


def test_an_equation_is_solved_for_its_order() -> None:
    found = solved_for_order(in_trees(equal(y, (x + o(a)) * b)))
    assert found is not None
    assert (found.relation, found.right) == ("o", in_trees(a * b))
    assert decide(found.left, in_trees(y - b * x)).verdict is Verdict.PROVED
    found = solved_for_order(in_trees(equal(y, x - 2 * O(a))))
    assert found is not None
    assert (str(found.left), found.relation, str(found.right)) == ("y - x", "O", "-2*a")


# -- along a path ---------------------------------------------------------------------------------

SQUARE = order(equal(x**2 / y, O(y)), Tuple(x, y), Tuple(0, 0), 0)
"""False: where x = √y, say, the left side is 1."""
PATH = Asymptotics({x: t, y: t**2})


def test_a_path_refutes_and_shows_nothing() -> None:
    found = finding(SQUARE, PATH, y > 0)
    assert found.verdict is Verdict.REFUTED
    assert found.witness is not None
    assert found.witness["y"] == found.witness["x"] ** 2
    assert verdict(SQUARE, Asymptotics({x: t**2, y: t}), y > 0) is Verdict.UNDECIDED
    assert verdict(order(equal(x**2 / y, O(x)), x), Asymptotics({x: t, y: t**3})) is Verdict.REFUTED
    irrational = finding(SQUARE, Asymptotics({x: sqrt(2) * t, y: t**2}), y > 0)
    assert irrational.verdict is Verdict.REFUTED
    assert irrational.witness is not None
    assert "x" not in irrational.witness


def test_a_path_is_in_all_conditions() -> None:
    assert verdict(SQUARE, PATH, y > 0, x > 0) is Verdict.REFUTED
    assert verdict(SQUARE, PATH, y > 0, x < 0) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("says", "along", "given"),
    [
        (SQUARE, {x: t, y: t**2}, y < 0),
        (SQUARE, {x: t, y: t**2}, y > 1),
        (SQUARE, {x: t, y: t**2}, x > y * 2 + 1),
        (SQUARE, {x: 1 + t, y: t**2}, y > 0),
        (SQUARE, {x: t, y: 1 + t}, y > 0),
        (SQUARE, {x: t}, y > 0),
        (SQUARE, {x: t, y: c * t**2}, c > 0),
        (SQUARE, {x: t, y: t**2, c: t}, c > 1),
        (order(equal(1 / x, O(y)), y, oo), {x: t, y: t}, x > 0),
        (order(equal(1 / x, O(y)), y, oo), {x: t, y: -1 / t}, x > 0),
        (order(equal(1 / x, O(y)), y), {x: t**2, y: -t}, x > 0),
        (order(equal(exp(-y), O(Integer(1))), y, oo), {y: -1 / t}, y < 0),
        (order(equal(x * y, O(x)), Tuple(x, y), Tuple(0, 0), 0), {x: t, y: 1 / t}, y > 0),
        (order(equal(1 / x, O(y)), y, side=-1), {x: t**2, y: t}, x > 0),
        (order(equal(1 / t, O(y)), y), {y: t}, y > 0),
    ],
)
def test_a_path_outside_the_statement_refutes_nothing(says: Any, along: Any, given: Any) -> None:
    assert verdict(says, Asymptotics(along), given) is Verdict.UNDECIDED


def test_a_path_gives_no_value_to_what_is_defined() -> None:
    says = order(equal(y, O(x)), x)
    assert verdict(says, Asymptotics({x: t, y: Integer(1)})) is Verdict.REFUTED
    defined = Asymptotics({x: t, y: Integer(1)}, claims=(ROOT,))
    assert verdict(says, defined, x > 0) is Verdict.UNDECIDED


# -- what is one root -----------------------------------------------------------------------------

ONE = Claim(
    "one",
    ExactlyOne(c, 0, 1 + x, equal(c + c**3, x)),
    Decided(),
    expect=Verdict.PROVED,
    given=(x > 0,),
)
ROOT = Claim("root", Root(y, ONE).says, Root(y, ONE), given=(x > 0,))
"""y + y³ = x: y is x − x³ and so on."""
OTHER = Claim(
    "other",
    ExactlyOne(c, 0, Rational(1, 2), equal(c - c**2, x)),
    Decided(),
    expect=Verdict.PROVED,
    given=(x > 0, x < Rational(1, 8)),
)
LESSER = Claim("lesser", Root(a, OTHER).says, Root(a, OTHER), given=OTHER.given)
"""a − a² = x where a < 1/2; beyond, the function falls again."""
TOO_SMALL = order(equal(y, x + o(x**3)), x)
BELOW = Asymptotics({x: t}, beside=y < x - x**3 / 2, claims=(ROOT,))


def test_a_root_is_beside_a_candidate() -> None:
    assert verdict(TOO_SMALL, BELOW, x > 0) is Verdict.REFUTED
    above = replace(BELOW, beside=y > x / 2)
    assert verdict(order(equal(y, o(x)), x), above, x > 0) is Verdict.REFUTED
    assert "at that bound" in finding(TOO_SMALL, BELOW, x > 0).why
    assert "at that bound" not in finding(SQUARE, PATH, y > 0).why


def test_a_candidate_is_between_the_ends() -> None:
    """Beyond them the function has the sign again that it has at the lower one."""
    assert judge(OTHER, {}).verdict is Verdict.PROVED
    says, beyond = order(equal(a, O(x)), x), Asymptotics({x: t}, a > 1 - x / 2, (LESSER,))
    assert verdict(says, beyond, *OTHER.given) is Verdict.UNDECIDED


def test_a_candidate_is_of_the_root_that_is_spoken_of() -> None:
    says = order(equal(a, x + o(x**3)), x)
    for claims in ((ROOT, LESSER), (LESSER, ROOT)):
        found = finding(says, replace(BELOW, beside=a < x - x**3 / 2, claims=claims), *OTHER.given)
        assert found.verdict is Verdict.UNDECIDED


def test_a_path_leaves_nothing_open() -> None:
    says = order(equal(y, O(x)), x)
    assert verdict(says, Asymptotics({x: t}, claims=(ROOT,)), x > 0) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("says", "beside"),
    [
        (TOO_SMALL, y < x - 2 * x**3),
        (TOO_SMALL, y > x - x**3 / 2),
        (TOO_SMALL, y > x - 2 * x**3),
        (TOO_SMALL, y < x + 5),
        (TOO_SMALL, y <= x - x**3 / 2),
        (TOO_SMALL, c < x - x**3 / 2),
        (order(equal(-y, -x + O(x**3)), x), y < x - x**3 / 2),
        (order(equal(y**2, x**2 + o(x**4)), x), y < x - x**3 / 2),
        (order(equal(y, x + o(y**3)), x), y < x - x**3 / 2),
        (order(equal(y, O(x)), x), y < 2 * x),
        (order(equal(y, 3 * x + o(x)), x), y > x / 2),
        (order(equal(y, o(x)), x), y > -x / 2),
    ],
)
def test_a_candidate_that_does_not_bound_refutes_nothing(says: Any, beside: Any) -> None:
    assert verdict(says, replace(BELOW, beside=beside), x > 0) is Verdict.UNDECIDED


def test_a_root_is_one_under_its_conditions_alone() -> None:
    elsewhere = replace(BELOW, along={x: -t})
    assert verdict(order(equal(y, x + o(x**3)), x, side=-1), elsewhere) is Verdict.UNDECIDED
    no_root = replace(BELOW, along={x: -t}, beside=y < Rational(1, 2))
    assert verdict(order(equal(1 - y, O(x)), x, side=-1), no_root) is Verdict.UNDECIDED
    assert verdict(TOO_SMALL, replace(BELOW, claims=()), x > 0) is Verdict.UNDECIDED
    assert verdict(TOO_SMALL, Asymptotics({x: t}, claims=(ROOT,)), x > 0) is Verdict.UNDECIDED


def test_the_function_of_the_root_may_be_rewritten_where_that_holds() -> None:
    form = Claim("form", equal(c**3 + c - x, (c**3 + c - x) * c / c), by(), given=(c > 0,))
    assert verdict(TOO_SMALL, replace(BELOW, claims=(ROOT, form)), x > 0) is Verdict.REFUTED
    assert verdict(TOO_SMALL, replace(BELOW, claims=(form, ROOT)), x > 0) is Verdict.REFUTED
    wrong = replace(form, given=(c < 0,))
    assert verdict(TOO_SMALL, replace(BELOW, claims=(ROOT, wrong)), x > 0) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    ("guard", "without", "says", "proof", "given"),
    [
        ("_need_path", lambda *_: None, SQUARE, PATH, y < 0),
        ("_need", lambda *_: None, SQUARE, PATH, y < 0),
    ],
)
def test_without_its_guard_a_planted_falsehood_is_believed(
    monkeypatch: pytest.MonkeyPatch, guard: str, without: Any, says: Any, proof: Any, given: Any
) -> None:
    assert verdict(says, proof, given) is Verdict.UNDECIDED
    monkeypatch.setattr(asymptotics, guard, without)
    assert verdict(says, proof, given) is Verdict.REFUTED
