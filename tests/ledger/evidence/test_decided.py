"""Evidence that the engine decides a statement, and false statements for each guard."""

from __future__ import annotations

from typing import Any

import pytest
from flint import fmpq
from sympy import Abs, Function, Symbol, sin, sqrt
from sympy_statements import equal, order

from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.evidence.decided import Decided, InVariables
from tresym.ledger.judge import judge_evidence
from tresym.reals.verdict import Verdict

x, y, v = (Symbol(name, real=True) for name in "xyv")
O = Function("O")  # noqa: E741
HALF = Claim("half", equal(y, 1 / x), Definition(), given=(x > 0,))
SHORT = (x > 0, x <= 1)
CUBE = Abs(sin(x) - x) <= x**3 / 6


def verdict(says: Any, proof: Decided, *given: Any, **rest: Any) -> Any:
    found = judge_evidence(Claim("f", says, proof, given=given, **rest))
    assert found is not None
    return found.verdict


def test_a_bound_is_decided_with_its_constant() -> None:
    bound = Decided(constant=fmpq(1, 6), gauge=x**3)
    assert verdict(CUBE, bound, *SHORT).holds
    assert verdict(x * y <= 1, Decided(put=(HALF,)), x > 0).holds


def test_a_smaller_constant_is_not_asserted() -> None:
    assert verdict(CUBE, Decided(constant=fmpq(1, 7), gauge=x**3), *SHORT) is Verdict.UNDECIDED


def test_a_definition_is_unfolded_only_where_it_holds() -> None:
    """x·y ≤ 1 says nothing where y = 1/x is not defined."""
    assert verdict(x * y <= 1, Decided(put=(HALF,)), x > -1) is Verdict.UNDECIDED


def test_both_sides_must_be_defined() -> None:
    assert not verdict(sqrt(x) + 1 >= 0, Decided(), x > -1, x <= 1).holds


def test_a_symbol_defined_by_the_variable_of_the_limit_is_unfolded() -> None:
    """x·y = 1 is not O(x) as x → 0, though it is for each fixed y."""
    says = order(equal(x * y, O(x)), x)
    assert not verdict(says, Decided(also=(HALF,)), y > 0, y < 1).holds


def test_an_order_holds_uniformly() -> None:
    says = order(equal(x / (x + y), O(x)), x)
    assert not verdict(says, Decided(), y > 0).holds


def test_a_statement_about_all_values_of_a_defined_symbol_refutes_nothing() -> None:
    """y ≤ 2 fails for some y, but not for the y that is defined."""
    one = Claim("one", equal(y, 1), Definition())
    assert verdict(y <= 2, Decided(also=(one,)), y > 0) is Verdict.UNDECIDED


@pytest.mark.parametrize(
    "new",
    [
        InVariables({v: x**2}, {x: -v}, ()),  # x is not -x²
        InVariables({v: x}, {x: v}, (v > 1,)),  # the values of v may be smaller
        InVariables({y: x}, {x: y}, ()),  # y occurs already
    ],
)
def test_other_variables_reach_every_point(new: InVariables) -> None:
    proof = Decided(variables=new)
    assert verdict(x * y**2 >= x**2 * y**2 - 1, proof, *SHORT, y > 0, y < 1) is Verdict.UNDECIDED
