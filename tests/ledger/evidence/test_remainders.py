"""Printed orders beside the bounds that are decided; false ones are among `test_false_claims`."""

from functools import partial
from typing import Any

import pytest
from sympy import Abs, Eq, Function, Symbol

from tresym.ledger.claim import (
    Claim,
)
from tresym.ledger.conversion import conditions
from tresym.ledger.evidence.allowed_evidence import is_formal
from tresym.ledger.evidence.chart_bounds import Charted, On, Shown
from tresym.ledger.evidence.remainders import Remainder, unreached, untied
from tresym.ledger.judge import judge
from tresym.reals.balls.branch_and_bound import box
from tresym.reals.verdict import Verdict

equal = partial(Eq, evaluate=False)

pytestmark = pytest.mark.quick

x, y = (Symbol(name, real=True) for name in "xy")
O = Function("O")  # noqa: E741
HOT = Symbol("hot", real=True)
SUM = x + x**2


def bounded(formula: Any, remainder: Remainder | None) -> Claim:
    """An order beside |x + x²| <= 3x for 0 < x < 1."""
    margins = (lambda s, m: 3 - (1 + s), lambda s, m: 3 + (1 + s))
    on = On((x,), box(("0", "1")), tuple(Shown(margin, x) for margin in margins))
    proof = Charted((on,), remainder=remainder)
    return Claim("order", formula, proof, given=(x > 0, x < 1), means=Abs(SUM) <= 3 * x)


@pytest.mark.parametrize("formula", [equal(SUM, O(x)), equal(1 + SUM, 1 + 2 * O(x))], ids=str)
def test_a_bound_of_what_is_left_out_shows_the_order(formula: Any) -> None:
    shown = bounded(formula, Remainder(x))
    assert judge(shown, {}).verdict is Verdict.ENCLOSED
    assert is_formal(shown)


def test_an_order_that_is_read_is_not_formal() -> None:
    read = bounded(equal(y, O(x)), Remainder(x, (), ((y, SUM),)))
    assert judge(read, {}).verdict is Verdict.ENCLOSED
    assert not is_formal(read)


def test_higher_orders_vanish_beside_what_stands_before_them() -> None:
    assert untied(bounded(equal(1 + HOT, 1 + SUM), Remainder(x))) is None
    assert untied(bounded(equal(x + HOT, x + SUM), Remainder(x))) is not None


def test_a_region_reaches_a_point_from_one_side_or_from_both() -> None:
    near = conditions((x > 0, x < 1))
    assert unreached("x", near) is None
    assert unreached("x", near, both=True) is not None
    assert unreached("x", conditions((x > -1, x < 1)), both=True) is None
    assert unreached("x", conditions((2 * x > 1,))) is not None
