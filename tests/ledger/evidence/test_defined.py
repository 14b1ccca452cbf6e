"""Where SymPy expressions are defined: the one table, and what is bound has its own conditions."""

from __future__ import annotations

from sympy import Derivative, Integral, Subs, Symbol, log, sqrt

from tresym.ledger.evidence.defined import continuous_on, undefined

x, y = (Symbol(name, real=True) for name in "xy")


def test_what_is_put_in_is_looked_at_in_place() -> None:
    assert undefined(Subs(1 / x, x, y), (y > 0,)) is None
    assert undefined(1 + 2 * Subs(1 / x, x, y), (y >= 0, x > 0)) is not None


def test_what_is_bound_has_conditions_of_its_own() -> None:
    for e in (Integral(1 / x, (x, 1, 2)), Derivative(log(x), x)):
        assert undefined(e, ()) is None
        assert undefined(e + sqrt(y), ()) is not None
        assert undefined(e + sqrt(y), (y >= 0,)) is None


def test_smooth_is_what_hides_nothing() -> None:
    assert continuous_on(Integral(x, (x, 0, 1)), ()) is not None
    assert continuous_on(1 + Subs(x, x, 1), ()) is not None
    assert continuous_on(Derivative(log(x), x), (x > 0,)) is None
    assert continuous_on(Derivative(log(x), x), ()) is not None
