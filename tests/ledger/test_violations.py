"""A violation of a claim is shown by balls, and found only where what is known holds."""

from flint import arb, fmpq
from sympy import Ge, Integral, Symbol, Tuple, cos, exp, sin, sqrt, tan
from sympy_statements import equal

from tresym.ledger.ball_evaluation import value
from tresym.ledger.counterexamples import violation
from tresym.ledger.formulas import in_trees

x, y, t = (Symbol(name, real=True) for name in "xyt")


def test_no_violation_of_what_is_true() -> None:
    assert violation(equal(sin(x) ** 2 + cos(x) ** 2, 1), ()) is None
    assert violation(Ge(x**2, 0, evaluate=False), ()) is None
    assert violation(Ge(x, 0, evaluate=False), (x > 1,)) is None


def test_violations_respect_everything_known() -> None:
    assert violation(equal(x + y, 1), ()) is not None
    assert violation(equal(x + y, 1), (), (equal(y, 1 - x),)) is None
    assert violation(equal(x**2 + 2 * x * y + y**2, 1), (), (equal(x + y, 1),)) is None
    assert violation(equal(x, 2), (x > 0,), (equal(exp(x) + x, exp(2) + 2),)) is None
    found = violation(equal(x, 1), (x > 0,), (equal(exp(x) + x, exp(2) + 2),))
    assert found is not None
    assert abs(found.point["x"] - 2) < fmpq(1, 10**6)


def test_a_pole_is_not_taken_for_a_root() -> None:
    given = (x > 1, x < 2)
    assert violation(equal(y, 0), given, (equal(tan(x) * exp(tan(x) ** 2), 0),)) is None


def test_systems_fall_with_one_part() -> None:
    assert violation(Tuple(equal(x, x + 0 * y), equal(x, x + 1)), ()) is not None


def test_integrals_are_enclosed() -> None:
    area = value(in_trees(Integral(sqrt(1 - t**2), (t, 0, x))), {"x": arb("0.5")})
    known = (arb(3).sqrt() / 4 + arb.pi() / 6) / 2
    assert area.overlaps(known)
    assert area.rad() < arb("1e-9")
    assert not value(in_trees(Integral(1 / t, (t, -1, x))), {"x": arb(1)}).is_finite()
