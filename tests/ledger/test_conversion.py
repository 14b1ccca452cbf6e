"""From what claims say to what is decided: trees made once, and definitions put in."""

import pytest
from sympy import (
    Basic,
    Derivative,
    Eq,
    Equivalent,
    Function,
    Integral,
    Matrix,
    Ne,
    Subs,
    Symbol,
    Tuple,
    sin,
)
from sympy_statements import equal

from tresym.ledger.claim import (
    Claim,
    Definition,
)
from tresym.ledger.conversion import (
    CircularError,
    Rules,
    conditions,
    conjuncts,
    definitions,
    formula,
    known,
    misread,
    put_in,
    put_into,
    stage,
)
from tresym.ledger.formulas import in_trees
from tresym.reals.domain.conditions import Given
from tresym.reals.language.binders import generalised, worked_out
from tresym.reals.language.expression import ONE
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.exact import InputError

x, y, z, t, u = (Symbol(name, real=True) for name in "xyztu")


def defined(*says: Basic) -> Rules:
    return definitions(Claim(f"d{n}", e, Definition()) for n, e in enumerate(says))


def test_definitions_are_put_in_until_none_is_left() -> None:
    rules = defined(equal(x, y + 1), equal(y, z**2))
    assert put_in(parse("2*x"), rules) == parse("2*(z**2 + 1)")


def test_systems_and_matrices_define_entry_by_entry() -> None:
    rules = defined(Tuple(equal(x, t), y > 0), Eq(Matrix([y, z]), Matrix([t, 2 * t])))
    assert rules == {parse("x"): parse("t"), parse("y"): parse("t"), parse("z"): parse("2*t")}


def test_a_number_is_replaced_by_nothing() -> None:
    assert defined(equal(1, x)) == {}
    assert defined(Equivalent(equal(x, 1), equal(y, 1))) == {}


@pytest.mark.parametrize("rules", [{"x": "x + 1"}, {"x": "y + 1", "y": "x"}], ids=str)
def test_circles_are_refused(rules: dict[str, str]) -> None:
    with pytest.raises(CircularError):
        put_in(parse("x + y"), {parse(left): parse(right) for left, right in rules.items()})


@pytest.mark.parametrize(
    ("e", "rule", "expected"),
    [
        (Integral(x * t, (t, 0, 1)), (x, y), Integral(y * t, (t, 0, 1))),
        (Integral(x * t, (t, 0, 1)), (t, 5), Integral(x * t, (t, 0, 1))),
        (Integral(x * u, (u, 0, 1)), (x, t), Integral(t * u, (u, 0, 1))),
        (Integral(x * t, (t, 0, 1)), (x, t), Integral(t * u, (u, 0, 1))),
        (Integral(t, (t, 0, x)), (x, t), Integral(u, (u, 0, t))),
        (Derivative(x**2 * y, x), (x, 2 * z), Subs(Derivative(x**2 * y, x), x, 2 * z)),
        (Derivative(x**2 * y, x), (y, x), Subs(Derivative(u**2 * x, u), u, x)),
        (Subs(x / y, x, t), (y, x), Subs(u / x, u, t)),
        (t + sin(x), (sin(x), z), t + z),
        (Integral(sin(x), (x, 0, y)), (sin(x), z), Integral(sin(x), (x, 0, y))),
        (1 + Derivative(x**2, x), (Derivative(x**2, x), z), 1 + z),
    ],
    ids=str,
)
def test_what_is_put_in_is_not_captured(
    e: Basic, rule: tuple[Basic, Basic], expected: Basic
) -> None:
    left, right = map(in_trees, rule)
    found, wanted = generalised(put_in(in_trees(e), {left: right}), in_trees(expected))
    assert found == wanted


def test_a_bound_defines_nothing() -> None:
    assert defined(x < y, Tuple(z >= t, equal(u, 1))) == {parse("u"): ONE}


def test_conditions_are_put_into_each_once() -> None:
    given = conditions((x > 0, y > 0))
    assert put_into(given, {parse("x"): parse("y")}) == conditions((y > 0,))


