"""Signs that are manifest where conditions pin a symbol, and the falsehoods planted for them."""

import pytest
from sympy import (
    Abs,
    Basic,
    Derivative,
    Expr,
    Integral,
    Ne,
    Subs,
    Symbol,
    cos,
    log,
    pi,
    sign,
    sin,
    sqrt,
)

from tresym.ledger.conversion import conditions
from tresym.ledger.evidence import sign_prover
from tresym.ledger.formulas import in_trees
from tresym.reals.language.formula import Relation

b, t, x, y = (Symbol(name, real=True) for name in "btxy")


def manifest_sign(e: Expr, given: tuple[Basic, ...]) -> str | None:
    return sign_prover.manifest_sign(in_trees(e), conditions(given))


PINNED = (b > 0, y > -b, x >= y, x <= y)
"""x is y, and above −b."""


@pytest.mark.parametrize("e", [x + b, 2 * x + 2 * b, x + y + 2 * b, b * (x + b)])
def test_a_pinned_symbol_has_the_sign_of_what_it_is(e: Expr) -> None:
    assert manifest_sign(e, PINNED) == "+"


FALSE: list[tuple[Expr, tuple[Basic, ...]]] = [
    (x - b, PINNED),
    (-x - b, PINNED),
    (y - x, PINNED),
    (x + b, (b > 0, y >= -b, x >= y, x <= y)),
    (x + b, (b > 0, y > -b, x <= y)),
    (sign(t) ** 2, (t >= 0, t <= 0)),
    (sign(t) ** 2 + t, (t >= 0, t <= 0)),
    (Abs(t), (t >= 0, t <= 0)),
    (1 - sign(t) ** 2 - t, (t >= 1, t <= 1)),
    (sqrt(t**2) + x, (t > 0, x >= -t)),
]


@pytest.mark.parametrize(("e", "given"), FALSE)
def test_no_positive_sign_is_read_off_where_there_is_none(
    e: Expr, given: tuple[Basic, ...]
) -> None:
    assert manifest_sign(e, given) != "+"


@pytest.mark.parametrize(
    ("e", "given"),
    [
        (x - 1, (x**2 * (x - 1) >= 0,)),
        (x - y, (x**2 * (x - y) >= 0,)),
        (sqrt(x**2) - x, (x >= y, x <= y, y**2 * x >= 0)),
        (x, (x >= y, x <= y)),
    ],
)
def test_what_holds_inside_does_not_hold_at_single_points(
    e: Expr, given: tuple[Basic, ...]
) -> None:
    """x = 0 and y = 1; or there is nothing inside."""
    assert manifest_sign(e, given) not in ("+", ">=0", "0")


NEITHER: list[tuple[Expr, tuple[Basic, ...]]] = [
    (sin(t), (t > 0,)),
    (sin(t), (t < pi,)),
    (cos(t), (t > -pi / 2,)),
    (x * sin(t), (x > 0, t > 0)),
    (x * t, (x > 0,)),
    (x + t, (x > 0,)),
    (sqrt(x) - t, (x > 0, t > 0)),
]


@pytest.mark.parametrize(("e", "given"), NEITHER)
def test_what_may_be_negative_has_no_sign(e: Expr, given: tuple[Basic, ...]) -> None:
    assert manifest_sign(e, given) not in ("+", ">=0", "0")


def test_a_condition_states_a_sign_where_it_is_a_bound() -> None:
    assert sign_prover.is_stated(in_trees(x - y), conditions((x >= y,)))
    for unlike in (Ne(x, y), x <= y, x > y + 1):
        assert not sign_prover.is_stated(in_trees(x - y), conditions((unlike,)))


def test_no_equation_is_manifest() -> None:
    for left, right in ((x, x), (x, y)):
        relation = Relation(in_trees(left), "==", in_trees(right))
        assert not sign_prover.is_manifest(relation, conditions((x >= y, x <= y)))


# Where expressions are defined: what is bound has conditions of its own


def undefined(e: Basic, given: tuple[Basic, ...]) -> object:
    return sign_prover.undefined(in_trees(e), conditions(given))


def continuous_on(e: Basic, given: tuple[Basic, ...]) -> object:
    return sign_prover.continuous_on(in_trees(e), conditions(given))


def test_what_is_put_in_is_looked_at_in_place() -> None:
    assert undefined(Subs(1 / x, x, y), (y > 0,)) is None
    assert undefined(1 + 2 * Subs(1 / x, x, y), (y >= 0, x > 0)) is not None


def test_what_is_bound_has_conditions_of_its_own() -> None:
    e = Integral(1 / x, (x, 1, 2))
    assert undefined(e, ()) is None
    assert undefined(e + sqrt(y), ()) is not None
    assert undefined(e + sqrt(y), (y >= 0,)) is None


def test_a_derivative_is_defined_where_its_function_is_smooth() -> None:
    for e in (Derivative(log(x), x), Derivative(Abs(x) + y, x), Subs(Derivative(log(x), x), x, y)):
        assert undefined(e, ()) is not None
        assert undefined(e, (x > 0, y > 0)) is None
    assert undefined(Derivative(log(x) + Integral(x, (x, 0, y)), y), ()) is not None


def test_smooth_is_what_hides_nothing() -> None:
    assert continuous_on(Integral(x, (x, 0, 1)), ()) is not None
    assert continuous_on(1 + Subs(x, x, 1), ()) is not None
    assert continuous_on(Derivative(log(x), x), (x > 0,)) is not None
    assert continuous_on(log(x), (x > 0,)) is None
