"""Relations, and what is made of them."""

from itertools import product

import pytest

from tresym.reals.language.expression import Expr, number, symbol
from tresym.reals.language.formula import (
    MIRRORED,
    NEGATED,
    Conjunction,
    Equivalence,
    Relation,
    names,
    relations,
)

pytestmark = pytest.mark.quick

HOLDS = {
    "==": lambda p, q: p == q,
    "!=": lambda p, q: p != q,
    ">": lambda p, q: p > q,
    "<": lambda p, q: p < q,
    ">=": lambda p, q: p >= q,
    "<=": lambda p, q: p <= q,
}


def _true(relation: Relation) -> bool:
    def exact(e: Expr) -> int:
        return int(e.args[0].p)

    return bool(HOLDS[relation.sign](exact(relation.left), exact(relation.right)))


@pytest.mark.parametrize("sign", sorted(HOLDS))
def test_mirrored_and_negated_on_numbers(sign: str) -> None:
    for p, q in product(range(-1, 2), repeat=2):
        relation = Relation(number(p), sign, number(q))
        assert _true(relation.mirrored) is _true(relation)
        assert _true(relation.upward) is _true(relation)
        assert _true(relation.negated) is not _true(relation)
        assert relation.mirrored.mirrored == relation.negated.negated == relation
        assert relation.upward.sign not in ("<", "<=")


def test_there_is_a_row_for_each_relation() -> None:
    assert MIRRORED.keys() == NEGATED.keys() == HOLDS.keys()


def test_relations_of_a_formula_in_order() -> None:
    x, y = symbol("x"), symbol("y")
    one, other = Relation(x, ">", number(0)), Relation(y, "==", x)
    whole = Conjunction((Equivalence(one, other), Conjunction(()), other))
    assert [*relations(whole)] == [one, other, other]
    assert names(whole) == {"x", "y"}
    assert str(Equivalence(one, Conjunction((one, other)))) == "x > 0 <=> x > 0 and y == x"
    assert not [*relations(Conjunction(()))]
