"""Statements with heads of their own: what is free in them, what is bound, and how they read."""

import pytest
from sympy import Function, Gt, Symbol, Tuple, cos
from sympy_statements import ExactlyOne, Under, equal, order, together_under

from tresym.report.typesetting.latex import says_latex

pytestmark = pytest.mark.quick

x, y, z = (Symbol(name, real=True) for name in "xyz")
ROOT = ExactlyOne(x, 0, y, equal(cos(x), z))
ORDER = order(equal(cos(x), 1 + Function("O")(x**2)), x)


def test_a_bound_name_is_not_free() -> None:
    assert ROOT.free_symbols == {y, z}
    assert ExactlyOne(x, 0, x, equal(cos(x), z)).free_symbols == {x, z}


def test_nothing_is_worked_out() -> None:
    vacuous = ExactlyOne(x, 1, 0, equal(x, x))
    assert vacuous.args[3] == equal(x, x)
    assert Under(vacuous, Tuple()) != vacuous


@pytest.mark.parametrize(
    ("says", "shown"),
    [
        (ROOT, r"\exists!\, x \in (0, y):\ \cos x = z"),
        (Under(x < y, Tuple(x > 0, y > 1)), r"x < y\quad(x > 0,\ y > 1)"),
        (Under(x < y, Tuple()), "x < y"),
        (ORDER, r"\cos x = 1+O(x^2)\quad(x \to 0^+)"),
    ],
)
def test_they_are_read_as_mathematics(says: object, shown: str) -> None:
    assert says_latex(says) == shown


def test_a_conjunction_says_each_part_once_with_its_conditions() -> None:
    first, second = Under(x < y, Tuple(x > 0)), Under(Gt(y, z), Tuple())
    once = together_under([(x < y, (x > 0,)), (Gt(y, z), ())])
    assert once == Tuple(first, second)
    assert together_under([(once, ()), (x < y, (x > 0,))]) == once
    assert together_under([(once, (z > 0,))]) == Tuple(Under(once, Tuple(z > 0)))
