"""What is conserved, stable and unstable, and systems of which it is said wrongly."""

from typing import Any

import pytest
from planted_claims import verdict_on as verdict
from planted_claims import x, y
from sympy import Rational, Symbol, Tuple, cos, sin
from sympy_statements import Conserved, StableEquilibrium, UnstableEquilibrium, equal

from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.decided import Decided
from tresym.reals.verdict import Verdict

PROVED, UNDECIDED = Verdict.PROVED, Verdict.UNDECIDED

v, k = Symbol("v", real=True), Symbol("k", real=True)
STATES, ORIGIN = Tuple(x, v), Tuple(0, 0)
SPRING, HILL = Tuple(v, -x), Tuple(v, x)
DAMPED = Tuple(v, -x - v)


@pytest.mark.parametrize(
    ("e", "rates", "holds"),
    [
        (x**2 + v**2, SPRING, True),
        (v**2 - x**2, HILL, True),
        (x**2 + v**2, DAMPED, False),
        (x**2 + v**2, HILL, False),
        (x, SPRING, False),
        (v**2 / 2 - cos(x), Tuple(v, -sin(x)), True),
        (v**2 / 2 + cos(x), Tuple(v, -sin(x)), False),
    ],
)
def test_what_is_constant_along_a_motion(e: Any, rates: Tuple, holds: bool) -> None:
    assert (verdict(Conserved(e, STATES, rates), Decided()) is PROVED) is holds


def test_a_symbol_defined_by_a_variable_is_no_constant() -> None:
    """k = x², by definition, is not constant, though nobody sees an x in it."""
    defined = Claim("defined", equal(k, x**2), Definition())
    says = Conserved(k, STATES, SPRING)
    assert verdict(says, Decided(also=(defined,))) is UNDECIDED
    assert not verdict(says, Decided(put=(defined,))).holds
    assert verdict(says, Decided()) is PROVED  # where k is any number
    energy = Conserved(k + v**2, STATES, SPRING)
    assert verdict(energy, Decided(put=(defined,))) is PROVED


def test_a_symbol_that_is_defined_does_not_move() -> None:
    start = Claim("start", equal(x, k**2), Definition())
    for says in (Conserved(x**2 + v**2, STATES, SPRING), Conserved(x, STATES, SPRING)):
        assert verdict(says, Decided(put=(start,))) is UNDECIDED
        assert verdict(says, Decided(also=(start,))) is UNDECIDED


def test_an_equilibrium_is_stable_where_a_conserved_function_has_a_strict_minimum() -> None:
    assert verdict(StableEquilibrium(STATES, SPRING, ORIGIN), Decided()) is PROVED
    for says in (
        StableEquilibrium(STATES, HILL, ORIGIN),
        StableEquilibrium(STATES, SPRING, Tuple(1, 0)),
        StableEquilibrium(STATES, Tuple(v, 0), ORIGIN),  # x moves freely
        UnstableEquilibrium(STATES, SPRING, ORIGIN),
    ):
        assert not verdict(says, Decided()).holds


def test_conditions_must_hold_around_the_equilibrium() -> None:
    """What is said where x > 0 says nothing around 0."""
    says = StableEquilibrium(STATES, SPRING, ORIGIN)
    assert not verdict(says, Decided(), x > 0).holds
    assert verdict(says, Decided(), x > -1) is PROVED


def test_an_equilibrium_is_unstable_where_a_solution_of_the_linear_system_grows() -> None:
    assert verdict(UnstableEquilibrium(STATES, HILL, ORIGIN), Decided()) is PROVED
    assert not verdict(UnstableEquilibrium(STATES, HILL, Tuple(0, 1)), Decided()).holds
    steep = UnstableEquilibrium(STATES, Tuple(v, k * x), ORIGIN)
    assert verdict(steep, Decided(), k > 0) is PROVED
    assert not verdict(steep, Decided(), k >= 0).holds


def test_a_system_has_one_rate_for_each_variable() -> None:
    for says in (
        Conserved(x, Tuple(x, v), Tuple(v)),
        Conserved(Rational(1) * x, Tuple(x, x), Tuple(0, v)),
        Conserved(y, Tuple(), Tuple()),
        StableEquilibrium(STATES, SPRING, Tuple(0)),
        StableEquilibrium(STATES, Tuple(v), ORIGIN),
    ):
        assert not verdict(says, Decided()).holds
