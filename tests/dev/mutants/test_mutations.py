"""One change at a time: each differs from what it was made of, and keeps its kind."""

import pytest
from sympy import (
    Basic,
    Derivative,
    Eq,
    Equivalent,
    I,
    Integral,
    Matrix,
    Rational,
    Subs,
    Symbol,
    Tuple,
    cos,
    nan,
    oo,
    sin,
    sqrt,
    zoo,
)

from tresym.dev.mutants.mutations import mutations, of_relations
from tresym.ledger.claim import equal
from tresym.ledger.statements import TheRoot

x, y, t, a, b = (Symbol(name, real=True) for name in "xytab")

CHANGED = [
    (x + y, {x - y, y - x, x, y, 2 * x + y, x + 2 * y}),
    (x * y, {x, y, -x * y, 2 * x * y}),
    (x**2, {x**3, x, x**4}),
    (sin(x), {cos(x), -sin(x), sin(2 * x)}),
    (cos(x), {sin(x), -cos(x)}),
    (Rational(3, 4) * x, {Rational(7, 4) * x, x * Rational(3, 2)}),
    (a - b / 2, {b - a / 2}),
    (x > y, {x < y, 2 * x > y}),
    (x <= y, {x >= y}),
    (equal(x, y), {equal(x, 2 * y), equal(-x, y)}),
    (Integral(t * x, (t, 0, y)), {Integral(t * x, (t, 1, y)), Integral(t * x, (t, 0, 2 * y))}),
    (Derivative(x**2, x), {Derivative(x**3, x)}),
    (Subs(x**2, x, y), {Subs(x**3, x, y), Subs(x**2, x, 2 * y)}),
    (Matrix([x, y]).as_immutable(), {Matrix([2 * x, y]).as_immutable()}),
]


@pytest.mark.parametrize(("e", "wanted"), CHANGED, ids=[str(e) for e, _ in CHANGED])
def test_slips_are_made(e: Basic, wanted: set[Basic]) -> None:
    assert wanted <= set(mutations(e, (a, b))) | {e}


ALL = [e for e, _ in CHANGED] + [
    Equivalent(Eq(x, 1), Eq(y, 1)),
    Tuple(x > 0, y > 0),
    equal(sqrt(1 - x**2) / x, a * b),
    equal(x, x),
]


@pytest.mark.parametrize("e", ALL, ids=str)
def test_changes_differ_from_each_other_and_from_what_they_change(e: Basic) -> None:
    found = list(mutations(e, (a, b)))
    assert found
    assert e not in found
    assert len(found) == len(set(found))
    assert found == list(mutations(e, (a, b)))
    for changed in found:
        assert not changed.has(nan, oo, zoo, I)
        if isinstance(e, Eq | Equivalent | Tuple):
            assert isinstance(changed, type(e))


def test_bound_variables_stay() -> None:
    for e in (Integral(t, (t, 0, 1)), Derivative(t**2, t), Subs(t, t, 1)):
        for changed in mutations(e, (a, b)):
            assert not changed.has(type(e)) or changed.atoms(type(e)).pop().variables == e.variables


def test_the_name_of_a_root_stays_a_name() -> None:
    root = TheRoot(t, 0, x, equal(t * x, 1))
    found = [node for e in mutations(root + y, (a, b)) for node in e.atoms(TheRoot)]
    assert {node.variable for node in found} == {t}
    assert len(set(found)) > 5


def test_each_relation_is_turned_round_first() -> None:
    found = list(of_relations(Tuple(x > 0, y <= 1)))
    assert found[:2] == [Tuple(x < 0, y <= 1), Tuple(x > 0, y >= 1)]
    assert Tuple(x > 0, y <= 2) in found
    assert (x > 2) in of_relations(x > 0)
