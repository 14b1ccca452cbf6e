"""Variables that are bound: equality up to their names, and substitution that captures nothing.

Random terms are written twice: as trees, and with all their names as nested tuples, which are
evaluated in complex balls by environments. Integrals are enclosed by quadrature and derivatives by
Cauchy's formula, so nothing of the trees is used there.
"""

import pickle
from typing import Any

import pytest
from flint import acb, arb
from hypothesis import assume, given, settings
from hypothesis import strategies as st

from tresym.reals.language.binders import (
    at,
    derivative,
    elementary,
    generalised,
    integral,
    limit,
    order,
    ordered,
    outermost,
    worked_out,
)
from tresym.reals.language.derivatives import differentiate
from tresym.reals.language.expression import (
    MAX_DEPTH,
    Expr,
    apply,
    bind,
    number,
    opened,
    rebuild,
    replaced,
    substitute,
    symbol,
    symbols,
)
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import InputError

pytestmark = pytest.mark.quick

x, y, z = map(symbol, "xyz")
NAMES = st.sampled_from("xyz")
Term = tuple[Any, ...]


def terms(depth: int, binders: int) -> st.SearchStrategy[Term]:
    """Terms with at most so many binders inside each other, over three names only."""
    leaves = st.one_of(
        st.tuples(st.just("symbol"), NAMES),
        st.tuples(st.just("number"), st.integers(-2, 2)),
    )
    if depth == 0:
        return leaves
    inner, body = terms(depth - 1, binders), terms(depth - 1, binders - 1)
    flat = terms(min(depth - 1, 1), 0)
    kinds = [
        leaves,
        st.tuples(st.sampled_from(("+", "*")), inner, inner),
        st.tuples(st.sampled_from(("sin", "cos")), inner),
    ]
    if binders:
        kinds += [
            st.tuples(st.just("integral"), NAMES, body, flat, flat),
            st.tuples(st.just("derivative"), NAMES, body, flat),
            st.tuples(st.just("at"), NAMES, body, inner),
        ]
    return st.one_of(kinds)


TERMS = terms(3, 2)
FLAT = terms(2, 0)


def tree(term: Term) -> Expr:
    match term:
        case "symbol", name:
            return symbol(name)
        case "number", n:
            return number(n)
        case "integral", name, body, low, high:
            return integral(tree(body), name, tree(low), tree(high))
        case "derivative", name, body, point:
            return derivative(tree(body), name, tree(point))
        case "at", name, body, value:
            return at(tree(body), {name: tree(value)})
        case "+", left, right:
            return tree(left) + tree(right)
        case "*", left, right:
            return tree(left) * tree(right)
    return apply(term[0], tree(term[1]))


def named(e: Expr) -> Term:
    """A tree with names for all its variables, chosen by ``opened``."""
    if e.op == "symbol":
        return ("symbol", e.args[0])
    if e.op == "number":
        return ("number", int(e.args[0].p))
    if e.op in ("integral", "derivative", "at"):
        (name,), body = opened(e)
        return (e.op, name, named(body), *map(named, e.args[1:]))
    if e.op in ("+", "*"):
        first, *rest = e.args
        whole = named(first)
        for part in rest:
            whole = (e.op, whole, named(part))
        return whole
    if e.op == "^":
        assert e.args[1] == number(2)
        return ("*", named(e.args[0]), named(e.args[0]))
    return (e.op, named(e.args[0]))


def value(term: Term, where: dict[str, acb]) -> acb:
    """A term at complex balls; all functions in it are entire."""
    match term:
        case "symbol", name:
            return where[name]
        case "number", n:
            return acb(n)
        case "integral", name, body, low, high:
            ends = value(low, where), value(high, where)
            return _quadrature(lambda t: value(body, {**where, name: t}), *ends)
        case "derivative", name, body, point:
            place = value(point, where)

            def around(t: acb) -> acb:
                turn = (2 * acb.pi() * acb(0, 1) * t).exp()
                return value(body, {**where, name: place + turn / 2}) / (turn / 2)

            return _quadrature(around, acb(0), acb(1))
        case "at", name, body, at_:
            return value(body, {**where, name: value(at_, where)})
        case "+", left, right:
            return value(left, where) + value(right, where)
        case "*", left, right:
            return value(left, where) * value(right, where)
    found = value(term[1], where)
    return found.sin() if term[0] == "sin" else found.cos()


def _quadrature(f: Any, low: acb, high: acb) -> acb:
    return acb.integral(lambda t, _: f(t), low, high, rel_tol=1e-6, abs_tol=1e-6, eval_limit=400)


