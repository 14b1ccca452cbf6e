"""Where expressions are defined: what is shown, and what is not."""

from __future__ import annotations

import pytest
from sympy import (
    Abs,
    Basic,
    Derivative,
    Integral,
    Rational,
    Subs,
    Symbol,
    acosh,
    asin,
    atanh,
    cos,
    cot,
    coth,
    exp,
    log,
    sign,
    sin,
    sqrt,
    tan,
)

from tresym.ledger.evidence import defined
from tresym.ledger.meaning import conditions, tree
from tresym.reals.language.expression import Expr

x, y = (Symbol(name, real=True) for name in "xy")


def undefined(e: Basic, given: tuple[Basic, ...]) -> Expr | None:
    return defined.undefined(tree(e), conditions(given))


def continuous_on(e: Basic, given: tuple[Basic, ...]) -> Expr | None:
    return defined.continuous_on(tree(e), conditions(given))


# an expression, conditions that show it defined, and weaker ones that do not
TABLE = [
    (1 / x, (x > 0,), (x >= 0,)),
    (1 / (x**2 + 1), (), None),
    (1 / (x - y), (x > y,), (x >= y,)),
    (sqrt(x), (x >= 0,), ()),
    (1 / sqrt(x), (x > 0,), (x >= 0,)),
    (log(1 - x), (x < 1,), (x <= 1,)),
    (x**y, (x > 0,), (x >= 0,)),
    (asin(x), (x <= 1, x >= -1), (x <= 1,)),
    (atanh(x), (x < 1, x > -1), (x <= 1, x > -1)),
    (acosh(x), (x >= 1,), (x >= 0,)),
    (sign(x), (x > 0,), None),
    (coth(x), (x > 0,), (x >= 0,)),
    (1 / (2 + cos(x)), (), None),
    (tan(x), None, ()),
    (cot(x), None, (x > 0,)),
    (sin(log(x)), (x > 0,), (x >= 0,)),
    (sin(1 / (1 + sqrt(x))), (x >= 0,), ()),
    (Subs(1 / x, x, y), (y > 0,), (y >= 0, x > 0)),
]


@pytest.mark.parametrize(("e", "enough", "_"), TABLE, ids=str)
def test_what_is_defined(e: Basic, enough: tuple[Basic, ...] | None, _: object) -> None:
    assert enough is None or undefined(e, enough) is None


@pytest.mark.parametrize(("e", "_", "weaker"), TABLE, ids=str)
def test_what_is_not_shown(e: Basic, _: object, weaker: tuple[Basic, ...] | None) -> None:
    assert weaker is None or undefined(e, weaker) is not None


@pytest.mark.parametrize(
    ("e", "given", "smooth"),
    [
        (sqrt(x), (x > 0,), True),
        (sqrt(x), (x >= 0,), False),
        (x ** Rational(1, 3), (x >= 0,), False),
        (1 / x, (x > 0,), True),
        (1 / x, (x >= 0,), False),
        (Abs(x), (x > 0,), True),
        (Abs(x), (), False),
        (sign(x), (x > 0,), True),
        (asin(x), (x < 1, x > -1), True),
        (asin(x), (x <= 1, x >= -1), False),
        (acosh(x), (x >= 1,), False),
        (exp(sin(x)), (), True),
        (Integral(x, (x, 0, 1)), (), False),
        (1 + Subs(x, x, 1), (), False),
    ],
    ids=str,
)
def test_smooth_is_more_than_defined(e: Basic, given: tuple[Basic, ...], smooth: bool) -> None:
    assert (continuous_on(e, given) is None) is smooth


def test_what_is_bound_has_conditions_of_its_own() -> None:
    for e in (Integral(1 / x, (x, 1, 2)), Derivative(log(x), x)):
        assert undefined(e, ()) is None
