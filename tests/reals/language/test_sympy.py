"""The door to SymPy: the same expressions on both sides, everything else refused."""

from typing import Any

import pytest
import sympy as sp

from tresym.reals.language.binders import at, derivative, integral, limit, order, ordered
from tresym.reals.language.expression import FUNCTIONS, apply, number, substitute, symbol
from tresym.reals.language.formula import Conjunction, Equivalence, Relation
from tresym.reals.language.parsing import parse
from tresym.reals.language.sympy import formula, from_sympy, unworked
from tresym.reals.language.to_sympy import to_sympy
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
        (sp.hankel1(0, x), "hankel1"),
        (sp.dirichlet_eta(x), "dirichlet_eta"),
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


def test_derivatives_are_carried_out_and_integrals_refused() -> None:
    assert from_sympy(sp.Derivative(x**2, x)) == parse("diff(x**2, x)") == parse("2*x")
    with pytest.raises(InputError, match="is outside the expressions"):
        from_sympy(sp.Derivative(sp.Integral(sp.sin(x * y), (y, 0, 1)), x))


def test_nothing_is_evaluated_on_the_way() -> None:
    """0·log x is not 0, and sqrt(x²) not x."""
    assert str(from_sympy(sp.Mul(0, sp.log(x), evaluate=False))) == "0*log(x)"
    assert from_sympy(sp.sqrt(sp.Symbol("z") ** 2)) == parse("sqrt(z**2)")


y = sp.Symbol("y", real=True)
X, Y, ZERO, ONE = symbol("x"), symbol("y"), number(0), number(1)


@pytest.mark.parametrize(
    ("e", "tree"),
    [
        (sp.Integral(x * y, (x, 0, y)), integral(X * Y, "x", ZERO, Y)),
        (
            sp.Integral(x * y, (x, 0, y), (y, 0, 1)),
            integral(integral(X * Y, "x", ZERO, Y), "y", ZERO, ONE),
        ),
        (sp.Derivative(x**2 * y, x), derivative(X**2 * Y, "x")),
        (sp.Derivative(x**2 * y, x, y), derivative(derivative(X**2 * Y, "x"), "y")),
        (sp.Subs(x / y, (x, y), (y, x)), at(X / Y, {"x": Y, "y": X})),
        (sp.Subs(sp.Derivative(x**2 * y, x), x, 0), derivative(X**2 * Y, "x", ZERO)),
        (sp.Limit(x * y, x, 0, "-"), limit(X * Y, "x", ZERO, -1)),
        (sp.Function("O")(x), order("O", X)),
    ],
    ids=str,
)
def test_what_is_not_worked_out_becomes_a_node_and_comes_back(e: Any, tree: Any) -> None:
    assert ordered(unworked(e)) == ordered(tree)
    assert ordered(unworked(to_sympy(tree))) == ordered(tree)


def test_names_are_chosen_anew_where_they_would_capture() -> None:
    tree = integral(X * Y, "x", ZERO, ONE)
    changed = substitute(tree, {"y": X})
    assert ordered(unworked(to_sympy(changed))) == ordered(changed)


@pytest.mark.parametrize(
    ("e", "keyword"),
    [
        (sp.Integral(x, x), "two ends"),
        (sp.Subs(y, x, 0), "depends on x"),
        (sp.Derivative(f(x), x), "unknown"),
        (sp.Derivative(x**20, (x, 11), evaluate=False), "order"),
    ],
    ids=str,
)
def test_what_says_nothing_is_no_node(e: Any, keyword: str) -> None:
    """The value at x = 0 of a symbol y would be y, whatever y stands for."""
    with pytest.raises(InputError, match=keyword):
        unworked(e)


def test_formulas() -> None:
    positive = Relation(X, ">", ZERO)
    assert formula(sp.Gt(x, 0)) == positive
    assert formula(sp.Eq(x, y, evaluate=False)) == Relation(X, "==", Y)
    assert formula(sp.Tuple(x > 0, y <= 1)) == Conjunction((positive, Relation(Y, "<=", ONE)))
    system = sp.Eq(sp.ImmutableMatrix([x, 0]), sp.ImmutableMatrix([y, 1]), evaluate=False)
    expected = Conjunction((Relation(X, "==", Y), Relation(ZERO, "==", ONE)))
    assert formula(system) == expected
    both = sp.Equivalent(sp.Eq(x, y), sp.Eq(x, 0), evaluate=False)
    assert {*formula(both)} == {Relation(X, "==", Y), Relation(X, "==", ZERO)}
    assert isinstance(formula(both), Equivalence)
    assert formula(sp.true) == Conjunction(())
    assert formula(sp.false) == Relation(ZERO, "!=", ZERO)
    for wrong in (x, sp.Not(sp.Eq(x, y) & (x > 0)), sp.Or(x > 0, y > 0)):
        with pytest.raises(InputError):
            formula(wrong)
