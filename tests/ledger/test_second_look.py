"""Violations: found where a claim fails, and none where it holds; values apart from the engine."""

from __future__ import annotations

import mpmath
import pytest
from flint import acb, arb, fmpq
from sympy import (
    Abs,
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
    acosh,
    asin,
    atanh,
    cos,
    exp,
    log,
    pi,
    sign,
    sin,
    sqrt,
    tan,
)

from tresym.ledger.claim import equal
from tresym.ledger.second_look import excluded, rootless, value, violation
from tresym.reals.numbers.arithmetic import ball_precision

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


def test_nothing_is_violated_where_nothing_can_be() -> None:
    for given in ((x > 1, x < 0), (x**2 < -1,)):
        assert violation(equal(x, x + 1), given) is None
    assert violation(equal(y, 0), (), (equal(x**2 + y**2, -1),)) is None
    assert violation(equal(log(x), 1), (x < 0,)) is None


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


def test_an_interval_without_a_root() -> None:
    assert rootless(x**2 + y, x, (Integer(0), Integer(1)), (y > 0,)) is not None
    assert rootless(x - y, x, (Integer(0), Integer(1)), (y > 0, y < 1)) is None
    assert rootless((x - y) ** 2, x, (Integer(0), Integer(1)), (y > 0, y < 1)) is None


VALUES = [
    (sin(x) * exp(x) / (1 + x**2), lambda m, v: m.sin(v) * m.exp(v) / (1 + v**2)),
    (x**pi + sqrt(x) + x ** Integer(-3), lambda m, v: v**m.pi + m.sqrt(v) + v**-3),
    (Abs(-x) + sign(x), lambda m, v: v + 1),
    (Integral(exp(-t * x), (t, 0, 1)), lambda m, v: (1 - m.exp(-v)) / v),
    (Integral(sqrt(t), (t, 0, x)), lambda m, v: 2 * v ** m.mpf("1.5") / 3),
    (Derivative(x**3 * log(x), x), lambda m, v: 3 * v**2 * m.log(v) + v**2),
    (Subs(t**2 + x, t, x), lambda m, v: v**2 + v),
    (asin(x / 2) + atanh(x / 2), lambda m, v: m.asin(v / 2) + m.atanh(v / 2)),
]


@pytest.mark.parametrize(("e", "expected"), VALUES, ids=[str(e) for e, _ in VALUES])
def test_values_agree_with_mpmath(e: Basic, expected: object) -> None:
    assert callable(expected)
    with ball_precision(128), mpmath.workdps(30):
        found = value(e, {x: arb(fmpq(7, 5))})
        near = arb(mpmath.nstr(expected(mpmath.mp, mpmath.mpf(7) / 5), 25))
        assert abs(found - near).contains(0) or abs(found - near) < 1e-20
        assert found.rad() < 1e-2


@pytest.mark.parametrize(
    ("e", "at"),
    [
        (1 / x, 0),
        (sqrt(x), -1),
        (log(x), 0),
        (x**y, -1),
        (sign(x), 0),
        (asin(x), 2),
        (acosh(x), 0),
        (tan(x) / x, 0),
        (Integral(1 / t, (t, -1, 1)), 0),
        (Integral(log(t), (t, x, 1)), -1),
        (Integral(t, (t, 0, 1 / x)), 0),
    ],
    ids=str,
)
def test_where_nothing_is_defined_there_is_no_number(e: Basic, at: int) -> None:
    with ball_precision(64):
        assert not value(e, {x: arb(at), y: arb(2)}).is_finite()


@pytest.mark.parametrize("e", [sqrt(x), log(x), Abs(x), sign(x), asin(x), 1 / x], ids=str)
def test_an_integrand_is_not_taken_for_analytic_across_a_cut(e: Basic) -> None:
    with ball_precision(64):
        across = acb(arb(0, 0.5), arb(0, 0.5)) if e != asin(x) else acb(arb(0))
        assert not value(e, {x: across}, analytic=True).is_finite()