POINT = {"x": "0.3", "y": "-0.7", "z": "1.1"}


def _same(one: Term, other: Term, where: dict[str, acb], shown: dict[str, acb]) -> None:
    """Balls of both overlap, and are sharp enough to tell."""
    p, q = value(one, where), value(other, shown)
    assume(p.is_finite() and q.is_finite() and p.rad() < 0.1 and q.rad() < 0.1)
    assert (p - q).contains(0)


def _point() -> dict[str, acb]:
    return {name: acb(arb(text)) for name, text in POINT.items()}


@given(TERMS)
@settings(max_examples=60)
@pytest.mark.slow
def test_a_tree_is_the_term(term: Term) -> None:
    with ball_precision(64):
        _same(term, named(tree(term)), _point(), _point())


@given(TERMS, NAMES, FLAT)
@settings(max_examples=150)
@pytest.mark.slow
def test_substitution_agrees_with_evaluation(term: Term, name: str, put: Term) -> None:
    """What is put in names the variables that are bound there, again and again."""
    with ball_precision(64):
        point = _point()
        changed = substitute(tree(term), {name: tree(put)})
        _same(term, named(changed), {**point, name: value(put, point)}, point)


@given(TERMS, FLAT, FLAT)
@settings(max_examples=60)
def test_two_are_put_in_at_once(term: Term, first: Term, second: Term) -> None:
    with ball_precision(64):
        point = _point()
        changed = substitute(tree(term), {"x": tree(first), "y": tree(second)})
        moved = {**point, "x": value(first, point), "y": value(second, point)}
        _same(term, named(changed), moved, point)


@given(TERMS)
@settings(max_examples=60)
def test_what_is_worked_out_has_the_same_value(term: Term) -> None:
    with ball_precision(64):
        _same(term, named(worked_out(tree(term))), _point(), _point())


@given(TERMS, NAMES)
@settings(max_examples=60)
@pytest.mark.slow
def test_the_derivative_is_the_derivative(term: Term, name: str) -> None:
    """Also of integrals, whose derivative is a node."""
    with ball_precision(64):
        slope = differentiate(tree(term), name)
        _same(("derivative", name, term, ("symbol", name)), named(slope), _point(), _point())


def _renamed(term: Term, new: dict[str, str], count: list[int]) -> Term:
    """The term with other names for all the variables that are bound."""
    match term:
        case "symbol", name:
            return ("symbol", new.get(name, name))
        case ("integral" | "derivative" | "at") as op, name, body, *rest:
            count[0] += 1
            fresh = f"v{count[0]}"
            inner = _renamed(body, {**new, name: fresh}, count)
            return (op, fresh, inner, *(_renamed(part, new, count) for part in rest))
    return (term[0], *(_renamed(p, new, count) if isinstance(p, tuple) else p for p in term[1:]))


@given(TERMS)
def test_trees_are_equal_up_to_the_names_of_bound_variables(term: Term) -> None:
    one, other = tree(term), tree(_renamed(term, {}, [0]))
    assert one == other
    assert hash(one) == hash(other)
    assert symbols(one) == symbols(other)
    assert pickle.loads(pickle.dumps(one)) == one


@given(TERMS, TERMS)
def test_terms_of_different_values_are_different_trees(one: Term, other: Term) -> None:
    if tree(one) == tree(other):
        with ball_precision(64):
            _same(one, other, _point(), _point())


@pytest.mark.parametrize(
    ("one", "other"),
    [
        (integral(x, "x", number(0), number(1)), x),
        (integral(x, "x", number(0), number(1)), integral(x, "y", number(0), number(1))),
        (integral(x * y, "x", number(0), x), integral(x * y, "y", number(0), x)),
        (derivative(x * y, "x"), derivative(x * y, "y")),
        (derivative(x * y, "x"), derivative(x * y, "x", y)),
        (at(x / y, {"x": y, "y": x}), at(at(x / y, {"x": y}), {"y": x})),
        (limit(1 / x, "x", number(0), 1), limit(1 / x, "x", number(0), -1)),
        (order("O", x), order("o", x)),
    ],
    ids=str,
)
def test_planted_falsehoods_are_different_trees(one: Expr, other: Expr) -> None:
    assert one != other


