"""The door to SymPy: the same expressions on both sides, everything else refused."""

from __future__ import annotations

from typing import Any

import pytest
import sympy as sp

from tresym.reals.language.expression import FUNCTIONS, apply, symbol
from tresym.reals.language.parsing import parse
from tresym.reals.language.sympy import from_sympy, to_sympy
from tresym.reals.numbers.exact import InputError

x, y = sp.symbols("x y", real=True)
f = sp.Function("f")

READ = [
    (sp.Rational(-7, 3), "-7/3"),
    (sp.pi + sp.E, "pi + E"),
    (sp.sqrt(x) / y**2, "sqrt(x)*y**(-2)"),
    (sp.Abs(x) + sp.sign(y), "abs(x) + sign(y)"),
    (sp.acot(x), "atan(1/x)"),
    (sp.asec(x), "acos(1/x)"),
    (sp.acoth(x), "atanh(1/x)"),
    (sp.Max(x, y), "max(x, y)"),
    (sp.Min(x, y), "min(x, y)"),
    (sp.Derivative(x**3, x), "3*x**2"),
    (sp.Derivative(sp.sin(x), (x, 2)), "-sin(x)"),
    (sp.Derivative(x * y, x, y), "1"),
    (sp.Integer(10) ** 900, "10**900"),
]


@pytest.mark.parametrize(("e", "text"), READ, ids=[text for _, text in READ])
def test_sympy_is_read(e: Any, text: str) -> None:
    found, expected = to_sympy(from_sympy(e)), to_sympy(parse(text))
    assert sp.expand(found - expected) == 0


@pytest.mark.parametrize("name", sorted(FUNCTIONS - {"cbrt"}))
def test_every_function_returns_as_itself(name: str) -> None:
    e = apply(name, symbol("x"))
    assert from_sympy(to_sympy(e)) == e


def test_the_real_cube_root_of_a_negative_number_is_real() -> None:
    value = to_sympy(parse("cbrt(x)")).subs(sp.Symbol("x", real=True), -8)
    assert value == -2
    assert to_sympy(parse("cbrt(-8)")) != sp.cbrt(-8)


@pytest.mark.parametrize(
    ("e", "keyword"),
    [
        (sp.Float("0.1"), "Float"),
        (x + 0.5, "Float"),
        (0.5, "Float"),
        (sp.I * x, "I"),
        (1 + 2j, ""),
        (sp.oo, ""),
        (sp.zoo, ""),
        (sp.nan, ""),
        (sp.gamma(x), "gamma"),
        (sp.LambertW(x), "LambertW"),
        (sp.Piecewise((x, x > 0), (0, True)), ""),
        (sp.Integral(x, x), "Integral"),
        (sp.Derivative(sp.Integral(f(x), x), x), ""),
        (sp.Derivative(f(x), x), "unknown"),
        (sp.Function("sin_")(x), "unknown"),
        (sp.Derivative(x**20, (x, 11), evaluate=False), "order"),
        (sp.Symbol("A", commutative=False) ** 1001, "exponent"),
        (sp.Matrix([x]), ""),
        (sp.true, ""),
        ("x + 1", "text"),
        ("__import__('os')", "text"),
    ],
    ids=str,
)
def test_the_rest_is_refused_in_one_line(e: Any, keyword: str) -> None:
    with pytest.raises(InputError) as caught:
        from_sympy(e)
    assert keyword in str(caught.value)
    assert "\n" not in str(caught.value)


def test_an_unknown_function_is_not_taken_for_a_known_one() -> None:
    with pytest.raises(InputError):
        from_sympy(sp.Function("sin")(x))


def test_a_derivative_may_be_read_in_another_way() -> None:
    e = from_sympy(1 + sp.Derivative(x**2, x), lambda node, walk: walk(node.expr))
    assert e == parse("1 + x**2") or e == parse("x**2 + 1")


def test_nothing_is_evaluated_on_the_way() -> None:
    """0·log x is not 0, and sqrt(x²) not x."""
    assert str(from_sympy(sp.Mul(0, sp.log(x), evaluate=False))) == "0*log(x)"
    assert from_sympy(sp.sqrt(sp.Symbol("z") ** 2)) == parse("sqrt(z**2)")
