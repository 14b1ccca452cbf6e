"""Claims about roots: what has one, none or several, and slopes of implicit functions."""

from dataclasses import replace
from typing import Any

import pytest
from derivations import by
from planted_claims import EVERYTHING, claim, r, t, verdict, x, y
from sympy import (
    Derivative,
    Integer,
    Integral,
    Rational,
    S,
    Subs,
    atan,
    exp,
    sign,
    tanh,
)
from sympy_statements import ExactlyOne, equal

from tresym.ledger.claim import (
    Claim,
    ImplicitFunction,
)
from tresym.ledger.evidence.decided import Decided
from tresym.ledger.finding import Finding
from tresym.ledger.judge import judge
from tresym.ledger.reasons import (
    differentiation,
)
from tresym.reals.verdict import Verdict

ONE = Integer(1)


def root(function: object, slope: object, low: object, high: object, *given: object) -> Verdict:
    stated = ExactlyOne(x, low, high, equal(function, 0))
    return verdict(claim(stated, Decided(), given))


def test_unique_roots() -> None:
    assert root(x**3 + x - 1, 3 * x**2 + 1, 0, 1) is Verdict.PROVED
    assert root(x**3 + x + 1, 3 * x**2 + 1, 0, 1) is Verdict.REFUTED
    assert root(x**2 - 1, 2 * x, -2, 2) is Verdict.REFUTED
    assert root(1 / x, -1 / x**2, -1, 1) is Verdict.UNDECIDED
    assert root(x + tanh(x) - 1, 2 - tanh(x) ** 2, 0, 1).holds


def test_what_jumps_over_zero_has_no_root() -> None:
    """x − 2 sign(x) + 1/2 rises, where it has a slope, from above 0 to below it."""
    for jumping in (x - 2 * sign(x) + Rational(1, 2), x - 4 * atan(1 / x)):
        stated = ExactlyOne(x, -1, 1, equal(jumping, 0))
        assert not judge(claim(stated, Decided()), {}).verdict.holds
    at_the_end = x - 1 + 2 * sign(x)
    stated = ExactlyOne(x, 0, 1, equal(at_the_end, 0))
    assert not judge(claim(stated, Decided()), {}).verdict.holds


def test_no_unique_root_where_there_is_none() -> None:
    assert root(x**3 + x + 1, 3 * x**2 + 1, 0, 1) is Verdict.REFUTED


def test_conditions_do_not_restrict_the_interval_of_a_root() -> None:
    function, slope = x**3 - x - 1, 3 * x**2 - 1
    assert root(function, slope, 0, 2, x > 1) is not Verdict.PROVED
    assert root(function, slope, 1, 2) is Verdict.PROVED


def test_what_hangs_on_a_variable_is_not_taken_for_a_constant() -> None:
    """An integral stays a symbol of its own, but no derivative by what it depends on is zero."""
    area = Integral(t * x, (t, 0, 1))
    for says in (
        equal(Derivative(Integral(1, (t, 0, x)), x), 0),
        equal(Derivative(Derivative(area * x, x), x), 0),
        equal(Derivative(Subs(Integral(t * y, (t, 0, 1)), y, x), x), 0),
        equal(Subs(area, x, 0), area),
    ):
        assert not verdict(claim(says, by(*EVERYTHING, differentiation))).holds
    free = equal(Derivative(x * Integral(y, (y, 0, 1)), x), Integral(y, (y, 0, 1)))
    assert verdict(claim(free, by(differentiation))) is Verdict.PROVED


def test_the_ends_do_not_depend_on_the_unknown() -> None:
    """Nothing is between x − 1 and x + 1 but for some x: the name would be caught."""
    root = Decided()
    assert verdict(claim(ExactlyOne(y, -1, 1, equal(y, 0)), root)) is Verdict.PROVED
    caught = claim(ExactlyOne(y, y - 1, y + 1, equal(y, y)), root)
    assert verdict(caught) is Verdict.UNDECIDED
    caught = claim(ExactlyOne(y, y - 1, y + 1, equal(y, 0)), Decided())
    assert verdict(caught) is Verdict.UNDECIDED


# -- implicit functions ---------------------------------------------------------------------------


def slope_of(left: Any, right: Any, slope: Any, *given: Any, **changes: Any) -> Finding:
    """y is a function of x by left = right; what is claimed of its slope r at x = 0."""
    equation = Claim("equation", equal(left, right), by(), given=given)
    says = -Subs(Derivative(left, x), x, 0) / Derivative(left.subs(x, 0), y)
    proof = ImplicitFunction(equation, y, x, Integer(0))
    planted = Claim("slope", equal(r, says), proof, given=given)
    return judge(replace(planted, **changes), {"equation": Finding(Verdict.PROVED, "")})


CUBIC = y**3 + y + x * y


def test_the_slope_of_a_cubic() -> None:
    assert slope_of(CUBIC, 2, 3 * y**2 + 1).verdict is Verdict.PROVED
    right = -Subs(Derivative(CUBIC, x), x, 0) / Derivative(y**3 + y, y)
    wrong = slope_of(CUBIC, 2, 3 * y**2 + 1, says=equal(r, right + 1))
    assert wrong.verdict is Verdict.REFUTED
    assert wrong.witness


@pytest.mark.parametrize(
    ("left", "right", "slope", "given", "why"),
    [
        (CUBIC, 2 + x, 3 * y**2 + 1, (), "must not depend on the unknown"),
        (CUBIC, 2 * y, 3 * y**2 + 1, (), "must not depend on the unknown"),
        (y**3 - 3 * y + x * y, -2, 3 * y**2 - 3, (), "is not 0: both sides are equal at"),
        (y**2 + x * y, 1, 2 * y, (), "is not 0: both sides are equal at"),
        (CUBIC, 2, 3 * y**2 + 1, (y > 5,), "no point"),
        (y + exp(x * y), 1, S.One, (y > 5,), "no point"),
    ],
    ids=str,
)
def test_what_is_no_implicit_function(
    left: Any, right: Any, slope: Any, given: tuple[Any, ...], why: str
) -> None:
    assert why in slope_of(left, right, slope, *given).why


def test_the_slope_has_a_name_and_is_no_equation_for_one() -> None:
    right = -Subs(Derivative(CUBIC, x), x, 0) / Derivative(y**3 + y, y)
    for says in (equal(r + 1, right), equal(r**2, right)):
        assert "is not a new symbol" in slope_of(CUBIC, 2, 3 * y**2 + 1, says=says).why