@pytest.mark.parametrize(
    ("e", "put", "text"),
    [
        (integral(x * y, "x", number(0), y), {"y": x}, "integral(x_1*x, x_1, 0, x)"),
        (integral(x * y, "x", number(0), number(1)), {"x": z}, "integral(x*y, x, 0, 1)"),
        (derivative(x * y, "x"), {"x": y + 1}, "at(diff(x*y, x), x, y + 1)"),
        (derivative(x * y, "x"), {"y": x}, "at(diff(x_1*x, x_1), x_1, x)"),
        (derivative(x * y, "x"), {"y": z}, "diff(x*z, x)"),
        (at(x / y, {"x": y, "y": z}), {"z": x}, "at(x_1/y_1, x_1, y, y_1, x)"),
        (limit(x * y, "x", y, 1), {"y": x}, "limit(x_1*x, x_1, x, 1)"),
        (order("O", x**2), {"x": y + 1}, "O((y + 1)**2)"),
        (
            integral(integral(x * y * z, "x", number(0), y), "y", number(0), x),
            {"z": y},
            "integral(integral(x*y_1*y, x, 0, y_1), y_1, 0, x)",
        ),
    ],
)
def test_text_has_names_that_capture_nothing(e: Expr, put: dict[str, Expr], text: str) -> None:
    assert str(substitute(e, put)) == text


def test_a_bound_variable_does_not_leave_its_binder() -> None:
    body = integral(x, "x", number(0), number(1)).args[0]
    assert body.loose == 1
    for act in (
        lambda: substitute(y, {"y": body}),
        lambda: replaced(integral(x, "x", number(0), number(1)), {body: y}),
        lambda: replaced(y, {y: body}),
    ):
        with pytest.raises(ValueError, match="binder"):
            act()


def test_parts_are_replaced_where_they_are_the_same() -> None:
    """sin x outside is not the sine of the variable inside; sin y is the same everywhere."""
    f = apply("sin", x) + integral(apply("sin", x) * apply("sin", y), "x", number(0), number(1))
    known = {apply("sin", x): z, apply("sin", y): x}
    expected = z + integral(apply("sin", y) * x, "y", number(0), number(1))
    assert replaced(f, known) == expected
    assert rebuild(f, f.args) == f


def test_the_value_of_a_derivative_is_the_derivative_at_the_point() -> None:
    assert at(derivative(x**2 * y, "x"), {"x": y}) == derivative(x**2 * y, "x", y)
    assert at(derivative(x**2, "x", y), {"x": y}).op == "at"
    assert at(derivative(x**2, "x") * x, {"x": y}).op == "at"


def test_an_integral_hides_what_it_depends_on() -> None:
    f = integral(x * y, "x", number(0), number(1))
    assert worked_out(derivative(f, "y", number(2))) == derivative(f, "y", number(2))
    assert worked_out(derivative(f * z, "z", number(2))) == f
    assert worked_out(at(f, {"y": z})) == integral(x * z, "x", number(0), number(1))
    with pytest.raises(InputError):
        differentiate(order("O", x), "x")


def test_equal_nodes_are_one_variable() -> None:
    f = integral(x * y, "x", number(0), number(1))
    g = integral(2 * y * z, "z", number(0), number(1))
    one, other = generalised(f, g)
    assert other == 2 * one
    assert elementary(one, other)
    assert [*outermost(f + derivative(g, "y"))] == [f, derivative(g, "y")]
    kept, moved = generalised(f, integral(x * y, "x", number(0), number(2)))
    assert symbols(kept) != symbols(moved)
    assert generalised(x + y) == (x + y,)


@given(TERMS)
@settings(max_examples=60)
def test_the_order_of_operands_says_nothing(term: Term) -> None:
    one, other = ordered(tree(term)), ordered(tree(_turned(term)))
    assert one == other
    with ball_precision(64):
        _same(term, named(one), _point(), _point())


def _turned(term: Term) -> Term:
    parts = [_turned(p) if isinstance(p, tuple) else p for p in term[1:]]
    return (term[0], *(reversed(parts) if term[0] in ("+", "*") else parts))


def test_the_depth_is_bounded() -> None:
    e = x
    for _ in range(MAX_DEPTH - 1):
        e = integral(e, "y", number(0), number(1))
    with pytest.raises(InputError, match="deep"):
        integral(e, "y", number(0), number(1))


def test_a_body_is_closed_by_its_names_alone() -> None:
    assert bind(parse("x + y"), ("x",)) != bind(parse("x + y"), ("y",))
    assert opened(integral(x + y, "x", number(0), number(1)), avoid=("x",))[0] == ("x_1",)
    with pytest.raises(InputError, match="order"):
        order("Omega", x)


def test_trees_are_elementary_if_each_is() -> None:
    area = integral(symbol("t"), "t", number(0), symbol("x"))
    assert elementary(symbol("x"), number(2))
    assert not elementary(symbol("x"), area)
    assert not elementary(area, symbol("x"))
