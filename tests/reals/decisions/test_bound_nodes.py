"""What binds a variable goes through every procedure of the core without an internal error."""

from collections.abc import Callable

import pytest
from flint import fmpq

from tresym.reals.decisions.ideals import follows, numerator_factors
from tresym.reals.decisions.identity import decide
from tresym.reals.decisions.inequalities import decide_inequality
from tresym.reals.domain.conditions import Given
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.expansions.limit_values import limit_of
from tresym.reals.language import binders
from tresym.reals.language.expression import HALF, ZERO, Expr, apply, number, symbol, unknown
from tresym.reals.normal.at_point import equal_at
from tresym.reals.normal.polynomials import polynomial
from tresym.reals.normal.to_expression import in_lowest_terms, normal_form
from tresym.reals.signs.closure import is_regular
from tresym.reals.signs.interior import is_zero
from tresym.reals.signs.sign import proof, sign
from tresym.reals.verdict import Verdict

X, T = symbol("x"), symbol("t")
BODY = apply("sin", X * T) + T**2
NODES = {
    "integral": binders.integral(BODY, "t", ZERO, X),
    "series": binders.total("sum", X**T / T, "t", number(1), symbol("oo")),
    "product": binders.total("product", 1 + X / T, "t", number(1), symbol("n")),
    "derivative": binders.derivative(BODY, "t", X),
    "nth": binders.nth_derivative(BODY, "t", symbol("n")),
    "at": binders.at(BODY, {"t": X}),
    "limit": binders.limit(BODY, "t", X),
    "root": binders.root(T**2 - X, "t", ZERO, X),
    "antiderivative": binders.antiderivative(BODY, "t"),
    "unknown": unknown("f", (X,)),
}
AROUND: list[Callable[[Expr], Expr]] = [
    lambda node: node,
    lambda node: X * node**2,
    lambda node: node**HALF,
    lambda node: apply("sin", node) + X,
    lambda node: 1 / node + X,
    lambda node: apply("log", node),
]
POINT = {"x": fmpq(1, 2), "n": fmpq(2), "t": fmpq(1), "oo": fmpq(1)}


@pytest.mark.slow
@pytest.mark.parametrize("node", NODES.values(), ids=NODES.keys())
@pytest.mark.parametrize("around", range(len(AROUND)))
def test_no_procedure_enters_what_binds(node: Expr, around: int) -> None:
    e = AROUND[around](node)
    assert normal_form(e, Given()) == e
    assert not evaluate(e, POINT).is_finite()
    assert polynomial(e) is None
    assert not is_zero(e, Given())
    assert decide(e, e + 1, Given()).verdict is Verdict.UNDECIDED
    assert not decide_inequality(e, ">", X, Given())
    assert not follows(e, [X], [], vanishes=True)
    assert numerator_factors(e) is None
    assert limit_of(e, "x", ZERO, 1, Given()) is None
    assert not equal_at(e, ZERO, {"x": fmpq(1)})
    in_lowest_terms(e)
    sign(e, Given())
    proof(e, ">", Given())
    condition = Given(((e, ">=", ZERO),))
    is_regular(condition)
    assert next(condition.points(["x"], 1), None) is None
