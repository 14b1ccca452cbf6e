"""Where expressions are defined under the conditions of a claim: what is bound has its own."""

from __future__ import annotations

from sympy import Abs, Basic, Derivative, Integral, Subs, Symbol, log, sqrt

from tresym.ledger.evidence import defined
from tresym.ledger.meaning import conditions, tree
from tresym.reals.language.expression import Expr

x, y = (Symbol(name, real=True) for name in "xy")


def undefined(e: Basic, given: tuple[Basic, ...]) -> Expr | None:
    return defined.undefined(tree(e), conditions(given))


def continuous_on(e: Basic, given: tuple[Basic, ...]) -> Expr | None:
    return defined.continuous_on(tree(e), conditions(given))


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
