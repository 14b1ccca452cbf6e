"""Violations: found where a claim fails, and none where it holds."""

import pytest
from flint import arb
from sympy import (
    Basic,
    Derivative,
    Equivalent,
    Ge,
    Gt,
    Integer,
    Integral,
    Lt,
    Matrix,
    Ne,
    Subs,
    Symbol,
    Tuple,
    cos,
    exp,
    pi,
    sin,
)
from sympy_statements import equal

from tresym.ledger.counterexamples import excluded, violation

x, y, t = (Symbol(name, real=True) for name in "xyt")

# what holds, its conditions and what is known; and what fails there
PAIRS = [
    (equal(sin(x) ** 2 + cos(x) ** 2, 1), (), (), equal(sin(x) ** 2 + cos(x) ** 2, 1 + x)),
    (Ge(x**2, 0), (), (), Gt(x**3, 0)),
    (Gt(x, 0), (x > 1,), (), Gt(x, 2)),
    (Ne(x, 0), (x > 1,), (), equal(x, 2)),
    (equal(y, x**2), (), (equal(y, x**2),), equal(y, x**2 + 1)),
    (equal(x + y, 1), (), (equal(y, 1 - x),), equal(x - y, 1)),
    (equal(x * y, 1), (x > 0,), (equal(x * y, 1),), Lt(x, y)),
    (Gt(x, 1), (x > 0,), (equal(exp(x) + x, 6),), Lt(x, 1)),
    (equal(Integral(t, (t, 0, x)), x**2 / 2), (), (), equal(Integral(t, (t, 0, x)), x**2)),
    (equal(Derivative(sin(x), x), cos(x)), (), (), equal(Derivative(sin(x), x), sin(x))),
    (equal(Subs(x**2, x, 3), 9), (), (), equal(Subs(x**2, x, 3), 6)),
    (
        Lt(pi, Integer(22) / 7, evaluate=False),
        (),
        (),
        Gt(pi, Integer(22) / 7, evaluate=False),
    ),
    (
        equal(Matrix([x, y]), Matrix([x, x])),
        (),
        (equal(y, x),),
        equal(Matrix([x, y]), Matrix([x, -x])),
    ),
    (Tuple(x**2 >= 0, y**2 >= 0), (), (), Tuple(x**2 >= 0, y >= 0)),
    (
        Equivalent(equal(x, y), equal(2 * x, 2 * y)),
        (),
        (),
        Equivalent(equal(x, y), equal(2 * x, y + 1)),
    ),
]


@pytest.mark.parametrize(("says", "given", "known", "_"), PAIRS, ids=[str(p[0]) for p in PAIRS])
def test_what_holds_is_not_violated(says: Basic, given: tuple, known: tuple, _: Basic) -> None:
    assert violation(says, given, known) is None


@pytest.mark.parametrize(("_", "given", "known", "says"), PAIRS, ids=[str(p[3]) for p in PAIRS])
def test_what_fails_is_violated_at_a_point(
    _: Basic, given: tuple, known: tuple, says: Basic
) -> None:
    found = violation(says, given, known)
    assert found is not None
    for condition in given:
        assert condition.subs({Symbol(n, real=True): str(v) for n, v in found.point.items()})


@pytest.mark.parametrize(
    ("difference", "relation", "found"),
    [
        (arb(1), "==", True),
        (arb(0, 1), "==", False),
        (arb(0), "!=", True),
        (arb(0, 1), "!=", False),
        (arb(0), ">", True),
        (arb(0), ">=", False),
        (arb(-1), ">=", True),
        (arb(0, 1), ">", False),
        (arb(0), "<", True),
        (arb(1), "<=", True),
        (arb.nan(), "==", False),
        (arb.nan(), ">", False),
        (arb.pos_inf(), "<", False),
    ],
)
def test_only_a_ball_that_is_clear_excludes(difference: arb, relation: str, found: bool) -> None:
    assert excluded(difference, relation) is found
