"""Points at which claims are tried, and where there is none."""

from sympy import (
    Symbol,
    log,
)
from sympy_statements import equal

from tresym.ledger.counterexamples import violation

x, y, t = (Symbol(name, real=True) for name in "xyt")


def test_nothing_is_violated_where_nothing_can_be() -> None:
    for given in ((x > 1, x < 0), (x**2 < -1,)):
        assert violation(equal(x, x + 1), given) is None
    assert violation(equal(y, 0), (), (equal(x**2 + y**2, -1),)) is None
    assert violation(equal(log(x), 1), (x < 0,)) is None