@pytest.mark.parametrize(
    ("e", "behind", "found"),
    [
        (Integral(y, (t, 0, 1)), "t", "y"),
        (Integral(y, (t, 0, 1)), "x", None),
        (1 + Derivative(y * x, x), "x", "y"),
        (Integral(u * y * z, (t, 0, 1)), "t", "y"),
        (Derivative(sin(x), x) + Integral(y, (t, 0, 1)), "t", "y"),
        (Subs(y * t, t, 0), "t", "y"),
        (Integral(x, (t, 0, y)), "t", None),
        (Integral(Integral(y, (u, 0, 1)), (t, 0, 1)), "t", "y"),
        (y + t, "t", None),
    ],
    ids=str,
)
def test_a_symbol_for_a_function_of_what_is_bound_is_seen(
    e: Basic, behind: str, found: str | None
) -> None:
    """∫ y dt with y = t + 1 is y for a tree, and 3/2 for a reader."""
    assert misread(in_trees(e), {"y": frozenset(behind)}) == found


@pytest.mark.parametrize(
    ("one", "other", "same"),
    [
        (Integral(sin(t), (t, 0, x)), Integral(sin(u), (u, 0, x)), True),
        (Integral(sin(t) * x, (t, 0, x)), Integral(x * sin(z), (z, 0, x)), True),
        (Integral(sin(t), (t, 0, x)), Integral(sin(t), (t, 0, y)), False),
        (Integral(2 * t, (t, 0, 1)), 2 * Integral(t, (t, 0, 1)), True),
        (Integral(t, (t, 0, 1)), Integral(t, (t, 1, 0)), False),
        (Integral(t * x, (t, 0, 1)), Integral(t * x, (x, 0, 1)), False),
        (Derivative(x**2, x), Derivative(x**3, x), False),
        (Derivative(sin(x), x), Derivative(sin(x), (x, 2)), False),
        (Subs(x**2, x, y), Subs(x**2, x, z), False),
    ],
    ids=str,
)
def test_what_is_not_opened_is_itself_alone(one: Basic, other: Basic, same: bool) -> None:
    left, right = generalised(in_trees(one), in_trees(other))
    assert (left == right) is same


def test_derivatives_and_values_open_where_they_may() -> None:
    assert worked_out(in_trees(Derivative(x**2, x))) == parse("2*x")
    assert worked_out(in_trees(Subs(x**2 + y, (x, y), (3, z)))) == parse("9 + z")
    kept = in_trees(Derivative(Integral(x * t, (t, 0, 1)), x))
    assert worked_out(kept) == kept
    free = in_trees(Derivative(y * Integral(t, (t, 0, 1)), y))
    assert worked_out(free) == in_trees(Integral(t, (t, 0, 1)))


def test_a_function_that_is_not_known_is_refused() -> None:
    with pytest.raises(InputError, match="unknown"):
        in_trees(Function("f")(x))


def test_a_symbol_that_stands_for_a_function_is_misread_at_a_point() -> None:
    """The value of y at x = 0 would be y, where y is a function of x."""
    assert misread(in_trees(Subs(y, x, 0)), {"y": frozenset("x")}) == "y"
    assert misread(in_trees(Subs(y, x, 0)), {"y": frozenset("z")}) is None


def test_conditions_are_those_of_the_engine() -> None:
    assert known(conditions((x > 0, y <= 1))) == Given.parse("x > 0, y <= 1")
    assert known(conditions((x > 0, Integral(t, (t, 0, x)) > 1))) == Given.parse("x > 0")
    assert conditions((Ne(x, 0) & (y > 0),)) in (
        conditions((Ne(x, 0), y > 0)),
        conditions((y > 0, Ne(x, 0))),
    )


@pytest.mark.parametrize("wrong", [equal(x, y), Equivalent(x > 0, y > 0), x])
def test_an_equation_or_an_equivalence_is_no_condition(wrong: Basic) -> None:
    """A condition on one side of an equivalence is no condition."""
    with pytest.raises(InputError):
        conditions((wrong,))


def test_what_a_chain_passes_through() -> None:
    equation = stage(equal(x, 1))
    assert equation == Relation(parse("x"), "==", ONE)
    assert stage(x) == (parse("x"),)
    with pytest.raises(InputError):
        stage(x > 0)


def test_parts_of_parts() -> None:
    assert len([*conjuncts(formula(Tuple(x > 0, Tuple(y > 0))))]) == 2
