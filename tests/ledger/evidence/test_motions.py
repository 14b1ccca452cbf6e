"""What is conserved, stable and unstable, and systems of which it is said wrongly."""

from typing import Any

import pytest
from planted_claims import verdict_on as verdict
from planted_claims import x, y
from sympy import Integer, Rational, Symbol, Tuple, cos, sin, sqrt

from tresym.ledger.claim import Claim, Conservation, Definition, Growing, Lyapunov, by, equal
from tresym.ledger.reasons import citing
from tresym.ledger.statements import Conserved, StableEquilibrium, UnstableEquilibrium
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
    assert (verdict(Conserved(e, STATES, rates), Conservation()) is PROVED) is holds


def test_a_symbol_defined_by_a_variable_is_no_constant() -> None:
    """k = x², by definition, is not constant, though nobody sees an x in it."""
    defined = Claim("defined", equal(k, x**2), Definition())
    says = Conserved(k, STATES, SPRING)
    assert verdict(says, Conservation(by(citing(defined)))) is UNDECIDED
    assert verdict(says, Conservation()) is PROVED  # where k is any number
    start = Claim("start", equal(x, k**2), Definition())
    whole = Conserved(x**2 + v**2, STATES, SPRING)
    assert verdict(whole, Conservation(by(citing(start)))) is UNDECIDED


def test_an_equilibrium_is_stable_where_a_conserved_function_has_a_strict_minimum() -> None:
    stable = StableEquilibrium(STATES, SPRING, ORIGIN)
    assert verdict(stable, Lyapunov(x**2 + v**2)) is PROVED
    assert verdict(stable, Lyapunov(-(x**2) - v**2)) is UNDECIDED
    assert verdict(StableEquilibrium(STATES, HILL, ORIGIN), Lyapunov(v**2 - x**2)) is UNDECIDED
    assert verdict(StableEquilibrium(STATES, HILL, ORIGIN), Lyapunov(x**2 + v**2)) is UNDECIDED
    assert (
        verdict(StableEquilibrium(STATES, SPRING, Tuple(1, 0)), Lyapunov(x**2 + v**2)) is UNDECIDED
    )
    # x moves freely: v² is conserved, has a minimum, and it is not strict.
    assert verdict(StableEquilibrium(STATES, Tuple(v, 0), ORIGIN), Lyapunov(v**2)) is UNDECIDED
    assert verdict(UnstableEquilibrium(STATES, SPRING, ORIGIN), Lyapunov(x**2 + v**2)) is UNDECIDED


def test_conditions_must_hold_around_the_equilibrium() -> None:
    """sqrt(x) is smooth where x > 0, and 0 is at the edge."""
    says = StableEquilibrium(STATES, SPRING, ORIGIN)
    assert verdict(says, Lyapunov(x**2 + v**2), x > 0) is UNDECIDED
    assert verdict(says, Lyapunov(x**2 + v**2), x > -1) is PROVED


def test_an_equilibrium_is_unstable_where_a_solution_of_the_linear_system_grows() -> None:
    unstable = UnstableEquilibrium(STATES, HILL, ORIGIN)
    assert verdict(unstable, Growing(Integer(1))) is PROVED
    assert verdict(unstable, Growing(Integer(-1))) is UNDECIDED
    assert verdict(unstable, Growing(Integer(2))) is UNDECIDED
    assert verdict(unstable, Growing(x + 1)) is UNDECIDED
    assert verdict(UnstableEquilibrium(STATES, SPRING, ORIGIN), Growing(Integer(1))) is UNDECIDED
    assert verdict(UnstableEquilibrium(STATES, HILL, Tuple(0, 1)), Growing(Integer(1))) is UNDECIDED
    assert verdict(StableEquilibrium(STATES, HILL, ORIGIN), Growing(Integer(1))) is UNDECIDED
    steep = UnstableEquilibrium(STATES, Tuple(v, k * x), ORIGIN)
    assert verdict(steep, Growing(sqrt(k)), k > 0) is PROVED
    assert verdict(steep, Growing(sqrt(k)), k >= 0) is UNDECIDED


def test_a_system_has_one_rate_for_each_variable() -> None:
    assert verdict(Conserved(x, Tuple(x, v), Tuple(v)), Conservation()) is UNDECIDED
    assert (
        verdict(Conserved(Rational(1) * x, Tuple(x, x), Tuple(0, v)), Conservation()) is UNDECIDED
    )
    assert verdict(Conserved(y, Tuple(), Tuple()), Conservation()) is UNDECIDED
