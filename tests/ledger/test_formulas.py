"""Statements of the ledger as trees."""

from __future__ import annotations

import sympy_statements as statements
from sympy import Eq, Gt, Symbol, Tuple, oo

from tresym.ledger.formulas import Under, bound_names, in_trees, names_of, parts_of, relations_of
from tresym.reals.language.compound import Equivalent, Together
from tresym.reals.language.expression import ONE, symbol

x, y = (Symbol(name, real=True) for name in "xy")


def test_a_statement_of_sympy_has_the_same_free_names() -> None:
    written = (
        Eq(x, y, evaluate=False),
        Tuple(Gt(x, 0), Eq(y, x**2)),
        statements.ExactlyOne(x, 0, y, Eq(x**2, 2)),
        statements.Under(Gt(x, 0), Tuple(Gt(y, 0))),
        statements.Rounds(x * y, "0.50"),
        statements.order(Eq(x, Symbol("z", real=True)), y, oo),
    )
    for says in written:
        assert names_of(in_trees(says)) == {s.name for s in says.free_symbols}


def test_a_counted_variable_is_bound() -> None:
    count = in_trees(statements.AtMostOne(x, 0, 1, Eq(x**3, y)))
    assert bound_names(count) == {"x"}
    assert names_of(count) == {"y"}


def test_the_order_of_terms_does_not_matter() -> None:
    assert in_trees(Eq(x + y, 1)) == in_trees(Eq(y + x, 1, evaluate=False))


def test_a_conjunction_is_no_equivalence() -> None:
    part = next(relations_of(in_trees(Gt(x, 0))))
    assert Together((part,)) != Equivalent((part,))
    assert parts_of(Under(part, ())) == (Under(part, ()),)
    assert part.left == symbol("x")
    assert part.right != ONE
