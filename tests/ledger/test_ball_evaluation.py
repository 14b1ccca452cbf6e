"""Values apart from the engine, in balls."""

from collections.abc import Callable
from typing import Any

import mpmath
import pytest
from flint import arb, fmpq

from tresym.ledger.ball_evaluation import Place, value
from tresym.reals.language.parsing import as_written
from tresym.reals.numbers.arithmetic import ball_precision

VALUES: list[tuple[str, Callable[[Any, Any], Any]]] = [
    ("sin(x)*exp(x)/(1 + x**2)", lambda m, v: m.sin(v) * m.exp(v) / (1 + v**2)),
    ("x**pi + sqrt(x) + x**-3", lambda m, v: v**m.pi + m.sqrt(v) + v**-3),
    ("abs(-x) + sign(x)", lambda m, v: v + 1),
    ("integral(exp(-t*x), t, 0, 1)", lambda m, v: (1 - m.exp(-v)) / v),
    ("integral(sqrt(t), t, x, 4)", lambda m, v: 2 * (8 - v ** m.mpf("1.5")) / 3),
    ("diff(x**3*log(x), x)", lambda m, v: 3 * v**2 * m.log(v) + v**2),
    (
        "diff(integral(exp(-t*x), t, 1, 2), x)",
        lambda m, v: -m.quad(lambda t: t * m.exp(-t * v), (1, 2)),
    ),
    ("asin(x/2) + atanh(x/2)", lambda m, v: m.asin(v / 2) + m.atanh(v / 2)),
]


@pytest.mark.parametrize(("text", "expected"), VALUES, ids=[text for text, _ in VALUES])
def test_values_agree_with_mpmath(text: str, expected: Callable[[Any, Any], Any]) -> None:
    with ball_precision(128), mpmath.workdps(30):
        found = value(as_written(text), {"x": arb(fmpq(7, 5))})
        near = arb(mpmath.nstr(expected(mpmath.mp, mpmath.mpf(7) / 5), 25))
        assert abs(found - near).contains(0) or abs(found - near) < 1e-20
        assert found.rad() < 1e-2


@pytest.mark.parametrize(
    ("text", "at"),
    [
        ("1/x", 0),
        ("sqrt(x)", -1),
        ("log(x)", 0),
        ("x**y", -1),
        ("sign(x)/sign(x)", 0),
        ("asin(x)", 2),
        ("acosh(x)", 0),
        ("tan(x)/x", 0),
        ("integral(1/t, t, -1, 1)", 0),
        ("integral(log(t), t, x, 1)", -1),
        ("integral(t, t, 0, 1/x)", 0),
        ("x + z", 0),
    ],
)
def test_where_nothing_is_defined_there_is_no_number(text: str, at: int) -> None:
    with ball_precision(64):
        assert not value(as_written(text), {"x": arb(at), "y": arb(2)}).is_finite()


def test_a_symbol_with_a_rule_has_the_value_of_its_meaning() -> None:
    rules = {"y": as_written("z**2"), "z": as_written("x + 1")}
    with ball_precision(64):
        assert Place({"x": arb(2)}, rules).value(as_written("y + 1")) == 10


def test_a_program_is_made_for_each_precision() -> None:
    third = as_written("x + 1/3")
    with ball_precision(64):
        rough = value(third, {"x": arb(0)})
    with ball_precision(640):
        assert value(third, {"x": arb(0)}).rad() < rough.rad() * arb((1, -500))
