"""Whether conditions and equations hold somewhere: what is found is shown, and nothing else is."""

from functools import partial

import pytest
import sympy
from flint import arb, fmpq
from sympy import (
    Abs,
    Basic,
    Derivative,
    Eq,
    Integral,
    Lt,
    Ne,
    Rational,
    Symbol,
    exp,
    log,
    pi,
    sin,
    sqrt,
)

from tresym.ledger.conversion import Rules
from tresym.ledger.evidence.satisfiability import BITS, Place, _integral, hold, satisfiable
from tresym.ledger.formulas import in_trees
from tresym.reals.language.formula import Relation
from tresym.reals.language.parsing import parse
from tresym.reals.numbers.arithmetic import ball_precision
from tresym.reals.numbers.exact import Interval

equal = partial(Eq, evaluate=False)

pytestmark = pytest.mark.quick

x, y, z, t = (Symbol(name, real=True) for name in "xyzt")


@pytest.mark.parametrize(
    ("given", "known"),
    [
        ((x > 0,), ()),
        ((x > 0,), (equal(exp(x) + x, 6),)),
        ((x > 0,), (equal(y, x**2), equal(y, 4 * x))),
        ((x > 0,), (equal(Integral(exp(t), (t, 0, x)), 3),)),
        ((x > 0, x < 3), (equal(y, Derivative(Integral(exp(t), (t, x, 5)), x)), equal(z, y))),
        ((x > 0, x < 3, Ne(y, 0)), (equal(y, Derivative(Integral(exp(t), (t, x, 5)), x)),)),
    ],
    ids=str,
)
def test_what_holds_somewhere(given: tuple, known: tuple) -> None:
    assert satisfiable(given, known)


@pytest.mark.parametrize(
    ("given", "known"),
    [
        ((x > 1, x < 0), ()),
        ((Lt(x**2, -1, evaluate=False),), ()),
        ((x > 0,), (equal(y, x), equal(y, -x))),
        ((), (equal(y, x), equal(y, x + 1))),
        ((y > 0,), (equal(y, -exp(x)),)),
        ((), (equal(y, log(x)), equal(x, -1))),
        ((), (equal(sqrt(x), -1),)),
        ((x > 0,), (equal(Integral(exp(t), (t, 0, x)), -3),)),
        ((x > 0, Ne(y, 0)), (equal(y, Derivative(Integral(exp(t), (t, 1, 5)), x)),)),
    ],
    ids=str,
)
def test_what_holds_nowhere(given: tuple, known: tuple) -> None:
    assert not satisfiable(given, known)


def said(text: str) -> Relation:
    for sign in ("==", "!=", ">=", ">"):
        left, found, right = text.partition(sign)
        if found:
            return Relation(parse(left), sign, parse(right))
    raise ValueError(text)


def at(**places: tuple[int | str, int | str] | int) -> Place:
    ends = {n: p if isinstance(p, tuple) else (p, p) for n, p in places.items()}
    return {n: Interval(*(fmpq(*map(int, str(e).split("/"))) for e in p)) for n, p in ends.items()}


PLACES = [
    (["x > 0"], {}, at(x=1), at(x=0)),
    (["x**2 == 2"], {}, at(x=(1, 2)), at(x=(2, 3))),
    (["x**2 == 4", "x > 0"], {}, at(x=(1, 3)), at(x=(-3, -1))),
    (["x**2 == 2", "x >= 1"], {}, at(x=("5/4", 2)), at(x=("1/2", 2))),
    (["y == x", "y > 0"], {"y": "x"}, at(x=1), at(x=-1)),
    (["y == x/x"], {"y": "1"}, at(x=1), at(x=0)),
    (["y == 1/x"], {"y": "1/x"}, at(x=1), at(x=0)),
    (["x == 1/y"], {"y": "1/x"}, at(x=1), at(x=0)),
    (["1/x == 0"], {}, None, at(x=(-1, 1))),
    (["sign(x) == 0"], {}, None, at(x=(-1, 2))),
    (["atan2(x, -1) == 0"], {}, None, at(x=(-1, 1))),
    (["x == 0", "y == 0"], {}, None, at(x=(-1, 1), y=(-1, 1))),
    (["x == 0", "x == 1/2"], {}, None, at(x=(-1, 1))),
    (["x == 0", "x == 1/2"], {}, None, at(x=(-1, 1), y=(0, 1))),
    (["x + y == 0"], {}, at(x=(-1, 1), y=0), at(x=(-1, 1), y=(0, "1/2"))),
    (["x == 0"], {}, at(x=(-1, 1)), at(x=0)),
    (["x != x"], {}, None, at(x=1)),
    (["x == x"], {}, at(x=1), at(x=(0, 1))),
]


