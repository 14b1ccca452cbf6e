"""Reasons: each opens the theory it is called by, and carries what it is given."""

import pytest
from sympy import Symbol
from sympy_statements import equal

from tresym.ledger import reasons
from tresym.ledger.claim import (
    Claim,
    Definition,
    Reason,
)
from tresym.ledger.formulas import in_trees
from tresym.reals.normal.field import ALL_THEORIES

x, y = (Symbol(name, real=True) for name in "xy")
A = Claim("A", equal(x, y), Definition())


def test_each_theory_has_one_reason_and_algebra_none() -> None:
    plain = [r for r in vars(reasons).values() if isinstance(r, Reason)]
    opened = [theory for reason in plain for theory in reason.theories]
    assert sorted(opened) == sorted(ALL_THEORIES)
    for reason in (reasons.algebra, reasons.differentiation, reasons.evaluating):
        assert not reason.theories


@pytest.mark.parametrize(
    "reason",
    [
        reasons.substituting(A),
        reasons.citing(A),
        reasons.changing_variable(x**2, A),
        reasons.integrating(x**2, A),
        reasons.cutting(x, A),
        reasons.collecting(A),
        reasons.differentiating_integral(x, A),
    ],
    ids=lambda reason: reason.name,
)
def test_claims_are_carried_and_no_theory_is_opened(reason: Reason) -> None:
    assert reason.claims == (A,)
    assert not reason.theories


def test_operations_on_both_sides() -> None:
    assert reasons.applying("exp").function == "exp"
    assert reasons.multiplying(x).factor == in_trees(x)
    assert reasons.adding(y).term == in_trees(y)
    names = [r.name for r in (reasons.applying("exp"), reasons.multiplying(x), reasons.adding(y))]
    assert len(set(names)) == 3
