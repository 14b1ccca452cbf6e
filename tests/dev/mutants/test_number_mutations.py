"""Changed numbers, bounds and orders: seen to be false where they are, and only there."""

import pytest
from flint import arb, fmpq
from sympy import Expr, Function, Symbol, sin, sqrt

from tresym.dev.mutants.number_mutations import (
    bound_changes,
    bound_fails,
    bounds_fail,
    moved_digits,
    no_inputs_give_it,
    order_changes,
    order_fails,
    printed_changes,
)
from tresym.ledger.claim import Claim, Printed, equal
from tresym.ledger.evidence.asymptotics import Asymptotics
from tresym.ledger.evidence.box_bounds import Boxes
from tresym.ledger.statements import Rounds, order
from tresym.reals.balls.branch_and_bound import Bound, box

x, y = (Symbol(name, real=True) for name in "xy")


def number(text: str, term: Expr, **inputs: str | int) -> Claim:
    given = tuple(
        Rounds(Symbol(n, real=True), v) if isinstance(v, str) else equal(Symbol(n, real=True), v)
        for n, v in inputs.items()
    )
    return Claim("number", "a number", Printed(), given=given, means=Rounds(term, text))


def bounded(least: str) -> Claim:
    """x² + 1 above ``least`` on [0, 2]."""
    bound = Bound(lambda x, m: x * x + 1 - arb(least), box((0, 2)))
    return Claim("bound", "a bound", Boxes((bound,), ("x",), "0 <= x <= 2"))


def ordered(kind: str, power: int) -> Claim:
    x = Symbol("x", real=True)
    says = equal(sin(x), x + Function(kind)(x**power))
    return Claim("order", "an order", Asymptotics(), means=order(says, x))


def test_digits_are_moved_leading_ones_first() -> None:
    found = list(moved_digits("1.9e-3"))
    assert found[:4] == ["2.9e-3", "0.9e-3", "1.8e-3", "-1.9e-3"]
    assert "1.9e-3" not in found
    assert all(text.endswith("e-3") for text in found)
    assert "1.2" in list(moved_digits("-1.2"))


@pytest.mark.parametrize(
    ("text", "x", "false"),
    [
        ("1.41", "2.00", False),
        ("1.43", "2.00", True),
        ("1.43", "2.0", False),
        ("1.5", "2.00", True),
        ("1.4142", 2, False),
        ("1.4143", 2, True),
        ("0.5", "-2.0", False),  # nowhere defined is not seen to be false
    ],
)
def test_a_printed_number_that_no_inputs_give(text: str, x: str | int, false: bool) -> None:
    assert no_inputs_give_it(number(text, sqrt(Symbol("x", real=True)), x=x)) is false


def test_every_printed_text_is_changed_and_no_exact_input() -> None:
    claim = number("3.0", x + y, x="1.0", y=2)
    changes = printed_changes(claim, lambda term: [term + 1, 2 * term, term * Symbol("z")])
    places = {place: list(map(make, variants)) for place, variants, make in changes}
    assert set(places) == {"printed number", "unit", "term", "input x"}
    for made in places.values():
        assert any(no_inputs_give_it(changed) for changed in made)
    assert [no_inputs_give_it(changed) for changed in places["term"]] == [True, True, False]
    assert not no_inputs_give_it(claim)


def test_a_bound_is_seen_to_fail_at_a_point_of_its_box() -> None:
    assert not bounds_fail(bounded("0.9"))
    assert bounds_fail(bounded("1.1"))
    bound = bounded("2.5").proof.bounds[0]
    assert bound_fails(bound, (fmpq(1),))
    assert not bound_fails(bound, (fmpq(2),))


def test_changed_bounds_are_negated_or_lowered() -> None:
    ((_, changes, make),) = bound_changes(bounded("0.9"))
    made = [(str(named), make(named)) for named in changes]
    assert made[0][0] == "the margin negated"
    assert all(bounds_fail(changed) for _, changed in made[:3])
    assert all(changed.proof.stored is None for _, changed in made)


@pytest.mark.parametrize(
    ("kind", "power", "false"),
    [
        ("O", 3, False),
        ("O", 2, False),
        ("O", 4, True),
        ("o", 2, False),
        ("o", 3, True),
    ],
)
def test_an_order_is_seen_to_fail(kind: str, power: int, false: bool) -> None:
    assert order_fails(ordered(kind, power)) is false


def test_some_change_of_every_order_is_false() -> None:
    for claim in (ordered("O", 3), ordered("o", 2)):
        ((_, changes, make),) = order_changes(claim)
        assert any(order_fails(make(named)) for named in changes)