@pytest.mark.parametrize(("asked", "rules", "yes", "no"), PLACES, ids=[str(p[0]) for p in PLACES])
def test_a_place_is_checked(
    asked: list[str], rules: dict[str, str], yes: Place | None, no: Place
) -> None:
    meant: Rules = {parse(left): parse(right) for left, right in rules.items()}
    relations = [*map(said, asked)]
    assert not hold(relations, meant, [no])
    assert yes is None or (hold(relations, meant, [yes]) and hold(relations, meant, [no, yes]))


def test_nothing_but_symbols_is_put_in() -> None:
    assert not hold([said("sin(x) == 2")], {parse("sin(x)"): parse("2")}, [at(x=0)])
    assert not hold([said("x == 1")], {}, [])
    assert satisfiable((x > 0,), (equal(sin(x), 1 / pi),))


def area(f: Basic, low: object, high: object, **at: object) -> arb:
    with ball_precision(BITS):
        return _integral(in_trees(Integral(f, (t, low, high))), {n: arb(v) for n, v in at.items()})


@pytest.mark.parametrize(
    ("f", "low", "high", "value"),
    [
        (t**2, 0, 3, arb(9)),
        (sin(t), 0, pi, arb(2)),
        (exp(t), 2, 0, 1 - arb(2).exp()),
        (exp(-50 * t**2), -3, 3, (arb.pi() / 50).sqrt()),  # a narrow peak
        (Abs(t - 5), 0, 2, arb(8)),
    ],
    ids=str,
)
def test_an_integral_is_enclosed(f: Basic, low: object, high: object, value: arb) -> None:
    found = area(f, low, high)
    assert found.is_finite()
    assert found.contains(value)


@pytest.mark.parametrize(
    ("f", "low", "high"),
    [
        (t**-2, -1, 1),
        (1 / t, -1, 2),
        (sympy.sign(t), -1, 2),
        (Abs(t), -1, 1),
        (Abs(64 * t - 1), 0, Rational(1, 32)),  # it bends between the ends of cells
        (log(t), -1, 1),
        (sqrt(t), 0, 1),  # it exists, but its slope does not
        (sin(1 / t), -1, 1),
        (Integral(x * t, (x, 0, t)), 0, 1),
    ],
    ids=str,
)
def test_an_integral_of_what_is_not_smooth_is_not(f: Basic, low: object, high: object) -> None:
    assert not area(f, low, high).is_finite()


def test_a_parameter_runs_through_its_segment() -> None:
    found = area(x * t, 0, 1, x=arb(2, 1))
    assert found.contains(arb(2, 1) / 2)


@pytest.mark.parametrize("f", [x / t**2, x * sympy.sign(t), x * log(t - 1)], ids=str)
def test_no_root_of_an_integral_that_is_not_shown_to_exist(f: Basic) -> None:
    relation = Relation(in_trees(Integral(f, (t, -1, 1))), "==", parse("-2"))
    assert not hold([relation], {}, [at(x=("1/2", "3/2"))])
    plain = Relation(in_trees(Integral(-x * t**2, (t, -1, 1))), "==", parse("-2/3"))
    assert hold([plain], {}, [at(x=("1/2", "3/2"))])
