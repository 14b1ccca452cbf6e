"""Traced formulas: the same steps in balls and in trees."""

import pytest
from flint import arb, fmpq

from tresym.reals.balls.gradient import Divided, coordinates, gradients
from tresym.reals.balls.tracing import Named, Part, traced
from tresym.reals.domain.evaluation import evaluate
from tresym.reals.language.expression import symbol, trees
from tresym.reals.numbers.arithmetic import ball_precision, balls

X, Y = symbol("x"), symbol("y")
POINT = {"x": fmpq(1, 3), "y": fmpq(2, 7)}
log_over = Divided(lambda s: (1 + s).log(), 2)


@Part
def shared(x, m):
    return m.exp(x) / (1 + x) - x**2


def formula(x, y, m):
    both = shared(x, m) + shared(x, m) * log_over(x * y)
    return fmpq(1, 7) - both * m.sqrt(y) + m.expm1(x) - m.log1p(y) * (-y) / (2 - m.pi)


def plainly(op, args, body=None):
    return body() if body else op.meaning(*args)


def test_what_runs_is_what_is_meant() -> None:
    program = traced(formula, 2)
    with ball_precision(128):
        value = program(*(arb(x) for x in POINT.values()), balls)
        tree = program.meaning((X, Y), plainly)
        assert abs(value - evaluate(tree, POINT)) < 1e-30
        assert value.overlaps(formula(*(arb(x) for x in POINT.values()), balls))
        found = program(*coordinates(tuple(arb(x) for x in POINT.values())), gradients)
        assert found.value.overlaps(value)


def test_equal_steps_are_done_once() -> None:
    assert sum(step[0] == "exp" for step in traced(formula, 2).steps) == 1


def test_a_part_may_be_read_otherwise() -> None:
    read = traced(formula, 2).meaning(
        (X, Y), lambda op, args, body=None: Y if op is shared else op.meaning(*args)
    )
    assert "exp(x)/(" not in str(read)


@pytest.mark.parametrize(
    "wrong",
    [
        lambda x, m: arb(1),
        lambda x, m: fmpq(1),
        lambda x, m: x + arb("0.5"),
        lambda x, m: x + 0.5,
        lambda x, m: x if x > 0 else -x,
        lambda x, m: x or 1,
        lambda x, m: m.abs(x),
        lambda x, m: x.union(x),
        lambda x, m: x.value,
    ],
)
def test_what_goes_by_values_is_not_traced(wrong) -> None:
    with pytest.raises((TypeError, AttributeError)):
        traced(wrong, 1)


def test_a_formula_cannot_tell_its_bounds_something_else() -> None:
    """It is run once; what it would do with balls is never asked."""
    program = traced(lambda x, m: arb(1) if isinstance(x, arb) else x, 1)
    assert program(arb(-3), balls) < 0


def test_a_named_function_has_its_own_program() -> None:
    double = Named(lambda x: 2 * x, lambda x: x + x)
    program = traced(lambda x, m: double(x) + 1, 1)
    assert program(arb(2), balls) == 5
    assert program.meaning((X,), plainly) == X + X + 1
    assert trees.sqrt(X) == traced(lambda x, m: x.sqrt(), 1).meaning((X,), plainly)
